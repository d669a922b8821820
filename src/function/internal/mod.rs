//! The functions of `functions.inc`: `function { internal(N) }` (manual, "functions.inc"). Formulas are those of
//! published surfaces, with POV-Ray's constants (quirk: `internal_functions`); `tests/suite/function_internals.rs`
//! compares each with POV-Ray.

mod algebraic;
mod helix;
mod misc;
mod noise;
mod planar;
mod quadric;
mod table;

pub use table::TABLE;

use super::Interval;
use std::fmt;

/// A function that a scene calls by number, as `internal(N)`.
pub struct Internal {
    /// Argument of `internal( )`.
    pub number: u32,
    /// Name of the function in `functions.inc`.
    pub name: &'static str,
    /// Summary for the manual.
    pub summary: &'static str,
    /// Meaning of each parameter after x, y and z, for the manual.
    pub parameters: &'static [&'static str],
    /// The function of x, y, z and the parameters; NaN for a wrong number of arguments.
    pub compute: fn(&[f64]) -> f64,
    /// Bounds of the function while the arguments are in these intervals.
    pub bounds: Option<fn(&[Interval]) -> Interval>,
    /// Upper bound of the gradient's length, for the parameters after x, y and z.
    pub steepest: Option<fn(&[f64]) -> f64>,
    /// Upper bound of the gradient's change per unit of length, where the numbers are strictly between 0 and 1.
    pub bend: Option<fn(&[f64]) -> f64>,
}

impl fmt::Debug for Internal {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name)
    }
}

/// Number of `f_noise3d`, whose generator is set by the scene.
pub const SCENE_NOISE: u32 = 76;

/// The function with this number.
pub fn find(number: u32) -> Option<&'static Internal> {
    TABLE.iter().find(|row| row.number == number)
}

/// Calls a function of N numbers.
#[inline]
fn call<const N: usize>(arguments: &[f64], function: fn([f64; N]) -> f64) -> f64 {
    arguments.try_into().map_or(f64::NAN, function)
}

/// A polynomial times its field strength, clamped to POV-Ray's limit.
#[inline]
fn field(strength: f64, value: f64) -> f64 {
    (strength * value).clamp(-10.0, 10.0)
}

/// Clamps a value to ±limit.
#[inline]
fn clamped(value: f64, limit: f64) -> f64 {
    value.max(-limit).min(limit)
}

/// Bounds of [`field`].
fn field_bounds(_: &[Interval]) -> Interval {
    Interval { lo: -10.0, hi: 10.0 }
}
