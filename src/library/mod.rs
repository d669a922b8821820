//! Built-in standard include files, for machines without an installed POV-Ray.
//!
//! Written from the manual's section 3.4.9, "Include Files", with the same names, parameters and results.

mod index;

pub use index::{declares, is_standard_include, standard_file_of, standard_names};

/// Prefix of the names of built-in include files in messages.
pub const FOLDER: &str = "<durer>";

/// Returns the text of a built-in include file; `None` if no file has the name, which is without a folder and in any letter
/// case, as on the systems that many scenes come from.
pub fn builtin_file_text(name: &str) -> Option<&'static str> {
    FILES.iter().find(|(file, _)| file.eq_ignore_ascii_case(name)).map(|(_, text)| *text)
}

/// Returns the names of the built-in include files.
pub fn builtin_file_names() -> impl Iterator<Item = &'static str> {
    FILES.iter().map(|(name, _)| *name)
}

macro_rules! files {
    ($($name:literal),* $(,)?) => {
        &[$(($name, include_str!(concat!("include/", $name)))),*]
    };
}

const FILES: &[(&str, &str)] = files![
    "arrays.inc",
    "colors.inc",
    "consts.inc",
    "functions.inc",
    "math.inc",
    "rad_def.inc",
    "rand.inc",
    "shapes.inc",
    "shapes2.inc",
    "shapes_old.inc",
    "stdinc.inc",
    "strings.inc",
    "transforms.inc",
];
