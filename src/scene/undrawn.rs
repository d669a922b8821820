//! What stands for a shape that is not drawn yet: nothing in the picture, but a box about where the shape would be, for
//! scripts that ask where things end.

use super::{Defaults, Object, ObjectKind};
use crate::diagnostic::{Diagnostic, Result, codes};
use crate::math::{Aabb, DVec3};
use crate::value::{Next, Reader, Value};

/// How wide a letter is, and how far letters reach below and above their line, about.
const LETTER: [f64; 3] = [0.55, -0.2, 0.75];

/// The values that stand between the braces.
#[derive(Debug, Default)]
struct Seen {
    points: Vec<DVec3>,
    flat: bool,
    letters: usize,
}

impl Object {
    /// Reads a block that is not drawn yet: its modifiers as those of any object, all else only for its values.
    pub(super) fn read_undrawn(word: &'static str, r: &mut dyn Reader, defaults: &Defaults) -> Result<Box<Self>> {
        let source = r.take()?;
        r.report(Diagnostic::new(codes::UNSUPPORTED, source, format!("`{word}` is not drawn yet: it is left out")));
        let mut object = Box::new(Self::new(ObjectKind::Undrawn(Aabb::EMPTY), word, source, defaults));
        let mut seen = Seen::default();
        loop {
            let next = r.next()?;
            if next == Next::End {
                break;
            }
            if let Next::Word("ttf") = next {
                r.take()?;
                read_font(r)?;
                continue;
            }
            // Groups of lights and objects hold what looks like modifiers.
            if word == "light_group" || !object.read_modifier(next, r, defaults)? {
                r.pass(&mut |value| seen.note(value))?;
            }
        }
        r.leave()?;
        object.kind = ObjectKind::Undrawn(seen.about(word));
        Ok(object)
    }
}

/// `"cyrvetic.ttf"` of a `text`: names without ending mean `.ttf`.
fn read_font(r: &mut dyn Reader) -> Result<()> {
    let (at, name) = (r.span(), r.text()?);
    let full = if name.contains('.') { name.clone() } else { format!("{name}.ttf") };
    if r.find_file(&full, at)?.is_none() {
        let message = format!("the font `{name}` was not found: a similar one stands for it");
        let d = Diagnostic::new(codes::FONT_MISSING, at, message);
        r.report(d.help("fonts are looked for where included files are; -I DIR adds a folder"));
    }
    Ok(())
}

impl Seen {
    fn note(&mut self, value: &Value) {
        match value {
            Value::Vector(v) if self.points.len() < 100_000 => {
                self.flat |= v.len == 2;
                self.points.push(v.xyz());
            }
            Value::Text(text) => self.letters = text.chars().count(),
            _ => {}
        }
    }

    fn about(&self, word: &str) -> Aabb {
        let all = Aabb::from_points(self.points.iter().copied());
        match word {
            "text" => Aabb {
                min: DVec3::new(0.0, LETTER[1], 0.0),
                max: DVec3::new(LETTER[0] * self.letters as f64, LETTER[2], 1.0),
            },
            "lathe" | "sor" if self.flat => {
                let r = all.max.x.abs().max(all.min.x.abs());
                Aabb { min: DVec3::new(-r, all.min.y, -r), max: DVec3::new(r, all.max.y, r) }
            }
            "prism" if self.flat => {
                Aabb { min: DVec3::new(all.min.x, 0.0, all.min.y), max: DVec3::new(all.max.x, 1.0, all.max.y) }
            }
            "height_field" => Aabb { min: DVec3::ZERO, max: DVec3::ONE },
            "mesh" | "mesh2" | "bicubic_patch" | "sphere_sweep" | "blob" if self.points.len() > 1 => all,
            _ => Aabb { min: DVec3::NEG_ONE, max: DVec3::ONE },
        }
    }
}
