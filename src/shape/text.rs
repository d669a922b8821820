//! `text { ttf "font.ttf" "string" depth, offset }`: a line of letters as solids (manual, "Text").
//!
//! The baseline is y = 0, from x = 0 on; an em is 1, and letters extend from z = 0 to z = `depth`. `offset` is added between one
//! letter and the next. With a `depth` below 0 there are only both ends, without any inside (quirk: `text_without_depth`).
//!
//! ```pov
//! text { ttf "timrom.ttf" "durer" 0.2, 0 pigment { color rgb <0.8, 0.3, 0.1> } scale 1.6 translate -1.6*x }
//! ```

use super::{Hit, Hits, Kernel, check_finite};
use crate::diagnostic::{Diagnostic, Result, codes};
use crate::font::{Curve, Outline};
use crate::math::{Aabb, DVec2, DVec3, Range, Ray, Transform, solve_quadratic};
use crate::source::Span;
use crate::value::{Next, Param, Readable, Reader, Spec, ValueKind};
use rustc_hash::FxHashMap;
use serde::Serialize;
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
    letters: Vec<Letter>,
    /// Transform from the letters' space to the text's space.
    #[serde(skip)]
    tilt: Box<Transform>,
    #[serde(skip)]
    bounds: Aabb,
}

/// Letter of a text at its position.
#[derive(Clone, Debug, PartialEq)]
struct Letter {
    shape: Arc<Glyph>,
    at: DVec3,
    /// Number of the letter's first part among the parts of all letters.
    first: u32,
}

/// Outline of a text's letter.
#[derive(Debug, PartialEq)]
struct Glyph {
    curves: Outline,
    min: DVec2,
    max: DVec2,
}

impl Glyph {
    fn new(curves: Outline) -> Self {
        let ends = |better: fn(DVec2, DVec2) -> DVec2| {
            curves
                .iter()
                .flat_map(|curve| [curve[0], extremum_of_turning_points(curve, better), curve[2]])
                .reduce(better)
        };
        let (min, max) = (ends(DVec2::min).unwrap_or_default(), ends(DVec2::max).unwrap_or_default());
        Self { curves, min, max }
    }

    /// True if the half-line from the point along +x crosses the letter's outlines an odd number of times. Each
    /// monotonic piece of a curve includes its lower end but not its upper end.
    fn outline_contains(&self, p: DVec2) -> bool {
        if p.y < self.min.y || p.y > self.max.y || p.x < self.min.x || p.x > self.max.x {
            return false;
        }
        let mut odd = false;
        for curve in &self.curves {
            let [a, b, c] = curve.map(|q| q - p);
            // y(s) = (a - 2b + c)·s² + 2(b - a)·s + a has at most one extremum.
            let turn = (a.y - b.y) / (a.y - 2.0 * b.y + c.y);
            let mut piece = |s0: f64, y0: f64, s1: f64, y1: f64| {
                if (y0 <= 0.0) != (y1 <= 0.0) {
                    odd ^= curve_point([a, b, c], bernstein_quadratic_root_between(a.y, b.y, c.y, s0, s1)).x > 0.0;
                }
            };
            if turn > 0.0 && turn < 1.0 {
                let top = curve_point([a, b, c], turn).y;
                piece(0.0, a.y, turn, top);
                piece(turn, top, 1.0, c.y);
            } else {
                piece(0.0, a.y, 1.0, c.y);
            }
        }
        odd
    }
}

/// Returns the curve's turning points along x and y, combined by `better` (componentwise minimum or maximum). The
/// curve's start replaces a turning point that is not between the ends.
fn extremum_of_turning_points(curve: &Curve, better: fn(DVec2, DVec2) -> DVec2) -> DVec2 {
    let turn = (curve[0] - curve[1]) / (curve[0] - 2.0 * curve[1] + curve[2]);
    let inner = |s: f64| if s > 0.0 && s < 1.0 { curve_point(*curve, s) } else { curve[0] };
    better(inner(turn.x), inner(turn.y))
}

fn curve_point([a, b, c]: Curve, s: f64) -> DVec2 {
    let r = 1.0 - s;
    a * (r * r) + b * (2.0 * r * s) + c * (s * s)
}

/// Returns the only root of (1 - s)²·a + 2s(1 - s)·b + s²·c between s0 and s1.
fn bernstein_quadratic_root_between(a: f64, b: f64, c: f64, s0: f64, s1: f64) -> f64 {
    let middle = (s0 + s1) / 2.0;
    let off = |s: &f64| (s - middle).abs();
    match solve_quadratic(a - 2.0 * b + c, 2.0 * (b - a), a) {
        Some((s, t)) if off(&t) < off(&s) => t.clamp(s0, s1),
        Some((s, _)) => s.clamp(s0, s1),
        None => middle,
    }
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
        let tilt = Box::new(Transform::rotate(DVec3::splat(TILT)));
        let mut text = Self { font: name, file, string, depth, letters: vec![], tilt, bounds: Aabb::EMPTY };
        let mut known = FxHashMap::default();
        let mut first = 0;
        for (i, set) in font.lay_out(&text.string).into_iter().enumerate() {
            let outline = || Arc::new(Glyph::new(font.outline(set.glyph)));
            let shape = known.entry(set.glyph).or_insert_with(outline).clone();
            if !shape.curves.is_empty() {
                // (The z component has no effect, as in POV-Ray.)
                let at = (offset.truncate() * i as f64).extend(0.0) + DVec3::X * set.x;
                let count = WALLS + shape.curves.len() as u32;
                text.letters.push(Letter { shape, at, first });
                first += count;
            }
        }
        let boxes = text.letters.iter().map(|letter| text.tilt.transform_aabb(&text.letter_bounds(letter)));
        text.bounds = boxes.fold(Aabb::EMPTY, Aabb::union);
        Ok(text)
    }

    fn finish(&mut self, span: Span, r: &mut dyn Reader) -> Result<()> {
        if self.letters.is_empty() {
            r.report(Diagnostic::new(codes::NO_SURFACE, span, "this `text` shows no letters"));
        }
        Ok(())
    }
}

impl Text {
    fn letter_bounds(&self, Letter { shape, at, .. }: &Letter) -> Aabb {
        Aabb::from_corners(at + shape.min.extend(0.0), at + shape.max.extend(self.depth))
    }

    /// Appends the hits on one letter of the text, with the ray in the letter's space.
    fn add_letter_hits(&self, letter: &Letter, ray: &Ray, range: Range, out: &mut Hits) {
        let (o, d) = (ray.origin - letter.at, ray.dir);
        let mut push = |t: f64, part: u32, s: f64| {
            if range.contains(t) {
                out.push(Hit { t, part: letter.first + part, uv: DVec2::new(s, 0.0) });
            }
        };
        for (part, z) in [(FRONT, 0.0), (BACK, self.depth)] {
            let t = (z - o.z) / d.z;
            if t.is_finite() && letter.shape.outline_contains((o + d * t).truncate()) {
                push(t, part, 0.0);
            }
        }
        let across = d.truncate();
        let length = across.length_squared();
        if length == 0.0 || self.depth < 0.0 {
            return;
        }
        for (part, curve) in (WALLS..).zip(&letter.shape.curves) {
            let from = curve.map(|p| p - o.truncate());
            // Signed distances from the ray, to the left.
            let [a, b, c] = from.map(|p| across.perp_dot(p));
            if (a > 0.0 && b > 0.0 && c > 0.0) || (a < 0.0 && b < 0.0 && c < 0.0) {
                continue;
            }
            let Some((s1, s2)) = solve_quadratic(a - 2.0 * b + c, 2.0 * (b - a), a) else { continue };
            for s in [s1, s2] {
                // A curve includes its first end but not its last, so that a corner is hit once.
                if (0.0..1.0).contains(&s) {
                    let t = across.dot(curve_point(from, s)) / length;
                    let z = o.z + d.z * t;
                    if z >= 0.0 && z <= self.depth {
                        push(t, part, s);
                    }
                }
            }
        }
    }

    /// Returns the text's letter that has this part, and the part's number within the letter.
    fn letter_and_own_part(&self, part_of_text: u32) -> (&Letter, u32) {
        let letter = &self.letters[self.letters.partition_point(|letter| letter.first <= part_of_text) - 1];
        (letter, part_of_text - letter.first)
    }
}

impl Kernel for Text {
    fn bounds(&self) -> Aabb {
        self.bounds
    }

    fn hits(&self, ray: &Ray, range: Range, out: &mut Hits) {
        let ray = self.tilt.inverse_transform_ray(ray);
        for letter in &self.letters {
            if self.letter_bounds(letter).slabs(&ray, range).is_some() {
                self.add_letter_hits(letter, &ray, range, out);
            }
        }
    }

    fn inside(&self, p: DVec3) -> bool {
        let p = self.tilt.inverse_transform_point(p);
        self.letters.iter().any(|letter| {
            let local = p - letter.at;
            local.z > 0.0 && local.z < self.depth && letter.shape.outline_contains(local.truncate())
        })
    }

    /// Normal of a text; walls point inwards (quirk: `text_walls`).
    fn normal(&self, _: DVec3, hit: &Hit) -> DVec3 {
        let (letter, part) = self.letter_and_own_part(hit.part);
        let n = match part {
            FRONT => DVec3::NEG_Z,
            BACK => DVec3::Z,
            _ => {
                let [a, b, c] = letter.shape.curves[(part - WALLS) as usize];
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::shape::testing::all_hits;

    fn text(string: &str) -> Text {
        crate::shape::testing::read_shape::<Text>(&format!("ttf \"roboto\" \"{string}\" 0.5 0")).0.unwrap()
    }

    #[test]
    fn hits_come_in_pairs_and_agree_with_inside() {
        let shape = text("Og8&");
        let mut met = 0;
        for k in 0..4000 {
            let at = |m: usize| (k * m % 997) as f64 / 997.0;
            let from = DVec3::new(at(13) * 3.0, at(29) - 0.2, at(5) - 0.2);
            let ray = Ray::new(from, DVec3::new(at(7) - 0.5, at(11) - 0.5, at(3) - 0.5));
            let hits = all_hits(&shape, &ray);
            assert!(hits.len().is_multiple_of(2), "{ray:?}: {hits:?}");
            met += hits.len();
            for pair in hits.windows(2) {
                let p = ray.at((pair[0].t + pair[1].t) / 2.0);
                let before = hits.iter().filter(|hit| hit.t < (pair[0].t + pair[1].t) / 2.0).count();
                assert!(pair[1].t - pair[0].t < 1e-9 || shape.inside(p) == (before % 2 == 1), "{ray:?}");
            }
            for hit in &hits {
                assert!(shape.bounds().grown(1e-9).contains(ray.at(hit.t)));
                assert!(shape.normal(ray.at(hit.t), hit).length() > 0.0);
            }
        }
        assert!(met > 2000, "{met}");
    }

    #[test]
    fn walls_point_inwards() {
        let shape = text("l");
        let hit = shape.closest(&Ray::new(DVec3::new(-1.0, 0.3, 0.2), DVec3::X), Range::FORWARD).unwrap();
        assert!(shape.normal(DVec3::ZERO, &hit).x > 0.0 && (hit.t - 1.0).abs() < 1e-5, "{hit:?}");
    }

    #[test]
    fn letters_lean() {
        // POV-Ray's `trace`
        let shape = text("l");
        let middle = shape.bounds().center();
        let hit = shape.closest(&Ray::new(middle.with_z(-9.0), DVec3::Z), Range::FORWARD).unwrap();
        let n = shape.normal(DVec3::ZERO, &hit) * 1e5;
        assert!((hit.t - 9.0 - 1.745_33e-5 * (middle.y - middle.x)).abs() < 1e-9, "{hit:?}");
        assert!((n - DVec3::new(-1.745_360, 1.745_299, -99_999.999_970)).length() < 1e-5, "{n}");
    }

    #[test]
    fn of_a_negative_depth_only_the_ends_are_left() {
        let shape = crate::shape::testing::read_shape::<Text>("ttf \"roboto\" \"l\" -0.5 0").0.unwrap();
        let middle = shape.bounds().center();
        let hits = all_hits(&shape, &Ray::new(middle.with_z(-5.0), DVec3::Z));
        assert!(hits.len() == 2 && (hits[0].t - 4.5).abs() < 1e-4 && (hits[1].t - 5.0).abs() < 1e-4, "{hits:?}");
        assert!(all_hits(&shape, &Ray::new(middle.with_x(-5.0), DVec3::X)).is_empty() && !shape.inside(middle));
        // Both ends exist even without depth (quirk: `text_without_depth`).
        let flat = crate::shape::testing::read_shape::<Text>("ttf \"roboto\" \"l\" 0 0").0.unwrap();
        assert_eq!(all_hits(&flat, &Ray::new(middle.with_z(-5.0), DVec3::Z)).len(), 2);
    }

    #[test]
    fn nothing_to_show() {
        assert_eq!(crate::shape::testing::read_shape::<Text>("ttf \"a\" \"\" 1 0").1[0].code, codes::NO_SURFACE);
    }
}
