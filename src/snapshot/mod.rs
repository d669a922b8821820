//! Compares pictures.
