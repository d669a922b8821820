//! The pull iterator over elements: it runs directives and splices macros on the way, so that whoever reads a
//! block sees one flat row of tokens. What stands whole in the text is one of them, unless something may go on with it.

mod following;

use super::Interpreter;
use super::evaluator::Slot;
use super::stream::{BlockName, FrameKind, Held, Token};
use crate::diagnostic::Result;
use crate::source::Span;
use crate::syntax::ast::*;
use crate::syntax::word::Category;
use crate::value::Value;

impl<'a> Interpreter<'a> {
    /// What comes next; directives and macros before it have run. Nothing is consumed. Commas and semicolons are passed over:
    /// `self.stream.comma` tells of them.
    pub(in crate::interpreter) fn peek(&mut self) -> Result<Token<'a>> {
        loop {
            if let Some(held) = self.stream.held.last() {
                return Ok(held.token);
            }
            if let Some(token) = self.stream.peeked {
                return Ok(token);
            }
            let Some(frame) = self.stream.frames.last_mut() else { return Ok(Token::End) };
            let element = frame.elements.get(frame.at);
            // The common case first.
            if let Some(Element { span, kind: ElementKind::Directive(directive), .. }) = element {
                frame.at += 1;
                self.directive_here(directive, *span)?;
                continue;
            }
            if element.is_none_or(may_settle) && self.settle_once()? {
                continue;
            }
            let Some(frame) = self.stream.frames.last_mut() else { return Ok(Token::End) };
            let Some(element) = frame.elements.get(frame.at) else {
                let token = frame.closer.map_or(Token::End, |bracket| Token::Sign(Sign::Close(bracket)));
                return Ok(self.announce(token));
            };
            let token = match &element.kind {
                ElementKind::Expr(expr) => match self.expr_token(expr, element)? {
                    Some(token) => token,
                    None => continue,
                },
                ElementKind::Numbers(list) => {
                    let (i, start) = frame.item;
                    Token::Numbers(&list.data[start..start + list.width(i)])
                }
                ElementKind::Word(word) => {
                    return self.word_token(word.name, word.category == Category::Function, element);
                }
                ElementKind::Block(block) => {
                    Token::Block(BlockName { word: block.name.word, span: block.name.span, body: Some(&block.body) })
                }
                ElementKind::Entry(group) => Token::Open(Bracket::Square, Some(&group.body)),
                ElementKind::Group(group) => Token::Open(Bracket::Brace, Some(&group.body)),
                ElementKind::Function(function) => Token::Function(Some(function)),
                ElementKind::Sign(Sign::Open(bracket)) => Token::Open(*bracket, None),
                ElementKind::Sign(sign) => Token::Sign(*sign),
                ElementKind::Directive(_) | ElementKind::Semicolon | ElementKind::Comma => continue,
            };
            // (An element in pieces is held.)
            return Ok(if self.stream.held.is_empty() { self.announce(token) } else { token });
        }
    }

    /// Runs directives and macro calls, and leaves what has come to its end, until something else comes next.
    pub(in crate::interpreter) fn settle(&mut self) -> Result<()> {
        while self.settle_once()? {}
        Ok(())
    }

    /// One step of that; false if there is nothing to do.
    pub(in crate::interpreter) fn settle_once(&mut self) -> Result<bool> {
        if !self.stream.held.is_empty() || self.stream.peeked.is_some() {
            return Ok(false);
        }
        let Some(frame) = self.stream.frames.last_mut() else { return Ok(false) };
        let Some(element) = frame.elements.get(frame.at) else {
            if frame.closer.is_some() || matches!(frame.kind, FrameKind::File) {
                return Ok(false);
            }
            // (A loop's condition is no matter of the row it stands in.)
            let comma = self.stream.comma;
            self.end_of_frame()?;
            self.stream.comma |= comma;
            return Ok(true);
        };
        match &element.kind {
            ElementKind::Semicolon => frame.at += 1,
            ElementKind::Comma => {
                frame.at += 1;
                self.stream.comma = true;
            }
            ElementKind::Directive(directive) => {
                frame.at += 1;
                self.directive_here(directive, element.span)?;
            }
            ElementKind::Expr(expr) => match &expr.kind {
                ExprKind::Call(name, arguments) if self.is_macro(*name) => {
                    self.stream.frames.last_mut().into_iter().for_each(|frame| frame.at += 1);
                    // (What its arguments hold is no matter of the row it stands in.)
                    let comma = self.stream.comma;
                    self.call_macro(*name, arguments, element.span, element.comma)?;
                    self.stream.comma = comma;
                }
                ExprKind::Name(name) if self.is_macro(*name) => {
                    self.stream.frames.last_mut().into_iter().for_each(|frame| frame.at += 1);
                    let comma = self.stream.comma;
                    self.call_macro_in_pieces(*name, element.span)?;
                    self.stream.comma = comma;
                }
                _ if expr.calls && self.splits(expr) => self.take_apart(),
                _ => return Ok(false),
            },
            _ => return Ok(false),
        }
        Ok(true)
    }

    /// Runs the directive that has just been passed.
    #[inline]
    pub(in crate::interpreter) fn directive_here(&mut self, directive: &'a Directive, span: Span) -> Result<()> {
        self.step(span)?;
        // A comma before it stands before what it gives.
        let comma = std::mem::replace(&mut self.stream.comma, false);
        self.run_directive(directive, span)?;
        self.stream.comma |= comma;
        Ok(())
    }

    /// The element that comes next in its frame, whatever it is; no directive and no macro runs.
    pub(in crate::interpreter) fn raw(&self) -> Option<&'a Element> {
        let held = !self.stream.held.is_empty();
        self.stream.frames.last().filter(|_| !held).and_then(|frame| frame.elements.get(frame.at))
    }

    /// Consumes a name that comes next, though it may be a macro's.
    pub(in crate::interpreter) fn raw_name(&mut self) -> Option<(Symbol, Span)> {
        let element = self.raw()?;
        let ElementKind::Expr(e) = &element.kind else { return None };
        let ExprKind::Name(symbol) = e.kind else { return None };
        self.advance();
        Some((symbol, element.span))
    }

    /// The same, if a closing bracket follows.
    pub(in crate::interpreter) fn bare_name(&mut self) -> Option<(Symbol, Span)> {
        let frame = self.stream.frames.last()?;
        match frame.elements.get(frame.at + 1).map(|e| &e.kind) {
            Some(ElementKind::Sign(Sign::Close(_))) => {}
            None if frame.closer.is_some() => {}
            _ => return None,
        }
        self.raw_name()
    }

    /// What an expression is to the reader; `None` if it has been taken apart, or called.
    pub(in crate::interpreter) fn expr_token(
        &mut self,
        expr: &'a Expr,
        element: &'a Element,
    ) -> Result<Option<Token<'a>>> {
        match &expr.kind {
            ExprKind::Name(symbol) => self.name_token(*symbol, expr, element),
            // What is skipped is not looked up.
            _ if self.stream.skipping => Ok(Some(Token::Expr(expr))),
            ExprKind::Index(base, indices) => match base.kind {
                ExprKind::Name(symbol) if !self.takes_index(symbol) => {
                    self.take_apart();
                    Ok(None)
                }
                _ => {
                    self.stream.element = Some(self.element_place(base, indices)?);
                    Ok(Some(Token::Element(expr.span)))
                }
            },
            ExprKind::Dot(..) => match self.dictionary_place(expr)? {
                Some(place) => {
                    self.stream.element = Some(place);
                    Ok(Some(Token::Element(expr.span)))
                }
                None => Ok(Some(Token::Expr(expr))),
            },
            _ if self.begins_with_own_word(expr) => {
                self.take_apart();
                Ok(None)
            }
            _ => Ok(Some(Token::Expr(expr))),
        }
    }

    /// Is what the name stands for, or the fault about it, a matter of its index? Else the `[` begins an entry.
    pub(in crate::interpreter) fn takes_index(&self, symbol: Symbol) -> bool {
        !matches!(self.evaluator.scopes.get(symbol), Some(Slot::Value(Value::Thing(_))))
    }

    /// A name alone: a word of durer's own, the name of an unknown block, an array's element in pieces, or a value.
    pub(in crate::interpreter) fn name_token(
        &mut self,
        symbol: Symbol,
        expr: &'a Expr,
        element: &'a Element,
    ) -> Result<Option<Token<'a>>> {
        if let Some(word) = self.own_word(symbol) {
            return self.word_token(word, false, element).map(Some);
        }
        if self.stream.skipping {
            return Ok(Some(Token::Expr(expr)));
        }
        let Some(frame) = self.stream.frames.last() else { return Ok(None) };
        let next = frame.elements.get(frame.at + 1).filter(|_| !element.comma);
        match next.map(|e| &e.kind) {
            Some(ElementKind::Group(_) | ElementKind::Sign(Sign::Open(Bracket::Brace))) => {
                Ok(Some(Token::Block(BlockName { word: None, span: expr.span, body: None })))
            }
            Some(ElementKind::Entry(_) | ElementKind::Sign(Sign::Open(Bracket::Square) | Sign::Dot))
                if matches!(self.evaluator.scopes.get(symbol), Some(Slot::Array(_))) =>
            {
                self.element_in_pieces(symbol, expr).map(Some)
            }
            // (The fault is that it has no elements.)
            Some(ElementKind::Sign(Sign::Open(Bracket::Square))) if matches!(self.evaluator.scopes.get(symbol), Some(Slot::Value(value)) if !matches!(value, Value::Thing(_))) => {
                self.element_in_pieces(symbol, expr).map(Some)
            }
            None if !element.comma && matches!(self.evaluator.scopes.get(symbol), Some(Slot::Array(_))) => {
                self.element_in_pieces(symbol, expr).map(Some)
            }
            _ => Ok(Some(Token::Expr(expr))),
        }
    }

    /// durer's own word in the block around here, if the name is one.
    pub(in crate::interpreter) fn own_word(&self, symbol: Symbol) -> Option<&'static str> {
        let words = self.stream.opened.last()?.own_words;
        if words.is_empty() {
            return None;
        }
        let name = self.inputs.names.text(symbol);
        words.iter().copied().find(|word| *word == name)
    }

    /// Does an expression begin with such a word? `eye -5*z` reads as a name minus something.
    pub(in crate::interpreter) fn begins_with_own_word(&self, e: &Expr) -> bool {
        if self.stream.opened.last().is_none_or(|o| o.own_words.is_empty()) {
            return false;
        }
        let mut first = e;
        loop {
            first = match &first.kind {
                ExprKind::Chain(chain) => &chain.first,
                ExprKind::Choice(parts) => &parts[0],
                ExprKind::Call(symbol, _) => return self.own_word(*symbol).is_some(),
                ExprKind::Name(symbol) => return self.own_word(*symbol).is_some(),
                _ => return false,
            };
        }
    }

    /// A word: does it open a block, or is it a function that is called? Where a directive, a macro or the end of a body follows, they tell.
    pub(in crate::interpreter) fn word_token(
        &mut self,
        word: &'static str,
        callee: bool,
        element: &'a Element,
    ) -> Result<Token<'a>> {
        let span = element.span;
        let Some(frame) = self.stream.frames.last_mut() else { return Ok(Token::End) };
        let alone = if word == "function" { Token::Function(None) } else { Token::Word(word) };
        let block = Token::Block(BlockName { word: Some(word), span, body: None });
        let next = frame.elements.get(frame.at + 1).map(|e| &e.kind);
        let callee = callee.then_some(Token::Callee(word));
        let unknown = match next {
            _ if element.comma || word == "function" => false,
            Some(ElementKind::Group(_) | ElementKind::Sign(Sign::Open(Bracket::Brace))) => {
                return Ok(self.announce(block));
            }
            Some(ElementKind::Sign(Sign::Open(Bracket::Paren))) if let Some(callee) = callee => {
                return Ok(self.announce(callee));
            }
            Some(ElementKind::Directive(_)) => true,
            Some(ElementKind::Expr(e)) => e.calls || matches!(e.kind, ExprKind::Name(name) if self.is_macro(name)),
            Some(_) => false,
            None => frame.closer.is_none() && !matches!(frame.kind, FrameKind::File),
        };
        if !unknown {
            return Ok(self.announce(alone));
        }
        if let Some(frame) = self.stream.frames.last_mut() {
            frame.at += 1;
        }
        let before = std::mem::replace(&mut self.stream.comma, false);
        self.settle()?;
        let known = self.stream.held.last().map(|held| held.token).or(self.stream.peeked);
        let (brace, paren) = match known {
            Some(token) => {
                (matches!(token, Token::Open(Bracket::Brace, _)), matches!(token, Token::Open(Bracket::Paren, _)))
            }
            None => match self.stream.frames.last() {
                Some(frame) => (frame.opens_brace(frame.at), frame.opens_paren(frame.at)),
                None => (false, false),
            },
        };
        let token = match callee {
            _ if self.stream.comma => alone,
            Some(callee) if paren => callee,
            _ if brace => block,
            _ => alone,
        };
        Ok(self.hold(token, span, before))
    }

    /// A number and its `;`, if nothing else comes next: both are consumed.
    pub(in crate::interpreter) fn simple_statement(&mut self) -> Option<f64> {
        let frame = self.stream.frames.last()?;
        let [Element { kind: ElementKind::Expr(e), .. }, Element { kind: ElementKind::Semicolon, .. }, ..] =
            frame.elements.get(frame.at..)?
        else {
            return None;
        };
        let x = if e.compares() { None } else { self.simple(e) }?;
        self.stream.peeked = None;
        self.stream.frames.last_mut()?.at += 2;
        Some(x)
    }

    /// The place of a `;` that comes next.
    pub(in crate::interpreter) fn at_semicolon(&self) -> Option<Span> {
        self.raw().filter(|element| matches!(element.kind, ElementKind::Semicolon)).map(|element| element.span)
    }

    pub(in crate::interpreter) fn announce(&mut self, token: Token<'a>) -> Token<'a> {
        self.stream.peeked = Some(token);
        token
    }

    /// Tells that the next token is this one, whose text has been consumed; did a comma stand before it?
    pub(in crate::interpreter) fn hold(&mut self, token: Token<'a>, span: Span, before: bool) -> Token<'a> {
        let comma = std::mem::replace(&mut self.stream.comma, before);
        self.stream.held.push(Held { token, span, comma });
        token
    }

    /// Consumes what [`Self::peek`] announced.
    pub(in crate::interpreter) fn advance(&mut self) {
        if let Some(held) = self.stream.held.pop() {
            self.stream.comma = held.comma;
            return;
        }
        self.stream.peeked = None;
        let Some(frame) = self.stream.frames.last_mut() else { return };
        let Some(element) = frame.elements.get(frame.at) else {
            if frame.closer.is_some() {
                let comma = frame.comma;
                self.pop_frame();
                self.stream.comma = comma;
            }
            return;
        };
        self.stream.comma = element.comma;
        if let ElementKind::Numbers(list) = &element.kind {
            let (i, start) = frame.item;
            frame.item = (i + 1, start + list.width(i));
            if i + 1 < list.len() {
                self.stream.comma = true;
                return;
            }
            frame.item = (0, 0);
        }
        frame.at += 1;
    }

    /// Consumes the next item of a list of literals that has been begun, unless it is the last.
    pub(in crate::interpreter) fn inner_literal(&mut self) -> Option<&'a [f64]> {
        if self.stream.peeked.is_some() || !self.stream.held.is_empty() {
            return None;
        }
        let frame = self.stream.frames.last_mut()?;
        let ElementKind::Numbers(list) = &frame.elements.get(frame.at)?.kind else { return None };
        let (i, start) = frame.item;
        if i == 0 || i + 1 >= list.len() {
            return None;
        }
        let end = start + list.width(i);
        frame.item = (i + 1, end);
        Some(&list.data[start..end])
    }

    /// The same while each has so many numbers and `take` accepts them, at most so many; returns how many.
    pub(in crate::interpreter) fn inner_literals(
        &mut self,
        width: usize,
        most: usize,
        take: &mut dyn FnMut(&[f64]) -> bool,
    ) -> usize {
        if self.stream.peeked.is_some() || !self.stream.held.is_empty() {
            return 0;
        }
        let Some(frame) = self.stream.frames.last_mut() else { return 0 };
        let Some(Element { kind: ElementKind::Numbers(list), .. }) = frame.elements.get(frame.at) else { return 0 };
        let (first, mut at) = frame.item;
        let end = if first == 0 { 0 } else { (list.len() - 1).min(first.saturating_add(most)) };
        let mut i = first;
        while i < end && list.width(i) == width && take(&list.data[at..at + width]) {
            (i, at) = (i + 1, at + width);
        }
        frame.item = (i, at);
        i - first
    }

    /// The place of what comes next.
    pub(in crate::interpreter) fn here(&self) -> Span {
        if let Some(held) = self.stream.held.last() {
            return held.span;
        }
        let Some(frame) = self.stream.frames.last() else { return Span::NONE };
        match frame.elements.get(frame.at) {
            Some(Element { span, kind: ElementKind::Numbers(_), .. }) => {
                let found =
                    self.stream.list_places.borrow_mut().find(self.inputs.sources.snippet(*span), *span, frame.item.0);
                found.unwrap_or(*span)
            }
            Some(Element { kind: ElementKind::Block(block), .. }) => block.name.span,
            Some(Element { span, kind: ElementKind::Group(_) | ElementKind::Entry(_), .. }) => {
                Span { hi: span.lo + 1, ..*span }
            }
            Some(element) => element.span,
            None => Span { lo: frame.span.hi.saturating_sub(1).max(frame.span.lo), hi: frame.span.hi },
        }
    }
}

/// Can this be something else than a token? (It mostly is none.)
pub(in crate::interpreter) fn may_settle(element: &Element) -> bool {
    match &element.kind {
        ElementKind::Numbers(_) | ElementKind::Word(_) | ElementKind::Block(_) | ElementKind::Sign(_) => false,
        ElementKind::Expr(e) => e.calls || matches!(e.kind, ExprKind::Name(_)),
        _ => true,
    }
}
