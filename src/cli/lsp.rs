//! The command `durer lsp`: runs the language server; see [`crate::lsp`].

use super::args::LspArgs;
use super::console::print_message;
use super::exit::{Exit, Failure, Result};
use crate::diagnostic::file;
use crate::lsp::{self, End};
use crate::source::Disk;
use std::io::IsTerminal;
use std::path::Path;

/// Serves an editor over standard input and output until the editor disconnects.
pub fn run(args: &LspArgs) -> Result {
    if std::io::stdin().is_terminal() {
        print_message(
            "durer lsp: an editor starts this command and sends messages to standard input (Ctrl-D ends it)\n",
        );
    }
    let failure = |fault| Err(Failure::Fault(Box::new(fault)));
    match lsp::serve(&args.include) {
        Ok(End::ShutDown) => Ok(Exit::Fine),
        Ok(End::Disconnected) => {
            print_message("durer lsp: the editor disconnected without the request `shutdown`\n");
            Err(Failure::Reported(Exit::Scene))
        }
        Ok(End::Unreadable(error)) => failure(file::unreadable(&Disk, Path::new("standard input"), &error.into())),
        Ok(End::Unwritable(error)) | Err(error) => {
            failure(file::unwritable(&Disk, Path::new("standard output"), &error))
        }
    }
}
