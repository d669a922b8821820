//! Mistakes with operators, vectors and indices, mostly habits from other languages.

use super::habit::CommonMistake;
use super::source_line::{
    SourceLine, is_name_char, shortened_value, split_leading_name, split_trailing_name, without_comment,
};
use crate::diagnostic::{Diagnostic, codes};
use crate::syntax::word::lookup;

/// Recognizes the mistake `A <> B` for a comparison.
pub(super) fn not_equal(source: &SourceLine, d: &Diagnostic) -> Option<CommonMistake> {
    // The fault may be at either sign.
    let from = source.at.saturating_sub(1).max(source.line.start);
    let at =
        from + source.text.get(from..source.line.end)?.find("<>").filter(|i| *i <= 1 && d.code == codes::SYNTAX)?;
    let (left, right) = (trailing_operand(&source.text[source.line.start..at]), &source.text[at + 2..source.line.end]);
    let right = right.trim_start();
    let right = &right[..right.find(|c: char| !is_name_char(c) && c != '.').unwrap_or(right.len())];
    let habit = CommonMistake::with_help(format!("write `{left} != {right}`")).message("`<>` does not compare");
    Some(habit.range(at..at + 2).code(codes::SYNTAX))
}

fn trailing_operand(text: &str) -> &str {
    let text = text.trim_end();
    &text[text.trim_end_matches(|c: char| is_name_char(c) || c == '.').len()..]
}

/// Recognizes C's operators `&&`, `||` and `==`.
pub(super) fn doubled_operator(source: &SourceLine, d: &Diagnostic) -> Option<CommonMistake> {
    // The fault is at the second sign.
    let at = source.at.checked_sub(1).filter(|_| d.code == codes::SYNTAX)?;
    let typed = source.text.get(at..at + 2)?;
    let help = match typed {
        "&&" => "a single `&` is the logical and",
        "||" => "a single `|` is the logical or",
        "==" => "a single `=` compares",
        _ => return None,
    };
    Some(CommonMistake::with_help(help).message(format!("`{typed}` is not allowed here")))
}

/// Recognizes the mistake `A + ;`, without a right operand.
pub(super) fn operator_at_end(source: &SourceLine, d: &Diagnostic) -> Option<CommonMistake> {
    let before = source.text[..source.at].trim_end().strip_suffix(';').filter(|_| d.code == codes::EXPECTED_VALUE)?;
    let sign = before.trim_end().chars().next_back().filter(|c| "+-*/".contains(*c))?;
    let habit = CommonMistake::with_help("an operator needs a value on both sides");
    Some(habit.message(format!("expected a value after `{sign}`, found `;`")).range(before.len()..before.len() + 1))
}

/// Recognizes the mistakes `A and B`, `not A` and `A mod 2`.
pub(super) fn operator_as_word(source: &SourceLine, d: &Diagnostic) -> Option<CommonMistake> {
    let (word, right) = split_leading_name(source.rest_from_fault())?;
    let left = source.before_fault().trim_end();
    let message = |sign: &str, what: &str| format!("{what} is `{sign}`");
    let habit = match word.to_ascii_lowercase().as_str() {
        "and" => CommonMistake::with_help(message("&", "the logical and")),
        "or" => CommonMistake::with_help(message("|", "the logical or")),
        "not" => CommonMistake::with_help(format!("the logical not is `!`: `!{}`", leading_operand(right))),
        "mod" if !right.trim_start().starts_with('(') => CommonMistake::with_help(format!(
            "the remainder is `mod({}, {})`",
            trailing_operand(left),
            leading_operand(right)
        )),
        "then" if left.ends_with(')') => {
            CommonMistake::with_help("the condition is followed by what depends on it, and then `#end`")
        }
        _ => return None,
    };
    let tells = matches!(
        d.code,
        codes::UNDECLARED | codes::UNKNOWN_WORD | codes::EXPECTED | codes::EXPECTED_VALUE | codes::SYNTAX
    );
    let habit = habit.message(format!("`{word}` is no operator")).range(source.at..source.at + word.len());
    tells.then(|| habit.code(codes::SYNTAX))
}

fn leading_operand(text: &str) -> &str {
    let text = text.trim_start();
    &text[..text.find(|c: char| !is_name_char(c) && c != '.').unwrap_or(text.len())]
}

/// Recognizes the mistake `phong = 0.5`, with a sign between word and value.
pub(super) fn equal_behind_word(source: &SourceLine, d: &Diagnostic) -> Option<CommonMistake> {
    let value = source.rest_from_fault().strip_prefix('=').filter(|_| d.code == codes::SYNTAX)?;
    let (before, word) = split_trailing_name(source.before_fault().trim_end())?;
    let plain = lookup(word).is_some() && !before.trim_end().ends_with('#') && !before.trim_end().ends_with("declare");
    let value = shortened_value(value.split(['}', ';']).next().unwrap_or_default());
    let habit = CommonMistake::with_help(format!("a value directly follows its word: `{word} {value}`"));
    plain.then(|| habit.message(format!("`=` is not allowed after `{word}`")))
}

/// Recognizes the mistake `A[0,1]`, with two indices in one bracket.
pub(super) fn index_with_comma(source: &SourceLine, d: &Diagnostic) -> Option<CommonMistake> {
    if !matches!(d.code, codes::EXPECTED | codes::SYNTAX | codes::WRONG_COUNT) {
        return None;
    }
    let line = &source.text[source.line.clone()];
    let from = source.at - source.line.start;
    let open = line[..from].rfind('[')?;
    let close = open + line[open..].find(']')?;
    let (_, name) = split_trailing_name(&line[..open])?;
    let indices: Vec<&str> = line[open + 1..close].split(',').map(str::trim).collect();
    if close < from || indices.len() < 2 || indices.iter().any(|index| index.is_empty()) {
        return None;
    }
    let written: String = indices.iter().map(|index| format!("[{index}]")).collect();
    let start = source.line.start + open - name.len();
    let habit = CommonMistake::with_help(format!("write `{name}{written}`"));
    let habit = habit.message("each index of an array has its own brackets");
    Some(habit.range(start..source.line.start + close + 1))
}

/// Recognizes the mistake `<-1 -1 -1>`, a vector without commas.
pub(super) fn vector_without_commas(source: &SourceLine, d: &Diagnostic) -> Option<CommonMistake> {
    let text = source.text.get(source.at..source.end).filter(|_| d.code == codes::WRONG_COUNT)?;
    let inside = text.strip_prefix('<')?.strip_suffix('>')?;
    let numbers: Vec<&str> = inside.split([' ', '\t', ',']).filter(|n| !n.is_empty()).collect();
    let signed = numbers.iter().skip(1).any(|n| n.starts_with(['-', '+']));
    let plain =
        numbers.iter().all(|n| n.trim_start_matches(['-', '+']).starts_with(|c: char| is_name_char(c) || c == '.'));
    if !signed || !plain || !(2..=5).contains(&numbers.len()) {
        return None;
    }
    let commas = numbers.join(", ");
    Some(CommonMistake::with_help(format!(
        "put commas between the numbers: `<{commas}>`; a sign without a comma before it subtracts"
    )))
}

/// Recognizes the mistake `translate 1, 2, 3`, without angle brackets.
pub(super) fn list_behind_word(source: &SourceLine, d: &Diagnostic) -> Option<CommonMistake> {
    if d.code != codes::EXPECTED {
        return None;
    }
    let before = source.before_fault().trim_end().strip_suffix(',')?;
    let start = before.trim_end_matches(|c: char| c.is_ascii_digit() || " .,-+".contains(c)).len();
    let (_, word) = split_trailing_name(&before[..start])?;
    if !matches!(word, "translate" | "rotate" | "scale" | "location" | "look_at" | "rgb") {
        return None;
    }
    let rest = without_comment(source.rest_from_fault());
    let rest = rest[..rest.find(|c: char| !c.is_ascii_digit() && !" .,-+".contains(c)).unwrap_or(rest.len())].trim();
    let numbers = format!("{}, {rest}", before[start..].trim());
    let habit = CommonMistake::with_help(format!(
        "a vector is written in angle brackets: `{word} <{}>`",
        numbers.trim_end_matches([',', ' '])
    ));
    Some(habit.message(format!("`{word}` takes one value, found a list")))
}

/// Recognizes the mistake `rgb(1, 0, 0)`, a colour in parentheses.
pub(super) fn list_in_parentheses(source: &SourceLine, d: &Diagnostic) -> Option<CommonMistake> {
    let inside = source.rest_from_fault().strip_prefix('(').filter(|_| d.code == codes::EXPECTED)?;
    let (numbers, _) = inside.split_once(')')?;
    let plain = numbers.contains(',') && !numbers.contains('(');
    let word = split_trailing_name(source.before_fault().trim_end()).map_or("", |(_, word)| word);
    let space = if word.is_empty() { "" } else { " " };
    let help = format!("vectors are written in angle brackets: `{word}{space}<{}>`", numbers.trim());
    (plain && (word.is_empty() || lookup(word).is_some())).then(|| CommonMistake::with_help(help))
}

/// Recognizes the mistake `sphere { [0, 1, 2], 1 }`, with square brackets.
pub(super) fn square_vector(source: &SourceLine, d: &Diagnostic) -> Option<CommonMistake> {
    let inside = source
        .rest_from_fault()
        .strip_prefix('[')
        .filter(|_| d.code == codes::EXPECTED && d.message.contains("a vector"))?;
    let (numbers, _) = inside.split_once(']')?;
    Some(CommonMistake::with_help(format!("vectors are written in angle brackets: `<{}>`", numbers.trim())))
}
