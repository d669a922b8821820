//! Tree-sitter's highlight queries: the category of each word. The grammar itself has no list of words.

use super::{File, GENERATED, lines};
use durer::reference::WordsByKind;

pub fn files(by_kind: &WordsByKind) -> Vec<File> {
    vec![("tree-sitter-povray/queries/highlights.scm", highlights(by_kind))]
}

fn highlights(by_kind: &WordsByKind) -> String {
    let sorted = [
        ("type", &by_kind.objects),
        ("keyword", &by_kind.blocks),
        ("function.builtin", &by_kind.functions),
        ("constant.builtin", &by_kind.constants),
        ("attribute", &by_kind.words),
    ];
    let words: String = sorted.iter().map(|(scope, words)| of_words(scope, words)).collect();
    format!("; {GENERATED}\n{HEAD}{words}")
}

fn of_words(scope: &str, words: &[&str]) -> String {
    let quoted: Vec<String> = words.iter().map(|word| format!("\"{word}\"")).collect();
    let quoted: Vec<&str> = quoted.iter().map(String::as_str).collect();
    format!("\n((word) @{scope}\n  (#any-of? @{scope}\n    {}))\n", lines(&quoted, " ").join("\n    "))
}

// No two patterns match the same node: editors do not agree which would win.
const HEAD: &str = r##"
(line_comment) @comment.line
(block_comment) @comment.block
(string) @string
(escape) @constant.character.escape
(number) @constant.numeric
(sign) @operator

["{" "}" "(" ")" "[" "]"] @punctuation.bracket
(parameters "," @punctuation.delimiter)

[(opener) (middle) (end) (macro_opener) (declare) (directive)] @keyword.directive
(declaration name: (word) @variable (#match? @variable "[A-Z0-9_]"))
(macro name: (word) @function.macro (#match? @function.macro "[A-Z0-9_]"))
(parameters (word) @variable.parameter (#match? @variable.parameter "[A-Z0-9_]"))
; What is called, by the manual's advice, has a large letter.
((word) @function . (parentheses) (#match? @function "^[A-Z]"))
"##;
