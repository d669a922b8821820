//! `sor { number_of_points, points … }`: a surface of revolution, whose radius is a function of the height.
//!
//! Each point is a distance from the y axis and a height; the heights rise. The first and the last point only give directions.
//! `open` leaves off the two lids. (A `lathe` turns any curve, a `sor` is a solid at once.)
//!
//! ```pov
//! sor {
//!   7, <0, -0.2>, <0.6, 0>, <1, 0.6>, <0.4, 1.3>, <0.3, 1.7>, <0.7, 2.2>, <0.9, 2.4> open
//!   pigment { color rgb <0.3, 0.7, 0.5> }
//! }
//! ```

use super::spline::{Interpolation, evaluate_bernstein, read_points};
use super::turned::{Walls, bernstein_max_or_zero};
use super::{Hit, Hits, Kernel, nearest_hit};
use crate::diagnostic::{Diagnostic, Result, codes};
use crate::math::{Aabb, DVec2, DVec3, Range, Ray, fp};
use crate::value::words::{Row, specs, word};
use crate::value::{Param, Readable, Reader, Spec, ValueKind};
use serde::Serialize;
use smallvec::smallvec;

/// Part number of the lower lid of a surface of revolution; the upper lid follows, other parts are segments.
const BOTTOM: u32 = u32::MAX - 1;
const TOP: u32 = u32::MAX;

/// A surface of revolution.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Sor {
    /// Radii and heights of the surface of revolution; the first and last point only give directions.
    pub points: Vec<DVec2>,
    /// True if the surface of revolution has no lids at its ends.
    pub open: bool,
    /// Bernstein coefficients of the surface's squared radius between neighbouring points.
    #[serde(skip)]
    squares: Vec<[f64; 4]>,
    #[serde(skip)]
    walls: Walls,
}

/// Squared radius of a surface of revolution from the second to the third of four points: a cubic function of the
/// height with the slopes 2·r·dr/dh of the chords from each end's neighbours (manual, "Surface of Revolution").
fn squared_radius_bernstein_coefficients(points: &[DVec2]) -> [f64; 4] {
    let step = (points[2].y - points[1].y) / 3.0;
    let slope = |before: DVec2, at: DVec2, after: DVec2| 2.0 * at.x * (after.x - before.x) / (after.y - before.y);
    let (from, to) = (points[1].x * points[1].x, points[2].x * points[2].x);
    [from, from + step * slope(points[0], points[1], points[2]), to - step * slope(points[1], points[2], points[3]), to]
}

impl Sor {
    /// Creates a surface of revolution through at least four points with increasing heights.
    pub fn new(points: Vec<DVec2>, open: bool) -> Self {
        let squares: Vec<[f64; 4]> = points.windows(4).map(squared_radius_bernstein_coefficients).collect();
        let level = 0.5 * (points[1].y + points[points.len() - 2].y);
        let segment = |(p, squares): (&[DVec2], &[f64; 4])| (smallvec![p[1].y, p[2].y], squares.to_vec());
        let walls = Walls::new(points.windows(4).zip(&squares).map(segment), level);
        Self { points, open, squares, walls }
    }

    /// Radius and height of both ends of the surface of revolution.
    fn end_points(&self) -> [DVec2; 2] {
        [self.points[1], self.points[self.points.len() - 2]]
    }
}

impl Readable for Sor {
    const SPEC: Spec = Spec {
        name: "sor",
        summary: "a surface of revolution: its radius is a smooth function of the height",
        params: &[
            Param { name: "number_of_points", kind: ValueKind::Float, summary: "how many follow, at least four" },
            Param {
                name: "points",
                kind: ValueKind::Vectors,
                summary: "radius and height; the first and last only give directions",
            },
        ],
        words: specs!(Self::WORDS),
        ..Spec::EMPTY
    };

    const WORDS: &'static [Row<Self>] = &[
        word("open", ValueKind::Nothing, "", "without lids").sets(|sor, _| {
            sor.open = true;
            Ok(())
        }),
        super::algebraic::STURM.sets(|_, r| r.flag().map(drop)),
    ];

    fn read(r: &mut dyn Reader) -> Result<Self> {
        let span = r.span();
        let points = read_points("sor", Interpolation::Linear, 4, r)?;
        let last = points.len() - 1;
        let fault = if points[1..last].iter().any(|p| p.x < 0.0) {
            "the radius of a `sor` is not negative"
        } else if points[1..last].windows(2).any(|p| p[0].y >= p[1].y) || points.windows(3).any(|p| p[0].y == p[2].y) {
            "the heights of a `sor` rise from the second point to the last but one"
        } else {
            return Ok(Self::new(points, false));
        };
        Err(Diagnostic::new(codes::BAD_OUTLINE, span, fault).help("a `lathe` turns any curve").into())
    }
}

impl Kernel for Sor {
    fn bounds(&self) -> Aabb {
        let reach = self.squares.iter().map(|b| bernstein_max_or_zero(b)).fold(0.0, f64::max).sqrt();
        let [bottom, top] = self.end_points();
        Aabb { min: DVec3::new(-reach, bottom.y, -reach), max: DVec3::new(reach, top.y, reach) }
    }

    fn hits(&self, ray: &Ray, range: Range, out: &mut Hits) {
        self.walls.hits(ray, range, out);
        if self.open || ray.dir.y == 0.0 {
            return;
        }
        for (end, part) in self.end_points().into_iter().zip([BOTTOM, TOP]) {
            let t = (end.y - ray.origin.y) / ray.dir.y;
            let p = ray.at(t);
            if range.contains(t) && p.x * p.x + p.z * p.z < end.x * end.x {
                out.push(Hit::on_piece(t, part));
            }
        }
    }

    fn closest(&self, ray: &Ray, range: Range) -> Option<Hit> {
        let mut all = Hits::new();
        self.hits(ray, range, &mut all);
        nearest_hit(&all)
    }

    fn inside(&self, p: DVec3) -> bool {
        let inner = &self.points[1..self.points.len() - 1];
        let found = inner.windows(2).zip(&self.squares).find(|(ends, _)| (ends[0].y..=ends[1].y).contains(&p.y));
        found.is_some_and(|(ends, b)| {
            let at = (p.y - ends[0].y) / (ends[1].y - ends[0].y);
            p.x * p.x + p.z * p.z <= evaluate_bernstein(b, at)
        })
    }

    fn normal(&self, p: DVec3, hit: &Hit) -> DVec3 {
        match hit.part {
            BOTTOM => -DVec3::Y,
            TOP => DVec3::Y,
            _ => self.walls.normal(p, hit),
        }
    }

    /// Surface coordinates of a surface of revolution. On the lids, they run from the centre to the rim of the lower
    /// and back to the centre of the upper lid (quirk: `lathe_uv`).
    fn uv(&self, p: DVec3, hit: &Hit) -> DVec2 {
        let [bottom, top] = self.end_points();
        let (around, across) = (fp::positive_angle_in_turns(p.z, p.x), fp::hypot(p.x, p.z));
        match hit.part {
            BOTTOM => DVec2::new(around, across / bottom.x - 1.0),
            TOP => DVec2::new(around, 2.0 - across / top.x),
            _ => self.walls.uv(p, hit),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::shape::testing::{all_hits, read_shape};

    #[test]
    fn as_pov_ray_traces() {
        let (shape, _) = read_shape::<Sor>("4 <0.5,0> <0.5,1> <1,2> <1,3>");
        let shape = shape.unwrap();
        let ray = Ray::new(DVec3::new(-9.0, 1.5, 0.0), DVec3::X);
        let hits = all_hits(&shape, &ray);
        assert!((ray.at(hits[0].t).x + 0.770551750371).abs() < 1e-10 && hits.len() == 2, "{hits:?}");
        let n = shape.normal(ray.at(hits[0].t), &hits[0]).normalize();
        assert!(n.distance(DVec3::new(-0.854337144682, -0.519719196506, 0.0)) < 1e-9, "{n}");
        let down = all_hits(&shape, &Ray::new(DVec3::new(0.1, 9.0, 0.05), -DVec3::Y));
        assert_eq!(down.iter().map(|h| (h.t, h.part)).collect::<Vec<_>>(), [(7.0, TOP), (8.0, BOTTOM)]);
        let on_lids = down.iter().map(|h| shape.uv(DVec3::new(0.3, 9.0 - h.t, 0.4), h));
        assert_eq!(on_lids.map(|uv| uv.y).collect::<Vec<_>>(), [1.5, 0.0]);
        assert!(shape.inside(DVec3::new(0.3, 1.5, 0.0)) && !shape.inside(DVec3::new(0.9, 1.5, 0.0)));
        assert!(shape.inside(DVec3::new(0.05, 1.0001, 0.0)) && !shape.inside(DVec3::new(0.05, 2.0001, 0.0)));
    }

    #[test]
    fn vase_of_the_manual() {
        let points = "<0,0> <0.118143,0> <0.620253,0.540084> <0.210970,0.827004> <0.194093,0.962025> <0.286920,1> <0.468354,1.033755>";
        let (vase, said) = read_shape::<Sor>(&format!("7 {points} open sturm"));
        let vase = vase.unwrap();
        assert!(said.is_empty() && vase.open);
        let max = vase.bounds().max;
        assert!((max.x - 0.620585918427).abs() < 1e-6 && max.y == 1.0, "{max}");
        let hits = all_hits(&vase, &Ray::new(DVec3::new(-9.0, 0.7, 0.0), DVec3::X));
        assert!((hits[0].t - 9.0 + 0.454584779604).abs() < 1e-9, "{hits:?}");
        assert!(all_hits(&vase, &Ray::new(DVec3::new(0.05, 9.0, 0.0), -DVec3::Y)).is_empty());
    }

    #[test]
    fn reading() {
        assert_eq!(read_shape::<Sor>("3 <0,0> <1,1> <2,2>").0.unwrap_err().code, codes::FEW_POINTS);
        for bad in [
            "<0,0> <1,1> <1,1> <2,2>",
            "<1,3> <1,2> <.5,1> <1,0>",
            "<-1,0> <-1,1> <-.5,2> <-1,3>",
            "<1,2> <1,1> <1,2> <1,3>",
        ] {
            assert_eq!(read_shape::<Sor>(&format!("4 {bad}")).0.unwrap_err().code, codes::BAD_OUTLINE, "{bad}");
        }
    }
}
