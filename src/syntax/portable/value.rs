//! Finds the end of the value of a `#declare`, where a `;` belongs.

use super::{after_partner, is_keyword};
use crate::syntax::class;
use crate::syntax::outline::Outline;

/// Functions that return strings; POV-Ray needs no `;` after them.
const STRING_FUNCTIONS: &[&str] = &["chr", "concat", "datetime", "str", "strlwr", "strupr", "substr", "vstr"];
/// Keywords that begin a colour.
const COLOR_WORDS: &[&str] = &[
    "color", "colour", "rgb", "rgbf", "rgbt", "rgbft", "srgb", "srgbf", "srgbt", "srgbft", "red", "green", "blue",
    "filter", "transmit",
];

/// Returns the index of the token after the number, vector or colour that begins at the index `at`; `None` where the
/// text alone does not decide, as for a name that may be a macro, or for a value with directives in it.
pub(super) fn value_end(outline: &Outline, at: usize) -> Option<usize> {
    let mut at = at;
    loop {
        while matches!(outline.class(at), class::PLUS | class::MINUS | class::NOT) {
            at += 1;
        }
        at = operand_end(outline, at)?;
        while outline.class(at) == class::DOT {
            at += 2;
        }
        match outline.class(at) {
            class::PLUS | class::MINUS | class::TIMES | class::OVER => at += 1,
            _ if is_color(outline, at) => {}
            _ => return Some(at),
        }
    }
}

fn is_color(outline: &Outline, at: usize) -> bool {
    is_keyword(outline, at) && COLOR_WORDS.contains(&outline.word(at))
}

fn operand_end(outline: &Outline, at: usize) -> Option<usize> {
    match outline.class(at) {
        class::NUMBER => Some(at + 1),
        class::PAREN | class::VECTOR => after_partner(outline, at),
        class::BUILTIN if STRING_FUNCTIONS.contains(&outline.word(at)) => None,
        class::BUILTIN if outline.class(at + 1) == class::PAREN => after_partner(outline, at + 1),
        // `rgb` and its value.
        _ if is_color(outline, at) => {
            let behind = at + 1;
            match outline.class(behind) {
                class::PLUS | class::MINUS => operand_end(outline, behind + 1),
                _ => operand_end(outline, behind),
            }
        }
        // Among names, only the built-in constants are known to be numbers.
        class::NAME if is_constant(outline.word(at)) => Some(at + 1),
        _ => None,
    }
}

fn is_constant(word: &str) -> bool {
    crate::syntax::word::CONSTANTS.iter().any(|(name, _)| *name == word) && word != "input_file_name"
}
