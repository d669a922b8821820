//! `cells`: a random number for each unit cube (manual, "Cells").
//!
//! ```pov
//! box { 0, <4, 3, 2> pigment { cells color_map { [0 color rgb <0.2, 0.1, 0.6>] [1 color rgb <1, 0.9, 0.4>] } scale 0.999 } }
//! ```

use super::{Field, Readable, Spot};
use crate::diagnostic::Result;
use crate::math::noise::Cell;
use crate::value::{Reader, Spec};
use serde::Serialize;

/// Cubes of random numbers.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct RandomCells {}

impl Readable for RandomCells {
    const SPEC: Spec =
        Spec { name: "cells", summary: "unit cubes, each with a random number", params: &[], words: &[] };

    fn read(_: &mut dyn Reader) -> Result<Self> {
        Ok(Self {})
    }
}

impl Field for RandomCells {
    fn value(&self, at: &Spot) -> f64 {
        Cell::of(at.p).0.random()
    }
}
