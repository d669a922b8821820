//! What an expression or a declared name can be.

use crate::color::Color;
use crate::math::DVec3;
use std::any::Any;
use std::rc::Rc;
use std::sync::Arc;

/// Two to five numbers in `< >`; shorter ones are filled with zeros.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct VecN {
    /// Its numbers; those past `len` are 0.
    pub c: [f64; 5],
    /// How many were given, 2 to 5.
    pub len: u8,
}

impl VecN {
    /// All `len` numbers the same, as POV-Ray promotes a float.
    pub fn splat(x: f64, len: u8) -> Self {
        let mut c = [0.0; 5];
        c[..len as usize].fill(x);
        Self { c, len }
    }

    /// From a slice of at most five numbers.
    pub fn from_slice(s: &[f64]) -> Self {
        let mut c = [0.0; 5];
        c[..s.len()].copy_from_slice(s);
        Self { c, len: s.len() as u8 }
    }

    /// The first three numbers.
    pub fn xyz(&self) -> DVec3 {
        DVec3::new(self.c[0], self.c[1], self.c[2])
    }
}

impl From<DVec3> for VecN {
    fn from(v: DVec3) -> Self {
        Self { c: [v.x, v.y, v.z, 0.0, 0.0], len: 3 }
    }
}

/// Something built from a block: a texture, an object, a camera … Its type belongs to a later layer,
/// so it is kept behind this trait and taken out by [`crate::value::ReaderExt::thing`].
pub trait Thing: Any + Send + Sync + std::fmt::Debug {
    /// The word of the language for it: `texture`, `object` …
    fn kind(&self) -> &'static str;
}

/// The thing itself, if it is of this type.
pub fn downcast<T: Thing>(thing: &Arc<dyn Thing>) -> Option<Arc<T>> {
    let any: Arc<dyn Any + Send + Sync> = thing.clone();
    any.downcast::<T>().ok()
}

/// A value of the language.
#[derive(Clone, Debug)]
pub enum Value {
    /// A number; also what conditions give: 0 or 1.
    Float(f64),
    /// Two to five numbers.
    Vector(VecN),
    /// A colour: five numbers that were written as one.
    Color(Color),
    /// Text.
    Text(Rc<str>),
    /// Anything built from a block.
    Thing(Arc<dyn Thing>),
}

impl Value {
    /// How messages call it, with its article.
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
