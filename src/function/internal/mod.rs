//! The functions behind `functions.inc`: `function { internal(N) }` (manual, "functions.inc"). Formulas are those of
//! published surfaces, with what was measured on POV-Ray 3.7.0.10; `tests/suite/function_internals.rs` compares each with it.

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

/// One of them.
pub struct Internal {
    /// What `internal( )` takes.
    pub number: u32,
    /// As `functions.inc` calls it.
    pub name: &'static str,
    /// What it is, for the manual.
    pub summary: &'static str,
    /// What each number beside x, y and z means, for the manual.
    pub parameters: &'static [&'static str],
    /// x, y, z and the parameters; NaN for another count.
    pub compute: fn(&[f64]) -> f64,
    /// Between which numbers it lies while the arguments lie in these intervals.
    pub bounds: Option<fn(&[Interval]) -> Interval>,
    /// No shorter than its gradient anywhere, for the numbers beside x, y and z.
    pub steepest: Option<fn(&[f64]) -> f64>,
    /// By no more than this does its gradient change along a way of length 1, where its numbers lie strictly between 0 and 1.
    pub bend: Option<fn(&[f64]) -> f64>,
}

impl fmt::Debug for Internal {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name)
    }
}

/// `f_noise3d`: which noise it is, the scene says.
pub const SCENE_NOISE: u32 = 76;

/// The function of this number.
pub fn find(number: u32) -> Option<&'static Internal> {
    TABLE.iter().find(|row| row.number == number)
}

/// Calls a function of N numbers.
#[inline]
fn call<const N: usize>(arguments: &[f64], function: fn([f64; N]) -> f64) -> f64 {
    arguments.try_into().map_or(f64::NAN, function)
}

/// A polynomial times its field strength, as far as POV-Ray follows it.
#[inline]
fn field(strength: f64, value: f64) -> f64 {
    (strength * value).clamp(-10.0, 10.0)
}

/// A value and the field limit.
#[inline]
fn clamped(value: f64, limit: f64) -> f64 {
    value.max(-limit).min(limit)
}

/// Where [`field`] lies.
fn field_bounds(_: &[Interval]) -> Interval {
    Interval { lo: -10.0, hi: 10.0 }
}
