//! Single triangles of a mesh, for use without rays.

use crate::math::{DVec2, DVec3, Transform};

/// A triangle of a mesh.
#[derive(Clone, Debug, PartialEq)]
pub struct Face {
    /// Corners of the triangle.
    pub corners: [DVec3; 3],
    /// Geometric normal of the mesh's triangle, which is the same at all its points.
    pub normal: DVec3,
    /// Normals at the corners of a smooth triangle of a mesh; `None` for a flat triangle.
    pub normals: Option<[DVec3; 3]>,
    /// Surface coordinates of the triangle's corners; `None` if the mesh has none.
    pub uv: Option<[DVec2; 3]>,
}

impl Face {
    /// Transforms the mesh's triangle: points by M and normals by M⁻ᵀ.
    pub fn transformed(self, m: &Transform) -> Self {
        Self {
            corners: self.corners.map(|p| m.transform_point(p)),
            normal: m.transform_normal(self.normal),
            normals: self.normals.map(|normals| normals.map(|n| m.transform_normal(n))),
            uv: self.uv,
        }
    }
}
