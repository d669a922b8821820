//! `function { … }` (manual, "User-Defined Functions"): compiled once into a graph of operations and a row of
//! instructions, evaluated for points, and for boxes by interval arithmetic.
//!
//! What a function computes lies in its [`Graph`]: numbers, without names, scopes or macros, each shared result once.
//! The bytecode of [`Program`] comes from it, as machine code will.

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

/// A declared function.
#[derive(Debug)]
pub struct Function {
    /// Names of its parameters; `x`, `y`, `z` where none are given.
    pub parameters: Box<[Box<str>]>,
    /// What it computes.
    pub body: Body,
}

/// See the variants.
#[derive(Debug)]
pub enum Body {
    /// An expression.
    Numeric(Program),
    /// `function { pigment { … } }` and its kin.
    Sampled(Arc<dyn Sampler>),
}

/// What a call gives.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Gives {
    /// A number.
    Number,
    /// Two to five numbers.
    Vector(u8),
    /// A colour.
    Color,
}

/// Something of a higher layer that can be asked at a point: a pigment, a pattern, a transform, a spline.
pub trait Sampler: std::fmt::Debug + Send + Sync {
    /// How many arguments it takes.
    fn arity(&self) -> usize;
    /// What it gives.
    fn gives(&self) -> Gives;
    /// The answer; a number is the first of the five, a colour is red, green, blue, filter, transmit.
    fn sample(&self, arguments: &[f64]) -> [f64; 5];
    /// One of the five.
    fn part(&self, component: usize, arguments: &[f64]) -> f64 {
        self.sample(arguments)[component]
    }
    /// What is known of the five no farther than a radius from these arguments.
    fn bounds_near(&self, _arguments: &[f64], _radius: f64) -> [LocalBounds; 5] {
        [LocalBounds::UNKNOWN; 5]
    }
    /// Between which numbers a component lies while the arguments lie in these intervals.
    fn bounds(&self, _component: usize, _arguments: &[Interval]) -> Interval {
        Interval::ALL
    }
}

impl Function {
    /// Does it compute the same in the same way, whatever its parameters are called?
    pub fn is_alike(&self, other: &Function) -> bool {
        match (&self.body, &other.body) {
            (Body::Numeric(a), Body::Numeric(b)) => self.arity() == other.arity() && a.graph().is_alike(b.graph()),
            (Body::Sampled(a), Body::Sampled(b)) => Arc::ptr_eq(a, b),
            _ => false,
        }
    }

    /// What a call gives.
    pub fn gives(&self) -> Gives {
        match &self.body {
            Body::Numeric(_) => Gives::Number,
            Body::Sampled(sampler) => sampler.gives(),
        }
    }

    /// How many arguments a call takes.
    pub fn arity(&self) -> usize {
        match &self.body {
            Body::Numeric(_) => self.parameters.len(),
            Body::Sampled(sampler) => sampler.arity(),
        }
    }

    /// The value for these arguments, as many as [`Self::arity`] says.
    pub fn call(&self, arguments: &[f64]) -> [f64; 5] {
        match &self.body {
            Body::Numeric(program) => [program.run(arguments), 0.0, 0.0, 0.0, 0.0],
            Body::Sampled(sampler) => sampler.sample(arguments),
        }
    }

    /// One of the numbers that [`Self::call`] gives.
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
