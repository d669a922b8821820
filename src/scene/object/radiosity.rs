//! `radiosity { … }` of an object (manual, "Radiosity Importance").

use crate::diagnostic::Result;
use crate::value::ValueKind::Float;
use crate::value::ranges::positive_up_to_one;
use crate::value::words::{Row, read_row, set, specs, word};
use crate::value::{Next, Reader, ReaderExt, Spec};
use serde::Serialize;

/// `radiosity` settings of an object.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct ObjectRadiosity {
    /// Factor of the number of rays by which radiosity gathers light at the object: more than 0, and 1 at most.
    pub importance: f64,
}

/// Words of the `radiosity` block, and how each is read.
const RADIOSITY_ROWS: &[Row<ObjectRadiosity>] =
    &[word("importance", Float, "1", "factor of the number of rays that gather light at the object, 1 at most")
        .sets(|s, r| set(&mut s.importance, positive_up_to_one("importance", r)))];

/// Specification of the block `radiosity { … }` of an object.
pub const OBJECT_RADIOSITY: Spec = Spec {
    name: "radiosity",
    summary: "radiosity settings of one object",
    words: specs!(RADIOSITY_ROWS),
    ..Spec::EMPTY
};

impl ObjectRadiosity {
    /// Reads a `radiosity` block from its opening to its closing brace.
    ///
    /// # Errors
    /// A diagnostic at the first item that is not understood.
    pub fn read_with_braces(r: &mut dyn Reader) -> Result<Self> {
        let mut out = Self { importance: 1.0 };
        r.take_token()?;
        loop {
            match r.peek_next()? {
                Next::End => return r.leave_block().map(|_| out),
                next if read_row(RADIOSITY_ROWS, &mut out, next, r)? => {}
                _ => return Err(r.unknown_word_in(&OBJECT_RADIOSITY)),
            }
        }
    }
}
