//! Cameras, anti-aliasing, focal blur.

use super::Quirk;

pub(super) const QUIRKS: &[Quirk] = &[];
