//! Functions that ask objects: `trace`, `inside`, `min_extent`, `max_extent` (manual, "Vector Functions").

use crate::diagnostic::{Diagnostic, Result, codes};
use crate::interpreter::Interpreter;
use crate::interpreter::eval::as_vector;
use crate::interpreter::scope::Slot;
use crate::math::DVec3;
use crate::scene::Object;
use crate::syntax::ast::{Expr, ExprKind};
use crate::value::{Thing, Value, downcast};
use crate::world::Probe;
use std::rc::Rc;
use std::sync::Arc;

/// Objects that are kept ready for rays at a time.
const MAX_PROBES: usize = 256;

impl<'a> Interpreter<'a> {
    /// `trace(Object, From, Direction [, Normal])`: where the ray meets the object, or the origin; the last argument is
    /// set to the normal there.
    pub(super) fn trace_object(
        &mut self,
        object: &'a Expr,
        from: &'a Expr,
        direction: &'a Expr,
        normal: Option<&'a Expr>,
    ) -> Result<Value> {
        let probe = self.probe(object)?;
        let (from, direction) = (self.vector_argument(from)?, self.vector_argument(direction)?);
        let found = probe.trace(from, direction);
        let (point, turned) = found.unwrap_or((DVec3::ZERO, DVec3::ZERO));
        if let Some(name) = normal {
            self.set_result(name, Value::Vector(turned.into()))?;
        }
        Ok(Value::Vector(point.into()))
    }

    /// `inside(Object, Point)`
    pub(super) fn inside_object(&mut self, object: &'a Expr, point: &'a Expr) -> Result<Value> {
        let probe = self.probe(object)?;
        let point = self.vector_argument(point)?;
        Ok(Value::Float(f64::from(probe.inside(point))))
    }

    /// `min_extent(Object)`, `max_extent(Object)`
    pub(super) fn extent(&mut self, object: &'a Expr, max: bool) -> Result<Value> {
        let extent = self.object_argument(object)?.extent();
        Ok(Value::Vector(if max { extent.max } else { extent.min }.into()))
    }

    fn vector_argument(&mut self, e: &'a Expr) -> Result<DVec3> {
        as_vector(&self.eval(e)?, e.span)
    }

    /// Gives a name or an array's element a value.
    fn set_result(&mut self, e: &'a Expr, value: Value) -> Result<()> {
        match &e.kind {
            ExprKind::Name(symbol) if self.scopes.get(*symbol).is_some() => {
                self.scopes.set_global(*symbol, Slot::Value(value), vec![]);
                Ok(())
            }
            ExprKind::Index(array, indices) => {
                let place = self.new_element_place(array, indices)?;
                self.scopes.set_element(&place, Some(Slot::Value(value)));
                Ok(())
            }
            ExprKind::Name(_) => self.eval(e).map(drop),
            _ => Diagnostic::new(codes::WRONG_TYPE, e.span, "the normal is given to a name")
                .help("`#declare N = <0, 0, 0>; #declare P = trace(Thing, From, Direction, N);`")
                .into(),
        }
    }

    /// An object that an argument names.
    fn object_argument(&mut self, e: &'a Expr) -> Result<Arc<Object>> {
        let value = match &e.kind {
            ExprKind::Name(_) | ExprKind::Index(..) | ExprKind::Dot(..) | ExprKind::Paren(_) => self.eval(e)?,
            ExprKind::Call(name, arguments) if self.is_macro(*name) => {
                self.call_macro(*name, arguments, e.span)?;
                let slot = self.macro_body(*name, |me| me.rvalue())?;
                self.slot_value(slot, e.span)?
            }
            _ => {
                let d = Diagnostic::new(codes::WRONG_TYPE, e.span, "expected the name of an object");
                return d.help("`#declare Thing = sphere { … }` gives it one").into();
            }
        };
        let found = value.describe();
        if let Value::Thing(thing) = value
            && let Some(object) = downcast::<Object>(&thing)
        {
            return Ok(object);
        }
        Diagnostic::err(codes::WRONG_TYPE, e.span, format!("expected an object, found {found}"))
    }

    /// The same, ready for rays. What was asked before is not built again.
    fn probe(&mut self, e: &'a Expr) -> Result<Rc<Probe>> {
        let object = self.object_argument(e)?;
        let key = Arc::as_ptr(&object).cast::<()>();
        if let Some((_, probe)) = self.probes.get(&key) {
            return Ok(probe.clone());
        }
        if self.probes.len() >= MAX_PROBES {
            self.probes.clear();
        }
        let probe = Rc::new(Probe::new(&object)?);
        // The object is kept, so that no other one gets its address.
        self.probes.insert(key, (object as Arc<dyn Thing>, probe.clone()));
        Ok(probe)
    }
}
