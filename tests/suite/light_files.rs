//! Files of photons and radiosity samples: a render that loads them has the bytes of the one that saved them; files that
//! do not fit are reported, and change nothing.

use super::scratch::Scratch;

/// A scene with photons and radiosity; CAMERA and FILES are replaced.
const SCENE: &str = "#version 3.7;
global_settings { assumed_gamma 1 radiosity { count 20 error_bound 1 RADIOSITY } photons { spacing 0.1 PHOTONS } }
camera { location <CAMERA, 3, -6> right x * image_width / image_height look_at <0, 0.7, 0> }
light_source { <-4, 6, 1> rgb 1 }
plane { y, 0 pigment { checker rgb 0.9, rgb <0.3, 0.5, 0.7> } }
sphere { <0, 0.8, 0>, 0.7 pigment { rgbf 1 } interior { ior 1.5 } photons { target refraction on } }
box { <1.2, 0, -1>, <1.4, 2, 2> pigment { bozo } }";
const SIZE: &str = "--size 40x30 --aa off";

fn put(scratch: &Scratch, name: &str, radiosity: &str, photons: &str) {
    let scene = SCENE.replace("CAMERA", "0").replace("RADIOSITY", radiosity).replace("PHOTONS", photons);
    scratch.put(name, scene);
}

/// Renders a scene to PNG, and returns the picture and the messages.
fn render(scratch: &Scratch, scene: &str, words: &str) -> (Vec<u8>, String) {
    let (_, messages) = scratch.exits(0, &format!("render {scene} {SIZE} -o out.png {words}"));
    (scratch.read("out.png"), messages)
}

#[test]
fn loaded_light_gives_the_bytes_of_the_run_that_saved_it() {
    let scratch = Scratch::new();
    put(&scratch, "plain.scene", "", "");
    put(&scratch, "save.scene", "save_file \"a.radiosity\"", "save_file \"a.photons\"");
    put(&scratch, "load.scene", "load_file \"a.radiosity\"", "load_file \"a.photons\"");
    let (plain, _) = render(&scratch, "plain.scene", "");
    let (saving, messages) = render(&scratch, "save.scene", "-j 2");
    assert!(saving == plain && !messages.contains("warning"), "{messages}");
    let saved = [scratch.read("a.radiosity"), scratch.read("a.photons")];
    for threads in [1, 2, 7] {
        let (loading, messages) = render(&scratch, "load.scene", &format!("-j {threads}"));
        assert!(loading == plain && !messages.contains("warning"), "{messages}");
        // A scene replaces the files that it created.
        render(&scratch, "save.scene", &format!("-j {threads}"));
        assert!(saved == [scratch.read("a.radiosity"), scratch.read("a.photons")]);
    }
}

#[test]
fn options_load_and_save_radiosity() {
    let scratch = Scratch::new();
    put(&scratch, "a.scene", "", "");
    let (saving, _) = render(&scratch, "a.scene", "--save-radiosity mine.rad");
    let (loading, messages) = render(&scratch, "a.scene", "--load-radiosity mine.rad --stats stats.json");
    assert!(loading == saving && !messages.contains("warning"), "{messages}");
    // No preparation pass of radiosity has run.
    let stats = String::from_utf8(scratch.read("stats.json")).unwrap();
    assert!(stats.contains("\"photons\"") && !stats.contains("\"radiosity\""), "{stats}");
    // The options of POV-Ray, with its default name
    scratch.exits(0, "+Ia.scene +W40 +H30 -A +Oout.png +RFO");
    assert!(scratch.read("object.rca") == scratch.read("mine.rad"));
    scratch.exits(0, "+Ia.scene +W40 +H30 -A +Oout.png +RFmine.rad +RFI");
    assert!(scratch.read("out.png") == saving);
    scratch.put(
        "a.ini",
        "Input_File_Name=a.scene\nWidth=40\nHeight=30\nRadiosity_To_File=on\nRadiosity_File_Name=ini.rad",
    );
    scratch.exits(0, "render a.ini --aa off -o out.png");
    assert!(scratch.read("ini.rad") == scratch.read("mine.rad"));
}

#[test]
fn another_camera_uses_the_same_light() {
    let scratch = Scratch::new();
    put(&scratch, "save.scene", "save_file \"a.radiosity\"", "save_file \"a.photons\"");
    render(&scratch, "save.scene", "");
    let loading = SCENE.replace("RADIOSITY", "load_file \"a.radiosity\"").replace("PHOTONS", "load_file \"a.photons\"");
    scratch.put("moved.scene", loading.replace("CAMERA", "1.5"));
    let (_, messages) = render(&scratch, "moved.scene", "");
    assert!(!messages.contains("warning"), "{messages}");
    // Another object is reported once for each file.
    scratch.put("other.scene", loading.replace("CAMERA", "0").replace("<1.4, 2, 2>", "<1.4, 3, 2>"));
    let (_, messages) = render(&scratch, "other.scene", "");
    assert_eq!(messages.matches("W0417").count(), 2, "{messages}");
}

#[test]
fn files_that_do_not_fit_are_reported_and_change_nothing() {
    let scratch = Scratch::new();
    put(&scratch, "save.scene", "save_file \"whole.radiosity\"", "save_file \"whole.photons\"");
    put(&scratch, "load.scene", "load_file \"a\"", "load_file \"b\"");
    let (plain, _) = render(&scratch, "save.scene", "");
    let check = |radiosity: &[u8], photons: &[u8], reason: &str| {
        scratch.put("a", radiosity);
        scratch.put("b", photons);
        let (picture, messages) = render(&scratch, "load.scene", "");
        assert!(picture == plain, "{reason}");
        assert_eq!(messages.matches("W0416").count(), 2, "{messages}");
        assert!(messages.contains(reason), "{messages}");
    };
    let [radiosity, photons] = ["whole.radiosity", "whole.photons"].map(|name| scratch.read(name));
    check(&photons, &radiosity, "contains photons, not samples of radiosity");
    check(b"C1\t1.5\t-1\t0", &[0; 8], "was saved by POV-Ray");
    check(b"#include \"a\"", b"", "does not contain photons");
    let cut = |bytes: &[u8]| bytes[..bytes.len() - 7].to_vec();
    check(&cut(&radiosity), &cut(&photons), "is damaged or cut off");
    let later = |bytes: &[u8]| [&bytes[..7], &[99], &bytes[8..]].concat();
    check(&later(&radiosity), &later(&photons), "was saved by another version of durer");
    std::fs::remove_file(scratch.path().join("b")).unwrap();
    assert!(render(&scratch, "load.scene", "").1.contains("`b` was not found"));
}

#[test]
fn only_renders_save_light_and_only_over_their_own_files() {
    let scratch = Scratch::new();
    put(&scratch, "save.scene", "save_file \"a.radiosity\"", "save_file \"notes.txt\"");
    for command in ["check", "query", "render --dump world"] {
        scratch.exits(0, &format!("{command} save.scene"));
        assert!(!scratch.path().join("a.radiosity").exists(), "{command}");
    }
    scratch.put("notes.txt", "mine");
    let (_, messages) = render(&scratch, "save.scene", "--save-radiosity notes.txt");
    assert_eq!(messages.matches("W0418").count(), 2, "{messages}");
    assert!(["durer did not save it", "not create it"].iter().all(|reason| messages.contains(reason)), "{messages}");
    assert_eq!(scratch.read("notes.txt"), b"mine");
    let (_, messages) = render(&scratch, "save.scene", "--untrusted");
    assert_eq!(messages.matches("W0418").count(), 2, "{messages}");
}

#[test]
fn prepared_light_gives_the_bytes_of_one_run() {
    let scratch = Scratch::new();
    put(&scratch, "a.scene", "", "save_file \"unwritten.photons\"");
    let (plain, _) = render(&scratch, "a.scene", "");
    std::fs::remove_file(scratch.path().join("unwritten.photons")).unwrap();
    let (_, messages) = scratch.exits(0, &format!("prepare a.scene {SIZE} -j 2"));
    assert!(messages.contains("a.prepared: ") && messages.contains(" photons and "), "{messages}");
    assert!(!scratch.path().join("unwritten.photons").exists(), "only `durer render` writes the files of a scene");
    let (prepared, messages) = render(&scratch, "a.scene", "--prepared a.prepared --stats stats.json");
    assert!(prepared == plain && !messages.contains("warning"), "{messages}");
    let stats = String::from_utf8(scratch.read("stats.json")).unwrap();
    assert!(!stats.contains("\"photons\"") && !stats.contains("\"radiosity\""), "no pass has run: {stats}");
    // Shards and a region use the preparation of the whole picture.
    for index in 1..=3 {
        scratch.exits(0, &format!("render a.scene {SIZE} -o b.png --prepared a.prepared --shard {index}/3"));
    }
    scratch.exits(0, "merge b.png");
    assert!(scratch.read("b.png") == plain);
    render(&scratch, "a.scene", "--prepared a.prepared --region 5,5,10,10");
}

#[test]
fn prepared_light_of_another_picture_is_an_error() {
    let scratch = Scratch::new();
    put(&scratch, "a.scene", "", "");
    scratch.put("plain.scene", "sphere { 0, 1 }");
    scratch.exits(0, &format!("prepare a.scene {SIZE} -o a.light"));
    let refuses = |words: &str, exit, reason: &str| {
        let (_, messages) = scratch.exits(exit, &format!("render {words} --prepared a.light -o no.png"));
        assert!(messages.contains(reason), "{messages}");
        assert!(!scratch.path().join("no.png").exists());
    };
    refuses(&format!("plain.scene {SIZE}"), 2, "`a.light` was prepared for another picture");
    refuses("a.scene --size 40x31 --aa off", 2, "E0020");
    refuses(&format!("a.scene {SIZE} --frame 2"), 2, "E0020");
    refuses(&format!("a.scene {SIZE} --quality 7"), 2, "E0020");
    put(&scratch, "a.scene", "", "jitter 0.2");
    refuses(&format!("a.scene {SIZE}"), 2, "E0020");
    let whole = scratch.read("a.light");
    scratch.put("a.light", &whole[..whole.len() - 1]);
    refuses(&format!("a.scene {SIZE}"), 5, "`a.light` is damaged or cut off");
    scratch.put("a.light", "sphere { 0, 1 }");
    refuses(&format!("a.scene {SIZE}"), 5, "was not written by `durer prepare`");
    // A file that is no light is not replaced.
    let (_, messages) = scratch.exits(5, &format!("prepare a.scene {SIZE} -o a.light"));
    assert!(messages.contains("durer did not save it as light"), "{messages}");
    assert!(scratch.read("a.light") == b"sphere { 0, 1 }");
    // A scene without photons and radiosity has an empty preparation, which serves it.
    scratch.exits(0, "prepare plain.scene --size 20x20 -o plain.light");
    scratch.exits(0, "render plain.scene --size 20x20 --prepared plain.light -o plain.png");
    // An animation has a preparation for each frame.
    scratch.put("film.ini", "Input_File_Name=a.scene\nInitial_Frame=1\nFinal_Frame=3\nWidth=40\nHeight=30");
    scratch.exits(2, "prepare film.ini");
    scratch.exits(0, "prepare film.ini --frame 2");
    scratch.exits(0, "render film.ini --frame 2 --prepared a.prepared -o two.png");
}
