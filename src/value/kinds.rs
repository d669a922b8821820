//! Values of expressions and declared names.

use crate::color::Color;
use crate::math::DVec3;
use std::any::Any;
use std::rc::Rc;
use std::sync::Arc;

/// A vector of two to five components.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct VecN {
    /// Components of the vector; those from `len` on are 0.
    pub c: [f64; 5],
    /// Number of components of the vector, 2 to 5; 1 for a number that is treated as a vector.
    pub len: u8,
}

impl VecN {
    /// Creates a vector of `len` equal components, as POV-Ray promotes a number.
    pub fn splat(x: f64, len: u8) -> Self {
        let mut c = [0.0; 5];
        c[..len as usize].fill(x);
        Self { c, len }
    }

    /// Creates a vector from a slice of at most five components.
    pub fn from_slice(s: &[f64]) -> Self {
        let mut c = [0.0; 5];
        c[..s.len()].copy_from_slice(s);
        Self { c, len: s.len() as u8 }
    }

    /// Returns the first three components of the vector.
    pub fn xyz(&self) -> DVec3 {
        DVec3::new(self.c[0], self.c[1], self.c[2])
    }
}

impl From<DVec3> for VecN {
    fn from(v: DVec3) -> Self {
        Self { c: [v.x, v.y, v.z, 0.0, 0.0], len: 3 }
    }
}

/// A thing built from a block of the scene language: a texture, an object, a camera. Its type belongs to a module of a
/// higher layer, so values hold it as a trait object; [`crate::value::ReaderExt::take_declared`] recovers the type.
pub trait Thing: Any + Send + Sync + std::fmt::Debug {
    /// Returns the word of the thing's block, such as `texture` or `object`.
    fn kind(&self) -> &'static str;
}

/// Converts a thing to type `T`; `None` if it has another type.
pub fn downcast<T: Thing>(thing: &Arc<dyn Thing>) -> Option<Arc<T>> {
    let any: Arc<dyn Any + Send + Sync> = thing.clone();
    any.downcast::<T>().ok()
}

/// A value of the scene language.
#[derive(Clone, Debug)]
pub enum Value {
    /// Value that is a number, also the result 0 or 1 of a condition.
    Float(f64),
    /// Value that is a vector of two to five components.
    Vector(VecN),
    /// Value that is a colour.
    Color(Color),
    /// Value that is a string.
    Text(Rc<str>),
    /// Value that is built from a block, such as a texture.
    Thing(Arc<dyn Thing>),
}

impl Value {
    /// Returns a description of the value for messages, with an article: "a number".
    pub fn describe(&self) -> String {
        match self {
            Value::Float(_) => "a number".into(),
            Value::Vector(v) => format!("a vector of {} numbers", v.len),
            Value::Color(_) => "a colour".into(),
            Value::Text(_) => "a string".into(),
            Value::Thing(t) => {
                let kind = t.kind();
                let article = if kind.starts_with(['a', 'e', 'i', 'o', 'u']) { "an" } else { "a" };
                format!("{article} {kind}")
            }
        }
    }
}
