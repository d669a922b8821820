//! The command `durer new NAME`: creates a simple scene to start with.

use super::args::NewArgs;
use super::console::Console;
use super::exit::{Exit, Result, usage_error};
use crate::diagnostic::file;
use crate::source::Disk;
use std::fs::OpenOptions;
use std::io::{ErrorKind, Write};
use std::path::PathBuf;

/// Text of the new scene that `durer new` writes; POV-Ray reads it, too.
pub const STARTER: &str = include_str!("starter.scene");

/// Writes the new scene; an existing file is not overwritten.
pub fn run(console: &Console, args: &NewArgs) -> Result {
    let path = new_scene_path(args)?;
    let name = path.display();
    let mut new = match OpenOptions::new().write(true).create_new(true).open(&path) {
        Ok(new) => new,
        Err(error) if error.kind() == ErrorKind::AlreadyExists => {
            return usage_error(format!("`{name}` exists and is not overwritten; choose another name"));
        }
        Err(error) => return Err(Box::new(file::unwritable(&Disk, &path, &error)).into()),
    };
    if let Err(error) = new.write_all(STARTER.as_bytes()).and_then(|()| new.sync_all()) {
        // Remove an incomplete file. If that fails too, the message names the fault of the folder.
        let _ = std::fs::remove_file(&path);
        return Err(Box::new(file::unwritable(&Disk, &path, &error)).into());
    }
    console.info(&format!("created `{name}`; `durer render {name}` renders it\n"));
    Ok(Exit::Fine)
}

/// Returns the path of the new scene, with `.scene` appended unless it has a scene's extension.
fn new_scene_path(args: &NewArgs) -> Result<PathBuf> {
    let path = &args.name;
    let Some(name) = path.file_name().filter(|_| !path.to_string_lossy().ends_with(['/', '\\'])) else {
        return usage_error(format!("`{}` is not a file name; type, for example, `durer new hall`", path.display()));
    };
    match path.extension().and_then(|ending| ending.to_str()) {
        Some("scene" | "pov") => Ok(path.clone()),
        Some("inc" | "ini" | "png" | "jpg") => {
            usage_error(format!("a scene's name ends in `.scene` or `.pov`, unlike `{}`", path.display()))
        }
        _ => {
            let mut name = name.to_os_string();
            name.push(".scene");
            Ok(path.with_file_name(name))
        }
    }
}
