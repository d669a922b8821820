//! A hundred thousand objects take no more memory than in POV-Ray 3.7.

use durer::{pattern, scene, texture, world};
use std::process::Command;

/// A name, POV-Ray 3.7's memory for the whole scene in MiB (the largest resident set of `povray +W160 +H120 +WT1 -GA`
/// on Linux), and the statement that the scene repeats a hundred thousand times. `P` is a random point.
const SCENES: &[(&str, u64, &str)] = &[
    ("macro", 114, "Ball(P * 4, 0.01, P)"),
    ("turned", 165, "box { -0.01, 0.01 pigment { rgb P } finish { phong 0.5 } rotate P * 360 translate P * 4 }"),
    ("bumps", 158, "sphere { P, 0.01 texture { pigment { rgb P } normal { bumps 0.3 scale 0.01 } } }"),
    ("union", 208, "union { sphere { P, 0.01 } box { P, P + 0.01 } cylinder { P, P + y, 0.005 } pigment { rgb P } }"),
    ("copy", 198, "object { Pair translate P * 4 }"),
    (
        "map",
        152,
        "sphere { P, 0.01 pigment { bozo color_map { [0 rgb P] [1 rgb P.x] } scale 0.1 } finish { phong 0.5 } }",
    ),
    ("difference", 161, "difference { box { P, P + 0.01 } sphere { P, 0.007 } pigment { rgb P } }"),
];

fn text(each: &str) -> String {
    format!(
        "#version 3.7; global_settings {{ assumed_gamma 1 }} camera {{ location -10*z look_at 0 }} light_source {{ -5, 1 }}
        #macro Ball(P, R, C) sphere {{ P, R pigment {{ rgb C }} finish {{ ambient 0.2 diffuse 0.6 phong 0.5 }} }} #end
        #declare Pair = union {{ sphere {{ 0, 0.01 }} box {{ 0, 0.01 }} pigment {{ rgb x }} }}
        #declare S = seed(1);
        #for (I, 1, 100000) #local P = <rand(S), rand(S), rand(S)>; {each} #end"
    )
}

/// Peak memory of rendering the scene, in bytes; `None` where the system does not report it.
fn peak(name: &str, each: &str) -> Option<u64> {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join(format!("{name}.scene"));
    std::fs::write(&file, text(each)).unwrap();
    let mut durer = Command::new(env!("CARGO_BIN_EXE_durer"));
    let out = durer
        .args(["render", "--size", "16x12", "--threads", "1", "--no-output", "--stats", "json"])
        .arg(&file)
        .output()
        .unwrap();
    assert!(out.status.success(), "{name}: {}", String::from_utf8_lossy(&out.stderr));
    serde_json::from_slice::<serde_json::Value>(&out.stdout).unwrap()["peak_memory"].as_u64()
}

#[test]
fn memory_is_at_most_that_of_povray() {
    for (name, bound, each) in SCENES {
        let mib = peak(name, each).map_or(0, |bytes| bytes >> 20);
        println!("{name}: {mib} MiB of {bound}");
        assert!(mib <= *bound, "`{name}` takes {mib} MiB, and POV-Ray {bound}");
    }
}

/// Maximum sizes of types with one value for each object of a scene: fields that few objects need are behind a pointer.
#[test]
fn types_of_many_values_are_small() {
    let sizes = [
        ("scene::Object", size_of::<scene::Object>(), 32),
        ("scene::ObjectBody", size_of::<scene::ObjectBody>(), 72),
        ("texture::Layer", size_of::<texture::Layer>(), 88),
        ("texture::Pigment", size_of::<texture::Pigment>(), 64),
        ("texture::Finish", size_of::<texture::Finish>(), 152),
        ("pattern::Pattern", size_of::<pattern::Pattern>(), 168),
        ("world::SolidNode", size_of::<world::SolidNode>(), 48),
        ("world::Part", size_of::<world::Part>(), 40),
        ("world::ObjectInfo", size_of::<world::ObjectInfo>(), 16),
        ("world::Material", size_of::<world::Material>(), 48),
        ("world::Layer", size_of::<world::Layer>(), 80),
    ];
    for (name, size, bound) in sizes {
        assert!(size <= bound, "a {name} takes {size} bytes, more than {bound}");
    }
}
