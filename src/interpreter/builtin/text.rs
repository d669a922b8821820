//! Functions of strings (manual, "String Functions").

use super::{Arguments, Builtin, float};
use crate::diagnostic::Result;
use crate::interpreter::evaluator::numbers_of;
use crate::value::{Value, VecN};
use std::fmt::Write;

pub(super) const TABLE: &[Builtin] = &[
    Builtin {
        name: "asc",
        usage: "(Text)",
        summary: "the number of the first character; 0 of an empty text",
        arity: 1..=1,
        run: |a| float(a.text(0)?.chars().next().map_or(0.0, |c| f64::from(u32::from(c)))),
    },
    Builtin {
        name: "chr",
        usage: "(Number)",
        summary: "the character of this number (Unicode)",
        arity: 1..=1,
        run: |a| match char::from_u32(a.float(0)? as u32) {
            Some(c) => Ok(text_value(c.to_string())),
            None => a.domain_error(0, "no character has this number".into()),
        },
    },
    Builtin {
        name: "concat",
        usage: "(Text, …)",
        summary: "all of them behind one another",
        arity: 1..=usize::MAX,
        run: |a| (0..a.len()).map(|i| a.text(i)).collect::<Result<String>>().map(text_value),
    },
    Builtin {
        name: "str",
        usage: "(Number, Width, Digits)",
        summary: "a number as text: at least so wide, with so many digits behind the point; a width below 0 fills with zeros",
        arity: 3..=3,
        run: |a| Ok(text_value(format_number(a.float(0)?, a.float(1)? as i64, a.float(2)? as i64))),
    },
    Builtin {
        name: "datetime",
        usage: "(Days [, Format])",
        summary: "days since the beginning of 2000 as a date; the format is that of C's `strftime`",
        arity: 1..=2,
        run: datetime,
    },
    Builtin {
        name: "strcmp",
        usage: "(Text, Text)",
        summary: "0 if they are the same; below 0 if the first comes first in the dictionary, else above 0",
        arity: 2..=2,
        run: |a| float(strcmp_difference(a.text(0)?, a.text(1)?)),
    },
    Builtin {
        name: "strlen",
        usage: "(Text)",
        summary: "how many characters it has",
        arity: 1..=1,
        run: |a| float(a.text(0)?.chars().count() as f64),
    },
    Builtin {
        name: "strlwr",
        usage: "(Text)",
        summary: "in small letters",
        arity: 1..=1,
        run: |a| Ok(text_value(a.text(0)?.to_lowercase())),
    },
    Builtin {
        name: "strupr",
        usage: "(Text)",
        summary: "in capitals",
        arity: 1..=1,
        run: |a| Ok(text_value(a.text(0)?.to_uppercase())),
    },
    Builtin {
        name: "substr",
        usage: "(Text, From, Count)",
        summary: "so many characters, the first being number 1",
        arity: 3..=3,
        run: substr,
    },
    Builtin {
        name: "val",
        usage: "(Text)",
        summary: "the number that the text begins with",
        arity: 1..=1,
        run: |a| float(leading_number_and_length(a.text(0)?.trim_start()).map_or(0.0, |(x, _)| x)),
    },
    Builtin {
        name: "vstr",
        usage: "(Count, Vector, Separator, Width, Digits)",
        summary: "a vector as text; each number as in `str`",
        arity: 5..=5,
        run: vstr,
    },
];

fn text_value(s: String) -> Value {
    Value::Text(s.into())
}

/// Returns the difference of the first two characters that differ, as `strcmp` does; 0 for equal strings.
fn strcmp_difference(a: &str, b: &str) -> f64 {
    let codes = |s: &str| s.chars().map(|c| f64::from(u32::from(c))).chain([0.0]).collect::<Vec<_>>();
    codes(a).iter().zip(&codes(b)).map(|(a, b)| a - b).find(|d| *d != 0.0).unwrap_or(0.0)
}

/// Parses the number at the start of a string, and returns it with its length in bytes.
pub fn leading_number_and_length(s: &str) -> Option<(f64, usize)> {
    let digits = |c: char| c.is_ascii_digit() || matches!(c, '.' | 'e' | 'E' | '+' | '-');
    let end = s.find(|c| !digits(c)).unwrap_or(s.len()).min(400);
    (1..=end).rev().find_map(|end| s[..end].parse().ok().map(|x| (x, end)))
}

/// Formats a number as C's `printf` does; a negative width pads with zeros, a negative precision means six digits.
fn format_number(x: f64, width: i64, precision: i64) -> String {
    let precision = if precision < 0 { 6 } else { precision.min(300) as usize };
    let wide = width.unsigned_abs().min(10_000) as usize;
    match x {
        _ if x.is_nan() => format!("{:>wide$}", "nan"),
        _ if x.is_infinite() => format!("{:>wide$}", if x > 0.0 { "inf" } else { "-inf" }),
        _ if width < 0 => format!("{x:0wide$.precision$}"),
        _ => format!("{x:wide$.precision$}"),
    }
}

/// Evaluates `datetime(Days [, Format])`: formats days since the beginning of 2000; the format is that of C's
/// `strftime`.
fn datetime(a: &Arguments) -> Result<Value> {
    let days = a.float(0)?;
    let format = if a.len() > 1 { a.text(1)? } else { "%Y-%m-%d %H:%M:%SZ" };
    let time = chrono::DateTime::from_timestamp(EPOCH_2000, 0)
        .zip(chrono::TimeDelta::try_milliseconds((days * 86_400_000.0).round() as i64))
        .and_then(|(start, since)| start.checked_add_signed(since));
    let Some(time) = time else { return a.domain_error(0, format!("there is no day {days}")) };
    let mut out = String::new();
    match write!(out, "{}", time.format(format)) {
        Ok(()) => Ok(text_value(out)),
        Err(_) => a.domain_error(1, "this is no format of a date: `%Y-%m-%d %H:%M:%S` is one".into()),
    }
}

/// Time from the beginning of 1970 to that of 2000, in seconds.
const EPOCH_2000: i64 = 946_684_800;

/// Evaluates `substr(S, P, L)`: L characters from character P on, counted from 1.
fn substr(a: &Arguments) -> Result<Value> {
    let (s, from, len) = (a.text(0)?, a.float(1)?.trunc(), a.float(2)?);
    let count = s.chars().count() as f64;
    if from < 0.0 || len < 0.0 || from - 1.0 + len > count {
        return a.domain_error(1, format!("a string of {count} characters has none at {from} to {}", from + len - 1.0));
    }
    // In POV-Ray, it is what precedes the string in memory, which mostly is a 0.
    let len = if from == 0.0 { 0.0 } else { len };
    Ok(text_value(s.chars().skip((from as usize).saturating_sub(1)).take(len as usize).collect()))
}

/// Evaluates `vstr(N, V, Separator, Width, Precision)`: formats a vector as a string.
fn vstr(a: &Arguments) -> Result<Value> {
    let n = a.float(0)?.clamp(2.0, 5.0) as usize;
    let value = &a.values[1].0;
    let Some(VecN { c, .. }) = numbers_of(value) else { return a.wrong_type_error(1, "a vector", value) };
    let (separator, width, precision) = (a.text(2)?, a.float(3)? as i64, a.float(4)? as i64);
    let parts: Vec<String> = c[..n].iter().map(|x| format_number(*x, width, precision)).collect();
    Ok(text_value(parts.join(separator)))
}
