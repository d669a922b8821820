//! `mesh`, `mesh2` and files of other programs: triangles by the million.
//!
//! All triangles of one mesh are one shape with its own hierarchy, which copies share. No ray passes between two
//! triangles that share a side.

mod face;
mod file;
mod hierarchy;
mod read;

pub use face::Face;
pub use read::{Mesh, Mesh2};

use super::{Hit, TextureWeights};
use crate::math::{DVec3, Ray};
use hierarchy::TriangleHierarchy;
use serde::Serialize;
use smallvec::smallvec;
use std::sync::Arc;

/// Triangles of a mesh, with a direction that defines its inside.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
pub struct TriangleMesh {
    /// Triangles of the mesh; shared by all meshes of one file.
    #[serde(flatten)]
    triangles: Arc<TriangleHierarchy>,
    /// Direction of a line that crosses the mesh an odd number of times from points inside; without it nothing is
    /// inside.
    inside_vector: Option<DVec3>,
    /// Number in the object of each texture of the mesh's file, by the index of the file's material; empty if the
    /// triangles store such numbers themselves.
    #[serde(skip)]
    texture_numbers: Vec<u32>,
}

impl TriangleMesh {
    fn inside(&self, p: DVec3) -> bool {
        self.inside_vector.is_some_and(|dir| self.triangles.is_crossed_oddly(&Ray::new(p, dir)))
    }

    fn texture_weights(&self, hit: &Hit) -> TextureWeights {
        let Some(textures) = self.triangles.corner_textures(hit) else { return smallvec![(0, 1.0)] };
        let [a, b, c] = textures.numbers.map(|number| match number.checked_sub(1) {
            Some(material) if !self.texture_numbers.is_empty() => self.texture_numbers[material as usize],
            _ => number,
        });
        if a == b && b == c && !textures.is_per_corner {
            return smallvec![(a, 1.0)];
        }
        smallvec![(a, 1.0 - hit.uv.x - hit.uv.y), (b, hit.uv.x), (c, hit.uv.y)]
    }
}

/// Flag in the first texture number of a mesh's face: the three textures are equal but were given for each corner, so
/// that each corner's share is compared with `adc_bailout` by itself (quirk: `embedded_shares_below_adc_bailout`).
const EACH_CORNER: u32 = 1 << 31;

/// Implements [`super::Kernel`] for a shape that wraps a mesh.
macro_rules! mesh_kernel {
    ($name:ident) => {
        impl $crate::shape::Kernel for $name {
            const QUIRKS: $crate::shape::Quirks =
                $crate::shape::Quirks { shadow_by_outside: true, ..$crate::shape::Quirks::NONE };

            fn bounds(&self) -> Aabb {
                self.0.triangles.bounds()
            }

            fn bounds_under(&self, m: &Transform) -> Aabb {
                self.0.triangles.bounds_under(m)
            }

            fn hits(&self, ray: &Ray, range: Range, out: &mut Hits) {
                self.0.triangles.hits(ray, range, out);
            }

            fn closest(&self, ray: &Ray, range: Range) -> Option<Hit> {
                self.0.triangles.closest(ray, range)
            }

            fn any_hit(&self, ray: &Ray, range: Range) -> bool {
                self.0.triangles.any_hit(ray, range)
            }

            fn inside(&self, p: DVec3) -> bool {
                self.0.inside(p)
            }

            fn normal(&self, _: DVec3, hit: &Hit) -> DVec3 {
                self.0.triangles.normal(hit)
            }

            fn uv(&self, _: DVec3, hit: &Hit) -> DVec2 {
                self.0.triangles.uv(hit)
            }

            fn mesh_faces(&self) -> Vec<$crate::shape::Face> {
                self.0.triangles.faces()
            }

            fn read_textured(&mut self, next: Next, r: &mut dyn Reader, paints: &mut dyn Paints) -> Result<bool> {
                self.read_geometry(next, r, paints)
            }

            fn texture_weights(&self, _: DVec3, hit: &Hit) -> TextureWeights {
                self.0.texture_weights(hit)
            }

            fn is_open(&self) -> bool {
                self.0.inside_vector.is_none()
            }
        }
    };
}
use mesh_kernel;
