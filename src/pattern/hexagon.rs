//! `hexagon`: prisms along y with sides of length 1, of three kinds (manual, "Hexagon").
//!
//! ```pov
//! plane { y, 0.1 pigment { hexagon color rgb x, color rgb y, color rgb z } }
//! ```

use super::{Cells, EDGE};
use crate::color::{Color, Rgb};
use crate::diagnostic::Result;
use crate::math::DVec3;
use crate::value::{Readable, Reader, Spec};
use serde::Serialize;

/// Pattern `hexagon`: a honeycomb in the xz plane.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Hexagon {}

impl Readable for Hexagon {
    const SPEC: Spec = Spec { name: "hexagon", summary: "six-sided prisms of three kinds", ..Spec::EMPTY };

    fn read(_: &mut dyn Reader) -> Result<Self> {
        Ok(Self {})
    }
}

impl Cells for Hexagon {
    fn cell_kind_count(&self) -> usize {
        3
    }

    fn cell_kind(&self, p: DVec3) -> usize {
        // Centres are at (3a/2, √3(b + a/2)): the cell is that of the nearest centre, found by rounding cube
        // coordinates (a, b, -a-b) and correcting the coordinate with the largest rounding error.
        const ROOT3: f64 = 1.732_050_807_568_877_2;
        // z = 0 contains edges and corners with exact coordinates: take the cell beyond the edge, or the outer one
        // (quirk: hexagon_edges).
        let (x, z) = if p.z.abs() < EDGE { (p.x + 2.0 * EDGE.copysign(p.x), EDGE) } else { (p.x, p.z) };
        let a = x / 1.5;
        let b = z / ROOT3 - a / 2.0;
        let c = -a - b;
        let (mut ra, mut rb, rc) = (a.round(), b.round(), c.round());
        let (da, db, dc) = ((ra - a).abs(), (rb - b).abs(), (rc - c).abs());
        if da > db && da > dc {
            ra = -rb - rc;
        } else if db > dc {
            rb = -ra - rc;
        }
        ((rb - ra) as i64).rem_euclid(3) as usize
    }

    fn default_color(&self, cell: usize) -> Color {
        Color::opaque([Rgb::Z, Rgb::Y, Rgb::X][cell])
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn neighbours_differ() {
        let cell = |x: f64, z: f64| Hexagon {}.cell_kind(DVec3::new(x, 7.0, z));
        let h = 3f64.sqrt();
        assert_eq!(cell(0.0, 0.0), 0);
        let around = [cell(1.5, h / 2.0), cell(0.0, h), cell(-1.5, h / 2.0), cell(-1.5, -h / 2.0), cell(0.0, -h)];
        assert_eq!(around, [2, 1, 2, 1, 2]);
        assert_eq!(cell(0.99, 0.0), 0);
        assert_eq!(cell(0.0, 0.86), 0);
        assert_eq!(cell(0.0, 0.87), 1);
    }

    #[test]
    fn edges_on_z_0_belong_to_the_cell_beyond() {
        let cell = |x: f64, z: f64| Hexagon {}.cell_kind(DVec3::new(x, 0.5, z));
        for x in [1.2, 1.5, -1.5, -1.8, 4.3, 4.5, -7.5, 31.2] {
            assert_eq!([cell(x, 0.0), cell(x, 1e-9), cell(x, -1e-9)], [2, 2, 1], "{x}");
        }
    }
}
