//! Functions of an isosurface's cells: the isosurface's function without the operations that are decided in a cell.

use super::cells::Cell;
use crate::function::{Replacements, Slope};
use crate::math::{Aabb, Ray};
use crate::shape::formula::Formula;
use rustc_hash::FxHashMap;
use std::sync::{Mutex, PoisonError};

/// Maximum number of different pruned functions of an isosurface; further cells use the whole function.
const MOST: usize = 500;
/// Cost that pruning must save: a pruned function needs a test whether the point is in its box.
const LEAST_GAIN: usize = 2;

/// Isosurface's function in a box, without the operations that are decided there.
#[derive(Debug)]
pub struct PrunedFormula {
    /// Box in which the pruned function gives the same bits as the whole one.
    bounds: Aabb,
    formula: Formula,
}

/// Pruned functions of an isosurface's cells; cells with the same decisions share one.
#[derive(Debug, Default)]
pub struct PrunedFormulas {
    /// Pruned function for each set of decisions; `None` if it is hardly shorter.
    known: Mutex<FxHashMap<Replacements, Option<Formula>>>,
}

impl PrunedFormulas {
    /// Returns the function without the operations that are decided in a box; `None` if that saves nothing. `scratch`
    /// has the slopes of the function's operations in the same box.
    pub fn prune(&self, whole: &Formula, bounds: Aabb, scratch: &[Slope]) -> Option<Box<PrunedFormula>> {
        let replacements = whole.find_replacements(&bounds, scratch);
        if replacements.is_empty() {
            return None;
        }
        let mut known = self.known.lock().unwrap_or_else(PoisonError::into_inner);
        if known.len() >= MOST && !known.contains_key(&replacements) {
            return None;
        }
        let formula = known.entry(replacements).or_insert_with_key(|replacements| {
            whole.pruned(replacements).filter(|pruned| pruned.cost() + LEAST_GAIN <= whole.cost())
        });
        formula.clone().map(|formula| Box::new(PrunedFormula { bounds, formula }))
    }

    /// Number of different pruned functions.
    #[cfg(test)]
    pub fn len(&self) -> usize {
        self.known.lock().unwrap_or_else(PoisonError::into_inner).len()
    }
}

/// Function of an isosurface along a ray. Points in the current cell are evaluated by the cell's pruned function.
pub struct RayFunction<'a> {
    ray: &'a Ray,
    whole: &'a Formula,
    current: std::cell::Cell<Option<&'a PrunedFormula>>,
}

impl<'a> RayFunction<'a> {
    /// Creates the function along a ray, without a current cell.
    pub fn new(whole: &'a Formula, ray: &'a Ray) -> Self {
        Self { ray, whole, current: std::cell::Cell::new(None) }
    }

    /// Ray along which the function is evaluated.
    pub fn ray(&self) -> &'a Ray {
        self.ray
    }

    /// Sets the cell whose pruned function is used in its box.
    pub fn enter_cell(&self, cell: Option<&'a Cell>) {
        self.current.set(cell.and_then(Cell::pruned));
    }

    /// Value of the isosurface's function at a position on the ray.
    #[inline]
    pub fn value_at(&self, t: f64) -> f64 {
        let p = self.ray.at(t);
        // Points that rounding moves out of the cell are evaluated by the whole function.
        let formula = match self.current.get() {
            Some(pruned) if pruned.bounds.contains(p) => &pruned.formula,
            _ => self.whole,
        };
        formula.value_at(p)
    }
}
