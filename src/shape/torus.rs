//! `torus { major, minor }`: a ring around the y axis, its middle at the origin.
//!
//! `major` reaches from the centre of the hole to the middle of the rim, `minor` is the radius of the rim. With a `minor`
//! larger than `major` the hole closes. Negative radii show parts of the ring, or nothing of it, as in
//! POV-Ray 3.7. `sturm` chooses a slower, more exact method in POV-Ray; here the method is always exact, so the word has no effect.
//!
//! ```pov
//! torus { 1, 0.25 pigment { color rgb <0.9, 0.2, 0.2> } }
//! ```

use super::{Hit, Hits, Kernel, check_finite};
use crate::diagnostic::{Diagnostic, Result, codes};
use crate::math::{
    Aabb, DVec2, DVec3, Range, Ray, bernstein_roots_in_window, fp, solve_quadratic_with_discriminant, tolerance,
};
use crate::source::Span;
use crate::value::words::{Row, specs, word};
use crate::value::{Param, Readable, Reader, Spec, ValueKind};
use serde::Serialize;
use std::f64::consts::TAU;
use std::ops::ControlFlow;

/// Torus: a ring with a round tube, about the y axis.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Torus {
    /// Distance from the torus's axis to the centre of its tube.
    pub major: f64,
    /// Radius of the torus's tube.
    pub minor: f64,
}

impl Torus {
    /// True if no ray hits any part of the torus.
    fn is_empty(&self) -> bool {
        self.minor == 0.0 || self.minor < 0.0 && self.major >= 0.0 || self.major + self.minor == 0.0
    }

    /// Bounding box of the torus, whatever the signs of its radii.
    fn torus_bounding_box(&self) -> Aabb {
        let across = self.major.abs() + self.minor.abs();
        let corner = DVec3::new(across, self.minor.abs(), across);
        Aabb { min: -corner, max: corner }
    }

    /// True if POV-Ray shows the torus along a ray. For a torus with a negative `major`, the ray must hit the outer
    /// wall of the bounding pipe if `minor` is positive, else its upper or lower disc (quirk: `negative_torus`).
    fn is_visible_in_povray(&self, ray: &Ray) -> bool {
        if self.major >= 0.0 {
            return true;
        }
        let (inner, outer) = ((self.major - self.minor).powi(2), (self.major + self.minor).powi(2));
        let across = |p: DVec3| p.x * p.x + p.z * p.z;
        if self.minor < 0.0 {
            let meets = |y: f64| {
                let t = (y - ray.origin.y) / ray.dir.y;
                t > 0.0 && (inner..=outer).contains(&across(ray.at(t)))
            };
            return meets(self.minor) || meets(-self.minor);
        }
        let (o, v) = (DVec2::new(ray.origin.x, ray.origin.z), DVec2::new(ray.dir.x, ray.dir.z));
        let (a, half_b, c) = (v.length_squared(), o.dot(v), o.length_squared() - outer);
        let ends = solve_quadratic_with_discriminant(a, half_b, c, half_b * half_b - a * c);
        let meets = |t: f64| t > 0.0 && ray.at(t).y.abs() < self.minor;
        ends.is_some_and(|(near, far)| meets(near) || meets(far))
    }

    /// Implicit function of the torus, (ρ - R)² + y² - r²: negative inside.
    fn value_at(&self, p: DVec3) -> f64 {
        let across = fp::hypot(p.x, p.z) - self.major;
        across * across + p.y * p.y - self.minor * self.minor
    }

    /// Calls `visit` with each hit on the torus in `range`, in ascending `t`, until it returns `Break`.
    fn visit_hits(&self, ray: &Ray, range: Range, mut visit: impl FnMut(f64) -> ControlFlow<()>) {
        // Search roots in the bounding pipe only. The range does not change the interval of the search, since it must not
        // change the last digit of a hit; it only excludes roots that are not needed.
        let around = self.torus_bounding_box().grown(0.01 * self.minor.abs());
        let Some((near, far)) =
            around.slabs(ray, Range::ALL).filter(|_| !self.is_empty() && self.is_visible_in_povray(ray))
        else {
            return;
        };
        if near >= range.max || far <= range.min {
            return;
        }
        let length = ray.dir.length();
        let range = range.raised_to_min_distance(tolerance::OWN_SURFACE / length);
        let v = ray.dir / length;
        let middle = -ray.origin.dot(v);
        let o = ray.origin + middle * v;
        let interval = Range { min: near * length - middle, max: far * length - middle };
        // (Far from the torus, distances along the ray are less exact.)
        let slack = 1e-14 * middle.abs();
        let wanted = Range { min: range.min * length - middle - slack, max: range.max * length - middle + slack };
        self.find_ray_roots(o, v, interval, wanted, &mut |s| {
            let t = (s + middle) / length;
            t >= range.max || range.contains(t) && visit(t).is_break()
        });
    }

    /// Calls `stops_at` with the roots of a ray on the torus in the interval, in units of |dir|, ascending, until it
    /// returns true; at least with those in the range `wanted`. `nearest_to_origin` is the point o of the ray nearest to
    /// the origin, so that o·v = 0.
    fn find_ray_roots(
        &self,
        nearest_to_origin: DVec3,
        v: DVec3,
        interval: Range,
        wanted: Range,
        stops_at: &mut dyn FnMut(f64) -> bool,
    ) {
        let (major2, minor2) = (self.major * self.major, self.minor * self.minor);
        // (s² + K)² = 4R²·((oₓ + s·vₓ)² + (o_z + s·v_z)²) with K = o² + R² - r²
        let k = nearest_to_origin.length_squared() + major2 - minor2;
        let c2 = 2.0 * k - 4.0 * major2 * (v.x * v.x + v.z * v.z);
        let c1 = -8.0 * major2 * (nearest_to_origin.x * v.x + nearest_to_origin.z * v.z);
        // K² - 4R²ρ² = (K - 2Rρ)·(K + 2Rρ) at s = 0
        let (rho, rest) =
            (fp::hypot(nearest_to_origin.x, nearest_to_origin.z), nearest_to_origin.y * nearest_to_origin.y - minor2);
        let c0 = ((rho - self.major).powi(2) + rest) * ((rho + self.major).powi(2) + rest);
        // Substitute s = lo + u·w, with u from 0 to 1
        let (lo, w) = (interval.min, interval.max - interval.min);
        let a0 = ((lo * lo + c2) * lo + c1) * lo + c0;
        let a1 = ((4.0 * lo * lo + 2.0 * c2) * lo + c1) * w;
        let (a2, a3, a4) = ((6.0 * lo * lo + c2) * w * w, 4.0 * lo * w * w * w, w * w * w * w);
        // Bernstein coefficients bⱼ = Σᵢ C(j,i)/C(4,i)·aᵢ
        let b = [
            a0,
            a0 + 0.25 * a1,
            a0 + 0.5 * a1 + a2 / 6.0,
            a0 + 0.75 * a1 + 0.5 * a2 + 0.25 * a3,
            a0 + a1 + a2 + a3 + a4,
        ];
        let window = ((wanted.min - lo) / w, (wanted.max - lo) / w);
        bernstein_roots_in_window(&b, window, &mut |u| stops_at(lo + u * w));
    }
}

impl Readable for Torus {
    const SPEC: Spec = Spec {
        name: "torus",
        summary: "a ring around the y axis",
        params: &[
            Param {
                name: "major",
                kind: ValueKind::Float,
                summary: "from the middle of the hole to the middle of the rim",
            },
            Param { name: "minor", kind: ValueKind::Float, summary: "the radius of the rim" },
        ],
        words: specs!(Self::WORDS),
        ..Spec::EMPTY
    };

    const WORDS: &'static [Row<Self>] =
        &[word("sturm", ValueKind::Flag, "off", "a more exact method in POV-Ray; changes nothing here")
            .sets(|_, r| r.flag().map(drop))];

    fn read(r: &mut dyn Reader) -> Result<Self> {
        let span = r.span();
        let (major, minor) = (r.float()?, r.float()?);
        check_finite(span, &[], &[major, minor])?;
        Ok(Self { major, minor })
    }

    fn complete_and_check(&mut self, span: Span, r: &mut dyn Reader) -> Result<()> {
        if self.is_empty() {
            let message = format!("a `torus` with radii {} and {} has no surface", self.major, self.minor);
            r.report(Diagnostic::new(codes::NO_SURFACE, span, message).help("both radii should be positive"));
        }
        Ok(())
    }
}

impl Kernel for Torus {
    fn bounds(&self) -> Aabb {
        if self.minor == 0.0 {
            return Aabb::EMPTY;
        }
        self.torus_bounding_box()
    }

    fn hits(&self, ray: &Ray, range: Range, out: &mut Hits) {
        self.visit_hits(ray, range, |t| {
            out.push(Hit::on_single_piece(t));
            ControlFlow::Continue(())
        });
    }

    fn closest(&self, ray: &Ray, range: Range) -> Option<Hit> {
        let mut found = None;
        self.visit_hits(ray, range, |t| {
            found = Some(Hit::on_single_piece(t));
            ControlFlow::Break(())
        });
        found
    }

    fn inside(&self, p: DVec3) -> bool {
        self.minor != 0.0 && self.value_at(p) <= 0.0
    }

    fn normal(&self, p: DVec3, _: &Hit) -> DVec3 {
        // Direction from the nearest point of the tube's centre line.
        let rho = fp::hypot(p.x, p.z);
        let rim = if rho > 0.0 { DVec3::new(p.x, 0.0, p.z) * (self.major / rho) } else { DVec3::ZERO };
        let n = p - rim;
        if n.length_squared() > 0.0 { n } else { DVec3::Y }
    }

    fn uv(&self, p: DVec3, _: &Hit) -> DVec2 {
        // Around the axis, and around the tube from the inside of the hole (quirk: `torus_uv`).
        let u = 0.5 - fp::atan2(p.z, p.x) / TAU;
        let v = 0.5 + fp::atan2(p.y, fp::hypot(p.x, p.z) - self.major) / TAU;
        DVec2::new(u, v)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::shape::testing::{all_hits, assert_hits, read_shape};
    use proptest::prelude::*;

    const RING: Torus = Torus { major: 1.0, minor: 0.25 };

    #[test]
    fn closed_forms() {
        let through = Ray::new(DVec3::new(-3.0, 0.0, 0.0), DVec3::X * 2.0);
        assert_hits(&all_hits(&RING, &through), &[(0.875, 0), (1.125, 0), (1.875, 0), (2.125, 0)]);
        let down = Ray::new(DVec3::new(1.15, 4.0, 0.0), -DVec3::Y);
        assert_hits(&all_hits(&RING, &down), &[(3.8, 0), (4.2, 0)]);
        assert_hits(&all_hits(&RING, &Ray::new(DVec3::Y, -DVec3::Y)), &[]);
        // The rays touch the top along a tangent, and the outer equator.
        let grazing = all_hits(&RING, &Ray::new(DVec3::new(1.0, 0.25, -2.0), DVec3::Z));
        assert!(grazing.iter().all(|h| (h.t - 2.0).abs() < 1e-3), "{grazing:?}");
        let n = RING.normal(DVec3::new(1.0, 0.25, 0.0), &Hit::on_single_piece(0.0));
        assert!(n.normalize().distance(DVec3::Y) < 1e-15);
    }

    #[test]
    fn far_eye() {
        let ray = Ray::new(DVec3::new(0.0, 0.1, -1e7), DVec3::Z);
        let h = (0.0625_f64 - 0.01).sqrt();
        let want = [-1.0 - h, -1.0 + h, 1.0 - h, 1.0 + h];
        for (hit, z) in all_hits(&RING, &ray).iter().zip(want) {
            assert!((hit.t - 1e7 - z).abs() < 1e-8, "{hit:?} {z}");
        }
    }

    #[test]
    fn odd_radii() {
        assert!(!Torus { major: -1.0, minor: 0.5 }.inside(DVec3::X));
        let ball = Torus { major: 0.0, minor: 1.0 };
        let hits = all_hits(&ball, &Ray::new(DVec3::new(0.1, 0.2, -5.0), DVec3::Z));
        let h = (1.0_f64 - 0.05).sqrt();
        assert!(hits.iter().all(|x| (x.t - 5.0 + h).abs() < 1e-6 || (x.t - 5.0 - h).abs() < 1e-6) && hits.len() >= 2);
        // POV-Ray's `inside()` for a closed hole.
        let spindle = Torus { major: 0.25, minor: 1.0 };
        assert!(spindle.inside(DVec3::ZERO) && spindle.inside(DVec3::Y * 0.9) && !spindle.inside(DVec3::X * 1.3));
        assert_eq!(read_shape::<Torus>("1 0.25 sturm on").0.unwrap(), RING);
        assert_eq!(read_shape::<Torus>("1 -0.25").1[0].code, codes::NO_SURFACE);
    }

    /// All numbers from POV-Ray's `trace()` and `inside()`.
    #[test]
    fn negative_radii() {
        let hits = |major: f64, minor: f64, from: [f64; 3], dir: DVec3| {
            all_hits(&Torus { major, minor }, &Ray::new(from.into(), dir)).len()
        };
        // Through the outer wall, of radius 0.8, or not; with the wall behind the origin.
        assert_eq!(hits(-1.0, 0.2, [-3.0, 0.0, 0.0], DVec3::X), 4);
        assert_eq!(hits(-1.0, 0.2, [0.0, 0.0, 1.1], DVec3::X), 0);
        assert_eq!(hits(-1.0, 0.2, [1.0, 3.0, 0.0], -DVec3::Y), 0);
        let ahead = Range { min: 0.0, max: f64::INFINITY };
        let from_inside = Ray::new(DVec3::new(0.85, 0.0, 0.0), DVec3::X);
        let mut out = Hits::new();
        Torus { major: -1.0, minor: 0.2 }.hits(&from_inside, ahead, &mut out);
        assert!(out.is_empty());
        // Through the discs.
        assert_eq!(hits(-1.0, -0.2, [-3.0, 0.0, 0.0], DVec3::X), 0);
        assert_eq!(hits(-1.0, -0.2, [0.81, 3.0, 0.0], -DVec3::Y), 2);
        assert_eq!(hits(1.0, -0.2, [1.0, 3.0, 0.0], -DVec3::Y), 0);
        let inside = |major: f64, minor: f64, x: f64| Torus { major, minor }.inside(DVec3::new(x, 0.05, 0.0));
        assert!(inside(1.0, -0.2, 1.1) && !inside(-1.0, 0.2, 0.9) && inside(-0.3, 1.0, 0.6) && !inside(-0.3, 1.0, 0.8));
    }

    #[test]
    fn uv_around_ring_and_tube() {
        let uv = |x: f64, y: f64, z: f64| RING.uv(DVec3::new(x, y, z), &Hit::on_single_piece(0.0));
        assert!(uv(0.0, 0.0, -1.25).distance(DVec2::new(0.75, 0.5)) < 1e-12);
        assert!(uv(0.0, 0.25, 1.0).distance(DVec2::new(0.25, 0.75)) < 1e-12);
    }

    proptest! {
        #[test]
        fn range_changes_no_hit_in_it(
            o in proptest::array::uniform3(-3.0..3.0f64),
            at in proptest::array::uniform3(-1.0..1.0f64),
            // (A far origin leaves fewer digits for the distance.)
            back in prop_oneof![Just(0.0), Just(1e3), Just(1e7)],
            minor in 0.05..1.0f64,
            start in -3.0..3.0f64, length in 0.0..3.0f64, is_open in any::<bool>(),
        ) {
            let torus = Torus { major: 1.0, minor };
            let dir = (DVec3::from(at) - DVec3::from(o)) * 1.7;
            let ray = Ray::new(DVec3::from(o) - back * dir, dir);
            let of_all = all_hits(&torus, &ray);
            // A range that starts or ends at a hit, or anywhere.
            let start = of_all.first().filter(|_| is_open).map_or(back + start, |hit| hit.t);
            let range = Range { min: start, max: if is_open { f64::INFINITY } else { start + length } };
            let mut found = Hits::new();
            torus.hits(&ray, range, &mut found);
            let want: Vec<f64> = of_all.iter().map(|hit| hit.t).filter(|t| range.contains(*t)).collect();
            prop_assert_eq!(found.iter().map(|hit| hit.t).collect::<Vec<_>>(), want);
        }

        #[test]
        fn hits_are_on_the_surface(
            o in proptest::array::uniform3(-3.0..3.0f64),
            at in proptest::array::uniform3(-1.0..1.0f64),
            major in 0.1..1.5f64, minor in 0.05..1.0f64,
        ) {
            let torus = Torus { major, minor };
            let (o, at) = (DVec3::from(o), DVec3::from(at));
            let ray = Ray::new(o, (at - o) * 1.7);
            let hits = all_hits(&torus, &ray);
            for hit in &hits {
                // A closed hole has an inner surface, on which -R takes the place of R.
                let (p, within) = (ray.at(hit.t), Torus { major: -major, minor });
                prop_assert!(torus.value_at(p).abs().min(within.value_at(p).abs()) < 1e-10, "{hit:?}");
            }
            prop_assert!(hits.len().is_multiple_of(2));
            // Sign changes of the implicit function between samples are crossings that must be found.
            let value = |i: i32| torus.value_at(ray.at(f64::from(i) * 0.01));
            for i in -400..400 {
                if value(i) * value(i + 1) < 0.0 && torus.major > torus.minor {
                    let (lo, hi) = (f64::from(i) * 0.01, f64::from(i + 1) * 0.01);
                    prop_assert!(hits.iter().any(|h| h.t >= lo && h.t <= hi), "crossing in {lo}..{hi} of {hits:?}");
                }
            }
        }
    }
}
