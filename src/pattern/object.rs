//! `object { … }`: inside and outside of an object (manual, "Object Pattern").
//!
//! ```pov
//! plane { z, 0 pigment { object { sphere { 0, 1 } color rgb 1, color rgb <1, 0, 0> } } rotate 30*x }
//! ```

use super::Cells;
use crate::color::{Color, Rgb};
use crate::diagnostic::Result;
use crate::math::DVec3;
use crate::value::{Param, Readable, Reader, Solid, Spec, ValueKind};
use serde::{Serialize, Serializer};
use std::sync::Arc;

/// Pattern `object`: points outside the object are of the first kind, points inside of the second.
#[derive(Clone, Debug)]
pub struct ObjectPattern(Arc<dyn Solid>);

impl PartialEq for ObjectPattern {
    fn eq(&self, other: &Self) -> bool {
        Arc::ptr_eq(&self.0, &other.0)
    }
}

impl Serialize for ObjectPattern {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.serialize_unit()
    }
}

impl Readable for ObjectPattern {
    const SPEC: Spec = Spec {
        name: "object",
        summary: "inside and outside of an object; both in its braces, `object { Thing color A, color B }`, A is outside",
        params: &[Param { name: "object", kind: ValueKind::Block, summary: "any object with an inside" }],
        ..Spec::EMPTY
    };

    fn read(r: &mut dyn Reader) -> Result<Self> {
        Ok(Self(r.read_solid()?))
    }
}

impl Cells for ObjectPattern {
    fn cell_kind_count(&self) -> usize {
        2
    }

    fn cell_kind(&self, p: DVec3) -> usize {
        usize::from(self.0.contains(p))
    }

    fn default_color(&self, cell: usize) -> Color {
        Color::opaque(if cell == 0 { Rgb::Z } else { Rgb::Y })
    }
}
