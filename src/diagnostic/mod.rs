//! Messages to the user: code, place, reason and help.

pub mod codes;
#[cfg(feature = "cli")]
pub mod draw;
pub mod file;
mod missing_names;
mod suggest;

pub use codes::Code;
pub use missing_names::{MissingNames, Remedy};
pub use suggest::{did_you_mean, nearest};

use crate::source::{Sources, Span};

/// Text for an editor or a browser after a panic; the terminal shows details.
pub const INTERNAL_FAILURE: &str = "durer has failed, which is a bug; please report it";

/// Severity of a diagnostic: error or warning.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Severity {
    /// Severity of a warning: the picture may not be the intended one.
    Warning,
    /// Severity of an error: the scene can't be rendered.
    Error,
}

impl Severity {
    /// Returns the severity's name, `error` or `warning`.
    pub fn name(self) -> &'static str {
        if self == Severity::Error { "error" } else { "warning" }
    }
}

/// A marked place in a source text, with a short description.
#[derive(Clone, Debug, PartialEq)]
pub struct Label {
    /// Span of source text that the label marks.
    pub span: Span,
    /// Description of the label's place; may be empty.
    pub text: String,
}

/// One message to the user. Only [`draw`] renders it.
#[derive(Clone, Debug, PartialEq)]
pub struct Diagnostic {
    /// Stable code of the diagnostic; `durer explain CODE` explains it.
    pub code: Code,
    /// Severity of the code, unless an unused declaration lowers it to a warning, or `--deny warnings` raises it to an error.
    pub severity: Severity,
    /// Text of the message, in lower case, which says what was found and what was expected, with names in backticks.
    pub message: String,
    /// Places of the diagnostic; the first label is the place of the fault.
    pub labels: Vec<Label>,
    /// Replacement text or advice that the diagnostic gives as help.
    pub help: Option<String>,
    /// Call frames of the fault, innermost first: "in macro `M`, called here", "included from here".
    pub trace: Box<[Label]>,
    /// Missing names that cause the message; `None` for a message with another cause. Messages about the same missing
    /// names are merged.
    pub missing_names: Option<Box<MissingNames>>,
}

/// An error that functions return; boxed so that the success path is fast.
pub type Fault = Box<Diagnostic>;

/// The result of every function that can fail with a diagnostic.
pub type Result<T, E = Fault> = std::result::Result<T, E>;

impl Diagnostic {
    /// Creates a diagnostic with a code and the span of the fault.
    pub fn new(code: Code, span: Span, message: impl Into<String>) -> Self {
        let labels = if span.is_none() { vec![] } else { vec![Label { span, text: String::new() }] };
        let (message, help, trace) = (message.into(), None, Box::default());
        Self { code, severity: code.severity(), message, labels, help, trace, missing_names: None }
    }

    /// Creates a diagnostic and returns it as an `Err`.
    ///
    /// # Errors
    /// Always.
    pub fn err<T>(code: Code, span: Span, message: impl Into<String>) -> Result<T> {
        Err(Box::new(Self::new(code, span, message)))
    }

    /// Sets the text of the first label; does nothing for a diagnostic without a label.
    pub fn label(mut self, text: impl Into<String>) -> Self {
        if let Some(first) = self.labels.first_mut() {
            first.text = text.into();
        }
        self
    }

    /// Adds another label to the diagnostic, unless `span` is [`Span::NONE`].
    pub fn also(mut self, span: Span, text: impl Into<String>) -> Self {
        if !span.is_none() {
            self.labels.push(Label { span, text: text.into() });
        }
        self
    }

    /// Sets the help of the diagnostic.
    pub fn help(mut self, text: impl Into<String>) -> Self {
        self.help = Some(text.into());
        self
    }

    /// Sets the missing names that cause the diagnostic; messages about the same names are merged.
    pub fn with_missing_names(mut self, names: MissingNames) -> Self {
        self.missing_names = Some(Box::new(names));
        self
    }

    /// Sets the help of the diagnostic, if `text` is some; `None` keeps the help.
    pub fn maybe_help(mut self, text: Option<String>) -> Self {
        self.help = text.or(self.help);
        self
    }

    /// Replaces all labels by one without text at `span`, for faults from functions that don't know the scene's text.
    pub fn at(mut self, span: Span) -> Box<Self> {
        self.labels = vec![Label { span, text: String::new() }];
        Box::new(self)
    }

    /// Returns the message on one line, as compilers print it and editors read it: `a.scene:3:7: error[E0204]: message`.
    pub fn line(&self, sources: &Sources) -> String {
        let place = sources.place(self.span()).map(|place| format!("{place}: ")).unwrap_or_default();
        format!("{place}{}[{}]: {}", self.severity.name(), self.code, self.message.replace('\n', " "))
    }

    /// Returns the span of the fault, which is that of the first label; [`Span::NONE`] without labels.
    pub fn span(&self) -> Span {
        self.labels.first().map_or(Span::NONE, |l| l.span)
    }
}

impl<T> From<Diagnostic> for Result<T> {
    fn from(d: Diagnostic) -> Self {
        Err(Box::new(d))
    }
}
