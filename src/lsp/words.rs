//! What the tables of the readers tell of a word, and which words a block takes.

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

/// A word that a block takes.
pub struct Taken {
    /// As it is typed.
    pub name: &'static str,
    /// What follows it.
    pub kind: ValueKind,
    /// What it says, in one line.
    pub summary: &'static str,
    /// Where there is one.
    pub default: &'static str,
}

impl From<&WordSpec> for Taken {
    fn from(word: &WordSpec) -> Self {
        Self { name: word.name, kind: word.kind, summary: word.summary, default: word.default }
    }
}

impl From<&Spec> for Taken {
    fn from(spec: &Spec) -> Self {
        Self { name: spec.name, kind: ValueKind::Nothing, summary: spec.summary, default: "" }
    }
}

/// A shape's table.
pub fn shape(name: &str) -> Option<&'static Spec> {
    shape::SPECS.iter().find(|spec| spec.name == name).copied()
}

fn add<'a, T: 'a>(out: &mut Vec<Taken>, more: impl IntoIterator<Item = &'a T>)
where
    Taken: From<&'a T>,
{
    for taken in more.into_iter().map(Taken::from) {
        if !out.iter().any(|other| other.name == taken.name) {
            out.push(taken);
        }
    }
}

/// What a block of this name takes; the empty name is the scene outside of all blocks.
pub fn of_block(block: &str) -> Vec<Taken> {
    let mut out = vec![];
    let holds_objects =
        block.is_empty() || GROUPS.contains(&block) || matches!(block, "clipped_by" | "bounded_by" | "light_group");
    if let Some(spec) = shape(block) {
        add(&mut out, spec.words);
    }
    let named = if block.is_empty() { interpreter::STATEMENTS.block } else { block };
    for table in BLOCKS.iter().map(|block| block.words).filter(|table| table.block == named) {
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

/// In words, what is expected.
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

/// All that the tables tell of a word, in Markdown; what belongs to `block` comes first.
pub fn explain(word: &str, block: &str) -> Vec<String> {
    let mut out = vec![];
    let mut tell = |text: String, first: bool| {
        if !out.contains(&text) {
            out.insert(if first { 0 } else { out.len() }, text);
        }
    };
    if let Some(here) = of_block(block).iter().find(|taken| taken.name == word) {
        let place = if block.is_empty() { String::new() } else { format!("in `{block}`: ") };
        tell(format!("{place}{}", describe(here)), true);
    }
    if let Some(spec) = FAMILIES.iter().flat_map(|family| family.specs.iter()).find(|spec| spec.name == word) {
        tell(form(spec), false);
    }
    for table in BLOCKS.iter().map(|block| block.words) {
        if table.block == word {
            tell(format!("`{word} {{ … }}`: {}", table.summary), false);
        }
        for row in table.words.iter().filter(|row| row.name == word && table.block != block) {
            tell(format!("in `{}`: {}", table.block, describe(&row.into())), false);
        }
    }
    for row in interpreter::COLOR_WORDS.iter().chain(TRANSFORMS).filter(|row| row.name == word) {
        tell(describe(&row.into()), false);
    }
    if let Some((usage, summary)) = function(word) {
        tell(format!("`{usage}`: {summary}"), false);
    }
    for (_, what) in CONSTANTS.iter().filter(|(name, _)| *name == word) {
        tell((*what).to_string(), false);
    }
    if out.is_empty() {
        out.extend(ELSEWHERE.iter().filter(|(name, _)| *name == word).map(|(_, place)| plain(place)));
    }
    out
}

/// Without links, which lead into the manual's own pages.
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

fn describe(taken: &Taken) -> String {
    let takes = if taken.kind == ValueKind::Nothing { String::new() } else { format!(" (takes {})", kind(taken.kind)) };
    let default = if taken.default.is_empty() { String::new() } else { format!(" Default: {}.", taken.default) };
    format!("{}{takes}.{default}", taken.summary)
}

/// How a thing of a family is written: `box { corner_1, corner_2 … }`.
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

/// How a function is called, and what it gives.
pub fn function(name: &str) -> Option<(String, &'static str)> {
    functions().find(|(other, ..)| *other == name).map(|(name, usage, summary)| (format!("{name}{usage}"), summary))
}

/// All functions: name, arguments in parentheses, one line.
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

/// What a directive does: its form, and one line.
pub fn of_directive(text: &str) -> Option<(&'static str, &'static str)> {
    let word = directive(text);
    let row = interpreter::directives::TABLE.iter().find(|row| row.names.contains(&word))?;
    Some((row.form, row.summary))
}

/// The name of the block around a byte; empty outside of all blocks.
pub fn block_at(scan: &Scan, offset: usize) -> &str {
    scan.around(offset, |pair| pair.open == b'{').map_or("", |pair| pair.name.as_str())
}
