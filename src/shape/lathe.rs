//! `lathe { number_of_points, points … }`: a curve that turns about the y axis.
//!
//! Each point is a distance from the axis and a height. `linear_spline`, `quadratic_spline`, `cubic_spline` or
//! `bezier_spline` before them says how they are joined. A point is inside if the curve is crossed an odd number of
//! times on the way from it straight outwards, and if the point is not closer to the axis than all of the curve.
//!
//! ```pov
//! lathe {
//!   cubic_spline 7, <0, -0.3>, <0.01, 0>, <0.8, 0.1>, <0.15, 0.5>, <0.2, 1>, <0.9, 2>, <1, 2.4>
//!   pigment { color rgb <0.3, 0.5, 0.9> }
//! }
//! ```

use super::spline::{Curve, Interpolation, KINDS, bernstein_product, read_points, single_outline};
use super::turned::Walls;
use super::{Hit, Hits, Kernel, nearest_hit, transformed_box};
use crate::diagnostic::Result;
use crate::math::{Aabb, DVec2, DVec3, Range, Ray, Transform, fp};
use crate::value::words::{Row, joined, specs};
use crate::value::{Param, Readable, Reader, Spec, ValueKind};
use serde::Serialize;

/// Lathe: a curve that is rotated about the y axis.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Lathe {
    /// Interpolation of the lathe's outline between its points.
    pub interpolation: Interpolation,
    /// Curve of the lathe: distance from the axis and height.
    pub curve: Curve,
    /// Distance from the lathe's axis below which no point is inside the lathe (quirk: `lathe_inner_radius`).
    #[serde(skip)]
    inner_radius: f64,
    #[serde(skip)]
    walls: Walls,
}

impl Lathe {
    /// Creates the lathe of a curve through these points.
    pub fn new(interpolation: Interpolation, points: &[DVec2]) -> Self {
        let curve = single_outline(interpolation, points);
        let (min, max) = curve.curve_bounds();
        let bezier = interpolation == Interpolation::Bezier;
        let inner_radius = if bezier { curve.control_bounds().0.x } else { min.x };
        let segment = |i: usize| {
            let radius = curve.affine_bernstein_coefficients(i, |p| p.x);
            (curve.affine_bernstein_coefficients(i, |p| p.y), bernstein_product(&radius, &radius))
        };
        let walls = Walls::new((0..curve.segments.len()).map(segment), 0.5 * (min.y + max.y));
        Self { interpolation, curve, inner_radius, walls }
    }

    fn bounds_of_profile(&self, (min, max): (DVec2, DVec2)) -> Aabb {
        let reach = max.x.max(-min.x);
        Aabb { min: DVec3::new(-reach, min.y, -reach), max: DVec3::new(reach, max.y, reach) }
    }
}

impl Readable for Lathe {
    const SPEC: Spec = Spec {
        name: "lathe",
        summary: "a curve that turns about the y axis",
        params: &[
            Param { name: "number_of_points", kind: ValueKind::Float, summary: "how many follow" },
            Param { name: "points", kind: ValueKind::Vectors, summary: "distance from the axis, and height" },
        ],
        words: &joined::<5>(&KINDS, specs!(Self::WORDS)),
        ..Spec::EMPTY
    };

    const WORDS: &'static [Row<Self>] = &[super::algebraic::STURM.sets(|_, r| r.flag().map(drop))];

    fn read(r: &mut dyn Reader) -> Result<Self> {
        let mut interpolation = Interpolation::Linear;
        while let Some(kind) = Interpolation::read(r)? {
            interpolation = kind;
        }
        Ok(Self::new(interpolation, &read_points("lathe", interpolation, 2, r)?))
    }
}

impl Kernel for Lathe {
    fn bounds(&self) -> Aabb {
        self.bounds_of_profile(self.curve.curve_bounds())
    }

    fn bounds_under(&self, m: &Transform) -> Aabb {
        m.transform_aabb(&self.bounds())
    }

    /// Bounding box of the lathe; for a `bezier_spline`, that of all control points (quirk: `extent_boxes`).
    fn pov_bounds(&self, m: &Transform) -> Aabb {
        let bezier = self.interpolation == Interpolation::Bezier;
        transformed_box(
            m,
            &self.bounds_of_profile(if bezier { self.curve.control_bounds() } else { self.curve.curve_bounds() }),
        )
    }

    fn hits(&self, ray: &Ray, range: Range, out: &mut Hits) {
        self.walls.hits(ray, range, out);
    }

    fn closest(&self, ray: &Ray, range: Range) -> Option<Hit> {
        let mut all = Hits::new();
        self.hits(ray, range, &mut all);
        nearest_hit(&all)
    }

    fn inside(&self, p: DVec3) -> bool {
        let across = fp::hypot(p.x, p.z);
        across >= self.inner_radius && self.curve.is_crossed_oddly(p.y, |x| x > across)
    }

    /// Normal of the lathe, which points to the right of the curve's direction (quirk: `sweep_normal_side`).
    fn normal(&self, p: DVec3, hit: &Hit) -> DVec3 {
        self.walls.normal(p, hit)
    }

    fn uv(&self, p: DVec3, hit: &Hit) -> DVec2 {
        self.walls.uv(p, hit)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::diagnostic::codes;
    use crate::shape::testing::{all_hits, read_shape};

    fn made(text: &str) -> Lathe {
        read_shape::<Lathe>(text).0.unwrap()
    }

    /// POV-Ray's `trace()` from (-9, y, z) along x: hit, and the normal's x and y.
    fn traced(shape: &Lathe, y: f64, z: f64, want: &[(f64, f64, f64)]) {
        let ray = Ray::new(DVec3::new(-9.0, y, z), DVec3::X);
        let hits = all_hits(shape, &ray);
        assert_eq!(hits.len(), want.len(), "{hits:?}");
        for (hit, (x, nx, ny)) in hits.iter().zip(want) {
            let n = shape.normal(ray.at(hit.t), hit).normalize();
            assert!(
                (ray.at(hit.t).x - x).abs() < 1e-6 && (n.x - nx).abs() < 1e-6 && (n.y - ny).abs() < 1e-6,
                "{hit:?} {n}"
            );
        }
    }

    const POINTS: &str = "<0,0> <1,0.5> <0.5,1> <0.7,2> <0.2,3> <1,4>";

    #[test]
    fn as_pov_ray_traces() {
        let straight = made("linear_spline 4 <0,0> <1,0.5> <0.5,1> <0.7,2>");
        traced(
            &straight,
            1.5,
            0.0,
            &[(-0.6, -0.980580675691, -0.196116135138), (0.6, 0.980580675691, -0.196116135138)],
        );
        assert!(straight.inside(DVec3::new(0.3, 1.5, 0.0)) && !straight.inside(DVec3::new(0.9, 1.5, 0.0)));
        let pipe = made("5 <2,0> <3,0> <3,5> <2,5> <2,0>");
        traced(
            &pipe,
            2.5,
            0.05,
            &[
                (-2.999583304394, -0.999861101465, 0.0),
                (-1.999374902313, 0.999687451157, 0.0),
                (1.999374902313, -0.999687451157, 0.0),
                (2.999583304394, 0.999861101465, 0.0),
            ],
        );
        let smooth = made(&format!("cubic_spline 6 {POINTS}"));
        traced(&smooth, 2.5, 0.05, &[(-0.409458483854, -0.794101302020, 0.6), (0.409458483854, 0.794101302020, 0.6)]);
        let bezier = made("bezier_spline 8 <0.1,0> <1,0.5> <0.5,1> <0.7,2> <0.7,2> <0.2,3> <1,4> <1,5>");
        traced(
            &bezier,
            2.5,
            0.05,
            &[(-0.546327878874, -0.988148173923, 0.124034734589), (0.546327878874, 0.988148173923, 0.124034734589)],
        );
    }

    #[test]
    fn outside_near_the_axis() {
        // POV-Ray's `inside()`: the smallest distance from the axis counts, for a `bezier_spline` that of control points.
        let inside = |text: &str, x: f64| made(text).inside(DVec3::X * x);
        let open = "linear_spline 4 <0.5,-2> <1,-1> <1,1> <0.5,2>";
        assert!(!inside(open, 0.49) && inside(open, 0.5) && inside(open, 0.9) && !inside(open, 1.1));
        let bezier = "bezier_spline 4 <0.5,-1> <0.1,-0.5> <0.1,0.5> <0.8,1>";
        assert!(!inside(bezier, 0.09) && inside(bezier, 0.11));
        let cubic = made("cubic_spline 6 <1,-3> <1,-2> <0.3,-1> <0.3,1> <1,2> <1,3>");
        let at = |x: f64| cubic.inside(DVec3::new(x, 1.9, 0.0));
        assert!(!at(0.21) && at(0.22));
    }

    #[test]
    fn from_above_and_aslant() {
        let quadratic = made("quadratic_spline 5 <0,0> <1,0.5> <0.5,1> <0.7,2> <0.2,3>");
        let hits = all_hits(&quadratic, &Ray::new(DVec3::new(0.3, 9.0, 0.0), -DVec3::Y));
        assert!((9.0 - hits[0].t - 2.876024108748).abs() < 1e-7, "{hits:?}");
        // A cone of 45°: rays of any slope, also nearly level ones.
        let cone = made("2 <0,0> <2,2>");
        for rise in [0.0, 1e-12, 1e-9, 1e-6, 1e-3, 0.6, 0.9] {
            let ray = Ray::new(DVec3::new(-9.0, 1.0 - 9.0 * rise, 0.0), DVec3::new(1.0, rise, 0.0));
            let hits = all_hits(&cone, &ray);
            for hit in &hits {
                let p = ray.at(hit.t);
                assert!((fp::hypot(p.x, p.z) - p.y).abs() < 1e-7, "{rise} {hit:?}");
            }
            assert_eq!(hits.len(), if rise < 0.4 { 2 } else { 1 }, "{rise} {hits:?}");
        }
    }

    #[test]
    fn extents_and_reading() {
        let arch = made("bezier_spline 4 <0,0> <2,1> <2,2> <0,3>");
        assert_eq!(arch.pov_bounds(&Transform::IDENTITY).max, DVec3::new(2.0, 3.0, 2.0));
        assert_eq!(arch.bounds().max, DVec3::new(1.5, 3.0, 1.5));
        for few in [
            "1 <0,0>",
            "quadratic_spline 2 <0,0> <1,1>",
            "cubic_spline 3 <0,0> <1,1> <2,2>",
            "bezier_spline 5 <0,0> <1,1> <1,1> <1,1> <1,1>",
        ] {
            assert_eq!(read_shape::<Lathe>(few).0.unwrap_err().code, codes::FEW_POINTS, "{few}");
        }
        assert_eq!(read_shape::<Lathe>("2 <0,0,0> <1,1,1>").0.unwrap_err().code, codes::WRONG_TYPE);
        assert!(read_shape::<Lathe>("2 <0,0> <1,1> sturm").1.is_empty());
        let uv = made("4 <.5,-1> <1,-.5> <.7,.5> <1.2,1>")
            .uv(DVec3::new(-0.92, 0.75, -0.1), &Hit { t: 0.0, part: 2, uv: DVec2::new(0.5, 0.0) });
        assert!((uv.y - 2.5 / 3.0).abs() < 1e-15);
    }
}
