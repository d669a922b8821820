//! The pull iterator over elements: it runs directives and splices macros on the way, so that whoever reads a
//! block sees one flat row of tokens. What stands whole in the text is one of them, unless something may go on with it.

use super::Interpreter;
use super::scope::Slot;
use crate::diagnostic::{Diagnostic, Result, codes};
use crate::source::Span;
use crate::syntax::ast::*;
use crate::syntax::{begins_with_parenthesis, begins_with_sign, pieces};
use crate::value::Value;

/// What the iterator gives.
#[derive(Clone, Copy, Debug)]
pub(super) enum Token<'a> {
    Word(&'static str),
    /// The name of a built-in function that has arguments behind it.
    Callee(&'static str),
    /// A word and the `{` behind it.
    Block(BlockName<'a>),
    /// An expression without macros: its value is what it is wherever it stands.
    Expr(&'a Expr),
    /// An item of a literal list: one number, or a vector of several.
    Numbers(&'a [f64]),
    /// `{`, `[` or `(`, and what stands between it and its partner, if that is whole.
    Open(Bracket, Option<&'a [Element]>),
    /// `function { … }`; without its parts only the word.
    Function(Option<&'a Function>),
    /// An element of an array alone; its indices are evaluated, and where it is kept stands in `Interpreter::element`.
    Element(Span),
    /// A closing bracket, an operator.
    Sign(Sign),
    /// The end of the text.
    End,
}

/// What stands before a `{`.
#[derive(Clone, Copy, Debug)]
pub(super) struct BlockName<'a> {
    /// The keyword; `None` for a word that is none.
    pub(super) word: Option<&'static str>,
    pub(super) span: Span,
    /// What stands between the braces; `None` where the tokens of the block come one by one.
    pub(super) body: Option<&'a [Element]>,
}

impl Token<'_> {
    /// Does it close a bracket, or is there no more text?
    pub(super) fn ends(self) -> bool {
        matches!(self, Token::End | Token::Sign(Sign::Close(_)))
    }

    pub(super) fn closes(self, bracket: Bracket) -> bool {
        matches!(self, Token::Sign(Sign::Close(found)) if found == bracket)
    }
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
    /// The bracket that follows the last element.
    pub(super) closer: Option<Bracket>,
    /// Does a comma follow?
    pub(super) comma: bool,
}

pub(super) enum FrameKind<'a> {
    /// The outermost file.
    File,
    /// Between brackets, or an expression taken apart.
    Piece,
    /// A branch or an arm.
    Branch,
    /// Like a branch, and `#break` leaves it.
    Switch,
    While(&'a Head),
    For {
        counter: Symbol,
        last: f64,
        step: f64,
    },
    Macro(Symbol),
    Include,
}

/// A token whose text has been consumed.
pub(super) struct Held<'a> {
    token: Token<'a>,
    span: Span,
    /// Does a comma follow?
    comma: bool,
}

/// A bracket that is open.
pub(super) struct Opened {
    /// The word before it.
    pub(super) word: Option<&'static str>,
    /// The word's place, or the bracket's.
    pub(super) span: Span,
    /// The place of the bracket alone, where it is a token by itself.
    pub(super) alone: Option<Span>,
    pub(super) bracket: Bracket,
    /// How many frames there were.
    frames: usize,
    /// What [`Interpreter::closed`] was outside.
    closed: bool,
}

/// Where the reading was, to go back there after a fault.
#[derive(Clone, Copy)]
pub(super) struct Mark {
    pub(super) frames: usize,
    pub(super) opened: usize,
    pub(super) at: usize,
    pub(super) closed: bool,
}

/// Brackets and values that are read inside each other.
const MAX_NESTING: usize = 5_000;

impl Frame<'_> {
    /// Has an expression that was taken apart come to its end?
    pub(super) fn is_spent_piece(&self) -> bool {
        let whole = matches!(self.kind, FrameKind::Piece) && self.closer.is_none();
        whole && self.at >= self.elements.len()
    }

    /// After a fault: on to the end of the statement that began at index `from`, of which so many brackets are open.
    fn skip_statement(&mut self, from: usize, open: usize) {
        self.item = (0, 0);
        self.closer = None;
        if open > 0 {
            return self.skip_brackets(open);
        }
        if self.at == from {
            self.skip_one();
        }
        // A block or a function ends a statement.
        // (A loop's next pass stands at its start.)
        let last = self.at.checked_sub(1).and_then(|last| self.elements.get(last)).map(|e| &e.kind);
        let ends = [Sign::Close(Bracket::Brace)].map(ElementKind::Sign);
        match last {
            Some(ElementKind::Block(_) | ElementKind::Function(_)) => return,
            Some(ElementKind::Sign(sign)) if matches!(&ends[0], ElementKind::Sign(end) if end == sign) => return,
            _ => {}
        }
        while let Some(element) = self.elements.get(self.at) {
            match element.kind {
                ElementKind::Block(_) | ElementKind::Directive(_) => return,
                ElementKind::Word(_) if self.opens_brace(self.at + 1) => return,
                ElementKind::Semicolon => {
                    self.at += 1;
                    return;
                }
                _ => self.skip_one(),
            }
        }
    }

    fn opens_brace(&self, at: usize) -> bool {
        matches!(
            self.elements.get(at).map(|e| &e.kind),
            Some(ElementKind::Group(_) | ElementKind::Sign(Sign::Open(Bracket::Brace)))
        )
    }

    fn opens_paren(&self, at: usize) -> bool {
        match self.elements.get(at).map(|e| &e.kind) {
            Some(ElementKind::Sign(sign)) => *sign == Sign::Open(Bracket::Paren),
            Some(ElementKind::Expr(e)) => matches!(e.kind, ExprKind::Paren(_)),
            _ => false,
        }
    }

    /// Over one element, or over a bracket with all that is in it.
    fn skip_one(&mut self) {
        let opens = matches!(self.elements.get(self.at).map(|e| &e.kind), Some(ElementKind::Sign(Sign::Open(_))));
        self.at += 1;
        if opens {
            self.skip_brackets(1);
        }
    }

    fn skip_brackets(&mut self, mut open: usize) {
        while let Some(element) = self.elements.get(self.at) {
            self.at += 1;
            match element.kind {
                ElementKind::Sign(Sign::Open(_)) => open += 1,
                ElementKind::Sign(Sign::Close(_)) => open -= 1,
                _ => {}
            }
            if open == 0 {
                return;
            }
        }
    }

    /// After a declared texture that failed: over its other layers.
    pub(super) fn skip_layers(&mut self, from: usize) {
        let is_texture = |frame: &Self, at: usize| match frame.elements.get(at).map(|e| &e.kind) {
            Some(ElementKind::Block(b)) => b.name.word == Some("texture"),
            Some(ElementKind::Word(word)) => word.name == "texture" && frame.opens_brace(at + 1),
            _ => false,
        };
        if is_texture(self, from) {
            while is_texture(self, self.at) {
                let alone = matches!(self.elements[self.at].kind, ElementKind::Word(_));
                self.at += usize::from(alone);
                self.skip_one();
            }
        }
    }
}

impl<'a> Interpreter<'a> {
    /// What comes next; directives and macros before it have run. Nothing is consumed. Commas and semicolons are passed over:
    /// `self.comma` tells of them.
    pub(super) fn peek(&mut self) -> Result<Token<'a>> {
        loop {
            if let Some(held) = self.held.last() {
                return Ok(held.token);
            }
            if let Some(token) = self.peeked {
                return Ok(token);
            }
            if self.settle_once()? {
                continue;
            }
            let Some(frame) = self.frames.last_mut() else { return Ok(Token::End) };
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
                ElementKind::Word(word) => return self.word_token(word.name, element),
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
            return Ok(if self.held.is_empty() { self.announce(token) } else { token });
        }
    }

    /// Runs directives and macro calls, and leaves what has come to its end, until something else comes next.
    fn settle(&mut self) -> Result<()> {
        while self.settle_once()? {}
        Ok(())
    }

    /// One step of that; false if there is nothing to do.
    fn settle_once(&mut self) -> Result<bool> {
        if !self.held.is_empty() || self.peeked.is_some() {
            return Ok(false);
        }
        let Some(frame) = self.frames.last_mut() else { return Ok(false) };
        let Some(element) = frame.elements.get(frame.at) else {
            if frame.closer.is_some() || matches!(frame.kind, FrameKind::File) {
                return Ok(false);
            }
            self.end_of_frame()?;
            return Ok(true);
        };
        match &element.kind {
            ElementKind::Semicolon => frame.at += 1,
            ElementKind::Comma => {
                frame.at += 1;
                self.comma = true;
            }
            ElementKind::Directive(directive) => {
                frame.at += 1;
                let comma = self.comma;
                self.step(element.span)?;
                self.comma = false;
                self.run_directive(directive, element.span)?;
                self.comma |= comma;
            }
            ElementKind::Expr(expr) => match &expr.kind {
                ExprKind::Call(name, arguments) if self.is_macro(*name) => {
                    self.frames.last_mut().into_iter().for_each(|frame| frame.at += 1);
                    // (What its arguments hold is no matter of the row it stands in.)
                    let comma = self.comma;
                    self.call_macro(*name, arguments, element.span, element.comma)?;
                    self.comma = comma;
                }
                ExprKind::Name(name) if self.is_macro(*name) => {
                    self.frames.last_mut().into_iter().for_each(|frame| frame.at += 1);
                    let comma = self.comma;
                    self.call_macro_in_pieces(*name, element.span)?;
                    self.comma = comma;
                }
                _ if expr.calls && self.splits(expr) => self.take_apart(),
                _ => return Ok(false),
            },
            _ => return Ok(false),
        }
        Ok(true)
    }

    /// Does a macro in the expression give tokens of its own, or is something called that can't be? Then it is no whole.
    pub(super) fn splits(&self, e: &Expr) -> bool {
        if !e.calls {
            return false;
        }
        let any = |elements: &[Element]| elements.iter().any(|element| self.element_splits(element));
        match &e.kind {
            ExprKind::Call(name, arguments) => match self.scopes.get(*name) {
                Some(Slot::Value(Value::Thing(thing))) if is_callable(thing.kind()) => any(arguments),
                // A value before a parenthesis is no call: `plane { z (-6) }`.
                Some(Slot::Value(_) | Slot::Macro(_)) => true,
                Some(_) => false,
                None => self.is_constant(*name),
            },
            ExprKind::Vector(parts) => any(parts),
            ExprKind::Paren(inner) | ExprKind::Prefix(_, inner) => self.splits(inner),
            ExprKind::Chain(chain) => self.splits(&chain.first) || chain.rest.iter().any(|(_, e)| self.splits(e)),
            ExprKind::Choice(parts) => parts.iter().any(|e| self.splits(e)),
            ExprKind::Builtin(_, arguments) => arguments.iter().any(|e| self.splits(e)),
            ExprKind::Index(base, indices) => self.splits(base) || indices.iter().any(|e| self.splits(e)),
            ExprKind::Apply(base, arguments) => self.splits(base) || any(arguments),
            ExprKind::Dot(base, _, symbol) => self.splits(base) || self.is_macro(*symbol),
            ExprKind::Block(_) | ExprKind::Function(_) => true,
            ExprKind::Number(_) | ExprKind::Text(_) | ExprKind::Name(_) | ExprKind::Literal(_) => false,
        }
    }

    fn element_splits(&self, element: &Element) -> bool {
        match &element.kind {
            ElementKind::Expr(e) => match &e.kind {
                ExprKind::Name(name) => self.is_macro(*name),
                _ => e.compares() || self.splits(e),
            },
            ElementKind::Numbers(_) => false,
            // `cubic_spline` of a spline's call.
            ElementKind::Word(_) => false,
            _ => true,
        }
    }

    /// Replaces the expression or list of literals that comes next by its parts.
    pub(super) fn take_apart(&mut self) {
        self.peeked = None;
        let Some(frame) = self.frames.last_mut() else { return };
        let Some(element) = frame.elements.get(frame.at) else { return };
        let item = frame.item;
        frame.at += 1;
        frame.item = (0, 0);
        let key: *const () = std::ptr::from_ref(element).cast();
        let parts = match self.parts.get(&key) {
            Some(parts) => *parts,
            None => {
                let made = match &element.kind {
                    ElementKind::Expr(e) => pieces(e, self.names),
                    ElementKind::Numbers(_) => self.tokens_of(element.span),
                    _ => vec![element.clone()],
                };
                let parts = self.keep_elements(self.with_exact_signs(made));
                *self.parts.entry(key).or_insert(parts)
            }
        };
        self.push_piece(parts, None, element.span, element.comma);
        if let (ElementKind::Numbers(list), Some(frame)) = (&element.kind, self.frames.last_mut()) {
            // Those that were read before are passed over: each item ends with a comma.
            let behind = parts.iter().enumerate().filter(|(_, e)| e.comma && item_ends(parts, e)).map(|(i, _)| i + 1);
            frame.at = if item.0 == 0 { 0 } else { behind.take(list.len()).nth(item.0 - 1).unwrap_or(0) };
        }
    }

    /// The place of an operator that was taken out of an expression is all that stands between its operands.
    fn with_exact_signs(&self, mut parts: Vec<Element>) -> Vec<Element> {
        for part in parts.iter_mut().filter(|part| matches!(part.kind, ElementKind::Sign(_))) {
            let text = self.sources.snippet(part.span);
            let lo = part.span.lo + (text.len() - text.trim_start().len()) as u32;
            part.span = Span { lo, hi: lo + text.trim().len() as u32 };
        }
        parts
    }

    /// An expression as the only element of a row, so that it is taken apart where it has to be.
    pub(super) fn as_elements(&mut self, e: &'a Expr) -> &'a [Element] {
        let key: *const () = std::ptr::from_ref(e).cast();
        if let Some(elements) = self.parts.get(&key) {
            return elements;
        }
        let element = Element::new(e.span, ElementKind::Expr(Box::new(e.clone())));
        let elements = self.keep_elements(vec![element]);
        self.parts.insert(key, elements);
        elements
    }

    /// Keeps elements that the run has made.
    pub(super) fn keep_elements(&self, elements: Vec<Element>) -> &'a [Element] {
        &self.parsed.asts.push_get(Box::new(Ast { elements, ..Ast::default() })).elements
    }

    /// The element that comes next in its frame, whatever it is; no directive and no macro runs.
    pub(super) fn raw(&self) -> Option<&'a Element> {
        let held = !self.held.is_empty();
        self.frames.last().filter(|_| !held).and_then(|frame| frame.elements.get(frame.at))
    }

    /// Consumes a name that comes next, though it may be a macro's.
    pub(super) fn raw_name(&mut self) -> Option<(Symbol, Span)> {
        let element = self.raw()?;
        let ElementKind::Expr(e) = &element.kind else { return None };
        let ExprKind::Name(symbol) = e.kind else { return None };
        self.advance();
        Some((symbol, element.span))
    }

    /// The same, if a closing bracket follows.
    pub(super) fn bare_name(&mut self) -> Option<(Symbol, Span)> {
        let frame = self.frames.last()?;
        match frame.elements.get(frame.at + 1).map(|e| &e.kind) {
            Some(ElementKind::Sign(Sign::Close(_))) => {}
            None if frame.closer.is_some() => {}
            _ => return None,
        }
        self.raw_name()
    }

    /// A piece of text as single tokens.
    pub(super) fn tokens_of(&self, span: Span) -> Vec<Element> {
        let text = self.sources.snippet(span);
        crate::syntax::parse_text(text, span.lo as usize, self.names, crate::syntax::Wholes::TakenApart).0.elements
    }

    /// What an expression is to the reader; `None` if it has been taken apart, or called.
    fn expr_token(&mut self, expr: &'a Expr, element: &'a Element) -> Result<Option<Token<'a>>> {
        match &expr.kind {
            ExprKind::Name(symbol) => self.name_token(*symbol, expr, element),
            // What is skipped is not looked up.
            _ if self.skipping => Ok(Some(Token::Expr(expr))),
            ExprKind::Index(base, indices) => match base.kind {
                ExprKind::Name(symbol) if !self.takes_index(symbol) => {
                    self.take_apart();
                    Ok(None)
                }
                _ => {
                    self.element = Some(self.element_place(base, indices)?);
                    Ok(Some(Token::Element(expr.span)))
                }
            },
            ExprKind::Dot(..) => match self.dictionary_place(expr)? {
                Some(place) => {
                    self.element = Some(place);
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
    fn takes_index(&self, symbol: Symbol) -> bool {
        !matches!(self.scopes.get(symbol), Some(Slot::Value(Value::Thing(_))))
    }

    /// A name alone: a word of durer's own, the name of an unknown block, an array's element in pieces, or a value.
    fn name_token(&mut self, symbol: Symbol, expr: &'a Expr, element: &'a Element) -> Result<Option<Token<'a>>> {
        if let Some(word) = self.own_word(symbol) {
            return self.word_token(word, element).map(Some);
        }
        if self.skipping {
            return Ok(Some(Token::Expr(expr)));
        }
        let Some(frame) = self.frames.last() else { return Ok(None) };
        let next = frame.elements.get(frame.at + 1).filter(|_| !element.comma);
        match next.map(|e| &e.kind) {
            Some(ElementKind::Group(_) | ElementKind::Sign(Sign::Open(Bracket::Brace))) => {
                Ok(Some(Token::Block(BlockName { word: None, span: expr.span, body: None })))
            }
            Some(ElementKind::Entry(_) | ElementKind::Sign(Sign::Open(Bracket::Square) | Sign::Dot))
                if matches!(self.scopes.get(symbol), Some(Slot::Array(_))) =>
            {
                self.element_in_pieces(symbol, expr).map(Some)
            }
            None if !element.comma && matches!(self.scopes.get(symbol), Some(Slot::Array(_))) => {
                self.element_in_pieces(symbol, expr).map(Some)
            }
            _ => Ok(Some(Token::Expr(expr))),
        }
    }

    /// durer's own word in the block around here, if the name is one.
    fn own_word(&self, symbol: Symbol) -> Option<&'static str> {
        let block = self.opened.last()?.word?;
        let words = crate::syntax::word::contextual(block);
        if words.is_empty() {
            return None;
        }
        let name = self.names.text(symbol);
        words.iter().copied().find(|word| *word == name)
    }

    /// Does an expression begin with such a word? `eye -5*z` reads as a name minus something.
    fn begins_with_own_word(&self, e: &Expr) -> bool {
        if self.opened.last().and_then(|o| o.word).is_none_or(|block| crate::syntax::word::contextual(block).is_empty())
        {
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

    /// A word: does it open a block? Where a directive, a macro or the end of a body follows, they tell.
    fn word_token(&mut self, word: &'static str, element: &'a Element) -> Result<Token<'a>> {
        let span = element.span;
        let Some(frame) = self.frames.last_mut() else { return Ok(Token::End) };
        let alone = if word == "function" { Token::Function(None) } else { Token::Word(word) };
        let block = Token::Block(BlockName { word: Some(word), span, body: None });
        let next = frame.elements.get(frame.at + 1).map(|e| &e.kind);
        let callee = is_function(word).then_some(Token::Callee(word));
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
        if let Some(frame) = self.frames.last_mut() {
            frame.at += 1;
        }
        let before = std::mem::replace(&mut self.comma, false);
        self.settle()?;
        let known = self.held.last().map(|held| held.token).or(self.peeked);
        let (brace, paren) = match known {
            Some(token) => {
                (matches!(token, Token::Open(Bracket::Brace, _)), matches!(token, Token::Open(Bracket::Paren, _)))
            }
            None => match self.frames.last() {
                Some(frame) => (frame.opens_brace(frame.at), frame.opens_paren(frame.at)),
                None => (false, false),
            },
        };
        let token = match callee {
            _ if self.comma => alone,
            Some(callee) if paren => callee,
            _ if brace => block,
            _ => alone,
        };
        Ok(self.hold(token, span, before))
    }

    /// What may go on with the value that was just read: the very next token. `None` where a comma, a `;` or nothing
    /// comes next, and where a directive or a macro does that must wait for the value ([`Self::closed`]).
    pub(super) fn peek_after(&mut self) -> Result<Option<Token<'a>>> {
        loop {
            if !self.held.is_empty() || self.peeked.is_some() {
                return if self.comma { Ok(None) } else { self.peek().map(Some) };
            }
            if self.comma {
                return Ok(None);
            }
            let Some(frame) = self.frames.last() else { return Ok(None) };
            match frame.elements.get(frame.at).map(|e| &e.kind) {
                Some(ElementKind::Comma | ElementKind::Semicolon) => return Ok(None),
                Some(ElementKind::Directive(_)) if self.closed => return Ok(None),
                Some(ElementKind::Expr(e)) if self.closed && self.is_macro_call(e) => return Ok(None),
                None if frame.closer.is_none() && self.closed => match frame.kind {
                    FrameKind::Macro(_) | FrameKind::Piece | FrameKind::Branch | FrameKind::Include
                        if self.frames.len() > self.floor =>
                    {
                        self.pop_frame();
                    }
                    _ => return Ok(None),
                },
                None if matches!(frame.kind, FrameKind::File) => return Ok(None),
                _ => {
                    if !self.settle_once()? {
                        return self.peek().map(Some);
                    }
                }
            }
        }
    }

    fn is_macro_call(&self, e: &Expr) -> bool {
        matches!(e.kind, ExprKind::Call(name, _) | ExprKind::Name(name) if self.is_macro(name))
    }

    /// Is the expression or list that comes next a value by itself, whatever follows? Told without running anything. Where
    /// it `compares`, a `>` goes on.
    pub(super) fn is_whole(&self, compares: bool) -> bool {
        let Some((frame, outer)) = self.frames.split_last() else { return true };
        let Some(element) = frame.elements.get(frame.at).filter(|_| self.held.is_empty()) else { return false };
        if let ElementKind::Numbers(list) = &element.kind
            && frame.item.0 + 1 < list.len()
        {
            return true;
        }
        if element.comma {
            return true;
        }
        match frame.elements.get(frame.at + 1) {
            Some(next) => self.separates(next, compares),
            None => self.end_separates(frame, outer, compares),
        }
    }

    fn end_separates<'f>(&self, mut frame: &'f Frame<'a>, mut outer: &'f [Frame<'a>], compares: bool) -> bool {
        loop {
            if frame.closer.is_some() || frame.comma {
                return true;
            }
            match frame.kind {
                FrameKind::File => return true,
                FrameKind::Piece | FrameKind::Branch | FrameKind::Macro(_) | FrameKind::Include | FrameKind::Switch => {
                }
                FrameKind::While(_) | FrameKind::For { .. } => return self.closed,
            }
            let Some((last, rest)) = outer.split_last() else { return true };
            match last.elements.get(last.at) {
                Some(next) => return self.separates(next, compares),
                None => (frame, outer) = (last, rest),
            }
        }
    }

    /// Does a value before this element end there?
    fn separates(&self, next: &Element, compares: bool) -> bool {
        match &next.kind {
            ElementKind::Semicolon | ElementKind::Comma | ElementKind::Word(_) | ElementKind::Block(_) => true,
            ElementKind::Group(_) | ElementKind::Entry(_) | ElementKind::Function(_) => true,
            ElementKind::Sign(Sign::Operator(Operator::Greater)) => !compares,
            ElementKind::Sign(sign) => matches!(sign, Sign::Close(_)),
            ElementKind::Directive(_) => self.closed,
            ElementKind::Numbers(list) => list.width(0) > 1 || !list.data[0].is_sign_negative(),
            ElementKind::Expr(e) if self.is_macro_call(e) => self.closed,
            ElementKind::Expr(e) => !e.calls && !begins_with_sign(e) && !begins_with_parenthesis(e),
        }
    }

    /// Like [`Self::peek`], but stops before directives and semicolons, and at the end of what the value that is being
    /// declared stands in.
    pub(super) fn peek_on(&mut self) -> Result<Token<'a>> {
        let outer = std::mem::replace(&mut self.closed, true);
        let next = self.peek_after();
        self.closed = outer;
        Ok(next?.unwrap_or(Token::End))
    }

    /// Runs what the macros that gave a declared value still have to run, down to `floor` frames.
    pub(super) fn drain(&mut self, floor: usize) -> Result<()> {
        let in_macro = |f: &Frame| matches!(f.kind, FrameKind::Macro(_));
        if self.held.is_empty() {
            self.peeked = None;
        }
        while self.frames.iter().skip(floor).any(in_macro) {
            let Some(frame) = self.frames.last_mut() else { break };
            match frame.elements.get(frame.at) {
                None if frame.closer.is_some() => return Ok(()),
                None => self.end_of_frame()?,
                Some(element) => match &element.kind {
                    ElementKind::Semicolon | ElementKind::Comma => frame.at += 1,
                    ElementKind::Directive(directive) => {
                        frame.at += 1;
                        self.run_directive(directive, element.span)?;
                    }
                    ElementKind::Expr(_) | ElementKind::Numbers(_) => {
                        let message = "the macro gives more than the one value that is declared here";
                        return Diagnostic::err(codes::WRONG_COUNT, element.span, message);
                    }
                    // It ends a block in which the declaration stands, or begins another one.
                    _ => return Ok(()),
                },
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
        let x = if e.compares() { None } else { self.simple(e) }?;
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

    /// Tells that the next token is this one, whose text has been consumed; did a comma stand before it?
    pub(super) fn hold(&mut self, token: Token<'a>, span: Span, before: bool) -> Token<'a> {
        let comma = std::mem::replace(&mut self.comma, before);
        self.held.push(Held { token, span, comma });
        token
    }

    /// Consumes what [`Self::peek`] announced.
    pub(super) fn advance(&mut self) {
        if let Some(held) = self.held.pop() {
            self.comma = held.comma;
            return;
        }
        self.peeked = None;
        let Some(frame) = self.frames.last_mut() else { return };
        let Some(element) = frame.elements.get(frame.at) else {
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

    /// The place of what comes next.
    pub(super) fn here(&self) -> Span {
        if let Some(held) = self.held.last() {
            return held.span;
        }
        let Some(frame) = self.frames.last() else { return Span::NONE };
        match frame.elements.get(frame.at) {
            Some(Element { span, kind: ElementKind::Numbers(_), .. }) => self.item_span(*span, frame.item.0),
            Some(Element { kind: ElementKind::Block(block), .. }) => block.name.span,
            Some(Element { span, kind: ElementKind::Group(_) | ElementKind::Entry(_), .. }) => {
                Span { hi: span.lo + 1, ..*span }
            }
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
        self.frames.push(Frame { elements, at: 0, item: (0, 0), kind, span, closer: None, comma: false });
    }

    /// Elements that come next, then perhaps a closing bracket and a comma.
    pub(super) fn push_piece(&mut self, elements: &'a [Element], closer: Option<Bracket>, span: Span, comma: bool) {
        self.peeked = None;
        self.frames.push(Frame { elements, at: 0, item: (0, 0), kind: FrameKind::Piece, span, closer, comma });
    }

    /// Drops the innermost frame, and the scope that came with it.
    pub(super) fn pop_frame(&mut self) {
        self.peeked = None;
        let Some(frame) = self.frames.pop() else { return };
        self.comma |= frame.comma;
        match frame.kind {
            FrameKind::Macro(_) => {
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

    pub(super) fn mark(&self) -> Mark {
        let at = self.frames.last().map_or(0, |f| f.at);
        Mark { frames: self.frames.len(), opened: self.opened.len(), at, closed: self.closed }
    }

    /// After an error: back to the frames that were there when the statement began.
    pub(super) fn unwind(&mut self, mark: Mark) {
        while self.frames.len() > mark.frames {
            self.pop_frame();
        }
        self.opened.truncate(mark.opened);
        self.held.clear();
        (self.peeked, self.comma, self.closed, self.skipping) = (None, false, mark.closed, false);
    }

    /// After an error in a directive: what was seen behind it is looked at anew.
    pub(super) fn forget_ahead(&mut self, mark: Mark) {
        self.opened.truncate(mark.opened);
        self.held.clear();
        (self.peeked, self.comma, self.skipping) = (None, false, false);
    }

    /// After an error: past the statement that began at the mark.
    pub(super) fn skip_statement(&mut self, mark: Mark) {
        let open = self.opened.iter().skip(mark.opened);
        let open = open.filter(|o| o.alone.is_some() && o.frames == mark.frames).count();
        self.unwind(mark);
        if let Some(frame) = self.frames.last_mut() {
            frame.skip_statement(mark.at, open);
        }
    }

    /// After an error: past the brackets that were opened since the mark.
    pub(super) fn skip_brackets(&mut self, mark: Mark) {
        let open = self.opened.iter().skip(mark.opened);
        let open = open.filter(|o| o.alone.is_some() && o.frames == mark.frames).count();
        self.unwind(mark);
        if let Some(frame) = self.frames.last_mut().filter(|_| open > 0) {
            frame.skip_brackets(open);
        }
    }

    /// Consumes the opening bracket that comes next, perhaps with the word before it.
    pub(super) fn open(&mut self) -> Result<Span> {
        let token = self.peek()?;
        let span = self.here();
        if self.opened.len() >= MAX_NESTING {
            let message = format!("more than {MAX_NESTING} brackets are open here");
            return self.limit(codes::TOO_DEEP, span, message, "does a macro open one without closing it?");
        }
        let (word, name, body, bracket) = match token {
            Token::Block(BlockName { word, span: name, body }) => (word, name, body, Bracket::Brace),
            Token::Open(bracket, body) => (None, span, body, bracket),
            _ => {
                self.advance();
                return Ok(span);
            }
        };
        let comma = self.element_comma();
        // (What stands whole ends with the bracket that a message may speak of.)
        let whole = self.raw().map_or(span, |element| element.span);
        self.advance();
        let closed = std::mem::replace(&mut self.closed, false);
        let mut opened = Opened { word, span: name, alone: None, bracket, frames: self.frames.len(), closed };
        match body {
            Some(body) => {
                self.push_piece(body, Some(bracket), whole, comma);
                self.comma = false;
            }
            // The bracket is a token by itself.
            None if matches!(token, Token::Block(_)) => match self.peek()? {
                Token::Open(Bracket::Brace, body) => {
                    let (at, comma) = (self.here(), self.element_comma());
                    let whole = self.raw().map_or(at, |element| element.span);
                    self.advance();
                    opened.frames = self.frames.len();
                    match body {
                        Some(body) => self.push_piece(body, Some(Bracket::Brace), whole, comma),
                        None => opened.alone = Some(at),
                    }
                }
                _ => return Err(self.unexpected_token("`{`").into()),
            },
            None => opened.alone = Some(span),
        }
        self.opened.push(opened);
        Ok(name)
    }

    fn element_comma(&self) -> bool {
        self.held.is_empty() && self.frames.last().and_then(|f| f.elements.get(f.at)).is_some_and(|e| e.comma)
    }

    /// Consumes the bracket that closes what was opened last; anything else is a fault.
    pub(super) fn close(&mut self, expected: &str) -> Result<()> {
        let token = self.peek()?;
        let Some(opened) = self.opened.last() else { return Err(self.unexpected_token(expected).into()) };
        if !token.closes(opened.bracket) {
            return Err(match token {
                Token::Sign(Sign::Close(_)) | Token::End => self.not_closed().into(),
                _ => self.unexpected_token(expected).into(),
            });
        }
        self.closed = opened.closed;
        self.opened.pop();
        self.advance();
        Ok(())
    }

    /// Reads what stands between brackets, of which the opening one is consumed, to its end.
    pub(super) fn within<T>(
        &mut self,
        elements: &'a [Element],
        bracket: Bracket,
        span: Span,
        read: impl FnOnce(&mut Self) -> Result<T>,
    ) -> Result<T> {
        let mark = self.mark();
        self.push_piece(elements, Some(bracket), span, false);
        let closed = std::mem::replace(&mut self.closed, false);
        let frames = self.frames.len();
        self.opened.push(Opened { word: None, span, alone: None, bracket, frames, closed });
        let result = read(self).and_then(|value| self.close(bracket.text()[1]).map(|()| value));
        result.map_err(|fault| {
            let fault = self.with_trace(*fault);
            self.unwind(mark);
            Box::new(fault)
        })
    }

    /// A frame that nobody waits for has run out: loops begin again, all others go.
    fn end_of_frame(&mut self) -> Result<()> {
        let Some(frame) = self.frames.last() else { return Ok(()) };
        let span = frame.span;
        let again = match frame.kind {
            FrameKind::While(condition) => self.step(span).and_then(|()| self.condition(condition, span)),
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
        let is_inner = |f: &Frame| matches!(f.kind, FrameKind::Branch | FrameKind::Piece);
        let inner = self.frames.iter().rev().take_while(|f| is_inner(f)).count();
        let target = self.frames.len().checked_sub(inner + 1);
        match target {
            Some(depth) if is_breakable(&self.frames[depth]) => {
                while self.frames.len() > depth {
                    self.pop_frame();
                }
                Ok(())
            }
            _ => Diagnostic::new(codes::BREAK_OUTSIDE, span, "`#break` stands in no loop, no `#switch` and no macro")
                .help("it leaves the innermost `#while`, `#for`, `#switch` or `#macro`")
                .into(),
        }
    }
}

/// Does an item of a list of literals end with this element, not a number of a vector?
fn item_ends(parts: &[Element], element: &Element) -> bool {
    let before = parts.iter().take_while(|e| !std::ptr::eq(*e, element));
    let depth = before.fold(0_i32, |depth, e| match e.kind {
        ElementKind::Sign(Sign::Operator(Operator::Less)) => depth + 1,
        ElementKind::Sign(Sign::Operator(Operator::Greater)) => depth - 1,
        _ => depth,
    });
    let closes = matches!(element.kind, ElementKind::Sign(Sign::Operator(Operator::Greater)));
    depth == i32::from(closes)
}

/// Is it the name of a built-in function?
pub(super) fn is_function(word: &str) -> bool {
    matches!(crate::syntax::word::lookup(word), Some((_, crate::syntax::word::Category::Function)))
}

/// Can something of this kind be called?
fn is_callable(kind: &str) -> bool {
    matches!(kind, "function" | "spline")
}
