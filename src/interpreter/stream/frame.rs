//! Call frames: bodies of branches, loops and macros, files, bracketed groups and split expressions.

use super::TokenStream;
use crate::source::Span;
use crate::syntax::ast::*;
use std::path::PathBuf;

/// A sequence of elements with a read position, on the token stream's stack.
pub struct StackFrame<'a> {
    pub(super) elements: &'a [Element],
    /// Index of the frame's next element to read.
    pub(super) at: usize,
    /// Read position within a list of literals: index of the item, and index of the item's first number.
    pub(super) item: (usize, usize),
    kind: FrameKind<'a>,
    /// Span of the construct that the frame reads: block, call, directive.
    span: Span,
    /// Closing bracket that follows the frame's last element; `None` if no bracket follows.
    pub(super) closer: Option<Bracket>,
    /// True if a comma follows the frame's last token.
    pub(super) comma: bool,
}

/// The construct that a frame's elements belong to.
#[derive(Clone, Copy)]
pub enum FrameKind<'a> {
    /// Frame of the outermost file, the scene itself.
    File,
    /// Frame of the contents of a bracket, or of the parts of a split expression.
    Piece,
    /// Frame of a branch of `#if`, or of an arm of `#switch`.
    Branch,
    /// Frame of a `#switch`, below the frame of its present arm; `#break` leaves both.
    Switch,
    /// Frame of one pass of `#while`, with its condition.
    While(&'a Head),
    /// Frame of one pass through the body of a `#for` loop.
    For { counter: Symbol, last: f64, step: f64 },
    /// Frame of a macro call, which reads the macro's body.
    Macro(Symbol),
    /// Frame of an included file.
    Include,
}

impl FrameKind<'_> {
    /// True if a scope of `#local` names ends with the frame.
    pub fn has_scope(self) -> bool {
        matches!(self, FrameKind::Macro(_) | FrameKind::Include)
    }
}

impl<'a> StackFrame<'a> {
    fn new(elements: &'a [Element], kind: FrameKind<'a>, span: Span) -> Self {
        Self { elements, at: 0, item: (0, 0), kind, span, closer: None, comma: false }
    }

    /// Returns the frame's element at the read position, which stays; `None` after the last element.
    #[inline]
    pub fn next(&self) -> Option<&'a Element> {
        self.elements.get(self.at)
    }

    /// Returns the frame's element after [`Self::next`].
    #[inline]
    pub fn element_after_next(&self) -> Option<&'a Element> {
        self.elements.get(self.at + 1)
    }

    /// Returns the frame's elements from the read position on.
    pub fn unread(&self) -> &'a [Element] {
        self.elements.get(self.at..).unwrap_or_default()
    }

    pub fn kind(&self) -> FrameKind<'a> {
        self.kind
    }

    pub fn span(&self) -> Span {
        self.span
    }

    /// Returns the closing bracket that follows the frame's last element; `None` if no bracket follows.
    pub fn closer(&self) -> Option<Bracket> {
        self.closer
    }

    /// True if a bracket or a comma follows the frame's last element.
    pub fn is_delimited(&self) -> bool {
        self.closer.is_some() || self.comma
    }

    /// Returns the index of the next item in the list of literals at the read position.
    pub fn list_item_index(&self) -> usize {
        self.item.0
    }

    /// Returns the next item of the list of literals at the read position, without moving the position.
    pub fn peek_list_item(&self, list: &'a NumberList) -> &'a [f64] {
        let (i, start) = self.item;
        &list.data[start..start + list.width(i)]
    }

    /// True if the frame holds a split expression whose parts are all consumed.
    pub fn is_spent_piece(&self) -> bool {
        matches!(self.kind, FrameKind::Piece) && self.is_spent()
    }

    /// True if all elements of the frame are consumed and no closing bracket follows.
    pub fn is_spent(&self) -> bool {
        self.closer.is_none() && self.at >= self.elements.len()
    }

    /// True if the element of this index is or begins with `{`.
    pub(super) fn opens_brace(&self, element_index: usize) -> bool {
        matches!(
            self.elements.get(element_index).map(|e| &e.kind),
            Some(ElementKind::Group(_) | ElementKind::Punctuation(Punctuation::Open(Bracket::Brace)))
        )
    }

    /// True if a `{` is the frame's next token.
    pub fn is_at_brace(&self) -> bool {
        self.opens_brace(self.at)
    }

    /// True if a `(` is the frame's next token.
    pub fn is_at_parenthesis(&self) -> bool {
        match self.next().map(|e| &e.kind) {
            Some(ElementKind::Punctuation(mark)) => *mark == Punctuation::Open(Bracket::Paren),
            Some(ElementKind::Expr(e)) => matches!(e.kind, ExprKind::Paren(_)),
            _ => false,
        }
    }
}

/// Frames of files, loops and macro calls on the token stream's stack.
impl<'a> TokenStream<'a> {
    #[inline]
    pub fn innermost(&self) -> Option<&StackFrame<'a>> {
        self.frames.last()
    }

    /// Returns all frames of the token stream, the innermost last.
    pub fn frames(&self) -> &[StackFrame<'a>] {
        &self.frames
    }

    /// Returns the number of macro calls around the read position.
    pub fn call_depth(&self) -> usize {
        self.call_depth + self.value_macros.len()
    }

    /// Adds the call of a macro that is evaluated as a value, which has no frame, to the call trace.
    pub fn enter_value_macro(&mut self, name: Symbol, span: Span) {
        self.value_macros.push((name, span));
    }

    /// Removes the innermost call that [`Self::enter_value_macro`] added.
    pub fn leave_value_macro(&mut self) {
        self.value_macros.pop();
    }

    /// Returns the paths of the included files around the read position, the innermost last.
    pub fn include_paths(&self) -> &[PathBuf] {
        &self.include_paths
    }

    /// Pushes a frame, so that the token stream reads `elements` next.
    pub fn push_frame(&mut self, elements: &'a [Element], kind: FrameKind<'a>, span: Span) {
        self.look_ahead = None;
        self.frames.push(StackFrame::new(elements, kind, span));
    }

    /// Inserts elements that are read next, then a closing bracket if one is given, then a comma if `comma_after` is set.
    pub fn push_elements(&mut self, elements: &'a [Element], closer: Option<Bracket>, span: Span, comma_after: bool) {
        self.look_ahead = None;
        self.frames.push(StackFrame {
            closer,
            comma: comma_after,
            ..StackFrame::new(elements, FrameKind::Piece, span)
        });
    }

    /// Inserts a macro's body that is read next, then a comma if `comma_after` is set. Forgets commas of the arguments.
    pub fn push_call(&mut self, definition: &'a Macro, span: Span, comma_after: bool) {
        (self.look_ahead, self.comma) = (None, false);
        self.call_depth += 1;
        let kind = FrameKind::Macro(definition.name);
        self.frames.push(StackFrame { comma: comma_after, ..StackFrame::new(&definition.body, kind, span) });
    }

    /// Inserts an included file that is read next. A comma before the directive moves to the end of the file.
    pub fn push_include(&mut self, path: PathBuf, elements: &'a [Element], span: Span) {
        let comma = self.take_comma();
        self.look_ahead = None;
        self.include_paths.push(path);
        self.frames.push(StackFrame { comma, ..StackFrame::new(elements, FrameKind::Include, span) });
    }

    /// Drops the innermost frame, and returns its kind.
    pub fn pop_frame(&mut self) -> Option<FrameKind<'a>> {
        self.look_ahead = None;
        let frame = self.frames.pop()?;
        self.comma |= frame.comma;
        match frame.kind {
            FrameKind::Macro(_) => self.call_depth -= 1,
            FrameKind::Include => drop(self.include_paths.pop()),
            _ => {}
        }
        Some(frame.kind)
    }

    /// Moves the read position of the innermost frame back to its first element.
    pub fn restart_frame(&mut self) {
        if let Some(frame) = self.frames.last_mut() {
            frame.at = 0;
        }
    }

    /// Removes and returns the frames above the first `kept_count`, which stay.
    pub fn split_off_frames(&mut self, kept_count: usize) -> Vec<StackFrame<'a>> {
        self.frames.split_off(kept_count)
    }

    /// Puts back frames that [`Self::split_off_frames`] removed.
    pub fn push_frames(&mut self, frames: Vec<StackFrame<'a>>) {
        self.frames.extend(frames);
    }
}
