//! Every tolerance of the program, in one table.

/// A ray that leaves a surface ignores hits closer than this (world units along the ray).
pub const SURFACE: f64 = 1e-6;
