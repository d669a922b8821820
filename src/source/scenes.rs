//! The scenes in a folder.

use std::io;
use std::path::{Path, PathBuf};

/// All scenes in a folder and those below it, in the order of their names. Hidden folders and Cargo's `target` are left out.
///
/// # Errors
/// If one of the folders can't be read.
pub fn scenes_below(folder: &Path) -> io::Result<Vec<PathBuf>> {
    below(folder, &["scene", "pov"])
}

/// Include files too.
///
/// # Errors
/// If one of the folders can't be read.
pub fn texts_below(folder: &Path) -> io::Result<Vec<PathBuf>> {
    below(folder, &["scene", "pov", "inc"])
}

fn below(folder: &Path, endings: &[&str]) -> io::Result<Vec<PathBuf>> {
    let mut found = Vec::new();
    search(folder, endings, &mut found)?;
    found.sort();
    Ok(found)
}

fn search(folder: &Path, endings: &[&str], found: &mut Vec<PathBuf>) -> io::Result<()> {
    for entry in std::fs::read_dir(folder)? {
        let entry = entry?;
        let (path, name) = (entry.path(), entry.file_name());
        // A link to a folder may lead in a circle.
        if entry.file_type()?.is_dir() {
            if !name.to_string_lossy().starts_with('.') && name != "target" {
                search(&path, endings, found)?;
            }
        } else if path.extension().is_some_and(|e| endings.iter().any(|ending| e == *ending)) {
            found.push(path.strip_prefix("./").unwrap_or(&path).to_path_buf());
        }
    }
    Ok(())
}
