//! Unions, intersections, clipping, bounding, and which texture their surfaces show.

use super::Quirk;

pub(super) const QUIRKS: &[Quirk] = &[];
