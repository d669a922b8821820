//! Finish, reflection, refraction, dispersion, layers.

use super::{Quirk, differing_quirk, emulated_quirk};

pub(super) const QUIRKS: &[Quirk] = &[
    emulated_quirk(
        "adc_transmission",
        "A transmitted ray ends where the gray of the surface's transmittance, or the ray's weight times the largest \
         channel, is at most `adc_bailout`. Negative transmittances count by their absolute value.",
        &["light_cases/adc", "light_cases/adc_filter", "light_cases/transmit_below_0"],
    ),
    emulated_quirk(
        "albedo_stays",
        "Once `albedo` is given for `diffuse`, `phong` or `specular`, it stays for later numbers in the same finish; a finish on top of another begins without it.",
        &["light_cases/finish_again", "light_cases/albedo"],
    ),
    emulated_quirk(
        "attenuation_beyond_surface",
        "`fade_distance` attenuates only light from beyond the surface where a ray leaves the interior; diffuse \
         light, highlights and reflection of that surface arrive without attenuation.",
        &["light_cases/glass_leaving", "light_cases/light_fade"],
    ),
    emulated_quirk(
        "attenuation_keeps_weight",
        "The attenuation of an interior does not lower the weight that is compared with `adc_bailout`.",
        &["light_cases/adc_fade"],
    ),
    emulated_quirk(
        "blend_by_light",
        "A `texture_map` or `average` blends the light of its textures, not their colours: each is lit, reflects and \
         refracts with its own finish and normal.",
        &["light_cases/blend_each_its_own", "light_cases/layers_apart"],
    ),
    emulated_quirk(
        "bumps_from_behind",
        "Where bumps turn the normal away from the ray, `fresnel` reflects all light, `metallic` does not tint, and \
         refraction and `irid` use the absolute value of the cosine.",
        &["light_cases/bumps_behind", "light_cases/reflection_falloff"],
    ),
    emulated_quirk(
        "bumps_reflect_twice",
        "Where bumps would reflect a ray into the surface, the surface reflects the ray a second time; bumps that are \
         seen from behind have no effect on reflection.",
        &["light_cases/bumps_behind"],
    ),
    emulated_quirk(
        "caustics_factor",
        "`caustics C` brightens a shadow by 1 + cos(a)^(45 C), where a is the angle of incidence at the surface.",
        &["light_cases/glass", "light_cases/inside_glass"],
    ),
    emulated_quirk(
        "conserve_energy_without_pigment",
        "`conserve_energy` takes nothing from transmitted light where the pigment is a picture shown `once` and the \
         point is beside it.",
        &["light_cases/conserve_no_picture", "light_cases/conserve_no_picture_uv"],
    ),
    emulated_quirk(
        "crand_ignores_opacity",
        "`crand` is subtracted from diffuse light whatever the pigment transmits, and a negative result darkens the \
         other terms.",
        &["light_cases/finish_mixed_1"],
    ),
    emulated_quirk(
        "dispersion_ior",
        "`dispersion D` gives red the index n/sqrt(D) and violet n*sqrt(D), with equal ratios between equal steps of \
         the spectrum. Reflection uses n for all colours.",
        &["light_cases/dispersion", "light_cases/dispersion_fresnel"],
    ),
    emulated_quirk(
        "dispersion_needs_ior",
        "`dispersion` has no effect without `ior`.",
        &["light_cases/dispersion_inside"],
    ),
    emulated_quirk(
        "dispersion_samples_beyond",
        "Of two interiors that meet, the one behind the boundary says into how many colours light splits.",
        &["light_cases/dispersion_overlap", "light_cases/dispersion_two"],
    ),
    emulated_quirk(
        "dispersion_spectrum",
        "Each part of the spectrum has a fixed colour: three parabolic lobes for red, green and blue, and a second \
         lobe of red at the violet end.",
        &["src/transport/dispersion.rs::lobes_are_parabolas", "light_cases/dispersion_fine"],
    ),
    emulated_quirk(
        "dispersion_total_reflection",
        "The colours that are totally reflected continue as one ray of white light, which the surface's transmittance \
         and film tint.",
        &["light_cases/dispersion_total", "light_cases/dispersion_total_irid"],
    ),
    emulated_quirk(
        "embedded_shares_below_adc_bailout",
        "At a point that shows several textures of a mesh or blob, textures with a share below `adc_bailout` are left \
         out, and the other shares do not grow.",
        &["light_cases/mesh_adc_corners", "light_cases/blob_adc_components"],
    ),
    emulated_quirk(
        "finish_ior_first",
        "`ior` and `caustics` in the finish of the topmost layer, as in old scenes, have priority over those of the \
         `interior`.",
        &["light_cases/old_finish"],
    ),
    emulated_quirk(
        "finish_ior_of_parts",
        "`ior` and `caustics` in the finish of a part of a CSG object apply to all its parts that have no `interior` \
         block; of several the last one counts.",
        &["light_cases/old_finish_of_parts"],
    ),
    emulated_quirk(
        "fresnel_of_last_entered",
        "Where a ray leaves one of several interiors, `fresnel` uses the index of that interior and the index of the \
         interior that was entered last, even if both are the same.",
        &["light_cases/fresnel_nested", "light_cases/fresnel_overlap"],
    ),
    emulated_quirk(
        "irid_formula",
        "`irid` multiplies the light of each channel by 1 + amount · cos(2π path / wavelength).",
        &["light_cases/finish_mixed_2", "light_cases/area_illumination_irid"],
    ),
    emulated_quirk(
        "layers_below_adc_bailout",
        "Layers below a stack whose transmittance is at most `adc_bailout` are not evaluated.",
        &["light_cases/adc_conserve", "light_cases/shadow_layers"],
    ),
    emulated_quirk(
        "layers_keep_reflection",
        "Upper layers of a texture do not attenuate the reflection of lower layers.",
        &["light_cases/reflection_twice", "light_cases/conserve_layers"],
    ),
    emulated_quirk(
        "nan_normal_is_black",
        "Where bumps make a normal that is not a number, the pixel is black.",
        &["light_cases/nan_patterns"],
    ),
    emulated_quirk(
        "quality_levels",
        "Quality 2 adds light sources, 4 shadows, 5 area lights, 6 patterns and transparency, 8 reflection and \
         normals, 9 fog and rainbows; 0 and 1 are the same.",
        &[
            "light_cases/quality_q0",
            "light_cases/quality_q2",
            "light_cases/quality_q4",
            "light_cases/quality_q6",
            "light_cases/quality_q8",
        ],
    ),
    emulated_quirk(
        "reflection_again",
        "A second `reflection { }` in a finish keeps `fresnel`, `falloff`, `exponent` and `metallic` of the first; a plain `reflection` switches `fresnel` off.",
        &["light_cases/reflection_twice"],
    ),
    emulated_quirk(
        "reflection_weight",
        "A reflected ray's weight is the larger of the two `reflection` colours times the gray of the layers above; \
         shares of a blend, `metallic`, and the angle (without `fresnel`) do not count.",
        &["light_cases/mirror_fresnel_metallic_adc"],
    ),
    emulated_quirk(
        "straight_ray_keeps_level",
        "A ray that passes a surface without being bent stays on its level of `max_trace_level`.",
        &["light_cases/dispersion_level"],
    ),
    emulated_quirk(
        "subsurface_both_sides",
        "Light from both sides of a surface enters a solid with `subsurface`; only shadows keep it from the far side, so \
         that an object with `no_shadow` is lit all around.",
        &["light_cases/subsurface_no_shadow"],
    ),
    emulated_quirk(
        "subsurface_boundary",
        "In `subsurface`, the index of refraction changes the spread of light less than the paper's formula for internal \
         reflection states: the factor A is 1.19 for 1.5, not 3.96.",
        &["src/transport/dipole.rs::mismatch_of_common_materials"],
    ),
    emulated_quirk(
        "subsurface_hits",
        "The mean over the `samples` of `subsurface` counts only rays that hit something: an open surface, such as a \
         plane, is brighter than the face of a box, up to twice as bright.",
        &["light_cases/subsurface_open"],
    ),
    emulated_quirk(
        "subsurface_opacity",
        "The light of `subsurface` does not depend on the transparency of the pigment.",
        &["light_cases/subsurface_transparent"],
    ),
    emulated_quirk(
        "subsurface_single_scattering",
        "Light that is scattered once in `subsurface` is added to the diffuse light that has the pigment's colour, and \
         falls with the distance along the ray more steeply than in nature.",
        &["light_cases/subsurface_slab"],
    ),
    differing_quirk(
        "subsurface_zero_channel",
        "If a channel of the pigment times `diffuse`, or of `translucency`, is 0, or the product above 1, `subsurface` \
         shows no diffuse light in any channel.",
        "only that channel is dark: each channel is computed by itself.",
        &["light_cases/subsurface_zero_channel"],
    ),
    emulated_quirk(
        "total_reflection_replaces_mirror",
        "Total reflection replaces the `reflection` of the same texture where both have the same normal, even if it \
         is too faint to be traced.",
        &["light_cases/tir_prism", "light_cases/adc_prism"],
    ),
    emulated_quirk(
        "total_reflection_weight",
        "All light is totally reflected, but the ray's weight falls as if the light were transmitted.",
        &["light_cases/adc_prism"],
    ),
    emulated_quirk(
        "unlit_layers",
        "At quality 0 and 1, the lowest visible layer of a texture is shown alone.",
        &["light_cases/layers_unlit_q1"],
    ),
    emulated_quirk(
        "untinted_upper_layers",
        "At `#version 3.1` and below, the `filter` of a texture's layer transmits light untinted if another layer is \
         below, as `transmit` does. The version where the layers are put together counts.",
        &["light_cases/layers_before_3_5"],
    ),
    emulated_quirk(
        "upper_texture_first",
        "Of the two textures that a `texture_map` blends, the upper one is evaluated first; `slope` and `aoi` in the \
         other use the normal that its bumps left.",
        &["light_cases/map_ends", "light_cases/slope_after_bumps"],
    ),
];
