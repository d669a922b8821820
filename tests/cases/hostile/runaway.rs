//! Texts without end, and texts with huge nesting or growth.

use super::limited_run::{Case, case, drawn, nested};

/// Far more than in any real scene.
const DEEP: usize = 100_000;
const LONG: usize = 1_000_000;
/// A low limit on steps.
const SOON: &str = "check a.scene --max-steps 20000";
const FEW_STEPS: &str = "render a.scene -o out.png --size 8x6 --max-steps 1000000";

/// 4 GB of numbers.
/// Radiosity that takes a sample at almost every point of the picture.
const MANY_SAMPLES: &str =
    "global_settings { radiosity { pretrace_start 0.00125 pretrace_end 0.00125 count 1 nearest_count 1 \
    error_bound 0.001 recursion_limit 1 minimum_reuse 1e-6 maximum_reuse 1e-5 } }
    sphere { 0, 9 pigment { rgb 1 } finish { ambient 0.1 diffuse 0.7 } }";
const LARGE_PICTURE: &str = "box { 0, 1 pigment { image_map { function 16384, 16384 { x } } } }";

/// All cases.
pub fn cases() -> Vec<Case> {
    [endless(), growing(), deep(), long(), many(), media()].into_iter().flatten().collect()
}

fn endless() -> Vec<Case> {
    let mutual = "#macro A() B() #end\n#macro B() A() #end\nA()\n";
    vec![
        case("macro_calls_itself", "#macro A() A() #end\nA()\n", 4, &["E0243", "a.scene:1:12", "a.scene:2:1"]),
        case("macros_call_each_other", mutual, 4, &["E0243", "a.scene:1:12", "a.scene:3:1"]),
        case("macro_as_operand", "#macro A(X) 1 + A(X + 1) #end\n#declare B = A(1);\n", 4, &["E0243", "a.scene:1:17"]),
        case("macro_in_block", "#macro A() union { A() } #end\nA()\n", 4, &["E0243", "a.scene:1:20"]),
        case("macro_as_argument", "#macro A(X) A(A(X)) #end\nA(1)\n", 4, &["E0243", "a.scene:1:"]),
        case("macro_that_branches", "#macro A() A() A() #end\nA()\n", 4, &["E0243", "a.scene:1:"]),
        case("while_endless", "#while (1)\n#end\n", 4, &["E0240", "a.scene:1:"]).args(FEW_STEPS),
        case("while_inside", "union { #while (1) #while (0) #end #end }\n", 4, &["E0240", "a.scene:1:"])
            .args(FEW_STEPS),
        case("while_time", "#while (1)\n#end\n", 4, &["E0241", "a.scene:1:"]).args("check a.scene --max-time 0.5"),
        case("for_tiny_step", "#for (I, 0, 1e9, 1e-9)\n#end\n", 4, &["E0240", "a.scene:1:"]).args(FEW_STEPS),
        case("for_step_lost_in_rounding", "#for (I, 1e20, 2e20)\n#end\n", 4, &["E0240"]).args(FEW_STEPS),
        case("for_zero_step", "#for (I, 0, 1, 0)\n#end\n", 1, &["E0233", "a.scene:1:16"]),
        case("for_denormal_step", "#for (I, 0, 1, 1e-308)\n#end\n", 1, &["E0233", "a.scene:1:16"]),
        case("for_nan_step", "#for (I, 0, 1, 0/0)\n#end\n", 0, &["W0200", "a.scene:1:18"]),
        case("for_nan_bounds", "#for (I, 0/0, 0/0)\n#end\n", 4, &["E0240", "a.scene:1:"]).args(FEW_STEPS),
        case("for_infinite", "#for (I, 0, 1/0)\n#end\n", 4, &["E0240", "a.scene:1:"]).args(FEW_STEPS),
        case("for_turned_back", "#for (I, 0, 9)\n#declare I = 0;\n#end\n", 4, &["E0240", "a.scene:"]).args(FEW_STEPS),
        case("for_counter_is_text", "#for (I, 0, 9)\n#declare I = \"x\";\n#end\n", 1, &["E0200", "a.scene:1:"]),
        case("for_counter_is_gone", "#for (I, 0, 9)\n#undef I\n#end\n", 1, &["a.scene:"]),
        case("error_in_endless_loop", "#while (1)\nboxx { }\n#end\n", 1, &["a.scene:2:1"]).args(FEW_STEPS),
    ]
}

/// Media and interiors with numbers that no picture needs.
fn media() -> Vec<Case> {
    const LIMITED: &str = "render a.scene -o out.png --size 8x6 --threads 2 --max-time 0.5";
    let smoke =
        |words: &str| format!("sphere {{ 0, 1 pigment {{ rgbt 1 }} hollow interior {{ media {{ {words} }} }} }}");
    let nested: String = (1..65)
        .map(|i| format!("sphere {{ 0, {i} pigment {{ rgbt 1 }} hollow interior {{ media {{ emission 0.01 }} }} }}\n"))
        .collect();
    vec![
        drawn(
            "media_many_intervals",
            smoke("emission 1 intervals 999999 samples 999999 density { bozo }"),
            4,
            &["E0241"],
        )
        .args(LIMITED),
        drawn("media_many_samples", smoke("method 1 scattering { 1, 1 } samples 1, 999999 variance -1"), 4, &["E0241"])
            .args(LIMITED),
        drawn(
            "media_many_levels",
            smoke("emission 1 aa_level 999999 aa_threshold 1e-300 density { granite }"),
            4,
            &["E0241"],
        )
        .args(LIMITED),
        drawn("media_not_numbers", smoke("emission 0/0 absorption 1/0 density { function { 0/0 } }"), 0, &[]),
        drawn("media_nested", nested, 0, &[]),
        drawn(
            "dispersion_of_many_colours",
            "sphere { 0, 1 pigment { rgbt 1 } interior { ior 1.5 dispersion 1.1 dispersion_samples 4294967296 } }",
            0,
            &[],
        ),
    ]
}

fn growing() -> Vec<Case> {
    let doubling = "#declare S = \"ab\";\n#while (1)\n#declare S = concat(S, S);\n#end\n";
    let held = "#declare S = \"0123456789abcdef\";\n#for (I, 1, 18) #declare S = concat(S, S); #end\n\
                #macro M(T)\n #local U = concat(T, \"x\");\n M(U)\n#end\nM(S)\n";
    let limited = "check a.scene --max-memory 120M";
    vec![
        case("string_doubles", doubling, 4, &["E0242", "a.scene:3:14"]),
        case("strings_held", held, 4, &["E0242", "a.scene:"]),
        case("strings_held_limited", held, 4, &["E0242", "a.scene:4:"]).args(limited),
        case("things_without_end", "#while (1)\nsphere { 0, 1 }\n#end\n", 4, &["E0242", "a.scene:"]),
        case("things_without_end_limited", "#while (1)\nsphere { 0, 1 }\n#end\n", 4, &["E0242", "a.scene:"]).args(limited),
        case("union_without_end", "union {\n#while (1)\nsphere { 0, 1 }\n#end\n}\n", 4, &["E0242", "a.scene:"]).args(limited),
        case("lights_without_end", "#while (1)\nlight_source { 0, 1 }\n#end\n", 4, &["E0242", "a.scene:"]).args(limited),
        case("polygon_without_end", "polygon { 1e9,\n#while (1)\n<0, 0>,\n#end\n}\n", 4, &["E0242"]).args(limited),
        case("map_without_end", "#declare P = pigment { gradient x color_map {\n#while (1)\n[0 rgb 1]\n#end\n} }\n", 4, &["E0242"])
            .args(limited),
        case("textures_without_end", "sphere { 0, 1\n#while (1)\ntexture { pigment { rgb 1 } }\n#end\n}\n", 4, &["a.scene:"])
            .args(FEW_STEPS),
        case("union_doubles", "#declare A = sphere { 0, 1 }\n#while (1)\n#declare A = union { object { A } object { A } }\n#end\n", 4, &["a.scene:"])
            .args(SOON),
        case("difference_grows", "#declare A = sphere { 0, 1 }\n#while (1)\n#declare A = difference { object { A } sphere { 0, 1 } }\n#end\n", 4, &["E0240", "E0104", "a.scene:3:"])
            .args(SOON),
        drawn("function_picture_too_large", LARGE_PICTURE, 4, &["E0242", "a.scene:1:43"]),
        drawn("function_picture_limited", LARGE_PICTURE, 4, &["E0242", "a.scene:1:43"])
            .args("render a.scene -o out.png --size 8x6 --max-memory 120M"),
        drawn("radiosity_samples_limited", MANY_SAMPLES, 4, &["E0242", "while photons or radiosity were prepared"])
            .args("render a.scene -o out.png --size 800x600 --max-memory 24M"),
        case("values_of_macros_branch", branching_value_macros(), 4, &["E0240"]).args(SOON),
        case("debug_floods", "#while (1)\n#debug \"x\"\n#end\n", 4, &["E0240"]).args("check a.scene --max-steps 10000"),
        case("warnings_flood", "#while (1)\n#warning \"x\"\n#end\n", 4, &["E0240"]).args("check a.scene --max-steps 100000"),
        case("warnings_differ", "#declare I = 0;\n#while (1)\n#warning str(I, 0, 0)\n#declare I = I + 1;\n#end\n", 4, &["E0240"])
            .args("check a.scene --max-steps 100000"),
    ]
}

fn deep() -> Vec<Case> {
    let too_deep: &[&str] = &["E0104", "a.scene:1:"];
    let blocks = |open: &str, inner: &str| nested(open, inner, " }", DEEP);
    vec![
        case("deep_parens", format!("#declare A = {};\n", nested("(", "1", ")", DEEP)), 1, too_deep),
        case("deep_braces", nested("{", "", "}", DEEP), 1, too_deep),
        case("deep_brackets", format!("#declare A = B{};\n", nested("[", "1", "]", DEEP)), 1, too_deep),
        case("deep_vectors", format!("#declare A = {};\n", nested("<0, ", "1", ">", DEEP)), 1, too_deep),
        case("deep_unions", blocks("union { ", "sphere { 0, 1 }"), 1, too_deep),
        case("deep_if", nested("#if (1) ", "", " #end", DEEP), 1, too_deep),
        case("deep_else", nested("#if (0) #else ", "", " #end", DEEP), 1, too_deep),
        case("deep_elseif", format!("#if (0) {} #end", "#elseif (0) ".repeat(DEEP)), 0, &[]),
        case("deep_macro", nested("#macro A() ", "", " #end", DEEP), 1, too_deep),
        case("deep_transform", format!("sphere {{ 0, 1 {} }}", blocks("transform { ", "")), 1, too_deep),
        case("deep_texture", format!("sphere {{ 0, 1 {} }}", blocks("texture { ", "")), 1, too_deep),
        case("deep_call", format!("#declare A = {};\n", nested("abs(", "1", ")", DEEP)), 1, too_deep),
        case("deep_choice", format!("#declare A = ({}1);\n", "1 ? 1 : ".repeat(DEEP)), 1, &["a.scene:1:"]),
        case("deep_comment", nested("/*", "", "*/", DEEP), 0, &["W0206"]),
        case("deep_declare", "#declare A = ".repeat(DEEP), 0, &["E0205", "a.scene:1:"]),
        case("deep_function", format!("#declare A = {}", nested("function { ", "x", " }", DEEP)), 1, too_deep),
        drawn("just_deep_enough", nested("union { ", "sphere { 0, 1 } sphere { x, 1 }", " }", 990), 0, &[]),
        drawn("just_deep_parens", format!("sphere {{ 0, {} }}", nested("(", "1", ")", 990)), 0, &[]),
        drawn("just_deep_ifs", nested("#if (1) ", "sphere { 0, 1 }", " #end", 990), 0, &[]),
        drawn(
            "just_deep_transforms",
            format!("sphere {{ 0, 1 {} }}", nested("transform { ", "rotate x", " }", 990)),
            0,
            &[],
        ),
    ]
}

fn long() -> Vec<Case> {
    vec![
        drawn("long_sum", format!("sphere {{ 0, (0{}) / {LONG} }}", "+1".repeat(LONG)), 0, &[]),
        drawn("long_product", format!("sphere {{ 0, 1{} }}", "*1".repeat(LONG)), 0, &[]),
        drawn("long_minus", format!("sphere {{ 0, {}1 }}", "-".repeat(LONG)), 0, &[]),
        drawn("long_not", format!("sphere {{ 0, ({}1) }}", "!".repeat(LONG)), 0, &[]),
        drawn("long_and", format!("sphere {{ 0, (1{}) }}", " & 1".repeat(LONG)), 0, &[]),
        drawn("long_dots", format!("sphere {{ 0, x{} }}", ".x".repeat(LONG)), 0, &[]),
        drawn("long_number", format!("sphere {{ 0, 0.{} }}", "9".repeat(LONG)), 0, &[]),
        drawn("long_whole_number", format!("sphere {{ 0, {} }}", "9".repeat(LONG)), 0, &["W0213", "a.scene:1:13"]),
        drawn("long_exponent", format!("sphere {{ 0, 1e-{} }}", "9".repeat(LONG)), 0, &["a.scene:1:"]),
        drawn("long_name", format!("sphere {{ 0, {} }}", "a".repeat(LONG)), 1, &["E0203", "a.scene:1:13"]),
        drawn(
            "long_names",
            format!("#declare {0}b = 1; sphere {{ 0, {0}c }}", "a".repeat(LONG)),
            1,
            &["E0203", "a.scene:1:"],
        ),
        drawn("long_word", format!("sphere {{ 0, 1 {} 2 }}", "a".repeat(LONG)), 1, &["a.scene:1:15"]),
        drawn("long_directive", format!("#{}", "a".repeat(LONG)), 1, &["E0103", "a.scene:1:1"]),
        drawn("long_string", format!("#warning \"{}\" sphere {{ 0, 1 }}", "a".repeat(LONG)), 0, &["W0202"]),
        drawn("long_error", format!("#error \"{}\"", "a".repeat(LONG)), 1, &["E0234", "a.scene:1:8"]),
        drawn("long_comment", format!("/* {} */ sphere {{ 0, 1 }}", "*".repeat(LONG)), 0, &[]),
        drawn("long_parameters", format!("#macro A({}b) #end", "a, ".repeat(DEEP)), 0, &[]),
        drawn("long_switch", format!("#switch (1) {} #end", "#case (0) ".repeat(DEEP)), 0, &[]),
        drawn("long_concat", format!("#debug concat({}\"\")", "\"\", ".repeat(DEEP)), 0, &[]),
    ]
}

fn many() -> Vec<Case> {
    vec![
        drawn("many_lights", "#for (I, 1, 100000) light_source { <I, 9, -9> rgb 1e-5 } #end sphere { 0, 1 }", 0, &[]),
        drawn("many_spheres", "#for (I, 1, 100000) sphere { <I, 0, 9>, 1 } #end", 0, &[]),
        drawn("many_at_one_place", "#for (I, 1, 100000) sphere { 0, 1 } #end", 0, &[]),
        drawn("many_planes", "#for (I, 1, 20000) plane { y, -I } #end", 0, &[]),
        drawn("many_transforms", "sphere { 0, 1 #for (I, 1, 100000) rotate <I, 1, 2> #end }", 0, &[]),
        drawn("many_layers", "sphere { 0, 1 #for (I, 1, 5000) texture { pigment { rgbt 0.5 } } #end }", 0, &[]),
        drawn("many_clear_walls", "#for (I, 1, 30000) plane { z, I / 100 pigment { rgbt 1 } } #end", 4, &["E0241"])
            .args("render a.scene -o out.png --size 8x6 --max-time 0.5"),
        drawn(
            "many_triangles",
            "union { #for (I, 1, 100000) triangle { <I, 0, 9>, <0, I, 9>, <I, I, 8> } #end }",
            0,
            &[],
        ),
    ]
}

/// Macros whose body is a value, each of which calls the next one many times.
fn branching_value_macros() -> String {
    let sum = |k: usize| vec![format!("M{k}()"); 30].join("+");
    let macros: String = (0..30).map(|k| format!("#macro M{k}() ({}) #end\n", sum(k + 1))).collect();
    macros + "#macro M30() (1) #end\n#declare A = M0();\n"
}
