//! `durer lsp`: see [`crate::lsp`].

use super::args::LspArgs;
use super::exit::{Exit, Failure, Result};
use crate::diagnostic::file;
use crate::lsp;
use crate::source::Disk;
use std::path::Path;

/// Serves the editor at the other end of standard input and output until it leaves.
pub fn run(args: &LspArgs) -> Result {
    match lsp::serve(&args.include) {
        Ok(true) => Ok(Exit::Fine),
        // It left without a word.
        Ok(false) => Err(Failure::Told(Exit::Scene)),
        Err(error) => Err(Failure::Fault(Box::new(file::unwritable(&Disk, Path::new("standard output"), &error)))),
    }
}
