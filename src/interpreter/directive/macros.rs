//! `#macro Name(A, B) … #end` and its calls.

use crate::diagnostic::{Diagnostic, Result, codes};
use crate::interpreter::Interpreter;
use crate::interpreter::limits::MAX_CALLS;
use crate::interpreter::scope::Slot;
use crate::interpreter::stream::{FrameKind, Token};
use crate::source::Span;
use crate::syntax::ast::*;

impl<'a> Interpreter<'a> {
    pub(in crate::interpreter) fn define_macro(&mut self, definition: &'a Macro) -> Result<()> {
        self.scopes.set_global(definition.name, Slot::Macro(definition), vec![]);
        Ok(())
    }

    pub(in crate::interpreter) fn is_macro(&self, name: Symbol) -> bool {
        matches!(self.scopes.get(name), Some(Slot::Macro(_)))
    }

    /// Evaluates the arguments, opens a scope and puts the body next in the stream.
    pub(in crate::interpreter) fn call_macro(
        &mut self,
        name: Symbol,
        arguments: &'a [Element],
        span: Span,
    ) -> Result<()> {
        let Some(&Slot::Macro(definition)) = self.scopes.get(name) else { return Ok(()) };
        self.step(span)?;
        if self.depth >= MAX_CALLS {
            let message = format!("`{}` is called {MAX_CALLS} times inside itself", self.names.text(name));
            return self.limit(codes::CALL_DEPTH, span, message, "does this recursion ever end?");
        }
        let slots = self.enclosed(None, arguments, span, |me| me.arguments(definition, span))?;
        self.scopes.enter();
        for ((parameter, _), slot) in definition.parameters.iter().zip(slots) {
            if let Some(slot) = slot {
                self.scopes.bind_parameter(*parameter, slot);
            }
        }
        self.depth += 1;
        self.push_frame(&definition.body, FrameKind::Macro(name), span);
        Ok(())
    }

    fn arguments(&mut self, definition: &'a Macro, span: Span) -> Result<Vec<Option<Slot<'a>>>> {
        let name = self.names.text(definition.name);
        let (depth, wanted) = (self.frames.len(), definition.parameters.len());
        let mut slots = Vec::with_capacity(wanted);
        for &(parameter, optional) in &definition.parameters {
            if matches!(self.peek()?, Token::End) {
                if optional {
                    slots.push(None);
                    continue;
                }
                let parameter = self.names.text(parameter);
                return Diagnostic::new(
                    codes::WRONG_COUNT,
                    span,
                    format!("macro `{name}` takes {}, but only {} given", counted(wanted), are(slots.len())),
                )
                .also(definition.span, "defined here")
                .help(format!("the argument for `{parameter}` is missing"))
                .into();
            }
            slots.push(Some(self.argument(depth)?));
        }
        if !matches!(self.peek()?, Token::End) {
            let message = format!("macro `{name}` takes {}, but more are given", counted(wanted));
            return Diagnostic::new(codes::WRONG_COUNT, self.here(), message)
                .also(definition.span, "defined here")
                .into();
        }
        Ok(slots)
    }

    /// A bare name is passed by reference, all else as a copy; so is a name that a macro gives, which may end with it.
    fn argument(&mut self, depth: usize) -> Result<Slot<'a>> {
        if let Token::Expr(Expr { kind: ExprKind::Name(symbol), .. }) = self.peek()?
            && self.frames[depth..].iter().all(|f| !matches!(f.kind, FrameKind::Macro(_) | FrameKind::Include))
            && !self.is_macro(*symbol)
            && let Some((symbol, depth)) = self.scopes.resolve(*symbol)
        {
            self.advance();
            return Ok(Slot::Alias(symbol, depth));
        }
        self.rvalue()
    }
}

fn counted(n: usize) -> String {
    if n == 1 { "one argument".into() } else { format!("{n} arguments") }
}

fn are(n: usize) -> String {
    if n == 1 { "one is".into() } else { format!("{n} are") }
}
