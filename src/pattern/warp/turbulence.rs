//! `warp { turbulence <vector> }`: turbulence at its position among the transforms (manual, "Turbulence Warp").
//!
//! ```pov
//! sphere { 0, 1 pigment { gradient x warp { turbulence 0.5 octaves 3 } scale 0.25 } }
//! ```

use super::super::TurbulenceParams;
use super::Bend;
use crate::diagnostic::Result;
use crate::math::DVec3;
use crate::value::words::read_row;
use crate::value::{Next, Param, Readable, Reader, Spec, ValueKind};
use serde::Serialize;

/// Warp `turbulence`: displaces points at random.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct TurbulenceWarp(pub TurbulenceParams);

impl Readable for TurbulenceWarp {
    const SPEC: Spec = Spec {
        name: "turbulence",
        summary: "displaces points at random",
        params: &[Param { name: "amount", kind: ValueKind::Vector, summary: "how far points are displaced" }],
        words: TurbulenceParams::WORDS,
        ..Spec::EMPTY
    };

    fn read(r: &mut dyn Reader) -> Result<Self> {
        Ok(Self(TurbulenceParams { amount: r.vector()?, ..TurbulenceParams::default() }))
    }

    fn read_own(&mut self, next: Next, r: &mut dyn Reader) -> Result<bool> {
        read_row(TurbulenceParams::ROWS, &mut self.0, next, r)
    }
}

impl Bend for TurbulenceWarp {
    fn apply(&self, p: DVec3) -> DVec3 {
        self.0.displace(p)
    }
}
