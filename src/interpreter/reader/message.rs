//! "expected …, found …", and which words a block takes.

use super::super::scope::Slot;
use super::super::stream::Token;
use super::super::{Interpreter, hints};
use crate::diagnostic::{Diagnostic, Result, codes, did_you_mean};
use crate::source::Span;
use crate::syntax::ast::*;

impl Interpreter<'_> {
    /// "expected …, found …" about what comes next.
    pub(in crate::interpreter) fn unexpected_token(&mut self, expected: &str) -> Diagnostic {
        let span = self.here();
        let found = match self.peek() {
            Err(fault) => return *fault,
            Ok(Token::Word(word)) => format!("`{word}`"),
            Ok(Token::Block(Block { name, .. }) | Token::Open(name)) => {
                format!("`{} {{`", self.sources.snippet(name.span))
            }
            Ok(Token::Expr(Expr { kind: ExprKind::Name(symbol), span })) => {
                let slot = self.scopes.get(*symbol);
                if matches!(slot, Some(Slot::Faulty(_))) || slot.is_none() && !self.is_constant(*symbol) {
                    let Err(fault) = self.name_value(*symbol, *span) else {
                        return self.expected(*span, expected, "a name");
                    };
                    return *fault;
                }
                format!("`{}`", self.names.text(*symbol))
            }
            Ok(Token::Expr(_) | Token::Numbers(_)) => "a value".to_string(),
            Ok(Token::Entry(_)) => "`[`".to_string(),
            Ok(Token::Values(_)) => {
                let d = self.expected(span, expected, "a list in parentheses");
                return d.help("vectors stand in angle brackets: `<1, 2, 3>`");
            }
            Ok(Token::Key(_) | Token::Colon) => format!("`{}`", self.sources.snippet(span)),
            Ok(Token::Group(_)) => "`{`".to_string(),
            Ok(Token::Element(e))
                if let Some(slot @ Slot::Faulty(_)) = self.element.as_ref().and_then(|place| self.scopes.at(place)) =>
            {
                let slot = slot.clone();
                return match self.slot_value(slot, e.span) {
                    Err(fault) => *fault,
                    Ok(_) => self.expected(e.span, expected, "an element"),
                };
            }
            Ok(Token::Element(e)) => format!("`{}`", self.sources.snippet(e.span)),
            Ok(Token::Function(_)) => "a function".to_string(),
            Ok(Token::End) => match self.blocks.last() {
                Some((block, _)) => format!("the end of `{block} {{…}}`"),
                None => "the end".to_string(),
            },
        };
        self.expected(span, expected, &found)
    }

    fn expected(&self, span: Span, expected: &str, found: &str) -> Diagnostic {
        Diagnostic::new(codes::EXPECTED, span, format!("expected {expected}, found {found}"))
    }

    /// Must a value come next? Says which one is missing.
    pub(super) fn at_value(&mut self, wanted: &str) -> Result<()> {
        match self.peek()? {
            Token::End | Token::Block(_) | Token::Entry(_) | Token::Group(_) => {
                Err(self.unexpected_token(wanted).into())
            }
            _ => Ok(()),
        }
    }

    /// The word that comes next is none of those that `block` takes.
    pub(super) fn tell_unknown_word(&mut self, block: &str, takes: &[&'static str]) -> Diagnostic {
        let span = self.here();
        let word = match self.peek() {
            Err(fault) => return *fault,
            Ok(Token::Word(word)) => word.to_string(),
            Ok(Token::Block(Block { name, .. }) | Token::Open(name)) => self.sources.snippet(name.span).to_string(),
            Ok(Token::Expr(Expr { kind: ExprKind::Name(symbol), .. }))
                if self.scopes.get(*symbol).is_none() && !self.is_constant(*symbol) =>
            {
                let name = self.names.text(*symbol).to_string();
                let d =
                    Diagnostic::new(codes::UNKNOWN_WORD, span, format!("`{name}` is not something a `{block}` takes"));
                let declared = self.scopes.names().map(|s| self.names.text(s));
                let near = did_you_mean(&name, takes.iter().copied().chain(declared));
                let hint = hints::other_tools(&name).map(String::from);
                return d.help(format!("it takes {}", list(takes))).maybe_help(near).maybe_help(hint);
            }
            Ok(Token::Expr(Expr { kind: ExprKind::Name(symbol), .. }))
                if matches!(self.scopes.get(*symbol), Some(Slot::Faulty(_))) =>
            {
                return self.unexpected_token(block);
            }
            Ok(_) => {
                return self
                    .unexpected_token(&format!("a word of `{block}`"))
                    .help(format!("it takes {}", list(takes)));
            }
        };
        let near = did_you_mean(&word, takes.iter().copied());
        Diagnostic::new(codes::UNKNOWN_WORD, span, format!("`{word}` is not something a `{block}` takes"))
            .help(format!("it takes {}", list(takes)))
            .maybe_help(near)
    }
}

/// Words in backticks, the first twelve of many.
fn list(words: &[&str]) -> String {
    let quoted: Vec<String> = words.iter().take(12).map(|w| format!("`{w}`")).collect();
    if words.len() > 12 { format!("{} …", quoted.join(" ")) } else { quoted.join(" ") }
}
