//! The command `durer completions SHELL`: prints a script that completes durer's options.

use super::Cli;
use super::args::CompletionsArgs;
use super::console::Console;
use super::exit::{Exit, Result};
use clap::CommandFactory;

/// Prints the shell's completion script for the command `durer`.
pub fn run(console: &Console, args: &CompletionsArgs) -> Result {
    let mut script = Vec::new();
    clap_complete::generate(args.shell, &mut Cli::command(), "durer", &mut script);
    console.write_to_stdout(script)?;
    Ok(Exit::Fine)
}
