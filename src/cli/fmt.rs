//! The command `durer fmt [PATH…]`: formats scenes.

use super::args::FmtArgs;
use super::console::Console;
use super::exit::{Exit, Result, usage_error};
use super::session;
use crate::diagnostic::{Diagnostic, codes, file};
use crate::format::{self, Encoded};
use crate::source::{Disk, Files, Sources, scenes_and_includes_below};
use std::io::Read;
use std::path::{Path, PathBuf};

/// Formats all named files; the worst result determines the exit code.
pub fn run(console: &Console, args: &FmtArgs) -> Result {
    let mut worst = Exit::Fine;
    for path in files_to_format(&args.paths)? {
        worst = worst.max(format_file(console, args, &path)?);
    }
    Ok(worst)
}

/// Replaces folders by the scenes and include files below them, sorted by name, and removes duplicates. Without names,
/// returns the files below the current folder.
fn files_to_format(named: &[PathBuf]) -> Result<Vec<PathBuf>> {
    let here = [PathBuf::from(".")];
    let mut all = vec![];
    for path in if named.is_empty() { &here } else { named } {
        if !path.is_dir() {
            all.push(path.clone());
            continue;
        }
        if path.canonicalize().is_ok_and(|folder| folder.parent().is_none()) {
            // Refuse the root folder: nobody means all files of the machine.
            session::check_input(path)?;
        }
        let found =
            scenes_and_includes_below(&Disk, path).map_err(|e| Box::new(file::unreadable(&Disk, path, &e.into())))?;
        if found.is_empty() {
            return usage_error(format!("no file in `{}` ends in `.scene`, `.pov` or `.inc`", path.display()));
        }
        all.extend(found);
    }
    let mut seen = std::collections::HashSet::new();
    all.retain(|path| seen.insert(path.clone()));
    Ok(all)
}

fn format_file(console: &Console, args: &FmtArgs, path: &Path) -> Result {
    let is_stdin = path.as_os_str() == "-";
    let name = if is_stdin { "<stdin>".to_string() } else { path.display().to_string() };
    let sources = Sources::default();
    let encoded = match read_input(path, is_stdin).map_err(Into::into).and_then(format::decode) {
        Ok(encoded) => encoded,
        Err(error) => return Ok(report(console, &sources, &[file::unreadable(&Disk, path, &error)])),
    };
    let Some(file) = sources.add(&name, (!is_stdin).then_some(path), encoded.text.clone()) else {
        let text = format!("`{name}` is too large: a file holds at most 4 GB");
        let fault = Diagnostic::new(codes::FILE_UNREADABLE, crate::source::Span::NONE, text);
        return Ok(report(console, &sources, &[fault]));
    };
    match encoded.formatted(sources.base(file), args.width.into()) {
        Ok(text) => write_formatted(console, args, path, &encoded, &text),
        Err(faults) => {
            let exit = report(console, &sources, &faults);
            console.info(&format!("`{name}` is unchanged\n"));
            Ok(exit)
        }
    }
}

fn read_input(path: &Path, is_stdin: bool) -> std::io::Result<Vec<u8>> {
    if !is_stdin {
        return Disk.read(path);
    }
    let mut bytes = vec![];
    std::io::stdin().lock().read_to_end(&mut bytes)?;
    Ok(bytes)
}

/// Reports the errors of a file, and returns the exit code.
fn report(console: &Console, sources: &Sources, faults: &[Diagnostic]) -> Exit {
    console.report(sources, faults);
    faults.iter().map(|fault| Exit::of(fault.code)).max().unwrap_or(Exit::Scene)
}

/// Returns the differences of two texts in the form of `diff -u`; empty for equal texts.
fn diff(name: &str, old: &str, new: &str) -> String {
    let diff = similar::TextDiff::from_lines(old, new);
    diff.unified_diff().header(name, &format!("{name} (formatted)")).to_string()
}

/// Writes the formatted text `new` to its file or to stdout; with `--check` or `--diff`, reports the changes only. With
/// `--check`, a change gives the exit code of an error.
fn write_formatted(console: &Console, args: &FmtArgs, path: &Path, old: &Encoded, new: &str) -> Result {
    let is_same = old.text == new;
    let name = path.display().to_string();
    if args.diff {
        console.write_to_stdout(diff(&name, &old.text, new))?;
    }
    if args.check {
        if !is_same {
            super::console::print_message(&format!("{name}\n"));
        }
        return Ok(if is_same { Exit::Fine } else { Exit::Scene });
    }
    if args.diff {
        return Ok(Exit::Fine);
    }
    if name == "-" {
        console.write_to_stdout(old.encode(new))?;
    } else if !is_same {
        Disk.write(path, &old.encode(new)).map_err(|error| Box::new(file::unwritable(&Disk, path, &error)))?;
    }
    Ok(Exit::Fine)
}
