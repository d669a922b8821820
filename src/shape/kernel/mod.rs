//! The interface of all shapes, in object space: bounds, hits, inside, normal, uv.

pub mod pov_bounds;
mod quirks;
#[cfg(test)]
pub mod testing;

pub use pov_bounds::{HUGE, transformed_box};
pub use quirks::{Bounding, Quirks};

use super::{Face, Paints, Shape};
use crate::diagnostic::Result;
use crate::math::packet::{Flags, Numbers, PACKET, RayPacket, Vectors, set_lanes};
use crate::math::{Aabb, DVec2, DVec3, Lanes, Mask, Quadratic, Range, Ray, Transform};
use crate::value::{Next, Reader};

/// A point where a ray hits a surface, in object space.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Hit {
    /// Parameter of the ray at the hit. Rays are not renormalised, so `t` is the distance in world space.
    pub t: f64,
    /// Number of the face or piece of the shape that was hit, so that normal and uv need no search.
    pub part: u32,
    /// Data of the shape's kernel for this hit, such as barycentric coordinates.
    pub uv: DVec2,
}

impl Hit {
    /// Creates a hit on a shape of one piece.
    pub fn on_single_piece(t: f64) -> Self {
        Self::on_piece(t, 0)
    }

    /// Creates a hit on a numbered piece of a shape.
    pub fn on_piece(t: f64, part: u32) -> Self {
        Self { t, part, uv: DVec2::ZERO }
    }
}

/// Closest hits of the rays of a packet on one shape, without data of the kernel.
#[derive(Clone, Copy, Debug)]
pub struct PacketHits {
    /// True for the rays that hit the shape.
    pub is_hit: Flags,
    /// Parameter of each ray at its hit, see [`Hit::t`].
    pub t: Numbers,
    /// Part of the surface that each ray hits, see [`Hit::part`].
    pub part: [u32; PACKET],
}

impl PacketHits {
    /// Hits of rays that all miss the shape.
    pub const NONE: Self = Self { is_hit: Mask::NONE, t: Lanes([0.0; PACKET]), part: [0; PACKET] };

    /// Replaces the hits of the rays `is_hit` by hits at `t` on a part of the surface, if these are at distances above `min` and
    /// before the hits so far. (Before the first, `t` is the end of the ray's range.)
    #[inline(always)]
    pub fn keep_if_closer(&mut self, is_hit: Flags, t: Numbers, part: u32, min: f64) {
        let is_closer = is_hit & Lanes::splat(min).less_than(t) & t.less_than(self.t);
        self.part = is_closer.select_u32([part; PACKET], self.part);
        (self.is_hit, self.t) = (self.is_hit | is_closer, is_closer.select(t, self.t));
    }
}

/// Intervals of the lines of a packet inside a solid, see [`Crossing`].
#[derive(Clone, Copy, Debug)]
pub struct PacketCrossings {
    /// True for the lines whose intervals the shape computes.
    pub is_known: Flags,
    /// Parameters of the ends of each line's interval, which can be infinite. The first is after the second for a line without
    /// ends.
    pub t: [Numbers; 2],
    /// Parts of the surface at the ends; see [`Hit::part`].
    pub part: [[u32; PACKET]; 2],
    /// True for the lines that are inside the solid except between the ends.
    pub is_around: Flags,
}

impl PacketCrossings {
    /// Lines that are all outside the solid.
    pub const MISSES: Self = Self {
        is_known: Mask::ALL,
        t: [Lanes([f64::INFINITY; PACKET]), Lanes([f64::NEG_INFINITY; PACKET])],
        part: [[0; PACKET]; 2],
        is_around: Mask::NONE,
    };

    /// Lines whose intervals are not known.
    pub const UNKNOWN: Self = Self { is_known: Mask::NONE, ..Self::MISSES };

    /// Creates the intervals of lines that are inside the solid between two ends if `crosses` is true, and nowhere if not.
    #[inline(always)]
    pub fn through(crosses: Flags, t: [Numbers; 2], part: [[u32; PACKET]; 2]) -> Self {
        let [none_before, none_after] = Self::MISSES.t;
        let t = [crosses.select(t[0], none_before), crosses.select(t[1], none_after)];
        Self { t, part, ..Self::MISSES }
    }

    /// Returns the first end of each interval that is in the range from `min` to the number in `max`. The intervals must be known.
    #[inline(always)]
    pub fn first_in_range(&self, min: f64, max: &Numbers) -> PacketHits {
        let Self { t: [t1, t2], part: [part1, part2], .. } = *self;
        let (first, second) = (is_between(min, t1, max), is_between(min, t2, max));
        PacketHits { is_hit: first | second, t: first.select(t1, t2), part: first.select_u32(part1, part2) }
    }
}

/// True for the numbers of `t` above `min` and below those of `max`.
#[inline(always)]
fn is_between(min: f64, t: Numbers, max: &Numbers) -> Flags {
    Lanes::splat(min).less_than(t) & t.less_than(*max)
}

/// All hits of a ray on one shape.
pub type Hits = smallvec::SmallVec<[Hit; 4]>;

/// Returns the hit with the smallest `t`.
pub fn nearest_hit(hits: &Hits) -> Option<Hit> {
    hits.iter().min_by(|a, b| a.t.total_cmp(&b.t)).copied()
}

/// Intervals of a line inside a solid.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Crossing {
    /// Interval of a line that the shape does not compute, also where the line is too close to an edge.
    Unknown,
    /// Line that is outside the solid everywhere.
    Misses,
    /// Line that is inside the solid between two ends, which can be infinite.
    Through([End; 2]),
    /// Line that is inside the solid except between two ends.
    Around([End; 2]),
    /// Line that is inside the solid everywhere.
    Stays,
}

/// End of a line's interval inside a solid: a [`Hit`] without the kernel's data.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct End {
    /// Parameter of the hit along the ray; see [`Hit::t`].
    pub t: f64,
    /// Part of the surface that the ray hits; see [`Hit::part`].
    pub part: u32,
}

impl End {
    /// Creates the end of an interval at a surface of one piece.
    pub fn on_single_piece(t: f64) -> Self {
        Self::on_piece(t, 0)
    }

    /// Creates the end of an interval at a numbered piece of the surface.
    pub fn on_piece(t: f64, part: u32) -> Self {
        Self { t, part }
    }
}

impl From<End> for Hit {
    fn from(end: End) -> Self {
        Hit::on_piece(end.t, end.part)
    }
}

/// Numbers of the textures at a point of an object with their weights, which sum to 1. Number 0 is the object's own
/// texture; the embedded textures are counted from 1.
pub type TextureWeights = smallvec::SmallVec<[(u32, f64); 3]>;

/// Half-space: all points p with normal·p ≤ distance.
pub type HalfSpace = (DVec3, f64);

/// Half-spaces whose intersection contains a shape.
pub type HalfSpaces = smallvec::SmallVec<[HalfSpace; 10]>;

/// Interface of a shape's kernel, in object space. Rays have directions of any length.
pub trait Kernel {
    /// Departures of POV-Ray's shape from this shape's model.
    const QUIRKS: Quirks = Quirks::NONE;

    /// True for shapes that compute the hits of several rays side by side; false for those that trace one ray at a time.
    const TRACES_PACKETS: bool = false;

    /// Departures of POV-Ray's shape from this model, [`Kernel::QUIRKS`].
    fn quirks(&self) -> &'static Quirks {
        &Self::QUIRKS
    }

    /// Bounding box of the shape; infinite for an infinite shape.
    fn bounds(&self) -> Aabb;

    /// Bounding box of the shape under the transform M; by default around the corners of [`Kernel::bounds`].
    fn bounds_under(&self, m: &Transform) -> Aabb {
        m.transform_aabb(&self.bounds())
    }

    /// The box that POV-Ray's `min_extent` and `max_extent` return under the transform M (quirk: `extent_boxes`).
    fn pov_bounds(&self, m: &Transform) -> Aabb {
        transformed_box(m, &self.bounds())
    }

    /// Appends every hit on the shape with `range.min < t < range.max`, in any order.
    fn hits(&self, ray: &Ray, range: Range, out: &mut Hits);

    /// Appends the hits that a CSG object or a clipping solid can use, in any order. They can be fewer than all: in front
    /// of the ray's origin, only the first `max_trace` of an isosurface (manual, "Isosurface"), and only the first of a
    /// `parametric` (quirk: `parametric_in_csg`).
    fn limited_hits_for_csg(&self, ray: &Ray, range: Range, out: &mut Hits) {
        self.hits(ray, range, out);
    }

    /// Returns the closest hit on the shape in the range.
    fn closest(&self, ray: &Ray, range: Range) -> Option<Hit> {
        let mut all = Hits::new();
        self.hits(ray, range, &mut all);
        nearest_hit(&all)
    }

    /// True if [`Kernel::closest_of_packet`] computes hits, see [`Kernel::TRACES_PACKETS`].
    fn traces_packets(&self) -> bool {
        Self::TRACES_PACKETS
    }

    /// Returns the closest hits of the rays of a packet, each in the range from `min` to the number in `max`; `min` is not
    /// negative. Only for shapes that [trace packets](Kernel::TRACES_PACKETS).
    #[inline(always)]
    fn closest_of_packet(&self, _rays: &RayPacket, _min: f64, _max: &Numbers) -> PacketHits {
        PacketHits::NONE
    }

    /// True if the ray has any hit on the shape in the range.
    fn any_hit(&self, ray: &Ray, range: Range) -> bool {
        self.closest(ray, range).is_some()
    }

    /// True if the point is inside the shape. On the surface either answer is allowed.
    fn inside(&self, p: DVec3) -> bool;

    /// The half-space that equals the inside of the shape; `None` for other shapes.
    fn as_half_space(&self) -> Option<HalfSpace> {
        None
    }

    /// Half-spaces that contain the shape's surface and inside; none for a shape without flat faces or round walls.
    fn half_spaces(&self) -> HalfSpaces {
        self.as_half_space().into_iter().collect()
    }

    /// The quadratic form that is not positive on the surface and inside; `None` for shapes that are not quadrics. It
    /// bounds intersections.
    fn bounding_quadratic(&self) -> Option<Quadratic> {
        None
    }

    /// Bounding box of the shape's inside, for a shape whose inside extends beyond [`Kernel::bounds`] but not in all
    /// directions.
    fn solid_bounds(&self) -> Option<Aabb> {
        None
    }

    /// True if the shape's inside extends beyond [`Kernel::bounds`].
    fn is_solid_unbounded(&self) -> bool {
        false
    }

    /// True if the solid is convex.
    fn is_convex(&self) -> bool {
        false
    }

    /// True if [`Kernel::crossing`] returns the intervals of nearly all lines.
    fn computes_crossings(&self) -> bool {
        self.is_convex()
    }

    /// Returns the interval of a line inside the solid, for shapes that a line crosses at most once.
    fn crossing(&self, _ray: &Ray) -> Crossing {
        Crossing::Unknown
    }

    /// True if [`Kernel::crossings_of_packet`] computes intervals, those that [`Kernel::crossing`] returns.
    fn crosses_packets(&self) -> bool {
        false
    }

    /// Returns the intervals of the lines of a packet inside the solid, see [`Kernel::crossing`].
    #[inline(always)]
    fn crossings_of_packet(&self, _rays: &RayPacket) -> PacketCrossings {
        PacketCrossings::UNKNOWN
    }

    /// Outward normal of the shape at a hit, of any length but zero.
    fn normal(&self, p: DVec3, hit: &Hit) -> DVec3;

    /// Normals at the hits of the rays `lanes` of a packet, given as bits, see [`Kernel::normal`]. The others are any vectors.
    #[inline(always)]
    fn normals_of_packet(&self, points: &Vectors, hits: &[Hit; PACKET], lanes: u32) -> Vectors {
        let mut normals = Vectors::ZERO;
        for lane in set_lanes(lanes) {
            normals.set_lane(lane, self.normal(points.lane(lane), &hits[lane]));
        }
        normals
    }

    /// Surface coordinates of a point of the shape, for `uv_mapping` and `durer pick`.
    fn uv(&self, p: DVec3, _hit: &Hit) -> DVec2 {
        p.truncate()
    }

    /// Triangles of a mesh, in the order written; empty for shapes other than meshes.
    fn mesh_faces(&self) -> Vec<Face> {
        vec![]
    }

    /// True if [`Kernel::uv`] is a mapping that `uv_mapping` uses.
    fn has_uv_mapping(&self) -> bool {
        true
    }

    /// Reads one of the shape's own words that can embed textures, such as a blob's component, if it is next; returns
    /// false otherwise. All other words belong to [`Readable::read_own`](crate::value::Readable::read_own).
    ///
    /// # Errors
    /// A diagnostic at the first item that is not understood.
    fn read_textured(&mut self, _next: Next, _r: &mut dyn Reader, _paints: &mut dyn Paints) -> Result<bool> {
        Ok(false)
    }

    /// Embedded textures of the shape at a point, with their weights.
    fn texture_weights(&self, _p: DVec3, _hit: &Hit) -> TextureWeights {
        smallvec::smallvec![(0, 1.0)]
    }

    /// Returns the shape to use under the transform M; `None` to use this one unchanged.
    fn adapted_to_transform(&self, _m: &Transform) -> Option<Shape> {
        None
    }

    /// True for a surface without inside, which `inverse` does not change.
    fn is_open(&self) -> bool {
        false
    }

    /// True if the shape builds caches lazily while tracing; equal shapes then share one instance.
    fn caches_lazily(&self) -> bool {
        false
    }
}
