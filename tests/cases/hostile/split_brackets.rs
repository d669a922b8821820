//! Texts with unmatched brackets and split expressions: endless ones, from macros that open or close only, from
//! branches and loops.

use super::limited_run::{Case, case, drawn, nested};

const DEEP: usize = 100_000;
const LONG: usize = 1_000_000;

/// All cases.
pub fn cases() -> Vec<Case> {
    [loose(), in_branches(), macros(), loops(), expressions(), inside_each_other()].into_iter().flatten().collect()
}

/// A loop around `body`.
fn times(count: usize, body: &str) -> String {
    format!("#for (I, 1, {count}) {body} #end")
}

fn loose() -> Vec<Case> {
    let deep: &[&str] = &["E0104", "a.scene:1:"];
    let closer: &[&str] = &["E0102", "a.scene:1:"];
    let sign: &[&str] = &["E0100", "a.scene:1:"];
    let many = |text: &str| text.repeat(LONG);
    vec![
        case("loose_braces", many("{"), 1, deep),
        case("loose_parens", many("("), 1, deep),
        case("loose_brackets", many("["), 1, deep),
        case("loose_angles", many("<"), 1, deep),
        case("loose_questions", many("?"), 1, deep),
        case("loose_of_all_kinds", many("<(["), 1, deep),
        case("loose_braces_closed", many("}"), 1, closer),
        case("loose_parens_closed", many(")"), 1, closer),
        case("loose_brackets_closed", many("]"), 1, closer),
        case("loose_angles_closed", many(">"), 1, sign),
        case("loose_colons", many(":"), 1, sign),
        case("loose_minus", many("-"), 1, sign),
        case("loose_operators", many("+ *"), 1, sign),
        case("loose_points", many(". "), 1, sign),
        drawn("loose_commas", many(","), 0, &[]),
        drawn("loose_semicolons", many(";"), 0, &[]),
        case("loose_braces_turned", many("} {"), 1, closer),
        case("loose_in_block", format!("sphere {{ 0, 1 {} }}", many(") ")), 1, closer),
        case("loose_in_parens", format!("#declare A = (1 {});", many("] ")), 1, &["E0101", "a.scene:1:14"]),
    ]
}

fn in_branches() -> Vec<Case> {
    let each = |text: &str| format!("#if (1) {text} #end ").repeat(DEEP);
    let deep: &[&str] = &["E0104", "a.scene:1:"];
    vec![
        case("branches_of_parens", each("("), 1, &["E0205", "a.scene:1:9"]),
        case("branches_of_closing_parens", each(")"), 1, &["E0102", "a.scene:1:9"]),
        case("branches_of_unions", each("union {"), 4, deep),
        case("branches_of_angles", format!("#declare A = {}", each("<")), 4, deep),
        case("branches_of_choices", format!("sphere {{ 0, ({}1) }}", each("1 ? 1 :")), 4, deep),
        drawn("branches_of_minus", format!("#declare A = {}1;", each("-")), 0, &[]),
    ]
}

fn macros() -> Vec<Case> {
    let calls: &[&str] = &["E0243", "a.scene:1:12"];
    let opens: &[&str] = &["E0104", "a.scene:1:12", "in macro `M`"];
    let valued = |body: &str| format!("#macro M() {body} #end\n#declare A = M()\n");
    vec![
        case("macro_opens", "#macro M() union { M() #end\nM()\n", 4, &["E0243", "a.scene:1:20"]),
        case("macro_opens_and_closes", "#macro M() union { M() } #end\nM()\n", 4, &["E0243", "a.scene:1:20"]),
        case("macro_closes_and_opens", "#macro M() } union { M() #end\nunion { M()\n", 4, &["E0243", "a.scene:1:22"]),
        case("macro_opens_parens", valued("( M()"), 4, opens),
        case("macro_opens_vectors", valued("< M()"), 4, opens),
        case("macro_gives_signs", valued("- M()"), 4, &["E0243", "a.scene:1:14"]),
        case("macro_gives_halves", "#macro M() 1 + M() #end\n#declare A = (M()\n", 4, &["E0243", "a.scene:1:16"]),
        case("macro_closes", "#macro M() } M() #end\nM()\n", 1, &["E0102", "a.scene:1:12", "a.scene:2:1"]),
        drawn("macro_closes_parens", valued(") M()"), 0, &["E0205", "a.scene:1:12"]),
        case("macro_opens_itself_behind", "#macro M() M() union { #end\nM()\n", 4, calls),
        case("macro_closes_itself_behind", "#macro M() M() } #end\nM()\n", 4, calls),
    ]
}

fn loops() -> Vec<Case> {
    let deep: &[&str] = &["E0104", "a.scene:1:"];
    let valued = |body: &str| format!("#declare A = #while (1) {body} #end\n");
    let both = |open: &str, inner: &str, close: &str, count: usize| {
        format!("{} {inner} {}", times(count, open), times(count, close))
    };
    vec![
        case("loop_opens", "#while (1) union { #end\n", 4, deep),
        case("loop_opens_by_macro", "#macro M() union { #end #while (1) M() #end\n", 4, deep),
        case("loop_opens_parens", valued("("), 4, deep),
        case("loop_opens_vectors", valued("<"), 4, deep),
        case("loop_opens_calls", valued("abs("), 4, deep),
        case("loop_opens_arrays", valued("array[2] {"), 4, deep),
        case("loop_opens_choices", "#declare A = (#while (1) 1 ? #end\n", 4, deep),
        drawn("loop_opens_functions", valued("function {"), 0, &["E0205", "a.scene:1:25"]),
        case(
            "loop_opens_entries",
            "sphere { 0, 1 pigment { gradient x color_map { #while (1) [ #end
",
            1,
            &["E0101", "a.scene:1:"],
        ),
        case("loop_closes", "#while (1) } #end\n", 1, &["E0102", "a.scene:1:12"]),
        case("loop_gives_signs", "#declare A = (#while (1) - #end\n", 4, &["a.scene:1:"]),
        drawn("loops_open_and_close", both("union {", "sphere { 0, 1 }", "}", 400), 0, &[]),
        case("loops_open_and_close_deeply", both("union {", "sphere { 0, 1 }", "}", DEEP), 4, deep),
        case("loops_of_parens", format!("#declare A = {};", both("(", "1", ")", DEEP)), 4, deep),
        case("loops_of_calls", format!("#declare A = {};", both("abs(", "1", ")", DEEP)), 4, deep),
        case("loops_of_choices", format!("#declare A = ({});", both("1 ?", "1", ": 1", DEEP)), 4, deep),
        case("loop_of_choices", format!("#declare A = ({} 1);", times(DEEP, "1 ? 1 :")), 4, deep),
    ]
}

/// Expressions of a million tokens.
fn expressions() -> Vec<Case> {
    let ball = |radius: String| format!("sphere {{ 0, {radius} }}");
    let counted = "#declare I = 0; sphere { 0, (1 #while (I < 1000000) + 1 #declare I = I + 1; #end) / 1000001 }";
    let steps = "render a.scene -o out.png --size 8x6 --threads 2 --max-steps 100000000";
    let fine = |name, text: String| drawn(name, text, 0, &[]).args(steps);
    let add = times(LONG, "+ 1");
    vec![
        fine("pieces_of_a_sum", ball(format!("(1 {add}) / 1000001"))),
        fine("pieces_of_a_counted_sum", counted.into()),
        fine("pieces_of_a_vector", format!("sphere {{ <0 {add} - 1000000, 0, 0>, 1 }}")),
        fine("pieces_of_a_product", ball(format!("1 {}", times(LONG, "* 1")))),
        fine("pieces_of_minus", ball(format!("{} 1", times(LONG, "-")))),
        fine("pieces_of_minus_in_parens", ball(format!("({} 1)", times(LONG, "-")))),
        fine("pieces_of_not", ball(format!("({} 1)", times(LONG, "!")))),
        fine("pieces_of_and", ball(format!("(1 {})", times(LONG, "& 1")))),
        fine("pieces_of_points", ball(format!("x {}", times(LONG, ".x")))),
        fine("pieces_of_commas", ball(format!("1 {}", times(LONG, ",")))),
        fine("pieces_of_concat", format!("#debug concat({} \"\")", times(LONG, "\"\","))),
        fine("pieces_of_an_array", format!("#declare A = array[1000000] {{ 1, {} }}", times(LONG - 1, "(I),"))),
        fine("pieces_of_arguments", format!("#macro F(X) X #end sphere {{ 0, F({} 1) }}", times(LONG, ""))),
        case(
            "pieces_of_a_long_vector",
            format!("sphere {{ <{} 0>, 1 }}", times(LONG, "1,")),
            1,
            &["E0202", "a.scene:1:10"],
        ),
        case(
            "pieces_of_indices",
            format!("#declare A = array[1] {{ 1 }} sphere {{ 0, A {} }}", times(LONG, "[0]")),
            1,
            &["E0201", "a.scene:1:"],
        ),
    ]
}

/// Incomplete expressions, nested.
fn inside_each_other() -> Vec<Case> {
    let value = |open: &str, close: &str| format!("#declare A = {};", nested(open, "1", close, 300));
    let called = |open: &str, close: &str| format!("#macro F(X) X + 1 #end\n{}", value(open, close));
    let missing: &[&str] = &["E0205", "a.scene:"];
    vec![
        drawn("nested_faulty_calls", called("F(", "+(1 1))"), 0, missing),
        drawn("nested_faulty_parens", value("((1 1)+", ")"), 0, missing),
        drawn("nested_faulty_built_ins", value("abs((1 1)+", ")"), 0, missing),
        drawn("nested_faulty_choices", value("(1 ? 2 3 : ", ")"), 0, missing),
        drawn("nested_faulty_indices", value("B[1 1 + ", "]"), 0, &["E0203", "a.scene:1:14"]),
        drawn("nested_faulty_branches", value("<#if (1) ", " #end>"), 0, &["E0202", "a.scene:1:"]),
        case("nested_faulty_heads", "#if (#if (1) ".repeat(300) + "1" + &" #end) #end ".repeat(300), 1, missing),
        drawn("nested_branches_in_vectors", value("<1, #if (1) ", " #end>.x"), 0, &[]),
        drawn("nested_branches_in_parens", value("(#if (1) ", " #end)"), 0, &[]),
        drawn("nested_calls_in_pieces", called("F(#if (1) ", " #end)"), 0, &[]),
        drawn(
            "nested_calls_in_a_function",
            called("F(", ")").replace("A =", "A = function {").replace(';', "}"),
            0,
            &[],
        ),
    ]
}
