//! Substitutes for fonts that a scene names and that are not installed.

use super::Files;
use std::path::{Path, PathBuf};

/// Style of a font, derived from the name of its file.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct Style {
    family: Family,
    bold: bool,
    italic: bool,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Family {
    Mono,
    Sans,
    Serif,
}

/// Parts of file names in lower case, with the families that they indicate. The first match counts; else `Sans`.
const FAMILIES: &[(&str, Family)] = &[
    ("cour", Family::Mono),
    ("mono", Family::Mono),
    ("crystal", Family::Mono),
    ("consol", Family::Mono),
    ("typewriter", Family::Mono),
    ("lucon", Family::Mono),
    ("fixed", Family::Mono),
    ("sans", Family::Sans),
    ("times", Family::Serif),
    ("timrom", Family::Serif),
    ("roman", Family::Serif),
    ("serif", Family::Serif),
    ("georgia", Family::Serif),
    ("garamond", Family::Serif),
    ("pala", Family::Serif),
    ("book", Family::Serif),
    ("century", Family::Serif),
    ("cambria", Family::Serif),
    ("antiqua", Family::Serif),
    ("bodoni", Family::Serif),
];

/// Families whose font files on Windows abbreviate the style: `arialbd`, `verdanaz`.
const ABBREVIATED_FAMILIES: &[&str] = &[
    "arial", "times", "cour", "verdana", "georgia", "trebuc", "tahoma", "calibri", "cambria", "consola", "pala",
    "comic",
];

/// Abbreviations of styles in the names of font files. The flags are bold and italic.
const STYLE_ABBREVIATIONS: &[(&str, bool, bool)] = &[
    ("bd", true, false),
    ("b", true, false),
    ("i", false, true),
    ("it", false, true),
    ("bi", true, true),
    ("z", true, true),
];

/// Parts of the names of preferred substitute fonts. The first ones have the letter widths of Windows' fonts.
const PREFERRED: &[&str] = &["liberation", "dejavu", "free", "noto", "timrom", "cyrvetic", "crystal"];

/// Parts of the names of fonts that are unsuitable for plain text.
const UNSUITABLE: &[&str] =
    &["condensed", "narrow", "light", "thin", "black", "math", "symbol", "emoji", "dingbat", "logo", "icon", "caps"];

impl Style {
    /// Guesses the style of a font from its name or file name.
    fn of_font_name(name: &str) -> Self {
        let plain = lowercase_letters_of_stem(name);
        let family = FAMILIES.iter().find(|(part, _)| plain.contains(part)).map_or(Family::Sans, |(_, family)| *family);
        let holds = |parts: &[&str]| parts.iter().any(|part| plain.contains(part));
        let (bold, italic) = (holds(&["bold", "black", "heavy"]), holds(&["italic", "oblique", "slanted"]));
        let ending = ABBREVIATED_FAMILIES.iter().find_map(|short| plain.strip_prefix(short));
        let (b, i) =
            STYLE_ABBREVIATIONS.iter().find(|(e, ..)| ending == Some(e)).map_or((false, false), |(_, b, i)| (*b, *i));
        Self { family, bold: bold || b, italic: italic || i }
    }
}

/// Returns the letters of a file's name in lower case, without its extension.
fn lowercase_letters_of_stem(name: &str) -> String {
    let last = name.rsplit(['/', '\\']).next().unwrap_or(name);
    let stem = last.rsplit_once('.').map_or(last, |(stem, _)| stem);
    stem.chars().filter(|c| c.is_ascii_alphabetic()).map(|c| c.to_ascii_lowercase()).collect()
}

/// Returns all font files in and below these folders, in the order of the folders and of the files' paths.
pub fn font_files(files: &dyn Files, folders: &[PathBuf]) -> Vec<PathBuf> {
    let mut found = vec![];
    folders.iter().for_each(|folder| collect_font_files(files, folder, MAX_DEPTH, &mut found));
    found
}

/// Returns the font file in and below these folders whose style is nearest to the style of the font `name`; `None` if no
/// font file may be read. The result depends only on the set of files that may be read.
pub fn find_similar_font(files: &dyn Files, name: &str, folders: &[PathBuf]) -> Option<PathBuf> {
    let (mut found, wanted) = (font_files(files, folders), Style::of_font_name(name));
    found.sort_by_cached_key(|file| (style_difference_key(wanted, file), file.clone()));
    found.into_iter().find(|file| files.may_read(file))
}

/// Largest nesting depth of the folders that are searched for font files.
const MAX_DEPTH: usize = 6;
/// Largest number of font files that a search for fonts reads.
const MAX_FILES: usize = 20_000;

fn collect_font_files(files: &dyn Files, folder: &Path, levels_left: usize, out: &mut Vec<PathBuf>) {
    let entries = files.list(folder).unwrap_or_default();
    let mut paths: Vec<PathBuf> = entries.into_iter().map(|entry| folder.join(entry.name)).collect();
    paths.sort();
    for path in paths {
        if files.is_folder(&path) && levels_left > 0 {
            collect_font_files(files, &path, levels_left - 1, out);
        } else if is_font_file_name(&path) && files.is_file(&path) && out.len() < MAX_FILES {
            out.push(path);
        }
    }
}

/// True if the path has the extension of a font file.
pub fn is_font_file_name(path: &Path) -> bool {
    let ending = path.extension().and_then(|e| e.to_str()).unwrap_or("");
    ["ttf", "otf", "ttc"].iter().any(|e| ending.eq_ignore_ascii_case(e))
}

/// Returns a key that sorts font files by their difference from the wanted style: unsuitable fonts last, then by
/// family, bold, italic, place in the list of preferred fonts, and name.
fn style_difference_key(wanted: Style, file: &Path) -> (bool, bool, bool, bool, usize, String) {
    let name = file.file_name().unwrap_or_default().to_string_lossy();
    let (style, plain) = (Style::of_font_name(&name), lowercase_letters_of_stem(&name));
    let odd = UNSUITABLE.iter().any(|part| plain.contains(part));
    let rank = PREFERRED.iter().position(|p| plain.starts_with(p)).unwrap_or(PREFERRED.len());
    (odd, style.family != wanted.family, style.bold != wanted.bold, style.italic != wanted.italic, rank, plain)
}

/// Returns the folders of fonts: those in `DURER_FONTS`, or the folders of the system and the user.
pub fn font_folders() -> Vec<PathBuf> {
    if let Some(list) = std::env::var_os("DURER_FONTS") {
        return std::env::split_paths(&list).collect();
    }
    let home = std::env::var_os("HOME").map(PathBuf::from);
    let own = home.iter().flat_map(|home| [home.join(".fonts"), home.join(".local/share/fonts")]);
    SYSTEM.iter().map(PathBuf::from).chain(own).collect()
}

/// Folders of fonts on Linux and macOS.
const SYSTEM: &[&str] = &["/usr/share/fonts", "/usr/local/share/fonts", "/Library/Fonts", "/System/Library/Fonts"];

#[cfg(test)]
mod tests {
    use super::*;
    use crate::source::{Disk, Sandbox, Sandboxed};

    const DEJAVU: &[&str] = &[
        "DejaVuMathTeXGyre",
        "DejaVuSans",
        "DejaVuSans-Bold",
        "DejaVuSans-BoldOblique",
        "DejaVuSans-ExtraLight",
        "DejaVuSansCondensed",
        "DejaVuSansMono",
        "DejaVuSansMono-Bold",
        "DejaVuSerif",
        "DejaVuSerif-BoldItalic",
        "DejaVuSerif-Italic",
        "OpenSymbol",
    ];

    fn folder(names: &[&str]) -> tempfile::TempDir {
        let folder = tempfile::tempdir().unwrap();
        std::fs::create_dir(folder.path().join("truetype")).unwrap();
        for name in names {
            std::fs::write(folder.path().join("truetype").join(format!("{name}.ttf")), "").unwrap();
        }
        folder
    }

    fn found(name: &str, folders: &[&tempfile::TempDir]) -> Option<String> {
        let folders: Vec<PathBuf> = folders.iter().map(|f| f.path().to_path_buf()).collect();
        let file = find_similar_font(&Disk, name, &folders)?;
        Some(file.file_stem()?.to_str()?.to_string())
    }

    #[test]
    fn the_substitute_has_the_same_style() {
        let fonts = folder(DEJAVU);
        for (name, like) in [
            ("timrom.ttf", "DejaVuSerif"),
            ("timesi.ttf", "DejaVuSerif-Italic"),
            ("Times New Roman Bold Italic.otf", "DejaVuSerif-BoldItalic"),
            ("arial.ttf", "DejaVuSans"),
            ("c:\\windows\\fonts\\arialbd.ttf", "DejaVuSans-Bold"),
            ("VERDANAZ.TTF", "DejaVuSans-BoldOblique"),
            ("cyrvetic", "DejaVuSans"),
            ("cour.ttf", "DejaVuSansMono"),
            ("CourierNew-Bold.ttf", "DejaVuSansMono-Bold"),
            ("crystal.ttf", "DejaVuSansMono"),
            ("no_such_font.ttf", "DejaVuSans"),
        ] {
            assert_eq!(found(name, &[&fonts]).as_deref(), Some(like), "{name}");
        }
    }

    #[test]
    fn preferred_fonts_are_chosen_first() {
        let (dejavu, others) = (folder(DEJAVU), folder(&["AArdvark", "LiberationSans-Regular", "LiberationSerif"]));
        assert_eq!(found("arial", &[&dejavu, &others]).as_deref(), Some("LiberationSans-Regular"));
        assert_eq!(found("arial", &[&others, &dejavu]).as_deref(), Some("LiberationSans-Regular"));
        assert_eq!(found("arialbd", &[&others, &dejavu]).as_deref(), Some("DejaVuSans-Bold"));
        assert_eq!(found("cour", &[&folder(&["AArdvark"])]).as_deref(), Some("AArdvark"));
    }

    #[test]
    fn without_fonts_there_is_no_substitute() {
        assert_eq!(found("arial.ttf", &[&folder(&[])]), None);
        let fonts = folder(DEJAVU);
        let nothing = Sandbox::default();
        assert_eq!(find_similar_font(&Sandboxed::new(&Disk, &nothing), "arial.ttf", &[fonts.path().into()]), None);
    }
}
