//! Explanations of words and lists of the words of a block, from the tables of the readers.

use crate::function::numeric::{self, Kernel};
use crate::interpreter;
use crate::pattern::{CellPattern, FieldPattern, Modifiers, TurbulenceParams, Warp, bitmap};
use crate::reference::{BLOCKS, ELSEWHERE, documented_blocks, shape_pattern_warp_entries};
use crate::scene::words::MODIFIERS;
use crate::shape::Shape;
use crate::syntax::Outline;
use crate::syntax::word::{CONSTANTS, GROUPS};
use crate::value::words::{TRANSFORMS, word};
use crate::value::{Family, Spec, ValueKind, WordSpec};

/// Returns the specification of a shape's block, with the words that the block takes; `None` for other names.
pub fn shape_spec(name: &str) -> Option<&'static Spec> {
    Shape::spec_of(name)
}

fn add_new_words(out: &mut Vec<WordSpec>, more: impl IntoIterator<Item = WordSpec>) {
    for word in more {
        if !out.iter().any(|other| other.name == word.name) {
            out.push(word);
        }
    }
}

/// Returns the names of these blocks as entries of a word table that take no value.
fn block_name_entries(specs: &[&Spec]) -> impl Iterator<Item = WordSpec> {
    specs.iter().map(|spec| word(spec.name, ValueKind::Nothing, "", spec.summary))
}

/// Returns the words that a block takes, each once; the empty name is the scene outside of all blocks. Empty for an
/// unknown block.
pub fn block_words(block: &str) -> Vec<WordSpec> {
    let mut out = vec![];
    let holds_objects =
        block.is_empty() || GROUPS.contains(&block) || matches!(block, "clipped_by" | "bounded_by" | "light_group");
    let named = if block.is_empty() { interpreter::STATEMENTS.name } else { block };
    for entry in documented_blocks().filter(|entry| entry.has_braces && entry.spec.name == named) {
        add_new_words(&mut out, entry.spec.words.iter().copied());
        if entry.spec.has_transforms {
            add_new_words(&mut out, TRANSFORMS.iter().copied());
        }
    }
    if holds_objects {
        add_new_words(&mut out, block_name_entries(Shape::SPECS));
        add_new_words(
            &mut out,
            interpreter::STATEMENTS.words.iter().copied().filter(|word| GROUPS.contains(&word.name)),
        );
    }
    let mut tables: Vec<&[WordSpec]> = vec![];
    if !block.is_empty() && (holds_objects || shape_spec(block).is_some()) {
        tables.extend([MODIFIERS.words, TRANSFORMS]);
    }
    if matches!(block, "pigment" | "normal" | "texture" | "density" | "pattern") {
        add_new_words(&mut out, block_name_entries(FieldPattern::SPECS).chain(block_name_entries(CellPattern::SPECS)));
        tables.extend([Modifiers::WORDS, TurbulenceParams::WORDS, TRANSFORMS]);
    }
    match block {
        "warp" => add_new_words(&mut out, block_name_entries(Warp::SPECS)),
        "image_map" | "bump_map" | "material_map" | "image_pattern" => tables.push(bitmap::WORDS),
        "transform" => tables.push(TRANSFORMS),
        _ => {}
    }
    add_new_words(&mut out, tables.into_iter().flatten().copied());
    out
}

/// Returns the description of a kind of value for completion and hover, such as "a number".
pub fn kind_description(kind: ValueKind) -> &'static str {
    match kind {
        ValueKind::Nothing => "nothing",
        ValueKind::Flag => "nothing, `on` or `off`",
        ValueKind::Float => "a number",
        ValueKind::Vector2 => "a vector of two",
        ValueKind::Vector => "a vector",
        ValueKind::Vectors => "vectors",
        ValueKind::Color => "a colour",
        ValueKind::Text => "a text",
        ValueKind::Block => "a block",
    }
}

/// Returns explanations of a word in Markdown, one for each meaning; its meaning in `block` comes first. Empty for an
/// unknown word.
pub fn explain(word: &str, block: &str) -> Vec<String> {
    let mut out = vec![];
    let mut add = |text: String, first: bool| {
        if !out.contains(&text) {
            out.insert(if first { 0 } else { out.len() }, text);
        }
    };
    if let Some(word_info) = block_words(block).iter().find(|info| info.name == word) {
        let place = if block.is_empty() { String::new() } else { format!("in `{block}`: ") };
        add(format!("{place}{}", describe(word_info)), true);
    }
    let member = shape_pattern_warp_entries().find(|entry| entry.spec.name == word);
    for entry in member.into_iter().chain(BLOCKS.iter().copied()) {
        let spec = entry.spec;
        if spec.name == word {
            add(format!("`{}`: {}", entry.usage(), spec.summary), false);
        }
        if entry.family.is_none() {
            for row in spec.words.iter().filter(|row| row.name == word && spec.name != block) {
                add(format!("in `{}`: {}", spec.name, describe(row)), false);
            }
        }
    }
    for row in interpreter::COLOR_WORDS.iter().chain(TRANSFORMS).filter(|row| row.name == word) {
        add(describe(row), false);
    }
    if let Some((usage, summary)) = function_usage_and_summary(word) {
        add(format!("`{usage}`: {summary}"), false);
    }
    for (_, what) in CONSTANTS.iter().filter(|(name, _)| *name == word) {
        add((*what).to_string(), false);
    }
    if out.is_empty() {
        out.extend(ELSEWHERE.iter().filter(|(name, _)| *name == word).map(|(_, place)| without_links(place)));
    }
    out
}

/// Removes the links from a Markdown text of the manual, because they lead to other pages.
fn without_links(markdown: &str) -> String {
    let mut text = String::new();
    let mut rest = markdown;
    while let Some((before, link)) = rest.split_once('[') {
        text.push_str(before);
        match link.split_once("](").and_then(|(name, after)| Some((name, after.split_once(')')?.1))) {
            Some((name, after)) => {
                text.push_str(name);
                rest = after;
            }
            None => {
                text.push('[');
                rest = link;
            }
        }
    }
    text + rest
}

fn describe(info: &WordSpec) -> String {
    let takes = if info.kind == ValueKind::Nothing {
        String::new()
    } else {
        format!(" (takes {})", kind_description(info.kind))
    };
    let default = if info.default.is_empty() { String::new() } else { format!(" Default: {}.", info.default) };
    format!("{}{takes}.{default}", info.summary)
}

/// Returns the syntax and description of a built-in function; `None` for other names.
pub fn function_usage_and_summary(name: &str) -> Option<(String, &'static str)> {
    function_names_arguments_summaries()
        .find(|(other, ..)| *other == name)
        .map(|(name, arguments, summary)| (format!("{name}{arguments}"), summary))
}

/// Returns all built-in functions of the scene language: name, arguments in parentheses, description.
pub fn function_names_arguments_summaries() -> impl Iterator<Item = (&'static str, &'static str, &'static str)> {
    let numbers = numeric::TABLE.iter().map(|row| {
        let arguments = match row.kernel {
            Kernel::One(_) => "(A)",
            Kernel::Two(_) => "(A, B)",
            Kernel::Many(_) => "(A, B, …)",
        };
        (row.name, arguments, row.summary)
    });
    numbers.chain(interpreter::script_only_functions())
}

/// Returns the syntax and description of a directive, whose `word` is without `#`; `None` for other words.
pub fn directive_usage_and_summary(word: &str) -> Option<(&'static str, &'static str)> {
    let row = interpreter::directives::TABLE.iter().find(|row| row.names.contains(&word))?;
    Some((row.form, row.summary))
}

/// Returns the name of the innermost block around a byte; empty outside of all blocks.
pub fn block_name_at(outline: &Outline, offset: usize) -> &str {
    outline.pair_at(offset, |pair| pair.bracket == b'{').map_or("", |pair| outline.head(pair))
}
