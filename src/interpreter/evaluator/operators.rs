//! Operators with POV-Ray's promotions of types, components of values, and conversions of values.

use crate::color::{Color, gray};
use crate::diagnostic::{Diagnostic, Result, codes};
use crate::math::DVec3;
use crate::source::Span;
use crate::syntax::ast::*;
use crate::value::{Value, VecN};

/// Distance within which numbers are equal, and numbers around 0 false (quirk: `comparison_tolerance`).
pub const TOLERANCE: f64 = 1e-10;

pub fn apply_prefix(prefix: Prefix, value: Value, span: Span) -> Result<Value> {
    Ok(match (prefix, value) {
        (Prefix::Not, value) => Value::Float(f64::from(as_float(&value, span)?.abs() <= TOLERANCE)),
        (Prefix::Minus, Value::Float(x)) => Value::Float(-x),
        (_, Value::Float(x)) => Value::Float(x),
        (sign, value) => {
            let (mut v, color) = components_and_is_color(&value).ok_or_else(|| {
                Box::new(Diagnostic::new(codes::WRONG_TYPE, span, format!("{} has no sign", value.describe())))
            })?;
            if sign == Prefix::Minus {
                v.c.iter_mut().take(v.len as usize).for_each(|x| *x = -*x);
            }
            from_numbers(v, color)
        }
    })
}

/// Returns the components of a vector or colour; `None` for any other value. The flag is true for a colour.
pub fn components_and_is_color(value: &Value) -> Option<(VecN, bool)> {
    match value {
        Value::Vector(v) => Some((*v, false)),
        Value::Color(c) => Some((VecN { c: c.to_array(), len: 5 }, true)),
        _ => None,
    }
}

/// Returns the components of a vector or colour; a number counts as one component. `None` for any other value.
pub fn numbers_of(value: &Value) -> Option<VecN> {
    match value {
        Value::Float(x) => Some(VecN::splat(*x, 1)),
        value => components_and_is_color(value).map(|(v, _)| v),
    }
}

pub fn from_numbers(v: VecN, is_color: bool) -> Value {
    if is_color { Value::Color(Color::from_array(v.c)) } else { Value::Vector(v) }
}

/// Applies a binary operator with POV-Ray's promotions. A number becomes a vector of equal components, and the shorter
/// of two vectors is padded with zeros. `<`, `=` and the other comparisons take two numbers or two strings; `&` and `|`
/// take two numbers.
pub fn combine(op: Operator, left: Value, right: Value, left_span: Span, right_span: Span) -> Result<Value> {
    use Operator::*;
    match (&left, &right) {
        (Value::Float(a), Value::Float(b)) => Ok(Value::Float(apply_to_floats(op, *a, *b))),
        (Value::Text(a), Value::Text(b)) if op.is_comparison() => {
            Ok(Value::Float(apply_to_floats(op, f64::from(a.cmp(b) as i8), 0.0)))
        }
        _ if matches!(op, Add | Sub | Mul | Div) => {
            let wrong = |value: &Value, span| {
                let message = format!("`{}` takes numbers, vectors and colours, not {}", op.text(), value.describe());
                Diagnostic::err(codes::WRONG_TYPE, span, message)
            };
            let (l, r) = (components_and_is_color(&left), components_and_is_color(&right));
            let (a, b, color) = match (l, r, &left, &right) {
                (Some((a, ca)), Some((b, cb)), ..) => (a, b, ca || cb),
                (Some((a, color)), _, _, Value::Float(x)) => (a, VecN::splat(*x, a.len), color),
                (_, Some((b, color)), Value::Float(x), _) => (VecN::splat(*x, b.len), b, color),
                (None, _, left, _) if !matches!(left, Value::Float(_)) => return wrong(left, left_span),
                _ => return wrong(&right, right_span),
            };
            Ok(from_numbers(apply_to_vectors(op, a, b), color))
        }
        (Value::Float(_), _) => wrong_comparison_error(op, &right, right_span),
        _ => wrong_comparison_error(op, &left, left_span),
    }
}

pub fn wrong_comparison_error(op: Operator, value: &Value, span: Span) -> Result<Value> {
    let message = format!("`{}` compares numbers, not {}", op.text(), value.describe());
    Diagnostic::err(codes::WRONG_TYPE, span, message)
}

pub fn apply_to_floats(op: Operator, a: f64, b: f64) -> f64 {
    use Operator::*;
    let truth = |x: f64| x.abs() > TOLERANCE;
    match op {
        Add => a + b,
        Sub => a - b,
        Mul => a * b,
        // POV-Ray's infinity has no sign: -1/0 and 0/0 are the same (quirk: `unsigned_infinity`).
        Div if b == 0.0 => f64::INFINITY,
        Div => a / b,
        Less => f64::from(a < b),
        LessEqual => f64::from(a <= b + TOLERANCE),
        Greater => f64::from(a > b),
        GreaterEqual => f64::from(a + TOLERANCE >= b),
        Equal => f64::from((a - b).abs() < TOLERANCE),
        NotEqual => f64::from((a - b).abs() >= TOLERANCE),
        And => f64::from(truth(a) && truth(b)),
        Or => f64::from(truth(a) || truth(b)),
    }
}

/// Applies an operator component by component; the shorter vector is padded with zeros.
pub fn apply_to_vectors(op: Operator, a: VecN, b: VecN) -> VecN {
    let mut out = VecN { c: [0.0; 5], len: a.len.max(b.len) };
    for i in 0..out.len as usize {
        out.c[i] = apply_to_floats(op, a.c[i], b.c[i]);
    }
    out
}

/// True for a division whose right side is zero or has a zero component.
pub fn divides_by_zero(op: Operator, right: &Value) -> bool {
    op == Operator::Div && numbers_of(right).is_some_and(|v| has_zero_component(&v))
}

/// True if a component of the vector is zero.
pub fn has_zero_component(v: &VecN) -> bool {
    v.c[..v.len as usize].contains(&0.0)
}

/// Returns the index of a named component in a vector or colour; `None` for any other name, such as `gray`.
pub fn component_index(name: &Name) -> Option<usize> {
    Some(match name.word? {
        "x" | "u" | "red" => 0,
        "y" | "v" | "green" => 1,
        "z" | "blue" => 2,
        "t" | "filter" => 3,
        "transmit" => 4,
        _ => return None,
    })
}

/// Returns the component `name` of a value, such as `.x`, `.red` or `.gray`.
pub fn component(value: &Value, name: &Name, span: Span) -> Result<Value> {
    let Some(v) = numbers_of(value) else {
        return Diagnostic::err(codes::WRONG_TYPE, span, format!("{} has no components", value.describe()));
    };
    if name.word == Some("gray") {
        return Ok(Value::Float(gray(v.xyz())));
    }
    let Some(index) = component_index(name) else {
        let d = Diagnostic::new(codes::NO_COMPONENT, name.span, "no vector has a component of this name");
        return d.help("vectors have x y z u v t, colours red green blue filter transmit gray").into();
    };
    if index >= v.len as usize && !matches!(value, Value::Color(_)) {
        let message = format!("{} has no `.{}`", value.describe(), name.word.unwrap_or(""));
        return Diagnostic::err(codes::NO_COMPONENT, name.span, message);
    }
    Ok(Value::Float(v.c[index]))
}

/// Returns a vector of two to five components; an error for any other number.
pub fn vector_value(data: &[f64], span: Span) -> Result<Value> {
    match data.len() {
        2..=5 => Ok(Value::Vector(VecN::from_slice(data))),
        n => Diagnostic::err(codes::WRONG_COUNT, span, format!("a vector has two to five numbers, this has {n}")),
    }
}

/// Converts a value to three components: a number fills all, and a shorter vector is padded with zeros. An error for
/// a longer vector, a colour and any other value.
pub fn as_vector(value: &Value, span: Span) -> Result<DVec3> {
    match value {
        Value::Float(x) => Ok(DVec3::splat(*x)),
        Value::Vector(v) if v.len <= 3 => Ok(v.xyz()),
        other => {
            let message = format!("expected a vector of three numbers, found {}", other.describe());
            Diagnostic::err(codes::WRONG_TYPE, span, message)
        }
    }
}

/// Returns the number in a value; an error for any other value.
pub fn as_float(value: &Value, span: Span) -> Result<f64> {
    match value {
        Value::Float(x) => Ok(*x),
        other => {
            let d = Diagnostic::new(codes::WRONG_TYPE, span, format!("expected a number, found {}", other.describe()));
            match other {
                Value::Vector(_) => d.help("`.x`, `.y` or `.z` selects one of its components").into(),
                Value::Color(_) => d.help("`.red`, `.green`, `.blue` or `.gray` selects one of its components").into(),
                _ => d.into(),
            }
        }
    }
}
