//! `waves`: waves of all lengths from sources around the origin (manual, "Waves").
//!
//! ```pov
//! plane { y, 0.1 pigment { waves color_map { [0.3 color rgb <0, 0.1, 0.3>] [0.7 color rgb <0.6, 0.9, 1>] } scale 0.7 } }
//! ```

use super::{Field, FieldParams, Modifiers, TextureContext};
use crate::diagnostic::Result;
use crate::math::{DVec3, fp, noise};
use crate::value::{Readable, Reader, Spec};
use serde::Serialize;
use std::array::from_fn;
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
        let mut sum = 0.0;
        for_each_wave(at, params.modifiers, frequency, |source, wave| sum += wave.sine / source.frequency);
        0.5 + 0.2 * sum / wave_sources(at.waves).len() as f64
    }

    fn bumped_normal(&self, at: &TextureContext, params: &FieldParams, n: DVec3, amount: f64) -> Option<DVec3> {
        let mut sum = DVec3::ZERO;
        for_each_wave(at, params.modifiers, frequency, |source, wave| {
            sum += wave.sine / source.frequency * wave.from_source / wave.distance;
        });
        Some(n + amount / wave_sources(at.waves).len() as f64 * sum)
    }
}

/// Returns the frequency of a source's wave in a pattern `waves` with this `frequency`.
fn frequency(source: &Source, of_pattern: f64) -> f64 {
    source.frequency * of_pattern
}

/// A wave of the patterns `waves` and `ripples` at a point.
#[derive(Clone, Copy)]
pub struct WaveAtPoint {
    /// Height of the wave.
    pub sine: f64,
    /// Vector from the source to the point.
    pub from_source: DVec3,
    /// Length of that vector.
    pub distance: f64,
}

/// Number of waves that are computed at once: the default of `number_of_waves`.
const MANY: usize = 10;

/// Calls `visit` with each source of waves and its wave at the point of `at`. `frequency` returns the frequency of a source's
/// wave for the `frequency` of the pattern.
#[inline]
pub fn for_each_wave(
    at: &TextureContext,
    modifiers: &Modifiers,
    frequency: impl Fn(&Source, f64) -> f64,
    mut visit: impl FnMut(&Source, &WaveAtPoint),
) {
    let of_pattern = modifiers.frequency.unwrap_or(1.0);
    let angle = |source: &Source, distance: f64| TAU * (frequency(source, of_pattern) * distance + modifiers.phase);
    let (groups, others) = wave_sources(at.waves).as_chunks::<MANY>();
    for group in groups {
        group.iter().zip(&waves_at(at.p, group, angle)).for_each(|(source, wave)| visit(source, wave));
    }
    for source in others {
        let [wave] = waves_at(at.p, &[*source], angle);
        visit(source, &wave);
    }
}

/// Returns the waves of sources at a point. `angle` returns the angle of a wave, in radians, at a distance from its source.
#[inline(always)]
fn waves_at<const N: usize>(p: DVec3, sources: &[Source; N], angle: impl Fn(&Source, f64) -> f64) -> [WaveAtPoint; N] {
    let from_source = sources.each_ref().map(|source| p - source.place);
    let distance = from_source.map(DVec3::length);
    let sine: [f64; N] = fp::sines(from_fn(|i| angle(&sources[i], distance[i])));
    from_fn(|i| WaveAtPoint { sine: sine[i], from_source: from_source[i], distance: distance[i] })
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
