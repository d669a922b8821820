//! `mesh_camera { rays distribution [distance] mesh { … } … [smooth] }`: a ray from the centre of each triangle, along
//! its normal (manual, "Mesh Camera").

use super::povray::{Kind, PovrayCamera};
use crate::diagnostic::{Diagnostic, Result, codes};
use crate::math::bvh::{self, Bvh};
use crate::math::{Aabb, DVec2, DVec3, Range, Ray, Transform};
use crate::shape::Face;
use crate::value::{Next, Reader};
use serde::Serialize;
use std::ops::ControlFlow;
use std::sync::Arc;

/// Mesh camera as written: rays start from the faces of meshes.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct MeshCamera {
    /// Number of rays per pixel. With distribution 0, ray n starts from a face of mesh n; the others use one ray.
    pub rays: usize,
    /// Assignment of the mesh camera's faces to pixels.
    pub distribution: Distribution,
    /// Distance along a mesh camera's ray beyond which hits are ignored, in world units; ∞ without a limit.
    pub reach: f64,
    /// True if the mesh camera interpolates the normals of corners.
    pub smooth: bool,
    /// The mesh camera's meshes, in the order written.
    #[serde(skip)]
    pub meshes: Vec<PlacedMesh>,
}

/// The faces of a mesh camera's mesh, with the mesh's transform.
#[derive(Clone, Debug, PartialEq)]
pub struct PlacedMesh {
    /// Faces of the mesh in object space, in the order written. Copies of one mesh share them.
    pub faces: Arc<[Face]>,
    /// Transform of the mesh from object to world space.
    pub transform: Transform,
}

impl PlacedMesh {
    /// Returns the centre of the mesh's face and its normal, of any length; `None` if the mesh has no such face.
    fn face_center_and_normal(&self, index: usize) -> Option<(DVec3, DVec3)> {
        let Face { corners: [a, b, c], normal, .. } = self.faces.get(index)?;
        Some((self.transform.transform_point((*a + *b + *c) / 3.0), self.transform.transform_normal(*normal)))
    }

    /// Returns a face of the mesh in world space.
    fn world_face(&self, index: usize) -> Face {
        self.faces[index].clone().transformed(&self.transform)
    }
}

/// Assignment of a mesh camera's faces to pixels; the numbers are those of POV-Ray's manual.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Distribution {
    /// Mesh camera, distribution 0: each mesh has a face for each pixel, row by row.
    Layers,
    /// Mesh camera, distribution 1: all meshes together have a face for each pixel.
    Row,
    /// Mesh camera, distribution 2: each mesh covers a stripe of the picture.
    Stripes,
    /// Mesh camera, distribution 3: a pixel belongs to the face that contains its uv coordinates.
    Uv,
}

/// Function that reads a mesh between the braces of its block; a parameter, since objects are in a layer above cameras.
pub type ReadMesh<'a> = &'a mut dyn FnMut(&mut dyn Reader) -> Result<PlacedMesh>;

impl PovrayCamera {
    /// Reads the items of a `mesh_camera` block.
    pub(super) fn read_mesh_camera(&mut self, r: &mut dyn Reader, read_mesh: ReadMesh) -> Result<()> {
        let mut camera = MeshCamera::read_rays_and_distribution(r)?;
        loop {
            match r.peek_next()? {
                Next::End => break,
                Next::Block("mesh" | "mesh2") => camera.meshes.push(read_mesh(r)?),
                Next::Word("smooth") if camera.distribution == Distribution::Uv => {
                    r.take_token()?;
                    camera.smooth = r.flag()?;
                }
                _ => return Err(r.unknown_word("mesh_camera", &["mesh", "mesh2", "smooth"]).into()),
            }
        }
        let at = r.span();
        if camera.meshes.is_empty() {
            let d = Diagnostic::new(codes::BAD_CAMERA, at, "this `mesh_camera` has no `mesh`");
            return Err(d.help("its rays begin at the faces of a mesh: `mesh { Name }`").into());
        }
        if camera.distribution == Distribution::Layers && camera.rays > camera.meshes.len() {
            let (rays, meshes) = (camera.rays, camera.meshes.len());
            let message = format!("{rays} rays a pixel want {rays} meshes with distribution 0, found {meshes}");
            return Diagnostic::err(codes::BAD_CAMERA, at, message);
        }
        (self.kind, self.mesh) = (Kind::Mesh, Some(Arc::new(camera)));
        Ok(())
    }
}

impl MeshCamera {
    fn read_rays_and_distribution(r: &mut dyn Reader) -> Result<Self> {
        let (at, rays) = (r.span(), r.float()?);
        if !(1.0..=1e6).contains(&rays) {
            let message = format!("a `mesh_camera` begins with its rays per pixel, 1 or more, found {rays}");
            return Diagnostic::err(codes::BAD_CAMERA, at, message);
        }
        let (at, number) = (r.span(), r.float()?);
        let distribution = match number as i64 {
            0 if number > -1.0 => Distribution::Layers,
            1 => Distribution::Row,
            2 => Distribution::Stripes,
            3 => Distribution::Uv,
            _ => {
                let message = format!("a `mesh_camera` has a distribution from 0 to 3, found {number}");
                let help = "0: each mesh has a face for each pixel; 1: all together have; 2: stripes; 3: by uv";
                return Err(Diagnostic::new(codes::BAD_CAMERA, at, message).help(help).into());
            }
        };
        if matches!(distribution, Distribution::Stripes | Distribution::Uv) && rays >= 2.0 {
            return Diagnostic::err(codes::BAD_CAMERA, at, "distributions 2 and 3 take one ray a pixel");
        }
        let reach = r.optional_float()?.filter(|reach| *reach > 1e-10).unwrap_or(f64::INFINITY);
        Ok(Self { rays: rays as usize, distribution, reach, smooth: false, meshes: vec![] })
    }
}

/// Lowered mesh camera.
#[derive(Debug)]
pub struct MeshRays {
    camera: Arc<MeshCamera>,
    /// Distance between the origin of a mesh camera's ray and its face.
    offset: f64,
    /// True if the mesh camera's rays point against the normals.
    reversed: bool,
    /// For distribution 3 of a mesh camera: hierarchy over the faces of the first mesh in uv space, and the faces'
    /// numbers in its order.
    by_uv: (Bvh, Vec<u32>),
}

impl MeshRays {
    /// Lowers a mesh camera. Of location and direction only z counts: the offset of the ray's origin from the face, and
    /// the sign of the direction (quirk: `mesh_camera_location`).
    pub(super) fn new(camera: &Arc<MeshCamera>, location: DVec3, direction: DVec3) -> Self {
        let boxes = match camera.distribution {
            Distribution::Uv => camera.meshes[0].faces.iter().map(uv_bounds).collect(),
            _ => vec![],
        };
        let kept: Vec<u32> =
            (0..boxes.len() as u32).filter(|i| bvh::fits_single_precision(&boxes[*i as usize])).collect();
        let (bvh, order) = Bvh::build(kept.iter().map(|i| boxes[*i as usize]));
        let order = order.into_iter().map(|i| kept[i as usize]).collect();
        Self { camera: camera.clone(), offset: location.z, reversed: direction.z < -1e-10, by_uv: (bvh, order) }
    }

    /// Maximum number of rays of the mesh camera through a point of the picture.
    pub fn max_rays_per_point(&self) -> usize {
        if self.camera.distribution == Distribution::Layers { self.camera.rays } else { 1 }
    }

    /// Maximum distance of a hit along a ray of the mesh camera.
    pub fn max_distance(&self) -> f64 {
        self.camera.reach
    }

    /// Returns the mesh camera's ray `ray_number` through a point of the picture, in pixels; `None` without a face (quirk:
    /// `mesh_camera_first_row`).
    pub(super) fn ray_at_pixel_position(&self, x: f64, y: f64, ray_number: usize, picture_size: DVec2) -> Option<Ray> {
        let (x, y) = (x.min(picture_size.x - 1.0), y.max(1.0) - 1.0);
        let meshes = &self.camera.meshes;
        let index = x as usize + y as usize * picture_size.x as usize;
        match self.camera.distribution {
            Distribution::Layers => self.ray_from_face(meshes.get(ray_number)?, index),
            Distribution::Row => {
                // Number of faces of all meshes up to this one.
                let mut end = 0;
                let mesh = meshes.iter().find(|mesh| {
                    end += mesh.faces.len();
                    index < end
                })?;
                self.ray_from_face(mesh, index + mesh.faces.len() - end)
            }
            Distribution::Stripes => {
                let stripe = (x / picture_size.x * meshes.len() as f64) as usize;
                let width = picture_size.x as usize / meshes.len();
                self.ray_from_face(meshes.get(stripe)?, x as usize + y as usize * width)
            }
            Distribution::Uv => {
                self.ray_at_uv(DVec2::new((x - 0.5) / picture_size.x, 1.0 - (y + 0.5) / picture_size.y))
            }
        }
    }

    fn ray_from_face(&self, mesh: &PlacedMesh, face_index: usize) -> Option<Ray> {
        let (middle, normal) = mesh.face_center_and_normal(face_index)?;
        self.ray_along_normal(middle, normal)
    }

    /// Returns the ray from the first face of the mesh that contains this uv; `None` if no face does, or if the normal
    /// is zero.
    fn ray_at_uv(&self, uv: DVec2) -> Option<Ray> {
        let (bvh, order) = &self.by_uv;
        let mut first: Option<(u32, DVec3)> = None;
        bvh.traverse(&Ray::new(uv.extend(-1.0), DVec3::Z), Range::ALL, |at, max| {
            let number = order[at];
            if first.is_none_or(|(best, _)| number < best) {
                let inside = barycentric_of_uv(&self.camera.meshes[0].faces[number as usize], uv);
                first = inside.map(|weights| (number, weights)).or(first);
            }
            ControlFlow::Continue(max)
        });
        let (number, weights) = first?;
        let face = self.camera.meshes[0].world_face(number as usize);
        let between = |[a, b, c]: [DVec3; 3]| a * weights.x + b * weights.y + c * weights.z;
        let normal = match face.normals {
            Some(normals) if self.camera.smooth => between(normals),
            _ => face.normal,
        };
        self.ray_along_normal(between(face.corners), normal)
    }

    fn ray_along_normal(&self, position: DVec3, normal: DVec3) -> Option<Ray> {
        let normal = normal.try_normalize()?;
        let dir = if self.reversed { -normal } else { normal };
        Some(Ray::new(position + dir * self.offset, dir))
    }
}

fn uv_bounds(face: &Face) -> Aabb {
    match face.uv {
        Some(uv) => Aabb::from_points(uv.map(|uv| uv.extend(0.0))),
        None => Aabb::EMPTY,
    }
}

/// Barycentric weights of a uv in a face; `None` outside.
fn barycentric_of_uv(face: &Face, uv: DVec2) -> Option<DVec3> {
    let [a, b, c] = face.uv?;
    let area = (b - a).perp_dot(c - a);
    let weights = DVec3::new((b - uv).perp_dot(c - uv), (c - uv).perp_dot(a - uv), (a - uv).perp_dot(b - uv)) / area;
    (weights.min_element() >= 0.0).then_some(weights)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn face(x: f64, uv: [DVec2; 3]) -> Face {
        let corners = [DVec3::new(x, 0.0, 0.0), DVec3::new(x + 3.0, 0.0, 0.0), DVec3::new(x, 3.0, 0.0)];
        Face { corners, normal: DVec3::NEG_Z, normals: None, uv: Some(uv) }
    }

    fn rays(distribution: Distribution, meshes: Vec<Vec<Face>>) -> MeshRays {
        let meshes =
            meshes.into_iter().map(|faces| PlacedMesh { faces: faces.into(), transform: Transform::default() });
        let meshes = meshes.collect();
        let camera = MeshCamera { rays: 1, distribution, reach: f64::INFINITY, smooth: false, meshes };
        MeshRays::new(&Arc::new(camera), DVec3::Z * 2.0, DVec3::Z)
    }

    /// POV-Ray: which face is in which pixel of a picture of 4 by 3, and of 7 by 3 with stripes.
    #[test]
    fn faces_of_pixels() {
        let mesh = |n: usize| (0..n).map(|i| face(i as f64, [DVec2::ZERO; 3])).collect::<Vec<_>>();
        let size = DVec2::new(4.0, 3.0);
        let layers = rays(Distribution::Layers, vec![mesh(6), mesh(20)]);
        let at = |rays: &MeshRays, x: usize, y: usize, size| {
            rays.ray_at_pixel_position(x as f64 + 0.5, y as f64 + 0.5, 0, size).map(|ray| ray.origin.x - 1.0)
        };
        let seen = |y| [0, 1, 2, 3].map(|x| at(&layers, x, y, size));
        assert_eq!(seen(0), [0.0, 1.0, 2.0, 3.0].map(Some));
        assert_eq!(seen(1), seen(0));
        assert_eq!(seen(2), [Some(4.0), Some(5.0), None, None]);
        let row = rays(Distribution::Row, vec![mesh(6), mesh(20)]);
        assert_eq!(at(&row, 2, 2, size), Some(0.0));
        let stripes = rays(Distribution::Stripes, vec![mesh(20), mesh(20), mesh(20)]);
        let size = DVec2::new(7.0, 3.0);
        assert_eq!([0, 1, 2, 4, 5, 6].map(|x| at(&stripes, x, 0, size)), [0.0, 1.0, 2.0, 4.0, 5.0, 6.0].map(Some));
        assert_eq!([0, 2, 5].map(|x| at(&stripes, x, 2, size)), [2.0, 4.0, 7.0].map(Some));
    }

    #[test]
    fn rays_begin_before_their_face_at_its_uv() {
        let uv = [DVec2::ZERO, DVec2::X, DVec2::Y];
        let by_uv = rays(Distribution::Uv, vec![vec![face(0.0, uv), face(9.0, uv)]]);
        let size = DVec2::new(8.0, 8.0);
        let ray = by_uv.ray_at_pixel_position(2.5, 6.5, 0, size).unwrap();
        assert_eq!((ray.origin, ray.dir), (DVec3::new(0.75, 0.75, -2.0), DVec3::NEG_Z));
        assert!(by_uv.ray_at_pixel_position(7.5, 1.5, 0, size).is_none());
    }
}
