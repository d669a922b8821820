//! Differences between versions of the language; nobody else compares versions.

use crate::color::Gamma;

/// The language of `#version 3.7`, and of a file that names none.
pub const DEFAULT_VERSION: u32 = 370;

/// `#version 3.62` as 362.
pub fn version_number(value: f64) -> u32 {
    (value * 100.0).round().clamp(0.0, 10_000.0) as u32
}

/// Before 3.0 a texture held the words of its pigment, normal and finish without their blocks.
pub fn has_bare_textures(version: u32) -> bool {
    version < 300
}

/// The noise of a scene that names none.
pub fn noise_generator(version: u32) -> u8 {
    if version < 350 { 1 } else { 2 }
}

/// The newest language that is known at least in part.
pub const NEWEST_VERSION: u32 = 380;

/// Do picture files that say nothing of their numbers follow the sRGB curve? (Measured on POV-Ray 3.7.)
pub fn has_srgb_files(version: u32) -> bool {
    version >= 370
}

/// Does a surface keep what its filter's colour holds back? By the version in force at the end (measured on POV-Ray 3.7).
pub fn has_opacity_by_color(version: Option<u32>) -> bool {
    version.is_none_or(|version| version < 370)
}

/// Does a pigment of a sky let those below it through by how much of its filter there is, whatever its colour; and is the sky left out of
/// pictures that keep alpha? By the version in force at the end (measured on POV-Ray 3.7; manual, "Sky Sphere").
pub fn has_sky_by_share(version: Option<u32>) -> bool {
    version.is_none_or(|version| version < 370)
}

/// Is a background there or not as the picture keeps alpha or not, whatever it lets pass? By the version in force where it stands (measured
/// on POV-Ray 3.7).
pub fn has_background_by_picture(version: Option<u32>) -> bool {
    version.is_none_or(|version| version < 370)
}

/// How numbers relate to light in a scene without `assumed_gamma`, by the version in force at its end: measured on
/// POV-Ray 3.7, which leaves scenes of older versions, and of none, without any conversion.
pub fn gamma_without_setting(version: Option<u32>) -> Gamma {
    match version {
        Some(370..) => Gamma::Power(1.0),
        _ => Gamma::Raw,
    }
}
