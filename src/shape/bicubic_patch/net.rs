//! The control net of a patch, and its subdivision into flat pieces.

use crate::math::{DVec2, DVec3};

/// Control net of a Bézier surface: four rows of four points.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Net(pub [DVec3; 16]);

/// Point of a bicubic patch where cells meet.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Corner {
    /// Position of the point on the bicubic patch.
    pub point: DVec3,
    /// Normal of the bicubic patch at the point, of length 1.
    pub normal: DVec3,
    /// Parameters of the bicubic patch at the point, along the rows and from row to row, from 0 to 1.
    pub place: DVec2,
}

/// Limits of a bicubic patch's subdivision.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Steps {
    /// Maximum subdivisions of a bicubic patch between the rows.
    pub rows: u32,
    /// Maximum subdivisions of a bicubic patch along the rows.
    pub columns: u32,
    /// Distance of control points from a plane below which a piece of a bicubic patch is flat; 0 to subdivide always.
    pub flatness: f64,
}

impl Net {
    fn control_point(&self, row: usize, column: usize) -> DVec3 {
        self.0[4 * row + column]
    }

    /// Halves four curves of a Bézier surface, whose points are `point_stride` apart; the curves are `curve_stride` apart. (De
    /// Casteljau's algorithm; the mean of two points does not depend on their order, so neighbours share their borders
    /// exactly.)
    fn halve_curves(&self, point_stride: usize, curve_stride: usize) -> [Net; 2] {
        let mean = |p: DVec3, q: DVec3| 0.5 * (p + q);
        let (mut first, mut second) = (*self, *self);
        for curve in 0..4 {
            let [a, b, c, d] = std::array::from_fn(|k| self.0[curve * curve_stride + k * point_stride]);
            let (ab, bc, cd) = (mean(a, b), mean(b, c), mean(c, d));
            let (abc, bcd) = (mean(ab, bc), mean(bc, cd));
            let middle = mean(abc, bcd);
            for (k, (p, q)) in [(a, middle), (ab, bcd), (abc, cd), (middle, d)].into_iter().enumerate() {
                first.0[curve * curve_stride + k * point_stride] = p;
                second.0[curve * curve_stride + k * point_stride] = q;
            }
        }
        [first, second]
    }

    /// True if no control point of the Bézier surface is farther than `flatness` from the plane through three of the
    /// corners. If two of the first three coincide, the fourth is used; without any plane the piece is not flat (quirk:
    /// `patch_flatness`).
    fn is_flat(&self, flatness: f64) -> bool {
        let [a, b, c, d] =
            [self.control_point(0, 0), self.control_point(0, 3), self.control_point(3, 0), self.control_point(3, 3)];
        let plane = [(b, c), (c, d)].map(|(p, q)| (p - a).cross(q - a));
        let Some(normal) = plane.into_iter().find_map(DVec3::try_normalize) else { return false };
        self.0.iter().all(|p| (p - a).dot(normal).abs() < flatness)
    }

    /// Normal of a Bézier surface at a corner, by its neighbours on the borders; along x if they coincide (quirk:
    /// `patch_flatness`).
    fn corner_normal(&self, row: usize, column: usize) -> DVec3 {
        let between = |at: usize, near: DVec3, far: DVec3| if at == 0 { near } else { far };
        let downwards = between(
            row,
            self.control_point(1, column) - self.control_point(0, column),
            self.control_point(3, column) - self.control_point(2, column),
        );
        let along = between(
            column,
            self.control_point(row, 1) - self.control_point(row, 0),
            self.control_point(row, 3) - self.control_point(row, 2),
        );
        downwards.cross(along).try_normalize().unwrap_or(DVec3::X)
    }

    /// Subdivides a Bézier surface; calls `leaf` with each flat piece: the corners first and last of the first row,
    /// first and last of the last row.
    pub fn subdivide(&self, steps: Steps, leaf: &mut dyn FnMut([Corner; 4])) {
        self.subdivide_between(steps, [DVec2::ZERO, DVec2::ONE], leaf);
    }

    fn subdivide_between(&self, steps: Steps, [from, to]: [DVec2; 2], leaf: &mut dyn FnMut([Corner; 4])) {
        let Steps { rows, columns, flatness } = steps;
        if rows + columns == 0 || flatness > 0.0 && self.is_flat(flatness) {
            let corner = |row: usize, column: usize| Corner {
                point: self.control_point(row, column),
                normal: self.corner_normal(row, column),
                place: DVec2::new(if column == 0 { from.x } else { to.x }, if row == 0 { from.y } else { to.y }),
            };
            return leaf([corner(0, 0), corner(0, 3), corner(3, 0), corner(3, 3)]);
        }
        let middle = 0.5 * (from + to);
        let left = Steps { rows: rows.saturating_sub(1), columns: columns.saturating_sub(1), flatness };
        let bands: &[(Net, f64, f64)] = match rows {
            0 => &[(*self, from.y, to.y)],
            _ => {
                let [upper, lower] = self.halve_curves(4, 1);
                &[(upper, from.y, middle.y), (lower, middle.y, to.y)]
            }
        };
        for (band, top, bottom) in bands {
            if columns == 0 {
                band.subdivide_between(left, [from.with_y(*top), to.with_y(*bottom)], leaf);
                continue;
            }
            let [first, second] = band.halve_curves(1, 4);
            first.subdivide_between(left, [DVec2::new(from.x, *top), DVec2::new(middle.x, *bottom)], leaf);
            second.subdivide_between(left, [DVec2::new(middle.x, *top), DVec2::new(to.x, *bottom)], leaf);
        }
    }
}
