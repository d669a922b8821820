//! Functions that query objects: `trace`, `inside`, `min_extent`, `max_extent` (manual, "Vector Functions").

use crate::diagnostic::{Diagnostic, Result, codes};
use crate::interpreter::Interpreter;
use crate::interpreter::argument::{Argument, ArgumentForm};
use crate::interpreter::evaluator::Contents;
use crate::math::DVec3;
use crate::scene::Object;
use crate::value::{Value, downcast};
use crate::world::Probe;
use std::rc::Rc;
use std::sync::Arc;

impl<'a> Interpreter<'a> {
    /// Evaluates `trace(Object, From, Direction [, Normal])`: the first hit of a ray, or the origin without a hit. The
    /// name in the last argument is set to the normal at the hit.
    pub(super) fn trace_object(
        &mut self,
        object: &Argument<'a>,
        from: &Argument<'a>,
        direction: &Argument<'a>,
        normal: Option<&Argument<'a>>,
    ) -> Result<Value> {
        let probe = self.probe(object)?;
        let (from, direction) = (self.argument_vector(from)?, self.argument_vector(direction)?);
        let found = probe.hit_point_and_normal(from, direction);
        let (point, turned) = found.unwrap_or((DVec3::ZERO, DVec3::ZERO));
        if let Some(name) = normal {
            self.assign_to_argument(name, Value::Vector(turned.into()))?;
        }
        Ok(Value::Vector(point.into()))
    }

    /// Evaluates `inside(Object, Point)`: 1 if the point is inside of the object, else 0.
    pub(super) fn inside_object(&mut self, object: &Argument<'a>, point: &Argument<'a>) -> Result<Value> {
        let probe = self.probe(object)?;
        let point = self.argument_vector(point)?;
        Ok(Value::Float(f64::from(probe.inside(point))))
    }

    /// Evaluates `min_extent(Object)` or `max_extent(Object)`: corners of the object's bounding box.
    pub(super) fn extent_corner(&mut self, object: &Argument<'a>, max: bool) -> Result<Value> {
        let pov_bounds = self.object_argument(object)?.pov_bounds();
        Ok(Value::Vector(if max { pov_bounds.max } else { pov_bounds.min }.into()))
    }

    /// Assigns a value to a name or an array's element.
    fn assign_to_argument(&mut self, target: &Argument<'a>, value: Value) -> Result<()> {
        match &target.given {
            ArgumentForm::Name(symbol) if self.evaluator.is_declared(*symbol) => {
                self.evaluator.scopes_mut().rebind_innermost_or_add_global(*symbol, Contents::Value(value), vec![]);
                Ok(())
            }
            ArgumentForm::LValue(lvalue) => {
                self.evaluator.scopes_mut().set_element(lvalue, Some(Contents::Value(value)));
                Ok(())
            }
            ArgumentForm::Name(symbol) => self.evaluate_name(*symbol, target.span).map(drop),
            ArgumentForm::Contents(_) => {
                Diagnostic::new(codes::WRONG_TYPE, target.span, "the normal is given to a name")
                    .help("`#declare N = <0, 0, 0>; #declare P = trace(Thing, From, Direction, N);`")
                    .into()
            }
        }
    }

    /// Returns the object that an argument names.
    fn object_argument(&mut self, argument: &Argument<'a>) -> Result<Arc<Object>> {
        let value = self.argument_value(argument)?;
        let found = value.describe();
        if let Value::Thing(thing) = value
            && let Some(object) = downcast::<Object>(&thing)
        {
            return Ok(object);
        }
        let d = Diagnostic::new(codes::WRONG_TYPE, argument.span, format!("expected an object, found {found}"));
        d.help("`#declare Thing = sphere { … }` declares one").into()
    }

    /// Returns the object that an argument names, prepared for ray queries and cached.
    fn probe(&mut self, argument: &Argument<'a>) -> Result<Rc<Probe>> {
        let object = self.object_argument(argument)?;
        let key = Arc::as_ptr(&object).cast::<()>();
        if let Some(probe) = self.evaluator.assets().probe(key) {
            return Ok(probe);
        }
        let probe = Rc::new(Probe::new(&object)?);
        self.evaluator.assets().add_probe(object, probe.clone());
        Ok(probe)
    }
}
