//! `#declare A = …`, `#local A = …`, `#undef A`, `#default { … }`.

use crate::diagnostic::{Diagnostic, Result, codes};
use crate::interpreter::Interpreter;
use crate::interpreter::scope::{Place, Slot};
use crate::interpreter::stream::Token;
use crate::source::Span;
use crate::syntax::ast::{Declare, Element, Expr, ExprKind, Target};
use crate::value::Value;
use std::rc::Rc;

impl<'a> Interpreter<'a> {
    /// Takes the next complete value from the stream. A thing that can't be built is declared all the same: the
    /// errors are told where it is used, because standard includes declare hundreds of which a scene uses one.
    pub(in crate::interpreter) fn declare(&mut self, declare: &'a Declare) -> Result<()> {
        let target = &declare.target;
        if let Some(word) = target.keyword {
            // Its value is read all the same, so that what follows is no second fault.
            self.rvalue().ok();
            return Diagnostic::new(codes::RESERVED_NAME, target.span, format!("`{word}` is a word of the language"))
                .help("names with a capital letter can never collide with one")
                .into();
        }
        if let Some(at) = self.at_semicolon() {
            let message = format!("expected a value for `{}`, found `;`", self.names.text(target.symbol));
            return Diagnostic::err(codes::EXPECTED, at, message);
        }
        if !declare.others.is_empty() {
            return self.declare_several(declare);
        }
        if target.indices.is_empty()
            && declare.deprecated.is_none()
            && let Some(x) = self.simple_statement()
        {
            self.bind(declare, target, None, Slot::Value(Value::Float(x)), vec![]);
            return Ok(());
        }
        let place = self.target_place(target)?;
        let mark = self.diagnostics.len();
        let (depth, at) = (self.frames.len(), self.frames.last().map_or(0, |f| f.at));
        let outer = std::mem::replace(&mut self.floor, depth);
        let value = self.rvalue().and_then(|slot| self.drain(depth).map(|()| slot));
        self.floor = outer;
        let slot = match value {
            Ok(slot) => slot,
            Err(fault) if self.limit_reached || fault.code == codes::ENDS_RUN => return Err(fault),
            Err(fault) => {
                self.unwind(depth);
                if let Some(frame) = self.frames.last_mut() {
                    frame.skip_statement(at);
                    frame.skip_layers(at);
                }
                let fault = self.with_trace(*fault);
                let mut faults = self.diagnostics.split_off(mark);
                faults.push(fault);
                Slot::Faulty(Rc::new(faults))
            }
        };
        // Warnings about a thing wait until it is used; those about a number are told here.
        let waits = matches!(slot, Slot::Value(Value::Thing(_)) | Slot::Faulty(_));
        let pending = if waits { self.diagnostics.split_off(mark.min(self.diagnostics.len())) } else { vec![] };
        self.bind(declare, target, place, slot, pending);
        if let Some((_, why)) = &declare.deprecated {
            self.deprecated.insert(target.symbol, why);
        }
        Ok(())
    }

    /// Where the array or dictionary keeps what gets a value, if the target is an element.
    fn target_place(&mut self, target: &'a Target) -> Result<Option<Place>> {
        if target.indices.is_empty() {
            return Ok(None);
        }
        self.new_place(target.symbol, target.span, &target.indices).map(Some)
    }

    /// Gives the target its value; `pending` are the warnings that wait for its use.
    fn bind(
        &mut self,
        declare: &Declare,
        target: &Target,
        place: Option<Place>,
        slot: Slot<'a>,
        pending: Vec<Diagnostic>,
    ) {
        match place {
            Some(place) => {
                self.scopes.set_element(&place, Some(slot));
                pending.into_iter().for_each(|d| self.report_fault(d));
            }
            None if declare.local => self.scopes.set_local(target.symbol, slot, pending),
            None => self.scopes.set_global(target.symbol, slot, pending),
        }
    }

    /// `#declare (A, B) = (1, 2);` (3.8): all values are computed before the first name gets one, so that
    /// `(A, B) = (B, A)` swaps them.
    fn declare_several(&mut self, declare: &'a Declare) -> Result<()> {
        let targets: Vec<&'a Target> = std::iter::once(&declare.target).chain(&declare.others).collect();
        let Token::Values(elements) = self.peek()? else {
            return Err(self.unexpected_token("as many values in parentheses").into());
        };
        let span = self.here();
        self.advance();
        let values = self.enclosed(None, elements, span, |me| {
            let mut values = vec![];
            while !matches!(me.peek()?, Token::End) {
                values.push(me.rvalue()?);
            }
            Ok(values)
        })?;
        if values.len() != targets.len() {
            let message = format!("{} names get {} values", targets.len(), values.len());
            return Diagnostic::err(codes::WRONG_COUNT, span, message);
        }
        for (target, slot) in targets.into_iter().zip(values) {
            let place = self.target_place(target)?;
            self.bind(declare, target, place, slot, vec![]);
        }
        Ok(())
    }

    pub(in crate::interpreter) fn undef(&mut self, name: &'a Expr) -> Result<()> {
        match &name.kind {
            ExprKind::Name(symbol) => drop(self.scopes.remove(*symbol)),
            ExprKind::Index(array, indices) if self.is_declared(name)? => {
                let place = self.element_place(array, indices)?;
                self.scopes.set_element(&place, None);
            }
            _ => {}
        }
        Ok(())
    }

    pub(in crate::interpreter) fn default_block(&mut self, body: &'a [Element], span: Span) -> Result<()> {
        self.enclosed(Some("default"), body, span, |me| me.read_defaults())
    }
}
