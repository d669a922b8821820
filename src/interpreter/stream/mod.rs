//! The token stream's state: call frames, look-ahead, pushed-back tokens, commas, open brackets.

mod bracket;
mod checkpoint;
mod frame;
mod split;
mod token;

use super::evaluator::Place;
use crate::syntax::ListPlaces;
pub(super) use bracket::Opened;
pub(super) use frame::{FrameKind, StackFrame};
use rustc_hash::FxHashSet;
use std::cell::RefCell;
use std::path::PathBuf;
pub(super) use token::{BlockName, Held, Token};

/// The token stream's state.
#[derive(Default)]
pub(super) struct TokenStream<'a> {
    pub(super) including: Vec<PathBuf>,
    /// Where the last place in a list of numbers was found.
    pub(super) list_places: RefCell<ListPlaces>,
    pub(super) frames: Vec<StackFrame<'a>>,
    pub(super) peeked: Option<Token<'a>>,
    /// Tokens that come before those of the frames, the next one last.
    pub(super) held: Vec<Held<'a>>,
    /// Does a comma stand between what was read last and what comes next?
    pub(super) comma: bool,
    /// Do directives and macros behind a value wait until it has been used? So it is with what a name gets, with what
    /// an array holds and a macro is given, and with conditions.
    pub(super) closed: bool,
    /// Is a value read that nobody wants?
    pub(super) skipping: bool,
    /// Values that are being read inside each other.
    pub(super) nested: usize,
    /// The element of an array that [`Token::Element`] announces.
    pub(super) element: Option<Place>,
    /// How many frames there were when the declaration that is being read began.
    pub(super) floor: usize,
    /// The brackets around here, innermost last.
    pub(super) opened: Vec<Opened>,
    /// Where brackets stand that nothing in the rest of their file closes.
    pub(super) unclosed: FxHashSet<u32>,
    pub(super) depth: usize,
}
