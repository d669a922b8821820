//! The table of what a block takes: one per shape, pattern, camera …; it feeds the reader, the
//! messages, the manual, and later hover and completion.

/// One block of the language.
#[derive(Debug)]
pub struct Spec {
    /// The word in front of the brace.
    pub name: &'static str,
    /// One line for the manual.
    pub summary: &'static str,
    /// Positional arguments, in order.
    pub params: &'static [Param],
    /// Words it takes beyond those of its family.
    pub words: &'static [WordSpec],
}

/// A positional argument.
#[derive(Debug)]
pub struct Param {
    /// As the manual calls it.
    pub name: &'static str,
    /// What is expected.
    pub kind: Kind,
    /// One line.
    pub summary: &'static str,
}

/// A word inside a block.
#[derive(Clone, Copy, Debug)]
pub struct WordSpec {
    /// As it is typed.
    pub name: &'static str,
    /// What follows it.
    pub kind: Kind,
    /// As it is typed; empty where there is none.
    pub default: &'static str,
    /// One line.
    pub summary: &'static str,
}

/// What is expected after a word or at a position.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// Nothing: the word itself switches something on.
    Nothing,
    /// Nothing, or `on`/`off`, or a number.
    Flag,
    /// A number.
    Float,
    /// Two numbers in `< >`, or one number for both.
    Vector2,
    /// Three numbers in `< >`, or one number for all.
    Vector,
    /// Several vectors, separated by commas.
    Vectors,
    /// A colour.
    Color,
    /// Text in quotes.
    Text,
    /// A block in braces, or several things described in the manual's text.
    Block,
}

impl Spec {
    /// Its words' names.
    pub fn word_names(&self) -> impl Iterator<Item = &'static str> {
        self.words.iter().map(|w| w.name)
    }
}
