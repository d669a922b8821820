//! `area_light axis, axis, N, M`: a row or grid of lights that makes soft shadows (manual, "Area Lights").

use super::{Light, read_finite};
use crate::diagnostic::{Diagnostic, Result, codes};
use crate::math::DVec3;
use crate::value::Reader;
use crate::value::ValueKind::{Flag, Float, Nothing, Vector};
use crate::value::words::{Row, set, word};
use serde::Serialize;

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
    /// Returns the vector from the area light's location to the light `cell` of its grid. `toward` is the direction to
    /// the illuminated point, length 1; `random` are two numbers in [0, 1) for jitter.
    pub fn light_offset(&self, cell: [u32; 2], toward: DVec3, random: Option<[f64; 2]>) -> DVec3 {
        let place = |i: usize| {
            let steps = f64::from(self.size[i].max(2) - 1);
            // The only light of a row is in its middle.
            let middle = if self.size[i] == 1 { 0.5 * steps } else { f64::from(cell[i]) };
            2.0 * (middle + random.map_or(0.0, |random| random[i] - 0.5)) / steps - 1.0
        };
        // Map to [-1, 1]
        let (mut u, mut v) = (place(0), place(1));
        // quirk: oriented_area_is_circular
        if (self.circular || self.orient) && self.size.iter().all(|n| *n > 1) {
            (u, v) = (u + BESIDE, v + BESIDE);
            // Map the square to a disc.
            let shrink = u.abs().max(v.abs()) / (u * u + v * v).sqrt().max(f64::MIN_POSITIVE);
            (u, v) = (u * shrink, v * shrink);
        }
        let [a, b] = if self.orient { self.sides_facing(toward) } else { self.axes };
        (a * u + b * v) * 0.5
    }

    /// Returns the sides of an area light's grid that faces a direction: the first side is perpendicular to z, or to y
    /// if the direction is nearly z (quirk: `oriented_area_sides`).
    fn sides_facing(&self, toward: DVec3) -> [DVec3; 2] {
        let up = if toward.z.abs() > 0.99 { DVec3::Y } else { DVec3::Z };
        let level = up.cross(toward).normalize_or(DVec3::X);
        [level, level.cross(toward)].map(|side| side * self.axes[0].length())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn places(area: &Area) -> Vec<DVec3> {
        let [n, m] = area.size;
        (0..n * m).map(|i| area.light_offset([i % n, i / n], DVec3::NEG_Z, None)).collect()
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
        assert_eq!(one.light_offset([0, 0], DVec3::Z, None), DVec3::ZERO);
    }

    #[test]
    fn what_is_oriented_faces_the_place() {
        let area = Area { axes: [DVec3::X * 3.0, DVec3::Z], size: [2, 2], orient: true, ..Area::default() };
        let toward = DVec3::new(1.0, 2.0, 3.0).normalize();
        for cell in [[0, 0], [1, 0], [1, 1]] {
            let offset = area.light_offset(cell, toward, None);
            assert!(offset.dot(toward).abs() < 1e-15);
            // Corners are as far from the centre as the middles of sides.
            assert!((offset.length() - 1.5).abs() < 1.5 * 1.001 * BESIDE);
        }
    }
}
