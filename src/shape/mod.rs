//! Shapes in object space: bounds, hits, inside, normal, uv. To add a shape, add a file here and a name to the list
//! below.

mod algebraic;
mod bicubic_patch;
mod blob;
mod cone;
mod cuboid;
mod cylinder;
mod disc;
mod height_field;
mod isosurface;
mod julia_fractal;
mod kernel;
mod lathe;
mod mesh;
mod ovus;
mod parametric;
mod plane;
mod polygon;
mod prism;
mod quadric;
mod shared;
mod smooth_triangle;
mod sor;
mod sphere;
mod sphere_sweep;
mod superellipsoid;
mod text;
mod torus;
mod triangle;

pub use algebraic::{Algebraic, Cubic, Poly, Polynomial, Quartic};
pub use bicubic_patch::BicubicPatch;
pub use blob::Blob;
pub use cone::Cone;
pub use cuboid::Cuboid;
pub use cylinder::Cylinder;
pub use disc::Disc;
pub use height_field::HeightField;
pub use isosurface::Isosurface;
pub use julia_fractal::{Algebra, Function, JuliaFractal};
#[cfg(test)]
use kernel::testing;
pub use kernel::{
    Bounding, Crossing, End, HUGE, HalfSpace, HalfSpaces, Hit, Hits, Kernel, PacketCrossings, PacketHits, Quirks,
    TextureWeights, transformed_box,
};
use kernel::{nearest_hit, pov_bounds};
pub use lathe::Lathe;
pub use mesh::{Face, Mesh, Mesh2, TriangleMesh};
pub use ovus::Ovus;
pub use parametric::Parametric;
pub use plane::{Plane, Spanned};
pub use polygon::Polygon;
pub use prism::Prism;
pub use quadric::Quadric;
pub use shared::{Container, Curve, Formula, Frustum, Interpolation};
pub use smooth_triangle::SmoothTriangle;
pub use sor::Sor;
pub use sphere::Sphere;
pub use sphere_sweep::{SphereSweep, SweepKind};
pub use superellipsoid::Superellipsoid;
pub use text::Text;
pub use torus::Torus;
pub use triangle::Triangle;

use shared::{formula, frustum, spline, turned};

use crate::diagnostic::{Diagnostic, Fault, Result, codes};
use crate::image_io::Picture;
use crate::math::packet::{Numbers, PACKET, RayPacket, Vectors};
use crate::math::{Aabb, DVec2, DVec3, Quadratic, Range, Ray, Transform};
use crate::mesh_io::MeshMaterial;
use crate::source::Span;
use crate::value::{Family, Next, Reader, Spec, delegate, family};
use std::borrow::Cow;
use std::sync::Arc;

/// Storage of the textures that are embedded in a shape, numbered from 1.
pub trait Paints {
    /// Reads an embedded texture or a part of one, if it is next; returns false otherwise. `number_or_0` is the number of
    /// the embedded texture so far, or 0 without one, and is updated.
    ///
    /// # Errors
    /// A diagnostic at the first item that is not understood.
    fn read_embedded_texture(&mut self, number_or_0: &mut u32, next: Next, r: &mut dyn Reader) -> Result<bool>;

    /// Reads one embedded texture of a list, in which consecutive textures are not layers, and returns its number;
    /// `None` if no texture is next.
    ///
    /// # Errors
    /// A diagnostic at the first item that is not understood.
    fn read_listed_texture(&mut self, next: Next, r: &mut dyn Reader) -> Result<Option<u32>>;

    /// Adds the texture of a material in a mesh file, with its picture if that was found, and returns its number.
    ///
    /// # Errors
    /// A diagnostic if the material has no equivalent.
    fn add_mesh_material(
        &mut self,
        material: &MeshMaterial,
        picture: Option<&Arc<Picture>>,
        r: &mut dyn Reader,
    ) -> Result<u32>;

    /// Transforms one embedded texture and updates its number, because other users of the same texture keep theirs. 0, for
    /// no embedded texture, stays unchanged.
    fn transform(&mut self, number_or_0: &mut u32, by: &Transform);
}

family! {
    /// Any shape of the language. A closed set, so that rays need no virtual calls. Clones share the kernel.
    pub enum Shape in Arc {
        Sphere Cuboid Cylinder Cone Torus Disc Plane Triangle SmoothTriangle Polygon Mesh Mesh2 Text Blob Quadric Cubic Quartic Poly
        Polynomial Superellipsoid Lathe Sor Prism HeightField Isosurface Parametric SphereSweep BicubicPatch JuliaFractal Ovus
    }
}

delegate! {
    impl Kernel for Shape {
        fn quirks(&self) -> &'static Quirks;
        fn bounds(&self) -> Aabb;
        fn bounds_under(&self, m: &Transform) -> Aabb;
        fn pov_bounds(&self, m: &Transform) -> Aabb;
        fn hits(&self, ray: &Ray, range: Range, out: &mut Hits);
        fn limited_hits_for_csg(&self, ray: &Ray, range: Range, out: &mut Hits);
        fn closest(&self, ray: &Ray, range: Range) -> Option<Hit>;
        #[inline(always)]
        fn closest_of_packet(&self, rays: &RayPacket, min: f64, max: &Numbers) -> PacketHits;
        fn traces_packets(&self) -> bool;
        fn any_hit(&self, ray: &Ray, range: Range) -> bool;
        fn inside(&self, p: DVec3) -> bool;
        fn as_half_space(&self) -> Option<HalfSpace>;
        fn half_spaces(&self) -> HalfSpaces;
        fn bounding_quadratic(&self) -> Option<Quadratic>;
        fn solid_bounds(&self) -> Option<Aabb>;
        fn is_solid_unbounded(&self) -> bool;
        fn is_convex(&self) -> bool;
        fn computes_crossings(&self) -> bool;
        fn crossing(&self, ray: &Ray) -> Crossing;
        fn crosses_packets(&self) -> bool;
        #[inline(always)]
        fn crossings_of_packet(&self, rays: &RayPacket) -> PacketCrossings;
        fn normal(&self, p: DVec3, hit: &Hit) -> DVec3;
        #[inline(always)]
        fn normals_of_packet(&self, points: &Vectors, hits: &[Hit; PACKET], lanes: u32) -> Vectors;
        fn uv(&self, p: DVec3, hit: &Hit) -> DVec2;
        fn mesh_faces(&self) -> Vec<Face>;
        fn has_uv_mapping(&self) -> bool;
        fn read_textured(&mut self, next: Next, r: &mut dyn Reader, paints: &mut dyn Paints) -> Result<bool>;
        fn texture_weights(&self, p: DVec3, hit: &Hit) -> TextureWeights;
        fn adapted_to_transform(&self, m: &Transform) -> Option<Shape>;
        fn is_open(&self) -> bool;
        fn caches_lazily(&self) -> bool;
    }
}

impl Shape {
    /// Returns a `box` that fills these bounds.
    pub fn box_filling(bounds: &Aabb) -> Self {
        Cuboid::new(bounds.min, bounds.max).into()
    }

    /// Reads the positional arguments of the shape with this name, after the name and its brace; `None` if there is no
    /// such shape.
    pub fn read_params_of(name: &'static str, r: &mut dyn Reader) -> Option<Result<Self>> {
        let spec = Self::spec_of(name)?;
        Self::read_params(Next::Block(name), r).map(|shape| shape.map_err(|fault| with_usage(fault, spec)))
    }

    /// Returns the shape to place by the transform M: see [`Kernel::adapted_to_transform`].
    pub fn shape_under_transform(&self, m: &Transform) -> Cow<'_, Self> {
        self.adapted_to_transform(m).map_or(Cow::Borrowed(self), Cow::Owned)
    }

    /// True if both are clones of one shape.
    pub fn shares_with(&self, other: &Self) -> bool {
        std::ptr::eq(self.kernel_address(), other.kernel_address())
    }

    /// Address of the shape's kernel, which clones share.
    fn kernel_address(&self) -> *const u8 {
        Shape!(self, kernel => Arc::as_ptr(kernel).cast())
    }
}

/// Adds a usage line to the diagnostic of a shape's missing argument.
fn with_usage(mut fault: Fault, spec: &Spec) -> Fault {
    if fault.code == codes::EXPECTED && fault.help.is_none() {
        fault.help = Some(format!("it is written `{}`", spec.block_usage()));
    }
    fault
}

/// Returns an error unless all numbers of a shape are finite.
fn check_finite(span: Span, points: &[DVec3], numbers: &[f64]) -> Result<()> {
    if points.iter().all(|p| p.is_finite()) && numbers.iter().all(|x| x.is_finite()) {
        return Ok(());
    }
    Diagnostic::err(codes::NOT_FINITE, span, "one of these numbers is infinite or not a number")
}

/// Returns an error if both ends of a cylinder or cone are at one point, or nearly so.
fn check_frustum_ends(span: Span, base: DVec3, cap: DVec3) -> Result<()> {
    let axis = cap - base;
    // The squared length is a divisor later, so it must be a normal number.
    if axis.length_squared().is_normal() {
        return Ok(());
    }
    let message = "both ends are at the same point, so there is no direction from one to the other";
    let help = "move one of the two points; for a flat round plate take `disc`";
    Err(Diagnostic::new(codes::NO_LENGTH, span, message).help(help).into())
}
