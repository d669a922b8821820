//! The computation of a function: a graph of operations that refer to their operands by index. Equal operations exist
//! once; operations on constants are evaluated when the graph is built.

use super::numeric::{self, Kernel};
use super::{Function, Interval, LocalBounds, Program, ResultType, Sampler, internal::Internal};
use crate::math::DVec3;
use crate::math::cancel::Poll;
use crate::math::noise::{self, NoiseGenerator};
use crate::syntax::ast::Operator;
use rustc_hash::FxHashMap;
use smallvec::SmallVec;
use std::sync::Arc;
use std::sync::atomic::{AtomicU8, Ordering};

/// Index of an operation in its [`Graph`]; operands have smaller indices.
pub type Id = u32;

/// An operation of a function's computation graph; it refers to its operands by index.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub enum Operation {
    /// A constant of a function, by its bits.
    Constant(u64),
    /// A parameter of the function, by its index.
    Parameter(u16),
    /// Call of a built-in numeric function with one argument: its row in [`numeric::TABLE`], and the argument.
    One(u8, Id),
    /// Call of a built-in numeric function with two arguments: its row in [`numeric::TABLE`], and the arguments.
    Two(u8, Id, Id),
    /// An operator with two operands, by their indices.
    Binary(Operator, Id, Id),
    /// The conditional `a ? b : c`: the second operand if the first is not 0, else the third; the other one is not
    /// evaluated.
    Choice(Id, Id, Id),
    /// A component of the result of a call: index of the function in [`Graph::callees`], component, arguments.
    Call(u32, u8, Box<[Id]>),
}

/// Function, pattern or series that a function's graph calls.
#[derive(Clone, Debug)]
pub enum Callee {
    /// One of POV-Ray's internal functions, the ones behind `functions.inc`.
    Internal(&'static Internal),
    /// POV-Ray's `f_noise3d`, whose noise generator is that of the scene and may be set after the function is declared.
    SceneNoise(Arc<AtomicU8>),
    /// A declared function that is too large to be inlined.
    Function(Arc<Function>),
    /// A pigment, pattern, transform or spline that a function evaluates.
    Sampler(Arc<dyn Sampler>),
    /// The call `sum(I, A, B, …)` or `prod(…)`: the body's parameters are those of the enclosing function and the
    /// counter.
    Series {
        /// True for the series `prod`, false for `sum`.
        product: bool,
        /// Program that computes a term of `sum`, or a factor of `prod`.
        body: Arc<Program>,
    },
}

/// Computation graph of a function: all its operations, operands first.
#[derive(Clone, Debug, Default)]
pub struct Graph {
    /// Operations of the function, each after its operands.
    pub nodes: Vec<Operation>,
    /// Functions that [`Operation::Call`] refers to by index.
    pub callees: Vec<Callee>,
    /// Index of the operation that gives the function's result.
    pub result: Id,
    known: FxHashMap<Operation, Id>,
}

/// Applies an operator. Inside functions comparisons are exact, and all numbers but 0 are true (quirk:
/// `exact_comparisons_in_functions`).
pub(super) fn apply_operator(op: Operator, a: f64, b: f64) -> f64 {
    use Operator::*;
    match op {
        Add => a + b,
        Sub => a - b,
        Mul => a * b,
        Div => a / b,
        Less => f64::from(a < b),
        LessEqual => f64::from(a <= b),
        Greater => f64::from(a > b),
        GreaterEqual => f64::from(a >= b),
        Equal => f64::from(a == b),
        NotEqual => f64::from(a != b),
        And => f64::from(a != 0.0 && b != 0.0),
        Or => f64::from(a != 0.0 || b != 0.0),
    }
}

/// Returns the bounds of an operator's result while its operands are in these intervals; `same_operand` is true if both
/// operands are one node.
pub(super) fn operator_bounds(op: Operator, a: Interval, b: Interval, same_operand: bool) -> Interval {
    use Operator::*;
    let sure = |yes: bool, no: bool| match (yes, no) {
        (true, _) => Interval::point(1.0),
        (_, true) => Interval::point(0.0),
        _ => Interval::TRUTH,
    };
    match op {
        Add => a + b,
        Sub if same_operand => Interval::point(0.0),
        Sub => a + -b,
        Mul if same_operand => a.square(),
        Mul => a * b,
        Div => a * b.recip(),
        Less => sure(a.hi < b.lo, a.lo >= b.hi),
        LessEqual => sure(a.hi <= b.lo, a.lo > b.hi),
        Greater => sure(a.lo > b.hi, a.hi <= b.lo),
        GreaterEqual => sure(a.lo >= b.hi, a.hi < b.lo),
        Equal => sure(false, a.hi < b.lo || a.lo > b.hi),
        NotEqual => sure(a.hi < b.lo || a.lo > b.hi, false),
        And | Or => Interval::TRUTH,
    }
}

impl Operation {
    /// Calls `visit` with the index of each operand.
    pub(super) fn for_each_operand(&self, mut visit: impl FnMut(Id)) {
        match self {
            Operation::Constant(_) | Operation::Parameter(_) => {}
            Operation::One(_, a) => visit(*a),
            Operation::Two(_, a, b) | Operation::Binary(_, a, b) => [*a, *b].into_iter().for_each(visit),
            Operation::Choice(c, a, b) => [*c, *a, *b].into_iter().for_each(visit),
            Operation::Call(_, _, list) => list.iter().copied().for_each(visit),
        }
    }
}

impl Callee {
    /// Calls the function; returns a component of its result.
    pub fn call_component(&self, component: usize, arguments: &[f64]) -> f64 {
        match self {
            Callee::Internal(internal) => (internal.compute)(arguments),
            Callee::SceneNoise(generator) => scene_noise(generator, arguments),
            Callee::Function(function) => function.call_component(component, arguments),
            Callee::Sampler(sampler) => sampler.sample_component(component, arguments),
            Callee::Series { product, body } => evaluate_series(*product, body, arguments),
        }
    }

    /// Calls a function with several components; returns all of them.
    pub(super) fn call_all(&self, arguments: &[f64]) -> [f64; 5] {
        match self {
            Callee::Function(function) => function.call(arguments),
            Callee::Sampler(sampler) => sampler.sample(arguments),
            _ => [self.call_component(0, arguments); 5],
        }
    }

    /// True if the called function returns a single number, which is the first component of [`Self::call_all`]. The
    /// other four are 0 for [`Callee::Function`] and [`Callee::Sampler`]; for all other callees they repeat the number.
    pub(super) fn gives_number(&self) -> bool {
        let gives = match self {
            Callee::Function(function) => function.result_type(),
            Callee::Sampler(sampler) => sampler.result_type(),
            _ => ResultType::Number,
        };
        gives == ResultType::Number
    }

    fn is_same_callee(&self, other: &Callee) -> bool {
        match (self, other) {
            (Callee::Internal(a), Callee::Internal(b)) => std::ptr::eq(*a, *b),
            (Callee::SceneNoise(_), Callee::SceneNoise(_)) => true,
            (Callee::Function(a), Callee::Function(b)) => Arc::ptr_eq(a, b),
            (Callee::Sampler(a), Callee::Sampler(b)) => Arc::ptr_eq(a, b),
            _ => false,
        }
    }

    /// Returns bounds on the components of a call's result, and on their gradients by the first three arguments, while
    /// these move at most `radius` away from the values given.
    pub(super) fn value_bounds_near(&self, arguments: &[f64], radius: f64) -> [LocalBounds; 5] {
        let rest = &arguments[3..];
        let (steepest, bend) = match self {
            Callee::Sampler(sampler) => return sampler.value_bounds_near(arguments, radius),
            Callee::Function(function) => match &function.body {
                super::Body::Sampled(sampler) => return sampler.value_bounds_near(arguments, radius),
                super::Body::Numeric(_) => return [LocalBounds::UNKNOWN; 5],
            },
            Callee::SceneNoise(generator) => {
                let generator = load_generator(generator);
                (generator.max_gradient(), Some(generator.max_gradient_change_per_unit()))
            }
            Callee::Internal(internal) => match internal.steepest {
                Some(steepest) => (steepest(rest), internal.bend.map(|bend| bend(rest))),
                None => return [LocalBounds::UNKNOWN; 5],
            },
            Callee::Series { .. } => return [LocalBounds::UNKNOWN; 5],
        };
        let near = LocalBounds::from_max_gradient(self.call_component(0, arguments), steepest, radius);
        let Some(bend) = bend else { return [near; 5] };
        let aside = |by: DVec3| {
            let mut there: SmallVec<[f64; 10]> = arguments.into();
            there.iter_mut().zip(by.to_array()).for_each(|(x, by)| *x += by);
            self.call_component(0, &there)
        };
        [near.tightened_by_gradient_change(aside, bend, radius, Interval::TRUTH); 5]
    }

    pub(super) fn bounds(&self, component: usize, arguments: &[Interval]) -> Interval {
        match self {
            Callee::Sampler(sampler) => sampler.bounds(component, arguments),
            Callee::Function(function) => match &function.body {
                super::Body::Numeric(program) => program.graph().bounds(arguments),
                super::Body::Sampled(sampler) => sampler.bounds(component, arguments),
            },
            Callee::SceneNoise(_) => Interval { lo: 0.0, hi: 1.0 },
            Callee::Internal(internal) => internal.bounds.map_or(Interval::ALL, |bounds| bounds(arguments)),
            Callee::Series { .. } => Interval::ALL,
        }
    }
}

fn load_generator(scene: &AtomicU8) -> NoiseGenerator {
    NoiseGenerator::from_number_modulo_4(f64::from(scene.load(Ordering::Relaxed)))
}

fn scene_noise(generator: &AtomicU8, p: &[f64]) -> f64 {
    noise::noise(DVec3::new(p[0], p[1], p[2]), load_generator(generator))
}

/// Maximum number of terms of `sum` and `prod`; a longer series gives NaN.
const MAX_TERMS: f64 = 1e7;

/// Evaluates a `sum` or `prod`. The arguments are the first and last value of the counter, and then those of the
/// enclosing function. NaN for more than [`MAX_TERMS`] terms; in cancelled work, a part of the terms.
fn evaluate_series(is_product: bool, body: &Program, arguments: &[f64]) -> f64 {
    let [first, last, outer @ ..] = arguments else { return f64::NAN };
    let mut inner = outer.to_vec();
    inner.push(0.0);
    if last - first > MAX_TERMS {
        return f64::NAN;
    }
    let (mut total, mut counter, mut poll) = (f64::from(is_product), *first, Poll::default());
    while counter <= *last && !poll.is_cancelled() {
        inner[outer.len()] = counter;
        let term = body.run(&inner);
        total = if is_product { total * term } else { total + term };
        counter += 1.0;
    }
    total
}

impl Graph {
    /// True if both graphs compute the same by the same operations.
    pub fn is_alike(&self, other: &Graph) -> bool {
        (self.result, &self.nodes, self.callees.len()) == (other.result, &other.nodes, other.callees.len())
            && self.callees.iter().zip(&other.callees).all(|(a, b)| a.is_same_callee(b))
    }

    /// Adds a constant to the function's graph and returns its index.
    pub fn add_constant(&mut self, x: f64) -> Id {
        self.add_operation(Operation::Constant(x.to_bits()))
    }

    /// The value of an operation of the graph, if the operation is a constant.
    pub fn constant_value(&self, id: Id) -> Option<f64> {
        match self.nodes[id as usize] {
            Operation::Constant(bits) => Some(f64::from_bits(bits)),
            _ => None,
        }
    }

    /// Returns the index of an operation, which is added if the graph lacks it. An operation on constants becomes a
    /// constant, and a choice by a constant condition becomes the chosen operand.
    pub fn add_operation(&mut self, node: Operation) -> Id {
        let node = self.fold_constants(&node).map_or(node, |x| Operation::Constant(x.to_bits()));
        if let Operation::Choice(condition, yes, no) = node
            && let Some(x) = self.constant_value(condition)
        {
            return if x != 0.0 { yes } else { no };
        }
        if let Some(&id) = self.known.get(&node) {
            return id;
        }
        let id = self.nodes.len() as Id;
        self.nodes.push(node.clone());
        self.known.insert(node, id);
        id
    }

    fn fold_constants(&self, node: &Operation) -> Option<f64> {
        Some(match node {
            Operation::One(row, a) => call_unary(*row, self.constant_value(*a)?),
            Operation::Two(row, a, b) => call_binary(*row, self.constant_value(*a)?, self.constant_value(*b)?),
            Operation::Binary(op, a, b) => apply_operator(*op, self.constant_value(*a)?, self.constant_value(*b)?),
            _ => return None,
        })
    }

    /// Adds a component of the result of a call to the function's graph, and returns its index.
    pub fn add_call_component(&mut self, callee: Callee, component: u8, arguments: Box<[Id]>) -> Id {
        let index = self.callees.iter().position(|c| c.is_same_callee(&callee)).unwrap_or_else(|| {
            self.callees.push(callee);
            self.callees.len() - 1
        });
        self.add_operation(Operation::Call(index as u32, component, arguments))
    }

    /// Copies another function's graph into this one, with these operands for its parameters; returns the index of its
    /// result.
    pub fn inline_graph(&mut self, other: &Graph, arguments: &[Id]) -> Id {
        let mut ids: Vec<Id> = Vec::with_capacity(other.nodes.len());
        for node in &other.nodes {
            ids.push(self.copy_operation(other, node, &ids, arguments));
        }
        ids[other.result as usize]
    }

    /// Copies an operation of another function's graph into this one; `ids` are the indices of the copied operands, and
    /// `arguments` those of the operands for parameters. Returns the index of the copy.
    pub(super) fn copy_operation(&mut self, other: &Graph, node: &Operation, ids: &[Id], arguments: &[Id]) -> Id {
        let at = |id: &Id| ids[*id as usize];
        match node {
            Operation::Parameter(i) => arguments[*i as usize],
            Operation::Constant(_) => self.add_operation(node.clone()),
            Operation::One(row, a) => self.add_operation(Operation::One(*row, at(a))),
            Operation::Two(row, a, b) => self.add_operation(Operation::Two(*row, at(a), at(b))),
            Operation::Binary(op, a, b) => self.add_operation(Operation::Binary(*op, at(a), at(b))),
            Operation::Choice(c, a, b) => self.add_operation(Operation::Choice(at(c), at(a), at(b))),
            Operation::Call(callee, component, list) => {
                let list = list.iter().map(at).collect();
                self.add_call_component(other.callees[*callee as usize].clone(), *component, list)
            }
        }
    }

    /// Frees the memory that finds equal operations, for a graph that is complete.
    pub(super) fn forget_known_operations(&mut self) {
        self.known = FxHashMap::default();
    }

    /// Returns bounds of the function's result while the parameters are in these intervals and every operation gives a
    /// number.
    pub fn bounds(&self, parameters: &[Interval]) -> Interval {
        let mut all: Vec<Interval> = Vec::with_capacity(self.nodes.len());
        for node in &self.nodes {
            let at = |id: &Id| all[*id as usize];
            let bounds = match node {
                Operation::Constant(bits) => Interval::point(f64::from_bits(*bits)),
                Operation::Parameter(i) => parameters[*i as usize],
                Operation::One(row, a) => (numeric::TABLE[*row as usize].bounds)(at(a), at(a)),
                Operation::Two(row, a, b) => (numeric::TABLE[*row as usize].bounds)(at(a), at(b)),
                Operation::Binary(op, a, b) => operator_bounds(*op, at(a), at(b), a == b),
                Operation::Choice(condition, yes, no) => match at(condition) {
                    c if !c.contains(0.0) => at(yes),
                    c if c.lo == 0.0 && c.hi == 0.0 => at(no),
                    _ => at(yes).hull(at(no)),
                },
                Operation::Call(callee, component, list) => {
                    let list: Vec<Interval> = list.iter().map(at).collect();
                    self.callees[*callee as usize].bounds(*component as usize, &list)
                }
            };
            all.push(bounds);
        }
        all.get(self.result as usize).copied().unwrap_or(Interval::ALL)
    }
}

/// Calls the built-in numeric function of a table row with one argument.
pub(super) fn call_unary(row: u8, a: f64) -> f64 {
    match numeric::TABLE[row as usize].kernel {
        Kernel::One(f) => f(a),
        _ => a,
    }
}

/// Calls the built-in numeric function of a table row with two arguments.
pub(super) fn call_binary(row: u8, a: f64, b: f64) -> f64 {
    match numeric::TABLE[row as usize].kernel {
        Kernel::Two(f) | Kernel::Many(f) => f(a, b),
        Kernel::One(f) => f(a),
    }
}
