//! Text to AST. The only place that knows pest.

pub mod ast;
mod build;
mod fault;
mod names;
mod numbers;
mod parse;
mod scan;
pub mod word;

pub use names::Names;
pub use parse::parse;
