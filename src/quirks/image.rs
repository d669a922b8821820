//! Reading and writing pictures: gamma, rounding, dithering, maps.

use super::{Quirk, emulated};

pub(super) const QUIRKS: &[Quirk] = &[
    emulated(
        "bump_map_three_pixels",
        "`bump_map` takes its slope from three pixels that form a triangle, and wraps at the edges of the picture even with `once`.",
        &["light_cases/bump_map_level"],
    ),
    emulated(
        "image_pattern_ignores_index",
        "`use_index` has no effect in `image_pattern`; it has one in `bump_map`.",
        &["tests/patterns/image_pattern.txt"],
    ),
    emulated(
        "image_pixel_centres",
        "Interpolation takes the centres of pixels at half numbers; each `map_type` and `once` treat the edges in their own way.",
        &["tests/patterns/image_pattern.txt"],
    ),
    emulated(
        "no_gamma_before_3_7",
        "In scenes before version 3.7 without `assumed_gamma`, the numbers of a picture file are used unchanged.",
        &["light_cases/no_version"],
    ),
    emulated(
        "palette_index_truncated",
        "Interpolation between the indices of a palette gives a whole number.",
        &["tests/patterns/image_pattern.txt"],
    ),
];
