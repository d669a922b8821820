//! `text { ttf "font.ttf" "string" depth, offset }`: a line of letters as solids (manual, "Text").
//!
//! The baseline is y = 0, from x = 0 on; an em is 1, and letters extend from z = 0 to z = `depth`. `offset` is added between one
//! letter and the next. With a `depth` below 0 there are only both ends, without any inside (quirk: `text_without_depth`).
//!
//! ```pov
//! text { ttf "timrom.ttf" "durer" 0.2, 0 pigment { color rgb <0.8, 0.3, 0.1> } scale 1.6 translate -1.6*x }
//! ```

mod glyph;
mod row;
#[cfg(test)]
mod tests;

use super::{Hit, Hits, Kernel, check_finite};
use crate::diagnostic::{Diagnostic, Result, codes};
use crate::math::{Aabb, DVec2, DVec3, Range, Ray, Transform};
use crate::source::Span;
use crate::value::{Next, Param, Readable, Reader, Spec, ValueKind};
use glyph::Glyph;
use row::Row;
use rustc_hash::FxHashMap;
use serde::Serialize;
use std::ops::ControlFlow;
use std::path::PathBuf;
use std::sync::Arc;

/// Fonts that come with POV-Ray, by the number in `text`; any other number is the first.
const INTERNAL: [&str; 4] = ["povlogo.ttf", "timrom.ttf", "cyrvetic.ttf", "crystal.ttf"];

/// Rotation of a text's letters about each axis, in degrees (quirk: `text_tilt`).
const TILT: f64 = 0.001;

/// Part numbers of a text's letter: both ends, then its curves.
const FRONT: u32 = 0;
const BACK: u32 = 1;
const WALLS: u32 = 2;

/// Shape `text`: solid letters in a row.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Text {
    /// Name of the text's font, as written.
    pub font: String,
    /// Path of the text's font file.
    pub file: PathBuf,
    /// Text whose letters the shape `text` consists of.
    pub string: String,
    /// Extent of the text's letters along z.
    pub depth: f64,
    /// Letters of the text that have an outline.
    #[serde(skip)]
    row: Row,
    /// Transform from the letters' space to the text's space.
    #[serde(skip)]
    tilt: Box<Transform>,
    #[serde(skip)]
    bounds: Aabb,
}

impl Readable for Text {
    const SPEC: Spec = Spec {
        name: "text",
        summary: "a line of letters as solids",
        params: &[
            Param {
                name: "ttf \"font.ttf\"",
                kind: ValueKind::Text,
                summary: "a TrueType or OpenType font, or the name of an installed family; `internal` and a number takes one of POV-Ray's",
            },
            Param { name: "string", kind: ValueKind::Text, summary: "what is written" },
            Param { name: "depth", kind: ValueKind::Float, summary: "how far the letters reach along z" },
            Param { name: "offset", kind: ValueKind::Vector, summary: "added between one letter and the next" },
        ],
        ..Spec::EMPTY
    };

    fn read(r: &mut dyn Reader) -> Result<Self> {
        let name = match r.peek_next()? {
            Next::Word("ttf") => {
                r.take_token()?;
                None
            }
            Next::Word("internal") => {
                r.take_token()?;
                let number = r.float()?;
                Some(INTERNAL.get(number as usize).copied().unwrap_or(INTERNAL[0]))
            }
            _ => return Err(r.unexpected("`ttf` and the name of a font").into()),
        };
        let at = r.span();
        let name = name.map_or_else(|| r.text(), |name| Ok(name.to_string()))?;
        let font = r.find_font_or_substitute(&name, at)?;
        let string = r.text()?;
        let span = r.span();
        let (depth, offset) = (r.float()?, r.vector()?);
        check_finite(span, &[offset], &[depth])?;
        let file = font.path().to_path_buf();
        let mut known = FxHashMap::default();
        let mut placed = vec![];
        for (i, set) in font.lay_out(&string).into_iter().enumerate() {
            let outline = || Arc::new(Glyph::new(font.outline(set.glyph)));
            let glyph: Arc<Glyph> = known.entry(set.glyph).or_insert_with(outline).clone();
            if glyph.curve_count() > 0 {
                // (The z component has no effect, as in POV-Ray.)
                placed.push((glyph, (offset.truncate() * i as f64).extend(0.0) + DVec3::X * set.x));
            }
        }
        let row = Row::new(placed, depth);
        let tilt = Box::new(Transform::rotate(DVec3::splat(TILT)));
        let boxes = row.letters.iter().map(|letter| tilt.transform_aabb(&letter.bounds));
        let bounds = boxes.fold(Aabb::EMPTY, Aabb::union);
        Ok(Self { font: name, file, string, depth, row, tilt, bounds })
    }

    fn complete_and_check(&mut self, span: Span, r: &mut dyn Reader) -> Result<()> {
        if self.row.letters.is_empty() {
            r.report(Diagnostic::new(codes::NO_SURFACE, span, "this `text` shows no letters"));
        }
        Ok(())
    }
}

impl Text {
    /// Calls `visit` with each hit of a ray on the text in the range; see [`Row::visit_hits`].
    fn visit_hits(&self, ray: &Ray, range: Range, visit: impl FnMut(Hit) -> ControlFlow<(), f64>) -> ControlFlow<()> {
        self.row.visit_hits(&self.tilt.inverse_transform_ray(ray), range, visit)
    }
}

impl Kernel for Text {
    fn bounds(&self) -> Aabb {
        self.bounds
    }

    /// Appends the text's hits in ascending order of their parts, which decides between hits at one point.
    fn hits(&self, ray: &Ray, range: Range, out: &mut Hits) {
        let first = out.len();
        let _ = self.visit_hits(ray, range, |hit| {
            out.push(hit);
            ControlFlow::Continue(range.max)
        });
        out[first..].sort_by_key(|hit| hit.part);
    }

    fn closest(&self, ray: &Ray, range: Range) -> Option<Hit> {
        let mut best: Option<Hit> = None;
        let _ = self.visit_hits(ray, range, |hit| {
            let wins_against = |best: Hit| hit.t.total_cmp(&best.t).then(hit.part.cmp(&best.part)).is_lt();
            let closest = best.filter(|best| !wins_against(*best)).unwrap_or(hit);
            best = Some(closest);
            ControlFlow::Continue(closest.t)
        });
        best
    }

    fn any_hit(&self, ray: &Ray, range: Range) -> bool {
        self.visit_hits(ray, range, |_| ControlFlow::Break(())).is_break()
    }

    fn inside(&self, p: DVec3) -> bool {
        self.row.contains(self.tilt.inverse_transform_point(p))
    }

    /// Normal of a text; walls point inwards (quirk: `text_walls`).
    fn normal(&self, _: DVec3, hit: &Hit) -> DVec3 {
        let (letter, part) = self.row.letter_and_own_part(hit.part);
        let n = match part {
            FRONT => DVec3::NEG_Z,
            BACK => DVec3::Z,
            _ => {
                let [a, b, c] = *letter.glyph.curve((part - WALLS) as usize);
                let along = (b - a) * (1.0 - hit.uv.x) + (c - b) * hit.uv.x;
                let along = if along == DVec2::ZERO { c - a } else { along };
                DVec3::new(along.y, -along.x, 0.0)
            }
        };
        // A rotation transforms normals as vectors.
        self.tilt.transform_vector(n)
    }

    fn has_uv_mapping(&self) -> bool {
        false
    }
}
