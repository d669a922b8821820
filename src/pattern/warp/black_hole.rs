//! `warp { black_hole <centre>, radius }`: pulls the pattern towards a point, or pushes it away (manual, "Black Hole Warp").
//!
//! ```pov
//! box { <-1, -1, 0>, 1 pigment { gradient x scale 0.2 warp { black_hole <0.1, 0, 0>, 0.8 falloff 1 strength 0.9 inverse } } }
//! ```

use super::Bend;
use crate::diagnostic::Result;
use crate::math::noise::Cell;
use crate::math::{DVec3, fp};
use crate::value::words::{Row, set, specs, word};
use crate::value::{Param, Readable, Reader, Spec, ValueKind};
use serde::Serialize;

/// Warp `black_hole`: moves points within a sphere along its radii.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct BlackHole {
    /// Centre of the black hole's sphere; with `repeat` that of the block at the origin.
    pub center: DVec3,
    /// Radius of the black hole's sphere.
    pub radius: f64,
    /// Strength of the black hole's pull near the centre.
    pub strength: f64,
    /// Exponent with which the black hole's pull grows from the surface to the centre.
    pub falloff: f64,
    /// True if the black hole pushes the pattern away.
    pub inverse: bool,
    /// Size of the blocks that have a black hole each; no repetition along an axis where the size is 0 or less.
    pub repeat: DVec3,
    /// Maximum random displacement of each black hole's centre along each axis; none without `repeat`.
    pub turbulence: DVec3,
}

impl Readable for BlackHole {
    const SPEC: Spec = Spec {
        name: "black_hole",
        summary: "pulls the pattern towards a point",
        params: &[
            Param { name: "center", kind: ValueKind::Vector, summary: "where to" },
            Param { name: "radius", kind: ValueKind::Float, summary: "how far it reaches" },
        ],
        words: specs!(Self::WORDS),
        ..Spec::EMPTY
    };

    const WORDS: &'static [Row<Self>] = &[
        word("strength", ValueKind::Float, "1", "how strong it pulls").sets(|s, r| set(&mut s.strength, r.float())),
        word("falloff", ValueKind::Float, "2", "to which power the pull grows from the edge to the centre")
            .sets(|s, r| set(&mut s.falloff, r.float())),
        word("inverse", ValueKind::Nothing, "", "pushes instead of pulling").sets(|s, _| set(&mut s.inverse, Ok(true))),
        word(
            "repeat",
            ValueKind::Vector,
            "0",
            "one in each block of this size; 0 for an axis along which they don't repeat",
        )
        .sets(|s, r| set(&mut s.repeat, r.vector())),
        word("turbulence", ValueKind::Vector, "0", "how far the centre is moved at random in each block")
            .sets(|s, r| set(&mut s.turbulence, r.vector())),
        word("type", ValueKind::Float, "0", "accepted for compatibility with POV-Ray, without effect")
            .sets(|_, r| r.float().map(drop)),
    ];

    fn read(r: &mut dyn Reader) -> Result<Self> {
        let (center, radius) = (r.vector()?, r.float()?);
        let (repeat, turbulence) = (DVec3::ZERO, DVec3::ZERO);
        Ok(Self { center, radius, strength: 1.0, falloff: 2.0, inverse: false, repeat, turbulence })
    }
}

impl BlackHole {
    /// Returns the centre of the black hole that may contain the point.
    fn nearest_hole_center(&self, p: DVec3) -> DVec3 {
        if self.repeat == DVec3::ZERO {
            return self.center;
        }
        // The hole must be within its block: shift the centre and widen the block if need be.
        let repeats = self.repeat.cmpgt(DVec3::ZERO);
        let center = DVec3::select(repeats, self.center.max(DVec3::splat(self.radius)), self.center);
        let size = self.repeat.max(center + self.radius + self.turbulence.max(DVec3::ZERO));
        let block = DVec3::select(repeats, (p / size).floor(), DVec3::ZERO);
        // Random numbers of unit cubes: each block has those of the cube with its number (quirk:
        // black_hole_random_cells).
        let random = Cell::cell_and_position(block).0.random_offset_in_cell();
        block * size + center + self.turbulence * random
    }
}

impl Bend for BlackHole {
    fn apply(&self, p: DVec3) -> DVec3 {
        let out = p - self.nearest_hole_center(p);
        let distance = out.length();
        if distance >= self.radius {
            return p;
        }
        // from 0 on the surface to 1 at the centre
        let closeness = (self.radius - distance) / self.radius;
        // A pattern is pulled inwards where the point is moved outwards, at most to twice its distance.
        let pull = (self.strength * fp::pow(closeness, self.falloff)).min(1.0);
        if self.inverse { p - pull * out } else { p + pull * out }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const HOLE: BlackHole = BlackHole {
        center: DVec3::ONE,
        radius: 1.0,
        strength: 1.0,
        falloff: 2.0,
        inverse: false,
        repeat: DVec3::ZERO,
        turbulence: DVec3::ZERO,
    };

    #[test]
    fn the_pull_is_the_square_of_closeness() {
        let p = DVec3::new(1.5, 1.0, 1.0);
        assert_eq!(HOLE.apply(p).x, 1.5 + 0.25 * 0.5);
        assert_eq!(BlackHole { inverse: true, ..HOLE }.apply(p).x, 1.5 - 0.25 * 0.5);
        assert_eq!(BlackHole { strength: 100.0, ..HOLE }.apply(p).x, 2.0);
        assert_eq!(HOLE.apply(DVec3::ZERO), DVec3::ZERO);
    }

    #[test]
    fn blocks_have_a_hole_each() {
        let holes = BlackHole { repeat: DVec3::X * 3.0, ..HOLE };
        assert_eq!(holes.apply(DVec3::new(-1.5, 1.0, 1.0)).x, -1.5 + 0.25 * 0.5);
    }

    #[test]
    fn turbulence_moves_each_hole_along_its_axes() {
        let holes = BlackHole { repeat: DVec3::X * 9.0, turbulence: DVec3::new(2.0, 0.0, -1.0), ..HOLE };
        let [first, second] = [0.0, 9.0].map(|x| holes.nearest_hole_center(DVec3::X * x) - DVec3::X * x - HOLE.center);
        for moved in [first, second] {
            assert!(moved.x > 0.0 && moved.x < 2.0 && moved.y == 0.0 && moved.z > -1.0 && moved.z < 0.0, "{moved}");
        }
        assert_ne!(first, second);
        assert_eq!(BlackHole { repeat: DVec3::ZERO, ..holes }.nearest_hole_center(DVec3::ZERO), HOLE.center);
    }
}
