//! Grids of triangles, squares or hexagons whose sides are 1, cut into tiles of several cells.

use super::plans;
use crate::math::{DVec2, fp};
use std::f64::consts::FRAC_1_SQRT_2;

/// √3 / 2, the height of a triangle whose sides are 1.
pub const H: f64 = 0.866_025_403_784_438_6;

/// Shape of the cells of the grid under the pattern `pavement`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Cells {
    /// Grid of triangles, two in each position: the first points up, the second down.
    Triangles,
    /// Grid of squares, the first from (0, 0) to (1, 1).
    Squares,
    /// Grid of hexagons; the first has corners at (0, 0) and (2, 0).
    Hexagons,
}

/// Cell of a pavement's grid: steps along the grid's axes, and the number of the cell at that position.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cell {
    /// Steps of the cell along the first axis of the pavement's grid.
    pub i: i64,
    /// Steps of the cell along the second axis of the pavement's grid.
    pub j: i64,
    /// Orientation of the cell: 1 for triangles that point down, else 0.
    pub kind: usize,
}

/// Steps to the neighbour across each edge, for a triangle that points up; then for one that points down, a square and
/// a hexagon.
const NEIGHBOURS_UP: &[(i64, i64)] = &[(0, -1), (0, 0), (-1, 0)];
const NEIGHBOURS_DOWN: &[(i64, i64)] = &[(0, 0), (1, 0), (0, 1)];
const NEIGHBOURS_SQUARE: &[(i64, i64)] = &[(0, -1), (1, 0), (0, 1), (-1, 0)];
const NEIGHBOURS_HEXAGON: &[(i64, i64)] = &[(1, 0), (0, 1), (-1, 1), (-1, 0), (0, -1), (1, -1)];

impl Cells {
    /// Returns the pavement's grid of cells with this number of sides; `None` unless that is 3, 4 or 6.
    pub fn with_sides(sides: f64) -> Option<Self> {
        [Self::Triangles, Self::Squares, Self::Hexagons].into_iter().find(|cells| cells.side_count() as f64 == sides)
    }

    /// Number of sides of a cell of the pavement's grid.
    pub fn side_count(self) -> usize {
        match self {
            Self::Triangles => 3,
            Self::Squares => 4,
            Self::Hexagons => 6,
        }
    }

    /// Plans of a pavement by number of cells in a tile, then by variant.
    pub fn tile_plans(self) -> &'static [&'static [&'static str]] {
        match self {
            Self::Triangles => plans::TRIANGLES,
            Self::Squares => plans::SQUARES,
            Self::Hexagons => plans::HEXAGONS,
        }
    }

    /// Distance from the centre of a pavement's cell to its corners.
    pub fn corner_radius(self) -> f64 {
        match self {
            Self::Triangles => 0.5 / H,
            Self::Squares => FRAC_1_SQRT_2,
            Self::Hexagons => 1.0,
        }
    }

    /// Width of the bevel at a pavement's joints.
    pub fn bevel_width(self) -> f64 {
        if self == Self::Squares { 0.5 } else { H / 3.0 }
    }

    /// Number of cells at each position of the pavement's grid.
    fn cells_per_position(self) -> usize {
        if self == Self::Triangles { 2 } else { 1 }
    }

    /// Directions of the corners from the centre of a pavement's cell, for each kind of cell.
    pub fn corner_directions(self) -> Vec<Vec<DVec2>> {
        let first: &[f64] = match self {
            Self::Triangles => &[210.0, 150.0],
            Self::Squares => &[225.0],
            Self::Hexagons => &[0.0],
        };
        let n = self.side_count();
        let corner = |first: f64, k: usize| {
            let (sin, cos) = fp::sin_cos((first + 360.0 * k as f64 / n as f64).to_radians());
            DVec2::new(cos, sin)
        };
        first.iter().map(|&first| (0..n).map(|k| corner(first, k)).collect()).collect()
    }

    /// Returns the pavement's cell that contains a point, and the point relative to the cell's centre.
    pub fn cell_at(self, p: DVec2) -> (Cell, DVec2) {
        let cell = |i: f64, j: f64, kind| Cell { i: i as i64, j: j as i64, kind };
        match self {
            Self::Squares => {
                let floor = p.floor();
                (cell(floor.x, floor.y, 0), p - floor - 0.5)
            }
            Self::Triangles => {
                let b = p.y / H;
                let a = p.x - b / 2.0;
                let (i, j) = (a.floor(), b.floor());
                let kind = usize::from(a - i + b - j >= 1.0);
                let corner = DVec2::new(i + j / 2.0, j * H);
                let middle = [DVec2::new(0.5, H / 3.0), DVec2::new(1.0, H * 2.0 / 3.0)][kind];
                (cell(i, j, kind), p - corner - middle)
            }
            Self::Hexagons => {
                // The nearest centre: round a, b and -a-b and correct the one with the largest rounding error.
                let a = (p.x - 1.0) / 1.5;
                let b = p.y / (2.0 * H) - a / 2.0;
                let c = -a - b;
                let (mut i, mut j, k) = (a.round(), b.round(), c.round());
                let (di, dj, dk) = ((i - a).abs(), (j - b).abs(), (k - c).abs());
                if di > dj && di > dk {
                    i = -j - k;
                } else if dj > dk {
                    j = -i - k;
                }
                (cell(i, j, 0), p - DVec2::new(1.0 + 1.5 * i, (i + 2.0 * j) * H))
            }
        }
    }

    /// Returns the neighbour of a pavement's cell across an edge.
    fn neighbour(self, cell: Cell, edge: usize) -> Cell {
        let steps = match (self, cell.kind) {
            (Self::Triangles, 0) => NEIGHBOURS_UP,
            (Self::Triangles, _) => NEIGHBOURS_DOWN,
            (Self::Squares, _) => NEIGHBOURS_SQUARE,
            (Self::Hexagons, _) => NEIGHBOURS_HEXAGON,
        };
        let (i, j) = steps[edge];
        let kind = if self == Self::Triangles { 1 - cell.kind } else { 0 };
        Cell { i: cell.i + i, j: cell.j + j, kind }
    }

    /// Returns the index that an edge of a pavement's cell has in the cell on its other side.
    fn edge_in_neighbour(self, cell: Cell, edge: usize) -> usize {
        match (self, cell.kind) {
            (Self::Triangles, 0) => (edge + 2) % 3,
            (Self::Triangles, _) => (edge + 1) % 3,
            _ => (edge + self.side_count() / 2) % self.side_count(),
        }
    }
}

/// Edges that are joints, among those that meet at a corner of a pavement's cell.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct CornerJoints {
    /// True if the edge of a pavement's cell before the corner (against the clock) is a joint.
    pub before: bool,
    /// True if the edge of a pavement's cell after the corner is a joint.
    pub after: bool,
    /// True if the first edge outside the cell at the corner, next to `after`, is a pavement's joint.
    pub first: bool,
    /// True if the last edge outside the cell at the corner, next to `before`, is a pavement's joint.
    pub last: bool,
    /// True if any edge outside the cell at the corner is a pavement's joint.
    pub any: bool,
}

/// Plan of a pavement: the edges of the grid that are joints between tiles.
#[derive(Clone, Debug, PartialEq)]
pub struct Plan {
    cells: Cells,
    /// The period of the pavement's plan: a along the first axis; b along the first and c along the second.
    steps: [i64; 3],
    /// For each cell of a period of the pavement, a bit for each edge that is a joint.
    joints: Vec<u8>,
    /// Joints at the corners of each cell of a period of the pavement.
    corner_joints: Vec<Vec<CornerJoints>>,
}

impl Plan {
    /// Parses a pavement's plan, a row of `plans.rs`.
    pub fn new(cells: Cells, row: &str) -> Self {
        let mut words = row.split(' ');
        let mut number = || words.next().and_then(|word| word.parse().ok()).unwrap_or(1);
        let steps = [number(), number(), number()];
        let digits: Vec<u8> = words.flat_map(str::chars).map(|c| c.to_digit(16).unwrap_or(0) as u8).collect();
        let joints = match cells {
            Cells::Hexagons => digits.chunks(2).map(|pair| pair.iter().fold(0, |all, digit| all * 8 + digit)).collect(),
            _ => digits,
        };
        let mut plan = Self { cells, steps, joints, corner_joints: vec![] };
        let places = (0..steps[2]).flat_map(|j| (0..steps[0]).map(move |i| (i, j)));
        let all = places.flat_map(|(i, j)| (0..cells.cells_per_position()).map(move |kind| Cell { i, j, kind }));
        plan.corner_joints =
            all.map(|cell| (0..cells.side_count()).map(|k| plan.joints_at_corner(cell, k)).collect()).collect();
        plan
    }

    fn index_in_period(&self, cell: Cell) -> usize {
        let [a, b, c] = self.steps;
        let (up, j) = (cell.j.div_euclid(c), cell.j.rem_euclid(c));
        // no step overflows, for any cell
        let i = (cell.i.rem_euclid(a) - up.rem_euclid(a) * b).rem_euclid(a);
        (j * a + i) as usize * self.cells.cells_per_position() + cell.kind
    }

    fn is_joint(&self, cell: Cell, edge: usize) -> bool {
        self.joints[self.index_in_period(cell)] >> edge & 1 == 1
    }

    fn joints_at_corner(&self, cell: Cell, k: usize) -> CornerJoints {
        let n = self.cells.side_count();
        // around the corner, from the edge after it to the edge before it
        let (mut there, mut edge) = (cell, k);
        let mut others = vec![];
        for _ in 0..2 * n / (n - 2) - 2 {
            (there, edge) = (self.cells.neighbour(there, edge), (self.cells.edge_in_neighbour(there, edge) + 1) % n);
            others.push(self.is_joint(there, edge));
        }
        let [first, last] = [others.first(), others.last()].map(|other| other == Some(&true));
        let (before, after) = (self.is_joint(cell, (k + n - 1) % n), self.is_joint(cell, k));
        CornerJoints { before, after, first, last, any: others.contains(&true) }
    }

    /// Returns, for each corner of a pavement's cell, which of the edges that meet there are joints.
    pub fn joints_at_corners(&self, cell: Cell) -> &[CornerJoints] {
        &self.corner_joints[self.index_in_period(cell)]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn joints_match_from_both_sides() {
        for cells in [Cells::Triangles, Cells::Squares, Cells::Hexagons] {
            for row in cells.tile_plans().iter().copied().flatten() {
                let plan = Plan::new(cells, row);
                assert_eq!(
                    plan.joints.len() as i64,
                    plan.steps[0] * plan.steps[2] * cells.cells_per_position() as i64,
                    "{row}"
                );
                for (i, j) in (-7..7).flat_map(|i| (-7..7).map(move |j| (i, j))) {
                    for (kind, edge) in
                        (0..cells.cells_per_position()).flat_map(|k| (0..cells.side_count()).map(move |e| (k, e)))
                    {
                        let cell = Cell { i, j, kind };
                        let (other, same) = (cells.neighbour(cell, edge), cells.edge_in_neighbour(cell, edge));
                        assert_eq!(cells.neighbour(other, same), cell);
                        assert_eq!(plan.is_joint(cell, edge), plan.is_joint(other, same), "{row}");
                    }
                }
            }
        }
    }
}
