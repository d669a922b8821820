//! `sphere_sweep { kind number_of_spheres, centres and radii }`: all that a ball sweeps that grows and shrinks on its way.
//!
//! `linear_spline` joins the balls by straight tubes. `cubic_spline` leads smoothly through all but the first and the last, which only
//! give directions (Catmull & Rom, 1974); `b_spline` comes near them in a smoother way (de Boor, A Practical Guide to Splines, 1978). What
//! the pieces cover of a ray is put together, so that only the outside of the whole is a surface, as in POV-Ray 3.7.
//!
//! ```pov
//! sphere_sweep {
//!   b_spline 6, <-1, -1, 0>, 0.2, <-1, 1, 0>, 0.3, <0, 1, 0.5>, 0.2, <0.5, 0.5, 0>, 0.3, <1, 1.5, 0>, 0.1, <1, 2, 0>, 0.1
//!   pigment { color rgb <0.4, 0.7, 0.9> }
//! }
//! ```

mod piece;

pub use piece::Piece;

use super::{Hit, Hits, Kernel, check_finite, transformed_box};
use crate::diagnostic::{Diagnostic, Result, codes};
use crate::math::bvh::{self, Bvh};
use crate::math::{Aabb, DVec2, DVec3, Range, Ray, Transform};
use crate::source::Span;
use crate::value::words::{Row, joined, specs, word};
use crate::value::{Param, Readable, Reader, ReaderExt, Spec, ValueKind, WordSpec};
use piece::Line;
use serde::Serialize;
use smallvec::SmallVec;
use std::ops::ControlFlow;

/// Interpolation between the spheres of a sphere sweep.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum SweepKind {
    /// Sphere sweep of straight tubes, each from one sphere to the next.
    Linear,
    /// Sphere sweep along a uniform cubic B-spline, which does not touch the spheres.
    BSpline,
    /// Sphere sweep along a spline through two spheres at a time, by their neighbours.
    Cubic,
}

/// Sphere sweep: the solid that a moving sphere of changing radius sweeps.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct SphereSweep {
    /// Interpolation between the spheres of the sphere sweep.
    pub kind: SweepKind,
    /// Pieces of the sphere sweep's path, in the order of the hierarchy.
    pub pieces: Vec<Piece>,
    #[serde(skip)]
    bvh: Bvh,
    #[serde(skip)]
    bounds: Aabb,
    /// Bounding box that POV-Ray computes for the whole sphere sweep.
    #[serde(skip)]
    pov_bounds: Aabb,
}

const KINDS: [WordSpec; 3] = [
    word("linear_spline", ValueKind::Nothing, "", "straight tubes join the balls"),
    word("b_spline", ValueKind::Nothing, "", "a smooth way near the balls, of which four or more are needed"),
    word(
        "cubic_spline",
        ValueKind::Nothing,
        "",
        "a smooth way through all balls but the first and the last, which only give directions",
    ),
];

impl SweepKind {
    fn min_sphere_count(self) -> usize {
        if self == SweepKind::Linear { 2 } else { 4 }
    }

    fn build_pieces(self, balls: &[(DVec3, f64)]) -> Vec<Piece> {
        if self == SweepKind::Linear {
            return balls.windows(2).map(|w| Piece::straight(w[0], w[1])).collect();
        }
        // Weighted sums of spheres, in sixths.
        let mixed = |w: &[(DVec3, f64)], by: [f64; 4]| {
            let sum = |(c, r): (DVec3, f64), ((center, radius), by): (&(DVec3, f64), f64)| {
                (c + *center * by, r + radius * by)
            };
            let (c, r) = w.iter().zip(by).fold((DVec3::ZERO, 0.0), sum);
            (c / 6.0, r / 6.0)
        };
        let weights = match self {
            SweepKind::Cubic => {
                [[0.0, 6.0, 0.0, 0.0], [-1.0, 6.0, 1.0, 0.0], [0.0, 1.0, 6.0, -1.0], [0.0, 0.0, 6.0, 0.0]]
            }
            _ => [[1.0, 4.0, 1.0, 0.0], [0.0, 4.0, 2.0, 0.0], [0.0, 2.0, 4.0, 0.0], [0.0, 1.0, 4.0, 1.0]],
        };
        balls.windows(4).map(|w| Piece::curved(weights.map(|by| mixed(w, by)))).collect()
    }
}

impl SphereSweep {
    /// Creates the sphere sweep of these spheres: centres and radii.
    pub fn new(kind: SweepKind, balls: &[(DVec3, f64)]) -> Self {
        let mut pieces = kind.build_pieces(balls);
        pieces.retain(|piece| bvh::fits_single_precision(&piece.bounds()));
        let (bvh, order) = Bvh::build(pieces.iter().map(Piece::bounds));
        let pieces: Vec<Piece> = order.into_iter().map(|i| pieces[i as usize].clone()).collect();
        let bounds = pieces.iter().map(Piece::bounds).fold(Aabb::EMPTY, Aabb::union);
        // quirk: extent_boxes (a negative radius is not considered)
        let reach = if kind == SweepKind::Cubic { 2.0 } else { 1.0 };
        let around =
            |(center, radius): &(DVec3, f64)| Aabb { min: *center - reach * radius, max: *center + reach * radius };
        let pov_bounds = balls.iter().map(around).fold(Aabb::EMPTY, Aabb::union);
        Self { kind, pieces, bvh, bounds, pov_bounds }
    }

    /// Returns the intervals of a ray that the sphere sweep covers, ascending and without overlaps: those that overlap
    /// `search_range`, not cut off at its ends, and possibly others. With `only_first_ahead`, if the range starts outside of
    /// the sweep, only the first interval that begins in the range is correct.
    fn uncut_intervals_near(&self, ray: &Ray, search_range: Range, only_first_ahead: bool) -> Covers {
        let length = ray.dir.length();
        let line = Line { o: ray.origin, v: ray.dir / length };
        let mut all: SmallVec<[[Hit; 2]; 8]> = SmallVec::new();
        let mut starts_inside = false;
        self.bvh.traverse(ray, search_range, |i, mut max| {
            self.pieces[i].visit_covered(&line, &mut |cover| {
                let ends = cover.map(|(s, at)| Hit { t: s / length, part: i as u32, uv: DVec2::new(at, 0.0) });
                let is_ahead = ends[0].t > search_range.min;
                starts_inside |= !is_ahead && ends[1].t > search_range.min;
                // The first interval hides what is behind.
                max = if only_first_ahead && is_ahead { max.min(ends[0].t) } else { max };
                all.push(ends);
            });
            if only_first_ahead && starts_inside { ControlFlow::Break(()) } else { ControlFlow::Continue(max) }
        });
        if only_first_ahead && starts_inside {
            return self.uncut_intervals_near(ray, search_range, false);
        }
        all.sort_unstable_by(|a, b| a[0].t.total_cmp(&b[0].t));
        let mut merged = Covers::new();
        for [near, far] in all {
            match merged.last_mut() {
                Some([_, end]) if near.t <= end.t => *end = if far.t > end.t { far } else { *end },
                _ => merged.push([near, far]),
            }
        }
        merged
    }
}

/// Intervals of a ray that a sphere sweep covers.
type Covers = SmallVec<[[Hit; 2]; 4]>;

impl Readable for SphereSweep {
    const SPEC: Spec = Spec {
        name: "sphere_sweep",
        summary: "all that a ball sweeps that grows and shrinks on its way",
        params: &[
            Param { name: "number_of_spheres", kind: ValueKind::Float, summary: "how many follow" },
            Param {
                name: "centres and radii",
                kind: ValueKind::Vectors,
                summary: "each centre with its radius behind it",
            },
        ],
        words: &joined::<4>(&KINDS, specs!(Self::WORDS)),
        ..Spec::EMPTY
    };

    const WORDS: &'static [Row<Self>] =
        &[word("tolerance", ValueKind::Float, "1e-6", "how exact POV-Ray is; durer always is, so it changes nothing")
            .sets(|_, r| r.float().map(drop))];

    fn read(r: &mut dyn Reader) -> Result<Self> {
        let kind = read_kind(r)?;
        let span = r.span();
        let count = r.float()?.floor();
        if !(kind.min_sphere_count() as f64..=f64::from(u32::MAX)).contains(&count) {
            let message =
                format!("this `sphere_sweep` needs at least {} spheres, it has {count}", kind.min_sphere_count());
            let help = "the number before the spheres says how many follow";
            return Err(Diagnostic::new(codes::FEW_POINTS, span, message).help(help).into());
        }
        let mut ball = |_| {
            let span = r.span();
            let (center, radius) = (r.vector()?, r.float()?);
            check_finite(span, &[center], &[radius])?;
            Ok((center, radius))
        };
        let balls: Result<Vec<_>> = (0..count as u32).map(&mut ball).collect();
        Ok(Self::new(kind, &balls?))
    }

    fn complete_and_check(&mut self, span: Span, r: &mut dyn Reader) -> Result<()> {
        if self.pieces.iter().all(|piece| piece.radii[..=piece.degree].iter().all(|r| *r == 0.0)) {
            r.report(Diagnostic::new(
                codes::NO_SURFACE,
                span,
                "this `sphere_sweep` has no surface: all its radii are 0",
            ));
        }
        Ok(())
    }
}

fn read_kind(r: &mut dyn Reader) -> Result<SweepKind> {
    for (kind, word) in [SweepKind::Linear, SweepKind::BSpline, SweepKind::Cubic].into_iter().zip(KINDS) {
        if r.accept(word.name)? {
            return Ok(kind);
        }
    }
    let help = "the kind stands first: it says how the spheres are joined";
    Err(r.unexpected("`linear_spline`, `b_spline` or `cubic_spline`").help(help).into())
}

impl Kernel for SphereSweep {
    fn bounds(&self) -> Aabb {
        self.bounds
    }

    fn pov_bounds(&self, m: &Transform) -> Aabb {
        transformed_box(m, &self.pov_bounds)
    }

    fn hits(&self, ray: &Ray, range: Range, out: &mut Hits) {
        // (The whole line, because an interval before the range can extend into it.)
        let ends = self.uncut_intervals_near(ray, Range::ALL, false).into_iter().flatten();
        out.extend(ends.filter(|hit| range.contains(hit.t)));
    }

    fn closest(&self, ray: &Ray, range: Range) -> Option<Hit> {
        self.uncut_intervals_near(ray, range, true).into_iter().flatten().find(|hit| range.contains(hit.t))
    }

    fn inside(&self, p: DVec3) -> bool {
        let mut inside = false;
        self.bvh.visit_items_near_point(p, |i| {
            inside = self.pieces[i].contains(p);
            if inside { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
        });
        inside
    }

    /// Normal of a sphere sweep, away from the centre of the sphere; towards it for a negative radius (quirk:
    /// `sphere_sweep_negative_radius`).
    fn normal(&self, p: DVec3, hit: &Hit) -> DVec3 {
        let (center, radius) = self.pieces[hit.part as usize].sphere_at(hit.uv.x);
        let n = if radius < 0.0 { center - p } else { p - center };
        if n.length_squared() > 0.0 { n } else { DVec3::Y }
    }

    /// Returns false: POV-Ray defines no uv mapping for a sphere sweep.
    fn has_uv_mapping(&self) -> bool {
        false
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::shape::testing::{all_hits, read_shape};

    const BALLS: &str = "5 <-2,0,0> .4 <-1,1,0> .3 <1,1.5,0> .5 <2,0,1> .2 <0,-1,0> .3";

    /// POV-Ray's `trace()` along a ray: one coordinate of the hit, and the normal.
    fn traced(text: &str, ray: Ray, want: &[(f64, [f64; 3])]) {
        let sweep = read_shape::<SphereSweep>(text).0.unwrap();
        let hits = all_hits(&sweep, &ray);
        assert_eq!(hits.len(), want.len(), "{hits:?}");
        for (hit, (at, normal)) in hits.iter().zip(want) {
            let p = ray.at(hit.t);
            let n = sweep.normal(p, hit).normalize();
            assert!((p.dot(ray.dir) - at).abs() < 1e-6 && n.distance((*normal).into()) < 1e-5, "{p} {n}");
        }
        let (first, range) = (hits.first().map(|h| h.t), Range::FORWARD);
        assert_eq!(sweep.closest(&ray, range).map(|h| h.t), first);
    }

    #[test]
    fn as_pov_ray_traces() {
        let (level, up) =
            (Ray::new(DVec3::new(-5.0, 0.8, 0.02), DVec3::X), Ray::new(DVec3::new(1.1, -5.0, 0.2), DVec3::Y));
        let b_spline = format!("b_spline {BALLS}");
        // (From within the first interval, POV-Ray's `trace` misses the gap behind it.)
        let hits = all_hits(&read_shape::<SphereSweep>(&b_spline).0.unwrap(), &level);
        let at: Vec<f64> = hits.iter().map(|hit| level.at(hit.t).x).collect();
        assert!(at.len() == 4 && (at[0] + 1.162709849).abs() < 1e-6 && (at[3] - 1.371521912).abs() < 1e-6, "{at:?}");
        traced(
            &b_spline,
            up,
            &[(0.608670513, [-0.369125, -0.835741, -0.406551]), (1.505351076, [0.436140, 0.899863, 0.005410])],
        );
        let cubic = format!("cubic_spline {BALLS} tolerance 0.1");
        traced(
            &cubic,
            level,
            &[(-1.222710575, [-0.742369, -0.666667, 0.066667]), (-0.700401596, [0.347448, -0.934038, 0.082782])],
        );
        traced(
            &cubic,
            up,
            &[(0.904385962, [-0.531892, -0.846613, 0.018385]), (1.947214071, [0.199090, 0.894761, 0.399707])],
        );
        let linear = "linear_spline 3 <-1,0,0> .4 <1,0,0> .3 <1,1.5,0> .5";
        let ray = Ray::new(DVec3::new(-5.0, 0.05, 0.02), DVec3::X);
        traced(
            linear,
            ray,
            &[(-1.396358424, [-0.990896, 0.125, 0.05]), (1.308782458, [0.988999, -0.133333, 0.064058])],
        );
        // One sphere within the other.
        traced(
            "linear_spline 2 0 1 <0.3,0,0> 0.2",
            ray,
            &[(-0.998548947, [-0.998549, 0.05, 0.02]), (0.998548947, [0.998549, 0.05, 0.02])],
        );
    }

    #[test]
    fn pov_bounds_of_each_kind() {
        let pov_bounds = |kind: &str| {
            read_shape::<SphereSweep>(&format!("{kind} {BALLS}")).0.unwrap().pov_bounds(&Transform::IDENTITY)
        };
        assert_eq!(pov_bounds("b_spline").min, DVec3::new(-2.4, -1.3, -0.5));
        assert_eq!(pov_bounds("cubic_spline").min, DVec3::new(-2.8, -1.6, -1.0));
        assert_eq!(pov_bounds("linear_spline").max, DVec3::new(2.2, 2.0, 1.2));
    }

    #[test]
    fn reading() {
        for few in ["linear_spline 1 0 1", "b_spline 3 0 1 0 1 0 1", "cubic_spline -1", "linear_spline 1e99"] {
            assert_eq!(read_shape::<SphereSweep>(few).0.unwrap_err().code, codes::FEW_POINTS, "{few}");
        }
        assert_eq!(read_shape::<SphereSweep>("linear_spline 2 0 1 inf 1").0.unwrap_err().code, codes::NOT_FINITE);
        assert_eq!(read_shape::<SphereSweep>("linear_spline 2 0 0 <1,0,0> 0").1[0].code, codes::NO_SURFACE);
        assert!(read_shape::<SphereSweep>("quadratic_spline 2 0 0 <1,0,0> 0").0.is_err());
    }
}
