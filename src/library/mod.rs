//! The include files that are built in, for machines without an installed POV-Ray.
//!
//! Written anew from the manual's section 3.4.9, "Include Files": the same names, parameters and results.

mod index;

pub use index::{declared_in, declares, index_names, is_standard};

/// Before the names of these files in messages.
pub const FOLDER: &str = "<durer>";

/// The text of an include file. Letter case does not count, as on the machines that many scenes come from.
pub fn find(name: &str) -> Option<&'static str> {
    FILES.iter().find(|(file, _)| file.eq_ignore_ascii_case(name)).map(|(_, text)| *text)
}

/// Their names.
pub fn names() -> impl Iterator<Item = &'static str> {
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
    "rand.inc",
    "shapes.inc",
    "shapes2.inc",
    "shapes_old.inc",
    "stdinc.inc",
    "strings.inc",
    "transforms.inc",
];
