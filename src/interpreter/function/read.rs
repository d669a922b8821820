//! `function (…) { … }`, as a whole or in pieces.

use super::pieces::Compiled;
use super::{Compiler, internal_function};
use crate::diagnostic::{Diagnostic, Result, codes};
use crate::interpreter::Interpreter;
use crate::interpreter::eval::as_float;
use crate::interpreter::pieces::joined;
use crate::interpreter::stream::Token;
use crate::source::Span;
use crate::syntax::ast::{Bracket, Expr, ExprKind, Symbol};
use crate::value::{SizedFunction, Thing};
use std::sync::Arc;

impl<'a> Interpreter<'a> {
    /// The function that comes next in the stream.
    pub(in crate::interpreter) fn read_function(&mut self) -> Result<Arc<dyn Thing>> {
        let token = self.peek()?;
        let span = self.here();
        self.advance();
        match token {
            Token::Function(Some(f)) => {
                let size = f.size.iter().map(|e| self.number(e).map(|n| (n, e.span))).collect::<Result<Vec<_>>>()?;
                let parameters = &f.parameters;
                self.function_of_size(size, span)?;
                self.within(&f.body, Bracket::Brace, span, |me| me.function_body(parameters, span))
            }
            _ => self.function_in_pieces(span),
        }
    }

    /// The same behind the word `function`.
    fn function_in_pieces(&mut self, span: Span) -> Result<Arc<dyn Thing>> {
        let (mut parameters, mut size) = (vec![], vec![]);
        self.expose_parenthesis()?;
        if let Token::Open(Bracket::Paren, _) = self.peek()? {
            self.open()?;
            while !self.peek()?.ends() {
                match self.raw_parameter() {
                    Some(symbol) => parameters.push(symbol),
                    None => return Err(self.unexpected_token("the name of a parameter").into()),
                }
            }
            self.close("`)`")?;
        } else {
            while !matches!(self.peek()?, Token::Open(..)) {
                let (value, at) = self.value_here()?;
                size.push((as_float(&value, at)?, at));
            }
        }
        self.function_of_size(size, span)?;
        if !matches!(self.peek()?, Token::Open(Bracket::Brace, _)) {
            return Err(self.unexpected_token("`{`").into());
        }
        self.open()?;
        let function = self.function_body(&parameters, span)?;
        let end = self.here();
        self.close("`}`")?;
        let _ = joined(span, end);
        Ok(function)
    }

    fn raw_parameter(&mut self) -> Option<Symbol> {
        let Ok(Token::Expr(Expr { kind: ExprKind::Name(symbol), .. })) = self.peek() else { return None };
        self.advance();
        Some(*symbol)
    }

    /// `function 200, 100 { … }` makes a picture: how many points it has across and down.
    fn function_of_size(&mut self, size: Vec<(f64, Span)>, span: Span) -> Result<()> {
        self.picture_size = None;
        let [(width, at), (height, end)] = size[..] else {
            return match size.len() {
                0 => Ok(()),
                n => Diagnostic::err(
                    codes::WRONG_COUNT,
                    span,
                    format!("a picture has a width and a height, this has {n} numbers"),
                ),
            };
        };
        let size = [self.picture_side(width, at)?, self.picture_side(height, end)?];
        self.check_picture(size, joined(at, end))?;
        self.picture_size = Some(size);
        Ok(())
    }

    /// The function that comes next, if it says how large the picture is that it makes.
    pub(in crate::interpreter) fn picture_function(&mut self) -> Result<Option<SizedFunction>> {
        if matches!(self.peek()?, Token::Function(Some(f)) if f.size.is_empty()) {
            return Ok(None);
        }
        let span = self.here();
        let function = self.read_function()?;
        match self.picture_size.take() {
            Some(size) => Ok(Some((size, function))),
            None => {
                Diagnostic::err(codes::EXPECTED, span, "expected the width and the height of the function's picture")
            }
        }
    }

    /// What stands between the braces.
    fn function_body(&mut self, parameters: &[Symbol], span: Span) -> Result<Arc<dyn Thing>> {
        let size = self.picture_size.take();
        let function = self.function_of_body(parameters, span);
        self.picture_size = size;
        function
    }

    fn function_of_body(&mut self, parameters: &[Symbol], span: Span) -> Result<Arc<dyn Thing>> {
        if let Token::Block(name) = self.peek()? {
            return self.sampled_function(!parameters.is_empty(), name.word.unwrap_or(""), span);
        }
        if let Some(internal) = self.internal_call()? {
            return Ok(internal);
        }
        let mut compiler = Compiler::new(self, parameters);
        if self.peek()?.ends() {
            return Err(self.unexpected_token("an expression").into());
        }
        let result = match self.peek()? {
            Token::Expr(e) if self.is_whole(true) => {
                self.advance();
                self.compile(&mut compiler, e)?
            }
            _ => self.climb(&mut Compiled(&mut compiler), true)?.0,
        };
        compiler.graph.result = result;
        if !self.peek()?.ends() {
            return Err(self.unexpected_token("an operator or the end of the function").into());
        }
        compiler.finish(self, span)
    }

    /// `internal(61)` alone: one of the functions behind functions.inc.
    fn internal_call(&mut self) -> Result<Option<Arc<dyn Thing>>> {
        let token = self.peek()?;
        let mut span = self.here();
        let number = match token {
            Token::Expr(Expr { kind: ExprKind::Builtin(word, arguments), .. }) if word.name == "internal" => {
                let [number] = &**arguments else {
                    return Diagnostic::err(codes::WRONG_COUNT, span, "`internal` takes one number");
                };
                self.advance();
                self.number(number)?
            }
            Token::Callee("internal") => {
                self.advance();
                self.expect_paren("internal")?;
                let (value, at) = self.value_here()?;
                span = joined(span, self.here());
                self.close("`)`")?;
                as_float(&value, at)?
            }
            _ => return Ok(None),
        };
        match internal_function(number, &self.noise_generator) {
            Some(function) if self.peek()?.ends() => Ok(Some(Arc::new(function))),
            Some(_) => Err(self.unexpected_token("the end of the function").into()),
            None => Diagnostic::err(codes::NOT_YET, span, format!("`internal({number})` is not supported yet")),
        }
    }
}
