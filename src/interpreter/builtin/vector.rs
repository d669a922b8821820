//! Functions of vectors and numbers (manual, "Vector Functions"); those of vectors alone are in the evaluator.

use super::Builtin;
use crate::diagnostic::Result;
use crate::math::noise::{self, Turbulence};
use crate::math::{DVec3, Transform};
use crate::value::Value;

pub(super) const TABLE: &[Builtin] = &[
    Builtin {
        name: "vaxis_rotate",
        usage: "(Vector, Axis, Degrees)",
        summary: "turned about an axis through the origin",
        arity: 3..=3,
        run: |a| {
            let (v, axis, degrees) = (a.vector(0)?, a.vector(1)?, a.float(2)?);
            if axis == DVec3::ZERO {
                return a.domain_error(1, "an axis of length 0 points nowhere".into());
            }
            vector(Transform::rotate_about(axis, degrees).transform_vector(v))
        },
    },
    Builtin {
        name: "vturbulence",
        usage: "(Lambda, Omega, Octaves, Point)",
        summary: "the offset that turbulence gives a point",
        arity: 4..=4,
        run: |a| vector(noise::vturbulence(a.vector(3)?, Turbulence::new(a.float(0)?, a.float(1)?, a.float(2)?))),
    },
];

fn vector(v: DVec3) -> Result<Value> {
    Ok(Value::Vector(v.into()))
}
