//! Table rows of blocks: one per shape, pattern, camera. They feed the reader, the messages, the manual, hover and
//! completion.

/// Description of a block of the scene language: its words and parameters.
#[derive(Debug)]
pub struct Spec {
    /// The word before the block's opening brace.
    pub name: &'static str,
    /// Summary of the block for the manual.
    pub summary: &'static str,
    /// Positional parameters of the block, in order.
    pub params: &'static [Param],
    /// Words of this block beyond those of its family.
    pub words: &'static [WordSpec],
}

/// A positional parameter of a block.
#[derive(Debug)]
pub struct Param {
    /// Name of the block's parameter in the manual.
    pub name: &'static str,
    /// Type of the parameter's value.
    pub kind: ValueKind,
    /// Summary of the parameter for the manual.
    pub summary: &'static str,
}

/// A keyword that is allowed inside a block.
#[derive(Clone, Copy, Debug)]
pub struct WordSpec {
    /// Name of the keyword.
    pub name: &'static str,
    /// Type of the value that follows the keyword.
    pub kind: ValueKind,
    /// Default value of the keyword as typed; empty without a default.
    pub default: &'static str,
    /// Summary of the keyword for the manual.
    pub summary: &'static str,
}

/// Type of a parameter or of the value after a word.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ValueKind {
    /// Value type: none, the keyword itself is a switch.
    Nothing,
    /// Value type: nothing, `on`, `off` or a number.
    Flag,
    /// Value type: a number.
    Float,
    /// Two components in `< >`, or one number for both.
    Vector2,
    /// Three components in `< >`, or one number for all.
    Vector,
    /// Value type: vectors separated by commas.
    Vectors,
    /// Value type: a colour.
    Color,
    /// Value type: a string.
    Text,
    /// A block in braces, or several values that the manual's text describes.
    Block,
}

impl Spec {
    /// Returns the names of the words allowed in the block.
    pub fn word_names(&self) -> impl Iterator<Item = &'static str> {
        self.words.iter().map(|w| w.name)
    }
}
