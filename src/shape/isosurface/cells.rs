//! The container of an isosurface in cells, with bounds of the function's gradient in each cell that may hold a piece of the surface.

use crate::function::{Interval, Slope};
use crate::math::{Aabb, DVec3, Ray, fp};
use crate::shape::formula::Formula;

/// About so many cells.
const COUNT: f64 = 5000.0;
/// And no more than these along an axis.
const MOST: f64 = 64.0;

/// See above.
#[derive(Debug)]
pub struct Cells {
    bounds: Aabb,
    count: [usize; 3],
    /// Cells per unit.
    scale: DVec3,
    /// One more than the number of a cell's slope; 0 where there is no surface.
    places: Box<[u16]>,
    slopes: Vec<Gradient>,
}

/// Where the function's gradient lies in a cell; see [`Slope`].
#[derive(Clone, Copy, Debug)]
pub struct Gradient {
    by: [[f32; 2]; 3],
    around: f32,
}

impl Gradient {
    fn new(slope: &Slope) -> Self {
        // (Wider than that, because of rounding.)
        let wider = |i: Interval| [(i.lo - i.lo.abs() * 1e-6) as f32, (i.hi + i.hi.abs() * 1e-6) as f32];
        Self { by: slope.by.map(wider), around: (slope.around * 1.000_001) as f32 }
    }

    /// Bounds of the derivative along a direction of length `length`; `unknown` where there are none.
    pub fn along(&self, d: DVec3, length: f64, unknown: Interval) -> Interval {
        let far = f64::from(self.around) * length;
        let (mut lo, mut hi) = (-far, far);
        for axis in 0..3 {
            let [a, b] = self.by[axis].map(|by| if d[axis] == 0.0 { 0.0 } else { f64::from(by) * d[axis] });
            lo += a.min(b);
            hi += a.max(b);
        }
        Interval { lo: if lo.is_finite() { lo } else { unknown.lo }, hi: if hi.is_finite() { hi } else { unknown.hi } }
    }
}

/// Part of the whole: the first cell and the one behind the last, along each axis.
type Block = [[usize; 2]; 3];

impl Cells {
    /// Finds the cells in which the function may have this value.
    pub fn new(formula: &Formula, threshold: f64, bounds: Aabb) -> Self {
        let size = bounds.size().max(DVec3::splat(f64::MIN_POSITIVE));
        // Cells as near to cubes as may be.
        let mut side = fp::pow(size.x * size.y * size.z / COUNT, 1.0 / 3.0);
        side = side.max(size.max_element() / MOST);
        let count = [0, 1, 2].map(|axis| (size[axis] / side).round().clamp(1.0, MOST) as usize);
        let scale = DVec3::from_array(count.map(|n| n as f64)) / size;
        let places = vec![0; count[0] * count[1] * count[2]].into();
        let mut cells = Self { bounds, count, scale, places, slopes: vec![] };
        cells.sort_out(formula, threshold, count.map(|n| [0, n]), &mut vec![]);
        cells
    }

    fn sort_out(&mut self, formula: &Formula, threshold: f64, block: Block, room: &mut Vec<Slope>) {
        let corner = |end: usize| {
            let at = |axis: usize| match block[axis][end] {
                n if n == self.count[axis] => self.bounds.max[axis],
                n => self.bounds.min[axis] + n as f64 / self.scale[axis],
            };
            DVec3::new(at(0), at(1), at(2))
        };
        let b = Aabb { min: corner(0), max: corner(1) };
        let slope = formula.slope(&b.grown(1e-9 * b.size().max_element()), room);
        if !slope.value.widened().contains(threshold) {
            return;
        }
        let (axis, length) =
            (0..3).map(|axis| (axis, block[axis][1] - block[axis][0])).max_by_key(|x| x.1).unwrap_or((0, 1));
        if length == 1 {
            self.slopes.push(Gradient::new(&slope));
            let place = self.index(block.map(|b| b[0]));
            self.places[place] = self.slopes.len() as u16;
            return;
        }
        let middle = block[axis][0] + length / 2;
        let (mut lower, mut upper) = (block, block);
        (lower[axis][1], upper[axis][0]) = (middle, middle);
        self.sort_out(formula, threshold, lower, room);
        self.sort_out(formula, threshold, upper, room);
    }

    fn index(&self, cell: [usize; 3]) -> usize {
        (cell[2] * self.count[1] + cell[1]) * self.count[0] + cell[0]
    }

    /// Hands the pieces of a line in each cell to `visit`, in order, until it says that it has enough; `None` where there is no surface.
    pub fn pass(
        &self,
        ray: &Ray,
        from: f64,
        to: f64,
        visit: &mut dyn FnMut(f64, f64, Option<&Gradient>) -> bool,
    ) -> bool {
        let o = (ray.origin - self.bounds.min) * self.scale;
        let d = ray.dir * self.scale;
        let inverse = d.recip();
        let start = o + d * from;
        let mut cell = [0, 1, 2].map(|axis| (start[axis].max(0.0) as usize).min(self.count[axis] - 1));
        let end_of = |axis: usize, i: usize| match d[axis] {
            0.0 => f64::INFINITY,
            v => ((i + usize::from(v > 0.0)) as f64 - o[axis]) * inverse[axis],
        };
        let mut ends = [0, 1, 2].map(|axis| end_of(axis, cell[axis]));
        let mut t = from;
        loop {
            let axis = if ends[0] <= ends[1] { 0 } else { 1 };
            let axis = if ends[axis] <= ends[2] { axis } else { 2 };
            let next = ends[axis].min(to).max(t);
            let gradient = match self.places[self.index(cell)] {
                0 => None,
                n => Some(&self.slopes[n as usize - 1]),
            };
            if visit(t, next, gradient) {
                return true;
            }
            let moved = if d[axis] > 0.0 { cell[axis] + 1 } else { cell[axis].wrapping_sub(1) };
            if ends[axis] >= to || moved >= self.count[axis] {
                return false;
            }
            cell[axis] = moved;
            ends[axis] = end_of(axis, moved);
            t = next;
        }
    }

    /// The diagonal of a cell.
    pub fn side(&self) -> f64 {
        self.scale.recip().length()
    }
}
