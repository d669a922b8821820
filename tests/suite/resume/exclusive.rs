//! One process at a time renders a picture, and journals are plain files.

use super::{SCENE, Scratch, err};
use std::process::Command;
use std::time::{Duration, Instant};

/// Number of times that two renders are started at once.
const ATTEMPTS: usize = 20;

#[test]
fn of_two_renders_that_start_at_once_each_is_whole_or_refused() {
    let scratch = Scratch::new();
    std::fs::write(scratch.at("b.scene"), SCENE.replace("<0.2, 0.4, 0.6>", "<0.6, 0, 0>")).unwrap();
    let words = "--size 60x45 --aa off --threads 1 -o out.png";
    let other = format!("render b.scene {words}");
    let start = |resume| {
        let mut other_durer = Command::new(env!("CARGO_BIN_EXE_durer"));
        other_durer.args(other.split_whitespace()).current_dir(&scratch.0).stderr(std::process::Stdio::piped());
        [scratch.durer(&format!("{words}{resume}")).spawn().unwrap(), other_durer.spawn().unwrap()]
    };
    let picture = || std::fs::read(scratch.at("out.png")).unwrap();
    let whole = ["a.scene", "b.scene"].map(|scene| {
        let mut alone = Command::new(env!("CARGO_BIN_EXE_durer"));
        alone.args(["render", scene]).args(words.split_whitespace()).current_dir(&scratch.0);
        assert!(alone.status().unwrap().success());
        picture()
    });
    assert!(whole[0] != whole[1]);
    let mut refused = 0;
    for attempt in 0..ATTEMPTS {
        std::fs::remove_file(scratch.at("out.png")).unwrap();
        let ended = start(["", " --resume"][attempt % 2]).map(|durer| durer.wait_with_output().unwrap());
        let is_refused = ended.each_ref().map(|out| {
            let is_refused = out.status.code() == Some(5);
            assert!(out.status.success() || is_refused && err(out).contains("E0004"), "{}", err(out));
            assert!(!is_refused || err(out).contains("another process is rendering it"), "{}", err(out));
            is_refused
        });
        refused += is_refused.iter().filter(|refused| **refused).count();
        match is_refused {
            [false, true] => assert!(picture() == whole[0]),
            [true, false] => assert!(picture() == whole[1]),
            [false, false] => assert!(whole.contains(&picture())),
            [true, true] => panic!("both were refused"),
        }
        assert!(!scratch.at("out.png.unfinished").exists());
    }
    assert!(refused > 0, "no two renders ran at the same time");
}

#[test]
fn a_picture_in_use_is_refused_until_its_render_is_killed() {
    let scratch = Scratch::new();
    let words = "--size 100x75 --aa 0.1 -o a.png";
    std::os::unix::fs::symlink("a.png", scratch.at("link.png")).unwrap();
    // The link's picture has to exist: a link without a target is no output.
    assert!(scratch.run("--size 8x6 -o a.png").status.success());
    let mut first = scratch.start(words);
    for second in [words, "--size 100x75 --aa 0.1 -o a.png --resume", "--size 8x6 -o link.png"] {
        let out = scratch.run(second);
        assert_eq!(out.status.code(), Some(5), "{}", err(&out));
        assert!(err(&out).contains("another process is rendering it"), "{}", err(&out));
    }
    first.kill().unwrap();
    first.wait().unwrap();
    let out = scratch.run(&format!("{words} --resume"));
    assert!(out.status.success() && err(&out).is_empty(), "{}", err(&out));
}

#[test]
fn journals_that_are_no_plain_files_are_refused() {
    let scratch = Scratch::new();
    let journal = scratch.at("a.png.unfinished");
    let check = |journal: &str, words: &str| {
        for resume in ["", " --resume"] {
            let start = Instant::now();
            let out = scratch.run(&format!("--size 8x6 -o a.png {words}{resume}"));
            assert_eq!(out.status.code(), Some(5), "{}", err(&out));
            let expected = format!("`{journal}` can't be written: it is not a regular file with one name");
            assert!(err(&out).contains("E0004") && err(&out).contains(&expected), "{}", err(&out));
            assert!(start.elapsed() < Duration::from_secs(10) && !scratch.at("a.png").exists());
        }
    };
    let make_pipe = |name: &str| assert!(Command::new("mkfifo").arg(scratch.at(name)).status().unwrap().success());
    make_pipe("a.png.unfinished");
    check("a.png.unfinished", "");
    std::fs::remove_file(&journal).unwrap();
    std::fs::write(scratch.at("precious"), "text").unwrap();
    std::os::unix::fs::symlink("precious", &journal).unwrap();
    check("a.png.unfinished", "");
    std::fs::remove_file(&journal).unwrap();
    std::fs::hard_link(scratch.at("precious"), &journal).unwrap();
    check("a.png.unfinished", "");
    std::fs::remove_file(&journal).unwrap();
    std::os::unix::fs::symlink("created", &journal).unwrap();
    check("a.png.unfinished", "");
    std::fs::remove_file(&journal).unwrap();
    std::fs::create_dir(&journal).unwrap();
    check("a.png.unfinished", "");
    make_pipe("a.png.frames");
    check("a.png.frames", "--frames 1-2");
    assert_eq!(std::fs::read(scratch.at("precious")).unwrap(), b"text");
    assert!(!scratch.at("created").exists());
}
