//! Manual page with an index of all words of the language, and the blocks that take them.

use super::{in_backticks, table};
use crate::pattern::{Modifiers, TurbulenceParams, bitmap};
use crate::reference::{ELSEWHERE, documented_blocks};
use crate::syntax::word::{CONSTANTS, CONTEXTUAL, FUNCTIONS, KEYWORDS};
use crate::value::WordSpec;
use crate::value::words::TRANSFORMS;
use crate::{function, interpreter};
use std::collections::BTreeMap;

type Index = BTreeMap<&'static str, Vec<String>>;

pub(super) fn words_page() -> String {
    let mut index = Index::new();
    add_block_words(&mut index);
    add_value_words(&mut index);
    let all = KEYWORDS.iter().chain(FUNCTIONS).copied().chain(CONSTANTS.iter().map(|c| c.0));
    let mut all: Vec<_> = all.chain(CONTEXTUAL.iter().flat_map(|(_, words)| words.iter().copied())).collect();
    all.sort_unstable();
    all.dedup();
    let rows = all
        .into_iter()
        .map(|word| [in_backticks(word), index.get(word).map(|places| places.join("; ")).unwrap_or_default()]);
    format!(
        "What the language knows, and which blocks take it. No scene can declare these names; those that are *durer's own* are \
         words only in their blocks.\n\n{}",
        table(["word", "belongs to"], rows)
    )
}

fn add(index: &mut Index, word: &'static str, place: &str) {
    let places = index.entry(word).or_default();
    if !places.iter().any(|p| p == place) {
        places.push(place.into());
    }
}

fn add_words(index: &mut Index, words: &'static [WordSpec], place: &str) {
    words.iter().for_each(|w| add(index, w.name, place));
}

fn add_block_words(index: &mut Index) {
    for entry in documented_blocks() {
        let (spec, place) = (entry.spec, entry.link());
        if let Some(family) = entry.family {
            add(index, spec.name, &format!("[a {family}]({}#{})", entry.page, spec.name));
        }
        add_words(index, spec.words, &place);
        spec.ignored.iter().for_each(|word| add(index, word, &format!("{place}, without effect")));
    }
    for inner in ["finish", "normal", "interior", "reflection"] {
        add(index, inner, "[a block](finishes.md)");
    }
    add_words(index, bitmap::WORDS, "[pictures](pigments.md#pictures)");
    add_words(index, bitmap::CHANNELS, "[`image_pattern`, `bump_map`](pigments.md#what-counts-of-a-pixel)");
    bitmap::FORMATS.iter().for_each(|word| add(index, word, "[pictures](pigments.md#pictures), without effect"));
    add_words(index, Modifiers::WORDS, "[patterns](pigments.md)");
    add_words(index, TurbulenceParams::WORDS, "[patterns](pigments.md)");
    add_words(index, TRANSFORMS, "[transforms](objects.md#transforms)");
}

fn add_value_words(index: &mut Index) {
    add_words(index, interpreter::COLOR_WORDS, "[colours](colors.md)");
    let numeric = function::numeric::TABLE.iter().map(|row| row.name);
    for name in numeric.chain(interpreter::script_only_functions().map(|(name, ..)| name)) {
        add(index, name, "[functions](functions.md)");
    }
    CONSTANTS.iter().for_each(|(name, _)| add(index, name, "[constants](constants.md)"));
    for (block, words) in CONTEXTUAL {
        words.iter().filter(|_| *block != "camera").for_each(|word| add(index, word, "*durer's own*"));
    }
    ELSEWHERE.iter().for_each(|(word, place)| add(index, word, place));
}
