//! Table of all directives, with their manual texts. Directives with a body are nodes of the syntax tree.

use crate::diagnostic::Result;
use crate::interpreter::Interpreter;
use crate::source::Span;
use rustc_hash::FxHashMap;
use std::sync::LazyLock;

/// Table row of a `#` directive: its name, syntax and summary.
#[derive(Debug)]
pub struct DirectiveSpec {
    /// Names of the directive after the `#`; related directives share an entry.
    pub names: &'static [&'static str],
    /// Syntax of the directive as the manual prints it.
    pub form: &'static str,
    /// Summary of the directive in one line, for the manual.
    pub summary: &'static str,
    /// Example of the directive in a few lines, which runs.
    pub example: &'static str,
    /// Function that runs the directive; `None` for a directive with a body.
    pub(in crate::interpreter) run: Option<Run>,
}

/// Function that runs a directive: receives the directive's word and span, and reads the tokens that follow.
pub(in crate::interpreter) type Run = for<'a> fn(&mut Interpreter<'a>, &'static str, Span) -> Result<()>;

/// Returns the word and the function of a directive without a body.
pub(in crate::interpreter) fn find_runner(name: &str) -> Option<(&'static str, Run)> {
    RUNNERS.get(name).copied()
}

/// Functions of the directives without a body, by word. (A hash map, because scripts may run `#write` a million times.)
static RUNNERS: LazyLock<FxHashMap<&'static str, (&'static str, Run)>> = LazyLock::new(|| {
    let runners = |row: &'static DirectiveSpec| row.names.iter().filter_map(|name| Some((*name, (*name, row.run?))));
    TABLE.iter().flat_map(runners).collect()
});

/// Returns the names of all directives of the scene language.
pub(in crate::interpreter) fn names() -> impl Iterator<Item = &'static str> {
    TABLE.iter().flat_map(|row| row.names).copied()
}

const fn entry(
    names: &'static [&'static str],
    form: &'static str,
    summary: &'static str,
    example: &'static str,
) -> DirectiveSpec {
    DirectiveSpec { names, form, summary, example, run: None }
}

impl DirectiveSpec {
    const fn with_run(self, run: Run) -> Self {
        Self { run: Some(run), ..self }
    }
}

/// All directives, in the order in which a beginner learns them.
pub const TABLE: &[DirectiveSpec] = &[
    entry(
        &["declare"],
        "#declare Name = value;",
        "gives a name to a number, vector, colour, text, array, function, spline, or to any block; or gives it a new value",
        "#declare Radius = 2;\n#declare Ball = sphere { 0, Radius }",
    ),
    entry(
        &["local"],
        "#local Name = value;",
        "the same, but the name ends with the macro or file around the directive",
        "#macro Ring(R)\n  #local Thin = R / 10;\n  torus { R, Thin }\n#end\nRing(1)",
    ),
    entry(&["undef"], "#undef Name", "forgets a name", "#declare A = 1;\n#undef A").with_run(|me, _, span| me.run_undef(span)),
    entry(
        &["if", "elseif", "else", "end"],
        "#if (condition) … #elseif (condition) … #else … #end",
        "reads the branch whose condition is true; 0 is false",
        "#declare A = 3;\n#if (A > 2)\n  sphere { 0, A }\n#else\n  box { 0, A }\n#end",
    ),
    entry(
        &["ifdef", "ifndef"],
        "#ifdef (Name) … #else … #end",
        "reads the branch if the name is declared; `#ifndef` if it is not",
        "#ifndef (Quick)\n  #declare Quick = no;\n#end",
    ),
    entry(
        &["while"],
        "#while (condition) … #end",
        "repeats the body while the condition is true",
        "#declare I = 0;\n#while (I < 3)\n  sphere { I * x, 0.4 }\n  #declare I = I + 1;\n#end",
    ),
    entry(
        &["for"],
        "#for (Name, from, to [, step]) … #end",
        "repeats the body while the name counts from the first to the last number",
        "#for (I, 0, 10, 2)\n  sphere { I * x, 0.4 }\n#end",
    ),
    entry(
        &["break"],
        "#break",
        "leaves the loop, the macro or the `#switch` around it",
        "#for (I, 1, 100)\n  #if (I * I > 50) #break #end\n#end",
    ).with_run(|me, _, span| me.run_break(span)),
    entry(
        &["switch", "case", "range"],
        "#switch (value) #case (number) … #break #range (low, high) … #break #else … #end",
        "reads from the first matching case on, up to the next `#break`",
        "#declare N = 5;\n#switch (N)\n  #case (0) sphere { 0, 1 } #break\n  #range (1, 9) box { 0, 1 } #break\n  #else torus { 1, 0.2 }\n#end",
    ),
    entry(
        &["macro"],
        "#macro Name(A, B, …) … #end",
        "declares a piece of scene with parameters; `Name(1, 2)` inserts it",
        "#macro Pill(A, B, R)\n  sphere { A, R } sphere { B, R } cylinder { A, B, R }\n#end\nunion { Pill(0, 2*y, 0.5) }",
    ),
    entry(&["include"], "#include \"name\"", "reads another file here", "#include \"stage.inc\"").with_run(|me, _, span| me.run_include(span)),
    entry(&["version"], "#version number;", "the version of the language that the file is written in", "#version 3.7;").with_run(|me, _, _| me.run_version()),
    entry(
        &["default"],
        "#default { texture, pigment, finish or camera }",
        "sets defaults for the objects that follow",
        "#default { finish { ambient 0 specular 0.3 } }",
    ).with_run(|me, _, span| me.run_default(span)),
    entry(
        &["debug", "render", "statistics"],
        "#debug text",
        "prints to standard error",
        "#debug concat(\"pi is \", str(pi, 0, 3), \"\\n\")",
    ).with_run(|me, kind, _| me.run_message(kind)),
    entry(
        &["warning"],
        "#warning text",
        "prints a warning, with its place",
        "#if (clock > 1) #warning \"the clock runs fast\" #end",
    ).with_run(|me, kind, _| me.run_message(kind)),
    entry(
        &["error"],
        "#error text",
        "prints an error, with its place, and ends the run",
        "#if (clock > 9) #error \"too late\" #end",
    ).with_run(|me, kind, _| me.run_message(kind)),
    entry(
        &["fopen"],
        "#fopen Name text read | write | append",
        "opens a file of numbers and texts",
        "#fopen F \"manual_fopen.tmp\" write\n#fclose F",
    ).with_run(|me, _, span| me.run_fopen(span)),
    entry(
        &["write"],
        "#write (Name, value, …)",
        "writes values; strings are written without quotes, so write commas and quotes yourself. `uint8`, `uint16le`, `uint16be`, `sint8`, `sint16le`, `sint16be`, `sint32le` or `sint32be` before a value writes it as an integer of this many bits",
        "#fopen F \"manual_write.tmp\" write\n#write (F, 1, \",\", <1, 2, 3>, \"\\n\")\n#fclose F",
    ).with_run(|me, _, span| me.run_write(span)),
    entry(
        &["read"],
        "#read (Name, A, B, …)",
        "declares A, B … as the next values in the file; at the end of the file, the name `Name` is undeclared",
        "#fopen F \"manual_read.tmp\" write\n#write (F, \"1, 2, 3\")\n#fclose F\n#fopen F \"manual_read.tmp\" read\n#while (defined(F))\n  #read (F, A)\n#end",
    ).with_run(|me, _, span| me.run_read(span)),
    entry(&["fclose"], "#fclose Name", "closes the file", "#fopen F \"manual_fclose.tmp\" write\n#fclose F").with_run(|me, _, span| me.run_fclose(span)),
];

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_directives_without_a_body_have_a_run_function() {
        let mut by_tree: Vec<_> = TABLE.iter().filter(|e| e.run.is_none()).flat_map(|e| e.names).copied().collect();
        let mut known: Vec<_> = crate::syntax::structural_directives().collect();
        by_tree.sort_unstable();
        known.sort_unstable();
        assert_eq!(by_tree, known);
    }
}
