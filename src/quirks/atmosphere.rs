//! Backgrounds, sky spheres, fogs, rainbows.

use super::Quirk;

pub(super) const QUIRKS: &[Quirk] = &[];
