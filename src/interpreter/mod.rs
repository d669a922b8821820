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

use crate::diagnostic::{Diagnostic, Label, Severity, codes};
use crate::scene::Scene;
use crate::source::{FileId, Sandbox, SearchPath, Sources, Span};
use crate::syntax::{Names, Wholes};
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
use std::sync::atomic::{AtomicBool, Ordering};
use stream::{FrameKind, StackFrame, TokenStream};

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
    /// Ends the run as a limit does when somebody sets it.
    pub stop: Option<Arc<AtomicBool>>,
    /// How much of the text the parser keeps whole; tests have it taken apart.
    pub wholes: Wholes,
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
            stop: None,
            wholes: Wholes::Kept,
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

/// A run ends after so many faults, though they be the same again and again.
const MAX_FAULTS: usize = 200;

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
    let mut interpreter = Interpreter::new(sources, parsed, options, debug);
    interpreter.run(file);
    interpreter.outcome()
}

/// Inputs of a run, shared by all its parts.
#[derive(Clone, Copy)]
struct Inputs<'a> {
    sources: &'a Sources,
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
    files: Vec<directive::OpenFile>,
    /// Bytes that `#write` has written.
    written: u64,
}

impl<'a> Interpreter<'a> {
    fn new(
        sources: &'a Sources,
        parsed: &'a ParsedFiles,
        options: &'a Options,
        debug: &'a mut dyn FnMut(&str),
    ) -> Self {
        Self {
            inputs: Inputs { sources, names: &parsed.names, parsed, options },
            stream: TokenStream::default(),
            evaluator: Evaluator::default(),
            builder: SceneBuilder::new(),
            reporter: Reporter::new(debug),
            files: vec![],
            written: 0,
        }
    }

    fn run(&mut self, file: FileId) {
        self.keep_constants();
        if let Some(version) = self.inputs.options.version {
            self.set_version(compat::version_number(version));
        }
        self.declare_options();
        let Ok(ast) = self.parse_file(file) else { return };
        // What is missing at the end of the text is told there.
        let end = self.inputs.sources.base(file) + self.inputs.sources.text(file).len();
        self.push_frame(&ast.elements, FrameKind::File, Span::new(end, end));
        loop {
            // Directives and macros run while the next statement is looked for: their faults are met here.
            (self.stream.closed, self.stream.nested) = (false, 0);
            let mut mark = self.mark();
            let failed = match self.peek() {
                Err(fault) => Some((fault, false)),
                Ok(_) => {
                    mark = self.mark();
                    match self.statement() {
                        Ok(true) => None,
                        Ok(false) => break,
                        Err(fault) => Some((fault, true)),
                    }
                }
            };
            if let Some((fault, in_statement)) = failed {
                let ends = self.reporter.limit_reached || fault.code == codes::ENDS_RUN;
                let fault = self.with_trace(*fault);
                // What follows a bracket that is not closed makes no sense.
                let told = if ends { None } else { self.unclosed_bracket().or_else(|| self.closed_early(&fault)) };
                if let Some(d) = told {
                    self.report_fault(d);
                    return;
                }
                // A directive that failed has been passed.
                if in_statement {
                    self.skip_statement(mark)
                } else {
                    self.forget_ahead(mark)
                }
                self.report_fault(fault);
                self.reporter.faults += 1;
                // A fault in a loop's body is told once, but met in every pass.
                if ends || self.reporter.faults >= MAX_FAULTS {
                    return;
                }
            }
        }
        self.finish_scene();
    }

    fn outcome(mut self) -> Outcome {
        for d in std::mem::take(&mut self.reporter.late) {
            self.report_fault(d);
        }
        let unused: Vec<Diagnostic> = self.evaluator.scopes.unused_faults().cloned().collect();
        for mut fault in unused.into_iter().filter(|fault| !matches!(fault.code, codes::NOT_YET | codes::FOLLOWS)) {
            fault.severity = Severity::Warning;
            self.report_fault(fault);
        }
        self.reporter.diagnostics.retain(|d| d.code != codes::FOLLOWS && d.code != codes::ENDS_RUN);
        self.settle_messages();
        let failed = self.error_count() > 0;
        Outcome {
            scene: (!failed).then_some(self.builder.scene),
            diagnostics: self.reporter.diagnostics,
            limit_reached: self.reporter.limit_reached,
            origins: self.builder.origins,
            idle: self.reporter.branches.into_iter().filter(|(_, ran)| !ran).map(|(span, _)| span).collect(),
        }
    }

    fn with_trace(&self, mut d: Diagnostic) -> Diagnostic {
        if d.trace.is_empty() {
            d.trace = self.trace().into();
        }
        d
    }

    /// The macro calls and includes around here, innermost first; of a deep recursion both ends.
    fn trace(&self) -> Vec<Label> {
        let label = |frame: &StackFrame| match frame.kind {
            FrameKind::Macro(name) => {
                Some(Label { span: frame.span, text: format!("in macro `{}`, called", self.inputs.names.text(name)) })
            }
            FrameKind::Include => Some(Label { span: frame.span, text: "included".into() }),
            _ => None,
        };
        let all: Vec<Label> = self.stream.frames.iter().rev().filter_map(label).collect();
        if all.len() <= 12 {
            return all;
        }
        all[..6].iter().chain(&all[all.len() - 4..]).cloned().collect()
    }

    /// What follows is of this version of the language.
    fn set_version(&mut self, version: u32) {
        self.builder.language.version = version;
        self.builder.language.bare_textures = compat::has_bare_textures(version);
        if self.builder.scene.settings.noise_generator.is_none() {
            self.builder.noise_generator.store(compat::noise_generator(version), Ordering::Relaxed);
        }
        self.builder.version_stated = true;
    }

    /// The version in force, if the scene has said one.
    fn stated_version(&self) -> Option<u32> {
        self.builder.version_stated.then_some(self.builder.language.version)
    }

    fn division_by_zero(&mut self, span: Span) {
        let d = Diagnostic::new(codes::DIVISION_BY_ZERO, span, "division by zero gives infinity");
        let d = self.with_trace(d.label("this is 0"));
        self.report_fault(d);
    }
}
