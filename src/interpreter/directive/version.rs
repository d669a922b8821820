//! `#version 3.7;`

use crate::diagnostic::{Diagnostic, Result, codes};
use crate::interpreter::{Interpreter, compat};
use crate::syntax::ast::Expr;
use std::sync::atomic::Ordering;

impl<'a> Interpreter<'a> {
    pub(in crate::interpreter) fn version(&mut self, value: &'a Expr) -> Result<()> {
        let value_span = value.span;
        let number = self.number(value)?;
        let version = compat::version_number(number);
        if version > compat::NEWEST_VERSION {
            let message = format!("this scene asks for version {number} of the language; durer knows up to 3.8");
            self.report_fault(Diagnostic::new(codes::NEWER_VERSION, value_span, message));
        }
        self.language.version = version;
        if self.scene.settings.noise_generator.is_none() {
            self.noise_generator.store(compat::noise_generator(version), Ordering::Relaxed);
        }
        self.language.bare_textures = compat::has_bare_textures(version);
        self.version_stated = true;
        Ok(())
    }
}
