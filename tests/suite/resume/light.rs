//! Photons and radiosity samples survive an interruption, and an interruption while they are computed does no harm.

use super::signals::send;
use super::{Scratch, err};
use std::io::{BufRead, BufReader, Read};
use std::process::{Child, Command};

/// A scene with photons and with three passes of radiosity.
const SCENE: &str = "#version 3.7;
global_settings { assumed_gamma 1 radiosity { count 12 error_bound 0.7 } photons { count 12000 } }
camera { location <0, 3, -6> right x * image_width / image_height look_at <0, 0.7, 0> }
light_source { <-4, 6, 1> rgb 1 }
plane { y, 0 pigment { checker rgb 0.9, rgb <0.3, 0.5, 0.7> } }
sphere { <0, 0.8, 0>, 0.7 pigment { rgbf 1 } interior { ior 1.5 } photons { target refraction on } }
box { <1.2, 0, -1>, <1.4, 2, 2> pigment { bozo } }
#debug \"begun\\n\"";
const WORDS: &str = "--size 40x30 --aa 0 --aa-method grid --aa-depth 2 -o a.png";

fn scratch() -> Scratch {
    let scratch = Scratch::new();
    std::fs::write(scratch.at("a.scene"), SCENE).unwrap();
    scratch
}

/// Renders the scene to its end. Returns the names of the passes that ran.
fn finish(scratch: &Scratch, words: &str) -> Vec<String> {
    let out = scratch.run(&format!("{words} --resume --stats json"));
    assert!(out.status.success(), "{}", err(&out));
    assert!(!scratch.is_unfinished());
    let stats: serde_json::Value = serde_json::from_slice(&out.stdout).unwrap();
    let passes = stats["passes"].as_array().unwrap().iter();
    passes.map(|pass| pass["pass"].as_str().unwrap().to_string()).collect()
}

/// Starts a render with one thread, and waits until its messages have `n` lines that contain `event`.
fn start_until(mut durer: Command, event: &str, n: usize) -> Child {
    let mut durer = durer.args(["--threads", "1", "--progress", "json"]).spawn().unwrap();
    let messages = BufReader::new(durer.stderr.as_mut().unwrap());
    let found = messages.lines().map_while(Result::ok).filter(|line| line.contains(event)).take(n).count();
    assert_eq!(found, n, "the render ended before");
    durer
}

/// Ends a process by a signal. The process may also have finished its work.
fn end(mut durer: Child, signal: &str) {
    let mut messages = durer.stderr.take().unwrap();
    send(&durer, signal);
    messages.read_to_end(&mut vec![]).unwrap();
    durer.wait().unwrap();
}

const PASS: &str = "\"pass\"";

#[test]
fn a_render_is_interrupted_during_each_pass() {
    let whole = scratch();
    assert_eq!(finish(&whole, WORDS), ["photons", "radiosity", "radiosity", "radiosity"]);
    let moments = [("begun", 1), (PASS, 1), (PASS, 2), (PASS, 3), ("\"progress\"", 1)];
    for signal in ["TERM", "KILL"] {
        for (moment, (event, n)) in moments.into_iter().enumerate() {
            let scratch = scratch();
            end(start_until(scratch.durer(WORDS), event, n), signal);
            let passes = finish(&scratch, WORDS);
            // A pass of radiosity begins after the photons are stored, and the picture after the samples.
            assert!(moment < 2 || !passes.contains(&"photons".to_string()), "{signal}, moment {moment}: {passes:?}");
            assert!(moment < 4 || passes.is_empty(), "{signal}: {passes:?}");
            assert!(scratch.pictures() == whole.pictures(), "{signal}, moment {moment}");
        }
    }
}

#[test]
fn stored_light_of_a_damaged_or_other_journal_is_not_used() {
    let (scratch, whole) = (scratch(), scratch());
    end(start_until(scratch.durer(WORDS), "\"progress\"", 1), "KILL");
    let journal = std::fs::read(scratch.at("a.png.unfinished")).unwrap();
    let header = journal.iter().position(|&byte| byte == b'\n').unwrap() + 1;
    finish(&whole, WORDS);
    // Light is the first content after the header.
    let mut damaged = journal.clone();
    damaged[header + 200] ^= 1;
    for content in [&damaged[..], &journal[..header + 200]] {
        std::fs::write(scratch.at("a.png.unfinished"), content).unwrap();
        assert_eq!(finish(&scratch, WORDS).len(), 4);
        assert!(scratch.pictures() == whole.pictures());
    }
    std::fs::write(scratch.at("a.png.unfinished"), &journal).unwrap();
    for scratch in [&scratch, &whole] {
        std::fs::write(scratch.at("a.scene"), SCENE.replace("rgb 1 }", "rgb 2 }")).unwrap();
        assert_eq!(finish(scratch, WORDS).len(), 4);
    }
    assert!(scratch.pictures() == whole.pictures());
}

#[test]
fn shards_keep_their_light_and_prepared_light_is_not_stored() {
    let scratch = scratch();
    let words = format!("{WORDS} --shard 1/1");
    end(start_until(scratch.durer(&words), "\"progress\"", 1), "KILL");
    assert!(finish(&scratch, &words).is_empty());
    let prepare = scratch.command("prepare a.scene --size 40x30").output().unwrap();
    assert!(prepare.status.success(), "{}", err(&prepare));
    end(start_until(scratch.durer(&format!("{WORDS} --prepared a.prepared")), "\"progress\"", 1), "KILL");
    // Without the file, the light is computed.
    assert_eq!(finish(&scratch, WORDS).len(), 4);
}

#[test]
fn light_of_a_short_preparation_is_not_stored() {
    let scratch = scratch();
    let durer = scratch.command(&format!("render a.scene {WORDS} --keep-after 100"));
    end(start_until(durer, "\"progress\"", 1), "KILL");
    assert!(!scratch.is_unfinished());
}
