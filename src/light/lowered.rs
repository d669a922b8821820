//! Lowered lights: direction, distance and strength of the light at a point.

use super::beam::{Profile, beam_axis};
use super::{Area, Beam, Light, LightPhotons};
use crate::color::Rgb;
use crate::math::{DVec3, Ray, fp};
use serde::Serialize;
use smallvec::SmallVec;

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
    /// True if fog, rainbows and media of the whole scene attenuate the light (`media_attenuation`).
    pub attenuated: bool,
    /// True if media scatter the light; `shadowless` lights are not scattered (quirk: `scattered_lights`).
    pub scattered: bool,
    /// Grid of the area light about its location; never a single light. `None` for a point light.
    pub area: Option<Area>,
    /// Settings of the photons that the lowered light emits.
    pub photons: LightPhotons,
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
    pub to_light: DVec3,
    /// Distance from the point to the light; negative behind a parallel light, which illuminates points there too
    /// (quirk: `parallel_light_behind`).
    pub distance: f64,
    /// Red, green and blue of the light that reaches the point without occlusion.
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
            // quirk: media_attenuation_needs_interaction
            attenuated: light.media_attenuation && light.media_interaction,
            scattered: light.media_interaction && !light.shadowless,
            area: (light.spreads && light.area.size != [1; 2]).then(|| light.area.clone()),
            photons: light.photons,
            axis: beam_axis(light.location, light.point_at),
            aim: light.location.distance(light.point_at),
            parallel: light.parallel || matches!(light.beam, Beam::Cylinder(_)),
            profile: Profile::from_beam(&light.beam),
        }
    }

    /// True if all rays of the light are parallel.
    pub fn is_parallel(&self) -> bool {
        self.parallel
    }

    /// True if the light shines from one point with the same strength in all directions and at all distances.
    pub fn is_even_point(&self) -> bool {
        matches!(self.profile, Profile::Round) && !self.parallel && self.area.is_none() && self.fade.is_none()
    }

    /// Returns the light that reaches the point `p` from the light at `offset` from the location.
    pub fn sample(&self, p: DVec3, offset: DVec3) -> LightSample {
        let (to_light, distance) = self.direction_and_distance(p, offset);
        LightSample {
            to_light,
            distance,
            light: self.strength_at(distance) * self.beam_share_at(p, to_light, distance),
        }
    }

    /// Returns the direction from the point `p` to the light at `offset` from the location, length 1, and the distance: of a
    /// parallel light, that along its direction.
    #[inline]
    pub fn direction_and_distance(&self, p: DVec3, offset: DVec3) -> (DVec3, f64) {
        let way = self.location + offset - p;
        if self.parallel {
            // Each light of a grid shines from its position towards `point_at`.
            let from = match offset == DVec3::ZERO {
                true => -self.axis,
                false => (offset - self.axis * self.aim).normalize_or(-self.axis),
            };
            return (from, way.dot(from));
        }
        let length = way.length();
        (way / length, length)
    }

    /// Returns the light's axis, length 1, or 0.
    pub fn axis(&self) -> DVec3 {
        self.axis
    }

    /// Returns the share of the light's strength, from 0 to 1, that its beam sends to the point `p`. `to_light` is the direction
    /// from the point to the light, and `distance` the distance.
    // (Forced: with the photons as a second caller, the compiler would make this a call.)
    #[inline(always)]
    pub fn beam_share_at(&self, p: DVec3, to_light: DVec3, distance: f64) -> f64 {
        // quirk: area_light_tube
        let ahead = (p - self.location).dot(self.axis);
        let beside = || (p - self.location - self.axis * ahead).length();
        let share = match self.profile {
            Profile::Round => 1.0,
            // quirk: beam_without_axis
            _ if self.axis == DVec3::ZERO => 0.0,
            // Behind a parallel light, the cone is reversed.
            profile if self.parallel => {
                profile.strength_share(-to_light.dot(self.axis) * distance.signum(), beside, ahead)
            }
            profile => profile.strength_share(-to_light.dot(self.axis), beside, ahead),
        };
        if self.parallel && self.axis == DVec3::ZERO { 0.0 } else { share }
    }

    /// Returns the stretches of a ray, in order, within the beam of a spotlight or cylinder light: pairs of distances
    /// within `range`. `None` for a light that shines in all directions, and for a spotlight whose falloff is a right
    /// angle or more.
    pub fn beam_stretches(&self, ray: &Ray, range: [f64; 2]) -> Option<SmallVec<[[f64; 2]; 2]>> {
        match self.profile {
            Profile::Round => None,
            // Beyond a right angle, the dark part is a cone; the whole ray counts as lit.
            Profile::Cone { falloff, .. } if falloff <= 0.0 => None,
            Profile::Cone { falloff, .. } => Some(self.stretches_in_cone(ray, range, falloff)),
            Profile::Tube(edge) => Some(self.stretch_in_tube(ray, range, edge.falloff).into_iter().collect()),
        }
    }

    /// Returns the stretches of a ray, in order, within the beam of a spotlight, whose outer edge has this cosine.
    fn stretches_in_cone(&self, ray: &Ray, [from, to]: [f64; 2], cos: f64) -> SmallVec<[[f64; 2]; 2]> {
        let (start, along) = (ray.origin - self.location, ray.dir.dot(self.axis));
        let (ahead, share) = (start.dot(self.axis), cos.powi(2));
        // Roots of the quadratic for the cone's side: (v·a)² - cos²·|v|²
        let a = along * along - share * ray.dir.length_squared();
        let b = along * ahead - share * start.dot(ray.dir);
        let c = ahead * ahead - share * start.length_squared();
        let discriminant = b * b - a * c;
        if discriminant < 0.0 && a < 0.0 {
            return SmallVec::new();
        }
        let root = discriminant.max(0.0).sqrt();
        let mut ends = SmallVec::<[f64; 5]>::from([from, to, (-b - root) / a, (-b + root) / a, -ahead / along]);
        ends.retain(|t| (from..=to).contains(t));
        ends.sort_by(f64::total_cmp);
        let is_lit = |t: f64| a * t * t + 2.0 * b * t + c > 0.0 && ahead + along * t > 0.0;
        let pieces = ends.windows(2).map(|pair| [pair[0], pair[1]]);
        pieces.filter(|[start, end]| end > start && is_lit(0.5 * (start + end))).collect()
    }

    /// Returns the stretch of a ray that counts as within the beam of a cylinder light, of this radius (quirk:
    /// `media_in_tube`).
    fn stretch_in_tube(&self, ray: &Ray, [from, to]: [f64; 2], radius: f64) -> Option<[f64; 2]> {
        let (start, along) = (ray.origin - self.location, ray.dir.dot(self.axis));
        let ahead = start.dot(self.axis);
        // Roots of the quadratic for the tube's side: |v|² - (v·a)² - r²
        let (across, across_dir) = (start - self.axis * ahead, ray.dir - self.axis * along);
        let a = across_dir.length_squared();
        let b = across.dot(across_dir);
        let discriminant = b * b - a * (across.length_squared() - radius * radius);
        if discriminant <= 0.0 {
            return None;
        }
        let root = discriminant.sqrt();
        let (enter, leave) = ((-b - root) / a, (-b + root) / a);
        let is_ahead = |t: f64| ahead + along * t > 0.0;
        let enter = if is_ahead(enter) { enter } else { from };
        let stretch = [enter.max(from), leave.min(to)];
        (is_ahead(leave) && stretch[1] > stretch[0]).then_some(stretch)
    }

    /// Returns the light's strength at a distance. Behind a parallel light the distance is negative, and an odd
    /// exponent brightens and darkens there (quirk: `parallel_light_behind`).
    #[inline]
    pub fn strength_at(&self, distance: f64) -> Rgb {
        match self.fade {
            // 2 / (1 + (d/d₀)ᵏ)
            Some((from, power)) => {
                let share = 2.0 / (1.0 + fp::power(distance / from, power));
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
        assert_eq!((arriving.to_light, arriving.distance), (DVec3::NEG_Z, 4.0));
        assert!((arriving.light.x - 0.4).abs() < 1e-15);
        let behind = lamp.sample(DVec3::new(5.0, 0.0, -8.0), DVec3::ZERO);
        assert_eq!((behind.to_light, behind.distance), (DVec3::NEG_Z, -4.0));
    }

    #[test]
    fn round_light_comes_from_its_place() {
        let light = Light { location: DVec3::Y * 3.0, color: Rgb::ONE, ..Light::default() };
        let arriving = LoweredLight::new(&light).sample(DVec3::X * 4.0, DVec3::ZERO);
        assert_eq!((arriving.to_light, arriving.distance), (DVec3::new(-0.8, 0.6, 0.0), 5.0));
    }
}
