//! `pigment_pattern { … }`: the brightness of a pigment (manual, "Pigment Pattern").
//!
//! ```pov
//! sphere { 0, 1 pigment { pigment_pattern { checker color rgb 0.2, color rgb 0.8 scale 0.5 }
//!   color_map { [0 color rgb <0, 0, 0.5>] [1 color rgb <1, 1, 0>] } } }
//! ```

use super::{Field, TextureContext};
use crate::diagnostic::{Diagnostic, Result, codes};
use crate::value::{Param, Readable, Reader, Spec, Thing, ValueKind, downcast};
use serde::{Serialize, Serializer};
use std::sync::Arc;

/// Pigment of a `pigment_pattern`, as an interface: pigments belong to a layer above patterns.
pub trait PigmentBrightness: std::fmt::Debug + Send + Sync {
    /// Returns the brightness of the pigment at a point. On a surface, the pigment depends on the surface as well, as
    /// with `slope` and `uv_mapping` (quirk: `pigment_pattern_sees_surface`).
    fn brightness(&self, at: &TextureContext) -> f64;
    /// True if the pigment depends on surface coordinates.
    fn depends_on_uv(&self) -> bool;
}

/// Pattern `pigment_pattern`: the brightness of a pigment.
#[derive(Clone, Debug)]
pub struct PigmentPattern(Arc<dyn PigmentBrightness>);

impl PigmentPattern {
    /// Creates the pattern of a pigment's brightness.
    pub fn new(pigment: Arc<dyn PigmentBrightness>) -> Self {
        Self(pigment)
    }

    /// True if the pigment depends on surface coordinates.
    pub fn depends_on_uv(&self) -> bool {
        self.0.depends_on_uv()
    }
}

impl PartialEq for PigmentPattern {
    fn eq(&self, other: &Self) -> bool {
        Arc::ptr_eq(&self.0, &other.0)
    }
}

impl Serialize for PigmentPattern {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_seq(["x", "y", "z"])
    }
}

impl Thing for PigmentPattern {
    fn kind(&self) -> &'static str {
        "pigment_pattern"
    }
}

impl Readable for PigmentPattern {
    const SPEC: Spec = Spec {
        name: "pigment_pattern",
        summary: "the brightness of a pigment in braces",
        params: &[Param { name: "pigment", kind: ValueKind::Block, summary: "any pigment" }],
        ..Spec::EMPTY
    };

    fn read(r: &mut dyn Reader) -> Result<Self> {
        let at = r.span();
        let thing = r.read_pigment_pattern()?;
        r.leave_block()?;
        match downcast::<Self>(&thing) {
            Some(pattern) => Ok((*pattern).clone()),
            None => Diagnostic::err(codes::WRONG_TYPE, at, "expected a pigment"),
        }
    }
}

impl Field for PigmentPattern {
    fn value(&self, at: &TextureContext) -> f64 {
        self.0.brightness(at)
    }
}
