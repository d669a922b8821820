//! Arguments of the commands and their messages: several scenes, POV-Ray's options, frames, values, codes.

use crate::scratch::{SCENE, Scratch};
use serde_json::Value;

const BAD: &str = "boxx { }\n#warning \"careful\"\n  spere { }\n";

/// Width and height of a PNG.
fn size(png: &[u8]) -> (u32, u32) {
    let number = |at: usize| u32::from_be_bytes(png[at..at + 4].try_into().unwrap());
    (number(16), number(20))
}

#[test]
fn help_groups_options() {
    let scratch = Scratch::new();
    let (help, _) = scratch.exits(0, "render --help");
    for heading in ["Scene:", "Picture:", "Files:", "Limits:", "Output:"] {
        assert!(help.contains(&format!("\n{heading}\n")), "{heading}\n{help}");
    }
    assert!(help.contains("-j, --threads <N>"), "{help}");
    let (check, _) = scratch.exits(0, "check -h");
    assert!(check.contains("\nOutput:\n") && !check.contains("\nPicture:\n      --format"), "{check}");
}

#[test]
fn help_pages_are_short() {
    use clap::CommandFactory;
    for command in durer::cli::Cli::command().get_subcommands().filter(|c| c.get_name() != "test") {
        for option in command.get_arguments().filter(|a| !a.is_hide_set()) {
            let help = option.get_help().map(ToString::to_string).unwrap_or_default();
            let name = format!("{} {}", command.get_name(), option.get_id());
            assert!((5..=105).contains(&help.len()) && !help.contains('\n'), "{name}: {help}");
        }
    }
}

/// Runs the command in a terminal, by `script`.
#[cfg(target_os = "linux")]
#[test]
fn pictures_are_not_written_to_a_terminal() {
    let scratch = Scratch::new();
    let line = format!("{} render ball.scene --size 4x3 -o -", env!("CARGO_BIN_EXE_durer"));
    let output =
        std::process::Command::new("script").args(["-qec", &line, "/dev/null"]).current_dir(scratch.path()).output();
    // Not every machine has `script`.
    let Ok(output) = output else { return };
    let text = String::from_utf8_lossy(&output.stdout);
    assert!(text.contains("durer render ball.scene -o - > picture.png"), "{text}");
    assert_eq!(output.status.code(), Some(2));
}

#[test]
fn povray_options_after_commands() {
    let scratch = Scratch::new();
    for (line, expected) in [
        ("render ball.scene +W32 +H20 -o a.png", (32, 20)),
        ("render ball.scene Width=32 height=20 -o a.png", (32, 20)),
        ("render +W32 +H20 +Oa.png ball.scene", (32, 20)),
        ("render +Iball.scene +W32 +H20 -o a.png", (32, 20)),
        ("ball.scene -o a.png +W32 +H20", (32, 20)),
        ("ball.scene --size 8x6 -o a.png +A0.1", (8, 6)),
        ("--size 8x6 ball.scene -o a.png", (8, 6)),
        ("render ball.scene +W32 --size 8x6 -o a.png -D", (8, 6)),
        ("render -oa.png ball.scene +W8 +H6 -j 2 +WT1", (8, 6)),
        ("ball.scene +W8 +H6 +Oa.png -j 2", (8, 6)),
        ("ball.scene +W8 +H6 +Oa.png -j1", (8, 6)),
        ("-q render ball.scene +W8 +H6 +Oa.png", (8, 6)),
        ("+W8 +H6 +Oa.png render ball.scene", (8, 6)),
    ] {
        scratch.exits(0, line);
        assert_eq!(size(&scratch.read("a.png")), expected, "{line}");
        std::fs::remove_file(scratch.path().join("a.png")).unwrap();
    }
    scratch.exits(0, "check ball.scene +W32 +A0.3 Antialias=on");
    scratch.exits(0, "+W32 check ball.scene");
    let (out, _) = scratch.exits(0, "pick ball.scene 16,10 +W32 +H20 --json");
    assert!(out.starts_with("{\"hit\":true"), "{out}");
    scratch.put("+odd.scene", SCENE);
    scratch.exits(0, "check +odd.scene");
    for (line, says) in [
        ("render ball.scene Widht=32", "did you mean `Width=32`?"),
        ("check ball.scene Widht=32", "did you mean `Width=32`?"),
        ("render ball.scene +W", "`+W` is invalid: it needs a number"),
        ("render ball.scene +Foo", "`+Foo` is invalid"),
        ("render ball.scene +nonsense", "there is no option `+nonsense`"),
    ] {
        let (_, err) = scratch.exits(2, line);
        assert!(err.contains(says), "{line}\n{err}");
    }
}

/// After `render`, durer's defaults apply: anti-aliasing is on unless `-A` switches it off.
#[test]
fn anti_aliasing_default_depends_on_the_command() {
    let scratch = Scratch::new();
    let bytes = |line: &str| {
        scratch.exits(0, &format!("{line} +W16 +H12 -o a.ppm"));
        scratch.read("a.ppm")
    };
    scratch.put("ball.scene", format!("{SCENE} background {{ rgb 1 }}"));
    let (smooth, rough) = (bytes("render ball.scene --aa 0.3"), bytes("render ball.scene --aa off"));
    assert!(smooth != rough);
    assert!(bytes("render ball.scene") == smooth);
    assert!(bytes("render ball.scene -A") == rough);
    assert!(bytes("ball.scene") == rough);
    assert!(bytes("ball.scene +A") == bytes("render ball.scene --aa 0.3 --aa-method grid"));
    assert!(bytes("ball.scene +A -J +AM2") == bytes("ball.scene --aa 0.3 --aa-method corners --aa-jitter 0"));
    assert!(bytes("ball.scene +A +AM2") != bytes("ball.scene +A"));
}

#[test]
fn explain_accepts_codes_in_any_case() {
    let scratch = Scratch::new();
    for word in ["203", "0203"] {
        let (out, _) = scratch.exits(0, &format!("explain {word}"));
        assert!(out.starts_with("E0203: ") && out.contains("\nW0203: "), "{out}");
    }
    for word in ["e203", "e0203", "E0203", "error[E0203]:", "[E0203]"] {
        let (out, _) = scratch.exits(0, &format!("explain {word}"));
        assert!(out.starts_with("E0203: ") && !out.contains("W0203: "), "{word}: {out}");
    }
    assert!(scratch.exits(0, "explain w202").0.starts_with("W0202: "));
    let (_, err) = scratch.exits(2, "explain E0299");
    assert!(err.contains("there is no code `E0299`; the nearest is `E0") && err.contains("lists all codes"), "{err}");
    for word in ["E9999", "sphere", "E", "", "99999999999999999999", "é"] {
        let output = scratch.command("explain").arg(word).output().unwrap();
        let err = String::from_utf8_lossy(&output.stderr);
        assert!(output.status.code() == Some(2) && err.contains("`durer explain` lists all codes"), "{word}: {err}");
    }
}

#[test]
fn unknown_commands() {
    let scratch = Scratch::new();
    for (line, says) in [
        ("rendr ball.scene", "did you mean `durer render ball.scene`?"),
        ("Render ball.scene", "did you mean `durer render ball.scene`?"),
        ("draw ball.scene --size 8x6", "did you mean `durer render ball.scene --size 8x6`?"),
        ("lint ball.scene", "did you mean `durer check ball.scene`?"),
        ("-q chekc ball.scene", "did you mean `durer check ball.scene`?"),
        ("format ball.scene", "did you mean `durer fmt ball.scene`?"),
        (
            "wibble ball.scene",
            "there is no command `wibble`, and no scene with this name; the commands are `render`, `check`",
        ),
        ("wibble", "there is no command `wibble`"),
    ] {
        let (out, err) = scratch.exits(2, line);
        assert!(out.is_empty() && err.contains(says), "{line}\n{err}");
    }
    assert_eq!(scratch.names(), ["ball.scene"]);
    // Files and scenes are not taken for commands, whatever their names.
    scratch.put("format.pov", SCENE);
    scratch.exits(0, "format +W4 +H3");
    scratch.put("rendr", SCENE);
    scratch.exits(0, "rendr +W4 +H3");
}

const FILM: &str = "camera { location -z }\n#debug concat(str(frame_number, 0, 0), \" \", str(clock, 0, 3), \" \", str(final_frame, 0, 0), \"\\n\")\n";

#[test]
fn one_frame_without_an_ini_file() {
    let scratch = Scratch::new();
    scratch.put("film.scene", FILM);
    let prints = |line: &str| scratch.exits(0, &format!("render film.scene --size 2x2 {line}")).1;
    assert_eq!(prints("--frame 7"), "7 0.000 7\n");
    assert_eq!(prints("--frame 7 --clock 0.5"), "7 0.500 7\n");
    assert_eq!(prints("--frames 1-11 --frame 7"), "7 0.600 11\n");
    assert_eq!(prints("--frames 1-11 --frame 7 --clock 0..10"), "7 6.000 11\n");
    assert_eq!(scratch.names(), ["ball.scene", "film.scene", "film07.png", "film7.png"]);
    assert_eq!(prints("--frames 1-11 --frame 7 -o one.png"), "7 0.600 11\n");
    assert_eq!(prints("--frame 7 -o shot%03d.png"), "7 0.000 7\n");
    assert_eq!(prints("--frames 9-11:2 -o f_%d_a.png").lines().count(), 2);
    let names = scratch.names();
    for name in ["one.png", "shot007.png", "f_9_a.png", "f_11_a.png"] {
        assert!(names.iter().any(|n| n == name), "{name} {names:?}");
    }
    let (_, err) = scratch.exits(2, "render film.scene --frames 1-5 --frame 7");
    assert!(err.contains("there is no frame 7: the animation goes from 1 to 5"), "{err}");
}

#[test]
fn animations_on_standard_output() {
    let scratch = Scratch::new();
    scratch.put("film.ini", "Input_File_Name=ball.scene\nFinal_Frame=2\n");
    for (line, frames) in [("ball.scene --frames 1-3", 3), ("film.ini", 2), ("ball.scene --frames 1-3 --frame 2", 1)] {
        let output = scratch.run(&format!("render {line} --size 4x3 -o - --format ppm"));
        let one = "P6\n4 3\n255\n".len() + 4 * 3 * 3;
        assert_eq!(output.stdout.len(), frames * one, "{line}");
        assert!(output.stdout.chunks(one).all(|picture| picture.starts_with(b"P6\n4 3\n255\n")));
    }
    let (_, err) = scratch.exits(2, "render ball.scene --frames 1-3 -o -");
    assert!(err.contains("add `--format ppm`"), "{err}");
}

#[test]
fn several_scenes_are_checked() {
    let scratch = Scratch::new();
    std::fs::create_dir_all(scratch.path().join("d/e")).unwrap();
    scratch.put("d/bad.scene", BAD);
    scratch.put("d/e/ball.pov", SCENE);
    let (out, err) = scratch.exits(1, "check ball.scene d");
    let lines = "ok    ball.scene\nFAIL  d/bad.scene  2 errors, 1 warning\nok    d/e/ball.pov\n2 ok, 1 FAIL; 2 errors, 1 warning\n";
    assert_eq!(out, lines);
    assert!(err.contains("`boxx {…}`") && !err.contains("2 errors"), "{err}");
    let (out, _) = scratch.exits(0, "check d/e");
    assert_eq!(out, "ok    d/e/ball.pov\n1 ok\n");
    let (out, _) = scratch.exits(1, "check ball.scene d missing.scene");
    assert!(out.ends_with("FAIL  missing.scene  1 error\n2 ok, 2 FAIL; 3 errors, 1 warning\n"), "{out}");
    scratch.exits(5, "check missing.scene ball.scene");
    assert_eq!(scratch.exits(0, "check -q ball.scene d/e").0, "");
    std::fs::create_dir(scratch.path().join("empty")).unwrap();
    let (_, err) = scratch.exits(2, "check empty");
    assert!(err.contains("no file in `empty` ends in `.scene` or `.pov`"), "{err}");
    assert_eq!(scratch.exits(0, "check ball.scene").0, "");
}

#[test]
fn several_scenes_are_rendered() {
    let scratch = Scratch::new();
    std::fs::create_dir_all(scratch.path().join("d")).unwrap();
    std::fs::create_dir_all(scratch.path().join("out")).unwrap();
    scratch.put("d/bad.scene", BAD);
    scratch.put("d/cube.pov", SCENE);
    let (out, err) = scratch.exits(1, "render ball.scene d --size 4x3 -o out");
    assert!(out.is_empty() && err.contains("ok    ball.scene  out/ball.png ("), "{err}");
    assert!(err.ends_with("2 ok, 1 FAIL; 2 errors, 1 warning\n"), "{err}");
    assert!(scratch.path().join("out/ball.png").is_file() && scratch.path().join("out/cube.png").is_file());
    let (_, err) = scratch.exits(0, "render ball.scene d/cube.pov --frames 1-3 --size 4x3 --stats s.json");
    assert!(err.contains("ok    d/cube.pov  cube1.png to cube3.png ("), "{err}");
    assert_eq!(String::from_utf8(scratch.read("s.json")).unwrap().lines().count(), 6);
    scratch.exits(0, "ball.scene d/cube.pov --size 4x3");
    assert_eq!(size(&scratch.read("cube.png")), (4, 3));
    // POV-Ray renders the last one.
    scratch.exits(0, "ball.scene d/cube.pov +W5 +H3 -o last.png");
    scratch.put("d/ball.scene", SCENE);
    for (line, says) in [
        ("render ball.scene d/cube.pov -o a.png", "name a folder: `-o pictures/`"),
        ("render ball.scene d/cube.pov -o - --format ppm", "standard output"),
        ("render ball.scene a.png", "`a.png` is a picture, not a scene; `-o a.png` writes the picture to it"),
        (
            "render ball.scene d/ball.scene -o out",
            "the pictures of `ball.scene` and `d/ball.scene` would both go to `out/ball.png`",
        ),
    ] {
        let (_, err) = scratch.exits(2, line);
        assert!(err.contains(says), "{line}\n{err}");
    }
}

#[test]
fn declare_options_for_vectors_and_colours() {
    let scratch = Scratch::new();
    let scene =
        "camera { location -z }\n#debug concat(vstr(3, P, \",\", 0, 1), \" \", vstr(5, C, \",\", 0, 1), \" \", S)\n";
    scratch.put("d.scene", scene);
    let run = |declares: [&str; 3]| {
        let words = declares.iter().flat_map(|d| ["--declare", d]);
        scratch.command("check d.scene").args(words).output().unwrap()
    };
    let output = run(["P=<1, -2, 3>", "C=rgbt <1, 0.5, 0, 0.3>", "S=\"a <b> 7\""]);
    let err = String::from_utf8_lossy(&output.stderr);
    assert_eq!((err.as_ref(), output.status.code()), ("1.0,-2.0,3.0 1.0,0.5,0.0,0.0,0.3 a <b> 7", Some(0)));
    for (declare, says) in [
        ("P=<1,2", "`<1,2` is no vector: `>` is missing at its end"),
        ("P=<1,a,3>", "`a` in `<1,a,3>` is no number"),
        ("C=rgb <1,2>", "`rgb` has 3 numbers, not 2: rgb <1, 0.5, 0>"),
        ("C=Red", "text needs quotes: 'C=\"Red\"'"),
        ("P", "expected a name and a value"),
    ] {
        let output = run(["P=<1,2,3>", "C=rgb 1", declare]);
        let err = String::from_utf8_lossy(&output.stderr);
        assert!(output.status.code() == Some(2) && err.contains(says), "{declare}\n{err}");
    }
}

#[test]
fn messages_for_editors() {
    let scratch = Scratch::new();
    scratch.put("bad.scene", BAD);
    let (out, err) = scratch.exits(1, "check --format short bad.scene ball.scene missing.scene");
    let lines: Vec<_> = out.lines().collect();
    assert!(err.is_empty() && lines.len() == 4, "{out}{err}");
    assert_eq!(lines[0], "bad.scene:1:1: error[E0204]: there is no block `boxx {…}`");
    assert!(lines[1].starts_with("bad.scene:2:10: warning[W0202]: "), "{out}");
    assert!(lines[2].starts_with("bad.scene:3:3: error[E0204]: "), "{out}");
    assert_eq!(lines[3], "error[E0002]: there is no file `missing.scene`");
    assert_eq!(scratch.exits(1, "check -q --format short bad.scene").0.lines().count(), 2);
}

#[test]
fn pick_lists_the_hits() {
    let scratch = Scratch::new();
    scratch.put(
        "beads.inc",
        "#macro Bead(P) sphere { P, 1 pigment { rgb <1, 0.5, 0> } finish { ambient 1 diffuse 0 } } #end\n\
         #declare Pair = union { Bead(<-1, 0, 0>) Bead(<1, 0, 0>) }\n",
    );
    scratch.put(
        "s.scene",
        "#version 3.7; #include \"beads.inc\"\nglobal_settings { assumed_gamma 1 }\ncamera { location <0, 0, -5> look_at 0 }\n\
         #macro Two() object { Pair translate -100*y } #end\nTwo()\n#for (I, 0, 2)\n  Bead(I*9*x)\n#end\n",
    );
    let (out, _) = scratch.exits(0, "pick s.scene 32,24 --size 65x49");
    let expected = "sphere at beads.inc:1:16\n  in macro `Bead`, called at s.scene:7:3\n  distance  4\n  point     <0, 0, -1>\n  \
                    normal    <0, 0, -1>\n  uv        <0.75, 0.5>\n  colour    rgb <1, 0.5, 0>, on the screen #ffbc00\n";
    assert_eq!(out, expected);
    let (out, _) = scratch.exits(0, "pick s.scene 32,24 --size 65x49 --json");
    let seen: Value = serde_json::from_str(&out).unwrap();
    assert_eq!((&seen["shape"], &seen["source"]["line"]), (&"sphere".into(), &1.into()));
    assert_eq!(seen["trace"][0]["text"], "in macro `Bead`, called");
    assert_eq!((&seen["trace"][0]["file"], &seen["trace"][0]["line"]), (&"s.scene".into(), &7.into()));
    assert_eq!(seen["color"], serde_json::json!([1.0, 0.5, 0.0]));
    assert_eq!(scratch.exits(0, "pick s.scene 0,0 --size 65x49 --json").0, "{\"hit\":false}\n");
    assert!(scratch.exits(0, "pick s.scene 0,0 --size 65x49").0.contains("colour    rgb <0, 0, 0>"));

    scratch.put(
        "s.scene",
        String::from_utf8(scratch.read("s.scene")).unwrap().replace("-100*y", "-y").replace("I*9", "9"),
    );
    let (out, _) = scratch.exits(0, "pick s.scene 26,30 --size 65x49");
    assert!(out.contains("placed at s.scene:4:14\n  in macro `Two`, called at s.scene:5:1\n"), "{out}");
}

#[test]
fn dumps_are_indented() {
    let scratch = Scratch::new();
    let (out, _) = scratch.exits(0, "render ball.scene --dump scene");
    assert!(out.lines().count() > 20 && out.lines().all(|line| line.len() < 200), "{out}");
    let scene: Value = serde_json::from_str(&out).unwrap();
    assert_eq!(scene["objects"][0]["source"], "ball.scene:2:1");
    let (out, _) = scratch.exits(0, "render ball.scene --dump world");
    assert_eq!(serde_json::from_str::<Value>(&out).unwrap()["parts"][0]["source"], "ball.scene:2:1");
}

/// The estimated memory is the used memory, to 15 % and the few megabytes of the program itself and of rows that wait for
/// earlier ones; `--stats` reports the peak.
#[cfg(target_os = "linux")]
#[test]
fn memory_estimate_matches_usage() {
    let scratch = Scratch::new();
    let peak = |render: &str| {
        let (out, _) = scratch.exits(0, &format!("{render} --stats json -j 1"));
        let stats: Value = serde_json::from_str(&out).unwrap();
        stats["peak_memory"].as_f64().unwrap() / 1e6
    };
    // (With many threads, rows wait for earlier ones, and their number depends on the machine's other work: the estimate is the
    // maximum.)
    // Memory of the program with a tiny picture.
    let program = peak("render ball.scene -o ball.png --size 16x12");
    // Rows of png leave memory when they are finished; exr keeps them, 16 bytes a pixel.
    for (format, megabytes) in [("png", 11.0), ("exr", 59.0)] {
        let render = format!("render ball.scene -o ball.{format} --size 2000x1500");
        let (_, err) = scratch.exits(4, &format!("{render} --max-memory 10M"));
        let said = format!("a picture of 2000x1500 takes {megabytes:.0} MB of memory");
        assert!(err.contains(&said), "{err}");
        let taken = peak(&render) - program;
        // (The allocator keeps up to 9 MB of free memory.)
        assert!((taken - megabytes).abs() < 0.15 * megabytes + 8.0, "{format}: {taken} MB, not {megabytes} MB");
    }
}
