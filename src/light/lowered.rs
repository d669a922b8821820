//! Lights as a ray needs them: from where, how far, how bright.

use super::beam::{Profile, axis};
use super::{Area, Beam, Light};
use crate::color::Rgb;
use crate::math::{DVec3, fp};
use serde::Serialize;

/// A lowered light.
#[derive(Clone, Debug, Serialize)]
pub struct LoweredLight {
    /// In world space.
    pub location: DVec3,
    /// Negative ones darken.
    pub color: Rgb,
    /// Casts no shadow and makes no highlight.
    pub shadowless: bool,
    /// Distance of full strength, and how fast it fades from there.
    pub fade: Option<(f64, f64)>,
    /// Does the air take from it on its way (`media_attenuation`)?
    pub attenuated: bool,
    /// The grid of lights about its location; never a single one.
    pub area: Option<Area>,
    /// Where its axis goes, length 1.
    axis: DVec3,
    /// How far away the place is that it points at.
    aim: f64,
    /// Is all of its light parallel to its axis?
    parallel: bool,
    profile: Profile,
}

/// Light that arrives at a place, if nothing is in between.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LightSample {
    /// Where it comes from; length 1.
    pub from: DVec3,
    /// How far it comes; negative behind a parallel light, which shines there too.
    pub distance: f64,
    /// What arrives.
    pub light: Rgb,
}

impl LoweredLight {
    /// Lowers a light that has been moved to its place.
    pub fn new(light: &Light) -> Self {
        let fade =
            (light.fade_distance > 0.0 && light.fade_power > 0.0).then_some((light.fade_distance, light.fade_power));
        Self {
            location: light.location,
            color: light.color,
            shadowless: light.shadowless,
            fade,
            attenuated: light.media_attenuation,
            area: (light.spreads && light.area.size != [1; 2]).then(|| light.area.clone()),
            axis: axis(light.location, light.point_at),
            aim: light.location.distance(light.point_at),
            parallel: light.parallel || matches!(light.beam, Beam::Cylinder(_)),
            profile: Profile::of(&light.beam),
        }
    }

    /// What arrives at a point from the light that stands at `offset` from its location.
    pub fn sample(&self, p: DVec3, offset: DVec3) -> LightSample {
        // (A tube is that of the middle of a grid: measured on POV-Ray 3.7.)
        let ahead = (p - self.location).dot(self.axis);
        let way = self.location + offset - p;
        let from = match self.parallel {
            true if offset == DVec3::ZERO => -self.axis,
            // Each light of a grid shines in a direction of its own, from its place to the one that all point at.
            true => (offset - self.axis * self.aim).normalize_or(-self.axis),
            false => way / way.length(),
        };
        // (Of parallel light, how far its place lies in that direction, for each light of a grid.)
        let distance = if self.parallel { way.dot(from) } else { way.length() };
        let beside = || (p - self.location - self.axis * ahead).length();
        let share = match self.profile {
            Profile::Round => 1.0,
            // A beam without an axis shines nowhere (measured on POV-Ray 3.7).
            _ if self.axis == DVec3::ZERO => 0.0,
            // (Behind a parallel light, a cone is seen from its back.)
            profile if self.parallel => profile.share(-from.dot(self.axis) * distance.signum(), beside(), ahead),
            profile => profile.share(-from.dot(self.axis), beside(), ahead),
        };
        let lit = if self.parallel && self.axis == DVec3::ZERO { 0.0 } else { share };
        LightSample { from, distance, light: self.strength(distance) * lit }
    }

    /// The light at a distance when nothing is in between; behind a parallel light that is below 0, and an odd power brightens and
    /// darkens there (measured on POV-Ray 3.7).
    fn strength(&self, distance: f64) -> Rgb {
        match self.fade {
            // 2 / (1 + (d/d₀)ᵏ)
            Some((from, power)) => {
                let share = 2.0 / (1.0 + fp::pow(distance / from, power));
                // (No number: behind the light, by a power that is not whole.)
                if share.is_nan() { Rgb::ZERO } else { self.color * share }
            }
            None => self.color,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn parallel_light_comes_from_its_plane() {
        // seen in POV-Ray 3.7: it fades by the distance from there, and shines behind it too
        let light = Light {
            location: DVec3::new(0.0, 0.0, -4.0),
            point_at: DVec3::ZERO,
            parallel: true,
            color: Rgb::ONE,
            fade_distance: 2.0,
            fade_power: 2.0,
            ..Light::default()
        };
        let lamp = LoweredLight::new(&light);
        let arriving = lamp.sample(DVec3::new(5.0, 0.0, 0.0), DVec3::ZERO);
        assert_eq!((arriving.from, arriving.distance), (DVec3::NEG_Z, 4.0));
        assert!((arriving.light.x - 0.4).abs() < 1e-15);
        let behind = lamp.sample(DVec3::new(5.0, 0.0, -8.0), DVec3::ZERO);
        assert_eq!((behind.from, behind.distance), (DVec3::NEG_Z, -4.0));
    }

    #[test]
    fn round_light_comes_from_its_place() {
        let light = Light { location: DVec3::Y * 3.0, color: Rgb::ONE, ..Light::default() };
        let arriving = LoweredLight::new(&light).sample(DVec3::X * 4.0, DVec3::ZERO);
        assert_eq!((arriving.from, arriving.distance), (DVec3::new(-0.8, 0.6, 0.0), 5.0));
    }
}
