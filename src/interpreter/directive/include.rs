//! The directive `#include "name"`.

use crate::diagnostic::{Diagnostic, Result, Severity, codes, file, nearest};
use crate::interpreter::Interpreter;
use crate::interpreter::reporter::{MAX_INCLUDES, hints};
use crate::interpreter::token_expr::joined_span_if_near;
use crate::library;
use crate::source::{FileId, Found, Span, read_text};
use crate::syntax::ast::Ast;
use crate::syntax::parse;
use std::path::{Path, PathBuf};

impl<'a> Interpreter<'a> {
    pub fn run_include(&mut self, span: Span) -> Result<()> {
        let (text, name) = self.read_text_value()?;
        self.include(&text, name, joined_span_if_near(span, name))
    }

    /// Includes the file `file_name`: its tokens come next. `name_span` is the span of the file's name, `span` of the directive.
    pub fn include(&mut self, file_name: &str, name_span: Span, span: Span) -> Result<()> {
        if self.stream.include_paths().len() >= MAX_INCLUDES {
            let message = format!("`{file_name}` is included inside {MAX_INCLUDES} includes");
            return self.reporter.limit_error(codes::INCLUDE_DEPTH, span, message, "does a file include itself?");
        }
        let (path, ast) = match self.find_readable_file(file_name, name_span)? {
            Some(path) => (path.clone(), self.load(&path, file_name, name_span)?),
            None => match library::builtin_file_text(file_name) {
                Some(built_in) => self.load_built_in(file_name, built_in, name_span)?,
                None => return Err(self.missing_include_error(file_name, name_span).into()),
            },
        };
        self.evaluator.scopes_mut().enter_scope();
        self.stream.push_include(path, &ast.elements, span);
        self.retokenize_unread_if_old_version();
        Ok(())
    }

    /// Finds a file that the scene names. Returns `None` without a message if the file does not exist, and an error if
    /// the scene may not read it.
    pub fn find_readable_file(&mut self, name: &str, span: Span) -> Result<Option<PathBuf>> {
        let including = self.stream.include_paths().last().map(PathBuf::as_path);
        // The name as typed: in `"C:\new\shapes.inc"`, `\n` is no line feed.
        let typed = self.inputs.sources.snippet(span);
        let typed = typed.strip_prefix('"').and_then(|t| t.strip_suffix('"')).filter(|t| t.contains('\\'));
        let search = &self.inputs.options.search;
        let found = search.resolve(self.inputs.files, name, including);
        let found = found.or_else(|| search.resolve(self.inputs.files, typed?, including));
        let name = typed.unwrap_or(name);
        if let Some(Found { portable: Some(portable), .. }) = &found {
            let message = format!("there is no file `{name}`; `{portable}` is read instead");
            let d = Diagnostic::new(codes::OTHER_SPELLING, span, message);
            self.report_here(d.help(format!("write \"{portable}\", which every system finds")));
        }
        match found.map(|found| found.path) {
            Some(path) if !self.inputs.files.may_read(&path) => {
                let folder = path.parent().unwrap_or(Path::new(".")).display().to_string();
                Diagnostic::new(codes::FORBIDDEN_FILE, span, format!("the scene may not read `{name}`"))
                    .help(format!("scenes read below their own folder and the include paths; `--allow-read {folder}` allows this one"))
                    .into()
            }
            found => Ok(found),
        }
    }

    /// Returns the syntax tree of a file, which is read and parsed once.
    fn load(&mut self, path: &Path, name: &str, span: Span) -> Result<&'a Ast> {
        let file = self.source_file(path, name, span)?;
        self.parse_file(file)
    }

    /// Returns the id in `Sources` of the text of an included file, which is read again only if the file has changed.
    pub fn source_file(&mut self, path: &Path, name: &str, span: Span) -> Result<FileId> {
        if let Some(file) = self.inputs.parsed.unchanged_file(self.inputs.files, path) {
            return Ok(file);
        }
        let text = read_text(self.inputs.files, path).map_err(|e| {
            let message = file::unreadable(self.inputs.files, path, &e).message;
            Box::new(Diagnostic::new(codes::UNREADABLE_INCLUDE, span, message))
        })?;
        let Some(file) = self.inputs.sources.add(name, Some(path), text) else {
            return self.reporter.limit_error(
                codes::MEMORY_LIMIT,
                span,
                "the scene's text is larger than 4 GB".into(),
                "split it",
            );
        };
        self.inputs.parsed.add_file(self.inputs.files, path, file);
        Ok(file)
    }

    /// Returns path and syntax tree of a file of the built-in library. No real file has such a path.
    fn load_built_in(&mut self, name: &str, text: &str, span: Span) -> Result<(PathBuf, &'a Ast)> {
        let path = Path::new(library::FOLDER).join(name);
        if let Some(ast) =
            self.inputs.parsed.unchanged_file(self.inputs.files, &path).and_then(|file| self.inputs.parsed.tree(file))
        {
            return Ok((path, ast));
        }
        let Some(file) = self.inputs.sources.add(&path.to_string_lossy(), None, text.to_string()) else {
            return self.reporter.limit_error(
                codes::MEMORY_LIMIT,
                span,
                "the scene's text is larger than 4 GB".into(),
                "split it",
            );
        };
        let ast = self.parse_file(file)?;
        self.inputs.parsed.add_file(self.inputs.files, &path, file);
        Ok((path, ast))
    }

    /// Returns the syntax tree of a file in [`crate::source::Sources`], which is parsed once. Faults of its syntax are
    /// reported here, and the error that is returned after them ends the run.
    pub fn parse_file(&mut self, file: FileId) -> Result<&'a Ast> {
        if let Some(ast) = self.inputs.parsed.tree(file) {
            self.stream.add_unclosed_brackets(ast);
            return Ok(ast);
        }
        let (ast, mut faults) = parse(self.inputs.sources, file, self.inputs.names, self.inputs.options.granularity);
        self.reporter.defer(faults.extract_if(.., |fault| fault.severity == Severity::Warning));
        // A surplus `#end` leaves the tree around it intact.
        if faults.iter().all(|fault| fault.code == codes::UNMATCHED_CLOSER) {
            self.reporter.defer(std::mem::take(&mut faults));
        }
        let Some(mut last) = faults.pop() else {
            self.stream.add_unclosed_brackets(&ast);
            return Ok(self.inputs.parsed.add_tree(file, ast));
        };
        for fault in faults {
            self.reporter.report(fault);
        }
        last.trace = self.stream.call_trace().into();
        self.reporter.report(last);
        Diagnostic::err(codes::ENDS_RUN, Span::NONE, "")
    }

    fn missing_include_error(&self, name: &str, span: Span) -> Diagnostic {
        let folders = &self.inputs.options.search.folders;
        let d = Diagnostic::new(codes::MISSING_INCLUDE, span, format!("the file `{name}` was not found"));
        if let Some(hint) = hints::povray_3_8_name_hint(name) {
            return d.help(hint);
        }
        let there = folders.iter().flat_map(|folder| self.inputs.files.list(folder).unwrap_or_default());
        let there: Vec<String> = there.filter_map(|entry| entry.name.into_string().ok()).collect();
        if let Some(found) = similar_file(name, &there) {
            return d.help(format!("did you mean `{found}`?"));
        }
        if library::is_standard_include(name) {
            return d.help(format!(
                "`{name}` comes with POV-Ray: install its include files (Debian: apt-get install povray-includes), or name their folder with -I DIR"
            ));
        }
        let list: Vec<String> = folders.iter().map(|f| format!("`{}`", f.display())).collect();
        d.help(format!("looked in {}; -I DIR adds a folder", list.join(", ")))
    }
}

/// Returns the file whose name is closest to `name`. The extension is ignored, because most files have the same.
fn similar_file<'a>(name: &str, there: &'a [String]) -> Option<&'a str> {
    let stem = |file: &'a str| file.rsplit_once('.').map_or(file, |(stem, _)| stem);
    let typed = name.rsplit_once('.').map_or(name, |(stem, _)| stem);
    let stems = || there.iter().map(|file| stem(file));
    let meant = stems().find(|known| *known == typed).or_else(|| nearest(typed, stems()))?;
    let files = there.iter().map(String::as_str).filter(|file| stem(file) == meant);
    files.min_by_key(|file| !file.ends_with(".inc"))
}
