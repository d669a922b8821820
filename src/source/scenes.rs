//! Finds scenes and include files in a folder.

use super::{Entry, FileKind, Files};
use std::io;
use std::path::{Path, PathBuf};

/// Returns all scenes in and below a folder, sorted by path. Hidden folders and Cargo's `target` are omitted.
///
/// # Errors
/// If a folder cannot be read.
pub fn scenes_below(files: &dyn Files, folder: &Path) -> io::Result<Vec<PathBuf>> {
    files_with_ending_below(files, folder, &["scene", "pov"])
}

/// Returns all scenes and include files in and below a folder, sorted by path.
///
/// # Errors
/// If a folder cannot be read.
pub fn scenes_and_includes_below(files: &dyn Files, folder: &Path) -> io::Result<Vec<PathBuf>> {
    files_with_ending_below(files, folder, &["scene", "pov", "inc"])
}

fn files_with_ending_below(files: &dyn Files, folder: &Path, endings: &[&str]) -> io::Result<Vec<PathBuf>> {
    let mut found = Vec::new();
    search(files, folder, endings, &mut found)?;
    found.sort();
    Ok(found)
}

fn search(files: &dyn Files, folder: &Path, endings: &[&str], found: &mut Vec<PathBuf>) -> io::Result<()> {
    for Entry { name, kind } in files.list(folder)? {
        let path = folder.join(&name);
        // Links to folders are not followed: they may form a cycle.
        if kind == FileKind::Folder {
            if !name.to_string_lossy().starts_with('.') && name != "target" {
                search(files, &path, endings, found)?;
            }
        } else if path.extension().is_some_and(|e| endings.iter().any(|ending| e == *ending)) {
            found.push(path.strip_prefix("./").unwrap_or(&path).to_path_buf());
        }
    }
    Ok(())
}
