//! The reference pages of the manual (`docs/src/reference/`), generated from the tables of the readers. A test
//! compares them with the files; `UPDATE_DOCS=1 cargo test --test cases manual::` rewrites the files.

mod command;
mod functions;
mod language;
mod quirks;
mod words;

use crate::value::{Spec, ValueKind, WordSpec};

/// A generated page of the manual's reference.
#[derive(Debug)]
pub struct Page {
    /// File name of the manual page in `docs/src/reference/`.
    pub file: &'static str,
    /// Text of the manual page in Markdown.
    pub text: String,
}

/// Returns the generated pages of the manual's reference, in their order.
pub fn generated_reference_pages() -> Vec<Page> {
    let page = |file, title: &str, body: String| Page { file, text: format!("{GENERATED}\n\n# {title}\n\n{body}") };
    vec![
        page("words.md", "Every word", words::words_page()),
        page("scene.md", "A scene's blocks", language::scene_page()),
        page("shapes.md", "Shapes", language::shapes_page()),
        page("objects.md", "Objects and transforms", language::objects_page()),
        page("cameras.md", "Cameras", language::cameras_page()),
        page("lights.md", "Lights", language::lights_page()),
        page("atmosphere.md", "Sky, fog, rainbows", language::atmosphere_page()),
        page("colors.md", "Colours", language::colors_page()),
        page("pigments.md", "Pigments and patterns", language::pigments_page()),
        page("finishes.md", "Textures, finishes, interiors", language::finishes_page()),
        page("media.md", "Media", language::media_page()),
        page("photons.md", "Photons", language::photons_page()),
        page("settings.md", "Global settings", language::settings_page()),
        page("directives.md", "Directives", functions::directives_page()),
        page("functions.md", "Functions", functions::functions_page()),
        page("constants.md", "Constants", functions::constants_page()),
        page("options.md", "Commands and options", command::options_page()),
        page("codes.md", "Messages", command::codes_page()),
        page("quirks.md", "What POV-Ray 3.7 really does", quirks::quirks_page()),
    ]
}

const GENERATED: &str =
    "<!-- Made of durer's tables by `UPDATE_DOCS=1 cargo test --test cases manual::`: change those. -->";

/// Formats a table; cells may contain `|`.
fn table<const N: usize>(head: [&str; N], rows: impl IntoIterator<Item = [String; N]>) -> String {
    let line =
        |cells: &[String]| format!("| {} |\n", cells.iter().map(|c| escape_cell(c)).collect::<Vec<_>>().join(" | "));
    let head = line(&head.map(String::from)) + &"|---".repeat(N) + "|\n";
    rows.into_iter().fold(head, |text, row| text + &line(&row)) + "\n"
}

fn escape_cell(text: &str) -> String {
    text.replace('|', "\\|").replace('\n', " ")
}

fn in_backticks(text: &str) -> String {
    if text.is_empty() { String::new() } else { format!("`{text}`") }
}

/// Formats words in backticks, separated by commas.
fn list_in_backticks(words: impl IntoIterator<Item = impl AsRef<str>>) -> String {
    words.into_iter().map(|w| in_backticks(w.as_ref())).collect::<Vec<_>>().join(", ")
}

/// Describes the value that a word takes.
fn value_description(kind: ValueKind) -> &'static str {
    match kind {
        ValueKind::Nothing => "",
        ValueKind::Flag => "nothing, `on` or `off`",
        ValueKind::Float => "number",
        ValueKind::Vector2 => "vector of two",
        ValueKind::Vector => "vector",
        ValueKind::Vectors => "vectors",
        ValueKind::Color => "colour",
        ValueKind::Text => "text",
        ValueKind::Block => "block",
    }
}

/// Formats a table of words; the words in `durer_words` are marked as words that only durer has.
fn word_table(words: &[WordSpec], durer_words: &[&str]) -> String {
    let row = |w: &WordSpec| {
        let mark = if durer_words.contains(&w.name) { " *(durer's own)*" } else { "" };
        [in_backticks(w.name) + mark, value_description(w.kind).into(), w.default.into(), w.summary.into()]
    };
    table(["word", "takes", "default", ""], words.iter().map(row))
}

/// Formats the section about a block. Words in `durer_words` are marked as words that only durer has.
fn section(block: &Spec, title: &str, durer_words: &[&str]) -> String {
    let mut text =
        format!("## {title}\n\n{}.\n\n{}", capitalize_sentence(block.summary), word_table(block.words, durer_words));
    if block.has_transforms {
        text += "It takes the [transforms](objects.md#transforms) too.\n\n";
    }
    if !block.ignored.is_empty() {
        text += &format!("Read, and without effect in durer: {}.\n\n", list_in_backticks(block.ignored));
    }
    text
}

/// Capitalizes the first letter of a manual's sentence, except in the name `durer`.
fn capitalize_sentence(text: &str) -> String {
    let mut chars = text.chars();
    let first = chars.next().map(|c| c.to_uppercase().to_string()).unwrap_or_default();
    // The name `durer` is always in lower case.
    if text.starts_with("durer") { text.into() } else { first + chars.as_str() }
}
