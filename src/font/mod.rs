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
use skrifa::instance::{LocationRef, Size};
use skrifa::outline::DrawSettings;
use skrifa::outline::pen::{PathElement, PathStyle};
use skrifa::raw::tables::{cmap, glyf, hmtx, kern};
use skrifa::raw::{FontRef, ReadError as FontError, TableProvider};
use skrifa::{GlyphId, MetadataProvider};
use std::borrow::Cow;
use std::path::Path;

/// A font: one of a file, or the built-in one.
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
    /// Position of the glyph's origin along the line, in em.
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

    /// Returns the font at a location: reads its file, or returns the built-in font.
    ///
    /// # Errors
    /// E0002 if it does not exist, E0003 if it can't be read, E0236 if it is not a font.
    pub fn read(files: &dyn Files, place: &FontLocation) -> Result<Self> {
        let FontLocation::File(path, number) = place else { return Ok(Self::built_in()) };
        let data = files.read(path).map_err(|e| file::unreadable(files, path, &ReadError::Io(e)))?;
        match Face::parse(&data, *number) {
            Ok(_) => Ok(Self { place: place.clone(), data: data.into() }),
            Err(fault) => {
                let message = format!("`{}` is no font that can be read: {fault}", path.display());
                Diagnostic::err(codes::BAD_DATA, Span::NONE, message)
            }
        }
    }

    /// Returns the built-in font, for machines without any: Latin, Greek and Cyrillic letters of Roboto.
    pub fn built_in() -> Self {
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
    pub fn lay_out(&self, text: &str) -> Vec<PlacedGlyph> {
        let Some(face) = self.face() else { return vec![] };
        let glyphs: Vec<GlyphId> = text.chars().map(|c| face.glyph_of(c)).collect();
        let mut x = -glyphs.first().map_or(0.0, |glyph| face.left_bearing_font_units(*glyph));
        let mut line = Vec::with_capacity(glyphs.len());
        for (i, &glyph) in glyphs.iter().enumerate() {
            let right = if face.is_composite(glyph) { face.left_bearing_font_units(glyph) } else { 0.0 };
            line.push(PlacedGlyph { glyph: glyph.to_u32() as u16, x: (x + right) / face.units_per_em });
            x += face.advance_font_units(glyph);
            x += glyphs.get(i + 1).map_or(0.0, |next| kerning(face.kern.as_ref(), glyph, *next));
        }
        line
    }

    /// The outline of a glyph, in em; empty if it has none.
    pub fn outline(&self, glyph: u16) -> Outline {
        let Some(face) = self.face() else { return vec![] };
        let Some(outline) = face.font.outline_glyphs().get(GlyphId::from(glyph)) else { return vec![] };
        let mut path: Vec<PathElement> = vec![];
        let settings = DrawSettings::unhinted(Size::unscaled(), LocationRef::default());
        let Ok(metrics) = outline.draw(settings.with_path_style(PathStyle::HarfBuzz), &mut path) else { return vec![] };
        // `draw` moves the left edge of a glyph's box to its left bearing; the outline stays where the file has it.
        let shift = f64::from(metrics.lsb.unwrap_or(0.0));
        let mut pen = Pen { scale: 1.0 / face.units_per_em, shift, ..Pen::default() };
        path.into_iter().for_each(|element| pen.draw(element));
        pen.close();
        pen.curves
    }
}

/// Tables of a font.
struct Face<'a> {
    font: FontRef<'a>,
    /// Size of an em in font units.
    units_per_em: f64,
    cmap: Option<cmap::Cmap<'a>>,
    hmtx: Option<hmtx::Hmtx<'a>>,
    kern: Option<kern::Kern<'a>>,
}

impl<'a> Face<'a> {
    /// Finds the tables of a font by the font's number in the file.
    fn parse(data: &'a [u8], number: u32) -> Result<Self, FontError> {
        let font = FontRef::from_index(data, number)?;
        font.maxp()?;
        let units_per_em = font.head()?.units_per_em();
        if !(16..=16_384).contains(&units_per_em) {
            return Err(FontError::MalformedData("units per em not from 16 to 16384"));
        }
        let (cmap, hmtx, kern) = (font.cmap().ok(), font.hmtx().ok(), font.kern().ok());
        Ok(Self { units_per_em: f64::from(units_per_em), cmap, hmtx, kern, font })
    }

    /// Returns the left bearing of a glyph, in font units.
    fn left_bearing_font_units(&self, glyph: GlyphId) -> f64 {
        self.hmtx.as_ref().and_then(|hmtx| hmtx.side_bearing(glyph)).map_or(0.0, f64::from)
    }

    /// Returns the width of a glyph, in font units.
    fn advance_font_units(&self, glyph: GlyphId) -> f64 {
        self.hmtx.as_ref().and_then(|hmtx| hmtx.advance(glyph)).map_or(0.0, f64::from)
    }

    /// Returns the glyph of a character. Symbol fonts, which do not use Unicode, have their glyphs at 0xF000 and above.
    fn glyph_of(&self, c: char) -> GlyphId {
        let code = u32::from(c);
        let mapped =
            |table: &cmap::CmapSubtable, code: u32| table.map_codepoint(code).filter(|glyph| *glyph != GlyphId::NOTDEF);
        let unicode = || self.cmaps(true).find_map(|table| mapped(&table, code));
        let symbol = || self.cmaps(false).find_map(|table| mapped(&table, 0xF000 + code).or(mapped(&table, code)));
        unicode().or_else(symbol).unwrap_or_default()
    }

    /// Returns the tables that map characters to glyphs, in the order of the file: those of Unicode or all others.
    fn cmaps(&self, of_unicode: bool) -> impl Iterator<Item = cmap::CmapSubtable<'a>> {
        let records =
            self.cmap.iter().flat_map(|cmap| cmap.encoding_records().iter().map(move |record| (cmap, record)));
        records.filter_map(move |(cmap, record)| {
            let table = record.subtable(cmap.offset_data()).ok()?;
            (is_unicode(record, &table) == of_unicode).then_some(table)
        })
    }

    /// True if the glyph is composed of others.
    fn is_composite(&self, glyph: GlyphId) -> bool {
        let (Ok(loca), Ok(glyf)) = (self.font.loca(None), self.font.glyf()) else { return false };
        loca.get(glyph, &glyf).is_some_and(|found| matches!(found.glyph(), Some(glyf::Glyph::Composite(_))))
    }
}

/// True if the codes of a table of characters are those of Unicode.
fn is_unicode(record: &cmap::EncodingRecord, table: &cmap::CmapSubtable) -> bool {
    let is_long = matches!(table, cmap::CmapSubtable::Format12(_) | cmap::CmapSubtable::Format13(_));
    match (record.platform_id(), record.encoding_id()) {
        (cmap::PlatformId::Unicode, _) | (cmap::PlatformId::Windows, 1) => true,
        (cmap::PlatformId::Windows, 10) => is_long,
        _ => false,
    }
}

/// Kerning of a pair (`kern` table), in font units. Pairs should be sorted; as in POV-Ray 3.7, unsorted ones are found
/// too (quirk: `text_layout`).
fn kerning(kern: Option<&kern::Kern>, left: GlyphId, right: GlyphId) -> f64 {
    let tables = kern.into_iter().flat_map(|kern| kern.subtables()).flatten();
    let mut tables = tables.filter(|table| table.is_horizontal() && !table.is_variable() && !table.is_state_machine());
    let value = |table: kern::Subtable| match table.kind().ok()? {
        kern::SubtableKind::Format0(list) => {
            let is_pair = |pair: &&kern::Subtable0Pair| (left, right) == (pair.left().into(), pair.right().into());
            list.pairs().iter().find(is_pair).map(|pair| i32::from(pair.value()))
        }
        kern::SubtableKind::Format1(_) => None,
        kern::SubtableKind::Format2(classes) => classes.kerning(left, right),
        kern::SubtableKind::Format3(classes) => classes.kerning(left, right),
    };
    tables.find_map(value).map_or(0.0, f64::from)
}

/// Collects outlines.
#[derive(Default)]
struct Pen {
    /// Size of a font unit.
    scale: f64,
    /// Distance by which outlines are moved to the right, in font units.
    shift: f64,
    curves: Outline,
    start: DVec2,
    at: DVec2,
}

impl Pen {
    fn draw(&mut self, element: PathElement) {
        let point = |x: f32, y: f32| DVec2::new(f64::from(x) + self.shift, f64::from(y)) * self.scale;
        match element {
            PathElement::MoveTo { x, y } => {
                let start = point(x, y);
                self.close();
                (self.start, self.at) = (start, start);
            }
            PathElement::LineTo { x, y } => self.line_to(point(x, y)),
            PathElement::QuadTo { cx0, cy0, x, y } => self.quadratic_to(point(cx0, cy0), point(x, y)),
            PathElement::CurveTo { cx0, cy0, cx1, cy1, x, y } => {
                self.cubic_to(point(cx0, cy0), point(cx1, cy1), point(x, y));
            }
            PathElement::Close => self.close(),
        }
    }

    /// Appends a quadratic Bézier curve from the current point; none if all three points are equal.
    fn quadratic_to(&mut self, control: DVec2, end: DVec2) {
        if end != self.at || control != self.at {
            self.curves.push([self.at, control, end]);
        }
        self.at = end;
    }

    fn line_to(&mut self, end: DVec2) {
        self.quadratic_to((self.at + end) / 2.0, end);
    }

    fn cubic_to(&mut self, b: DVec2, c: DVec2, end: DVec2) {
        let p = [self.at, b, c, end];
        let at = |s: f64| {
            let r = 1.0 - s;
            p[0] * (r * r * r) + p[1] * (3.0 * r * r * s) + p[2] * (3.0 * r * s * s) + p[3] * (s * s * s)
        };
        for i in 0..PIECES {
            let (s0, s1) = (f64::from(i) / f64::from(PIECES), f64::from(i + 1) / f64::from(PIECES));
            // Through the same midpoint: b = 2·m - (a + c)/2
            let (a, m, c) = (at(s0), at((s0 + s1) / 2.0), at(s1));
            self.quadratic_to(2.0 * m - (a + c) / 2.0, c);
        }
    }

    fn close(&mut self) {
        if self.start != self.at {
            self.line_to(self.start);
        }
    }
}
