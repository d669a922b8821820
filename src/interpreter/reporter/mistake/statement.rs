//! Mistakes in statements, mostly habits from other languages.

use super::habit::CommonMistake;
use super::source_line::{SourceLine, is_name_char, shortened_value, split_leading_name, split_trailing_name};
use crate::diagnostic::{Diagnostic, codes};
use crate::syntax::word::lookup;

/// Returns the name at the start of the line, and the text after it; `None` for a keyword.
fn split_leading_non_keyword<'t>(source: &SourceLine<'t>) -> Option<(&'t str, &'t str)> {
    split_leading_name(source.line_without_comment())
        .filter(|(name, _)| lookup(name).is_none())
        .map(|(name, rest)| (name, rest.trim_start()))
}

/// Recognizes the mistake `F(x) = x*x` for a function definition.
pub(super) fn function_definition(source: &SourceLine, _: &Diagnostic) -> Option<CommonMistake> {
    let (name, rest) = split_leading_non_keyword(source)?;
    let (parameters, rest) = rest.strip_prefix('(')?.split_once(')')?;
    let value = rest.trim_start().strip_prefix('=').filter(|value| !value.starts_with('='))?;
    let is_list = parameters.split(',').all(|p| !p.trim().is_empty() && p.trim().chars().all(is_name_char));
    let sign = source.file_range_of(value).start - 1;
    let body = shortened_value(value);
    let habit =
        CommonMistake::with_help(format!("write `#declare {name} = function({}) {{ {body} }};`", parameters.trim()));
    let habit = habit.message(format!("`{name}(…) = …` defines no function")).range(sign..sign + 1);
    is_list.then(|| habit.code(codes::SYNTAX).leaving_undeclared(name))
}

/// Recognizes the mistake `I++` or `N += 2` for an assignment.
pub(super) fn in_place_assignment(source: &SourceLine, _: &Diagnostic) -> Option<CommonMistake> {
    let (name, rest) = split_leading_non_keyword(source)?;
    let start = source.trimmed_line_offset_in_file();
    let typed = rest.trim_end_matches(';').trim_end();
    let (sign, value, length) = match typed {
        "++" => ("+", "1".to_string(), 2),
        "--" => ("-", "1".to_string(), 2),
        _ => {
            let sign = ["+", "-", "*", "/"].into_iter().find(|sign| rest.starts_with(sign))?;
            (sign, shortened_value(rest[1..].strip_prefix('=')?), 2)
        }
    };
    let end = source.file_range_of(rest).start + length;
    let shown = &source.text[start..end];
    let habit = CommonMistake::with_help(format!("write `#declare {name} = {name} {sign} {value};`"));
    Some(habit.message(format!("`{shown}` does not change `{name}`")).range(start..end).code(codes::SYNTAX))
}

/// Recognizes the mistake `float A = 2;` or `let A = 2;` for a declaration.
pub(super) fn typed_variable(source: &SourceLine, _: &Diagnostic) -> Option<CommonMistake> {
    let (kind, rest) = split_leading_name(source.line_without_comment())?;
    let known = ["let", "var", "const", "int", "float", "double", "set", "auto", "vector", "string", "vec3"];
    let (name, rest) = split_leading_name(rest.trim_start()).filter(|_| known.contains(&kind))?;
    let value = rest.trim_start().strip_prefix('=')?;
    let start = source.trimmed_line_offset_in_file();
    let habit = CommonMistake::with_help(format!("write `#declare {name} = {};`", shortened_value(value)));
    let habit = habit.message(format!("`{kind}` declares nothing")).range(start..start + kind.len());
    Some(habit.code(codes::SYNTAX).leaving_undeclared(name))
}

/// Recognizes the mistake `Size = 3;`, an assignment without `#declare`.
pub(super) fn assignment_without_declare(source: &SourceLine, d: &Diagnostic) -> Option<CommonMistake> {
    let (name, rest) = split_leading_non_keyword(source)?;
    let value = rest.strip_prefix('=').filter(|value| !value.starts_with('='))?;
    let sign = source.file_range_of(value).start - 1;
    let inside = source.at <= sign + 1 && d.code != codes::UNKNOWN_DIRECTIVE;
    let habit = CommonMistake::with_help(format!(
        "to give `{name}` a value, write `#declare {name} = {};`",
        shortened_value(value)
    ));
    let habit = habit.message("`=` is not allowed here").range(sign..sign + 1);
    inside.then(|| habit.code(codes::SYNTAX).leaving_undeclared(name))
}

/// Recognizes the mistake `Ball translate 2*x` or `sphere { … } rotate y` outside of all braces.
pub(super) fn modifier_behind_object(source: &SourceLine, d: &Diagnostic) -> Option<CommonMistake> {
    let (word, _) = split_leading_name(source.rest_from_fault())?;
    if d.code != codes::UNKNOWN_WORD || !d.message.ends_with("outside of all braces") {
        return None;
    }
    let known = crate::scene::words::MODIFIERS;
    let modifies = known.has_effect(word) || crate::value::words::TRANSFORMS.iter().any(|w| w.name == word);
    let before = source.text[..source.at].trim_end();
    let message = |what: &str| format!("`{word}` follows {what}, which is complete");
    if let Some((_, name)) = split_trailing_name(before).filter(|(_, name)| modifies && lookup(name).is_none()) {
        let rest = shortened_value(source.rest_from_fault());
        let habit = CommonMistake::with_help(format!("write `object {{ {name} {rest} }}`"));
        return Some(habit.message(message(&format!("the object `{name}`"))));
    }
    let typed = shortened_value(source.rest_from_fault());
    let habit =
        CommonMistake::with_help(format!("put it before the `}}` of the object that it is for: `… {typed} }}`"));
    (modifies && before.ends_with('}')).then(|| habit.message(message("an object")))
}
