//! Reading and writing pictures: gamma, rounding, dithering, maps.

use super::Quirk;

pub(super) const QUIRKS: &[Quirk] = &[];
