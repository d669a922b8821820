//! Table of common mistakes, mostly habits from other languages.

use super::source_line::SourceLine;
use super::{directive, operator, statement};
use crate::diagnostic::{Code, Diagnostic, Label, codes};
use crate::source::Span;
use std::ops::Range;

/// A recognized common mistake in a scene, with replacements for the texts of the error.
#[derive(Default)]
pub(super) struct CommonMistake {
    /// Diagnostic code that replaces the one of the error; `None` for no replacement.
    pub(super) code: Option<Code>,
    /// Message that replaces the message of the error.
    pub(super) message: Option<String>,
    /// Range that replaces the error's span, in offsets within the file.
    pub(super) range: Option<Range<usize>>,
    /// Text of the help for the recognized mistake.
    pub(super) help: String,
    /// Names that stay undeclared because of the mistake.
    pub(super) names_left_undeclared: Vec<String>,
    /// Include file that was not read because of the mistake.
    pub(super) file: Option<String>,
    /// True if a directive with a body was meant, so that its `#end` is surplus.
    pub(super) loses_directive: bool,
}

impl CommonMistake {
    /// Creates a mistake that replaces only the error's help.
    pub(super) fn with_help(text: impl Into<String>) -> Self {
        Self { help: text.into(), ..Self::default() }
    }

    pub(super) fn message(mut self, text: impl Into<String>) -> Self {
        self.message = Some(text.into());
        self
    }

    pub(super) fn range(mut self, file_range: Range<usize>) -> Self {
        self.range = Some(file_range);
        self
    }

    pub(super) fn code(mut self, code: Code) -> Self {
        self.code = Some(code);
        self
    }

    /// Records that the mistake leaves `name` undeclared, so that errors about later uses of the name are suppressed.
    pub(super) fn leaving_undeclared(mut self, name: &str) -> Self {
        self.names_left_undeclared.push(name.into());
        self
    }

    /// Applies the replacements to the error's diagnostic; `base_in_sources` is the global offset of the file.
    pub(super) fn apply_to(self, mut d: Diagnostic, base_in_sources: usize) -> Diagnostic {
        if let Some(range) = self.range {
            d.labels = vec![Label {
                span: Span::new(base_in_sources + range.start, base_in_sources + range.end),
                text: String::new(),
            }];
        }
        d.code = self.code.unwrap_or(d.code);
        d.message = self.message.unwrap_or(d.message);
        d.missing_names = None;
        d.help(self.help)
    }
}

type Recognizer = fn(&SourceLine, &Diagnostic) -> Option<CommonMistake>;

/// Functions that recognize common mistakes, in order of precedence.
const COMMON_MISTAKES: &[Recognizer] = &[
    directive::hex_color,
    directive::define_directive,
    directive::other_elseif_spelling,
    directive::other_end_spelling,
    directive::assignment_after_hash,
    directive::comment_after_hash,
    directive::misspelt_directive,
    directive::else_if,
    directive::c_style_for,
    directive::file_without_quotes,
    directive::braces_around_body,
    directive::directive_without_hash,
    statement::function_definition,
    statement::in_place_assignment,
    statement::typed_variable,
    statement::assignment_without_declare,
    statement::modifier_behind_object,
    operator::operator_at_end,
    operator::not_equal,
    operator::doubled_operator,
    operator::operator_as_word,
    operator::equal_behind_word,
    operator::index_with_comma,
    operator::vector_without_commas,
    operator::list_behind_word,
    operator::square_vector,
    operator::list_in_parentheses,
];

/// Codes of errors that a common mistake can cause.
const CODES: &[Code] = &[
    codes::SYNTAX,
    codes::UNKNOWN_DIRECTIVE,
    codes::EXPECTED,
    codes::EXPECTED_VALUE,
    codes::UNDECLARED,
    codes::UNKNOWN_WORD,
    codes::WRONG_COUNT,
    codes::WRONG_TYPE,
    codes::NOT_CALLABLE,
];

/// Returns the common mistake that caused an error.
pub(super) fn find(source: &SourceLine, d: &Diagnostic) -> Option<CommonMistake> {
    if !CODES.contains(&d.code) {
        return None;
    }
    COMMON_MISTAKES.iter().find_map(|recognise| recognise(source, d))
}
