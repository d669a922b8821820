//! Table rows of blocks: one per shape, pattern, camera. They feed the reader, the messages, the manual, hover and
//! completion.

/// A block of the language.
#[derive(Debug)]
pub struct Spec {
    /// The word before the brace.
    pub name: &'static str,
    /// Summary for the manual.
    pub summary: &'static str,
    /// Positional parameters, in order.
    pub params: &'static [Param],
    /// Words of this block beyond those of its family.
    pub words: &'static [WordSpec],
}

/// A positional parameter.
#[derive(Debug)]
pub struct Param {
    /// Name in the manual.
    pub name: &'static str,
    /// Type of the value.
    pub kind: ValueKind,
    /// Summary for the manual.
    pub summary: &'static str,
}

/// A word inside a block.
#[derive(Clone, Copy, Debug)]
pub struct WordSpec {
    /// Name.
    pub name: &'static str,
    /// Type of the value after the word.
    pub kind: ValueKind,
    /// Default value as typed; empty without a default.
    pub default: &'static str,
    /// Summary for the manual.
    pub summary: &'static str,
}

/// Type of a parameter or of the value after a word.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ValueKind {
    /// No value: the word itself is a switch.
    Nothing,
    /// Nothing, `on`, `off` or a number.
    Flag,
    /// A number.
    Float,
    /// Two components in `< >`, or one number for both.
    Vector2,
    /// Three components in `< >`, or one number for all.
    Vector,
    /// Vectors separated by commas.
    Vectors,
    /// A colour.
    Color,
    /// A string.
    Text,
    /// A block in braces, or several values that the manual's text describes.
    Block,
}

impl Spec {
    /// Names of the words.
    pub fn word_names(&self) -> impl Iterator<Item = &'static str> {
        self.words.iter().map(|w| w.name)
    }
}
