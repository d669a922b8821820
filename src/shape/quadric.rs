//! `quadric { <A, B, C>, <D, E, F>, <G, H, I>, J }`: where A·x² + B·y² + C·z² + D·x·y + E·x·z + F·y·z + G·x + H·y + I·z + J is 0.
//!
//! Balls and eggs, pipes, cones, bowls, hourglasses, saddles. Its inside is where the sum is negative. Most have no end:
//! `clipped_by` or an `intersection` cuts a piece out.
//!
//! ```pov
//! quadric { <1, 0, 1>, <0, 0, 0>, <0, -1, 0>, 0 clipped_by { plane { y, 1.6 } } pigment { color rgb <0.9, 0.6, 0.2> } }
//! ```

use super::{
    Crossing, End, HUGE, Hit, Hits, Kernel, PacketCrossings, PacketHits, Quirks, check_finite, transformed_box,
};
use crate::diagnostic::{Diagnostic, Result, codes};
use crate::math::packet::{Flags, Numbers, PACKET, RayPacket, Vectors};
use crate::math::{
    Aabb, DMat3, DVec3, Lanes, Quadratic, Range, Ray, Transform, quadratic_roots_of_lanes,
    solve_quadratic_with_discriminant,
};
use crate::source::Span;
use crate::value::{Param, Readable, Reader, Spec, ValueKind};
use serde::Serialize;

/// Curvature of a quadric along a line, relative to the largest element of the matrix Q, up to which `crossing` returns
/// no interval and `hits` and `inside` decide.
const STRAIGHT: f64 = 1e-6;

/// Quadric: a surface of second order.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Quadric {
    /// Coefficients of x², y² and z² in the quadric.
    pub squares: DVec3,
    /// Coefficients of x·y, x·z and y·z in the quadric.
    pub mixed: DVec3,
    /// Coefficients of x, y and z in the quadric.
    pub linear: DVec3,
    /// Constant term J of the quadric's equation.
    pub constant: f64,
    #[serde(skip)]
    centered: Centered,
}

/// Quadric about its centre: q·Qq + 2·h·q + c with q = p - centre.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Centered {
    /// Symmetric matrix Q of the centred quadric.
    q: DMat3,
    /// Linear term h of the centred quadric: zero, unless there is no unique centre.
    h: DVec3,
    c: f64,
    center: DVec3,
    /// Largest element of the quadric's matrix Q.
    size: f64,
    /// Bounding box of a closed quadric; empty if there is no surface. `None` for other quadrics.
    ends: Option<Aabb>,
    /// True if the quadric is a filled ellipsoid.
    convex: bool,
}

impl Quadric {
    /// Creates a quadric from coefficients in the order of the manual: A B C, D E F, G H I, J.
    pub fn new(squares: DVec3, mixed: DVec3, linear: DVec3, constant: f64) -> Self {
        let (xy, xz, yz) = (0.5 * mixed.x, 0.5 * mixed.y, 0.5 * mixed.z);
        let q = DMat3::from_cols_array(&[squares.x, xy, xz, xy, squares.y, yz, xz, yz, squares.z]);
        let h = 0.5 * linear;
        // The gradient vanishes at the centre: Q·centre = -h
        let size = (squares.abs() + mixed.abs()).max_element();
        let determinant = q.determinant() / (size * size * size);
        let center = if determinant.abs() > 1e-9 { -(q.inverse() * h) } else { DVec3::ZERO };
        let center = if center.is_finite() { center } else { DVec3::ZERO };
        let at_center = q * center + 2.0 * h;
        let c = center.dot(at_center) + constant;
        let has_center = determinant.abs() > 1e-9;
        let h = if has_center { DVec3::ZERO } else { h };
        let mut centered = Centered { q, h, c, center, size, ends: None, convex: false };
        centered.ends = centered.bounding_box().filter(|_| has_center);
        centered.convex = centered.ends.is_some_and(|b| !b.is_empty()) && centered.definiteness_sign() > 0.0;
        Self { squares, mixed, linear, constant, centered }
    }

    /// Value of the quadric's form at a point; negative inside.
    fn value_at(&self, p: DVec3) -> f64 {
        self.centered.value_about_center(p - self.centered.center)
    }

    fn ray_roots(&self, ray: &Ray) -> Option<(f64, f64)> {
        self.curvature_and_roots(ray).1
    }

    /// Returns the curvature of the quadric's form along a ray, and its roots.
    fn curvature_and_roots(&self, ray: &Ray) -> (f64, Option<(f64, f64)>) {
        let Centered { q, h, center, .. } = &self.centered;
        // Start from the ray's point nearest to the centre, so that a distant eye costs no digits.
        let from = ray.origin - *center;
        let shift = -from.dot(ray.dir) / ray.dir.length_squared();
        let o = from + ray.dir * shift;
        let qv = *q * ray.dir;
        let (a, half_b, c) = (qv.dot(ray.dir), qv.dot(o) + h.dot(ray.dir), self.centered.value_about_center(o));
        let roots = solve_quadratic_with_discriminant(a, half_b, c, half_b * half_b - a * c);
        (a, roots.map(|(t1, t2)| (t1 + shift, t2 + shift)))
    }
}

impl Quadric {
    /// Returns [`Self::curvature_and_roots`] for each ray: the curvatures, for which rays there are roots, and the roots.
    #[inline(always)]
    fn curvature_and_roots_of_packet(&self, rays: &RayPacket) -> (Numbers, Flags, [Numbers; 2]) {
        // The operations of `curvature_and_roots`, in the same order
        let Centered { q, h, c, center, .. } = &self.centered;
        let from = rays.origin - Vectors::splat(*center);
        let shift = -from.dot(rays.dir) / rays.dir.length_squared();
        let o = from + rays.dir * shift;
        let qv = rays.dir.multiplied_by(q);
        let value = o.dot(o.multiplied_by(q) + Vectors::splat(2.0 * *h)) + *c;
        let (a, half_b) = (qv.dot(rays.dir), qv.dot(o) + Vectors::splat(*h).dot(rays.dir));
        let discriminant = half_b * half_b - a * value;
        let zero = Lanes::splat(0.0);
        let has_roots = !discriminant.less_than(zero) & !(a.equals(zero) & half_b.equals(zero));
        let [t1, t2] = quadratic_roots_of_lanes(a, half_b, value, discriminant);
        (a, has_roots, [t1 + shift, t2 + shift])
    }
}

impl Centered {
    fn value_about_center(&self, q: DVec3) -> f64 {
        q.dot(self.q * q + 2.0 * self.h) + self.c
    }

    /// Returns 1 if the quadric's matrix Q is positive definite, -1 if negative definite, 0 otherwise (Sylvester's
    /// criterion).
    fn definiteness_sign(&self) -> f64 {
        let (a, b) = (self.q.x_axis, self.q.y_axis);
        let sign = a.x.signum();
        let minor = a.x * b.y - a.y * b.x;
        if a.x != 0.0 && minor > 0.0 && self.q.determinant() * sign > 0.0 { sign } else { 0.0 }
    }

    /// Bounding box of the quadric: an ellipsoid extends √(-c·(Q⁻¹)ᵢᵢ) along axis i.
    fn bounding_box(&self) -> Option<Aabb> {
        let sign = self.definiteness_sign();
        if sign == 0.0 {
            return None;
        }
        if self.c * sign >= 0.0 {
            return Some(Aabb::EMPTY);
        }
        let inverse = self.q.inverse();
        let diagonal = DVec3::new(inverse.x_axis.x, inverse.y_axis.y, inverse.z_axis.z);
        let reach = (diagonal * -self.c).map(f64::sqrt);
        Some(Aabb { min: self.center - reach, max: self.center + reach })
    }
}

impl Readable for Quadric {
    const SPEC: Spec = Spec {
        name: "quadric",
        summary: "where a polynomial of the second order in x, y and z is 0",
        params: &[
            Param { name: "<A, B, C>", kind: ValueKind::Vector, summary: "of x², y² and z²" },
            Param { name: "<D, E, F>", kind: ValueKind::Vector, summary: "of x·y, x·z and y·z" },
            Param { name: "<G, H, I>", kind: ValueKind::Vector, summary: "of x, y and z" },
            Param { name: "J", kind: ValueKind::Float, summary: "added to all that; it is negative inside" },
        ],
        ..Spec::EMPTY
    };

    fn read(r: &mut dyn Reader) -> Result<Self> {
        let span = r.span();
        let (squares, mixed, linear, constant) = (r.vector()?, r.vector()?, r.vector()?, r.float()?);
        check_finite(span, &[squares, mixed, linear], &[constant])?;
        Ok(Self::new(squares, mixed, linear, constant))
    }

    fn complete_and_check(&mut self, span: Span, r: &mut dyn Reader) -> Result<()> {
        let constant = [self.squares, self.mixed, self.linear].iter().all(|v| *v == DVec3::ZERO);
        if constant || self.centered.ends.is_some_and(|b| b.is_empty()) {
            let message = "a `quadric` with these numbers has no surface: the sum is nowhere 0";
            r.report(Diagnostic::new(codes::NO_SURFACE, span, message));
        }
        Ok(())
    }
}

impl Kernel for Quadric {
    const QUIRKS: Quirks = Quirks { keeps_texture_sides: true, ..Quirks::NONE };
    const TRACES_PACKETS: bool = true;

    fn bounds(&self) -> Aabb {
        self.centered.ends.unwrap_or(Aabb::INFINITE)
    }

    /// Box that POV-Ray reports for the quadric: that of an axis-parallel ellipsoid; infinite for all others (quirk:
    /// `extent_boxes`).
    fn pov_bounds(&self, m: &Transform) -> Aabb {
        match self.centered.ends {
            Some(ends) if self.mixed == DVec3::ZERO && !ends.is_empty() => transformed_box(m, &ends),
            _ => HUGE,
        }
    }

    fn hits(&self, ray: &Ray, range: Range, out: &mut Hits) {
        if let Some((t1, t2)) = self.ray_roots(ray) {
            out.extend([t1, t2].into_iter().filter(|&t| range.contains(t) && t.is_finite()).map(Hit::on_single_piece));
        }
    }

    fn closest(&self, ray: &Ray, range: Range) -> Option<Hit> {
        let (t1, t2) = self.ray_roots(ray)?;
        let counts = |t: &f64| range.contains(*t) && t.is_finite();
        Some(t1).filter(counts).into_iter().chain(Some(t2).filter(counts)).reduce(f64::min).map(Hit::on_single_piece)
    }

    #[inline(always)]
    fn closest_of_packet(&self, rays: &RayPacket, min: f64, max: &Numbers) -> PacketHits {
        let (_, has_roots, ends) = self.curvature_and_roots_of_packet(rays);
        let mut hits = PacketHits { t: *max, ..PacketHits::NONE };
        for t in ends {
            hits.keep_if_closer(has_roots & t.is_finite(), t, 0, min);
        }
        hits
    }

    fn crosses_packets(&self) -> bool {
        true
    }

    #[inline(always)]
    fn crossings_of_packet(&self, rays: &RayPacket) -> PacketCrossings {
        // The operations of `crossing`, in the same order
        let (bend, has_roots, [t1, t2]) = self.curvature_and_roots_of_packet(rays);
        let zero = Lanes::splat(0.0);
        let straight = (STRAIGHT * self.centered.size) * rays.dir.length_squared();
        let is_straight = match self.centered.ends {
            None => bend.abs().at_most(straight),
            Some(_) => Flags::NONE,
        };
        let (is_hollow, is_bent) = (bend.less_than(zero), !bend.equals(zero));
        let has_ends = has_roots & t1.is_finite() & t2.is_finite();
        PacketCrossings {
            is_known: !is_straight & (has_ends | !has_roots & is_bent),
            is_around: is_hollow | has_roots & !is_bent,
            ..PacketCrossings::through(has_ends, [t1, t2], [[0; PACKET]; 2])
        }
    }

    fn inside(&self, p: DVec3) -> bool {
        self.value_at(p) <= 0.0
    }

    fn bounding_quadratic(&self) -> Option<Quadratic> {
        let Centered { q, h, c, center, .. } = self.centered;
        Some(Quadratic { q, h, c, center })
    }

    fn is_solid_unbounded(&self) -> bool {
        self.centered.definiteness_sign() < 0.0
    }

    fn is_convex(&self) -> bool {
        self.centered.convex
    }

    fn computes_crossings(&self) -> bool {
        true
    }

    fn crossing(&self, ray: &Ray) -> Crossing {
        let (bend, roots) = self.curvature_and_roots(ray);
        // Along a nearly straight line in the wall of a pipe or cone `t` is inaccurate; an ellipsoid has no such lines.
        let straight = STRAIGHT * self.centered.size * ray.dir.length_squared();
        if self.centered.ends.is_none() && bend.abs() <= straight {
            return Crossing::Unknown;
        }
        match roots {
            None if bend > 0.0 => Crossing::Misses,
            None if bend < 0.0 => Crossing::Stays,
            Some((t1, t2)) if t1.is_finite() && t2.is_finite() => {
                let ends = [End::on_single_piece(t1), End::on_single_piece(t2)];
                if bend > 0.0 { Crossing::Through(ends) } else { Crossing::Around(ends) }
            }
            _ => Crossing::Unknown,
        }
    }

    fn normal(&self, p: DVec3, _: &Hit) -> DVec3 {
        // The gradient; the apex of a cone has none.
        let n = self.centered.q * (p - self.centered.center) + self.centered.h;
        if n.length_squared() > 0.0 { n } else { DVec3::Y }
    }

    /// Returns false: POV-Ray defines no uv mapping for quadrics.
    fn has_uv_mapping(&self) -> bool {
        false
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::shape::testing::{all_hits, assert_hits, read_shape};

    fn made(text: &str) -> Quadric {
        read_shape::<Quadric>(text).0.unwrap()
    }

    #[test]
    fn packets_match_single_rays() {
        let linear = DVec3::new(0.1, -0.3, 0.2);
        for squares in [DVec3::new(1.0, 2.0, 3.0), DVec3::new(1.0, -1.0, 2.0), DVec3::new(1.0, 0.0, 1.0), DVec3::ZERO] {
            crate::shape::testing::assert_packets_match_single_rays(&Quadric::new(squares, DVec3::ZERO, linear, -0.4));
            crate::shape::testing::assert_packets_match_single_rays(&Quadric::new(
                squares,
                DVec3::new(0.2, -0.4, 0.1),
                linear,
                -0.4,
            ));
        }
    }

    #[test]
    fn closed_forms() {
        let ball = made("<1,1,1> 0 0 -1");
        assert_hits(&all_hits(&ball, &Ray::new(DVec3::Z * -5.0, DVec3::Z * 2.0)), &[(2.0, 0), (3.0, 0)]);
        assert!(ball.inside(DVec3::ZERO) && !ball.inside(DVec3::Y * 1.01));
        assert_eq!(ball.bounds(), Aabb { min: DVec3::NEG_ONE, max: DVec3::ONE });
        // A bowl y = x² + z², hit from above and from the side.
        let bowl = made("<1,0,1> 0 <0,-1,0> 0");
        assert_hits(&all_hits(&bowl, &Ray::new(DVec3::new(0.5, 9.0, 0.5), -DVec3::Y)), &[(8.5, 0)]);
        assert_hits(&all_hits(&bowl, &Ray::new(DVec3::new(-9.0, 4.0, 0.0), DVec3::X)), &[(7.0, 0), (11.0, 0)]);
        assert!(bowl.inside(DVec3::Y) && !bowl.inside(-DVec3::Y) && bowl.bounds() == Aabb::INFINITE);
        assert!(bowl.normal(DVec3::ZERO, &Hit::on_single_piece(0.0)).normalize().distance(-DVec3::Y) < 1e-15);
        assert!(bowl.pov_bounds(&Transform::IDENTITY) == HUGE);
    }

    #[test]
    fn as_pov_ray_tells() {
        // `quadric { <1, 4, 0.25>, 0, <1, 2, 3>, -2 }`: min_extent, max_extent and trace.
        let egg = made("<1,4,0.25> 0 <1,2,3> -2");
        let (min, max) = (egg.bounds().min, egg.bounds().max);
        assert!(min.distance(DVec3::new(-3.891165018, -1.945582509, -12.782329559)) < 1e-5, "{min}");
        assert!(max.distance(DVec3::new(2.891165018, 1.445582509, 0.782330513)) < 1e-5, "{max}");
        let hit = egg.closest(&Ray::new(DVec3::new(0.1, 0.2, -9.0), DVec3::Z), Range::FORWARD).unwrap();
        assert!((hit.t - 9.428063471995).abs() < 1e-11);
    }

    #[test]
    fn turned_ellipsoid() {
        let egg = made("<1,2,3> <0.5,0.2,0.1> 0 -1");
        let b = egg.bounds();
        // Points of the surface along a spiral are in the box, and nearly touch all its sides.
        let mut seen = Aabb::EMPTY;
        for k in 0..20_000 {
            let y = 1.0 - f64::from(k) / 10_000.0;
            let (sin, cos) = crate::math::fp::sin_cos(f64::from(k) * 2.4);
            let v = DVec3::new(cos * (1.0 - y * y).sqrt(), y, sin * (1.0 - y * y).sqrt());
            let hit = egg.closest(&Ray::new(DVec3::ZERO, v), Range::FORWARD).unwrap();
            seen = seen.including(v * hit.t);
        }
        assert!(b.grown(1e-9).contains(seen.min) && b.grown(1e-9).contains(seen.max));
        assert!(seen.grown(1e-3).contains(b.min) && seen.grown(1e-3).contains(b.max));
    }

    #[test]
    fn far_eye_and_turned_inside_out() {
        let ball = made("<1,1,1> 0 <0,0,0> -1");
        let hits = all_hits(&ball, &Ray::new(DVec3::new(0.0, 0.6, -1e7), DVec3::Z));
        assert!((hits[0].t - 1e7 + 0.8).abs() < 1e-8, "{hits:?}");
        let hole = made("<-1,-1,-1> 0 0 1");
        assert!(!hole.inside(DVec3::ZERO) && hole.inside(DVec3::X * 9.0) && hole.is_solid_unbounded());
        assert!(hole.bounds().is_finite() && !hole.is_convex() && ball.is_convex());
    }

    /// `inside` agrees with the intervals of `crossing`.
    #[test]
    fn crossings_agree_with_inside() {
        let surfaces = [
            "<1,1,1> 0 0 -1",
            "<-1,-1,-1> 0 0 1",
            "<0,1,1> 0 0 -1",
            "<1,-1,1> 0 0 0",
            "<1,-1,1> 0 0 -1",
            "<1,0,1> 0 <0,-1,0> 0",
        ];
        let (mut known, mut rng) = ([0; 4], crate::math::rng::Stream::new(&[7]));
        for surface in surfaces.map(made) {
            for _ in 0..400 {
                let mut any = || 3.0 * DVec3::from_array(std::array::from_fn(|_| rng.next_random() - 0.5));
                let ray = Ray::new(any(), any());
                let holds: (usize, Box<dyn Fn(f64) -> bool>) = match surface.crossing(&ray) {
                    Crossing::Unknown => continue,
                    Crossing::Misses => (0, Box::new(|_| false)),
                    Crossing::Stays => (1, Box::new(|_| true)),
                    Crossing::Through([a, b]) => (2, Box::new(move |t| t > a.t && t < b.t)),
                    Crossing::Around([a, b]) => (3, Box::new(move |t| t < a.t || t > b.t)),
                };
                known[holds.0] += 1;
                assert!(
                    (-9..9).map(|i| 0.37 * f64::from(i)).all(|t| surface.inside(ray.at(t)) == holds.1(t)),
                    "{ray:?}"
                );
            }
        }
        assert!(known.iter().all(|&n| n > 50) && known.iter().sum::<i32>() > 2390, "{known:?}");
        // Along a pipe's wall `crossing` is unknown.
        let along = Ray::new(DVec3::Y, DVec3::new(1.0, 1e-5, 0.0));
        assert_eq!(made("<0,1,1> 0 0 -1").crossing(&along), Crossing::Unknown);
    }

    #[test]
    fn no_surface() {
        assert_eq!(read_shape::<Quadric>("1 0 0 1").1[0].code, codes::NO_SURFACE);
        assert_eq!(read_shape::<Quadric>("0 0 0 1").1[0].code, codes::NO_SURFACE);
        assert!(read_shape::<Quadric>("0 0 <0,1,0> 1").1.is_empty());
        assert!(all_hits(&made("1 0 0 1"), &Ray::new(DVec3::ZERO, DVec3::X)).is_empty());
    }
}
