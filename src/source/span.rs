//! Byte ranges in the texts.

use serde::Serialize;

/// A range of bytes in the concatenation of all texts (see [`super::Sources`]), so that a span also identifies its
/// text. The default is [`Span::NONE`].
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, PartialOrd, Ord, Serialize)]
pub struct Span {
    /// Offset of the span's first byte.
    pub lo: u32,
    /// Offset after the span's last byte.
    pub hi: u32,
}

impl Span {
    /// Absence of a position, for values from the command line and for defaults. (Positions in texts start at 1.)
    pub const NONE: Span = Span { lo: 0, hi: 0 };

    /// Creates the span from `lo` to `hi`, exclusive.
    pub fn new(lo: usize, hi: usize) -> Self {
        Self { lo: lo as u32, hi: hi as u32 }
    }

    /// True for [`Span::NONE`], the span without a position.
    pub fn is_none(&self) -> bool {
        self.hi == 0
    }

    /// Returns the smallest span that contains both; [`Self::NONE`] is neutral.
    pub fn to(self, other: Span) -> Span {
        if self.is_none() {
            other
        } else if other.is_none() {
            self
        } else {
            Span { lo: self.lo.min(other.lo), hi: self.hi.max(other.hi) }
        }
    }

    /// Returns the empty span directly after this span.
    pub fn end(self) -> Span {
        Span { lo: self.hi, hi: self.hi }
    }
}
