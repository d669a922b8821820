//! Exit codes, and the reasons for which a command ends early.

use crate::diagnostic::{Code, Fault, codes};
use std::sync::atomic::{AtomicBool, Ordering::Relaxed};

/// Exit codes of the program (`durer help` lists them).
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Exit {
    /// Exit code for success.
    Fine = 0,
    /// Exit code for errors in the scene.
    Scene = 1,
    /// Exit code for errors in the command line.
    Usage = 2,
    /// Exit code for a picture that differs from its snapshot.
    Snapshot = 3,
    /// Exit code for a reached limit.
    Limit = 4,
    /// Exit code for a file that could not be read or written.
    File = 5,
    /// Exit code after the signal HUP: the terminal was closed.
    HungUp = 129,
    /// Exit code after Ctrl-C, the signal INT.
    Interrupted = 130,
    /// Exit code after the signal TERM.
    Terminated = 143,
    /// Exit code after the signal XFSZ: a file reached the size limit of the process.
    FileSizeLimit = 153,
}

/// Signal after which a command stores what is done, reports it and ends.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Signal {
    /// Number of the signal on Unix.
    pub number: i32,
    /// Exit code of a command that this signal ends.
    pub exit: Exit,
    /// Reason of the end, for the message.
    pub reason: &'static str,
    /// True if the signal is left alone in a process that was started with the signal ignored, as by `nohup`.
    pub may_be_ignored: bool,
}

/// All signals that end a command in good order. The exit codes are those of shells: 128 and the signal's number.
pub const SIGNALS: &[Signal] = &[
    Signal { number: 1, exit: Exit::HungUp, reason: "the terminal was closed", may_be_ignored: true },
    Signal { number: 2, exit: Exit::Interrupted, reason: "interrupted", may_be_ignored: false },
    Signal { number: 15, exit: Exit::Terminated, reason: "terminated", may_be_ignored: false },
    Signal {
        number: FILE_SIZE_LIMIT,
        exit: Exit::FileSizeLimit,
        reason: "a file reached the size limit of the process",
        may_be_ignored: true,
    },
];

/// Number of the signal XFSZ.
pub const FILE_SIZE_LIMIT: i32 = 25;

/// True if the process ends with POV-Ray's exit codes.
static ENDS_LIKE_POVRAY: AtomicBool = AtomicBool::new(false);

/// Lets the process end with POV-Ray's exit codes, for programs that drive POV-Ray.
pub fn use_povray_codes() {
    ENDS_LIKE_POVRAY.store(true, Relaxed);
}

impl Exit {
    /// Returns the number with which the process ends. POV-Ray has 0 for success, 1 for errors, and 2 for an interruption.
    pub fn number(self) -> u8 {
        match self {
            _ if !ENDS_LIKE_POVRAY.load(Relaxed) => self as u8,
            Self::Fine => 0,
            _ if self.is_signal() => 2,
            _ => 1,
        }
    }

    /// True for the exit code of a command that a signal has ended.
    pub fn is_signal(self) -> bool {
        SIGNALS.iter().any(|signal| signal.exit == self)
    }

    /// The exit code of an error outside of the scene's text.
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

/// Reason for which a command ends early.
#[derive(Debug)]
pub enum Failure {
    /// A fault that is not reported yet, without a position in a text.
    Fault(Fault),
    /// An error of the command line, which clap prints.
    Usage(Box<clap::Error>),
    /// Failure of a command whose messages are all printed already.
    Reported(Exit),
    /// Failure of a command because the reader of standard output is gone.
    BrokenPipe,
}

/// Result of a command: its exit code or its failure.
pub type Result<T = Exit> = std::result::Result<T, Failure>;

impl From<Fault> for Failure {
    fn from(fault: Fault) -> Self {
        Failure::Fault(fault)
    }
}

/// The error for a contradictory command line, in the form of clap's own errors.
pub fn usage<T>(message: impl std::fmt::Display) -> Result<T> {
    use clap::CommandFactory;
    let error = super::Cli::command().error(clap::error::ErrorKind::ArgumentConflict, message);
    Err(Failure::Usage(Box::new(error)))
}
