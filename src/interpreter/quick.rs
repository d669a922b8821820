//! The short way through expressions: numbers and vectors, and nothing that has an effect or needs a message. Most
//! expressions of a script are no more than that.

use super::Interpreter;
use super::operators::{SMALL, component_index, on_floats};
use super::scope::Slot;
use crate::function::numeric::{self, Kernel};
use crate::syntax::ast::*;
use crate::value::{Value, VecN};

/// A value that needs no allocation.
pub(super) enum Quick {
    Float(f64),
    Vector(VecN),
}

impl Quick {
    /// Both with an operator between them; `None` where [`apply`] has something to say.
    fn combined(self, op: Operator, right: Quick) -> Option<Quick> {
        if !op.multiplies() && !op.adds() {
            return match (self, right) {
                (Quick::Float(a), Quick::Float(b)) => Some(Quick::Float(on_floats(op, a, b))),
                _ => None,
            };
        }
        let (a, b) = match (self, right) {
            (Quick::Float(_), Quick::Float(0.0)) if op == Operator::Div => return None,
            (Quick::Float(a), Quick::Float(b)) => return Some(Quick::Float(on_floats(op, a, b))),
            (Quick::Float(x), Quick::Vector(b)) => (VecN::splat(x, b.len), b),
            (Quick::Vector(a), Quick::Float(x)) => (a, VecN::splat(x, a.len)),
            (Quick::Vector(a), Quick::Vector(b)) => (a, b),
        };
        if op == Operator::Div && b.c[..b.len as usize].contains(&0.0) {
            return None;
        }
        let mut out = VecN { c: [0.0; 5], len: a.len.max(b.len) };
        for i in 0..out.len as usize {
            out.c[i] = on_floats(op, a.c[i], b.c[i]);
        }
        // A shorter divisor is filled with zeros.
        let fine = op != Operator::Div || b.len >= out.len;
        fine.then_some(Quick::Vector(out))
    }
}

impl Interpreter<'_> {
    /// The short way for what most expressions are: numbers, and nothing that has an effect or needs a message. `None`
    /// says that the long way has to be gone.
    pub(super) fn simple(&self, e: &Expr) -> Option<f64> {
        match &e.kind {
            ExprKind::Number(x) => Some(*x),
            ExprKind::Paren(inner) => self.simple(inner),
            ExprKind::Name(symbol) => match self.scopes.get(*symbol) {
                Some(Slot::Value(Value::Float(x))) if self.deprecated.is_empty() => Some(*x),
                None => match self.constants.get(symbol.0 as usize) {
                    Some(Some(Value::Float(x))) => Some(*x),
                    _ => None,
                },
                _ => None,
            },
            ExprKind::Prefix(prefix, inner) => {
                let x = self.simple(inner)?;
                Some(match prefix {
                    Prefix::Minus => -x,
                    Prefix::Plus => x,
                    Prefix::Not => f64::from(x.abs() <= SMALL),
                })
            }
            ExprKind::Chain(chain) => chain.rest.iter().try_fold(self.simple(&chain.first)?, |left, (op, operand)| {
                let right = self.simple(operand)?;
                let warns = *op == Operator::Div && right == 0.0;
                if warns { None } else { Some(on_floats(*op, left, right)) }
            }),
            ExprKind::Choice(parts) => {
                let [condition, yes, no] = &**parts;
                self.simple(if self.simple(condition)?.abs() > SMALL { yes } else { no })
            }
            ExprKind::Builtin(name, arguments) => self.simple_call(name, arguments),
            ExprKind::Index(array, indices) => match &**indices {
                [index] => self.simple_element(array, index),
                _ => None,
            },
            ExprKind::Dot(base, name, _) => match base.kind {
                ExprKind::Name(symbol) if self.deprecated.is_empty() => match self.scopes.get(symbol) {
                    Some(Slot::Value(Value::Vector(v))) => {
                        component_index(name).filter(|i| *i < usize::from(v.len)).map(|i| v.c[i])
                    }
                    _ => None,
                },
                _ => None,
            },
            _ => None,
        }
    }

    /// The same for vectors too.
    pub(super) fn quick(&self, e: &Expr) -> Option<Quick> {
        match &e.kind {
            ExprKind::Literal(data) if (2..=5).contains(&data.len()) => Some(Quick::Vector(VecN::from_slice(data))),
            ExprKind::Vector(parts) if (2..=5).contains(&parts.len()) => {
                let mut out = VecN { c: [0.0; 5], len: parts.len() as u8 };
                for (slot, part) in out.c.iter_mut().zip(parts) {
                    match &part.kind {
                        ElementKind::Expr(e) => *slot = self.simple(e)?,
                        _ => return None,
                    }
                }
                Some(Quick::Vector(out))
            }
            ExprKind::Paren(inner) => self.quick(inner),
            ExprKind::Name(symbol) => match self.scopes.get(*symbol) {
                Some(Slot::Value(Value::Float(x))) if self.deprecated.is_empty() => Some(Quick::Float(*x)),
                Some(Slot::Value(Value::Vector(v))) if self.deprecated.is_empty() => Some(Quick::Vector(*v)),
                None => match self.constants.get(symbol.0 as usize) {
                    Some(Some(Value::Float(x))) => Some(Quick::Float(*x)),
                    Some(Some(Value::Vector(v))) => Some(Quick::Vector(*v)),
                    _ => None,
                },
                _ => None,
            },
            ExprKind::Chain(chain) => {
                let first = self.quick(&chain.first)?;
                chain.rest.iter().try_fold(first, |left, (op, operand)| left.combined(*op, self.quick(operand)?))
            }
            _ => self.simple(e).map(Quick::Float),
        }
    }

    fn simple_call(&self, name: &str, arguments: &[Expr]) -> Option<f64> {
        let row = &numeric::TABLE[numeric::find(name)? as usize];
        let first = row.clamped(self.simple(arguments.first()?)?);
        let second = match arguments.get(1) {
            Some(e) => self.simple(e)?,
            None => first,
        };
        let divides = second == 0.0 && matches!(name, "div" | "mod");
        if divides || row.fault(first, second).is_some() {
            return None;
        }
        match (row.kernel, arguments) {
            (Kernel::One(f), [_]) => Some(f(first)),
            (Kernel::Two(f), [_, _]) => Some(f(first, second)),
            (Kernel::Many(f), [_, rest @ ..]) => {
                rest.iter().try_fold(first, |out, e| self.simple(e).map(|next| f(out, next)))
            }
            _ => None,
        }
    }

    fn simple_element(&self, array: &Expr, index: &Expr) -> Option<f64> {
        let ExprKind::Name(symbol) = array.kind else { return None };
        let i = self.simple(index).filter(|i| *i >= 0.0)?;
        match self.scopes.get(symbol)? {
            Slot::Array(array) if array.sizes.len() == 1 => match array.items.get(i as usize)? {
                Some(Slot::Value(Value::Float(x))) => Some(*x),
                _ => None,
            },
            _ => None,
        }
    }
}
