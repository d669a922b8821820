//! `cylindrical`: falls from 1 on the y axis to 0 one unit away from it (manual, "Cylindrical Pattern").
//!
//! ```pov
//! box { <-1, -1, 0>, <1, 1, 1> pigment { cylindrical color_map { [0 color rgb <0, 0, 1>] [1 color rgb 1] } rotate x*60 } }
//! ```

use super::{Field, FieldParams, LocalBounds, Support, TextureContext};
use crate::diagnostic::Result;
use crate::math::fp;
use crate::value::{Readable, Reader, Spec};
use serde::Serialize;

/// Pattern `cylindrical`: falls from 1 on the y axis to 0 one unit away.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Cylindrical {}

impl Readable for Cylindrical {
    const SPEC: Spec =
        Spec { name: "cylindrical", summary: "falls from 1 on the y axis to 0 one unit away", ..Spec::EMPTY };

    fn read(_: &mut dyn Reader) -> Result<Self> {
        Ok(Self {})
    }
}

impl Field for Cylindrical {
    fn value(&self, at: &TextureContext) -> f64 {
        (1.0 - fp::hypot(at.p.x, at.p.z)).max(0.0)
    }

    fn value_bounds_near(&self, at: &TextureContext, _: &FieldParams, radius: f64) -> LocalBounds {
        LocalBounds::from_max_gradient(self.value(at), 1.0, radius).clamp_range(0.0, 1.0)
    }

    fn support(&self) -> Option<Support> {
        Some(Support::Cylinder)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::DVec3;

    #[test]
    fn concentric_cylinders() {
        let value =
            |x, y, z| Cylindrical {}.value(&TextureContext::without_surface(DVec3::new(x, y, z), Default::default()));
        assert_eq!([value(0.0, 7.0, 0.25), value(0.3, 1.0, 0.4), value(2.0, 0.0, 0.0)], [0.75, 0.5, 0.0]);
    }
}
