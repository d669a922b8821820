//! `function { … }` (manual, "User-Defined Functions"): compiled once into a graph of operations and into bytecode,
//! evaluated for points, and for boxes by interval arithmetic.
//!
//! The [`Graph`] has no names, scopes or macros, and each common subexpression once. The bytecode of [`Program`] is
//! generated from the graph.

mod graph;
pub mod internal;
mod interval;
mod local_bounds;
pub mod numeric;
mod program;
mod prune;
mod slope;
mod spline;

pub use graph::{Callee, Graph, Id, Operation};
pub use interval::Interval;
pub use local_bounds::LocalBounds;
pub use program::Program;
pub use prune::Replacements;
pub use slope::Slope;
pub use spline::{Spline, SplineKind};

use crate::value::Thing;
use std::sync::Arc;

/// A function that a scene declares.
#[derive(Debug)]
pub struct Function {
    /// Names of the declared function's parameters; `x`, `y`, `z` where none are given.
    pub parameters: Box<[Box<str>]>,
    /// Computation of the function's result.
    pub body: Body,
}

/// Computation of a declared function's result.
#[derive(Debug)]
pub enum Body {
    /// Function whose body is an expression of numbers, compiled.
    Numeric(Program),
    /// Function whose body is `{ pigment { … } }` or another block that is evaluated at a point.
    Sampled(Arc<dyn Sampler>),
}

/// Type of a function's result.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ResultType {
    /// The function returns a number.
    Number,
    /// The function returns a vector of this many numbers, two to five.
    Vector(u8),
    /// The function returns a colour.
    Color,
}

/// An object of a higher layer that is evaluated at a point: a pigment, a pattern, a transform, a spline.
pub trait Sampler: std::fmt::Debug + Send + Sync {
    /// Number of arguments that the evaluation of the pigment, pattern, transform or spline takes.
    fn arity(&self) -> usize;
    /// Type of the result of the pigment, pattern, transform or spline.
    fn result_type(&self) -> ResultType;
    /// Evaluates the pigment, pattern, transform or spline. A number fills the first component, a vector of `n` numbers
    /// the first `n`, a colour all five: red, green, blue, filter, transmit; other components are 0.
    fn sample(&self, arguments: &[f64]) -> [f64; 5];
    /// Evaluates one component of the result of the pigment, pattern, transform or spline.
    fn sample_component(&self, component: usize, arguments: &[f64]) -> f64 {
        self.sample(arguments)[component]
    }
    /// Returns bounds on the components of the result within a radius of these arguments.
    fn value_bounds_near(&self, _arguments: &[f64], _radius: f64) -> [LocalBounds; 5] {
        [LocalBounds::UNKNOWN; 5]
    }
    /// Returns bounds of a component of the result while the arguments are in these intervals.
    fn bounds(&self, _component: usize, _arguments: &[Interval]) -> Interval {
        Interval::ALL
    }
}

impl Function {
    /// True if both functions compute the same in the same way, whatever their parameters' names.
    pub fn is_alike(&self, other: &Function) -> bool {
        match (&self.body, &other.body) {
            (Body::Numeric(a), Body::Numeric(b)) => self.arity() == other.arity() && a.graph().is_alike(b.graph()),
            (Body::Sampled(a), Body::Sampled(b)) => Arc::ptr_eq(a, b),
            _ => false,
        }
    }

    /// Type of the function's result.
    pub fn result_type(&self) -> ResultType {
        match &self.body {
            Body::Numeric(_) => ResultType::Number,
            Body::Sampled(sampler) => sampler.result_type(),
        }
    }

    /// Number of arguments that the function takes.
    pub fn arity(&self) -> usize {
        match &self.body {
            Body::Numeric(_) => self.parameters.len(),
            Body::Sampled(sampler) => sampler.arity(),
        }
    }

    /// Calls the function with [`Self::arity`] arguments. A number is the first of the five results; a colour is red,
    /// green, blue, filter, transmit.
    pub fn call(&self, arguments: &[f64]) -> [f64; 5] {
        match &self.body {
            Body::Numeric(program) => [program.run(arguments), 0.0, 0.0, 0.0, 0.0],
            Body::Sampled(sampler) => sampler.sample(arguments),
        }
    }

    /// Calls the function; returns one component of the result.
    pub fn call_component(&self, component: usize, arguments: &[f64]) -> f64 {
        match &self.body {
            Body::Numeric(program) if component == 0 => program.run(arguments),
            Body::Numeric(_) => 0.0,
            Body::Sampled(sampler) => sampler.sample_component(component, arguments),
        }
    }
}

impl Thing for Function {
    fn kind(&self) -> &'static str {
        "function"
    }
}
