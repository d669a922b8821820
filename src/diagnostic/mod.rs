//! What is told to the user: a code, a place, the reason and the remedy.

mod cause;
pub mod codes;
#[cfg(feature = "cli")]
pub mod draw;
pub mod file;
mod suggest;

pub use cause::{Cause, Remedy};
pub use codes::Code;
pub use suggest::{did_you_mean, nearest};

use crate::source::{Sources, Span};

/// How bad it is.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Severity {
    /// The picture may not be what was meant.
    Warning,
    /// The scene can't be drawn.
    Error,
}

impl Severity {
    /// `error` or `warning`.
    pub fn name(self) -> &'static str {
        if self == Severity::Error { "error" } else { "warning" }
    }
}

/// A place with a few words about it.
#[derive(Clone, Debug, PartialEq)]
pub struct Label {
    /// Where.
    pub span: Span,
    /// What is there; may be empty.
    pub text: String,
}

/// One message. It is made where the fault is found and drawn in [`draw`] alone.
#[derive(Clone, Debug, PartialEq)]
pub struct Diagnostic {
    /// Stable; `durer explain CODE` tells more.
    pub code: Code,
    /// Follows from the code unless an unused declaration turned it into a warning.
    pub severity: Severity,
    /// Lower case, says found and expected, names in backticks.
    pub message: String,
    /// The first one is the place of the fault.
    pub labels: Vec<Label>,
    /// What to type instead.
    pub help: Option<String>,
    /// The chain of "in macro `M`, called here", "included from here", innermost first.
    pub trace: Box<[Label]>,
    /// What it shares with others: those of one cause become one message.
    pub cause: Option<Box<Cause>>,
}

/// An error on its way up; boxed because the way down is the fast one.
pub type Fault = Box<Diagnostic>;

/// What everything that can meet a fault returns.
pub type Result<T, E = Fault> = std::result::Result<T, E>;

impl Diagnostic {
    /// A message of this code at this place.
    pub fn new(code: Code, span: Span, message: impl Into<String>) -> Self {
        let labels = if span.is_none() { vec![] } else { vec![Label { span, text: String::new() }] };
        let (message, help, trace) = (message.into(), None, Box::default());
        Self { code, severity: code.severity(), message, labels, help, trace, cause: None }
    }

    /// As an `Err`, ready for `?`.
    ///
    /// # Errors
    /// Always.
    pub fn err<T>(code: Code, span: Span, message: impl Into<String>) -> Result<T> {
        Err(Box::new(Self::new(code, span, message)))
    }

    /// Says what the first place is.
    pub fn label(mut self, text: impl Into<String>) -> Self {
        if let Some(first) = self.labels.first_mut() {
            first.text = text.into();
        }
        self
    }

    /// Adds another place.
    pub fn also(mut self, span: Span, text: impl Into<String>) -> Self {
        if !span.is_none() {
            self.labels.push(Label { span, text: text.into() });
        }
        self
    }

    /// Adds what to type instead.
    pub fn help(mut self, text: impl Into<String>) -> Self {
        self.help = Some(text.into());
        self
    }

    /// Says what it shares with other messages.
    pub fn because(mut self, cause: Cause) -> Self {
        self.cause = Some(Box::new(cause));
        self
    }

    /// The same with help where there is some.
    pub fn maybe_help(mut self, text: Option<String>) -> Self {
        self.help = text.or(self.help);
        self
    }

    /// The same about this place, for faults that were found below the text.
    pub fn at(mut self, span: Span) -> Box<Self> {
        self.labels = vec![Label { span, text: String::new() }];
        Box::new(self)
    }

    /// Returns the message on one line, as compilers print it and editors read it: `a.scene:3:7: error[E0204]: message`.
    pub fn line(&self, sources: &Sources) -> String {
        let place = sources.place(self.span()).map(|place| format!("{place}: ")).unwrap_or_default();
        format!("{place}{}[{}]: {}", self.severity.name(), self.code, self.message.replace('\n', " "))
    }

    /// The place of the fault.
    pub fn span(&self) -> Span {
        self.labels.first().map_or(Span::NONE, |l| l.span)
    }
}

impl<T> From<Diagnostic> for Result<T> {
    fn from(d: Diagnostic) -> Self {
        Err(Box::new(d))
    }
}
