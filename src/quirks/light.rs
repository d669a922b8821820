//! Lights, shadows, and what happens to light on its way.

use super::{Quirk, differs, emulated};

pub(super) const QUIRKS: &[Quirk] = &[
    emulated(
        "area_illumination_both_sides",
        "At qualities 2 to 4, an area light with `area_illumination` illuminates both sides of a surface.",
        &["light_cases/area_illumination_both_sides_q4", "light_cases/area_illumination_q2"],
    ),
    emulated(
        "area_illumination_shadow",
        "With `area_illumination` each light of the grid illuminates by itself, but all with the shadow of the whole \
         grid.",
        &["light_cases/area_illumination"],
    ),
    emulated(
        "area_light_subdivision",
        "The shadow of an area light is the mean over pieces of the grid, and each piece is the mean of its corners, \
         so lights inside the grid count more than those at its edge. A piece is subdivided where the light of its \
         corners differs by more than 0.1.",
        &["light_cases/area_light", "light_cases/area_light_adaptive_orient"],
    ),
    emulated(
        "double_illuminate_highlights",
        "With `double_illuminate`, light from behind makes highlights too.",
        &["light_cases/double_illuminate_highlights"],
    ),
    emulated(
        "fade_power_0_shadow",
        "`fade_power 0` halves the light that is seen through an interior, and does not darken its shadow.",
        &["light_cases/fade_power_0"],
    ),
    emulated(
        "fog_and_shadows",
        "Fog attenuates the light of a light source only with `media_attenuation`.",
        &["light_cases/media_attenuation"],
    ),
    emulated(
        "irid_of_area_center",
        "`irid` uses the direction to the centre of an area light, whichever light of the grid illuminates.",
        &["light_cases/area_illumination_irid"],
    ),
    emulated(
        "missing_shares_darken_twice",
        "Where textures of a mesh or blob are left out because their shares are below `adc_bailout`, the shadow \
         darkens by the missing shares twice.",
        &["light_cases/shadow_small_shares"],
    ),
    emulated(
        "projected_through_range",
        "Objects between the object of `projected_through` and the light cast no shadow; fog there attenuates the \
         light.",
        &["light_cases/projected_through", "light_cases/fog_projected"],
    ),
    differs(
        "remembered_occluder",
        "POV-Ray asks the object that last blocked a light first, and what that object transmits is counted twice, so \
         a shadow depends on the pixels drawn before.",
        "A pixel of durer depends on the scene, the options and its position alone; the surfaces along a shadow ray \
         each count once.",
        &["tests/random/README.md"],
    ),
    emulated(
        "shadow_by_outside",
        "Meshes and blobs cast shadows by their outer texture alone, whatever their `interior_texture` transmits.",
        &["light_cases/shadow_of_interior_texture"],
    ),
    emulated(
        "shadow_min_distance",
        "A shadow ray ignores hits closer than 0.001 to either of its ends, and a transparent surface closer than \
         that to the one before.",
        &["light_cases/shadow_thin"],
    ),
];
