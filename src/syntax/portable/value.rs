//! The end of the value of a `#declare`, where a `;` belongs.

use super::Text;
use crate::syntax::class;

/// Functions that return strings, after which POV-Ray needs no `;`.
const TEXTS: &[&str] = &["chr", "concat", "datetime", "str", "strlwr", "strupr", "substr", "vstr"];
/// Keywords that begin a colour.
const COLORS: &[&str] = &[
    "color", "colour", "rgb", "rgbf", "rgbt", "rgbft", "srgb", "srgbf", "srgbt", "srgbft", "red", "green", "blue",
    "filter", "transmit",
];

/// Index of the token after a number, vector or colour that begins at `at`; `None` where the text alone does not
/// decide, as for a name that may be a macro or an object, or for a value that directives compose.
pub(super) fn end(text: &Text, at: usize) -> Option<usize> {
    let mut at = at;
    loop {
        while matches!(text.class(at), class::PLUS | class::MINUS | class::NOT) {
            at += 1;
        }
        at = operand(text, at)?;
        while text.class(at) == class::DOT {
            at += 2;
        }
        match text.class(at) {
            class::PLUS | class::MINUS | class::TIMES | class::OVER => at += 1,
            _ if is_color(text, at) => {}
            _ => return Some(at),
        }
    }
}

fn is_color(text: &Text, at: usize) -> bool {
    text.is_keyword(at) && COLORS.contains(&text.word(at))
}

fn operand(text: &Text, at: usize) -> Option<usize> {
    match text.class(at) {
        class::NUMBER => Some(at + 1),
        class::PAREN => closed(text, at),
        class::VECTOR => closed(text, at),
        class::BUILTIN if TEXTS.contains(&text.word(at)) => None,
        class::BUILTIN if text.class(at + 1) == class::PAREN => closed(text, at + 1),
        // `rgb` and its value.
        _ if is_color(text, at) => {
            let behind = at + 1;
            match text.class(behind) {
                class::PLUS | class::MINUS => operand(text, behind + 1),
                _ => operand(text, behind),
            }
        }
        // Among names, only the built-in constants are known to be numbers.
        class::NAME if is_constant(text.word(at)) => Some(at + 1),
        _ => None,
    }
}

fn is_constant(word: &str) -> bool {
    crate::syntax::word::CONSTANTS.iter().any(|(name, _)| *name == word) && word != "input_file_name"
}

/// Returns the index after the partner of the bracket at `open`.
fn closed(text: &Text, open: usize) -> Option<usize> {
    let mut depth = 0;
    for at in open..text.len() {
        match text.class(at) {
            class::PAREN | class::VECTOR | class::BRACKET | class::BRACE => depth += 1,
            class::PAREN_END | class::VECTOR_END | class::BRACKET_END | class::BRACE_END => {
                depth -= 1;
                if depth == 0 {
                    return Some(at + 1);
                }
            }
            class if super::is_directive(class) => return None,
            _ => {}
        }
    }
    None
}
