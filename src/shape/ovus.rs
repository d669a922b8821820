//! `ovus { bottom_radius, top_radius }`: an egg (manual, "Ovus").
//!
//! A ball around the origin, a second ball whose centre is the top of the first, and between them a band that touches both: an arc
//! about the y axis, with twice the larger radius (quirk: `ovus_shape`). If the upper ball is at least twice as large as the
//! lower one, the shape is the upper ball.
//!
//! ```pov
//! ovus { 1, 0.6 translate y pigment { color rgb <0.9, 0.8, 0.6> } }
//! ```

use super::{Hit, Hits, Kernel, Sphere, Torus, check_finite, transformed_box};
use crate::diagnostic::{Diagnostic, Result, codes};
use crate::math::{Aabb, DVec2, DVec3, Range, Ray, Transform, fp};
use crate::source::Span;
use crate::value::words::{Row, specs};
use crate::value::{Param, Readable, Reader, Spec, ValueKind};
use serde::Serialize;

/// Part numbers of an ovus: lower ball, band, upper ball.
const BOTTOM: u32 = 0;
const BAND: u32 = 1;
const TOP: u32 = 2;
/// Tolerance, relative to the larger radius, within which a point belongs to two neighbouring parts of an ovus.
const OVERLAP: f64 = 1e-9;

/// Ovus, a solid egg: two balls joined by an arc that is rotated about the y axis.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Ovus {
    /// Radius of the ovus's ball around the origin.
    pub bottom: f64,
    /// Radius of the ovus's upper ball.
    pub top: f64,
    /// Centre of the ovus's arc: distance from the axis, on the opposite side, and height.
    #[serde(skip)]
    middle: DVec2,
    /// Radius of the ovus's arc; 0 if there is only one ball.
    #[serde(skip)]
    arc: f64,
    /// Heights of the ends of the ovus's band.
    #[serde(skip)]
    ends: [f64; 2],
}

impl Ovus {
    /// Creates an ovus with radii that are not negative.
    pub fn new(bottom: f64, top: f64) -> Self {
        if top >= 2.0 * bottom {
            return Self { bottom, top, middle: DVec2::ZERO, arc: 0.0, ends: [f64::NEG_INFINITY; 2] };
        }
        let arc = 2.0 * bottom.max(top);
        // The balls touch the arc from inside: its centre is arc - radius from theirs, (0, 0) and (0, bottom).
        let (low, high) = (arc - bottom, arc - top);
        let y = 0.5 * (bottom + (low - high) * (low + high) / bottom);
        let x = (low * low - y * y).max(0.0).sqrt();
        let ends = [-y * bottom / low, bottom + (bottom - y) * top / high];
        Self { bottom, top, middle: DVec2::new(x, y), arc, ends }
    }

    fn ball_of_part(&self, part: u32) -> Sphere {
        match part {
            BOTTOM => Sphere { center: DVec3::ZERO, radius: self.bottom },
            _ => Sphere { center: DVec3::Y * self.bottom, radius: self.top },
        }
    }

    /// Vector from the centre of the ovus's arc to the point, in the plane through the axis.
    fn offset_from_arc_center(&self, p: DVec3) -> DVec2 {
        DVec2::new(fp::hypot(p.x, p.z) + self.middle.x, p.y - self.middle.y)
    }

    /// True if a point of the torus is on the ovus's band, between two heights.
    fn is_on_band(&self, p: DVec3, [y_min, y_max]: [f64; 2]) -> bool {
        // Of the two arcs of a closed torus the one that curves towards the axis.
        let here = self.offset_from_arc_center(p);
        let other = DVec2::new(here.x - 2.0 * self.middle.x, here.y);
        let off = |q: DVec2| (q.length() - self.arc).abs();
        (y_min..=y_max).contains(&p.y) && off(here) <= off(other)
    }

    /// Returns the entry and exit of a line; an ovus is convex.
    fn entry_and_exit(&self, ray: &Ray) -> Option<[Hit; 2]> {
        let slack = OVERLAP * self.bottom.max(self.top);
        let ends = [self.ends[0] + slack, self.ends[1] - slack];
        let mut all = Hits::new();
        let mut candidates = Hits::new();
        for part in [BOTTOM, TOP] {
            candidates.clear();
            self.ball_of_part(part).hits(ray, Range::ALL, &mut candidates);
            let shows = |y: f64| if part == BOTTOM { y <= ends[0] } else { y >= ends[1] };
            all.extend(candidates.iter().map(|hit| Hit::on_piece(hit.t, part)).filter(|hit| shows(ray.at(hit.t).y)));
        }
        if all.len() < 2 && self.ends[0] < self.ends[1] {
            candidates.clear();
            let up = DVec3::Y * self.middle.y;
            let torus = Torus { major: self.middle.x, minor: self.arc };
            torus.hits(&Ray::new(ray.origin - up, ray.dir), Range::ALL, &mut candidates);
            let band = [self.ends[0] - slack, self.ends[1] + slack];
            all.extend(
                candidates
                    .iter()
                    .map(|hit| Hit::on_piece(hit.t, BAND))
                    .filter(|hit| self.is_on_band(ray.at(hit.t), band)),
            );
        }
        let first = all.iter().min_by(|a, b| a.t.total_cmp(&b.t))?;
        let last = all.iter().max_by(|a, b| a.t.total_cmp(&b.t))?;
        Some([*first, *last])
    }
}

impl Readable for Ovus {
    const SPEC: Spec = Spec {
        name: "ovus",
        summary: "an egg",
        params: &[
            Param { name: "bottom_radius", kind: ValueKind::Float, summary: "of the ball around the origin" },
            Param { name: "top_radius", kind: ValueKind::Float, summary: "of the ball around the top of that one" },
        ],
        words: specs!(Self::WORDS),
        ..Spec::EMPTY
    };

    const WORDS: &'static [Row<Self>] = &[super::algebraic::STURM.sets(|_, r| r.flag().map(drop))];

    fn read(r: &mut dyn Reader) -> Result<Self> {
        let span = r.span();
        let (bottom, top) = (r.float()?, r.float()?);
        check_finite(span, &[], &[bottom, top])?;
        if bottom < 0.0 || top < 0.0 {
            return Diagnostic::err(codes::BAD_ARGUMENT, span, "the radii of an `ovus` can't be negative");
        }
        Ok(Self::new(bottom, top))
    }

    fn complete_and_check(&mut self, span: Span, r: &mut dyn Reader) -> Result<()> {
        if self.bottom == 0.0 && self.top == 0.0 {
            r.report(Diagnostic::new(codes::NO_SURFACE, span, "an `ovus` with both radii 0 has no surface"));
        }
        Ok(())
    }
}

impl Kernel for Ovus {
    fn bounds(&self) -> Aabb {
        let widest =
            if (self.ends[0]..=self.ends[1]).contains(&self.middle.y) { self.arc - self.middle.x } else { 0.0 };
        let across = match self.arc {
            0.0 => self.top,
            _ => widest.max(self.bottom).max(self.top),
        };
        let low = if self.arc == 0.0 { self.bottom - self.top } else { -self.bottom };
        let high = self.bottom + self.top;
        Aabb { min: DVec3::new(-across, low, -across), max: DVec3::new(across, high, across) }
    }

    /// Box of the ovus, as wide as the whole circle of its arc (quirk: `extent_boxes`).
    fn pov_bounds(&self, m: &Transform) -> Aabb {
        let Aabb { min, max } = self.bounds();
        let across = (self.arc - self.middle.x).max(max.x);
        transformed_box(m, &Aabb { min: DVec3::new(-across, min.y, -across), max: DVec3::new(across, max.y, across) })
    }

    fn hits(&self, ray: &Ray, range: Range, out: &mut Hits) {
        out.extend(self.entry_and_exit(ray).into_iter().flatten().filter(|hit| range.contains(hit.t)));
    }

    fn inside(&self, p: DVec3) -> bool {
        match p.y {
            y if y <= self.ends[0] => self.ball_of_part(BOTTOM).inside(p),
            y if y >= self.ends[1] => self.ball_of_part(TOP).inside(p),
            _ => self.offset_from_arc_center(p).length_squared() <= self.arc * self.arc,
        }
    }

    fn normal(&self, p: DVec3, hit: &Hit) -> DVec3 {
        if hit.part != BAND {
            let n = p - self.ball_of_part(hit.part).center;
            return if n == DVec3::ZERO { DVec3::Y } else { n };
        }
        let (across, from) = (fp::hypot(p.x, p.z), self.offset_from_arc_center(p));
        let out = if across > 0.0 { from.x / across } else { 0.0 };
        DVec3::new(p.x * out, from.y, p.z * out)
    }

    /// Surface coordinates of an ovus: angle about the axis, and angle seen from the middle of the height (quirk:
    /// `ovus_uv`).
    fn uv(&self, p: DVec3, _: &Hit) -> DVec2 {
        let height = p.y - self.bounds().center().y;
        DVec2::new(
            fp::positive_angle_in_turns(p.z, p.x),
            2.0 * fp::positive_angle_in_turns(fp::hypot(p.x, p.z), -height),
        )
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::shape::testing::{all_hits, read_shape};

    /// POV-Ray's `trace()` from (-9, y, 0) along x: distance from the axis, and the normal outwards and up.
    #[test]
    fn as_pov_ray_traces() {
        for (bottom, top, y, x, out, up) in [
            (1.0, 0.5, -0.4, 0.9165151, 0.91652, -0.4),
            (1.0, 0.5, 0.2, 0.9812603, 0.98671, 0.1625),
            (1.0, 0.5, 1.2, 0.5059671, 0.74906, 0.6625),
            (1.0, 0.5, 1.4, 0.3, 0.6, 0.8),
            (0.5, 0.8, -0.2, 0.4995085, 0.77045, -0.6375),
            (0.5, 0.8, 0.2, 0.7416198, 0.92702, -0.375),
            (0.5, 0.8, 1.2, 0.3872983, 0.48412, 0.875),
            (1.0, 2.2, -1.0, 0.9165151, 0.4166, -0.90909),
        ] {
            let egg = Ovus::new(bottom, top);
            let ray = Ray::new(DVec3::new(-9.0, y, 0.0), DVec3::X * 3.0);
            let hits = all_hits(&egg, &ray);
            assert_eq!(hits.len(), 2, "{egg:?} {y}");
            for (hit, side) in hits.iter().zip([-1.0, 1.0]) {
                let n = egg.normal(ray.at(hit.t), hit).normalize();
                assert!((ray.at(hit.t).x - side * x).abs() < 1e-6, "{egg:?} {hit:?}");
                assert!(n.distance(DVec3::new(side * out, up, 0.0)) < 1e-4, "{egg:?} {n}");
            }
            assert!(egg.inside(DVec3::new(x - 1e-6, y, 0.0)) && !egg.inside(DVec3::new(x + 1e-6, y, 0.0)));
        }
    }

    #[test]
    fn extents_and_reading() {
        let far = |bottom: f64, top: f64| Ovus::new(bottom, top).pov_bounds(&Transform::IDENTITY).max;
        assert!(far(1.0, 0.5).distance(DVec3::new(1.007843, 1.5, 1.007843)) < 1e-6);
        assert!(far(0.5, 0.8).distance(DVec3::new(0.866788, 1.3, 0.866788)) < 1e-6);
        assert_eq!(far(1.0, 2.2), DVec3::new(2.2, 3.2, 2.2));
        assert_eq!(far(1.0, 0.0), DVec3::new(2.0, 1.0, 2.0));
        assert_eq!(read_shape::<Ovus>("1 -1").0.unwrap_err().code, codes::BAD_ARGUMENT);
        assert_eq!(read_shape::<Ovus>("NaN 1").0.unwrap_err().code, codes::NOT_FINITE);
        assert_eq!(read_shape::<Ovus>("0 0").1[0].code, codes::NO_SURFACE);
        assert!(read_shape::<Ovus>("1 0.5 sturm").1.is_empty());
    }
}
