//! `boxed`: falls from 1 at the origin to 0 at the faces of the cube from -1 to 1 (manual, "Boxed Pattern").
//!
//! ```pov
//! box { <-1, -1, 0>, <1, 1, 1> pigment { boxed color_map { [0 color rgb <0, 0, 1>] [1 color rgb 1] } } }
//! ```

use super::{Field, FieldParams, LocalBounds, Support, TextureContext};
use crate::diagnostic::Result;
use crate::value::{Readable, Reader, Spec};
use serde::Serialize;

/// Pattern `boxed`: falls from 1 at the origin to 0 at the faces of a cube.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Boxed {}

impl Readable for Boxed {
    const SPEC: Spec =
        Spec { name: "boxed", summary: "falls from 1 at the origin to 0 at the faces of a cube", ..Spec::EMPTY };

    fn read(_: &mut dyn Reader) -> Result<Self> {
        Ok(Self {})
    }
}

impl Field for Boxed {
    fn value(&self, at: &TextureContext) -> f64 {
        (1.0 - at.p.abs().max_element()).max(0.0)
    }

    fn value_bounds_near(&self, at: &TextureContext, _: &FieldParams, radius: f64) -> LocalBounds {
        LocalBounds::from_max_gradient(self.value(at), 1.0, radius).clamp_range(0.0, 1.0)
    }

    fn support(&self) -> Option<Support> {
        Some(Support::Cube)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::DVec3;

    #[test]
    fn concentric_cubes() {
        let value = |x, y, z| Boxed {}.value(&TextureContext::without_surface(DVec3::new(x, y, z), Default::default()));
        assert_eq!([value(0.25, 0.0, -0.125), value(0.1, -0.5, 0.3), value(0.0, 0.0, 2.0)], [0.75, 0.5, 0.0]);
    }
}
