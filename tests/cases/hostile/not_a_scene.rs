//! Files that are not text, and texts that are not scenes.

use super::limited_run::{Case, case, drawn};

/// All cases.
pub fn cases() -> Vec<Case> {
    [bytes(), syntax(), words(), includes()].into_iter().flatten().collect()
}

/// Deterministic random bytes.
fn noise(len: usize) -> Vec<u8> {
    let mut rng = crate::mutate::Rng::new(1525);
    (0..len).map(|_| rng.next() as u8).collect()
}

fn bytes() -> Vec<Case> {
    let utf16 = |text: &str, mark: u16, order: fn(u16) -> [u8; 2]| -> Vec<u8> {
        std::iter::once(mark).chain(text.encode_utf16()).flat_map(order).collect()
    };
    let elf = [b"\x7fELF\x02\x01\x01".as_slice(), &[0; 100]].concat();
    let far_zero = ["// ".to_string().repeat(10_000).as_bytes(), b"\nsphere { 0, 1 }\0\n"].concat();
    vec![
        case("random_bytes", noise(5000), 1, &["E0001", "a.scene:1:1"]),
        case("latin_noise", noise(5000).iter().map(|b| b | 0x80).collect::<Vec<_>>(), 1, &["E0100", "a.scene:1:1"]),
        case("elf", elf, 1, &["E0001", "a program", "a.scene:1:1"]),
        case("c_loop_to_the_last_number", "for (i = 0; i > 9223372036854775807; i--)", 1, &["E0100", "#for"]),
        case("utf16_le", utf16("sphere { 0, 1 }", 0xfeff, u16::to_le_bytes), 1, &["E0001", "UTF-16", "a.scene:1:1"]),
        case("utf16_be", utf16("sphere { 0, 1 }", 0xfeff, u16::to_be_bytes), 1, &["E0001", "UTF-16", "a.scene:1:1"]),
        case("nul_bytes", vec![0; 1000], 1, &["E0001", "a.scene:1:1"]),
        case("nul_far_away", far_zero, 0, &["W0206"]),
        case("nul_in_include", "#include \"b.inc\"", 1, &["E0231", "a.scene:1:10"]).with("b.inc", [0; 10]),
        drawn("utf8_mark", "\u{feff}sphere { 0, 1 }", 0, &[]),
        drawn("control_z", "sphere { 0, 1 }\x1a", 0, &[]),
        case("empty", "", 0, &["W0206"]),
        case("blank", "\n\r\n\t \r", 0, &["W0206"]),
        case("only_a_comment", "// nothing", 0, &["W0206"]),
        case("half_utf8", b"sphere { 0, 1 } \xc3".to_vec(), 1, &["E0100", "a.scene:1:17"]),
        case("mark_inside", "camera { location <0, 2, - hollow  \u{feff} \u{feff}", 1, &["a.scene:1:"]),
        case("mark_before_fault", "sphere { 0, -\u{feff}}", 1, &["a.scene:1:"]),
        case("emoji", "sphere { 0, 1 } 🎨", 1, &["E0100", "a.scene:1:17"]),
        case("carriage_returns", "sphere { 0, 1 }\r\rbox { }\r", 1, &["a.scene:3:"]),
    ]
}

fn syntax() -> Vec<Case> {
    vec![
        case("unclosed_brace_error", "sphere { 0, 1", 1, &["E0101", "a.scene:1:8"]),
        case("open_string", "#debug \"never ends\n\n", 1, &["E0101", "a.scene:1:8"]),
        case("open_string_escape", "#debug \"\\", 1, &["E0101", "a.scene:1:8"]),
        case("open_comment", "/* never /* ends */\n", 1, &["E0101", "a.scene:1:1"]),
        case("open_paren", "#declare A = (1 + 2;\n", 1, &["E0101", "a.scene:1:14"]),
        case("open_bracket", "#declare A = array[3 ;\n", 1, &["E0101", "a.scene:1:19"]),
        case("open_vector", "#declare A = <1, 2;\n", 1, &["a.scene:1:"]),
        case("open_if", "#if (1)\nsphere { 0, 1 }\n", 1, &["E0101", "a.scene:1:1"]),
        case("open_macro", "#macro A()\nsphere { 0, 1 }\n", 1, &["E0101", "a.scene:1:1"]),
        case("open_while", "#while (0)\n", 1, &["E0101", "a.scene:1:1"]),
        case("open_switch", "#switch (0)\n#case (1)\n", 1, &["E0101", "a.scene:1:1"]),
        case("open_else", "#if (1)\n#else\n", 1, &["E0101", "a.scene:1:1"]),
        case("stray_brace", "}\n", 1, &["E0102", "a.scene:1:1"]),
        case("stray_end", "\n#end\n", 1, &["E0102", "a.scene:2:1"]),
        case("stray_else", "\n #else\n", 1, &["E0102", "a.scene:2:2"]),
        case("swapped", "sphere { (0, 1 } )\n", 1, &["a.scene:1:10"]),
        case("half_directive", "#declare", 1, &["a.scene:1:"]),
        case("half_declare", "#declare A =", 0, &["E0205", "a.scene:1:13"]),
        case("lone_hash", "#", 0, &["W0206"]),
        case("lone_operators", "+ * / ? : ! = < >", 1, &["a.scene:1:"]),
        case("many_closers", "}".repeat(100_000), 1, &["E0102", "a.scene:1:1"]),
        case("many_angles", "<".repeat(100_000), 1, &["a.scene:1:"]),
        case("many_questions", format!("#declare A = (1 {})", "? 1 ".repeat(100_000)), 1, &["a.scene:1:"]),
        case("many_hashes", "#".repeat(100_000), 0, &[]),
        case("many_quotes", "\"".repeat(100_001), 1, &["a.scene:1:"]),
        case("many_backslashes", "\\".repeat(100_000), 1, &["a.scene:1:1"]),
        case("many_semicolons", ";".repeat(100_000), 0, &["W0206"]),
        case("many_commas", ",".repeat(100_000), 0, &["W0206"]),
        case("many_function_parens", "function ".to_string() + &") {".repeat(50_000), 1, &["a.scene:1:"]),
        case("many_unknown_directives", "#foo ".repeat(100_000), 1, &["E0103", "a.scene:1:1"]),
        case("one_long_line", "sphere { 0, 1 } ".repeat(20_000) + "x_", 1, &["E0203", "a.scene:1:320001"]),
    ]
}

fn words() -> Vec<Case> {
    vec![
        case("unknown_block", "sphear { 0, 1 }\n", 1, &["a.scene:1:1", "did you mean `sphere`?"]),
        case("unknown_word", "sphere { 0, 1 raduis 3 }\n", 1, &["a.scene:1:15"]),
        case("unknown_name", "sphere { 0, Radius }\n", 1, &["E0203", "a.scene:1:13"]),
        case("wrong_word", "sphere { 0, 1 major_radius 3 }\n", 1, &["E0204", "a.scene:1:15"]),
        case("text_as_radius", "sphere { 0, \"one\" }\n", 1, &["E0200", "a.scene:1:13"]),
        case("vector_as_radius", "sphere { 0, <1, 2> }\n", 1, &["E0200", "a.scene:1:13"]),
        case(
            "thing_as_number",
            "#declare S = sphere { 0, 1 }\n#declare A = S + 1;\nsphere { 0, A }\n",
            1,
            &["a.scene:2:14"],
        ),
        case("number_as_text", "#debug 5\n", 1, &["E0200", "a.scene:1:8"]),
        case("two_components", "sphere { <1, 2>, 1 rotate <1, 2, 3, 4> }\n", 1, &["a.scene:1:27"]),
        case("six_components", "sphere { <1, 2, 3, 4, 5, 6>, 1 }\n", 1, &["E0202", "a.scene:1:10"]),
        case(
            "many_components",
            format!("sphere {{ <{}1>, 1 }}\n", "1, ".repeat(100_000)),
            1,
            &["E0202", "a.scene:1:10"],
        ),
        case("no_components", "sphere { <>, 1 }\n", 1, &["a.scene:1:1"]),
        case("too_few_values", "box { 0 }\n", 1, &["a.scene:1:"]),
        case("too_many_values", "sphere { 0, 1, 2, 3 }\n", 1, &["a.scene:1:"]),
        case("missing_component", "#declare A = <1, 2, 3>.t;\nsphere { 0, A }\n", 1, &["E0206", "a.scene:1:24"]),
        case("wrong_arguments", "#macro A(B) B #end\nsphere { 0, A(1, 2) }\n", 1, &["E0202", "a.scene:2:"]),
        case("declares_keyword", "#declare sphere = 1;\n", 1, &["a.scene:1:10"]),
        case("error_in_scene", "#error \"I give up\"\n", 1, &["E0234", "I give up", "a.scene:1:8"]),
        case("many_errors", "boxx { }\n".repeat(10_000), 1, &["20 errors", "a.scene:1:1"]),
        case("version_zero", "#version 0;\n", 0, &[]),
        case("version_negative", "#version -1;\n", 0, &[]),
        case("version_huge", "#version 1e300;\n", 0, &["W0204", "a.scene:1:"]),
        case("version_nan", "#version 0/0;\n", 0, &["W0204", "a.scene:1:10"]),
        case("version_text", "#version \"new\";\n", 1, &["E0200", "a.scene:1:10"]),
        case("version_missing", "#version\n", 1, &["a.scene:2:1"]),
        case("settings_unknown", "global_settings { gammma 1 }\n", 1, &["a.scene:1:19"]),
        case("settings_text", "global_settings { assumed_gamma \"x\" }\n", 1, &["E0200", "a.scene:1:33"]),
        drawn("settings_gamma_zero", "global_settings { assumed_gamma 0 }\n", 1, &["a.scene:1:33"]),
        drawn("settings_gamma_negative", "global_settings { assumed_gamma -2.2 }\n", 1, &["a.scene:1:33"]),
        drawn("settings_gamma_huge", "global_settings { assumed_gamma 1e300 }\nsphere { 0, 1 }", 0, &[]),
        drawn("settings_levels", "global_settings { max_trace_level -5 adc_bailout -1 }\nsphere { 0, 1 }", 0, &[]),
        case("settings_nan", "global_settings { max_trace_level 0/0 }\n", 1, &["a.scene:1:35"]),
        case("settings_infinite", "global_settings { adc_bailout 1/0 }\n", 1, &["a.scene:1:31"]),
        case("settings_nothing", "global_settings { }\n", 0, &["W0206"]),
    ]
}

fn includes() -> Vec<Case> {
    let to_b = "#include \"b.inc\"\n";
    vec![
        case("include_missing", "\n#include \"nowhere.inc\"\n", 1, &["E0230", "a.scene:2:10"]),
        case("include_empty_name", "#include \"\"\n", 1, &["a.scene:1:10"]),
        case("include_missing_in_block", "plane {\n#include \"nowhere.inc\"\ny, 0 }\n", 1, &["E0230", "a.scene:2:10"]),
        case("include_number", "#include 5\n", 1, &["E0200", "a.scene:1:10"]),
        case("include_itself", "#include \"a.scene\"\n", 4, &["E0244", "a.scene:1:1"]),
        case("include_mutual", to_b, 4, &["E0244", "b.inc:1:1"])
            .with("b.inc", "#include \"c.inc\"")
            .with("c.inc", "\n #include \"b.inc\""),
        case("include_folder", "#include \"..\"\n", 1, &["a.scene:1:10"]),
        case("include_device", "#include \"/dev/null\"\n", 1, &["a.scene:1:10"]),
        case("include_endless_device", "#include \"/dev/zero\"\n", 1, &["a.scene:1:10"]),
        case("include_broken", to_b, 1, &["E0101", "b.inc:2:8"]).with("b.inc", "\nsphere { 0, 1"),
        case("include_ends_block", "sphere { 0, #include \"b.inc\"\n", 0, &["W0206"]).with("b.inc", "1 }"),
        case("include_in_macro", "#macro A() #include \"b.inc\" #end\nA()", 1, &["E0203", "b.inc:1:13", "a.scene:2:1"])
            .with("b.inc", "sphere { 0, Radius }"),
        case("include_long_name", format!("#include \"{}\"\n", "x".repeat(100_000)), 1, &["E0230", "a.scene:1:10"]),
        case("include_nul_name", "#include \"a\\u0000b\"\n", 1, &["a.scene:1:10"]),
        case("include_many", "#include \"b.inc\"\n".repeat(20_000), 0, &[]).with("b.inc", "#declare A = 1;"),
    ]
}
