//! `cubic`: six pyramids that meet at the origin, one for each face of a cube (manual, "Cubic Pattern").
//!
//! ```pov
//! sphere { 0, 1 pigment { cubic color rgb x, color rgb y, color rgb z, color rgb 1, color rgb 0.5, color rgb 0 } rotate <30, 30, 0> }
//! ```

use super::{Cells, SIX_COLORS};
use crate::color::Color;
use crate::diagnostic::Result;
use crate::math::DVec3;
use crate::value::{Readable, Reader, Spec};
use serde::Serialize;

/// Pattern `cubic`: the nearest of the six directions +x, +y, +z, -x, -y, -z.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Cubic {}

impl Readable for Cubic {
    const SPEC: Spec =
        Spec { name: "cubic", summary: "six pyramids that meet at the origin: +x, +y, +z, -x, -y, -z", ..Spec::EMPTY };

    fn read(_: &mut dyn Reader) -> Result<Self> {
        Ok(Self {})
    }
}

impl Cells for Cubic {
    fn cell_kind_count(&self) -> usize {
        6
    }

    fn cell_kind(&self, p: DVec3) -> usize {
        // the first of equally near directions
        let along = [p.x, p.y, p.z, -p.x, -p.y, -p.z];
        let farthest = p.abs().max_element();
        along.iter().position(|&a| a == farthest).unwrap_or(0)
    }

    fn default_color(&self, cell: usize) -> Color {
        Color::opaque(SIX_COLORS[cell])
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ties_go_to_the_first() {
        let cell = |x, y, z| Cubic {}.cell_kind(DVec3::new(x, y, z));
        assert_eq!(
            [cell(1.0, 0.0, 0.5), cell(0.0, -2.0, 1.0), cell(-1.0, 1.0, 0.0), cell(0.0, -1.0, -1.0)],
            [0, 4, 1, 4]
        );
    }
}
