//! Errors about undeclared names.

use super::missing::{include_help, include_message};
use crate::diagnostic::{Diagnostic, MissingNames, Remedy, codes, nearest};
use crate::interpreter::reporter::{Reporter, hints};
use crate::library;
use crate::source::Span;
use crate::syntax::word;

impl Reporter<'_> {
    /// Returns the error for a name that is not declared, with the include file that declares it or the name that was
    /// probably meant. `declared` are the names that are declared at present.
    pub fn undeclared_name_error<'n>(
        &self,
        name: &str,
        span: Span,
        declared: impl Iterator<Item = &'n str>,
    ) -> Diagnostic {
        // Of a call, only the name is marked.
        let named = self.inputs.sources.snippet(span).starts_with(name);
        let span = if named { Span { hi: span.lo + name.len() as u32, ..span } } else { span };
        let d = Diagnostic::new(codes::UNDECLARED, span, format!("`{name}` is not declared"));
        if let Some(file) = self.include_missing_for(name) {
            let d = Diagnostic::new(codes::UNDECLARED, span, include_message(name, file)).help(include_help(file));
            return d.with_missing_names(MissingNames::new(Remedy::Include(file), name, span));
        }
        let d = d.with_missing_names(MissingNames::new(Remedy::Declare, name, span));
        let help = hints::povray_3_8_name_hint(name)
            .map(String::from)
            .or_else(|| meant_name_hint(name, declared))
            .or_else(|| hints::other_tool_hint(name).map(String::from))
            .or_else(|| meant_word_hint(name));
        let help = help.or_else(|| meant_include_hint(name));
        d.help(help.unwrap_or_else(|| self.declaration_help(name, span)))
    }

    fn declaration_help(&self, name: &str, span: Span) -> String {
        let called = self.inputs.sources.locate(span).is_some_and(|(file, range)| {
            self.inputs.sources.text(file).get(range.end..).unwrap_or_default().trim_start().starts_with('(')
        });
        match called {
            true => format!(
                "`#macro {name}(…) … #end` or `#declare {name} = function(…) {{…}};` declares it; is an `#include` missing?"
            ),
            false => format!("`#declare {name} = …;` gives it a value; is an `#include` missing?"),
        }
    }
}

/// Returns the hint "did you mean …?" with a declared name of nearly the same spelling.
fn meant_name_hint<'n>(name: &str, declared: impl Iterator<Item = &'n str>) -> Option<String> {
    // A lower-case word of another tool is no misspelling.
    if hints::other_tool_hint(name).is_some() && !name.starts_with(char::is_uppercase) {
        return None;
    }
    nearest(name, declared).map(|found| format!("did you mean `{found}`?"))
}

/// Returns the hint "did you mean …?" with a keyword, function or constant of nearly the same spelling.
fn meant_word_hint(name: &str) -> Option<String> {
    let words = word::KEYWORDS.iter().chain(word::FUNCTIONS).copied().chain(word::CONSTANTS.iter().map(|c| c.0));
    // Words of the language are in lower case: a capitalized name is a misspelling of one only if nothing else differs.
    let capital = name.starts_with(char::is_uppercase);
    nearest(name, words.filter(|w| !capital || w.eq_ignore_ascii_case(name)))
        .map(|found| format!("did you mean `{found}`?"))
}

/// Returns the hint "did you mean …?" with a name of nearly the same spelling that a standard include file declares.
fn meant_include_hint(name: &str) -> Option<String> {
    // Short names resemble too many others.
    let near =
        nearest(name, library::standard_names()).filter(|found| name.len() > 4 || found.eq_ignore_ascii_case(name))?;
    let file = library::standard_file_of(near)?;
    Some(format!("did you mean `{near}`? `#include \"{file}\"` declares it"))
}
