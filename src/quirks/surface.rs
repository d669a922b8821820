//! Finish, reflection, refraction, dispersion, layers.

use super::{Quirk, emulated};

pub(super) const QUIRKS: &[Quirk] = &[
    emulated(
        "albedo_stays",
        "Once `albedo` is given for `diffuse`, `phong` or `specular`, it stays for later numbers in the same finish; a finish on top of another begins without it.",
        &["light_cases/finish_again", "light_cases/albedo"],
    ),
    emulated(
        "caustics_formula",
        "`caustics` c multiplies light that enters at an angle θ by 1 + cos(θ) to the power 45 c.",
        &["light_cases/area_light_glass"],
    ),
    emulated(
        "dispersion_middle",
        "White light is refracted like the middle of the spectrum; the index for a colour grows exponentially from red to violet.",
        &["light_cases/dispersion_two", "light_cases/dispersion_fine"],
    ),
    emulated(
        "dispersion_needs_ior",
        "`dispersion` has no effect in an interior without `ior`.",
        &["light_cases/dispersion"],
    ),
    emulated(
        "irid_formula",
        "`irid` multiplies the light of each channel by 1 + amount · cos(2π path / wavelength).",
        &["light_cases/finish_mixed_2", "light_cases/area_illumination_irid"],
    ),
    emulated(
        "reflection_again",
        "A second `reflection { }` in a finish keeps `fresnel`, `falloff`, `exponent` and `metallic` of the first; a plain `reflection` switches `fresnel` off.",
        &["light_cases/reflection_twice"],
    ),
];
