//! Finds the fonts that a scene names.

use crate::diagnostic::{Diagnostic, Result, codes};
use crate::font::{self, Font, FontLocation};
use crate::interpreter::Interpreter;
use crate::source::{Span, fonts};
use std::path::{Path, PathBuf};
use std::sync::Arc;

impl Interpreter<'_> {
    /// Finds and parses a font. A name without an extension is that of a TrueType file or else of an installed family.
    /// A font with a similar design or durer's own font replaces a missing one, with a warning.
    ///
    /// # Errors
    /// A diagnostic for a file that the scene may not read, or that is no font.
    pub(super) fn find_font_or_substitute(&mut self, name: &str, at: Span) -> Result<Arc<Font>> {
        let full = if name.contains('.') { name.to_string() } else { format!("{name}.ttf") };
        let place = match self.find_readable_file(&full, at)? {
            Some(path) => FontLocation::first_in_file(path),
            None => {
                match self
                    .installed_font(name)
                    .or_else(|| self.substitute_font(name, &full, at).map(FontLocation::first_in_file))
                {
                    Some(place) => place,
                    None => return Ok(Arc::new(Font::built_in())),
                }
            }
        };
        if let Some(font) = self.evaluator.assets().fonts.get(&place) {
            return Ok(font.clone());
        }
        let font = Arc::new(Font::read(self.inputs.files, &place).map_err(|fault| fault.at(at))?);
        self.evaluator.assets().fonts.insert(place, font.clone());
        Ok(font)
    }

    /// Returns the installed font of a family, which POV-Ray does not support.
    fn installed_font(&mut self, name: &str) -> Option<FontLocation> {
        if fonts::is_font_file_name(Path::new(name)) {
            return None;
        }
        if let Some(known) = self.evaluator.assets().families.get(name) {
            return known.clone();
        }
        let files = fonts::font_files(self.inputs.files, &self.inputs.options.search.fonts);
        let found = font::find_family(self.inputs.files, name, &files);
        self.evaluator.assets().families.insert(name.to_string(), found.clone());
        found
    }

    /// Returns an installed font of this name, or one with a similar design together with a warning; `None`, with a
    /// warning too, if there is neither.
    fn substitute_font(&mut self, name: &str, file_name: &str, at: Span) -> Option<PathBuf> {
        let search = &self.inputs.options.search.fonts;
        let found = fonts::find_similar_font(self.inputs.files, name, search);
        let file = found.as_deref().and_then(Path::file_name).map(|file| file.to_string_lossy().into_owned());
        if file.as_ref().is_some_and(|file| file.eq_ignore_ascii_case(file_name)) {
            return found;
        }
        let what = match file {
            Some(file) => format!(": `{file}` is used instead"),
            None => ": durer's own font, Roboto, is used instead".into(),
        };
        let d = Diagnostic::new(codes::FONT_MISSING, at, format!("the font `{name}` was not found{what}"));
        self.report_here(d.help("fonts are searched in the same folders as included files; -I DIR adds a folder"));
        found
    }
}
