//! Mistakes in directives, mostly habits from other languages.

use super::habit::CommonMistake;
use super::source_line::{SourceLine, is_name_char, shortened_value, split_leading_name, without_comment};
use crate::diagnostic::{Diagnostic, codes};

/// Returns the word after the `#` at the fault, and the rest of the line.
fn directive_and_rest<'t>(source: &SourceLine<'t>) -> Option<(&'t str, &'t str)> {
    let rest = source.rest_from_fault().strip_prefix('#')?.trim_start_matches([' ', '\t']);
    let end = rest.find(|c: char| !is_name_char(c)).unwrap_or(rest.len());
    Some(rest.split_at(end))
}

/// Returns the word after the `#` and the rest of the line, if the scene language has no directive of this name.
fn unknown_directive_and_rest<'t>(source: &SourceLine<'t>, d: &Diagnostic) -> Option<(&'t str, &'t str)> {
    if d.code == codes::UNKNOWN_DIRECTIVE { directive_and_rest(source) } else { None }
}

/// Recognizes the mistake `#ff8800` for a colour.
pub(super) fn hex_color(source: &SourceLine, d: &Diagnostic) -> Option<CommonMistake> {
    let (word, _) = unknown_directive_and_rest(source, d)?;
    let digits = |i: usize, n: usize| u32::from_str_radix(word.get(i..i + n)?, 16).ok();
    let [red, green, blue] = match word.len() {
        3 | 4 => [0, 1, 2].map(|i| digits(i, 1).map(|x| x * 17)),
        6 | 8 => [0, 2, 4].map(|i| digits(i, 2)),
        _ => return None,
    };
    let (red, green, blue) = (red?, green?, blue?);
    let habit = CommonMistake::with_help(format!("write `srgb <{red}, {green}, {blue}>/255`"));
    Some(habit.message(format!("a colour is not written as `#{word}`")))
}

/// Recognizes the mistake `#define A 2` for a declaration.
pub(super) fn define_directive(source: &SourceLine, d: &Diagnostic) -> Option<CommonMistake> {
    let ("define" | "def" | "set" | "let" | "var" | "const", rest) = unknown_directive_and_rest(source, d)? else {
        return None;
    };
    let (name, rest) = split_leading_name(rest.trim_start())?;
    let help = match rest.strip_prefix('(') {
        Some(rest) => format!("`#macro {name}({}) … #end`", rest.split(')').next().unwrap_or_default()),
        None => {
            format!("write `#declare {name} = {};`", shortened_value(rest.trim_start().trim_start_matches('=')))
        }
    };
    Some(CommonMistake::with_help(help).leaving_undeclared(name))
}

/// Recognizes the mistake `#elsif (A)` for `#elseif`.
pub(super) fn other_elseif_spelling(source: &SourceLine, d: &Diagnostic) -> Option<CommonMistake> {
    let (word, rest) = unknown_directive_and_rest(source, d)?;
    let condition = without_comment(rest);
    crate::syntax::fault::is_other_elseif(word)
        .then(|| CommonMistake::with_help(format!("write `#elseif {condition}`")))
}

/// Recognizes the mistake `#endif` for `#end`.
pub(super) fn other_end_spelling(source: &SourceLine, d: &Diagnostic) -> Option<CommonMistake> {
    let (word, _) = unknown_directive_and_rest(source, d)?;
    crate::syntax::fault::is_other_end(word)
        .then(|| CommonMistake::with_help("every directive with a body ends with `#end`"))
}

/// Recognizes the mistake `#Size = 3;`, without the word `declare`.
pub(super) fn assignment_after_hash(source: &SourceLine, d: &Diagnostic) -> Option<CommonMistake> {
    let (name, rest) = unknown_directive_and_rest(source, d)?;
    let value = rest.trim_start().strip_prefix('=')?;
    Some(
        CommonMistake::with_help(format!("write `#declare {name} = {};`", shortened_value(value)))
            .leaving_undeclared(name),
    )
}

/// Recognizes the mistake `# the red ball` for a comment.
pub(super) fn comment_after_hash(source: &SourceLine, d: &Diagnostic) -> Option<CommonMistake> {
    unknown_directive_and_rest(source, d).filter(|_| d.help.is_none())?;
    let text = source.rest_from_fault().trim_end();
    let comment = text.trim_start_matches(['#', ' ', '\t']);
    let help = format!("a comment begins with `//`: `// {}`", shortened_value(comment));
    Some(CommonMistake::with_help(help).range(source.file_range_of(text)))
}

/// Recognizes the mistake `#declre Size = 2;`: a misspelt directive, whose name stays undeclared.
pub(super) fn misspelt_directive(source: &SourceLine, d: &Diagnostic) -> Option<CommonMistake> {
    let (_, rest) = unknown_directive_and_rest(source, d)?;
    let rest = rest.trim_start();
    let habit = CommonMistake::with_help(d.help.clone()?);
    // The file of a misspelt `#include` was not read.
    if let Some(file) = rest.strip_prefix('"').and_then(|rest| rest.split('"').next()) {
        return Some(CommonMistake { file: Some(file.to_string()), ..habit });
    }
    let loses_directive = matches!(d.help.as_deref(), Some(help) if ["#macro", "#if", "#for", "#while", "#switch"].iter().any(|w| help.contains(w)));
    let habit = CommonMistake { loses_directive, ..habit };
    Some(match split_leading_name(rest) {
        Some((name, _)) => habit.leaving_undeclared(name),
        None => habit,
    })
}

/// Recognizes the mistake `#else if (A)` for `#elseif`.
pub(super) fn else_if(source: &SourceLine, _: &Diagnostic) -> Option<CommonMistake> {
    let before = source.before_fault().trim_end();
    let rest = source.rest_from_fault().strip_prefix("if")?.trim_start();
    before.strip_suffix("else")?.trim_end_matches([' ', '\t']).strip_suffix('#')?;
    let habit = CommonMistake::with_help(format!("write `#elseif {}`", without_comment(rest)));
    let start = source.line.start + before.rfind('#')?;
    let habit = habit.message("`#else if` is written as one word: `#elseif`").range(start..source.at + 2);
    Some(habit.code(codes::UNKNOWN_DIRECTIVE))
}

/// Recognizes the mistake `for (int i = 0; i < 10; i++) {`, with or without `#`.
pub(super) fn c_style_for(source: &SourceLine, _: &Diagnostic) -> Option<CommonMistake> {
    let statement = source.line_without_comment();
    let bare = !statement.starts_with('#');
    let head = statement.trim_start_matches('#').trim_start().strip_prefix("for")?.trim_start().strip_prefix('(')?;
    let head = head.split(')').next().unwrap_or_default();
    let mut parts = head.split(';');
    let (first, last) = match (parts.next(), parts.next()) {
        (Some(first), Some(last)) if first.contains('=') => (first, last),
        _ => return None,
    };
    let (counter, first) = first.split_once('=')?;
    let counter = counter.split_whitespace().last()?;
    let (sign, limit) = last.split_at(last.find(['<', '>'])?);
    let below = !limit.starts_with("<=") && !limit.starts_with(">=") && !sign.is_empty();
    let step = if limit.starts_with('<') { 1 } else { -1 };
    let limit = limit.trim_start_matches(['<', '>', '=']).trim();
    let last = match limit.parse::<i64>() {
        Ok(n) if below => n.saturating_sub(step).to_string(),
        _ => limit.to_string(),
    };
    let by = if step < 0 { ", -1" } else { "" };
    let habit = CommonMistake::with_help(format!("write `#for ({counter}, {}, {last}{by}) … #end`", first.trim()));
    let message = if bare { "a loop begins with `#for`" } else { "`#for` takes a name, a first and a last value" };
    let start = source.trimmed_line_offset_in_file();
    let end = start + statement.find('(').unwrap_or(0);
    let habit = habit.message(message).range(start..start + statement[..end - start].trim_end().len());
    Some(habit.code(codes::SYNTAX).leaving_undeclared(counter))
}

/// Recognizes the mistake `#include colors.inc`, a file name without quotes.
pub(super) fn file_without_quotes(source: &SourceLine, _: &Diagnostic) -> Option<CommonMistake> {
    let rest = source.line_without_comment().strip_prefix('#')?.trim_start().strip_prefix("include")?;
    let typed = rest.trim_start();
    if typed.starts_with('"')
        || !rest.starts_with([' ', '\t', '<', '\''])
        || source.at < source.file_range_of(typed).start
    {
        return None;
    }
    let typed = typed.split_whitespace().next()?;
    let name = typed.trim_matches(|c: char| matches!(c, '<' | '>' | '\'' | ';' | '‘' | '’' | '“' | '”'));
    // The name may also be that of a declared string.
    let plain = name.chars().all(|c| c.is_alphanumeric() || "._-/\\".contains(c));
    if !plain || !name.contains('.') {
        return None;
    }
    let habit = CommonMistake::with_help(format!("write `#include \"{name}\"`"));
    let habit = habit.message("the name of a file is written in double quotes").range(source.file_range_of(typed));
    Some(CommonMistake { file: Some(name.to_string()), ..habit.code(codes::SYNTAX) })
}

/// Recognizes the mistake `#macro Ball(R) {`, with braces around the body.
pub(super) fn braces_around_body(source: &SourceLine, d: &Diagnostic) -> Option<CommonMistake> {
    let statement = source.line_without_comment();
    let head = source.before_fault().trim();
    if d.code != codes::EXPECTED || !source.rest_from_fault().starts_with('{') || !head.starts_with('#') {
        return None;
    }
    let (word, _) = split_leading_name(head.trim_start_matches('#').trim_start())?;
    let has_body = matches!(word, "macro" | "if" | "ifdef" | "ifndef" | "elseif" | "else" | "while" | "for");
    if !has_body || word != "else" && !head.ends_with(')') {
        return None;
    }
    let head = statement.split('{').next().unwrap_or_default().trim_end();
    let habit = CommonMistake::with_help(format!("write `{head} … #end`, without `{{` and `}}`"));
    Some(habit.message(format!("what belongs to a `#{word}` has no braces around it")))
}

/// Recognizes the mistakes `macro Ball(R)`, `if (A = 1)` and `def Ball(r):`, without `#`.
pub(super) fn directive_without_hash(source: &SourceLine, d: &Diagnostic) -> Option<CommonMistake> {
    let statement = source.line_without_comment();
    let (word, rest) = split_leading_name(statement)?;
    if source.at != source.trimmed_line_offset_in_file() || d.code == codes::UNKNOWN_DIRECTIVE {
        return None;
    }
    let typed = rest.trim_start();
    let range = source.at..source.at + word.len();
    let habit = match word {
        "def" | "func" | "fn" | "proc" | "sub" => {
            let head = typed.trim_end_matches([':', '{', ' ']);
            CommonMistake::with_help(format!("write `#macro {head} … #end`"))
                .message(format!("`{word}` defines nothing here"))
        }
        "if" | "ifdef" | "ifndef" | "while" | "for" | "macro" | "else" | "elseif" | "switch" | "case" | "range"
        | "end" | "break" | "local" | "undef" | "debug" | "warning" | "error" => {
            let head = shortened_value(statement.split('{').next().unwrap_or_default());
            let rest = if statement.contains('{') { " … #end" } else { "" };
            let help = format!("write `#{head}{rest}`");
            CommonMistake::with_help(help).message(format!("the directive `{word}` is missing its `#`"))
        }
        _ => return None,
    };
    let named = matches!(word, "macro" | "def" | "func" | "fn" | "proc" | "sub" | "local");
    let names_left_undeclared =
        typed.split(|c: char| !is_name_char(c)).filter(|name| named && !name.is_empty()).map(str::to_string).collect();
    let loses_directive = !matches!(word, "end" | "break" | "local" | "undef" | "debug" | "warning" | "error");
    Some(CommonMistake { names_left_undeclared, loses_directive, ..habit.range(range).code(codes::UNKNOWN_DIRECTIVE) })
}
