//! Pigments, normals, maps, texture blocks.

use super::Quirk;

pub(super) const QUIRKS: &[Quirk] = &[];
