use super::*;

fn words(line: &str) -> Vec<OsString> {
    std::iter::once("durer").chain(line.split_whitespace()).map(OsString::from).collect()
}

/// What a line becomes, without `durer render`, and how many warnings there are.
fn ours(line: &str) -> (String, usize) {
    let (words, warnings) = translate(words(line)).unwrap();
    let words: Vec<_> = words[2..].iter().map(|w| w.to_str().unwrap()).collect();
    (words.join(" "), warnings.len())
}

#[track_caller]
fn same(line: &str, expected: &str) {
    assert_eq!(ours(line), (expected.to_string(), 0), "{line}");
}

#[test]
fn a_whole_line() {
    same(
        "+Iscene.pov +W640 +H480 +A0.3 -D -P +Ofoo.png +FN16 +L/path +Q5 +WT2 +UA -GA",
        "--aa=0.3 --size=640x480 --output=foo.png --format=png --bit-depth=16 --include=/path --quality=5 --threads=2 \
         --alpha --quiet -- scene.pov",
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
            Takes::Number | Takes::MaybeNumber => "8",
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
                assert!(translate(words(&format!("{sign}{}{value} a.pov", row.switch))).is_ok(), "{}", row.switch);
            }
        }
        if !row.ini.is_empty() {
            let value = if row.takes == Takes::Nothing { "on" } else { value };
            assert!(translate(words(&format!("{}={value} a.pov", row.ini))).is_ok(), "{}", row.ini);
            assert!(translate(words(&format!("{}={value} a.pov", row.ini.to_lowercase()))).is_ok(), "{}", row.ini);
        }
    }
}

/// Every option of ours that the table names is taken by the command line, and every translation is understood.
#[test]
fn translations_are_understood() {
    use clap::Parser;
    for line in [
        "+Ia.pov -A +FE -UA +V +KFF12 +SF3 +EF0.5 +KC +STP2 +SC2 +EC0.5 +SR0.25 +ER300",
        "Input_File_Name=a.pov Antialias=on Antialias_Threshold=0.1 Output_to_File=off Declare=x=-1 Clock=-2",
        "a.pov -F +Q11 +WT1 Library_Path=\"/a\" +B4 -GA +K-0.5",
    ] {
        let (words, _) = translate(words(line)).unwrap();
        assert!(Cli::try_parse_from(&words).is_ok(), "{line}: {words:?}");
    }
}

#[test]
fn size_region_and_format() {
    same("+W320 a.pov", "--aa=off --size=320x480 -- a.pov");
    same("Width=320 height=200 a.pov", "--aa=off --size=320x200 -- a.pov");
    same("+W100 +H50 +SC0.25 +EC0.5 a.pov", "--aa=off --size=100x50 --region=25,0,25,50 -- a.pov");
    same("+W100 +H50 +SC10 +EC20 +SR5 +ER6 a.pov", "--aa=off --size=100x50 --region=9,4,11,2 -- a.pov");
    same("+W100 +H50 +SC1 +EC1 a.pov", "--aa=off --size=100x50 --region=0,0,100,50 -- a.pov");
    same("+FT24 a.pov", "--aa=off --format=tga -- a.pov");
    same("+FP10 a.pov", "--aa=off --format=ppm --bit-depth=16 -- a.pov");
    same("Output_File_Type=j a.pov", "--aa=off --format=jpg -- a.pov");
    same("-F a.pov", "--aa=off --no-output -- a.pov");
}

#[test]
fn animation() {
    same("+K0.5 a.pov", "--aa=off --clock=0.5 -- a.pov");
    same("+KFI1 +KFF10 a.pov", "--aa=off --frames=1-10:1 --clock=0..1 -- a.pov");
    same(
        "+KFF12 +SF3 +EF0.5 a.pov",
        &format!("--aa=off --frames=3-06:1 --clock={}..{} -- a.pov", 2.0 / 11.0, 5.0 / 11.0),
    );
    same("+KFF4 +KC +KF8 a.pov", "--aa=off --frames=1-4:1 --clock=0..6 -- a.pov");
    same("Final_Frame=100 Frame_Step=10 a.pov", "--aa=off --frames=1-100:10 --clock=0..1 -- a.pov");
}

#[test]
fn antialiasing() {
    same("+A a.pov", "--aa=0.3 -- a.pov");
    same("+A0.1 -A a.pov", "--aa=off -- a.pov");
    same("Antialias=on Antialias_Threshold=0.2 a.pov", "--aa=0.2 -- a.pov");
    assert_eq!(ours("+A0.1 +AM2 +R3 -J a.pov"), ("--aa=0.1 -- a.pov".into(), 2));
}

#[test]
fn what_is_not_obeyed_is_told() {
    assert_eq!(ours("+D +P +C a.pov").1, 3);
    assert_eq!(ours("Post_Scene_Command=rm a.pov").1, 1);
    assert_eq!(ours("-D -P -C -UF a.pov").1, 0);
}

#[test]
fn unknown_options_are_errors_with_a_guess() {
    let message = |line: &str| match translate(words(line)) {
        Err(super::super::Failure::Fault(fault)) => format!("{} | {}", fault.message, fault.help.unwrap_or_default()),
        other => format!("{other:?}"),
    };
    assert_eq!(message("a.pov Widht=3"), "there is no option `Widht=3` | did you mean `Width=3`?");
    assert_eq!(message("a.pov +Antialais"), "there is no option `+Antialais` | did you mean `Antialias=`?");
    assert!(message("a.pov -banana").starts_with("there is no option `-banana`"));
    assert_eq!(message("a.pov +W"), "`+W` is not understood: it needs a number | ");
    assert!(message("a.pov +W0").contains("1 or more"));
    assert!(message("a.pov +FX").contains("types are"));
}

#[test]
fn help_is_given_when_it_is_the_only_word() {
    assert_eq!(translate(words("+h")).unwrap().0, ["durer", "--help"]);
    assert_eq!(translate(words("-?")).unwrap().0, ["durer", "--help"]);
}

#[test]
fn our_own_command_lines_are_left_alone() {
    for line in
        ["", "--help", "-h", "render a.scene", "-q render a.scene", "--color never check a.scene", "rendr a.scene"]
    {
        assert!(is_ours(&words(line)), "{line}");
    }
    for line in ["a.scene", "+Ia.pov", "Width=4", "-D a.pov", "-q a.scene"] {
        assert!(!is_ours(&words(line)), "{line}");
    }
}
