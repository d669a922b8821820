//! Explanations of words and lists of the words of a block, from the tables of the readers.

use super::scan::{Scan, directive};
use crate::function::numeric::{self, Kernel};
use crate::interpreter;
use crate::pattern::{CellPattern, FieldPattern, Modifiers, TurbulenceParams, Warp, bitmap};
use crate::reference::{BLOCKS, ELSEWHERE, FAMILIES};
use crate::scene::words::MODIFIERS;
use crate::shape;
use crate::syntax::word::{CONSTANTS, GROUPS};
use crate::value::words::TRANSFORMS;
use crate::value::{Spec, ValueKind, WordSpec};

/// A word that a block of the scene language accepts.
pub struct WordInfo {
    /// Spelling of the reserved word.
    pub name: &'static str,
    /// Kind of value that follows the reserved word.
    pub kind: ValueKind,
    /// Description of the reserved word in one line.
    pub summary: &'static str,
    /// Default value of the word; empty for a word without default.
    pub default: &'static str,
}

impl From<&WordSpec> for WordInfo {
    fn from(word: &WordSpec) -> Self {
        Self { name: word.name, kind: word.kind, summary: word.summary, default: word.default }
    }
}

impl From<&Spec> for WordInfo {
    fn from(spec: &Spec) -> Self {
        Self { name: spec.name, kind: ValueKind::Nothing, summary: spec.summary, default: "" }
    }
}

/// Returns the table of words for a shape.
pub fn shape(name: &str) -> Option<&'static Spec> {
    shape::SPECS.iter().find(|spec| spec.name == name).copied()
}

fn add<'a, T: 'a>(out: &mut Vec<WordInfo>, more: impl IntoIterator<Item = &'a T>)
where
    WordInfo: From<&'a T>,
{
    for info in more.into_iter().map(WordInfo::from) {
        if !out.iter().any(|other| other.name == info.name) {
            out.push(info);
        }
    }
}

/// The words that a block takes; the empty name is the scene outside of all blocks.
pub fn of_block(block: &str) -> Vec<WordInfo> {
    let mut out = vec![];
    let holds_objects =
        block.is_empty() || GROUPS.contains(&block) || matches!(block, "clipped_by" | "bounded_by" | "light_group");
    if let Some(spec) = shape(block) {
        add(&mut out, spec.words);
    }
    let named = if block.is_empty() { interpreter::STATEMENTS.name } else { block };
    for table in BLOCKS.iter().map(|block| block.words).filter(|table| table.name == named) {
        add(&mut out, table.words);
        if table.has_transforms {
            add(&mut out, TRANSFORMS);
        }
    }
    if holds_objects {
        add(&mut out, shape::SPECS.iter().copied());
        let groups = interpreter::STATEMENTS.words.iter().filter(|word| GROUPS.contains(&word.name));
        add(&mut out, groups);
    }
    if !block.is_empty() && (holds_objects || shape(block).is_some()) {
        add(&mut out, MODIFIERS.words);
        add(&mut out, TRANSFORMS);
    }
    if matches!(block, "pigment" | "normal" | "texture" | "density" | "pattern") {
        add(&mut out, FieldPattern::SPECS.iter().copied());
        add(&mut out, CellPattern::SPECS.iter().copied());
        add(&mut out, Modifiers::WORDS);
        add(&mut out, TurbulenceParams::WORDS);
        add(&mut out, TRANSFORMS);
    }
    match block {
        "warp" => add(&mut out, Warp::SPECS.iter().copied()),
        "image_map" | "bump_map" | "material_map" | "image_pattern" => add(&mut out, bitmap::WORDS),
        "transform" => add(&mut out, TRANSFORMS),
        _ => {}
    }
    out
}

/// Returns the name of a kind of value.
pub fn kind(kind: ValueKind) -> &'static str {
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

/// Explanations of a word in Markdown; its meaning in `block` comes first.
pub fn explain(word: &str, block: &str) -> Vec<String> {
    let mut out = vec![];
    let mut add = |text: String, first: bool| {
        if !out.contains(&text) {
            out.insert(if first { 0 } else { out.len() }, text);
        }
    };
    if let Some(word_info) = of_block(block).iter().find(|info| info.name == word) {
        let place = if block.is_empty() { String::new() } else { format!("in `{block}`: ") };
        add(format!("{place}{}", describe(word_info)), true);
    }
    if let Some(spec) = FAMILIES.iter().flat_map(|family| family.specs.iter()).find(|spec| spec.name == word) {
        add(form(spec), false);
    }
    for table in BLOCKS.iter().map(|block| block.words) {
        if table.name == word {
            add(format!("`{word} {{ … }}`: {}", table.summary), false);
        }
        for row in table.words.iter().filter(|row| row.name == word && table.name != block) {
            add(format!("in `{}`: {}", table.name, describe(&row.into())), false);
        }
    }
    for row in interpreter::COLOR_WORDS.iter().chain(TRANSFORMS).filter(|row| row.name == word) {
        add(describe(&row.into()), false);
    }
    if let Some((usage, summary)) = function(word) {
        add(format!("`{usage}`: {summary}"), false);
    }
    for (_, what) in CONSTANTS.iter().filter(|(name, _)| *name == word) {
        add((*what).to_string(), false);
    }
    if out.is_empty() {
        out.extend(ELSEWHERE.iter().filter(|(name, _)| *name == word).map(|(_, place)| plain(place)));
    }
    out
}

/// Removes links, which lead to pages of the manual.
fn plain(markdown: &str) -> String {
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

fn describe(info: &WordInfo) -> String {
    let takes = if info.kind == ValueKind::Nothing { String::new() } else { format!(" (takes {})", kind(info.kind)) };
    let default = if info.default.is_empty() { String::new() } else { format!(" Default: {}.", info.default) };
    format!("{}{takes}.{default}", info.summary)
}

/// Syntax of a shape, a pattern and the like: `box { corner_1, corner_2 … }`.
pub fn form(spec: &Spec) -> String {
    let params: Vec<_> = spec.params.iter().map(|param| param.name).collect();
    let is_shape = shape(spec.name).is_some();
    let usage = match (is_shape, params.is_empty()) {
        (true, true) => format!("{} {{ … }}", spec.name),
        (true, false) => format!("{} {{ {} … }}", spec.name, params.join(", ")),
        (false, true) => spec.name.to_string(),
        (false, false) => format!("{} {}", spec.name, params.join(", ")),
    };
    format!("`{usage}`: {}", spec.summary)
}

/// Returns the syntax and description of a built-in function.
pub fn function(name: &str) -> Option<(String, &'static str)> {
    functions().find(|(other, ..)| *other == name).map(|(name, usage, summary)| (format!("{name}{usage}"), summary))
}

/// All functions: name, arguments in parentheses, description.
pub fn functions() -> impl Iterator<Item = (&'static str, &'static str, &'static str)> {
    let numbers = numeric::TABLE.iter().map(|row| {
        let usage = match row.kernel {
            Kernel::One(_) => "(A)",
            Kernel::Two(_) => "(A, B)",
            Kernel::Many(_) => "(A, B, …)",
        };
        (row.name, usage, row.summary)
    });
    numbers.chain(interpreter::functions())
}

/// Returns the syntax and description of a directive.
pub fn of_directive(text: &str) -> Option<(&'static str, &'static str)> {
    let word = directive(text);
    let row = interpreter::directives::TABLE.iter().find(|row| row.names.contains(&word))?;
    Some((row.form, row.summary))
}

/// The name of the block around a byte; empty outside of all blocks.
pub fn block_at(scan: &Scan, offset: usize) -> &str {
    scan.around(offset, |pair| pair.open == b'{').map_or("", |pair| pair.name.as_str())
}
