//! The words of blocks that are no member of a family: `finish`, `camera`, `light_source` … One table feeds the reader, the
//! messages and the manual.

use super::{Kind, Next, Reader, WordSpec};
use crate::diagnostic::Result;

/// All words of one block.
#[derive(Debug)]
pub struct Vocabulary {
    /// The word in front of the brace.
    pub block: &'static str,
    /// One line for the manual.
    pub summary: &'static str,
    /// What is obeyed.
    pub words: &'static [WordSpec],
    /// Does it take [`TRANSFORMS`] too?
    pub moves: bool,
    /// What is read and changes nothing in durer.
    pub idle: &'static [&'static str],
    /// What is read, and left out of the picture with a warning.
    pub unsupported: &'static [&'static str],
}

impl Vocabulary {
    /// Is the word obeyed?
    pub fn obeys(&self, word: &str) -> bool {
        self.words.iter().any(|w| w.name == word)
    }

    /// Is it read without effect?
    pub fn ignores(&self, word: &str) -> bool {
        self.idle.contains(&word)
    }

    /// Is it read and left out with a warning?
    pub fn is_unsupported(&self, word: &str) -> bool {
        self.unsupported.contains(&word)
    }

    /// All names, in the order in which messages list them. They show a dozen: transforms shall be among these.
    pub fn names(&self) -> Vec<&'static str> {
        let (first, rest) = self.words.split_at(self.words.len().min(6));
        let moves = TRANSFORMS.iter().filter(|_| self.moves);
        let words = first.iter().chain(moves).chain(rest).map(|w| w.name);
        words.chain(self.idle.iter().copied()).chain(self.unsupported.iter().copied()).collect()
    }
}

/// A row of a table of words.
pub const fn word(name: &'static str, kind: Kind, default: &'static str, summary: &'static str) -> WordSpec {
    WordSpec { name, kind, default, summary }
}

/// Reads what follows a word, which is consumed, into the thing that has it.
pub type Setter<T> = fn(&mut T, &mut dyn Reader) -> Result<()>;

/// A row of a table of words that knows how it is read.
#[derive(Debug)]
pub struct Row<T: 'static> {
    /// What the messages and the manual tell.
    pub spec: WordSpec,
    /// What the reader does.
    pub set: Setter<T>,
}

impl WordSpec {
    /// The row of a thing that reads the word so.
    pub const fn sets<T>(self, set: Setter<T>) -> Row<T> {
        Row { spec: self, set }
    }
}

/// Reads one of these words, if it comes next, and what follows it; false if none does.
///
/// # Errors
/// With the place of what is not understood, and what was expected there.
pub fn read_row<T>(rows: &[Row<T>], thing: &mut T, next: Next, r: &mut dyn Reader) -> Result<bool> {
    let Next::Word(word) = next else { return Ok(false) };
    let Some(row) = rows.iter().find(|row| row.spec.name == word) else { return Ok(false) };
    r.take()?;
    (row.set)(thing, r).map(|()| true)
}

/// Does one of these words come next?
pub fn is_row<T>(rows: &[Row<T>], next: Next) -> bool {
    matches!(next, Next::Word(word) if rows.iter().any(|row| row.spec.name == word))
}

/// Sets a field to what was read.
///
/// # Errors
/// That of the reading.
pub fn set<T>(field: &mut T, read: Result<T>) -> Result<()> {
    *field = read?;
    Ok(())
}

/// What an array is filled with first.
const NO_WORD: WordSpec = word(EMPTY, Kind::Nothing, EMPTY, EMPTY);
const EMPTY: &str = "";

/// What the rows tell, without how they are read; the macro `specs!` calls it.
pub const fn specs_of<T, const N: usize>(rows: &[Row<T>]) -> [WordSpec; N] {
    let mut out = [NO_WORD; N];
    let mut i = 0;
    while i < N {
        out[i] = rows[i].spec;
        i += 1;
    }
    out
}

/// Two tables one behind the other; `N` is how long both are together.
pub const fn joined<const N: usize>(first: &[WordSpec], second: &[WordSpec]) -> [WordSpec; N] {
    let mut out = [NO_WORD; N];
    let mut i = 0;
    while i < N {
        out[i] = if i < first.len() { first[i] } else { second[i - first.len()] };
        i += 1;
    }
    out
}

/// The `&'static [WordSpec]` of a constant `&[Row<T>]`, for the tables that know no `T`.
macro_rules! specs {
    ($rows:expr) => {
        &$crate::value::words::specs_of::<_, { $rows.len() }>($rows)
    };
}
pub(crate) use specs;

/// What moves things; they are obeyed in the order in which they are written.
pub const TRANSFORMS: &[WordSpec] = &[
    word("translate", Kind::Vector, "", "moves by this vector"),
    word("rotate", Kind::Vector, "", "turns about the x axis, then y, then z, by these angles in degrees; left-handed"),
    word("scale", Kind::Vector, "", "stretches along the axes; one number is for all three"),
    word("matrix", Kind::Block, "", "twelve numbers: where the three axes and the origin go to"),
    word(
        "transform",
        Kind::Block,
        "",
        "several of these in braces, or a declared one; `inverse` among them undoes those before it",
    ),
];

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_come_in_the_order_of_the_table() {
        const WORDS: &[WordSpec] = &[word("radius", Kind::Float, "1", "")];
        let table = Vocabulary {
            block: "thing",
            summary: "",
            words: WORDS,
            moves: true,
            idle: &["old"],
            unsupported: &["new"],
        };
        assert_eq!(table.names(), ["radius", "translate", "rotate", "scale", "matrix", "transform", "old", "new"]);
        assert!(table.obeys("radius") && !table.obeys("new") && table.is_unsupported("new") && table.ignores("old"));
    }
}
