//! The nodes of a glTF file, and their triangles.

use super::super::{MANY, MeshFile, NONE, ReadResult, finite_point, unit_direction};
use super::accessor::Rows;
use super::document::{Document, Node, Primitive};
use crate::math::{DVec2, DVec3, Transform};
use glam::{DAffine3, DMat4, DQuat};

/// Appends the triangles of a glTF file's default scene, or of all nodes if there is no scene. `total_file_bytes` is
/// the total size of all files, in bytes.
pub fn read_nodes(
    document: &Document,
    buffers: &[Vec<u8>],
    total_file_bytes: usize,
    out: &mut MeshFile,
) -> ReadResult<()> {
    let mut is_child = vec![false; document.nodes.len()];
    for child in document.nodes.iter().flat_map(|node| &node.children) {
        match is_child.get_mut(*child) {
            None => return Err(format!("there is no node {child}")),
            Some(true) => return Err(format!("node {child} hangs in the tree twice")),
            Some(known) => *known = true,
        }
    }
    let roots = match document.scenes.get(document.scene) {
        Some(scene) => scene.nodes.clone(),
        None => (0..document.nodes.len()).filter(|i| !is_child[*i]).collect(),
    };
    // (No node has two parents, so each is visited once.)
    let mut open: Vec<(usize, DAffine3)> = roots.into_iter().rev().map(|root| (root, DAffine3::IDENTITY)).collect();
    if let Some((root, _)) = open.iter().find(|(root, _)| is_child.get(*root) != Some(&false)) {
        return Err(format!(
            "the scene begins with node {root}, which is {}",
            if *root < is_child.len() { "another's child" } else { "not there" }
        ));
    }
    while let Some((number, around)) = open.pop() {
        let node = &document.nodes[number];
        let place = around * node_matrix(node);
        open.extend(node.children.iter().rev().map(|child| (*child, place)));
        let Some(mesh) = node.mesh else { continue };
        let mesh = document.meshes.get(mesh).ok_or_else(|| format!("node {number}: there is no mesh {mesh}"))?;
        for primitive in &mesh.primitives {
            read_primitive(document, buffers, primitive, &place, out).map_err(|why| format!("node {number}: {why}"))?;
        }
        let count = out.triangles.corners.len().max(out.triangles.vertices.len());
        if count > total_file_bytes.max(MANY) {
            return Err(format!(
                "node {number}: its nodes name the same meshes so often that there are more than {MANY} triangles"
            ));
        }
    }
    Ok(())
}

fn node_matrix(node: &Node) -> DAffine3 {
    match &node.matrix {
        Some(all) => DAffine3::from_mat4(DMat4::from_cols_array(all)),
        None => DAffine3::from_scale_rotation_translation(
            node.scale.unwrap_or([1.0; 3]).into(),
            DQuat::from_array(node.rotation.unwrap_or([0.0, 0.0, 0.0, 1.0])).normalize(),
            node.translation.unwrap_or_default().into(),
        ),
    }
}

fn read_primitive(
    document: &Document,
    buffers: &[Vec<u8>],
    primitive: &Primitive,
    place: &DAffine3,
    out: &mut MeshFile,
) -> ReadResult<()> {
    let (Some(position), 4..=6) = (primitive.attributes.position, primitive.mode) else { return Ok(()) };
    let positions = Rows::new(document, buffers, position, 3)?;
    let attribute = |number: Option<usize>, width| number.map(|i| Rows::new(document, buffers, i, width)).transpose();
    let (normals, uvs) = (attribute(primitive.attributes.normal, 3)?, attribute(primitive.attributes.uv, 2)?);
    let indices = attribute(primitive.indices, 1)?;
    if [&normals, &uvs].into_iter().flatten().any(|rows| rows.count < positions.count) {
        return Err("there are fewer normals or surface coordinates than corners".into());
    }
    if primitive.material.is_some_and(|i| i >= document.materials.len()) {
        return Err("it has a material that is not there".into());
    }
    let triangles = &mut out.triangles;
    let (first, first_normal, first_uv) = (triangles.vertices.len(), triangles.normals.len(), triangles.uvs.len());
    // (A singular transform has no normals.)
    let m = Transform::from_affine(*place).ok();
    for i in 0..positions.count {
        let p = place.transform_point3(DVec3::from_array(positions.row_numbers(i)));
        triangles.vertices.push(finite_point(p.to_array(), || format!("corner {i}"))?);
    }
    for i in 0..normals.as_ref().map_or(0, |_| positions.count) {
        let n = normals.as_ref().map_or([0.0; 3], |rows| rows.row_numbers(i));
        triangles.normals.push(unit_direction(m.map_or(DVec3::ZERO, |m| m.transform_normal(n.into())).to_array()));
    }
    // In glTF v = 0 is the top of a picture, in POV-Ray the bottom.
    for i in 0..uvs.as_ref().map_or(0, |_| positions.count) {
        let [u, v] = uvs.as_ref().map_or([0.0; 2], |rows| rows.row_numbers(i));
        triangles.uvs.push(DVec2::new(u, 1.0 - v));
    }
    let count = indices.as_ref().map_or(positions.count, |rows| rows.count);
    let number = |i: usize| -> ReadResult<u32> {
        let n = indices.as_ref().map_or(i as f64, |rows| rows.row_numbers::<1>(i)[0]);
        if n < positions.count as f64 {
            Ok(n as u32)
        } else {
            Err(format!("it has a corner {n}, and there are {}", positions.count))
        }
    };
    let material_or_0 = primitive.material.map_or(0, |i| i as u32 + 1);
    for face in 0..if primitive.mode == 4 { count / 3 } else { count.saturating_sub(2) } {
        // Every second triangle of a strip has the opposite orientation.
        let places = match primitive.mode {
            4 => [3 * face, 3 * face + 1, 3 * face + 2],
            5 => [face, face + 1 + face % 2, face + 2 - face % 2],
            _ => [face + 1, face + 2, 0],
        };
        let corners = [number(places[0])?, number(places[1])?, number(places[2])?];
        let of = |has: bool, first: usize| if has { corners.map(|n| n + first as u32) } else { NONE };
        let (smooth, mapped) = (of(normals.is_some(), first_normal), of(uvs.is_some(), first_uv));
        triangles.push_triangle(of(true, first), smooth, mapped, [material_or_0; 3]);
    }
    Ok(())
}
