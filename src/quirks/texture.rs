//! Pigments, normals, maps, texture blocks.

use super::{Quirk, emulated};

pub(super) const QUIRKS: &[Quirk] = &[
    emulated(
        "bumps_within_maps",
        "Within the entries of a map, and in a texture with `uv_mapping`, bumps start from a normal of length 1 in \
         the map's space, and the pigment uses that normal.",
        &["light_cases/normal_map_slope", "light_cases/csg_uv_normal"],
    ),
    emulated(
        "slope_after_bumps",
        "`slope` and `aoi` use the normal that the last bumps before them left, in the space of those bumps.",
        &["light_cases/slope_after_bumps", "light_cases/slope_seen"],
    ),
    emulated(
        "slope_faces_ray",
        "For a shadow, `slope` and `aoi` use the normal on the side from which the shadow ray comes.",
        &["light_cases/slope_shadows"],
    ),
];
