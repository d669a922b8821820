//! Parsing, values, versions.

use super::{Quirk, emulated};

pub(super) const QUIRKS: &[Quirk] = &[
    emulated(
        "cubic_spline_slopes",
        "The slope of a `cubic_spline` at a point is the mean of the slopes of the lines to its two neighbours.",
        &["tests/lang/functions.scene"],
    ),
    emulated(
        "exact_comparisons_in_functions",
        "Inside `function { }` comparisons are exact, and every number but 0 is true; outside of it 1e-10 separates numbers.",
        &["tests/lang/functions.scene"],
    ),
    emulated(
        "internal_functions",
        "The functions of `functions.inc` have signs, scales and weights of parameters of their own beside the published formulas.",
        &["tests/internals/values.txt"],
    ),
];
