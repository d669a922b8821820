//! How the program ends.

use crate::diagnostic::{Code, Fault, codes};

/// The exit codes (`durer help` lists them).
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Exit {
    /// All is well.
    Fine = 0,
    /// The scene is wrong.
    Scene = 1,
    /// The command line is wrong.
    Usage = 2,
    /// A snapshot differs.
    Snapshot = 3,
    /// A limit was reached.
    Limit = 4,
    /// A file could not be read or written.
    File = 5,
    /// Ctrl-C.
    Interrupted = 130,
}

impl Exit {
    /// For an error that is not in the scene's text.
    pub fn of(code: Code) -> Exit {
        match code {
            codes::FILE_NOT_FOUND | codes::FILE_UNREADABLE | codes::FILE_UNWRITABLE | codes::PICTURE_BROKEN => {
                Exit::File
            }
            codes::PICTURE_TOO_LARGE | codes::TIME_LIMIT => Exit::Limit,
            codes::UNKNOWN_FORMAT | codes::FORMAT_LIMIT | codes::OUTSIDE_PICTURE | codes::UNKNOWN_OPTION => Exit::Usage,
            codes::INI_SYNTAX | codes::NO_SCENE | codes::INI_LOOP => Exit::Usage,
            _ => Exit::Scene,
        }
    }
}

/// Why a command ends before its end.
#[derive(Debug)]
pub enum Failure {
    /// To be told; without a place in a text.
    Fault(Fault),
    /// To be told as clap does.
    Usage(Box<clap::Error>),
    /// All was told already.
    Told(Exit),
    /// Whoever reads our output has left.
    NobodyListens,
}

/// What commands return.
pub type Result<T = Exit> = std::result::Result<T, Failure>;

impl From<Fault> for Failure {
    fn from(fault: Fault) -> Self {
        Failure::Fault(fault)
    }
}

/// A command line that contradicts itself, told as clap would.
pub fn usage<T>(message: impl std::fmt::Display) -> Result<T> {
    use clap::CommandFactory;
    let error = super::Cli::command().error(clap::error::ErrorKind::ArgumentConflict, message);
    Err(Failure::Usage(Box::new(error)))
}
