//! Triangles in the order of a hierarchy, and their intersection with rays.

use super::{EACH_CORNER, Face};
use crate::math::bvh;
use crate::math::{Aabb, DVec2, DVec3, Range, Ray, Transform, fork};
use crate::mesh_io::{NONE, Triangles};
use crate::shape::{Hit, Hits, Triangle};
use serde::Serialize;
use std::ops::ControlFlow;

/// Minimum number of a mesh's triangles that one thread handles in a row.
const FACES_FOR_A_THREAD: usize = 1 << 13;

/// All triangles of a mesh, with a hierarchy over them.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
pub struct TriangleHierarchy {
    /// Triangles of the mesh in the hierarchy's order.
    #[serde(flatten)]
    lists: Triangles,
    #[serde(skip)]
    bvh: bvh::Triangles,
    #[serde(skip)]
    bounds: Option<Aabb>,
    /// True if every vertex of the mesh's lists is a corner of a triangle.
    #[serde(skip)]
    uses_all_vertices: bool,
    /// Position of each triangle in the hierarchy's order, in the order written.
    #[serde(skip)]
    written: Vec<u32>,
}

/// Textures at the corners of a mesh's triangle.
pub struct CornerTextures {
    /// Texture number, or material number of a mesh file, of each corner: from 1 on, or 0 for the object's own texture.
    pub numbers: [u32; 3],
    /// True if the numbers are equal but were given for each corner.
    pub is_per_corner: bool,
}

impl TriangleHierarchy {
    /// Builds the hierarchy over a mesh's triangles; leaves out those without area and those beyond the range of
    /// numbers.
    pub fn new(lists: Triangles) -> Self {
        let mut all = Self { lists, ..Self::default() };
        let is_usable = fork::map(all.lists.corners.len(), FACES_FOR_A_THREAD, |i| all.is_usable(i));
        let kept: Vec<u32> = (0..all.lists.corners.len() as u32).filter(|&i| is_usable[i as usize]).collect();
        let corners = |i: u32| all.lists.corners[kept[i as usize] as usize];
        let (bvh, order) = bvh::Triangles::build(kept.len(), &all.lists.vertices, corners);
        all.written = vec![0; order.len()];
        for (at, i) in order.iter().enumerate() {
            all.written[*i as usize] = at as u32;
        }
        let order: Vec<u32> = order.into_iter().map(|i| kept[i as usize]).collect();
        let lists = &mut all.lists;
        for list in [&mut lists.corners, &mut lists.smooth, &mut lists.mapped, &mut lists.painted] {
            if !list.is_empty() {
                *list = fork::map(order.len(), FACES_FOR_A_THREAD, |i| list[order[i] as usize]);
            }
        }
        let mut is_used = vec![false; all.lists.vertices.len()];
        all.lists.corners.iter().flatten().for_each(|&i| is_used[i as usize] = true);
        all.uses_all_vertices = is_used.iter().all(|used| *used);
        all.bounds = Some(Aabb::from_points(all.points()));
        all.bvh = bvh;
        all
    }

    /// True if the mesh has no triangles.
    pub fn is_empty(&self) -> bool {
        self.lists.corners.is_empty()
    }

    /// Iterates over the vertices of all triangles of the mesh; those in use once each, if all are.
    fn points(&self) -> impl Iterator<Item = DVec3> {
        let Triangles { vertices, corners, .. } = &self.lists;
        let (each, of_triangles) =
            if self.uses_all_vertices { (&vertices[..], &[][..]) } else { (&[][..], &corners[..]) };
        let corners = of_triangles.iter().flatten().map(|&i| &vertices[i as usize]);
        each.iter().chain(corners).map(|p| p.as_dvec3())
    }

    fn is_usable(&self, face: usize) -> bool {
        let [a, b, c] = self.corners_of_face(face);
        !Triangle::new(a, b, c).is_degenerate() && bvh::fits_single_precision(&self.face_bounds(face))
    }

    #[inline]
    fn corners_of_face(&self, face: usize) -> [DVec3; 3] {
        self.lists.corners[face].map(|i| self.lists.vertices[i as usize].as_dvec3())
    }

    fn face_bounds(&self, face: usize) -> Aabb {
        Aabb::from_points(self.corners_of_face(face))
    }

    /// Returns all triangles of the mesh in the order written.
    pub fn faces(&self) -> Vec<Face> {
        let face = |&i: &u32| {
            let (i, lists) = (i as usize, &self.lists);
            let [a, b, c] = self.corners_of_face(i);
            Face {
                corners: [a, b, c],
                normal: Triangle::new(a, b, c).face_normal(),
                normals: Self::triangle_indices(&lists.smooth, i)
                    .map(|numbers| numbers.map(|n| lists.normals[n as usize].as_dvec3())),
                uv: Self::triangle_indices(&lists.mapped, i).map(|numbers| numbers.map(|n| lists.uvs[n as usize])),
            }
        };
        self.written.iter().map(face).collect()
    }

    /// Returns the three indices of a triangle in a list; `None` if the list has no entry for the triangle.
    fn triangle_indices(list: &[[u32; 3]], face: usize) -> Option<[u32; 3]> {
        list.get(face).copied().filter(|numbers| *numbers != NONE)
    }

    /// Bounding box of all triangles of the mesh.
    pub fn bounds(&self) -> Aabb {
        self.bounds.unwrap_or(Aabb::EMPTY)
    }

    /// Bounding box of the mesh under the transform M.
    pub fn bounds_under(&self, m: &Transform) -> Aabb {
        Aabb::from_points(self.points().map(|p| m.transform_point(p)))
    }

    /// Calls `visit` with each hit of a ray on the mesh in the range; `visit` returns the distance up to which hits are
    /// still of interest.
    fn visit_hits(&self, ray: &Ray, range: Range, mut visit: impl FnMut(Hit) -> ControlFlow<(), f64>) {
        self.bvh.visit_hits(ray, range, |part, t, uv| visit(Hit { t, part, uv }));
    }

    /// Appends all hits of a ray on the mesh in the range.
    pub fn hits(&self, ray: &Ray, range: Range, out: &mut Hits) {
        self.visit_hits(ray, range, |hit| {
            out.push(hit);
            ControlFlow::Continue(range.max)
        });
    }

    /// Returns the closest hit of the ray on the mesh within the range; `None` for a miss.
    pub fn closest(&self, ray: &Ray, range: Range) -> Option<Hit> {
        let mut best = None;
        self.visit_hits(ray, range, |hit| {
            best = Some(hit);
            ControlFlow::Continue(hit.t)
        });
        best
    }

    /// True if the ray has any hit on the mesh in the range.
    pub fn any_hit(&self, ray: &Ray, range: Range) -> bool {
        let mut found = false;
        self.visit_hits(ray, range, |_| {
            found = true;
            ControlFlow::Break(())
        });
        found
    }

    /// True if the ray starts in the mesh's bounding box and hits an odd number of its triangles.
    pub fn is_crossed_oddly(&self, ray: &Ray) -> bool {
        let mut odd = false;
        if self.bounds().contains(ray.origin) {
            self.visit_hits(ray, Range::FORWARD, |_| {
                odd = !odd;
                ControlFlow::Continue(f64::INFINITY)
            });
        }
        odd
    }

    /// Normal of the mesh at a hit, of any length.
    pub fn normal(&self, hit: &Hit) -> DVec3 {
        let face = hit.part as usize;
        let [a, b, c] = self.corners_of_face(face);
        let flat = Triangle::new(a, b, c).face_normal();
        let Some(smooth) = Self::triangle_indices(&self.lists.smooth, face) else { return flat };
        let sum = self.interpolate_corners(hit, smooth.map(|i| self.lists.normals[i as usize].as_dvec3()));
        if sum == DVec3::ZERO { flat } else { sum }
    }

    /// Interpolates values of the corners of the mesh's triangle at a hit.
    fn interpolate_corners<T>(&self, hit: &Hit, [a, b, c]: [T; 3]) -> T
    where
        T: std::ops::Mul<f64, Output = T> + std::ops::Add<Output = T>,
    {
        a * (1.0 - hit.uv.x - hit.uv.y) + b * hit.uv.x + c * hit.uv.y
    }

    /// Surface coordinates of the mesh at a hit; (0, 0) for a triangle without any (quirk: `mesh_without_uv`).
    pub fn uv(&self, hit: &Hit) -> DVec2 {
        let mapped = Self::triangle_indices(&self.lists.mapped, hit.part as usize);
        mapped.map_or(DVec2::ZERO, |numbers| self.interpolate_corners(hit, numbers.map(|i| self.lists.uvs[i as usize])))
    }

    /// Textures at the corners of the mesh's triangle that was hit; `None` for a mesh without textured triangles.
    pub fn corner_textures(&self, hit: &Hit) -> Option<CornerTextures> {
        let flagged = Self::triangle_indices(&self.lists.painted, hit.part as usize)?;
        let is_per_corner = flagged[0] & EACH_CORNER != 0;
        Some(CornerTextures { numbers: flagged.map(|number| number & !EACH_CORNER), is_per_corner })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::fp;

    /// A grid of n×n squares over [0, 1]², each of two triangles, on a curved surface.
    fn grid(n: usize) -> TriangleHierarchy {
        let at = |i: usize, j: usize| {
            let (x, y) = (i as f64 / n as f64, j as f64 / n as f64);
            DVec3::new(x, y, 0.3 * fp::sin(x * 7.0) * fp::cos(y * 5.0)).as_vec3()
        };
        let number = |i: usize, j: usize| (i * (n + 1) + j) as u32;
        let mut mesh = Triangles::default();
        for i in 0..=n {
            mesh.vertices.extend((0..=n).map(|j| at(i, j)));
        }
        for (i, j) in (0..n).flat_map(|i| (0..n).map(move |j| (i, j))) {
            let [a, b, c, d] = [number(i, j), number(i + 1, j), number(i + 1, j + 1), number(i, j + 1)];
            mesh.corners.extend([[a, b, c], [a, c, d]]);
        }
        TriangleHierarchy::new(mesh)
    }

    #[test]
    fn watertight() {
        let mesh = grid(8);
        // Rays along the grid's own lines and corners, where they could pass between triangles.
        for k in 0..=160 {
            for l in 0..=160 {
                let p = DVec3::new(f64::from(k) / 160.0, f64::from(l) / 160.0, 5.0);
                for dir in [DVec3::NEG_Z, DVec3::new(1e-9, -1e-9, -1.0), DVec3::new(-0.25, 0.125, -1.0)] {
                    let ray = Ray::new(p - dir * 9.0, dir);
                    let end = ray.at(9.0 + 5.0 / -dir.z);
                    let within = end.truncate().clamp(DVec2::splat(0.1), DVec2::splat(0.9)) == end.truncate();
                    assert!(!within || mesh.any_hit(&ray, Range::FORWARD), "{k} {l} {dir}");
                }
            }
        }
    }

    #[test]
    fn hits_lie_on_their_triangle() {
        let mesh = grid(5);
        for k in 0..500 {
            let at = |m: usize| (k * m % 97) as f64 / 97.0;
            let ray = Ray::new(DVec3::new(at(13), at(29), 3.0), DVec3::new(at(7) - 0.5, at(11) - 0.5, -2.0));
            let mut all = Hits::new();
            mesh.hits(&ray, Range::ALL, &mut all);
            for hit in &all {
                let p = mesh.interpolate_corners(hit, mesh.corners_of_face(hit.part as usize));
                assert!(p.distance(ray.at(hit.t)) < 1e-12, "{hit:?}");
                assert!(mesh.bounds().contains(p));
            }
            let nearest = all.iter().map(|hit| hit.t).filter(|t| *t > 0.0).reduce(f64::min);
            assert_eq!(mesh.closest(&ray, Range::FORWARD).map(|hit| hit.t), nearest);
            assert_eq!(mesh.any_hit(&ray, Range::FORWARD), nearest.is_some());
        }
    }
}
