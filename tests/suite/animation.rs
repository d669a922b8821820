//! INI files and animations on the command line, compared with POV-Ray 3.7's output.

use std::path::Path;
use std::process::{Command, Stdio};

const SCENE: &str = r#"camera { location <0, 0, -5> look_at 0 }
light_source { -9*z rgb 1 } sphere { 0, 1 pigment { rgb 1 } }
#debug concat("c=", str(clock, 0, 9), " n=", str(frame_number, 0, 0), " of ", str(initial_frame, 0, 0), "-", str(final_frame, 0, 0),
  " in ", str(initial_clock, 0, 5), "-", str(final_clock, 0, 5), " d=", str(clock_delta, 0, 9), " on=", str(clock_on, 0, 0),
  " ", str(image_width, 0, 0), "x", str(image_height, 0, 0), " ", input_file_name, "\n")
#ifdef (Speed) #debug concat("Speed=", str(Speed, 0, 2), "\n") #end
"#;

/// Beginnings of the lines that programs expect from POV-Ray.
const POVRAY_LINES: &[&str] = &[
    "POV-Ray ",
    "====",
    "Rendered ",
    "----",
    "Render Statistics",
    "Image Resolution ",
    "  Parse Time: ",
    "  Trace Time: ",
];

/// An empty folder with a scene in it.
struct Scratch(tempfile::TempDir);

impl Scratch {
    fn new(files: &[(&str, &str)]) -> Self {
        let scratch = Self(tempfile::tempdir().unwrap());
        for (name, text) in [("q.pov", SCENE)].iter().chain(files) {
            let path = scratch.0.path().join(name);
            std::fs::create_dir_all(path.parent().unwrap()).unwrap();
            std::fs::write(path, text).unwrap();
        }
        scratch
    }

    fn path(&self) -> &Path {
        self.0.path()
    }

    /// Runs durer and asserts its exit code; returns stdout and stderr together.
    #[track_caller]
    fn exits(&self, code: i32, line: &str) -> String {
        let mut command = Command::new(env!("CARGO_BIN_EXE_durer"));
        command.args(line.split_whitespace()).current_dir(self.path()).stdin(Stdio::null());
        let output = command.output().unwrap();
        let text = [output.stdout, output.stderr].map(|bytes| String::from_utf8_lossy(&bytes).into_owned()).concat();
        assert_eq!(output.status.code(), Some(code), "durer {line}\n{text}");
        text
    }

    /// Returns the lines that the scene prints, without the lines that programs expect from POV-Ray.
    #[track_caller]
    fn prints(&self, line: &str) -> Vec<String> {
        let is_povrays = |line: &&str| POVRAY_LINES.iter().any(|start| line.starts_with(start));
        self.exits(0, line).lines().filter(|line| !is_povrays(line)).map(String::from).collect()
    }

    fn pictures(&self) -> Vec<String> {
        let entries = std::fs::read_dir(self.path()).unwrap().map(|e| e.unwrap().file_name().into_string().unwrap());
        let mut names: Vec<_> = entries.filter(|name| name.ends_with(".png")).collect();
        names.iter().for_each(|name| std::fs::remove_file(self.path().join(name)).unwrap());
        names.sort();
        names
    }
}

const ANIM: &str =
    "; twelve frames\nInput_File_Name=\"q.pov\"\n+W4 +H3 -A\nFinal_Frame=12\n[low]\nWidth=2\n[Really Low]\n+W1 +H1\n";

#[test]
fn still_pictures_have_clock_0() {
    let scratch = Scratch::new(&[]);
    let none = "c=0.000000000 n=0 of 0-0 in 0.00000-0.00000 d=0.000000000 on=0 640x480 q.pov";
    assert_eq!(scratch.prints("check q.pov"), [none]);
    assert_eq!(scratch.prints("q.pov +KI2 +KF4 -F"), [none]);
    let clock = "c=0.300000012 n=0 of 0-0 in 0.00000-0.00000 d=0.000000000 on=1 640x480 q.pov";
    assert_eq!(scratch.prints("check q.pov --clock 0.3"), [clock]);
    assert_eq!(scratch.prints("+Iq +K0.3 -F"), [clock]);
    assert_eq!(scratch.prints("check q"), [none]);
}

#[test]
fn an_ini_file_is_drawn() {
    let scratch = Scratch::new(&[("anim.ini", ANIM)]);
    let line = |clock: &str, frame: u32, size: &str| {
        format!("c={clock} n={frame} of 1-12 in 0.00000-1.00000 d=0.090909100 on=1 {size} q.pov")
    };
    assert_eq!(scratch.prints("render anim.ini --frame 3"), [line("0.181818187", 3, "4x3")]);
    assert_eq!(scratch.pictures(), ["q03.png"]);
    assert_eq!(scratch.prints("render anim.ini --frame 3 -o a.png --size 8x6"), [line("0.181818187", 3, "8x6")]);
    assert_eq!(scratch.pictures(), ["a.png"]);
    assert_eq!(
        scratch.prints("render anim.ini[low] --frames 3-5:2"),
        [line("0.181818187", 3, "2x3"), line("0.363636374", 5, "2x3")]
    );
    assert_eq!(scratch.pictures(), ["q03.png", "q05.png"]);
    assert_eq!(scratch.prints("check anim.ini"), [line("0.000000000", 1, "4x3")]);
    assert_eq!(scratch.prints("check anim --frame 10"), [line("0.818181813", 10, "4x3")]);
    for line in ["anim.ini", "anim", "+W9 q.pov anim.ini[LOW] +W4", "render anim.ini", "render anim"] {
        assert_eq!(scratch.prints(line).len(), 12, "{line}");
        let expected: Vec<_> = (1..=12).map(|n| format!("q{n:02}.png")).collect();
        assert_eq!(scratch.pictures(), expected, "{line}");
    }
    assert!(scratch.exits(0, "pick anim.ini 2,1 --frame 2").contains("sphere"));
}

#[test]
fn later_options_override_and_command_line_wins() {
    let scratch = Scratch::new(&[("a.ini", "+W4 +H3 Declare=Speed=2.5\nInput_File_Name=q.pov\n")]);
    let size = |line: &str| scratch.prints(line)[0].split(' ').rev().nth(1).unwrap().to_string();
    assert_eq!(size("+W7 a.ini -F"), "4x3");
    assert_eq!(size("a.ini +W7 -F"), "7x3");
    assert_eq!(size("a.ini +W7 --size 2x2 -F"), "2x2");
    assert_eq!(size("check a.ini --size 2x2"), "2x2");
    assert_eq!(scratch.prints("check a.ini")[1], "Speed=2.50");
    assert_eq!(scratch.prints("check a.ini --declare Speed=3")[1], "Speed=3.00");
}

#[test]
fn cyclic_parts_and_steps() {
    let scratch =
        Scratch::new(&[("c.ini", "Input_File_Name=q.pov\n+W1 +H1 +KFF9 +KC +SF0.5 +EF8 +STP2 Output_File_Name=out\n")]);
    let lines = scratch.prints("c.ini");
    let start = |clock: &str, frame: u32| format!("c={clock} n={frame} of 1-10 in 0.00000-1.00000 d=0.111111000 on=1");
    assert!(lines[0].starts_with(&start("0.444444448", 5)), "{lines:?}");
    assert!(lines[1].starts_with(&start("0.666666687", 7)), "{lines:?}");
    assert_eq!(scratch.pictures(), ["out05.png", "out07.png"]);
    let lines = scratch.prints("render c.ini --frame 9 --clock 0..9 --no-output");
    assert!(lines[0].starts_with("c=8.000000000 n=9"), "{lines:?}");
}

#[test]
fn files_beside_the_ini_file_are_found() {
    let scratch = Scratch::new(&[
        ("sub/r.pov", "#include \"k.inc\"\n#debug \"beside\\n\"\ncamera { location z }"),
        ("sub/lib/k.inc", ""),
        ("sub/r.ini", "Input_File_Name=r\nLibrary_Path=lib\nn[x]"),
        ("sub/n.ini", "[x]\n+W3\n[y]\n+W5"),
    ]);
    assert_eq!(scratch.prints("check sub/r.ini"), ["beside"]);
}

#[test]
fn mistakes_are_reported() {
    let scratch =
        Scratch::new(&[("a.ini", "Input_File_Name=q.pov\nFinal_Frame=9\n"), ("b.ini", "Widht=4\n\nHeight=x\n")]);
    assert!(scratch.exits(2, "render a.ini --frame 10").contains("the animation goes from 1 to 9"));
    assert!(scratch.exits(2, "render a.ini --frames 5-10").contains("the animation goes from 1 to 9"));
    assert!(scratch.exits(2, "render a.ini -o -").contains("standard output"));
    for (exit, command) in [(2, "check"), (2, "render"), (1, "")] {
        let text = scratch.exits(exit, &format!("{command} b.ini"));
        assert!(text.contains("b.ini:1:1") && text.contains("b.ini:3:8") && text.contains("`Width=4`"), "{text}");
    }
    let json = scratch.exits(2, "check b.ini --format json");
    assert!(json.lines().all(|l| l.starts_with('{')) && json.contains("\"line\":3"), "{json}");
    assert!(scratch.exits(5, "render no.ini").contains("there is no file `no.ini`"));
    assert!(scratch.exits(5, "check a.ini no.pov").contains("there is no file `no.pov`"));
}

/// The next frame includes a file that the scene has written.
#[test]
fn a_file_that_changes_between_frames_is_read_again() {
    let scene = "#if (file_exists(\"n.inc\")) #include \"n.inc\" #else #declare N = 0; #end\n#debug concat(str(N, 0, 0), \"\\n\")\n\
                 #fopen F \"n.inc\" write\n#write (F, \"#declare N = \", N + 1, \";\")\n#fclose F\ncamera { location z }";
    let scratch = Scratch::new(&[("w.pov", scene)]);
    assert_eq!(scratch.prints("render w.pov --frames 1-4 --size 1x1"), ["0", "1", "2", "3"]);
}

#[test]
fn warnings_are_printed_once() {
    let scratch = Scratch::new(&[("w.pov", "#warning \"look\"\ncamera { location z }")]);
    let text = scratch.exits(0, "render w.pov --frames 1-4 --size 1x1");
    assert_eq!(text.matches("W0202").count(), 1, "{text}");
}

#[test]
fn warnings_as_json() {
    let scratch =
        Scratch::new(&[("w.pov", "#declare A = 1;\n#macro M() 1 / 0 #end\n#declare B = M();\ncamera { location z }")]);
    let text = scratch.exits(0, "check w.pov --warn unused --format json");
    let keys = ["code", "severity", "message", "file", "line", "column", "end", "help", "labels", "trace"];
    let documented = include_str!("../../docs/src/diagnostics.md");
    let mut codes = vec![];
    for line in text.lines() {
        let object: serde_json::Value = serde_json::from_str(line).unwrap();
        assert!(object.as_object().unwrap().keys().all(|key| keys.contains(&key.as_str())), "{line}");
        assert!(keys.iter().all(|key| documented.contains(&format!("`{key}`")) && object.get(key).is_some()), "{line}");
        codes.push(format!("{}:{}", object["code"].as_str().unwrap(), object["line"]));
        if object["code"] == "W0200" {
            assert_eq!((&object["trace"][0]["line"], &object["file"]), (&3.into(), &"w.pov".into()));
        }
    }
    assert_eq!(codes, ["W0200:2", "W0209:1", "W0209:3"]);
    assert!(scratch.exits(1, "check w.pov --warn unused --deny warnings").contains("W0209"));
    assert!(!scratch.exits(0, "check w.pov").contains("W0209"));
    assert!(scratch.exits(2, "check w.pov --warn unusd").contains("unused"));
}
