//! The error about a command that does not exist.

use super::exit::Failure;
use super::povray::{first_index_and_word, is_ini};
use super::{Cli, commands, session};
use crate::diagnostic::nearest;
use clap::CommandFactory;
use std::ffi::OsString;
use std::path::Path;

/// Names of commands in other programs, each with durer's command for the same purpose.
const OTHERS: &[(&str, &str)] = &[
    ("draw", "render"),
    ("run", "render"),
    ("trace", "render"),
    ("raytrace", "render"),
    ("build", "render"),
    ("animate", "render"),
    ("lint", "check"),
    ("validate", "check"),
    ("verify", "check"),
    ("parse", "check"),
    ("compare", "test"),
    ("diff", "test"),
    ("probe", "pick"),
    ("inspect", "pick"),
    ("why", "explain"),
    ("error", "explain"),
    ("format", "fmt"),
    ("pretty", "fmt"),
    ("indent", "fmt"),
    ("tidy", "fmt"),
    ("language-server", "lsp"),
    ("init", "new"),
    ("create", "new"),
    ("list", "query"),
    ("info", "query"),
    ("show", "watch"),
    ("preview", "watch"),
    ("serve", "watch"),
    ("live", "watch"),
    ("complete", "completions"),
];

/// Returns an error if the first word looks like a command but is neither a command nor a file.
pub fn check_command_name(words: &[OsString]) -> Result<(), Failure> {
    let Some((at, word)) = first_index_and_word(words) else { return Ok(()) };
    let command = commands();
    let is_plain = word.starts_with(char::is_alphabetic) && !word.contains(['=', '.', '/', '\\', '[']);
    let is_file = || session::existing_scene_path(Path::new(&word)).exists() || is_ini(&word);
    if !is_plain || word == "help" || command.find_subcommand(&word).is_some() || is_file() {
        return Ok(());
    }
    let names = || command.get_subcommands().filter(|c| !c.is_hide_set()).map(clap::Command::get_name);
    let other = OTHERS.iter().find(|(other, _)| other.eq_ignore_ascii_case(&word)).map(|(_, ours)| *ours);
    let near = names().find(|name| name.eq_ignore_ascii_case(&word)).or(other).or_else(|| nearest(&word, names()));
    let message = match near {
        Some(near) => {
            let rest: String = words[at + 1..].iter().map(|word| format!(" {}", word.to_string_lossy())).collect();
            format!("there is no command `{word}`; did you mean `durer {near}{rest}`?")
        }
        None => {
            let list: Vec<_> = names().map(|name| format!("`{name}`")).collect();
            format!("there is no command `{word}`, and no scene with this name; the commands are {}", list.join(", "))
        }
    };
    Err(Failure::Usage(Box::new(Cli::command().error(clap::error::ErrorKind::InvalidSubcommand, message))))
}
