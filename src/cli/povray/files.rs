//! Finds the files that POV-Ray's command line and INI files name.

use super::ini::{self, Ini};
use crate::diagnostic::{Diagnostic, Result, codes, file};
use crate::source::{Sources, Span, read_text};
use std::path::{Path, PathBuf};

/// Maximum nesting depth of INI files.
const MAX_NESTED: usize = 20;

/// Stack of the INI files that are being read.
pub struct Files<'s> {
    sources: &'s Sources,
    /// INI files with their sections, the innermost last.
    open: Vec<(PathBuf, Option<String>)>,
    /// True if INI files may name only scenes and INI files below the folder of the outermost INI file.
    untrusted: bool,
}

impl<'s> Files<'s> {
    /// Creates an empty stack of INI files.
    pub fn new(sources: &'s Sources, untrusted: bool) -> Self {
        Self { sources, open: Vec::new(), untrusted }
    }

    /// True if INI files are untrusted.
    pub fn is_untrusted(&self) -> bool {
        self.untrusted
    }

    /// Checks that an untrusted INI file may name this scene or INI file.
    ///
    /// # Errors
    /// E0235 if the file is not below the folder of the outermost INI file.
    pub fn check_ini_may_name(&self, path: &Path, span: Span) -> Result<()> {
        let Some((outermost, _)) = self.open.first().filter(|_| self.untrusted) else { return Ok(()) };
        let folder = outermost.parent().unwrap_or(Path::new("."));
        if !path.exists() || path.canonicalize().is_ok_and(|path| path.starts_with(folder)) {
            return Ok(());
        }
        let text = format!("`{}` is outside of the folder of the untrusted INI file", path.display());
        Diagnostic::new(codes::FORBIDDEN_FILE, span, text).help("name the scene on the command line").into()
    }

    /// Reads an INI file, `file.ini` or `file.ini[section]`, named at `span`, and adds it to the stack of open INI files. A file
    /// that is open already is an error.
    pub fn open_ini(&mut self, word: &str, span: Span) -> Result<Ini> {
        let (name, section) = ini::split_section(word);
        let path = self.path_here_or_beside_ini(&ini_file_name(name), Path::is_file);
        self.check_ini_may_name(&path, span)?;
        let entry = (path.canonicalize().unwrap_or_else(|_| path.clone()), section.map(str::to_lowercase));
        if self.open.contains(&entry) || self.open.len() >= MAX_NESTED {
            let d = Diagnostic::new(codes::INI_LOOP, span, format!("`{word}` is being read already"));
            return d.help("remove this line").into();
        }
        let at_span = |mut fault: Diagnostic| {
            fault.labels.extend((!span.is_none()).then_some(crate::diagnostic::Label { span, text: String::new() }));
            Box::new(fault)
        };
        let text = read_text(self.sources.files(), &path)
            .map_err(|e| at_span(file::unreadable(self.sources.files(), &path, &e)))?;
        let name = path.display().to_string();
        let Some(file) = self.sources.add(&name, Some(&path), text) else {
            return Diagnostic::err(codes::FILE_UNREADABLE, span, format!("`{name}` is too large"));
        };
        self.open.push(entry);
        Ok(ini::parse(self.sources.text(file), self.sources.base(file), section))
    }

    /// True if a word names an INI file, also one that is beside the INI file with the word.
    pub fn is_ini(&self, word: &str) -> bool {
        let exists = |word: &str| self.path_here_or_beside_ini(word, Path::is_file).is_file();
        is_ini(word) || Path::new(word).extension().is_none() && !exists(word) && exists(&ini_file_name(word))
    }

    /// Removes the innermost INI file after its end.
    pub fn close_innermost_ini(&mut self) {
        self.open.pop();
    }

    /// Returns the path of a scene in the current folder, as in POV-Ray, or else beside the INI file that names it.
    pub fn scene_path(&self, name: &str) -> String {
        self.path_here_or_beside_ini(name, |path| path.is_file() || exists_with_pov_extension(path))
            .display()
            .to_string()
    }

    /// Returns the path of a folder in the current folder, or else beside the INI file that names it.
    pub fn folder_path(&self, name: &str) -> String {
        self.path_here_or_beside_ini(name, Path::is_dir).display().to_string()
    }

    /// Returns the path `name` if `is_there` accepts it, or else the path beside the open INI file if `is_there`
    /// accepts that; `name` if neither.
    fn path_here_or_beside_ini(&self, name: &str, is_there: impl Fn(&Path) -> bool) -> PathBuf {
        let name = Path::new(name);
        let beside = self.open.last().and_then(|(ini, _)| ini.parent());
        let beside = beside.map(|folder| relative_to_current_folder(&folder.join(name))).filter(|path| is_there(path));
        if is_there(name) { name.into() } else { beside.unwrap_or(name.into()) }
    }
}

/// Returns the path relative to the current folder, if it is below that folder.
fn relative_to_current_folder(path: &Path) -> PathBuf {
    let here = std::env::current_dir().and_then(|here| here.canonicalize()).unwrap_or_default();
    path.strip_prefix(here).map_or(path.to_path_buf(), Path::to_path_buf)
}

/// True if a word names an INI file: `anim.ini`, `res[low]`, or `res` if `res.ini` exists.
pub fn is_ini(word: &str) -> bool {
    let (name, section) = ini::split_section(word);
    let path = Path::new(name);
    !Path::new(word).is_file() && section.is_some()
        || has_ini_extension(path)
        || path.extension().is_none() && !path.is_file() && Path::new(&ini_file_name(name)).is_file()
}

fn has_ini_extension(path: &Path) -> bool {
    path.extension().is_some_and(|e| e.eq_ignore_ascii_case("ini"))
}

/// Returns the name of the INI file that a word means: `name` if it has the extension `.ini` or is a file, else `name` with
/// `.ini`.
fn ini_file_name(name: &str) -> String {
    if has_ini_extension(Path::new(name)) || Path::new(name).is_file() { name.into() } else { format!("{name}.ini") }
}

fn exists_with_pov_extension(path: &Path) -> bool {
    path.extension().is_none() && path.with_extension("pov").is_file()
}

/// Returns `input.pov` if `input` does not exist and `input.pov` is a file; else `input`, as POV-Ray does.
pub fn input_or_pov_file(input: String) -> String {
    let path = Path::new(&input);
    if !path.exists() && exists_with_pov_extension(path) { format!("{input}.pov") } else { input }
}
