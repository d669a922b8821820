//! The directives `#fopen`, `#fclose`, `#read` and `#write` (manual, "User Defined File I/O").

use super::data::{Binary, data_bytes, data_value_and_length, skip_blanks_commas_comments};
use crate::diagnostic::{Diagnostic, Result, codes};
use crate::interpreter::Interpreter;
use crate::interpreter::argument::ArgumentForm;
use crate::interpreter::evaluator::Contents;
use crate::interpreter::stream::Token;
use crate::source::{FileId, Files, Span, WriteMode};
use crate::syntax::ast::{ElementKind, Expr, ExprKind, Symbol};
use crate::value::Value;
use std::io::{BufWriter, ErrorKind, Write};
use std::path::{Path, PathBuf};
use std::rc::Rc;

/// Maximum number of bytes that one scene may write.
const MAX_WRITTEN: u64 = 4 << 30;

/// A file that `#fopen` opened, until its `#fclose`.
pub struct OpenFile {
    /// Name by which the scene refers to a file opened with `#fopen`.
    name: String,
    path: PathBuf,
    access: Access,
    /// Span of the file's name in the `#fopen` directive.
    span: Span,
}

enum Access {
    /// A text file that is read, with the offset up to which it has been read.
    Read {
        file: FileId,
        at: usize,
    },
    Write(BufWriter<Box<dyn Write + Send>>),
    Closed,
}

impl<'a> Interpreter<'a> {
    /// Runs the directive `#fopen Name "file" read`.
    pub fn run_fopen(&mut self, span: Span) -> Result<()> {
        let Some((symbol, _)) = self.read_name()? else {
            let message = "`#fopen` takes a name, a file and `read`, `write` or `append`";
            return Diagnostic::err(codes::EXPECTED, span, message);
        };
        let (name, at) = self.read_text_value()?;
        let word = self.read_access_word();
        let file = match word {
            "read" => self.open_to_read(&name, at),
            "write" | "append" => self.open_to_write(&name, word == "append", at),
            _ => {
                let d = Diagnostic::new(
                    codes::EXPECTED,
                    at.end(),
                    "expected `read`, `write` or `append` after the file's name",
                );
                return d.help(format!("`#fopen {} \"{name}\" read`", self.inputs.names.text(symbol))).into();
            }
        };
        // Uses of a file that could not be opened are no further faults.
        let file = file.inspect_err(|_| {
            self.evaluator.scopes_mut().rebind_innermost_or_add_global(symbol, Contents::Faulty(Rc::default()), vec![])
        })?;
        self.open_files.push(file);
        self.evaluator.scopes_mut().rebind_innermost_or_add_global(
            symbol,
            Contents::File(self.open_files.len() - 1),
            vec![],
        );
        Ok(())
    }

    /// Reads a name that a directive defines; `None` if the next token is no name.
    pub fn read_name(&mut self) -> Result<Option<(Symbol, Span)>> {
        match self.peek()? {
            Token::Expr(Expr { kind: ExprKind::Name(symbol), span, .. }) => {
                self.stream.advance();
                Ok(Some((*symbol, *span)))
            }
            _ => Ok(None),
        }
    }

    /// Reads the word after the file's name in an `#fopen`; empty if no word follows. A directive after the word runs
    /// only after the file is open.
    fn read_access_word(&mut self) -> &'static str {
        while let Some(ElementKind::Comma) = self.stream.next_raw_element().map(|e| &e.kind) {
            self.stream.advance();
        }
        let word = match self.stream.next_raw_element().map(|e| &e.kind) {
            Some(ElementKind::Word(word)) => word.name,
            Some(ElementKind::Expr(e)) if let ExprKind::Name(symbol) = e.kind => {
                crate::syntax::word::lookup(self.inputs.names.text(symbol)).map_or("", |(word, _)| word)
            }
            _ => "",
        };
        if !word.is_empty() {
            self.stream.advance();
        }
        word
    }

    /// Runs the directive `#fclose Name`.
    pub fn run_fclose(&mut self, span: Span) -> Result<()> {
        if let Some((symbol, _)) = self.read_name()? {
            self.close_file(symbol, span);
        }
        Ok(())
    }

    fn open_to_read(&mut self, name: &str, span: Span) -> Result<OpenFile> {
        let Some(path) = self.find_readable_file(name, span)? else {
            let d = Diagnostic::new(codes::MISSING_INCLUDE, span, format!("the file `{name}` was not found"));
            let folders: Vec<String> =
                self.inputs.options.search.folders.iter().map(|f| format!("`{}`", f.display())).collect();
            return d
                .help(format!("looked in {}; `#if (file_exists(\"{name}\"))` asks for it", folders.join(", ")))
                .into();
        };
        let file = self.source_file(&path, name, span)?;
        Ok(OpenFile { name: name.into(), path, access: Access::Read { file, at: 0 }, span })
    }

    fn open_to_write(&mut self, name: &str, append: bool, span: Span) -> Result<OpenFile> {
        let path = PathBuf::from(name);
        let mode = if append { WriteMode::Append } else { WriteMode::Truncate };
        match self.inputs.files.open_writer(&path, mode) {
            Ok(file) => {
                self.inputs.parsed.forget(self.inputs.files, &path);
                let access = Access::Write(BufWriter::new(file));
                Ok(OpenFile { name: name.into(), path, access, span })
            }
            // The policy has no number of the operating system.
            Err(error) if error.kind() == ErrorKind::PermissionDenied && error.raw_os_error().is_none() => {
                let message = format!("the scene may not write `{name}`: {error}");
                let help = "scenes create files below the current folder; --allow-write DIR lets them write in another \
                            folder, and replace files there";
                Diagnostic::new(codes::FORBIDDEN_FILE, span, message).help(help).into()
            }
            Err(error) => Err(unwritable(self.inputs.files, &path, &error, span).into()),
        }
    }

    fn close_file(&mut self, symbol: Symbol, span: Span) {
        if let Some(Contents::File(index)) = self.evaluator.scopes().get(symbol) {
            self.close_file_at(*index, span);
            if let Some(place) = self.evaluator.scopes().resolve(symbol) {
                self.evaluator.scopes_mut().unbind(&place);
            }
        }
    }

    /// Closes a file, and reports an error in writing the rest of the file's buffer.
    fn close_file_at(&mut self, index: usize, span: Span) {
        let file = &mut self.open_files[index];
        let written = match std::mem::replace(&mut file.access, Access::Closed) {
            Access::Write(mut out) => out.flush(),
            _ => Ok(()),
        };
        let fault = written.err().map(|error| unwritable(self.inputs.files, &file.path, &error, span));
        self.inputs.parsed.forget(self.inputs.files, &file.path);
        fault.into_iter().for_each(|fault| self.reporter.report(fault));
    }

    /// Closes the files that the scene has left open.
    pub fn close_files(&mut self) {
        (0..self.open_files.len()).for_each(|index| self.close_file_at(index, self.open_files[index].span));
    }

    fn index_of_open_file(&mut self, symbol: Symbol, span: Span) -> Result<usize> {
        match self.evaluator.scopes().get(symbol) {
            Some(Contents::File(index)) => Ok(*index),
            Some(Contents::Faulty(_)) => Diagnostic::err(codes::FOLLOWS, span, ""),
            _ => {
                let name = self.inputs.names.text(symbol);
                let d = Diagnostic::new(codes::WRONG_TYPE, span, format!("`{name}` is no open file"));
                d.help(format!("`#fopen {name} \"file.txt\" read` opens one")).into()
            }
        }
    }

    /// Runs `#read (Name, A, B)`. At the end of the file's text the file is closed, and `defined(Name)` is then false.
    pub fn run_read(&mut self, span: Span) -> Result<()> {
        self.expect_paren("#read")?;
        let Some((file, at)) = self.read_name()? else {
            return Diagnostic::err(codes::EXPECTED, span, "`#read` takes an open file and names");
        };
        let index = self.index_of_open_file(file, at)?;
        let mut more = true;
        while !self.peek()?.is_closer_or_end() {
            let target = self.read_argument()?;
            // Names after the end of the file keep their values.
            if !more {
                continue;
            }
            let value = self.value_and_has_more(index, span);
            if let (Err(_), ArgumentForm::Name(symbol)) = (&value, &target.given) {
                self.evaluator.scopes_mut().rebind_innermost_or_add_global(
                    *symbol,
                    Contents::Faulty(Rc::default()),
                    vec![],
                );
            }
            let Some((value, follows)) = value? else {
                more = false;
                continue;
            };
            match &target.given {
                ArgumentForm::Name(symbol) => {
                    self.evaluator.scopes_mut().rebind_innermost_or_add_global(*symbol, Contents::Value(value), vec![])
                }
                ArgumentForm::LValue(place) => {
                    self.evaluator.scopes_mut().set_element(place, Some(Contents::Value(value)))
                }
                ArgumentForm::Contents(_) => {
                    return Diagnostic::err(codes::EXPECTED, target.span, "expected a name for what is read");
                }
            }
            more = follows;
        }
        self.close_bracket("`)`")?;
        if !more {
            self.close_file(file, span);
        }
        Ok(())
    }

    /// Reads the next number, vector or string of a file; `None` at the end of the file. The flag is true if more
    /// values follow.
    fn value_and_has_more(&mut self, index: usize, span: Span) -> Result<Option<(Value, bool)>> {
        let file = &mut self.open_files[index];
        let Access::Read { file, at } = &mut file.access else {
            let message = format!("`{}` is open for writing: it can't be read", file.name);
            return Diagnostic::err(codes::WRONG_TYPE, span, message);
        };
        let text = self.inputs.sources.text(*file);
        *at = skip_blanks_commas_comments(text, *at);
        if *at == text.len() {
            return Ok(None);
        }
        match data_value_and_length(&text[*at..]) {
            Some((value, length)) => {
                *at = skip_blanks_commas_comments(text, *at + length);
                Ok(Some((value, *at < text.len())))
            }
            None => {
                let place = self.inputs.sources.base(*file) + *at;
                let message = "a data file holds numbers, vectors and strings, not this";
                let d = Diagnostic::new(codes::BAD_DATA, Span::new(place, place + 1), message);
                d.also(span, "read here").into()
            }
        }
    }

    /// Runs the directive `#write (Name, A, B)`.
    pub fn run_write(&mut self, span: Span) -> Result<()> {
        self.expect_paren("#write")?;
        let index = match self.read_name()? {
            Some((symbol, at)) => self.index_of_open_file(symbol, at)?,
            None => return Err(self.unexpected_token("an open file").into()),
        };
        // Binary format of the values up to the next comma. A comma directly after the word cancels it.
        let mut form = None;
        loop {
            let token = self.peek()?;
            if self.stream.has_comma() {
                form = None;
            }
            match token {
                token if token.is_closer_or_end() => return self.close_bracket("`)`"),
                Token::Word(word) if Binary::from_word(word).is_some() => {
                    self.stream.advance();
                    form = Binary::from_word(word);
                }
                _ => {
                    let (value, at) = self.read_value()?;
                    let Some(bytes) = data_bytes(&value, form) else {
                        let what = if form.is_some() { "numbers" } else { "a number, a vector or a string" };
                        let message = format!("expected {what}, found {}", value.describe());
                        return Diagnostic::err(codes::WRONG_TYPE, at, message);
                    };
                    self.write_bytes(index, &bytes, span)?;
                }
            }
        }
    }

    fn write_bytes(&mut self, index: usize, bytes: &[u8], span: Span) -> Result<()> {
        self.written += bytes.len() as u64;
        if self.written > MAX_WRITTEN {
            let message = format!("the scene writes more than {} GB", MAX_WRITTEN >> 30);
            return self.reporter.limit_error(codes::MEMORY_LIMIT, span, message, "does a loop write without end?");
        }
        let file = &mut self.open_files[index];
        let written = match &mut file.access {
            Access::Write(out) => out.write_all(bytes),
            _ => {
                let message = format!("`{}` is open for reading: it can't be written", file.name);
                return Diagnostic::err(codes::WRONG_TYPE, span, message);
            }
        };
        written.map_err(|error| Box::new(unwritable(self.inputs.files, &file.path, &error, span)))
    }
}

fn unwritable(files: &dyn Files, path: &Path, error: &std::io::Error, span: Span) -> Diagnostic {
    let d = crate::diagnostic::file::unwritable(files, path, error);
    Diagnostic::new(d.code, span, d.message).maybe_help(d.help)
}
