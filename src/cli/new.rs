//! `durer new NAME`: a first scene to change.

use super::args::NewArgs;
use super::console::Console;
use super::exit::{Exit, Result, usage};
use crate::diagnostic::file;
use crate::source::Disk;
use std::fs::OpenOptions;
use std::io::{ErrorKind, Write};
use std::path::PathBuf;

/// Draws something nice, in words that POV-Ray takes too.
pub const STARTER: &str = include_str!("starter.scene");

/// Writes the scene; what is there stays.
pub fn run(console: &Console, args: &NewArgs) -> Result {
    let path = path(args)?;
    let name = path.display();
    let mut new = match OpenOptions::new().write(true).create_new(true).open(&path) {
        Ok(new) => new,
        Err(error) if error.kind() == ErrorKind::AlreadyExists => {
            return usage(format!("`{name}` is there already and is not overwritten; choose another name"));
        }
        Err(error) => return Err(Box::new(file::unwritable(&Disk, &path, &error)).into()),
    };
    if let Err(error) = new.write_all(STARTER.as_bytes()).and_then(|()| new.sync_all()) {
        // Half a scene helps nobody; if it can't be removed, the message says what is wrong with the folder.
        let _ = std::fs::remove_file(&path);
        return Err(Box::new(file::unwritable(&Disk, &path, &error)).into());
    }
    console.note(&format!("`{name}` is a scene now; `durer render {name}` draws it\n"));
    Ok(Exit::Fine)
}

/// The name, with `.scene` behind it unless it has an ending that scenes have.
fn path(args: &NewArgs) -> Result<PathBuf> {
    let path = &args.name;
    let Some(name) = path.file_name().filter(|_| !path.to_string_lossy().ends_with(['/', '\\'])) else {
        return usage(format!("`{}` is no name for a file; such as `durer new hall`", path.display()));
    };
    match path.extension().and_then(|ending| ending.to_str()) {
        Some("scene" | "pov") => Ok(path.clone()),
        Some("inc" | "ini" | "png" | "jpg") => {
            usage(format!("a scene's name ends in `.scene` or `.pov`, not as `{}` does", path.display()))
        }
        _ => {
            let mut name = name.to_os_string();
            name.push(".scene");
            Ok(path.with_file_name(name))
        }
    }
}
