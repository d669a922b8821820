//! Fonts: TrueType and OpenType files, and the layout of a line of text. No other module reads font files.
//!
//! Lengths are in units of the font's size: an em is 1.

mod installed;
#[cfg(test)]
mod tests;

pub use installed::{FontLocation, find_family};

use crate::diagnostic::{Diagnostic, Result, codes, file};
use crate::math::DVec2;
use crate::source::{Files, ReadError, Span};
use std::borrow::Cow;
use std::path::Path;
use ttf_parser::{Face, GlyphId, OutlineBuilder, kern};

/// A font file.
pub struct Font {
    /// Location of the font.
    place: FontLocation,
    data: Cow<'static, [u8]>,
}

/// A glyph on a line of text.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PlacedGlyph {
    /// Index of the glyph in the font.
    pub glyph: u16,
    /// Position of the glyph's origin along the line.
    pub x: f64,
}

/// A piece of an outline: (1 - s)²·a + 2s(1 - s)·b + s²·c for s from 0 to 1. A straight one has `b` in the middle.
pub type Curve = [DVec2; 3];

/// Closed outlines of a glyph, as a list of curves; the inside is where the number of enclosing outlines is odd.
pub type Outline = Vec<Curve>;

/// Number of quadratic curves that approximate a cubic one.
const PIECES: u32 = 4;

impl Font {
    /// Roboto (Apache-2.0).
    const OWN: &[u8] = include_bytes!("Roboto-Regular.ttf");

    /// Reads a file.
    ///
    /// # Errors
    /// E0002 if it does not exist, E0003 if it can't be read, E0236 if it is not a font.
    pub fn read(files: &dyn Files, place: &FontLocation) -> Result<Self> {
        let FontLocation::File(path, number) = place else { return Ok(Self::own()) };
        let data = files.read(path).map_err(|e| file::unreadable(files, path, &ReadError::Io(e)))?;
        match Face::parse(&data, *number) {
            Ok(_) => Ok(Self { place: place.clone(), data: data.into() }),
            Err(fault) => {
                let message = format!("`{}` is no font that can be read: {fault}", path.display());
                Diagnostic::err(codes::BAD_DATA, Span::NONE, message)
            }
        }
    }

    /// The built-in font, for machines without any: Latin, Greek and Cyrillic letters of Roboto.
    pub fn own() -> Self {
        Self { place: FontLocation::Own, data: Cow::Borrowed(Self::OWN) }
    }

    /// The font's file; the built-in font has only a name.
    pub fn path(&self) -> &Path {
        if let FontLocation::File(path, _) = &self.place { path } else { Path::new("Roboto-Regular.ttf") }
    }

    fn face(&self) -> Option<Face<'_>> {
        let number = if let FontLocation::File(_, number) = self.place { number } else { 0 };
        Face::parse(&self.data, number).ok()
    }

    /// Lays out a line of text: the left edge of the first glyph is at 0, and kerning pairs are moved together.
    /// Composite glyphs are shifted to the right by their left bearing (quirk: `text_layout`). Characters without a
    /// glyph show glyph 0.
    pub fn set(&self, text: &str) -> Vec<PlacedGlyph> {
        let Some(face) = self.face() else { return vec![] };
        let em = f64::from(face.units_per_em());
        let glyphs: Vec<GlyphId> = text.chars().map(|c| glyph_of(&face, c)).collect();
        let bearing = |glyph: &GlyphId| face.glyph_hor_side_bearing(*glyph).map_or(0.0, f64::from);
        let mut x = -glyphs.first().map_or(0.0, bearing);
        let mut line = Vec::with_capacity(glyphs.len());
        for (i, &glyph) in glyphs.iter().enumerate() {
            let right = if is_composite(&face, glyph) { bearing(&glyph) } else { 0.0 };
            line.push(PlacedGlyph { glyph: glyph.0, x: (x + right) / em });
            x += face.glyph_hor_advance(glyph).map_or(0.0, f64::from);
            x += glyphs.get(i + 1).map_or(0.0, |next| kerning(face.tables().kern, glyph, *next));
        }
        line
    }

    /// The outline of a glyph; empty if it has none.
    pub fn outline(&self, glyph: u16) -> Outline {
        let Some(face) = self.face() else { return vec![] };
        let mut pen = Pen { scale: 1.0 / f64::from(face.units_per_em()), ..Pen::default() };
        face.outline_glyph(GlyphId(glyph), &mut pen);
        pen.close();
        pen.curves
    }
}

/// The glyph of a character. Symbol fonts, which do not use Unicode, have their glyphs at 0xF000 and above.
fn glyph_of(face: &Face, c: char) -> GlyphId {
    let others = || face.tables().cmap.into_iter().flat_map(|cmap| cmap.subtables).filter(|table| !table.is_unicode());
    let code = u32::from(c);
    let symbol = || others().find_map(|table| table.glyph_index(0xF000 + code).or_else(|| table.glyph_index(code)));
    face.glyph_index(c).or_else(symbol).unwrap_or_default()
}

/// True if the glyph is composed of others (OpenType, "glyf": a negative number of contours).
fn is_composite(face: &Face, glyph: GlyphId) -> bool {
    let tables = face.raw_face();
    let [glyf, loca] = [b"glyf", b"loca"].map(|tag| tables.table(ttf_parser::Tag::from_bytes(tag)).unwrap_or_default());
    let number = |bytes: Option<&[u8]>| bytes.map(|bytes| bytes.iter().fold(0, |n, &b| n << 8 | usize::from(b)));
    let i = usize::from(glyph.0);
    let start = match face.tables().head.index_to_location_format {
        ttf_parser::head::IndexToLocationFormat::Short => number(loca.get(2 * i..2 * i + 2)).map(|n| 2 * n),
        ttf_parser::head::IndexToLocationFormat::Long => number(loca.get(4 * i..4 * i + 4)),
    };
    start.and_then(|start| glyf.get(start)).is_some_and(|first| first & 0x80 != 0)
}

/// Kerning of a pair (`kern` table), in font units. Pairs should be sorted; as in POV-Ray 3.7, unsorted ones are found
/// too (quirk: `text_layout`).
fn kerning(kern: Option<kern::Table>, left: GlyphId, right: GlyphId) -> f64 {
    let tables = kern.into_iter().flat_map(|kern| kern.subtables);
    let mut tables = tables.filter(|table| table.horizontal && !table.variable && !table.has_state_machine);
    let both = u32::from(left.0) << 16 | u32::from(right.0);
    let value = |table: kern::Subtable| match table.format {
        kern::Format::Format0(list) => list.pairs.into_iter().find(|pair| pair.pair == both).map(|pair| pair.value),
        _ => table.glyphs_kerning(left, right),
    };
    tables.find_map(value).map_or(0.0, f64::from)
}

/// Collects outlines.
#[derive(Default)]
struct Pen {
    scale: f64,
    curves: Outline,
    start: DVec2,
    at: DVec2,
}

impl Pen {
    fn point(&self, x: f32, y: f32) -> DVec2 {
        DVec2::new(f64::from(x), f64::from(y)) * self.scale
    }

    fn to(&mut self, b: DVec2, c: DVec2) {
        if c != self.at || b != self.at {
            self.curves.push([self.at, b, c]);
        }
        self.at = c;
    }
}

impl OutlineBuilder for Pen {
    fn move_to(&mut self, x: f32, y: f32) {
        self.close();
        self.start = self.point(x, y);
        self.at = self.start;
    }

    fn line_to(&mut self, x: f32, y: f32) {
        let end = self.point(x, y);
        self.to((self.at + end) / 2.0, end);
    }

    fn quad_to(&mut self, bx: f32, by: f32, x: f32, y: f32) {
        self.to(self.point(bx, by), self.point(x, y));
    }

    fn curve_to(&mut self, bx: f32, by: f32, cx: f32, cy: f32, x: f32, y: f32) {
        let p = [self.at, self.point(bx, by), self.point(cx, cy), self.point(x, y)];
        let at = |s: f64| {
            let r = 1.0 - s;
            p[0] * (r * r * r) + p[1] * (3.0 * r * r * s) + p[2] * (3.0 * r * s * s) + p[3] * (s * s * s)
        };
        for i in 0..PIECES {
            let (s0, s1) = (f64::from(i) / f64::from(PIECES), f64::from(i + 1) / f64::from(PIECES));
            // Through the same midpoint: b = 2·m - (a + c)/2
            let (a, m, c) = (at(s0), at((s0 + s1) / 2.0), at(s1));
            self.to(2.0 * m - (a + c) / 2.0, c);
        }
    }

    fn close(&mut self) {
        let (start, at) = (self.start, self.at);
        if start != at {
            self.to((at + start) / 2.0, start);
        }
    }
}
