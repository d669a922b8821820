//! Hostile arguments, input and output files.

use super::limited_run::{Case, ScratchFolder, case, finish};
use libtest_mimic::{Failed, Trial};
use std::io::Read;
use std::process::Stdio;

const BALL: &str = "camera { location <0, 0, -5> look_at 0 }\nsphere { 0, 1 }\n";

/// Cases of one command with files.
pub fn cases() -> Vec<Case> {
    let ball = |name, args, exit, told| case(name, BALL, exit, told).args(args);
    vec![
        ball("size_huge", "render a.scene -o out.exr --size 200000x200000", 4, &["E0006"]),
        ball("size_beyond_png", "render a.scene -o out.png --size 99999999999x1", 4, &["E0006"]),
        ball("size_overflow", "render a.scene -o out.png --size 99999999999999999999x1", 2, &["--size"]),
        ball("size_zero", "render a.scene -o out.png --size 0x0", 2, &["--size"]),
        ball("size_negative", "render a.scene -o out.png --size -1x5", 2, &["-1"]),
        ball("size_words", "render a.scene -o out.png --size wide", 2, &["--size"]),
        ball("size_thin", "render a.scene -o out.png --size 1x2000", 0, &[]),
        ball("threads_many", "render a.scene -o out.png --size 8x6 --threads 99999", 2, &["--threads"]),
        ball("threads_none", "render a.scene -o out.png --size 8x6 --threads 0", 2, &["--threads"]),
        ball("clock_nan", "render a.scene -o out.png --size 8x6 --clock nan", 2, &["--clock"]),
        ball("time_nan", "render a.scene -o out.png --size 8x6 --max-time nan", 2, &["--max-time"]),
        ball("time_negative", "render a.scene -o out.png --max-time=-1", 2, &["--max-time"]),
        ball("frames_backwards", "render a.scene -o out.png --frames 5-3", 2, &["--frames"]),
        ball(
            "output_in_missing_folder",
            "render a.scene -o nowhere/out2.png --size 8x6",
            5,
            &["E0004", "nowhere/out2.png"],
        ),
        ball("output_is_in_proc", "render a.scene -o /proc/out.png --size 8x6", 5, &["E0004", "/proc/out.png"]),
        ball("output_is_a_file_inside_a_file", "render a.scene -o out.png/x.png --size 8x6", 5, &["E0004"]),
        ball("output_is_the_scene", "render a.scene -o a.scene --format png --size 8x6", 2, &["a.scene"]),
        ball("output_on_full_disk", "render a.scene -o /dev/full --format png --size 8x6", 5, &["E0004", "/dev/full"]),
        ball("output_ending_unknown", "render a.scene -o out.xyz --size 8x6", 2, &["E0005"]),
        ball("output_empty", "render a.scene -o= --size 8x6", 2, &["-o"]),
        ball(
            "stats_unwritable",
            "render a.scene --no-output --size 8x6 --stats nowhere/s.json",
            5,
            &["E0004", "nowhere"],
        ),
        ball("dither_unknown", "render a.scene --dither b9", 2, &["--dither"]),
        ball("dither_of_one_row", "render a.scene -o out.png --size 500x1 --dither fs", 0, &[]),
        ball("dither_of_one_column", "render a.scene -o out.png --size 1x500 --dither d2 --bit-depth 16", 0, &[]),
        ball("dither_of_a_region", "render a.scene -o out.png --size 8x6 --region 1,1,2,2 --alpha --dither d1", 0, &[]),
        ball("file_gamma_zero", "render a.scene --file-gamma 0", 2, &["--file-gamma", "0.1 to 10"]),
        ball("file_gamma_negative", "render a.scene --file-gamma -1", 2, &["--file-gamma", "0.1 to 10"]),
        ball("file_gamma_nan", "render a.scene --file-gamma nan", 2, &["--file-gamma"]),
        ball("file_gamma_steep", "render a.scene -o out.png --size 8x6 --file-gamma 10 --dither fs", 0, &[]),
        ball("aa_nan", "render a.scene --aa nan", 2, &["--aa"]),
        ball("aa_negative", "render a.scene --aa -1", 2, &["--aa", "a number from 0"]),
        ball("aa_everywhere", "render a.scene -o out.png --size 4x3 --aa 0 --aa-depth 9 --aa-method corners", 0, &[]),
        ball("aa_jitter_negative", "render a.scene --aa-jitter -5", 2, &["--aa-jitter", "0 to 1"]),
        ball("aa_gamma_nan", "render a.scene --aa-gamma nan", 2, &["--aa-gamma"]),
        ball("bits_unknown", "render a.scene --bit-depth 17", 2, &["--bit-depth"]),
        ball("bits_that_png_lacks", "render a.scene -o out.png --bit-depth 32", 2, &["E0008"]),
        ball("resume_of_nothing", "render a.scene -o out.png --size 8x6 --resume", 0, &[]),
        ball("resume_without_a_picture", "render a.scene --no-output --size 8x6 --resume", 0, &[]),
        ball("povrays_file_gamma", "+Ia.scene +Oout.png File_Gamma=-3", 1, &["E0011", "File_Gamma"]),
        ball("povrays_dither", "+Ia.scene +Oout.png +THB9", 1, &["E0011", "+THB9"]),
        ball("povrays_bits", "+Ia.scene +Oout.png +FN99999999999999999999", 1, &["E0011", "5 to 16"]),
        ball("option_unknown", "render a.scene --sizze 8x6", 2, &["--sizze"]),
        ball("pick_outside", "pick a.scene 100000,0", 2, &["E0010"]),
        ball("scene_missing", "render b.scene -o out.png", 5, &["E0002", "b.scene"]),
        ball("scene_is_a_folder", "render . -o out.png", 2, &["name a folder"]),
        ball("scene_is_root", "check /", 5, &["E0003"]),
        ball("scene_below_a_file", "check a.scene/b.scene", 5, &["a.scene/b.scene"]),
        ball("scene_is_memory", "check /proc/self/mem", 5, &["E0003"]),
        ball("scene_is_null", "check /dev/null", 0, &["W0206"]),
        ball("scene_never_ends", "check /dev/zero", 5, &["E0003"]),
        ball("prepared_is_no_light", "render a.scene -o out.png --prepared a.scene", 5, &["E0003", "durer prepare"]),
        ball("prepare_over_a_scene", "prepare a.scene -o a.scene", 5, &["E0004", "did not save it"]),
        case("no_scene", "", 5, &["E0002", "a.scene"]).absent(),
        case("memory_tiny", BALL, 4, &["E0006"]).args("render a.scene -o out.png --max-memory 1"),
    ]
}

/// Cases with pipes and folders.
pub fn trials() -> Vec<Trial> {
    vec![
        Trial::test("hostile::scene_from_stdin", scene_from_stdin),
        Trial::test("hostile::noise_from_stdin", noise_from_stdin),
        Trial::test("hostile::endless_stdin", endless_stdin),
        Trial::test("hostile::closed_stdin", closed_stdin),
        Trial::test("hostile::reader_leaves", reader_leaves),
        Trial::test("hostile::stdout_on_full_disk", stdout_on_full_disk),
        Trial::test("hostile::folder_as_output", folder_as_output),
        Trial::test("hostile::read_only_folder", read_only_folder),
    ]
}

fn piped(bytes: &[u8]) -> Result<Stdio, Failed> {
    let mut file = tempfile::tempfile()?;
    std::io::Write::write_all(&mut file, bytes)?;
    std::io::Seek::rewind(&mut file)?;
    Ok(file.into())
}

fn scene_from_stdin() -> Result<(), Failed> {
    let scratch = ScratchFolder::new()?;
    scratch.run("check -", piped(b"\nsphere { 0, Radius }")?)?.judge(1, &["E0203", "<stdin>:2:13"])?;
    scratch.run("render - --size 8x6 -o out.png", piped(BALL.as_bytes())?)?.judge(0, &[])?;
    same(&scratch, &["out.png"])
}

fn noise_from_stdin() -> Result<(), Failed> {
    let scratch = ScratchFolder::new()?;
    scratch.run("render -", piped(b"\x7fELF\0\0")?)?.judge(1, &["E0001", "<stdin>:1:1"])?;
    same(&scratch, &[])
}

fn endless_stdin() -> Result<(), Failed> {
    if !cfg!(target_os = "linux") {
        return Ok(());
    }
    let scratch = ScratchFolder::new()?;
    scratch.run("render -", std::fs::File::open("/dev/zero")?.into())?.judge(5, &["E0003"])?;
    same(&scratch, &[])
}

fn closed_stdin() -> Result<(), Failed> {
    ScratchFolder::new()?.run("check -", Stdio::null())?.judge(0, &["W0206"])
}

/// `durer render … -o - | head -c1`.
fn reader_leaves() -> Result<(), Failed> {
    let scratch = ScratchFolder::new()?;
    scratch.put("a.scene", BALL)?;
    let mut child = scratch.start("render a.scene -o - --format bmp --size 300x200 --aa off", Stdio::piped())?;
    let mut pipe = child.stdout.take().ok_or("no stdout")?;
    pipe.read_exact(&mut [0])?;
    drop(pipe);
    finish(child)?.judge(0, &[])?;
    same(&scratch, &["a.scene"])
}

fn stdout_on_full_disk() -> Result<(), Failed> {
    if !cfg!(target_os = "linux") {
        return Ok(());
    }
    let scratch = ScratchFolder::new()?;
    scratch.put("a.scene", BALL)?;
    for line in ["render a.scene -o - --size 8x6", "render a.scene --dump world", "check a.scene --format json"] {
        let full = std::fs::OpenOptions::new().write(true).open("/dev/full")?;
        let ended = finish(scratch.start(line, full.into())?)?;
        // `check` prints nothing for a scene without faults.
        let silent = line.starts_with("check");
        ended.judge(if silent { 0 } else { 5 }, if silent { &[] } else { &["E0004"] })?;
    }
    same(&scratch, &["a.scene"])
}

/// The picture is written into the folder, with the scene's name.
fn folder_as_output() -> Result<(), Failed> {
    let scratch = ScratchFolder::new()?;
    scratch.put("a.scene", BALL)?;
    std::fs::create_dir(scratch.path().join("pictures"))?;
    scratch.run("render a.scene -o pictures --size 8x6", Stdio::null())?.judge(0, &[])?;
    std::fs::create_dir(scratch.path().join("a.png"))?;
    scratch.run("render a.scene --size 8x6", Stdio::null())?.judge(5, &["E0004", "a.png"])?;
    same(&scratch, &["a.png", "a.scene", "pictures"])
}

fn read_only_folder() -> Result<(), Failed> {
    let scratch = ScratchFolder::new()?;
    let folder = scratch.path().join("closed");
    scratch.put("a.scene", BALL)?;
    std::fs::create_dir(&folder)?;
    let mut rights = std::fs::metadata(&folder)?.permissions();
    rights.set_readonly(true);
    std::fs::set_permissions(&folder, rights)?;
    // The superuser may write everywhere.
    let allowed = std::fs::write(folder.join("probe"), "").is_ok();
    let ended = scratch.run("render a.scene -o closed/out.png --size 8x6", Stdio::null())?;
    if allowed {
        return ended.judge(0, &[]);
    }
    ended.judge(5, &["E0004", "closed/out.png"])
}

fn same(scratch: &ScratchFolder, expected: &[&str]) -> Result<(), Failed> {
    let names = scratch.names()?;
    if names == expected { Ok(()) } else { Err(format!("files are {names:?}, expected {expected:?}").into()) }
}
