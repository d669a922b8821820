//! `durer fmt`: a file with faults stays unchanged, and no file takes long.

use super::limited_run::{Case, case};

pub fn cases() -> Vec<Case> {
    let fmt = |case: Case| case.args("fmt --check a.scene");
    let refused = |name, scene: Vec<u8>, told| fmt(case(name, scene, 1, told));
    let taken = |name, scene: String, exit| fmt(case(name, scene, exit, &[]));
    let one_line = "union{".repeat(60) + &"sphere{0,1 pigment{rgb 1}}".repeat(2000) + &"}".repeat(60);
    let branches = format!("#if(1){}#end", "#elseif(0) 1 ".repeat(50_000));
    vec![
        taken("fmt_nothing", String::new(), 0),
        taken("fmt_blanks", " \r\n\t\n\n".into(), 1),
        taken("fmt_closing_braces", "}".repeat(50_000), 1),
        taken("fmt_signs", format!("#declare A={}1;", "-".repeat(300_000)), 1),
        taken("fmt_sum", format!("#declare A=1{};", "+1*2".repeat(100_000)), 1),
        taken("fmt_vector", format!("#declare V=<{}1>;", "1,".repeat(500_000)), 1),
        taken("fmt_one_line", one_line, 1),
        taken("fmt_words", "a ".repeat(200_000), 1),
        taken("fmt_one_word", "a".repeat(3_000_000), 1),
        taken("fmt_line_comments", "//x\n".repeat(200_000), 0),
        taken("fmt_block_comments", "/*x*/".repeat(100_000), 1),
        taken("fmt_branches", branches, 1),
        refused("fmt_bytes", (0..=255).collect(), &["E0001", "`a.scene`"]),
        refused("fmt_endless_string", b"#declare A=\"abc".to_vec(), &["E0101", "a.scene:1:12", "is unchanged"]),
        refused("fmt_endless_comment", b"/* abc".to_vec(), &["E0101", "is unchanged"]),
        refused("fmt_endless_if", b"#if (1)\nsphere{0,1}".to_vec(), &["E0101", "is unchanged"]),
        refused("fmt_deep_blocks", "union{".repeat(100_000).into(), &["E0104", "is unchanged"]),
        refused("fmt_deep_vectors", "<".repeat(100_000).into(), &["E0104", "is unchanged"]),
        refused("fmt_deep_macros", "#macro A()".repeat(3000).into(), &["E0104", "is unchanged"]),
        fmt(case("fmt_absent", "", 5, &["a.scene"]).absent()),
        case("fmt_folder_without_scenes", "", 2, &["no file in `.`"]).absent().args("fmt ."),
    ]
}
