//! Search for fonts by their own names, such as `DejaVu Sans Bold`.

use super::Font;
use crate::source::Files;
use fontdb::{Database, FaceInfo, Family, ID, Query, Source, Stretch, Style, Weight};
use std::path::PathBuf;
use std::sync::Arc;

/// Location of a font: in durer or in a file.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub enum FontLocation {
    /// Built-in font of durer.
    Own,
    /// Font in a file, by its index in the file, counted from 0.
    File(PathBuf, u32),
}

impl FontLocation {
    /// Returns the location of the first or only font of a font file.
    pub fn first_in_file(path: PathBuf) -> Self {
        Self::File(path, 0)
    }
}

/// Weight, slant and width that a font's name asks for.
#[derive(Clone, Copy, Debug, PartialEq)]
struct FontStyle {
    weight: Weight,
    style: Style,
    stretch: Stretch,
}

const PLAIN: FontStyle = FontStyle { weight: Weight::NORMAL, style: Style::Normal, stretch: Stretch::Normal };

/// Words that name a font's weight after the family's name.
const WEIGHTS: &[(&str, Weight)] = &[
    ("thin", Weight::THIN),
    ("extralight", Weight::EXTRA_LIGHT),
    ("light", Weight::LIGHT),
    ("regular", Weight::NORMAL),
    ("book", Weight::NORMAL),
    ("medium", Weight::MEDIUM),
    ("semibold", Weight::SEMIBOLD),
    ("demibold", Weight::SEMIBOLD),
    ("bold", Weight::BOLD),
    ("extrabold", Weight::EXTRA_BOLD),
    ("black", Weight::BLACK),
    ("heavy", Weight::BLACK),
];
const STYLES: &[(&str, Style)] = &[("italic", Style::Italic), ("oblique", Style::Oblique)];
const STRETCHES: &[(&str, Stretch)] =
    &[("condensed", Stretch::Condensed), ("narrow", Stretch::Condensed), ("expanded", Stretch::Expanded)];

/// Returns the font of a family whose weight, style and width are nearest to the words after the family's name, from
/// the font files `paths` and durer's own font; `None` if no family has the name, or if a word after the name is
/// unknown.
pub fn find_family(files: &dyn Files, name: &str, paths: &[PathBuf]) -> Option<FontLocation> {
    let (mut fonts, mut places) = (Database::new(), vec![]);
    for path in paths.iter().filter(|path| files.may_read(path)) {
        // A file that is not a font has no family.
        let Ok(bytes) = files.read_unrecorded(path) else { continue };
        add_faces(&mut fonts, bytes, &mut places, |number| FontLocation::File(path.clone(), number));
    }
    add_faces(&mut fonts, Font::OWN.to_vec(), &mut places, |_| FontLocation::Own);
    let words: Vec<&str> = name.split_whitespace().collect();
    // Prefer the longest family: that of `Arial Black` is not `Arial`.
    let (family, looks) = (1..=words.len()).rev().find_map(|count| {
        let looks = parse_style(&words[count..])?;
        let family = words[..count].join(" ");
        let found = fonts.faces().find_map(|face| matching_family_name(face, &family))?;
        Some((found.to_string(), looks))
    })?;
    let FontStyle { weight, style, stretch } = looks;
    let id = fonts.query(&Query { families: &[Family::Name(&family)], weight, stretch, style })?;
    places.into_iter().find(|(face, _)| *face == id).map(|(_, place)| place)
}

/// Adds the descriptions of a font file's fonts, without the file's bytes, to a database.
fn add_faces(
    fonts: &mut Database,
    bytes: Vec<u8>,
    locations: &mut Vec<(ID, FontLocation)>,
    location_of_index: impl Fn(u32) -> FontLocation,
) {
    let mut of_file = Database::new();
    of_file.load_font_source(Source::Binary(Arc::new(bytes)));
    for face in of_file.faces() {
        let id = fonts.push_face_info(FaceInfo { source: Source::Binary(Arc::new([])), ..face.clone() });
        locations.push((id, location_of_index(face.index)));
    }
}

/// The name of a font's family, if it equals `family` in any language.
fn matching_family_name<'f>(face: &'f FaceInfo, family: &str) -> Option<&'f str> {
    face.families.iter().map(|(name, _)| &**name).find(|name| name.to_lowercase() == family.to_lowercase())
}

fn parse_style(words: &[&str]) -> Option<FontStyle> {
    words.iter().try_fold(PLAIN, |looks, word| {
        let word = word.to_lowercase();
        if let Some(&(_, weight)) = WEIGHTS.iter().find(|(name, _)| *name == word) {
            return Some(FontStyle { weight, ..looks });
        }
        if let Some(&(_, style)) = STYLES.iter().find(|(name, _)| *name == word) {
            return Some(FontStyle { style, ..looks });
        }
        STRETCHES.iter().find(|(name, _)| *name == word).map(|&(_, stretch)| FontStyle { stretch, ..looks })
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::source::{Memory, Sandbox, Sandboxed};

    /// Storage with a broken font and durer's own font, and the paths of both.
    fn roboto() -> (Memory, [PathBuf; 2]) {
        let (files, paths) = (Memory::default(), ["b.ttf", "a.ttf"].map(PathBuf::from));
        files.insert(&paths[0], "no font");
        files.insert(&paths[1], Font::OWN);
        (files, paths)
    }

    #[test]
    fn families_are_found_in_any_case_and_with_style_words() {
        let (files, paths) = roboto();
        for (name, is_there) in [
            ("Roboto", true),
            ("roboto regular", true),
            // the nearest one
            ("Roboto Bold Italic", true),
            ("Roboto Slab", false),
            ("Bold", false),
            ("", false),
        ] {
            let found = find_family(&files, name, &paths);
            assert_eq!(found, is_there.then(|| FontLocation::first_in_file(paths[1].clone())), "{name}");
        }
        let nothing = Sandbox::default();
        assert_eq!(find_family(&Sandboxed::new(&files, &nothing), "Roboto", &paths), Some(FontLocation::Own));
    }

    #[test]
    fn style_words() {
        let bold = FontStyle { weight: Weight::BOLD, style: Style::Oblique, stretch: Stretch::Condensed };
        assert_eq!(parse_style(&["Condensed", "Bold", "Oblique"]), Some(bold));
        assert_eq!((parse_style(&[]), parse_style(&["Sans"])), (Some(PLAIN), None));
    }
}
