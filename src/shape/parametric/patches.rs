//! A parametric surface in patches with bounds of their points and derivatives, and the intersection of a ray with a
//! patch (after Toth, "On Ray Tracing Parametric Surfaces", 1985: Newton's method where interval arithmetic proves
//! convergence, subdivision elsewhere).

use super::Parametric;
use crate::function::Slope;
use crate::math::bvh::{self, Bvh};
use crate::math::cancel;
use crate::math::{Aabb, DVec2, DVec3, Range, Ray};
use std::cell::Cell;
use std::ops::ControlFlow;

/// Divisor of the container's longest side: a parametric surface is subdivided until each patch is smaller than the
/// quotient.
const PARTS: f64 = 24.0;
/// Maximum number of times that a parametric surface is halved into the patches of the hierarchy, before any ray is
/// traced.
const DEPTH: u32 = 13;
/// Maximum number of times that a patch of the hierarchy is halved again during the search for a ray's hits in it.
const MORE: u32 = 24;

/// Patches of a parametric surface, with a hierarchy of their boxes.
#[derive(Debug)]
pub struct Patches {
    bvh: Bvh,
    patches: Vec<Patch>,
}

/// Patch of a parametric surface: bounds of the points for u and v between two corners.
#[derive(Clone, Copy, Debug)]
struct Patch {
    from: DVec2,
    to: DVec2,
    bounds: Aabb,
    /// Point of the patch and derivatives at its centre, and the maximum deviation of the derivatives in the patch from
    /// those, in each coordinate.
    middle: DVec3,
    by: [DVec3; 2],
    off: [DVec3; 2],
}

impl Patch {
    fn new(of: &Parametric, from: DVec2, to: DVec2, scratch: &mut Vec<Slope>) -> Self {
        let uv = (from + to) * 0.5;
        let middle = of.point_at(uv);
        let half = (to - from) * 0.5;
        let (mut bounds, mut by, mut off) = (Aabb::INFINITE, [DVec3::ZERO; 2], [DVec3::ZERO; 2]);
        let wanted = Aabb { min: from.extend(0.0), max: to.extend(0.0) };
        for (axis, function) in of.functions.iter().enumerate() {
            let slope = function.value_and_slope_in(&wanted, scratch);
            let mut reach = 0.0;
            for side in 0..2 {
                let unit = [DVec3::X, DVec3::Y][side];
                let rate = slope.derivative_along(unit);
                let known = rate.lo.is_finite() && rate.hi.is_finite();
                let (lo, hi) = if known { (rate.lo, rate.hi) } else { (-of.max_gradient, of.max_gradient) };
                by[side][axis] = 0.5 * (lo + hi);
                off[side][axis] = 0.5 * (hi - lo);
                reach += half[side] * lo.abs().max(hi.abs());
            }
            // Intersect the bounds by the values and by the centre's value with its maximum change.
            bounds.min[axis] = slope.value.lo.max(middle[axis] - reach);
            bounds.max[axis] = slope.value.hi.min(middle[axis] + reach);
        }
        let size = 1e-12 * (1.0 + bounds.size().max_element());
        Self { from, to, bounds: bounds.grown(size), middle, by, off }
    }

    /// Halves the parametric surface's patch along the side on which points are farther apart.
    fn halve(&self, of: &Parametric, scratch: &mut Vec<Slope>) -> [Self; 2] {
        let size = self.to - self.from;
        let length = |side: usize| (self.by[side].abs() + self.off[side]).length() * size[side];
        let side = usize::from(length(1) > length(0));
        let middle = 0.5 * (self.from[side] + self.to[side]);
        let (mut to, mut from) = (self.to, self.from);
        (to[side], from[side]) = (middle, middle);
        [Self::new(of, self.from, to, scratch), Self::new(of, from, self.to, scratch)]
    }
}

/// A ray that is searched for hits on a parametric surface, with two directions perpendicular to it.
struct Line<'a> {
    of: &'a Parametric,
    ray: &'a Ray,
    /// Two directions perpendicular to the ray.
    across: [DVec3; 2],
    range: Range,
    /// Distance along the ray up to which hits still count.
    far: Cell<f64>,
    /// True if only the nearest hit of the ray counts.
    nearest: bool,
    /// Size of a parametric surface's patches that are not subdivided.
    smallest: f64,
}

/// Result of the convergence test for a ray and a parametric surface's patch.
enum Verdict {
    Misses,
    Meets(DVec2),
    Open,
}

impl Patches {
    /// Subdivides a parametric surface into patches within its container.
    pub fn new(of: &Parametric) -> Self {
        let mut scratch = vec![];
        let container = of.container.bounds();
        let largest = container.size().max_element() / PARTS;
        let mut patches = vec![];
        let mut open = vec![(Patch::new(of, of.from, of.to, &mut scratch), 0)];
        while let Some((patch, depth)) = open.pop().filter(|_| !cancel::is_cancelled()) {
            if patch.bounds.intersection(container).is_empty() || patch.middle.is_nan() && depth == DEPTH {
                continue;
            }
            let size = patch.bounds.size().max_element();
            if depth == DEPTH || size < largest && patch.relative_bend() < 0.3 {
                patches.push(Patch { bounds: patch.bounds.intersection(container), ..patch });
                continue;
            }
            open.extend(patch.halve(of, &mut scratch).map(|half| (half, depth + 1)));
        }
        patches.retain(|patch| bvh::fits_single_precision(&patch.bounds));
        let (bvh, order) = Bvh::build(patches.iter().map(|patch| patch.bounds));
        let patches = order.into_iter().map(|i| patches[i as usize]).collect();
        Self { bvh, patches }
    }

    /// Calls `found` with the hits of a ray on the parametric surface in any order; with `only_nearer`, each that is nearer
    /// than all before.
    pub fn visit_hits(
        &self,
        of: &Parametric,
        ray: &Ray,
        range: Range,
        only_nearer: bool,
        found: &mut dyn FnMut(f64, DVec2),
    ) {
        let first = ray.dir.normalize_or_zero().any_orthogonal_vector().normalize_or_zero();
        let across = [first, ray.dir.cross(first).normalize_or_zero()];
        let smallest = (0.25 * of.accuracy).max(5e-5 * of.container.bounds().size().max_element());
        let line = Line { of, ray, across, range, far: Cell::new(range.max), nearest: only_nearer, smallest };
        let mut scratch = vec![];
        self.bvh.traverse(ray, range, |i, _| {
            line.visit_hits(&self.patches[i], MORE, &mut scratch, found);
            ControlFlow::Continue(line.far.get())
        });
    }
}

impl Patch {
    /// Relative change of the surface's derivatives within the patch.
    fn relative_bend(&self) -> f64 {
        let part = |side: usize| self.off[side].length() / self.by[side].length();
        part(0).max(part(1))
    }
}

impl Line<'_> {
    /// Calls `found` with the ray's hits in a patch, which is halved at most `halvings_left` times; the centre of a
    /// patch that is still undecided is reported as a hit.
    fn visit_hits(
        &self,
        patch: &Patch,
        halvings_left: u32,
        scratch: &mut Vec<Slope>,
        found: &mut dyn FnMut(f64, DVec2),
    ) {
        if patch.bounds.slabs(self.ray, Range { max: self.far.get(), ..self.range }).is_none() {
            return;
        }
        match self.test_convergence(patch) {
            Verdict::Misses => {}
            Verdict::Meets(uv) => self.report_hit(self.of.point_at(uv), uv, found),
            Verdict::Open if halvings_left == 0 || patch.bounds.size().max_element() < self.smallest => {
                self.report_hit(patch.middle, (patch.from + patch.to) * 0.5, found);
            }
            Verdict::Open if cancel::is_cancelled() => {}
            Verdict::Open => {
                for half in patch.halve(self.of, scratch) {
                    self.visit_hits(&half, halvings_left - 1, scratch, found);
                }
            }
        }
    }

    /// Calls `found` with the hit at a point of the parametric surface, unless the point is outside the container or
    /// the range.
    fn report_hit(&self, p: DVec3, uv: DVec2, found: &mut dyn FnMut(f64, DVec2)) {
        let t = (p - self.ray.origin).dot(self.ray.dir) / self.ray.dir.length_squared();
        if p.is_finite() && self.of.container.contains(p) && self.range.contains(t) && t < self.far.get() {
            found(t, uv);
            if self.nearest {
                self.far.set(t);
            }
        }
    }

    /// Coordinates of a point along the two directions perpendicular to the ray.
    fn coordinates_across_ray(&self, p: DVec3) -> DVec2 {
        DVec2::new(self.across[0].dot(p), self.across[1].dot(p))
    }

    /// Tests whether a search of the patch for the ray's hit converges: with Y the inverse of the derivatives at the
    /// centre, x - Y·F(x) reduces the distance from a root by the factor by which Y·F' differs from 1.
    fn test_convergence(&self, patch: &Patch) -> Verdict {
        let (a, b) = (self.coordinates_across_ray(patch.by[0]), self.coordinates_across_ray(patch.by[1]));
        let det = a.perp_dot(b);
        let half = (patch.to - patch.from) * 0.5;
        // Rows of Y, in units of the patch's half sides.
        let y0 = DVec2::new(b.y, -b.x) / (det * half.x);
        let y1 = DVec2::new(-a.y, a.x) / (det * half.y);
        let spread = |i: usize| {
            let c = self.across.map(|n| n.abs().dot(patch.off[i]) * half[i]);
            DVec2::from_array(c)
        };
        let (s0, s1) = (spread(0), spread(1));
        let row = |y: DVec2| y.abs().dot(s0) + y.abs().dot(s1);
        let (q0, q1) = (row(y0), row(y1));
        if !(q0 < 1e3 && q1 < 1e3) {
            return Verdict::Open;
        }
        let miss = self.coordinates_across_ray(patch.middle - self.ray.origin);
        let step = DVec2::new(y0.dot(miss), y1.dot(miss));
        // A root x of the patch is within q of -step.
        if !(step.x.abs() <= 1.0 + q0 + 1e-9 && step.y.abs() <= 1.0 + q1 + 1e-9) {
            return Verdict::Misses;
        }
        if q0.max(q1) > 0.7 {
            return Verdict::Open;
        }
        self.iterate_to_root(patch, [y0 * half.x, y1 * half.y], half)
    }

    /// Iterates until the root in the patch is found or excluded, at most 60 times.
    fn iterate_to_root(&self, patch: &Patch, inverse_jacobian: [DVec2; 2], half: DVec2) -> Verdict {
        let middle = (patch.from + patch.to) * 0.5;
        let mut uv = middle;
        for _ in 0..60 {
            let miss = self.coordinates_across_ray(self.of.point_at(uv) - self.ray.origin);
            let step = DVec2::new(inverse_jacobian[0].dot(miss), inverse_jacobian[1].dot(miss));
            let next = (uv - step).clamp(patch.from - half * 1e-6, patch.to + half * 1e-6);
            let moved = ((next - uv) / half).abs().max_element();
            uv = next;
            if moved < 1e-12 {
                // At an edge beyond which the iteration would go, there is no root in this patch.
                let rest = (step / half).abs().max_element();
                return if rest < 1e-7 { Verdict::Meets(uv.clamp(patch.from, patch.to)) } else { Verdict::Misses };
            }
        }
        Verdict::Open
    }
}
