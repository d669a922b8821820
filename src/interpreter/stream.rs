//! The pull iterator over elements: it runs directives and splices macros on the way, so that whoever reads a
//! block sees one flat row of tokens.

use super::Interpreter;
use crate::diagnostic::{Diagnostic, Result, codes};
use crate::source::Span;
use crate::syntax::ast::*;

/// What the iterator gives.
#[derive(Clone, Copy, Debug)]
pub(super) enum Token<'a> {
    Word(&'static str),
    Block(&'a Block),
    Open(&'a Name),
    Expr(&'a Expr),
    /// An item of a literal list: one number, or a vector of several.
    Numbers(&'a [f64]),
    Entry(&'a [Element]),
    Group(&'a [Element]),
    Function(&'a Function),
    /// An element of an array alone; its indices are evaluated, and where it is kept stands in `Interpreter::element`.
    Element(&'a Expr),
    /// `.Name :`
    Key(Symbol),
    Colon,
    Values(&'a [Element]),
    /// The end of the block, entry, group, argument list or file that is being read.
    End,
}

/// Where elements come from.
pub(super) struct Frame<'a> {
    pub(super) elements: &'a [Element],
    pub(super) at: usize,
    /// Index within a literal list, and of its first number.
    pub(super) item: (usize, usize),
    pub(super) kind: FrameKind<'a>,
    /// The whole of what is being read: block, call, directive.
    pub(super) span: Span,
}

pub(super) enum FrameKind<'a> {
    /// Read until its end, which whoever opened it consumes: block, entry, group, arguments, outermost file.
    Enclosed,
    /// A branch or an arm: its end is passed over.
    Branch,
    /// Like a branch, and `#break` leaves it.
    Switch,
    While(&'a Expr),
    For {
        counter: Symbol,
        last: f64,
        step: f64,
    },
    Macro(Symbol),
    /// A macro's body whose value is wanted: its end stops the reading.
    Call(Symbol),
    Include,
}

impl Frame<'_> {
    /// After a fault: on to the end of the statement that began at index `from`.
    pub(super) fn skip_statement(&mut self, from: usize) {
        self.item = (0, 0);
        if self.at == from {
            self.at += 1;
        }
        // A block or a function ends a statement.
        // (A loop's next pass stands at its start.)
        let last = self.at.checked_sub(1).and_then(|last| self.elements.get(last)).map(|e| &e.kind);
        if matches!(last, Some(ElementKind::Block(_) | ElementKind::Function(_))) {
            return;
        }
        while let Some(element) = self.elements.get(self.at) {
            match element.kind {
                ElementKind::Block(_) | ElementKind::Open(_) | ElementKind::Directive(_) => return,
                ElementKind::Semicolon => {
                    self.at += 1;
                    return;
                }
                _ => self.at += 1,
            }
        }
    }
}

impl Frame<'_> {
    /// After a declared texture that failed: over its other layers.
    pub(super) fn skip_layers(&mut self, from: usize) {
        let is_texture = |e: Option<&Element>| matches!(e, Some(Element { kind: ElementKind::Block(b), .. }) if b.name.word == Some("texture"));
        if is_texture(self.elements.get(from)) {
            while is_texture(self.elements.get(self.at)) {
                self.at += 1;
            }
        }
    }
}

impl<'a> Interpreter<'a> {
    /// What comes next; directives and macros before it have run. Nothing is consumed.
    pub(super) fn peek(&mut self) -> Result<Token<'a>> {
        if let Some(token) = self.peeked {
            return Ok(token);
        }
        loop {
            let Some(frame) = self.frames.last_mut() else { return Ok(Token::End) };
            let Some(element) = frame.elements.get(frame.at) else {
                if matches!(frame.kind, FrameKind::Enclosed | FrameKind::Call(_)) {
                    return Ok(self.announce(Token::End));
                }
                self.end_of_frame()?;
                continue;
            };
            let token = match &element.kind {
                ElementKind::Semicolon => {
                    frame.at += 1;
                    continue;
                }
                ElementKind::Directive(directive) => {
                    frame.at += 1;
                    self.step(element.span)?;
                    self.run_directive(directive, element.span)?;
                    continue;
                }
                ElementKind::Expr(expr) => match &expr.kind {
                    ExprKind::Call(name, arguments) if self.is_macro(*name) => {
                        if let Some(frame) = self.frames.last_mut() {
                            frame.at += 1;
                        }
                        self.call_macro(*name, arguments, element.span)?;
                        continue;
                    }
                    ExprKind::Chain(chain) if self.leads_with_block(chain) => {
                        if let Some(frame) = self.frames.last_mut() {
                            frame.at += 1;
                        }
                        self.call_before_sign(chain, element.span)?;
                        continue;
                    }
                    ExprKind::Keyword(word) => Token::Word(word),
                    ExprKind::Index(base, indices) => {
                        self.element = Some(self.element_place(base, indices)?);
                        Token::Element(expr)
                    }
                    ExprKind::Dot(..) => match self.dictionary_place(expr)? {
                        Some(place) => {
                            self.element = Some(place);
                            Token::Element(expr)
                        }
                        None => Token::Expr(expr),
                    },
                    _ => Token::Expr(expr),
                },
                ElementKind::Numbers(list) => {
                    let (i, start) = frame.item;
                    Token::Numbers(&list.data[start..start + list.width(i)])
                }
                ElementKind::Word(word) => Token::Word(word),
                ElementKind::Block(block) => Token::Block(block),
                ElementKind::Open(name) => Token::Open(name),
                ElementKind::Entry(elements) => Token::Entry(elements),
                ElementKind::Group(elements) => Token::Group(elements),
                ElementKind::Function(function) => Token::Function(function),
                ElementKind::Key(symbol) => Token::Key(*symbol),
                ElementKind::Colon => Token::Colon,
                ElementKind::Values(elements) => Token::Values(elements),
                ElementKind::Close => Token::End,
            };
            return Ok(self.announce(token));
        }
    }

    /// Like [`Self::peek`], but stops before directives and semicolons, and at the end of what the value that is being
    /// declared stands in.
    pub(super) fn peek_on(&mut self) -> Result<Token<'a>> {
        while self.peeked.is_none() {
            let Some(frame) = self.frames.last() else { return Ok(Token::End) };
            match frame.elements.get(frame.at).map(|e| &e.kind) {
                Some(ElementKind::Directive(_) | ElementKind::Semicolon) => return Ok(Token::End),
                Some(_) => break,
                None => match frame.kind {
                    FrameKind::Branch | FrameKind::Macro(_) if self.frames.len() > self.floor => self.pop_frame(),
                    _ => return Ok(Token::End),
                },
            }
        }
        self.peek()
    }

    /// Runs what the macros that gave a declared value still have to run, down to `floor` frames.
    pub(super) fn drain(&mut self, floor: usize) -> Result<()> {
        self.peeked = None;
        while self.frames.len() > floor {
            let Some(frame) = self.frames.last_mut() else { break };
            match frame.elements.get(frame.at) {
                None => self.end_of_frame()?,
                Some(element) => {
                    frame.at += 1;
                    match &element.kind {
                        ElementKind::Semicolon => {}
                        ElementKind::Directive(directive) => self.run_directive(directive, element.span)?,
                        _ => {
                            let message = "the macro gives more than the one value that is declared here";
                            return Diagnostic::err(codes::WRONG_COUNT, element.span, message);
                        }
                    }
                }
            }
        }
        Ok(())
    }

    /// A number and its `;`, if nothing else comes next: both are consumed.
    pub(super) fn simple_statement(&mut self) -> Option<f64> {
        let frame = self.frames.last()?;
        let [Element { kind: ElementKind::Expr(e), .. }, Element { kind: ElementKind::Semicolon, .. }, ..] =
            frame.elements.get(frame.at..)?
        else {
            return None;
        };
        let x = self.simple(e)?;
        self.peeked = None;
        self.frames.last_mut()?.at += 2;
        Some(x)
    }

    /// The place of a `;` that comes next.
    pub(super) fn at_semicolon(&self) -> Option<Span> {
        let element = self.frames.last().and_then(|frame| frame.elements.get(frame.at))?;
        matches!(element.kind, ElementKind::Semicolon).then_some(element.span)
    }

    fn announce(&mut self, token: Token<'a>) -> Token<'a> {
        self.peeked = Some(token);
        token
    }

    /// Consumes what [`Self::peek`] announced, except the end of an enclosed frame.
    pub(super) fn advance(&mut self) {
        self.peeked = None;
        let Some(frame) = self.frames.last_mut() else { return };
        let Some(element) = frame.elements.get(frame.at) else { return };
        if let ElementKind::Numbers(list) = &element.kind {
            let (i, start) = frame.item;
            frame.item = (i + 1, start + list.width(i));
            if i + 1 < list.len() {
                return;
            }
            frame.item = (0, 0);
        }
        frame.at += 1;
    }

    /// The place of what comes next.
    pub(super) fn here(&self) -> Span {
        let Some(frame) = self.frames.last() else { return Span::NONE };
        match frame.elements.get(frame.at) {
            Some(Element { span, kind: ElementKind::Numbers(_) }) => self.item_span(*span, frame.item.0),
            Some(element) => element.span,
            None => Span { lo: frame.span.hi.saturating_sub(1).max(frame.span.lo), hi: frame.span.hi },
        }
    }

    /// The place of one item of a literal list: its text is scanned again, which only messages do.
    fn item_span(&self, list: Span, item: usize) -> Span {
        let text = self.sources.snippet(list);
        let (mut depth, mut index, mut start) = (0, 0, 0);
        for (i, c) in text.char_indices().chain([(text.len(), ',')]) {
            match c {
                '<' => depth += 1,
                '>' => depth -= 1,
                ',' if depth == 0 && index == item => {
                    let piece = &text[start..i];
                    let lo = list.lo as usize + start + (piece.len() - piece.trim_start().len());
                    return Span::new(lo, lo + piece.trim().len());
                }
                ',' if depth == 0 => (index, start) = (index + 1, i + 1),
                _ => {}
            }
        }
        list
    }

    pub(super) fn push_frame(&mut self, elements: &'a [Element], kind: FrameKind<'a>, span: Span) {
        self.peeked = None;
        self.frames.push(Frame { elements, at: 0, item: (0, 0), kind, span });
    }

    /// Drops the innermost frame, and the scope that came with it.
    pub(super) fn pop_frame(&mut self) {
        self.peeked = None;
        let Some(frame) = self.frames.pop() else { return };
        match frame.kind {
            FrameKind::Macro(_) | FrameKind::Call(_) => {
                self.scopes.leave();
                self.depth -= 1;
            }
            FrameKind::Include => {
                self.scopes.leave();
                self.leave_include();
            }
            _ => {}
        }
    }

    /// After an error: back to the frames that were there when the statement began.
    pub(super) fn unwind(&mut self, depth: usize) {
        while self.frames.len() > depth {
            self.pop_frame();
        }
        self.peeked = None;
    }

    /// A frame that nobody waits for has run out: loops begin again, all others go.
    fn end_of_frame(&mut self) -> Result<()> {
        let Some(frame) = self.frames.last() else { return Ok(()) };
        let span = frame.span;
        let again = match frame.kind {
            FrameKind::While(condition) => self.step(span).and_then(|()| self.condition(condition)),
            FrameKind::For { counter, last, step } => {
                self.step(span).and_then(|()| self.advance_counter(counter, last, step, span))
            }
            _ => Ok(false),
        };
        let again = match again {
            Ok(again) => again,
            Err(fault) => {
                // A loop whose condition fails ends here.
                let fault = self.with_trace(*fault);
                self.pop_frame();
                return Err(Box::new(fault));
            }
        };
        match self.frames.last_mut() {
            Some(frame) if again => frame.at = 0,
            _ => self.pop_frame(),
        }
        Ok(())
    }

    /// `#break`: leaves the innermost loop, `#switch` or macro.
    pub(super) fn break_out(&mut self, span: Span) -> Result<()> {
        let is_breakable = |f: &Frame| {
            matches!(f.kind, FrameKind::While(_) | FrameKind::For { .. } | FrameKind::Switch | FrameKind::Macro(_))
        };
        let is_branch = |f: &Frame| matches!(f.kind, FrameKind::Branch);
        let inner = self.frames.iter().rev().take_while(|f| is_branch(f)).count();
        let target = self.frames.len().checked_sub(inner + 1);
        match target {
            Some(depth) if matches!(self.frames[depth].kind, FrameKind::Call(_)) => {
                self.unwind(depth + 1);
                if let Some(frame) = self.frames.last_mut() {
                    frame.at = frame.elements.len();
                }
                Ok(())
            }
            Some(depth) if is_breakable(&self.frames[depth]) => {
                self.unwind(depth);
                Ok(())
            }
            _ => Diagnostic::new(codes::BREAK_OUTSIDE, span, "`#break` stands in no loop, no `#switch` and no macro")
                .help("it leaves the innermost `#while`, `#for`, `#switch` or `#macro`")
                .into(),
        }
    }
}
