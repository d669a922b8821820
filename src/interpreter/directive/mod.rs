//! Directives of the scene language: each has a file and a row in [`table`].

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
use crate::diagnostic::{Diagnostic, Result, codes, did_you_mean};
use crate::source::Span;
use crate::syntax::ast::{Directive, Symbol};

impl<'a> Interpreter<'a> {
    /// Runs a directive. For branches and loops, pushes a frame so that the body is read next.
    #[inline]
    pub(super) fn run_directive(&mut self, directive: &'a Directive, span: Span) -> Result<()> {
        match directive {
            Directive::Declare(declare) if self.try_declare_number(declare) => Ok(()),
            _ => self.run_general_directive(directive, span),
        }
    }

    /// Runs a directive that is no declaration of a number. (Not inlined: declarations of numbers, which are most of the
    /// directives of a loop, are faster without this code.)
    #[inline(never)]
    fn run_general_directive(&mut self, directive: &'a Directive, span: Span) -> Result<()> {
        match directive {
            Directive::Declare(declare) => self.run_declare(declare),
            Directive::DeclarePieces(local) => self.run_declare_by_tokens(*local, span),
            Directive::If(branches) => self.run_if(branches, span),
            Directive::While(condition, body) => self.run_while(condition, body, span),
            Directive::For(f) => self.run_for(f, span),
            Directive::Switch(value, arms) => self.run_switch(value, arms, span),
            Directive::Macro(definition) => self.define_macro(definition),
            Directive::Plain(word) => self.run_bodiless_directive(directive, *word, span),
        }
    }

    /// Runs a directive without a body. A `#` before another word, as in `#Ball(1)`, is ignored.
    fn run_bodiless_directive(&mut self, directive: &'a Directive, word: Symbol, span: Span) -> Result<()> {
        let name = self.inputs.names.text(word);
        if let Some((name, run)) = table::find_runner(name) {
            return self.run_directive_function(name, run, span);
        }
        let declared = self.evaluator.is_declared(word);
        if declared || crate::syntax::word::lookup(name).is_some() {
            let text = Span { lo: span.hi - name.len() as u32, hi: span.hi };
            let parts = self.inputs.parsed.cached_parts(directive, || self.inputs.tokens_of(text));
            self.stream.push_elements(parts, None, text, false);
            return Ok(());
        }
        self.skip_statement(self.stream.checkpoint());
        let help = did_you_mean(name, table::names()).map(|s| s.replacen('`', "`#", 1));
        let message = format!("there is no directive `#{name}`");
        Diagnostic::new(codes::UNKNOWN_DIRECTIVE, span, message).maybe_help(help).into()
    }

    /// Runs a directive without a body, whose word has been consumed.
    pub(super) fn run_directive_function(&mut self, name: &'static str, run: table::Run, span: Span) -> Result<()> {
        // No other directive runs before this one has read its values.
        let frame_floor = self.stream.frames().len();
        self.in_mode(
            |mode| (mode.defers_directives, mode.frame_floor) = (true, frame_floor),
            |me| {
                let checkpoint = me.stream.checkpoint();
                run(me, name, span).map_err(|fault| me.trace_fault_and_skip(checkpoint, *fault))
            },
        )
    }
}
