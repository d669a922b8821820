//! Fonts that a scene names.

use crate::diagnostic::{Diagnostic, Result, codes};
use crate::font::Font;
use crate::interpreter::Interpreter;
use crate::source::{Span, fonts};
use std::path::{Path, PathBuf};
use std::sync::Arc;

impl Interpreter<'_> {
    /// See [`crate::value::Reader::font`]. A name without ending means ttf.
    pub(super) fn font_named(&mut self, name: &str, at: Span) -> Result<Arc<Font>> {
        let full = if name.contains('.') { name.to_string() } else { format!("{name}.ttf") };
        let path = match self.find_read_file(&full, at)? {
            Some(path) => path,
            None => match self.stand_in(name, &full, at) {
                Some(path) => path,
                None => return Ok(Arc::new(Font::own())),
            },
        };
        if let Some(font) = self.fonts.get(&path) {
            return Ok(font.clone());
        }
        let font = Arc::new(Font::read(&path).map_err(|fault| fault.at(at))?);
        self.fonts.insert(path, font.clone());
        Ok(font)
    }

    /// A font of the system: the one of this name, or one that looks like it, which is told.
    fn stand_in(&mut self, name: &str, full: &str, at: Span) -> Option<PathBuf> {
        let search = &self.options.search.fonts;
        let found = fonts::similar(name, search, |path| self.options.sandbox.may_read(path));
        let file = found.as_deref().and_then(Path::file_name).map(|file| file.to_string_lossy().into_owned());
        if file.as_ref().is_some_and(|file| file.eq_ignore_ascii_case(full)) {
            return found;
        }
        let what = match file {
            Some(file) => format!(": `{file}` stands for it"),
            None => ": durer's own one, Roboto, stands for it".into(),
        };
        let d = Diagnostic::new(codes::FONT_MISSING, at, format!("the font `{name}` was not found{what}"));
        let d = self.with_trace(d.help("fonts are looked for where included files are; -I DIR adds a folder"));
        self.report_fault(d);
        found
    }
}
