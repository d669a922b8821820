//! Lights, shadows, and what happens to light on its way.

use super::{Quirk, differing_quirk, emulated_quirk};

pub(super) const QUIRKS: &[Quirk] = &[
    emulated_quirk(
        "area_illumination_both_sides",
        "At qualities 2 to 4, an area light with `area_illumination` illuminates both sides of a surface.",
        &["light_cases/area_illumination_both_sides_q4", "light_cases/area_illumination_q2"],
    ),
    emulated_quirk(
        "area_illumination_shadow",
        "With `area_illumination` each light of the grid illuminates by itself, but all with the shadow of the whole \
         grid.",
        &["light_cases/area_illumination"],
    ),
    emulated_quirk(
        "area_light_in_radiosity",
        "To rays that gather light for radiosity, and in the media that they cross, an area light is one light at the centre of its grid.",
        &["light_cases/radiosity_area_light", "light_cases/radiosity_area_light_media"],
    ),
    emulated_quirk(
        "area_light_subdivision",
        "The shadow of an area light is the mean over pieces of the grid, and each piece is the mean of its corners, \
         so lights inside the grid count more than those at its edge. A piece is subdivided where the light of its \
         corners differs by more than 0.1.",
        &["light_cases/area_light", "light_cases/area_light_adaptive_orient"],
    ),
    emulated_quirk(
        "area_light_tube",
        "A `cylinder` light with `area_light` has one tube, about the centre of the grid.",
        &["light_cases/area_light_parallel_spot"],
    ),
    emulated_quirk(
        "beam_without_axis",
        "A spotlight, cylinder or parallel light whose `point_at` is its location illuminates nothing.",
        &["src/light/beam.rs::profiles_of_spotlight_and_cylinder"],
    ),
    differing_quirk(
        "black_photons",
        "POV-Ray follows and stores photons without any light, such as red light behind a cyan filter; they count among the \
         `gather` photons of an estimate.",
        "durer drops them: they cost time and memory.",
        &["tests/random/README.md"],
    ),
    emulated_quirk(
        "circular_area_light",
        "Lights of a circular grid are displaced by 0.002 of half a side.",
        &["src/light/area.rs::offsets_of_a_grid_and_a_disc", "light_cases/area_light_circular_beside"],
    ),
    emulated_quirk(
        "double_illuminate_highlights",
        "With `double_illuminate`, light from behind makes highlights too.",
        &["light_cases/double_illuminate_highlights"],
    ),
    emulated_quirk(
        "fade_power_0_shadow",
        "`fade_power 0` halves the light that is seen through an interior, and does not darken its shadow.",
        &["light_cases/fade_power_0"],
    ),
    emulated_quirk(
        "fog_and_shadows",
        "Fog attenuates the light of a light source only with `media_attenuation`.",
        &["light_cases/media_attenuation"],
    ),
    emulated_quirk(
        "irid_of_area_center",
        "`irid` uses the direction to the centre of an area light, whichever light of the grid illuminates.",
        &["light_cases/area_illumination_irid"],
    ),
    differing_quirk(
        "large_area_light",
        "Without `adaptive`, a point sends a shadow ray to each light of an area light, however many there are.",
        "A grid of more than 65536 lights is sampled as with `adaptive 7`, and with `area_illumination` at most 128 lights \
         of a side of more than 256 illuminate; 16-bit pictures stay the same.",
        &["tests/suite/area_lights.rs::nine_million_lights_behind_a_small_box"],
    ),
    emulated_quirk(
        "light_in_union_of_group",
        "A light in a union within a `light_group` is a light of the whole scene.",
        &["light_cases/light_group"],
    ),
    emulated_quirk(
        "looks_like_ignores_group",
        "The `looks_like` object of a light in a `light_group` is illuminated by the lights of the group and by all \
         others, even with `global_lights off`.",
        &["light_cases/light_group_looks_like"],
    ),
    emulated_quirk(
        "missing_shares_darken_twice",
        "Where textures of a mesh or blob are left out because their shares are below `adc_bailout`, the shadow \
         darkens by the missing shares twice.",
        &["light_cases/shadow_small_shares"],
    ),
    emulated_quirk(
        "oriented_area_is_circular",
        "`orient` makes a grid of lights circular, but not a row.",
        &["light_cases/area_light_orient_alone"],
    ),
    emulated_quirk(
        "oriented_area_sides",
        "The first side of an `orient` grid is perpendicular to z, or to y if the light shines nearly along z.",
        &["light_cases/area_light_orient_along_z"],
    ),
    emulated_quirk(
        "parallel_light_behind",
        "A parallel light also illuminates what is behind it; with `fade_distance` the distance there is negative, so \
         odd powers brighten and darken.",
        &["light_cases/fade_behind_parallel"],
    ),
    emulated_quirk(
        "pass_through_transparent",
        "`photons { pass_through }` lets photons pass in a straight line, but what the object transmits filters them, \
         and an opaque object stops them.",
        &["tests/suite/photons.rs"],
    ),
    emulated_quirk(
        "photon_radius_in_media",
        "In media, photons are searched within twice the `radius`, stated or not.",
        &["tests/suite/photons.rs"],
    ),
    emulated_quirk(
        "photon_weight_of_reflection",
        "Each reflection multiplies the weight of a photon, which is compared with `adc_bailout`, by the square of the \
         reflection.",
        &["tests/suite/photons.rs"],
    ),
    emulated_quirk(
        "photons_by_visibility",
        "Photons do not hit objects with `no_image` or `no_shadow`, which cannot be targets, either.",
        &["tests/suite/photons.rs"],
    ),
    emulated_quirk(
        "photons_diverge_in_media",
        "The light of photons in media grows along each stretch between two surfaces, unless the light is parallel: with the distance from \
         the light, relative to that at the beginning of the stretch.",
        &["tests/suite/photons.rs"],
    ),
    emulated_quirk(
        "photons_from_behind",
        "The light of photons on the back of a surface, by the second number of `diffuse` or by `double_illuminate`, \
         is too bright, by the factor of ten times the cosine of the angle of incidence.",
        &["tests/suite/photons.rs"],
    ),
    emulated_quirk(
        "photons_of_global_lights",
        "Lights in a `light_group` shoot no photons, and objects in it are targets only with `global_lights on`; but the \
         photons of other lights are stored on all objects.",
        &["tests/suite/photons.rs"],
    ),
    emulated_quirk(
        "photons_off_surface",
        "A photon at the distance d counts as one at the distance d times the square root of 1 + 16 h, where h is its distance from \
         the plane through the point, perpendicular to the normal of the topmost layer, in the units of the scene: the same scene in \
         larger units has narrower caustics on curved surfaces.",
        &["tests/suite/photons.rs"],
    ),
    emulated_quirk(
        "projected_through_range",
        "Objects between the object of `projected_through` and the light cast no shadow; fog there attenuates the \
         light.",
        &["light_cases/projected_through", "light_cases/fog_projected"],
    ),
    emulated_quirk(
        "radiosity_keeps_ambient",
        "In scenes for versions before 3.7, and in those that state none, `ambient` has its effect beside radiosity; 3.7 \
         ignores `ambient` then, except at quality levels below 9, which are without radiosity.",
        &[
            "light_cases/radiosity_ambient_36",
            "light_cases/radiosity_ambient_37",
            "light_cases/radiosity_ambient_37_q8",
        ],
    ),
    emulated_quirk(
        "radiosity_without_highlights",
        "Rays that gather light for radiosity see no highlights (`phong`, `specular`), neither of light \
         sources nor of photons.",
        &["light_cases/radiosity_highlights", "light_cases/radiosity_photon_highlights"],
    ),
    differing_quirk(
        "remembered_occluder",
        "POV-Ray asks the object that last blocked a light first, and what that object transmits is counted twice, so \
         a shadow depends on the pixels drawn before.",
        "A pixel of durer depends on the scene, the options and its position alone; the surfaces along a shadow ray \
         each count once.",
        &["tests/random/README.md"],
    ),
    emulated_quirk(
        "shadow_by_outside",
        "Meshes and blobs cast shadows by their outer texture alone, whatever their `interior_texture` transmits.",
        &["light_cases/shadow_of_interior_texture"],
    ),
    emulated_quirk(
        "shadow_min_distance",
        "A shadow ray ignores hits closer than 0.001 to either of its ends, and a transparent surface closer than \
         that to the one before.",
        &["light_cases/shadow_thin"],
    ),
    emulated_quirk(
        "spotlight_profile",
        "Between `radius` and `falloff` light follows 3x^2 - 2x^3 of the cosine, times the cosine to the power of \
         `tightness`.",
        &["light_cases/spotlight", "src/light/beam.rs::profiles_of_spotlight_and_cylinder"],
    ),
];
