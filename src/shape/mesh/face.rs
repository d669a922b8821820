//! Single triangles of a mesh, for those who do not ask by rays.

use crate::math::{DVec2, DVec3, Transform};

/// A triangle of a mesh.
#[derive(Clone, Debug, PartialEq)]
pub struct Face {
    /// Its corners.
    pub corners: [DVec3; 3],
    /// Across it, of any length; seen against it, the corners go around clockwise.
    pub normal: DVec3,
    /// Those at the corners, if it is smooth.
    pub normals: Option<[DVec3; 3]>,
    /// The surface coordinates of the corners, if it has any.
    pub uv: Option<[DVec2; 3]>,
}

impl Face {
    /// The same moved: points by M, normals by M⁻ᵀ.
    pub fn moved(self, m: &Transform) -> Self {
        Self {
            corners: self.corners.map(|p| m.point(p)),
            normal: m.normal(self.normal),
            normals: self.normals.map(|normals| normals.map(|n| m.normal(n))),
            uv: self.uv,
        }
    }
}
