//! Text to AST. The only place that knows pest.

pub mod ast;
mod build;
mod fault;
mod lex;
pub mod lint;
mod names;
mod nesting;
mod numbers;
mod parse;
pub mod word;

pub use build::unescape;
pub use lex::directive_names;
pub use names::Names;
pub use parse::parse;
