//! `prism { bottom, top, number_of_points, points … }`: an outline in the x-z plane, swept along y.
//!
//! `linear_spline`, `quadratic_spline`, `cubic_spline` or `bezier_spline` before the numbers says how the points are
//! joined.
//! Each outline ends where its first point comes again; the next one may be a hole in it. `conic_sweep` makes the
//! outline as large as y is high, with the
//! tip at the origin. `open` leaves off both lids.
//!
//! ```pov
//! prism {
//!   cubic_spline 0, 1, 7, <0.5, -1.2>, <-1, -0.6>, <1, -0.8>, <0.6, 0.7>, <-0.8, 0.9>, <-1, -0.6>, <1, -0.8>
//!   rotate -x*70 translate y pigment { color rgb <0.9, 0.7, 0.2> }
//! }
//! ```

use super::spline::{Curve, Interpolation, KINDS, outlines_and_is_unclosed, read_points, warn_of_unclosed_outline};
use super::{Hit, Hits, Kernel, check_finite, nearest_hit, transformed_box};
use crate::diagnostic::{Diagnostic, Result, codes};
use crate::math::{Aabb, DVec2, DVec3, Range, Ray, Transform, bernstein_roots};
use crate::source::Span;
use crate::value::words::{Row, joined, specs, word};
use crate::value::{Param, Readable, Reader, ReaderExt, Spec, ValueKind, WordSpec};
use serde::Serialize;

/// Part number of a prism's lid; other parts are segments of the outline.
const LID: u32 = u32::MAX;

/// Prism: an outline that is swept along y.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Prism {
    /// Interpolation of the prism's outlines between their points.
    pub interpolation: Interpolation,
    /// True if the prism's outline grows with y from an apex at the origin.
    pub conic: bool,
    /// The y coordinate of the prism's lower end: the lesser of its two heights.
    pub bottom: f64,
    /// The y coordinate of the prism's upper end: the greater of its two heights.
    pub top: f64,
    /// Outlines of the prism, as x and z.
    pub outlines: Curve,
    /// True if the prism has no lids at its ends.
    pub open: bool,
    #[serde(skip)]
    unclosed: bool,
    /// Bounding rectangle of the prism's outlines.
    #[serde(skip)]
    ends: (DVec2, DVec2),
}

/// Margin of a prism's bounds, relative to a distance: far above rounding.
const MARGIN: f64 = 1e-6;

impl Prism {
    /// Creates a prism between two heights in any order. Outlines end where their first point is repeated.
    pub fn new(interpolation: Interpolation, conic: bool, heights: [f64; 2], points: &[DVec2], open: bool) -> Self {
        let (outlines, unclosed) = outlines_and_is_unclosed(interpolation, points);
        let (bottom, top) = (heights[0].min(heights[1]), heights[0].max(heights[1]));
        let ends = outlines.curve_bounds();
        Self { interpolation, conic, bottom, top, outlines, open, unclosed, ends }
    }

    /// Scale of the prism's outline at a height.
    fn outline_scale(&self, y: f64) -> f64 {
        if self.conic { y } else { 1.0 }
    }

    fn outline_contains(&self, p: DVec3) -> bool {
        let size = self.outline_scale(p.y);
        let (at, (min, max)) = (DVec2::new(p.x, p.z) / size, self.ends);
        size != 0.0 && at.cmpge(min).all() && at.cmple(max).all() && self.outlines.is_crossed_oddly(at.y, |x| x > at.x)
    }

    /// Bounding box of the prism for outlines within a rectangle.
    fn bounds_of_outline(&self, (min, max): (DVec2, DVec2)) -> Aabb {
        let at = |y: f64| {
            let size = self.outline_scale(y);
            Aabb::from_corners(DVec3::new(min.x * size, y, min.y * size), DVec3::new(max.x * size, y, max.y * size))
        };
        at(self.bottom).union(at(self.top))
    }

    /// Returns the parameter of the ray where it hits the prism's wall over a point of the outline.
    fn ray_t_at_wall(&self, ray: &Ray, p: DVec2) -> f64 {
        let (o, v) = (ray.origin, ray.dir);
        if self.conic {
            // (oₓ + t·vₓ) = pₓ·(o_y + t·v_y), and z likewise: divide by the larger divisor
            let (x, z) = (v.x - p.x * v.y, v.z - p.y * v.y);
            return if x.abs() > z.abs() { (p.x * o.y - o.x) / x } else { (p.y * o.y - o.z) / z };
        }
        if v.x.abs() > v.z.abs() { (p.x - o.x) / v.x } else { (p.y - o.z) / v.z }
    }

    fn add_wall_hits(&self, ray: &Ray, range: Range, out: &mut Hits) {
        let (o, v) = (ray.origin, ray.dir);
        // Intersect the outline with the plane of the ray and the y axis' direction (or the apex): c + n·p = 0
        let (n, c) = if self.conic {
            (DVec2::new(o.z * v.y - o.y * v.z, o.y * v.x - o.x * v.y), o.x * v.z - o.z * v.x)
        } else {
            (DVec2::new(v.z, -v.x), o.z * v.x - o.x * v.z)
        };
        if n == DVec2::ZERO {
            return;
        }
        let way = self.range_between_lids(ray, range);
        for segment in (0..self.outlines.segments.len()).filter(|segment| self.may_hit_segment(ray, *segment, way)) {
            let b = self.outlines.affine_bernstein_coefficients(segment, |p| c + n.dot(p));
            bernstein_roots(&b, &mut |at| {
                let t = self.ray_t_at_wall(ray, self.outlines.point_at(segment, at));
                let y = ray.at(t).y;
                if range.contains(t) && y >= self.bottom && y <= self.top {
                    out.push(Hit { t, part: segment as u32, uv: DVec2::new(at, 0.0) });
                }
                false
            });
        }
    }

    /// Returns the part of the ray's range between the heights of the prism's lids, with a margin.
    fn range_between_lids(&self, ray: &Ray, range: Range) -> Range {
        if ray.dir.y == 0.0 {
            return range;
        }
        let [a, b] = [self.bottom, self.top].map(|y| (y - ray.origin.y) / ray.dir.y);
        let (min, max) = (range.min.max(a.min(b)), range.max.min(a.max(b)));
        let margin = MARGIN * (min.abs().max(max.abs()));
        if margin.is_finite() { Range { min: min - margin, max: max + margin } } else { range }
    }

    /// True if the ray can hit the wall of a prism's segment in the range `range`: a hit over a point of the segment is
    /// between the hits over its control points.
    fn may_hit_segment(&self, ray: &Ray, segment: usize, range: Range) -> bool {
        if self.conic {
            return true;
        }
        let (mut min, mut max) = (f64::INFINITY, f64::NEG_INFINITY);
        for p in self.outlines.control_points(segment) {
            let t = self.ray_t_at_wall(ray, *p);
            (min, max) = (min.min(t), max.max(t));
        }
        let margin = MARGIN * min.abs().max(max.abs());
        !(min - margin > range.max || max + margin < range.min)
    }

    fn add_lid_hits(&self, ray: &Ray, range: Range, out: &mut Hits) {
        if self.open || ray.dir.y == 0.0 {
            return;
        }
        for y in [self.bottom, self.top] {
            let t = (y - ray.origin.y) / ray.dir.y;
            if range.contains(t) && self.outline_contains(ray.at(t).with_y(y)) {
                out.push(Hit::on_piece(t, LID));
            }
        }
    }
}

impl Readable for Prism {
    const SPEC: Spec = Spec {
        name: "prism",
        summary: "outlines in the x-z plane, swept along y",
        params: &[
            Param { name: "bottom", kind: ValueKind::Float, summary: "the height of one end" },
            Param { name: "top", kind: ValueKind::Float, summary: "the height of the other end" },
            Param { name: "number_of_points", kind: ValueKind::Float, summary: "how many follow" },
            Param {
                name: "points",
                kind: ValueKind::Vectors,
                summary: "x and z; repeating the first one closes an outline",
            },
        ],
        words: &joined::<8>(&joined::<6>(&KINDS, &SWEEPS), specs!(Self::WORDS)),
        ..Spec::EMPTY
    };

    const WORDS: &'static [Row<Self>] = &[
        word("open", ValueKind::Nothing, "", "without lids").sets(|prism, _| {
            prism.open = true;
            Ok(())
        }),
        super::algebraic::STURM.sets(|_, r| r.flag().map(drop)),
    ];

    fn read(r: &mut dyn Reader) -> Result<Self> {
        let (mut interpolation, mut conic) = (Interpolation::Linear, false);
        loop {
            if let Some(kind) = Interpolation::read(r)? {
                interpolation = kind;
            } else if r.accept(SWEEPS[0].name)? {
                conic = false;
            } else if r.accept(SWEEPS[1].name)? {
                conic = true;
            } else {
                break;
            }
        }
        let span = r.span();
        let heights = [r.float()?, r.float()?];
        check_finite(span, &[], &heights)?;
        let points = read_points("prism", interpolation, 3, r)?;
        let prism = Self::new(interpolation, conic, heights, &points, false);
        if prism.outlines.segments.is_empty() {
            let message = "no outline of this `prism` is closed";
            let help = "repeat the first point of the outline at its end, and count it";
            return Err(Diagnostic::new(codes::FEW_POINTS, span, message).help(help).into());
        }
        Ok(prism)
    }

    fn complete_and_check(&mut self, span: Span, r: &mut dyn Reader) -> Result<()> {
        if self.unclosed {
            warn_of_unclosed_outline("prism", self.interpolation, span, r);
        }
        Ok(())
    }
}

const SWEEPS: [WordSpec; 2] = [
    word("linear_sweep", ValueKind::Nothing, "", "straight walls; so it is without any such word"),
    word("conic_sweep", ValueKind::Nothing, "", "walls that run to a tip at the origin"),
];

impl Kernel for Prism {
    fn bounds(&self) -> Aabb {
        self.bounds_of_outline(self.ends)
    }

    /// Bounding box of the prism; for a `bezier_spline`, that of all control points (quirk: `extent_boxes`).
    fn pov_bounds(&self, m: &Transform) -> Aabb {
        let ends = if self.interpolation == Interpolation::Bezier { self.outlines.control_bounds() } else { self.ends };
        transformed_box(m, &self.bounds_of_outline(ends))
    }

    fn hits(&self, ray: &Ray, range: Range, out: &mut Hits) {
        self.add_wall_hits(ray, range, out);
        self.add_lid_hits(ray, range, out);
    }

    fn closest(&self, ray: &Ray, range: Range) -> Option<Hit> {
        let mut all = Hits::new();
        self.hits(ray, range, &mut all);
        nearest_hit(&all)
    }

    fn inside(&self, p: DVec3) -> bool {
        p.y >= self.bottom && p.y <= self.top && self.outline_contains(p)
    }

    /// Normal of the prism. That of walls points to the right of the outline's direction, seen from above, and to the
    /// left of a `bezier_spline`; the normal of both lids is y (quirk: `sweep_normal_side`).
    fn normal(&self, _: DVec3, hit: &Hit) -> DVec3 {
        if hit.part == LID {
            return DVec3::Y;
        }
        let (segment, t) = (hit.part as usize, hit.uv.x);
        let side = if self.interpolation == Interpolation::Bezier { -1.0 } else { 1.0 };
        let along = self.outlines.tangent(segment, t) * side;
        let n = DVec3::new(along.y, 0.0, -along.x);
        if !self.conic {
            return n;
        }
        let at = self.outlines.point_at(segment, t);
        n.with_y(-(n.x * at.x + n.z * at.y))
    }

    /// Returns false: POV-Ray defines no uv mapping for prisms.
    fn has_uv_mapping(&self) -> bool {
        false
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::shape::testing::{all_hits, assert_hits, read_shape};

    fn made(text: &str) -> Prism {
        read_shape::<Prism>(text).0.unwrap()
    }

    #[test]
    fn as_pov_ray_traces() {
        // POV-Ray's `trace()` returns <0, 0, -1>; an `interior_texture` is on the other side.
        let leaf = made("bezier_spline 0 1 8 <0,0> <1,1> <2,1> <3,0> <3,0> <2,-1> <1,-1> <0,0>");
        let ray = Ray::new(DVec3::new(1.5, 0.5, -9.0), DVec3::Z);
        let hit = leaf.closest(&ray, Range::FORWARD).unwrap();
        assert!((leaf.normal(ray.at(hit.t), &hit).normalize() + DVec3::Z).length() < 1e-12);
        let wedge = made("linear_spline 0 1 5 <0,0> <2,0> <2,1> <1,3> <0,0>");
        let ray = Ray::new(DVec3::new(-9.0, 0.2, 0.5), DVec3::X);
        let hits = all_hits(&wedge, &ray);
        assert!((hits[0].t - 9.0 - 1.0 / 6.0).abs() < 1e-12 && (hits[1].t - 11.0).abs() < 1e-12);
        let n = wedge.normal(ray.at(hits[0].t), &hits[0]).normalize();
        assert!(n.distance(DVec3::new(-0.948683298051, 0.0, 0.316227766017)) < 1e-9);
        assert_hits(&all_hits(&wedge, &Ray::new(DVec3::new(0.4, 9.0, 0.3), -DVec3::Y)), &[(8.0, LID), (9.0, LID)]);
        assert!(wedge.inside(DVec3::new(0.4, 0.7, 0.3)) && !wedge.inside(DVec3::new(0.4, 1.5, 0.2)));
        let smooth = made("cubic_spline 0 1 7 <1,-1> <0,0> <6,0> <6,8> <0,8> <0,0> <-1,1>");
        let ray = Ray::new(DVec3::new(-9.0, 0.7, 0.1), DVec3::X);
        let hits = all_hits(&smooth, &ray);
        for (hit, (x, n)) in hits.iter().zip([(0.010383472762, -0.997437481032), (6.068514430064, 0.846563196038)]) {
            assert!((ray.at(hit.t).x - x).abs() < 1e-7, "{hit:?}");
            assert!((smooth.normal(ray.at(hit.t), hit).normalize().x - n).abs() < 1e-7);
        }
        let parabolas = made("quadratic_spline 0 1 6 <1,-1> <0,0> <6,0> <6,8> <0,8> <0,0>");
        let found: Vec<f64> = all_hits(&parabolas, &ray).iter().map(|h| ray.at(h.t).x).collect();
        for (x, want) in found.iter().zip([-0.024860334106, 0.958359213500, 3.641640786500, 6.071426544510]) {
            assert!((x - want).abs() < 1e-7, "{found:?}");
        }
    }

    #[test]
    fn conic() {
        let hopper = made("linear_spline conic_sweep -1 1 5 <-1,-1> <1,-1> <1,1> <-1,1> <-1,-1>");
        let ray = Ray::new(DVec3::new(-9.0, 0.7, 0.1), DVec3::X);
        let hits = all_hits(&hopper, &ray);
        assert!((hits[0].t - 8.3).abs() < 1e-12 && (hits[1].t - 9.7).abs() < 1e-12 && hits.len() == 2);
        let n = hopper.normal(ray.at(hits[0].t), &hits[0]).normalize();
        assert!(n.distance(DVec3::new(-0.5_f64.sqrt(), -0.5_f64.sqrt(), 0.0)) < 1e-12, "{n}");
        // Down beside the apex: out through the wall, and in again.
        let down = all_hits(&hopper, &Ray::new(DVec3::new(0.4, 9.0, 0.3), -DVec3::Y));
        let found: Vec<f64> = down.iter().map(|h| 9.0 - h.t).collect();
        assert!(found.iter().zip([1.0, 0.4, -0.4, -1.0]).all(|(y, want)| (y - want).abs() < 1e-12), "{found:?}");
        assert!(hopper.inside(DVec3::new(0.4, 0.5, 0.4)) && !hopper.inside(DVec3::new(0.4, 0.3, 0.1)));
    }

    #[test]
    fn reading() {
        assert_eq!(read_shape::<Prism>("0 1 2 <0,0> <1,1>").0.unwrap_err().code, codes::FEW_POINTS);
        assert_eq!(
            read_shape::<Prism>("bezier_spline 0 1 5 <0,0> <1,1> <1,1> <0,0> <0,0>").0.unwrap_err().code,
            codes::FEW_POINTS
        );
        assert_eq!(
            read_shape::<Prism>("cubic_spline 0 1 6 <1,-1> <0,0> <6,0> <6,8> <0,8> <1,1>").0.unwrap_err().code,
            codes::FEW_POINTS
        );
        let (prism, said) = read_shape::<Prism>("0 1 3 <0,0> <1,1> <0,1> open sturm");
        assert!(prism.unwrap().open && said[0].code == codes::OPEN_OUTLINE);
        let hull = made("bezier_spline 0 1 8 <0,0> <1,1> <2,1> <3,0> <3,0> <2,-1> <1,-1> <0,0>");
        assert_eq!(hull.pov_bounds(&Transform::IDENTITY).max, DVec3::ONE.with_x(3.0));
        assert_eq!(hull.bounds().max, DVec3::new(3.0, 1.0, 0.75));
    }
}
