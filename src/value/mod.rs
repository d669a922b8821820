//! Values of the language, the words a block takes, and the reader through which a family of things
//! reads its own words.

mod reader;
mod spec;
mod value;

pub use reader::{FloatOrColor, Language, Next, Reader, ReaderExt};
pub use spec::{Kind, Param, Spec, WordSpec};
pub use value::{Thing, Value, VecN};
