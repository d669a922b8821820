//! The formatter `durer fmt`: one style for scenes.
//!
//! The author's decisions stay: tokens, comments, blank lines (one at a time), which items share a line, and whether a
//! block is on one line or on several. All else follows from the tree: indentation, blanks, the position of braces, the
//! breaks of lines that are too long. A block or a directive on several lines shares none of them:
//!
//! ```text
//! sphere { 0, 1 pigment { Oak } }
//!
//! sphere { 0, 1
//!   pigment { Oak }
//! }
//! ```
//!
//! `gather` makes a list of `atoms` from tokens, comments and tree; `layout` distributes them over lines, `run` breaks
//! lines of one long expression, `columns` and `table` keep columns aligned. A broken line is never joined again, so
//! that formatting is idempotent.

mod atoms;
mod columns;
mod gather;
mod layout;
mod run;
mod table;
mod text;

pub use text::{Encoded, decode};

use crate::diagnostic::{Diagnostic, Severity};
use crate::syntax::{Granularity, Names, parse_text};

/// Default maximum width of a line, in columns.
pub const WIDTH: usize = 120;

/// Indentation of each level, in columns.
const STEP: usize = 2;

/// Formats a text. New lines end with `\n`. Lines have at most `width` characters where they can be broken. `base` is
/// the global offset of the text's first byte, for messages.
///
/// # Errors
/// The faults of a text that can't be formatted: strings, comments and directives without an end, brackets that nest
/// too deeply.
pub fn format(text: &str, base: usize, width: usize) -> Result<String, Vec<Diagnostic>> {
    let (ast, faults) = parse_text(text, base, &Names::default(), Granularity::Whole);
    if faults.iter().any(|fault| fault.severity == Severity::Error) {
        return Err(faults);
    }
    let atoms = gather::gather(text, base, &ast);
    drop(ast);
    Ok(layout::lay_out(text, &atoms, width))
}
