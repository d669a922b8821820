//! `waves`: waves of all lengths from sources around the origin (manual, "Waves").
//!
//! ```pov
//! plane { y, 0.1 pigment { waves color_map { [0.3 color rgb <0, 0.1, 0.3>] [0.7 color rgb <0.6, 0.9, 1>] } scale 0.7 } }
//! ```

use super::{Field, FieldParams, TextureContext};
use crate::diagnostic::Result;
use crate::math::{DVec3, fp, noise};
use crate::value::{Readable, Reader, Spec};
use serde::Serialize;
use std::f64::consts::TAU;
use std::sync::LazyLock;

/// Pattern `waves`: waves of many lengths.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Waves {}

impl Readable for Waves {
    const SPEC: Spec = Spec {
        name: "waves",
        summary: "waves of many lengths; `frequency` makes them shorter and `phase` moves them",
        ..Spec::EMPTY
    };

    fn read(_: &mut dyn Reader) -> Result<Self> {
        Ok(Self {})
    }
}

impl Field for Waves {
    fn value(&self, at: &TextureContext) -> f64 {
        self.value_with_params(at, &FieldParams::NONE)
    }

    fn value_with_params(&self, at: &TextureContext, params: &FieldParams) -> f64 {
        let (frequency, phase) = (params.modifiers.frequency.unwrap_or(1.0), params.modifiers.phase);
        let wave = |s: &Source| {
            let turns = s.frequency * frequency * at.p.distance(s.place) + phase;
            fp::sin(TAU * turns) / s.frequency
        };
        let sources = wave_sources(at.waves);
        0.5 + 0.2 * sources.iter().map(wave).sum::<f64>() / sources.len() as f64
    }

    fn bumped_normal(&self, at: &TextureContext, params: &FieldParams, n: DVec3, amount: f64) -> Option<DVec3> {
        let (frequency, phase) = (params.modifiers.frequency.unwrap_or(1.0), params.modifiers.phase);
        let wave = |s: &Source| {
            let from = at.p - s.place;
            let r = from.length();
            fp::sin(TAU * (s.frequency * frequency * r + phase)) / s.frequency * from / r
        };
        let sources = wave_sources(at.waves);
        Some(n + amount / sources.len() as f64 * sources.iter().map(wave).sum::<DVec3>())
    }
}

/// A source of the patterns `waves` and `ripples`.
#[derive(Clone, Copy, Debug)]
pub struct Source {
    /// Position of the source of waves on the unit sphere.
    pub place: DVec3,
    /// Frequency of the source of waves, from 0.01 to 1.01 per unit.
    pub frequency: f64,
}

/// Returns the first `count` sources of waves: at least one, and at most 4096.
pub fn wave_sources(count: usize) -> &'static [Source] {
    &SOURCES[..count.clamp(1, SOURCES.len())]
}

/// Sources of waves. Positions are vector noise at whole numbers, normalised; frequencies are POV-Ray's random numbers
/// of 15 bits after the first 7168 with seed 1 (quirk: wave_sources).
static SOURCES: LazyLock<Vec<Source>> = LazyLock::new(|| {
    let mut state = 1u32;
    let mut random = move || {
        state = state.wrapping_mul(1_812_433_253).wrapping_add(12_345);
        f64::from(state >> 16 & 0x7fff)
    };
    for _ in 0..7168 {
        random();
    }
    let source = |i| Source {
        place: noise::noise_vector(DVec3::new(f64::from(i), 0.0, 0.0)).normalize_or_zero(),
        // 1/32767 with POV-Ray's digits
        frequency: random() * 3.0518509476e-5 + 0.01,
    };
    (0..4096).map(source).collect()
});
