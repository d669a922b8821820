//! Every word of a scene reaches the scene and the World: none is read and left out.

use durer::interpreter::{Options, Outcome, interpret};
use durer::source::{Sandbox, SearchPath, Sources};
use durer::value::{Spec, ValueKind, WordSpec};
use durer::{atmosphere, light, medium, scene, texture};
use std::collections::BTreeSet;
use std::path::PathBuf;

fn outcome(text: &str, fonts: Vec<PathBuf>) -> Outcome {
    let options = Options {
        sandbox: Sandbox::with_writes_in_memory(),
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

/// Blocks, each with scenes in which a word of the block and its value replace `@`.
const BLOCKS: &[(&Spec, &[&str])] = &[
    (&scene::words::SETTINGS, &["global_settings { @ }"]),
    (&scene::RADIOSITY, &["global_settings { radiosity { @ } }"]),
    (&scene::SUBSURFACE, &["global_settings { subsurface { @ } }"]),
    (&scene::PHOTON_MAP, &["global_settings { photons { count 7 @ } }"]),
    (&scene::PHOTONS, &["sphere { 0, 1 photons { @ } }"]),
    (&scene::OBJECT_RADIOSITY, &["sphere { 0, 1 radiosity { @ } }"]),
    (&light::LIGHT_PHOTONS, &["light_source { y, 1 area_light x, z, 2, 2 photons { @ } }"]),
    (
        &light::words::LIGHT,
        &["light_source { <2, 3, 4>, 1 area_light x, z, 2, 2 @ }", "light_source { <2, 3, 4>, 1 spotlight @ }"],
    ),
    (&texture::words::FINISH, &["sphere { 0, 1 finish { @ } }"]),
    (&texture::words::REFLECTION, &["sphere { 0, 1 finish { reflection { 0.5 @ } } }"]),
    (&texture::words::IRID, &["sphere { 0, 1 finish { irid { 0.5 @ } } }"]),
    (&texture::words::SUBSURFACE, &["sphere { 0, 1 finish { subsurface { @ } } }"]),
    (&medium::INTERIOR, &["sphere { 0, 1 interior { @ } }"]),
    (&medium::MEDIA, &["media { @ }"]),
    (&medium::SCATTERING, &["media { scattering { 1, 0.5 @ } }"]),
    (&atmosphere::FOG, &["fog { distance 5 color rgb 1 up 2*y @ }"]),
    (
        &atmosphere::RAINBOW,
        &["rainbow { direction z angle 40 width 5 distance 9 falloff_angle 20 color_map { [0 rgb 1] [1 rgb 0] } @ }"],
    ),
];

/// Values that a word may have, by its kind; one of them is not the default.
fn values(word: &WordSpec) -> &'static [&'static str] {
    match (word.name, word.kind) {
        (_, ValueKind::Flag) => &["off", "on"],
        ("photons", _) => &["{ count 7 }", "{ target }", "{ refraction on }"],
        ("radiosity", _) => &["{ count 7 }", "{ importance 0.5 }"],
        ("subsurface", _) => &["{ samples 7, 7 }", "{ translucency 0.3 }"],
        ("reflection", _) => &["{ 0.3 }"],
        ("irid", _) => &["{ 0.3 }"],
        ("media", ValueKind::Float) => &["3"],
        ("media", _) => &["{ absorption 1 }", "3"],
        ("scattering", _) => &["{ 2, 0.3 }"],
        ("density", _) => &["{ bozo }"],
        ("color_map" | "colour_map", _) => &["{ [0 rgb 0.5] [1 rgb 1] }"],
        ("looks_like", _) => &["{ sphere { 0, 1 } }"],
        ("projected_through", _) => &["{ sphere { 0, 1 } }"],
        ("area_light", _) => &["y, z, 3, 3"],
        ("noise_generator" | "type" | "method" | "aa_level", _) => &["1", "2"],
        ("pretrace_end", _) => &["0.01"],
        ("arc_angle", _) => &["150"],
        ("samples", _) => &["7, 7"],
        (_, ValueKind::Nothing) => &[""],
        (_, ValueKind::Float) => &["0.37", "3"],
        (_, ValueKind::Vector2) => &["<0.37, 0.6>", "<3, 7>"],
        (_, ValueKind::Vector) => &["<0.3, 0.5, 0.7>"],
        (_, ValueKind::Vectors) => &["<0.3, 0.5, 0.7>, <1, 2, 3>"],
        (_, ValueKind::Color) => &["rgb <0.3, 0.5, 0.7>"],
        (_, ValueKind::Text) => &["\"a.light\""],
        (_, ValueKind::Block) => &["0.37, 0.4", "3, 5", "<0.37, 0.4>", "0.37"],
    }
}

/// The contents of a scene with one of [`BLOCKS`] in which `words` replaces `@`; `None` for an error.
fn contents(block: &str, words: &str) -> Option<String> {
    let text = format!("#version 3.7; camera {{ location -5*z }} {}", block.replace('@', words));
    outcome(&text, vec![]).scene.map(|scene| without_spans(&format!("{scene:?}")))
}

/// True if the word with one of its values changes the contents of one of the scenes.
fn has_effect(word: &WordSpec, scenes: &[&str]) -> bool {
    scenes.iter().any(|scene| {
        let without = contents(scene, "").expect(scene);
        let with = |value: &&str| contents(scene, &format!("{} {value}", word.name));
        values(word).iter().any(|value| with(value).is_some_and(|with| with != without))
    })
}

#[test]
fn no_word_is_read_and_left_out() {
    let mut faults = vec![];
    for (spec, scenes) in BLOCKS {
        // A file of light that does not exist has no effect; `light_files` tests those that do.
        for word in spec.words.iter().filter(|word| word.name != "load_file" && !has_effect(word, scenes)) {
            faults.push(format!("`{}` in `{}`", word.name, scenes[0]));
        }
    }
    assert!(faults.is_empty(), "these words change nothing:\n{}", faults.join("\n"));
}

/// Removes the positions in the text from the debug output of a scene.
fn without_spans(text: &str) -> String {
    let mut parts = text.split("Span {");
    let first = parts.next().unwrap_or_default().to_string();
    parts.fold(first, |all, part| all + part.split_once('}').map_or("", |(_, rest)| rest))
}

/// Words without effect are those of old versions, and hints for POV-Ray's own methods.
#[test]
fn the_words_without_effect_are_known() {
    let ignored: BTreeSet<&str> =
        durer::reference::documented_blocks().flat_map(|entry| entry.spec.ignored).copied().collect();
    assert_eq!(
        ignored.into_iter().collect::<Vec<_>>(),
        [
            "all_intersections",
            "charset",
            "fade_distance",
            "fade_power",
            "hf_gray_16",
            "hierarchy",
            "max_intersections",
            "no_bump_scale",
            "refraction",
            "split_union",
            "sturm"
        ]
    );
}

#[test]
fn photon_settings_are_in_the_dump() {
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
    holds(&dump, r#""photons":{"refraction":true,"reflection":null,"area_light":true}"#);
    holds(&dump, r#""photons":{"target":0.75,"refraction":null"#);
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
