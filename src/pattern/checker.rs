//! `checker`: cubes with edges of length 1, alternately of two kinds (manual, "Checker").
//!
//! ```pov
//! plane { y, 0.1 pigment { checker color rgb 1, color rgb 0 } }
//! ```

use super::{Cells, EDGE};
use crate::color::{Color, Rgb};
use crate::diagnostic::Result;
use crate::math::DVec3;
use crate::value::{Readable, Reader, Spec};
use serde::Serialize;

/// Pattern `checker`: unit cubes of two alternating kinds.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Checker {}

impl Readable for Checker {
    const SPEC: Spec = Spec { name: "checker", summary: "cubes of two kinds in turns", ..Spec::EMPTY };

    fn read(_: &mut dyn Reader) -> Result<Self> {
        Ok(Self {})
    }
}

impl Cells for Checker {
    fn cell_kind_count(&self) -> usize {
        2
    }

    fn cell_kind(&self, p: DVec3) -> usize {
        // the parity of ⌊x⌋ + ⌊y⌋ + ⌊z⌋
        let f = (p + EDGE).floor();
        let sum = (f.x as i64).wrapping_add(f.y as i64).wrapping_add(f.z as i64);
        (sum & 1) as usize
    }

    fn is_uniform(&self, p: DVec3, radius: f64) -> bool {
        // from the next whole number
        let from = (p + EDGE - (p + EDGE).round()).abs();
        from.min_element() > radius + EDGE
    }

    fn default_color(&self, cell: usize) -> Color {
        Color::opaque(if cell == 0 { Rgb::Z } else { Rgb::Y })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn cells_alternate_also_below_zero() {
        let cell = |x, y, z| Checker {}.cell_kind(DVec3::new(x, y, z));
        assert_eq!(
            [cell(0.5, 0.5, 0.5), cell(1.5, 0.5, 0.5), cell(-0.5, 0.5, 0.5), cell(-0.5, -0.5, 0.5)],
            [0, 1, 1, 0]
        );
    }

    #[test]
    fn a_plane_at_a_whole_number_does_not_flicker() {
        assert_eq!(Checker {}.cell_kind(DVec3::new(0.5, -1e-12, 0.5)), 0);
    }
}
