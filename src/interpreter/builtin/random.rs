//! `seed(A)` and `rand(Stream)` (manual, "Float Functions"): reproducible pseudo-random streams.

use crate::diagnostic::{Diagnostic, Result, codes};
use crate::interpreter::Interpreter;
use crate::interpreter::argument::Argument;
use crate::value::Value;

impl<'a> Interpreter<'a> {
    /// Opens a random stream, and returns the stream's number.
    pub(super) fn seed(&mut self, start: &Argument<'a>) -> Result<Value> {
        let start = self.argument_number(start)?;
        // Numbers outside of 32 bits count as the smallest one (quirk: `seed_overflow`).
        let holds = start > -2_147_483_649.0 && start < 2_147_483_648.0;
        let stream = self.evaluator.random_streams().open(if holds { start as i32 as u32 } else { 1 << 31 });
        Ok(Value::Float(stream as f64))
    }

    /// Returns the next number of a random stream, from 0 to 1.
    pub(super) fn rand(&mut self, stream: &Argument<'a>) -> Result<Value> {
        let number = self.argument_number(stream)?;
        match self.evaluator.random_streams().next(number) {
            Some(x) => Ok(Value::Float(x)),
            None => Diagnostic::new(codes::BAD_ARGUMENT, stream.span, format!("there is no random stream {number}"))
                .help("`#declare R = seed(1);` opens one, and `rand(R)` returns its next number")
                .into(),
        }
    }
}
