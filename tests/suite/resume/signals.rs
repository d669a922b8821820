//! Signals end a render in good order: what is done is stored, and the exit code names the signal.

use super::{Scratch, err};
use std::process::{Child, Command, Stdio};
use std::time::{Duration, Instant};

const WORDS: &str = "--size 200x150 --aa 0.1 -o a.png";

pub fn send(durer: &Child, signal: &str) {
    let line = format!("kill -{signal} {}", durer.id());
    assert!(Command::new("sh").args(["-c", &line]).status().unwrap().success());
}

#[test]
fn signals_store_what_is_done() {
    let cases = [("INT", 130, "interrupted"), ("TERM", 143, "terminated"), ("HUP", 129, "the terminal was closed")];
    for (signal, exit, reason) in cases {
        let scratch = Scratch::new();
        let durer = scratch.start(WORDS);
        let start = Instant::now();
        send(&durer, signal);
        let out = durer.wait_with_output().unwrap();
        assert!(start.elapsed() < Duration::from_secs(2), "{signal}: {:?}", start.elapsed());
        assert_eq!(out.status.code(), Some(exit), "{signal}: {}", err(&out));
        let expected = format!(
            "{reason}; no picture was written\n\
             the unfinished picture is stored in `a.png.unfinished`; `--resume` continues it\n"
        );
        assert_eq!(err(&out), expected);
        assert!(scratch.is_unfinished() && !scratch.at("a.png").exists());
        let again = scratch.run("--size 200x150 --aa 0.1 -o a.png --resume --max-time 0.1");
        assert!(!err(&again).contains("anew"), "{}", err(&again));
    }
}

#[test]
fn signals_while_the_scene_is_read_leave_no_file() {
    let scratch = Scratch::new();
    std::fs::write(scratch.at("a.scene"), "#debug \"begun\\n\" #while (1) #end").unwrap();
    let mut durer = scratch.durer(WORDS).spawn().unwrap();
    let mut begun = [0; 5];
    std::io::Read::read_exact(durer.stderr.as_mut().unwrap(), &mut begun).unwrap();
    assert!(scratch.at("a.png.unfinished").exists());
    send(&durer, "TERM");
    assert_eq!(durer.wait().unwrap().code(), Some(143));
    assert_eq!(scratch.pictures().len(), 1);
}

/// `nohup durer …`
#[cfg(target_os = "linux")]
#[test]
fn an_ignored_hang_up_is_left_alone() {
    let scratch = Scratch::new();
    let line =
        format!("trap '' HUP; exec \"$0\" render a.scene --keep-after 0 --threads 1 {}", "--size 60x45 -o a.png");
    let mut shell = Command::new("sh");
    shell.args(["-c", &line, env!("CARGO_BIN_EXE_durer")]).current_dir(&scratch.0).stderr(Stdio::piped());
    let durer = shell.spawn().unwrap();
    while !scratch.is_unfinished() {
        std::thread::sleep(Duration::from_millis(1));
    }
    send(&durer, "HUP");
    let out = durer.wait_with_output().unwrap();
    assert!(out.status.success() && scratch.at("a.png").exists(), "{}", err(&out));
}

/// No file may grow beyond half of the picture.
#[cfg(target_os = "linux")]
#[test]
fn the_limit_of_a_file_size_ends_the_render_in_good_order() {
    let (scratch, whole) = (Scratch::new(), Scratch::new());
    let words = "--size 140x105 --aa off -o a.bmp";
    let line = format!("ulimit -f 64; exec \"$0\" render a.scene --keep-after 0 {words}");
    let mut shell = Command::new("sh");
    let out = shell.args(["-c", &line, env!("CARGO_BIN_EXE_durer")]).current_dir(&scratch.0).output().unwrap();
    assert_eq!(out.status.code(), Some(153), "{:?} {}", out.status, err(&out));
    let expected = "a part of the unfinished picture is stored in `a.bmp.unfinished` (writing stopped: ";
    assert!(err(&out).contains(expected) && err(&out).contains("`--resume` continues it"), "{}", err(&out));
    assert!(!scratch.at("a.bmp").exists());
    let again = scratch.run(&format!("{words} --resume"));
    assert!(again.status.success() && err(&again).is_empty(), "{}", err(&again));
    assert!(whole.run(words).status.success());
    assert!(scratch.pictures() == whole.pictures());
}

#[test]
fn frames_that_a_signal_interrupts_are_continued() {
    let scratch = Scratch::new();
    let words = "--size 60x45 --aa 0.1 --frames 1-2 -o a.png";
    let durer = scratch.start(words);
    send(&durer, "TERM");
    assert_eq!(durer.wait_with_output().unwrap().status.code(), Some(143));
    let out = scratch.run(&format!("{words} --resume"));
    assert!(out.status.success() && err(&out).is_empty(), "{}", err(&out));
}
