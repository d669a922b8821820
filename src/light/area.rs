//! `area_light axis, axis, N, M`: a row or grid of lights that makes soft shadows (manual, "Area Lights").

use super::{Light, read_finite};
use crate::diagnostic::{Diagnostic, Result, codes};
use crate::math::packet::{Numbers, Vectors};
use crate::math::{DVec3, Lanes};
use crate::value::Reader;
use crate::value::ValueKind::{Flag, Float, Nothing, Vector};
use crate::value::words::{Row, set, word};
use serde::Serialize;
use std::f64::consts::FRAC_1_SQRT_2;

/// Grid of an area light's point lights about its location.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Area {
    /// Vectors along the two sides of an area light's grid; their lengths are the sizes.
    pub axes: [DVec3; 2],
    /// Number of lights along each side of an area light's grid.
    pub size: [u32; 2],
    /// Number of halvings after which an area light's subdivision stops where the corners agree; `None` to use all
    /// lights.
    pub adaptive: Option<u32>,
    /// True if an area light's point lights are displaced at random.
    pub jitter: bool,
    /// True if an area light's grid is mapped to a disc.
    pub circular: bool,
    /// True if an area light's grid is turned towards the point that it illuminates.
    pub orient: bool,
    /// True if each point of an area light illuminates by itself; otherwise the grid only shapes the shadow.
    pub illumination: bool,
}

impl Default for Area {
    fn default() -> Self {
        Self {
            axes: [DVec3::X, DVec3::Y],
            size: [1; 2],
            adaptive: None,
            jitter: false,
            circular: false,
            orient: false,
            illumination: false,
        }
    }
}

/// Words of an area light, and how each is read.
pub(super) const AREA_ROWS: &[Row<Light>] = &[
    word(
        "area_light",
        Vector,
        "",
        "two sides and how many lights stand along each: `4*x, 4*z, 5, 5`; it casts soft shadows",
    )
    .sets(Light::read_area),
    word("adaptive", Float, "", "asks only corners where they agree, after so many halvings; 1 is mostly enough")
        .sets(|s, r| set(&mut s.area.adaptive, r.float().map(|level| Some(level.clamp(0.0, 64.0) as u32)))),
    word("jitter", Nothing, "", "moves the lights at random: grain in place of steps")
        .sets(|s, _| set(&mut s.area.jitter, Ok(true))),
    word("circular", Nothing, "", "bends the grid to a disc").sets(|s, _| set(&mut s.area.circular, Ok(true))),
    word("orient", Nothing, "", "turns it towards each place; its first side says how long both are")
        .sets(|s, _| set(&mut s.area.orient, Ok(true))),
    word("area_illumination", Flag, "off", "each light shines by itself; else the shadow alone is soft")
        .sets(|s, r| set(&mut s.area.illumination, r.flag())),
];

/// Maximum number of lights along a side of an area light's grid.
const MOST: f64 = 1e5;
/// Displacement of the lights of a circular area light, as a share of half a side (quirk: `circular_area_light`).
const BESIDE: f64 = 0.002;
/// Distance from the outermost lights to the sides of the hull of an area light, as a share of half a side.
const OUTWARDS: f64 = BESIDE + 1e-6;

impl Light {
    fn read_area(&mut self, r: &mut dyn Reader) -> Result<()> {
        let span = r.span();
        self.area.axes = [r.vector()?, r.vector()?];
        for n in &mut self.area.size {
            let at = r.span();
            let number = read_finite(r)?.trunc();
            if !(1.0..=MOST).contains(&number) {
                let message = format!("an `area_light` has 1 to {MOST} lights along a side, found {number}");
                return Err(Diagnostic::new(codes::BAD_ARGUMENT, at, message).help("5 is usual, 17 is smooth").into());
            }
            *n = number as u32;
        }
        if !self.area.axes.iter().all(|axis| axis.is_finite()) {
            return Diagnostic::err(codes::NOT_FINITE, span, "one of these numbers is infinite or not a number");
        }
        self.spreads = true;
        Ok(())
    }
}

impl Area {
    /// Returns the sides of the grid, as vectors; `direction_to_point` is the direction to the illuminated point,
    /// length 1.
    #[inline]
    pub fn sides(&self, direction_to_point: DVec3) -> [DVec3; 2] {
        if self.orient { self.grid_sides_facing(direction_to_point) } else { self.axes }
    }

    /// Returns the number of steps from the first to the last light along side `i` of the grid, and the place of light `cell` in
    /// steps: the only light of a row is in its middle.
    #[inline(always)]
    fn steps_and_place(&self, i: usize, cell: u32) -> (f64, f64) {
        let steps = f64::from(self.size[i].max(2) - 1);
        (steps, if self.size[i] == 1 { 0.5 * steps } else { f64::from(cell) })
    }

    /// Returns the vector from the area light's location to the light `cell` of its grid. `sides` are the sides of the grid, see
    /// [`Self::sides`]; `random` are two numbers in [0, 1) for jitter.
    #[inline]
    pub fn light_offset(&self, cell: [u32; 2], sides: &[DVec3; 2], random: Option<[f64; 2]>) -> DVec3 {
        let place = |i: usize| {
            let (steps, middle) = self.steps_and_place(i, cell[i]);
            2.0 * (middle + random.map_or(0.0, |random| random[i] - 0.5)) / steps - 1.0
        };
        // Map to [-1, 1]
        let (mut u, mut v) = (place(0), place(1));
        if self.is_disc() {
            (u, v) = (u + BESIDE, v + BESIDE);
            // Map the square to a disc.
            let shrink = u.abs().max(v.abs()) / (u * u + v * v).sqrt().max(f64::MIN_POSITIVE);
            (u, v) = (u * shrink, v * shrink);
        }
        let [a, b] = *sides;
        (a * u + b * v) * 0.5
    }

    /// Returns the offsets of [`Self::light_offset`] for several points, each with its own sides and random numbers.
    #[inline(always)]
    pub fn light_offsets(&self, cell: [u32; 2], sides: &[Vectors; 2], random: Option<[Numbers; 2]>) -> Vectors {
        // The operations of `light_offset`, in the same order
        let place = |i: usize| {
            let (steps, middle) = self.steps_and_place(i, cell[i]);
            let moved = random.as_ref().map_or(Lanes::splat(middle), |random| (random[i] - 0.5) + middle);
            2.0 * moved / Lanes::splat(steps) - 1.0
        };
        let (mut u, mut v) = (place(0), place(1));
        if self.is_disc() {
            (u, v) = (u + BESIDE, v + BESIDE);
            let length = (u * u + v * v).sqrt().max(Lanes::splat(f64::MIN_POSITIVE));
            let shrink = u.abs().max(v.abs()) / length;
            (u, v) = (u * shrink, v * shrink);
        }
        let [a, b] = *sides;
        (a * u + b * v) * Lanes::splat(0.5)
    }

    /// Returns the offsets of the corners, in order around it, of a parallelogram that contains the lights from `low`
    /// to `high`, with any jitter. `direction_to_point` is the direction to the illuminated point, length 1.
    pub fn offset_parallelogram(&self, low: [u32; 2], high: [u32; 2], direction_to_point: DVec3) -> [DVec3; 4] {
        let place = |i: usize, cell: u32, outwards: f64| {
            let (steps, middle) = self.steps_and_place(i, cell);
            let jitter = if self.jitter { 1.0 / steps } else { 0.0 };
            2.0 * middle / steps - 1.0 + outwards * (jitter + OUTWARDS)
        };
        // The map to a disc multiplies coordinates by a factor between √½ and 1.
        let least_factor = if self.is_disc() { FRAC_1_SQRT_2 } else { 1.0 };
        let ends = |i: usize| {
            let (start, end) = (place(i, low[i], -1.0), place(i, high[i], 1.0));
            [start.min(start * least_factor), end.max(end * least_factor)]
        };
        let [a, b] = self.sides(direction_to_point);
        let ([u0, u1], [v0, v1]) = (ends(0), ends(1));
        [[u0, v0], [u1, v0], [u1, v1], [u0, v1]].map(|[u, v]| (a * u + b * v) * 0.5)
    }

    /// True if the grid is mapped to a disc (quirk: `oriented_area_is_circular`).
    #[inline]
    fn is_disc(&self) -> bool {
        (self.circular || self.orient) && self.size.iter().all(|n| *n > 1)
    }

    /// Returns the sides of an area light's grid that faces a direction of length 1: the first side is perpendicular to
    /// z, or to y if the direction is nearly z (quirk: `oriented_area_sides`).
    fn grid_sides_facing(&self, direction_to_point: DVec3) -> [DVec3; 2] {
        let up = if direction_to_point.z.abs() > 0.99 { DVec3::Y } else { DVec3::Z };
        let level = up.cross(direction_to_point).normalize_or(DVec3::X);
        [level, level.cross(direction_to_point)].map(|side| side * self.axes[0].length())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn places(area: &Area) -> Vec<DVec3> {
        let [n, m] = area.size;
        (0..n * m).map(|i| area.light_offset([i % n, i / n], &area.sides(DVec3::NEG_Z), None)).collect()
    }

    #[test]
    fn offsets_of_a_grid_and_a_disc() {
        // Positions seen through a pinhole in POV-Ray
        let area = Area { axes: [DVec3::X * 4.0, DVec3::Y * 2.0], size: [4, 3], circular: true, ..Area::default() };
        let places = places(&area);
        let seen = [(0, [-1.4112, -0.7056]), (1, [-0.6293, -0.9468]), (4, [-1.9958, 0.0017]), (5, [-0.6629, 0.0014])];
        let seen = seen.into_iter().chain([(8, [-1.414, 0.7098]), (11, [1.4165, 0.7088])]);
        for (i, [x, y]) in seen {
            assert!(places[i].distance(DVec3::new(x, y, 0.0)) < 7e-4, "{i} {}", places[i]);
        }
        let one = Area { size: [1, 1], ..area };
        assert_eq!(one.light_offset([0, 0], &one.sides(DVec3::Z), None), DVec3::ZERO);
    }

    #[test]
    fn what_is_oriented_faces_the_place() {
        let area = Area { axes: [DVec3::X * 3.0, DVec3::Z], size: [2, 2], orient: true, ..Area::default() };
        let toward = DVec3::new(1.0, 2.0, 3.0).normalize();
        for cell in [[0, 0], [1, 0], [1, 1]] {
            let offset = area.light_offset(cell, &area.sides(toward), None);
            assert!(offset.dot(toward).abs() < 1e-15);
            // Corners are as far from the centre as the middles of sides.
            assert!((offset.length() - 1.5).abs() < 1.5 * 1.001 * BESIDE);
        }
    }

    #[test]
    fn hulls_contain_the_lights_of_their_pieces() {
        let toward = DVec3::new(0.48, -0.6, 0.64);
        let axes = [DVec3::X * 3.0, DVec3::new(0.5, 2.0, 0.0)];
        for (size, options) in [([9, 7], 0), ([9, 7], 7), ([1, 12], 3), ([12, 1], 7)]
            .iter()
            .flat_map(|(size, most)| (0..=*most).map(move |options| (*size, options)))
        {
            let [jitter, circular, orient] = [1, 2, 4].map(|bit| options & bit != 0);
            let area = Area { axes, size, jitter, circular, orient, ..Area::default() };
            for (low, high) in
                [([0, 0], [8, 6]), ([0, 0], [3, 3]), ([4, 2], [5, 6]), ([7, 6], [8, 6]), ([2, 2], [2, 2])]
            {
                let [low, high] =
                    [low, high].map(|cell: [u32; 2]| [cell[0].min(size[0] - 1), cell[1].min(size[1] - 1)]);
                let [corner, right, _, up] = area.offset_parallelogram(low, high, toward);
                let (u, v) = (right - corner, up - corner);
                let normal = u.cross(v);
                for cell in (low[0]..=high[0]).flat_map(|i| (low[1]..=high[1]).map(move |j| [i, j])) {
                    for random in [[0.0, 0.0], [1.0, 0.0], [0.0, 1.0], [1.0, 1.0], [0.3, 0.6]] {
                        let p = area.light_offset(cell, &area.sides(toward), jitter.then_some(random)) - corner;
                        let at = [p.cross(v).dot(normal), u.cross(p).dot(normal)].map(|x| x / normal.length_squared());
                        assert!(at.iter().all(|x| (0.0..=1.0).contains(x)), "{area:?} {cell:?} {at:?}");
                        assert!(p.dot(normal).abs() < 1e-12 * normal.length());
                    }
                }
            }
        }
    }
}
