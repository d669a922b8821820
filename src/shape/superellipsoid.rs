//! `superellipsoid { <e, n> }`: between box, ball and octahedron, from -1 to 1 along each axis.
//!
//! The points at which (|x|^(2/e) + |y|^(2/e))^(e/n) + |z|^(2/n) is 1. `e` rounds the outline seen along z, `n` that
//! seen from the side: near 0 they are
//! square, 1 is a circle, 2 a rhombus, and above 2 a star. `<0.2, 0.2>` is a box with round edges, `<1, 0.2>` such a
//! drum.
//!
//! ```pov
//! superellipsoid { <0.3, 0.5> rotate x*30 translate y pigment { color rgb <0.9, 0.4, 0.2> } }
//! ```

use super::{Hit, Hits, Kernel, check_finite, transformed_box};
use crate::diagnostic::{Diagnostic, Result, codes};
use crate::math::{Aabb, DVec3, Range, Ray, Transform, fp, tolerance};
use crate::source::Span;
use crate::value::{Param, Readable, Reader, Spec, ValueKind};
use serde::Serialize;

const CUBE: Aabb = Aabb { min: DVec3::NEG_ONE, max: DVec3::ONE };
/// Accuracy of a superellipsoid's roots; closer roots are one.
const STEP: f64 = 1e-15;
/// Length of a Newton step for a superellipsoid's root after which no other is needed.
const SHORT: f64 = 1e-9;
/// Logarithm of a superellipsoid's gauge beyond which a point is inside or outside despite rounding.
const CLEAR: f64 = 1e-12;
/// Maximum number of factors in a power that is computed by multiplication.
const MOST_FACTORS: u32 = 64;

/// Superellipsoid, whose roundness two exponents define.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Superellipsoid {
    /// East-west exponent of the superellipsoid, not negative; 0 is square.
    pub e: f64,
    /// North-south exponent of the superellipsoid, not negative.
    pub n: f64,
}

/// Computes xᵃ, for an exponent that is usually whole.
fn power(x: f64, a: f64) -> f64 {
    let whole = a as u32;
    if f64::from(whole) != a || whole > MOST_FACTORS {
        return fp::quick_pow(x, a);
    }
    let (mut product, mut square, mut left) = (1.0, x, whole);
    while left > 0 {
        if left % 2 == 1 {
            product *= square;
        }
        square *= square;
        left /= 2;
    }
    product
}

/// Computes x^(1/degree) of a number between 1 and 2, for a degree that is often a power of two.
fn nth_root_of_one_to_two(x: f64, degree: f64) -> f64 {
    match degree {
        _ if x == 1.0 || degree == 1.0 => x,
        2.0 => x.sqrt(),
        4.0 => x.sqrt().sqrt(),
        8.0 => x.sqrt().sqrt().sqrt(),
        _ => fp::quick_pow(x, 1.0 / degree),
    }
}

/// Computes (xᵃ + yᵃ)^(1/a) of positive numbers, and its derivatives by x and y.
fn norm_and_derivatives(x: f64, y: f64, a: f64) -> (f64, f64, f64) {
    let (big, small) = if x > y { (x, y) } else { (y, x) };
    if big == 0.0 {
        return (0.0, 0.0, 0.0);
    }
    // Use the ratio, whose power cannot overflow.
    let ratio = small / big;
    // At an edge, where the ratio is 0, any slope between those of both sides is valid.
    let slope = match () {
        _ if ratio > 0.0 => power(ratio, a - 1.0),
        _ if a >= 1.0 => 0.0,
        _ => f64::INFINITY,
    };
    let sum = if ratio > 0.0 { 1.0 + slope * ratio } else { 1.0 };
    let root = nth_root_of_one_to_two(sum, a);
    let (value, by_big) = (big * root, root / sum);
    let by_small = by_big * slope;
    if x > y { (value, by_big, by_small) } else { (value, by_small, by_big) }
}

/// End of a piece of a line in a superellipsoid's cube.
#[derive(Clone, Copy)]
struct End {
    s: f64,
    /// Point of the line at this end, with each coordinate replaced by its absolute value.
    p: DVec3,
    /// Logarithms of the absolute values of the point's coordinates.
    ln: DVec3,
}

impl End {
    fn new(line: &Line, s: f64) -> Self {
        let p = line.point_at(s).abs();
        Self { s, p, ln: p.map(fp::ln) }
    }
}

/// Logarithms of a superellipsoid's terms at a point.
struct TermLogarithms {
    /// Logarithms of the point's coordinates.
    of: DVec3,
    /// Logarithm of (|x|^(2/e) + |y|^(2/e))^(e/2).
    across: f64,
    /// Logarithm of the gauge: the factor by which the superellipsoid must grow to reach the point.
    gauge: f64,
}

/// Returns xⁿ = exp(n·ln x), where `ln` is ln x; 1 if n·ln x is NaN, as for 0·∞.
fn power_from_logarithm(ln: f64, n: f64) -> f64 {
    let product = ln * n;
    if product.is_nan() { 1.0 } else { fp::exp(product) }
}

/// Logarithm of (xᵃ + yᵃ)^(1/a) from the logarithms of x and y.
fn ln_norm_of_logarithms(ln_x: f64, ln_y: f64, a: f64) -> f64 {
    let (big, small) = if ln_x > ln_y { (ln_x, ln_y) } else { (ln_y, ln_x) };
    big + fp::ln(1.0 + power_from_logarithm(small - big, a)) / a
}

impl Superellipsoid {
    /// Returns the factor by which the superellipsoid must grow to reach the point, and its gradient. For exponents up
    /// to 2 the factor is a norm.
    fn gauge_and_gradient(&self, p: DVec3) -> (f64, DVec3) {
        let q = p.abs();
        let (across, by_x, by_y) = norm_and_derivatives(q.x, q.y, 2.0 / self.e);
        let (value, by_across, by_z) = norm_and_derivatives(across, q.z, 2.0 / self.n);
        let product = |by: f64| if by_across == 0.0 || by == 0.0 { 0.0 } else { by_across * by };
        let slopes = DVec3::new(product(by_x), product(by_y), by_z);
        (value, DVec3::select(p.cmplt(DVec3::ZERO), -slopes, slopes))
    }

    fn is_empty(&self) -> bool {
        !(self.e >= 0.0 && self.n >= 0.0)
    }

    /// Finds the surface of a convex superellipsoid by Newton's method from one end of a line's piece in the cube to
    /// the surface. A tangent of a convex function is below the function, so steps approach the root and never pass it.
    /// `None` if the line has no root between `from` and `to`.
    fn convex_root_from_end(&self, line: &Line, from: f64, to: f64) -> Option<f64> {
        let toward = (to - from).signum();
        let mut s = from;
        for _ in 0..200 {
            let (value, gradient) = self.gauge_and_gradient(line.point_at(s));
            let excess = value - 1.0;
            if excess <= 0.0 {
                return Some(s);
            }
            let slope = gradient.dot(line.v) * toward;
            if slope >= 0.0 {
                return None;
            }
            let step = excess / -slope;
            s += step * toward;
            if (to - s) * toward < 0.0 {
                return None;
            }
            // Such a short step doubles the number of correct digits.
            if step < SHORT {
                break;
            }
        }
        Some(s)
    }

    /// Calls `stops_at` with the roots on a superellipsoid between two points within one octant, ascending; pieces
    /// outside of the range are left out, but roots outside of it can be among them. Returns true if `stops_at` did.
    /// Pieces do not depend on the range, so neither do the last digits of roots.
    fn any_root_in_octant(
        &self,
        line: &Line,
        lo: End,
        hi: End,
        within: Range,
        stops_at: &mut dyn FnMut(f64) -> bool,
    ) -> bool {
        if hi.s < within.min || lo.s > within.max {
            return false;
        }
        // The gauge grows along each axis, so it is bounded by its values at two corners of the piece's box.
        let far = self.term_logarithms(lo.ln.max(hi.ln));
        if far.gauge < -CLEAR {
            return false;
        }
        let near = self.term_logarithms(lo.ln.min(hi.ln));
        if near.gauge > CLEAR {
            return false;
        }
        let length = hi.s - lo.s;
        let slopes = self.scaled_derivative_bounds(&near, &far, (hi.p - lo.p) / length);
        if slopes.0 > 0.0 || slopes.1 < 0.0 || length < 1e-13 {
            let begins_inside = self.gauge_and_gradient(lo.p).0 <= 1.0;
            let differ = begins_inside != (self.gauge_and_gradient(hi.p).0 <= 1.0);
            return differ
                && stops_at(
                    self.root_between_inside_and_outside(line, if begins_inside { (lo.s, hi.s) } else { (hi.s, lo.s) }),
                );
        }
        let middle = End::new(line, 0.5 * (lo.s + hi.s));
        self.any_root_in_octant(line, lo, middle, within, stops_at)
            || self.any_root_in_octant(line, middle, hi, within, stops_at)
    }

    /// Returns the logarithms of the superellipsoid's terms at a point from those of its coordinates; each power costs
    /// one exponential.
    fn term_logarithms(&self, ln_point: DVec3) -> TermLogarithms {
        let across = ln_norm_of_logarithms(ln_point.x, ln_point.y, 2.0 / self.e);
        TermLogarithms { of: ln_point, across, gauge: ln_norm_of_logarithms(across, ln_point.z, 2.0 / self.n) }
    }

    /// Bounds of the derivative of the superellipsoid's (xᵃ + yᵃ)^(b/a) + zᵇ between two corners, along v, divided by
    /// b.
    fn scaled_derivative_bounds(&self, near: &TermLogarithms, far: &TermLogarithms, v: DVec3) -> (f64, f64) {
        let (a, b) = (2.0 / self.e, 2.0 / self.n);
        let power = |lo: f64, hi: f64, n: f64| {
            let (x, y) = (power_from_logarithm(lo, n), power_from_logarithm(hi, n));
            (x.min(y), x.max(y))
        };
        let times = |(lo, hi): (f64, f64), v: f64| {
            if v < 0.0 {
                (hi * v, lo * v)
            } else if v > 0.0 {
                (lo * v, hi * v)
            } else {
                (0.0, 0.0)
            }
        };
        let plus = |x: (f64, f64), y: (f64, f64)| (x.0 + y.0, x.1 + y.1);
        let across = power(near.across, far.across, b - a);
        let along = |axis: usize, n: f64| times(power(near.of[axis], far.of[axis], n), v[axis]);
        let in_plane = plus(along(0, a - 1.0), along(1, a - 1.0));
        let scaled = |x: f64, least: bool| if (x < 0.0) == least { x * across.1 } else { x * across.0 };
        plus((scaled(in_plane.0, true), scaled(in_plane.1, false)), along(2, b - 1.0))
    }

    /// Returns the root of a superellipsoid between a point inside and one outside: Newton's method, or bisection where
    /// that is slow.
    fn root_between_inside_and_outside(&self, line: &Line, (mut inner, mut outer): (f64, f64)) -> f64 {
        let (mut s, mut last) = (0.5 * (inner + outer), (outer - inner).abs());
        for _ in 0..100 {
            let (value, gradient) = self.gauge_and_gradient(line.point_at(s));
            if value <= 1.0 {
                inner = s;
            } else {
                outer = s;
            }
            let newton = s - (value - 1.0) / gradient.dot(line.v);
            let helps = (newton - inner) * (newton - outer) <= 0.0 && (newton - s).abs() <= 0.5 * last;
            let next = if helps { newton } else { 0.5 * (inner + outer) };
            last = (next - s).abs();
            s = next;
            if last < STEP {
                break;
            }
        }
        s
    }

    /// Calls `stops_at` with the entry and exit of a convex superellipsoid, unless they are before `range_start`; true
    /// ends the search.
    fn search_convex(
        &self,
        line: &Line,
        (lo, hi): (f64, f64),
        range_start: f64,
        stops_at: &mut dyn FnMut(f64) -> bool,
    ) {
        let mut last = range_start;
        // Within the cube one evaluation decides whether a ray starts inside or moves away: most are shadow rays that
        // leave the surface.
        let (value, gradient) = if range_start > lo {
            self.gauge_and_gradient(line.point_at(range_start))
        } else {
            (f64::INFINITY, -line.v)
        };
        if value > 1.0 {
            if gradient.dot(line.v) >= 0.0 {
                return;
            }
            let Some(first) = self.convex_root_from_end(line, lo, hi) else { return };
            if stops_at(first) {
                return;
            }
            last = first;
        }
        // At a grazing ray rounding can put the exit before the entry.
        stops_at(self.convex_root_from_end(line, hi, lo).map_or(last, |s| s.max(last)));
    }

    /// Calls `stops_at` with each hit on the superellipsoid in the range, ascending, until it returns true.
    fn search_hits(&self, ray: &Ray, range: Range, stops_at: &mut dyn FnMut(f64) -> bool) {
        let Some((near, far)) = CUBE.slabs(ray, Range::ALL).filter(|_| !self.is_empty()) else { return };
        if near >= range.max || far <= range.min {
            return;
        }
        // Start from the point nearest to the origin.
        let length = ray.dir.length();
        let range = range.raised_to_min_distance(tolerance::OWN_SURFACE / length);
        let v = ray.dir / length;
        let middle = -ray.origin.dot(v);
        let line = Line { o: ray.origin + middle * v, v };
        let (lo, hi) = (near * length - middle, far * length - middle);
        let mut report_root = |s: f64| {
            let t = (s + middle) / length;
            range.contains(t) && stops_at(t)
        };
        if self.e <= 2.0 && self.n <= 2.0 {
            return self.search_convex(&line, (lo, hi), range.min * length - middle, &mut report_root);
        }
        let within = Range { min: range.min * length - middle, max: range.max * length - middle };
        let mut cuts: smallvec::SmallVec<[f64; 5]> = smallvec::smallvec![lo, hi];
        cuts.extend((0..3).map(|axis| -line.o[axis] / v[axis]).filter(|s| *s > lo && *s < hi));
        cuts.sort_by(f64::total_cmp);
        let ends: smallvec::SmallVec<[End; 5]> = cuts.iter().map(|&s| End::new(&line, s)).collect();
        let _ = ends
            .windows(2)
            .any(|w| w[0].s < w[1].s && self.any_root_in_octant(&line, w[0], w[1], within, &mut report_root));
    }
}

/// A line o + s·v in a superellipsoid's space.
struct Line {
    o: DVec3,
    v: DVec3,
}

impl Line {
    fn point_at(&self, s: f64) -> DVec3 {
        self.o + self.v * s
    }
}

impl Readable for Superellipsoid {
    const SPEC: Spec = Spec {
        name: "superellipsoid",
        summary: "between box, ball and octahedron, from -1 to 1 along each axis",
        params: &[Param {
            name: "<e, n>",
            kind: ValueKind::Vector2,
            summary: "how round: near 0 square, 1 round, 2 pointed; around z, and towards z",
        }],
        ..Spec::EMPTY
    };

    fn read(r: &mut dyn Reader) -> Result<Self> {
        let span = r.span();
        let both = r.vector2()?;
        check_finite(span, &[], &[both.x, both.y])?;
        Ok(Self { e: both.x, n: both.y })
    }

    fn complete_and_check(&mut self, span: Span, r: &mut dyn Reader) -> Result<()> {
        if self.is_empty() {
            let message = format!("a `superellipsoid` with the exponents {} and {} has no surface", self.e, self.n);
            r.report(Diagnostic::new(codes::NO_SURFACE, span, message).help("neither should be negative; 1 is round"));
        }
        Ok(())
    }
}

impl Kernel for Superellipsoid {
    fn bounds(&self) -> Aabb {
        if self.is_empty() { Aabb::EMPTY } else { CUBE }
    }

    /// Box that POV-Ray reports for a superellipsoid, slightly larger than the shape (quirk: `extent_boxes`).
    fn pov_bounds(&self, m: &Transform) -> Aabb {
        transformed_box(m, &CUBE.grown(1e-4))
    }

    fn hits(&self, ray: &Ray, range: Range, out: &mut Hits) {
        self.search_hits(ray, range, &mut |t| {
            out.push(Hit::on_single_piece(t));
            false
        });
    }

    fn closest(&self, ray: &Ray, range: Range) -> Option<Hit> {
        let mut first = None;
        self.search_hits(ray, range, &mut |t| {
            first = Some(Hit::on_single_piece(t));
            true
        });
        first
    }

    fn inside(&self, p: DVec3) -> bool {
        !self.is_empty() && CUBE.contains(p) && self.gauge_and_gradient(p).0 <= 1.0
    }

    fn normal(&self, p: DVec3, _: &Hit) -> DVec3 {
        let n = self.gauge_and_gradient(p).1;
        if n.is_finite() && n.length_squared() > 0.0 {
            return n;
        }
        // On the sharp edge of a star the normal is that of one side.
        let edge = n.map(|x| if x.is_infinite() { x.signum() } else { 0.0 });
        if edge == DVec3::ZERO { DVec3::Z } else { edge }
    }

    /// Returns false: POV-Ray defines no uv mapping for a superellipsoid.
    fn has_uv_mapping(&self) -> bool {
        false
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::shape::testing::{all_hits, read_shape};

    fn near(found: &[Hit], want: &[f64]) {
        let same = found.len() == want.len() && found.iter().zip(want).all(|(h, t)| (h.t - t).abs() < 1e-12);
        assert!(same, "{found:?} {want:?}");
    }

    #[test]
    fn ball_and_octahedron() {
        let ball = Superellipsoid { e: 1.0, n: 1.0 };
        let h = (1.0_f64 - 0.25).sqrt();
        near(
            &all_hits(&ball, &Ray::new(DVec3::new(0.3, 0.4, -5.0), DVec3::Z * 2.0)),
            &[(5.0 - h) / 2.0, (5.0 + h) / 2.0],
        );
        near(&all_hits(&ball, &Ray::new(DVec3::new(0.8, 0.7, -5.0), DVec3::Z)), &[]);
        let octahedron = Superellipsoid { e: 2.0, n: 2.0 };
        near(&all_hits(&octahedron, &Ray::new(DVec3::new(0.3, 0.4, -5.0), DVec3::Z)), &[4.7, 5.3]);
        near(&all_hits(&octahedron, &Ray::new(DVec3::new(-5.0, 0.0, 0.0), DVec3::X)), &[4.0, 6.0]);
    }

    #[test]
    fn as_pov_ray_traces() {
        // `trace()` from <.1, .2, -5> along z.
        for (e, n, z) in [(1.0, 1.0, 0.974679434481), (0.1, 0.1, 1.0), (2.0, 0.5, 0.997968819820)] {
            let shape = Superellipsoid { e, n };
            let hit = shape.closest(&Ray::new(DVec3::new(0.1, 0.2, -5.0), DVec3::Z), Range::FORWARD).unwrap();
            assert!((hit.t - 5.0 + z).abs() < 1e-10, "{e} {n} {hit:?}");
        }
        let n = Superellipsoid { e: 2.0, n: 0.5 }
            .normal(DVec3::new(0.1, 0.2, 0.997968819820), &Hit::on_single_piece(0.0))
            .normalize();
        assert!(n.distance(DVec3::new(0.027145172107, 0.027145172107, 0.999262867949)) < 1e-9, "{n}");
    }

    #[test]
    fn from_sharp_to_starry() {
        for e in [0.0, 0.01, 0.1, 0.5, 1.5, 2.5, 5.0] {
            for n in [0.01, 0.3, 1.0, 2.0, 3.0, 5.0] {
                let shape = Superellipsoid { e, n };
                for k in 0..60 {
                    let (sin, cos) = fp::sin_cos(f64::from(k) * 2.4);
                    let from = DVec3::new(3.0 * cos, 3.0 * sin, 0.1 * f64::from(k) - 3.0);
                    let ray = Ray::new(from, DVec3::new(0.11, -0.07, 0.05) * (f64::from(k % 7) - 3.0) - from);
                    let hits = all_hits(&shape, &ray);
                    assert!(hits.len().is_multiple_of(2), "{shape:?} {ray:?} {hits:?}");
                    for hit in &hits {
                        let (value, _) = shape.gauge_and_gradient(ray.at(hit.t));
                        assert!((value - 1.0).abs() < 1e-9 || e > 2.0 || n > 2.0, "{shape:?} {ray:?} {value}");
                    }
                    for j in 0..200 {
                        let t = f64::from(j) / 100.0;
                        let behind = hits.iter().filter(|h| h.t > t).count();
                        let clear = hits.iter().all(|h| (h.t - t).abs() > 1e-6);
                        assert!(
                            !clear || shape.inside(ray.at(t)) == (behind % 2 == 1),
                            "{shape:?} {ray:?} {t} {hits:?}"
                        );
                    }
                }
            }
        }
    }

    #[test]
    fn reading() {
        assert_eq!(read_shape::<Superellipsoid>("<0.5,2,0>").0.unwrap(), Superellipsoid { e: 0.5, n: 2.0 });
        assert_eq!(read_shape::<Superellipsoid>("<-1,1,0>").1[0].code, codes::NO_SURFACE);
        assert_eq!(read_shape::<Superellipsoid>("<inf,1,0>").0.unwrap_err().code, codes::NOT_FINITE);
    }
}
