//! POV-Ray's command line in our words: `durer +Iscene.pov +W640 +H480 +A0.3` becomes
//! `durer render --aa=0.3 --size=640x480 -- scene.pov`. As with POV-Ray, there is no anti-aliasing unless `+A` asks for it.

mod parts;
mod table;
#[cfg(test)]
mod tests;

use super::Cli;
use super::exit::Result;
use crate::diagnostic::{Diagnostic, codes, nearest};
use crate::source::Span;
use clap::CommandFactory;
use parts::Parts;
use std::ffi::OsString;
use std::path::Path;
use table::{Effect, ROWS, Row, Takes};

/// The same command line with nothing but our own options, and what was left out of it. A command line that is ours already
/// comes back as it is.
pub fn translate(words: Vec<OsString>) -> Result<(Vec<OsString>, Vec<Diagnostic>)> {
    if is_ours(&words) {
        return Ok((words, Vec::new()));
    }
    if let [program, word] = &words[..]
        && ["-?", "+?", "-H", "+H"].iter().any(|help| word.eq_ignore_ascii_case(help))
    {
        return Ok((vec![program.clone(), "--help".into()], Vec::new()));
    }
    let mut translation = Translation::new();
    let mut rest = words.iter().skip(1);
    while let Some(word) = rest.next() {
        translation.word(word, &mut rest)?;
    }
    Ok(translation.finish(words.first().cloned().unwrap_or_default()))
}

/// Does a command of ours come first, or nothing but our options?
fn is_ours(words: &[OsString]) -> bool {
    let mut first = words
        .iter()
        .skip(1)
        .map(|w| w.to_string_lossy())
        .skip_while(|w| w.starts_with("--color=") || w == "-q" || w == "--quiet");
    let Some(mut word) = first.next() else {
        return true;
    };
    if word == "--color" {
        word = first.nth(1).unwrap_or_default();
    }
    let command = Cli::command();
    let names: Vec<_> = command.get_subcommands().map(clap::Command::get_name).chain(["help"]).collect();
    let is_option = word.starts_with("--") || word == "-h" || word == "-V";
    let is_plain = !word.contains(['+', '-', '=', '.', '/', '\\']) && !Path::new(&*word).exists();
    is_option || names.contains(&&*word) || is_plain && nearest(&word, names).is_some()
}

struct Translation {
    parts: Parts,
    /// Ours, as they came.
    options: Vec<OsString>,
    /// Was anything said in POV-Ray's way?
    any_switch: bool,
    warnings: Vec<Diagnostic>,
}

impl Translation {
    fn new() -> Self {
        Self { parts: Parts::new(), options: Vec::new(), any_switch: false, warnings: Vec::new() }
    }

    fn word<'a>(&mut self, word: &OsString, rest: &mut impl Iterator<Item = &'a OsString>) -> Result<()> {
        let text = word.to_string_lossy().into_owned();
        if let Some(takes_value) = own_option(&text) {
            self.options.push(word.clone());
            self.options.extend(rest.take(usize::from(takes_value)).cloned());
            return Ok(());
        }
        let switch = text.strip_prefix(['+', '-']).filter(|rest| !rest.is_empty());
        let setting =
            text.split_once('=').filter(|(name, _)| name.chars().all(|c| c.is_ascii_alphanumeric() || c == '_'));
        if let Some(rest) = switch {
            self.any_switch = true;
            let (row, value) = find_switch(rest).ok_or_else(|| unknown(&text))?;
            self.apply(row, &text, value, text.starts_with('+'))
        } else if let Some((name, value)) = setting {
            self.any_switch = true;
            let row = ROWS.iter().find(|row| row.ini.eq_ignore_ascii_case(name)).ok_or_else(|| unknown(&text))?;
            let value = value.trim_matches('"');
            match (row.takes, truth(value)) {
                (Takes::Number | Takes::Text, _) => self.apply(row, &text, value, true),
                (_, Some(on)) => self.apply(row, &text, "", on),
                _ => self.apply(row, &text, value, true),
            }
        } else {
            self.parts.input = Some(text);
            Ok(())
        }
    }

    fn apply(&mut self, row: &Row, text: &str, value: &str, on: bool) -> Result<()> {
        let needs = match row.takes {
            Takes::Number if value.parse::<f64>().is_err() => Some("a number"),
            Takes::Text if value.is_empty() => Some("something behind it, without a space"),
            _ => None,
        };
        if let Some(needs) = needs {
            return Err(wrong(text, &format!("it needs {needs}")));
        }
        match if on { row.on } else { row.off } {
            Effect::Same => Ok(()),
            Effect::Flag(flag) => {
                self.options.push(flag.into());
                Ok(())
            }
            Effect::Option(name) => {
                self.options.push(format!("{name}={value}").into());
                Ok(())
            }
            Effect::Part(put) => put(&mut self.parts, value).map_err(|reason| wrong(text, &reason)),
            Effect::Lacks(reason) => {
                let message = format!("`{text}` has no effect: {reason}");
                self.warnings.push(Diagnostic::new(codes::OPTION_IGNORED, Span::NONE, message));
                Ok(())
            }
        }
    }

    fn finish(self, program: OsString) -> (Vec<OsString>, Vec<Diagnostic>) {
        let mut words = vec![program, "render".into()];
        let parts = self.parts.options(self.any_switch).into_iter().map(OsString::from);
        let is_named = |part: &OsString| {
            let name = part.to_string_lossy().split('=').next().unwrap_or_default().to_string();
            self.options.iter().any(|o| o.to_string_lossy().split('=').next() == Some(&name))
        };
        // Anti-aliasing is off by default, which an option of ours overrides.
        words.extend(parts.filter(|part| !is_named(part)));
        words.extend(self.options.iter().cloned());
        if let Some(input) = self.parts.input {
            words.extend(["--".into(), with_ending(input).into()]);
        }
        (words, self.warnings)
    }
}

/// Is it one of our options for `render`, and does it take the next word? A short one is ours if nothing is attached, where
/// POV-Ray would need a value.
fn own_option(text: &str) -> Option<bool> {
    let command = Cli::command();
    let render = command.find_subcommand("render")?;
    let mut arguments = render.get_arguments().chain(command.get_arguments());
    let takes_value = |a: &clap::Arg| a.get_action().takes_values();
    if let Some(long) = text.strip_prefix("--").filter(|long| !long.is_empty()) {
        let found = arguments.find(|a| a.get_long() == Some(long));
        return Some(found.is_some_and(takes_value));
    }
    let mut letters = text.strip_prefix('-')?.chars();
    let (letter, None) = (letters.next()?, letters.next()) else {
        return None;
    };
    let theirs =
        find_switch(&letter.to_string()).is_some_and(|(row, _)| !matches!(row.takes, Takes::Number | Takes::Text));
    let found = arguments.find(|a| a.get_short() == Some(letter)).map(takes_value);
    if theirs { None } else { found.or((letter == 'h').then_some(false)) }
}

/// The row with the longest switch that the word begins with and whose value can be what is left of it.
fn find_switch(word: &str) -> Option<(&'static Row, &str)> {
    let fits = |row: &&Row| {
        let head =
            word.get(..row.switch.len()).filter(|head| !head.is_empty() && head.eq_ignore_ascii_case(row.switch));
        let value = &word[head?.len()..];
        let number = || value.is_empty() || value.parse::<f64>().is_ok();
        let fits = match row.takes {
            Takes::Nothing => value.is_empty(),
            Takes::Number | Takes::MaybeNumber => number(),
            Takes::Text | Takes::MaybeText => true,
        };
        fits.then_some(value)
    };
    let found = ROWS.iter().filter_map(|row| fits(&row).map(|value| (row, value)));
    found.max_by_key(|(row, _)| row.switch.len())
}

/// `on`, `true`, `yes` and `1`; `off`, `false`, `no` and `0`.
fn truth(value: &str) -> Option<bool> {
    let is = |words: [&str; 4]| words.iter().any(|w| w.eq_ignore_ascii_case(value));
    match () {
        () if is(["on", "true", "yes", "1"]) => Some(true),
        () if is(["off", "false", "no", "0"]) => Some(false),
        () => None,
    }
}

/// POV-Ray reads `scene.pov` when told `scene`.
fn with_ending(input: String) -> String {
    let with = format!("{input}.pov");
    if Path::new(&input).extension().is_none() && !Path::new(&input).exists() && Path::new(&with).exists() {
        with
    } else {
        input
    }
}

fn wrong(text: &str, reason: &str) -> super::Failure {
    let fault = Diagnostic::new(codes::UNKNOWN_OPTION, Span::NONE, format!("`{text}` is not understood: {reason}"));
    super::Failure::Fault(Box::new(fault))
}

fn unknown(text: &str) -> super::Failure {
    let (name, value) = text.split_once('=').map_or((text, ""), |(name, value)| (name, value));
    let known = ROWS.iter().map(|row| row.ini).filter(|ini| !ini.is_empty());
    let near = nearest(name.trim_start_matches(['+', '-']), known).map(|ini| format!("did you mean `{ini}={value}`?"));
    let help = near.unwrap_or("`durer render --help` lists durer's options".into());
    let fault = Diagnostic::new(codes::UNKNOWN_OPTION, Span::NONE, format!("there is no option `{text}`")).help(help);
    super::Failure::Fault(Box::new(fault))
}
