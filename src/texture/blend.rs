//! Choices and blends by a pattern: lists for cells, maps for numbers, weights for `average` (manual, "Pigment Maps",
//! "Normal Maps", "Texture Maps").

use super::Texture;
use super::doubts::warn_if_map_descends;
use crate::diagnostic::{Diagnostic, Result, codes};
use crate::math::cancel;
use crate::pattern::{CellPattern, Cells, Pattern, PatternKind};
use crate::value::{Family, Next, Reader, ReaderExt, Thing};
use serde::Serialize;
use smallvec::SmallVec;
use std::sync::Arc;

/// Map from numbers to values, such as colours, in the order written; between two numbers their values are blended.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Map<T> {
    /// Entries of the map in the order written, each with the number at which the entry is placed; never empty.
    pub entries: Vec<(f64, T)>,
}

/// Values of a map with their weights, usually one or two.
pub type Shares<'a, T> = SmallVec<[(&'a T, f64); 2]>;

impl<T> Map<T> {
    /// Returns the map's entries below and above a number, and the number's position between them, from 0 to 1. Returns
    /// one entry with `None` beyond the ends: the last entry from its number on, else the first up to its number and
    /// for NaN.
    pub fn entries_and_fraction_at(&self, number: f64) -> (&T, Option<(&T, f64)>) {
        let (first, last) = (&self.entries[0], &self.entries[self.entries.len() - 1]);
        // The last entry takes precedence over the first, also where both have one number; NaN gives the first (quirk:
        // map_ends).
        if number >= last.0 {
            return (&last.1, None);
        }
        if number <= first.0 || number.is_nan() {
            return (&first.1, None);
        }
        // No binary search: entries may be in any order, and the first that fits counts (quirk: map_ends).
        let Some(i) = self.entries.iter().position(|e| e.0 >= number) else { return (&last.1, None) };
        let ((a, below), (b, above)) = (&self.entries[i - 1], &self.entries[i]);
        (below, Some((above, (number - a) / (b - a))))
    }

    /// Returns the map's values at a number, with their weights.
    pub fn weighted_entries(&self, number: f64) -> Shares<'_, T> {
        match self.entries_and_fraction_at(number) {
            (only, None) => SmallVec::from_slice(&[(only, 1.0)]),
            (below, Some((above, t))) => SmallVec::from_slice(&[(below, 1.0 - t), (above, t)]),
        }
    }

    /// Returns all values of the map, weighted by their numbers.
    pub fn entries_weighted_by_numbers(&self) -> Shares<'_, T> {
        let sum: f64 = self.entries.iter().map(|(weight, _)| weight).sum();
        self.entries.iter().map(|(weight, entry)| (entry, weight / sum)).collect()
    }
}

/// Value of a map or list: a pigment, normal, texture, slope or density.
pub trait Entry: Clone {
    /// Keyword of a block that maps numbers to values of this type, such as `pigment_map`.
    const MAP: &'static str;
    /// Keyword of a block that describes one value of this type, such as `pigment`; empty if there is no such block.
    const BLOCK: &'static str;

    /// Reads the value of a map's entry after its number, or the contents of the value's block, on top of the default
    /// texture.
    fn read_entry(r: &mut dyn Reader, defaults: &Texture) -> Result<Self>;

    /// Reads an item of a list such as `checker A, B` that has no block: a declared value, or a colour if a colour can
    /// be a value of this type; `None` if neither comes next.
    fn read_declared_or_color(r: &mut dyn Reader) -> Result<Option<Self>>;
}

impl<T: Entry> Map<T>
where
    Map<T>: Thing,
{
    /// Reads the entries of a map, `{ [0.0 …] [1.0 …] }`, after the brace, or a declared map. With
    /// `numbers_are_weights`, as for `average`, a missing weight is 1, but a weight must precede a colour (quirk:
    /// `average_weights`).
    ///
    /// # Errors
    /// A diagnostic at the item that is not understood.
    pub fn read_entries(r: &mut dyn Reader, defaults: &Texture, numbers_are_weights: bool) -> Result<Self> {
        if let Some(map) = r.take_declared::<Self>()? {
            return Ok((*map).clone());
        }
        let span = r.span();
        let mut entries = vec![];
        while r.peek_next()? == Next::Entry {
            r.take_token()?;
            let number = match r.optional_float()? {
                Some(number) => number,
                None if numbers_are_weights && !r.may_be_at_color()? => 1.0,
                None => return Err(r.unexpected("the entry's number").help(example_entry::<T>()).into()),
            };
            entries.push((number, T::read_entry(r, defaults)?));
            r.leave_block()?;
        }
        if entries.is_empty() {
            if r.peek_next()? != Next::End {
                return Err(r.unknown_word(T::MAP, &["[0.5 …]"]).into());
            }
            return Diagnostic::new(codes::EMPTY_MAP, span, format!("a `{}` needs at least one entry", T::MAP))
                .help(example_entry::<T>())
                .into();
        }
        entries.shrink_to_fit();
        let map = Self { entries };
        if !numbers_are_weights {
            warn_if_map_descends(r, span, &map);
        }
        Ok(map)
    }
}

/// Returns an example of a map's entry, for the help line of a message.
fn example_entry<T: Entry>() -> String {
    format!("entries look like `[0.5 {} … ]`", T::BLOCK)
}

/// Reads the values for the cells of a pattern whose name is already read, in braces or declared, up to the pattern's
/// count; `None` if the name was not that of a pattern of cells. `default`
/// gives the values that the scene leaves out. The values of an object pattern are inside the object's braces.
pub fn read_list<T: Entry>(
    r: &mut dyn Reader,
    name: Next,
    pattern: &Pattern,
    defaults: &Texture,
    default: &dyn Fn(&CellPattern, usize) -> T,
) -> Result<Option<Blend<T>>> {
    let (Next::Word(word) | Next::Block(word), PatternKind::Cells(pattern)) = (name, &pattern.kind) else {
        return Ok(None);
    };
    if !CellPattern::is_name(word) {
        return Ok(None);
    }
    let mut list = vec![];
    while list.len() < pattern.cell_kind_count() {
        if r.peek_next()? == Next::Block(T::BLOCK) {
            r.take_token()?;
            list.push(T::read_entry(r, defaults)?);
            r.leave_block()?;
        } else if let Some(declared) = T::read_declared_or_color(r)? {
            list.push(declared);
        } else {
            break;
        }
    }
    if matches!(name, Next::Block(_)) {
        r.leave_block()?;
    }
    list.extend((list.len()..pattern.cell_kind_count()).map(|cell| default(pattern, cell)));
    Ok(Some(Blend::List(list.into())))
}

/// Values from which a pattern selects.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Blend<T> {
    /// Values selected by the pattern's number; all values are mixed with `average`.
    Map(Arc<Map<T>>),
    /// Values in a list, one for each kind of the pattern's cells.
    List(Arc<[T]>),
}

impl<T> Blend<T> {
    /// Returns the values at a pattern's number, with their weights; all of them if `averages_all` is true.
    pub fn weighted_values(&self, number: f64, averages_all: bool) -> Shares<'_, T> {
        match self {
            Blend::Map(map) if averages_all => map.entries_weighted_by_numbers(),
            Blend::Map(map) => map.weighted_entries(number),
            Blend::List(list) => weighted_list_neighbors(list, number),
        }
    }

    /// Applies `f` to all values from which the pattern selects.
    pub fn map<U>(&self, mut f: impl FnMut(&T) -> U) -> Blend<U> {
        match self {
            Blend::Map(map) => {
                let entries = map.entries.iter().map(|(number, entry)| (*number, f(entry))).collect();
                Blend::Map(Arc::new(Map { entries }))
            }
            Blend::List(list) => Blend::List(list.iter().map(f).collect()),
        }
    }

    /// True if both maps or lists share one allocation.
    pub(super) fn shares_allocation_with(&self, other: &Self) -> bool {
        match (self, other) {
            (Blend::Map(a), Blend::Map(b)) => Arc::ptr_eq(a, b),
            (Blend::List(a), Blend::List(b)) => Arc::ptr_eq(a, b),
            _ => false,
        }
    }

    /// Applies `f` to all values from which the pattern selects, once for each run of equal neighbours. In cancelled
    /// work all values count as equal, so that nested maps, whose number of values is exponential in their depth, end
    /// soon.
    pub fn map_runs<U: Clone>(&self, same: impl Fn(&T, &T) -> bool, mut f: impl FnMut(&T) -> U) -> Blend<U> {
        let mut before: Option<(&T, U)> = None;
        let entries: &mut dyn Iterator<Item = &T> = match self {
            Blend::Map(map) => &mut map.entries.iter().map(|(_, entry)| entry),
            Blend::List(list) => &mut list.iter(),
        };
        let mut all = entries.map(|entry| match &before {
            Some((last, made)) if same(last, entry) || cancel::is_cancelled() => made.clone(),
            _ => before.insert((entry, f(entry))).1.clone(),
        });
        match self {
            Blend::Map(map) => {
                let entries = map.entries.iter().map(|(number, _)| *number).zip(&mut all).collect();
                Blend::Map(Arc::new(Map { entries }))
            }
            Blend::List(_) => Blend::List(all.collect()),
        }
    }

    /// Iterates over all values from which the pattern selects, in order; over none in cancelled work.
    pub fn iter(&self) -> Box<dyn Iterator<Item = &T> + '_> {
        match self {
            _ if cancel::is_cancelled() => Box::new([].iter()),
            Blend::Map(map) => Box::new(map.entries.iter().map(|(_, entry)| entry)),
            Blend::List(list) => Box::new(list.iter()),
        }
    }
}

/// Returns the entries of a list on both sides of a position, with weights that blend them linearly; a single entry at
/// a whole number, beyond the end the last one, and none for an empty list. The position is a pattern's number, which
/// has a fraction after a `frequency`.
fn weighted_list_neighbors<T>(list: &[T], position: f64) -> Shares<'_, T> {
    let (i, t) = (position as usize, position.fract());
    let (Some(below), Some(above)) = (list.get(i).or(list.last()), list.get(i.saturating_add(1)).or(list.last()))
    else {
        return SmallVec::new();
    };
    if t > 0.0 { SmallVec::from_slice(&[(below, 1.0 - t), (above, t)]) } else { SmallVec::from_slice(&[(below, 1.0)]) }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::color::{Color, Rgb};

    #[test]
    fn blends_between_and_holds_at_the_ends() {
        let gray = |x: f64| Color::opaque(Rgb::splat(x));
        let map = Map { entries: vec![(0.25, gray(0.0)), (0.5, gray(1.0)), (0.5, gray(0.25)), (1.0, gray(0.75))] };
        let at = |v| map.color_at(v).rgb.x;
        assert_eq!([at(0.0), at(0.375), at(0.5), at(0.75), at(2.0)], [0.0, 0.5, 1.0, 0.5, 0.75]);
        assert_eq!(at(f64::NAN), 0.0);
    }

    #[test]
    fn entries_of_one_number_and_out_of_order() {
        // POV-Ray 3.7's choice
        let shown = |numbers: &[f64], v: f64| {
            let map = Map { entries: numbers.iter().copied().enumerate().map(|(i, number)| (number, i)).collect() };
            match map.entries_and_fraction_at(v) {
                (i, None) => (*i, *i),
                (below, Some((above, _))) => (*below, *above),
            }
        };
        assert_eq!(shown(&[0.0, 0.5, 1.0, 1.0], 1.0), (3, 3));
        assert_eq!(shown(&[0.5, 0.5], 0.5), (1, 1));
        assert_eq!([0.25, 0.5, 0.75, 1.0].map(|v| shown(&[0.0, 1.0, 0.5], v)), [(0, 1), (2, 2), (2, 2), (2, 2)]);
        assert_eq!([0.0, 0.5, 1.0].map(|v| shown(&[1.0, 0.0], v).0), [1, 1, 1]);
        assert_eq!([0.25, 0.5, 0.75].map(|v| shown(&[0.5, 0.0, 0.75], v).0), [0, 0, 2]);
    }

    #[test]
    fn weights_of_an_average_add_up_to_one() {
        let map = Map { entries: vec![(1.0, 'a'), (3.0, 'b')] };
        assert_eq!(map.entries_weighted_by_numbers().to_vec(), [(&'a', 0.25), (&'b', 0.75)]);
    }
}
