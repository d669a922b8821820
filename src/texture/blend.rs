//! What patterns choose among or blend: lists for cells, maps for numbers, weights for `average` (manual, "Pigment Maps",
//! "Normal Maps", "Texture Maps").

use super::Texture;
use super::doubts::tell_falling;
use crate::diagnostic::{Diagnostic, Result, codes};
use crate::pattern::{CellPattern, Cells, Kind, Pattern};
use crate::value::{Next, Reader, ReaderExt, Thing};
use serde::Serialize;
use smallvec::SmallVec;
use std::sync::Arc;

/// Things at numbers, in the order in which they were written; between them they are blended.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Map<T> {
    /// Never empty.
    pub entries: Vec<(f64, T)>,
}

/// One or two things and how much of each is seen.
pub type Shares<'a, T> = SmallVec<[(&'a T, f64); 2]>;

impl<T> Map<T> {
    /// The entries below and above a number, and how far it is from the one to the other; the last from the last entry's number
    /// on, the first up to the first's.
    pub fn around(&self, v: f64) -> (&T, Option<(&T, f64)>) {
        let (first, last) = (&self.entries[0], &self.entries[self.entries.len() - 1]);
        // The last goes before the first, also where both have one number; what is no number is the first (measured on POV-Ray 3.7).
        if v >= last.0 {
            return (&last.1, None);
        }
        if v <= first.0 || v.is_nan() {
            return (&first.1, None);
        }
        // Not by halves: entries may be in any order, and then the first that fits counts (measured on POV-Ray 3.7).
        let Some(i) = self.entries.iter().position(|e| e.0 >= v) else { return (&last.1, None) };
        let ((a, below), (b, above)) = (&self.entries[i - 1], &self.entries[i]);
        (below, Some((above, (v - a) / (b - a))))
    }

    /// What is seen at a number.
    pub fn shares(&self, v: f64) -> Shares<'_, T> {
        match self.around(v) {
            (only, None) => SmallVec::from_slice(&[(only, 1.0)]),
            (below, Some((above, t))) => SmallVec::from_slice(&[(below, 1.0 - t), (above, t)]),
        }
    }

    /// All of it at once, by the numbers as weights.
    pub fn average(&self) -> Shares<'_, T> {
        let sum: f64 = self.entries.iter().map(|(weight, _)| weight).sum();
        self.entries.iter().map(|(weight, entry)| (entry, weight / sum)).collect()
    }
}

/// What a map or a list holds: pigments, normals, textures, slopes, densities.
pub trait Entry: Clone {
    /// The block of a map of these: `pigment_map`.
    const MAP: &'static str;
    /// The block of one: `pigment`; empty if there is none.
    const BLOCK: &'static str;

    /// Reads an entry behind its number, or what stands between the braces of its block, on top of the default texture.
    fn read_entry(r: &mut dyn Reader, defaults: &Texture) -> Result<Self>;

    /// A declared one that comes next.
    fn declared(r: &mut dyn Reader) -> Result<Option<Self>>;
}

impl<T: Entry> Map<T>
where
    Map<T>: Thing,
{
    /// Reads `{ [0.0 …] [1.0 …] }` after the brace, or a declared map. Behind `average` the numbers are weights, and one that is
    /// left out is 1, but not before a colour (measured on POV-Ray 3.7).
    ///
    /// # Errors
    /// With the place of what is not understood, and what was expected there.
    pub fn read_entries(r: &mut dyn Reader, defaults: &Texture, average: bool) -> Result<Self> {
        if let Some(map) = r.thing::<Self>()? {
            return Ok((*map).clone());
        }
        let span = r.span();
        let mut entries = vec![];
        while r.next()? == Next::Entry {
            r.take()?;
            let number = match r.optional_float()? {
                Some(number) => number,
                None if average && !r.at_color()? => 1.0,
                None => return Err(r.unexpected("the entry's number").help(example::<T>()).into()),
            };
            entries.push((number, T::read_entry(r, defaults)?));
            r.leave()?;
        }
        if entries.is_empty() {
            if r.next()? != Next::End {
                return Err(r.unknown_word(T::MAP, &["[0.5 …]"]).into());
            }
            return Diagnostic::new(codes::EMPTY_MAP, span, format!("a `{}` needs at least one entry", T::MAP))
                .help(example::<T>())
                .into();
        }
        entries.shrink_to_fit();
        let map = Self { entries };
        if !average {
            tell_falling(r, span, &map);
        }
        Ok(map)
    }
}

/// A help line: what an entry looks like.
fn example<T: Entry>() -> String {
    format!("entries look like `[0.5 {} … ]`", T::BLOCK)
}

/// Reads the things for the cells of a pattern whose name was just read, in braces or declared, up to as many as it has;
/// `None` if it was no such name. Those of an object stand inside the object's braces.
pub fn read_list<T: Entry>(
    r: &mut dyn Reader,
    name: Next,
    pattern: &Pattern,
    defaults: &Texture,
    default: &dyn Fn(&CellPattern, usize) -> T,
) -> Result<Option<Blend<T>>> {
    let (Next::Word(word) | Next::Block(word), Kind::Cells(pattern)) = (name, &pattern.kind) else { return Ok(None) };
    if !CellPattern::is_name(word) {
        return Ok(None);
    }
    let mut list = vec![];
    while list.len() < pattern.count() {
        if r.next()? == Next::Block(T::BLOCK) {
            r.take()?;
            list.push(T::read_entry(r, defaults)?);
            r.leave()?;
        } else if let Some(declared) = T::declared(r)? {
            list.push(declared);
        } else {
            break;
        }
    }
    if matches!(name, Next::Block(_)) {
        r.leave()?;
    }
    list.extend((list.len()..pattern.count()).map(|cell| default(pattern, cell)));
    Ok(Some(Blend::List(list.into())))
}

/// What a pattern makes of them.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Blend<T> {
    /// By the pattern's number; all at once with `average`.
    Map(Arc<Map<T>>),
    /// One for each cell.
    List(Arc<[T]>),
}

impl<T> Blend<T> {
    /// What is seen at a number; `average` sees all.
    pub fn shares(&self, number: f64, average: bool) -> Shares<'_, T> {
        match self {
            Blend::Map(map) if average => map.average(),
            Blend::Map(map) => map.shares(number),
            Blend::List(list) => between(list, number),
        }
    }

    /// The same with others in their places.
    pub fn map<U>(&self, mut f: impl FnMut(&T) -> U) -> Blend<U> {
        match self {
            Blend::Map(map) => {
                let entries = map.entries.iter().map(|(number, entry)| (*number, f(entry))).collect();
                Blend::Map(Arc::new(Map { entries }))
            }
            Blend::List(list) => Blend::List(list.iter().map(f).collect()),
        }
    }

    /// Is it shared with another?
    pub(super) fn shares_with(&self, other: &Self) -> bool {
        match (self, other) {
            (Blend::Map(a), Blend::Map(b)) => Arc::ptr_eq(a, b),
            (Blend::List(a), Blend::List(b)) => Arc::ptr_eq(a, b),
            _ => false,
        }
    }

    /// The same with others in their places; where one is the same as the one before, `f` is asked but once.
    pub fn map_runs<U: Clone>(&self, same: impl Fn(&T, &T) -> bool, mut f: impl FnMut(&T) -> U) -> Blend<U> {
        let mut before: Option<(&T, U)> = None;
        let mut all = self.iter().map(|entry| match &before {
            Some((last, made)) if same(last, entry) => made.clone(),
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

    /// All of them.
    pub fn iter(&self) -> Box<dyn Iterator<Item = &T> + '_> {
        match self {
            Blend::Map(map) => Box::new(map.entries.iter().map(|(_, entry)| entry)),
            Blend::List(list) => Box::new(list.iter()),
        }
    }
}

/// What is seen of a list as if it were a map with its entries at whole numbers: a `frequency` gives others too.
fn between<T>(list: &[T], number: f64) -> Shares<'_, T> {
    let (i, t) = (number as usize, number.fract());
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
        let at = |v| map.at(v).rgb.x;
        assert_eq!([at(0.0), at(0.375), at(0.5), at(0.75), at(2.0)], [0.0, 0.5, 1.0, 0.5, 0.75]);
        assert_eq!(at(f64::NAN), 0.0);
    }

    #[test]
    fn entries_of_one_number_and_out_of_order() {
        // which entry POV-Ray 3.7 shows
        let shown = |numbers: &[f64], v: f64| {
            let map = Map { entries: numbers.iter().copied().enumerate().map(|(i, number)| (number, i)).collect() };
            match map.around(v) {
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
        assert_eq!(map.average().to_vec(), [(&'a', 0.25), (&'b', 0.75)]);
    }
}
