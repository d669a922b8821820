//! `durer lsp`: runs the language server; see [`crate::lsp`].

use super::args::LspArgs;
use super::exit::{Exit, Failure, Result};
use crate::diagnostic::file;
use crate::lsp;
use crate::source::Disk;
use std::path::Path;

/// Serves an editor over standard input and output until it disconnects.
pub fn run(args: &LspArgs) -> Result {
    match lsp::serve(&args.include) {
        Ok(true) => Ok(Exit::Fine),
        // The editor disconnected without the shutdown request.
        Ok(false) => Err(Failure::Reported(Exit::Scene)),
        Err(error) => Err(Failure::Fault(Box::new(file::unwritable(&Disk, Path::new("standard output"), &error)))),
    }
}
