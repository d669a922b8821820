//! Functions of numbers in scripts (manual, "Float Functions"); the table is [`crate::function::numeric`].

use super::{Arguments, float};
use crate::diagnostic::Result;
use crate::function::numeric::{Kernel, Numeric};
use crate::value::Value;

/// Computes a built-in numeric function, such as `sin`, for arguments whose number has been checked.
pub(super) fn compute(row: &Numeric, a: &Arguments) -> Result<Value> {
    let first = row.clamp_if_arc_function(a.float(0)?);
    match row.kernel {
        Kernel::One(f) => match row.domain_fault(first, first) {
            Some(why) => a.domain_error(0, why),
            None => float(f(first)),
        },
        Kernel::Two(f) => {
            let second = a.float(1)?;
            match row.domain_fault(first, second) {
                Some(why) => a.domain_error(0, why),
                None => float(f(first, second)),
            }
        }
        Kernel::Many(f) => (1..a.len()).try_fold(first, |out, i| Ok(f(out, a.float(i)?))).map(Value::Float),
    }
}

/// Returns the numbers of arguments that a numeric function accepts.
pub(super) fn arity(row: &Numeric) -> std::ops::RangeInclusive<usize> {
    match row.kernel {
        Kernel::One(_) => 1..=1,
        Kernel::Two(_) => 2..=2,
        Kernel::Many(_) => 1..=usize::MAX,
    }
}
