//! Result lines of several scenes, in the same form for `render`, `check` and `test`.

use super::console::Console;
use super::exit::{Exit, Failure, Result, SIGNALS};
use crate::diagnostic::{Diagnostic, Severity};
use std::fmt::{self, Display};
use std::path::{Path, PathBuf};

/// Word for the result of one scene in a command's summary.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ResultWord {
    /// Word for a scene that passed.
    Ok,
    /// Word for a scene that has errors, or a picture that differs from its snapshot.
    Fail,
    /// Word for a scene that has no snapshot.
    New,
}

impl ResultWord {
    /// Returns the word for the result of a scene with this exit code.
    pub fn of(exit: Exit) -> Self {
        if exit == Exit::Fine { Self::Ok } else { Self::Fail }
    }

    /// Returns the word that a command prints for a scene's result.
    pub fn text(self) -> &'static str {
        match self {
            Self::Ok => "ok",
            Self::Fail => "FAIL",
            Self::New => "new",
        }
    }
}

/// Number of errors and warnings, displayed as `2 errors, 1 warning`.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Count {
    /// Number of messages of [`Severity::Error`].
    pub errors: usize,
    /// Number of messages of [`Severity::Warning`].
    pub warnings: usize,
}

impl Count {
    /// Counts the errors and warnings among a scene's messages.
    pub fn of<'a>(diagnostics: impl IntoIterator<Item = &'a Diagnostic>) -> Self {
        diagnostics.into_iter().fold(Self::default(), |mut count, d| {
            match d.severity {
                Severity::Error => count.errors += 1,
                Severity::Warning => count.warnings += 1,
            }
            count
        })
    }
}

impl std::ops::Add for Count {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        Self { errors: self.errors + other.errors, warnings: self.warnings + other.warnings }
    }
}

impl Display for Count {
    fn fmt(&self, f: &mut fmt::Formatter) -> fmt::Result {
        let part = |n, word| match n {
            0 => None,
            1 => Some(format!("1 {word}")),
            n => Some(format!("{n} {word}s")),
        };
        let parts = [part(self.errors, "error"), part(self.warnings, "warning")];
        f.write_str(&parts.into_iter().flatten().collect::<Vec<_>>().join(", "))
    }
}

/// Returns the result line of one scene, `FAIL  a.scene  2 errors`, with its line ending.
pub fn scene_line(word: ResultWord, scene: impl Display, text: &str) -> String {
    let gap = if text.is_empty() { "" } else { "  " };
    format!("{:4}  {scene}{gap}{text}\n", word.text())
}

/// Returns the last line, `12 ok, 1 FAIL; 2 errors, 1 warning`, with its line ending.
pub fn total_line(words: &[ResultWord], messages: Count) -> String {
    let count = |wanted: ResultWord| (words.iter().filter(|word| **word == wanted).count(), wanted.text());
    let parts = [ResultWord::Ok, ResultWord::Fail, ResultWord::New].map(count);
    let parts = parts.iter().filter(|(n, _)| *n > 0).map(|(n, word)| format!("{n} {word}"));
    let gap = if messages == Count::default() { "" } else { "; " };
    format!("{}{gap}{messages}\n", parts.collect::<Vec<_>>().join(", "))
}

/// Processes several scenes, and prints a result line for each. `work` returns the exit code of a scene, and a text for
/// the line of a scene without errors.
pub fn process_each(
    console: &Console,
    inputs: &[PathBuf],
    print: impl Fn(&str) -> Result<()>,
    mut work: impl FnMut(&Console, &Path) -> Result<(Exit, String)>,
) -> Result {
    let console = &console.for_scene_among_several();
    let (mut exits, mut all) = (Vec::new(), Count::default());
    for input in inputs {
        let (exit, text) = match work(console, input) {
            Ok(ended) => ended,
            Err(Failure::BrokenPipe) => return Err(Failure::BrokenPipe),
            Err(failure) => (console.print_failure(failure), String::new()),
        };
        let count = console.take_message_count();
        let parts = [text, count.to_string()].into_iter().filter(|part| !part.is_empty());
        exits.push(exit);
        all = all + count;
        if exit.is_signal() {
            return Err(Failure::Reported(exit));
        }
        print(&scene_line(ResultWord::of(exit), input.display(), &parts.collect::<Vec<_>>().join("  ")))?;
    }
    let words: Vec<_> = exits.iter().map(|exit| ResultWord::of(*exit)).collect();
    print(&total_line(&words, all))?;
    Ok(combined_exit_code(exits))
}

/// Returns the exit code of all scenes together: that of the highest rank. A signal has the highest rank, then a scene's
/// error; a different picture has the lowest.
pub fn combined_exit_code(exits: impl IntoIterator<Item = Exit> + Clone) -> Exit {
    let signals = SIGNALS.iter().map(|signal| signal.exit);
    let order = signals.chain([Exit::Scene, Exit::File, Exit::Limit, Exit::Usage, Exit::Snapshot]);
    let mut order = order.into_iter();
    order.find(|wanted| exits.clone().into_iter().any(|exit| exit == *wanted)).unwrap_or(Exit::Fine)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lines_omit_counts_of_zero() {
        let count = |errors, warnings| Count { errors, warnings };
        assert_eq!(scene_line(ResultWord::Ok, "a.scene", ""), "ok    a.scene\n");
        assert_eq!(
            scene_line(ResultWord::Fail, "b.scene", &count(2, 1).to_string()),
            "FAIL  b.scene  2 errors, 1 warning\n"
        );
        assert_eq!(total_line(&[ResultWord::Ok], count(0, 0)), "1 ok\n");
        assert_eq!(
            total_line(&[ResultWord::New, ResultWord::Fail, ResultWord::Ok], count(1, 0)),
            "1 ok, 1 FAIL, 1 new; 1 error\n"
        );
        assert_eq!(count(1, 2) + count(1, 0), count(2, 2));
    }

    #[test]
    fn the_worst_exit_code_is_returned() {
        assert_eq!(combined_exit_code([Exit::Fine, Exit::File, Exit::Scene]), Exit::Scene);
        assert_eq!(combined_exit_code([Exit::Snapshot, Exit::Fine]), Exit::Snapshot);
        assert_eq!(combined_exit_code([]), Exit::Fine);
    }
}
