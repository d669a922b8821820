use super::mixed::Form;
use super::text_output::Stream;
use super::*;
use crate::cli::Cli;
use crate::cli::args::values::Clock;
use crate::diagnostic::Severity;

/// The translation, if it has no errors.
fn translated(words: Vec<OsString>) -> Option<Translated> {
    let translated = translate(&Sources::default(), words);
    translated.diagnostics.iter().all(|d| d.severity == Severity::Warning).then_some(translated)
}

fn words(line: &str) -> Vec<OsString> {
    std::iter::once("durer").chain(line.split_whitespace()).map(OsString::from).collect()
}

/// The translated words without `durer render`, and the number of warnings.
fn ours(line: &str) -> (String, usize) {
    let Translated { words, diagnostics, .. } = translated(words(line)).unwrap();
    let words: Vec<_> = words[2..].iter().map(|w| w.to_str().unwrap()).collect();
    (words.join(" "), diagnostics.len())
}

#[track_caller]
fn same(line: &str, expected: &str) {
    assert_eq!(ours(line), (expected.to_string(), 0), "{line}");
}

#[test]
fn a_command_line_is_translated() {
    same(
        "+Iscene.pov +W640 +H480 +A0.3 -D -P +Ofoo.png +FN16 +L/path +Q5 +WT2 +UA -GA",
        "--aa=0.3 --aa-method=grid --size=640x480 --output=foo.png --format=png --bit-depth=16 --alpha --include=/path --quality=5 \
         --threads=2 --quiet -- scene.pov",
    );
    same("scene.pov", "-- scene.pov");
    same("scene.pov --size 4x3 -o a.png -q -I x", "--size 4x3 -o a.png -q -I x -- scene.pov");
    same("+W8 scene.pov --aa 0.1", "--size=8x480 --aa 0.1 -- scene.pov");
}

#[test]
fn every_row_reads_a_well_written_option() {
    for row in ROWS {
        let value = match row.takes {
            Takes::Nothing => "",
            Takes::Number if row.ini == "Sampling_Method" => "2",
            Takes::Number | Takes::MaybeNumber => "8",
            _ if row.ini.starts_with("Dither") => "B3",
            Takes::Text if row.ini == "File_Gamma" => "sRGB",
            Takes::Text if row.ini == "Declare" => "a=1",
            Takes::Text | Takes::MaybeText => "N",
        };
        for sign in ["+", "-"] {
            if !row.switch.is_empty() {
                for switch in [row.switch.to_string(), row.switch.to_lowercase()] {
                    let word = format!("{switch}{value}");
                    let (found, rest) = find_switch(&word).unwrap();
                    assert_eq!((found.switch, rest), (row.switch, value), "{}", row.switch);
                }
                assert!(translated(words(&format!("{sign}{}{value} a.pov", row.switch))).is_some(), "{}", row.switch);
            }
        }
        if !row.ini.is_empty() {
            let value = if row.takes == Takes::Nothing { "on" } else { value };
            assert!(translated(words(&format!("{}={value} a.pov", row.ini))).is_some(), "{}", row.ini);
            assert!(translated(words(&format!("{}={value} a.pov", row.ini.to_lowercase()))).is_some(), "{}", row.ini);
        }
    }
}

/// Checks that the command line accepts all options that the table names, and all translations.
#[test]
fn translations_are_understood() {
    use clap::Parser;
    for line in [
        "+Ia.pov +MV3.1 Quality=20 --warn options -A +FE -UA +V +KFF12 +SF3 +EF0.5 +KC +STP2 +SC2 +EC0.5 +SR0.25 +ER300",
        "Input_File_Name=a.pov Antialias=on Antialias_Threshold=0.1 Output_to_File=off Declare=x=-1 Clock=-2",
        "a.pov -F +Q11 +WT1 Library_Path=\"/a\" +B4 -GA +K-0.5",
    ] {
        let words = translated(words(line)).unwrap().words;
        assert!(Cli::try_parse_from(&words).is_ok(), "{line}: {words:?}");
    }
}

#[test]
fn size_region_and_format() {
    same("+W320 a.pov", "--aa=off --size=320x480 -- a.pov");
    same("Width=320 height=200 a.pov", "--aa=off --size=320x200 -- a.pov");
    same("+W100 +H50 +SC0.25 +EC0.5 a.pov", "--aa=off --size=100x50 --region=25,0,25,50 --outside=black -- a.pov");
    same("+W100 +H50 +SC10 +EC20 +SR5 +ER6 a.pov", "--aa=off --size=100x50 --region=9,4,11,2 --outside=black -- a.pov");
    same("+W100 +H50 +SC1 +EC1 a.pov", "--aa=off --size=100x50 --region=0,0,100,50 --outside=black -- a.pov");
    same("+FT24 a.pov", "--aa=off --format=tga -- a.pov");
    same("+FPg a.pov", "--aa=off --format=ppm --gray -- a.pov");
    same("Bits_Per_Color=8 Grayscale_Output=on a.pov", "--aa=off --gray -- a.pov");
    same("+FNg Grayscale_Output=off a.pov", "--aa=off --format=png -- a.pov");
    same("+FP10 a.pov", "--aa=off --format=ppm --bit-depth=16 -- a.pov");
    same("Output_File_Type=j a.pov", "--aa=off --format=jpg -- a.pov");
    same("-F a.pov", "--aa=off --no-output -- a.pov");
    same("+UA a.pov", "--aa=off --alpha -- a.pov");
    same("+UA -UA a.pov", "--aa=off -- a.pov");
    same("+UA +FJ a.pov", "--aa=off --format=jpg -- a.pov");
}

/// First, last, start, end, step and digits of the animation.
fn frames(line: &str) -> Option<[u32; 6]> {
    let a = translated(words(&format!("{line} a.pov"))).unwrap().animation?;
    Some([a.first, a.last, a.start, a.end, a.step, a.digits as u32])
}

/// With POV-Ray's own results (quirk: `animation_of_one_frame`).
#[test]
fn animations() {
    same("+K0.5 a.pov", "--aa=off --clock=0.5 -- a.pov");
    same("+KFF3 +K0.5 a.pov", "--aa=off -- a.pov");
    for (line, expected) in [
        ("+KFF3", [1, 3, 1, 3, 1, 1]),
        ("+KFF3 +KC", [1, 4, 1, 3, 1, 1]),
        ("+KFF9 +KC", [1, 10, 1, 9, 1, 2]),
        ("+KFF10 +SF2 +EF3", [1, 10, 2, 3, 1, 2]),
        ("+KFF10 +SF0.5 +EF0.75", [1, 10, 5, 7, 1, 2]),
        ("+KFF10 +SF0.25 +EF0.75 +KC", [1, 11, 2, 8, 1, 2]),
        ("+KFI3 +KFF12 +SF0.25 +EF0.5", [3, 12, 3, 5, 1, 2]),
        ("+KFI10 +KFF19 +SF0.5 +EF0.75", [10, 19, 10, 10, 1, 2]),
        ("+KFF10 +SF9 +EF12", [1, 10, 9, 12, 1, 2]),
        ("+KFF10 +SF9 +EF1", [1, 10, 9, 9, 1, 2]),
        ("+KFF10 +SF1.6 +EF2.7", [1, 10, 1, 2, 1, 2]),
        ("+KFF100 +SF0 +EF2", [1, 100, 1, 2, 1, 3]),
        ("+KFI5", [5, 5, 5, 5, 1, 1]),
        ("+KFI4 +KFF2", [4, 4, 4, 4, 1, 1]),
        ("+KFI-2 +KFF1", [0, 1, 0, 1, 1, 1]),
        ("+KFF1", [1, 1, 1, 1, 1, 1]),
        ("+KFF4 +STP0", [1, 4, 1, 4, 1, 1]),
        ("Final_Frame=100 Frame_Step=10", [1, 100, 1, 100, 10, 3]),
    ] {
        assert_eq!(frames(line), Some(expected), "{line}");
    }
    for line in ["+KFI1 +KFF1", "+KFI0 +KFF0", "+KFI0", "+KFF0", "+KI2 +KF4", "+SF2 +EF3", "+KC"] {
        assert_eq!(frames(line), None, "{line}");
    }
    let clock = translated(words("+KFF9 +KI0.5 +KF-3 a.pov")).unwrap().animation.map(|a| a.clock);
    assert_eq!(clock, Some(Clock { first: 0.5, last: -3.0 }));
}

#[test]
fn output_names_get_the_ending_of_the_format() {
    same("+Ofoo a.pov", "--aa=off --output=foo.png -- a.pov");
    same("+Ofoo. a.pov", "--aa=off --output=foo.png -- a.pov");
    same("+Ofoo.bar +FT a.pov", "--aa=off --output=foo.bar.tga --format=tga -- a.pov");
    same("+Ofoo.tga +FN a.pov", "--aa=off --output=foo.tga.png --format=png -- a.pov");
    same("+Ofoo.jpg a.pov", "--aa=off --output=foo.jpg.png -- a.pov");
    same("+Ofoo.jpeg +FJ a.pov", "--aa=off --output=foo.jpeg.jpg --format=jpg -- a.pov");
    same("+Ofoo.tga +FC a.pov", "--aa=off --output=foo.tga --format=tga --packing=rle -- a.pov");
    same("+FC +FT a.pov", "--aa=off --format=tga -- a.pov");
    same("+Ofoo/ a.pov", "--aa=off --output=foo/ -- a.pov");
    same("+Isub/a.pov", "--aa=off --output=sub/a.png -- sub/a.pov");
    same("sub/a.pov +FT +W9", "--aa=off --size=9x480 --output=sub/a.tga --format=tga -- sub/a.pov");
    same("sub/a.pov b.pov +FT", "--aa=off --format=tga -- b.pov");
    mixes("render sub/a.pov +W9", "render --size=9x480 sub/a.pov");
    mixes("sub/a.pov --size 9x9", "render --size 9x9 -- sub/a.pov");
}

#[test]
fn quotes_around_values_are_removed() {
    same(
        "+I\"a.pov\" +W\"8\" Height='7' +O'o.png' Antialias=\"on\"",
        "--aa=0.3 --aa-method=grid --size=8x7 --output=o.png -- a.pov",
    );
    same("'a.pov' Declare=\"A=3\" Library_Path='b", "--aa=off --declare=A=3 --include=b -- a.pov");
    assert!(translated(words("+W\"x\" a.pov")).is_none());
}

#[test]
fn the_later_of_two_options_is_valid() {
    same("+Q3 +W4 +Q9 +W5 +WT1 +WT2 a.pov b.pov", "--aa=off --size=5x480 --quality=9 --threads=2 -- b.pov");
}

#[test]
fn antialiasing() {
    same("+A a.pov", "--aa=0.3 --aa-method=grid -- a.pov");
    same("+A0.1 -A a.pov", "--aa=off -- a.pov");
    same("Antialias=on Antialias_Threshold=0.2 a.pov", "--aa=0.2 --aa-method=grid -- a.pov");
    same("+A0.1 +AM2 +R4 -J a.pov", "--aa=0.1 --aa-method=corners --aa-depth=4 --aa-jitter=0 -- a.pov");
    same("+A +J0.5 -J +J +AG1.8 a.pov", "--aa=0.3 --aa-method=grid --aa-jitter=0.5 --aa-gamma=1.8 -- a.pov");
    same("+R10 +A a.pov", "--aa=0.3 --aa-method=grid --aa-depth=9 -- a.pov");
    same("Antialias_Depth=0 a.pov", "--aa=off --aa-depth=1 -- a.pov");
    same("Jitter_Amount=2 a.pov", "--aa=off --aa-jitter=1 -- a.pov");
    for line in ["+AM3", "+AG0", "+AG-1"] {
        assert!(translated(words(&format!("{line} a.pov"))).is_none(), "{line}");
    }
}

#[test]
fn dithering() {
    same("+THB2 +FG2.2 a.pov", "--aa=off --file-gamma=2.2 --dither=b2 -- a.pov");
    same("Dither=on Dither_Method=D1 File_Gamma=sRGB a.pov", "--aa=off --file-gamma=srgb --dither=d1 -- a.pov");
    same("+TH -THfs a.pov", "--aa=off -- a.pov");
    assert!(translated(words("+THx a.pov")).is_none() && translated(words("+FG0 a.pov")).is_none());
}

#[test]
fn unsupported_options_are_reported() {
    assert_eq!(ours("+UF +GD3 -GF a.pov").1, 2);
    assert_eq!(ours("Post_Scene_Command=rm a.pov").1, 1);
    assert_eq!(ours("-D -P -C -UF a.pov").1, 0);
}

#[test]
fn options_without_effect_are_reported_on_request() {
    let idle = |line: &str| translate(&Sources::default(), words(line)).idle.len();
    for (line, count) in [
        ("+D +P +X +UD +GIa.ini a.pov", 4),
        ("Display=on Pause_When_Done=on Test_Abort=on Draw_Vistas=on a.pov", 4),
        ("Display_Gamma=2.2 Palette=3 Video_Mode=1 Create_Ini=b All_File=on a.pov", 3),
        ("render All_File=on +GIa.ini a.pov", 2),
        ("-D -P -C -X -UD Display=off Verbose=off Display_Gamma= a.pov", 0),
    ] {
        assert_eq!(ours(line).1, 0, "{line}");
        assert_eq!(idle(line), count, "{line}");
    }
}

/// With POV-Ray's own results (quirk: `option_numbers`).
#[test]
fn numbers_end_at_the_first_other_character() {
    same("Height=693.0412871 Width=12abc a.pov", "--aa=off --size=12x693 -- a.pov");
    same("+H12.7 +W1e2 a.pov", "--aa=off --size=1x12 -- a.pov");
    same("+H6 +W+8 a.pov", "--aa=off --size=8x6 -- a.pov");
    same("Clock=0.5abc +Q12 Work_Threads=1.5 a.pov", "--aa=off --clock=0.5 --quality=11 --threads=1 -- a.pov");
    same(
        "+A0.1x Quality=-1 Bits_Per_Color=16.0 a.pov",
        "--aa=0.1 --aa-method=grid --bit-depth=16 --quality=0 -- a.pov",
    );
    assert_eq!(frames("+KFI2.7 +KFF3x"), Some([2, 3, 2, 3, 1, 1]));
    for line in ["Height=abc", "Height=", "Height=.5e2", "+W", "Clock=abc", "Quality=abc", "Version=abc"] {
        assert!(translated(words(&format!("{line} a.pov"))).is_none(), "{line}");
    }
}

#[test]
fn version_sets_the_language() {
    same("+MV3.1 a.pov", "--aa=off --language=3.1 -- a.pov");
    same("Version=3.5 -MV3.62x a.pov", "--aa=off --language=3.62 -- a.pov");
    same("Version=0.9 a.pov", "--aa=off --language=1 -- a.pov");
}

#[test]
fn unknown_options_are_errors_with_a_guess() {
    let message = |line: &str| match &translate(&Sources::default(), words(line)).diagnostics[..] {
        [fault] => format!("{} | {}", fault.message, fault.help.clone().unwrap_or_default()),
        other => format!("{other:?}"),
    };
    assert_eq!(message("a.pov Widht=3"), "there is no option `Widht=3` | did you mean `Width=3`?");
    assert_eq!(message("a.pov +Antialais"), "there is no option `+Antialais` | did you mean `Antialias=`?");
    assert!(message("a.pov -banana").starts_with("there is no option `-banana`"));
    assert_eq!(message("a.pov +W"), "`+W` is invalid: it needs a number | ");
    assert!(message("a.pov +W0").contains("1 or more"));
    assert!(message("a.pov +FX").contains("types are"));
}

#[test]
fn help_is_printed_for_a_single_word() {
    assert_eq!(translate(&Sources::default(), words("+h")).words, ["durer", "--help"]);
    assert_eq!(translate(&Sources::default(), words("-?")).words, ["durer", "--help"]);
}

#[test]
fn all_lines_of_a_link_named_povray_are_povrays() {
    let translate = |line: &str| {
        let words = ["/tmp/bin/povray"].into_iter().chain(line.split_whitespace()).map(OsString::from).collect();
        translate(&Sources::default(), words)
    };
    for line in ["a.pov", "-V a.pov", "a"] {
        let Translated { words, is_povray_line, diagnostics, .. } = translate(line);
        assert!(is_povray_line && diagnostics.is_empty() && words.contains(&"--aa=off".into()), "{line} {words:?}");
    }
    for line in ["", "-V -D", "+W8"] {
        let Translated { is_povray_line, diagnostics, .. } = translate(line);
        assert!(is_povray_line, "{line}");
        assert_eq!(diagnostics.iter().map(|d| d.code).collect::<Vec<_>>(), [codes::NO_SCENE], "{line}");
    }
    assert!(!translate("check a.pov").is_povray_line);
}

#[test]
fn progress_is_printed_unless_it_is_turned_off() {
    same("a.pov +V", "--aa=off --progress=always -- a.pov");
    same("-V a.pov", "--aa=off --progress=never -- a.pov");
    same("a.pov +V Verbose=off", "--aa=off --progress=never -- a.pov");
}

#[test]
fn command_lines_of_durer_are_unchanged() {
    for line in [
        "",
        "--help",
        "-h",
        "-V",
        "-q -V",
        "render a.scene",
        "-q render a.scene",
        "--color never check a.scene",
        "test a.scene",
    ] {
        assert_eq!(mixed::command_line_form(&words(line)), Form::Durer, "{line}");
    }
    for line in [
        "a.scene",
        "+Ia.pov",
        "Width=4",
        "-D a.pov",
        "-q a.scene",
        "--size 4x3 a.scene",
        "+W4 render a.scene",
        "-V -D a.pov",
    ] {
        assert_eq!(mixed::command_line_form(&words(line)), Form::Povray, "{line}");
    }
    for line in ["render a.scene +W4", "render -D a.scene", "-q check a.scene Width=4", "pick a.scene 1,2 -A"] {
        assert!(matches!(mixed::command_line_form(&words(line)), Form::Mixed(_)), "{line}");
    }
    for line in
        ["render a.scene -o +W4", "render --declare Width=4 a.scene", "render a.scene -- +W4", "render -o=+W a.scene"]
    {
        assert_eq!(mixed::command_line_form(&words(line)), Form::Durer, "{line}");
    }
}

/// Checks the translation of a command line that mixes durer's and POV-Ray's options.
#[track_caller]
fn mixes(line: &str, expected: &str) {
    let words = translated(words(line)).unwrap().words;
    let words: Vec<_> = words[1..].iter().map(|w| w.to_str().unwrap()).collect();
    assert_eq!(words.join(" "), expected, "{line}");
}

#[test]
fn povray_options_precede_durers() {
    mixes("render a.scene +W32", "render --size=32x480 a.scene");
    mixes("render a.scene +W32 --size 8x6 -A +Q3 +WT4 -j 2", "render --aa=off --quality=3 a.scene --size 8x6 -j 2");
    mixes("render a.scene +Oa.ppm -ob.png +La -Ib", "render --include=a a.scene -ob.png -Ib");
    mixes("-q check a.scene +W32 +A0.1 -P", "-q check --size=32x480 a.scene");
    mixes("+W32 check a.scene +A0.1", "check --size=32x480 -- a.scene");
    mixes("a.scene b.scene --size 8x6", "render --size 8x6 -- a.scene b.scene");
    mixes("a.scene +Ib.scene", "render --aa=off -- b.scene");
}

#[test]
fn text_files_are_beside_the_picture() {
    let files = |line: &str| {
        let output = translated(words(line)).unwrap().text_output;
        output.files.into_iter().map(|(_, path)| path.display().to_string()).collect::<Vec<_>>().join(" ")
    };
    assert_eq!(files("+Ia.pov +GA"), "");
    assert_eq!(files("+Ia.pov +GAall -GDb All_File=c"), "b c");
    assert_eq!(files("+Ia.pov All_File= Debug_File=on Fatal_File=off"), "alltext.out debug.out");
    assert_eq!(files("+Isub/a.pov Render_File=true +GSs Warning_File=w"), "sub/render.out sub/s sub/w");
    assert_eq!(files("+Isub/a.pov +Oother/ +GAall"), "other/all");
    // A command of durer has no text files.
    assert_eq!(files("render a.pov All_File=b"), "");
    for name in ["sub/b", "/tmp/b", "../b"] {
        assert!(translated(words(&format!("+Ia.pov All_File={name}"))).is_none(), "{name}");
    }
}

#[test]
fn streams_are_silenced_one_by_one() {
    let silent = |line: &str| translated(words(line)).unwrap().text_output.silent;
    assert_eq!(silent("+Ia.pov -GD Warning_Console=off"), [Stream::Debug, Stream::Warning]);
    assert_eq!(ours("+Ia.pov -GF"), ("--aa=off -- a.pov".to_string(), 1));
    assert_eq!(ours("render a.pov -GD").1, 1);
}

#[test]
fn a_created_ini_file_states_all_settings() {
    let line = "+Ia.pov +GIq.ini +A0.2 +FN16 +GAall +L/b +L/a Declare=B=1 declare=A=2 -D +W8 +W9 -GD";
    let (path, text) = translated(words(line)).unwrap().text_output.ini.unwrap();
    let expected = "All_Console=On\nAll_File=\"all\"\nAntialias=On\nAntialias_Threshold=0.2\nBits_Per_Color=16\n\
                    Create_Ini=\"q.ini\"\nDebug_Console=Off\nDeclare=B=1\nDeclare=A=2\nDisplay=Off\nHeight=480\n\
                    Input_File_Name=\"a.pov\"\nLibrary_Path=\"/b\"\nLibrary_Path=\"/a\"\nOutput_File_Type=N\n\
                    Output_to_File=On\nWidth=9\n";
    assert_eq!((path, text.as_str()), (PathBuf::from("q.ini"), expected));
}

#[test]
fn devices_and_standard_output_are_written_directly() {
    same("+Ia.pov +O/dev/stdout", "--aa=off --output=- -- a.pov");
    same("+Ia.pov +O/dev/null", "--aa=off --output=/dev/null --format=png -- a.pov");
    same("+Ia.pov +O/dev/null +FT", "--aa=off --output=/dev/null --format=tga -- a.pov");
}
