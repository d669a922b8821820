//! Runs the AST: scopes, macros, directives, built-in functions.

mod argument;
mod array;
mod builtin;
mod compat;
mod directive;
mod eval;
mod function;
mod hints;
mod limits;
mod mistake;
mod operators;
mod parsed;
mod pieces;
mod quick;
mod reader;
mod rvalue;
mod scope;
mod stream;
mod timing;
mod top;

use crate::diagnostic::{Diagnostic, Label, Severity, codes};
use crate::font::{self, Font};
use crate::image_io::Picture;
use crate::scene::{Defaults, Scene};
use crate::source::{FileId, Files, Host, LocalHost, Sandbox, Sandboxed, SearchPath, Sources, Span};
use crate::syntax::ast::Symbol;
use crate::syntax::{ListPlaces, Names, Wholes};
use crate::value::{Language, Thing, Value};
use crate::world::Probe;
pub use directive::table as directives;
pub use parsed::ParsedFiles;
pub use reader::COLOR_WORDS;
use rustc_hash::{FxHashMap, FxHashSet};
pub use rvalue::LATER;
use scope::{Place, Scopes, Slot};
use std::cell::RefCell;
use std::collections::BTreeMap;
use std::path::PathBuf;
use std::rc::Rc;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, AtomicU8, Ordering};
use std::time::Duration;
use stream::{FrameKind, Held, Opened, StackFrame, Token};
pub use timing::Timing;
pub use top::STATEMENTS;

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
            host: Arc::new(LocalHost::default()),
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
    let files = Sandboxed::new(sources.files(), &options.sandbox);
    let mut interpreter = Interpreter::new(sources, &files, parsed, options, debug);
    interpreter.run(file);
    interpreter.outcome()
}

/// Everything of one run.
pub(crate) struct Interpreter<'a> {
    sources: &'a Sources,
    /// The storage, restricted by the sandbox.
    files: &'a dyn Files,
    names: &'a Names,
    parsed: &'a ParsedFiles,
    options: &'a Options,
    debug: &'a mut dyn FnMut(&str),
    including: Vec<PathBuf>,
    /// An empty list for the arguments of the next call.
    call_slots: Vec<Option<Slot<'a>>>,
    scopes: Scopes<'a>,
    deprecated: FxHashMap<Symbol, &'a str>,
    /// What constants stand for that never change, by symbol.
    constants: Vec<Option<Value>>,
    /// States of the streams that `seed()` opened.
    random: Vec<u32>,
    /// Declared objects that were asked by rays, by their addresses.
    probes: FxHashMap<*const (), (Arc<dyn Thing>, Rc<Probe>)>,
    /// Decoded picture files.
    pictures: FxHashMap<PathBuf, Arc<Picture>>,
    /// What files of meshes became.
    meshes: FxHashMap<PathBuf, Arc<dyn Thing>>,
    /// Fonts that were read.
    fonts: FxHashMap<font::Place, Arc<Font>>,
    /// What was found of families of fonts.
    families: FxHashMap<String, Option<font::Place>>,
    /// Files by the numbers in [`Slot::File`].
    open_files: Vec<directive::OpenFile>,
    /// Bytes that `#write` has written.
    written: u64,
    /// Where the last place in a list of numbers was found.
    list_places: RefCell<ListPlaces>,
    frames: Vec<StackFrame<'a>>,
    peeked: Option<Token<'a>>,
    /// Tokens that come before those of the frames, the next one last.
    held: Vec<Held<'a>>,
    /// Does a comma stand between what was read last and what comes next?
    comma: bool,
    /// Do directives and macros behind a value wait until it has been used? So it is with what a name gets, with what
    /// an array holds and a macro is given, and with conditions.
    closed: bool,
    /// Is a value read that nobody wants?
    skipping: bool,
    /// Values that are being read inside each other.
    nested: usize,
    /// The element of an array that [`Token::Element`] announces.
    element: Option<Place>,
    /// How many frames there were when the declaration that is being read began.
    floor: usize,
    /// The brackets around here, innermost last.
    opened: Vec<Opened>,
    /// Faults of the text, told behind those of the run.
    late: Vec<Diagnostic>,
    /// Where brackets stand that nothing in the rest of their file closes.
    unclosed: FxHashSet<u32>,
    depth: usize,
    steps: u64,
    /// Bytes of strings made since memory was looked at.
    text_made: usize,
    /// Time on the host's clock.
    started: Duration,
    language: Language,
    /// The number of the scene's noise generator, which functions ask for when they run.
    noise_generator: Arc<AtomicU8>,
    version_stated: bool,
    defaults: Defaults,
    scene: Scene,
    diagnostics: Vec<Diagnostic>,
    limit_reached: bool,
    /// Did a branch run? By its place; noted where [`Options::branches`] asks for it.
    branches: BTreeMap<Span, bool>,
    /// Kept where [`Options::origins`] asks for it.
    origins: Vec<Vec<Label>>,
    /// Faults met, also those that were told before.
    faults: usize,
    /// What earlier faults have left undone.
    mistakes: mistake::Mistakes,
}

impl<'a> Interpreter<'a> {
    fn new(
        sources: &'a Sources,
        files: &'a dyn Files,
        parsed: &'a ParsedFiles,
        options: &'a Options,
        debug: &'a mut dyn FnMut(&str),
    ) -> Self {
        Self {
            sources,
            files,
            names: &parsed.names,
            parsed,
            options,
            debug,
            including: vec![],
            call_slots: vec![],
            scopes: Scopes::default(),
            deprecated: FxHashMap::default(),
            constants: vec![],
            random: vec![],
            probes: FxHashMap::default(),
            pictures: FxHashMap::default(),
            meshes: FxHashMap::default(),
            list_places: RefCell::default(),
            fonts: FxHashMap::default(),
            families: FxHashMap::default(),
            open_files: vec![],
            written: 0,
            frames: vec![],
            peeked: None,
            held: vec![],
            comma: false,
            closed: false,
            skipping: false,
            nested: 0,
            element: None,
            floor: 0,
            opened: vec![],
            late: vec![],
            unclosed: FxHashSet::default(),
            depth: 0,
            steps: 0,
            text_made: 0,
            started: options.host.elapsed(),
            language: Language {
                version: compat::DEFAULT_VERSION,
                bare_textures: false,
                assumed_gamma: None,
                other_gamma: compat::gamma_without_setting(None),
                srgb_files: false,
            },
            noise_generator: Arc::new(AtomicU8::new(compat::noise_generator(compat::DEFAULT_VERSION))),
            version_stated: false,
            defaults: Defaults::default(),
            scene: Scene::default(),
            diagnostics: vec![],
            limit_reached: false,
            branches: BTreeMap::new(),
            origins: vec![],
            faults: 0,
            mistakes: mistake::Mistakes::default(),
        }
    }

    fn run(&mut self, file: FileId) {
        self.keep_constants();
        if let Some(version) = self.options.version {
            self.set_version(compat::version_number(version));
        }
        self.declare_options();
        let Ok(ast) = self.parse_file(file) else { return };
        // What is missing at the end of the text is told there.
        let end = self.sources.base(file) + self.sources.text(file).len();
        self.push_frame(&ast.elements, FrameKind::File, Span::new(end, end));
        loop {
            // Directives and macros run while the next statement is looked for: their faults are met here.
            (self.closed, self.nested) = (false, 0);
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
                let ends = self.limit_reached || fault.code == codes::ENDS_RUN;
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
                self.faults += 1;
                // A fault in a loop's body is told once, but met in every pass.
                if ends || self.faults >= MAX_FAULTS {
                    return;
                }
            }
        }
        self.finish_scene();
    }

    fn outcome(mut self) -> Outcome {
        for d in std::mem::take(&mut self.late) {
            self.report_fault(d);
        }
        let unused: Vec<Diagnostic> = self.scopes.unused_faults().cloned().collect();
        for mut fault in unused.into_iter().filter(|fault| !matches!(fault.code, codes::NOT_YET | codes::FOLLOWS)) {
            fault.severity = Severity::Warning;
            self.report_fault(fault);
        }
        self.diagnostics.retain(|d| d.code != codes::FOLLOWS && d.code != codes::ENDS_RUN);
        self.settle_messages();
        let failed = self.error_count() > 0;
        Outcome {
            scene: (!failed).then_some(self.scene),
            diagnostics: self.diagnostics,
            limit_reached: self.limit_reached,
            origins: self.origins,
            idle: self.branches.into_iter().filter(|(_, ran)| !ran).map(|(span, _)| span).collect(),
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
                Some(Label { span: frame.span, text: format!("in macro `{}`, called", self.names.text(name)) })
            }
            FrameKind::Include => Some(Label { span: frame.span, text: "included".into() }),
            _ => None,
        };
        let all: Vec<Label> = self.frames.iter().rev().filter_map(label).collect();
        if all.len() <= 12 {
            return all;
        }
        all[..6].iter().chain(&all[all.len() - 4..]).cloned().collect()
    }

    /// What follows is of this version of the language.
    fn set_version(&mut self, version: u32) {
        self.language.version = version;
        self.language.bare_textures = compat::has_bare_textures(version);
        if self.scene.settings.noise_generator.is_none() {
            self.noise_generator.store(compat::noise_generator(version), Ordering::Relaxed);
        }
        self.version_stated = true;
    }

    /// The version in force, if the scene has said one.
    fn stated_version(&self) -> Option<u32> {
        self.version_stated.then_some(self.language.version)
    }

    fn division_by_zero(&mut self, span: Span) {
        let d = Diagnostic::new(codes::DIVISION_BY_ZERO, span, "division by zero gives infinity");
        let d = self.with_trace(d.label("this is 0"));
        self.report_fault(d);
    }
}
