//! Parser of scene files: from text to syntax tree. No other module uses pest.

pub mod ast;
pub mod blame;
mod brackets;
mod build;
mod class;
pub mod fault;
mod lex;
pub mod lint;
mod names;
mod number_list;
mod numbers;
pub mod outline;
pub use numbers::ItemSpans;
mod parse;
mod portable;
mod tokens;
pub mod word;

pub use build::{SignRow, begins_with_parenthesis, begins_with_sign, split_one_level, unescape};
pub use class::{directive_continues_body, directive_opens_body, structural_directives};
pub use lex::is_ignored_char;
pub use names::Names;
pub use outline::Outline;
pub use parse::{Granularity, parse, parse_text, tokens_of};
pub use portable::MISSING_SEMICOLON;
pub use tokens::{Piece, Tokens};
