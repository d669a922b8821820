//! The directive `#version 3.7;`.

use crate::diagnostic::{Diagnostic, Result, codes};
use crate::interpreter::stream::Token;
use crate::interpreter::{Interpreter, scene_builder::compat};
use crate::syntax::ast::{Expr, ExprKind};

impl Interpreter<'_> {
    pub fn run_version(&mut self) -> Result<()> {
        // In `#version unofficial patch 3.7;` the words of MegaPOV are ignored.
        while let Token::Expr(Expr { kind: ExprKind::Name(symbol), .. }) = self.peek()?
            && self.evaluator.is_unknown(*symbol)
        {
            self.stream.advance();
        }
        let (number, value_span) = self.read_number()?;
        let version = compat::version_number(number);
        // A scene may state its version many times.
        if version > compat::DEFAULT_VERSION && !self.newer_version_reported {
            self.newer_version_reported = true;
            let (message, help) = if version > compat::NEWEST_VERSION {
                (
                    format!("this scene states version {number} of the language; durer supports up to 3.8"),
                    "words that durer does not know are errors; the rest is rendered as in 3.7",
                )
            } else {
                (
                    format!("version {number} of the language is rendered as 3.7"),
                    "dictionaries, mixed arrays, optional parameters and several names in one `#declare` are read as in 3.8",
                )
            };
            self.reporter.report(Diagnostic::new(codes::NEWER_VERSION, value_span, message).help(help));
        }
        self.set_version(version);
        Ok(())
    }
}
