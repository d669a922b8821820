//! Contents of blocks that durer does not render yet, evaluated and kept as plain data.

use super::{Thing, Value, VecN};
use crate::color::Color;
use crate::diagnostic::{Diagnostic, codes};
use crate::source::Span;
use serde::ser::{Serialize, SerializeMap, Serializer};

/// Item of a scene that durer does not render yet: a word, a value or a block. `area_light x*4, z*4, 5, 5` serializes
/// as `{"area_light": [[4, 0, 0], [0, 0, 4], 5, 5]}`.
#[derive(Clone, Debug, PartialEq)]
pub enum Unsupported {
    /// Unsupported item: a keyword without a value.
    Word(&'static str),
    /// Unsupported item: consecutive numbers, or consecutive vectors of one length: a mesh has millions.
    Numbers {
        /// Number of components of each unsupported vector; 1 for numbers.
        width: usize,
        /// Components of all items in an unsupported list.
        all: Vec<f64>,
    },
    /// Unsupported item: a colour.
    Color(Color),
    /// Unsupported item: a string.
    Text(Box<str>),
    /// Unsupported item: a declared thing, with the word of its block.
    Declared(&'static str),
    /// Unsupported item: a word with its block or the values after it. `[ … ]` has the word `entry`, `{ … }` the word
    /// `group`.
    Block(&'static str, Box<[Unsupported]>),
}

/// Returns the warning that a word or block of the scene has no effect yet.
pub fn unsupported_warning(word: &str, at: Span) -> Diagnostic {
    Diagnostic::new(codes::UNSUPPORTED, at, format!("`{word}` is not supported yet and has no effect"))
}

impl Unsupported {
    /// Appends a number, or a vector of any length, to a row of unsupported items.
    pub fn push_numbers(row: &mut Vec<Unsupported>, c: &[f64]) {
        match row.last_mut() {
            Some(Unsupported::Numbers { width, all }) if *width == c.len() => all.extend(c),
            _ => row.push(Unsupported::Numbers { width: c.len(), all: c.to_vec() }),
        }
    }

    /// Appends a value to an unsupported row of items.
    pub fn push_value(row: &mut Vec<Unsupported>, value: &Value) {
        match value {
            Value::Float(x) => Self::push_numbers(row, &[*x]),
            Value::Vector(v) => Self::push_numbers(row, &v.c[..v.len as usize]),
            Value::Color(c) => row.push(Unsupported::Color(*c)),
            Value::Text(text) => row.push(Unsupported::Text((**text).into())),
            Value::Thing(thing) => row.push(match super::downcast::<Unsupported>(thing) {
                Some(item) => (*item).clone(),
                None => Unsupported::Declared(thing.kind()),
            }),
        }
    }

    /// Serializes the unsupported contents of a block: numbers and vectors become single items.
    ///
    /// # Errors
    /// The serializer's error.
    pub fn serialize_row<S: Serializer>(row: &[Unsupported], s: S) -> Result<S::Ok, S::Error> {
        s.collect_seq(items(row))
    }

    /// Calls `visit` with each vector of two to five components of the unsupported item, in order.
    pub fn visit_vectors(&self, visit: &mut dyn FnMut(VecN)) {
        match self {
            Unsupported::Numbers { width: n @ 2..=5, all } => all.chunks(*n).for_each(|c| visit(VecN::from_slice(c))),
            Unsupported::Block(_, inner) => inner.iter().for_each(|item| item.visit_vectors(visit)),
            _ => {}
        }
    }
}

/// Unsupported items can be declared: media, radiosity or the like.
impl Thing for Unsupported {
    fn kind(&self) -> &'static str {
        match self {
            Unsupported::Word(word) | Unsupported::Declared(word) | Unsupported::Block(word, _) => word,
            Unsupported::Numbers { .. } => "number",
            Unsupported::Color(_) => "color",
            Unsupported::Text(_) => "string",
        }
    }
}

impl Serialize for Unsupported {
    fn serialize<S: Serializer>(&self, s: S) -> Result<S::Ok, S::Error> {
        match self {
            Unsupported::Word(word) => s.serialize_str(word),
            Unsupported::Numbers { .. } => Self::serialize_row(std::slice::from_ref(self), s),
            Unsupported::Color(c) if c.filter == 0.0 && c.transmit == 0.0 => {
                serialize_named(s, "rgb", &c.rgb.to_array())
            }
            Unsupported::Color(c) => serialize_named(s, "rgbft", &c.to_array()),
            Unsupported::Text(text) => serialize_named(s, "text", text),
            Unsupported::Declared(kind) => serialize_named(s, "declared", kind),
            Unsupported::Block(word, inner) => serialize_named(s, word, &Row(inner)),
        }
    }
}

fn serialize_named<S: Serializer>(s: S, name: &str, value: &impl Serialize) -> Result<S::Ok, S::Error> {
    let mut map = s.serialize_map(Some(1))?;
    map.serialize_entry(name, value)?;
    map.end()
}

impl<'s> Item<'s> {
    fn from_components(c: &'s [f64]) -> Self {
        if let [x] = c { Item::Number(*x) } else { Item::Vector(c) }
    }
}

/// Unsupported contents of a block, for serialization.
struct Row<'s>(&'s [Unsupported]);

/// One item of a block's unsupported contents, for serialization.
enum Item<'s> {
    Number(f64),
    Vector(&'s [f64]),
    Other(&'s Unsupported),
}

fn items(row: &[Unsupported]) -> impl Iterator<Item = Item<'_>> {
    row.iter().flat_map(|item| {
        let (width, all, other) = match item {
            Unsupported::Numbers { width, all } => ((*width).max(1), &all[..], None),
            other => (1, &[][..], Some(Item::Other(other))),
        };
        all.chunks(width).map(Item::from_components).chain(other)
    })
}

impl Serialize for Row<'_> {
    fn serialize<S: Serializer>(&self, s: S) -> Result<S::Ok, S::Error> {
        Unsupported::serialize_row(self.0, s)
    }
}

impl Serialize for Item<'_> {
    fn serialize<S: Serializer>(&self, s: S) -> Result<S::Ok, S::Error> {
        match self {
            Item::Number(x) => s.serialize_f64(*x),
            Item::Vector(c) => s.collect_seq(*c),
            Item::Other(item) => item.serialize(s),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn items_serialize_in_their_order() {
        let mut row = vec![Unsupported::Word("angle")];
        Unsupported::push_numbers(&mut row, &[1.0]);
        Unsupported::push_numbers(&mut row, &[2.0]);
        Unsupported::push_numbers(&mut row, &[1.0, 2.0, 3.0]);
        Unsupported::push_value(&mut row, &Value::Color(Color::WHITE));
        row.push(Unsupported::Block("entry", Box::default()));
        assert_eq!(row.len(), 5);
        let json = serde_json::to_string(&Unsupported::Block("fog", row.into())).unwrap();
        assert_eq!(json, r#"{"fog":["angle",1.0,2.0,[1.0,2.0,3.0],{"rgb":[1.0,1.0,1.0]},{"entry":[]}]}"#);
    }

    #[test]
    fn consecutive_vectors_share_one_item() {
        let mut row = vec![];
        (0..1000).for_each(|i| Unsupported::push_numbers(&mut row, &[f64::from(i), 0.0, 0.0]));
        let mut count = 0;
        row[0].visit_vectors(&mut |v| count += usize::from(v.len == 3));
        assert_eq!((row.len(), count), (1, 1000));
    }
}
