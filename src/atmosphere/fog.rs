//! `fog { distance D color }`: colour that covers distant objects (manual, "Fog").
//!
//! ```pov
//! fog { distance 30 rgb <0.8, 0.85, 0.9> }
//! ```

use super::{Segment, transmittance_at_least_transmit};
use crate::color::Color;
use crate::diagnostic::Result;
use crate::math::noise::{self, NoiseGenerator};
use crate::math::{DVec3, Ray, Transform, fp};
use crate::pattern::TurbulenceParams;
use crate::value::ValueKind::{Float, Vector};
use crate::value::words::{Row, joined, read_row, set, specs, word};
use crate::value::{Next, Reader, ReaderExt, Spec, Thing};
use serde::Serialize;

/// Fog of a scene: attenuates light by distance and adds its colour.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Fog {
    /// Type of the fog: 2 for ground fog, which is denser below; any other number for uniform fog.
    pub fog_type: f64,
    /// Distance in the fog over which light falls to 1/e, in world units; 0 for no fog.
    pub distance: f64,
    /// Colour of the fog; `transmit` is the minimum transmittance, `filter` tints transmitted light.
    pub color: Color,
    /// Turbulence of the fog's density.
    pub turbulence: TurbulenceParams,
    /// Share of the fog that turbulence can remove.
    pub turb_depth: f64,
    /// Height up to which ground fog has its full density.
    pub fog_offset: f64,
    /// Height above `fog_offset` at which ground fog has half its density.
    pub fog_alt: f64,
    /// Upward direction for ground fog, in world space.
    pub up: DVec3,
}

impl Default for Fog {
    fn default() -> Self {
        Self {
            fog_type: 1.0,
            distance: 0.0,
            color: Color::BLACK,
            turbulence: TurbulenceParams::STILL,
            turb_depth: 0.5,
            fog_offset: 0.0,
            fog_alt: 0.0,
            up: DVec3::Y,
        }
    }
}

impl Thing for Fog {
    fn kind(&self) -> &'static str {
        "fog"
    }
}

const FOG_ROWS: &[Row<Fog>] = &[
    word("distance", Float, "0", "how far one sees: there, a third of what lies behind is left; 0 is no fog")
        .sets(|s, r| set(&mut s.distance, r.float())),
    word("fog_type", Float, "1", "1: the same everywhere; 2: it thins out with the height")
        .sets(|s, r| set(&mut s.fog_type, r.float())),
    word("fog_offset", Float, "0", "type 2: up to which height it is dense")
        .sets(|s, r| set(&mut s.fog_offset, r.float())),
    word("fog_alt", Float, "0", "type 2: how far above that it is half as dense")
        .sets(|s, r| set(&mut s.fog_alt, r.float())),
    word("up", Vector, "<0, 1, 0>", "type 2: which way is up; of transforms, only rotations change it")
        .sets(|s, r| set(&mut s.up, r.vector())),
    word("turb_depth", Float, "0.5", "how much of the fog turbulence takes away, 0 to 1")
        .sets(|s, r| set(&mut s.turb_depth, r.float())),
];

/// Words of a `fog { … }` block, without those of colours.
pub const FOG: Spec = Spec {
    name: "fog",
    summary: "colour that covers what is far; its `transmit` leaves so much clear, its `filter` colours what is behind",
    words: &joined::<{ FOG_ROWS.len() + TurbulenceParams::WORDS.len() }>(specs!(FOG_ROWS), TurbulenceParams::WORDS),
    has_transforms: true,
    ..Spec::EMPTY
};

impl Fog {
    /// Reads the items of a `fog` block.
    ///
    /// # Errors
    /// A diagnostic at the first item that is not understood.
    pub fn read(r: &mut dyn Reader) -> Result<Self> {
        let mut fog = Self::default();
        loop {
            match r.peek_next()? {
                Next::End => return Ok(fog),
                Next::Thing("fog") => {
                    if let Some(declared) = r.take_declared::<Fog>()? {
                        fog = (*declared).clone();
                    }
                }
                next if read_row(FOG_ROWS, &mut fog, next, r)? => {}
                next if read_row(TurbulenceParams::ROWS, &mut fog.turbulence, next, r)? => {}
                next if next.is_transform() => {
                    if let Some(step) = r.transform()? {
                        fog.transform(&step);
                    }
                }
                Next::Word(_) | Next::Value if r.may_be_at_color()? => fog.color = r.color()?,
                _ => return Err(r.unknown_word_in(&FOG)),
            }
        }
    }

    fn transform(&mut self, by: &Transform) {
        self.up = by.transform_vector(self.up);
    }

    /// True if the fog has an effect: its distance is not 0.
    pub fn has_effect(&self) -> bool {
        self.distance != 0.0
    }

    /// Returns radiance and transmittance of the fog along a ray, whose direction has length 1, up to the distance
    /// `length`.
    pub fn segment(&self, ray: &Ray, length: f64, noise: NoiseGenerator) -> Segment {
        let far = length / self.distance;
        let mut depth = far;
        if self.fog_type.trunc() == 2.0 {
            depth *= self.mean_ground_density(ray, length);
        }
        if self.turbulence.amount != DVec3::ZERO {
            let stirred = (ray.origin + ray.dir * (0.5 * length)) * self.turbulence.amount;
            let gap = self.turb_depth * noise::turbulence(stirred, self.turbulence.to_octaves(), noise);
            depth *= 1.0 - gap.min(1.0) * fp::exp(-far);
        }
        let clear = transmittance_at_least_transmit(&self.color, fp::exp(-depth));
        Segment::from_color(self.color.rgb, clear, self.color.filter)
    }

    /// Mean density of ground fog along a ray: 1 up to the offset, 1/(1 + z²) at height z above it, in units of
    /// `fog_alt`. The integral of the density is z below and atan z above the offset.
    fn mean_ground_density(&self, ray: &Ray, length: f64) -> f64 {
        let up = self.up.normalize_or(DVec3::Y);
        let from = ray.origin.dot(up) - self.fog_offset;
        let to = from + ray.dir.dot(up) * length;
        if self.fog_alt == 0.0 {
            let below = |y: f64| y.min(0.0);
            return if to == from { f64::from(from <= 0.0) } else { (below(to) - below(from)) / (to - from) };
        }
        let (from, to) = (from / self.fog_alt, to / self.fog_alt);
        if (to - from).abs() < 1e-6 {
            let z = 0.5 * (from + to).max(0.0);
            return 1.0 / (1.0 + z * z);
        }
        let integral = |z: f64| if z < 0.0 { z } else { fp::atan(z) };
        (integral(to) - integral(from)) / (to - from)
    }
}

/// Combines all fogs of a scene along a ray: the radiances are added, the transmittances are multiplied (quirk:
/// `fogs_add`).
pub fn combine_fogs_adding_radiance(fogs: &[Fog], ray: &Ray, length: f64, noise: NoiseGenerator) -> Segment {
    fogs.iter().map(|fog| fog.segment(ray, length, noise)).fold(Segment::NONE, |all, one| Segment {
        radiance: all.radiance + one.radiance,
        transmittance: all.transmittance * one.transmittance,
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::color::Rgb;

    fn along(dir: DVec3, from_height: f64, fog: &Fog, length: f64) -> f64 {
        let ray = Ray::new(DVec3::Y * from_height, dir.normalize());
        fog.segment(&ray, length, NoiseGenerator::default()).transmittance.x
    }

    #[test]
    fn constant_fog_is_an_exponential() {
        let fog = Fog { distance: 20.0, ..Fog::default() };
        assert!((along(DVec3::Z, 0.0, &fog, 50.0) - fp::exp(-2.5)).abs() < 1e-15);
    }

    #[test]
    fn ground_fog_is_the_integral_of_its_density() {
        let fog = Fog { fog_type: 2.0, distance: 20.0, fog_offset: 1.0, fog_alt: 2.0, ..Fog::default() };
        for (dir, from) in [(DVec3::new(1.0, 2.0, 10.0), -3.0), (DVec3::new(0.0, -5.0, 30.0), 8.0), (DVec3::Z, 3.0)] {
            let (length, steps) = (20.0, 100_000);
            let height = |i: usize| from + dir.normalize().y * length * (i as f64 + 0.5) / steps as f64;
            let density = |y: f64| if y < 1.0 { 1.0 } else { 1.0 / (1.0 + ((y - 1.0) / 2.0) * ((y - 1.0) / 2.0)) };
            let mean = (0..steps).map(|i| density(height(i))).sum::<f64>() / steps as f64;
            assert!((along(dir, from, &fog, length) - fp::exp(-mean)).abs() < 1e-6);
        }
    }

    #[test]
    fn filter_and_transmit() {
        // POV-Ray: a background <1, 0.5, 0.25> behind infinite fog
        let color = Color { rgb: Rgb::new(0.2, 0.4, 0.6), filter: 0.3, transmit: 0.5 };
        let fog = Fog { distance: 20.0, color, ..Fog::default() };
        let veil = fog.segment(&Ray::new(DVec3::ZERO, DVec3::Z), Segment::FAR, NoiseGenerator::default());
        let seen = veil.radiance + veil.transmittance * Rgb::new(1.0, 0.5, 0.25);
        assert!(seen.distance(Rgb::new(0.48, 0.405, 0.41)) < 1e-12, "{seen}");
    }
}
