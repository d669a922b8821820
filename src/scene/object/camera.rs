//! Cameras whose rays begin at an object, the mesh of a `mesh_camera`.

use super::{Object, ObjectKind};
use crate::camera::Camera;
use crate::diagnostic::Result;
use crate::scene::Defaults;
use crate::shape::{Face, Kernel};
use crate::source::Span;
use crate::value::Reader;

/// Reads what stands between the braces of a camera; `source` is the block's place.
///
/// # Errors
/// With the place of what is not understood, and what was expected there.
pub fn read_camera(r: &mut dyn Reader, source: Span, defaults: &Defaults) -> Result<Camera> {
    Camera::read(r, source, &defaults.texture, &mut |r| Ok(faces(&*Object::read(r, defaults)?)))
}

/// The faces of a mesh where it lies.
fn faces(object: &Object) -> Vec<Face> {
    match &object.kind {
        ObjectKind::Shape(shape) => shape.faces().into_iter().map(|face| face.moved(&object.transform)).collect(),
        _ => vec![],
    }
}
