//! Cameras whose rays begin at an object, the mesh of a `mesh_camera`.

use super::{Object, ObjectKind};
use crate::camera::{Camera, PlacedMesh};
use crate::diagnostic::Result;
use crate::scene::Defaults;
use crate::shape::{Face, Kernel, Shape};
use crate::source::Span;
use crate::value::Reader;
use std::sync::Arc;

/// Of so many shapes the faces are looked for before they are listed.
const RECENT: usize = 8;

/// Reads what stands between the braces of a camera; `source` is the block's place.
///
/// # Errors
/// With the place of what is not understood, and what was expected there.
pub fn read_camera(r: &mut dyn Reader, source: Span, defaults: &Defaults) -> Result<Camera> {
    let mut known = vec![];
    Camera::read(r, source, &defaults.texture, &mut |r| Ok(placed(&*Object::read(r, defaults)?, &mut known)))
}

/// A mesh where it lies; what is no mesh has no faces.
fn placed(object: &Object, known: &mut Vec<(Shape, Arc<[Face]>)>) -> PlacedMesh {
    let faces = match &object.kind {
        ObjectKind::Shape(shape) => faces(shape, known),
        _ => [].into(),
    };
    PlacedMesh { faces, transform: *object.transform }
}

/// The faces of a shape, which are listed once for all its copies.
fn faces(shape: &Shape, known: &mut Vec<(Shape, Arc<[Face]>)>) -> Arc<[Face]> {
    if let Some((_, faces)) = known.iter().rev().take(RECENT).find(|(other, _)| other.shares_with(shape)) {
        return faces.clone();
    }
    let faces: Arc<[Face]> = shape.faces().into();
    known.push((shape.clone(), faces.clone()));
    faces
}
