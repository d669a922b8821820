//! `square`: rods along y with square ends, of four kinds (manual, "Square Pattern").
//!
//! ```pov
//! plane { y, 0.1 pigment { square color rgb 1, color rgb x, color rgb y, color rgb z } }
//! ```

use super::{Cells, SIX_COLORS};
use crate::color::Color;
use crate::diagnostic::Result;
use crate::math::DVec3;
use crate::value::{Readable, Reader, Spec};
use serde::Serialize;

/// Pattern `square`: squares of length 1 in the xz plane.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Square {}

impl Readable for Square {
    const SPEC: Spec = Spec { name: "square", summary: "rods with square ends, of four kinds", ..Spec::EMPTY };

    fn read(_: &mut dyn Reader) -> Result<Self> {
        Ok(Self {})
    }
}

impl Cells for Square {
    fn cell_kind_count(&self) -> usize {
        4
    }

    fn cell_kind(&self, p: DVec3) -> usize {
        let odd = |t: f64| t.floor() as i64 & 1 != 0;
        match (odd(p.x), odd(p.z)) {
            (false, false) => 0,
            (false, true) => 1,
            (true, true) => 2,
            (true, false) => 3,
        }
    }

    fn default_color(&self, cell: usize) -> Color {
        Color::opaque(SIX_COLORS[cell])
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn four_kinds_go_around() {
        let cell = |x, z| Square {}.cell_kind(DVec3::new(x, 5.0, z));
        assert_eq!([cell(0.5, 0.5), cell(0.5, 1.5), cell(1.5, 1.5), cell(1.5, 0.5)], [0, 1, 2, 3]);
        assert_eq!(cell(-0.5, -1.5), 3);
    }
}
