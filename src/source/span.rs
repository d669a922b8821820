//! A place in the text.

use serde::Serialize;

/// A range of bytes in the concatenation of all files read so far (see [`super::Sources`]), so that
/// eight bytes name the file too. The default is no place at all.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, PartialOrd, Ord, Serialize)]
pub struct Span {
    /// First byte.
    pub lo: u32,
    /// One past the last byte.
    pub hi: u32,
}

impl Span {
    /// No place: made by the command line, or by a default. Global offsets start at 1.
    pub const NONE: Span = Span { lo: 0, hi: 0 };

    /// From `lo` up to and without `hi`.
    pub fn new(lo: usize, hi: usize) -> Self {
        Self { lo: lo as u32, hi: hi as u32 }
    }

    /// Is it [`Span::NONE`]?
    pub fn is_none(&self) -> bool {
        self.hi == 0
    }

    /// From the start of this one to the end of the other.
    pub fn to(self, other: Span) -> Span {
        if self.is_none() {
            other
        } else if other.is_none() {
            self
        } else {
            Span { lo: self.lo.min(other.lo), hi: self.hi.max(other.hi) }
        }
    }

    /// The empty place just behind this one.
    pub fn end(self) -> Span {
        Span { lo: self.hi, hi: self.hi }
    }
}
