//! `ripples`: rings of equal waves from sources around the origin (manual, "Ripples").
//!
//! ```pov
//! plane { y, 0.1 pigment { ripples color_map { [0.3 color rgb <0, 0.1, 0.3>] [0.7 color rgb <0.6, 0.9, 1>] } } }
//! ```

use super::waves::{for_each_wave, wave_sources};
use super::{Field, FieldParams, TextureContext};
use crate::diagnostic::Result;
use crate::math::DVec3;
use crate::value::{Readable, Reader, Spec};
use serde::Serialize;

/// Pattern `ripples`: waves of one length.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Ripples {}

impl Readable for Ripples {
    const SPEC: Spec = Spec {
        name: "ripples",
        summary: "rings of equal waves; `frequency` makes them shorter and `phase` moves them",
        ..Spec::EMPTY
    };

    fn read(_: &mut dyn Reader) -> Result<Self> {
        Ok(Self {})
    }
}

impl Field for Ripples {
    fn value(&self, at: &TextureContext) -> f64 {
        self.value_with_params(at, &FieldParams::NONE)
    }

    fn value_with_params(&self, at: &TextureContext, params: &FieldParams) -> f64 {
        let mut sum = 0.0;
        for_each_wave(at, params.modifiers, |_, frequency| frequency, |_, wave| sum += wave.sine);
        0.5 + 0.5 * sum / wave_sources(at.waves).len() as f64
    }

    fn bumped_normal(&self, at: &TextureContext, params: &FieldParams, n: DVec3, amount: f64) -> Option<DVec3> {
        let mut sum = DVec3::ZERO;
        for_each_wave(
            at,
            params.modifiers,
            |_, frequency| frequency,
            |_, wave| sum += wave.sine * wave.from_source / wave.distance,
        );
        Some(n + amount / wave_sources(at.waves).len() as f64 * sum)
    }
}
