//! Kinds of the declared names, as far as the text decides them.

use super::{Text, is_directive};
use crate::syntax::ast::Symbol;
use crate::syntax::class;
use rustc_hash::FxHashMap;

/// The kind of a declared value.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Kind {
    /// Kind of a name declared as a block such as `texture { … }` or `pigment { … }`: the block's word.
    Block(&'static str),
    /// Kind of a name declared as a vector without a word before it.
    Vector,
    /// Kind of a name that is declared as another kind, or as different kinds.
    Unknown,
}

/// Blocks whose names POV-Ray accepts in a block of the same word only.
const BLOCKS: &[&str] = &["texture", "pigment", "normal", "finish", "interior", "material", "transform"];

/// All names that the scene's files declare, with their kinds.
pub(super) struct Declared {
    kinds: FxHashMap<Symbol, Kind>,
    /// True for a macro if the last token of its body, and of all others of the name, is the `}` of a block.
    macros: FxHashMap<Symbol, bool>,
    /// True if the scene's own file requests a language version without `;` after values.
    pub is_old: bool,
}

impl Declared {
    pub(super) fn of(texts: &[Text]) -> Self {
        let mut out = Self {
            kinds: FxHashMap::default(),
            macros: FxHashMap::default(),
            is_old: texts.first().is_some_and(is_old),
        };
        texts.iter().for_each(|text| out.gather(text));
        out
    }

    pub(super) fn kind(&self, symbol: Symbol) -> Option<Kind> {
        self.kinds.get(&symbol).copied()
    }

    /// True if the symbol is a macro whose body ends with a block.
    pub(super) fn ends_with_block(&self, symbol: Symbol) -> bool {
        self.macros.get(&symbol) == Some(&true)
    }

    fn gather(&mut self, text: &Text) {
        for at in 0..text.len() {
            match text.class(at) {
                class::DECLARE => {
                    if let Some(symbol) = text.symbol(at + 1) {
                        self.add(symbol, kind_of(text, at + 2));
                    }
                }
                class::MACRO => {
                    let block = body_end(text, at).is_some_and(|end| text.before(end) == class::BRACE_END);
                    if let Some(symbol) = text.symbol(at + 1) {
                        *self.macros.entry(symbol).or_insert(true) &= block;
                    }
                    self.add_parameters(text, at);
                }
                class::FOR => self.add_parameters(text, at),
                _ => {}
            }
        }
    }

    /// Adds parameters of macros and the variables of loops, which may be of any kind.
    fn add_parameters(&mut self, text: &Text, at: usize) {
        let list = (at + 1..text.len()).take_while(|&at| !matches!(text.class(at), class::PAREN_END));
        list.filter_map(|at| text.symbol(at)).for_each(|symbol| self.add(symbol, Kind::Unknown));
    }

    fn add(&mut self, symbol: Symbol, kind: Kind) {
        let known = self.kinds.entry(symbol).or_insert(kind);
        if *known != kind {
            *known = Kind::Unknown;
        }
    }
}

/// The `#end` of the directive at `at`.
fn body_end(text: &Text, at: usize) -> Option<usize> {
    let mut depth = 0;
    (at..text.len()).find(|&i| {
        let class = text.class(i);
        depth += i32::from(class::opens_body(class)) - i32::from(class == class::END);
        class == class::END && depth == 0
    })
}

/// The kind of `= value`, from the equal sign on.
fn kind_of(text: &Text, at: usize) -> Kind {
    if text.class(at) != class::EQUAL {
        return Kind::Unknown;
    }
    let block = BLOCKS.iter().find(|block| **block == text.word(at + 1));
    match text.class(at + 1) {
        class::VECTOR => match behind(text, at + 1) {
            class::SEMICOLON => Kind::Vector,
            _ => Kind::Unknown,
        },
        _ if text.class(at + 2) == class::BRACE => block.map_or(Kind::Unknown, |block| Kind::Block(block)),
        _ => Kind::Unknown,
    }
}

/// The class of the token after a vector's end.
fn behind(text: &Text, open: usize) -> u8 {
    let mut depth = 0;
    for at in open..text.len() {
        match text.class(at) {
            class::VECTOR => depth += 1,
            class::VECTOR_END if depth == 1 => return text.class(at + 1),
            class::VECTOR_END => depth -= 1,
            class if is_directive(class) => return 0,
            _ => {}
        }
    }
    0
}

/// True if the text contains a `#version` directive below 3.5, or one without a literal number.
fn is_old(text: &Text) -> bool {
    (0..text.len()).any(|at| {
        text.class(at) == class::PLAIN
            && text.word(at).ends_with("version")
            && text.word(at + 1).parse::<f64>().map_or(true, |version| version < 3.5)
    })
}
