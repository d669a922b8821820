//! The command line: exit codes, stdout and stderr, and files that are written whole or not at all.

use crate::scratch::{SCENE, Scratch};
use std::io::Write;
use std::path::Path;
use std::process::Stdio;

#[test]
fn render_writes_to_the_current_folder() {
    let scratch = Scratch::new();
    let (out, err) = scratch.exits(0, "render ball.scene --size 8x6");
    assert_eq!((out.as_str(), err.as_str()), ("", ""));
    assert_eq!(scratch.names(), ["ball.png", "ball.scene"]);
    assert!(scratch.read("ball.png").starts_with(b"\x89PNG"));
}

#[test]
fn every_format_is_written() {
    let scratch = Scratch::new();
    let starts: [(&str, &[u8]); 8] = [
        ("png", b"\x89PNG"),
        ("exr", b"\x76\x2f\x31\x01"),
        ("hdr", b"#?"),
        ("jpg", b"\xff\xd8"),
        ("ppm", b"P6\n8 6\n255\n"),
        ("bmp", b"BM"),
        ("tga", b"\0"),
        ("tiff", b"II*\0"),
    ];
    for (ending, start) in starts {
        scratch.exits(0, &format!("render ball.scene --size 8x6 -o a.{ending}"));
        assert!(scratch.read(&format!("a.{ending}")).starts_with(start), "{ending}");
    }
}

#[test]
fn standard_output_and_input() {
    let scratch = Scratch::new();
    let output = scratch.run("render ball.scene --size 4x3 -o - --format ppm --bit-depth 16");
    assert!(output.stdout.starts_with(b"P6\n4 3\n65535\n") && output.stderr.is_empty());
    assert!(scratch.run("render ball.scene --size 4x3 -o -").stdout.starts_with(b"\x89PNG"));
    let mut command = scratch.command("render - --size 4x3 -o -");
    let mut child = command.stdin(Stdio::piped()).stdout(Stdio::piped()).spawn().unwrap();
    child.stdin.take().unwrap().write_all(SCENE.as_bytes()).unwrap();
    assert!(child.wait_with_output().unwrap().stdout.starts_with(b"\x89PNG"));
    assert_eq!(scratch.names(), ["ball.scene"]);
}

#[test]
fn closed_pipes_are_not_errors() {
    let scratch = Scratch::new();
    for line in ["explain", "completions bash", "render ball.scene -o - --size 8x6"] {
        let mut child = scratch.command(line).stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().unwrap();
        drop(child.stdout.take());
        let output = child.wait_with_output().unwrap();
        assert_eq!(String::from_utf8_lossy(&output.stderr), "", "{line}");
        assert_eq!(output.status.code(), Some(0), "{line}");
    }
}

#[test]
fn exit_codes() {
    let scratch = Scratch::new();
    scratch.put("picture.scene", b"\x89PNG\r\n\x1a\n\0");
    for (code, line) in [
        (0, "check ball.scene"),
        (0, "--help"),
        (0, "--version"),
        (0, "help render"),
        (0, "-?"),
        (0, "render ball.scene --no-output --size 4x3"),
        (1, "check picture.scene"),
        (1, "render picture.scene"),
        (2, ""),
        (2, "rendr ball.scene"),
        (2, "render"),
        (2, "render ball.scene --size 0x4"),
        (2, "render ball.scene --size big"),
        (2, "render ball.scene -o a.xyz"),
        (2, "render ball.scene -o ./ball.scene --format png"),
        (2, "render ball.scene -o a.jpg --alpha"),
        (2, "render ball.scene -o - --stats json"),
        (2, "render ball.scene --frame 3 --frames 1-2"),
        (2, "render ball.scene --region 0,0,641,1"),
        (2, "render ball.scene --declare 1=2"),
        (2, "pick ball.scene 640,0"),
        (2, "pick ball.scene -1,0"),
        (2, "pick ball.scene here"),
        (2, "explain E9999"),
        (2, "test"),
        (4, "render ball.scene --size 1000000x1000000"),
        (4, "render ball.scene --size 18446744073709551615x18446744073709551615"),
        (4, "render ball.scene --max-memory 1k"),
        (4, "render ball.scene --max-time 0"),
        (5, "render missing.scene"),
        (5, "check missing.scene"),
        (1, "check ."),
        (5, "check /"),
        (5, "render ball.scene -o nowhere/a.png"),
    ] {
        scratch.exits(code, line);
    }
    assert_eq!(scratch.names(), ["ball.scene", "picture.scene"]);
}

#[test]
fn failed_renders_keep_the_old_picture() {
    let scratch = Scratch::new();
    scratch.put("ball.png", "P6 old");
    scratch.exits(4, "render ball.scene --max-time 0");
    assert_eq!(scratch.read("ball.png"), b"P6 old");
    assert_eq!(scratch.names(), ["ball.png", "ball.scene"]);
}

#[test]
fn missing_files_get_suggestions() {
    let scratch = Scratch::new();
    let (out, err) = scratch.exits(5, "render bal.scene");
    assert!(out.is_empty() && err.contains("E0002") && err.contains("did you mean `ball.scene`?"), "{err}");
    // As with POV-Ray, the file's ending may be left out.
    scratch.exits(0, "check ball");
    scratch.put("anim.ini", "Input_File_Name=ball.scene");
    let (_, err) = scratch.exits(2, "test anim.ini");
    assert!(err.contains("name the scene, not `anim.ini`"), "{err}");
}

#[test]
fn messages_as_json() {
    let scratch = Scratch::new();
    scratch.put("picture.scene", b"\x89PNG\r\n\x1a\n\0");
    let (out, err) = scratch.exits(1, "check --format json ball.scene picture.scene missing.scene");
    let lines: Vec<serde_json::Value> = out.lines().map(|line| serde_json::from_str(line).unwrap()).collect();
    assert!(err.is_empty() && lines.len() == 2, "{out}{err}");
    assert_eq!((&lines[0]["code"], &lines[0]["severity"]), (&"E0001".into(), &"error".into()));
    assert_eq!((&lines[0]["file"], &lines[0]["line"]), (&"picture.scene".into(), &1.into()));
    assert_eq!((&lines[1]["code"], &lines[1]["file"]), (&"E0002".into(), &serde_json::Value::Null));
}

#[test]
fn quiet_hides_warnings_and_counts_messages() {
    let scratch = Scratch::new();
    scratch.put("two.scene", "#warning \"careful\"\nboxx { }\nspere { }\n");
    let (_, err) = scratch.exits(1, "check two.scene");
    assert!(err.contains("careful") && err.contains("2 errors, "), "{err}");
    assert!(err.find("boxx") < err.find("careful"), "errors come first: {err}");
    let (_, err) = scratch.exits(1, "check -q two.scene");
    assert!(!err.contains("careful") && err.ends_with("2 errors\n"), "{err}");
}

#[test]
fn many_frames_are_numbered() {
    let scratch = Scratch::new();
    scratch.exits(0, "render ball.scene --size 4x3 --frames 8-10 --stats s.json");
    assert_eq!(scratch.names(), ["ball.scene", "ball08.png", "ball09.png", "ball10.png", "s.json"]);
    assert_eq!(String::from_utf8(scratch.read("s.json")).unwrap().lines().count(), 3);
}

#[test]
fn stats_are_one_json_object() {
    let (out, _) = Scratch::new().exits(0, "render ball.scene --size 4x3 --stats json --threads 1");
    let stats: serde_json::Value = serde_json::from_str(&out).unwrap();
    for time in ["parse", "build", "trace", "encode", "total"] {
        assert!(stats["times"][time].is_f64(), "{out}");
    }
    assert_eq!((&stats["width"], &stats["height"], &stats["threads"]), (&4.into(), &3.into(), &1.into()));
    assert!(stats["rays"]["camera"].is_u64(), "{out}");
}

#[test]
fn dumps_are_json_without_rendering() {
    let scratch = Scratch::new();
    for stage in ["scene", "world"] {
        let (out, _) = scratch.exits(0, &format!("render ball.scene --dump {stage}"));
        assert!(serde_json::from_str::<serde_json::Value>(&out).is_ok(), "{out}");
    }
    assert_eq!(scratch.names(), ["ball.scene"]);
}

#[test]
fn pov_rays_command_line() {
    let scratch = Scratch::new();
    scratch.exits(0, "+Iball.scene +W8 +H6 -D -P +Ofoo.ppm +FP -GA");
    assert!(scratch.read("foo.ppm").starts_with(b"P6\n8 6\n"));
    let (_, err) = scratch.exits(0, "ball.scene +W8 +H6 +UF");
    assert!(err.contains("W0012"), "{err}");
    let (_, err) = scratch.exits(1, "ball.scene Widht=8");
    assert!(err.starts_with("Problem with option setting\n") && err.ends_with("Render failed\n"), "{err}");
    assert!(err.contains("did you mean `Width=8`?"), "{err}");
    scratch.put("wrong.pov", "\nsphere { 0, Radius }\n");
    let (_, err) = scratch.exits(1, "+Iwrong.pov +W8 +H6");
    assert!(err.contains("File 'wrong.pov' line 2: Parse Error: `Radius` is not declared\n"), "{err}");
    assert!(err.ends_with("Fatal error in parser: Cannot parse input.\nRender failed\n"), "{err}");
    std::fs::remove_file(scratch.path().join("wrong.pov")).unwrap();
    assert_eq!(scratch.names(), ["ball.png", "ball.scene", "foo.ppm"]);
}

#[test]
fn lines_for_programs_that_start_povray() {
    let scratch = Scratch::new();
    // Two threads and two passes of anti-aliasing: the last progress is that of the whole picture.
    for options in ["", "-GA", "+A0.1 +AM2 +WT2 +W80 +H60"] {
        let (_, err) = scratch.exits(0, &format!("ball.scene +W8 +H6 {options}"));
        assert!(err.starts_with("POV-Ray 3.7 compatible (durer "), "{err}");
        let all = if options.contains("+W80") { "4800 of 4800" } else { "48 of 48" };
        let last = err.rsplit("Rendered ").next().unwrap();
        assert!(last.starts_with(&format!("{all} pixels (100%)\r\n")), "{err}");
        assert!(err.ends_with("POV-Ray finished\n") && err.is_ascii(), "{err}");
        let places: Vec<_> = ["= [Parsing...] =", "= [Rendering...] =", "Rendered"].map(|line| err.find(line)).into();
        assert!(places.iter().all(Option::is_some) && places.is_sorted(), "{err}");
    }
    let (_, err) = scratch.exits(0, "-V ball.scene +W8 +H6");
    assert!(!err.contains("Rendered") && err.contains("\nRender Statistics\nImage Resolution 8 x 6\n----"), "{err}");
    assert!(err.contains("\n  Trace Time:       0 hours  0 minutes  0 seconds (0."), "{err}");
    for silent in ["-GA", "-GS"] {
        assert!(!scratch.exits(0, &format!("ball.scene +W8 +H6 {silent}")).1.contains("Statistics"), "{silent}");
    }
    assert_eq!(scratch.exits(0, "+Iball.scene +W8 +H6 -q").1, "");
    // Programs decode messages as ASCII.
    scratch.put("short.pov", "sphere { <0, 1, 2> }\n");
    let (_, err) = scratch.exits(1, "short.pov +W8");
    assert!(err.contains("the end of `sphere {...}`") && err.is_ascii(), "{err}");
    let (_, err) = scratch.exits(1, "+W8");
    assert!(err.starts_with("Problem with option setting\nNo input file provided\n"), "{err}");
}

#[test]
fn language_version_by_option() {
    let scratch = Scratch::new();
    scratch
        .put("v.pov", "#debug str(version, 0, 2)\n#version 3.6;\n#debug str(version, 0, 2)\ncamera { location -z }\n");
    scratch.put("v.ini", "Input_File_Name=v.pov\nVersion=3.1\nHeight=4.0412871\nWidth=4\nDisplay_Gamma=2.2\n");
    for (line, version) in [
        ("+Iv.pov +W4 +H4 -F", "3.70"),
        ("+Iv.pov +W4 +H4 -F +MV3.1", "3.10"),
        ("v.ini -F", "3.10"),
        ("v.ini -F +MV3.5", "3.50"),
        ("render v.ini --no-output", "3.10"),
        ("render v.ini --no-output --language 2", "2.00"),
        ("check v.ini", "3.10"),
        ("check v.pov --language 3.5", "3.50"),
    ] {
        let (_, err) = scratch.exits(0, line);
        assert!(err.contains(&format!("{version}3.60")), "{line}\n{err}");
        assert!(!err.contains("W0012"), "{line}\n{err}");
    }
    scratch.exits(2, "check v.pov --language 0.5");
    for line in ["v.ini -F --warn options", "render v.ini --no-output --warn options", "check v.ini --warn options"] {
        assert!(scratch.exits(0, line).1.contains("`Display_Gamma=2.2` has no effect"), "{line}");
    }
}

/// POV-Ray 3.7 rounds a half of the largest number up.
#[test]
fn halves_are_rounded_up_in_png() {
    let scratch = Scratch::new();
    for (red, code) in [("0.1", 26), ("0.5", 128), ("0.7", 179), ("0.9", 230)] {
        scratch.put("b.pov", format!("camera {{ location -z }} background {{ rgb {red} }}"));
        scratch.exits(0, "+Ib.pov +W1 +H1 +FP +Ob.ppm");
        assert_eq!(scratch.read("b.ppm").last(), Some(&code), "{red}");
    }
}

#[test]
fn explanations_and_completions() {
    let scratch = Scratch::new();
    let (out, err) = scratch.exits(0, "explain e0004");
    assert!(out.starts_with("E0004: ") && err.is_empty());
    let (out, _) = scratch.exits(0, "explain");
    assert_eq!(out.lines().count(), durer::diagnostic::codes::ALL.len());
    for shell in ["bash", "zsh", "fish", "elvish", "powershell"] {
        let (out, _) = scratch.exits(0, &format!("completions {shell}"));
        assert!(out.contains("max-steps"), "{shell}");
    }
}

#[test]
fn snapshots_are_accepted_and_compared() {
    let scratch = Scratch::new();
    scratch.put("ball.scene", format!("//! test: --size 8x6 --aa off\n{SCENE}"));
    let (out, _) = scratch.exits(3, "test ball.scene");
    assert!(out.starts_with("new   ball.scene"), "{out}");
    scratch.exits(2, "test .");
    let (out, _) = scratch.exits(0, "test --accept ball.scene");
    assert!(out.contains("accepted") && scratch.names() == ["ball.scene", "ball.snapshot.png"], "{out}");
    let accepted = scratch.read("ball.snapshot.png");
    // Rendering the scene does not change the snapshot.
    scratch.exits(0, "render ball.scene --size 8x6 --aa off --declare Size=2");
    scratch.exits(2, "render ball.scene --size 8x6 -o ball.snapshot.png");
    scratch.exits(1, "+Iball.scene +W8 +H6 +Oball.snapshot.png");
    assert_eq!(scratch.read("ball.snapshot.png"), accepted);
    std::fs::remove_file(scratch.path().join("ball.png")).unwrap();
    assert_eq!(scratch.exits(0, "test").0, "ok    ball.scene\n1 ok\n");

    std::fs::create_dir(scratch.path().join("other")).unwrap();
    scratch.put("other/white.ppm", [b"P6\n8 6\n255\n".as_slice(), &[255; 8 * 6 * 3]].concat());
    let white = durer::image_io::decode_picture_file(&durer::source::Disk, &scratch.path().join("other/white.ppm"))
        .unwrap()
        .to_linear_image();
    let png = durer::image_io::Encoding::new(durer::image_io::Format::Png);
    scratch.put("ball.snapshot.png", durer::image_io::encode(&white, &png).unwrap());
    let (out, err) = scratch.exits(3, "test --report report");
    assert!(out.starts_with("FAIL  ball.scene") && out.ends_with("1 FAIL\n"), "{out}");
    assert!(out.contains("durer test --accept ball.scene\n") && err.contains("report/index.html"), "{out}{err}");
    let (out, _) = scratch.exits(3, "test --format json");
    let json: serde_json::Value = serde_json::from_str(&out).unwrap();
    assert_eq!(json["result"], "fail");
    assert_eq!((json["pixels"].as_u64(), json["exit"].as_u64()), (Some(48), Some(3)));
    assert_eq!(
        (&json["snapshot"], &json["accept"]),
        (&"ball.snapshot.png".into(), &"durer test --accept ball.scene".into())
    );
    let page = String::from_utf8(scratch.read("report/index.html")).unwrap();
    assert!(
        page.contains("ball.scene.difference.png") && scratch.path().join("report/ball.scene.difference.png").exists()
    );
    scratch.exits(0, "test --accept");
    assert_eq!(scratch.read("ball.snapshot.png"), accepted);
}

#[test]
fn hashes_of_pictures_are_written_and_compared() {
    let scratch = Scratch::new();
    let scene = |red: f64| format!("//! test: --size 8x6 --aa off\n{SCENE} background {{ rgb <{red}, 0, 0> }}");
    scratch.put("ball.scene", scene(0.6));
    scratch.exits(0, "test --accept ball.scene");
    let (out, err) = scratch.exits(5, "test --hashes hashes.txt");
    assert!(out.is_empty() && err.contains("hashes.txt"), "{out}{err}");
    let (out, _) = scratch.exits(0, "test --accept --hashes hashes.txt");
    assert_eq!(out, "ok    ball.scene  accepted: a new hash\n1 ok\n");
    assert_eq!(scratch.exits(0, "test --hashes hashes.txt").0, "ok    ball.scene\n1 ok\n");

    // A picture that equals its snapshot within the tolerance has other bits.
    scratch.put("ball.scene", scene(0.6000001));
    let (out, _) = scratch.exits(3, "test --hashes hashes.txt");
    assert!(out.contains("the pixels have other bits than their hash says\n"), "{out}");
    assert!(out.contains("durer test --accept --hashes hashes.txt ball.scene\n"), "{out}");
    assert_eq!(scratch.exits(0, "test").0.lines().last(), Some("1 ok"));
}

#[cfg(target_os = "linux")]
#[test]
fn devices_and_full_disks() {
    let scratch = Scratch::new();
    scratch.exits(0, "render ball.scene --size 4x3 -o /dev/null --format png");
    assert!(!Path::new("/dev/null").is_file());
    let full = std::fs::OpenOptions::new().write(true).open("/dev/full").unwrap();
    let output = scratch.command("explain").stdout(full).output().unwrap();
    assert_eq!(output.status.code(), Some(5));
    assert!(String::from_utf8_lossy(&output.stderr).contains("E0004"));
}

#[test]
fn system_fonts_are_found_by_family() {
    let scratch = Scratch::new();
    std::fs::create_dir_all(scratch.path().join("fonts/deep")).unwrap();
    // The built-in Roboto under another name.
    let mut font = include_bytes!("../../scenes/gallery/Roboto-Regular.ttf").to_vec();
    let [from, to] =
        ["Roboto", "Durero"].map(|name| name.encode_utf16().flat_map(u16::to_be_bytes).collect::<Vec<_>>());
    for at in 0..font.len() - from.len() {
        if font[at..].starts_with(&from) {
            font[at..at + to.len()].copy_from_slice(&to);
        }
    }
    std::fs::write(scratch.path().join("fonts/deep/some.ttf"), font).unwrap();
    for (name, is_told) in
        [("durero", false), ("Durero Medium Italic", false), ("Durero Slab", true), ("Roboto", false)]
    {
        let text = format!("text {{ ttf \"{name}\" \"a\" 1, 0 pigment {{ rgb 1 }} }}");
        std::fs::write(scratch.path().join("text.scene"), text).unwrap();
        let output = scratch.command("check text.scene").env("DURER_FONTS", "fonts").output().unwrap();
        assert_eq!(output.status.code(), Some(0));
        assert_eq!(String::from_utf8_lossy(&output.stderr).contains("W0211"), is_told, "{name}");
    }
}

/// Programs that start POV-Ray open `alltext.out` after the render.
#[test]
fn povray_text_files_hold_what_is_printed() {
    let scratch = Scratch::new();
    scratch.put("a.pov", "#debug \"from the scene\\n\" #warning \"mind this\" sphere { 0, 1 pigment { rgb 1 } } camera { location -3*z }");
    scratch.exits(0, "+Ia.pov +W8 +H6 -GA All_File= Warning_File=w.txt +GIused.ini");
    let text = |name: &str| String::from_utf8(scratch.read(name)).unwrap();
    let has = |name: &str| scratch.path().join(name).exists();
    let all = text("alltext.out");
    for part in [
        "[Parsing...]",
        "from the scene",
        "File 'a.pov' line 1: Parse Warning: mind this",
        "Trace Time:",
        "POV-Ray finished",
    ] {
        assert!(all.contains(part), "{part} in {all}");
    }
    let warnings = text("w.txt");
    assert!(warnings.contains("mind this") && !warnings.contains("Trace Time"), "{warnings}");
    std::fs::remove_file(scratch.path().join("a.png")).unwrap();
    scratch.exits(0, "used.ini");
    assert!(has("a.png"));
    // A file of another origin is kept, and nothing is rendered.
    scratch.put("alltext.out", "mine");
    scratch.exits(1, "+Ia.pov +W8 +H6 +Ob.png All_File=on");
    assert_eq!(text("alltext.out"), "mine");
    assert!(!has("b.png"));
    scratch.exits(1, "+Ia.pov +W8 +H6 +Ob.png All_File=sub/all.txt");
    // Nothing but the picture is written for untrusted scenes.
    scratch.exits(0, "+Ia.pov +W8 +H6 Debug_File=d.txt +GIother.ini --untrusted");
    assert!(!has("d.txt") && !has("other.ini"));
}
