//! Pigments, normals, maps, texture blocks.

use super::{Quirk, emulated_quirk};

pub(super) const QUIRKS: &[Quirk] = &[
    emulated_quirk(
        "average_weights",
        "In a map with `average`, an entry without a weight has weight 1, but a colour needs a weight.",
        &["tests/patterns/average.txt"],
    ),
    emulated_quirk(
        "blended_normals",
        "In a map of normals, the patterns of an entry see the normal that the entry above has bumped; the blend of two entries has length 1, even with `no_bump_scale`.",
        &["light_cases/slope_after_bumps", "light_cases/uv_no_bump_scale"],
    ),
    emulated_quirk(
        "bumps_within_maps",
        "Within the entries of a map, and in a texture with `uv_mapping`, bumps start from a normal of length 1 in \
         the map's space, and the pigment uses that normal.",
        &["light_cases/normal_map_slope", "light_cases/csg_uv_normal"],
    ),
    emulated_quirk(
        "cells_reset_accuracy",
        "`accuracy` of a default or declared normal has no effect on a pattern of cells.",
        &["light_cases/normal_cells"],
    ),
    emulated_quirk(
        "declared_slope_map_stays",
        "A `slope_map` of a declared or default normal stays when another pattern is named.",
        &["light_cases/normal_map_stays"],
    ),
    emulated_quirk(
        "image_alpha_of_one",
        "A picture whose alpha is 1 everywhere counts as a picture without alpha.",
        &["light_cases/image_alpha_one"],
    ),
    emulated_quirk(
        "image_palette_transmit",
        "In a picture with a palette, `transmit all` replaces the transparency of the palette; else it is added to alpha.",
        &["light_cases/shadow_image_in_map"],
    ),
    emulated_quirk(
        "image_seems_opaque",
        "A picture among several pigments casts a full shadow unless its own alpha or palette is transparent, whatever `filter` and `transmit` say.",
        &["light_cases/shadow_image_in_map"],
    ),
    emulated_quirk(
        "map_ends",
        "The last entry of a map takes precedence over the first; entries in any order are searched for the first that fits; NaN shows the first.",
        &["light_cases/map_ends", "light_cases/nan_patterns"],
    ),
    emulated_quirk(
        "map_without_pattern",
        "A pigment with a map but without a pattern is black.",
        &["light_cases/old_map"],
    ),
    emulated_quirk(
        "negative_highlights",
        "Negative strengths of `phong` and `specular` count as 0.",
        &["light_cases/finish_mixed_2"],
    ),
    emulated_quirk(
        "normals_by_transpose",
        "Bumps of a scaled or sheared normal are transformed by the transpose of the matrix, so that stretching flattens them.",
        &["light_cases/twisted_by_scale"],
    ),
    emulated_quirk(
        "opaque_pigment_map",
        "An object whose pigments transmit light only in entries of a `pigment_map` casts a full shadow; a \
         `texture_map` is evaluated at each point.",
        &["light_cases/shadow_image_in_map"],
    ),
    emulated_quirk(
        "pictures_once",
        "Outside of an `image_map` with `once`, a `pigment_pattern` is 0, and a layer has no colour; an average or a pigment with its own `uv_mapping` always has one.",
        &["light_cases/pigment_pattern_once"],
    ),
    emulated_quirk(
        "pigments_see_bumped_normal",
        "`slope` and `aoi` in a pigment see the normal after the bumps of the texture's `normal`, which need not have length 1 with `no_bump_scale`.",
        &["light_cases/slope_after_bumps"],
    ),
    emulated_quirk(
        "slope_after_bumps",
        "`slope` and `aoi` use the normal that the last bumps before them left, in the space of those bumps.",
        &["light_cases/slope_after_bumps", "light_cases/slope_seen"],
    ),
    emulated_quirk(
        "slope_faces_ray",
        "For a shadow, `slope` and `aoi` use the normal on the side from which the shadow ray comes.",
        &["light_cases/slope_shadows"],
    ),
    emulated_quirk(
        "tiles_order",
        "In `tiles`, the cube at the origin has the second texture.",
        &["conformance/advanced/wineglass.pov"],
    ),
    emulated_quirk(
        "uv_mapping_pigments",
        "`uv_mapping` after the name of a declared pigment begins a new, black pigment; it takes the quick colour along; a pattern named after it has frequency 0.",
        &["light_cases/default_uv", "light_cases/quick_default_uv_q4", "light_cases/quick_default_uv_q5"],
    ),
    emulated_quirk(
        "uv_normal_stays",
        "Bumps of a normal with `uv_mapping` do not turn with the object; with `uv_mapping` in the texture, pigments see them in the texture's space.",
        &["light_cases/uv_fixed", "light_cases/csg_uv_normal"],
    ),
];
