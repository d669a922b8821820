//! A shape with its transform, and hits on such a shape.

use super::halfspace::{self, HalfSpace};
use super::instance::Instance;
use crate::math::packet::{Numbers, RayPacket};
use crate::math::registers::wide_versions;
use crate::math::{Aabb, DVec2, DVec3, Quadratic, Range, Ray, Transform, tolerance};
use crate::shape::{Hit, Hits, Kernel, PacketHits, Shape};
use crate::value::SharedDefault;
use serde::Serialize;
use smallvec::SmallVec;
use std::sync::Arc;

/// A shape placed in the world by a transform.
#[derive(Clone, Debug, Serialize)]
pub struct Leaf {
    /// Shape in object space, which instances share.
    pub shape: Shape,
    /// Transform from object to world space; `None` for the identity.
    pub(super) place: Option<Arc<Transform>>,
    /// True if the shape is inverted, which exchanges inside and outside.
    pub inverse: bool,
    /// Index of the shape's properties in [`super::World::parts`], before the offset of an instance.
    pub id: u32,
}

/// A hit on a shape.
#[derive(Clone, Copy, Debug)]
pub struct Intersection<'a> {
    /// Hit in object space, except for the distance `t`, which is the same in all spaces.
    pub hit: Hit,
    /// The shape that was hit.
    pub leaf: &'a Leaf,
    /// Number of the hit object, [`super::SolidNode::object`] of the outermost node.
    pub object: u32,
    /// Instance that contains the hit shape.
    pub(super) instance: Option<&'a Instance>,
}

/// Hits on the shapes of a solid.
pub type Intersections<'a> = SmallVec<[Intersection<'a>; 8]>;

/// Point and normal of a hit, in world space.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Surface {
    /// Point of the hit in world space.
    pub point: DVec3,
    /// Outward normal in world space, length 1.
    pub normal: DVec3,
    /// Point of the hit in object space.
    pub object_point: DVec3,
}

impl Leaf {
    /// Places a shape by `transform`, from object to world space.
    pub fn new(shape: Shape, transform: &Transform, id: u32) -> Self {
        Self::placed(shape, &SharedDefault::new(*transform), id)
    }

    /// Places a shape by a transform that other shapes share.
    pub(super) fn placed(shape: Shape, transform: &SharedDefault<Transform>, id: u32) -> Self {
        Self { shape, place: non_identity(transform), inverse: false, id }
    }

    /// Returns the transform from object to world space.
    pub fn transform(&self) -> Transform {
        self.place.as_deref().copied().unwrap_or(Transform::IDENTITY)
    }

    /// Exchanges inside and outside; an open surface stays unchanged.
    pub(super) fn inverted(self) -> Self {
        let inverse = if self.shape.is_open() { self.inverse } else { !self.inverse };
        Self { inverse, ..self }
    }

    /// Returns the result of `find` for a ray in object space, M⁻¹·ray. (A function that returned the ray would copy it, and
    /// each use would wait for the copy.)
    #[inline(always)]
    pub(super) fn with_local_ray<T>(&self, ray: &Ray, find: impl FnOnce(&Ray) -> T) -> T {
        match &self.place {
            Some(m) => find(&m.inverse_transform_ray(ray)),
            None => find(ray),
        }
    }

    #[inline]
    pub(super) fn closest(&self, ray: &Ray, range: Range) -> Option<Hit> {
        self.with_local_ray(ray, |local| self.shape.closest(local, range))
    }

    /// Stores the closest hit of a ray on the shape, as a hit on the object with this number, in `out`, and returns true;
    /// false without a hit.
    #[inline]
    pub(super) fn find_closest<'a>(
        &'a self,
        ray: &Ray,
        range: Range,
        object: u32,
        out: &mut Option<Intersection<'a>>,
    ) -> bool {
        let Some(Hit { t, part, uv }) = self.closest(ray, range) else { return false };
        *out = Some(Intersection::new(Hit { t, part, uv }, self, object));
        true
    }

    #[inline]
    pub(super) fn any(&self, ray: &Ray, range: Range) -> bool {
        self.with_local_ray(ray, |local| self.shape.any_hit(local, range))
    }

    pub(super) fn hits(&self, ray: &Ray, range: Range, out: &mut Hits) {
        self.with_local_ray(ray, |local| self.shape.hits(local, range, out))
    }

    /// Appends the hits that a CSG object or a clipping solid can use, which may be fewer than all; see
    /// [`Kernel::limited_hits_for_csg`]. The caller clips them.
    pub(super) fn limited_hits_for_csg(&self, ray: &Ray, range: Range, out: &mut Hits) {
        self.with_local_ray(ray, |local| self.shape.limited_hits_for_csg(local, range, out))
    }

    #[inline]
    pub(super) fn inside(&self, p: DVec3) -> bool {
        let local = self.place.as_ref().map_or(p, |m| m.inverse_transform_point(p));
        !self.shape.is_open() && self.shape.inside(local) != self.inverse
    }

    /// Returns the quadratic form, in world space, that is not positive inside the shape; `None` if no quadric.
    pub(super) fn quadratic(&self) -> Option<Quadratic> {
        let local = self.local_quadratic()?;
        Some(self.place.as_ref().map_or(local, |m| local.transformed(m)))
    }

    /// Returns the quadratic form, in object space, that is not positive inside the solid; `None` if no quadric.
    fn local_quadratic(&self) -> Option<Quadratic> {
        let own = self.shape.bounding_quadratic()?;
        Some(if self.inverse { own.negated() } else { own })
    }

    /// Returns a box, in world space, around the points in all half-spaces `planes` that are inside the shape, or outside if
    /// it is inverted; `None` if the shape is no quadric or the points are unbounded. Half-spaces count whose faces are
    /// perpendicular to an axis of the shape's own space, however shape and half-spaces are rotated together.
    pub(super) fn quadric_bounds_between(&self, planes: &[HalfSpace]) -> Option<Aabb> {
        let transform = self.transform();
        let slabs = halfspace::slabs_in_object_space(planes, &transform);
        let local = self.local_quadratic()?.nonpositive_bounds_within(slabs);
        (local.min.is_finite() && local.max.is_finite()).then(|| loosened(transform.transform_aabb(&local)))
    }

    /// Returns a box around all hits and a box around all inside points, in world space.
    pub(super) fn surface_and_solid_bounds(&self) -> (Aabb, Aabb) {
        let surface = loosened(match &self.place {
            Some(m) => self.shape.bounds_under(m),
            None => self.shape.bounds(),
        });
        let solid = match self.inverse {
            _ if self.shape.is_open() => Aabb::EMPTY,
            true => Aabb::INFINITE,
            false if self.shape.is_solid_unbounded() => Aabb::INFINITE,
            false => match (self.shape.solid_bounds(), &self.place) {
                (None, _) => surface,
                (Some(solid), Some(m)) => loosened(m.transform_aabb(&solid)),
                (Some(solid), None) => loosened(solid),
            },
        };
        (surface, solid)
    }
}

impl Leaf {
    /// Returns the rays of a packet in the shape's space; `buffer` holds them if they are not the same.
    #[inline(always)]
    pub(super) fn local_rays<'r>(&self, rays: &'r RayPacket, buffer: &'r mut Option<RayPacket>) -> &'r RayPacket {
        match &self.place {
            Some(m) => buffer.insert(rays.inverse_transformed(m)),
            None => rays,
        }
    }
}

wide_versions! {
    /// Returns the closest hits of the rays of a packet on a shape that traces packets, see [`Kernel::closest_of_packet`].
    pub(super) fn closest_of_packet(leaf: &Leaf, rays: &RayPacket, min: f64, max: &Numbers) -> PacketHits {
        leaf.shape.closest_of_packet(leaf.local_rays(rays, &mut None), min, max)
    }
}

/// Returns the transform; `None` for the identity.
pub(super) fn non_identity(transform: &SharedDefault<Transform>) -> Option<Arc<Transform>> {
    transform.explicit_value().filter(|transform| !transform.is_identity()).cloned()
}

impl<'a> Intersection<'a> {
    /// Creates the hit on a shape of the object with the number `object`.
    pub(super) fn new(hit: Hit, leaf: &'a Leaf, object: u32) -> Self {
        Self { hit, leaf, object, instance: None }
    }
}

impl Intersection<'_> {
    /// Returns the distance of the hit along the ray.
    pub fn t(&self) -> f64 {
        self.hit.t
    }

    /// Returns the index of the hit shape's properties in [`super::World::parts`].
    pub fn part_number(&self) -> u32 {
        self.instance.map_or(self.leaf.id, |instance| instance.part_number_of(self.leaf))
    }

    /// True if this hit wins against `other`: closer, or at the same point on an object that was declared earlier.
    pub(super) fn wins_against(&self, other: &Intersection) -> bool {
        self.hit.t < other.hit.t || (self.hit.t == other.hit.t && self.part_number() < other.part_number())
    }

    /// True if the hit shape is inverted.
    pub fn is_on_inverted_shape(&self) -> bool {
        self.leaf.inverse
    }

    /// True if the hit shape was inverted but its textures keep their sides (quirk: `quadric_keeps_sides`).
    pub fn keeps_texture_sides(&self) -> bool {
        self.leaf.inverse && self.leaf.shape.quirks().keeps_texture_sides
    }

    /// Returns the surface coordinates at `object_point` of [`Intersection::surface`].
    pub fn uv(&self, object_point: DVec3) -> DVec2 {
        self.leaf.shape.uv(object_point, &self.hit)
    }

    /// Returns the coordinates for `uv_mapping`: surface coordinates, or x and y in world space for a shape without a
    /// mapping (quirk: `uv_of_world_point`).
    pub fn mapped_uv(&self, surface: &Surface) -> DVec2 {
        if self.leaf.shape.has_uv_mapping() { self.uv(surface.object_point) } else { surface.point.truncate() }
    }

    /// Returns point and normal of this hit of `ray` (lecture, "Ray – transformed object intersection": points by M,
    /// normals by M⁻ᵀ).
    pub fn surface(&self, ray: &Ray) -> Surface {
        let Leaf { shape, place, inverse, .. } = self.leaf;
        let object_point = self.object_point(ray);
        let (mut point, mut normal) = (object_point, shape.normal(object_point, &self.hit));
        if let Some(m) = place {
            (point, normal) = (m.transform_point(point), m.transform_normal(normal));
        }
        if let Some(m) = self.instance.and_then(Instance::world_from_instance) {
            (point, normal) = (m.transform_point(point), m.transform_normal(normal));
        }
        let normal = if *inverse { -normal } else { normal };
        Surface { point, normal: normal.try_normalize().unwrap_or(-ray.dir), object_point }
    }

    /// Returns the point of the surface in world space, the same as that of [`Self::surface`].
    pub fn point(&self, ray: &Ray) -> DVec3 {
        let around = self.instance.and_then(Instance::world_from_instance);
        let places = [self.leaf.place.as_deref(), around].into_iter().flatten();
        places.fold(self.object_point(ray), |p, m| m.transform_point(p))
    }

    /// Returns the point of the surface in the space of the leaf's shape.
    fn object_point(&self, ray: &Ray) -> DVec3 {
        let point = |ray: &Ray| self.leaf.with_local_ray(ray, |local| local.at(self.hit.t));
        self.instance.map_or_else(|| point(ray), |instance| point(&instance.local(ray)))
    }
}

/// Grows a box slightly, so that no hit is outside because of rounding.
pub(super) fn loosened(b: Aabb) -> Aabb {
    if b.is_empty() {
        return Aabb::EMPTY;
    }
    let finite = |v: DVec3| v.map(|x| if x.is_finite() { x.abs() } else { 0.0 }).max_element();
    b.grown(tolerance::BOUNDS * finite(b.min).max(finite(b.max)).max(1.0))
}
