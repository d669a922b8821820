//! Shapes in their own object space: bounds, hits, inside, normal, uv. Adding one is a file here and
//! a row in the table below.

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
use kernel::nearest;
pub use kernel::{Crossing, End, HalfSpace, HalfSpaces, Hit, Hits, Kernel, TextureWeights};
pub use lathe::Lathe;
pub use mesh::{Face, Mesh, Mesh2, TriangleMesh};
pub use ovus::Ovus;
pub use parametric::Parametric;
pub use plane::{Plane, Spanned};
pub use polygon::Polygon;
pub use pov_bounds::{HUGE, moved_box};
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

/// Where the textures are kept that a shape carries itself: its kernel knows them by their numbers, from 1 on.
pub trait Paints {
    /// Reads what comes next if it is a texture or a part of one; false if something else comes. `slot` is what the place has so
    /// far, and has then.
    ///
    /// # Errors
    /// With the place of what is not understood, and what was expected there.
    fn read(&mut self, slot: &mut u32, next: Next, r: &mut dyn Reader) -> Result<bool>;

    /// Consumes one texture of a list, of which several in a row are no layers; `None` if something else comes.
    ///
    /// # Errors
    /// With the place of what is not understood, and what was expected there.
    fn read_one(&mut self, next: Next, r: &mut dyn Reader) -> Result<Option<u32>>;

    /// The texture of a material in a mesh's file, with its picture if that was found.
    ///
    /// # Errors
    /// As those of the others.
    fn of_file(&mut self, material: &MeshMaterial, picture: Option<&Arc<Picture>>, r: &mut dyn Reader) -> Result<u32>;

    /// Moves what the place has, and nothing else that has the same.
    fn transform(&mut self, slot: &mut u32, by: &Transform);
}

macro_rules! shapes {
    ($($name:ident)*) => {
        /// Any shape. A closed set: no virtual calls on the way of a ray. Copies share it, and each takes no more room than
        /// its own kind needs.
        #[derive(Clone, Debug, PartialEq, Serialize)]
        #[serde(rename_all = "snake_case")]
        pub enum Shape { $(#[doc = concat!("See [`", stringify!($name), "`].")] $name(Arc<$name>)),* }

        impl Kernel for Shape {
            fn bounds(&self) -> Aabb { match self { $(Shape::$name(s) => Kernel::bounds(&**s)),* } }
            fn bounds_under(&self, m: &Transform) -> Aabb { match self { $(Shape::$name(s) => s.bounds_under(m)),* } }
            fn hits(&self, ray: &Ray, range: Range, out: &mut Hits) { match self { $(Shape::$name(s) => s.hits(ray, range, out)),* } }
            fn hits_in_csg(&self, ray: &Ray, range: Range, out: &mut Hits) { match self { $(Shape::$name(s) => s.hits_in_csg(ray, range, out)),* } }
            fn closest(&self, ray: &Ray, range: Range) -> Option<Hit> { match self { $(Shape::$name(s) => s.closest(ray, range)),* } }
            fn any(&self, ray: &Ray, range: Range) -> bool { match self { $(Shape::$name(s) => s.any(ray, range)),* } }
            fn pov_bounds(&self, m: &Transform) -> Aabb { match self { $(Shape::$name(s) => s.pov_bounds(m)),* } }
            fn as_half_space(&self) -> Option<HalfSpace> { match self { $(Shape::$name(s) => s.as_half_space()),* } }
            fn half_spaces(&self) -> HalfSpaces { match self { $(Shape::$name(s) => s.half_spaces()),* } }
            fn quadratic(&self) -> Option<Quadratic> { match self { $(Shape::$name(s) => s.quadratic()),* } }
            fn solid_bounds(&self) -> Option<Aabb> { match self { $(Shape::$name(s) => s.solid_bounds()),* } }
            fn is_solid_unbounded(&self) -> bool { match self { $(Shape::$name(s) => s.is_solid_unbounded()),* } }
            fn inside(&self, p: DVec3) -> bool { match self { $(Shape::$name(s) => s.inside(p)),* } }
            fn is_convex(&self) -> bool { match self { $(Shape::$name(s) => s.is_convex()),* } }
            fn knows_crossings(&self) -> bool { match self { $(Shape::$name(s) => s.knows_crossings()),* } }
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
            /// The shape to place by M: see [`Kernel::changed_under`].
            pub fn under(&self, m: &Transform) -> Cow<'_, Self> {
                match self { $(Shape::$name(s) => s.changed_under(m).map_or(Cow::Borrowed(self), |s| Cow::Owned(s.into()))),* }
            }
            /// Do both share all they are?
            pub fn shares_with(&self, other: &Self) -> bool {
                match (self, other) {
                    $((Shape::$name(a), Shape::$name(b)) => Arc::ptr_eq(a, b),)*
                    _ => false,
                }
            }
            /// The table of its words.
            pub fn spec(&self) -> &'static Spec { match self { $(Shape::$name(_) => &$name::SPEC),* } }
            /// Reads one of the words of its own table, if it comes next; false if none does.
            ///
            /// # Errors
            /// With the place of what is not understood, and what was expected there.
            pub fn read_own(&mut self, next: Next, r: &mut dyn Reader, paints: &mut dyn Paints) -> Result<bool> {
                match self { $(Shape::$name(s) => Arc::make_mut(s).read_own(next, r, paints)),* }
            }
            /// Checks what only the whole block shows, after its last word; `span` is the block's name.
            ///
            /// # Errors
            /// With the place of what is not understood, and what was expected there.
            pub fn finish(&mut self, span: Span, r: &mut dyn Reader) -> Result<()> {
                match self { $(Shape::$name(s) => Arc::make_mut(s).finish(span, r)),* }
            }
        }

        $(impl From<$name> for Shape {
            fn from(shape: $name) -> Self { Shape::$name(Arc::new(shape)) }
        })*

        /// Every shape's table.
        pub const SPECS: &[&Spec] = &[$(&$name::SPEC),*];

        /// Reads the positional arguments of the shape of this name; `None` if there is no such shape.
        pub fn read(name: &str, r: &mut dyn Reader) -> Option<Result<Shape>> {
            $(if name == $name::SPEC.name { return Some($name::read(r).map(Shape::from).map_err(|e| with_usage(e, &$name::SPEC))); })*
            None
        }
    };
}

impl Shape {
    /// The `box` that fills these bounds.
    pub fn filling(bounds: &Aabb) -> Self {
        Cuboid::new(bounds.min, bounds.max).into()
    }
}

/// A missing argument: says how the block is written.
fn with_usage(mut fault: Fault, spec: &Spec) -> Fault {
    if fault.code == codes::EXPECTED && fault.help.is_none() {
        let names: Vec<&str> = spec.params.iter().map(|p| p.name).collect();
        fault.help = Some(format!("it is written `{} {{ {} … }}`", spec.name, names.join(", ")));
    }
    fault
}

/// How a shape is read.
pub trait Readable: Sized + 'static {
    /// Its table.
    const SPEC: Spec;

    /// Words of its own, which `SPEC` names.
    const WORDS: &'static [Row<Self>] = &[];

    /// Reads the positional arguments, after the opening brace.
    ///
    /// # Errors
    /// With the place of what is not understood, and what was expected there.
    fn read(r: &mut dyn Reader) -> Result<Self>;

    /// Reads one of [`Self::WORDS`], if it comes next, and what follows it; false if none does. Shapes that carry textures read
    /// more here.
    ///
    /// # Errors
    /// With the place of what is not understood, and what was expected there.
    fn read_own(&mut self, next: Next, r: &mut dyn Reader, _paints: &mut dyn Paints) -> Result<bool> {
        read_row(Self::WORDS, self, next, r)
    }

    /// Checks what only the whole block shows.
    ///
    /// # Errors
    /// With the place of what is not understood, and what was expected there.
    fn finish(&mut self, _span: Span, _r: &mut dyn Reader) -> Result<()> {
        Ok(())
    }
}

shapes! {
    Sphere Cuboid Cylinder Cone Torus Disc Plane Triangle SmoothTriangle Polygon Mesh Mesh2 Text Blob Quadric Cubic Quartic Poly
    Polynomial Superellipsoid Lathe Sor Prism HeightField Isosurface Parametric SphereSweep BicubicPatch JuliaFractal Ovus
}

/// An error unless all these are finite numbers.
fn finite(span: Span, points: &[DVec3], numbers: &[f64]) -> Result<()> {
    if points.iter().all(|p| p.is_finite()) && numbers.iter().all(|x| x.is_finite()) {
        return Ok(());
    }
    Diagnostic::err(codes::NOT_FINITE, span, "one of these numbers is infinite or not a number")
}

/// An error unless the two ends of a cylinder or cone are apart.
fn frustum_ends(span: Span, base: DVec3, cap: DVec3) -> Result<()> {
    let axis = cap - base;
    // The square of the length divides: it must be a number that can.
    if axis.length_squared().is_normal() {
        return Ok(());
    }
    let message = "both ends are at the same point, so there is no direction from one to the other";
    let help = "move one of the two points; for a flat round plate take `disc`";
    Err(Diagnostic::new(codes::NO_LENGTH, span, message).help(help).into())
}
