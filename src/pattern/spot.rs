//! What a pattern is asked about.

use super::Turbulent;
use crate::color::Color;
use crate::math::noise::NoiseGenerator;
use crate::math::{DVec2, DVec3};

/// A point, and what patterns want to know beside it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Spot {
    /// The point, in the space of who is asked.
    pub p: DVec3,
    /// Where it lies on its shape.
    pub uv: DVec2,
    /// The same place in world space.
    pub world: DVec3,
    /// The surface's normal in world space, turned towards the eye, length 1. Pigments see that of their texture's `normal { }`.
    pub normal: DVec3,
    /// The direction of the ray that sees it, in world space; length 1.
    pub ray: DVec3,
    /// The noise of patterns that do not say which.
    pub noise: NoiseGenerator,
}

impl Spot {
    /// A point that lies on nothing: what functions ask about.
    pub fn free(p: DVec3, noise: NoiseGenerator) -> Self {
        Self { p, uv: DVec2::new(p.x, p.y), world: p, normal: DVec3::Y, ray: DVec3::NEG_Y, noise }
    }

    /// The same place seen from another space.
    pub fn at(&self, p: DVec3) -> Self {
        Self { p, ..*self }
    }
}

/// A pattern that gives every point a number, which a map turns into colour.
pub trait Field {
    /// The number before frequency, phase and wave; mostly in [0, 1].
    fn value(&self, at: &Spot) -> f64;

    /// The number under `turbulence`, of a pattern that stirs itself; of all others the point is displaced.
    fn stirred(&self, _at: &Spot, _by: &Turbulent) -> Option<f64> {
        None
    }

    /// The colours it shows without a map.
    fn default_colors(&self) -> Vec<(f64, Color)> {
        vec![(0.0, Color::BLACK), (1.0, Color::WHITE)]
    }
}
