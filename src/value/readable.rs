//! Blocks that read themselves by their descriptions.

use super::words::{Row, read_row};
use super::{Next, Reader, Spec};
use crate::diagnostic::Result;
use crate::source::Span;

/// A block of the scene language that a table describes, such as a shape, a pattern or a warp.
pub trait Readable: Sized + 'static {
    /// Name, parameters and words of the block.
    const SPEC: Spec;

    /// The words in `SPEC`, and how each is read.
    const WORDS: &'static [Row<Self>] = &[];

    /// Reads the positional parameters. The block's name has been consumed, and its opening brace if it has one.
    ///
    /// # Errors
    /// A diagnostic at the first item that is not understood.
    fn read(r: &mut dyn Reader) -> Result<Self>;

    /// Reads the positional parameters after the opening brace, for a pattern that has forms with and without braces.
    ///
    /// # Errors
    /// A diagnostic at the first item that is not understood.
    fn read_braced_params(r: &mut dyn Reader) -> Result<Self> {
        Self::read(r)
    }

    /// Reads the positional parameters; `None` if `next` does not name the block. The name has been consumed, with the
    /// opening brace of a `Next::Block`.
    fn read_params(next: Next, r: &mut dyn Reader) -> Option<Result<Self>> {
        match next {
            Next::Word(name) if name == Self::SPEC.name => Some(Self::read(r)),
            Next::Block(name) if name == Self::SPEC.name => Some(Self::read_braced_params(r)),
            _ => None,
        }
    }

    /// Reads one of [`Self::WORDS`] and its value, if it is next; returns false otherwise.
    ///
    /// # Errors
    /// A diagnostic at the first item that is not understood.
    fn read_own(&mut self, next: Next, r: &mut dyn Reader) -> Result<bool> {
        read_row(Self::WORDS, self, next, r)
    }

    /// Completes a shape or warp after the last item of its block, and checks it; `span` is the block's name. Warnings
    /// are reported to `r`. Not called for patterns, whose words may follow anywhere in the block around them.
    ///
    /// # Errors
    /// A diagnostic for a block that is complete but invalid.
    fn complete_and_check(&mut self, _span: Span, _r: &mut dyn Reader) -> Result<()> {
        Ok(())
    }
}
