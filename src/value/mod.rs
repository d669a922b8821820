//! Values of the language, the words a block takes, and the reader through which a family of things
//! reads its own words.

mod decimal;
mod given;
mod kinds;
mod reader;
mod shared_default;
mod spec;
mod unsupported;
pub mod words;

pub use decimal::{decimal, without_zeros};
pub use given::given;
pub use kinds::{Thing, Value, VecN, downcast};
pub use reader::{BuildMesh, FloatOrColor, Language, Next, Reader, ReaderExt, SizedFunction, Solid};
pub use shared_default::{SharedDefault, StaticDefault};
pub use spec::{Kind, Param, Spec, WordSpec};
pub use unsupported::Unsupported;
pub use words::Vocabulary;
