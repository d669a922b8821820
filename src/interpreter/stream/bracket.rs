//! Open brackets around the read position.

use super::{Mode, TokenStream};
use crate::diagnostic::{Diagnostic, codes};
use crate::source::Span;
use crate::syntax::ast::*;
use crate::syntax::{Outline, blame};

/// An opening bracket of the scene's text whose closing bracket was not read yet.
pub struct OpenBracket {
    /// The word before the open bracket; `None` for a bracket without a word, and for a word that is not a keyword.
    pub word: Option<&'static str>,
    /// Span of the word before the bracket, or of a bracket without a word.
    pub span: Span,
    /// Span of the bracket without the word; `None` if the parser found the matching bracket.
    pub alone: Option<Span>,
    pub bracket: Bracket,
    /// Keywords that only durer has, not POV-Ray, and that the bracket's block takes.
    pub own_words: &'static [&'static str],
    /// Number of frames on the stack at the time when the bracket was opened.
    pub frame_count: usize,
    /// Reading mode that is restored after the closing bracket.
    pub mode: Mode,
}

/// Number of brackets that were open where an error was found.
#[derive(Clone, Copy)]
pub(super) struct Unclosed {
    pub(super) count: usize,
    /// True if the number counts only braces, and ignores other brackets.
    pub(super) braces: bool,
}

/// Open brackets of the token stream.
impl<'a> TokenStream<'a> {
    /// Returns the innermost open bracket of the token stream.
    pub fn innermost_open_bracket(&self) -> Option<&OpenBracket> {
        self.open_brackets.last()
    }

    pub fn bracket_count(&self) -> usize {
        self.open_brackets.len()
    }

    /// Enters the reading mode inside of brackets, where no directive or macro call is deferred, and returns the mode
    /// outside.
    pub fn stop_deferring_directives(&mut self) -> Mode {
        let outer = self.mode;
        self.mode.defers_directives = false;
        outer
    }

    pub fn push_bracket(&mut self, bracket: OpenBracket) {
        self.open_brackets.push(bracket);
    }

    /// Closes the innermost bracket, and restores the mode outside of it.
    pub fn pop_bracket(&mut self) {
        if let Some(bracket) = self.open_brackets.pop() {
            self.mode = bracket.mode;
        }
    }

    /// Gives the innermost bracket the name of a directive, for messages.
    pub fn name_bracket(&mut self, word: &'static str, span: Span) {
        if let Some(bracket) = self.open_brackets.last_mut() {
            (bracket.word, bracket.span) = (Some(word), span);
        }
    }

    /// Returns the keyword with the spelling of a name, if only durer has the keyword and the innermost open block
    /// takes it; `None` for any other name.
    pub fn durer_only_word_of_open_block(&self, symbol: Symbol) -> Option<&'static str> {
        let words = self.open_brackets.last()?.own_words;
        if words.is_empty() {
            return None;
        }
        let name = self.inputs.names.text(symbol);
        words.iter().copied().find(|word| *word == name)
    }

    /// True if an expression begins with a keyword that only durer has: `eye -5*z` parses as a difference.
    pub fn begins_with_durer_word(&self, e: &Expr) -> bool {
        if self.open_brackets.last().is_none_or(|o| o.own_words.is_empty()) {
            return false;
        }
        let mut first = e;
        loop {
            first = match &first.kind {
                ExprKind::Chain(chain) => &chain.first,
                ExprKind::Choice(parts) => &parts[0],
                ExprKind::Call(symbol, _) => return self.durer_only_word_of_open_block(*symbol).is_some(),
                ExprKind::Name(symbol) => return self.durer_only_word_of_open_block(*symbol).is_some(),
                _ => return false,
            };
        }
    }

    /// Records the brackets of a file that have no closing bracket in the file.
    pub fn add_unclosed_brackets(&mut self, ast: &Ast) {
        self.unclosed.extend(ast.unclosed.iter().map(|span| span.lo));
    }

    /// Returns the error for the innermost open bracket that has no closing bracket in its file; `None` if all have
    /// one. Other errors inside the bracket follow from this one.
    pub fn unclosed_bracket_error(&self) -> Option<Diagnostic> {
        let unclosed = |o: &&OpenBracket| o.alone.is_some_and(|span| self.is_unclosed(span));
        let opened = self.open_brackets.iter().rev().find(unclosed)?;
        let [open, close] = opened.bracket.text();
        Some(self.unclosed_error_at(opened.alone?, open, close))
    }

    /// True if the bracket at `span` has no closing bracket in its file.
    pub fn is_unclosed(&self, span: Span) -> bool {
        self.unclosed.contains(&span.lo)
    }

    /// Returns the error "this `{` is not closed" for the bracket at `span`, or the brace that probably lacks its end.
    pub fn unclosed_error_at(&self, span: Span, open: &str, close: &str) -> Diagnostic {
        if let Some(d) = self.blamed_brace_error(span).filter(|_| open == "{") {
            return self.with_call_trace(d);
        }
        let message = format!("this `{open}` is not closed");
        let d = Diagnostic::new(codes::UNCLOSED, span, message);
        let d = d.help(format!("add `{close}` where it should end"));
        self.with_call_trace(d)
    }

    /// Returns the error for the brace whose `}` is missing, judged by the words of its block and the indentation;
    /// `None` without evidence. `span` is that of a brace that is open at the end of its file.
    fn blamed_brace_error(&self, span: Span) -> Option<Diagnostic> {
        let (file, _) = self.inputs.sources.locate(span)?;
        blame::unclosed_brace_error(&Outline::read(self.inputs.sources, file))
    }
}
