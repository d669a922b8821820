//! A grid of heights, and its intersection with lines: a pyramid of minimum and maximum heights skips what the line is
//! entirely above or below (Tevs, Ihrke and Seidel, "Maximum Mipmaps for Fast, Accurate, and Scalable Dynamic Height
//! Field Rendering", 2008).

use super::line::{Line, RayPiece, SLACK, middle_crossing_or_infinity};
use super::normals::Normals;
use crate::math::{DVec2, DVec3, Range, Ray};
use std::ops::ControlFlow;
use std::sync::OnceLock;

/// Number of steps of a height field's height in a unit.
pub const STEPS: f64 = 65536.0;
/// Side of the smallest squares in a height field's pyramid, in cells.
const BLOCK: usize = 4;
/// Distance from the edge of a height field's cell below which rounding may decide on which side a point of a ray is, in
/// cells.
const ROUNDING_IN_CELLS: f64 = 1e-3;

/// Heights of a height field at the corners of cells, row by row: x grows along a row, z from row to row.
#[derive(Debug)]
pub struct Grid {
    /// Number of the height field's cells along x.
    pub across: usize,
    /// Number of the height field's cells along z.
    pub deep: usize,
    heights: Box<[u16]>,
    pyramid: Vec<Level>,
    /// Normals at the height field's corners, once any is requested.
    normals: OnceLock<Normals>,
}

/// Two grids of a height field are equal if their heights are, whatever is cached of their normals.
impl PartialEq for Grid {
    fn eq(&self, other: &Self) -> bool {
        (self.across, self.deep, &self.heights) == (other.across, other.deep, &other.heights)
    }
}

/// Level of a height field's pyramid: squares of one size.
#[derive(Debug, PartialEq)]
struct Level {
    across: usize,
    deep: usize,
    /// Side of each square of this pyramid level, in cells.
    size: usize,
    /// Minimum and maximum height in each square of the pyramid level.
    ranges: Box<[[u16; 2]]>,
}

/// Cell of a height field and one of its triangles.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Place {
    /// Index of the height field's cell along x.
    pub i: usize,
    /// Index of the height field's cell along z.
    pub k: usize,
    /// True for the triangle of the corners (1, 1), (1, 0) and (0, 1) of a height field's cell.
    pub upper: bool,
}

impl Grid {
    /// Creates a height field's grid with `width` heights in each row, at least two in each direction.
    pub fn new(width: usize, heights: Vec<u16>) -> Self {
        let (across, deep) = (width.max(2) - 1, (heights.len() / width.max(1)).max(2) - 1);
        let mut grid = Self { across, deep, heights: heights.into(), pyramid: vec![], normals: OnceLock::new() };
        grid.pyramid.push(grid.build_finest_level());
        while let Some(level) = grid.pyramid.last().filter(|level| level.ranges.len() > 1) {
            grid.pyramid.push(level.coarser_level());
        }
        grid
    }

    /// Factors from the height field's object space to cells and steps of height.
    pub fn grid_from_object_scale(&self) -> DVec3 {
        DVec3::new(self.across as f64, STEPS, self.deep as f64)
    }

    /// Height of the field at a corner of cells, in steps of height from 0 to 65535.
    pub fn corner_height_in_steps(&self, column: usize, row: usize) -> f64 {
        f64::from(self.heights[row * (self.across + 1) + column])
    }

    /// Normal at a corner of a smooth height field, in object space without its scale in steps and cells.
    pub fn unnormalized_corner_normal(&self, column: usize, row: usize) -> DVec3 {
        self.normals.get_or_init(|| Normals::new(self.heights.len())).unnormalized_normal_at(self, column, row)
    }

    /// Minimum and maximum height of the field, in steps.
    pub fn height_range(&self) -> [f64; 2] {
        self.pyramid.last().map_or([0.0; 2], |level| level.ranges[0].map(f64::from))
    }

    fn build_finest_level(&self) -> Level {
        let (across, deep) = (self.across.div_ceil(BLOCK), self.deep.div_ceil(BLOCK));
        let range = |place: usize| {
            let (i, k) = (place % across * BLOCK, place / across * BLOCK);
            let rows = (k..=(k + BLOCK).min(self.deep)).map(|k| k * (self.across + 1));
            let all = rows.flat_map(|row| &self.heights[row + i..=row + (i + BLOCK).min(self.across)]);
            all.fold([u16::MAX, 0], |[lo, hi], &h| [lo.min(h), hi.max(h)])
        };
        Level { across, deep, size: BLOCK, ranges: (0..across * deep).map(range).collect() }
    }

    /// Heights of the field at the corners of a cell: (0, 0), (1, 0), (0, 1) and (1, 1).
    pub fn cell_corner_heights(&self, column: usize, row: usize) -> [f64; 4] {
        [
            self.corner_height_in_steps(column, row),
            self.corner_height_in_steps(column + 1, row),
            self.corner_height_in_steps(column, row + 1),
            self.corner_height_in_steps(column + 1, row + 1),
        ]
    }

    /// Number of a triangle of the height field, which has fewer than 2³¹ cells.
    pub fn number_of_triangle(&self, Place { i, k, upper }: Place) -> u32 {
        2 * (k * self.across + i) as u32 + u32::from(upper)
    }

    /// Returns the triangle of the height field with a number.
    pub fn triangle_with_number(&self, number: u32) -> Place {
        let cell = number as usize / 2;
        Place { i: cell % self.across, k: cell / self.across, upper: number % 2 == 1 }
    }

    /// Number of the height field's pyramid level with a single square.
    pub fn top_level(&self) -> usize {
        self.pyramid.len() - 1
    }

    /// Minimum and maximum height in a square of the height field's pyramid; `None` beyond its last square.
    pub fn heights_of_square_if_there(&self, level: usize, [a, b]: [usize; 2]) -> Option<[u16; 2]> {
        let level = &self.pyramid[level];
        (a < level.across && b < level.deep).then(|| level.range_of_square([a, b]))
    }

    /// Returns the height field's triangle under a point, and the position within its cell, from 0 to 1; points outside
    /// belong to the nearest cell.
    pub fn triangle_and_position_at(&self, x: f64, z: f64) -> (Place, DVec2) {
        let (i, k) = ((x as usize).min(self.across - 1), (z as usize).min(self.deep - 1));
        let rest = DVec2::new(x - i as f64, z - k as f64).clamp(DVec2::ZERO, DVec2::ONE);
        (Place { i, k, upper: rest.x + rest.y > 1.0 }, rest)
    }

    /// Height of a field's triangle at a position in its cell, in steps.
    pub fn triangle_height(&self, place: Place, position_in_cell: DVec2) -> f64 {
        let slope = self.triangle_slope(place);
        let Place { i, k, upper } = place;
        if upper {
            self.corner_height_in_steps(i + 1, k + 1) + slope.dot(position_in_cell - 1.0)
        } else {
            self.corner_height_in_steps(i, k) + slope.dot(position_in_cell)
        }
    }

    /// Slope of a height field's triangle along x and z, in steps a cell.
    pub fn triangle_slope(&self, place: Place) -> DVec2 {
        let [h00, h10, h01, h11] = self.cell_corner_heights(place.i, place.k);
        if place.upper { DVec2::new(h11 - h01, h11 - h10) } else { DVec2::new(h10 - h00, h01 - h00) }
    }

    /// Calls `visit` with each hit of a ray on the height field, ascending, until it breaks. The ray is in units of
    /// cells and steps.
    pub fn visit_hits(&self, ray: &Ray, range: Range, visit: &mut dyn FnMut(f64, Place) -> ControlFlow<()>) {
        let Some((mut line, way)) = self.line_over_field(ray, range, visit) else { return };
        let (level, square) = self.smallest_square_under(&way, &line);
        if !way.is_clear_of(self.pyramid[level].range_of_square(square)) {
            let _ = self.visit_hits_in_square(level, square, way, &mut line);
        }
    }

    /// Returns the ray as a line, and the piece of it within the range where it is over the height field and between its
    /// lowest and highest point; `None` without such a piece.
    fn line_over_field<'v>(
        &self,
        ray: &Ray,
        range: Range,
        visit: &'v mut dyn FnMut(f64, Place) -> ControlFlow<()>,
    ) -> Option<(Line<'v>, RayPiece)> {
        let (o, d) = (ray.origin, ray.dir);
        let mut line =
            Line { o, d, inverse: DVec2::new(1.0 / d.x, 1.0 / d.z), near: range.min, far: range.max, range, visit };
        let [lo, hi] = self.height_range();
        let below = (lo - 1.0 - o.y) / d.y;
        let above = (hi + 1.0 - o.y) / d.y;
        let (mut near, mut far) = (below.min(above), below.max(above));
        if d.y == 0.0 {
            if o.y < lo - 1.0 || o.y > hi + 1.0 {
                return None;
            }
            (near, far) = (f64::NEG_INFINITY, f64::INFINITY);
        }
        let whole = self.interval_over(&line, [0, 0], [self.across, self.deep]);
        (line.near, line.far) = (near.max(whole.0), far.min(whole.1));
        let is_finite = line.near < line.far && line.near.is_finite() && line.far.is_finite();
        let t = [line.near.max(range.min), line.far.min(range.max)];
        let way = RayPiece { t, y: t.map(|t| line.height_at(t)) };
        (is_finite && t[0] <= t[1] && !self.pyramid.is_empty()).then_some((line, way))
    }

    /// Returns the level and the indices of the smallest square of the height field's pyramid that the line is over along the
    /// whole of `way`.
    fn smallest_square_under(&self, way: &RayPiece, line: &Line) -> (usize, [usize; 2]) {
        // First and last cell along an axis, with the neighbour where rounding may decide.
        let cells = |o: f64, d: f64, last: usize| {
            let [a, b] = way.t.map(|t| o + d * t);
            let cell = |x: f64| (x.max(0.0) as usize).min(last);
            [cell(a.min(b) - ROUNDING_IN_CELLS), cell(a.max(b) + ROUNDING_IN_CELLS)]
        };
        let (i, k) = (cells(line.o.x, line.d.x, self.across - 1), cells(line.o.z, line.d.z, self.deep - 1));
        // The highest bit in which both cells of an axis differ.
        let differing = ((i[0] ^ i[1]) | (k[0] ^ k[1])) / BLOCK;
        let level = ((usize::BITS - differing.leading_zeros()) as usize).min(self.pyramid.len() - 1);
        let size = self.pyramid[level].size;
        (level, [i[0] / size, k[0] / size])
    }

    /// Visits the hits in a square of a height field's pyramid, whose heights the line may reach; the line is over the square
    /// along `way`.
    fn visit_hits_in_square(
        &self,
        level: usize,
        [a, b]: [usize; 2],
        way: RayPiece,
        line: &mut Line,
    ) -> ControlFlow<()> {
        let [from, to] = self.first_and_end_cells(level, a, b);
        if level == 0 {
            return self.visit_hits_in_cells(from, to, line);
        }
        // The line crosses the middle of the square once along each axis, so it is over three of the four quarters at
        // most.
        let quarters = &self.pyramid[level - 1];
        let half = quarters.size;
        let x_middle =
            middle_crossing_or_infinity(line.o.x, line.d.x, from[0] + half, to[0], line.distance_at_x(from[0] + half));
        let z_middle =
            middle_crossing_or_infinity(line.o.z, line.d.z, from[1] + half, to[1], line.distance_at_z(from[1] + half));
        let (flip_x, flip_z) = (usize::from(line.d.x < 0.0), usize::from(line.d.z < 0.0));
        let (first, second, by_x) =
            if x_middle <= z_middle { (x_middle, z_middle, true) } else { (z_middle, x_middle, false) };
        let [before, between, after] = way.split_at(first, second, line);
        let mut visit_quarter = |piece: Option<RayPiece>, is_beyond_x: bool, is_beyond_z: bool| {
            let Some(piece) = piece else { return ControlFlow::Continue(()) };
            let quarter = [2 * a + (usize::from(is_beyond_x) ^ flip_x), 2 * b + (usize::from(is_beyond_z) ^ flip_z)];
            match piece.is_clear_of(quarters.range_of_square(quarter)) {
                true => ControlFlow::Continue(()),
                false => self.visit_hits_in_square(level - 1, quarter, piece, line),
            }
        };
        visit_quarter(before, false, false)?;
        visit_quarter(between, by_x, !by_x)?;
        visit_quarter(after, true, true)
    }

    /// Returns the first cell of a pyramid level's square, and the one beyond its last.
    pub fn first_and_end_cells(&self, level: usize, a: usize, b: usize) -> [[usize; 2]; 2] {
        let size = self.pyramid[level].size;
        let from = [a * size, b * size];
        [from, [(from[0] + size).min(self.across), (from[1] + size).min(self.deep)]]
    }

    /// Visits the hits in the cells of a block of the height field. Whether the line is above or below the surface is evaluated
    /// only where it crosses edges and diagonals of cells, and both sides of an edge get the same result, so no line
    /// passes between them.
    pub fn visit_hits_in_cells(&self, from: [usize; 2], to: [usize; 2], line: &mut Line) -> ControlFlow<()> {
        let (enter, leave) = self.interval_over(line, from, to);
        let (mut t, end) = (enter.max(line.near), leave.min(line.far));
        let (x, z) = (line.o.x + line.d.x * t, line.o.z + line.d.z * t);
        let mut i = (x.max(0.0) as usize).clamp(from[0], to[0] - 1);
        let mut k = (z.max(0.0) as usize).clamp(from[1], to[1] - 1);
        // (Evaluated only where the line comes near the surface.)
        let mut known = None;
        loop {
            let next_x =
                if line.d.x == 0.0 { f64::INFINITY } else { line.distance_at_x(i + usize::from(line.d.x > 0.0)) };
            let next_z =
                if line.d.z == 0.0 { f64::INFINITY } else { line.distance_at_z(k + usize::from(line.d.z > 0.0)) };
            let next = next_x.min(next_z).min(end).max(t);
            let mut over_next = None;
            if self.may_hit_cell(i, k, [t, next], line) {
                let heights = [
                    known.unwrap_or_else(|| self.height_above_field(i, k, t, line)),
                    self.height_above_field(i, k, next, line),
                ];
                over_next = Some(heights[1]);
                self.visit_hits_in_cell(i, k, [t, next], heights, line)?;
            }
            if next >= end {
                return ControlFlow::Continue(());
            }
            let moved = if next_x <= next_z {
                try_next_cell(&mut i, line.d.x, from[0], to[0])
            } else {
                try_next_cell(&mut k, line.d.z, from[1], to[1])
            };
            if !moved {
                return ControlFlow::Continue(());
            }
            (t, known) = (next, over_next);
        }
    }

    /// Returns the interval in which a line is over a rectangle of a height field's cells. A line along the upper side
    /// is not, except at the end of the field.
    fn interval_over(&self, line: &Line, from: [usize; 2], to: [usize; 2]) -> (f64, f64) {
        let (mut near, mut far) = (f64::NEG_INFINITY, f64::INFINITY);
        let mut narrow = |o: f64, d: f64, a: f64, b: f64, ends: [usize; 2], last: usize| {
            let is_in = o >= ends[0] as f64 && (o < ends[1] as f64 || o == last as f64);
            if d != 0.0 {
                (near, far) = (near.max(a.min(b)), far.min(a.max(b)));
            } else if !(is_in && o <= ends[1] as f64) {
                far = f64::NEG_INFINITY;
            }
        };
        let (o, d) = (line.o, line.d);
        narrow(o.x, d.x, line.distance_at_x(from[0]), line.distance_at_x(to[0]), [from[0], to[0]], self.across);
        narrow(o.z, d.z, line.distance_at_z(from[1]), line.distance_at_z(to[1]), [from[1], to[1]], self.deep);
        (near, far)
    }

    /// True if a piece of a ray is neither entirely above a height field's cell nor entirely below.
    fn may_hit_cell(&self, i: usize, k: usize, t: [f64; 2], line: &Line) -> bool {
        let row = k * (self.across + 1) + i;
        let (first, second) = (&self.heights[row..row + 2], &self.heights[row + self.across + 1..][..2]);
        let (lo, hi) = (
            first[0].min(first[1]).min(second[0]).min(second[1]),
            first[0].max(first[1]).max(second[0]).max(second[1]),
        );
        let y = t.map(|t| line.o.y + line.d.y * t);
        y[0].min(y[1]) <= f64::from(hi) + SLACK && y[0].max(y[1]) >= f64::from(lo) - SLACK
    }

    /// Visits the hits in a height field's cell between the distances `t` along the ray, where the ray is at the heights
    /// `above_field`.
    fn visit_hits_in_cell(
        &self,
        i: usize,
        k: usize,
        t: [f64; 2],
        above_field: [f64; 2],
        line: &mut Line,
    ) -> ControlFlow<()> {
        let diagonal = ((i + k + 1) as f64 - line.o.x - line.o.z) / (line.d.x + line.d.z);
        if !(diagonal > t[0] && diagonal < t[1]) {
            let (_, rest) = line.height_and_cell_position(i, k, 0.5 * (t[0] + t[1]));
            return line.visit_crossing(Place { i, k, upper: rest.x + rest.y > 1.0 }, t, above_field);
        }
        let [_, h10, h01, _] = self.cell_corner_heights(i, k);
        let (y, rest) = line.height_and_cell_position(i, k, diagonal);
        let middle = y - (h10 + (h01 - h10) * rest.y);
        let first = line.d.x + line.d.z < 0.0;
        line.visit_crossing(Place { i, k, upper: first }, [t[0], diagonal], [above_field[0], middle])?;
        line.visit_crossing(Place { i, k, upper: !first }, [diagonal, t[1]], [middle, above_field[1]])
    }

    /// Height of the ray above the height field at the edge of a cell, or within it.
    fn height_above_field(&self, i: usize, k: usize, t: f64, line: &Line) -> f64 {
        let (y, rest) = line.height_and_cell_position(i, k, t);
        let along = |a: f64, b: f64, s: f64| a + (b - a) * s;
        let edge = |i: usize| along(self.corner_height_in_steps(i, k), self.corner_height_in_steps(i, k + 1), rest.y);
        let row = |k: usize| along(self.corner_height_in_steps(i, k), self.corner_height_in_steps(i + 1, k), rest.x);
        y - match () {
            _ if line.d.x != 0.0 && t == line.distance_at_x(i) => edge(i),
            _ if line.d.x != 0.0 && t == line.distance_at_x(i + 1) => edge(i + 1),
            _ if line.d.z != 0.0 && t == line.distance_at_z(k) => row(k),
            _ if line.d.z != 0.0 && t == line.distance_at_z(k + 1) => row(k + 1),
            _ => self.triangle_height(Place { i, k, upper: rest.x + rest.y > 1.0 }, rest),
        }
    }
}

impl Level {
    /// Returns the minimum and maximum height in a square of this pyramid level, in steps.
    #[inline]
    fn range_of_square(&self, [a, b]: [usize; 2]) -> [u16; 2] {
        self.ranges[b * self.across + a]
    }

    /// Returns the next level of the height field's pyramid, with squares twice as large.
    fn coarser_level(&self) -> Self {
        let (across, deep) = (self.across.div_ceil(2), self.deep.div_ceil(2));
        let range = |place: usize| {
            let (a, b) = (place % across * 2, place / across * 2);
            let rows = (b..(b + 2).min(self.deep)).map(|b| b * self.across);
            let all = rows.flat_map(|row| &self.ranges[row + a..row + (a + 2).min(self.across)]);
            all.fold([u16::MAX, 0], |[lo, hi], range| [lo.min(range[0]), hi.max(range[1])])
        };
        Self { across, deep, size: self.size * 2, ranges: (0..across * deep).map(range).collect() }
    }
}

/// Moves to the height field's next cell along an axis; returns false at the end.
fn try_next_cell(i: &mut usize, d: f64, from: usize, to: usize) -> bool {
    if d > 0.0 {
        *i += 1;
        *i < to
    } else if *i > from {
        *i -= 1;
        true
    } else {
        false
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::fp;
    use crate::math::rng::Stream;

    #[test]
    fn pyramid_skips_no_hit() {
        let (width, depth, mut random) = (83, 61, Stream::new(&[7]));
        let heights = (0..width * depth).map(|i| {
            let wave = fp::sin((i % width) as f64 * 0.2) * fp::cos((i / width) as f64 * 0.3);
            (30_000.0 + 20_000.0 * wave + 4000.0 * random.next_random()) as u16
        });
        let grid = Grid::new(width, heights.collect());
        let (size, mut n_hits) = (DVec3::new(82.0, 65_536.0, 60.0), 0);
        for i in 0..3000 {
            let mut any =
                |spread: f64| DVec3::from_array([(); 3].map(|()| spread * (random.next_random() - 0.5) + 0.5)) * size;
            // Rays to all sides, among them steep ones, whole and in part.
            let (from, mut to) = (any(3.0), any(1.0));
            if i % 3 == 0 {
                (to.x, to.z) = (from.x + 0.02 * (to.x - from.x), from.z + 0.02 * (to.z - from.z));
            }
            let range = if i % 2 == 0 { Range::FORWARD } else { Range { min: 0.3, max: 0.9 } };
            let ray = Ray::new(from, to - from);
            let (mut found, mut expected) = (vec![], vec![]);
            grid.visit_hits(&ray, range, &mut |t, place| {
                found.push((t, place));
                ControlFlow::Continue(())
            });
            let mut collect = |t, place| {
                expected.push((t, place));
                ControlFlow::Continue(())
            };
            if let Some((mut line, _)) = grid.line_over_field(&ray, range, &mut collect) {
                let _ = grid.visit_hits_in_cells([0, 0], [grid.across, grid.deep], &mut line);
            }
            assert_eq!(found, expected, "{ray:?}");
            n_hits += found.len();
        }
        assert!(n_hits > 3000, "{n_hits}");
    }
}
