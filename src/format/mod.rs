//! `durer fmt`: one style for scenes, that of a careful author.
//!
//! What the author decided stays: tokens, comments, blank lines (one at a time), which things share a line, and whether a block
//! stands on one line or on several. What is nobody's decision follows from the tree: how far lines are indented, where
//! blanks stand, where braces go, where a line that is too long is broken. A block or a directive that stands on several lines
//! has them all to itself:
//!
//! ```text
//! sphere { 0, 1 pigment { Oak } }
//!
//! sphere { 0, 1
//!   pigment { Oak }
//! }
//! ```
//!
//! `gather` makes of tokens, comments and tree a row of `atoms`; `layout` sets them in lines, `run` breaks those that hold one long
//! expression, `columns` and `table` keep in line what was aligned. A text that was broken once is never joined again, so that formatting twice
//! is formatting once.

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

/// Columns of a line, unless the author wants others.
pub const WIDTH: usize = 120;

/// Blanks for each level.
const STEP: usize = 2;

/// The text as it should be, with `\n` at the ends of those lines that are new. Lines hold at most `width` characters where there is
/// a place to break them. `base` is the global offset of the text's first byte, for messages.
///
/// # Errors
/// What is wrong with the text if it can't be understood well enough: strings, comments and directives without an end, brackets that
/// nest too deeply.
pub fn format(text: &str, base: usize, width: usize) -> Result<String, Vec<Diagnostic>> {
    let (ast, faults) = parse_text(text, base, &Names::default(), Granularity::Whole);
    if faults.iter().any(|fault| fault.severity == Severity::Error) {
        return Err(faults);
    }
    let atoms = gather::gather(text, base, &ast);
    drop(ast);
    Ok(layout::set(text, &atoms, width))
}
