//! Functions of vectors (manual, "Vector Functions").

use super::{Builtin, float};
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
        name: "vcross",
        usage: "(Vector, Vector)",
        summary: "the cross product: a vector at right angles to both",
        arity: 2..=2,
        run: |a| vector(a.vector(0)?.cross(a.vector(1)?)),
    },
    Builtin {
        name: "vdot",
        usage: "(Vector, Vector)",
        summary: "the dot product",
        arity: 2..=2,
        run: |a| float(a.vector(0)?.dot(a.vector(1)?)),
    },
    Builtin {
        name: "vlength",
        usage: "(Vector)",
        summary: "the length",
        arity: 1..=1,
        run: |a| float(a.vector(0)?.length()),
    },
    Builtin {
        name: "vnormalize",
        usage: "(Vector)",
        summary: "the vector of length 1 in the same direction",
        arity: 1..=1,
        // A vector of length 0 is returned unchanged.
        run: |a| vector(a.vector(0)?.normalize_or_zero()),
    },
    Builtin {
        name: "vturbulence",
        usage: "(Lambda, Omega, Octaves, Point)",
        summary: "the offset that turbulence gives a point",
        arity: 4..=4,
        run: |a| vector(noise::vturbulence(a.vector(3)?, Turbulence::new(a.float(0)?, a.float(1)?, a.float(2)?))),
    },
    Builtin {
        name: "vrotate",
        usage: "(Vector, Degrees)",
        summary: "turned about the x axis, then y, then z, as `rotate` does",
        arity: 2..=2,
        run: |a| vector(Transform::rotate(a.vector(1)?).transform_vector(a.vector(0)?)),
    },
];

fn vector(v: DVec3) -> Result<Value> {
    Ok(Value::Vector(v.into()))
}
