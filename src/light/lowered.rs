//! Lowered lights: direction, distance and strength of the light at a point.

use super::beam::{Profile, beam_axis};
use super::{Area, Beam, Light};
use crate::color::Rgb;
use crate::math::{DVec3, fp};
use serde::Serialize;

/// Lowered light source, in world space.
#[derive(Clone, Debug, Serialize)]
pub struct LoweredLight {
    /// Location of the light in world space.
    pub location: DVec3,
    /// Colour of the light; negative values darken.
    pub color: Rgb,
    /// True if the light casts no shadow and makes no highlight.
    pub shadowless: bool,
    /// Distance at which the light has its full strength, and exponent of the fall-off beyond it; `None` for no
    /// fall-off.
    pub fade: Option<(f64, f64)>,
    /// True if air attenuates the light (`media_attenuation`).
    pub attenuated: bool,
    /// Grid of the area light about its location; never a single light. `None` for a point light.
    pub area: Option<Area>,
    /// Direction of the light's axis, length 1.
    axis: DVec3,
    /// Distance from the light's location to its `point_at`.
    aim: f64,
    /// True if all rays of the light are parallel.
    parallel: bool,
    profile: Profile,
}

/// Light that reaches a point if nothing occludes it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LightSample {
    /// Direction from the point to the light, length 1.
    pub from: DVec3,
    /// Distance from the point to the light; negative behind a parallel light, which illuminates points there too
    /// (quirk: `parallel_light_behind`).
    pub distance: f64,
    /// Light that reaches the point.
    pub light: Rgb,
}

impl LoweredLight {
    /// Lowers a light that is already in world space.
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
            axis: beam_axis(light.location, light.point_at),
            aim: light.location.distance(light.point_at),
            parallel: light.parallel || matches!(light.beam, Beam::Cylinder(_)),
            profile: Profile::from_beam(&light.beam),
        }
    }

    /// Returns the light that reaches the point `p` from the light at `offset` from the location.
    pub fn sample(&self, p: DVec3, offset: DVec3) -> LightSample {
        // quirk: area_light_tube
        let ahead = (p - self.location).dot(self.axis);
        let way = self.location + offset - p;
        let from = match self.parallel {
            true if offset == DVec3::ZERO => -self.axis,
            // Each light of a grid shines from its position towards `point_at`.
            true => (offset - self.axis * self.aim).normalize_or(-self.axis),
            false => way / way.length(),
        };
        // Distance of a parallel light: along its direction.
        let distance = if self.parallel { way.dot(from) } else { way.length() };
        let beside = || (p - self.location - self.axis * ahead).length();
        let share = match self.profile {
            Profile::Round => 1.0,
            // quirk: beam_without_axis
            _ if self.axis == DVec3::ZERO => 0.0,
            // Behind a parallel light, the cone is reversed.
            profile if self.parallel => {
                profile.strength_share(-from.dot(self.axis) * distance.signum(), beside(), ahead)
            }
            profile => profile.strength_share(-from.dot(self.axis), beside(), ahead),
        };
        let lit = if self.parallel && self.axis == DVec3::ZERO { 0.0 } else { share };
        LightSample { from, distance, light: self.strength_at(distance) * lit }
    }

    /// Returns the light's strength at a distance. Behind a parallel light the distance is negative, and an odd
    /// exponent brightens and darkens there (quirk: `parallel_light_behind`).
    fn strength_at(&self, distance: f64) -> Rgb {
        match self.fade {
            // 2 / (1 + (d/d₀)ᵏ)
            Some((from, power)) => {
                let share = 2.0 / (1.0 + fp::pow(distance / from, power));
                // NaN: a fractional power behind the light.
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
        // POV-Ray: the light fades by the distance from its plane, and illuminates points behind the plane too
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
