//! Backgrounds, sky spheres, fogs, rainbows.

use super::{Quirk, emulated};

pub(super) const QUIRKS: &[Quirk] = &[emulated(
    "fog_needs_hollow",
    "There is no fog inside an object that is not `hollow`.",
    &["light_cases/fog_in_glass", "light_cases/fog_in_union"],
)];
