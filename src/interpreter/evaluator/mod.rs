//! Values of a run: scopes, constants, the fast evaluation of expressions, random streams and cached assets.
//!
//! No code of this module reads the token stream. Calls of macros and splines, and errors with a call trace, are in
//! [`super::eval`].

mod assets;
mod constants;
mod element;
mod operators;
mod quick;
mod random_streams;
mod scope;
mod timing;
mod vector_functions;
mod whole;

use super::Inputs;
use crate::diagnostic::{Diagnostic, Result, codes};
use crate::source::Span;
use crate::syntax::ast::Symbol;
use crate::value::{Next, Thing, Value, downcast};
pub(super) use assets::Assets;
use constants::Constants;
pub(super) use element::not_text_error;
pub(super) use operators::{
    TOLERANCE, apply_prefix, as_float, as_vector, combine, component, component_index, divides_by_zero, numbers_of,
    vector_value,
};
pub(super) use quick::Quick;
use random_streams::RandomStreams;
use rustc_hash::FxHashMap;
pub(super) use scope::{Array, Contents, LValue, Scopes};
use std::sync::Arc;
pub use timing::Timing;
pub(super) use vector_functions::{VECTOR_FUNCTIONS, VectorFunction};
pub(super) use whole::is_callable;

/// Values, scopes and constants of one run of the interpreter.
pub(super) struct Evaluator<'a> {
    inputs: Inputs<'a>,
    scopes: Scopes<'a>,
    constants: Constants,
    /// Messages of names declared `deprecated` that were not used yet.
    deprecated: FxHashMap<Symbol, &'a str>,
    random: RandomStreams,
    assets: Assets,
    /// Empty list for the arguments of the next macro call, kept to reuse its allocation.
    spare_arguments: Vec<Option<Contents<'a>>>,
    /// True if calls of all macros are expanded to tokens, also of those whose body is a value: in bodies of functions,
    /// which are compiled.
    expands_all_macros: bool,
}

impl<'a> Evaluator<'a> {
    /// Creates an evaluator whose only names are those declared by the option `--declare`.
    pub(super) fn new(inputs: Inputs<'a>) -> Self {
        let mut scopes = Scopes::default();
        for (name, value) in &inputs.options.declares {
            let value =
                crate::value::parse_value(value).unwrap_or_else(|_| Value::Text(value.trim_matches('"').into()));
            scopes.rebind_innermost_or_add_global(inputs.names.intern(name), Contents::Value(value), vec![]);
        }
        Self {
            inputs,
            scopes,
            constants: Constants::new(inputs),
            deprecated: FxHashMap::default(),
            random: RandomStreams::default(),
            assets: Assets::default(),
            spare_arguments: vec![],
            expands_all_macros: false,
        }
    }

    #[inline]
    pub(super) fn scopes(&self) -> &Scopes<'a> {
        &self.scopes
    }

    #[inline]
    pub(super) fn scopes_mut(&mut self) -> &mut Scopes<'a> {
        &mut self.scopes
    }

    pub(super) fn assets(&mut self) -> &mut Assets {
        &mut self.assets
    }

    /// Returns the value of the built-in constant of this name; `None` for other names.
    pub(super) fn constant(&self, symbol: Symbol) -> Option<Value> {
        self.constants.get(symbol, &*self.inputs.options.host)
    }

    pub(super) fn is_constant(&self, symbol: Symbol) -> bool {
        self.constants.get(symbol, &*self.inputs.options.host).is_some()
    }

    /// Sets the built-in constant `version`, the language version in force.
    pub(super) fn set_version(&mut self, version: u32) {
        self.constants.set_version(version);
    }

    #[inline]
    pub(super) fn is_macro(&self, symbol: Symbol) -> bool {
        matches!(self.scopes.get(symbol), Some(Contents::Macro(_)))
    }

    pub(super) fn is_array(&self, symbol: Symbol) -> bool {
        matches!(self.scopes.get(symbol), Some(Contents::Array(_)))
    }

    pub(super) fn is_declared(&self, symbol: Symbol) -> bool {
        self.scopes.get(symbol).is_some()
    }

    /// Returns the symbol of a keyword that the scene also declared as a name; `None` for other keywords.
    pub(super) fn declared_symbol_of_keyword(&self, word: &str) -> Option<Symbol> {
        self.inputs.names.find(word).filter(|symbol| self.is_declared(*symbol))
    }

    /// True for a name that is neither declared nor a built-in constant.
    pub(super) fn is_unknown(&self, symbol: Symbol) -> bool {
        !self.is_declared(symbol) && !self.is_constant(symbol)
    }

    /// Returns the declared object, texture or similar value of this name; `None` if its type is not `T`.
    pub(super) fn thing_of<T: Thing>(&self, symbol: Symbol) -> Option<Arc<T>> {
        match self.scopes.get(symbol) {
            Some(Contents::Value(Value::Thing(thing))) => downcast(thing),
            _ => None,
        }
    }

    /// Returns a name as [`crate::value::Reader::peek_next`] announces it: as a declared thing or as a value.
    pub(super) fn next_kind_of_name(&self, symbol: Symbol) -> Next {
        match self.scopes.get(symbol) {
            Some(Contents::Value(Value::Thing(thing))) => Next::Thing(thing.kind()),
            _ => Next::Value,
        }
    }

    /// Adds the step to a loop's counter, which the body may have changed. Returns true if another pass follows.
    pub(super) fn step_counter_and_continues(
        &mut self,
        counter: Symbol,
        last: f64,
        step: f64,
        span: Span,
    ) -> Result<bool> {
        let Some(Contents::Value(Value::Float(value))) = self.scopes.get(counter) else {
            let name = self.inputs.names.text(counter);
            return Diagnostic::err(codes::WRONG_TYPE, span, format!("the counter `{name}` is no longer a number"));
        };
        let next = value + step;
        self.scopes.set_number(counter, next, false);
        Ok(is_in_loop(next, last, step))
    }

    /// Makes the first use of a name report the warning `why`.
    pub(super) fn deprecate(&mut self, symbol: Symbol, why: &'a str) {
        self.deprecated.insert(symbol, why);
    }

    #[inline]
    pub(super) fn has_deprecations(&self) -> bool {
        !self.deprecated.is_empty()
    }

    /// Returns and forgets the reason why a name is deprecated; `None` for other names and from the second call on.
    pub(super) fn take_deprecation(&mut self, symbol: Symbol) -> Option<&'a str> {
        self.deprecated.remove(&symbol)
    }

    #[inline]
    pub(super) fn random_streams(&mut self) -> &mut RandomStreams {
        &mut self.random
    }

    /// Returns an empty list for the arguments of a macro call.
    pub(super) fn take_empty_argument_list(&mut self) -> Vec<Option<Contents<'a>>> {
        std::mem::take(&mut self.spare_arguments)
    }

    /// Sets whether calls of all macros are expanded to tokens, also of value macros; returns the previous setting.
    pub(super) fn set_expands_all_macros(&mut self, expands: bool) -> bool {
        std::mem::replace(&mut self.expands_all_macros, expands)
    }

    /// Opens the scope of a macro call and binds the parameters to the arguments. The argument `None` leaves an
    /// optional parameter unbound.
    pub(super) fn enter_call(&mut self, parameters: &[(Symbol, bool)], mut arguments: Vec<Option<Contents<'a>>>) {
        self.scopes.enter_scope();
        for ((parameter, _), contents) in parameters.iter().zip(arguments.drain(..)) {
            if let Some(contents) = contents {
                self.scopes.bind_parameter(*parameter, contents);
            }
        }
        self.spare_arguments = arguments;
    }
}

/// True if a `#for` loop with this step and last value runs its body for the counter `value`.
pub(super) fn is_in_loop(value: f64, last: f64, step: f64) -> bool {
    if step > 0.0 { value <= last + TOLERANCE } else { value >= last - TOLERANCE }
}
