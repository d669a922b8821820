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
//! that formatting is idempotent. Brackets without a partner and other tokens that are part of no construct, as in
//! macros that open a block, are laid out again until the layout is stable.

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

/// Maximum number of passes over a text with irregular tokens.
const MAX_PASSES: usize = 8;

/// Formats a text. New lines end with `\n`. Lines have at most `width` characters where they can be broken.
/// `base_in_sources` is the global offset of the text's first byte, from which the spans of messages count. A text with
/// tokens that are part of no construct is returned as it is if its layout does not become stable.
///
/// # Errors
/// The faults of a text that can't be formatted: strings, comments and directives without an end, brackets that nest
/// too deeply.
pub fn format(text: &str, base_in_sources: usize, width: usize) -> Result<String, Vec<Diagnostic>> {
    let Pass { text: mut formatted, has_stray_token } = format_once(text, base_in_sources, width)?;
    if !has_stray_token {
        return Ok(formatted);
    }
    // Where brackets have no partner, a line that was broken may have another structure when it is parsed again.
    for _ in 1..MAX_PASSES {
        let next = format_once(&formatted, base_in_sources, width)?.text;
        if next == formatted {
            return Ok(formatted);
        }
        formatted = next;
    }
    // Without a stable layout the author's lines stay.
    Ok(text.to_string())
}

/// Result of laying out a text once.
struct Pass {
    text: String,
    /// True if the text has tokens that are part of no construct, so that the layout may change in the next pass.
    has_stray_token: bool,
}

fn format_once(text: &str, base_in_sources: usize, width: usize) -> Result<Pass, Vec<Diagnostic>> {
    let (ast, faults) = parse_text(text, base_in_sources, &Names::default(), Granularity::Whole);
    if faults.iter().any(|fault| fault.severity == Severity::Error) {
        return Err(faults);
    }
    let atoms = gather::gather(text, base_in_sources, &ast);
    drop(ast);
    Ok(Pass { text: layout::lay_out(text, &atoms, width), has_stray_token: atoms.has_stray_token() })
}
