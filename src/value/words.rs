//! Tables of the words of blocks, with the functions that read their values.

use super::{Next, Reader, ValueKind, WordSpec};
use crate::diagnostic::Result;

/// Creates a row of a block's table of words.
pub const fn word(name: &'static str, kind: ValueKind, default: &'static str, summary: &'static str) -> WordSpec {
    WordSpec { name, kind, default, summary }
}

/// Function that reads the value after a word into a field of `T`. The word has been consumed.
pub type FieldReader<T> = fn(&mut T, &mut dyn Reader) -> Result<()>;

/// A row of a table of words, with the function that reads its value.
#[derive(Debug)]
pub struct Row<T: 'static> {
    /// Name, value type and description of the one word that this row reads.
    pub spec: WordSpec,
    /// Function that reads the word's value into the block.
    pub set: FieldReader<T>,
}

impl WordSpec {
    /// Returns the table row of this word, with the function that reads the word's value.
    pub const fn sets<T>(self, set: FieldReader<T>) -> Row<T> {
        Row { spec: self, set }
    }
}

/// Reads a word of the table and its value; false if the next token is none of the words.
///
/// # Errors
/// The error of the value's reader.
pub fn read_row<T>(rows: &[Row<T>], thing: &mut T, next: Next, r: &mut dyn Reader) -> Result<bool> {
    let Next::Word(word) = next else { return Ok(false) };
    let Some(row) = rows.iter().find(|row| row.spec.name == word) else { return Ok(false) };
    r.take_token()?;
    (row.set)(thing, r).map(|()| true)
}

/// True if the next token is a word of the table.
pub fn is_word_in_rows<T>(rows: &[Row<T>], next: Next) -> bool {
    matches!(next, Next::Word(word) if rows.iter().any(|row| row.spec.name == word))
}

/// Assigns a value that was read to a field.
///
/// # Errors
/// The error of the reading.
pub fn set<T>(field: &mut T, read: Result<T>) -> Result<()> {
    *field = read?;
    Ok(())
}

/// Filler of word tables that are under construction.
const NO_WORD: WordSpec = word(EMPTY, ValueKind::Nothing, EMPTY, EMPTY);
const EMPTY: &str = "";

/// The word descriptions of a table of rows; the macro `specs!` calls it.
pub const fn specs_of<T, const N: usize>(rows: &[Row<T>]) -> [WordSpec; N] {
    let mut out = [NO_WORD; N];
    let mut i = 0;
    while i < N {
        out[i] = rows[i].spec;
        i += 1;
    }
    out
}

/// Concatenates two tables of words; `N` has to be the sum of their lengths.
pub const fn joined<const N: usize>(first: &[WordSpec], second: &[WordSpec]) -> [WordSpec; N] {
    let mut out = [NO_WORD; N];
    let mut i = 0;
    while i < N {
        out[i] = if i < first.len() { first[i] } else { second[i - first.len()] };
        i += 1;
    }
    out
}

/// The `&'static [WordSpec]` of a constant `&[Row<T>]`, for tables that do not depend on `T`.
macro_rules! specs {
    ($rows:expr) => {
        &$crate::value::words::specs_of::<_, { $rows.len() }>($rows)
    };
}
pub(crate) use specs;

/// Words of transforms, which apply in the order of the text.
pub const TRANSFORMS: &[WordSpec] = &[
    word("translate", ValueKind::Vector, "", "moves by this vector"),
    word(
        "rotate",
        ValueKind::Vector,
        "",
        "turns about the x axis, then y, then z, by these angles in degrees; left-handed",
    ),
    word("scale", ValueKind::Vector, "", "stretches along the axes; one number is for all three"),
    word("matrix", ValueKind::Block, "", "twelve numbers: where the three axes and the origin go to"),
    word(
        "transform",
        ValueKind::Block,
        "",
        "several of these in braces, or a declared one; `inverse` among them undoes those before it",
    ),
];
