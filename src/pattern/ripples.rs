//! `ripples`: rings of equal waves from sources around the origin (manual, "Ripples").
//!
//! ```pov
//! plane { y, 0.1 pigment { ripples color_map { [0.3 color rgb <0, 0.1, 0.3>] [0.7 color rgb <0.6, 0.9, 1>] } } }
//! ```

use super::waves::{Source, wave_sources};
use super::{Field, FieldParams, TextureContext};
use crate::diagnostic::Result;
use crate::math::{DVec3, fp};
use crate::value::{Readable, Reader, Spec};
use serde::Serialize;
use std::f64::consts::TAU;

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
        let (frequency, phase) = (params.modifiers.frequency.unwrap_or(1.0), params.modifiers.phase);
        let wave = |s: &Source| fp::sin(TAU * (frequency * at.p.distance(s.place) + phase));
        let sources = wave_sources(at.waves);
        0.5 + 0.5 * sources.iter().map(wave).sum::<f64>() / sources.len() as f64
    }

    fn bumped_normal(&self, at: &TextureContext, params: &FieldParams, n: DVec3, amount: f64) -> Option<DVec3> {
        let (frequency, phase) = (params.modifiers.frequency.unwrap_or(1.0), params.modifiers.phase);
        let wave = |s: &Source| {
            let from = at.p - s.place;
            let r = from.length();
            fp::sin(TAU * (frequency * r + phase)) * from / r
        };
        let sources = wave_sources(at.waves);
        Some(n + amount / sources.len() as f64 * sources.iter().map(wave).sum::<DVec3>())
    }
}
