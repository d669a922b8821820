//! Runs the AST: scopes, macros, directives, built-in functions.

use crate::diagnostic::Diagnostic;
use crate::scene::Scene;
use crate::source::{FileId, SearchPath, Sources};

/// What a run may do and what it is given.
#[derive(Clone, Debug)]
pub struct Options {
    /// Where includes are looked for.
    pub search: SearchPath,
    /// `--declare NAME=VALUE`: numbers, or text in quotes.
    pub declares: Vec<(String, String)>,
    /// `clock`, `frame_number` and their kin.
    pub clock: f64,
    /// The number of the frame, 0 without animation.
    pub frame: u32,
    /// `image_width`, `image_height`.
    pub size: (usize, usize),
    /// `--max-steps`: elements and loop passes.
    pub max_steps: u64,
    /// `--max-time` in seconds, for the whole run.
    pub max_time: Option<f64>,
    /// `--max-memory` in bytes.
    pub max_memory: Option<u64>,
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
}

/// Runs a file that [`Sources`] already holds. `debug` receives what `#debug`, `#warning` and `#statistics` print.
pub fn interpret(_sources: &Sources, _file: FileId, _options: &Options, _debug: &mut dyn FnMut(&str)) -> Outcome {
    Outcome { scene: Some(Scene::default()), ..Outcome::default() }
}
