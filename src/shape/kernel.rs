//! What every shape can do: hits, inside, normals and all else that is asked of one, in its own space.

use super::{Face, Quirks, moved_box};
use crate::math::{Aabb, DVec2, DVec3, Quadratic, Range, Ray, Transform};

/// Where a ray meets a surface, in object space.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Hit {
    /// The ray's parameter: the distance in world space, because rays are not renormalised.
    pub t: f64,
    /// Which face or piece of the shape, so that normal and uv need no search.
    pub part: u32,
    /// What the kernel wants to remember of the place, such as barycentric coordinates.
    pub uv: DVec2,
}

impl Hit {
    /// A hit of a shape that has one piece.
    pub fn at(t: f64) -> Self {
        Self::on(t, 0)
    }

    /// A hit of a numbered piece.
    pub fn on(t: f64, part: u32) -> Self {
        Self { t, part, uv: DVec2::ZERO }
    }
}

/// All hits of a ray with one shape.
pub type Hits = smallvec::SmallVec<[Hit; 4]>;

/// The nearest of some hits.
pub(super) fn nearest(hits: &Hits) -> Option<Hit> {
    hits.iter().min_by(|a, b| a.t.total_cmp(&b.t)).copied()
}

/// How a line passes a convex solid.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Crossing {
    /// The shape does not know, or this line is too close to call.
    Unknown,
    /// It never gets in.
    Misses,
    /// In by the first end and out by the second; at an infinite t where there is no such end.
    Through([End; 2]),
    /// Out by the first end and in again by the second.
    Around([End; 2]),
    /// It never gets out.
    Stays,
}

/// Where a line goes into a solid, or out of it: a [`Hit`] that remembers nothing else.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct End {
    /// See [`Hit::t`].
    pub t: f64,
    /// See [`Hit::part`].
    pub part: u32,
}

impl End {
    /// On a shape that has one piece.
    pub fn at(t: f64) -> Self {
        Self::on(t, 0)
    }

    /// On a numbered piece.
    pub fn on(t: f64, part: u32) -> Self {
        Self { t, part }
    }
}

impl From<End> for Hit {
    fn from(end: End) -> Self {
        Hit::on(end.t, end.part)
    }
}

/// Numbers of the textures that a place shows, and their shares, which make up 1. Number 0 is the object's own texture.
pub type TextureWeights = smallvec::SmallVec<[(u32, f64); 3]>;

/// All points p with normal·p ≤ distance.
pub type HalfSpace = (DVec3, f64);

/// Half-spaces that something lies in.
pub type HalfSpaces = smallvec::SmallVec<[HalfSpace; 10]>;

/// What every shape can do, in its own space. Rays come with a direction of any length.
pub trait Kernel {
    /// How POV-Ray's version of the shape departs from this model.
    const QUIRKS: Quirks = Quirks::NONE;

    /// The smallest box around it; infinite where it is.
    fn bounds(&self) -> Aabb;

    /// A box around its image under M: that of its own box, where it does not know better.
    fn bounds_under(&self, m: &Transform) -> Aabb {
        m.aabb(&self.bounds())
    }

    /// The box that `min_extent` and `max_extent` tell of its image under M.
    fn pov_bounds(&self, m: &Transform) -> Aabb {
        moved_box(m, &self.bounds())
    }

    /// Appends every hit with `range.min < t < range.max`, in any order.
    fn hits(&self, ray: &Ray, range: Range, out: &mut Hits);

    /// The same of a part of a CSG object, or of what is clipped, of which POV-Ray may know but the first few (measured on 3.7).
    fn hits_in_csg(&self, ray: &Ray, range: Range, out: &mut Hits) {
        self.hits(ray, range, out);
    }

    /// The nearest hit in the range.
    fn closest(&self, ray: &Ray, range: Range) -> Option<Hit> {
        let mut all = Hits::new();
        self.hits(ray, range, &mut all);
        nearest(&all)
    }

    /// Is there any hit in the range?
    fn any(&self, ray: &Ray, range: Range) -> bool {
        self.closest(ray, range).is_some()
    }

    /// Is the point in the solid? Points on the surface may go either way.
    fn inside(&self, p: DVec3) -> bool;

    /// The half-space that is all of its inside, of such shapes.
    fn as_half_space(&self) -> Option<HalfSpace> {
        None
    }

    /// Half-spaces that its surface and its inside lie in, if it has flat faces or round walls.
    fn half_spaces(&self) -> HalfSpaces {
        self.as_half_space().into_iter().collect()
    }

    /// What is not positive on its surface and inside, of shapes of the second order, which other shapes may cut to a finite size.
    fn quadratic(&self) -> Option<Quadratic> {
        None
    }

    /// The smallest box around its inside, of shapes whose inside reaches out of their bounds and is not cut to those in POV-Ray
    /// either.
    fn solid_bounds(&self) -> Option<Aabb> {
        None
    }

    /// Does its inside reach out of its bounds?
    fn is_solid_unbounded(&self) -> bool {
        false
    }

    /// Is it convex?
    fn is_convex(&self) -> bool {
        false
    }

    /// Can [`Kernel::crossing`] tell of nearly all lines?
    fn knows_crossings(&self) -> bool {
        self.is_convex()
    }

    /// Where a line goes into a solid and out of it, of shapes that know it as one stretch, or all but one.
    fn crossing(&self, _ray: &Ray) -> Crossing {
        Crossing::Unknown
    }

    /// The outward normal at a hit, of any length but zero.
    fn normal(&self, p: DVec3, hit: &Hit) -> DVec3;

    /// Surface coordinates: what `uv_mapping` sees and `durer pick` shows. Shapes that have none keep this, and say so below.
    fn uv(&self, p: DVec3, _hit: &Hit) -> DVec2 {
        p.truncate()
    }

    /// Its triangles in the order in which they were written, of a mesh.
    fn faces(&self) -> Vec<Face> {
        vec![]
    }

    /// True if [`Kernel::uv`] is a mapping of the surface, which `uv_mapping` uses.
    fn has_uv_mapping(&self) -> bool {
        true
    }

    /// What a place shows, of shapes that carry textures.
    fn texture_weights(&self, _p: DVec3, _hit: &Hit) -> TextureWeights {
        smallvec::smallvec![(0, 1.0)]
    }

    /// The shape to place by M instead of this one; `None` for a shape that does not depend on its transform.
    fn changed_under(&self, _m: &Transform) -> Option<Self>
    where
        Self: Sized,
    {
        None
    }

    /// Is it a surface without any inside, which `inverse` can't turn inside out?
    fn is_open(&self) -> bool {
        false
    }

    /// Does it find out about itself when rays ask, so that shapes that are alike had better be one?
    fn caches_lazily(&self) -> bool {
        false
    }
}
