//! All words of the language by kind, for the grammars of editors, which `tests/suite/editors.rs` generates.

use super::{BLOCKS, documented_blocks};
use crate::interpreter::directives;
use crate::pattern::Modifiers;
use crate::shape::Shape;
use crate::syntax::word::{CONSTANTS, FUNCTIONS, GROUPS, KEYWORDS};
use crate::syntax::{directive_continues_body, directive_opens_body};
use crate::value::words::TRANSFORMS;
use crate::value::{Family, ValueKind};

/// Words by kind, each list in alphabetical order. No word is in two of the first five lists.
#[derive(Debug)]
pub struct WordsByKind {
    /// Words for objects, such as `sphere` and `union`.
    pub objects: Vec<&'static str>,
    /// Words of blocks that are no objects, such as `pigment` and `camera`.
    pub blocks: Vec<&'static str>,
    /// Names of functions with arguments in parentheses, such as `sin`.
    pub functions: Vec<&'static str>,
    /// Words for values, such as `x`, `pi` and `on`.
    pub constants: Vec<&'static str>,
    /// Words in none of the other lists, such as `rotate`, `rgb` and `marble`.
    pub words: Vec<&'static str>,
    /// Names of directives, without `#`.
    pub directives: Vec<&'static str>,
    /// Names of directives that an `#end` closes.
    pub openers: Vec<&'static str>,
    /// Names of directives between an opener and its `#end`, such as `else` and `case`.
    pub continuers: Vec<&'static str>,
}

/// Returns all words of the language by kind.
pub fn words_by_kind() -> WordsByKind {
    let rows = || documented_blocks().map(|entry| entry.spec.words).chain([TRANSFORMS, Modifiers::WORDS]).flatten();
    let objects = sorted(Shape::SPECS.iter().map(|spec| spec.name).chain(GROUPS.iter().copied()));
    // These have no table.
    let named = BLOCKS.iter().map(|block| block.spec.name).chain(["function", "array", "pattern", "warp"]);
    let with_braces = rows().filter(|row| row.kind == ValueKind::Block).map(|row| row.name);
    let is_keyword = |name: &&str| KEYWORDS.contains(name);
    let blocks = sorted(named.chain(with_braces).filter(is_keyword).filter(|name| !objects.contains(name)));
    let is_left = |name: &&str| !objects.contains(name) && !blocks.contains(name);
    let words = sorted(KEYWORDS.iter().copied().filter(is_left));
    let directives = sorted(directives::TABLE.iter().flat_map(|row| row.names.iter().copied()));
    let some = |which: fn(&str) -> bool| directives.iter().copied().filter(|name| which(name)).collect();
    WordsByKind {
        functions: sorted(FUNCTIONS.iter().copied()),
        constants: sorted(CONSTANTS.iter().map(|(name, _)| *name)),
        openers: some(directive_opens_body),
        continuers: some(directive_continues_body),
        objects,
        blocks,
        words,
        directives,
    }
}

fn sorted(words: impl Iterator<Item = &'static str>) -> Vec<&'static str> {
    words.collect::<std::collections::BTreeSet<_>>().into_iter().collect()
}
