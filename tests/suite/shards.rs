//! Shards of a picture: merged, they have the bytes of one render; `merge` refuses what is missing, foreign or damaged.

use super::scratch::Scratch;
use std::process::Command;

/// A scene with glass, soft shadows, media, radiosity and photons, so that each preparation and random number counts.
const SCENE: &str = "#version 3.7;
global_settings { assumed_gamma 1 radiosity { count 20 error_bound 1 } photons { spacing 0.1 } }
camera { location <0, 3, -6> right x * image_width / image_height look_at <0, 0.7, 0> }
light_source { <-4, 6, 1> rgb 1 area_light x, z, 2, 2 jitter }
fog { distance 20 rgb 0.5 }
plane { y, 0 pigment { checker rgb 0.9, rgb <0.3, 0.5, 0.7> } }
sphere { <0, 0.8, 0>, 0.7 pigment { rgbf 1 } interior { ior 1.5 } photons { target refraction on } }
box { <1.2, 0, -1>, <1.4, 2 + clock, 2> pigment { bozo } }";

fn scratch() -> Scratch {
    let scratch = Scratch::new();
    scratch.put("a.scene", SCENE);
    scratch
}

/// Renders shards 1 to `count` with these words.
fn render_shards(scratch: &Scratch, words: &str, count: usize) {
    for index in 1..=count {
        scratch.exits(0, &format!("render a.scene {words} --shard {index}/{count} -j {}", 1 + index % 3));
    }
}

#[track_caller]
fn merged_equals_whole(words: &str, output: &str, count: usize) {
    let scratch = scratch();
    scratch.exits(0, &format!("render a.scene {words} -o whole.{output}"));
    render_shards(&scratch, &format!("{words} -o a.{output}"), count);
    scratch.exits(0, &format!("merge a.{output}"));
    assert!(scratch.read(&format!("a.{output}")) == scratch.read(&format!("whole.{output}")), "{words}");
}

#[test]
fn merged_shards_have_the_bytes_of_one_render() {
    merged_equals_whole("--size 70x52", "png", 3);
    merged_equals_whole("--size 70x52 --aa 0.1 --aa-method grid --alpha --bit-depth 16 --dither fs", "png", 4);
    merged_equals_whole("--size 70x52 --aa 0.1 --aa-method corners", "exr", 2);
    merged_equals_whole("--size 70x52 --aa off --region 5,17,40,30 --outside black", "bmp", 2);
}

#[test]
fn there_may_be_more_shards_than_blocks() {
    merged_equals_whole("--size 20x16 --aa off", "png", 9);
}

#[test]
fn a_finished_shard_is_left_alone() {
    let scratch = scratch();
    let line = "render a.scene --size 40x30 -o a.png --shard 1/2";
    let time = || scratch.path().join("a.png.shard-1-of-2").metadata().unwrap().modified().unwrap();
    scratch.exits(0, line);
    let first = time();
    scratch.exits(0, line);
    assert_eq!(time(), first);
    // Another option, a changed scene and a damaged file are rendered again.
    scratch.exits(0, &format!("{line} --quality 8"));
    assert_ne!(time(), first);
    scratch.exits(0, line);
    let mut bytes = scratch.read("a.png.shard-1-of-2");
    let whole = bytes.clone();
    *bytes.last_mut().unwrap() ^= 1;
    scratch.put("a.png.shard-1-of-2", &bytes);
    scratch.exits(0, line);
    assert!(scratch.read("a.png.shard-1-of-2") == whole);
}

#[test]
fn shards_of_other_machines_fit() {
    let (here, there) = (scratch(), scratch());
    for scratch in [&here, &there] {
        scratch.put("colour.inc", "#declare Colour = rgb 0.5;");
        scratch.put("a.scene", format!("#include \"colour.inc\"\n{SCENE}"));
    }
    here.exits(0, "render a.scene --size 40x30 -o whole.png");
    here.exits(0, "render a.scene --size 40x30 -o a.png --shard 1/2");
    there.exits(0, "render ./a.scene --size 40x30 -o a.png --shard 2/2 -j 1");
    here.put("a.png.shard-2-of-2", there.read("a.png.shard-2-of-2"));
    here.exits(0, "merge a.png");
    assert!(here.read("a.png") == here.read("whole.png"));
    // A file that differs is found.
    there.put("colour.inc", "#declare Colour = rgb 0.6;");
    there.exits(0, "render a.scene --size 40x30 -o a.png --shard 2/2");
    here.put("a.png.shard-2-of-2", there.read("a.png.shard-2-of-2"));
    let (_, err) = here.exits(5, "merge a.png");
    assert!(err.contains("`colour.inc` is not the same file"), "{err}");
}

#[test]
fn merge_refuses_what_is_missing_foreign_or_damaged() {
    let scratch = scratch();
    let refuses = |line: &str, code: i32, reason: &str| {
        let (_, err) = scratch.exits(code, line);
        assert!(err.contains(reason), "{line}: {err}");
        assert!(!scratch.path().join("a.png").exists());
    };
    refuses("merge a.png", 2, "there are no shards of `a.png`");
    scratch.exits(0, "render a.scene --size 40x30 -o a.png --shard 2/3");
    refuses("merge a.png", 5, "2 of 3 shards are missing: 1, 3");
    render_shards(&scratch, "--size 40x30 -o a.png", 3);
    refuses("merge a.jpg a.png.shard-1-of-3", 5, "2 of 3 shards are missing");
    scratch.exits(0, "render a.scene --size 40x30 -o a.png --shard 2/2");
    refuses("merge a.png", 2, "out of 2 and out of 3");
    std::fs::remove_file(scratch.path().join("a.png.shard-2-of-2")).unwrap();
    let name = "a.png.shard-3-of-3";
    let whole = scratch.read(name);
    for (bytes, reason) in [
        (whole[..whole.len() - 1].to_vec(), "it is not complete"),
        (whole[..20].to_vec(), "it is not complete"),
        ([&whole[..], b"x"].concat(), "it is damaged"),
        (b"hello".to_vec(), "it is not a shard"),
        (b"durer shard 9\n{}\n".to_vec(), "it is from another version of durer"),
    ] {
        scratch.put(name, &bytes);
        refuses("merge a.png", 5, reason);
    }
    for at in (20..whole.len()).step_by(whole.len() / 40) {
        let mut bytes = whole.clone();
        bytes[at] ^= 4;
        scratch.put(name, &bytes);
        refuses("merge a.png", 5, "can't be merged");
    }
    scratch.put(name, &whole);
    scratch.put("plain.scene", SCENE.replace("0.9", "0.8"));
    scratch.exits(0, "render plain.scene --size 40x30 -o b.png --shard 3/3");
    scratch.put(name, scratch.read("b.png.shard-3-of-3"));
    refuses("merge a.png", 5, "is not the same file");
    scratch.put(name, &whole);
    scratch.exits(0, "merge a.png");
}

#[test]
fn frames_of_an_animation_are_dealt_out() {
    let scratch = scratch();
    scratch.exits(0, "render a.scene --size 30x20 --frames 1-3 -o whole.png");
    render_shards(&scratch, "--size 30x20 --frames 1-3 -o a.png", 2);
    // Five shards of three frames: frames 1 and 2 have two parts each.
    render_shards(&scratch, "--size 30x20 --frames 1-3 -o b.png", 5);
    scratch.exits(0, "merge b1.png");
    scratch.exits(0, "merge b2.png");
    for frame in 1..=3 {
        let whole = scratch.read(&format!("whole{frame}.png"));
        assert!(scratch.read(&format!("a{frame}.png")) == whole && scratch.read(&format!("b{frame}.png")) == whole);
    }
}

#[test]
fn schedulers_choose_the_shard() {
    let scratch = scratch();
    let mut command = scratch.command("render a.scene --size 40x30 -o a.png --shard auto/4");
    let out = command.env("JOB_COMPLETION_INDEX", "2").output().unwrap();
    let err = String::from_utf8_lossy(&out.stderr);
    assert!(err.starts_with("shard 3 of 4 (Kubernetes: JOB_COMPLETION_INDEX=2)\n"), "{err}");
    assert!(scratch.names().contains(&"a.png.shard-3-of-4".to_string()));
    let (_, err) = scratch.exits(2, "render a.scene --shard auto");
    assert!(err.contains("state the shard: `--shard 3/16`"), "{err}");
}

/// A scheduler's TERM keeps what is done, and the same command continues. USR1 writes what is done as a picture.
#[cfg(unix)]
#[test]
fn a_terminated_shard_is_continued() {
    let scratch = scratch();
    let line = "render a.scene --size 200x150 --aa 0.1 -o a.png --shard 1/2 --keep-after 0 -j 1";
    let mut durer = scratch.command(line).spawn().unwrap();
    let journal = scratch.path().join("a.png.shard-1-of-2.unfinished");
    while journal.metadata().map_or(0, |metadata| metadata.len()) < 100_000 {
        assert!(durer.try_wait().unwrap().is_none(), "the render ended without a journal");
        std::thread::sleep(std::time::Duration::from_millis(1));
    }
    let send = |signal: &str| {
        let kill = format!("kill -{signal} {}", durer.id());
        assert!(Command::new("sh").args(["-c", &kill]).status().unwrap().success());
    };
    send("USR1");
    let partial = scratch.path().join("a.png.shard-1-of-2.partial.png");
    while !partial.exists() {
        std::thread::sleep(std::time::Duration::from_millis(1));
    }
    send("TERM");
    assert_eq!(durer.wait().unwrap().code(), Some(75));
    assert!(journal.exists());
    scratch.exits(0, line);
    assert!(!journal.exists());
    scratch.exits(0, "render a.scene --size 200x150 --aa 0.1 -o a.png --shard 2/2");
    scratch.exits(0, "render a.scene --size 200x150 --aa 0.1 -o whole.png");
    scratch.exits(0, "merge a.png");
    assert!(scratch.read("a.png") == scratch.read("whole.png"));
    let [partial, whole] = ["a.png.shard-1-of-2.partial.png", "whole.png"]
        .map(|name| image::load_from_memory(&scratch.read(name)).unwrap().into_rgba8());
    let finished: Vec<_> = partial.pixels().zip(whole.pixels()).filter(|(pixel, _)| pixel[3] != 0).collect();
    // Blocks of 16 pixels, at most one half of the picture
    assert!(finished.len() >= 256 && finished.len() < 200 * 150, "{}", finished.len());
    assert!(finished.iter().all(|(pixel, whole)| pixel == whole));
}

#[test]
fn progress_is_printed_for_logs_and_programs() {
    let scratch = scratch();
    let line = "render a.scene --size 80x60 -o a.png";
    let (_, err) = scratch.exits(0, &format!("{line} --shard 1/1"));
    assert!(err.ends_with("100%, 0 s left\n") && err.contains("photons: finished\n"), "{err}");
    assert!(err.lines().count() < 30, "{err}");
    assert_eq!(scratch.exits(0, &format!("{line} --shard 1/2 -q")).1, "");
    assert_eq!(scratch.exits(0, line).1, "");
    let (_, err) = scratch.exits(0, &format!("{line} --progress openjd"));
    assert!(
        err.starts_with("openjd_status: rendering a.scene\n") && err.ends_with("openjd_progress: 100.0\n"),
        "{err}"
    );
    let (_, err) = scratch.exits(0, &format!("{line} --progress json"));
    let lines: Vec<serde_json::Value> = err.lines().map(|line| serde_json::from_str(line).unwrap()).collect();
    let percents: Vec<f64> = lines.iter().filter_map(|line| line["percent"].as_f64()).collect();
    assert!(percents.is_sorted() && percents.last() == Some(&100.0), "{percents:?}");
    assert!(lines.iter().any(|line| line["event"] == "pass" && line["name"] == "photons"), "{err}");
}

#[test]
fn pictures_of_rows_are_merged_to_the_bytes_of_one_render() {
    let scratch = scratch();
    let formats =
        ["png", "png --bit-depth 16", "png --gray", "png --file-gamma 1.8", "ppm", "bmp", "tga", "tiff", "exr", "hdr"];
    for format in formats {
        let (ending, options) = format.split_once(' ').unwrap_or((format, ""));
        let line = format!("render a.scene --size 40x30 --aa 0.1 {options}");
        for (part, region) in [("b", "0,0,40,11"), ("c", "0,11,25,19"), ("d", "25,9,15,21")] {
            scratch.exits(0, &format!("{line} --region {region} --outside black -o {part}.{ending}"));
        }
        scratch.exits(0, &format!("{line} -o whole.{ending}"));
        let (_, err) = scratch.exits(0, &format!("merge a.{ending} b.{ending} c.{ending} d.{ending}"));
        assert_eq!(err, format!("a.{ending}: 3 pictures merged\n"));
        assert!(scratch.read(&format!("a.{ending}")) == scratch.read(&format!("whole.{ending}")), "{format}");
    }
    // POV-Ray's options, and a part that is missing
    for (part, rows) in [("b", "+SR1 +ER10"), ("c", "+SR11 +ER25")] {
        scratch.exits(0, &format!("+Ia.scene +W40 +H30 +A0.1 {rows} +O{part}.png"));
    }
    let (_, err) = scratch.exits(0, "merge a.png b.png c.png");
    assert_eq!(
        err,
        "a.png: 2 pictures merged\n5 rows are black in all pictures; the first is row 26, counted from 1\n"
    );
}

#[test]
fn pictures_that_do_not_fit_are_not_merged() {
    let scratch = scratch();
    let line = "render a.scene --size 20x15 --aa off --outside black";
    scratch.exits(0, &format!("{line} --region 0,0,20,9 -o b.png"));
    let refuses = |words: &str, code, reason: &str| {
        let (_, err) = scratch.exits(code, &format!("merge {words}"));
        assert!(err.contains(reason), "{err}");
        assert!(!scratch.names().contains(&"a.png".to_string()));
    };
    scratch.exits(0, &format!("{line} --clock 1 --region 0,6,20,9 -o c.png"));
    refuses("a.png b.png c.png", 5, "`c.png` can't be merged: its pixel ");
    scratch.exits(0, &format!("{line} --size 20x16 -o c.png").replacen(" --size 20x15", "", 1));
    refuses("a.png b.png c.png", 5, "it has another size or kind of pixels than `b.png`");
    refuses("a.png b.png ball.scene", 5, "`ball.scene` can't be decoded");
    refuses("a.jpg b.png", 2, "without loss");
    refuses("a.exr b.png", 2, "exr can't hold 8 bits a channel");
    refuses("a.png nothing.png", 5, "nothing.png");
}
