//! `mesh { file "NAME" … }`: triangles from a file of another program. An addition of durer.

use super::hierarchy::TriangleHierarchy;
use crate::diagnostic::{Diagnostic, Result, codes};
use crate::image_io::Picture;
use crate::mesh_io::{MeshFile, MeshMaterial};
use crate::shape::Paints;
use crate::value::words::word;
use crate::value::{Reader, Thing, ValueKind, WordSpec, downcast};
use std::sync::Arc;

pub const FILE: WordSpec = word(
    "file",
    ValueKind::Text,
    "",
    "the triangles of a file that another program wrote: ply, obj, stl, gltf or glb, in place of triangles that are written out",
);

/// Contents of a mesh file, shared by all meshes that name it.
#[derive(Debug, PartialEq)]
pub struct FileMesh {
    pub triangles: Arc<TriangleHierarchy>,
    materials: Vec<(MeshMaterial, Option<Arc<Picture>>)>,
}

impl Thing for FileMesh {
    fn kind(&self) -> &'static str {
        "file of a mesh"
    }
}

impl FileMesh {
    /// Reads the mesh file's name, and the file unless it was read before.
    pub fn read(r: &mut dyn Reader) -> Result<Arc<Self>> {
        let at = r.span();
        let thing = r.read_mesh_file(|file: MeshFile, pictures| {
            let materials = file.materials.into_iter().zip(pictures).collect();
            Arc::new(Self { triangles: Arc::new(TriangleHierarchy::new(file.triangles)), materials })
        })?;
        match downcast::<Self>(&thing) {
            Some(file) => Ok(file),
            None => Diagnostic::err(codes::WRONG_TYPE, at, "expected the name of a mesh's file"),
        }
    }

    /// Adds the textures of the mesh file's materials to the object, and returns for each material the number of its
    /// texture in the object.
    pub fn add_material_textures(&self, paints: &mut dyn Paints, r: &mut dyn Reader) -> Result<Vec<u32>> {
        self.materials
            .iter()
            .map(|(material, picture)| paints.add_mesh_material(material, picture.as_ref(), r))
            .collect()
    }
}

#[cfg(test)]
mod tests;
