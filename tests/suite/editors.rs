//! The editors' grammars and the fuzzers' dictionaries equal those generated from durer's tables. `UPDATE_EDITORS=1 cargo
//! test --test suite editors::` regenerates them. `tests/editor/` tests the grammars in the editors themselves.

mod emacs;
mod fuzz_dictionaries;
mod neovim;
mod tree_sitter;
mod vscode;

use durer::reference::words_by_kind;
use durer::syntax::word::KEYWORDS;
use std::collections::BTreeSet;
use std::path::Path;

/// Name below `editors/`, and contents.
type File = (&'static str, String);

const GENERATED: &str = "Made of durer's tables by `UPDATE_EDITORS=1 cargo test --test suite editors::`: change those.";

fn files() -> Vec<File> {
    let (by_kind, options) = (words_by_kind(), options());
    [
        vscode::files(&by_kind, &options),
        neovim::files(&by_kind, &options),
        emacs::files(&by_kind, &options),
        tree_sitter::files(&by_kind),
        fuzz_dictionaries::files(&by_kind, &options),
    ]
    .concat()
}

/// The INI names of POV-Ray's options, sorted.
fn options() -> Vec<&'static str> {
    durer::cli::ini_names().collect::<BTreeSet<_>>().into_iter().collect()
}

/// Words in several lines, none much longer than 100 characters.
fn lines(words: &[&str], separator: &str) -> Vec<String> {
    let mut out = vec![String::new()];
    for word in words {
        if out.last().is_some_and(|line| line.len() + word.len() > 100) {
            out.push(String::new());
        }
        if let Some(line) = out.last_mut() {
            *line += if line.is_empty() { "" } else { separator };
            *line += word;
        }
    }
    out
}

#[test]
fn grammars_equal_the_generated_ones() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("editors");
    for (name, text) in files() {
        let path = folder.join(name);
        if std::env::var_os("UPDATE_EDITORS").is_some() {
            std::fs::write(&path, &text).ok();
        }
        let stored = std::fs::read_to_string(&path).unwrap_or_default().replace("\r\n", "\n");
        let first = stored.lines().zip(text.lines()).find(|(a, b)| a != b);
        assert!(stored == text, "editors/{name}: {first:?} (UPDATE_EDITORS=1 takes it)");
    }
}

/// Each word has one category, and none is missing.
#[test]
fn every_word_has_one_category() {
    let by_kind = words_by_kind();
    let all = [&by_kind.objects, &by_kind.blocks, &by_kind.functions, &by_kind.constants, &by_kind.words];
    let known: BTreeSet<_> = all.iter().flat_map(|words| words.iter()).collect();
    assert_eq!(known.len(), all.iter().map(|words| words.len()).sum::<usize>());
    assert_eq!(KEYWORDS.iter().find(|word| !known.contains(word)), None);
    for word in ["sphere", "union", "blob"] {
        assert!(by_kind.objects.contains(&word), "{word}");
    }
    for word in ["pigment", "camera", "light_source", "finish", "global_settings", "color_map", "media", "warp"] {
        assert!(by_kind.blocks.contains(&word), "{word}: {:?}", by_kind.blocks);
    }
    assert!(by_kind.openers.contains(&"macro") && !by_kind.openers.contains(&"else"));
}
