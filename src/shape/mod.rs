//! Shapes in object space: bounds, hits, inside, normal, uv. To add a shape, add a file here and a name to the list
//! below.

mod algebraic;
mod bicubic_patch;
mod blob;
mod cone;
mod cuboid;
mod cylinder;
mod disc;
mod formula;
mod frustum;
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
mod pov_bounds;
mod prism;
mod quadric;
mod quirks;
mod smooth_triangle;
mod sor;
mod sphere;
mod sphere_sweep;
mod spline;
mod superellipsoid;
#[cfg(test)]
mod testing;
mod text;
mod torus;
mod triangle;
mod turned;

pub use algebraic::{Algebraic, Cubic, Poly, Polynomial, Quartic};
pub use bicubic_patch::BicubicPatch;
pub use blob::Blob;
pub use cone::Cone;
pub use cuboid::Cuboid;
pub use cylinder::Cylinder;
pub use disc::Disc;
pub use formula::{Container, Formula};
pub use frustum::Frustum;
pub use height_field::HeightField;
pub use isosurface::Isosurface;
pub use julia_fractal::{Algebra, Function, JuliaFractal};
use kernel::nearest_hit;
pub use kernel::{Crossing, End, HalfSpace, HalfSpaces, Hit, Hits, Kernel, TextureWeights};
pub use lathe::Lathe;
pub use mesh::{Face, Mesh, Mesh2, TriangleMesh};
pub use ovus::Ovus;
pub use parametric::Parametric;
pub use plane::{Plane, Spanned};
pub use polygon::Polygon;
pub use pov_bounds::{HUGE, transformed_box};
pub use prism::Prism;
pub use quadric::Quadric;
pub use quirks::{Bounding, Quirks};
pub use smooth_triangle::SmoothTriangle;
pub use sor::Sor;
pub use sphere::Sphere;
pub use sphere_sweep::{SphereSweep, Sweep};
pub use spline::{Curve, Interpolation};
pub use superellipsoid::Superellipsoid;
pub use text::Text;
pub use torus::Torus;
pub use triangle::Triangle;

use crate::diagnostic::{Diagnostic, Fault, Result, codes};
use crate::image_io::Picture;
use crate::math::{Aabb, DVec2, DVec3, Quadratic, Range, Ray, Transform};
use crate::mesh_io::MeshMaterial;
use crate::source::Span;
use crate::value::words::{Row, read_row};
use crate::value::{Next, Reader, Spec};
use serde::Serialize;
use std::borrow::Cow;
use std::sync::Arc;

/// Storage of the textures that are embedded in a shape, numbered from 1.
pub trait Paints {
    /// Reads a texture or a part of one, if it is next; returns false otherwise. `slot` is the number of the embedded
    /// texture so far, and is updated.
    ///
    /// # Errors
    /// A diagnostic at the first item that is not understood.
    fn read_embedded_texture(&mut self, slot: &mut u32, next: Next, r: &mut dyn Reader) -> Result<bool>;

    /// Reads one texture of a list, in which consecutive textures are not layers; `None` if no texture is next.
    ///
    /// # Errors
    /// A diagnostic at the first item that is not understood.
    fn read_listed_texture(&mut self, next: Next, r: &mut dyn Reader) -> Result<Option<u32>>;

    /// Adds the texture of a material in a mesh file, with its picture if that was found.
    ///
    /// # Errors
    /// A diagnostic if the material has no equivalent.
    fn add_mesh_material(
        &mut self,
        material: &MeshMaterial,
        picture: Option<&Arc<Picture>>,
        r: &mut dyn Reader,
    ) -> Result<u32>;

    /// Transforms one embedded texture; other users of the same texture keep theirs.
    fn transform(&mut self, slot: &mut u32, by: &Transform);
}

macro_rules! shapes {
    ($($name:ident)*) => {
        /// Any shape. A closed set, so that rays need no virtual calls. Clones share the kernel.
        #[derive(Clone, Debug, PartialEq, Serialize)]
        #[serde(rename_all = "snake_case")]
        pub enum Shape { $(#[doc = concat!("See [`", stringify!($name), "`].")] $name(Arc<$name>)),* }

        impl Kernel for Shape {
            fn bounds(&self) -> Aabb { match self { $(Shape::$name(s) => Kernel::bounds(&**s)),* } }
            fn bounds_under(&self, m: &Transform) -> Aabb { match self { $(Shape::$name(s) => s.bounds_under(m)),* } }
            fn hits(&self, ray: &Ray, range: Range, out: &mut Hits) { match self { $(Shape::$name(s) => s.hits(ray, range, out)),* } }
            fn hits_in_csg(&self, ray: &Ray, range: Range, out: &mut Hits) { match self { $(Shape::$name(s) => s.hits_in_csg(ray, range, out)),* } }
            fn closest(&self, ray: &Ray, range: Range) -> Option<Hit> { match self { $(Shape::$name(s) => s.closest(ray, range)),* } }
            fn any_hit(&self, ray: &Ray, range: Range) -> bool { match self { $(Shape::$name(s) => s.any_hit(ray, range)),* } }
            fn pov_bounds(&self, m: &Transform) -> Aabb { match self { $(Shape::$name(s) => s.pov_bounds(m)),* } }
            fn as_half_space(&self) -> Option<HalfSpace> { match self { $(Shape::$name(s) => s.as_half_space()),* } }
            fn half_spaces(&self) -> HalfSpaces { match self { $(Shape::$name(s) => s.half_spaces()),* } }
            fn bounding_quadratic(&self) -> Option<Quadratic> { match self { $(Shape::$name(s) => s.bounding_quadratic()),* } }
            fn solid_bounds(&self) -> Option<Aabb> { match self { $(Shape::$name(s) => s.solid_bounds()),* } }
            fn is_solid_unbounded(&self) -> bool { match self { $(Shape::$name(s) => s.is_solid_unbounded()),* } }
            fn inside(&self, p: DVec3) -> bool { match self { $(Shape::$name(s) => s.inside(p)),* } }
            fn is_convex(&self) -> bool { match self { $(Shape::$name(s) => s.is_convex()),* } }
            fn computes_crossings(&self) -> bool { match self { $(Shape::$name(s) => s.computes_crossings()),* } }
            fn crossing(&self, ray: &Ray) -> Crossing { match self { $(Shape::$name(s) => s.crossing(ray)),* } }
            fn normal(&self, p: DVec3, hit: &Hit) -> DVec3 { match self { $(Shape::$name(s) => s.normal(p, hit)),* } }
            fn uv(&self, p: DVec3, hit: &Hit) -> DVec2 { match self { $(Shape::$name(s) => s.uv(p, hit)),* } }
            fn faces(&self) -> Vec<Face> { match self { $(Shape::$name(s) => s.faces()),* } }
            fn texture_weights(&self, p: DVec3, hit: &Hit) -> TextureWeights { match self { $(Shape::$name(s) => s.texture_weights(p, hit)),* } }
            fn has_uv_mapping(&self) -> bool { match self { $(Shape::$name(s) => s.has_uv_mapping()),* } }
            fn is_open(&self) -> bool { match self { $(Shape::$name(s) => s.is_open()),* } }
            fn caches_lazily(&self) -> bool { match self { $(Shape::$name(s) => s.caches_lazily()),* } }
        }

        impl Shape {
            /// The quirks of the shape's kind.
            pub fn quirks(&self) -> &'static Quirks { match self { $(Shape::$name(_) => &$name::QUIRKS),* } }
            /// The shape to place by M: see [`Kernel::adapted_to_transform`].
            pub fn under(&self, m: &Transform) -> Cow<'_, Self> {
                match self { $(Shape::$name(s) => s.adapted_to_transform(m).map_or(Cow::Borrowed(self), |s| Cow::Owned(s.into()))),* }
            }
            /// True if both are clones of one shape.
            pub fn shares_with(&self, other: &Self) -> bool {
                match (self, other) {
                    $((Shape::$name(a), Shape::$name(b)) => Arc::ptr_eq(a, b),)*
                    _ => false,
                }
            }
            /// Name, words and parameters of the shape.
            pub fn spec(&self) -> &'static Spec { match self { $(Shape::$name(_) => &$name::SPEC),* } }
            /// Reads one word of the shape, if it is next; returns false otherwise.
            ///
            /// # Errors
            /// A diagnostic at the first item that is not understood.
            pub fn read_own(&mut self, next: Next, r: &mut dyn Reader, paints: &mut dyn Paints) -> Result<bool> {
                match self { $(Shape::$name(s) => Arc::make_mut(s).read_own(next, r, paints)),* }
            }
            /// Checks the complete block; `span` is the block's name.
            ///
            /// # Errors
            /// A diagnostic for a block that is complete but invalid.
            pub fn finish(&mut self, span: Span, r: &mut dyn Reader) -> Result<()> {
                match self { $(Shape::$name(s) => Arc::make_mut(s).finish(span, r)),* }
            }
        }

        $(impl From<$name> for Shape {
            fn from(shape: $name) -> Self { Shape::$name(Arc::new(shape)) }
        })*

        /// Names, words and parameters of all shapes.
        pub const SPECS: &[&Spec] = &[$(&$name::SPEC),*];

        /// Reads the positional arguments of the shape with this name; `None` if there is no such shape.
        pub fn read(name: &str, r: &mut dyn Reader) -> Option<Result<Shape>> {
            $(if name == $name::SPEC.name { return Some($name::read(r).map(Shape::from).map_err(|e| with_usage(e, &$name::SPEC))); })*
            None
        }
    };
}

impl Shape {
    /// The `box` with these bounds.
    pub fn filling(bounds: &Aabb) -> Self {
        Cuboid::new(bounds.min, bounds.max).into()
    }
}

/// Adds a usage line to the diagnostic of a missing argument.
fn with_usage(mut fault: Fault, spec: &Spec) -> Fault {
    if fault.code == codes::EXPECTED && fault.help.is_none() {
        let names: Vec<&str> = spec.params.iter().map(|p| p.name).collect();
        fault.help = Some(format!("it is written `{} {{ {} … }}`", spec.name, names.join(", ")));
    }
    fault
}

/// Reader of a shape.
pub trait Readable: Sized + 'static {
    /// Name, words and parameters.
    const SPEC: Spec;

    /// The words in `SPEC`, and how each is read.
    const WORDS: &'static [Row<Self>] = &[];

    /// Reads the positional arguments, after the opening brace.
    ///
    /// # Errors
    /// A diagnostic at the first item that is not understood.
    fn read(r: &mut dyn Reader) -> Result<Self>;

    /// Reads one of [`Self::WORDS`], if it is next; returns false otherwise. Shapes with embedded textures read those
    /// too.
    ///
    /// # Errors
    /// A diagnostic at the first item that is not understood.
    fn read_own(&mut self, next: Next, r: &mut dyn Reader, _paints: &mut dyn Paints) -> Result<bool> {
        read_row(Self::WORDS, self, next, r)
    }

    /// Checks the complete block.
    ///
    /// # Errors
    /// A diagnostic for a block that is complete but invalid.
    fn finish(&mut self, _span: Span, _r: &mut dyn Reader) -> Result<()> {
        Ok(())
    }
}

shapes! {
    Sphere Cuboid Cylinder Cone Torus Disc Plane Triangle SmoothTriangle Polygon Mesh Mesh2 Text Blob Quadric Cubic Quartic Poly
    Polynomial Superellipsoid Lathe Sor Prism HeightField Isosurface Parametric SphereSweep BicubicPatch JuliaFractal Ovus
}

/// Returns an error unless all numbers are finite.
fn finite(span: Span, points: &[DVec3], numbers: &[f64]) -> Result<()> {
    if points.iter().all(|p| p.is_finite()) && numbers.iter().all(|x| x.is_finite()) {
        return Ok(());
    }
    Diagnostic::err(codes::NOT_FINITE, span, "one of these numbers is infinite or not a number")
}

/// Returns an error if both ends of a cylinder or cone are at one point.
fn frustum_ends(span: Span, base: DVec3, cap: DVec3) -> Result<()> {
    let axis = cap - base;
    // The squared length is a divisor later, so it must be a normal number.
    if axis.length_squared().is_normal() {
        return Ok(());
    }
    let message = "both ends are at the same point, so there is no direction from one to the other";
    let help = "move one of the two points; for a flat round plate take `disc`";
    Err(Diagnostic::new(codes::NO_LENGTH, span, message).help(help).into())
}
