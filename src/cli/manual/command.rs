//! Manual pages about the command line and the diagnostic codes.

use super::{in_backticks, table};
use crate::cli::commands;
use crate::cli::povray::table::{Effect, ROWS, Row, Takes};
use crate::cli::povray::text_output::Stream;
use crate::diagnostic::codes::ALL;
use clap::Arg;

pub(super) fn options_page() -> String {
    let command = commands();
    let global = command.get_arguments().filter(|a| a.is_global_set()).map(option_row);
    let mut text = format!("## For every command\n\n{}", table(["option", ""], global));
    for sub in command.get_subcommands().filter(|c| !c.is_hide_set()) {
        let about = sub.get_about().map(ToString::to_string).unwrap_or_default();
        text += &format!("## durer {}\n\n{about}.\n\n", sub.get_name());
        let options: Vec<_> = sub.get_arguments().filter(|a| !a.is_hide_set() && !a.is_global_set()).collect();
        let mut headings: Vec<_> = options.iter().map(|a| a.get_help_heading()).collect();
        headings.sort_by_key(|heading| heading.is_some());
        let mut listed = vec![];
        for heading in headings {
            if !listed.contains(&heading) {
                let rows = options.iter().filter(|a| a.get_help_heading() == heading).map(|a| option_row(a));
                text += &table(["option", heading.unwrap_or_default()], rows);
                listed.push(heading);
            }
        }
    }
    text + "## POV-Ray's options\n\n\
            They stand on the command line as switches (`+W640`; `-` for `+` switches off) or as in an INI file (`Width=640`), \
            in any letter case. What durer can't obey gets a warning with the reason.\n\n"
        + &table(["switch", "INI", "in durer", "switched off"], ROWS.iter().map(povray_row))
}

fn option_row(arg: &Arg) -> [String; 2] {
    let values =
        arg.get_value_names().unwrap_or_default().iter().map(ToString::to_string).collect::<Vec<_>>().join(" ");
    let takes = arg.get_action().takes_values();
    let name = match (arg.get_short(), arg.get_long()) {
        (Some(short), Some(long)) => format!("-{short}, --{long}"),
        (None, Some(long)) => format!("--{long}"),
        (Some(short), None) => format!("-{short}"),
        (None, None) => String::new(),
    };
    let shown = if takes { format!("{name} {values}") } else { name };
    let default = arg.get_default_values().first().map(|d| format!(" [default: {}]", d.to_string_lossy()));
    let help = arg.get_help().map(ToString::to_string).unwrap_or_default();
    // Markdown interprets angle brackets.
    [in_backticks(shown.trim()), help.replace('<', "&lt;") + &described_values(arg) + &default.unwrap_or_default()]
}

/// Returns the values of an option with their descriptions, after `: `; empty if a value has none.
fn described_values(arg: &Arg) -> String {
    let values = arg.get_possible_values();
    if values.is_empty() || values.iter().any(|value| value.get_help().is_none()) {
        return String::new();
    }
    let each = values.iter().map(|v| {
        format!("{} ({})", in_backticks(v.get_name()), lower_first_letter(v.get_help().map(ToString::to_string)))
    });
    format!(": {}", each.collect::<Vec<_>>().join(", "))
}

fn lower_first_letter(text: Option<String>) -> String {
    let text = text.unwrap_or_default();
    let mut letters = text.chars();
    // Change `An INI file`, but not `INI files`.
    match (letters.next(), letters.next()) {
        (Some(first), Some(second)) if !second.is_uppercase() => {
            first.to_lowercase().to_string() + &text[first.len_utf8()..]
        }
        _ => text,
    }
}

fn povray_row(row: &Row) -> [String; 4] {
    let value = match row.takes {
        Takes::Nothing => "",
        Takes::Number => "N",
        Takes::MaybeNumber => "[N]",
        Takes::Text => "TEXT",
        Takes::MaybeText => "[TEXT]",
    };
    let switch = if row.switch.is_empty() { String::new() } else { in_backticks(&format!("+{}{value}", row.switch)) };
    let ini = if row.ini.is_empty() { String::new() } else { in_backticks(row.ini) };
    let (on, off) = (effect_text(&row.on), effect_text(&row.off));
    let off = if off == on { String::new() } else { off };
    [switch, ini, on, off]
}

fn effect_text(effect: &Effect) -> String {
    match effect {
        Effect::Same => "nothing to do".into(),
        Effect::Option(option) | Effect::Flag(option) | Effect::Whole(option, ..) => in_backticks(option),
        Effect::Part(_) => "obeyed".into(),
        Effect::TextFile(stream) => format!("copies the {} text into a file", stream.name()),
        Effect::Silence(Stream::All) => in_backticks("--quiet"),
        Effect::Silence(Stream::Fatal) => "ignored: errors are always printed".into(),
        Effect::Silence(stream) => format!("does not print the {} text", stream.name()),
        Effect::Lacks(why) => format!("ignored: {why}"),
        Effect::Idle(why) => format!("ignored in silence: {why}"),
    }
}

pub(super) fn codes_page() -> String {
    let intro = "Every message has a code. `durer explain E0203` prints what stands here. `E…` is an error, `W…` a warning.\n\n";
    let each = ALL.iter().map(|e| format!("## {}: {}\n\n{}\n\n", e.code, e.title, e.text));
    intro.to_string() + each.collect::<String>().trim_end() + "\n"
}
