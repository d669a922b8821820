//! Reading and writing pictures: gamma, rounding, dithering, maps.

use super::{Quirk, emulated_quirk};

pub(super) const QUIRKS: &[Quirk] = &[
    emulated_quirk(
        "bmp_dithers_upwards",
        "Error diffusion in a bmp file begins at the bottom row, as its rows do.",
        &["src/image_io/tests.rs::bmp_is_dithered_from_the_bottom"],
    ),
    emulated_quirk(
        "bump_map_three_pixels",
        "`bump_map` takes its slope from three pixels that form a triangle, and wraps at the edges of the picture even with `once`.",
        &["light_cases/bump_map_level"],
    ),
    emulated_quirk(
        "dithering",
        "Dithering adds patterns to the numbers of the file and diffuses errors as light; the first column receives errors from above one row late, and errors beyond the sides are lost.",
        &["src/image_io/dither.rs::patterns_are_povrays", "src/image_io/dither.rs::errors_go_where_povrays_go"],
    ),
    emulated_quirk(
        "function_picture_wraps",
        "A picture made of a function has 16 bits a channel; numbers are truncated, and numbers outside of 0 to 1 wrap.",
        &["light_cases/function_image_bits", "light_cases/function_image_wraps"],
    ),
    emulated_quirk(
        "gray_png_rounds_down",
        "The brightness of a pixel in a png of grays is rounded down to a byte.",
        &["tests/patterns/image_pattern.txt"],
    ),
    emulated_quirk(
        "image_pattern_ignores_index",
        "`use_index` has no effect in `image_pattern`; it has one in `bump_map`.",
        &["tests/patterns/image_pattern.txt"],
    ),
    emulated_quirk(
        "image_pixel_centres",
        "Interpolation takes the centres of pixels at half numbers; each `map_type` and `once` treat the edges in their own way.",
        &["tests/patterns/image_pattern.txt"],
    ),
    emulated_quirk(
        "old_picture_orientation",
        "In `image_map`, `bump_map`, `material_map` and `image_pattern`, a vector or number before the picture is ignored, with a warning: before \
         version 2 of POV-Ray it was an orientation or a map type.",
        &["tests/ui/old_picture_orientation.scene"],
    ),
    emulated_quirk(
        "palette_index_truncated",
        "Interpolation between the indices of a palette gives a whole number.",
        &["tests/patterns/image_pattern.txt"],
    ),
    emulated_quirk(
        "png_transparent_color",
        "A colour that a png file marks as transparent is opaque.",
        &["tests/patterns/image_pattern.txt"],
    ),
];
