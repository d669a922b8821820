//! `isosurface { function { … } … }`: all points where a function of x, y and z has one value.
//!
//! Inside, the function is less than `threshold`. It ends at `contained_by`, a box or a sphere: where the solid reaches out of that, its face
//! closes it, unless `open` is said. A ray meets it up to `accuracy` behind where it is, as in POV-Ray. durer bounds the function and its
//! gradient by interval arithmetic, and so needs no `max_gradient`; only for functions that nothing is known of (patterns, pigments, splines,
//! most of those behind `functions.inc`) it searches by that, as POV-Ray always does, and a value that is too small makes holes.
//!
//! ```pov
//! isosurface {
//!   function { x*x + y*y + z*z - 1 + 0.3*sin(8*x)*sin(8*y)*sin(8*z) } contained_by { sphere { 0, 1.2 } }
//!   max_gradient 4 pigment { color rgb <0.9, 0.6, 0.2> }
//! }
//! ```

mod cells;
mod pruned;
mod search;
mod walk;

use super::formula::{self, Container, Formula};
use super::{Hit, Hits, Kernel, Quirks, check_finite};
use crate::diagnostic::{Diagnostic, Result, codes};
use crate::function::Interval;
use crate::math::{Aabb, DVec3, Range, Ray, tolerance};
use crate::source::Span;
use crate::value::words::{Row, read_row, set, specs, word};
use crate::value::{Next, Param, Readable, Reader, Spec, ValueKind};
use cells::{Cell, Cells};
use pruned::RayFunction;
use search::Search;
use serde::Serialize;
use std::sync::{Arc, OnceLock};
use walk::Walk;

const SURFACE: u32 = 0;
const FACE: u32 = 1;
/// Lower limits of an isosurface's `accuracy`, relative to a cell's diagonal: with known and with unknown gradient.
/// They bound the number of pieces in a cell, however steep the function is.
const FINEST: f64 = 1e-5;
const COARSEST: f64 = 1e-3;
/// Distance to the isosurface's container below which a ray starts inside it (quirk: `isosurface_start`).
const BEGINS: f64 = 1e-6;
/// Number of points along each side of the isosurface's container at which the gradient is sampled.
const POINTS: usize = 12;
/// Factor by which the isosurface's sampled gradient must exceed `max_gradient` to be reported.
const STEEPER: f64 = 1.5;

/// Isosurface: the points at which a function equals a threshold.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Isosurface {
    /// Function of x, y and z that defines the isosurface.
    pub function: Formula,
    /// Value of the function on the isosurface; smaller values are inside.
    pub threshold: f64,
    /// Solid that bounds the isosurface.
    pub container: Container,
    /// True if the isosurface has no faces on its container.
    pub open: bool,
    /// Maximum distance of a hit behind the isosurface, and the step of differences for normals.
    pub accuracy: f64,
    /// Maximum gradient of the isosurface's function, where it has no computed bounds.
    pub max_gradient: f64,
    /// Maximum number of hits of one ray on an isosurface in CSG.
    pub max_trace: u32,
    /// True for `evaluate`, which adapts `max_gradient` in POV-Ray.
    pub adapts: bool,
    #[serde(skip)]
    cells: Lazy,
}

/// Cells of the isosurface, built when the first ray arrives.
#[derive(Clone, Debug, Default)]
struct Lazy(Arc<OnceLock<Cells>>);

impl PartialEq for Lazy {
    fn eq(&self, _: &Self) -> bool {
        true
    }
}

impl Isosurface {
    /// Creates an isosurface with POV-Ray's defaults.
    pub fn new(function: Formula) -> Self {
        Self {
            function,
            threshold: 0.0,
            container: Container::default(),
            open: false,
            accuracy: 0.001,
            max_gradient: 1.1,
            max_trace: 1,
            adapts: false,
            cells: Lazy::default(),
        }
    }

    fn cells(&self) -> &Cells {
        self.cells.0.get_or_init(|| Cells::new(&self.function, self.threshold, self.container.bounds()))
    }

    /// Value of the isosurface's function minus the threshold: negative inside. NaN counts as outside.
    fn above_threshold(&self, value: f64) -> f64 {
        let value = value - self.threshold;
        if value.is_nan() { self.accuracy * self.max_gradient } else { value }
    }

    /// Calls `stops_at` with each hit of a ray on the isosurface in the range, ascending, until it returns true.
    fn search_hits(&self, ray: &Ray, range: Range, stops_at: &mut dyn FnMut(Hit) -> bool) {
        let Some((enter, leave)) = self.container.interval_inside(ray) else { return };
        if !(enter < range.max && leave > range.min) {
            return;
        }
        // Start where the ray enters the container, so that a distant eye costs no digits.
        let near = Ray::new(ray.at(enter), ray.dir);
        let mut report_hit = |t: f64, part: u32| range.contains(t + enter) && stops_at(Hit::on_piece(t + enter, part));
        let function = RayFunction::new(&self.function, &near);
        let value = |t: f64| self.above_threshold(function.value_at(t));
        let to = leave - enter;
        let origin_t = -enter;
        let begins_outside = enter > BEGINS;
        // (The value behind the ray is not needed.)
        let first = (begins_outside || range.min <= enter).then(|| value(0.0));
        let is_solid = first.is_some_and(|first| first < 0.0);
        if range.min <= enter && !self.open && is_solid && report_hit(0.0, FACE) {
            return;
        }
        let mut walk = match begins_outside {
            true => Walk::entering_container(&value, is_solid, self.open, to, self.accuracy),
            false => Walk::starting_in_container(&value, origin_t, to, self.accuracy, self.max_gradient),
        };
        let from = walk.as_ref().map_or(f64::INFINITY, Walk::search_start);
        let within = Range { min: from.min(range.min - enter), max: range.max - enter };
        // Roots behind the ray's origin are reported unchanged.
        let mut report_root = |t: f64| match &mut walk {
            _ if t <= origin_t => report_hit(t, SURFACE),
            Some(walk) => walk.povray_hit(t).is_some_and(|t| report_hit(t, SURFACE)),
            None => false,
        };
        let first = first.map(|first| (0.0, first));
        if self.any_root_in_cells(&function, (origin_t, to), within, first, &mut report_root) {
            return;
        }
        let leaves = walk.is_some() || to <= origin_t;
        if !self.open && leave < range.max && leaves && value(to) < 0.0 {
            report_hit(to, FACE);
        }
    }

    /// Searches the isosurface's cells between 0 and `to` that overlap the range `within`; returns true if `stops_at`,
    /// which receives the roots, did. All positions are those on the function's ray, which starts at the container;
    /// `origin_t` is that of the original ray's origin. `known_t_and_value` is a point with its value, which does not
    /// depend on the cell. Pieces start where cells do, so that roots hardly depend on the range.
    fn any_root_in_cells<'a>(
        &'a self,
        function: &RayFunction<'a>,
        (origin_t, to): (f64, f64),
        within: Range,
        mut known_t_and_value: Option<(f64, f64)>,
        stops_at: &mut dyn FnMut(f64) -> bool,
    ) -> bool {
        let value = &|t: f64| self.above_threshold(function.value_at(t));
        let near = function.ray();
        let cells = self.cells();
        let length = near.dir.length();
        let unknown = self.max_gradient * length;
        let unknown = Interval { lo: -unknown, hi: unknown };
        // The number of steps grows with the gradient.
        let apart = |exact: f64, least: f64| exact.max(cells.cell_diagonal() * least / length);
        let (fine, coarse) = (apart(0.25 * self.accuracy, FINEST), apart(self.accuracy, COARSEST));
        let exact = 1e-10 * cells.cell_diagonal() / length;
        let roughly = exact.max(self.accuracy * walk::ROOTS);
        let mut piece = |(a, b): (f64, f64), rate: Interval, apart: f64, cell: Option<&'a Cell>| {
            function.enter_cell(cell);
            let first = known_t_and_value.filter(|known| known.0 == a).unwrap_or_else(|| (a, value(a)));
            let last = (b, value(b));
            known_t_and_value = Some(last);
            Search { value, apart, exact, roughly, ahead: origin_t, range: within }
                .any_root_between(first, last, rate, stops_at)
        };
        // Consecutive cells without bounds are searched as one piece.
        let mut run: Option<(f64, f64)> = None;
        let ended = cells.any_piece(near, 0.0, to, &mut |a, b, cell| {
            if a > within.max && run.is_none() {
                return true;
            }
            if b <= within.min {
                return false;
            }
            let rate = cell.map(|cell| cell.gradient.derivative_along(near.dir, length, unknown));
            if rate.is_some_and(|rate| rate.lo == unknown.lo || rate.hi == unknown.hi) {
                run = Some((run.map_or(a, |run| run.0), b));
                return false;
            }
            run.take().is_some_and(|run| piece(run, unknown, coarse, None))
                || rate.is_some_and(|rate| piece((a, b), rate, fine, cell))
        });
        ended || run.is_some_and(|run| piece(run, unknown, coarse, None))
    }

    /// Returns the maximum gradient found near the isosurface: where the value changes its sign between two points of a
    /// lattice.
    fn sampled_max_gradient(&self) -> f64 {
        let b = self.container.bounds();
        let step = b.size() / POINTS as f64;
        let at = |i: usize, j: usize, k: usize| b.min + step * (DVec3::new(i as f64, j as f64, k as f64) + 0.5);
        let row = |j: usize, k: usize| (0..POINTS).map(move |i| at(i, j, k));
        let mut found = 0.0;
        for (j, k) in (0..POINTS).flat_map(|k| (0..POINTS).map(move |j| (j, k))) {
            let mut before = f64::NAN;
            for p in row(j, k) {
                let value = self.function.value_at(p) - self.threshold;
                if before * value < 0.0 && self.container.contains(p) {
                    let slant = self.gradient_by_differences(p - DVec3::X * (0.5 * step.x), 1e-4 * step.x).length();
                    found = if slant > found { slant } else { found };
                }
                before = value;
            }
        }
        found
    }

    /// Gradient of the isosurface's function by differences over a step (quirk: `isosurface_normal`).
    fn gradient_by_differences(&self, p: DVec3, step: f64) -> DVec3 {
        let here = self.function.value_at(p);
        let rise = |axis: DVec3| self.function.value_at(p + axis * step) - here;
        DVec3::new(rise(DVec3::X), rise(DVec3::Y), rise(DVec3::Z)) / step
    }
}

impl Readable for Isosurface {
    const SPEC: Spec = Spec {
        name: "isosurface",
        summary: "all points where a function of x, y and z has one value",
        params: &[Param {
            name: "function { … }",
            kind: ValueKind::Block,
            summary: "a function of x, y and z; less than the threshold inside",
        }],
        words: &crate::value::words::joined::<8>(
            &[word("contained_by", ValueKind::Block, "box { -1, 1 }", "a box or a sphere in braces, at which it ends")],
            specs!(Self::WORDS),
        ),
        ..Spec::EMPTY
    };

    const WORDS: &'static [Row<Self>] = &[
        word("threshold", ValueKind::Float, "0", "the function's value on the surface")
            .sets(|s, r| set(&mut s.threshold, r.float())),
        word("open", ValueKind::Flag, "off", "it has no faces where it reaches out of its container")
            .sets(|s, r| set(&mut s.open, r.flag())),
        word(
            "accuracy",
            ValueKind::Float,
            "0.001",
            "how far behind the surface it is met, in units of the world, and how long the steps that find normals",
        )
        .sets(|s, r| set(&mut s.accuracy, formula::read_default_unless_positive(r, "accuracy", 0.001))),
        word("max_gradient", ValueKind::Float, "1.1", "how steep the function is, where durer can't know it")
            .sets(|s, r| set(&mut s.max_gradient, formula::read_default_unless_positive(r, "max_gradient", 1.1))),
        word(
            "evaluate",
            ValueKind::Float,
            "",
            "three numbers, by which POV-Ray adapts `max_gradient`: the first, times the second, stands for it",
        )
        .sets(|s, r| {
            let (least, factor, _) = (r.float()?, r.float()?, r.float()?);
            s.adapts = true;
            s.max_gradient = (least * factor).abs().max(f64::MIN_POSITIVE);
            Ok(())
        }),
        word("max_trace", ValueKind::Float, "1", "how many hits of one ray count in CSG and for what is clipped").sets(
            |s, r| {
                set(
                    &mut s.max_trace,
                    formula::read_default_unless_positive(r, "max_trace", 1.0).map(|n| (n as u32).max(1)),
                )
            },
        ),
        word("all_intersections", ValueKind::Nothing, "", "all hits of a ray count")
            .sets(|s, _| set(&mut s.max_trace, Ok(u32::MAX))),
    ];

    fn read(r: &mut dyn Reader) -> Result<Self> {
        Formula::read(r, "x, y and z").map(Self::new)
    }

    fn read_own(&mut self, next: Next, r: &mut dyn Reader) -> Result<bool> {
        if next == Next::Block("contained_by") {
            self.container = Container::read(r)?;
            return Ok(true);
        }
        read_row(Self::WORDS, self, next, r)
    }

    fn complete_and_check(&mut self, span: Span, r: &mut dyn Reader) -> Result<()> {
        let b = self.container.bounds();
        check_finite(span, &[b.min, b.max], &[self.threshold, self.max_gradient, self.accuracy])?;
        let found = if self.adapts { 0.0 } else { self.sampled_max_gradient() };
        if found > STEEPER * self.max_gradient {
            let (said, found) = (self.max_gradient, (found * 100.0).ceil() / 100.0);
            let message = format!("this `isosurface` has a gradient of {found} and more, its `max_gradient` is {said}");
            let help = format!("POV-Ray will show holes; write `max_gradient {found}`");
            r.report(Diagnostic::new(codes::TOO_STEEP, span, message).help(help));
        }
        Ok(())
    }
}

impl Kernel for Isosurface {
    const QUIRKS: Quirks = Quirks { hits_depend_on_origin: true, ..Quirks::NONE };

    fn bounds(&self) -> Aabb {
        self.container.bounds()
    }

    fn hits(&self, ray: &Ray, range: Range, out: &mut Hits) {
        self.search_hits(ray, range, &mut |hit| {
            out.push(hit);
            false
        });
    }

    /// Appends the first `max_trace` hits on the isosurface in front of the ray's origin, and all behind it.
    fn limited_hits_for_csg(&self, ray: &Ray, range: Range, out: &mut Hits) {
        if self.max_trace == u32::MAX {
            return self.hits(ray, range, out);
        }
        let mut seen = 0;
        let counted = Range { min: range.min.min(tolerance::SURFACE), max: range.max };
        self.search_hits(ray, counted, &mut |hit| {
            if range.contains(hit.t) {
                out.push(hit);
            }
            seen += u32::from(hit.t > tolerance::SURFACE);
            seen >= self.max_trace
        });
    }

    fn closest(&self, ray: &Ray, range: Range) -> Option<Hit> {
        let mut first = None;
        self.search_hits(ray, range, &mut |hit| {
            first = Some(hit);
            true
        });
        first
    }

    fn inside(&self, p: DVec3) -> bool {
        self.container.contains(p) && self.function.value_at(p) < self.threshold
    }

    fn normal(&self, p: DVec3, hit: &Hit) -> DVec3 {
        if hit.part == FACE {
            return self.container.normal(p);
        }
        let n = self.gradient_by_differences(p, self.accuracy);
        if n.is_finite() && n != DVec3::ZERO {
            return n;
        }
        let n = self.gradient_by_differences(p, 1e-3 * self.accuracy);
        if n.is_finite() && n != DVec3::ZERO { n } else { DVec3::Y }
    }

    fn has_uv_mapping(&self) -> bool {
        false
    }

    fn caches_lazily(&self) -> bool {
        true
    }
}

#[cfg(test)]
mod tests;
