//! Differences between language versions. Only this module compares versions.

use crate::color::Gamma;

/// Language version of a scene that states none.
pub const DEFAULT_VERSION: u32 = 370;

/// Converts the number of a `#version` directive to an integer: 3.62 to 362.
pub fn version_number(value: f64) -> u32 {
    (value * 100.0).round().clamp(0.0, 10_000.0) as u32
}

/// True if a texture holds the words of its pigment, normal and finish without their blocks, as before 3.0.
pub fn has_bare_textures(version: u32) -> bool {
    version < 300
}

/// True if media are sampled by method 1 unless they state a method (quirk: `media_defaults`).
pub fn has_random_media(version: u32) -> bool {
    version < 350
}

/// Returns the number of the noise generator for a scene that sets none.
pub fn default_noise_generator(version: u32) -> u8 {
    if version < 350 { 1 } else { 2 }
}

/// Newest language version that durer supports at least in part.
pub const NEWEST_VERSION: u32 = 380;

/// True if picture files without gamma information are read as sRGB (quirk: `srgb_files_since_3_7`).
pub fn has_srgb_files(version: u32) -> bool {
    version >= 370
}

/// True if the opacity of a colour is 1 - filter · (its brightest channel) - transmit, and not 1 - filter - transmit.
/// `version` is in force at the end of the scene (quirk: `opacity_by_version`).
pub fn has_opacity_by_brightest_channel(version: Option<u32>) -> bool {
    version.is_none_or(|version| version < 370)
}

/// True if the `filter` of a texture's layer transmits light untinted where another layer is below (quirk:
/// `untinted_upper_layers`).
pub fn has_untinted_layers(version: u32) -> bool {
    version <= 310
}

/// True if each word of a camera takes effect where it is written (quirk: `camera_words_in_order`).
pub fn has_ordered_cameras(version: u32) -> bool {
    version < 350
}

/// True if operators are allowed outside of parentheses (quirk: `operators_before_1_5`).
pub fn has_bare_operators(version: u32) -> bool {
    version >= 150
}

/// True if a pigment of a sky sphere transmits the pigments below it in proportion to its filter, whatever its colour,
/// and pictures with alpha omit the sky. `version` is in force at the end of the scene (quirk: `sky_by_share`; manual,
/// "Sky Sphere").
pub fn has_pre_3_7_sky(version: Option<u32>) -> bool {
    version.is_none_or(|version| version < 370)
}

/// True if `finish { ambient }` has an effect in a scene with radiosity. `version` is in force at the end of the scene
/// (quirk: `radiosity_keeps_ambient`).
pub fn has_ambient_with_radiosity(version: Option<u32>) -> bool {
    version.is_none_or(|version| version < 370)
}

/// True if pictures with alpha omit the background, even an opaque one, and all other pictures show it. `version` is in
/// force at the `background` (quirk: `background_before_3_7`).
pub fn has_pre_3_7_background(version: Option<u32>) -> bool {
    version.is_none_or(|version| version < 370)
}

/// Returns the working gamma of a scene without `assumed_gamma`. `version` is in force at the end of the scene. POV-Ray
/// does not convert scenes that state an older version or none (quirk: `gamma_by_version`).
pub fn gamma_without_setting(version: Option<u32>) -> Gamma {
    match version {
        Some(370..) => Gamma::Power(1.0),
        _ => Gamma::Raw,
    }
}
