//! Diagnostics about files that can't be read or written.

use super::{Diagnostic, codes, nearest};
use crate::source::{Files, ReadError, Span};
use std::io;
use std::path::Path;

/// Creates the error for a scene or an include file that was not read. The caller adds the place.
pub fn unreadable(files: &dyn Files, path: &Path, error: &ReadError) -> Diagnostic {
    let name = path.display();
    let say = |code, text: String| Diagnostic::new(code, Span::NONE, text);
    match error {
        ReadError::NotText(kind) => {
            let help = if *kind == "text in UTF-16" { "save it as UTF-8" } else { "a scene is a text file" };
            say(codes::NOT_TEXT, format!("`{name}` is not a scene but {kind}")).help(help)
        }
        ReadError::Folder => {
            say(codes::FILE_UNREADABLE, format!("`{name}` is a folder")).maybe_help(scenes_inside_help(files, path))
        }
        ReadError::Io(e) if e.kind() == io::ErrorKind::NotFound => {
            say(codes::FILE_NOT_FOUND, format!("there is no file `{name}`")).maybe_help(did_you_mean_file(files, path))
        }
        ReadError::Io(e) => say(codes::FILE_UNREADABLE, format!("`{name}` can't be read: {}", reason(e))),
    }
}

/// Creates the error for a file that was not written.
pub fn unwritable(files: &dyn Files, path: &Path, error: &io::Error) -> Diagnostic {
    let folder = path.parent().filter(|p| !p.as_os_str().is_empty() && !files.exists(p));
    let help = folder.map(|f| format!("there is no folder `{}`; make it first", f.display()));
    let message = format!("`{}` can't be written: {}", path.display(), reason(error));
    Diagnostic::new(codes::FILE_UNWRITABLE, Span::NONE, message).maybe_help(help)
}

/// Returns the operating system's message for an error, without its number and with a small first letter.
pub fn reason(error: &io::Error) -> String {
    let text = error.to_string();
    let text = text.split(" (os error").next().unwrap_or_default();
    let mut letters = text.chars();
    letters.next().map_or(String::new(), |first| first.to_lowercase().chain(letters).collect())
}

/// Returns a "did you mean" with a file of the folder, for a typo or a missing extension.
fn did_you_mean_file(files: &dyn Files, path: &Path) -> Option<String> {
    let folder = path.parent().filter(|p| !p.as_os_str().is_empty());
    let names = file_names(files, folder.unwrap_or(Path::new(".")))?;
    let wanted = path.file_name()?.to_str()?;
    let with_ending = || names.iter().find(|n| is_scene(n) && Path::new(n).file_stem().is_some_and(|s| s == wanted));
    let found = with_ending().map(String::as_str).or_else(|| nearest(wanted, names.iter().map(String::as_str)))?;
    let found = folder.map_or(found.to_string(), |f| f.join(found).display().to_string());
    Some(format!("did you mean `{found}`?"))
}

/// Returns a help line that lists the scenes of a folder, if the folder was given in place of a scene.
fn scenes_inside_help(files: &dyn Files, folder: &Path) -> Option<String> {
    let names = file_names(files, folder)?;
    let scenes = names.iter().filter(|n| is_scene(n)).take(3);
    let scenes: Vec<_> = scenes.map(|n| format!("`{}`", folder.join(n).display())).collect();
    (!scenes.is_empty()).then(|| format!("there is {} in it", scenes.join(", ")))
}

fn is_scene(name: &str) -> bool {
    Path::new(name).extension().is_some_and(|e| e == "scene" || e == "pov")
}

fn file_names(files: &dyn Files, folder: &Path) -> Option<Vec<String>> {
    let entries = files.list(folder).ok()?.into_iter();
    let mut names: Vec<_> = entries.filter_map(|entry| entry.name.into_string().ok()).collect();
    names.sort();
    Some(names)
}
