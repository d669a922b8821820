//! The point at which a pattern is evaluated, and the parameters that patterns share.

use super::{LocalBounds, Modifiers, Support, TurbulenceParams, Wave};
use crate::color::Color;
use crate::math::noise::NoiseGenerator;
use crate::math::{DVec2, DVec3};

/// A point at which a texture is evaluated, with the properties of its surface and ray that patterns depend on.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TextureContext {
    /// The point at which a texture is evaluated, in the space of the texture.
    pub p: DVec3,
    /// Surface coordinates (u, v) of the point at which a texture is evaluated.
    pub uv: DVec2,
    /// The point at which a texture is evaluated, in world space.
    pub world: DVec3,
    /// Surface normal in world space, on the viewer's side, length 1 (quirk: `pigments_see_bumped_normal`). Zero
    /// without a surface: in the sky, in a function.
    pub normal: DVec3,
    /// Direction of the ray that hits the point, in world space; length 1.
    pub ray: DVec3,
    /// Noise generator of patterns without `noise_generator`.
    pub noise: NoiseGenerator,
    /// Number of sources of the patterns `ripples` and `waves`, from `number_of_waves`.
    pub waves: usize,
}

impl TextureContext {
    /// Default number of wave sources of the patterns `ripples` and `waves`.
    pub const WAVES: usize = 10;

    /// Creates the context of a point without a surface, as functions evaluate patterns. Functions ignore the scene's
    /// `number_of_waves`, as in POV-Ray.
    pub fn without_surface(p: DVec3, noise: NoiseGenerator) -> Self {
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

    /// True if the point is on a surface. Without one, patterns of the surface's direction are 0 (quirk:
    /// `slope_without_surface`).
    pub fn is_on_surface(&self) -> bool {
        self.normal != DVec3::ZERO
    }

    /// Returns this texture context for the point's coordinates in another space.
    pub fn with_point(&self, p: DVec3) -> Self {
        Self { p, ..*self }
    }
}

/// Parameters that all patterns of numbers share.
#[derive(Clone, Copy, Debug)]
pub struct FieldParams<'a> {
    /// Frequency, phase and wave type of a pattern.
    pub modifiers: &'a Modifiers,
    /// Parameters of the pattern's `turbulence`.
    pub turbulence: &'a TurbulenceParams,
    /// End of the start of the map in which its value is constant. In place of a number below it, a pattern may return
    /// any other that is below it and not negative.
    pub constant_below: f64,
}

impl FieldParams<'_> {
    /// Parameters of a pattern without modifiers and turbulence.
    pub const NONE: Self =
        Self { modifiers: &Modifiers::NONE, turbulence: &TurbulenceParams::STILL, constant_below: 0.0 };
}

/// Colours of most patterns without a colour map: black to white.
pub(super) const GRAYS: [(f64, Color); 2] = [(0.0, Color::BLACK), (1.0, Color::WHITE)];

/// A pattern that assigns a number to every point; a map turns the number into a colour.
pub trait Field {
    /// Returns the pattern's number at a point, before frequency, phase and wave; in [0, 1] for most patterns.
    fn value(&self, at: &TextureContext) -> f64;

    /// Returns the pattern's number at a point, as [`Field::value`], for a pattern whose number also depends on the
    /// parameters that all patterns share.
    fn value_with_params(&self, at: &TextureContext, _params: &FieldParams) -> f64 {
        self.value(at)
    }

    /// Returns [`Field::value_with_params`] at four points: a pattern whose number takes a long chain of operations
    /// computes them side by side.
    fn values_with_params(&self, at: &[TextureContext; 4], params: &FieldParams) -> [f64; 4] {
        at.each_ref().map(|at| self.value_with_params(at, params))
    }

    /// True if the pattern's number takes a long chain of operations, so that [`Field::values_with_params`] takes little more time than
    /// one number.
    fn takes_long_chain(&self) -> bool {
        false
    }

    /// Returns bounds on the pattern's numbers within a radius of the point, before frequency, phase and wave.
    fn value_bounds_near(&self, _at: &TextureContext, _params: &FieldParams, _radius: f64) -> LocalBounds {
        LocalBounds::UNKNOWN
    }

    /// Returns a region about the origin, a ball, cube, infinite cylinder or slab, outside of which the pattern's number
    /// is 0, before frequency, phase and wave.
    fn support(&self) -> Option<Support> {
        None
    }

    /// True if the pattern uses `turbulence` in its own way; for all others the point is displaced.
    fn handles_turbulence_itself(&self) -> bool {
        false
    }

    /// Returns the normal `n` with bumps that the pattern computes itself, all in the pattern's space; `None` if bumps
    /// are found by comparing heights.
    fn bumped_normal(&self, _at: &TextureContext, _params: &FieldParams, _n: DVec3, _amount: f64) -> Option<DVec3> {
        None
    }

    /// Wave type that the pattern's name sets; `None` if the name leaves the wave type unchanged.
    fn default_wave(&self) -> Option<Wave> {
        None
    }

    /// True if the pattern's name sets the frequency to 0, so that `phase` has no effect until a `frequency` is given
    /// (quirk: `still_patterns`).
    fn starts_with_zero_frequency(&self) -> bool {
        false
    }

    /// Colours of the pattern without a colour map.
    fn default_colors(&self) -> Vec<(f64, Color)> {
        GRAYS.to_vec()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::pattern::{Agate, FieldPattern, Wood, extreme_points};

    #[test]
    fn four_points_have_the_bits_of_single_points() {
        let spread = [DVec3::ZERO, DVec3::X, -0.3 * DVec3::Y, 1e-3 * DVec3::ONE];
        let usual =
            (0..300).map(|i| DVec3::new(f64::from(i) * 0.37 - 50.0, f64::from(i % 17), f64::from(i % 5) * 0.21));
        for p in usual.chain(extreme_points()) {
            let at = spread.map(|offset| TextureContext::without_surface(p + offset, Default::default()));
            for amount in [DVec3::ZERO, DVec3::new(0.05, 0.3, 2.0)] {
                let turbulence = TurbulenceParams { amount, ..TurbulenceParams::default() };
                let params = FieldParams { turbulence: &turbulence, ..FieldParams::NONE };
                for field in [FieldPattern::from(Wood {}), Agate { turbulence: 0.7 }.into()] {
                    let single = at.each_ref().map(|at| field.value_with_params(at, &params));
                    let four = field.values_with_params(&at, &params);
                    let is_same =
                        |i: usize| four[i].to_bits() == single[i].to_bits() || single[i].is_nan() && four[i].is_nan();
                    assert!((0..4).all(is_same), "{field:?} at {p}: {four:?} {single:?}");
                }
            }
        }
    }
}
