//! Differences between versions of the language; nobody else compares versions.

/// The language of `#version 3.7`, and of a file that names none.
pub const DEFAULT_VERSION: u32 = 370;

/// `#version 3.62` as 362.
pub fn version_number(value: f64) -> u32 {
    (value * 100.0).round().clamp(0.0, 10_000.0) as u32
}

/// The newest language that is known at least in part.
pub const NEWEST_VERSION: u32 = 380;
