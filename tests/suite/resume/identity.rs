//! A journal is continued only by the same program for the same work.

use super::{SCENE, Scratch, err};
use std::process::Command;

const WORDS: &str = "--size 100x75 --aa 0.1 -o a.png";

/// The picture of an interrupted and resumed render, with its messages, and that of an uninterrupted one. The scene
/// begins with `start`; `change` is made after the interruption.
fn resumed(start: &str, words: &str, change: impl Fn(&Scratch)) -> (Vec<u8>, String, Vec<u8>) {
    let (scratch, whole) = (Scratch::new(), Scratch::new());
    for scratch in [&scratch, &whole] {
        std::fs::write(scratch.at("a.scene"), SCENE.replace("camera", &format!("{start}\ncamera"))).unwrap();
        std::fs::create_dir(scratch.at("later")).unwrap();
        std::fs::write(scratch.at("later/b.inc"), "#declare Height = 1;").unwrap();
    }
    scratch.kill(words);
    [&scratch, &whole].into_iter().for_each(change);
    let out = scratch.run(&format!("{words} --resume"));
    assert!(out.status.success(), "{}", err(&out));
    assert!(whole.run(words).status.success());
    let read = |scratch: &Scratch| std::fs::read(scratch.at("a.png")).unwrap();
    (read(&scratch), err(&out), read(&whole))
}

#[test]
fn a_file_that_appears_changes_the_scene() {
    let start = "background { rgb file_exists(\"a.flag\") }";
    let flag = |scratch: &Scratch| std::fs::write(scratch.at("a.flag"), "").unwrap();
    let (picture, messages, expected) = resumed(start, WORDS, flag);
    assert!(messages.contains("the scene has changed: `./a.flag` exists now"), "{messages}");
    assert!(picture == expected);
    let (picture, messages, expected) = resumed(start, WORDS, |_| ());
    assert!(messages.is_empty() && picture == expected, "{messages}");
}

#[test]
fn a_file_found_earlier_on_the_include_path_changes_the_scene() {
    let start = "#include \"b.inc\"\nsphere { <-2, Height, 0>, 1 }";
    let words = format!("{WORDS} -I later");
    let shadow = |scratch: &Scratch| std::fs::write(scratch.at("b.inc"), "#declare Height = 2;").unwrap();
    let (picture, messages, expected) = resumed(start, &words, shadow);
    assert!(messages.contains("the scene has changed: `./b.inc` exists now"), "{messages}");
    assert!(picture == expected);
}

/// The colour of the scene's background changes every millisecond.
#[test]
fn a_resumed_scene_has_the_now_of_its_first_run() {
    let scratch = Scratch::new();
    let background =
        "background { rgb <mod(now * 864e5, 256), mod(now * 864e5 / 256, 256), mod(now * 864e5 / 65536, 256)> / 255 }";
    // The background is in the four corners.
    let scene = SCENE.replace("plane { y, -1 ", &format!("{background}\ndisc {{ -y, y, 1.5 "));
    std::fs::write(scratch.at("a.scene"), scene).unwrap();
    let words = "--size 100x75 --aa 0.1 -o a.ppm --file-gamma 1";
    scratch.kill(words);
    let out = scratch.run(&format!("{words} --resume"));
    assert!(out.status.success() && err(&out).is_empty(), "{}", err(&out));
    let pixels = std::fs::read(scratch.at("a.ppm")).unwrap();
    let pixels = &pixels[pixels.len() - 100 * 75 * 3..];
    let corners = [0, 99, 74 * 100, 74 * 100 + 99].map(|at| &pixels[at * 3..at * 3 + 3]);
    assert!(corners.iter().all(|corner| *corner == corners[0]), "{corners:?}");
    // Another render has another `now`.
    assert!(scratch.run(words).status.success());
    let again = std::fs::read(scratch.at("a.ppm")).unwrap();
    assert!(again[again.len() - 100 * 75 * 3..][..3] != *corners[0]);
}

#[test]
fn a_now_of_other_work_is_not_used() {
    let scratch = Scratch::new();
    let scene = format!("{SCENE}\n#debug concat(str(now, 0, 9), \" is now\\n\")\n");
    let now = |messages: &str| {
        let line = messages.lines().find_map(|line| line.strip_suffix(" is now"));
        line.and_then(|number| number.parse::<f64>().ok()).unwrap_or_else(|| panic!("{messages}"))
    };
    std::fs::write(scratch.at("a.scene"), &scene).unwrap();
    let first = now(&scratch.kill(WORDS));
    assert_eq!(now(&err(&scratch.run(&format!("{WORDS} --resume")))), first);
    let again = now(&scratch.kill(WORDS));
    std::fs::write(scratch.at("a.scene"), scene + " ").unwrap();
    let changed = err(&scratch.run(&format!("{WORDS} --resume")));
    assert!(changed.contains("a.scene` has changed") && now(&changed) > again && again > first, "{changed}");
}

#[test]
fn frames_of_another_encoding_are_rendered_again() {
    let scratch = Scratch::new();
    // The second frame needs a file that does not exist yet.
    std::fs::write(scratch.at("a.scene"), "#if (frame_number = 2) #include \"b.inc\" #end sphere { z * 3, 1 }")
        .unwrap();
    let words = "--size 8x6 --frames 1-2 -o a.png";
    assert_eq!(scratch.run(words).status.code(), Some(1));
    std::fs::write(scratch.at("b.inc"), "").unwrap();
    let out = scratch.run(&format!("{words} --bit-depth 16 --resume"));
    assert!(out.status.success() && err(&out).contains("`a1.png` is rendered again"), "{}", err(&out));
    assert_eq!([1, 2].map(|frame| std::fs::read(scratch.at(&format!("a{frame}.png"))).unwrap()[24]), [16, 16]);
}

/// A copy of the program continues its journals; a program with one byte more does not.
#[cfg(target_os = "linux")]
#[test]
fn programs_are_identified_by_their_contents() {
    let scratch = Scratch::new();
    scratch.kill(WORDS);
    let journal = std::fs::read(scratch.at("a.png.unfinished")).unwrap();
    let program = scratch.at("durer");
    std::fs::copy(env!("CARGO_BIN_EXE_durer"), &program).unwrap();
    let words = format!("render a.scene --keep-after 0 {WORDS} --resume");
    let run = || Command::new(&program).args(words.split_whitespace()).current_dir(&scratch.0).output().unwrap();
    let same = run();
    assert!(same.status.success() && err(&same).is_empty(), "{}", err(&same));
    std::fs::write(scratch.at("a.png.unfinished"), journal).unwrap();
    let mut bytes = std::fs::read(&program).unwrap();
    bytes.push(0);
    std::fs::write(&program, bytes).unwrap();
    let other = run();
    assert!(other.status.success() && err(&other).contains("another version of durer"), "{}", err(&other));
}
