//! Descriptions of the blocks of the language: one per shape, pattern, `finish`, camera. They feed the reader, the
//! messages, the manual, hover and completion.

use super::words::TRANSFORMS;

/// Description of a block of the scene language, such as a shape, a pattern or `finish`: its parameters and words.
#[derive(Debug)]
pub struct Spec {
    /// The word before the block's opening brace.
    pub name: &'static str,
    /// Summary of the block for the manual.
    pub summary: &'static str,
    /// Positional parameters of the block, in order.
    pub params: &'static [Param],
    /// Words that have an effect in the block, beyond those of its family.
    pub words: &'static [WordSpec],
    /// True if the block takes the transforms [`TRANSFORMS`], too.
    pub has_transforms: bool,
    /// Words that are read without effect.
    pub ignored: &'static [&'static str],
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
    /// Value type: a block in braces, or several values that the manual's text describes.
    Block,
}

impl Spec {
    /// Description of a block without parameters and words, for struct updates.
    pub const EMPTY: Self =
        Self { name: "", summary: "", params: &[], words: &[], has_transforms: false, ignored: &[] };

    /// True if the word has an effect in the block.
    pub fn has_effect(&self, word: &str) -> bool {
        self.words.iter().any(|w| w.name == word)
    }

    /// True if the block reads the word without effect.
    pub fn ignores(&self, word: &str) -> bool {
        self.ignored.contains(&word)
    }

    /// Returns all words that the block accepts, in the order in which messages list them. Messages show a dozen, so
    /// that transforms come early.
    pub fn word_names(&self) -> Vec<&'static str> {
        let (first, rest) = self.words.split_at(self.words.len().min(6));
        let transforms = TRANSFORMS.iter().filter(|_| self.has_transforms);
        let words = first.iter().chain(transforms).chain(rest).map(|w| w.name);
        words.chain(self.ignored.iter().copied()).collect()
    }

    /// Returns the syntax of a form without braces, such as `gradient orientation`.
    pub fn usage(&self) -> String {
        self.params.iter().fold(self.name.to_string(), |usage, param| usage + " " + param.name)
    }

    /// Returns the syntax of a form with braces, such as `box { corner_1, corner_2 … }`.
    pub fn block_usage(&self) -> String {
        let params: Vec<_> = self.params.iter().map(|p| p.name).collect();
        let space = if params.is_empty() { "" } else { " " };
        format!("{} {{ {}{space}… }}", self.name, params.join(", "))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::value::words::word;

    #[test]
    fn names_are_in_the_order_of_the_table() {
        const WORDS: &[WordSpec] = &[word("radius", ValueKind::Float, "1", "")];
        let block = Spec { words: WORDS, has_transforms: true, ignored: &["old"], ..Spec::EMPTY };
        assert_eq!(block.word_names(), ["radius", "translate", "rotate", "scale", "matrix", "transform", "old"]);
        assert!(block.has_effect("radius") && !block.has_effect("old"));
        assert!(block.ignores("old") && !block.ignores("radius"));
    }
}
