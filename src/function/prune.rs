//! Pruning: a function without the operations that interval arithmetic decides over a box, after Matthew J. Keeter,
//! "Massively Parallel Rendering of Complex Closed-Form Implicit Surfaces" (SIGGRAPH 2020).
//!
//! A pruned function gives the same bits as the whole function at every point of its box. Only operations that surely
//! give finite numbers are compared, and only intervals that do not touch are decided: neither NaN nor the sign of 0
//! then depends on the operand that is dropped.

use super::graph::{Callee, Graph, Id, Operation, operator_bounds};
use super::{Body, Function, Interval, Program, Slope, numeric};
use crate::syntax::ast::Operator;
use smallvec::SmallVec;
use std::sync::Arc;

/// Relative widening of bounds before decisions, far above the rounding error of an operation.
const MARGIN: f64 = 1e-12;
/// Maximum number of operations of a pruned function that is inlined into its caller.
const MAX_INLINED: usize = 60;

/// Replacement of an operation that is valid in a box.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
enum Replacement {
    /// One of the operands, by its index.
    Operand(Id),
    /// A constant, by its bits.
    Constant(u64),
    /// Call of the same declared function, pruned.
    PrunedCallee(Replacements),
}

/// Replacements of a function's operations that are valid in a box, in the order of the operations. Only operations
/// that contribute to the pruned result are listed, so that equal lists mean equal pruned functions.
#[derive(Clone, Debug, Default, PartialEq, Eq, Hash)]
pub struct Replacements(Vec<(Id, Replacement)>);

impl Replacements {
    /// True if pruning would not change the function.
    pub fn is_empty(&self) -> bool {
        self.0.is_empty()
    }

    /// Returns the replacement of an operation, if any.
    fn of(&self, id: Id) -> Option<&Replacement> {
        self.0.binary_search_by_key(&id, |(id, _)| *id).ok().map(|i| &self.0[i].1)
    }
}

/// Bounds of all operations of a graph over a box.
struct OperationBounds {
    /// Bounds of each operation; `None` if the operation may be NaN or unbounded.
    all: Vec<Option<Interval>>,
    /// Bounds within the declared functions that the graph calls, by the index of the call.
    callees: Vec<(Id, OperationBounds)>,
}

impl OperationBounds {
    /// Computes the bounds from those of the parameters, and from the slopes of all operations over the same box.
    fn new(graph: &Graph, parameters: &[Option<Interval>], slopes: &[Slope]) -> Self {
        let mut bounds = Self { all: Vec::with_capacity(graph.nodes.len()), callees: vec![] };
        for (node, slope) in graph.nodes.iter().zip(slopes) {
            let own = match node {
                Operation::Parameter(i) => parameters[*i as usize],
                Operation::Call(callee, _, list) => {
                    bounds.of_call(&graph.callees[*callee as usize], list, slopes, slope)
                }
                _ => bounds.of_operation(node, slope),
            };
            bounds.all.push(own.filter(|own| own.lo.is_finite() && own.hi.is_finite()));
        }
        bounds
    }

    /// Returns the bounds of an operation; `None` if an operand may be NaN or unbounded.
    fn of_operation(&self, node: &Operation, slope: &Slope) -> Option<Interval> {
        let at = |id: &Id| self.all[*id as usize];
        Some(match node {
            Operation::Constant(bits) => Interval::point(f64::from_bits(*bits)),
            Operation::One(row, a) => {
                let (row, a) = (&numeric::TABLE[*row as usize], at(a)?);
                if is_exact(row.name) { (row.bounds)(a, a) } else { widened(slope.value) }
            }
            Operation::Two(row, a, b) => {
                let (row, a, b) = (&numeric::TABLE[*row as usize], at(a)?, at(b)?);
                match row.name {
                    // (The bounds of `mod` are those of a quotient whose rounding is unknown.)
                    "mod" => return None,
                    name if is_exact(name) => (row.bounds)(a, b),
                    _ => widened(slope.value),
                }
            }
            Operation::Binary(op, a, b) => {
                let (left, right) = (at(a)?, at(b)?);
                match op {
                    // (0/0 is NaN, although its bounds are those of 0.)
                    Operator::Div if right.contains(0.0) => return None,
                    Operator::Add | Operator::Sub | Operator::Mul | Operator::Div => widened(slope.value),
                    Operator::And | Operator::Or => logical_bounds(*op, left, right),
                    _ => operator_bounds(*op, left, right, a == b),
                }
            }
            Operation::Choice(condition, yes, no) => match truth(at(condition)?) {
                Some(true) => at(yes)?,
                Some(false) => at(no)?,
                None => at(yes)?.hull(at(no)?),
            },
            Operation::Parameter(_) | Operation::Call(..) => return None,
        })
    }

    /// Returns the bounds of a call, and stores those within a declared function.
    fn of_call(&mut self, callee: &Callee, list: &[Id], slopes: &[Slope], slope: &Slope) -> Option<Interval> {
        let arguments: SmallVec<[Option<Interval>; 10]> = list.iter().map(|id| self.all[*id as usize]).collect();
        if let Some(graph) = declared_graph(callee) {
            let list: SmallVec<[Slope; 10]> = list.iter().map(|id| slopes[*id as usize]).collect();
            let mut inner_slopes = vec![];
            graph.slope_over_box(&list, &mut inner_slopes);
            let inner = Self::new(graph, &arguments, &inner_slopes);
            let result = inner.all[graph.result as usize];
            self.callees.push((self.all.len() as Id, inner));
            return result;
        }
        let is_sure = arguments.iter().all(Option::is_some)
            && match callee {
                Callee::SceneNoise(_) => true,
                // (Bounds of -10 to 10 are those of a clamped polynomial, which may be NaN.)
                Callee::Internal(internal) => {
                    list.len() == 3 + internal.parameters.len() && slope.value != Interval { lo: -10.0, hi: 10.0 }
                }
                // Patterns that may be NaN have no bounds of the gradient.
                Callee::Sampler(_) => {
                    slope.around.is_finite() && slope.by.iter().all(|by| by.lo.is_finite() && by.hi.is_finite())
                }
                Callee::Function(_) | Callee::Series { .. } => false,
            };
        is_sure.then(|| widened(slope.value))
    }

    /// Bounds within the declared function that an operation calls.
    fn within_call(&self, id: Id) -> Option<&OperationBounds> {
        self.callees.binary_search_by_key(&id, |(id, _)| *id).ok().map(|i| &self.callees[i].1)
    }

    /// Returns the replacement of an operation, if its operands decide it. `window` is explained at [`Needs`].
    fn replacement(&self, graph: &Graph, id: Id, window: Interval) -> Option<Replacement> {
        let at = |id: Id| self.all[id as usize];
        let constant = || at(id).filter(|own| own.lo == own.hi).map(|own| own.lo);
        match &graph.nodes[id as usize] {
            Operation::One(row, a) => match numeric::TABLE[*row as usize].name {
                "abs" if at(*a)?.lo > 0.0 => Some(Replacement::Operand(*a)),
                // (A result of 0 may have either sign.)
                "floor" | "ceil" | "int" => {
                    constant().filter(|x| *x != 0.0).map(|x| Replacement::Constant(x.to_bits()))
                }
                _ => None,
            },
            Operation::Two(row, a, b) => {
                let (left, right) = (at(*a)?, at(*b)?);
                let is_dropped = match numeric::TABLE[*row as usize].name {
                    "min" => |x: Interval, other: Interval, window: Interval| x.lo > other.hi.min(window.hi),
                    "max" => |x: Interval, other: Interval, window: Interval| x.hi < other.lo.max(window.lo),
                    _ => return None,
                };
                match () {
                    _ if is_dropped(left, right, window) => Some(Replacement::Operand(*b)),
                    _ if is_dropped(right, left, window) => Some(Replacement::Operand(*a)),
                    _ => None,
                }
            }
            Operation::Binary(Operator::Add | Operator::Sub | Operator::Mul | Operator::Div, ..) => None,
            Operation::Binary(..) => constant().map(|x| Replacement::Constant(x.to_bits())),
            Operation::Choice(condition, yes, no) => {
                truth(at(*condition)?).map(|is_true| Replacement::Operand(if is_true { *yes } else { *no }))
            }
            Operation::Call(callee, 0, _) => {
                let inner = declared_graph(&graph.callees[*callee as usize])?;
                let pruned = Needs::find_replacements(inner, self.within_call(id)?, window);
                (!pruned.is_empty()).then_some(Replacement::PrunedCallee(pruned))
            }
            _ => None,
        }
    }
}

/// Returns the graph of a callee that is a declared function.
fn declared_graph(callee: &Callee) -> Option<&Graph> {
    match callee {
        Callee::Function(function) => match &function.body {
            Body::Numeric(program) => Some(program.graph()),
            Body::Sampled(_) => None,
        },
        _ => None,
    }
}

/// True for numeric functions that are computed without rounding, and whose bounds are therefore not widened.
fn is_exact(name: &str) -> bool {
    matches!(name, "abs" | "floor" | "ceil" | "int" | "min" | "max")
}

fn widened(i: Interval) -> Interval {
    Interval { lo: i.lo - MARGIN * i.lo.abs(), hi: i.hi + MARGIN * i.hi.abs() }
}

/// Returns the truth of a condition with these bounds; `None` if it can be both.
fn truth(condition: Interval) -> Option<bool> {
    match condition {
        c if !c.contains(0.0) => Some(true),
        c if c.lo == 0.0 && c.hi == 0.0 => Some(false),
        _ => None,
    }
}

/// Returns the bounds of a logical operator.
fn logical_bounds(op: Operator, a: Interval, b: Interval) -> Interval {
    let (a, b) = (truth(a), truth(b));
    // Value of an operand that decides the result alone.
    let decisive = op == Operator::Or;
    match () {
        _ if a == Some(decisive) || b == Some(decisive) => Interval::point(f64::from(decisive)),
        _ if a.is_some() && b.is_some() => Interval::point(f64::from(!decisive)),
        _ => Interval::TRUTH,
    }
}

/// Operations that contribute to a pruned result, each with its window.
///
/// Only values inside of the window have to be exact: of smaller values, it only matters that they are smaller than the
/// window, and of larger ones, that they are larger. In `min(min(a, b), c)`, `a` is dropped if it is always larger than
/// `c`, even if it overlaps `b`: the window of the inner minimum ends at the upper bound of `c`. An operation with
/// several uses has the hull of their windows.
struct Needs(Vec<Option<Interval>>);

impl Needs {
    /// Finds the replacements over a box, from the result to its operands; `window` is that of the result.
    fn find_replacements(graph: &Graph, bounds: &OperationBounds, window: Interval) -> Replacements {
        let mut needs = Self(vec![None; graph.nodes.len()]);
        needs.add(graph.result, window);
        let mut found = vec![];
        for id in (0..=graph.result).rev() {
            let Some(window) = needs.0[id as usize] else { continue };
            let replacement = bounds.replacement(graph, id, window);
            match &replacement {
                Some(Replacement::Operand(operand)) => needs.add(*operand, window),
                Some(Replacement::Constant(_)) => {}
                _ => needs.add_operands(&graph.nodes[id as usize], bounds, window),
            }
            found.extend(replacement.map(|replacement| (id, replacement)));
        }
        found.reverse();
        Replacements(found)
    }

    fn add(&mut self, id: Id, window: Interval) {
        // An empty window would ask for values on both sides of it.
        let window = if window.lo <= window.hi { window } else { Interval::ALL };
        let all = &mut self.0[id as usize];
        *all = Some(all.map_or(window, |other| other.hull(window)));
    }

    fn add_operands(&mut self, node: &Operation, bounds: &OperationBounds, window: Interval) {
        match node {
            Operation::Two(row, a, b) => {
                let name = numeric::TABLE[*row as usize].name;
                let both = bounds.all[*a as usize].zip(bounds.all[*b as usize]);
                let narrowed = |other: Interval| match name {
                    "min" => Some(Interval { hi: window.hi.min(other.hi), ..window }),
                    "max" => Some(Interval { lo: window.lo.max(other.lo), ..window }),
                    _ => None,
                };
                let [to_a, to_b] = match both {
                    Some((a, b)) => [narrowed(b), narrowed(a)],
                    None => [None; 2],
                };
                self.add(*a, to_a.unwrap_or(Interval::ALL));
                self.add(*b, to_b.unwrap_or(Interval::ALL));
            }
            Operation::Choice(condition, yes, no) => {
                self.add(*condition, Interval::ALL);
                self.add(*yes, window);
                self.add(*no, window);
            }
            _ => node.for_each_operand(|id| self.add(id, Interval::ALL)),
        }
    }
}

impl Graph {
    /// True if pruning over some box can change the function.
    fn can_be_pruned(&self) -> bool {
        self.nodes.iter().any(|node| match node {
            Operation::One(row, _) => matches!(numeric::TABLE[*row as usize].name, "abs" | "floor" | "ceil" | "int"),
            Operation::Two(row, ..) => matches!(numeric::TABLE[*row as usize].name, "min" | "max"),
            Operation::Binary(op, ..) => !matches!(op, Operator::Add | Operator::Sub | Operator::Mul | Operator::Div),
            Operation::Choice(..) => true,
            Operation::Call(callee, ..) => {
                declared_graph(&self.callees[*callee as usize]).is_some_and(Self::can_be_pruned)
            }
            Operation::Constant(_) | Operation::Parameter(_) => false,
        })
    }

    /// Copies the operations that remain of `other` into this graph, with these operands for its parameters; returns the
    /// index of the result. `None` if a pruned callee cannot be compiled.
    fn inline_pruned(&mut self, other: &Graph, replacements: &Replacements, arguments: &[Id]) -> Option<Id> {
        let mut is_needed = vec![false; other.nodes.len()];
        is_needed[other.result as usize] = true;
        for id in (0..=other.result).rev() {
            if !is_needed[id as usize] {
                continue;
            }
            match replacements.of(id) {
                Some(Replacement::Operand(operand)) => is_needed[*operand as usize] = true,
                Some(Replacement::Constant(_)) => {}
                _ => other.nodes[id as usize].for_each_operand(|id| is_needed[id as usize] = true),
            }
        }
        let mut ids: Vec<Id> = vec![0; other.nodes.len()];
        for (id, node) in (0..=other.result).zip(&other.nodes).filter(|(id, _)| is_needed[*id as usize]) {
            ids[id as usize] = match (replacements.of(id), node) {
                (Some(Replacement::Operand(operand)), _) => ids[*operand as usize],
                (Some(Replacement::Constant(bits)), _) => self.add_operation(Operation::Constant(*bits)),
                (Some(Replacement::PrunedCallee(inner)), Operation::Call(callee, _, list)) => {
                    let list: Vec<Id> = list.iter().map(|id| ids[*id as usize]).collect();
                    self.add_pruned_call(&other.callees[*callee as usize], inner, &list)?
                }
                _ => self.copy_operation(other, node, &ids, arguments),
            };
        }
        Some(ids[other.result as usize])
    }

    /// Adds a call of a declared function that is pruned: inlined if few operations remain.
    fn add_pruned_call(&mut self, callee: &Callee, replacements: &Replacements, arguments: &[Id]) -> Option<Id> {
        let Callee::Function(function) = callee else { return None };
        let pruned = function.pruned(replacements)?;
        if let Body::Numeric(program) = &pruned.body
            && program.graph().nodes.len() <= MAX_INLINED
        {
            return Some(self.inline_graph(program.graph(), arguments));
        }
        Some(self.add_call_component(Callee::Function(Arc::new(pruned)), 0, arguments.into()))
    }
}

impl Function {
    /// Approximate cost of a call, in instructions of compiled functions; 0 for a function that has no graph.
    pub fn cost(&self) -> usize {
        match &self.body {
            Body::Numeric(program) => program.cost(),
            Body::Sampled(_) => 0,
        }
    }

    /// True if pruning over some box can change the function.
    pub fn can_be_pruned(&self) -> bool {
        match &self.body {
            Body::Numeric(program) => program.graph().can_be_pruned(),
            Body::Sampled(_) => false,
        }
    }

    /// Finds the replacements of operations that are valid over a box of the parameters. `slopes` are those of all
    /// operations over the same box, which [`Function::slope_over_box`] leaves in its scratch memory.
    pub fn find_replacements(&self, parameters: &[Interval], slopes: &[Slope]) -> Replacements {
        let Body::Numeric(program) = &self.body else { return Replacements::default() };
        let parameters: SmallVec<[Option<Interval>; 4]> = parameters.iter().map(|i| Some(*i)).collect();
        let bounds = OperationBounds::new(program.graph(), &parameters, slopes);
        Needs::find_replacements(program.graph(), &bounds, Interval::ALL)
    }

    /// Returns the function without the operations that the replacements make superfluous; `None` for a function that
    /// has no graph.
    pub fn pruned(&self, replacements: &Replacements) -> Option<Function> {
        let Body::Numeric(program) = &self.body else { return None };
        let mut graph = Graph::default();
        let parameters: Vec<Id> =
            (0..self.parameters.len()).map(|i| graph.add_operation(Operation::Parameter(i as u16))).collect();
        graph.result = graph.inline_pruned(program.graph(), replacements, &parameters)?;
        graph.forget_known_operations();
        let program = Program::new(graph, self.parameters.len())?;
        Some(Function { parameters: self.parameters.clone(), body: Body::Numeric(program) })
    }
}

#[cfg(test)]
mod tests;
