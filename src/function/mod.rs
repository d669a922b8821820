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
mod slope;
mod spline;

pub use graph::{Callee, Graph, Id, Operation};
pub use interval::Interval;
pub use local_bounds::LocalBounds;
pub use program::Program;
pub use slope::Slope;
pub use spline::{Spline, SplineKind};

use crate::value::Thing;
use std::sync::Arc;

/// A function that a scene declares.
#[derive(Debug)]
pub struct Function {
    /// Names of its parameters; `x`, `y`, `z` where none are given.
    pub parameters: Box<[Box<str>]>,
    /// Computation of the function's result.
    pub body: Body,
}

/// Computation of a function.
#[derive(Debug)]
pub enum Body {
    /// An expression of numbers, compiled.
    Numeric(Program),
    /// `function { pigment { … } }` and similar functions.
    Sampled(Arc<dyn Sampler>),
}

/// Type of a function's result.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Gives {
    /// The function returns a number.
    Number,
    /// The function returns a vector of this many numbers, two to five.
    Vector(u8),
    /// The function returns a colour.
    Color,
}

/// An object of a higher layer that is evaluated at a point: a pigment, a pattern, a transform, a spline.
pub trait Sampler: std::fmt::Debug + Send + Sync {
    /// Number of arguments that the function takes.
    fn arity(&self) -> usize;
    /// Type of the result.
    fn gives(&self) -> Gives;
    /// The result: a number is the first of the five, a colour is red, green, blue, filter, transmit.
    fn sample(&self, arguments: &[f64]) -> [f64; 5];
    /// One component of the result.
    fn part(&self, component: usize, arguments: &[f64]) -> f64 {
        self.sample(arguments)[component]
    }
    /// Bounds on the components within a radius of these arguments.
    fn bounds_near(&self, _arguments: &[f64], _radius: f64) -> [LocalBounds; 5] {
        [LocalBounds::UNKNOWN; 5]
    }
    /// Bounds of a component while the arguments are in these intervals.
    fn bounds(&self, _component: usize, _arguments: &[Interval]) -> Interval {
        Interval::ALL
    }
}

impl Function {
    /// True if both compute the same in the same way, whatever their parameters' names.
    pub fn is_alike(&self, other: &Function) -> bool {
        match (&self.body, &other.body) {
            (Body::Numeric(a), Body::Numeric(b)) => self.arity() == other.arity() && a.graph().is_alike(b.graph()),
            (Body::Sampled(a), Body::Sampled(b)) => Arc::ptr_eq(a, b),
            _ => false,
        }
    }

    /// Type of the result.
    pub fn gives(&self) -> Gives {
        match &self.body {
            Body::Numeric(_) => Gives::Number,
            Body::Sampled(sampler) => sampler.gives(),
        }
    }

    /// Number of arguments that the function takes.
    pub fn arity(&self) -> usize {
        match &self.body {
            Body::Numeric(_) => self.parameters.len(),
            Body::Sampled(sampler) => sampler.arity(),
        }
    }

    /// The result for [`Self::arity`] arguments.
    pub fn call(&self, arguments: &[f64]) -> [f64; 5] {
        match &self.body {
            Body::Numeric(program) => [program.run(arguments), 0.0, 0.0, 0.0, 0.0],
            Body::Sampled(sampler) => sampler.sample(arguments),
        }
    }

    /// One component of [`Self::call`].
    pub fn part(&self, component: usize, arguments: &[f64]) -> f64 {
        match &self.body {
            Body::Numeric(program) if component == 0 => program.run(arguments),
            Body::Numeric(_) => 0.0,
            Body::Sampled(sampler) => sampler.part(component, arguments),
        }
    }
}

impl Thing for Function {
    fn kind(&self) -> &'static str {
        "function"
    }
}
