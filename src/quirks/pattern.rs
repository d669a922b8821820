//! Patterns, warps, waves.

use super::Quirk;

pub(super) const QUIRKS: &[Quirk] = &[];
