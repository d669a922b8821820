//! Decides whether a command line is durer's or POV-Ray's, and translates POV-Ray options after a durer command.

use super::own::DurerOption;
use super::{Origin, Translated, Translation, find_switch};
use crate::cli::commands;
use clap::Command;
use std::ffi::OsString;
use std::path::Path;

/// Form of a command line: durer's options, POV-Ray's, or both.
#[derive(Debug, PartialEq)]
pub enum Form {
    /// Command line with durer's own options only.
    Durer,
    /// A command of durer followed by POV-Ray options; the number is the index of the command's word.
    Mixed(usize),
    /// Command line of POV-Ray options without a durer command.
    Povray,
}

/// Determines the form of a command line.
pub fn command_line_form(words: &[OsString]) -> Form {
    let Some((at, first)) = first_index_and_word(words) else { return Form::Durer };
    let command = commands();
    // `-V` before other words is POV-Ray's.
    if ["--help", "-h", "--version", "help"].contains(&&*first) || first == "-V" && words.len() == at + 1 {
        return Form::Durer;
    }
    match command.find_subcommand(&first) {
        Some(command) if accepts_povray_options(command) => {
            let is_povray = mark_povray_options(command, &words[at + 1..]).iter().any(|(_, is_povray)| *is_povray);
            if is_povray { Form::Mixed(at) } else { Form::Durer }
        }
        Some(_) => Form::Durer,
        None => Form::Povray,
    }
}

/// Returns the first word after the options that all commands have, and its index.
pub fn first_index_and_word(words: &[OsString]) -> Option<(usize, String)> {
    let mut at = 1;
    loop {
        let word = words.get(at)?.to_string_lossy().into_owned();
        match &*word {
            "-q" | "--quiet" => at += 1,
            "--color" => at += 2,
            _ if word.starts_with("--color=") => at += 1,
            _ => return Some((at, word)),
        }
    }
}

/// True if the word is a command that accepts POV-Ray's options, `render`, `check` or `pick`, and no file has this name.
pub fn accepts_povray_words(command: &str) -> bool {
    commands().find_subcommand(command).is_some_and(accepts_povray_options) && !Path::new(command).exists()
}

fn accepts_povray_options(command: &Command) -> bool {
    ["render", "check", "pick"].contains(&command.get_name())
}

/// True if `durer_word` is a long option that the subcommand of durer takes, such as `--width=640`, or is no
/// long option. The subcommands `check` and `pick` lack the options for pictures.
pub fn subcommand_accepts_word(subcommand: &str, durer_word: &str) -> bool {
    let all = commands();
    let name = durer_word.split('=').next().and_then(|word| word.strip_prefix("--"));
    let own = all.find_subcommand(subcommand).into_iter().flat_map(Command::get_arguments);
    name.is_none() || own.chain(all.get_arguments()).any(|a| a.get_long() == name)
}

/// Splits the words after a command into options, each with a flag that is true for POV-Ray options.
fn mark_povray_options<'a>(command: &Command, words: &'a [OsString]) -> Vec<(&'a OsString, bool)> {
    let global = commands();
    let arguments: Vec<_> = command.get_arguments().chain(global.get_arguments()).collect();
    let takes_value = |a: &&clap::Arg| a.get_action().takes_values();
    let (mut out, mut is_value, mut is_over) = (vec![], false, false);
    for word in words {
        let text = word.to_string_lossy();
        let (dashes, name) = (text.starts_with("--"), text.trim_start_matches('-'));
        let short = || text.strip_prefix('-').and_then(|s| s.chars().next());
        let own_option = match dashes {
            true => arguments.iter().find(|a| a.get_long() == Some(name)),
            false => arguments.iter().find(|a| a.get_short().is_some() && a.get_short() == short()),
        };
        let is_povray = !is_value && !is_over && !dashes && own_option.is_none() && is_povray_option(&text);
        is_over |= !is_value && text == "--";
        is_value = !is_value && own_option.is_some_and(takes_value) && (dashes || text.chars().count() == 2);
        out.push((word, is_povray));
    }
    out
}

/// True for any word after `+`, for a known POV-Ray switch after `-`, and for `Name=Value`, unless a file has this name.
fn is_povray_option(text: &str) -> bool {
    if Path::new(text).exists() {
        return false;
    }
    if let Some(rest) = text.strip_prefix('+') {
        return !rest.is_empty();
    }
    if let Some(rest) = text.strip_prefix('-') {
        return !rest.is_empty() && !rest.starts_with(['h', 'V']) && find_switch(rest).is_some();
    }
    let is_name = |name: &str| !name.is_empty() && name.chars().all(|c| c.is_ascii_alphanumeric() || c == '_');
    text.split_once('=').is_some_and(|(name, _)| is_name(name))
}

impl Translation<'_> {
    /// Translates the POV-Ray options after a durer command, and puts them before durer's own, which have precedence. The
    /// default of anti-aliasing is durer's unless `+A` or `-A` is given.
    pub(super) fn translate_mixed(mut self, words: &[OsString], command_index: usize) -> Translated {
        let all = commands();
        let Some(command) = words.get(command_index).and_then(|word| all.find_subcommand(word)) else {
            return self.into_translated("durer".into());
        };
        let mut own = Vec::new();
        for (word, is_povray) in mark_povray_options(command, &words[command_index + 1..]) {
            match is_povray {
                true => self.translate_option(&word.to_string_lossy(), Origin::default()),
                false => own.push(word.clone()),
            }
        }
        // An option of durer's own has precedence over one of POV-Ray's.
        let is_set = |name: &str| {
            let short =
                command.get_arguments().find(|a| name.strip_prefix("--") == a.get_long()).and_then(|a| a.get_short());
            let is_short = |w: &str| short.is_some_and(|c| w.starts_with(&format!("-{c}")));
            let mut words = own.iter().map(|w| w.to_string_lossy());
            name != "--include"
                && name != "--declare"
                && words.any(|w| w.split('=').next() == Some(name) || is_short(&w))
        };
        self.translate_text_stream_options();
        let options =
            self.take_option_words(false).into_iter().map(|word| DurerOption::new(word.to_string_lossy().into_owned()));
        let options = options
            .filter(|own| subcommand_accepts_word(command.get_name(), &own.name) && !is_set(&own.name))
            .flat_map(|own| own.words);
        let named = self.settings.input.take().map(OsString::from);
        let words =
            words[..=command_index].iter().cloned().chain(options).chain(named).chain(own.iter().cloned()).collect();
        let animation = self.settings.animation();
        Translated { words, animation, diagnostics: self.faults, idle: self.idle, ..Translated::default() }
    }
}
