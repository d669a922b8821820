//! Diffusion of light in a translucent half-space, by the dipole approximation of Jensen, Marschner, Levoy and Hanrahan,
//! A Practical Model for Subsurface Light Transport, SIGGRAPH 2001. Equation numbers are those of the paper.

use crate::math::fp;
use std::f64::consts::PI;

/// Number of bisections that find an albedo; each halves the error.
const BISECTIONS: u32 = 40;

/// The dipole of a material, for one channel.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Dipole {
    /// Reduced albedo α' of the material: the share of light that a change of direction does not absorb.
    pub albedo: f64,
    /// Depth of the real source below the surface, z_r, which is the mean free path 1/σ_t', in world units.
    pub depth: f64,
    /// Height of the virtual source above the surface, z_v, in world units.
    height: f64,
    /// Effective transport coefficient σ_tr, per world unit.
    transport: f64,
}

impl Dipole {
    /// Creates the dipole of a material that reflects the share `reflectance` of uniform light. `scattering_length` is
    /// 1/σ_s', in world units, and `mismatch` the value of [`boundary_mismatch`]. `None` for a material that sends no light
    /// back: the reflectance has to be more than 0 and at most 1, and the length positive and finite.
    pub fn new(reflectance: f64, scattering_length: f64, mismatch: f64) -> Option<Self> {
        let is_valid = reflectance > 0.0 && reflectance <= 1.0 && scattering_length > 0.0;
        if !is_valid || !scattering_length.is_finite() {
            return None;
        }
        let albedo = reduced_albedo_of_reflectance(reflectance, mismatch);
        // α' = σ_s'/σ_t', and σ_tr = √(3·σ_a·σ_t') = σ_t'·√(3·(1 - α'))
        let depth = albedo * scattering_length;
        let height = depth * (1.0 + 4.0 / 3.0 * mismatch);
        let transport = (3.0 * (1.0 - albedo)).sqrt() / depth;
        (depth > 0.0 && transport.is_finite()).then_some(Self { albedo, depth, height, transport })
    }

    /// Returns the diffuse reflectance R_d per unit of area, at the distance whose square is `distance_squared` from the
    /// point where light enters (equation 4).
    pub fn reflectance(&self, distance_squared: f64) -> f64 {
        let source = |z: f64| {
            let d = (distance_squared + z * z).sqrt();
            let reach = self.transport * d;
            z * (1.0 + reach) * fp::exp(-reach) / (d * d * d)
        };
        self.albedo / (4.0 * PI) * (source(self.depth) + source(self.height))
    }
}

/// Returns the reflectance of a half-space in uniform light, the integral of R_d over the plane, for the reduced albedo
/// α': α'/2·(1 + exp(-4/3·A·s))·exp(-s), where s = √(3·(1 - α')).
fn total_reflectance(albedo: f64, mismatch: f64) -> f64 {
    let s = (3.0 * (1.0 - albedo)).sqrt();
    0.5 * albedo * (1.0 + fp::exp(-4.0 / 3.0 * mismatch * s)) * fp::exp(-s)
}

/// Returns the reduced albedo of the half-space that reflects this share of uniform light.
fn reduced_albedo_of_reflectance(reflectance: f64, mismatch: f64) -> f64 {
    // The reflectance grows with the albedo.
    let (mut low, mut high) = (0.0, 1.0);
    for _ in 0..BISECTIONS {
        let middle = 0.5 * (low + high);
        if total_reflectance(middle, mismatch) < reflectance { low = middle } else { high = middle }
    }
    high
}

/// Returns A, the change of the boundary condition by internal reflection, for an index of refraction (quirk:
/// `subsurface_boundary`).
pub(super) fn boundary_mismatch(ior: f64) -> f64 {
    if ior < 1.0 {
        return 1.0 + 0.4957 * (1.0 - ior) * fp::pow(ior.max(0.0), 1.6);
    }
    let u = ior - 1.0;
    1.0 + u * (0.4957 + u * (0.0749 + u * 0.4568)) / (1.0 + u * (0.9051 + u * 0.8304))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn reflectance_integrates_to_the_total() {
        for (total, mismatch) in [(0.02, 1.0), (0.3, 1.2), (0.5, 1.8), (0.9, 1.2)] {
            let dipole = Dipole::new(total, 0.7, mismatch).unwrap();
            // ∫ R_d(r)·2πr dr with r = eᵗ, by the trapezoidal rule
            let step = 0.01;
            let ring = |t: f64| {
                let r = fp::exp(t);
                dipole.reflectance(r * r) * 2.0 * PI * r * r
            };
            let sum: f64 = (-1500..1500).map(|i| ring(f64::from(i) * step)).sum::<f64>() * step;
            assert!((sum - total).abs() < 1e-4 * total, "{total}: {sum}");
        }
    }

    #[test]
    fn white_material_absorbs_nothing() {
        let dipole = Dipole::new(1.0, 2.0, 1.5).unwrap();
        assert!((dipole.albedo - 1.0).abs() < 1e-9 && (dipole.depth - 2.0).abs() < 1e-8);
        // R_d(0) = (1/z_r² + 1/z_v²)/4π, where z_v = 3·z_r
        let expected = (0.25 + 0.25 / 9.0) / (4.0 * PI);
        assert!((dipole.reflectance(0.0) - expected).abs() < 1e-6);
    }

    #[test]
    fn reflectance_scales_with_the_length() {
        let [one, ten] = [1.0, 10.0].map(|length| Dipole::new(0.4, length, 1.2).unwrap());
        assert!((one.reflectance(0.09) - 100.0 * ten.reflectance(9.0)).abs() < 1e-9);
    }

    #[test]
    fn no_dipole_without_light_or_length() {
        for (reflectance, length) in [(0.0, 1.0), (1.1, 1.0), (-0.5, 1.0), (f64::NAN, 1.0), (0.5, 0.0), (0.5, -1.0)] {
            assert_eq!(Dipole::new(reflectance, length, 1.0), None);
        }
        assert_eq!(Dipole::new(0.5, f64::INFINITY, 1.0), None);
    }

    #[test]
    fn mismatch_of_common_materials() {
        // POV-Ray 3.7, from the light that single scattering adds to a half-space
        for (ior, a) in [(0.8, 1.0719), (1.0, 1.0), (1.2, 1.0875), (1.5, 1.1946), (2.0, 1.3757), (5.0, 2.8078)] {
            assert!((boundary_mismatch(ior) - a).abs() < 0.003, "{ior}: {}", boundary_mismatch(ior));
        }
    }
}
