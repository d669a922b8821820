//! `cells`: a random number for each unit cube (manual, "Cells").
//!
//! ```pov
//! box { 0, <4, 3, 2> pigment { cells color_map { [0 color rgb <0.2, 0.1, 0.6>] [1 color rgb <1, 0.9, 0.4>] } scale 0.999 } }
//! ```

use super::{EDGE, Field, TextureContext};
use crate::diagnostic::Result;
use crate::math::noise::Cell;
use crate::value::{Readable, Reader, Spec};
use serde::Serialize;

/// Pattern `cells`: unit cubes with random numbers.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct RandomCells {}

impl Readable for RandomCells {
    const SPEC: Spec = Spec { name: "cells", summary: "unit cubes, each with a random number", ..Spec::EMPTY };

    fn read(_: &mut dyn Reader) -> Result<Self> {
        Ok(Self {})
    }
}

impl Field for RandomCells {
    fn value(&self, at: &TextureContext) -> f64 {
        Cell::cell_and_position(at.p + EDGE).0.random()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::DVec3;

    #[test]
    fn a_border_belongs_to_the_cell_behind_it() {
        // POV-Ray 3.7's numbers
        let at = |x: f64| {
            (RandomCells {}.value(&TextureContext::without_surface(DVec3::new(x, 0.5, 0.5), Default::default())) * 1e6)
                .round()
        };
        assert_eq!([0.5, 1.0 - 1.01e-10].map(at), [711_819.0; 2]);
        assert_eq!([1.0 - 0.99e-10, 1.0, 1.5].map(at), [681_271.0; 3]);
    }
}
