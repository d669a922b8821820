//! Triangles by the million: `mesh` and `mesh2`, which differ only in how they are written.
//!
//! All triangles of one mesh are one shape with a hierarchy of its own, which its copies share. Rays meet them by the test of Woop,
//! Benthin and Wald (Watertight ray/triangle intersection, Journal of Computer Graphics Techniques, 2013): a ray never slips through
//! between two triangles that share a side.

mod read;

pub use read::{Mesh, Mesh2};

use super::{Hit, Hits, Slots, Triangle};
use crate::math::bvh::{self, Bvh};
use crate::math::{Aabb, DVec2, DVec3, Range, Ray, Transform};
use serde::Serialize;
use smallvec::smallvec;
use std::ops::ControlFlow;

/// In a list of three numbers: this triangle has none.
const NONE: [u32; 3] = [u32::MAX; 3];

/// Triangles whose corners, normals and surface coordinates are numbers into lists.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
pub struct TriangleMesh {
    /// In object space.
    pub vertices: Vec<DVec3>,
    /// Length 1.
    pub normals: Vec<DVec3>,
    /// Surface coordinates.
    pub uvs: Vec<DVec2>,
    /// Numbers of the corners of each triangle.
    pub corners: Vec<[u32; 3]>,
    /// Numbers of the normals at the corners, of each triangle; empty if all are flat.
    pub smooth: Vec<[u32; 3]>,
    /// Numbers of the surface coordinates at the corners, of each triangle; empty if no triangle has any.
    pub mapped: Vec<[u32; 3]>,
    /// Numbers of the textures at the corners (see [`super::Paints`]), of each triangle; empty if no triangle has any.
    pub painted: Vec<[u32; 3]>,
    /// A line in this direction crosses the surface an odd number of times from points inside; without it nothing is inside.
    pub inside_vector: Option<DVec3>,
    /// Over the triangles, which are in its order.
    #[serde(skip)]
    bvh: Bvh,
    #[serde(skip)]
    bounds: Option<Aabb>,
}

/// A ray as the test wants it: seen along its longest axis, sheared so that it runs along that.
pub(super) struct Sheared {
    origin: DVec3,
    axes: [usize; 3],
    shear: DVec3,
}

impl Sheared {
    pub(super) fn new(ray: &Ray) -> Self {
        let z = ray.dir.abs().max_position();
        // (Which way round does not matter: the signs of all three areas change together.)
        let (x, y) = ((z + 1) % 3, (z + 2) % 3);
        let shear = DVec3::new(ray.dir[x] / ray.dir[z], ray.dir[y] / ray.dir[z], 1.0 / ray.dir[z]);
        Self { origin: ray.origin, axes: [x, y, z], shear }
    }

    /// t and the weights of the second and third corner, where the line meets the triangle.
    pub(super) fn meet(&self, corners: [DVec3; 3]) -> Option<(f64, DVec2)> {
        let [x, y, z] = self.axes;
        let from = corners.map(|corner| corner - self.origin);
        let [a, b, c] = from.map(|p| DVec2::new(p[x] - self.shear.x * p[z], p[y] - self.shear.y * p[z]));
        // Twice the areas of the parts that each side cuts off with the ray.
        let (u, v, w) = (c.perp_dot(b), a.perp_dot(c), b.perp_dot(a));
        if (u < 0.0 || v < 0.0 || w < 0.0) && (u > 0.0 || v > 0.0 || w > 0.0) {
            return None;
        }
        let det = u + v + w;
        if det == 0.0 {
            return None;
        }
        let t = self.shear.z * (u * from[0][z] + v * from[1][z] + w * from[2][z]) / det;
        Some((t, DVec2::new(v, w) / det))
    }
}

impl TriangleMesh {
    /// Puts the triangles in order for rays; those without area, and those that lie beyond all measure, are left out.
    pub(super) fn finish(&mut self) {
        let kept: Vec<u32> = (0..self.corners.len() as u32).filter(|&i| self.is_solid(i as usize)).collect();
        let (bvh, order) = Bvh::build(kept.iter().map(|&i| self.face_bounds(i as usize)));
        let order: Vec<u32> = order.into_iter().map(|i| kept[i as usize]).collect();
        for list in [&mut self.corners, &mut self.smooth, &mut self.mapped, &mut self.painted] {
            if !list.is_empty() {
                *list = order.iter().map(|&i| list[i as usize]).collect();
            }
        }
        self.bounds = Some(Aabb::from_points(self.corners.iter().flatten().map(|&i| self.vertices[i as usize])));
        self.bvh = bvh;
    }

    fn is_solid(&self, face: usize) -> bool {
        let [a, b, c] = self.face(face);
        !Triangle::new(a, b, c).is_degenerate() && bvh::fits(&self.face_bounds(face))
    }

    fn face(&self, face: usize) -> [DVec3; 3] {
        self.corners[face].map(|i| self.vertices[i as usize])
    }

    fn face_bounds(&self, face: usize) -> Aabb {
        Aabb::from_points(self.face(face))
    }

    /// The numbers that a list has for a triangle.
    fn of(list: &[[u32; 3]], face: usize) -> Option<[u32; 3]> {
        list.get(face).copied().filter(|numbers| *numbers != NONE)
    }

    fn bounds(&self) -> Aabb {
        self.bounds.unwrap_or(Aabb::EMPTY)
    }

    /// The smallest box around its image under M.
    fn bounds_under(&self, m: &Transform) -> Aabb {
        Aabb::from_points(self.corners.iter().flatten().map(|&i| m.point(self.vertices[i as usize])))
    }

    /// Hands what the ray meets in the range to `visit`, which says how far hits count from now on.
    fn meet(&self, ray: &Ray, range: Range, mut visit: impl FnMut(Hit) -> ControlFlow<(), f64>) {
        let sheared = Sheared::new(ray);
        self.bvh.traverse(ray, range, |face, max| match sheared.meet(self.face(face)) {
            Some((t, uv)) if t > range.min && t < max => visit(Hit { t, part: face as u32, uv }),
            _ => ControlFlow::Continue(max),
        });
    }

    fn hits(&self, ray: &Ray, range: Range, out: &mut Hits) {
        self.meet(ray, range, |hit| {
            out.push(hit);
            ControlFlow::Continue(range.max)
        });
    }

    fn closest(&self, ray: &Ray, range: Range) -> Option<Hit> {
        let mut best = None;
        self.meet(ray, range, |hit| {
            best = Some(hit);
            ControlFlow::Continue(hit.t)
        });
        best
    }

    fn any(&self, ray: &Ray, range: Range) -> bool {
        let mut found = false;
        self.meet(ray, range, |_| {
            found = true;
            ControlFlow::Break(())
        });
        found
    }

    fn inside(&self, p: DVec3) -> bool {
        let Some(dir) = self.inside_vector else { return false };
        let mut odd = false;
        if self.bounds().contains(p) {
            self.meet(&Ray::new(p, dir), Range::FORWARD, |_| {
                odd = !odd;
                ControlFlow::Continue(f64::INFINITY)
            });
        }
        odd
    }

    fn normal(&self, hit: &Hit) -> DVec3 {
        let face = hit.part as usize;
        let [a, b, c] = self.face(face);
        let flat = Triangle::new(a, b, c).face_normal();
        let Some(smooth) = Self::of(&self.smooth, face) else { return flat };
        let sum = self.between(hit, smooth.map(|i| self.normals[i as usize]));
        if sum == DVec3::ZERO { flat } else { sum }
    }

    /// What lies at a hit between the values at the corners.
    fn between<T>(&self, hit: &Hit, [a, b, c]: [T; 3]) -> T
    where
        T: std::ops::Mul<f64, Output = T> + std::ops::Add<Output = T>,
    {
        a * (1.0 - hit.uv.x - hit.uv.y) + b * hit.uv.x + c * hit.uv.y
    }

    /// Where nothing is said, (0, 0) (measured on POV-Ray 3.7).
    fn uv(&self, hit: &Hit) -> DVec2 {
        let mapped = Self::of(&self.mapped, hit.part as usize);
        mapped.map_or(DVec2::ZERO, |numbers| self.between(hit, numbers.map(|i| self.uvs[i as usize])))
    }

    fn slots(&self, hit: &Hit) -> Slots {
        match Self::of(&self.painted, hit.part as usize) {
            None => smallvec![(0, 1.0)],
            Some([a, b, c]) if a == b && b == c => smallvec![(a, 1.0)],
            Some([a, b, c]) => {
                smallvec![(a, 1.0 - hit.uv.x - hit.uv.y), (b, hit.uv.x), (c, hit.uv.y)]
            }
        }
    }
}

/// A shape that is a mesh under another name.
macro_rules! mesh_kernel {
    ($name:ident) => {
        impl $crate::shape::Kernel for $name {
            fn bounds(&self) -> Aabb {
                self.0.bounds()
            }

            fn bounds_under(&self, m: &Transform) -> Aabb {
                self.0.bounds_under(m)
            }

            fn hits(&self, ray: &Ray, range: Range, out: &mut Hits) {
                self.0.hits(ray, range, out);
            }

            fn closest(&self, ray: &Ray, range: Range) -> Option<Hit> {
                self.0.closest(ray, range)
            }

            fn any(&self, ray: &Ray, range: Range) -> bool {
                self.0.any(ray, range)
            }

            fn inside(&self, p: DVec3) -> bool {
                self.0.inside(p)
            }

            fn normal(&self, _: DVec3, hit: &Hit) -> DVec3 {
                self.0.normal(hit)
            }

            fn uv(&self, _: DVec3, hit: &Hit) -> DVec2 {
                self.0.uv(hit)
            }

            fn slots(&self, _: DVec3, hit: &Hit) -> Slots {
                self.0.slots(hit)
            }

            fn is_patch(&self) -> bool {
                self.0.inside_vector.is_none()
            }
        }
    };
}
use mesh_kernel;

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::fp;

    /// A grid of n×n squares over [0, 1]², each of two triangles, on a curved surface.
    fn grid(n: usize) -> TriangleMesh {
        let at = |i: usize, j: usize| {
            let (x, y) = (i as f64 / n as f64, j as f64 / n as f64);
            DVec3::new(x, y, 0.3 * fp::sin(x * 7.0) * fp::cos(y * 5.0))
        };
        let number = |i: usize, j: usize| (i * (n + 1) + j) as u32;
        let mut mesh = TriangleMesh::default();
        for i in 0..=n {
            mesh.vertices.extend((0..=n).map(|j| at(i, j)));
        }
        for (i, j) in (0..n).flat_map(|i| (0..n).map(move |j| (i, j))) {
            let [a, b, c, d] = [number(i, j), number(i + 1, j), number(i + 1, j + 1), number(i, j + 1)];
            mesh.corners.extend([[a, b, c], [a, c, d]]);
        }
        mesh.finish();
        mesh
    }

    #[test]
    fn watertight() {
        let mesh = grid(8);
        // Along the grid's own lines and corners, where rays would slip through.
        for k in 0..=160 {
            for l in 0..=160 {
                let p = DVec3::new(f64::from(k) / 160.0, f64::from(l) / 160.0, 5.0);
                for dir in [DVec3::NEG_Z, DVec3::new(1e-9, -1e-9, -1.0), DVec3::new(-0.25, 0.125, -1.0)] {
                    let ray = Ray::new(p - dir * 9.0, dir);
                    let end = ray.at(9.0 + 5.0 / -dir.z);
                    let within = end.truncate().clamp(DVec2::splat(0.1), DVec2::splat(0.9)) == end.truncate();
                    assert!(!within || mesh.any(&ray, Range::FORWARD), "{k} {l} {dir}");
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
                let p = mesh.between(hit, mesh.face(hit.part as usize));
                assert!(p.distance(ray.at(hit.t)) < 1e-12, "{hit:?}");
                assert!(mesh.bounds().contains(p));
            }
            let nearest = all.iter().map(|hit| hit.t).filter(|t| *t > 0.0).reduce(f64::min);
            assert_eq!(mesh.closest(&ray, Range::FORWARD).map(|hit| hit.t), nearest);
            assert_eq!(mesh.any(&ray, Range::FORWARD), nearest.is_some());
        }
    }
}
