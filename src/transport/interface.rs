//! Optical boundaries between interiors: indices of refraction, Snell's law, Fresnel's equations.

use crate::math::DVec3;
use crate::medium::Interior;
use smallvec::SmallVec;
use std::sync::Arc;

/// Numbers of the interiors that contain a ray's origin; the last entered is on top.
pub(super) type Interiors = SmallVec<[u32; 6]>;

/// Returns a copy of a ray's list of interiors; faster than `clone`, which copies number by number.
#[inline]
pub(super) fn copy_interiors(interiors: &Interiors) -> Interiors {
    match interiors.as_slice() {
        [] => Interiors::new(),
        numbers => Interiors::from_slice(numbers),
    }
}

/// Optical boundary where a ray hits a surface: the indices of refraction on both sides, and whether the ray leaves an
/// interior.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Interface {
    /// Index of refraction on the ray's side.
    pub n1: f64,
    /// Index of refraction beyond the surface.
    pub n2: f64,
    /// Indices (n1, n2) in Fresnel's equations; inside several interiors, they differ from those of refraction.
    mirror: (f64, f64),
    /// Index, in the ray's list of interiors, of the interior that the ray leaves at the surface; `None` if the ray
    /// enters an interior.
    leaves: Option<usize>,
}

impl Interface {
    /// Boundary without effect: one medium on both sides.
    pub const NONE: Interface = Interface { n1: 1.0, n2: 1.0, mirror: (1.0, 1.0), leaves: None };

    /// Creates the boundary of the interior `own_interior` for a ray inside the interiors `inside`. The ray leaves
    /// `own_interior` if the list contains it, and enters it otherwise.
    pub fn new(inside: &Interiors, own_interior: u32, interiors: &[Arc<Interior>]) -> Self {
        let ior = |i: Option<&u32>| i.and_then(|&i| interiors.get(i as usize)).map_or(1.0, |interior| interior.ior);
        let (n1, own_ior) = (ior(inside.last()), ior(Some(&own_interior)));
        let Some(at) = inside.iter().rposition(|&i| i == own_interior) else {
            return Self { n1, n2: own_ior, mirror: (n1, own_ior), leaves: None };
        };
        let n2 = ior(inside.iter().enumerate().rev().find(|(i, _)| *i != at).map(|(_, i)| i));
        // quirk: fresnel_of_last_entered
        let beyond = if inside.len() == 1 { 1.0 } else { n1 };
        Self { n1, n2, mirror: (own_ior, beyond), leaves: Some(at) }
    }

    /// Returns the boundary for light of one hue, from 0 for red to 1 for violet (see [`Interior::ior_of_hue`]). Its
    /// reflectance stays that of white light (quirk: `dispersion_ior`).
    pub fn of_hue(
        self,
        red_to_violet: f64,
        inside: &Interiors,
        own_interior: u32,
        interiors: &[Arc<Interior>],
    ) -> Self {
        let ior =
            |i: Option<u32>| i.and_then(|i| interiors.get(i as usize)).map_or(1.0, |i| i.ior_of_hue(red_to_violet));
        Self { n1: ior(inside.last().copied()), n2: ior(self.interior_beyond(inside, own_interior)), ..self }
    }

    /// Returns the number of colours into which white light splits at the boundary, as the interior beyond it states
    /// (quirk: `dispersion_samples_beyond`); `None` if both sides have the same dispersion.
    pub fn dispersion_samples(
        &self,
        inside: &Interiors,
        own_interior: u32,
        interiors: &[Arc<Interior>],
    ) -> Option<u32> {
        let interior = |i: Option<u32>| i.and_then(|i| interiors.get(i as usize));
        let dispersion = |interior: Option<&Arc<Interior>>| interior.map_or(1.0, |interior| interior.dispersion);
        let (before, beyond) = (interior(inside.last().copied()), interior(self.interior_beyond(inside, own_interior)));
        let samples = || beyond.or(interior(Some(own_interior))).map_or(0, |interior| interior.dispersion_samples);
        (dispersion(before) != dispersion(beyond)).then(samples)
    }

    /// Returns the number of the interior on top of the ray's list after the ray has crossed the boundary of `own_interior`;
    /// `None` if the list is then empty.
    fn interior_beyond(&self, inside: &Interiors, own_interior: u32) -> Option<u32> {
        match self.leaves {
            Some(at) => inside.iter().enumerate().rev().find(|(i, _)| *i != at).map(|(_, &i)| i),
            None => Some(own_interior),
        }
    }

    /// True if the ray leaves an interior at the boundary.
    pub fn leaves_interior(&self) -> bool {
        self.leaves.is_some()
    }

    /// True if the boundary refracts a ray.
    pub fn refracts(&self) -> bool {
        self.n1 != self.n2
    }

    /// Updates the list `inside` of a ray that crosses the boundary of the interior `own_interior`.
    pub fn update_crossed_interiors(&self, inside: &mut Interiors, own_interior: u32) {
        match self.leaves {
            Some(at) => drop(inside.remove(at)),
            None => inside.push(own_interior),
        }
    }

    /// Returns the reflectance of a dielectric for unpolarised light (Fresnel's equations). `cos` is the cosine of the
    /// angle between ray and normal. Bumps that are seen from behind (`cos` < 0) reflect all light (quirk:
    /// `bumps_from_behind`).
    pub fn fresnel(&self, cos: f64) -> f64 {
        let (n1, n2) = self.mirror;
        if cos < 0.0 {
            return 1.0;
        }
        if n1 == n2 {
            return 0.0;
        }
        // Snell: sin²θ₂ = (n₁/n₂)²·sin²θ₁
        let sin2 = (n1 / n2).powi(2) * (1.0 - cos * cos);
        if sin2 >= 1.0 {
            return 1.0;
        }
        let cos2 = (1.0 - sin2).sqrt();
        let perpendicular = (n1 * cos - n2 * cos2) / (n1 * cos + n2 * cos2);
        let parallel = (n1 * cos2 - n2 * cos) / (n1 * cos2 + n2 * cos);
        (perpendicular * perpendicular + parallel * parallel) / 2.0
    }

    /// Returns the direction beyond the boundary by Snell's law, length 1; `None` for total internal reflection. The
    /// side of `normal` does not matter (quirk: `bumps_from_behind`).
    pub fn refract(&self, dir: DVec3, normal: DVec3) -> Option<DVec3> {
        if !self.refracts() {
            return Some(dir);
        }
        let eta = self.n1 / self.n2;
        let against = -dir.dot(normal);
        let (cos, normal) = (against.abs(), if against < 0.0 { -normal } else { normal });
        // cos²θ₂ = 1 - η²·(1 - cos²θ₁)
        let cos2 = 1.0 - eta * eta * (1.0 - cos * cos);
        (cos2 >= 0.0).then(|| (dir * eta + normal * (eta * cos - cos2.sqrt())).normalize())
    }
}

/// Returns the mirror direction d - 2(d·n)n, length 1.
pub(super) fn reflect(dir: DVec3, normal: DVec3) -> DVec3 {
    (dir - normal * (2.0 * dir.dot(normal))).normalize()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::fp;

    fn interface(n1: f64, n2: f64) -> Interface {
        Interface { n1, n2, mirror: (n1, n2), leaves: None }
    }

    #[test]
    fn snell() {
        let (sin, cos) = fp::sin_cos(30f64.to_radians());
        let out = interface(1.0, 1.5).refract(DVec3::new(sin, -cos, 0.0), DVec3::Y).unwrap();
        assert!((out.x - sin / 1.5).abs() < 1e-15 && out.y < 0.0);
        // past the critical angle asin(1/1.5) = 41.8°
        let (sin, cos) = fp::sin_cos(42f64.to_radians());
        assert_eq!(interface(1.5, 1.0).refract(DVec3::new(sin, -cos, 0.0), DVec3::Y), None);
    }

    #[test]
    fn fresnel_straight_on_and_at_brewsters_angle() {
        // ((n₁ - n₂)/(n₁ + n₂))²
        assert!((interface(1.0, 1.5).fresnel(1.0) - 0.04).abs() < 1e-15);
        assert!((interface(1.5, 1.0).fresnel(0.1) - 1.0).abs() < 1e-15);
        // At Brewster's angle, tan θ = n₂/n₁, only perpendicular light is reflected: ((n² - 1)/(n² + 1))²/2
        let cos = fp::cos(fp::atan(1.5f64));
        assert!((interface(1.0, 1.5).fresnel(cos) - (1.25f64 / 3.25).powi(2) / 2.0).abs() < 1e-15);
    }

    #[test]
    fn overlapping_glasses() {
        // A (1.5) and B (1.2) overlap: the ray enters A, enters B, leaves A, leaves B
        let iors = [1.5, 1.2].map(|ior| Arc::new(Interior { ior, ..Interior::default() }));
        let mut inside = Interiors::new();
        let mut seen = vec![];
        for own_interior in [0, 1, 0, 1] {
            let interface = Interface::new(&inside, own_interior, &iors);
            seen.push(((interface.n1, interface.n2), interface.mirror));
            interface.update_crossed_interiors(&mut inside, own_interior);
        }
        let both = |n1: f64, n2: f64| ((n1, n2), (n1, n2));
        assert_eq!(seen, [both(1.0, 1.5), both(1.5, 1.2), ((1.2, 1.2), (1.5, 1.2)), both(1.2, 1.0)]);
        assert!(inside.is_empty());
        // The ray leaves B, which is inside A
        let interface = Interface::new(&Interiors::from_slice(&[0, 1]), 1, &iors);
        assert_eq!(((interface.n1, interface.n2), interface.mirror), ((1.2, 1.5), (1.2, 1.2)));
    }
}
