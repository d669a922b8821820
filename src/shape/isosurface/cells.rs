//! The container of an isosurface in cells, with bounds of the function's gradient in each cell that can hold a piece
//! of the surface.
//!
//! If the gradient has no bounds, such as at jumps, a cell is subdivided when the first ray enters it: most of the
//! smaller cells are empty or have bounds.

use super::pruned::{PrunedFormula, PrunedFormulas};
use crate::function::{Interval, Slope};
use crate::math::{Aabb, DVec3, Ray, cancel, fp};
use crate::shape::formula::Formula;
use std::sync::OnceLock;

/// Approximate number of cells of an isosurface.
const COUNT: f64 = 5000.0;
/// Maximum number of cells of an isosurface along an axis.
const MOST: f64 = 64.0;
/// Maximum number of subdivisions of an isosurface's cell. (More cost more than they save in small pictures.)
const HALVINGS: u32 = 2;

/// Cells of an isosurface's container that can hold a piece of its surface.
#[derive(Debug)]
pub struct Cells {
    surface: Surface,
    grid: Grid,
}

/// Definition of an isosurface, for all its cells.
#[derive(Debug)]
struct Surface {
    /// Function of the isosurface, whose value on the surface is the threshold.
    formula: Formula,
    threshold: f64,
    /// Pruned functions of the cells; `None` if the function has no operations that a cell can decide.
    pruned: Option<PrunedFormulas>,
}

/// Grid of an isosurface's cells.
#[derive(Debug)]
struct Grid {
    bounds: Aabb,
    count: [usize; 3],
    /// Number of the isosurface's cells per unit of length, along each axis.
    scale: DVec3,
    /// For each cell of the grid, its index in `cells` plus one; 0 without surface.
    places: Box<[u16]>,
    cells: Vec<Cell>,
}

/// Cell that can hold a piece of the isosurface.
#[derive(Debug)]
pub struct Cell {
    /// Bounds of the gradient of the isosurface's function in the cell.
    pub gradient: Gradient,
    /// Function of the isosurface without the operations that are decided in the cell; `None` if none are.
    pruned: Option<Box<PrunedFormula>>,
    /// Eight parts of the isosurface's cell, built when a ray enters.
    halves: OnceLock<Option<Box<Grid>>>,
}

/// Bounds of the gradient of an isosurface's function in a cell; see [`Slope`].
#[derive(Clone, Copy, Debug)]
pub struct Gradient {
    by: [[f32; 2]; 3],
    around: f32,
    rough: bool,
    /// True if all bounds are finite.
    is_known: bool,
}

impl Gradient {
    fn new(slope: &Slope) -> Self {
        // Widen the bounds for rounding.
        let wider = |i: Interval| [(i.lo - i.lo.abs() * 1e-6) as f32, (i.hi + i.hi.abs() * 1e-6) as f32];
        let (by, around) = (slope.by.map(wider), (slope.around * 1.000_001) as f32);
        let is_known = by.iter().flatten().chain([&around]).all(|by| by.is_finite());
        Self { by, around, rough: slope.rough, is_known }
    }

    /// Bounds of the function's derivative along `d`, whose length is `length`; `fallback` without bounds, or where
    /// rough bounds are wider than that.
    pub fn derivative_along(&self, d: DVec3, length: f64, fallback: Interval) -> Interval {
        let far = f64::from(self.around) * length;
        let (mut lo, mut hi) = (-far, far);
        for axis in 0..3 {
            let [a, b] = self.by[axis].map(|by| if d[axis] == 0.0 { 0.0 } else { f64::from(by) * d[axis] });
            lo += a.min(b);
            hi += a.max(b);
        }
        let good = |bound: f64, fallback: f64| bound.is_finite() && !(self.rough && bound.abs() > fallback.abs());
        Interval {
            lo: if good(lo, fallback.lo) { lo } else { fallback.lo },
            hi: if good(hi, fallback.hi) { hi } else { fallback.hi },
        }
    }
}

impl Cell {
    /// Function of the isosurface without the operations that are decided in the cell; `None` if none are.
    pub fn pruned(&self) -> Option<&PrunedFormula> {
        self.pruned.as_deref()
    }
}

/// Block of an isosurface's cells: the first cell and the one beyond the last, along each axis.
type Block = [[usize; 2]; 3];

/// Function that receives the pieces of a ray through an isosurface's cells in order: both ends, and the cell, `None`
/// without surface. It returns true to stop.
pub type StopsAt<'a, 'c> = &'a mut dyn FnMut(f64, f64, Option<&'c Cell>) -> bool;

impl Cells {
    /// Finds the cells in which an isosurface's function can have the threshold's value.
    pub fn new(formula: &Formula, threshold: f64, bounds: Aabb) -> Self {
        let size = bounds.size().max(DVec3::splat(f64::MIN_POSITIVE));
        // Make cells nearly cubes.
        let mut side = fp::pow(size.x * size.y * size.z / COUNT, 1.0 / 3.0);
        side = side.max(size.max_element() / MOST);
        let count = [0, 1, 2].map(|axis| (size[axis] / side).round().clamp(1.0, MOST) as usize);
        let pruned = formula.can_be_pruned().then(PrunedFormulas::default);
        let surface = Surface { formula: formula.clone(), threshold, pruned };
        let mut grid = Grid::empty_grid(bounds, count);
        grid.collect_surface_cells(&surface, count.map(|n| [0, n]), &mut vec![]);
        Self { surface, grid }
    }

    /// Calls `stops_at` with the pieces of a ray in each cell of the isosurface, in order, until it returns true.
    /// Returns true if it did, or if the work is cancelled.
    pub fn any_piece<'c>(&'c self, ray: &Ray, from: f64, to: f64, stops_at: StopsAt<'_, 'c>) -> bool {
        self.any_piece_in_grid(&self.grid, HALVINGS, ray, (from, to), stops_at)
    }

    fn any_piece_in_grid<'c>(
        &'c self,
        grid: &'c Grid,
        halvings_left: u32,
        ray: &Ray,
        (from, to): (f64, f64),
        stops_at: StopsAt<'_, 'c>,
    ) -> bool {
        let o = (ray.origin - grid.bounds.min) * grid.scale;
        let d = ray.dir * grid.scale;
        let inverse = d.recip();
        let start = o + d * from;
        let cell_of = |axis: usize| (start[axis].max(0.0) as usize).min(grid.count[axis] - 1);
        let mut cell = [cell_of(0), cell_of(1), cell_of(2)];
        let end_of = |axis: usize, i: usize| match d[axis] {
            0.0 => f64::INFINITY,
            v => ((i + usize::from(v > 0.0)) as f64 - o[axis]) * inverse[axis],
        };
        let mut ends = [end_of(0, cell[0]), end_of(1, cell[1]), end_of(2, cell[2])];
        let mut t = from;
        while !cancel::is_cancelled() {
            let axis = if ends[0] <= ends[1] { 0 } else { 1 };
            let axis = if ends[axis] <= ends[2] { axis } else { 2 };
            let next = ends[axis].min(to).max(t);
            let ended = match grid.cell_at(cell) {
                None => stops_at(t, next, None),
                Some(inner) if halvings_left == 0 || inner.gradient.is_known => stops_at(t, next, Some(inner)),
                Some(inner) => match self.eight_parts_if_useful(grid, cell, inner) {
                    Some(finer) => self.any_piece_in_grid(finer, halvings_left - 1, ray, (t, next), stops_at),
                    None => stops_at(t, next, Some(inner)),
                },
            };
            if ended {
                return true;
            }
            let moved = if d[axis] > 0.0 { cell[axis] + 1 } else { cell[axis].wrapping_sub(1) };
            if ends[axis] >= to || moved >= grid.count[axis] {
                return false;
            }
            cell[axis] = moved;
            ends[axis] = end_of(axis, moved);
            t = next;
        }
        true
    }

    /// Returns the eight parts of an isosurface's cell; `None` if all of them hold surface and none has bounds.
    fn eight_parts_if_useful<'a>(&self, grid: &Grid, cell: [usize; 3], inner: &'a Cell) -> Option<&'a Grid> {
        let halves = inner.halves.get_or_init(|| {
            let mut eight = Grid::empty_grid(grid.block_bounds(cell.map(|i| [i, i + 1])), [2; 3]);
            eight.collect_surface_cells(&self.surface, [[0, 2]; 3], &mut vec![]);
            let better = eight.cells.len() < 8 || eight.cells.iter().any(|cell| cell.gradient.is_known);
            better.then(|| Box::new(eight))
        });
        halves.as_deref()
    }

    /// Number of different pruned functions of the isosurface's cells.
    #[cfg(test)]
    pub fn pruned_count(&self) -> usize {
        self.surface.pruned.as_ref().map_or(0, PrunedFormulas::len)
    }

    /// Length of the diagonal of an isosurface's cell.
    pub fn cell_diagonal(&self) -> f64 {
        self.grid.scale.recip().length()
    }
}

impl Grid {
    fn empty_grid(bounds: Aabb, count: [usize; 3]) -> Self {
        let size = bounds.size().max(DVec3::splat(f64::MIN_POSITIVE));
        let scale = DVec3::from_array(count.map(|n| n as f64)) / size;
        let places = vec![0; count[0] * count[1] * count[2]].into();
        Self { bounds, count, scale, places, cells: vec![] }
    }

    fn block_bounds(&self, block: Block) -> Aabb {
        let corner = |end: usize| {
            let at = |axis: usize| match block[axis][end] {
                n if n == self.count[axis] => self.bounds.max[axis],
                n => self.bounds.min[axis] + n as f64 / self.scale[axis],
            };
            DVec3::new(at(0), at(1), at(2))
        };
        Aabb { min: corner(0), max: corner(1) }
    }

    fn collect_surface_cells(&mut self, surface: &Surface, block: Block, scratch: &mut Vec<Slope>) {
        let b = self.block_bounds(block);
        let b = b.grown(1e-9 * b.size().max_element());
        let slope = surface.formula.value_and_slope_in(&b, scratch);
        if !slope.value.widened_by_rounding().contains(surface.threshold) {
            return;
        }
        let (axis, length) =
            (0..3).map(|axis| (axis, block[axis][1] - block[axis][0])).max_by_key(|x| x.1).unwrap_or((0, 1));
        if length == 1 {
            let pruned = surface.pruned.as_ref().and_then(|all| all.prune(&surface.formula, b, scratch));
            self.cells.push(Cell { gradient: Gradient::new(&slope), pruned, halves: OnceLock::new() });
            let place = self.cell_index(block.map(|b| b[0]));
            self.places[place] = self.cells.len() as u16;
            return;
        }
        let middle = block[axis][0] + length / 2;
        let (mut lower, mut upper) = (block, block);
        (lower[axis][1], upper[axis][0]) = (middle, middle);
        self.collect_surface_cells(surface, lower, scratch);
        self.collect_surface_cells(surface, upper, scratch);
    }

    fn cell_index(&self, cell: [usize; 3]) -> usize {
        (cell[2] * self.count[1] + cell[1]) * self.count[0] + cell[0]
    }

    /// Returns the cell at a position of the isosurface's grid; `None` if there is no surface in it.
    fn cell_at(&self, cell: [usize; 3]) -> Option<&Cell> {
        self.cells.get((self.places[self.cell_index(cell)] as usize).wrapping_sub(1))
    }
}
