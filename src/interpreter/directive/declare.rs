//! The directives `#declare A = …`, `#local A = …`, `#undef A` and `#default { … }`.

use crate::diagnostic::{Diagnostic, Result, codes};
use crate::interpreter::Interpreter;
use crate::interpreter::argument::ArgumentForm;
use crate::interpreter::evaluator::{Contents, LValue};
use crate::interpreter::stream::{StackFrame, Token};
use crate::source::Span;
use crate::syntax::ast::*;
use crate::syntax::word;
use crate::value::Value;
use std::rc::Rc;

/// Target of a `#declare` or `#local` directive.
struct Declared {
    symbol: Symbol,
    /// Scope level that the prefix `local.` or `global.` (3.8) selects; `None` without a prefix.
    level: Option<u32>,
    /// Location of the array element that is declared; `None` if the name itself is.
    lvalue: Option<LValue>,
}

/// Message of `deprecated once "why"` in a declaration; the flag is true for `once`.
type Deprecated<'a> = Option<(bool, &'a str)>;

impl<'a> Interpreter<'a> {
    /// Runs `#declare` and `#local`. A value with errors is declared all the same, and the errors are reported where it
    /// is used, because standard include files declare hundreds of values of which a scene uses a few.
    pub fn run_declare(&mut self, declare: &'a Declare) -> Result<()> {
        let target = &declare.target;
        if let Some(word) = target.keyword {
            return self.skip_value_and_refuse_name(word, target.span);
        }
        self.refuse_semicolon_as_value(target.symbol)?;
        let deprecated = declare.deprecated.as_ref().map(|(once, why)| (*once, &**why));
        if !declare.others.is_empty() {
            let targets: Vec<&'a Target> = std::iter::once(target).chain(&declare.others).collect();
            let values = self.read_values_in_parentheses(targets.len())?;
            for (target, contents) in targets.into_iter().zip(values) {
                let declared = self.evaluate_target(target)?;
                self.bind(declare.local, &declared, contents, vec![]);
            }
            return Ok(());
        }
        let declared = self.evaluate_target(target)?;
        self.read_value_and_bind(declare.local, deprecated, declared)
    }

    /// Runs a declaration of one name as a number that the fast evaluation gives, such as `#declare A = B * 2;`. Returns
    /// false, without any effect, for other declarations. (Not inlined: other directives run without this code.)
    #[inline(never)]
    pub(super) fn try_declare_number(&mut self, declare: &'a Declare) -> bool {
        let Declare { target, others, deprecated, local } = declare;
        if target.keyword.is_some() || !target.indices.is_empty() || !others.is_empty() || deprecated.is_some() {
            return false;
        }
        let Some(number) = self.take_number_and_semicolon() else { return false };
        self.evaluator.scopes_mut().set_number(target.symbol, number, *local);
        true
    }

    /// Skips the value that is declared, and returns the error for the reserved name `word`.
    fn skip_value_and_refuse_name(&mut self, word: &str, span: Span) -> Result<()> {
        // The value is read all the same, so that its tokens are no further faults.
        self.read_rvalue().ok();
        Diagnostic::new(codes::RESERVED_NAME, span, format!("`{word}` is a word of the language"))
            .help(format!("call it `{}`: names with a capital letter can never collide with one", capitalized(word)))
            .into()
    }

    fn refuse_semicolon_as_value(&self, symbol: Symbol) -> Result<()> {
        match self.stream.next_semicolon_span() {
            Some(at) => {
                let message = format!("expected a value for `{}`, found `;`", self.inputs.names.text(symbol));
                Diagnostic::err(codes::EXPECTED, at, message)
            }
            None => Ok(()),
        }
    }

    /// Runs `#declare` and `#local` for a target that comes token by token.
    pub fn run_declare_by_tokens(&mut self, local: bool, span: Span) -> Result<()> {
        let checkpoint = self.stream.checkpoint();
        self.declare_by_tokens(local, span).map_err(|fault| self.trace_fault_and_skip(checkpoint, *fault))
    }

    fn declare_by_tokens(&mut self, local: bool, span: Span) -> Result<()> {
        self.pop_spent_frames();
        let deprecated = self.read_deprecated()?;
        if let Some(ElementKind::Expr(_) | ElementKind::Punctuation(Punctuation::Open(Bracket::Paren))) =
            self.stream.next_raw_element().map(|e| &e.kind)
            && let Token::Open(Bracket::Paren, _) = self.peek_parenthesis_or_end()?
        {
            self.open_bracket()?;
            let mut targets = vec![];
            while !matches!(self.stream.next_raw_element().map(|e| &e.kind), Some(ElementKind::Punctuation(_)) | None) {
                if self.stream.next_raw_element().is_some_and(|e| matches!(e.kind, ElementKind::Comma)) {
                    self.stream.advance();
                    continue;
                }
                targets.push(self.read_target(span)?);
            }
            self.close_bracket("`)`")?;
            self.expect_equals_sign()?;
            let values = self.read_values_in_parentheses(targets.len())?;
            for (target, contents) in targets.into_iter().zip(values) {
                self.bind(local, &target, contents, vec![]);
            }
            return Ok(());
        }
        if let Some(Element { kind: ElementKind::Word(word), span, .. }) = self.stream.next_raw_element() {
            self.stream.advance();
            self.expect_equals_sign()?;
            return self.skip_value_and_refuse_name(word.name, *span);
        }
        let declared = self.read_target(span)?;
        self.expect_equals_sign()?;
        self.refuse_semicolon_as_value(declared.symbol)?;
        self.read_value_and_bind(local, deprecated, declared)
    }

    /// Returns the next token if it is `(`, and [`Token::End`] otherwise.
    fn peek_parenthesis_or_end(&mut self) -> Result<Token<'a>> {
        match self.stream.next_raw_element().map(|e| &e.kind) {
            Some(ElementKind::Expr(e)) if matches!(e.kind, ExprKind::Paren(_)) => self.stream.split_next_element(),
            Some(ElementKind::Punctuation(_)) => {}
            _ => return Ok(Token::End),
        }
        self.peek()
    }

    /// Reads `deprecated once "why"` if the next token begins it.
    fn read_deprecated(&mut self) -> Result<Deprecated<'a>> {
        let word = |me: &Self, name: &str| matches!(me.stream.next_raw_element().map(|e| &e.kind), Some(ElementKind::Word(w)) if w.name == name);
        if !word(self, "deprecated") {
            return Ok(None);
        }
        self.stream.advance();
        let once = word(self, "once");
        if once {
            self.stream.advance();
        }
        match self.stream.next_raw_element().map(|e| &e.kind) {
            Some(ElementKind::Expr(e)) if let ExprKind::Text(why) = &e.kind => {
                self.stream.advance();
                Ok(Some((once, why)))
            }
            _ => Ok(Some((once, ""))),
        }
    }

    /// Reads the target of a declaration: a name, perhaps with indices.
    fn read_target(&mut self, directive: Span) -> Result<Declared> {
        self.pop_spent_frames();
        // A `declare A = 3` without `#` was parsed as a comparison.
        if matches!(self.stream.next_raw_element().map(|e| &e.kind), Some(ElementKind::Expr(e)) if e.has_bare_condition())
        {
            self.stream.split_next_element();
        }
        let Some((symbol, span)) = self.stream.take_name() else { return Err(self.missing_name_error(directive)) };
        let text = self.inputs.names.text(symbol);
        if let Some(word) = word::reserved(text) {
            self.expect_equals_sign()?;
            self.skip_value_and_refuse_name(word, span)?;
        }
        if let Some(level) = self.evaluator.scope_level_of_prefix(symbol)
            && let Some(ElementKind::Punctuation(Punctuation::Dot)) = self.stream.next_raw_element().map(|e| &e.kind)
        {
            return self.read_prefixed_target(level, directive);
        }
        let indices = self.read_indices(symbol)?;
        let lvalue = match indices.is_empty() {
            true => None,
            false => Some(self.lvalue_at(symbol, span, &indices, true)?),
        };
        Ok(Declared { symbol, level: None, lvalue })
    }

    /// Reads the `.A` or `.A[i]` of a target `local.A` or `global.A[i]` (3.8). The prefix decides where the name is
    /// bound, whether `#declare` or `#local` is written.
    fn read_prefixed_target(&mut self, level: u32, directive: Span) -> Result<Declared> {
        self.stream.advance();
        let Some((symbol, span)) = self.stream.take_name() else { return Err(self.missing_name_error(directive)) };
        let indices = self.read_indices(symbol)?;
        let lvalue = match indices.is_empty() {
            true => None,
            false => {
                let array = self.evaluator.scopes().resolve_at(symbol, level);
                Some(self.lvalue_in_array(array, span, &indices, true)?)
            }
        };
        Ok(Declared { symbol, level: Some(level), lvalue })
    }

    fn missing_name_error(&self, directive: Span) -> crate::diagnostic::Fault {
        let at = self.stream.next_raw_element().map_or(directive.end(), |e| e.span);
        self.syntax_error_at(at).into()
    }

    fn expect_equals_sign(&mut self) -> Result<()> {
        match self.stream.next_raw_element().map(|e| &e.kind) {
            Some(ElementKind::Punctuation(Punctuation::Operator(Operator::Equal))) => {
                self.stream.advance();
                Ok(())
            }
            _ => {
                let at = self.stream.next_raw_element().map_or(Span::NONE, |e| e.span);
                Err(if at == Span::NONE {
                    self.unexpected_token("`=`").into()
                } else {
                    self.syntax_error_at(at).into()
                })
            }
        }
    }

    fn read_value_and_bind(&mut self, local: bool, deprecated: Deprecated<'a>, declared: Declared) -> Result<()> {
        let first = self.reporter.diagnostic_count();
        let checkpoint = self.stream.checkpoint();
        let floor = checkpoint.frame_count();
        let read =
            |me: &mut Self| me.read_rvalue().and_then(|contents| me.run_rest_of_macros(floor).map(|()| contents));
        let value = self.in_mode(|mode| mode.frame_floor = floor, read);
        if value.is_ok() && self.stream.next_raw_element().is_some_and(|e| matches!(e.kind, ElementKind::Semicolon)) {
            self.stream.advance();
        }
        let contents = match value {
            Ok(contents) => contents,
            Err(fault)
                if self.reporter.limit_reached()
                    || fault.code == codes::ENDS_RUN
                    || self.stream.unclosed_bracket_error().is_some() =>
            {
                return Err(fault);
            }
            Err(fault) => {
                let fault = self.stream.with_call_trace(*fault);
                self.skip_statement(checkpoint);
                self.stream.skip_following_texture_layers(checkpoint);
                // Text that POV-Ray cannot even tokenize is an error at once.
                if matches!(fault.code, codes::SYNTAX | codes::UNCLOSED | codes::UNMATCHED_CLOSER) {
                    self.bind(local, &declared, Contents::Faulty(Rc::default()), vec![]);
                    return fault.into();
                }
                let mut faults = self.reporter.take_diagnostics_since(first);
                faults.push(fault);
                Contents::Faulty(Rc::new(faults))
            }
        };
        // Warnings about a thing wait until the thing is used; those about a number are reported here.
        let waits = matches!(contents, Contents::Value(Value::Thing(_)) | Contents::Faulty(_));
        let pending = if waits { self.reporter.take_diagnostics_since(first) } else { vec![] };
        self.bind(local, &declared, contents, pending);
        if let Some((_, why)) = deprecated {
            self.evaluator.deprecate(declared.symbol, why);
        }
        Ok(())
    }

    fn evaluate_target(&mut self, target: &'a Target) -> Result<Declared> {
        let lvalue = match target.indices.is_empty() {
            true => None,
            false => Some(self.lvalue_adding_new_key(target.symbol, target.span, &target.indices)?),
        };
        Ok(Declared { symbol: target.symbol, level: None, lvalue })
    }

    /// Assigns a value to the target of a declaration. `first_use_warnings` are reported at the first use of a name,
    /// and now for an array element.
    fn bind(&mut self, local: bool, declared: &Declared, contents: Contents<'a>, first_use_warnings: Vec<Diagnostic>) {
        match &declared.lvalue {
            Some(lvalue) => {
                self.evaluator.scopes_mut().set_element(lvalue, Some(contents));
                first_use_warnings.into_iter().for_each(|d| self.reporter.report(d));
            }
            None if let Some(level) = declared.level => {
                self.evaluator.scopes_mut().set_at_level(declared.symbol, level, contents, first_use_warnings);
            }
            None if local => self.evaluator.scopes_mut().set_local(declared.symbol, contents, first_use_warnings),
            None => self.evaluator.scopes_mut().rebind_innermost_or_add_global(
                declared.symbol,
                contents,
                first_use_warnings,
            ),
        }
    }

    /// Reads the values `(1, 2)` of `#declare (A, B) = (1, 2);` (3.8). All values are computed before the first name is
    /// assigned, so that `(A, B) = (B, A)` swaps them.
    fn read_values_in_parentheses(&mut self, value_count: usize) -> Result<Vec<Contents<'a>>> {
        self.split_to_parenthesis()?;
        let Token::Open(Bracket::Paren, _) = self.peek()? else {
            return Err(self.unexpected_token("as many values in parentheses").into());
        };
        let span = self.open_bracket()?;
        let mut values = vec![];
        while !self.peek()?.is_closer_or_end() {
            values.push(self.read_rvalue()?);
        }
        let end = self.stream.next_span();
        self.close_bracket("`)`")?;
        if values.len() == value_count {
            return Ok(values);
        }
        Diagnostic::err(codes::WRONG_COUNT, span.to(end), format!("{value_count} names get {} values", values.len()))
    }

    pub fn run_undef(&mut self, span: Span) -> Result<()> {
        self.pop_spent_frames();
        // The name is removed before anything after it runs, and a macro's name is not called.
        let next = self.stream.innermost().and_then(StackFrame::element_after_next).map(|e| &e.kind);
        if !matches!(next, Some(ElementKind::Entry(_) | ElementKind::Punctuation(_)))
            && let Some((symbol, _)) = self.stream.take_name()
        {
            self.evaluator.scopes_mut().remove(symbol);
            return Ok(());
        }
        if self.stream.next_raw_element().is_none_or(|e| !matches!(e.kind, ElementKind::Expr(_))) {
            return Err(self.missing_name_error(span));
        }
        if let Some(ElementKind::Expr(e)) = self.stream.next_raw_element().map(|e| &e.kind)
            && matches!(e.kind, ExprKind::Index(..) | ExprKind::Dot(..))
            && !self.is_declared(e)?
        {
            self.stream.advance();
            return Ok(());
        }
        let argument = match self.read_argument() {
            // Removing an undeclared name has no effect.
            Err(fault) if fault.code == codes::UNDECLARED => return Ok(()),
            argument => argument?,
        };
        match argument.given {
            ArgumentForm::Name(symbol) => drop(self.evaluator.scopes_mut().remove(symbol)),
            ArgumentForm::LValue(lvalue) => self.evaluator.scopes_mut().set_element(&lvalue, None),
            ArgumentForm::Contents(_) => {}
        }
        Ok(())
    }

    pub fn run_default(&mut self, span: Span) -> Result<()> {
        if !matches!(self.peek()?, Token::Open(Bracket::Brace, _)) {
            let d = self.unexpected_token("`{` after `#default`");
            return d.help("`#default { finish { ambient 0 } }`").into();
        }
        self.open_bracket()?;
        self.stream.name_bracket("default", span);
        self.read_defaults()?;
        self.close_bracket("the end of this block")
    }
}

/// Returns the word with a capital first letter.
fn capitalized(word: &str) -> String {
    let mut letters = word.chars();
    letters.next().map_or(String::new(), |first| first.to_uppercase().chain(letters).collect())
}
