//! `color_map`: colours along a line of numbers (manual, "Color Maps").

use super::blend::Map;
use super::doubts::warn_if_map_descends;
use crate::color::Color;
use crate::diagnostic::{Diagnostic, Result, codes};
use crate::function::Interval;
use crate::function::LocalBounds;
use crate::value::{FloatOrColor, Next, Reader, ReaderExt};

/// Colour map: a map from numbers to colours.
pub type ColorMap = Map<Color>;

impl ColorMap {
    /// Returns the map's colour at a number.
    pub fn color_at(&self, number: f64) -> Color {
        match self.entries_and_fraction_at(number) {
            (only, None) => *only,
            (below, Some((above, t))) => below.lerp(*above, t),
        }
    }

    /// Returns the number below which the map's colour is constant.
    pub fn end_of_constant_start(&self) -> f64 {
        let mut end = self.entries[0].0;
        for pair in self.entries.windows(2) {
            if pair[1].0 < end || pair[1].1 != pair[0].1 {
                break;
            }
            end = pair[1].0;
        }
        end.min(self.entries[self.entries.len() - 1].0)
    }

    /// Bounds on the components of the map's colour (red, green, blue, filter, transmit) for numbers with these
    /// bounds.
    pub fn component_bounds_for(&self, numbers: LocalBounds) -> [LocalBounds; 5] {
        let Interval { lo, hi } = numbers.range;
        let (first, last) = (self.color_at(lo).to_array(), self.color_at(hi).to_array());
        let mut all = [0, 1, 2, 3, 4].map(|i: usize| LocalBounds {
            range: Interval::new(first[i], last[i]),
            steepest: 0.0,
            ..numbers
        });
        for pair in self.entries.windows(2) {
            let [(a, from), (b, to)] = pair else { continue };
            if b < a {
                return [LocalBounds::UNKNOWN; 5];
            }
            if *b < lo || *a > hi {
                continue;
            }
            let ends = from.to_array().into_iter().zip(to.to_array());
            for (one, (from, to)) in all.iter_mut().zip(ends) {
                // (Includes the ends of a piece that reaches beyond the range, which only widens the bounds.)
                one.range = one.range.hull(Interval::new(from, to));
                one.steepest = if from == to { one.steepest } else { one.steepest.max((to - from).abs() / (b - a)) };
            }
        }
        all.map(|one| LocalBounds {
            steepest: if one.steepest == 0.0 { 0.0 } else { one.steepest * numbers.steepest },
            ..one
        })
    }

    /// Reads a colour map, `{ [0.0 color …] [1.0 color …] }`, after the brace; also the old entries of two numbers and
    /// two colours, and a declared map.
    ///
    /// # Errors
    /// A diagnostic at the item that is not understood.
    pub fn read(r: &mut dyn Reader) -> Result<Self> {
        if let Some(map) = r.take_declared::<ColorMap>()? {
            return Ok((*map).clone());
        }
        let span = r.span();
        let mut entries = vec![];
        while r.peek_next()? == Next::Entry {
            r.take_token()?;
            let from = r.float()?;
            match r.float_or_color()? {
                FloatOrColor::Color(color) => entries.push((from, color.with_infinities_as_zero())),
                FloatOrColor::Float(to) => {
                    entries.push((from, r.color()?.with_infinities_as_zero()));
                    entries.push((to, r.color()?.with_infinities_as_zero()));
                }
            }
            r.leave_block()?;
        }
        if entries.is_empty() {
            if r.peek_next()? != Next::End {
                return Err(r.unknown_word("color_map", &["[0.5 color …]"]).into());
            }
            return Diagnostic::new(codes::EMPTY_MAP, span, "a `color_map` needs at least one entry")
                .help("entries look like `[0.5 color rgb <1, 0, 0>]`")
                .into();
        }
        entries.shrink_to_fit();
        let map = Self { entries };
        warn_if_map_descends(r, span, &map);
        Ok(map)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn colors_are_constant_up_to_the_end_of_the_constant_start() {
        let map = |entries: &[(f64, Color)]| ColorMap { entries: entries.to_vec() };
        let (a, b) = (Color::BLACK, Color::WHITE);
        let maps = [
            (map(&[(0.2, a)]), 0.2),
            (map(&[(0.2, a), (0.7, b)]), 0.2),
            (map(&[(0.0, a), (0.5, a), (0.7, b), (0.9, a)]), 0.5),
            (map(&[(0.0, a), (0.5, a), (0.5, b)]), 0.5),
            // entries in descending order
            (map(&[(0.4, a), (0.8, a), (0.6, a), (0.9, b)]), 0.8),
            (map(&[(0.0, a), (0.8, a), (0.6, b)]), 0.6),
        ];
        for (map, end) in maps {
            assert_eq!(map.end_of_constant_start(), end);
            for i in 0..1000 {
                let number = f64::from(i) / 1000.0 * end;
                assert_eq!(map.color_at(number), a, "{number} of {end}");
            }
        }
    }
}
