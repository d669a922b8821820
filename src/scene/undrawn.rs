//! What stands for a shape that is not drawn yet: nothing in the picture, but a box about where the shape would be, for
//! scripts that ask where things end.

use super::{Defaults, Object, ObjectKind};
use crate::diagnostic::{Diagnostic, Result, codes};
use crate::math::{Aabb, DVec3};
use crate::source::Span;
use crate::value::{Next, RawItem, Reader};
use serde::Serialize;
use std::path::{Path, PathBuf};
use std::sync::Arc;

/// How wide a letter is, and how far letters reach below and above their line, about.
const LETTER: [f64; 3] = [0.55, -0.2, 0.75];

/// A shape that is not drawn yet: what was said of it, without its modifiers.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Undrawn {
    /// Stands for it where scripts ask, in its own space.
    pub bounds: Aabb,
    /// What stands between its braces.
    #[serde(serialize_with = "RawItem::print_row")]
    pub said: Vec<RawItem>,
}

impl Object {
    /// Reads a block that is not drawn yet: its modifiers as those of any object, all else as it is said.
    pub(super) fn read_undrawn(word: &'static str, r: &mut dyn Reader, defaults: &Defaults) -> Result<Box<Self>> {
        let source = r.take()?;
        r.report(Diagnostic::new(codes::UNSUPPORTED, source, format!("`{word}` is not drawn yet: it is left out")));
        let mut object = Box::new(Self::unfinished(word, source, defaults));
        let mut said = vec![];
        loop {
            let next = r.next()?;
            if next == Next::End {
                break;
            }
            if let Next::Word("ttf") = next {
                r.take()?;
                said.push(read_font(r)?);
                continue;
            }
            // Groups of lights and objects hold what looks like modifiers.
            if word == "light_group" || !object.read_modifier(next, r, defaults)? {
                r.pass(&mut said)?;
            }
        }
        r.leave()?;
        object.kind = ObjectKind::Undrawn(Arc::new(Undrawn { bounds: about(word, &said), said }));
        Ok(object)
    }
}

/// `"cyrvetic.ttf"` of a `text`: names without ending mean `.ttf`. Behind the name stands the file that will be used.
fn read_font(r: &mut dyn Reader) -> Result<RawItem> {
    let (at, name) = (r.span(), r.text()?);
    let full = if name.contains('.') { name.clone() } else { format!("{name}.ttf") };
    let file = match r.find_file(&full, at)? {
        Some(file) => Some(file),
        None => stand_in(r, &name, at),
    };
    let names = std::iter::once(name).chain(file.map(|file| file.to_string_lossy().into_owned()));
    Ok(RawItem::Block("ttf", names.map(|name| RawItem::Text(name.into())).collect()))
}

/// The font that is used where the one of this name is not there.
fn stand_in(r: &mut dyn Reader, name: &str, at: Span) -> Option<PathBuf> {
    let found = r.similar_font(name);
    let what = match found.as_deref().and_then(Path::file_name) {
        Some(file) => format!(": `{}` stands for it", file.to_string_lossy()),
        None => ", and there is no other one that could stand for it".into(),
    };
    let d = Diagnostic::new(codes::FONT_MISSING, at, format!("the font `{name}` was not found{what}"));
    r.report(d.help("fonts are looked for where included files are; -I DIR adds a folder"));
    found
}

/// A box about where the shape is.
fn about(word: &str, said: &[RawItem]) -> Aabb {
    let (mut all, mut count) = (Aabb::EMPTY, 0);
    for part in said {
        part.visit_vectors(&mut |v| {
            all = all.union(Aabb::from_points([v.xyz()]));
            count += 1;
        });
    }
    match word {
        "text" => {
            let text =
                said.iter().rev().find_map(|part| if let RawItem::Text(text) = part { Some(text) } else { None });
            let letters = text.map_or(0, |text| text.chars().count());
            Aabb { min: DVec3::new(0.0, LETTER[1], 0.0), max: DVec3::new(LETTER[0] * letters as f64, LETTER[2], 1.0) }
        }
        "height_field" => Aabb { min: DVec3::ZERO, max: DVec3::ONE },
        "mesh" | "mesh2" | "bicubic_patch" | "sphere_sweep" | "blob" if count > 1 => all,
        _ => Aabb { min: DVec3::NEG_ONE, max: DVec3::ONE },
    }
}
