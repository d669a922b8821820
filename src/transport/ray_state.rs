//! State of a ray that is traced through the scene.

use super::interface::{Interiors, copy_interiors};
use crate::atmosphere::Segment;
use crate::color::{Rgb, gray};
use crate::math::Ray;

/// Number of surfaces after which a ray is dropped: guards against rounding that keeps a ray in one place.
pub(super) const MAX_SURFACES: u32 = 20_000;

/// A ray that is still to be traced, and its share of the camera ray's radiance.
#[derive(Debug)]
pub(super) struct RayState {
    pub ray: Ray,
    /// Depth of the ray tree: 1 for a camera ray, one more for each reflection and each refraction.
    pub level: u32,
    /// Importance that is compared with `adc_bailout`; 1 for a camera ray.
    pub weight: f64,
    /// Factor of the ray's radiance in the result.
    pub throughput: Rgb,
    /// Factor of the transparency that the ray contributes to the alpha channel; 0 after a reflection.
    pub transparency: f64,
    /// True if the ray was reflected.
    pub is_reflected: bool,
    /// True if the ray was transmitted by a surface.
    pub has_transmitted: bool,
    /// Interiors that contain the ray; the last entered is on top.
    pub inside: Interiors,
    /// Hue of the ray after dispersion, from 0 for red to 1 for violet; `None` for white light.
    pub hue: Option<f64>,
    /// Number of diffuse bounces between the camera and the ray; 0 unless the ray gathers light for radiosity.
    pub bounces: u8,
    /// Rank of the ray among those that gather light for its origin, from 0 to 1; `None` for other rays.
    pub gather_rank: Option<f64>,
    /// Number of surfaces that the ray and its ancestors have hit.
    pub n_surfaces: u32,
}

impl RayState {
    /// Creates the state of a camera ray.
    #[inline]
    pub fn camera(ray: Ray, inside: Interiors) -> Self {
        Self {
            ray,
            level: 1,
            weight: 1.0,
            throughput: Rgb::ONE,
            transparency: 1.0,
            is_reflected: false,
            has_transmitted: false,
            inside,
            hue: None,
            bounces: 0,
            gather_rank: None,
            n_surfaces: 0,
        }
    }

    /// Multiplies throughput and transparency by the transmittance of a segment.
    #[inline]
    pub fn attenuate(&mut self, segment: &Segment) {
        self.throughput *= segment.transmittance;
        self.transparency *= gray(segment.transmittance);
    }

    /// Returns the state of a ray that continues along `ray` from a surface, with the share `share` of the light. Level
    /// and weight stay those of this ray, and the transparency is 0; the caller changes them.
    #[inline]
    pub fn continued(&self, ray: Ray, share: Rgb) -> Self {
        Self {
            ray,
            level: self.level,
            weight: self.weight,
            throughput: self.throughput * share,
            transparency: 0.0,
            is_reflected: self.is_reflected,
            has_transmitted: self.has_transmitted,
            inside: copy_interiors(&self.inside),
            hue: self.hue,
            bounces: self.bounces,
            gather_rank: None,
            n_surfaces: self.n_surfaces + 1,
        }
    }
}
