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
use crate::math::DVec3;
use std::fmt;
use std::sync::Arc;

/// A function that a scene calls by number, as `internal(N)`.
pub struct Internal {
    /// Number of the internal function, the argument of `internal( )`.
    pub number: u32,
    /// Name of the internal function in `functions.inc`.
    pub name: &'static str,
    /// Summary of the internal function for the manual.
    pub summary: &'static str,
    /// Meaning of each parameter after x, y and z of an internal function, for the manual.
    pub parameters: &'static [&'static str],
    /// Computes the internal function from x, y, z and its parameters; NaN for a wrong number of arguments.
    pub compute: fn(&[f64]) -> f64,
    /// Returns bounds of the internal function while the arguments are in these intervals; `None` if no bounds are
    /// known.
    pub bounds: Option<fn(&[Interval]) -> Interval>,
    /// Returns an upper bound of the gradient's length of the internal function, from the parameters after x, y and z;
    /// `None` if no such bound is known.
    pub steepest: Option<fn(&[f64]) -> f64>,
    /// Returns an upper bound of the change of the internal function's gradient per unit of length, where the function
    /// is strictly between 0 and 1, from the parameters after x, y and z; `None` if no such bound is known.
    pub bend: Option<fn(&[f64]) -> f64>,
    /// Prepares the internal function for constant parameters; `None` if preparation would save nothing.
    pub prepare: Option<Prepare>,
}

/// Function that prepares an internal function for constant parameters after x, y and z, so that what depends on these
/// alone is computed once; returns `None` for a wrong number of parameters.
pub type Prepare = fn(&[f64]) -> Option<Arc<dyn PointFunction>>;

/// An internal function that is prepared for its parameters after x, y and z.
pub trait PointFunction: fmt::Debug + Send + Sync {
    /// Computes the function at a point.
    fn value_at(&self, p: DVec3) -> f64;
}

impl fmt::Debug for Internal {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name)
    }
}

/// Number of the internal function `f_noise3d`, whose generator is set by the scene.
pub const SCENE_NOISE: u32 = 76;

/// Finds the internal function with this number; `None` if no function has the number.
pub fn find_internal(number: u32) -> Option<&'static Internal> {
    TABLE.iter().find(|row| row.number == number)
}

/// Calls a function of an array of N numbers; NaN for another number of arguments.
#[inline]
fn call_with_array<const N: usize>(arguments: &[f64], function: fn([f64; N]) -> f64) -> f64 {
    arguments.try_into().map_or(f64::NAN, function)
}

/// Returns a polynomial times its field strength, clamped to the limit of POV-Ray's internal functions, ±10.
#[inline]
fn scale_and_clamp_field(strength: f64, value: f64) -> f64 {
    (strength * value).clamp(-10.0, 10.0)
}

/// Clamps a value to ±limit.
#[inline]
fn clamp_symmetrically(value: f64, limit: f64) -> f64 {
    value.max(-limit).min(limit)
}

/// Returns the bounds of an internal function that is a clamped polynomial: -10 to 10, whatever the arguments are.
fn bounds_plus_minus_ten(_: &[Interval]) -> Interval {
    Interval { lo: -10.0, hi: 10.0 }
}
