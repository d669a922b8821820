//! Exit codes, and failures that end a command early.

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
    /// Exit code for a shard that the signal TERM ended: the same command continues it (`EX_TEMPFAIL` of sysexits.h).
    TryAgain = 75,
    /// Exit code after the signal HUP: the terminal was closed.
    HungUp = 129,
    /// Exit code after Ctrl-C, the signal INT.
    Interrupted = 130,
    /// Exit code after the signal TERM.
    Terminated = 143,
    /// Exit code after the signal XFSZ: a file reached the size limit of the process.
    FileSizeLimit = 153,
}

/// A signal after which a command stores its results, reports the signal and ends.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Signal {
    /// Number of the signal on Unix.
    pub number: i32,
    /// Exit code of a command that ends because of this signal.
    pub exit: Exit,
    /// Reason of the signal, for the message.
    pub reason: &'static str,
    /// True if durer does not handle the signal in a process that was started with the signal ignored, as by `nohup`.
    pub may_be_ignored: bool,
}

/// All signals after which commands store their results and end, with the exit codes of shells: 128 plus the number.
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

/// True if the process uses POV-Ray's exit codes.
static ENDS_LIKE_POVRAY: AtomicBool = AtomicBool::new(false);

/// Makes the process use POV-Ray's exit codes, for programs that start POV-Ray.
pub fn use_povray_codes() {
    ENDS_LIKE_POVRAY.store(true, Relaxed);
}

/// True if the process ends with [`Exit::TryAgain`] after the signal TERM.
static ASKS_FOR_ANOTHER_TRY: AtomicBool = AtomicBool::new(false);

/// Makes the process end with [`Exit::TryAgain`] after the signal TERM, for schedulers that requeue tasks.
pub fn request_retry_on_term() {
    ASKS_FOR_ANOTHER_TRY.store(true, Relaxed);
}

impl Exit {
    /// Returns the number with which the process ends. After [`use_povray_codes`], 0 is success, 1 any error, and 2 the end by
    /// a signal. After [`request_retry_on_term`], the signal TERM has the number of [`Exit::TryAgain`].
    pub fn number(self) -> u8 {
        match self {
            Self::Terminated if ASKS_FOR_ANOTHER_TRY.load(Relaxed) => Self::TryAgain as u8,
            _ if !ENDS_LIKE_POVRAY.load(Relaxed) => self as u8,
            Self::Fine => 0,
            _ if self.is_signal() => 2,
            _ => 1,
        }
    }

    /// True for the exit code of a command that a signal ended.
    pub fn is_signal(self) -> bool {
        SIGNALS.iter().any(|signal| signal.exit == self)
    }

    /// Returns the exit code for an error with this diagnostic code: [`Exit::Scene`], unless the error is about a file, a
    /// limit or the command line.
    pub fn of(code: Code) -> Exit {
        match code {
            codes::FILE_NOT_FOUND | codes::FILE_UNREADABLE | codes::FILE_UNWRITABLE | codes::PICTURE_BROKEN => {
                Exit::File
            }
            codes::PICTURE_TOO_LARGE | codes::TIME_LIMIT => Exit::Limit,
            codes::UNKNOWN_FORMAT | codes::FORMAT_LIMIT | codes::OUTSIDE_PICTURE | codes::UNKNOWN_OPTION => Exit::Usage,
            codes::INI_SYNTAX | codes::NO_SCENE | codes::INI_LOOP | codes::OTHER_PREPARATION => Exit::Usage,
            _ => Exit::Scene,
        }
    }
}

/// Failure that ends a command early.
#[derive(Debug)]
pub enum Failure {
    /// An error without a position in a text, which is not reported yet.
    Fault(Fault),
    /// An error of the command line, or the text of `--help` or `--version`, which clap prints.
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

/// Returns the error for a wrong command line, with this message, in the form of clap's own errors.
pub fn usage_error<T>(message: impl std::fmt::Display) -> Result<T> {
    use clap::CommandFactory;
    let error = super::Cli::command().error(clap::error::ErrorKind::ArgumentConflict, message);
    Err(Failure::Usage(Box::new(error)))
}
