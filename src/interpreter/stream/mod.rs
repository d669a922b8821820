//! State of the token stream: call frames, look-ahead, pushed-back tokens, commas, open brackets, checkpoints.
//!
//! No code of this module runs directives or evaluates expressions; [`super::pull`] does both while it reads tokens.

mod bracket;
mod checkpoint;
mod frame;
mod split;
mod token;

use super::Inputs;
use super::evaluator::LValue;
use crate::diagnostic::{Diagnostic, Label};
use crate::source::Span;
use crate::syntax::ItemSpans;
use crate::syntax::ast::*;
pub(super) use bracket::OpenBracket;
pub(super) use checkpoint::Checkpoint;
pub(super) use frame::{FrameKind, StackFrame};
use rustc_hash::FxHashSet;
use std::cell::RefCell;
use std::path::PathBuf;
use token::PushedBack;
pub(super) use token::{BlockName, Token};

/// The state of the token stream.
pub(super) struct TokenStream<'a> {
    inputs: Inputs<'a>,
    /// Frames whose elements are read: of files, brackets, branches, loops and macro calls, the innermost last.
    frames: Vec<StackFrame<'a>>,
    /// Next token of the stream, which is not consumed yet.
    look_ahead: Option<Token<'a>>,
    /// Tokens that are read before `look_ahead`, the next one last.
    pushed_back: Vec<PushedBack<'a>>,
    /// True if a comma separates the last token from the next one.
    comma: bool,
    mode: Mode,
    /// Location of the array element that [`Token::Element`] represents.
    element: Option<LValue>,
    /// Brackets around the read position, the innermost last.
    open_brackets: Vec<OpenBracket>,
    /// Global offsets of brackets that have no closing bracket in their file.
    unclosed: FxHashSet<u32>,
    /// Number of macro frames on the token stream's stack.
    call_depth: usize,
    /// Names and calls of the value macros that are being evaluated, the innermost last.
    value_macros: Vec<(Symbol, Span)>,
    /// Paths of the included files that are being read, the innermost last.
    include_paths: Vec<PathBuf>,
    /// Span of the last literal that was looked up in a list.
    literal_spans: RefCell<ItemSpans>,
}

/// Mode of reading. `Interpreter::in_mode` changes it and restores it as a whole.
#[derive(Clone, Copy, Default)]
pub(super) struct Mode {
    /// True if directives and macro calls after a value run only after the value has been used: in declarations, array
    /// elements, macro arguments and conditions.
    pub(super) defers_directives: bool,
    /// Number of frames on the stack when the present declaration or directive began; deferred reading pops none of
    /// these frames.
    pub(super) frame_floor: usize,
    /// Depth of values that are being read inside each other.
    pub(super) nesting: usize,
}

impl<'a> TokenStream<'a> {
    pub(super) fn new(inputs: Inputs<'a>) -> Self {
        Self {
            inputs,
            frames: vec![],
            look_ahead: None,
            pushed_back: vec![],
            comma: false,
            mode: Mode::default(),
            element: None,
            open_brackets: vec![],
            unclosed: FxHashSet::default(),
            call_depth: 0,
            value_macros: vec![],
            include_paths: vec![],
            literal_spans: RefCell::default(),
        }
    }

    #[inline]
    pub(super) fn mode(&self) -> Mode {
        self.mode
    }

    #[inline]
    pub(super) fn set_mode(&mut self, mode: Mode) {
        self.mode = mode;
    }

    /// True if a comma separates the last token from the next one.
    #[inline]
    pub(super) fn has_comma(&self) -> bool {
        self.comma
    }

    /// Returns whether a comma comes next, and forgets the comma.
    #[inline]
    pub(super) fn take_comma(&mut self) -> bool {
        std::mem::take(&mut self.comma)
    }

    #[inline]
    pub(super) fn set_comma(&mut self, comma: bool) {
        self.comma = comma;
    }

    /// Records a comma before the next token, if `comma` is true.
    #[inline]
    pub(super) fn add_comma(&mut self, comma: bool) {
        self.comma |= comma;
    }

    /// Returns the next token if it is known: a pushed-back token or the look-ahead; `None` before it is read.
    #[inline(always)]
    pub(super) fn look_ahead(&self) -> Option<&Token<'a>> {
        match self.pushed_back.last() {
            Some(pushed_back) => Some(&pushed_back.token),
            None => self.look_ahead.as_ref(),
        }
    }

    #[inline]
    pub(super) fn has_pushed_back(&self) -> bool {
        !self.pushed_back.is_empty()
    }

    /// Drops the look-ahead unless it was pushed back.
    pub(super) fn drop_unpushed_look_ahead(&mut self) {
        if self.pushed_back.is_empty() {
            self.look_ahead = None;
        }
    }

    /// Sets the next token, whose text is at the read position.
    #[inline]
    pub(super) fn set_look_ahead(&mut self, token: Token<'a>) -> Token<'a> {
        self.look_ahead = Some(token);
        token
    }

    /// Makes a token the next one, although its text has been consumed. `has_comma_before` is true if a comma precedes the token;
    /// the present comma follows it.
    pub(super) fn push_back(&mut self, token: Token<'a>, span: Span, has_comma_before: bool) -> Token<'a> {
        let comma = std::mem::replace(&mut self.comma, has_comma_before);
        self.pushed_back.push(PushedBack { token, span, comma });
        token
    }

    /// Returns the location of the array element that the next token, a [`Token::Element`], represents.
    pub(super) fn array_element(&self) -> Option<&LValue> {
        self.element.as_ref()
    }

    pub(super) fn set_array_element(&mut self, element: LValue) {
        self.element = Some(element);
    }

    pub(super) fn take_array_element(&mut self) -> Option<LValue> {
        self.element.take()
    }

    /// Returns the innermost frame's element at the read position, without running directives; `None` at the end of the
    /// frame, or if a token was pushed back.
    pub(super) fn next_raw_element(&self) -> Option<&'a Element> {
        let has_pushed_back = !self.pushed_back.is_empty();
        self.frames.last().filter(|_| !has_pushed_back).and_then(StackFrame::next)
    }

    /// Consumes and returns a name that comes next, even the name of a macro; `None` if no name comes next.
    pub(super) fn take_name(&mut self) -> Option<(Symbol, Span)> {
        let element = self.next_raw_element()?;
        let ElementKind::Expr(e) = &element.kind else { return None };
        let ExprKind::Name(symbol) = e.kind else { return None };
        self.advance();
        Some((symbol, element.span))
    }

    /// Consumes and returns a name that comes next, if a closing bracket follows it; otherwise returns `None` and
    /// consumes nothing.
    pub(super) fn take_name_before_closer(&mut self) -> Option<(Symbol, Span)> {
        let frame = self.frames.last()?;
        match frame.element_after_next().map(|e| &e.kind) {
            Some(ElementKind::Punctuation(Punctuation::Close(_))) => {}
            None if frame.closer.is_some() => {}
            _ => return None,
        }
        self.take_name()
    }

    /// Returns the span of a `;` that comes next, which is not consumed; `None` if no `;` comes next.
    pub(super) fn next_semicolon_span(&self) -> Option<Span> {
        self.next_raw_element()
            .filter(|element| matches!(element.kind, ElementKind::Semicolon))
            .map(|element| element.span)
    }

    /// Returns the expression that comes next, if a `;` follows it; consumes nothing. `None` otherwise.
    #[inline]
    pub(super) fn expression_before_semicolon(&self) -> Option<&'a Expr> {
        match self.frames.last()?.unread() {
            [Element { kind: ElementKind::Expr(e), .. }, Element { kind: ElementKind::Semicolon, .. }, ..] => Some(e),
            _ => None,
        }
    }

    /// Consumes the expression and the `;` that [`Self::expression_before_semicolon`] found.
    #[inline]
    pub(super) fn skip_expression_and_semicolon(&mut self) {
        self.look_ahead = None;
        if let Some(frame) = self.frames.last_mut() {
            frame.at += 2;
        }
    }

    /// Consumes and returns the directive at the read position; `None` if no directive is there.
    #[inline(always)]
    pub(super) fn take_directive(&mut self) -> Option<(&'a Directive, Span)> {
        let frame = self.frames.last_mut()?;
        match frame.elements.get(frame.at) {
            Some(Element { span, kind: ElementKind::Directive(directive), .. }) => {
                frame.at += 1;
                Some((directive, *span))
            }
            _ => None,
        }
    }

    /// True if a comma follows the syntax element at the read position.
    pub(super) fn comma_follows_element(&self) -> bool {
        self.pushed_back.is_empty() && self.frames.last().and_then(StackFrame::next).is_some_and(|e| e.comma)
    }

    /// Moves the read position past one syntax element.
    #[inline]
    pub(super) fn skip_element(&mut self) {
        if let Some(frame) = self.frames.last_mut() {
            frame.at += 1;
        }
    }

    /// Consumes the next token of the stream.
    pub(super) fn advance(&mut self) {
        if let Some(pushed_back) = self.pushed_back.pop() {
            self.comma = pushed_back.comma;
            return;
        }
        self.look_ahead = None;
        let Some(frame) = self.frames.last_mut() else { return };
        let Some(element) = frame.next() else {
            if frame.closer.is_some() {
                let comma = frame.comma;
                self.pop_frame();
                self.comma = comma;
            }
            return;
        };
        self.comma = element.comma;
        if let ElementKind::Numbers(list) = &element.kind {
            let (i, start) = frame.item;
            frame.item = (i + 1, start + list.width(i));
            if i + 1 < list.len() {
                self.comma = true;
                return;
            }
            frame.item = (0, 0);
        }
        frame.at += 1;
    }

    /// Consumes and returns the next item of a list of literals; `None` for the first and last item of the list, and
    /// for any other token.
    pub(super) fn take_middle_list_item(&mut self) -> Option<&'a [f64]> {
        if self.look_ahead.is_some() || !self.pushed_back.is_empty() {
            return None;
        }
        let frame = self.frames.last_mut()?;
        let ElementKind::Numbers(list) = &frame.elements.get(frame.at)?.kind else { return None };
        let (i, start) = frame.item;
        if i == 0 || i + 1 >= list.len() {
            return None;
        }
        let end = start + list.width(i);
        frame.item = (i + 1, end);
        Some(&list.data[start..end])
    }

    /// Consumes up to `max_count` items of a list of literals, neither the first nor the last one, while each has `width`
    /// numbers and `take` accepts them. Returns the number of items consumed.
    pub(super) fn take_middle_list_items(
        &mut self,
        width: usize,
        max_count: usize,
        take: &mut dyn FnMut(&[f64]) -> bool,
    ) -> usize {
        if self.look_ahead.is_some() || !self.pushed_back.is_empty() {
            return 0;
        }
        let Some(frame) = self.frames.last_mut() else { return 0 };
        let Some(Element { kind: ElementKind::Numbers(list), .. }) = frame.elements.get(frame.at) else { return 0 };
        let (first, mut at) = frame.item;
        let end = if first == 0 { 0 } else { (list.len() - 1).min(first.saturating_add(max_count)) };
        let mut i = first;
        while i < end && list.width(i) == width && take(&list.data[at..at + width]) {
            (i, at) = (i + 1, at + width);
        }
        frame.item = (i, at);
        i - first
    }

    /// Returns the span of the stream's next token.
    pub(super) fn next_span(&self) -> Span {
        if let Some(pushed_back) = self.pushed_back.last() {
            return pushed_back.span;
        }
        let Some(frame) = self.frames.last() else { return Span::NONE };
        match frame.next() {
            Some(Element { span, kind: ElementKind::Numbers(list), .. }) => {
                let text = self.inputs.sources.snippet(*span);
                // (A mesh asks for the last item of each of its lists.)
                if frame.item.0 + 1 == list.len() {
                    return ItemSpans::span_of_last_item(text, *span);
                }
                let found = self.literal_spans.borrow_mut().find(text, *span, frame.item.0);
                found.unwrap_or(*span)
            }
            Some(Element { kind: ElementKind::Block(block), .. }) => block.name.span,
            Some(Element { span, kind: ElementKind::Group(_) | ElementKind::Entry(_), .. }) => {
                Span { hi: span.lo + 1, ..*span }
            }
            Some(element) => element.span,
            None => {
                let span = frame.span();
                Span { lo: span.hi.saturating_sub(1).max(span.lo), hi: span.hi }
            }
        }
    }

    /// Adds the call trace to a diagnostic that has none.
    pub(super) fn with_call_trace(&self, mut d: Diagnostic) -> Diagnostic {
        if d.trace.is_empty() {
            d.trace = self.call_trace().into();
        }
        d
    }

    /// Returns the macro calls and includes around the read position, innermost first; of a deep recursion the first
    /// six and the last four.
    pub(super) fn call_trace(&self) -> Vec<Label> {
        let macro_label = |name: Symbol, span: Span| {
            let text = format!("in macro `{}`, called", self.inputs.names.text(name));
            Label { span, text }
        };
        let label = |frame: &StackFrame| match frame.kind() {
            FrameKind::Macro(name) => Some(macro_label(name, frame.span())),
            FrameKind::Include => Some(Label { span: frame.span(), text: "included".into() }),
            _ => None,
        };
        let values = self.value_macros.iter().rev().map(|&(name, span)| macro_label(name, span));
        let all: Vec<Label> = values.chain(self.frames.iter().rev().filter_map(label)).collect();
        if all.len() <= 12 {
            return all;
        }
        all[..6].iter().chain(&all[all.len() - 4..]).cloned().collect()
    }
}
