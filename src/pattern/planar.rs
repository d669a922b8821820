//! `planar`: falls from 1 in the xz plane to 0 one unit above and below it (manual, "Planar Pattern").
//!
//! ```pov
//! box { -1, 1 pigment { planar color_map { [0 color rgb <0, 0, 1>] [1 color rgb 1] } } }
//! ```

use super::{Field, FieldParams, LocalBounds, Support, TextureContext};
use crate::diagnostic::Result;
use crate::value::{Readable, Reader, Spec};
use serde::Serialize;

/// Pattern `planar`: falls from 1 in the xz plane to 0 one unit away.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Planar {}

impl Readable for Planar {
    const SPEC: Spec =
        Spec { name: "planar", summary: "falls from 1 in the xz plane to 0 one unit away", ..Spec::EMPTY };

    fn read(_: &mut dyn Reader) -> Result<Self> {
        Ok(Self {})
    }
}

impl Field for Planar {
    fn value(&self, at: &TextureContext) -> f64 {
        (1.0 - at.p.y.abs()).max(0.0)
    }

    fn value_bounds_near(&self, at: &TextureContext, _: &FieldParams, radius: f64) -> LocalBounds {
        LocalBounds::from_max_gradient(self.value(at), 1.0, radius).clamp_range(0.0, 1.0)
    }

    fn support(&self) -> Option<Support> {
        Some(Support::Slab)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::DVec3;

    #[test]
    fn nothing_is_left_one_unit_away() {
        let value =
            |x, y, z| Planar {}.value(&TextureContext::without_surface(DVec3::new(x, y, z), Default::default()));
        assert_eq!([value(9.0, 0.25, 9.0), value(0.0, -0.5, 0.0), value(0.0, 2.0, 0.0)], [0.75, 0.5, 0.0]);
    }
}
