//! Backgrounds, sky spheres, fogs, rainbows.

use super::{Quirk, emulated_quirk};

pub(super) const QUIRKS: &[Quirk] = &[
    emulated_quirk(
        "background_before_3_7",
        "Before `#version 3.7` a background is absent from pictures with alpha and complete in others, whatever it \
         transmits.",
        &["src/atmosphere/background.rs::light_by_view_and_version"],
    ),
    emulated_quirk(
        "background_by_view",
        "Reflections show the whole background; pictures with alpha show the part that it does not transmit, and \
         others also the light that it filters.",
        &["src/atmosphere/background.rs::light_by_view_and_version"],
    ),
    emulated_quirk(
        "fog_far",
        "Where a ray hits nothing, fog counts up to a distance of 2e10.",
        &["light_cases/fog", "light_cases/fog_ground_turbulent"],
    ),
    emulated_quirk(
        "fog_needs_hollow",
        "There is no fog inside an object that is not `hollow`.",
        &["light_cases/fog_in_glass", "light_cases/fog_in_union"],
    ),
    emulated_quirk(
        "fogs_add",
        "Several fogs add their colours independently; each attenuates what is behind.",
        &["light_cases/fog_two"],
    ),
    emulated_quirk(
        "rainbow_default_distance",
        "A rainbow without `distance` shows what is behind it without attenuation.",
        &["light_cases/rainbow_without_distance"],
    ),
    emulated_quirk(
        "rainbows_average",
        "Several rainbows at one point show their mean.",
        &["src/atmosphere/rainbow.rs::light_of_one_and_two_rainbows"],
    ),
    emulated_quirk(
        "sky_by_share",
        "Before `#version 3.7`, each layer of a `sky_sphere` counts by the share that the layers above transmit, \
         light that passes all layers takes the product of their colours, and pictures with alpha show no sky.",
        &["light_cases/sky_sphere_before_37", "src/world/sky.rs::layers_by_version"],
    ),
    emulated_quirk(
        "sky_sphere_pigment",
        "Pigments of a `sky_sphere` start from black, not from the default pigment; pigments in their maps start from \
         the default.",
        &["light_cases/sky_default"],
    ),
    emulated_quirk(
        "sky_sphere_transform",
        "A transform in a `sky_sphere` applies to all its pigments, also to those written after it.",
        &["light_cases/sky_sphere"],
    ),
];
