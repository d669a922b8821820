//! Shapes: hits, inside, normals, uv, boxes.

use super::Quirk;

pub(super) const QUIRKS: &[Quirk] = &[];
