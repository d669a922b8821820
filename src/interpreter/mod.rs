//! Runs the syntax tree of a scene file and builds the scene.
//!
//! The run has four parts: [`stream`] holds the tokens, [`evaluator`] the values, [`scene_builder`] the scene and
//! [`reporter`] the diagnostics. The other modules read the language with all four; [`pull`] connects them.

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
use crate::math::cancel::CancelToken;
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
pub use reporter::cancellation_error;
use scene_builder::{SceneBuilder, compat};
pub use statement::STATEMENTS;
use std::path::PathBuf;
use std::sync::Arc;
use stream::{FrameKind, Mode, TokenStream};

/// Returns name, arguments and one-line summary of each function that scripts have and `function { }` does not.
pub fn script_only_functions() -> impl Iterator<Item = (&'static str, &'static str, &'static str)> {
    builtin::script_only_usages()
}

/// Permissions and inputs of one run of the interpreter.
#[derive(Clone, Debug)]
pub struct Options {
    /// Folders that are searched for the files that the scene names: included files, pictures, fonts and others.
    pub search: SearchPath,
    /// Files that the scene may read and write.
    pub sandbox: Sandbox,
    /// Names declared by `--declare NAME=VALUE`; [`crate::value::parse_value`] parses the values.
    pub declares: Vec<(String, String)>,
    /// Language version in force before the scene's own `#version` (`--language`); `None` for the default version.
    pub version: Option<f64>,
    /// Values of `clock`, `frame_number` and the other constants of an animation.
    pub timing: Timing,
    /// Name of a file that is included before the scene, as by a first line `#include`; `None` without such a file.
    pub header: Option<String>,
    /// Value of `input_file_name`: the name of the scene file without its folder.
    pub input_name: String,
    /// Values of the constants `image_width` and `image_height`, in pixels.
    pub size: (usize, usize),
    /// Maximum number of directives, loop passes and macro calls (`--max-steps`).
    pub max_steps: u64,
    /// Maximum duration of the run in seconds (`--max-time`); `None` for no limit.
    pub max_time: Option<f64>,
    /// Maximum memory of the process in bytes (`--max-memory`); `None` for no limit.
    pub max_memory: Option<u64>,
    /// Clock and memory meter, for the limits and the constant `now`.
    pub host: Arc<dyn Host>,
    /// Token with which another thread can end the run.
    pub cancel: CancelToken,
    /// Number of threads that read large meshes and build their hierarchies; 0 for one per processor. The result does
    /// not depend on it.
    pub threads: usize,
    /// Granularity of the syntax tree that the parser produces: whole blocks and expressions, or single tokens.
    pub granularity: Granularity,
    /// True to record the call frames (macro calls and includes) of each object that is added to the scene.
    pub record_origins: bool,
    /// True to record which branches of the scene run.
    pub record_branches: bool,
}

/// Options for a picture of one pixel, no files and a million steps.
impl Default for Options {
    fn default() -> Self {
        Self {
            search: SearchPath::default(),
            sandbox: Sandbox::default(),
            declares: vec![],
            version: None,
            timing: Timing::default(),
            header: None,
            input_name: String::new(),
            size: (1, 1),
            max_steps: 1_000_000,
            max_time: None,
            max_memory: None,
            host: Arc::new(LocalHost::default()),
            cancel: CancelToken::default(),
            threads: 1,
            granularity: Granularity::Whole,
            record_origins: false,
            record_branches: false,
        }
    }
}

/// Result of interpreting a scene file.
#[derive(Debug, Default)]
pub struct Outcome {
    /// The interpreted scene; `None` after errors.
    pub scene: Option<Scene>,
    /// Errors and warnings about the scene, in the order in which they were found; those of the parser follow those of
    /// the run.
    pub diagnostics: Vec<Diagnostic>,
    /// True if a limit on steps, memory or time ended the run (exit code 4).
    pub limit_reached: bool,
    /// Macro calls and includes around each of the scene's objects, innermost first; empty without
    /// [`Options::record_origins`].
    pub origins: Vec<Vec<Label>>,
    /// Paths of the files that the scene wrote to memory, because its sandbox does not allow writing files.
    pub paths_written_in_memory: Vec<PathBuf>,
    /// Branches of `#if`, `#ifdef` and `#switch` that never ran; empty without [`Options::record_branches`].
    pub unused_branches: Vec<Span>,
}

/// Runs a file of `sources`. `debug` receives the output of `#debug`, `#render` and `#statistics`.
///
/// The recursion is as deep as the nesting of the text and of the macro calls, so the stack should have about 500 MB.
pub fn interpret(sources: &Sources, file: FileId, options: &Options, debug: &mut dyn FnMut(&str)) -> Outcome {
    interpret_with(&ParsedFiles::default(), sources, file, options, debug)
}

/// Runs a file like [`interpret`], and reuses the syntax trees of earlier animation frames.
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
    Outcome { paths_written_in_memory: files.paths_written_in_memory(), ..interpreter.outcome() }
}

/// Inputs of a run, which all its parts share.
#[derive(Clone, Copy)]
struct Inputs<'a> {
    sources: &'a Sources,
    /// File storage that the scene may read, restricted by the sandbox.
    files: &'a dyn Files,
    names: &'a Names,
    parsed: &'a ParsedFiles,
    options: &'a Options,
}

/// One run of a scene's text, in four parts that use each other only through their interfaces.
pub(crate) struct Interpreter<'a> {
    inputs: Inputs<'a>,
    stream: TokenStream<'a>,
    evaluator: Evaluator<'a>,
    builder: SceneBuilder,
    reporter: Reporter<'a>,
    /// Files that `#fopen` opened, by the numbers in [`evaluator::Contents::File`].
    open_files: Vec<directive::OpenFile>,
    /// Number of bytes that the scene's `#write` directives have written.
    written: u64,
    /// True if the warning about a `#version` above 3.7 was reported.
    newer_version_reported: bool,
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
            newer_version_reported: false,
        }
    }

    fn run(&mut self, file: FileId) {
        self.evaluator.set_version(compat::DEFAULT_VERSION);
        if let Some(version) = self.inputs.options.version {
            self.set_version(compat::version_number(version));
        }
        let Ok(ast) = self.parse_file(file) else { return };
        // Faults at the end of the text are reported at the file's last offset.
        let end = self.inputs.sources.base(file) + self.inputs.sources.text(file).len();
        self.stream.push_frame(&ast.elements, FrameKind::File, Span::new(end, end));
        self.retokenize_unread_if_old_version();
        if let Some(header) = &self.inputs.options.header
            && let Err(fault) = self.include(header, Span::NONE, Span::NONE)
        {
            return self.report_here(*fault);
        }
        while self.run_statement_unless_end() {}
    }

    /// Reads one statement; returns false at the end of the scene, and after an error that ends the run.
    fn run_statement_unless_end(&mut self) -> bool {
        self.stream.set_mode(Mode::default());
        // Directives and macros run while the next statement is peeked. A fault in them skips only the directive.
        let checkpoint = self.stream.checkpoint();
        if let Err(fault) = self.peek() {
            return self.report_and_can_continue(*fault, |me| me.stream.restore_brackets_only(checkpoint));
        }
        let checkpoint = self.stream.checkpoint();
        match self.read_statement_unless_end() {
            Ok(true) => true,
            Ok(false) => {
                self.finish_scene();
                false
            }
            Err(fault) => self.report_and_can_continue(*fault, |me| me.skip_statement(checkpoint)),
        }
    }

    /// Calls `skip` and reports an error, or reports only the unclosed bracket that causes the error. Returns true if
    /// the run goes on, false if it ends.
    fn report_and_can_continue(&mut self, fault: Diagnostic, skip: impl FnOnce(&mut Self)) -> bool {
        let ends = self.reporter.limit_reached() || fault.code == codes::ENDS_RUN;
        let fault = self.stream.with_call_trace(fault);
        // Text after an unclosed bracket cannot be read.
        let bracket = match ends {
            true => None,
            false => self.stream.unclosed_bracket_error().or_else(|| self.reporter.error_of_early_brace(&fault)),
        };
        if let Some(d) = bracket {
            self.reporter.report(d);
            return false;
        }
        skip(self);
        self.reporter.report(fault);
        // A fault in a loop's body is reported once, but found in each pass.
        let too_many = self.reporter.count_fault_reaches_limit();
        !ends && !too_many
    }

    fn outcome(mut self) -> Outcome {
        let faults_of_declarations = self.evaluator.scopes().faults_of_failed_declarations().cloned().collect();
        self.reporter.report_deferred(faults_of_declarations);
        let failed = self.reporter.error_count() > 0;
        let limit_reached = self.reporter.limit_reached();
        let (scene, origins) = self.builder.into_scene_and_call_traces();
        let (diagnostics, unused_branches) = self.reporter.into_diagnostics_and_unused_branches();
        Outcome {
            scene: (!failed).then_some(scene),
            diagnostics,
            limit_reached,
            origins,
            unused_branches,
            paths_written_in_memory: vec![],
        }
    }

    /// Sets the language version for the rest of the text.
    fn set_version(&mut self, version: u32) {
        self.builder.set_version(version);
        self.evaluator.set_version(version);
        self.retokenize_unread_if_old_version();
    }

    /// Splits the unread part of the file into tokens if the language version is so old that operators are allowed only
    /// inside parentheses: the syntax tree has `<1 -2 3>` as a vector of two numbers.
    fn retokenize_unread_if_old_version(&mut self) {
        if !self.builder.language().bare_operators {
            self.stream.retokenize_unread();
        }
    }

    /// Reports a diagnostic with the present call trace.
    fn report_here(&mut self, d: Diagnostic) {
        self.reporter.report(self.stream.with_call_trace(d));
    }

    /// Reports a division by zero in an expression of the scene.
    fn report_division_by_zero(&mut self, span: Span) {
        let d = Diagnostic::new(codes::DIVISION_BY_ZERO, span, "division by zero gives infinity");
        self.report_here(d.label("this is 0"));
    }

    /// Returns the error for a name that is not declared.
    fn undeclared_name_error(&self, symbol: Symbol, span: Span) -> Diagnostic {
        let declared = self.evaluator.scopes().names().map(|s| self.inputs.names.text(s));
        self.reporter.undeclared_name_error(self.inputs.names.text(symbol), span, declared)
    }
}
