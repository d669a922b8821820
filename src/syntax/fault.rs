//! Explains the syntax error at the position where the grammar stopped.

use super::word;
use crate::diagnostic::{Diagnostic, Severity, codes};
use crate::source::Span;

/// Returns the error for text that fits no rule of the grammar from the offset `at` on.
pub fn syntax_error_at(text: &str, at: usize, base_in_sources: usize) -> Diagnostic {
    if let Some(d) = unparenthesized_condition_error(text, at, base_in_sources) {
        return d;
    }
    if let Some(d) = missing_name_or_equals_error(text, at, base_in_sources) {
        return d;
    }
    let d = Diagnostic::new(
        codes::SYNTAX,
        token_span(text, at, base_in_sources),
        format!("{} is not allowed here", describe_text_at(text, at)),
    );
    if let Some(help) = help_for(text, at, token_at(text, at)) {
        return d.help(help);
    }
    match open_vector_start(text, at) {
        Some(opener) if follows_operand(text, opener) => {
            let message = "`<` opens a vector here, and it has no end";
            Diagnostic::new(codes::SYNTAX, Span::new(base_in_sources + opener, base_in_sources + opener + 1), message)
                .help("comparisons need parentheses around them: `(A < B)`")
        }
        Some(opener) => d
            .also(
                Span::new(base_in_sources + opener, base_in_sources + opener + 1),
                "the vector that begins here is not closed",
            )
            .help("a vector ends with `>`; comparisons need parentheses around them"),
        None => d,
    }
}

/// True for `elif` and similar words, which other languages have for `#elseif`.
pub fn is_other_elseif(word: &str) -> bool {
    matches!(word, "elsif" | "elif" | "elsf" | "elseIf" | "ElseIf" | "else_if" | "elsei")
}

/// Returns the error for `#elsif`, with severity `Warning`: the directive and the elements after it are skipped with
/// the branch before.
pub(super) fn elsif_error(word: &str, span: Span) -> Diagnostic {
    let message = format!("there is no directive `#{word}`: what follows it is a part of the branch before");
    let d = Diagnostic::new(codes::UNKNOWN_DIRECTIVE, span, message).help("write `#elseif`");
    Diagnostic { severity: Severity::Warning, ..d }
}

/// True for `endif` and similar words, which other languages have for `#end`.
pub fn is_other_end(word: &str) -> bool {
    matches!(
        word,
        "endif" | "endfor" | "endwhile" | "endmacro" | "endswitch" | "end_if" | "fi" | "done" | "wend" | "next"
    )
}

/// Describes the text at the offset `at`, for a message.
fn describe_text_at(text: &str, at: usize) -> String {
    match token_at(text, at) {
        "" => "the end of the text".into(),
        token => format!("`{token}`"),
    }
}

fn token_span(text: &str, at: usize, base_in_sources: usize) -> Span {
    Span::new(base_in_sources + at, base_in_sources + at + token_at(text, at).len())
}

/// True if the text before the offset `at` could be the left side of a comparison.
fn follows_operand(text: &str, at: usize) -> bool {
    let before = text[..at].trim_end();
    match word_at_end(before) {
        Some(word) => word::lookup(word).is_none(),
        None => before.ends_with(|c: char| c.is_ascii_digit() || c == ')' || c == ']'),
    }
}

/// Returns the error for a missing name or `=`, as in `#declare A 5`, `#declare = 5` and `#macro (A)`.
fn missing_name_or_equals_error(text: &str, at: usize, base_in_sources: usize) -> Option<Diagnostic> {
    let before = text[..at].trim_end();
    let fault = |message: String| Diagnostic::new(codes::SYNTAX, token_span(text, at, base_in_sources), message);
    let found = describe_text_at(text, at);
    if let Some(directive @ ("declare" | "local" | "macro" | "undef")) = directive_name_at_end(before) {
        let d = fault(format!("expected a name after `#{directive}`, found {found}"));
        return Some(d.help("names are made of the letters a to z, digits and `_`"));
    }
    let name = word_at_end(before)?;
    let directive = directive_name_at_end(before[..before.len() - name.len()].trim_end())?;
    let d = fault(format!("expected `=` after `#{directive} {name}`, found {found}"));
    let line = text[at..].lines().next().unwrap_or_default();
    let value = line.split([';', '/']).next().unwrap_or_default().trim();
    let value = if value.is_empty() || value.len() > 40 || value.starts_with('=') { "…" } else { value };
    matches!(directive, "declare" | "local").then(|| d.help(format!("`#{directive} {name} = {value};`")))
}

/// Returns the name of the directive that a text ends with.
fn directive_name_at_end(text: &str) -> Option<&str> {
    let word = word_at_end(text)?;
    text[..text.len() - word.len()].trim_end_matches([' ', '\t']).ends_with('#').then_some(word)
}

/// Returns the error for a condition without parentheses, as in `#if A = 1`.
fn unparenthesized_condition_error(text: &str, at: usize, base_in_sources: usize) -> Option<Diagnostic> {
    let directive = text[at..].strip_prefix('#')?.trim_start_matches([' ', '\t']);
    let word = token_at(directive, 0);
    let form = match word {
        "if" | "elseif" | "while" => "condition",
        "ifdef" | "ifndef" => "Name",
        "for" => "Name, 1, 10",
        "switch" | "case" => "value",
        "range" => "first, last",
        _ => return None,
    };
    let rest = &directive[word.len()..];
    let next = text.len() - rest.trim_start().len();
    if text[next..].starts_with('(') {
        let message = format!("the `(` of this `#{word}` is not closed");
        let d = Diagnostic::new(codes::SYNTAX, token_span(text, at, base_in_sources), message);
        let d = d.also(Span::new(base_in_sources + next, base_in_sources + next + 1), "this one");
        return (!first_parenthesis_is_closed(&text[next..]))
            .then(|| d.help(format!("it is written `#{word} ({form}) …`")));
    }
    let message = format!("expected `(` after `#{word}`, found {}", describe_text_at(text, next));
    let span = token_span(text, next, base_in_sources);
    Some(Diagnostic::new(codes::SYNTAX, span, message).help(format!("`#{word} ({form}) …`")))
}

/// True if the text contains the partner of the parenthesis that it starts with.
fn first_parenthesis_is_closed(text: &str) -> bool {
    let mut depth = 0usize;
    text.chars().any(|c| {
        depth = match c {
            '(' => depth + 1,
            ')' => depth.saturating_sub(1),
            _ => depth,
        };
        depth == 0
    })
}

fn help_for(text: &str, at: usize, token: &str) -> Option<String> {
    let before = text[..at].trim_end();
    Some(match token {
        "=" if before.ends_with('=') => "a single `=` compares".into(),
        "=" => match word_at_end(before) {
            Some(name) if word::lookup(name).is_none() => {
                format!("to give `{name}` a value, write `#declare {name} = …;`")
            }
            _ => "comparisons need parentheses around them".into(),
        },
        "&" if before.ends_with('&') => "a single `&` is the logical and".into(),
        "|" if before.ends_with('|') => "a single `|` is the logical or".into(),
        "&" | "|" | "?" | "!" | "<" | ">" if open_vector_start(text, at).is_none() => {
            "comparisons, `&`, `|` and `?:` need parentheses around them".into()
        }
        "'" => "strings stand in double quotes".into(),
        "%" => "the remainder is `mod(a, b)`".into(),
        "^" => "powers are `pow(a, b)`".into(),
        "\\" | "@" | "$" | "~" | "`" => "scenes have no such character outside of strings and comments".into(),
        "+" | "*" | "/" | "-" => "an operator needs a value on both sides".into(),
        "" => "something is missing at the end".into(),
        _ if matches!(word_at_end(before), Some("rgb" | "rgbf" | "rgbt" | "rgbft" | "color" | "colour"))
            && ends_inside_parentheses(before) =>
        {
            "in parentheses, a colour is written as a vector: `<1, 0, 0>`".into()
        }
        _ => return None,
    })
}

/// Returns the word, number or character that starts at the offset `at`.
pub fn token_at(text: &str, at: usize) -> &str {
    let rest = &text[at..];
    let word = rest.find(|c: char| !c.is_alphanumeric() && c != '_').unwrap_or(rest.len());
    let end = if word > 0 { word } else { rest.chars().next().map_or(0, char::len_utf8) };
    &rest[..end]
}

fn word_at_end(text: &str) -> Option<&str> {
    let word = text.rsplit(|c: char| !c.is_alphanumeric() && c != '_').next()?;
    word.starts_with(|c: char| c.is_alphabetic() || c == '_').then_some(word)
}

/// Returns the offset of a vector's `<` that is still open at the offset `at`; `None` if a brace, `;`, `#` or quote is
/// nearer than such a `<`.
fn open_vector_start(text: &str, at: usize) -> Option<usize> {
    let mut depth = 0;
    for (i, c) in text[..at].char_indices().rev() {
        match c {
            '>' => depth += 1,
            // Inside parentheses it compares.
            '<' if depth == 0 && follows_operand(text, i) && ends_inside_parentheses(&text[..i]) => {}
            '<' if depth == 0 => return Some(i),
            '<' => depth -= 1,
            '{' | '}' | ';' | '#' | '"' => return None,
            _ => {}
        }
    }
    None
}

/// True if the text ends inside `( … )` where `<` compares: a group, a condition or a function's arguments.
fn ends_inside_parentheses(text: &str) -> bool {
    let mut depth = 0;
    for (i, c) in text.char_indices().rev() {
        match c {
            ')' => depth += 1,
            '(' if depth == 0 => return word_at_end(text[..i].trim_end()).is_none_or(|w| word::lookup(w).is_some()),
            '(' => depth -= 1,
            '{' | '}' | ';' | '#' | '"' => return false,
            _ => {}
        }
    }
    false
}
