//! Built-in functions whose arguments are vectors alone (manual, "Vector Functions").

use super::quick::Quick;
use crate::math::{DVec3, Transform};

/// Built-in function of one or two vectors.
pub(in crate::interpreter) struct VectorFunction {
    pub name: &'static str,
    /// Arguments of the function as the manual prints them.
    pub usage: &'static str,
    /// Summary of the function for the manual.
    pub summary: &'static str,
    kernel: Kernel,
}

/// Computation of a function of vectors, by the types of its arguments and of its result.
#[derive(Clone, Copy)]
enum Kernel {
    VectorToNumber(fn(DVec3) -> f64),
    VectorToVector(fn(DVec3) -> DVec3),
    VectorsToNumber(fn(DVec3, DVec3) -> f64),
    VectorsToVector(fn(DVec3, DVec3) -> DVec3),
}

impl VectorFunction {
    /// Number of the function's arguments.
    pub fn arity(&self) -> usize {
        match self.kernel {
            Kernel::VectorToNumber(_) | Kernel::VectorToVector(_) => 1,
            Kernel::VectorsToNumber(_) | Kernel::VectorsToVector(_) => 2,
        }
    }

    /// Calls the function; `argument` returns the argument of this index, and may fail.
    #[inline]
    pub fn call<E>(&self, mut argument: impl FnMut(usize) -> Result<DVec3, E>) -> Result<Quick, E> {
        Ok(match self.kernel {
            Kernel::VectorToNumber(f) => Quick::Float(f(argument(0)?)),
            Kernel::VectorToVector(f) => Quick::Vector(f(argument(0)?).into()),
            Kernel::VectorsToNumber(f) => Quick::Float(f(argument(0)?, argument(1)?)),
            Kernel::VectorsToVector(f) => Quick::Vector(f(argument(0)?, argument(1)?).into()),
        })
    }
}

const fn row(name: &'static str, usage: &'static str, summary: &'static str, kernel: Kernel) -> VectorFunction {
    VectorFunction { name, usage, summary, kernel }
}

/// The functions of vectors.
pub(in crate::interpreter) const VECTOR_FUNCTIONS: &[VectorFunction] = &[
    row(
        "vcross",
        "(Vector, Vector)",
        "the cross product: a vector at right angles to both",
        Kernel::VectorsToVector(|a, b| a.cross(b)),
    ),
    row("vdot", "(Vector, Vector)", "the dot product", Kernel::VectorsToNumber(|a, b| a.dot(b))),
    row("vlength", "(Vector)", "the length", Kernel::VectorToNumber(|v| v.length())),
    // A vector of length 0 is returned unchanged.
    row(
        "vnormalize",
        "(Vector)",
        "the vector of length 1 in the same direction",
        Kernel::VectorToVector(|v| v.normalize_or_zero()),
    ),
    row(
        "vrotate",
        "(Vector, Degrees)",
        "turned about the x axis, then y, then z, as `rotate` does",
        Kernel::VectorsToVector(|v, degrees| Transform::rotate(degrees).transform_vector(v)),
    ),
];
