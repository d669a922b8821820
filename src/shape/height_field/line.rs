//! A ray over a height field, in units of the field's cells and steps of height.

use super::grid::Place;
use crate::math::{DVec2, DVec3, Range};
use std::ops::ControlFlow;

/// Distance above or below a height field's heights that exceeds all rounding, in steps.
pub const SLACK: f64 = 1e-3;

/// A ray in units of a height field's cells and steps of height, and the part of it over the field.
pub struct Line<'v> {
    /// Origin of the ray.
    pub o: DVec3,
    /// Direction of the ray.
    pub d: DVec3,
    /// Inverses of the direction's components along x and z.
    pub inverse: DVec2,
    /// Distance at which the ray enters the height field's box.
    pub near: f64,
    /// Distance at which the ray leaves the height field's box.
    pub far: f64,
    /// Range of distances along the ray in which hits count.
    pub range: Range,
    /// Function that receives each hit, and breaks to end the search.
    pub visit: &'v mut dyn FnMut(f64, Place) -> ControlFlow<()>,
}

/// Piece of a ray over a height field: its ends, and the heights there.
#[derive(Clone, Copy)]
pub struct RayPiece {
    /// Distances along the ray of both ends.
    pub t: [f64; 2],
    /// Heights of the ray at both ends.
    pub y: [f64; 2],
}

impl RayPiece {
    /// True if the piece of the ray is entirely above or below these heights.
    pub fn is_clear_of(&self, [lo, hi]: [u16; 2]) -> bool {
        let [y0, y1] = self.y;
        let (least, most) = if y0 < y1 { (y0, y1) } else { (y1, y0) };
        least > f64::from(hi) + SLACK || most < f64::from(lo) - SLACK
    }

    /// Splits the piece of the ray at two distances.
    pub fn split_at(&self, first: f64, second: f64, line: &Line) -> [Option<Self>; 3] {
        let Self { t: [near, far], y: [y_near, y_far] } = *self;
        let (a, ya) = if first > far { (far, y_far) } else { (first, line.height_at(first)) };
        let (b, yb) = if second < near { (near, y_near) } else { (second, line.height_at(second)) };
        let between = match (first < near, second > far) {
            (false, false) => Self { t: [first, second], y: [ya, yb] },
            (true, false) => Self { t: [near, second], y: [y_near, yb] },
            (false, true) => Self { t: [first, far], y: [ya, y_far] },
            (true, true) => *self,
        };
        [
            (first >= near).then_some(Self { t: [near, a], y: [y_near, ya] }),
            (first <= far && second >= near).then_some(between),
            (second <= far).then_some(Self { t: [b, far], y: [yb, y_far] }),
        ]
    }
}

/// Returns the distance at which a ray crosses the middle of a square along one axis. That is `line_crossing`, or
/// infinite (of either sign) where the ray is parallel to the middle line or the square has no second half.
pub fn middle_crossing_or_infinity(o: f64, d: f64, middle: usize, end: usize, line_crossing: f64) -> f64 {
    let is_whole = middle >= end;
    if d == 0.0 {
        let is_first = is_whole || o < middle as f64;
        return if is_first { f64::INFINITY } else { f64::NEG_INFINITY };
    }
    match is_whole {
        true if d < 0.0 => f64::NEG_INFINITY,
        true => f64::INFINITY,
        false => line_crossing,
    }
}

impl Line<'_> {
    /// Distance at which the ray crosses the side between two columns of cells.
    pub fn distance_at_x(&self, i: usize) -> f64 {
        (i as f64 - self.o.x) * self.inverse.x
    }

    /// Distance at which the ray crosses the side between two rows of cells.
    pub fn distance_at_z(&self, k: usize) -> f64 {
        (k as f64 - self.o.z) * self.inverse.y
    }

    /// Height of the ray at a distance.
    pub fn height_at(&self, t: f64) -> f64 {
        self.o.y + self.d.y * t
    }

    /// Returns the height of the ray at distance `t`, and its position within a height field's cell.
    pub fn height_and_cell_position(&self, i: usize, k: usize, t: f64) -> (f64, DVec2) {
        let p = self.o + self.d * t;
        (p.y, DVec2::new(p.x - i as f64, p.z - k as f64).clamp(DVec2::ZERO, DVec2::ONE))
    }

    /// Visits the hit on a height field's triangle if the ray is above it at one end and below at the other.
    pub fn visit_crossing(&mut self, place: Place, t: [f64; 2], above_field: [f64; 2]) -> ControlFlow<()> {
        if (above_field[0] < 0.0) == (above_field[1] < 0.0) {
            return ControlFlow::Continue(());
        }
        let t = t[0] + (t[1] - t[0]) * (above_field[0] / (above_field[0] - above_field[1]));
        if self.range.contains(t) { (self.visit)(t, place) } else { ControlFlow::Continue(()) }
    }
}
