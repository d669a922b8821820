//! Blocks that durer does not render yet are kept in the scene, and the dump shows them.

use durer::interpreter::{Options, Outcome, interpret};
use durer::source::{Sandbox, SearchPath, Sources};
use std::path::PathBuf;

fn outcome(text: &str, fonts: Vec<PathBuf>) -> Outcome {
    let options = Options {
        sandbox: Sandbox::read_only(),
        search: SearchPath { folders: vec![], fonts },
        size: (4, 3),
        ..Options::default()
    };
    durer::on_big_stack(|| {
        let sources = Sources::default();
        let file = sources.add("scene", None, text.to_string()).unwrap();
        interpret(&sources, file, &options, &mut |_| {})
    })
}

fn dump(text: &str) -> String {
    serde_json::to_string(&outcome(text, vec![]).scene.expect("a scene")).unwrap()
}

#[track_caller]
fn holds(dump: &str, part: &str) {
    assert!(dump.contains(part), "{part} is not in\n{dump}");
}

#[test]
fn the_dump_shows_unsupported_blocks() {
    let dump = dump(
        r#"
        #version 3.7;
        global_settings { assumed_gamma 1 max_intersections 7 }
        camera { location <0, 0, -5> look_at 0 }
        light_source { 5*y, rgb 1 photons { refraction on area_light } }
        sphere {
          0, 1 hollow photons { target 0.75 }
        }
        "#,
    );
    holds(&dump, r#"{"max_intersections":[7.0]}"#);
    holds(&dump, r#""photons":{"refraction":true,"reflection":null,"area_light":true}"#);
    holds(&dump, r#""photons":{"target":0.75,"refraction":null"#);
}

#[test]
fn the_dump_of_a_supported_scene_has_no_unsupported_blocks() {
    let dump = dump("#version 3.7; camera { location -5*z } light_source { y, 1 } sphere { 0, 1 finish { phong 1 } }");
    assert!(!dump.contains("unsupported") && !dump.contains("said"), "{dump}");
}

#[test]
fn a_missing_font_is_replaced_by_an_installed_one() {
    let folder = tempfile::tempdir().unwrap();
    for name in ["DejaVuSans.ttf", "DejaVuSerif-Bold.ttf"] {
        std::fs::write(folder.path().join(name), include_bytes!("../../src/font/Roboto-Regular.ttf")).unwrap();
    }
    let text =
        "#version 3.7; camera { location -5*z } text { ttf \"timesbd\" \"Dürer\" 0.25, <0, 0, 0> pigment { rgb 1 } }";
    let reported = |outcome: &Outcome| {
        let reported = outcome.diagnostics.iter().find(|d| d.code == durer::diagnostic::codes::FONT_MISSING);
        reported.unwrap().message.clone()
    };
    let with = outcome(text, vec![folder.path().into()]);
    assert_eq!(reported(&with), "the font `timesbd` was not found: `DejaVuSerif-Bold.ttf` is used instead");
    let json = serde_json::to_string(&with.scene.unwrap()).unwrap();
    let file = folder.path().join("DejaVuSerif-Bold.ttf");
    let file = serde_json::to_string(&file).unwrap();
    holds(&json, &format!(r#""font":"timesbd","file":{file},"string":"Dürer","depth":0.25"#));
    let without = outcome(text, vec![]);
    assert_eq!(reported(&without), "the font `timesbd` was not found: durer's own font, Roboto, is used instead");
}

#[test]
fn photon_settings_of_groups_and_parts_reach_the_world() {
    let scene = outcome(
        "#version 3.7;
        union {
          sphere { 0, 1 }
          sphere { x, 1 photons { target reflection on } }
          photons { target 0.5 collect off refraction off }
        }
        sphere { y, 1 photons { pass_through target 0.25 } }
        sphere { z, 1 }",
        vec![],
    )
    .scene
    .expect("a scene");
    let world = durer::world::lower(&scene).unwrap();
    let settings = |object: usize| world.photons[world.objects[object].photons as usize];
    let group = settings(0);
    assert_eq!((group.target, group.refraction, group.ignores_photons), (Some(0.5), Some(false), true));
    let part = settings(1);
    assert_eq!((part.target, part.refraction, part.reflection), (Some(1.0), Some(false), Some(true)));
    assert_eq!((settings(2).target, settings(2).pass_through), (Some(0.25), Some(true)));
    assert_eq!(settings(3), Default::default());
    // Lights, which are objects of no shape, aside: one entry for each distinct block, and one for the defaults.
    assert_eq!(world.photons.len(), 4);
}
