//! `function { … }`: any formula of x, y and z (manual, "Function Pattern").
//!
//! ```pov
//! sphere { 0, 1 pigment { function { abs(sin(8*x) * sin(8*y)) } color_map { [0 color rgb 0] [1 color rgb <1, 0.8, 0.2>] } } }
//! ```

use super::{Field, TextureContext};
use crate::diagnostic::{Diagnostic, Result, codes};
use crate::function::Function;
use crate::value::{Readable, Reader, Spec, downcast};
use serde::{Serialize, Serializer};
use std::sync::Arc;

/// Pattern `function { … }`, whose number is a formula of x, y and z.
#[derive(Clone, Debug)]
pub struct FunctionPattern(pub Arc<Function>);

impl PartialEq for FunctionPattern {
    fn eq(&self, other: &Self) -> bool {
        Arc::ptr_eq(&self.0, &other.0)
    }
}

impl Serialize for FunctionPattern {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_seq(self.0.parameters.iter())
    }
}

impl Readable for FunctionPattern {
    const SPEC: Spec = Spec {
        name: "function",
        summary: "a formula of x, y and z in braces, as in `#declare F = function { … }`",
        ..Spec::EMPTY
    };

    fn read(r: &mut dyn Reader) -> Result<Self> {
        let (thing, at) = r.take_thing()?;
        let Some(function) = downcast::<Function>(&thing) else {
            return Diagnostic::err(codes::WRONG_TYPE, at, "expected `function { … }`");
        };
        match function.arity() {
            3 => Ok(Self(function)),
            n => {
                let message = format!("a pattern's function has the parameters x, y and z; this one takes {n}");
                Diagnostic::err(codes::WRONG_COUNT, at, message)
            }
        }
    }
}

impl Field for FunctionPattern {
    fn value(&self, at: &TextureContext) -> f64 {
        let [value, ..] = self.0.call(&at.p.to_array());
        // Numbers above 1 wrap; 1 belongs to the first period. The wave handles numbers below 0.
        if value > 1.0 { value.fract() } else { value }
    }
}
