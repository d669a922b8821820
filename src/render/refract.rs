//! Borders between what fills the objects: indices of refraction, Snell's law, Fresnel's formula.

use crate::math::DVec3;
use crate::texture::Interior;
use smallvec::SmallVec;
use std::sync::Arc;

/// The interiors that a ray is in, the last entered on top.
pub(super) type Interiors = SmallVec<[u32; 6]>;

/// The same interiors; mostly there are none, which is quicker told than copied.
pub(super) fn copied(interiors: &Interiors) -> Interiors {
    if interiors.is_empty() { Interiors::new() } else { interiors.clone() }
}

/// What lies on both sides of a surface that a ray meets.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Interface {
    /// Index of refraction on the ray's side.
    pub n1: f64,
    /// Index of refraction behind the surface.
    pub n2: f64,
    /// Both as Fresnel's formula takes them, which differ where more than one thing is left.
    mirror: (f64, f64),
    /// The place in the stack of what the ray leaves; `None` if it enters something.
    leaves: Option<usize>,
}

impl Interface {
    /// The same on both sides.
    pub const NONE: Interface = Interface { n1: 1.0, n2: 1.0, mirror: (1.0, 1.0), leaves: None };

    /// The border of interior `own` for a ray in `inside`: a ray that is in it leaves it, any other enters it.
    pub fn new(inside: &Interiors, own: u32, interiors: &[Arc<Interior>]) -> Self {
        let ior = |i: Option<&u32>| i.and_then(|&i| interiors.get(i as usize)).map_or(1.0, |interior| interior.ior);
        let (n1, own_ior) = (ior(inside.last()), ior(Some(&own)));
        let Some(at) = inside.iter().rposition(|&i| i == own) else {
            return Self { n1, n2: own_ior, mirror: (n1, own_ior), leaves: None };
        };
        let n2 = ior(inside.iter().enumerate().rev().find(|(i, _)| *i != at).map(|(_, i)| i));
        // For its mirror the ray comes from what it leaves, and goes to what it entered last, even if that is the same
        // (measured on 3.7: glass in glass mirrors nothing on its far side).
        let behind = if inside.len() == 1 { 1.0 } else { n1 };
        Self { n1, n2, mirror: (own_ior, behind), leaves: Some(at) }
    }

    /// The same border for one hue (see [`Interior::ior_of`]); what it mirrors stays that of white light (measured on 3.7).
    pub fn of_hue(self, hue: f64, inside: &Interiors, own: u32, interiors: &[Arc<Interior>]) -> Self {
        let ior = |i: Option<u32>| i.and_then(|i| interiors.get(i as usize)).map_or(1.0, |i| i.ior_of(hue));
        Self { n1: ior(inside.last().copied()), n2: ior(self.behind(inside, own)), ..self }
    }

    /// Into how many colours white light splits here: where both sides spread it in the same way it stays white. What lies
    /// behind the border says the number (both measured on 3.7).
    pub fn samples(&self, inside: &Interiors, own: u32, interiors: &[Arc<Interior>]) -> Option<u32> {
        let interior = |i: Option<u32>| i.and_then(|i| interiors.get(i as usize));
        let spread = |interior: Option<&Arc<Interior>>| interior.map_or(1.0, |interior| interior.dispersion);
        let (before, behind) = (interior(inside.last().copied()), interior(self.behind(inside, own)));
        let samples = || behind.or(interior(Some(own))).map_or(0, |interior| interior.dispersion_samples);
        (spread(before) != spread(behind)).then(samples)
    }

    /// What a ray is in behind the border of `own`.
    fn behind(&self, inside: &Interiors, own: u32) -> Option<u32> {
        match self.leaves {
            Some(at) => inside.iter().enumerate().rev().find(|(i, _)| *i != at).map(|(_, &i)| i),
            None => Some(own),
        }
    }

    /// Does the ray leave what it meets?
    pub fn leaves(&self) -> bool {
        self.leaves.is_some()
    }

    /// Is a ray bent here?
    pub fn bends(&self) -> bool {
        self.n1 != self.n2
    }

    /// Takes a ray across the border of `own`.
    pub fn cross(&self, inside: &mut Interiors, own: u32) {
        match self.leaves {
            Some(at) => drop(inside.remove(at)),
            None => inside.push(own),
        }
    }

    /// The part of unpolarised light that a dielectric mirrors (Fresnel's formula); `cos` is that of the angle between
    /// ray and normal; bumps that are seen from behind mirror all of it (measured on 3.7).
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
        let across = (n1 * cos - n2 * cos2) / (n1 * cos + n2 * cos2);
        let along = (n1 * cos2 - n2 * cos) / (n1 * cos2 + n2 * cos);
        (across * across + along * along) / 2.0
    }

    /// The direction behind the border, by Snell's law; `None` if all is reflected. `normal` points to the ray's side, or where
    /// bumps are seen from behind away from it, which is the same (measured on 3.7).
    pub fn refract(&self, dir: DVec3, normal: DVec3) -> Option<DVec3> {
        if !self.bends() {
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

/// The mirrored direction: d - 2(d·n)n.
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
        // at Brewster's angle, tan θ = n₂/n₁, only the part across is mirrored: ((n² - 1)/(n² + 1))²/2
        let cos = fp::cos(fp::atan(1.5f64));
        assert!((interface(1.0, 1.5).fresnel(cos) - (1.25f64 / 3.25).powi(2) / 2.0).abs() < 1e-15);
    }

    #[test]
    fn overlapping_glasses() {
        // A 1.5 and B 1.2 overlap: in A, in both, in B, out
        let iors = [1.5, 1.2].map(|ior| Arc::new(Interior { ior, ..Interior::default() }));
        let mut inside = Interiors::new();
        let mut seen = vec![];
        for own in [0, 1, 0, 1] {
            let interface = Interface::new(&inside, own, &iors);
            seen.push(((interface.n1, interface.n2), interface.mirror));
            interface.cross(&mut inside, own);
        }
        let both = |n1: f64, n2: f64| ((n1, n2), (n1, n2));
        assert_eq!(seen, [both(1.0, 1.5), both(1.5, 1.2), ((1.2, 1.2), (1.5, 1.2)), both(1.2, 1.0)]);
        assert!(inside.is_empty());
        // out of B, which lies in A
        let interface = Interface::new(&Interiors::from_slice(&[0, 1]), 1, &iors);
        assert_eq!(((interface.n1, interface.n2), interface.mirror), ((1.2, 1.5), (1.2, 1.2)));
    }
}
