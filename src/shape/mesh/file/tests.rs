//! A cube in each format is the `box`, by all rays.

use super::*;
use crate::math::{DVec3, Range, Ray};
use crate::mesh_io;
use crate::shape::{Cuboid, Kernel};

const CORNERS: [[f64; 3]; 8] = [
    [0.0, 0.0, 0.0],
    [2.0, 0.0, 0.0],
    [2.0, 1.0, 0.0],
    [0.0, 1.0, 0.0],
    [0.0, 0.0, 3.0],
    [2.0, 0.0, 3.0],
    [2.0, 1.0, 3.0],
    [0.0, 1.0, 3.0],
];
const SIDES: [[usize; 4]; 6] = [[0, 1, 2, 3], [4, 7, 6, 5], [0, 4, 5, 1], [3, 2, 6, 7], [0, 3, 7, 4], [1, 5, 6, 2]];

fn cube_triangles() -> impl Iterator<Item = [usize; 3]> {
    SIDES.into_iter().flat_map(|[a, b, c, d]| [[a, b, c], [a, c, d]])
}

fn cube_text(corner: impl Fn(&[f64; 3]) -> String, side: impl Fn([usize; 4]) -> String) -> String {
    CORNERS.iter().map(corner).chain(SIDES.into_iter().map(side)).collect()
}

fn cube_ply_text() -> Vec<u8> {
    let head = "ply\nformat ascii 1.0\ncomment a cube\nelement vertex 8\nproperty float x\nproperty float y\nproperty float z\n\
                property uchar red\nelement face 6\nproperty list uchar int vertex_indices\nend_header\n";
    let body = cube_text(|[x, y, z]| format!("{x} {y} {z} 255\n"), |[a, b, c, d]| format!("4 {a} {b} {c} {d}\n"));
    (head.to_string() + &body).into()
}

fn cube_ply_bytes(big: bool) -> Vec<u8> {
    let order = if big { "big" } else { "little" };
    let mut out = format!(
        "ply\r\nformat binary_{order}_endian 1.0\r\nelement vertex 8\r\nproperty double x\r\nproperty float y\r\nproperty short z\r\n\
         element face 6\r\nproperty uchar flags\r\nproperty list ushort uint vertex_index\r\nend_header\r\n"
    )
    .into_bytes();
    macro_rules! put {
        ($x:expr) => {{
            let x = $x;
            out.extend(if big { x.to_be_bytes() } else { x.to_le_bytes() });
        }};
    }
    for [x, y, z] in CORNERS {
        put!(x);
        put!(y as f32);
        put!(z as i16);
    }
    for side in SIDES {
        put!(7u8);
        put!(4u16);
        for i in side {
            put!(i as u32);
        }
    }
    out
}

fn cube_obj() -> Vec<u8> {
    // By numbers, by numbers from the end, and with all that a corner may have.
    let side = |[a, b, c, d]: [usize; 4]| match a {
        0 => format!("f {} {} {} {}\n", a + 1, b + 1, c + 1, d + 1),
        3 => format!("f -{} -{} \\\n -{} -{}\r\n", 8 - a, 8 - b, 8 - c, 8 - d),
        _ => format!("f {}/1/1 {}//1 {}/1 {}\n", a + 1, b + 1, c + 1, d + 1),
    };
    let body = cube_text(|[x, y, z]| format!("v {x} {y} {z}\n"), side);
    format!("# a cube\no cube\nvt 0 0\nvn 0 0 1\ng sides\ns off\n{body}l 1 2\n").into()
}

fn cube_stl_text() -> Vec<u8> {
    let vertex = |i: usize| format!("   vertex {} {} {}\n", CORNERS[i][0], CORNERS[i][1], CORNERS[i][2]);
    let facet = |[a, b, c]: [usize; 3]| {
        format!(" facet normal 0 0 0\n  outer loop\n{}{}{}  endloop\n endfacet\n", vertex(a), vertex(b), vertex(c))
    };
    format!("solid cube\n{}endsolid cube\n", cube_triangles().map(facet).collect::<String>()).into()
}

fn cube_stl_bytes() -> Vec<u8> {
    // As some programs begin them.
    let mut out = b"solid no text".to_vec();
    out.resize(80, b' ');
    out.extend(12u32.to_le_bytes());
    for corners in cube_triangles() {
        out.extend([0; 12]);
        for x in corners.into_iter().flat_map(|i| CORNERS[i]) {
            out.extend((x as f32).to_le_bytes());
        }
        out.extend([0; 2]);
    }
    out
}

/// Creates a glTF file whose triangles are half as large, and put in their place by two nodes.
fn cube_gltf_parts() -> (String, Vec<u8>) {
    let mut bytes: Vec<u8> = cube_triangles().flatten().map(|i| i as u8).collect();
    for [x, y, z] in CORNERS {
        for x in [x / 2.0 - 1.0, y, z / 2.0] {
            bytes.extend((x as f32).to_le_bytes());
        }
        bytes.extend([0; 4]);
    }
    let json = r#""scene": 0, "scenes": [{"nodes": [1]}],
        "nodes": [{"mesh": 0, "translation": [2, 0, 0]}, {"children": [0], "matrix": [2,0,0,0, 0,1,0,0, 0,0,2,0, -2,0,0,1]}],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 1}, "indices": 0, "material": 0}]}],
        "materials": [{"name": "red", "pbrMetallicRoughness": {"baseColorFactor": [1, 0.25, 0, 1]}}],
        "accessors": [{"bufferView": 0, "componentType": 5121, "count": 36, "type": "SCALAR"},
            {"bufferView": 1, "componentType": 5126, "count": 8, "type": "VEC3"}],
        "bufferViews": [{"buffer": 0, "byteLength": 36}, {"buffer": 0, "byteOffset": 36, "byteLength": 128, "byteStride": 16}]"#;
    (json.into(), bytes)
}

fn cube_glb() -> Vec<u8> {
    let (json, bytes) = cube_gltf_parts();
    let json = format!("{{{json}, \"buffers\": [{{\"byteLength\": {}}}]}}", bytes.len());
    let mut out = b"glTF\x02\0\0\0\0\0\0\0".to_vec();
    for (kind, part) in [(b"JSON", json.as_bytes()), (b"BIN\0", &bytes)] {
        out.extend((part.len() as u32).to_le_bytes());
        out.extend(kind);
        out.extend(part);
    }
    out
}

fn cube_gltf() -> Vec<u8> {
    let (json, _) = cube_gltf_parts();
    format!("{{{json}, \"buffers\": [{{\"byteLength\": 164, \"uri\": \"my%20cube.bin\"}}]}}").into()
}

fn read_mesh(bytes: &[u8], ending: &str) -> Result<MeshFile, String> {
    mesh_io::read_mesh_file(bytes, ending, &mut |name| match name {
        "my cube.bin" => Ok(cube_gltf_parts().1),
        "red.mtl" => {
            Ok(b"newmtl red\nKd 1 0 0\nd 0.25\nKs 0.5 0.5 0.5\nNs 60\nmap_Kd -s 1 1 1 -bm 2 my red.png\n".into())
        }
        _ => Err(format!("no file `{name}`")),
    })
}

#[test]
fn a_cube_is_a_box() {
    let cuboid = Cuboid::new(DVec3::ZERO, DVec3::new(2.0, 1.0, 3.0));
    let files = [
        ("ply", cube_ply_text()),
        ("ply", cube_ply_bytes(false)),
        ("ply", cube_ply_bytes(true)),
        ("obj", cube_obj()),
        ("STL", cube_stl_text()),
        ("stl", cube_stl_bytes()),
        ("gltf", cube_gltf()),
        ("glb", cube_glb()),
    ];
    for (ending, bytes) in files {
        let file = read_mesh(&bytes, ending).unwrap();
        assert_eq!((file.triangles.corners.len(), file.triangles.vertices.len()), (12, 8), "{ending}");
        let mesh = TriangleHierarchy::new(file.triangles);
        for k in 0..2000 {
            let at = |m: usize| (k * m % 1009) as f64 / 1009.0 - 0.5;
            let ray = Ray::new(DVec3::new(at(13), at(29), at(31)) * 9.0, DVec3::new(at(7), at(11), at(17)));
            let [found, want] = [mesh.closest(&ray, Range::FORWARD), Kernel::closest(&cuboid, &ray, Range::FORWARD)];
            assert_eq!(found.is_some(), want.is_some(), "{ending} {ray:?}");
            if let (Some(found), Some(want)) = (found, want) {
                assert!((found.t - want.t).abs() < 1e-11, "{ending} {found:?} {want:?}");
                let normal = Kernel::normal(&cuboid, ray.at(want.t), &want);
                assert!(mesh.normal(&found).normalize().dot(normal).abs() > 0.999_999, "{ending} {ray:?}");
            }
        }
    }
}

#[test]
fn materials_are_read_from_obj_and_gltf() {
    let text = "mtllib red.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nusemtl red\nf 1 2 3\nusemtl blue\nf 1 2 3\n";
    let file = read_mesh(text.as_bytes(), "obj").unwrap();
    assert_eq!(file.triangles.painted, [[0; 3], [1; 3], [0; 3]]);
    assert_eq!(file.remarks, ["line 8: there is no material `blue`"]);
    let material = &file.materials[0];
    assert_eq!(
        (material.color, material.opacity, material.specular, material.shininess),
        ([1.0, 0.0, 0.0], 0.25, 0.5, 60.0)
    );
    assert_eq!(material.picture.as_deref(), Some("my red.png"));
    let file = read_mesh(&cube_glb(), "").unwrap();
    assert_eq!((file.materials[0].color, file.materials[0].is_linear), ([1.0, 0.25, 0.0], true));
    assert_eq!(file.triangles.painted, [[1; 3]; 12]);
}

#[test]
fn strips_and_fans_turn_one_way() {
    let (json, bytes) = cube_gltf_parts();
    for (mode, want) in [(5, [[0, 1, 2], [1, 0, 2]]), (6, [[1, 2, 0], [2, 0, 0]])] {
        let json = json.replace("\"indices\": 0", &format!("\"indices\": 0, \"mode\": {mode}")).replace("36,", "4,");
        let json = format!("{{{json}, \"buffers\": [{{\"uri\": \"my cube.bin\"}}]}}");
        let file = read_mesh(json.as_bytes(), "gltf").unwrap();
        assert_eq!((bytes[..4].to_vec(), file.triangles.corners), (vec![0, 1, 2, 0], want.to_vec()));
    }
}

#[test]
fn faults_have_a_place() {
    let mut others = vec![];
    let ply = String::from_utf8(cube_ply_text()).unwrap();
    let changed = |from: &str, to: &str| ply.replacen(from, to, 1).into_bytes();
    let mut cut = cube_ply_bytes(false);
    cut.truncate(cut.len() - 5);
    let mut far = cube_glb();
    let at = far.windows(3).position(|w| w == b"128").unwrap();
    far[at..at + 3].copy_from_slice(b"990");
    for (bytes, ending, want) in [
        (cut, "ply", "the file ends within its 6 `face` elements"),
        (ply.as_bytes()[..150].to_vec(), "ply", "the header has no `end_header`"),
        (ply.as_bytes()[..230].to_vec(), "ply", "in its `vertex` elements: line 16: "),
        (changed("vertex 8", "vertex 4000000000"), "ply", "the file ends within its 4000000000 `vertex` elements"),
        (changed("face 6", "face 4000000000"), "ply", "the file ends within its 4000000000 `face` elements"),
        (changed("4 0 1 2 3", "4 0 1 2 8"), "ply", "`face` 0 has a corner 8, and there are 8"),
        (changed("4 0 1 2 3", "4 0 1 2 -1"), "ply", "`face` 0 has a corner -1"),
        (changed("4 0 1 2 3", "4000000000 0 1 2 3"), "ply", "in its `face` elements: line 20: "),
        (changed("0 0 0 255", "0 nan 0 255"), "ply", "in its `vertex` elements: line 12: "),
        (changed("float x", "real x"), "ply", "line 5: "),
        (b"v 0 0 0\nf 1 2 3\n".to_vec(), "obj", "line 2: there is no corner 2: 1 stand before"),
        (b"v 0 0\n".to_vec(), "obj", "line 1: expected 3 numbers, found 2"),
        (b"f 0 1 2\n".to_vec(), "obj", "line 1: there is no corner 0"),
        (b"v 1 1 x\n".to_vec(), "obj", "line 1: expected a number, found `x`"),
        (b"v 1 1 1e999\n".to_vec(), "obj", "line 1: a corner's place is not a number"),
        (vec![], "obj", "it holds no triangles"),
        (vec![], "stl", "it ends within its first 84 bytes"),
        (cube_stl_bytes()[..100].to_vec(), "stl", "it holds no triangles"),
        (
            {
                let mut b = vec![0; 84];
                b[83] = 255;
                b
            },
            "stl",
            "byte 84: it ends after 0 of 4278190080 triangles",
        ),
        (b"solid\nfacet\nvertex 0 0 0\nendloop\n".to_vec(), "stl", "line 4: this facet has 1 corners"),
        (b"{\n".to_vec(), "gltf", "line 2: EOF"),
        (b"glTF\x01\0\0\0".to_vec(), "glb", "byte 4: only version 2"),
        (far, "glb", "accessor 1: its bytes from 36 on are 990, and buffer 0 ends at 164"),
        (b"hello".to_vec(), "txt", "it is none of ply, obj, stl, gltf and glb"),
    ] {
        let found = read_mesh(&bytes, ending).unwrap_err();
        if !found.contains(want) {
            others.push((found, want));
        }
    }
    assert!(others.is_empty(), "{others:#?}");
}

#[test]
fn whatever_is_changed_gives_a_message_or_triangles() {
    let mut seed = 1u32;
    let mut random = |n: usize| {
        seed = seed.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
        (seed >> 8) as usize % n
    };
    for (ending, bytes) in [
        ("ply", cube_ply_text()),
        ("ply", cube_ply_bytes(true)),
        ("obj", cube_obj()),
        ("stl", cube_stl_bytes()),
        ("glb", cube_glb()),
    ] {
        for _ in 0..2000 {
            let mut bytes = bytes.clone();
            for _ in 0..1 + random(4) {
                let at = random(bytes.len());
                match random(4) {
                    0 => bytes.truncate(at + 1),
                    1 => bytes[at] = [b'0', b'9', b'-', b' ', b'\n', b',', 0, 255][random(8)],
                    2 => drop(bytes.remove(at.min(bytes.len() - 1))),
                    _ => bytes[at] = random(256) as u8,
                }
                if bytes.is_empty() {
                    break;
                }
            }
            if let Ok(file) = read_mesh(&bytes, ending) {
                let mesh = TriangleHierarchy::new(file.triangles);
                mesh.any_hit(&Ray::new(DVec3::splat(-3.0), DVec3::new(0.3, 0.2, 0.4)), Range::FORWARD);
            }
        }
    }
}
