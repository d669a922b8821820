//! Reads cameras. (The rays of a `mesh_camera` start at the faces of an object.)

use super::{Object, ObjectKind};
use crate::camera::{Camera, PlacedMesh};
use crate::diagnostic::Result;
use crate::scene::Defaults;
use crate::shape::{Face, Kernel, Shape};
use crate::source::Span;
use crate::value::Reader;
use std::sync::Arc;

/// Number of recent shapes whose lists of faces are cached.
const RECENT: usize = 8;

/// Reads the contents of a camera's block; `source` is the span of the word `camera`.
///
/// # Errors
/// A diagnostic at the first item that is not understood.
pub fn read_camera(r: &mut dyn Reader, source: Span, defaults: &Defaults) -> Result<Camera> {
    let mut known = vec![];
    let mut mesh = |r: &mut dyn Reader| Ok(placed_mesh(&*Object::read(r, defaults)?, &mut known));
    Camera::read(r, source, &defaults.camera, &defaults.texture, &mut mesh)
}

/// Returns the faces of a mesh with the object's transform; other objects have no faces.
fn placed_mesh(object: &Object, known: &mut Vec<(Shape, Arc<[Face]>)>) -> PlacedMesh {
    let faces = match &object.kind {
        ObjectKind::Shape(shape) => cached_faces(shape, known),
        _ => [].into(),
    };
    PlacedMesh { faces, transform: *object.transform }
}

/// Returns the faces of a shape, which are listed once for all copies of the shape.
fn cached_faces(shape: &Shape, known: &mut Vec<(Shape, Arc<[Face]>)>) -> Arc<[Face]> {
    if let Some((_, faces)) = known.iter().rev().take(RECENT).find(|(other, _)| other.shares_with(shape)) {
        return faces.clone();
    }
    let faces: Arc<[Face]> = shape.mesh_faces().into();
    known.push((shape.clone(), faces.clone()));
    faces
}
