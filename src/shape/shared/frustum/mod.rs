//! Common part of `cylinder` and `cone`: a wall around an axis with a linear radius, and two end discs.

mod packet;

use crate::math::{Aabb, DVec2, DVec3, Range, Ray, Transform, fp, solve_quadratic_with_discriminant, tolerance};
use crate::shape::{Crossing, End, HalfSpaces, Hit, Hits, nearest_hit, pov_bounds};
use crate::value::words::word;
use crate::value::{ValueKind, WordSpec};
use serde::Serialize;
use std::f64::consts::TAU;

/// Number of tangent planes of a cone's or cylinder's wall, for bounds.
const SIDES: usize = 8;

/// Part number of the wall of a cone or cylinder.
pub const WALL: u32 = 0;
/// Part number of a cone's or cylinder's disc around the base point.
pub const BASE: u32 = 1;
/// Part number of a cone's or cylinder's disc around the cap point.
pub const CAP: u32 = 2;

/// Frustum of a cone: a wall around an axis, closed by discs unless `open`. Radii have signs: if the signs differ, the
/// wall is an hourglass through the axis (quirk: `cone_negative_radii`).
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Frustum {
    /// Centre of the frustum's base.
    pub base: DVec3,
    /// Centre of the frustum's cap; never equal to the base.
    pub cap: DVec3,
    /// Radius of the frustum at the base.
    pub base_radius: f64,
    /// Radius of the frustum at the cap.
    pub cap_radius: f64,
    /// True if the frustum has no discs at its ends.
    pub open: bool,
    #[serde(skip)]
    frame: Precomputed,
}

/// Constants of a frustum for all rays.
#[derive(Clone, Debug, PartialEq)]
struct Precomputed {
    /// Axis of the frustum divided by its squared length.
    along: DVec3,
    /// Two unit vectors perpendicular to the frustum's axis and each other.
    across: (DVec3, DVec3),
    middle: DVec3,
}

/// A point or direction in the frame of a frustum's axis: `w` is 0 at the base and 1 at the cap, `x` and `y` are
/// lengths perpendicular to the axis.
struct AxisCoordinates {
    w: f64,
    x: f64,
    y: f64,
}

impl AxisCoordinates {
    /// Returns x² + y²: the squared distance of a point from the frustum's axis, or the squared part of a direction across it.
    fn across_squared(&self) -> f64 {
        self.x * self.x + self.y * self.y
    }
}

impl Frustum {
    /// Creates the frustum between two different points.
    pub fn new(base: DVec3, cap: DVec3, base_radius: f64, cap_radius: f64, open: bool) -> Self {
        let axis = cap - base;
        let frame = Precomputed {
            along: axis / axis.length_squared(),
            across: axis.normalize().any_orthonormal_pair(),
            middle: 0.5 * (base + cap),
        };
        Self { base, cap, base_radius, cap_radius, open, frame }
    }

    fn axis(&self) -> DVec3 {
        self.cap - self.base
    }

    /// Radius of the frustum at the fraction `axis_fraction` of the axis from base to cap.
    fn radius_at(&self, axis_fraction: f64) -> f64 {
        self.base_radius + axis_fraction * (self.cap_radius - self.base_radius)
    }

    fn to_axis_frame(&self, v: DVec3) -> AxisCoordinates {
        let Precomputed { along, across: (x, y), .. } = &self.frame;
        AxisCoordinates { w: v.dot(*along), x: v.dot(*x), y: v.dot(*y) }
    }

    /// True if the frustum has no surface.
    pub fn is_empty(&self) -> bool {
        self.base_radius == 0.0 && self.cap_radius == 0.0
    }

    /// Bounding box of both end circles of the frustum.
    pub fn bounds(&self) -> Aabb {
        if self.is_empty() {
            return Aabb::EMPTY;
        }
        // A circle with normal n extends r·√(1 - nᵢ²) along axis i.
        let n = self.axis().normalize();
        let reach = (DVec3::ONE - n * n).max(DVec3::ZERO).map(f64::sqrt);
        let around = |c: DVec3, r: f64| Aabb { min: c - reach * r.abs(), max: c + reach * r.abs() };
        around(self.base, self.base_radius).union(around(self.cap, self.cap_radius))
    }

    /// Returns a ray in the frustum's frame, relative to its point nearest to the centre, so that a distant eye costs
    /// no digits: `t` of that point, the point, and the direction.
    fn t_point_direction_near_center(&self, ray: &Ray) -> (f64, AxisCoordinates, AxisCoordinates) {
        let shift = (self.frame.middle - ray.origin).dot(ray.dir) / ray.dir.length_squared();
        (shift, self.to_axis_frame(ray.at(shift) - self.base), self.to_axis_frame(ray.dir))
    }

    /// True if the frustum is a cylinder with both end discs.
    fn is_closed_cylinder(&self) -> bool {
        !self.open && self.base_radius == self.cap_radius
    }

    /// Returns the closest hit on the frustum in the range.
    pub fn closest(&self, ray: &Ray, range: Range) -> Option<Hit> {
        if self.is_closed_cylinder() && !self.is_empty() {
            let Crossing::Through(ends) = self.cylinder_interval(ray) else { return None };
            return ends.into_iter().find(|end| range.contains(end.t)).map(Hit::from);
        }
        let mut all = Hits::new();
        self.hits(ray, range, &mut all);
        nearest_hit(&all)
    }

    /// Appends the frustum's hits in the range.
    pub fn hits(&self, ray: &Ray, range: Range, out: &mut Hits) {
        if self.is_empty() {
            return;
        }
        if self.is_closed_cylinder() {
            if let Crossing::Through(ends) = self.cylinder_interval(ray) {
                out.extend(ends.into_iter().filter(|end| range.contains(end.t)).map(Hit::from));
            }
            return;
        }
        let (shift, o, v) = self.t_point_direction_near_center(ray);
        // Roots of |across(s)|² = r(w(s))²
        let dr = self.cap_radius - self.base_radius;
        let (r, slope) = (self.radius_at(o.w), v.w * dr);
        // half_b² - a·c without the squares that cancel: (v×o)² is what remains of (o·v)² - v²·o².
        let (tx, ty) = (v.x * r - o.x * slope, v.y * r - o.y * slope);
        let turn = o.x * v.y - o.y * v.x;
        let disc = tx * tx + ty * ty - turn * turn;
        if disc < 0.0 {
            // A line that misses the wall misses the discs too.
            return;
        }
        let a = v.across_squared() - slope * slope;
        let half_b = o.x * v.x + o.y * v.y - slope * r;
        let c = o.across_squared() - r * r;
        let mut push = |s: f64, part: u32| {
            if range.contains(s + shift) {
                out.push(Hit::on_piece(s + shift, part));
            }
        };
        for s in solve_quadratic_with_discriminant(a, half_b, c, disc).into_iter().flat_map(|(s1, s2)| [s1, s2]) {
            if (0.0..=1.0).contains(&(o.w + s * v.w)) {
                push(s, WALL);
            }
        }
        if self.open || v.w == 0.0 {
            return;
        }
        for (w, radius, part) in [(0.0, self.base_radius, BASE), (1.0, self.cap_radius, CAP)] {
            let s = (w - o.w) / v.w;
            let (x, y) = (o.x + s * v.x, o.y + s * v.y);
            if x * x + y * y < radius * radius {
                push(s, part);
            }
        }
    }

    /// Box that POV-Ray reports for the frustum, see [`crate::shape::Kernel::pov_bounds`]: that of a cylinder about the
    /// same axis (quirk: `extent_boxes`).
    pub fn pov_bounds(&self, m: &Transform) -> Aabb {
        let (r, axis) = (self.base_radius.max(self.cap_radius), self.cap - self.base);
        let b = Aabb { min: DVec3::new(-r, -r, 0.0), max: DVec3::new(r, r, axis.length()) };
        pov_bounds::transformed_frame_bounds(m, axis, self.base, &b)
    }

    /// Half-spaces that contain the frustum: of both ends and of tangent planes around the wall.
    pub fn half_spaces(&self) -> HalfSpaces {
        let Self { base, cap, base_radius, cap_radius, .. } = *self;
        let axis = (cap - base).normalize();
        let mut out = HalfSpaces::from_iter([(axis, axis.dot(cap)), (-axis, -axis.dot(base))]);
        let (e1, e2) = axis.any_orthonormal_pair();
        for side in 0..SIDES {
            let (sin, cos) = fp::sin_cos(side as f64 * TAU / SIDES as f64);
            let across = e1 * cos + e2 * sin;
            out.push((across, (across.dot(base) + base_radius.abs()).max(across.dot(cap) + cap_radius.abs())));
        }
        out
    }

    /// True if the point is between the frustum's ends and nearer to the axis than the wall. The boundary belongs to an
    /// open frustum only (quirk: `open_wall_inside`).
    pub fn inside(&self, p: DVec3) -> bool {
        let at = self.to_axis_frame(p - self.base);
        let slack = if self.open { tolerance::INSIDE } else { -tolerance::INSIDE };
        let r = self.radius_at(at.w);
        at.w > -slack && at.w < 1.0 + slack && at.across_squared() < r * r + slack
    }

    /// True if the frustum is convex: with both end discs and no hourglass.
    pub fn is_convex(&self) -> bool {
        !self.open && self.base_radius * self.cap_radius >= 0.0
    }

    /// Interval of a line inside a closed cylinder or cone.
    pub fn crossing(&self, ray: &Ray) -> Crossing {
        if !self.is_convex() {
            return Crossing::Unknown;
        }
        if self.base_radius == self.cap_radius {
            return self.cylinder_interval(ray);
        }
        let mut all = Hits::new();
        self.hits(ray, Range::ALL, &mut all);
        match all[..] {
            [] => Crossing::Misses,
            [a, b] if a.t <= b.t => Crossing::Through([a, b].map(|hit| End::on_piece(hit.t, hit.part))),
            [a, b] => Crossing::Through([b, a].map(|hit| End::on_piece(hit.t, hit.part))),
            // The rim belongs to the wall and to a disc.
            _ => Crossing::Unknown,
        }
    }

    /// Interval of a line inside a closed cylinder: the intersection of the interval between the ends and the interval
    /// within the wall.
    fn cylinder_interval(&self, ray: &Ray) -> Crossing {
        let (shift, o, v) = self.t_point_direction_near_center(ray);
        let r2 = self.base_radius * self.base_radius;
        let mut ends = [End::on_single_piece(f64::NEG_INFINITY), End::on_single_piece(f64::INFINITY)];
        let a = v.across_squared();
        if a > 0.0 {
            let turn = o.x * v.y - o.y * v.x;
            let half_b = o.x * v.x + o.y * v.y;
            let Some((s1, s2)) =
                solve_quadratic_with_discriminant(a, half_b, o.across_squared() - r2, a * r2 - turn * turn)
            else {
                return Crossing::Misses;
            };
            ends = [End::on_piece(s1, WALL), End::on_piece(s2, WALL)];
        } else if o.across_squared() >= r2 {
            return Crossing::Misses;
        }
        if v.w != 0.0 {
            let (base, cap) = (End::on_piece(-o.w / v.w, BASE), End::on_piece((1.0 - o.w) / v.w, CAP));
            let (enter, leave) = if v.w > 0.0 { (base, cap) } else { (cap, base) };
            ends =
                [if enter.t > ends[0].t { enter } else { ends[0] }, if leave.t < ends[1].t { leave } else { ends[1] }];
        } else if !(0.0..=1.0).contains(&o.w) {
            return Crossing::Misses;
        }
        match ends[0].t <= ends[1].t {
            true => Crossing::Through(ends.map(|end| End { t: end.t + shift, ..end })),
            false => Crossing::Misses,
        }
    }

    /// Outward normal at a point of a part of the frustum's surface.
    pub fn normal(&self, p: DVec3, part: u32) -> DVec3 {
        let axis = self.axis();
        match part {
            BASE => -axis,
            CAP => axis,
            _ => {
                // Half the gradient of |across|² - r(w)²
                let at = self.to_axis_frame(p - self.base);
                let dr = self.cap_radius - self.base_radius;
                let across = p - self.base - at.w * axis;
                let n = across - axis * (self.radius_at(at.w) * dr / axis.length_squared());
                // The apex has no normal; use the axis.
                if n.length_squared() > 0.0 { n } else { axis * -dr.signum() }
            }
        }
    }

    /// Angle about the frustum's axis, and height along it. POV-Ray defines no uv mapping for cones and cylinders.
    pub fn uv(&self, p: DVec3, part: u32) -> DVec2 {
        let at = self.to_axis_frame(p - self.base);
        let u = fp::positive_angle_in_turns(at.y, at.x);
        let v = match part {
            WALL => at.w,
            BASE => at.across_squared().sqrt() / self.base_radius.abs(),
            _ => at.across_squared().sqrt() / self.cap_radius.abs(),
        };
        DVec2::new(u, v)
    }
}

/// The word `open` of a cone or cylinder: without end discs.
pub const OPEN: WordSpec = word("open", ValueKind::Nothing, "", "takes the discs at the ends away");

/// Implements [`crate::shape::Kernel`] for a shape that wraps a frustum.
macro_rules! frustum_kernel {
    ($shape:ident) => {
        impl $crate::shape::Kernel for $shape {
            const TRACES_PACKETS: bool = true;

            fn bounds(&self) -> Aabb {
                self.0.bounds()
            }

            fn hits(&self, ray: &Ray, range: Range, out: &mut Hits) {
                self.0.hits(ray, range, out);
            }

            fn closest(&self, ray: &Ray, range: Range) -> Option<Hit> {
                self.0.closest(ray, range)
            }

            #[inline(always)]
            fn closest_of_packet(
                &self,
                rays: &$crate::math::packet::RayPacket,
                min: f64,
                max: &$crate::math::packet::Numbers,
            ) -> $crate::shape::PacketHits {
                self.0.closest_of_packet(rays, min, max)
            }

            fn pov_bounds(&self, m: &$crate::math::Transform) -> Aabb {
                self.0.pov_bounds(m)
            }

            fn half_spaces(&self) -> $crate::shape::HalfSpaces {
                self.0.half_spaces()
            }

            fn inside(&self, p: DVec3) -> bool {
                self.0.inside(p)
            }

            fn is_convex(&self) -> bool {
                self.0.is_convex()
            }

            fn crossing(&self, ray: &Ray) -> $crate::shape::Crossing {
                self.0.crossing(ray)
            }

            fn crosses_packets(&self) -> bool {
                self.0.is_convex()
            }

            #[inline(always)]
            fn crossings_of_packet(&self, rays: &$crate::math::packet::RayPacket) -> $crate::shape::PacketCrossings {
                self.0.crossings_of_packet(rays)
            }

            fn normal(&self, p: DVec3, hit: &Hit) -> DVec3 {
                self.0.normal(p, hit.part)
            }

            fn uv(&self, p: DVec3, hit: &Hit) -> DVec2 {
                self.0.uv(p, hit.part)
            }

            fn has_uv_mapping(&self) -> bool {
                false
            }
        }
    };
}
pub(crate) use frustum_kernel;
