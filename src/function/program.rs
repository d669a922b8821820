//! Bytecode: the operations of a [`Graph`] in an order in which they can be evaluated, each into a register of its own.

use super::graph::{self, Callee, Graph, Id, Operation};
use super::internal::PointFunction;
use super::numeric::{self, Kernel};
use crate::math::DVec3;
use crate::syntax::ast::Operator;
use smallvec::SmallVec;
use std::sync::Arc;

/// Index of a register of a compiled function: first the parameters, then the constants, then results.
type Register = u16;

/// An instruction of a compiled function.
#[derive(Clone, Copy, Debug)]
enum Step {
    Add(Register, Register, Register),
    Sub(Register, Register, Register),
    Mul(Register, Register, Register),
    Div(Register, Register, Register),
    /// Instruction that applies an operator without an instruction of its own.
    Binary(Operator, Register, Register, Register),
    One(fn(f64) -> f64, Register, Register),
    Two(fn(f64, f64) -> f64, Register, Register, Register),
    Copy(Register, Register),
    /// Instruction that jumps to this position if the register is 0.
    SkipIfZero(Register, u32),
    Skip(u32),
    /// Instruction that calls a function: index of the callee, component, position and number of the arguments'
    /// registers in [`Program::arguments`], register of the result.
    Call(u32, u8, u32, u16, Register),
    /// Instruction that calls a prepared function: its index in [`Program::prepared`], registers of x, y and z, register
    /// of the result.
    CallPrepared(u16, [Register; 3], Register),
    /// Instruction that calls a function and stores all its components in five registers.
    CallAll(u32, u32, u16, Register),
}

/// A function compiled to instructions on registers.
#[derive(Clone, Debug)]
pub struct Program {
    graph: Graph,
    steps: Vec<Step>,
    constants: Vec<f64>,
    arguments: Vec<Register>,
    /// Internal functions whose parameters after x, y and z are constants.
    prepared: Vec<Arc<dyn PointFunction>>,
    parameters: usize,
    registers: usize,
    result: Register,
    /// Initial values of the first registers of a compiled function, including the constants.
    start: Box<[f64; FEW]>,
}

/// Number of registers that suffices for most compiled functions.
const FEW: usize = 24;
/// Number of registers that suffices for larger compiled functions.
const SOME: usize = 64;
/// Maximum number of registers of a compiled function without allocation of memory.
const MANY: usize = 256;
/// Maximum number of arguments of a call that needs no allocation.
const FEW_ARGUMENTS: usize = 12;
/// Number of operations after one that are searched for other components of the same call.
const NEAR: usize = 24;
/// Maximum number of operations of a compiled function, since register indices have 16 bits.
const MAX_OPERATIONS: usize = 60_000;

/// Approximate cost of calling an internal function or a pattern, in instructions.
const CALL_COST: usize = 20;

/// Compiler of a function's graph to instructions.
struct Writer<'g> {
    graph: &'g Graph,
    steps: Vec<Step>,
    constants: Vec<f64>,
    arguments: Vec<Register>,
    prepared: Vec<Arc<dyn PointFunction>>,
    /// Register of each operation's result that is already evaluated at the current position of the program.
    places: Vec<Option<Register>>,
    next: usize,
}

impl Program {
    /// Compiles a function's graph; `None` if it has more than 60 000 operations.
    pub fn new(graph: Graph, parameter_count: usize) -> Option<Self> {
        if graph.nodes.len() + parameter_count > MAX_OPERATIONS {
            return None;
        }
        let mut places = vec![None; graph.nodes.len()];
        let mut constants = vec![];
        for (place, node) in places.iter_mut().zip(&graph.nodes) {
            if let Operation::Constant(bits) = node {
                *place = Some((parameter_count + constants.len()) as Register);
                constants.push(f64::from_bits(*bits));
            }
        }
        let next = parameter_count + constants.len();
        let mut writer =
            Writer { graph: &graph, steps: vec![], constants, arguments: vec![], prepared: vec![], places, next };
        let result = writer.emit_operation(graph.result);
        let Writer { steps, constants, arguments, prepared, next, .. } = writer;
        let mut start = [0.0; FEW];
        start.iter_mut().skip(parameter_count).zip(&constants).for_each(|(to, constant)| *to = *constant);
        (next <= usize::from(Register::MAX)).then_some(Self {
            steps,
            constants,
            arguments,
            prepared,
            parameters: parameter_count,
            registers: next,
            result,
            graph,
            start: start.into(),
        })
    }

    /// Graph from which the function was compiled.
    pub fn graph(&self) -> &Graph {
        &self.graph
    }

    /// Approximate cost of a run, in instructions; branches count as if all were taken.
    pub fn cost(&self) -> usize {
        let of_callee = |callee: u32| match &self.graph.callees[callee as usize] {
            Callee::Function(function) => match &function.body {
                super::Body::Numeric(program) => program.cost(),
                super::Body::Sampled(_) => CALL_COST,
            },
            _ => CALL_COST,
        };
        let of_step = |step: &Step| match step {
            Step::Call(callee, ..) | Step::CallAll(callee, ..) => of_callee(*callee) + 2,
            Step::CallPrepared(..) => CALL_COST,
            _ => 1,
        };
        self.steps.iter().map(of_step).sum()
    }

    /// Runs the compiled function for these parameters.
    pub fn run(&self, parameters: &[f64]) -> f64 {
        // (A short program would spend most of its time clearing registers, and on copies whose lengths the compiler
        // does not know.)
        let all = self.registers;
        if all <= FEW {
            let mut r = *self.start;
            match (self.parameters, parameters) {
                (3, &[x, y, z, ..]) => [r[0], r[1], r[2]] = [x, y, z],
                (n, all) => r[..n].copy_from_slice(&all[..n]),
            }
            return self.run_in_registers(&mut r);
        }
        match () {
            _ if all <= SOME => self.run_in_registers(self.registers_with_inputs(&mut [0.0; SOME], parameters)),
            _ if all <= MANY => self.run_in_registers(self.registers_with_inputs(&mut [0.0; MANY], parameters)),
            _ => self.run_in_registers(self.registers_with_inputs(&mut vec![0.0; all], parameters)),
        }
    }

    /// Stores the arguments and the constants in the first registers, and returns all registers.
    fn registers_with_inputs<'r>(&self, registers: &'r mut [f64], arguments: &[f64]) -> &'r mut [f64] {
        registers[..self.parameters].copy_from_slice(&arguments[..self.parameters]);
        registers[self.parameters..self.parameters + self.constants.len()].copy_from_slice(&self.constants);
        registers
    }

    fn run_in_registers(&self, r: &mut [f64]) -> f64 {
        let mut at = 0;
        while let Some(step) = self.steps.get(at) {
            at += 1;
            match *step {
                Step::Add(to, a, b) => r[to as usize] = r[a as usize] + r[b as usize],
                Step::Sub(to, a, b) => r[to as usize] = r[a as usize] - r[b as usize],
                Step::Mul(to, a, b) => r[to as usize] = r[a as usize] * r[b as usize],
                Step::Div(to, a, b) => r[to as usize] = r[a as usize] / r[b as usize],
                Step::Binary(op, to, a, b) => r[to as usize] = graph::apply_operator(op, r[a as usize], r[b as usize]),
                Step::One(f, to, a) => r[to as usize] = f(r[a as usize]),
                Step::Two(f, to, a, b) => r[to as usize] = f(r[a as usize], r[b as usize]),
                Step::Copy(to, a) => r[to as usize] = r[a as usize],
                Step::SkipIfZero(a, target) if r[a as usize] == 0.0 => at = target as usize,
                Step::SkipIfZero(..) => {}
                Step::Skip(target) => at = target as usize,
                Step::Call(callee, component, list, count, to) => {
                    let callee = &self.graph.callees[callee as usize];
                    r[to as usize] =
                        self.with_arguments(list, count, r, |list| callee.call_component(component as usize, list));
                }
                Step::CallPrepared(function, [x, y, z], to) => {
                    let p = DVec3::new(r[x as usize], r[y as usize], r[z as usize]);
                    r[to as usize] = self.prepared[function as usize].value_at(p);
                }
                Step::CallAll(callee, list, count, to) => {
                    let callee = &self.graph.callees[callee as usize];
                    let all = self.with_arguments(list, count, r, |list| callee.call_all(list));
                    r[to as usize..][..5].copy_from_slice(&all);
                }
            }
        }
        r[self.result as usize]
    }

    fn with_arguments<T>(&self, first_argument: u32, count: u16, r: &[f64], call: impl FnOnce(&[f64]) -> T) -> T {
        let list = &self.arguments[first_argument as usize..][..count as usize];
        if let &[x, y, z] = list {
            return call(&[r[x as usize], r[y as usize], r[z as usize]]);
        }
        if list.len() > FEW_ARGUMENTS {
            let all: Vec<f64> = list.iter().map(|&i| r[i as usize]).collect();
            return call(&all);
        }
        let mut few = [0.0; FEW_ARGUMENTS];
        for (to, &i) in few.iter_mut().zip(list) {
            *to = r[i as usize];
        }
        call(&few[..list.len()])
    }
}

impl Writer<'_> {
    /// Emits the instructions that evaluate an operation, unless its result is available; returns its register.
    fn emit_operation(&mut self, id: Id) -> Register {
        if let Some(place) = self.places[id as usize] {
            return place;
        }
        let graph = self.graph;
        let place = match &graph.nodes[id as usize] {
            Operation::Parameter(i) => *i,
            Operation::Constant(_) => 0,
            Operation::One(row, a) => {
                let a = self.emit_operation(*a);
                let to = self.new_register();
                let f = match numeric::TABLE[*row as usize].kernel {
                    Kernel::One(f) => f,
                    _ => |x| x,
                };
                self.steps.push(Step::One(f, to, a));
                to
            }
            Operation::Two(row, a, b) => {
                let (a, b) = (self.emit_operation(*a), self.emit_operation(*b));
                let to = self.new_register();
                let f = match numeric::TABLE[*row as usize].kernel {
                    Kernel::Two(f) | Kernel::Many(f) => f,
                    Kernel::One(_) => |x, _| x,
                };
                self.steps.push(Step::Two(f, to, a, b));
                to
            }
            Operation::Binary(op, a, b) => {
                let (a, b) = (self.emit_operation(*a), self.emit_operation(*b));
                let to = self.new_register();
                self.steps.push(match op {
                    Operator::Add => Step::Add(to, a, b),
                    Operator::Sub => Step::Sub(to, a, b),
                    Operator::Mul => Step::Mul(to, a, b),
                    Operator::Div => Step::Div(to, a, b),
                    op => Step::Binary(*op, to, a, b),
                });
                to
            }
            Operation::Choice(condition, yes, no) => self.emit_conditional(*condition, *yes, *no),
            Operation::Call(callee, _, list) if let Some(function) = self.prepare_call(*callee, list) => {
                let point = [list[0], list[1], list[2]].map(|id| self.emit_operation(id));
                let to = self.new_register();
                self.steps.push(Step::CallPrepared(self.prepared.len() as u16, point, to));
                self.prepared.push(function);
                to
            }
            Operation::Call(callee, component, list) => {
                let registers: Vec<Register> = list.iter().map(|id| self.emit_operation(*id)).collect();
                let start = self.arguments.len() as u32;
                let count = registers.len() as u16;
                self.arguments.extend(registers);
                let siblings = self.operations_of_same_call(id, *callee, list);
                let to = self.new_register();
                if siblings.len() == 1 {
                    self.steps.push(Step::Call(*callee, *component, start, count, to));
                    to
                } else {
                    self.next += 4;
                    self.steps.push(Step::CallAll(*callee, start, count, to));
                    for (sibling, component) in siblings {
                        self.places[sibling] = Some(to + Register::from(component));
                    }
                    to + Register::from(*component)
                }
            }
        };
        self.places[id as usize] = Some(place);
        place
    }

    /// Prepares an internal function whose parameters after x, y and z are constants, if it can be prepared.
    fn prepare_call(&self, callee: u32, list: &[Id]) -> Option<Arc<dyn PointFunction>> {
        let Callee::Internal(internal) = &self.graph.callees[callee as usize] else { return None };
        let parameters: Option<Vec<f64>> = list.get(3..)?.iter().map(|id| self.graph.constant_value(*id)).collect();
        internal.prepare?(&parameters?)
    }

    /// Finds, among this operation and the next few, those that use components of the same call; returns their indices
    /// and components.
    fn operations_of_same_call(&self, id: Id, callee: u32, list: &[Id]) -> SmallVec<[(usize, u8); 5]> {
        let is_one = |(i, node): (usize, &Operation)| match node {
            Operation::Call(other, component, same) if *other == callee && **same == *list => Some((i, *component)),
            _ => None,
        };
        self.graph.nodes.iter().enumerate().skip(id as usize).take(NEAR).filter_map(is_one).collect()
    }

    /// Emits a conditional. Operations that only one branch needs are evaluated in that branch, and are unknown after
    /// it.
    fn emit_conditional(&mut self, condition: Id, yes: Id, no: Id) -> Register {
        let condition = self.emit_operation(condition);
        let to = self.new_register();
        let before = self.places.clone();
        let branch = self.steps.len();
        self.steps.push(Step::SkipIfZero(condition, 0));
        let value = self.emit_operation(yes);
        self.steps.push(Step::Copy(to, value));
        let end = self.steps.len();
        self.steps.push(Step::Skip(0));
        self.steps[branch] = Step::SkipIfZero(condition, self.steps.len() as u32);
        self.places.clone_from(&before);
        let value = self.emit_operation(no);
        self.steps.push(Step::Copy(to, value));
        self.steps[end] = Step::Skip(self.steps.len() as u32);
        self.places = before;
        to
    }

    fn new_register(&mut self) -> Register {
        self.next += 1;
        (self.next - 1) as Register
    }
}

/// Evaluates a function's graph recursively, without bytecode: the reference for tests.
#[cfg(test)]
pub(super) fn evaluate_recursively(graph: &Graph, parameters: &[f64]) -> f64 {
    fn value_of_operation(graph: &Graph, id: Id, p: &[f64]) -> f64 {
        let at = |id: &Id| value_of_operation(graph, *id, p);
        match &graph.nodes[id as usize] {
            Operation::Constant(bits) => f64::from_bits(*bits),
            Operation::Parameter(i) => p[*i as usize],
            Operation::One(row, a) => graph::call_unary(*row, at(a)),
            Operation::Two(row, a, b) => graph::call_binary(*row, at(a), at(b)),
            Operation::Binary(op, a, b) => graph::apply_operator(*op, at(a), at(b)),
            Operation::Choice(c, yes, no) => at(if at(c) != 0.0 { yes } else { no }),
            Operation::Call(callee, component, list) => {
                let list: Vec<f64> = list.iter().map(at).collect();
                graph.callees[*callee as usize].call_component(*component as usize, &list)
            }
        }
    }
    value_of_operation(graph, graph.result, parameters)
}

#[cfg(test)]
pub(super) mod tests {
    use super::*;
    use crate::function::Interval;
    use crate::function::internal::find_internal;
    use proptest::prelude::*;

    /// Description of one operation: its type, and its operands.
    pub type Recipe = Vec<(u8, u32, u32, u32, f64)>;

    /// A graph of operations that mostly give finite numbers, in any order.
    pub fn recipe_graph(recipe: &Recipe) -> Graph {
        let mut graph = Graph::default();
        let mut ids: Vec<Id> = (0..3).map(|i| graph.add_operation(Operation::Parameter(i))).collect();
        let rows = ["abs", "sin", "cos", "exp", "sqrt", "floor", "max", "min", "pow", "tanh"];
        for &(kind, a, b, c, x) in recipe {
            let pick = |i: u32| ids[i as usize % ids.len()];
            let (a, b, c) = (pick(a), pick(b), pick(c));
            use Operator::*;
            let id = match kind % 24 {
                0 => graph.add_constant(x),
                1 => graph.add_operation(Operation::Choice(a, b, c)),
                k @ 2..=13 => {
                    let op = [Add, Sub, Mul, Div, Less, LessEqual, Greater, GreaterEqual, Equal, NotEqual, And, Or];
                    graph.add_operation(Operation::Binary(op[k as usize - 2], a, b))
                }
                k => {
                    let row = numeric::find_numeric(rows[k as usize - 14]).unwrap();
                    match numeric::TABLE[row as usize].kernel {
                        Kernel::One(_) => graph.add_operation(Operation::One(row, a)),
                        _ => graph.add_operation(Operation::Two(row, a, b)),
                    }
                }
            };
            ids.push(id);
        }
        graph.result = ids[ids.len() - 1];
        graph
    }

    pub fn recipe() -> impl Strategy<Value = Recipe> {
        prop::collection::vec((any::<u8>(), any::<u32>(), any::<u32>(), any::<u32>(), -3.0..3.0), 1..30)
    }

    proptest! {
        #[test]
        fn bytecode_matches_the_graph(recipe in recipe(), p in prop::array::uniform3(-2.0..2.0)) {
            let graph = recipe_graph(&recipe);
            let wanted = evaluate_recursively(&graph, &p);
            let found = Program::new(graph, 3).unwrap().run(&p);
            prop_assert!(wanted.to_bits() == found.to_bits() || wanted.is_nan() && found.is_nan());
        }

        #[test]
        fn values_are_in_bounds(
            recipe in recipe(),
            corner in prop::array::uniform3(-2.0..2.0),
            size in prop::array::uniform3(0.0..1.0),
            inner in prop::array::uniform3(0.0..1.0),
        ) {
            let graph = recipe_graph(&recipe);
            let boxes = [0, 1, 2].map(|i| Interval::new(corner[i], corner[i] + size[i]));
            let p = [0, 1, 2].map(|i: usize| f64::min(corner[i] + inner[i] * size[i], boxes[i].hi));
            let value = evaluate_recursively(&graph, &p);
            let bounds = graph.bounds(&boxes);
            let mut part = graph.clone();
            let mut at = |id| {
                part.result = id;
                evaluate_recursively(&part, &p)
            };
            let no_number = (0..graph.nodes.len() as Id).any(|id| at(id).is_nan());
            prop_assert!(no_number || bounds.contains(value), "{value} is not in {bounds:?}");
        }
    }

    #[test]
    fn prepared_calls_match_the_graph() {
        for (number, h) in [(29, 0.3), (59, 0.07), (58, 0.4)] {
            let mut g = Graph::default();
            let point = [2, 0, 1].map(|i| g.add_operation(Operation::Parameter(i)));
            let constants = [h, 2.2, 4.5, 0.6, 0.9, 1.0].map(|x| g.add_constant(x));
            let callee = Callee::Internal(find_internal(number).unwrap());
            g.result = g.add_call_component(callee, 0, point.into_iter().chain(constants).collect());
            let wanted = evaluate_recursively(&g, &[0.7, -1.3, 5.2]);
            let program = Program::new(g, 3).unwrap();
            assert_eq!(program.prepared.len(), usize::from(number != 58), "{number}");
            assert_eq!(program.run(&[0.7, -1.3, 5.2]), wanted, "{number}");
        }
    }

    #[test]
    fn unchosen_branches_are_skipped_and_shared_results_reused() {
        // x < 0 ? x·y : (x·y)² − x·y, and then + x·y
        let mut g = Graph::default();
        let (x, y) = (g.add_operation(Operation::Parameter(0)), g.add_operation(Operation::Parameter(1)));
        let zero = g.add_constant(0.0);
        let below = g.add_operation(Operation::Binary(Operator::Less, x, zero));
        let product = g.add_operation(Operation::Binary(Operator::Mul, x, y));
        let square = g.add_operation(Operation::Binary(Operator::Mul, product, product));
        let rest = g.add_operation(Operation::Binary(Operator::Sub, square, product));
        let choice = g.add_operation(Operation::Choice(below, product, rest));
        g.result = g.add_operation(Operation::Binary(Operator::Add, choice, product));
        let program = Program::new(g, 2).unwrap();
        assert_eq!(program.run(&[-2.0, 3.0]), -12.0);
        assert_eq!(program.run(&[2.0, 3.0]), 36.0);
    }
}
