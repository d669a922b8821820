//! Bounds of a function and of its derivatives over a box: forward-mode differentiation in interval arithmetic (Moore, "Interval Analysis",
//! 1966, chapter 11).

use super::graph::{Callee, Graph, Operation, operator_bounds};
use super::{Body, Function, Interval, LocalBounds, numeric};
use crate::math::{DVec3, fp};
use crate::syntax::ast::Operator;
use smallvec::SmallVec;

const ZERO: Interval = Interval { lo: 0.0, hi: 0.0 };
const ONE: Interval = Interval { lo: 1.0, hi: 1.0 };

/// Bounds of a function's value and gradient over a box of its parameters: each gradient is within a distance of a box
/// of gradients, and jumps have unbounded gradients.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Slope {
    /// Bounds of the function's value.
    pub value: Interval,
    /// Box of gradients: bounds of the derivatives by each of up to three parameters.
    pub by: [Interval; 3],
    /// Maximum distance of the function's gradient from the box `by`.
    pub around: f64,
    /// True if nearly all gradients of the function are far shorter than these bounds.
    pub rough: bool,
}

impl Slope {
    /// Returns the bounds of the constant `x`.
    pub fn of_constant(x: f64) -> Self {
        Self::with_zero_gradient(Interval::point(x))
    }

    /// Returns the slope of the parameter with this index, whose value is in the interval.
    pub fn slope_of_parameter(i: usize, value: Interval) -> Self {
        let mut by = [ZERO; 3];
        if let Some(by) = by.get_mut(i) {
            *by = ONE;
        }
        Self { value, by, around: 0.0, rough: false }
    }

    fn with_zero_gradient(value: Interval) -> Self {
        Self { value, by: [ZERO; 3], around: 0.0, rough: false }
    }

    fn with_unknown_gradient(value: Interval) -> Self {
        Self { value, by: [Interval::ALL; 3], around: 0.0, rough: false }
    }

    /// Returns bounds of the function's derivative along a direction; infinite if unknown.
    pub fn derivative_along(&self, d: DVec3) -> Interval {
        let [x, y, z] = [0, 1, 2].map(|i| interval_product(self.by[i], Interval::point(d[i])));
        let sum = interval_sum(interval_sum(x, y), z);
        let far = self.around * d.length();
        Interval { lo: sum.lo - far, hi: sum.hi + far }
    }

    /// True if the function is constant over the box.
    fn is_constant(&self) -> bool {
        self.by == [ZERO; 3] && self.around == 0.0
    }

    /// Chain rule: returns the slope of a function f(self), whose value and derivative by `self` are in these
    /// intervals.
    fn chain_rule(&self, value: Interval, derivative: Interval) -> Self {
        let most = derivative.lo.abs().max(derivative.hi.abs());
        let around = if self.around == 0.0 { 0.0 } else { self.around * most };
        Self { value, by: self.by.map(|by| interval_product(derivative, by)), around, rough: self.rough }
    }

    fn add_slopes(&self, value: Interval, other: &Self, sign: f64) -> Self {
        let by = |i: usize| interval_sum(self.by[i], if sign < 0.0 { -other.by[i] } else { other.by[i] });
        let rough = self.rough || other.rough;
        Self { value, by: [by(0), by(1), by(2)], around: self.around + other.around, rough }
    }

    /// Chain rule for a function of two arguments: its value and its derivatives by both are in these intervals.
    fn chain_rule_of_two(value: Interval, a: &Self, by_a: Interval, b: &Self, by_b: Interval) -> Self {
        a.chain_rule(value, by_a).add_slopes(value, &b.chain_rule(value, by_b), 1.0)
    }

    fn hull(&self, other: &Self) -> Self {
        let by = |i: usize| self.by[i].hull(other.by[i]);
        let (value, around) = (self.value.hull(other.value), self.around.max(other.around));
        Self { value, by: [by(0), by(1), by(2)], around, rough: self.rough || other.rough }
    }
}

/// Product of two intervals; exactly 0 if one factor is.
fn interval_product(a: Interval, b: Interval) -> Interval {
    if a == ZERO || b == ZERO { ZERO } else { a * b }
}

fn interval_sum(a: Interval, b: Interval) -> Interval {
    match () {
        _ if a == ZERO => b,
        _ if b == ZERO => a,
        _ => a + b,
    }
}

impl Graph {
    /// Returns bounds of the function's result and of its derivatives, from those of its parameters. `scratch` is
    /// scratch memory for those of all operations.
    pub fn slope_over_box(&self, parameters: &[Slope], scratch: &mut Vec<Slope>) -> Slope {
        scratch.clear();
        let mut last = None;
        for node in &self.nodes {
            let slope = self.slope_of_operation(node, parameters, scratch, &mut last);
            scratch.push(slope);
        }
        scratch.get(self.result as usize).copied().unwrap_or(Slope::with_unknown_gradient(Interval::ALL))
    }

    /// Returns the slope of one operation of the graph. `last_call_slopes` has the results of the last call: the next operation
    /// often uses another component of it.
    #[inline]
    fn slope_of_operation<'g>(
        &'g self,
        node: &'g Operation,
        parameters: &[Slope],
        earlier_slopes: &[Slope],
        last_call_slopes: &mut Option<(u32, &'g [u32], [Slope; 5])>,
    ) -> Slope {
        let at = |id: &u32| &earlier_slopes[*id as usize];
        match node {
            Operation::Constant(bits) => Slope::of_constant(f64::from_bits(*bits)),
            Operation::Parameter(i) => parameters[*i as usize],
            Operation::One(row, a) => unary_slope(&numeric::TABLE[*row as usize], at(a)),
            Operation::Two(row, a, b) => binary_slope(&numeric::TABLE[*row as usize], at(a), at(b)),
            Operation::Binary(op, a, b) => operator_slope(*op, at(a), at(b), a == b),
            Operation::Choice(condition, yes, no) => match at(condition).value {
                c if !c.contains(0.0) => *at(yes),
                c if c.lo == 0.0 && c.hi == 0.0 => *at(no),
                _ => at(yes).hull(at(no)),
            },
            Operation::Call(callee, component, list) => {
                let slopes = match last_call_slopes {
                    Some((other, same, slopes)) if other == callee && *same == &**list => slopes,
                    _ => {
                        let slopes: SmallVec<[&Slope; 10]> = list.iter().map(at).collect();
                        let slopes = call_slopes(&self.callees[*callee as usize], &slopes);
                        &last_call_slopes.insert((*callee, list, slopes)).2
                    }
                };
                slopes[*component as usize]
            }
        }
    }
}

impl Function {
    /// Returns bounds of the function's number and of its derivatives, over a box of its parameters. `scratch` is
    /// scratch memory.
    pub fn slope_over_box(&self, parameters: &[Interval], scratch: &mut Vec<Slope>) -> Slope {
        let list: SmallVec<[Slope; 4]> =
            parameters.iter().enumerate().map(|(i, &value)| Slope::slope_of_parameter(i, value)).collect();
        match &self.body {
            Body::Numeric(program) => program.graph().slope_over_box(&list, scratch),
            Body::Sampled(sampler) => {
                let list: SmallVec<[&Slope; 4]> = list.iter().collect();
                call_slopes(&Callee::Sampler(sampler.clone()), &list)[0]
            }
        }
    }
}

fn operator_slope(op: Operator, a: &Slope, b: &Slope, same_operand: bool) -> Slope {
    let value = operator_bounds(op, a.value, b.value, same_operand);
    match op {
        Operator::Add => a.add_slopes(value, b, 1.0),
        Operator::Sub if same_operand => Slope::of_constant(0.0),
        Operator::Sub => a.add_slopes(value, b, -1.0),
        Operator::Mul if same_operand => a.chain_rule(value, a.value + a.value),
        Operator::Mul => Slope::chain_rule_of_two(value, a, b.value, b, a.value),
        Operator::Div if b.is_constant() => a.chain_rule(value, b.value.recip()),
        // (a/b)' = (a' - (a/b)·b') / b
        Operator::Div => {
            Slope::chain_rule_of_two(value, a, b.value.recip(), b, -interval_product(value, b.value.recip()))
        }
        _ => Slope::with_zero_gradient(value),
    }
}

/// Slope of a built-in function of one argument, from its derivative over an interval.
fn unary_slope(row: &numeric::Numeric, a: &Slope) -> Slope {
    let value = (row.bounds)(a.value, a.value);
    if a.is_constant() {
        return Slope::with_zero_gradient(value);
    }
    let x = a.value;
    let derivative = match row.name {
        "abs" if x.lo >= 0.0 => ONE,
        "abs" if x.hi <= 0.0 => -ONE,
        "abs" => Interval { lo: -1.0, hi: 1.0 },
        "sin" => x.cos(),
        "cos" => -x.sin(),
        "exp" => value,
        "ln" if x.lo > 0.0 => x.recip(),
        "log" if x.lo > 0.0 => x.recip() * Interval::point(std::f64::consts::LOG10_E),
        "sqrt" if x.lo > 0.0 => Interval::point(0.5) * value.recip(),
        // (Unbounded slope at 0.)
        "sqrt" if x.hi > 0.0 => Interval { lo: 0.5 / x.hi.sqrt(), hi: f64::INFINITY }.widened_by_rounding(),
        "sinh" => (numeric_bounds("cosh"))(x, x),
        "cosh" => (numeric_bounds("sinh"))(x, x),
        "tanh" => ONE + -value.square(),
        "atan" => (ONE + x.square()).recip(),
        "asinh" => (ONE + x.square()).map_increasing(f64::sqrt).recip(),
        "degrees" => Interval::point(1f64.to_degrees()),
        "radians" => Interval::point(1f64.to_radians()),
        // (A step inside the interval is a jump.)
        "floor" | "ceil" | "int" if value.lo == value.hi => ZERO,
        _ => Interval::ALL,
    };
    a.chain_rule(value, derivative)
}

fn numeric_bounds(name: &str) -> fn(Interval, Interval) -> Interval {
    numeric::find_numeric(name).map_or(|_, _| Interval::ALL, |row| numeric::TABLE[row as usize].bounds)
}

/// Slope of a built-in function of two arguments.
fn binary_slope(row: &numeric::Numeric, a: &Slope, b: &Slope) -> Slope {
    let value = (row.bounds)(a.value, b.value);
    if a.is_constant() && b.is_constant() {
        return Slope::with_zero_gradient(value);
    }
    let (x, y) = (a.value, b.value);
    match row.name {
        "max" if x.lo >= y.hi => *a,
        "max" if y.lo >= x.hi => *b,
        "min" if x.hi <= y.lo => *a,
        "min" if y.hi <= x.lo => *b,
        "max" | "min" => Slope { value, ..a.hull(b) },
        "pow" if b.is_constant() && y.lo == y.hi => {
            let less = Interval::point(y.lo - 1.0);
            let power = if y.lo == 1.0 { ONE } else { (row.bounds)(x, less) };
            a.chain_rule(value, interval_product(y, power))
        }
        // The angle of (y, x) changes by (y·dx - x·dy)/(x² + y²). Where it jumps by a full turn, most results that use
        // it do not.
        "atan2" => {
            let over = (x.square() + y.square()).recip();
            Slope::chain_rule_of_two(atan2_bounds(x, y), a, interval_product(y, over), b, -interval_product(x, over))
        }
        "mod" if b.is_constant() && y.lo == y.hi && y.lo != 0.0 => {
            let turns = [(x.lo / y.lo).trunc(), (x.hi / y.lo).trunc()];
            let one_turn = turns[0] == turns[1] && (x.lo >= 0.0) == (x.hi >= 0.0);
            let size = y.lo.abs();
            if one_turn {
                Slope { value: x + Interval::point(-turns[0] * y.lo), ..*a }
            } else {
                Slope::with_unknown_gradient(Interval {
                    lo: if x.lo < 0.0 { -size } else { 0.0 },
                    hi: if x.hi > 0.0 { size } else { 0.0 },
                })
            }
        }
        _ => Slope::with_unknown_gradient(value),
    }
}

/// Bounds of atan2 over a box of y and x.
fn atan2_bounds(y: Interval, x: Interval) -> Interval {
    if y.contains(0.0) && x.lo <= 0.0 {
        return Interval::new(-3.2, 3.2);
    }
    let corners = [(y.lo, x.lo), (y.lo, x.hi), (y.hi, x.lo), (y.hi, x.hi)];
    let all = corners.map(|(y, x)| Interval::point(fp::atan2(y, x)));
    all.into_iter().reduce(Interval::hull).unwrap_or(Interval::ALL).widened_by_rounding()
}

/// Slopes of all components of a call.
fn call_slopes(callee: &Callee, list: &[&Slope]) -> [Slope; 5] {
    if let Callee::Function(function) = callee
        && let Body::Numeric(program) = &function.body
    {
        let list: SmallVec<[Slope; 10]> = list.iter().copied().copied().collect();
        return [program.graph().slope_over_box(&list, &mut vec![]); 5];
    }
    let values: SmallVec<[Interval; 10]> = list.iter().map(|slope| slope.value).collect();
    let bounds = |component: usize| callee.bounds(component, &values);
    let each = |slope: &dyn Fn(usize) -> Slope| match callee.gives_number() {
        true => [slope(0); 5],
        false => [0, 1, 2, 3, 4].map(slope),
    };
    if let [a, b, c, rest @ ..] = list
        && rest.iter().all(|slope| slope.value.lo == slope.value.hi)
    {
        let middle: SmallVec<[f64; 10]> = values.iter().map(|i| 0.5 * (i.lo + i.hi)).collect();
        let radius = values[..3].iter().map(|i| (0.5 * (i.hi - i.lo)).powi(2)).sum::<f64>().sqrt();
        let near = callee.value_bounds_near(&middle, radius);
        let (rough, longest) = ([a, b, c].iter().any(|slope| slope.rough), max_lengthening_factor([a, b, c]));
        return each(&|component| {
            let LocalBounds { range, gradient, steepest, rough: uneven } = near[component];
            let value = range.intersection_or_self(bounds(component));
            let around = if steepest == 0.0 { 0.0 } else { steepest * longest };
            if !around.is_finite() {
                return Slope::with_unknown_gradient(value);
            }
            let at_middle = [a, b, c].into_iter().zip(gradient.to_array());
            let sum = at_middle.fold(Slope::with_zero_gradient(value), |sum, (slope, by)| {
                if by == 0.0 { sum } else { sum.add_slopes(value, &slope.chain_rule(value, Interval::point(by)), 1.0) }
            });
            Slope { around: sum.around + around, rough: rough || uneven, ..sum }
        });
    }
    let is_flat = list.iter().all(|slope| slope.is_constant());
    each(&|component| {
        if is_flat {
            Slope::with_zero_gradient(bounds(component))
        } else {
            Slope::with_unknown_gradient(bounds(component))
        }
    })
}

/// Returns an upper bound of the length of a change of three coordinates, relative to the length of the change of the
/// function's parameters that causes it.
fn max_lengthening_factor(numbers: [&Slope; 3]) -> f64 {
    let size = |i: &Interval| i.lo.abs().max(i.hi.abs());
    let turns = numbers.iter().map(|n| n.around * n.around).sum::<f64>().sqrt();
    let alone = |(i, n): (usize, &&Slope)| (0..3).all(|k| k == i || n.by[k] == ZERO);
    let by = numbers.iter().enumerate().map(|(i, n)| size(&n.by[i]));
    if numbers.iter().enumerate().all(alone) {
        // Each parameter affects only its own number: the largest factor counts.
        return by.fold(0.0, f64::max) + turns;
    }
    let all = numbers.iter().flat_map(|n| n.by.iter().map(|by| size(by).powi(2)));
    all.sum::<f64>().sqrt() + turns
}

#[cfg(test)]
mod tests;
