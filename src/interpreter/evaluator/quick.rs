//! Fast evaluation of expressions of numbers and vectors, without side effects and messages, which are the most common.

use super::operators::{TOLERANCE, apply_to_floats, apply_to_vectors, component_index, has_zero_component};
use super::vector_functions::{VECTOR_FUNCTIONS, VectorFunction};
use super::{Contents, Evaluator};
use crate::function::numeric::{self, Domain, Kernel, Numeric};
use crate::math::DVec3;
use crate::syntax::ast::*;
use crate::syntax::word::WordTable;
use crate::value::{Value, VecN};
use std::sync::LazyLock;

/// Built-in function that the fast evaluation can call.
#[derive(Clone, Copy)]
enum QuickFunction {
    Numeric(&'static Numeric),
    Vector(&'static VectorFunction),
    /// The function `rand`.
    Random,
}

/// Built-in functions that the fast evaluation can call, by word.
static FUNCTIONS: LazyLock<WordTable<QuickFunction>> = LazyLock::new(|| {
    let numeric = numeric::TABLE.iter().map(|row| (row.name, QuickFunction::Numeric(row)));
    let vector = VECTOR_FUNCTIONS.iter().map(|row| (row.name, QuickFunction::Vector(row)));
    WordTable::new(numeric.chain(vector).chain([("rand", QuickFunction::Random)]))
});

/// Value of an expression without heap allocation, for fast evaluation.
pub enum Quick {
    Float(f64),
    Vector(VecN),
}

impl From<Quick> for Value {
    fn from(value: Quick) -> Self {
        match value {
            Quick::Float(x) => Value::Float(x),
            Quick::Vector(v) => Value::Vector(v),
        }
    }
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

    /// Evaluates an expression of numbers and vectors; `None` if the general evaluation is needed. Random streams are
    /// then as they were before.
    pub fn quick<T: QuickValue>(&self, e: &Expr) -> Option<T> {
        let value = self.try_quick(e);
        self.random.end_attempt(value.is_some());
        value
    }

    /// Evaluates an expression like [`Self::quick`], which restores the random streams if the result is `None`.
    fn try_quick<T: QuickValue>(&self, e: &Expr) -> Option<T> {
        match &e.kind {
            ExprKind::Number(x) => Some(T::float(*x)),
            ExprKind::Literal(data) if (2..=5).contains(&data.len()) => T::vector(VecN::from_slice(data)),
            ExprKind::Vector(parts) if T::VECTORS => self.quick_vector(parts),
            ExprKind::Paren(inner) => self.try_quick(inner),
            ExprKind::Name(symbol) => self.quick_name(*symbol),
            ExprKind::Prefix(prefix, inner) => self.try_quick::<T>(inner)?.prefixed(*prefix),
            ExprKind::Chain(chain) => {
                let first: T = self.quick_operand(&chain.first)?;
                chain
                    .rest
                    .iter()
                    .try_fold(first, |left, (op, operand)| left.combined(*op, self.quick_operand(operand)?))
            }
            ExprKind::Choice(parts) => {
                let [condition, yes, no] = &**parts;
                let (condition, yes, no) =
                    (self.try_quick::<f64>(condition)?, self.try_quick(yes)?, self.try_quick(no)?);
                Some(if condition.abs() > TOLERANCE { yes } else { no })
            }
            ExprKind::Builtin(name, arguments) => match *FUNCTIONS.get(name)? {
                QuickFunction::Numeric(row) => self.quick_number_call(row, arguments).map(T::float),
                QuickFunction::Vector(row) => self.quick_vector_call(row, arguments),
                QuickFunction::Random => match &**arguments {
                    [stream] => self.random.try_next(self.try_quick(stream)?).map(T::float),
                    _ => None,
                },
            },
            ExprKind::Index(array, indices) => match &**indices {
                [index] => self.quick_element(array, index),
                _ => None,
            },
            ExprKind::Dot(base, name, _) => self.quick_component(base, name).map(T::float),
            _ => None,
        }
    }

    /// Returns the number or vector of a name; `None` if the general evaluation is needed.
    #[inline]
    fn quick_name<T: QuickValue>(&self, symbol: Symbol) -> Option<T> {
        match self.scopes.get(symbol) {
            Some(Contents::Value(value)) if self.deprecated.is_empty() => T::from_value(value),
            None => T::from_value(self.constants.fixed_value(symbol)?),
            _ => None,
        }
    }

    /// Evaluates an operand like [`Self::try_quick`]. (Most operands are numbers and names, which need no recursive call.)
    #[inline(always)]
    fn quick_operand<T: QuickValue>(&self, e: &Expr) -> Option<T> {
        match &e.kind {
            ExprKind::Number(x) => Some(T::float(*x)),
            ExprKind::Name(symbol) => self.quick_name(*symbol),
            _ => self.try_quick(e),
        }
    }

    fn quick_vector<T: QuickValue>(&self, parts: &[Element]) -> Option<T> {
        if !(2..=5).contains(&parts.len()) {
            return None;
        }
        let mut out = VecN { c: [0.0; 5], len: parts.len() as u8 };
        for (slot, part) in out.c.iter_mut().zip(parts) {
            match &part.kind {
                ElementKind::Expr(e) => *slot = self.try_quick::<f64>(e)?,
                _ => return None,
            }
        }
        T::vector(out)
    }

    /// Evaluates a component of a vector, such as `V.x` or `A[I].x`; `None` for other values, such as dictionaries.
    fn quick_component(&self, base: &Expr, name: &Name) -> Option<f64> {
        let vector = match base.kind {
            ExprKind::Name(symbol) => match self.scopes.get(symbol)? {
                Contents::Value(Value::Vector(v)) if self.deprecated.is_empty() => *v,
                _ => return None,
            },
            // (Long chains of components would need a deep recursion.)
            ExprKind::Dot(..) => return None,
            _ => match self.try_quick(base)? {
                Quick::Vector(v) => v,
                Quick::Float(_) => return None,
            },
        };
        component_index(name).filter(|i| *i < usize::from(vector.len)).map(|i| vector.c[i])
    }

    fn quick_number_call(&self, row: &Numeric, arguments: &[Expr]) -> Option<f64> {
        let first = row.clamp_if_arc_function(self.try_quick::<f64>(arguments.first()?)?);
        let second = match arguments.get(1) {
            Some(e) => self.try_quick::<f64>(e)?,
            None => first,
        };
        let divides = second == 0.0 && row.domain == Domain::Divides;
        if divides || row.domain_fault(first, second).is_some() {
            return None;
        }
        match (row.kernel, arguments) {
            (Kernel::One(f), [_]) => Some(f(first)),
            (Kernel::Two(f), [_, _]) => Some(f(first, second)),
            (Kernel::Many(_), [_]) => Some(first),
            // (Each argument is evaluated once: it may be a random number.)
            (Kernel::Many(f), [_, _, rest @ ..]) => {
                rest.iter().try_fold(f(first, second), |out, e| self.try_quick(e).map(|next| f(out, next)))
            }
            _ => None,
        }
    }

    fn quick_vector_call<T: QuickValue>(&self, row: &VectorFunction, arguments: &[Expr]) -> Option<T> {
        if arguments.len() != row.arity() {
            return None;
        }
        let argument = |i: usize| self.quick_point(&arguments[i]).ok_or(());
        match row.call(argument).ok()? {
            Quick::Float(x) => Some(T::float(x)),
            Quick::Vector(v) => T::vector(v),
        }
    }

    /// Evaluates a vector of three numbers; `None` for other values and if the general evaluation is needed.
    fn quick_point(&self, e: &Expr) -> Option<DVec3> {
        match self.try_quick(e)? {
            Quick::Vector(v) if v.len == 3 => Some(v.xyz()),
            _ => None,
        }
    }

    fn quick_element<T: QuickValue>(&self, array: &Expr, index: &Expr) -> Option<T> {
        let ExprKind::Name(symbol) = array.kind else { return None };
        let i = self.try_quick::<f64>(index).filter(|i| *i >= 0.0)?;
        match self.scopes.get(symbol)? {
            Contents::Array(array) if array.sizes.len() == 1 => match array.items.get(i as usize)? {
                Some(Contents::Value(value)) => T::from_value(value),
                _ => None,
            },
            _ => None,
        }
    }
}
