//! Finish, reflection, refraction, dispersion, layers.

use super::Quirk;

pub(super) const QUIRKS: &[Quirk] = &[];
