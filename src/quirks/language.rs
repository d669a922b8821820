//! Parsing, values, versions.

use super::Quirk;

pub(super) const QUIRKS: &[Quirk] = &[];
