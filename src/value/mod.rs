//! Values of the language, the words a block takes, and the reader through which a family of things
//! reads its own words.

mod decimal;
mod given;
mod kinds;
mod raw_item;
mod reader;
mod seldom;
mod spec;
pub mod words;

pub use decimal::{decimal, without_zeros};
pub use given::given;
pub use kinds::{Thing, Value, VecN, downcast};
pub use raw_item::RawItem;
pub use reader::{BuildMesh, FloatOrColor, Language, Next, Reader, ReaderExt, SizedFunction, Solid};
pub use seldom::{Seldom, Usual};
pub use spec::{Kind, Param, Spec, WordSpec};
pub use words::Vocabulary;
