//! Reads mesh files that a scene names, and the pictures that mesh files name.

use crate::diagnostic::{Diagnostic, Result, codes, file};
use crate::image_io::Picture;
use crate::interpreter::Interpreter;
use crate::mesh_io::{self, MeshFile, ReadResult};
use crate::source::{ReadError, Span};
use crate::value::{BuildMesh, Reader, Thing};
use std::path::Path;
use std::sync::Arc;

impl Interpreter<'_> {
    /// Reads the name of a mesh file, and builds the shape with `build`. Each file is read once.
    pub(super) fn read_mesh_file(&mut self, build: BuildMesh) -> Result<Arc<dyn Thing>> {
        let (at, name) = (self.span(), self.text()?);
        let Some(path) = self.find_readable_file(&name, at)? else {
            let d = Diagnostic::new(codes::MISSING_INCLUDE, at, format!("the mesh's file `{name}` was not found"));
            return d
                .help("mesh files are searched in the same folders as included files; -I DIR adds a folder")
                .into();
        };
        if let Some(mesh) = self.evaluator.assets().meshes.get(&path) {
            return Ok(mesh.clone());
        }
        let file = self.read_mesh(&path, at)?;
        for remark in &file.remarks {
            self.warn_partly_read(&name, remark, at);
        }
        let pictures: Vec<_> = file
            .materials
            .iter()
            .map(|material| self.material_picture(&path, material.picture.as_deref()?, at))
            .collect();
        let mesh = build(file, pictures);
        self.evaluator.assets().meshes.insert(path, mesh.clone());
        Ok(mesh)
    }

    fn read_mesh(&self, path: &Path, at: Span) -> Result<MeshFile> {
        let bytes = match self.inputs.files.read(path) {
            Ok(bytes) => bytes,
            Err(error) => return Err(file::unreadable(self.inputs.files, path, &ReadError::Io(error)).at(at)),
        };
        let ending = path.extension().and_then(|e| e.to_str()).unwrap_or_default();
        let folder = path.parent().unwrap_or(Path::new(""));
        let mut open = |name: &str| -> ReadResult<Vec<u8>> {
            let beside = folder.join(name);
            if self.inputs.files.exists(&beside) && !self.inputs.files.may_read(&beside) {
                return Err(format!("the file `{name}` may not be read by the scene"));
            }
            self.inputs.files.read(&beside).map_err(|_| format!("there is no file `{name}` that can be read"))
        };
        mesh_io::read_mesh_file(&bytes, ending, &mut open).map_err(|why| {
            let message = format!("the mesh's file `{}` can't be read: {why}", path.display());
            Box::new(Diagnostic::new(codes::MESH_BROKEN, at, message))
        })
    }

    /// Returns the picture of a mesh's material; `None` with a warning if the picture cannot be read.
    fn material_picture(&mut self, mesh: &Path, name: &str, at: Span) -> Option<Arc<Picture>> {
        let path = mesh.parent().unwrap_or(Path::new("")).join(name);
        let is_open = self.inputs.files.is_file(&path) && self.inputs.files.may_read(&path);
        let picture = if is_open {
            self.picture_at(path, at).map_err(|fault| fault.message)
        } else {
            Err(format!("the picture `{name}` is not there, or may not be read"))
        };
        picture.map_err(|why| self.warn_partly_read(&mesh.display().to_string(), &why, at)).ok()
    }

    fn warn_partly_read(&mut self, name: &str, message: &str, at: Span) {
        self.report(Diagnostic::new(codes::MESH_PARTLY, at, format!("in the mesh file `{name}`: {message}")));
    }
}
