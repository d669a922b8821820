//! The option `--deps FILE`: lists the files that were read for the pictures, for make and other programs.

use crate::cli::console::Console;
use crate::cli::exit::Result;
use crate::diagnostic::file;
use crate::source::{Disk, Files, ReadFiles};
use serde_json::json;
use std::path::{Path, PathBuf};

/// Writes the files `read` as dependencies of the pictures: as JSON if the name of the output file ends in `.json`,
/// else as a rule for make. The output file `-` is standard output.
pub fn write(console: &Console, to: &Path, pictures: &[PathBuf], read: &ReadFiles) -> Result<()> {
    let mut files: Vec<PathBuf> = read.keys().filter(|path| path.is_file()).cloned().map(without_dot_slash).collect();
    files.sort();
    let is_json = to.extension().is_some_and(|ending| ending.eq_ignore_ascii_case("json"));
    let text = if is_json { as_json(pictures, &files) } else { as_make_rule(pictures, &files) };
    if to == Path::new("-") {
        return console.write_to_stdout(text);
    }
    Disk.write(to, &text).map_err(|error| Box::new(file::unwritable(&Disk, to, &error)).into())
}

/// Removes a leading `./` of a path, which rules for the file do not contain.
fn without_dot_slash(path: PathBuf) -> PathBuf {
    path.strip_prefix("./").map(Path::to_path_buf).unwrap_or(path)
}

fn as_json(pictures: &[PathBuf], files: &[PathBuf]) -> Vec<u8> {
    let names = |paths: &[PathBuf]| paths.iter().map(|path| path.to_string_lossy().into_owned()).collect::<Vec<_>>();
    let text = json!({"pictures": names(pictures), "files": names(files)});
    format!("{text:#}\n").into_bytes()
}

/// Returns a make rule without commands, and an empty rule for each file, so that make does not fail if a file is gone.
fn as_make_rule(pictures: &[PathBuf], files: &[PathBuf]) -> Vec<u8> {
    let mut text = vec![];
    for (i, picture) in pictures.iter().enumerate() {
        text.extend(if i > 0 { &b" "[..] } else { b"" });
        text.extend(escaped_for_make(picture));
    }
    if !pictures.is_empty() {
        text.push(b':');
        for file in files {
            text.extend(b" \\\n  ");
            text.extend(escaped_for_make(file));
        }
        text.push(b'\n');
    }
    for file in files {
        text.push(b'\n');
        text.extend(escaped_for_make(file));
        text.extend(b":\n");
    }
    text
}

/// Escapes a path for make (GNU make's manual, "Rule Syntax" and "Using Wildcard Characters in File Names").
fn escaped_for_make(path: &Path) -> Vec<u8> {
    let (mut out, mut slashes) = (vec![], 0);
    for &byte in path.as_os_str().as_encoded_bytes() {
        match byte {
            b'$' => out.push(b'$'),
            // Backslashes before an escaped character have to be doubled.
            b' ' | b'\t' | b'#' => out.extend(std::iter::repeat_n(b'\\', slashes + 1)),
            b':' | b'%' | b'*' | b'?' | b'[' | b']' | b'~' if cfg!(unix) => out.push(b'\\'),
            _ => {}
        }
        slashes = if byte == b'\\' { slashes + 1 } else { 0 };
        out.push(byte);
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_are_escaped_for_make() {
        let escaped_for_make = |name: &str| String::from_utf8(super::escaped_for_make(Path::new(name))).unwrap();
        assert_eq!(escaped_for_make("a b.inc"), r"a\ b.inc");
        assert_eq!(escaped_for_make("a$b#c"), r"a$$b\#c");
        assert_eq!(escaped_for_make(r"a\ b\c"), r"a\\\ b\c");
    }

    #[test]
    fn a_rule_and_one_for_each_file() {
        let [out, a, b] = ["o ut.png", "a.scene", "b c.inc"].map(PathBuf::from);
        let text = String::from_utf8(as_make_rule(&[out], &[a, b])).unwrap();
        assert_eq!(text, "o\\ ut.png: \\\n  a.scene \\\n  b\\ c.inc\n\na.scene:\n\nb\\ c.inc:\n");
    }
}
