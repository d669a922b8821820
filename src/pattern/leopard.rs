//! `leopard`: round spots in rows (manual, "Leopard").
//!
//! ```pov
//! box { -1, 1 pigment { leopard color_map { [0.1 color rgb <0.9, 0.7, 0.3>] [0.4 color rgb <0.2, 0.1, 0>] } scale 0.1 } }
//! ```

use super::{Field, FieldParams, LocalBounds, TextureContext};
use crate::diagnostic::Result;
use crate::math::fp;
use crate::value::{Readable, Reader, Spec};
use serde::Serialize;

/// Pattern `leopard`: the square of the mean of three sines.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Leopard {}

impl Readable for Leopard {
    const SPEC: Spec = Spec { name: "leopard", summary: "round spots in rows", ..Spec::EMPTY };

    fn read(_: &mut dyn Reader) -> Result<Self> {
        Ok(Self {})
    }
}

impl Field for Leopard {
    fn value(&self, at: &TextureContext) -> f64 {
        let mean = (fp::sin(at.p.x) + fp::sin(at.p.y) + fp::sin(at.p.z)) / 3.0;
        mean * mean
    }

    fn value_bounds_near(&self, at: &TextureContext, _: &FieldParams, radius: f64) -> LocalBounds {
        // The gradient of the mean is (cos x, cos y, cos z) / 3.
        let mean = (fp::sin(at.p.x) + fp::sin(at.p.y) + fp::sin(at.p.z)) / 3.0;
        let mean = LocalBounds::from_max_gradient(mean, 1.0 / 3f64.sqrt(), radius).clamp_range(-1.0, 1.0);
        let most = mean.range.abs().hi;
        LocalBounds { range: mean.range.square(), steepest: 2.0 * most * mean.steepest, ..mean }
    }
}
