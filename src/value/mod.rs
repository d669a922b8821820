//! Values of the language, the words a block takes, and the reader through which a family of things
//! reads its own words.

mod kinds;
mod reader;
mod said;
mod seldom;
mod spec;
pub mod words;

pub use kinds::{Thing, Value, VecN, downcast};
pub use reader::{FloatOrColor, Language, Next, Reader, ReaderExt, SizedFunction, Solid};
pub use said::Said;
pub use seldom::{Seldom, Usual};
pub use spec::{Kind, Param, Spec, WordSpec};
pub use words::Vocabulary;
