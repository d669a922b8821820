//! Values of the language, tables of the words in blocks, and the [`Reader`] trait through which the families of blocks
//! read.

mod decimal;
mod given;
mod kinds;
pub mod ranges;
mod readable;
mod reader;
mod registry;
mod shared_default;
mod spec;
pub mod words;

pub use decimal::{format_decimal, trim_zeros};
pub use given::parse_value;
pub use kinds::{Thing, Value, VecN, downcast};
pub use readable::Readable;
pub use reader::{BuildMesh, FloatOrColor, Language, Next, Reader, ReaderExt, SizedFunction, Solid};
pub use registry::{Family, Stored};
pub(crate) use registry::{delegate, family};
pub use shared_default::{SharedDefault, StaticDefault};
pub use spec::{Param, Spec, ValueKind, WordSpec};
