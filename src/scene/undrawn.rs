//! What stands for a shape that is not drawn yet: nothing in the picture, but a box about where the shape would be, for
//! scripts that ask where things end.

use super::{Defaults, Object, ObjectKind};
use crate::diagnostic::{Diagnostic, Result, codes};
use crate::math::{Aabb, DVec3};
use crate::value::{Next, RawItem, Reader};
use serde::Serialize;
use std::sync::Arc;

/// A shape that is not drawn yet: what was said of it, without its modifiers.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Undrawn {
    /// Stands for it where scripts ask, in its own space.
    pub bounds: Aabb,
    /// What stands between its braces.
    #[serde(serialize_with = "RawItem::print_row")]
    pub said: Vec<RawItem>,
}

impl Object {
    /// Reads a block that is not drawn yet: its modifiers as those of any object, all else as it is said.
    pub(super) fn read_undrawn(word: &'static str, r: &mut dyn Reader, defaults: &Defaults) -> Result<Box<Self>> {
        let source = r.take()?;
        r.report(Diagnostic::new(codes::UNSUPPORTED, source, format!("`{word}` is not drawn yet: it is left out")));
        let mut object = Box::new(Self::unfinished(word, source, defaults));
        let mut said = vec![];
        loop {
            let next = r.next()?;
            if next == Next::End {
                break;
            }
            if !object.read_modifier(next, r, defaults)? {
                r.pass(&mut said)?;
            }
        }
        r.leave()?;
        object.kind = ObjectKind::Undrawn(Arc::new(Undrawn { bounds: about(word), said }));
        Ok(object)
    }
}

/// A box about where the shape is.
fn about(word: &str) -> Aabb {
    match word {
        _ => Aabb { min: DVec3::NEG_ONE, max: DVec3::ONE },
    }
}
