//! `color_map`: colours along a line of numbers (manual, "Color Maps").

use crate::color::Color;
use crate::diagnostic::{Diagnostic, Result, codes};
use crate::value::{FloatOrColor, Next, Reader, ReaderExt};
use serde::Serialize;

/// Colours at numbers, in the order they were written; between them it blends.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct ColorMap {
    /// Never empty.
    pub entries: Vec<(f64, Color)>,
}

impl ColorMap {
    /// What a pattern without a map shows.
    pub fn black_to_white() -> Self {
        Self { entries: vec![(0.0, Color::BLACK), (1.0, Color::WHITE)] }
    }

    /// The colour at a number: the first colour below the first entry, the last above the last.
    pub fn at(&self, v: f64) -> Color {
        let (first, last) = (self.entries[0], self.entries[self.entries.len() - 1]);
        if v <= first.0 {
            return first.1;
        }
        let Some(i) = self.entries.iter().position(|e| e.0 >= v) else { return last.1 };
        let ((a, below), (b, above)) = (self.entries[i - 1], self.entries[i]);
        below.lerp(above, (v - a) / (b - a))
    }

    /// Reads `{ [0.0 color …] [1.0 color …] }`, after the brace; also the old entries of two numbers and two colours, and a
    /// declared map.
    pub fn read(r: &mut dyn Reader) -> Result<Self> {
        if let Some(map) = r.thing::<ColorMap>()? {
            return Ok((*map).clone());
        }
        let span = r.span();
        let mut entries = vec![];
        while r.next()? == Next::Entry {
            r.take()?;
            let from = r.float()?;
            match r.float_or_color()? {
                FloatOrColor::Color(color) => entries.push((from, color)),
                FloatOrColor::Float(to) => {
                    entries.push((from, r.color()?));
                    entries.push((to, r.color()?));
                }
            }
            r.leave()?;
        }
        if entries.is_empty() {
            return Diagnostic::new(codes::EMPTY_MAP, span, "a `color_map` needs at least one entry")
                .help("entries look like `[0.5 color rgb <1, 0, 0>]`")
                .into();
        }
        Ok(Self { entries })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::color::Rgb;

    #[test]
    fn blends_between_and_holds_at_the_ends() {
        let gray = |x: f64| Color::opaque(Rgb::splat(x));
        let map = ColorMap { entries: vec![(0.25, gray(0.0)), (0.5, gray(1.0)), (0.5, gray(0.25)), (1.0, gray(0.75))] };
        let at = |v| map.at(v).rgb.x;
        assert_eq!([at(0.0), at(0.375), at(0.5), at(0.75), at(2.0)], [0.0, 0.5, 1.0, 0.5, 0.75]);
    }
}
