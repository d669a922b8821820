//! What a `#` begins: one file a directive, one row below.

mod branch;
mod data;
mod declare;
mod file;
mod include;
mod macros;
mod message;
pub mod table;
mod version;

pub(super) use file::OpenFile;

use super::Interpreter;
use crate::diagnostic::Result;
use crate::source::Span;
use crate::syntax::ast::Directive;

impl<'a> Interpreter<'a> {
    /// Runs a directive; branches and loops push a frame that is read next.
    pub(super) fn run_directive(&mut self, directive: &'a Directive, span: Span) -> Result<()> {
        match directive {
            Directive::Declare(declare) => self.declare(declare),
            Directive::Undef(name) => self.undef(name),
            Directive::If(branches) => self.branch(branches, span),
            Directive::While(condition, body) => self.while_loop(condition, body, span),
            Directive::For(f) => self.for_loop(f, span),
            Directive::Switch(value, arms) => self.switch(value, arms, span),
            Directive::Break => self.break_out(span),
            Directive::Macro(definition) => self.define_macro(definition),
            Directive::Include(name) => self.include(name, span),
            Directive::Version(value) => self.version(value),
            Directive::Message(kind, text) => self.message(kind, text),
            Directive::Default(body) => self.default_block(body, span),
            Directive::File(kind, elements) => self.file(kind, elements, span),
        }
    }
}
