//! `pigment_pattern { … }`: the brightness of a pigment (manual, "Pigment Pattern").
//!
//! ```pov
//! sphere { 0, 1 pigment { pigment_pattern { checker color rgb 0.2, color rgb 0.8 scale 0.5 }
//!   color_map { [0 color rgb <0, 0, 0.5>] [1 color rgb <1, 1, 0>] } } }
//! ```

use super::{Field, FunctionPattern, Readable, TextureContext};
use crate::diagnostic::{Diagnostic, Result, codes};
use crate::function::Function;
use crate::value::{Kind, Param, Reader, Spec, downcast};
use serde::Serialize;

/// The brightness of a pigment as a function of the point.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct PigmentPattern(FunctionPattern);

impl Readable for PigmentPattern {
    const SPEC: Spec = Spec {
        name: "pigment_pattern",
        summary: "the brightness of a pigment, which stands in braces",
        params: &[Param { name: "pigment", kind: Kind::Block, summary: "any pigment" }],
        words: &[],
    };

    fn read(r: &mut dyn Reader) -> Result<Self> {
        let at = r.span();
        let thing = r.pigment()?;
        r.leave()?;
        match downcast::<Function>(&thing) {
            Some(function) => Ok(Self(FunctionPattern(function))),
            None => Diagnostic::err(codes::WRONG_TYPE, at, "expected a pigment"),
        }
    }
}

impl Field for PigmentPattern {
    fn value(&self, at: &TextureContext) -> f64 {
        let [brightness, ..] = self.0.0.call(&at.p.to_array());
        brightness
    }
}
