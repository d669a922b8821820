//! Runs the AST: scopes, macros, directives, built-in functions.

mod argument;
mod array;
mod builtin;
mod directive;
mod eval;
mod evaluator;
mod function;
mod parsed;
mod pull;
mod reader;
mod reporter;
mod rvalue;
mod scene_builder;
mod statement;
mod stream;
mod token_expr;

use crate::diagnostic::{Diagnostic, Label, codes};
use crate::scene::Scene;
use crate::source::{FileId, Files, Host, LocalHost, Sandbox, Sandboxed, SearchPath, Sources, Span};
use crate::syntax::ast::Symbol;
use crate::syntax::{Granularity, Names};
pub use directive::table as directives;
use evaluator::Evaluator;
pub use evaluator::Timing;
pub use parsed::ParsedFiles;
pub use reader::COLOR_WORDS;
use reporter::Reporter;
pub use rvalue::LATER;
use scene_builder::{SceneBuilder, compat};
pub use statement::STATEMENTS;
use std::sync::Arc;
use std::sync::atomic::AtomicBool;
use stream::{FrameKind, Mode, TokenStream};

/// Every function of scripts that `function { }` does not have: name, arguments, one line.
pub fn functions() -> impl Iterator<Item = (&'static str, &'static str, &'static str)> {
    builtin::usages()
}

/// What a run may do and what it is given.
#[derive(Clone, Debug)]
pub struct Options {
    /// Where includes are looked for.
    pub search: SearchPath,
    /// What the scene may read and write.
    pub sandbox: Sandbox,
    /// `--declare NAME=VALUE`: see [`crate::value::given`].
    pub declares: Vec<(String, String)>,
    /// `--language`: the version in force until the text's own `#version`.
    pub version: Option<f64>,
    /// `clock`, `frame_number` and their kin.
    pub timing: Timing,
    /// `input_file_name`: the scene's, without its folder.
    pub input_name: String,
    /// `image_width`, `image_height`.
    pub size: (usize, usize),
    /// `--max-steps`: elements and loop passes.
    pub max_steps: u64,
    /// `--max-time` in seconds, for the whole run.
    pub max_time: Option<f64>,
    /// `--max-memory` in bytes.
    pub max_memory: Option<u64>,
    /// Clock and memory meter, for the limits and the built-in variable `now`.
    pub host: Arc<dyn Host>,
    /// Ends the run as a limit does when somebody sets it.
    pub stop: Option<Arc<AtomicBool>>,
    /// How much of the text the parser keeps whole; tests have it taken apart.
    pub granularity: Granularity,
    /// Keep through which macros and includes each object came into the scene.
    pub origins: bool,
    /// Note which branches run.
    pub branches: bool,
}

/// A picture of one pixel, no files, and a million steps.
impl Default for Options {
    fn default() -> Self {
        Self {
            search: SearchPath::default(),
            sandbox: Sandbox::default(),
            declares: vec![],
            version: None,
            timing: Timing::default(),
            input_name: String::new(),
            size: (1, 1),
            max_steps: 1_000_000,
            max_time: None,
            max_memory: None,
            host: Arc::new(LocalHost::default()),
            stop: None,
            granularity: Granularity::Whole,
            origins: false,
            branches: false,
        }
    }
}

/// What came of it.
#[derive(Debug, Default)]
pub struct Outcome {
    /// The scene, unless there were errors.
    pub scene: Option<Scene>,
    /// Errors and warnings in the order of the text.
    pub diagnostics: Vec<Diagnostic>,
    /// A limit (steps, memory, time) ended the run: exit code 4.
    pub limit_reached: bool,
    /// If they were to be kept: the macro calls and includes around each of the scene's objects, innermost first.
    pub origins: Vec<Vec<Label>>,
    /// If branches were to be noted: those of `#if`, `#ifdef` and `#switch` that were passed over each time.
    pub idle: Vec<Span>,
}

/// Runs a file that [`Sources`] already holds. `debug` receives what `#debug`, `#render` and `#statistics` print.
///
/// It recurses as deeply as the text nests and macros call each other: give it a stack of some 500 MB.
pub fn interpret(sources: &Sources, file: FileId, options: &Options, debug: &mut dyn FnMut(&str)) -> Outcome {
    interpret_with(&ParsedFiles::default(), sources, file, options, debug)
}

/// The same with the trees that an earlier frame has left.
pub fn interpret_with(
    parsed: &ParsedFiles,
    sources: &Sources,
    file: FileId,
    options: &Options,
    debug: &mut dyn FnMut(&str),
) -> Outcome {
    let files = Sandboxed::new(sources.files(), &options.sandbox);
    let inputs = Inputs { sources, files: &files, names: &parsed.names, parsed, options };
    let mut interpreter = Interpreter::new(inputs, debug);
    interpreter.run(file);
    interpreter.outcome()
}

/// Inputs of a run, shared by all its parts.
#[derive(Clone, Copy)]
struct Inputs<'a> {
    sources: &'a Sources,
    /// The storage, restricted by the sandbox.
    files: &'a dyn Files,
    names: &'a Names,
    parsed: &'a ParsedFiles,
    options: &'a Options,
}

/// One run: the four parts, which know each other only through their interfaces.
pub(crate) struct Interpreter<'a> {
    inputs: Inputs<'a>,
    stream: TokenStream<'a>,
    evaluator: Evaluator<'a>,
    builder: SceneBuilder,
    reporter: Reporter<'a>,
    /// Files by the numbers in [`evaluator::Slot::File`].
    open_files: Vec<directive::OpenFile>,
    /// Bytes that `#write` has written.
    written: u64,
}

impl<'a> Interpreter<'a> {
    fn new(inputs: Inputs<'a>, debug: &'a mut dyn FnMut(&str)) -> Self {
        Self {
            inputs,
            stream: TokenStream::new(inputs),
            evaluator: Evaluator::new(inputs),
            builder: SceneBuilder::new(),
            reporter: Reporter::new(inputs, debug),
            open_files: vec![],
            written: 0,
        }
    }

    fn run(&mut self, file: FileId) {
        self.evaluator.set_version(compat::DEFAULT_VERSION);
        if let Some(version) = self.inputs.options.version {
            self.set_version(compat::version_number(version));
        }
        let Ok(ast) = self.parse_file(file) else { return };
        // Faults at the end of the text are reported at its last offset.
        let end = self.inputs.sources.base(file) + self.inputs.sources.text(file).len();
        self.stream.push_frame(&ast.elements, FrameKind::File, Span::new(end, end));
        while self.next_statement() {}
    }

    /// Reads one statement; false at the end of the scene, and after a fault that ends the run.
    fn next_statement(&mut self) -> bool {
        self.stream.set_mode(Mode::default());
        // Directives and macros run while the next statement is peeked: a fault in them was skipped where it was found.
        let checkpoint = self.stream.checkpoint();
        if let Err(fault) = self.peek() {
            return self.recover(*fault, |me| me.stream.forget_look_ahead(checkpoint));
        }
        let checkpoint = self.stream.checkpoint();
        match self.read_statement() {
            Ok(true) => true,
            Ok(false) => {
                self.finish_scene();
                false
            }
            Err(fault) => self.recover(*fault, |me| me.skip_statement(checkpoint)),
        }
    }

    /// Reports a fault, or the bracket that causes it, and skips what `skip` does; false if the run ends.
    fn recover(&mut self, fault: Diagnostic, skip: impl FnOnce(&mut Self)) -> bool {
        let ends = self.reporter.limit_reached() || fault.code == codes::ENDS_RUN;
        let fault = self.stream.with_trace(fault);
        // What follows an unclosed bracket makes no sense.
        let bracket = match ends {
            true => None,
            false => self.stream.unclosed_bracket().or_else(|| self.reporter.closed_early(&fault)),
        };
        if let Some(d) = bracket {
            self.reporter.report(d);
            return false;
        }
        skip(self);
        self.reporter.report(fault);
        // A fault in a loop's body is reported once, but found in each pass.
        let too_many = self.reporter.count_fault();
        !ends && !too_many
    }

    fn outcome(mut self) -> Outcome {
        let unused = self.evaluator.scopes().unused_faults().cloned().collect();
        self.reporter.finish(unused);
        let failed = self.reporter.error_count() > 0;
        let limit_reached = self.reporter.limit_reached();
        let (scene, origins) = self.builder.into_scene();
        let (diagnostics, idle) = self.reporter.into_diagnostics();
        Outcome { scene: (!failed).then_some(scene), diagnostics, limit_reached, origins, idle }
    }

    /// Sets the language version of the text that follows.
    fn set_version(&mut self, version: u32) {
        self.builder.set_version(version);
        self.evaluator.set_version(version);
    }

    /// Reports a diagnostic with the present call trace.
    fn report_here(&mut self, d: Diagnostic) {
        self.reporter.report(self.stream.with_trace(d));
    }

    /// Reports a division by zero.
    fn division_by_zero(&mut self, span: Span) {
        let d = Diagnostic::new(codes::DIVISION_BY_ZERO, span, "division by zero gives infinity");
        self.report_here(d.label("this is 0"));
    }

    /// The error for a name that is not declared.
    fn undeclared(&self, symbol: Symbol, span: Span) -> Diagnostic {
        let declared = self.evaluator.scopes().names().map(|s| self.inputs.names.text(s));
        self.reporter.undeclared(self.inputs.names.text(symbol), span, declared)
    }
}
