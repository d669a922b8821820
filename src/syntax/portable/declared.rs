//! Finds the kinds of the declared names, as far as the text alone decides them.

use super::token_after_partner;
use crate::syntax::class;
use crate::syntax::outline::{Declaration, DeclarationKind, Outline};
use rustc_hash::FxHashMap;

/// The kind of a declared value.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum DeclaredKind {
    /// Kind of a name declared as a block such as `texture { … }` or `pigment { … }`: the block's word.
    Block(&'static str),
    /// Kind of a name declared as a vector without a word before it.
    Vector,
    /// Kind of a name that is declared as anything else, or as several kinds.
    Unknown,
}

/// Blocks whose declared names POV-Ray accepts only in a block of the same word.
const BLOCKS: &[&str] = &["texture", "pigment", "normal", "finish", "interior", "material", "transform"];

/// Names that the scene's files declare, with their kinds.
pub(super) struct Declared<'a> {
    kinds: FxHashMap<&'a str, DeclaredKind>,
    /// Names of macros; true if each macro of the name ends with the `}` of a block.
    macros: FxHashMap<&'a str, bool>,
    /// True if the scene's own file requests a language version without `;` after values.
    pub has_old_version: bool,
}

impl<'a> Declared<'a> {
    pub(super) fn new(own_file: &Outline, all_files: &'a [Outline]) -> Self {
        let mut out = Self {
            kinds: FxHashMap::default(),
            macros: FxHashMap::default(),
            has_old_version: has_old_version(own_file),
        };
        all_files.iter().for_each(|outline| out.add_declarations_of(outline));
        out
    }

    pub(super) fn kind(&self, name: &str) -> Option<DeclaredKind> {
        self.kinds.get(name).copied()
    }

    /// True if the name is a macro whose body ends with a block.
    pub(super) fn macro_ends_with_block(&self, name: &str) -> bool {
        self.macros.get(name) == Some(&true)
    }

    fn add_declarations_of(&mut self, outline: &'a Outline) {
        for d in &outline.declarations {
            match d.kind {
                DeclarationKind::Declare | DeclarationKind::Local => self.add(&d.name, kind_of(outline, d)),
                // A parameter or a counter may be of any kind.
                DeclarationKind::Parameter | DeclarationKind::Counter => self.add(&d.name, DeclaredKind::Unknown),
                DeclarationKind::Macro => *self.macros.entry(&d.name).or_insert(true) &= ends_with_block(outline, d),
            }
        }
    }

    fn add(&mut self, name: &'a str, kind: DeclaredKind) {
        let known = self.kinds.entry(name).or_insert(kind);
        if *known != kind {
            *known = DeclaredKind::Unknown;
        }
    }
}

/// True if the last token of the macro that a declaration defines is the `}` of a block.
fn ends_with_block(outline: &Outline, d: &Declaration) -> bool {
    let own = outline.opened_by(outline.first_token_from(d.whole.start)).and_then(|pair| pair.closer);
    own.is_some_and(|end| outline.class_before(end) == class::BRACE_END)
}

/// Returns the kind of a declaration's value.
fn kind_of(outline: &Outline, d: &Declaration) -> DeclaredKind {
    // The first token after the name is `=`.
    let value = outline.first_token_from(d.range.end) + 1;
    let end = match outline.class(value) {
        class::VECTOR => token_after_partner(outline, value),
        class::LITERAL if outline.token_text(value).starts_with('<') => Some(value + 1),
        _ if outline.class(value + 1) == class::BRACE => {
            let block = BLOCKS.iter().find(|block| **block == outline.token_text(value));
            return block.map_or(DeclaredKind::Unknown, |block| DeclaredKind::Block(block));
        }
        _ => None,
    };
    match end.map(|end| outline.class(end)) {
        Some(class::SEMICOLON) => DeclaredKind::Vector,
        _ => DeclaredKind::Unknown,
    }
}

/// True if the text contains a `#version` directive below 3.5, or one without a literal number.
fn has_old_version(outline: &Outline) -> bool {
    let mut versions = (0..outline.tokens.len()).filter(|&at| outline.directive_word(&outline.tokens[at]) == "version");
    versions.any(|at| outline.token_text(at + 1).parse::<f64>().map_or(true, |version| version < 3.5))
}
