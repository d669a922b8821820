//! `spherical`: falls from 1 at the origin to 0 one unit away (manual, "Spherical Pattern").
//!
//! ```pov
//! box { <-1, -1, 0>, <1, 1, 1> pigment { spherical color_map { [0 color rgb <0, 0, 1>] [1 color rgb 1] } } }
//! ```

use super::{Field, FieldParams, LocalBounds, Support, TextureContext};
use crate::diagnostic::Result;
use crate::value::{Readable, Reader, Spec};
use serde::Serialize;

/// Pattern `spherical`: falls from 1 at the origin to 0 one unit away.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Spherical {}

impl Readable for Spherical {
    const SPEC: Spec =
        Spec { name: "spherical", summary: "falls from 1 at the origin to 0 one unit away", ..Spec::EMPTY };

    fn read(_: &mut dyn Reader) -> Result<Self> {
        Ok(Self {})
    }
}

impl Field for Spherical {
    fn value(&self, at: &TextureContext) -> f64 {
        (1.0 - at.p.length()).max(0.0)
    }

    fn value_bounds_near(&self, at: &TextureContext, _: &FieldParams, radius: f64) -> LocalBounds {
        LocalBounds::from_max_gradient(self.value(at), 1.0, radius).clamp_range(0.0, 1.0)
    }

    fn support(&self) -> Option<Support> {
        Some(Support::Ball)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::DVec3;

    #[test]
    fn concentric_spheres() {
        let value =
            |x, y, z| Spherical {}.value(&TextureContext::without_surface(DVec3::new(x, y, z), Default::default()));
        assert_eq!([value(0.0, 0.25, 0.0), value(0.3, 0.0, 0.4), value(0.0, 0.0, 2.0)], [0.75, 0.5, 0.0]);
    }
}
