//! `triangular`: rods along y with triangular ends, of six kinds (manual, "Triangular Pattern").
//!
//! ```pov
//! plane { y, 0.1 pigment { triangular color rgb 1, color rgb 0.8, color rgb 0.6, color rgb 0.4, color rgb 0.2, color rgb 0 } }
//! ```

use super::{Cells, SIX_COLORS};
use crate::color::Color;
use crate::diagnostic::Result;
use crate::math::DVec3;
use crate::value::{Readable, Reader, Spec};
use serde::Serialize;

/// Pattern `triangular`: triangles with sides of length 1 in the xz plane, in rows along x.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Triangular {}

impl Readable for Triangular {
    const SPEC: Spec = Spec { name: "triangular", summary: "rods with triangular ends, of six kinds", ..Spec::EMPTY };

    fn read(_: &mut dyn Reader) -> Result<Self> {
        Ok(Self {})
    }
}

impl Cells for Triangular {
    fn cell_kind_count(&self) -> usize {
        6
    }

    fn cell_kind(&self, p: DVec3) -> usize {
        // Shear the plane so that triangles are halves of squares.
        let row = p.z / (3f64.sqrt() / 2.0);
        let along = p.x - row / 2.0;
        let (j, i) = (row.floor(), along.ceil() - 1.0);
        let upper = (along - i) + (row - j) >= 1.0;
        let column = (i - j).rem_euclid(3.0) as usize;
        if upper { [3, 5, 1][column] } else { [0, 4, 2][column] }
    }

    fn default_color(&self, cell: usize) -> Color {
        Color::opaque(SIX_COLORS[cell])
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_row_has_all_six() {
        let row = [0.5, 1.0, 1.5, 2.0, 2.5, 3.0];
        assert_eq!(row.map(|x| Triangular {}.cell_kind(DVec3::new(x, 0.0, 0.4))), [0, 3, 4, 5, 2, 1]);
        assert_eq!(Triangular {}.cell_kind(DVec3::new(0.5, 0.0, -0.1)), 5);
    }
}
