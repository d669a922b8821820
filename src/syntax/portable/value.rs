//! Finds the end of the value of a `#declare`, where a `;` belongs.

use super::{is_keyword, token_after_partner};
use crate::syntax::class;
use crate::syntax::outline::Outline;

/// Functions that return strings; POV-Ray needs no `;` after them.
const STRING_FUNCTIONS: &[&str] = &["chr", "concat", "datetime", "str", "strlwr", "strupr", "substr", "vstr"];
/// Keywords that begin a colour.
const COLOR_WORDS: &[&str] = &[
    "color", "colour", "rgb", "rgbf", "rgbt", "rgbft", "srgb", "srgbf", "srgbt", "srgbft", "red", "green", "blue",
    "filter", "transmit",
];

/// Returns the index of the token after the number, vector or colour that begins at the index `token`; `None` where the
/// text alone does not decide, as for a name that may be a macro, or for a value with directives in it.
pub(super) fn token_after_value(outline: &Outline, token: usize) -> Option<usize> {
    let mut token = token;
    loop {
        while matches!(outline.class(token), class::PLUS | class::MINUS | class::NOT) {
            token += 1;
        }
        token = token_after_operand(outline, token)?;
        while outline.class(token) == class::DOT {
            token += 2;
        }
        match outline.class(token) {
            class::PLUS | class::MINUS | class::TIMES | class::OVER => token += 1,
            _ if is_color_word(outline, token) => {}
            _ => return Some(token),
        }
    }
}

fn is_color_word(outline: &Outline, token: usize) -> bool {
    is_keyword(outline, token) && COLOR_WORDS.contains(&outline.token_text(token))
}

fn token_after_operand(outline: &Outline, token: usize) -> Option<usize> {
    match outline.class(token) {
        class::NUMBER => Some(token + 1),
        class::PAREN | class::VECTOR => token_after_partner(outline, token),
        class::BUILTIN if STRING_FUNCTIONS.contains(&outline.token_text(token)) => None,
        class::BUILTIN if outline.class(token + 1) == class::PAREN => token_after_partner(outline, token + 1),
        // `rgb` and its value.
        _ if is_color_word(outline, token) => {
            let behind = token + 1;
            match outline.class(behind) {
                class::PLUS | class::MINUS => token_after_operand(outline, behind + 1),
                _ => token_after_operand(outline, behind),
            }
        }
        // Among names, only the built-in constants are known to be numbers.
        class::NAME if is_constant(outline.token_text(token)) => Some(token + 1),
        _ => None,
    }
}

fn is_constant(word: &str) -> bool {
    crate::syntax::word::CONSTANTS.iter().any(|(name, _)| *name == word) && word != "input_file_name"
}
