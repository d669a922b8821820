//! How scenes fared, in the same words wherever several are named: `render`, `check` and `test`.

use super::console::Console;
use super::exit::{Exit, Failure, Result};
use crate::diagnostic::{Diagnostic, Severity};
use std::fmt::{self, Display};
use std::path::{Path, PathBuf};

/// How one scene fared, in a word.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Word {
    /// All is well.
    Ok,
    /// It is wrong, or its picture is.
    Fail,
    /// It has no snapshot to be compared with.
    New,
}

impl Word {
    /// For a scene that alone would end the program so.
    pub fn of(exit: Exit) -> Self {
        if exit == Exit::Fine { Self::Ok } else { Self::Fail }
    }

    /// As it is printed.
    pub fn text(self) -> &'static str {
        match self {
            Self::Ok => "ok",
            Self::Fail => "FAIL",
            Self::New => "new",
        }
    }
}

/// How many messages there were; written as `2 errors, 1 warning`.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Count {
    /// Messages of [`Severity::Error`].
    pub errors: usize,
    /// Messages of [`Severity::Warning`].
    pub warnings: usize,
}

impl Count {
    /// Of these messages.
    pub fn of<'a>(diagnostics: impl IntoIterator<Item = &'a Diagnostic>) -> Self {
        diagnostics.into_iter().fold(Self::default(), |mut count, d| {
            match d.severity {
                Severity::Error => count.errors += 1,
                Severity::Warning => count.warnings += 1,
            }
            count
        })
    }

    /// Both together.
    pub fn and(self, other: Self) -> Self {
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

/// The line of one scene: `FAIL  a.scene  2 errors`, and its end.
pub fn line(word: Word, scene: impl Display, text: &str) -> String {
    let gap = if text.is_empty() { "" } else { "  " };
    format!("{:4}  {scene}{gap}{text}\n", word.text())
}

/// The line behind those of all scenes: `12 ok, 1 FAIL; 2 errors, 1 warning`, and its end.
pub fn total(words: &[Word], messages: Count) -> String {
    let count = |wanted: Word| (words.iter().filter(|word| **word == wanted).count(), wanted.text());
    let parts = [Word::Ok, Word::Fail, Word::New].map(count);
    let parts = parts.iter().filter(|(n, _)| *n > 0).map(|(n, word)| format!("{n} {word}"));
    let gap = if messages == Count::default() { "" } else { "; " };
    format!("{}{gap}{messages}\n", parts.collect::<Vec<_>>().join(", "))
}

/// Does something with each of several scenes, and tells of each on a line of its own: `work` gives how it ended and what is to
/// be told of a scene that went well.
pub fn each(
    console: &Console,
    inputs: &[PathBuf],
    tell: impl Fn(&str) -> Result<()>,
    mut work: impl FnMut(&Console, &Path) -> Result<(Exit, String)>,
) -> Result {
    let console = &console.among_several();
    let (mut exits, mut all) = (Vec::new(), Count::default());
    for input in inputs {
        let (exit, text) = match work(console, input) {
            Ok(ended) => ended,
            Err(Failure::NobodyListens) => return Err(Failure::NobodyListens),
            Err(failure) => (console.tell(failure), String::new()),
        };
        let count = console.take_count();
        let parts = [text, count.to_string()].into_iter().filter(|part| !part.is_empty());
        exits.push(exit);
        all = all.and(count);
        if exit == Exit::Interrupted {
            return Err(Failure::Told(exit));
        }
        tell(&line(Word::of(exit), input.display(), &parts.collect::<Vec<_>>().join("  ")))?;
    }
    let words: Vec<_> = exits.iter().map(|exit| Word::of(*exit)).collect();
    tell(&total(&words, all))?;
    Ok(worst(exits))
}

/// The exit code of all scenes together: what is wrong with a scene counts most, a picture that differs least.
pub fn worst(exits: impl IntoIterator<Item = Exit> + Clone) -> Exit {
    let order = [Exit::Interrupted, Exit::Scene, Exit::File, Exit::Limit, Exit::Usage, Exit::Snapshot];
    order.into_iter().find(|wanted| exits.clone().into_iter().any(|exit| exit == *wanted)).unwrap_or(Exit::Fine)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lines_are_short_and_counts_leave_zeros_out() {
        let count = |errors, warnings| Count { errors, warnings };
        assert_eq!(line(Word::Ok, "a.scene", ""), "ok    a.scene\n");
        assert_eq!(line(Word::Fail, "b.scene", &count(2, 1).to_string()), "FAIL  b.scene  2 errors, 1 warning\n");
        assert_eq!(total(&[Word::Ok], count(0, 0)), "1 ok\n");
        assert_eq!(total(&[Word::New, Word::Fail, Word::Ok], count(1, 0)), "1 ok, 1 FAIL, 1 new; 1 error\n");
        assert_eq!(count(1, 2).and(count(1, 0)), count(2, 2));
    }

    #[test]
    fn the_worst_counts() {
        assert_eq!(worst([Exit::Fine, Exit::File, Exit::Scene]), Exit::Scene);
        assert_eq!(worst([Exit::Snapshot, Exit::Fine]), Exit::Snapshot);
        assert_eq!(worst([]), Exit::Fine);
    }
}
