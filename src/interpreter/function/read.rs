//! Reads `function (…) { … }`, parsed or token by token.

use super::token_function::Compiled;
use super::{Compiler, internal_function};
use crate::diagnostic::{Diagnostic, Result, codes};
use crate::interpreter::Interpreter;
use crate::interpreter::evaluator::as_float;
use crate::interpreter::stream::Token;
use crate::interpreter::token_expr::joined_span_if_near;
use crate::source::Span;
use crate::syntax::ast::{Bracket, Expr, ExprKind, Symbol};
use crate::value::{SizedFunction, Thing};
use std::sync::Arc;

/// A function and, for a height field's function, the width and height of its picture in pixels.
type FunctionAndSize = (Option<[usize; 2]>, Arc<dyn Thing>);

impl<'a> Interpreter<'a> {
    /// Reads a user-defined function from the scene and compiles it.
    pub fn read_function(&mut self) -> Result<Arc<dyn Thing>> {
        self.read_any_function().map(|(_, function)| function)
    }

    /// Reads a function with the size of its picture, as in `function 200, 100 { … }`; consumes nothing and returns
    /// `None` if a function without a size follows.
    pub fn read_function_if_sized(&mut self) -> Result<Option<SizedFunction>> {
        if matches!(self.peek()?, Token::Function(Some(f)) if f.size.is_empty()) {
            return Ok(None);
        }
        let span = self.stream.next_span();
        match self.read_any_function()? {
            (Some(size), function) => Ok(Some((size, function))),
            (None, _) => {
                Diagnostic::err(codes::EXPECTED, span, "expected the width and the height of the function's picture")
            }
        }
    }

    fn read_any_function(&mut self) -> Result<FunctionAndSize> {
        let token = self.peek()?;
        let span = self.stream.next_span();
        self.stream.advance();
        let Token::Function(Some(f)) = token else { return self.read_function_by_tokens(span) };
        let size = f.size.iter().map(|e| self.evaluate_number(e).map(|n| (n, e.span))).collect::<Result<Vec<_>>>()?;
        let size = self.picture_size(&size, span)?;
        let function =
            self.read_contents(&f.body, Bracket::Brace, span, |me| me.read_function_body(&f.parameters, span))?;
        Ok((size, function))
    }

    /// Reads a function token by token; the word `function` has been consumed.
    fn read_function_by_tokens(&mut self, span: Span) -> Result<FunctionAndSize> {
        let (mut parameters, mut size) = (vec![], vec![]);
        self.split_to_parenthesis()?;
        if let Token::Open(Bracket::Paren, _) = self.peek()? {
            self.open_bracket()?;
            while !self.peek()?.is_closer_or_end() {
                match self.read_name()? {
                    Some((symbol, _)) => parameters.push(symbol),
                    None => return Err(self.unexpected_token("the name of a parameter").into()),
                }
            }
            self.close_bracket("`)`")?;
        } else {
            while !matches!(self.peek()?, Token::Open(..)) {
                let (value, at) = self.read_value()?;
                size.push((as_float(&value, at)?, at));
            }
        }
        let size = self.picture_size(&size, span)?;
        if !matches!(self.peek()?, Token::Open(Bracket::Brace, _)) {
            return Err(self.unexpected_token("`{`").into());
        }
        self.open_bracket()?;
        let function = self.read_function_body(&parameters, span)?;
        self.close_bracket("`}`")?;
        Ok((size, function))
    }

    /// Checks the width and height of a function's picture, and returns them in pixels; `None` without numbers.
    fn picture_size(&mut self, size: &[(f64, Span)], span: Span) -> Result<Option<[usize; 2]>> {
        let &[(width, at), (height, end)] = size else {
            return match size.len() {
                0 => Ok(None),
                n => {
                    let message = format!("a picture has a width and a height, this has {n} numbers");
                    Diagnostic::err(codes::WRONG_COUNT, span, message)
                }
            };
        };
        let size = [self.checked_picture_side(width, at)?, self.checked_picture_side(height, end)?];
        self.reporter.check_picture_memory(size, joined_span_if_near(at, end))?;
        Ok(Some(size))
    }

    /// Reads the contents of a function's braces. The tokens of macros are compiled, also where a macro's body is a value.
    fn read_function_body(&mut self, parameters: &[Symbol], span: Span) -> Result<Arc<dyn Thing>> {
        let outer = self.evaluator.set_expands_all_macros(true);
        let function = self.read_function_body_from_tokens(parameters, span);
        self.evaluator.set_expands_all_macros(outer);
        function
    }

    fn read_function_body_from_tokens(&mut self, parameters: &[Symbol], span: Span) -> Result<Arc<dyn Thing>> {
        if let Token::Block(name) = self.peek()? {
            return self.read_block_function(!parameters.is_empty(), name.word.unwrap_or(""), span);
        }
        if let Some(internal) = self.read_internal_call()? {
            return Ok(internal);
        }
        let mut compiler = Compiler::new(self, parameters);
        if self.peek()?.is_closer_or_end() {
            return Err(self.unexpected_token("an expression").into());
        }
        let result = match self.peek()? {
            Token::Expr(e) if self.next_value_is_complete(true) => {
                self.stream.advance();
                self.compile(&mut compiler, e)?
            }
            _ => self.read_by_precedence(&mut Compiled(&mut compiler), true)?.0,
        };
        compiler.graph.result = result;
        if !self.peek()?.is_closer_or_end() {
            return Err(self.unexpected_token("an operator or the end of the function").into());
        }
        compiler.into_function(self, span)
    }

    /// Reads a function that consists of `internal(61)` alone, a number of a function in functions.inc.
    fn read_internal_call(&mut self) -> Result<Option<Arc<dyn Thing>>> {
        let token = self.peek()?;
        let mut span = self.stream.next_span();
        let number = match token {
            Token::Expr(Expr { kind: ExprKind::Builtin(word, arguments), .. }) if word.name == "internal" => {
                let [number] = &**arguments else {
                    return Diagnostic::err(codes::WRONG_COUNT, span, "`internal` takes one number");
                };
                self.stream.advance();
                self.evaluate_number(number)?
            }
            Token::Callee("internal") => {
                self.stream.advance();
                self.expect_paren("internal")?;
                let (value, at) = self.read_value()?;
                span = joined_span_if_near(span, self.stream.next_span());
                self.close_bracket("`)`")?;
                as_float(&value, at)?
            }
            _ => return Ok(None),
        };
        match internal_function(number, self.builder.noise_generator()) {
            Some(function) if self.peek()?.is_closer_or_end() => Ok(Some(Arc::new(function))),
            Some(_) => Err(self.unexpected_token("the end of the function").into()),
            None => Diagnostic::err(codes::NOT_YET, span, format!("`internal({number})` is not supported yet")),
        }
    }
}
