//! Fast evaluation of expressions of numbers and vectors, without side effects and messages, which are the most common.

use super::operators::{TOLERANCE, apply_to_floats, apply_to_vectors, component_index, has_zero_component};
use super::{Contents, Evaluator};
use crate::function::numeric::{self, Domain, Kernel, Numeric};
use crate::syntax::ast::*;
use crate::syntax::word::{Word, WordTable};
use crate::value::{Value, VecN};
use std::sync::LazyLock;

/// Numeric built-in functions by word.
static NUMERIC: LazyLock<WordTable<&'static Numeric>> =
    LazyLock::new(|| WordTable::new(numeric::TABLE.iter().map(|row| (row.name, row))));

/// Value of an expression without heap allocation, for fast evaluation.
pub enum Quick {
    Float(f64),
    Vector(VecN),
}

/// Result type of the fast evaluation: a number alone, which is fastest, or a number or vector.
pub trait QuickValue: Sized {
    /// True if the fast evaluation can give vectors; false if it gives numbers alone.
    const VECTORS: bool;
    fn float(x: f64) -> Self;
    fn vector(v: VecN) -> Option<Self>;
    /// Applies a binary operator; `None` where [`super::combine`] reports a message.
    fn combined(self, op: Operator, right: Self) -> Option<Self>;
    fn prefixed(self, prefix: Prefix) -> Option<Self>;

    /// Converts a number or vector of the scene; `None` for other values.
    fn from_value(value: &Value) -> Option<Self> {
        match value {
            Value::Float(x) => Some(Self::float(*x)),
            Value::Vector(v) => Self::vector(*v),
            _ => None,
        }
    }
}

impl QuickValue for f64 {
    const VECTORS: bool = false;

    fn float(x: f64) -> Self {
        x
    }

    fn vector(_: VecN) -> Option<Self> {
        None
    }

    fn combined(self, op: Operator, right: f64) -> Option<Self> {
        let warns = op == Operator::Div && right == 0.0;
        if warns { None } else { Some(apply_to_floats(op, self, right)) }
    }

    fn prefixed(self, prefix: Prefix) -> Option<Self> {
        Some(match prefix {
            Prefix::Minus => -self,
            Prefix::Plus => self,
            Prefix::Not => f64::from(self.abs() <= TOLERANCE),
        })
    }
}

impl QuickValue for Quick {
    const VECTORS: bool = true;

    fn float(x: f64) -> Self {
        Quick::Float(x)
    }

    fn vector(v: VecN) -> Option<Self> {
        Some(Quick::Vector(v))
    }

    fn combined(self, op: Operator, right: Quick) -> Option<Self> {
        let (a, b) = match (self, right) {
            (Quick::Float(a), Quick::Float(b)) => return a.combined(op, b).map(Quick::Float),
            _ if !op.is_multiplication_or_division() && !op.is_addition_or_subtraction() => return None,
            (Quick::Float(x), Quick::Vector(b)) => (VecN::splat(x, b.len), b),
            (Quick::Vector(a), Quick::Float(x)) => (a, VecN::splat(x, a.len)),
            (Quick::Vector(a), Quick::Vector(b)) => (a, b),
        };
        let warns = op == Operator::Div && has_zero_component(&b);
        if warns { None } else { Some(Quick::Vector(apply_to_vectors(op, a, b))) }
    }

    fn prefixed(self, prefix: Prefix) -> Option<Self> {
        match self {
            Quick::Float(x) => x.prefixed(prefix).map(Quick::Float),
            Quick::Vector(_) => None,
        }
    }
}

impl Evaluator<'_> {
    /// Evaluates an expression to a number; `None` if the general evaluation is needed.
    pub fn quick_number(&self, e: &Expr) -> Option<f64> {
        self.quick(e)
    }

    /// Evaluates an expression of numbers and vectors; `None` if the general evaluation is needed.
    pub fn quick<T: QuickValue>(&self, e: &Expr) -> Option<T> {
        match &e.kind {
            ExprKind::Number(x) => Some(T::float(*x)),
            ExprKind::Literal(data) if (2..=5).contains(&data.len()) => T::vector(VecN::from_slice(data)),
            ExprKind::Vector(parts) if T::VECTORS => self.quick_vector(parts),
            ExprKind::Paren(inner) => self.quick(inner),
            ExprKind::Name(symbol) => match self.scopes.get(*symbol) {
                Some(Contents::Value(value)) if self.deprecated.is_empty() => T::from_value(value),
                None => T::from_value(self.constants.fixed_value(*symbol)?),
                _ => None,
            },
            ExprKind::Prefix(prefix, inner) => self.quick::<T>(inner)?.prefixed(*prefix),
            ExprKind::Chain(chain) => {
                let first: T = self.quick(&chain.first)?;
                chain.rest.iter().try_fold(first, |left, (op, operand)| left.combined(*op, self.quick(operand)?))
            }
            ExprKind::Choice(parts) => {
                let [condition, yes, no] = &**parts;
                let (condition, yes, no) = (self.quick_number(condition)?, self.quick(yes)?, self.quick(no)?);
                Some(if condition.abs() > TOLERANCE { yes } else { no })
            }
            ExprKind::Builtin(name, arguments) => self.quick_call(name, arguments).map(T::float),
            ExprKind::Index(array, indices) => match &**indices {
                [index] => self.quick_element(array, index),
                _ => None,
            },
            ExprKind::Dot(base, name, _) => self.quick_component(base, name).map(T::float),
            _ => None,
        }
    }

    fn quick_vector<T: QuickValue>(&self, parts: &[Element]) -> Option<T> {
        if !(2..=5).contains(&parts.len()) {
            return None;
        }
        let mut out = VecN { c: [0.0; 5], len: parts.len() as u8 };
        for (slot, part) in out.c.iter_mut().zip(parts) {
            match &part.kind {
                ElementKind::Expr(e) => *slot = self.quick_number(e)?,
                _ => return None,
            }
        }
        T::vector(out)
    }

    /// Evaluates a component of a declared vector, such as `V.x`; `None` for other values, such as dictionaries.
    fn quick_component(&self, base: &Expr, name: &Name) -> Option<f64> {
        let ExprKind::Name(symbol) = base.kind else { return None };
        match self.scopes.get(symbol)? {
            Contents::Value(Value::Vector(v)) if self.deprecated.is_empty() => {
                component_index(name).filter(|i| *i < usize::from(v.len)).map(|i| v.c[i])
            }
            _ => None,
        }
    }

    fn quick_call(&self, function: &Word, arguments: &[Expr]) -> Option<f64> {
        let row = *NUMERIC.get(function)?;
        let first = row.clamp_if_arc_function(self.quick_number(arguments.first()?)?);
        let second = match arguments.get(1) {
            Some(e) => self.quick_number(e)?,
            None => first,
        };
        let divides = second == 0.0 && row.domain == Domain::Divides;
        if divides || row.domain_fault(first, second).is_some() {
            return None;
        }
        match (row.kernel, arguments) {
            (Kernel::One(f), [_]) => Some(f(first)),
            (Kernel::Two(f), [_, _]) => Some(f(first, second)),
            (Kernel::Many(f), [_, rest @ ..]) => {
                rest.iter().try_fold(first, |out, e| self.quick_number(e).map(|next| f(out, next)))
            }
            _ => None,
        }
    }

    fn quick_element<T: QuickValue>(&self, array: &Expr, index: &Expr) -> Option<T> {
        let ExprKind::Name(symbol) = array.kind else { return None };
        let i = self.quick_number(index).filter(|i| *i >= 0.0)?;
        match self.scopes.get(symbol)? {
            Contents::Array(array) if array.sizes.len() == 1 => match array.items.get(i as usize)? {
                Some(Contents::Value(value)) => T::from_value(value),
                _ => None,
            },
            _ => None,
        }
    }
}
