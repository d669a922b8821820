//! Says what is wrong where the grammar stopped.

use super::word;
use crate::diagnostic::{Diagnostic, codes};
use crate::source::Span;

/// The message for text that fits no rule from `at` on.
pub fn explain(text: &str, at: usize, base: usize) -> Diagnostic {
    let token = token_at(text, at);
    let span = Span::new(base + at, base + at + token.len());
    let found = if token.is_empty() { "the end of the text".to_string() } else { format!("`{token}`") };
    let d = Diagnostic::new(codes::SYNTAX, span, format!("{found} can't stand here"));
    if let Some(help) = help_for(text, at, token) {
        return d.help(help);
    }
    match open_vector(text, at) {
        Some(opener) => d
            .also(Span::new(base + opener, base + opener + 1), "the vector that begins here is not closed")
            .help("a vector ends with `>`; comparisons need parentheses around them"),
        None => d,
    }
}

fn help_for(text: &str, at: usize, token: &str) -> Option<String> {
    let before = text[..at].trim_end();
    Some(match token {
        "=" if before.ends_with('=') => "a single `=` compares".into(),
        "=" => match last_word(before) {
            Some(name) if word::lookup(name).is_none() => {
                format!("to give `{name}` a value, write `#declare {name} = …;`")
            }
            _ => "comparisons need parentheses around them".into(),
        },
        "&" if before.ends_with('&') => "a single `&` is the logical and".into(),
        "|" if before.ends_with('|') => "a single `|` is the logical or".into(),
        "&" | "|" | "?" | "!" | "<" | ">" if open_vector(text, at).is_none() => {
            "comparisons, `&`, `|` and `?:` need parentheses around them".into()
        }
        "'" => "strings stand in double quotes".into(),
        "%" => "the remainder is `mod(a, b)`".into(),
        "^" => "powers are `pow(a, b)`".into(),
        "\\" | "@" | "$" | "~" | "`" => "no such character stands in a scene outside of strings and comments".into(),
        "+" | "*" | "/" | "-" => "an operator needs a value on both sides".into(),
        "" => "something is missing at the end".into(),
        _ => return None,
    })
}

/// The word, number or character that starts at `at`.
fn token_at(text: &str, at: usize) -> &str {
    let rest = &text[at..];
    let word = rest.find(|c: char| !c.is_alphanumeric() && c != '_').unwrap_or(rest.len());
    let end = if word > 0 { word } else { rest.chars().next().map_or(0, char::len_utf8) };
    &rest[..end]
}

fn last_word(text: &str) -> Option<&str> {
    let start = text.rfind(|c: char| !c.is_alphanumeric() && c != '_').map_or(0, |i| i + 1);
    let word = &text[start..];
    word.starts_with(|c: char| c.is_alphabetic() || c == '_').then_some(word)
}

/// The `<` of a vector that is still open at `at`, as far as one can tell from its line and the one before.
fn open_vector(text: &str, at: usize) -> Option<usize> {
    let mut depth = 0;
    for (i, c) in text[..at].char_indices().rev() {
        match c {
            '>' => depth += 1,
            '<' if depth == 0 => return Some(i),
            '<' => depth -= 1,
            '{' | '}' | ';' | '#' | '"' => return None,
            _ => {}
        }
    }
    None
}
