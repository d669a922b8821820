//! No render is lost: after a kill at any moment, `--resume` continues and gives the same bytes. (`DURER_KILLS=20`
//! tries more moments.)

#[cfg(unix)]
mod exclusive;
mod identity;
#[cfg(unix)]
mod light;
#[cfg(unix)]
mod signals;

use std::path::{Path, PathBuf};
use std::process::{Child, Command, Output, Stdio};
use std::time::{Duration, Instant};

/// A scene that takes half a second for a small picture.
const SCENE: &str = "#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 2, -6> look_at 0 }
light_source { <-5, 8, -6>, 1 area_light x * 3, z * 3, 3, 3 jitter }
plane { y, -1 pigment { checker rgb 1, rgb <0.2, 0.4, 0.6> } finish { reflection 0.2 } }
#for (I, 0, 25) sphere { <sin(I), cos(I * 2), cos(I + clock)>, 0.3 pigment { rgbt <1, 0.8, 0.5, 0.3> } finish { phong 1 } } #end";

struct Scratch(tempfile::TempDir);

impl Scratch {
    fn new() -> Self {
        let scratch = Self(tempfile::tempdir().unwrap());
        std::fs::write(scratch.at("a.scene"), SCENE).unwrap();
        scratch
    }

    fn at(&self, name: &str) -> PathBuf {
        self.0.path().join(name)
    }

    /// A render of the scene, whose journal is written from the beginning on.
    fn durer(&self, words: &str) -> Command {
        self.command(&format!("render a.scene --keep-after 0 {words}"))
    }

    fn command(&self, line: &str) -> Command {
        let mut durer = Command::new(env!("CARGO_BIN_EXE_durer"));
        durer.args(line.split_whitespace()).current_dir(&self.0);
        durer.stdin(Stdio::null()).stdout(Stdio::piped()).stderr(Stdio::piped());
        durer
    }

    /// Starts the command with one thread, and waits until its journal has tiles.
    fn start(&self, words: &str) -> Child {
        let mut durer = self.durer(&format!("{words} --threads 1")).spawn().unwrap();
        while !self.is_unfinished() {
            assert!(durer.try_wait().unwrap().is_none(), "the render ended without a journal");
            std::thread::sleep(Duration::from_millis(1));
        }
        durer
    }

    /// Starts the command, and kills it as soon as its journal has tiles. Returns its messages.
    fn kill(&self, words: &str) -> String {
        let mut durer = self.start(words);
        durer.kill().unwrap();
        err(&durer.wait_with_output().unwrap())
    }

    fn run(&self, words: &str) -> Output {
        self.durer(words).output().unwrap()
    }

    /// The files in the folder, with contents. A process that is killed at the very end of a picture leaves a part of the
    /// picture's file under a name that begins with `.durer-`; this file is not counted.
    fn pictures(&self) -> Vec<(String, Vec<u8>)> {
        let entries = std::fs::read_dir(&self.0).unwrap().map(|entry| entry.unwrap().path());
        let name = |path: &Path| path.file_name().unwrap().to_string_lossy().into_owned();
        let entries = entries.filter(|path| !name(path).starts_with(".durer-"));
        let mut all: Vec<_> = entries.map(|path| (name(&path), std::fs::read(&path).unwrap())).collect();
        all.sort();
        all
    }

    /// True if there is a journal with contents.
    fn is_unfinished(&self) -> bool {
        let mut entries = std::fs::read_dir(&self.0).unwrap().map(|entry| entry.unwrap().path());
        let is_journal = |path: &Path| path.extension().is_some_and(|ending| ending == "unfinished");
        entries.any(|path| is_journal(&path) && path.metadata().is_ok_and(|metadata| metadata.len() > 0))
    }
}

fn err(out: &Output) -> String {
    String::from_utf8_lossy(&out.stderr).into_owned()
}

/// Kills the command at moments spread over its running time, resumes until it is done, and compares all files.
fn kill_and_resume(words: &str, short: usize) {
    let whole = Scratch::new();
    let start = Instant::now();
    let out = whole.run(words);
    assert!(out.status.success(), "{}", err(&out));
    let (time, expected) = (start.elapsed(), whole.pictures());
    let moments = std::env::var("DURER_KILLS").ok().and_then(|n| n.parse().ok()).unwrap_or(short);
    let mut went_on = 0;
    for moment in 0..moments {
        let scratch = Scratch::new();
        for threads in [1, 2, 7].iter().cycle().skip(moment).take(2) {
            let mut durer = scratch.durer(&format!("{words} --resume --threads {threads}")).spawn().unwrap();
            std::thread::sleep(time.mul_f64((moment as f64 + 0.5) / moments as f64 * 0.8));
            // If the machine has become slower since the reference render, the last kill waits until there is a
            // journal.
            while moment + 1 == moments && !scratch.is_unfinished() && durer.try_wait().unwrap().is_none() {
                std::thread::sleep(Duration::from_millis(1));
            }
            durer.kill().unwrap();
            durer.wait().unwrap();
            went_on += usize::from(scratch.is_unfinished());
        }
        let out = scratch.run(&format!("{words} --resume"));
        assert!(out.status.success() && err(&out).is_empty(), "{}", err(&out));
        let names = |files: &[(String, Vec<u8>)]| files.iter().map(|(name, _)| name.clone()).collect::<Vec<_>>();
        let pictures = scratch.pictures();
        assert_eq!(names(&pictures), names(&expected), "{words}, moment {moment}");
        assert!(pictures == expected, "{words}, moment {moment}");
    }
    assert!(went_on > 0 || moments == 0, "it never got so far");
}

#[test]
fn resuming_a_still() {
    kill_and_resume("--size 100x75 --aa 0.1 -o a.png", 4);
}

#[test]
fn resuming_a_region_with_antialiasing_method_2() {
    kill_and_resume("--size 120x90 --aa 0.1 --aa-method corners --region 30,20,75,60 -o a.exr", 2);
}

#[test]
fn resuming_an_animation() {
    kill_and_resume("--size 52x39 --aa 0.1 --frames 1-4 -o a.png", 3);
}

#[test]
fn stale_or_damaged_journals_are_reported_and_ignored() {
    let scratch = Scratch::new();
    let words = "--size 200x150 --aa 0.1 -o a.png";
    let stopped = scratch.run(&format!("{words} --max-time 0.3"));
    assert!(err(&stopped).contains("`a.png.unfinished`; `--resume` continues it"), "{}", err(&stopped));
    let journal = std::fs::read(scratch.at("a.png.unfinished")).unwrap();
    let other = scratch.run("--size 20x15 --aa 0.1 -o a.png --resume");
    assert!(other.status.success() && err(&other).contains("rendered with other options"), "{}", err(&other));
    std::fs::write(scratch.at("a.png.unfinished"), &journal).unwrap();
    std::fs::write(scratch.at("a.scene"), SCENE.replace("<-5, 8, -6>", "<5, 8, -6>")).unwrap();
    let changed = scratch.run(&format!("{words} --resume --max-time 1"));
    assert!(err(&changed).contains("a.scene` has changed"), "{}", err(&changed));
    std::fs::write(scratch.at("a.scene"), SCENE).unwrap();
    let mut damaged = journal.clone();
    damaged[journal.len() / 2] ^= 1;
    std::fs::write(scratch.at("a.png.unfinished"), &damaged).unwrap();
    let told = scratch.run(&format!("{words} --resume --max-time 1"));
    assert!(err(&told).contains("it is damaged"), "{}", err(&told));
    std::fs::write(scratch.at("a.png.unfinished"), &journal).unwrap();
    let anew = scratch.run(&format!("{words} --max-time 0.2"));
    assert!(err(&anew).contains("continue it with `--resume`"), "{}", err(&anew));
}

#[cfg(target_os = "linux")]
#[test]
fn journals_are_kept_when_the_folder_is_missing() {
    let scratch = Scratch::new();
    std::fs::create_dir(scratch.at("out")).unwrap();
    let mut durer = scratch.durer("--size 300x225 --aa 0.1 --threads 1 -o out/a.png").spawn().unwrap();
    std::thread::sleep(Duration::from_millis(300));
    std::fs::rename(scratch.at("out"), scratch.at("away")).unwrap();
    let out = {
        durer.wait().unwrap();
        durer.wait_with_output().unwrap()
    };
    assert_eq!(out.status.code(), Some(5), "{}", err(&out));
    assert!(
        err(&out).contains("out/a.png` can't be written") && err(&out).contains("the unfinished picture is stored")
    );
    std::fs::rename(scratch.at("away"), scratch.at("out")).unwrap();
    let again = scratch.run("--size 300x225 --aa 0.1 -o out/a.png --resume --stats json");
    assert!(again.status.success(), "{}", err(&again));
    let stats: serde_json::Value = serde_json::from_slice(&again.stdout).unwrap();
    assert_eq!(stats["rays"]["camera"], 0);
}

/// A full disk: no file may grow beyond half of the picture, and the signal for that is ignored, so that writing
/// returns an error.
#[cfg(target_os = "linux")]
#[test]
fn journals_are_kept_when_the_disk_is_full() {
    let (scratch, whole) = (Scratch::new(), Scratch::new());
    // 44 KB as a bmp; the journal ends in the middle of a tile.
    let words = "--size 140x105 --aa off -o a.bmp";
    let mut small = Command::new("sh");
    // (Blocks of 512 bytes)
    small.args([
        "-c",
        "trap '' XFSZ; ulimit -f 64; exec \"$0\" render a.scene --keep-after 0 \"$@\"",
        env!("CARGO_BIN_EXE_durer"),
    ]);
    let out = small.args(words.split_whitespace()).current_dir(&scratch.0).stdin(Stdio::null()).output().unwrap();
    let told = err(&out);
    assert_eq!(out.status.code(), Some(5), "{told}");
    assert!(told.contains("`a.bmp` can't be written: file too large"), "{told}");
    assert!(
        told.contains("a part of the unfinished picture is stored in `a.bmp.unfinished` (writing stopped: "),
        "{told}"
    );
    assert!(!told.contains("cannot write the resume journal"), "{told}");
    assert!(!scratch.at("a.bmp").exists() && scratch.at("a.bmp.unfinished").exists());
    let again = scratch.run(&format!("{words} --resume --stats json"));
    assert!(again.status.success(), "{}", err(&again));
    let stats: serde_json::Value = serde_json::from_slice(&again.stdout).unwrap();
    let rays = stats["rays"]["camera"].as_u64().unwrap();
    assert!(rays > 0 && rays < 140 * 105, "{rays} rays");
    assert!(whole.run(words).status.success());
    assert!(scratch.pictures() == whole.pictures());
}

/// A process that is killed just after it has listed a finished frame leaves the frame's journal.
#[test]
fn journals_of_finished_frames_are_deleted() {
    let scratch = Scratch::new();
    std::fs::write(scratch.at("a.scene"), "#if (frame_number = 2) #include \"b.inc\" #end sphere { z * 3, 1 }")
        .unwrap();
    let words = "--size 8x6 --frames 1-2 -o a.png --resume";
    assert_eq!(scratch.run(words).status.code(), Some(1));
    std::fs::write(scratch.at("b.inc"), "").unwrap();
    std::fs::write(scratch.at("a1.png.unfinished"), "{}\n").unwrap();
    let out = scratch.run(words);
    assert!(out.status.success() && !err(&out).contains("again"), "{}", err(&out));
    assert!(!scratch.is_unfinished());
}
