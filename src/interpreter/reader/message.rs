//! Errors about the next token: "expected …, found …", unclosed brackets, unknown words.

use super::super::evaluator::Contents;
use super::super::stream::{BlockName, OpenBracket, Token};
use super::super::{Interpreter, reporter::hints};
use crate::camera::words::{LECTURE, POVRAY};
use crate::diagnostic::{Diagnostic, Remedy, Result, codes, did_you_mean};
use crate::light::words::LIGHT;
use crate::medium::INTERIOR;
use crate::scene::is_object;
use crate::scene::words::{MODIFIERS, SETTINGS};
use crate::shape::Shape;
use crate::source::Span;
use crate::syntax::ast::*;
use crate::syntax::fault;
use crate::syntax::word::lookup;
use crate::texture::words::{FINISH, NORMAL, PIGMENT, TEXTURE};
use crate::value::words::TRANSFORMS;
use crate::value::{Family, Next, Reader, ValueKind};

impl Interpreter<'_> {
    /// Returns the error "expected …, found …" about the next token, or a more specific one, as for an undeclared name.
    pub fn unexpected_token(&mut self, expected: &str) -> Diagnostic {
        let span = self.stream.next_span();
        let found = match self.peek() {
            Err(fault) => return *fault,
            Ok(Token::Word(word) | Token::Callee(word)) => format!("`{word}`"),
            Ok(Token::Block(name)) => format!("`{} {{`", self.inputs.sources.snippet(name.span)),
            Ok(Token::Expr(Expr { kind: ExprKind::Name(symbol), span, .. })) => {
                let contents = self.evaluator.scopes().get(*symbol);
                if matches!(contents, Some(Contents::Faulty(_)))
                    || contents.is_none() && !self.evaluator.is_constant(*symbol)
                {
                    let Err(fault) = self.evaluate_name(*symbol, *span) else {
                        return self.expected_error(*span, expected, "a name");
                    };
                    return *fault;
                }
                format!("`{}`", self.inputs.names.text(*symbol))
            }
            Ok(Token::Expr(Expr { kind: ExprKind::Call(symbol, _), span, .. }))
                if self.evaluator.scopes().get(*symbol).is_none() =>
            {
                return self.undeclared_name_error(*symbol, *span);
            }
            Ok(Token::Expr(Expr { span, .. })) if self.inputs.sources.snippet(*span).starts_with('(') => {
                let paren = Span { hi: span.lo + 1, ..*span };
                return self.unexpected_parenthesis(paren, expected);
            }
            Ok(Token::Expr(_) | Token::Numbers(_)) => "a value".to_string(),
            Ok(Token::Element(span))
                if let Some(contents @ Contents::Faulty(_)) =
                    self.stream.array_element().and_then(|lvalue| self.evaluator.scopes().contents_at(lvalue)) =>
            {
                let contents = contents.clone();
                return match self.value_of_contents(contents, span) {
                    Err(fault) => *fault,
                    Ok(_) => self.expected_error(span, expected, "an element"),
                };
            }
            Ok(Token::Element(span)) => format!("`{}`", self.inputs.sources.snippet(span)),
            Ok(Token::Function(_)) => "a function".to_string(),
            Ok(Token::Open(Bracket::Paren, _)) => return self.unexpected_parenthesis(span, expected),
            Ok(Token::Open(bracket, _)) => format!("`{}`", bracket.text()[0]),
            Ok(Token::Punctuation(Punctuation::Close(bracket))) => match self.stream.innermost_open_bracket() {
                Some(opened) if opened.bracket != bracket => return self.unclosed_error(),
                Some(OpenBracket { word: Some(block), .. }) => format!("the end of `{block} {{…}}`"),
                _ => format!("`{}`", bracket.text()[1]),
            },
            Ok(Token::Punctuation(_)) => return self.syntax_error_at(span),
            Ok(Token::End) if self.stream.innermost_open_bracket().is_some() => return self.unclosed_error(),
            Ok(Token::End) => "the end".to_string(),
        };
        self.expected_error(span, expected, &found)
    }

    fn unexpected_parenthesis(&mut self, span: Span, expected: &str) -> Diagnostic {
        self.uncallable_value_error().unwrap_or_else(|| {
            self.expected_error(span, expected, "`(`").help("vectors are written in angle brackets: `<1, 2, 3>`")
        })
    }

    /// Returns the error for a call of a value that is no function, as in `A(2)`.
    pub fn uncallable_value_error(&mut self) -> Option<Diagnostic> {
        let opens = matches!(
            self.peek(),
            Ok(Token::Open(Bracket::Paren, _) | Token::Expr(Expr { kind: ExprKind::Paren(_), .. }))
        );
        if !opens || self.stream.has_comma() {
            return None;
        }
        let (file, range) = self.inputs.sources.locate(self.stream.next_span())?;
        let text = &self.inputs.sources.text(file)[..range.start];
        let is_word = |c: char| c.is_ascii_alphanumeric() || c == '_';
        let name = &text[text.trim_end_matches(is_word).len()..];
        if !name.starts_with(|c: char| c.is_ascii_alphabetic() || c == '_') || lookup(name).is_some() {
            return None;
        }
        let lo = self.inputs.sources.base(file) + range.start - name.len();
        let message = format!("`{name}` is neither a macro nor a function");
        Some(Diagnostic::new(codes::NOT_CALLABLE, Span::new(lo, lo + name.len()), message))
    }

    /// Returns the syntax error for a token that is not allowed at its position.
    pub fn syntax_error_at(&self, span: Span) -> Diagnostic {
        let Some((file, range)) = self.inputs.sources.locate(span) else {
            return Diagnostic::new(codes::SYNTAX, span, "this is not allowed here");
        };
        fault::syntax_error_at(self.inputs.sources.text(file), range.start, self.inputs.sources.base(file))
    }

    /// Returns the error for the innermost open bracket, where an outer bracket closes or the text ends.
    pub fn unclosed_error(&mut self) -> Diagnostic {
        let token = self.peek();
        let here = self.stream.next_span();
        let Some(opened) = self.stream.innermost_open_bracket() else {
            return Diagnostic::new(codes::UNMATCHED_CLOSER, here, "this closes nothing");
        };
        let [open, close] = opened.bracket.text();
        let place = opened.alone.unwrap_or(opened.span);
        let found = self.inputs.sources.snippet(here);
        match (token, opened.bracket) {
            (Ok(Token::Punctuation(Punctuation::Close(_))), Bracket::Brace) => {
                let d = Diagnostic::new(codes::UNMATCHED_CLOSER, here, format!("`{found}` closes nothing"));
                d.also(place, "this is open, and closes with `}`").help("remove it, or look for its opener above")
            }
            (Ok(Token::Punctuation(Punctuation::Close(_))), _) => {
                let message = format!("this `{open}` is not closed: found `{found}` where `{close}` was expected");
                let d = Diagnostic::new(codes::UNCLOSED, place, message).label("opened here");
                d.also(here, format!("`{found}` found here"))
            }
            _ if self.stream.is_unclosed(place) || opened.word.is_none() => {
                self.stream.unclosed_error_at(place, open, close)
            }
            _ => {
                let block = opened.word.unwrap_or("block");
                let message = format!("this `{block} {{` has no end");
                let help = "its `}` must come in the same file, or from the macro that opens it";
                self.stream.with_call_trace(Diagnostic::new(codes::UNCLOSED_BLOCK, opened.span, message).help(help))
            }
        }
    }

    /// Returns the error for a vector without `>`, whose `<` is at `start` and of which the next token is no part.
    pub fn unclosed_vector_error(&mut self, start: Span) -> Diagnostic {
        let here = self.stream.next_span();
        let found = match self.peek() {
            Err(fault) => return *fault,
            Ok(
                Token::Punctuation(Punctuation::Close(Bracket::Paren | Bracket::Square))
                | Token::Word(_)
                | Token::Block(_),
            ) => {
                let found = self.inputs.sources.snippet(here);
                let message = format!("this `<` is not closed: found `{found}` where `>` was expected");
                let d =
                    Diagnostic::new(codes::UNCLOSED, Span { hi: start.lo + 1, ..start }, message).label("opened here");
                let d = d.help(format!("add `>` before `{found}`"));
                return d.also(here, format!("`{found}` found here"));
            }
            Ok(Token::End) => return self.stream.unclosed_error_at(Span { hi: start.lo + 1, ..start }, "<", ">"),
            Ok(_) => format!("`{}`", self.inputs.sources.snippet(here)),
        };
        Diagnostic::new(codes::SYNTAX, here, format!("{found} is not allowed here"))
            .also(Span { hi: start.lo + 1, ..start }, "the vector that begins here is not closed")
            .help("a vector ends with `>`; comparisons need parentheses around them")
    }

    fn expected_error(&self, span: Span, expected: &str, found: &str) -> Diagnostic {
        Diagnostic::new(codes::EXPECTED, span, format!("expected {expected}, found {found}"))
    }

    /// Returns an error that names the missing value if the next token is a block, `[`, `{` or a closing bracket, or
    /// the text ends. Any other token may begin a value.
    pub(super) fn expect_value(&mut self, wanted: &str) -> Result<()> {
        match self.peek()? {
            Token::Block(_) | Token::Open(Bracket::Square | Bracket::Brace, _) => {
                Err(self.unexpected_token(wanted).into())
            }
            token if token.is_closer_or_end() => Err(self.unexpected_token(wanted).into()),
            _ => Ok(()),
        }
    }

    /// Returns the error for the next word, which the block `block` does not take. `takes` are the block's words.
    pub(super) fn unknown_word_error(&mut self, block: &str, takes: &[&'static str]) -> Diagnostic {
        let span = self.stream.next_span();
        let word = match self.peek() {
            Err(fault) => return *fault,
            Ok(Token::Word(word)) if takes.contains(&word) => {
                return self.wrong_token_after_error(block, word, span, false);
            }
            Ok(Token::Block(BlockName { word: Some(word), span, .. })) if takes.contains(&word) => {
                return self.wrong_token_after_error(block, word, span, true);
            }
            Ok(Token::Word(word)) => word.to_string(),
            Ok(Token::Block(name)) => self.inputs.sources.snippet(name.span).to_string(),
            Ok(Token::Punctuation(_)) => return self.unexpected_token(block),
            Ok(Token::Expr(Expr { kind: ExprKind::Name(symbol), .. })) if self.evaluator.is_unknown(*symbol) => {
                return self.unknown_name_error(*symbol, span, block, takes);
            }
            Ok(Token::Expr(Expr { kind: ExprKind::Name(symbol), .. }))
                if matches!(self.evaluator.scopes().get(*symbol), Some(Contents::Faulty(_))) =>
            {
                return self.unexpected_token(block);
            }
            Ok(_) => {
                let is_object = Reader::peek_next(self) == Ok(Next::Thing("object"));
                let d = self.unexpected_token(&format!("a word of `{block}`"));
                if is_object && matches!(block, "union" | "merge" | "intersection" | "difference") {
                    let help = format!(
                        "the words of the `{block}` follow all its objects; to move one of these, write `object {{ … }}`"
                    );
                    return d.help(help);
                }
                return if d.code == codes::EXPECTED {
                    d.help(format!("it takes {}", first_words_in_backticks(takes)))
                } else {
                    d
                };
            }
        };
        let d = refused_word_error(&word, span, block, takes);
        let near = did_you_mean(&word, takes.iter().copied());
        if let Some(spec) = Shape::spec_of(block).filter(|spec| spec.params.iter().any(|p| p.name == word)) {
            let help = format!("it is written `{}`, and takes {}", spec.block_usage(), first_words_in_backticks(takes));
            return d.help(help);
        }
        let home = block_taking(&word)
            .filter(|home| *home != block)
            .map(|home| format!("it belongs in `{home} {{ {word} … }}`"));
        d.maybe_help(near).maybe_help(home).maybe_help(hints::wrong_block_word_hint(block, &word).map(String::from))
    }

    /// Returns the error for an undeclared name where a word of the block could be.
    fn unknown_name_error(&mut self, symbol: Symbol, span: Span, block: &str, takes: &[&'static str]) -> Diagnostic {
        let name = self.inputs.names.text(symbol);
        let near = did_you_mean(name, takes.iter().copied());
        // A capitalized name is the author's own, or that of an include file.
        if name.starts_with(char::is_uppercase)
            || hints::other_tool_hint(name).is_none() && self.reporter.is_declared_in_library(name)
        {
            let d = self.undeclared_name_error(symbol, span);
            return if d.missing_names.as_ref().is_some_and(|names| names.remedy == Remedy::Declare) {
                d.maybe_help(near)
            } else {
                d
            };
        }
        let declared = self.evaluator.scopes().names().map(|s| self.inputs.names.text(s));
        let near = did_you_mean(name, takes.iter().copied().chain(declared));
        let hint = hints::wrong_block_word_hint(block, name).or_else(|| hints::other_tool_hint(name)).map(String::from);
        refused_word_error(name, span, block, takes).maybe_help(near).maybe_help(hint)
    }

    /// Returns the error for a word that the block takes, but that is followed by an unsuitable token. `brace_follows`
    /// is true if a `{` follows the word.
    fn wrong_token_after_error(
        &mut self,
        block: &str,
        word: &'static str,
        span: Span,
        brace_follows: bool,
    ) -> Diagnostic {
        let rest =
            self.inputs.sources.locate(span).map_or("", |(file, range)| &self.inputs.sources.text(file)[range.end..]);
        let found = match fault::token_at(rest.trim_start(), 0) {
            "" => "the end of the text".to_string(),
            token => format!("`{token}`"),
        };
        let (wanted, usage) = match (brace_follows, opens_block(word)) {
            (true, false) => value_description_and_example(word),
            (false, true) => ("`{`".to_string(), block_usage(word)),
            // The word has what it needs, but is not allowed at this position.
            _ => {
                let d =
                    Diagnostic::new(codes::UNKNOWN_WORD, span, format!("`{word}` is not allowed here in a `{block}`"));
                return d.help("it belongs to another kind of this block, or to another place in it");
            }
        };
        let d = Diagnostic::new(codes::UNKNOWN_WORD, span, format!("expected {wanted} after `{word}`, found {found}"));
        d.help(format!("it is written `{usage}`"))
    }
}

/// Returns the type of the value after a word, if one of the tables defines it.
fn value_kind_of(word: &str) -> Option<ValueKind> {
    let tables = [&FINISH, &PIGMENT, &NORMAL, &TEXTURE, &INTERIOR, &LIGHT, &SETTINGS, &MODIFIERS, &POVRAY, &LECTURE];
    let words = tables.into_iter().flat_map(|table| table.words).chain(TRANSFORMS);
    words.into_iter().find(|known| known.name == word).map(|known| known.kind)
}

/// True if the word opens a block in the scene language, so that a `{` has to follow it.
fn opens_block(word: &str) -> bool {
    is_object(word)
        || matches!(word, "camera" | "background" | "global_settings")
        || value_kind_of(word) == Some(ValueKind::Block) && word != "matrix"
}

/// Returns the error for a word that the block does not take.
fn refused_word_error(word: &str, span: Span, block: &str, takes: &[&'static str]) -> Diagnostic {
    let message = match block {
        "scene" => format!("`{word}` is not allowed outside of all braces"),
        _ => format!("`{word}` is not something a `{block}` takes"),
    };
    Diagnostic::new(codes::UNKNOWN_WORD, span, message).help(format!("it takes {}", first_words_in_backticks(takes)))
}

/// Returns description and example of the value after a word that opens no block.
fn value_description_and_example(word: &str) -> (String, String) {
    let (what, value) = match value_kind_of(word) {
        _ if word == "matrix" => ("twelve numbers", "<…>"),
        Some(ValueKind::Float) => ("a number", "0.5"),
        Some(ValueKind::Vector2) => ("a vector", "<x, y>"),
        Some(ValueKind::Vector) => ("a vector", "<x, y, z>"),
        Some(ValueKind::Text) => ("a text", "\"…\""),
        Some(ValueKind::Flag | ValueKind::Nothing) => ("no `{`", ""),
        _ if super::begins_color(word) => ("a colour", "rgb <r, g, b>"),
        _ => ("a value", "…"),
    };
    let value = if word.starts_with("rgb") || word.starts_with("srgb") { "<r, g, b>" } else { value };
    (what.into(), format!("{word} {value}").trim_end().to_string())
}

/// Returns the syntax of the block `word` for a message.
fn block_usage(word: &str) -> String {
    match Shape::spec_of(word) {
        Some(spec) => spec.block_usage(),
        None if word == "pigment" => "pigment { rgb <r, g, b> }".into(),
        None => format!("{word} {{ … }}"),
    }
}

/// Returns the name of the block that takes a word; of several, the most likely one.
fn block_taking(word: &str) -> Option<&'static str> {
    let homes = [&INTERIOR, &FINISH, &PIGMENT, &POVRAY, &SETTINGS, &LIGHT];
    homes.into_iter().find(|table| table.has_effect(word)).map(|table| table.name)
}

/// Lists the first twelve words in backticks.
fn first_words_in_backticks(words: &[&str]) -> String {
    let quoted: Vec<String> = words.iter().take(12).map(|w| format!("`{w}`")).collect();
    if words.len() > 12 { format!("{} …", quoted.join(" ")) } else { quoted.join(" ") }
}
