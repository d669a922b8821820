//! The directive `#macro Name(A, B) … #end`, and calls of macros.

use crate::diagnostic::{Diagnostic, Result, codes};
use crate::interpreter::Interpreter;
use crate::interpreter::argument::ArgumentForm;
use crate::interpreter::evaluator::{Contents, LValue};
use crate::interpreter::reporter::MAX_CALLS;
use crate::interpreter::stream::Token;
use crate::interpreter::token_expr::joined_span_if_near;
use crate::source::Span;
use crate::syntax::ast::*;
use crate::value::Value;

impl<'a> Interpreter<'a> {
    pub fn define_macro(&mut self, definition: &'a Macro) -> Result<()> {
        if let Some(at) = definition.fault {
            let found = self.inputs.sources.snippet(at);
            let found = if found.is_empty() { "nothing".into() } else { format!("`{found}`") };
            let d = Diagnostic::new(codes::SYNTAX, at, format!("expected a name after `#macro`, found {found}"));
            return d.help("`#macro Name(A, B) … #end`").into();
        }
        self.evaluator.scopes_mut().rebind_innermost_or_add_global(
            definition.name,
            Contents::Macro(definition),
            vec![],
        );
        Ok(())
    }

    /// Calls a macro: evaluates the arguments and opens a scope. The body is read next, then a comma if `has_comma_after` is set.
    pub fn call_macro(
        &mut self,
        name: Symbol,
        arguments: &'a [Element],
        span: Span,
        has_comma_after: bool,
    ) -> Result<()> {
        let Some(&Contents::Macro(definition)) = self.evaluator.scopes().get(name) else { return Ok(()) };
        self.check_call_depth(name, span)?;
        let argument_contents = match self.evaluate_plain_arguments(definition, arguments)? {
            Some(argument_contents) => argument_contents,
            None => self.read_contents(arguments, Bracket::Paren, span, |me| me.read_arguments(definition, span))?,
        };
        self.enter_macro(definition, argument_contents, span, has_comma_after);
        Ok(())
    }

    /// Calls a macro whose body is a value ([`Macro::value`]) and whose arguments are plain, and returns the value of the
    /// call; `None` for other macros and arguments.
    pub fn call_value_macro(
        &mut self,
        definition: &'a Macro,
        arguments: &'a [Element],
        span: Span,
    ) -> Result<Option<Value>> {
        let Some(body) = definition.value() else { return Ok(None) };
        self.check_call_depth(definition.name, span)?;
        let Some(argument_contents) = self.evaluate_plain_arguments(definition, arguments)? else { return Ok(None) };
        self.evaluator.enter_call(&definition.parameters, argument_contents);
        self.stream.enter_value_macro(definition.name, span);
        let value = self.evaluate(body).map_err(|fault| Box::new(self.stream.with_call_trace(*fault)));
        self.stream.leave_value_macro();
        self.evaluator.scopes_mut().leave_scope();
        value.map(Some)
    }

    /// Calls a macro whose name has been consumed; the next token is the `(`.
    pub fn call_macro_by_tokens(&mut self, name: Symbol, span: Span) -> Result<()> {
        let Some(&Contents::Macro(definition)) = self.evaluator.scopes().get(name) else { return Ok(()) };
        self.check_call_depth(name, span)?;
        self.split_to_parenthesis()?;
        if !matches!(self.peek()?, Token::Open(Bracket::Paren, _)) {
            let name = self.inputs.names.text(name);
            let d = Diagnostic::new(codes::EXPECTED_VALUE, span, format!("`{name}` is a macro"));
            return d.help(format!("a call needs parentheses: `{name}()`")).into();
        }
        let checkpoint = self.stream.checkpoint();
        let read = self.open_bracket().and_then(|_| self.read_arguments(definition, span));
        let read = read.and_then(|argument_contents| {
            let end = self.stream.next_span();
            self.close_bracket("`)`").map(|()| (argument_contents, end))
        });
        let (argument_contents, end) = match read {
            Ok(read) => read,
            Err(fault) => {
                if self.stream.unclosed_bracket_error().is_none() {
                    self.skip_brackets(checkpoint);
                }
                return Err(fault);
            }
        };
        let comma = self.stream.take_comma();
        self.enter_macro(definition, argument_contents, joined_span_if_near(span, end), comma);
        Ok(())
    }

    fn check_call_depth(&mut self, name: Symbol, span: Span) -> Result<()> {
        self.reporter.count_step(span)?;
        if self.stream.call_depth() < MAX_CALLS {
            return Ok(());
        }
        let message = format!("`{}` is called {MAX_CALLS} times inside itself", self.inputs.names.text(name));
        self.reporter.limit_error(codes::CALL_DEPTH, span, message, "does this recursion ever end?")
    }

    fn enter_macro(
        &mut self,
        definition: &'a Macro,
        arguments: Vec<Option<Contents<'a>>>,
        span: Span,
        has_comma_after: bool,
    ) {
        self.evaluator.enter_call(&definition.parameters, arguments);
        self.stream.push_call(definition, span, has_comma_after);
    }

    /// Evaluates the arguments of a macro in the common case: one expression for each parameter, without calls of
    /// macros. `None` for other arguments.
    fn evaluate_plain_arguments(
        &mut self,
        definition: &'a Macro,
        arguments: &'a [Element],
    ) -> Result<Option<Vec<Option<Contents<'a>>>>> {
        if arguments.len() != definition.parameters.len()
            || !arguments.iter().all(|e| self.evaluator.is_plain_argument(e))
        {
            return Ok(None);
        }
        // The list is reused: calls are many, and evaluation itself does not allocate.
        let mut argument_contents = self.evaluator.take_empty_argument_list();
        argument_contents.clear();
        for (i, element) in arguments.iter().enumerate() {
            let ElementKind::Expr(e) = &element.kind else { return Ok(None) };
            let next = arguments.get(i + 1).filter(|_| !element.comma).and_then(|next| match &next.kind {
                ElementKind::Expr(next) => first_name(next),
                _ => None,
            });
            argument_contents.push(Some(match e.kind {
                ExprKind::Name(symbol) => match self.reference_target(symbol, next) {
                    Some(lvalue) => Contents::Alias(lvalue),
                    None => return Ok(None),
                },
                _ => Contents::Value(self.evaluate(e)?),
            }));
        }
        Ok(Some(argument_contents))
    }

    /// Returns the location to which a parameter refers if its argument is the name `symbol`. `name_after_argument` is
    /// the name that follows the argument in the call, without a comma (quirk: `reference_without_comma`).
    fn reference_target(&self, symbol: Symbol, name_after_argument: Option<Symbol>) -> Option<LValue> {
        let scopes = self.evaluator.scopes();
        let is_number = |contents: &Contents| {
            matches!(contents, Contents::Value(Value::Float(_) | Value::Vector(_) | Value::Color(_)))
        };
        match name_after_argument.and_then(|next| scopes.resolve(next)) {
            Some(next) if scopes.get(symbol).is_some_and(is_number) => Some(next),
            _ => scopes.resolve(symbol),
        }
    }

    fn read_arguments(&mut self, definition: &'a Macro, span: Span) -> Result<Vec<Option<Contents<'a>>>> {
        let name = self.inputs.names.text(definition.name);
        let (level, wanted) = (self.evaluator.scopes().level(), definition.parameters.len());
        let mut argument_contents = Vec::with_capacity(wanted);
        for &(parameter, optional) in &definition.parameters {
            if self.peek()?.is_closer_or_end() {
                if optional {
                    argument_contents.push(None);
                    continue;
                }
                let parameter = self.inputs.names.text(parameter);
                return Diagnostic::new(
                    codes::WRONG_COUNT,
                    span,
                    format!(
                        "macro `{name}` takes {}, but only {} given",
                        arguments_text(wanted),
                        count_with_verb(argument_contents.len())
                    ),
                )
                .also(definition.span, "defined here")
                .help(format!("the argument for `{parameter}` is missing"))
                .into();
            }
            argument_contents.push(Some(self.read_macro_argument(level)?));
        }
        let next = self.peek()?;
        if let Some(d) = self.uncallable_value_error() {
            return d.into();
        }
        if matches!(next, Token::Punctuation(_)) && !next.is_closer_or_end() {
            return Err(self.unexpected_token("`)`").into());
        }
        if !next.is_closer_or_end() {
            let message = format!("macro `{name}` takes {}, but more are given", arguments_text(wanted));
            return Diagnostic::new(codes::WRONG_COUNT, self.stream.next_span(), message)
                .also(definition.span, "defined here")
                .into();
        }
        Ok(argument_contents)
    }

    /// Reads an argument of a macro. A name alone is passed by reference, unless it is local to a macro that ends with
    /// the argument; any other value is copied.
    fn read_macro_argument(&mut self, call_level: u32) -> Result<Contents<'a>> {
        if !matches!(self.peek()?, Token::Expr(Expr { kind: ExprKind::Name(_), .. }) | Token::Element(_)) {
            return self.read_rvalue();
        }
        let lvalue = match self.peek()? {
            Token::Expr(Expr { kind: ExprKind::Name(symbol), .. }) => self.evaluator.scopes().resolve(*symbol),
            _ => None,
        };
        let lasting = lvalue.filter(|lvalue| self.evaluator.scopes().level_of(lvalue) <= call_level);
        let argument = self.in_mode(|mode| mode.defers_directives = true, Self::read_argument)?;
        match argument.given {
            ArgumentForm::Name(symbol) if let Some(own) = lasting => {
                let next = match self.peek()? {
                    Token::Expr(next) if !self.stream.has_comma() => first_name(next),
                    _ => None,
                };
                let referenced = self.reference_target(symbol, next);
                let referenced = referenced.filter(|lvalue| self.evaluator.scopes().level_of(lvalue) <= call_level);
                Ok(Contents::Alias(referenced.unwrap_or(own)))
            }
            ArgumentForm::LValue(lvalue) => {
                self.evaluator.contents_at(&lvalue, argument.span).map(|_| Contents::Alias(lvalue))
            }
            ArgumentForm::Contents(contents) => Ok(contents),
            ArgumentForm::Name(_) => self.argument_contents(&argument),
        }
    }
}

/// Returns the name with which an expression begins.
fn first_name(e: &Expr) -> Option<Symbol> {
    match &e.kind {
        ExprKind::Name(symbol) => Some(*symbol),
        ExprKind::Dot(base, ..) => first_name(base),
        ExprKind::Chain(chain) => first_name(&chain.first),
        _ => None,
    }
}

fn arguments_text(n: usize) -> String {
    if n == 1 { "one argument".into() } else { format!("{n} arguments") }
}

fn count_with_verb(n: usize) -> String {
    if n == 1 { "one is".into() } else { format!("{n} are") }
}
