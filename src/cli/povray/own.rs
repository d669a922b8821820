//! Options of durer on a command line with POV-Ray options.

use super::find_switch;
use super::table::Takes;
use crate::cli::commands;
use std::ffi::OsString;

/// An option of durer on a command line.
pub struct DurerOption {
    /// Long name of a durer option, such as `--output`.
    pub name: String,
    /// Words of the durer option on the command line: its name and its value.
    pub words: Vec<OsString>,
}

impl DurerOption {
    /// Creates the durer option that `word` is, of the form `--name` or `--name=value`.
    pub fn new(word: String) -> Self {
        let name = word.split('=').next().unwrap_or_default().to_string();
        Self { name, words: vec![word.into()] }
    }
}

/// Removes all but the last occurrence of options that POV-Ray accepts twice, such as `+Q3` and `+Q9`.
pub fn drop_overridden(options: Vec<DurerOption>) -> Vec<DurerOption> {
    const OVERRIDABLE: &[&str] =
        &["--quality", "--threads", "--progress", "--header", "--quiet", "--no-output", "--language"];
    let names: Vec<_> = options.iter().map(|o| o.name.clone()).collect();
    let again = |i: usize| OVERRIDABLE.contains(&&*names[i]) && names[i + 1..].contains(&names[i]);
    options.into_iter().enumerate().filter(|(i, _)| !again(*i)).map(|(_, option)| option).collect()
}

/// Returns the long name of durer's option `text`, and true if the next word is its value; `None` for other words. Every
/// `--name` counts as durer's, known or not. A short option of durer counts unless POV-Ray has an option of the same
/// letter that is valid without a value. `-j` counts only if a number follows, attached or as the next word.
pub fn name_and_takes_next(text: &str, next: Option<&str>) -> Option<(String, bool)> {
    let command = commands();
    let render = command.find_subcommand("render")?;
    let mut arguments = render.get_arguments().chain(command.get_arguments());
    let takes_value = |a: &clap::Arg| a.get_action().takes_values();
    if let Some(long) = text.strip_prefix("--").filter(|long| !long.is_empty()) {
        let found = arguments.find(|a| a.get_long() == Some(long));
        let name = text.split('=').next().unwrap_or_default().to_string();
        return Some((name, found.is_some_and(takes_value)));
    }
    let is_number = |text: &str| !text.is_empty() && text.bytes().all(|b| b.is_ascii_digit());
    match text.strip_prefix("-j") {
        Some("") if next.is_some_and(is_number) => return Some(("--threads".into(), true)),
        Some(digits) if is_number(digits) => return Some(("--threads".into(), false)),
        _ => {}
    }
    let mut letters = text.strip_prefix('-')?.chars();
    let (letter, None) = (letters.next()?, letters.next()) else {
        return None;
    };
    let theirs =
        find_switch(&letter.to_string()).is_some_and(|(row, _)| !matches!(row.takes, Takes::Number | Takes::Text));
    let found = arguments.find(|a| a.get_short() == Some(letter)).filter(|_| !theirs);
    let name = |a: &clap::Arg| format!("--{}", a.get_long().unwrap_or_default());
    found.map(|a| (name(a), takes_value(a))).or((letter == 'h').then(|| ("--help".into(), false)))
}
