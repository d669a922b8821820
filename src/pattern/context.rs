//! What a pattern is asked about.

use super::{Modifiers, Near, Turbulent, Wave};
use crate::color::Color;
use crate::math::noise::NoiseGenerator;
use crate::math::{DVec2, DVec3};

/// A point, and what patterns want to know beside it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TextureContext {
    /// The point, in the space of who is asked.
    pub p: DVec3,
    /// Where it lies on its shape.
    pub uv: DVec2,
    /// The same place in world space.
    pub world: DVec3,
    /// The surface's normal in world space, turned towards the eye, length 1. Pigments see that of their texture's `normal { }`, which
    /// `no_bump_scale` leaves as long as the bumps make it (measured on POV-Ray 3.7). Zero where there is no surface: in the sky, in a
    /// function.
    pub normal: DVec3,
    /// The direction of the ray that sees it, in world space; length 1.
    pub ray: DVec3,
    /// The noise of patterns that do not say which.
    pub noise: NoiseGenerator,
    /// `number_of_waves`: how many sources `ripples` and `waves` have.
    pub waves: usize,
}

impl TextureContext {
    /// How many sources waves have, unless the scene says.
    pub const WAVES: usize = 10;

    /// A point that lies on nothing: what functions ask about. They do not know the scene's number of waves, as in POV-Ray.
    pub fn free(p: DVec3, noise: NoiseGenerator) -> Self {
        Self {
            p,
            uv: DVec2::new(p.x, p.y),
            world: p,
            normal: DVec3::ZERO,
            ray: DVec3::NEG_Y,
            noise,
            waves: Self::WAVES,
        }
    }

    /// Does it lie on a surface? Without one, patterns that ask how it is turned are 0 (measured on POV-Ray 3.7).
    pub fn has_surface(&self) -> bool {
        self.normal != DVec3::ZERO
    }

    /// The same place seen from another space.
    pub fn at(&self, p: DVec3) -> Self {
        Self { p, ..*self }
    }
}

/// What else is said of a pattern.
#[derive(Clone, Copy, Debug)]
pub struct Words<'a> {
    /// Frequency, phase, wave.
    pub modifiers: &'a Modifiers,
    /// `turbulence` and its words.
    pub turbulence: &'a Turbulent,
}

impl Words<'_> {
    /// Nothing is said.
    pub const NONE: Self = Self { modifiers: &Modifiers::NONE, turbulence: &Turbulent::STILL };
}

/// The colours of most patterns without a map.
pub(super) const GRAYS: [(f64, Color); 2] = [(0.0, Color::BLACK), (1.0, Color::WHITE)];

/// A pattern that gives every point a number, which a map turns into colour.
pub trait Field {
    /// The number before frequency, phase and wave; mostly in [0, 1].
    fn value(&self, at: &TextureContext) -> f64;

    /// The number of a pattern that listens to what else is said of it.
    fn value_as(&self, at: &TextureContext, _words: &Words) -> f64 {
        self.value(at)
    }

    /// What is known of the numbers no farther away than a radius, before frequency, phase and wave.
    fn near(&self, _at: &TextureContext, _words: &Words, _radius: f64) -> Near {
        Near::UNKNOWN
    }

    /// Does it use `turbulence` in its own way? Of all others the point is displaced.
    fn stirs(&self) -> bool {
        false
    }

    /// The normal `n` with bumps of the pattern's own making, all in the pattern's space; `None` if they are found by
    /// comparing heights.
    fn bumped(&self, _at: &TextureContext, _words: &Words, _n: DVec3, _amount: f64) -> Option<DVec3> {
        None
    }

    /// The wave that its name brings along.
    fn default_wave(&self) -> Option<Wave> {
        None
    }

    /// Does its name set the frequency to 0, so that `phase` counts for nothing until a `frequency` is said (measured on 3.7)?
    fn begins_still(&self) -> bool {
        false
    }

    /// The colours it shows without a map.
    fn default_colors(&self) -> Vec<(f64, Color)> {
        GRAYS.to_vec()
    }
}
