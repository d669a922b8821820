//! The table of POV-Ray's quirks (`src/quirks/`): every row is cited where it is obeyed and proven by POV-Ray's own numbers.

use durer::quirks::{Quirk, Status, TOPICS};
use std::collections::BTreeSet;
use std::path::{Path, PathBuf};

const ROOT: &str = env!("CARGO_MANIFEST_DIR");

fn quirks() -> impl Iterator<Item = &'static Quirk> {
    TOPICS.iter().flat_map(|topic| topic.quirks)
}

fn sources(folder: &Path, found: &mut Vec<(PathBuf, String)>) {
    for entry in std::fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        if path.is_dir() {
            sources(&path, found);
        } else if path.extension().is_some_and(|e| e == "rs") {
            let text = std::fs::read_to_string(&path).unwrap();
            found.push((path, text));
        }
    }
}

/// Every source file of the program except the tables.
fn code() -> Vec<(PathBuf, String)> {
    let mut found = vec![];
    sources(&Path::new(ROOT).join("src"), &mut found);
    found.retain(|(path, _)| !path.starts_with(Path::new(ROOT).join("src/quirks")));
    found
}

/// The ids after `quirk: ` in a line; several may follow, with commas.
fn cited(line: &str) -> Vec<&str> {
    let is_id = |c: char| c.is_ascii_lowercase() || c.is_ascii_digit() || c == '_';
    let mut ids = vec![];
    for (at, found) in line.match_indices("quirk: ") {
        let mut rest = &line[at + found.len()..];
        loop {
            rest = rest.trim_start_matches('`');
            let end = rest.find(|c| !is_id(c)).unwrap_or(rest.len());
            if end > 0 {
                ids.push(&rest[..end]);
            }
            rest = rest[end..].trim_start_matches('`');
            // Further ids follow in backticks, or are recognised by an underscore.
            let next = rest.strip_prefix(", `").or_else(|| rest.strip_prefix(", "));
            let is_next = |next: &&str| {
                rest.starts_with(", `") || next.split(|c| !is_id(c)).next().is_some_and(|id| id.contains('_'))
            };
            match next.filter(is_next) {
                Some(next) => rest = next,
                None => break,
            }
        }
    }
    ids
}

/// The text with each comment of several lines on one line, since a citation may be wrapped.
fn joined_comments(text: &str) -> String {
    let mut joined = String::new();
    for line in text.lines() {
        let comment = line.trim_start().strip_prefix("//").map(|rest| rest.trim_start_matches(['/', '!']).trim_start());
        match comment {
            Some(rest) if !rest.is_empty() => joined += &format!("{rest} "),
            _ => joined.push('\n'),
        }
    }
    joined
}

#[test]
fn ids_are_in_order_and_summaries_are_sentences() {
    for topic in TOPICS {
        let ids: Vec<_> = topic.quirks.iter().map(|quirk| quirk.id).collect();
        assert!(ids.is_sorted(), "{}: {ids:?}", topic.title);
    }
    let mut seen = BTreeSet::new();
    for quirk in quirks() {
        assert!(seen.insert(quirk.id), "{} twice", quirk.id);
        assert!(quirk.summary.ends_with('.') && !quirk.summary.contains("  "), "{}: {}", quirk.id, quirk.summary);
        if let Status::Differs(instead) = quirk.status {
            assert!(instead.ends_with('.'), "{}: {instead}", quirk.id);
        }
    }
}

#[test]
fn emulated_quirks_are_cited_and_cited_quirks_exist() {
    let known: BTreeSet<&str> = quirks().map(|quirk| quirk.id).collect();
    let (mut found, mut faults) = (BTreeSet::new(), vec![]);
    for (path, text) in code() {
        for id in cited(&joined_comments(&text)) {
            if known.contains(id) {
                found.insert(id.to_string());
            } else {
                faults.push(format!("{}: there is no quirk `{id}`", path.display()));
            }
        }
    }
    for quirk in quirks().filter(|quirk| matches!(quirk.status, Status::Emulated)) {
        if !found.contains(quirk.id) {
            faults.push(format!("quirk `{}` is cited nowhere", quirk.id));
        }
    }
    assert!(faults.is_empty(), "\n{}", faults.join("\n"));
}

#[test]
fn all_evidence_exists() {
    let ledger = std::fs::read_to_string(Path::new(ROOT).join("tests/conformance.json")).unwrap();
    let ledger: serde_json::Value = serde_json::from_str(&ledger).unwrap();
    let exists = |evidence: &str| {
        if let Some(name) = evidence.strip_prefix("light_cases/") {
            Path::new(ROOT).join(format!("tests/light_cases/{name}.json")).exists()
        } else if let Some(scene) = evidence.strip_prefix("conformance/") {
            matches!(ledger[scene].as_str(), Some("same" | "close"))
        } else if let Some((file, function)) = evidence.split_once("::") {
            let text = std::fs::read_to_string(Path::new(ROOT).join(file)).unwrap_or_default();
            text.contains(&format!("fn {function}("))
        } else {
            evidence.starts_with("tests/") && Path::new(ROOT).join(evidence).exists()
        }
    };
    let mut faults = vec![];
    for quirk in quirks() {
        if quirk.evidence.is_empty() {
            faults.push(format!("quirk `{}` has no evidence", quirk.id));
        }
        for evidence in quirk.evidence.iter().filter(|evidence| !exists(evidence)) {
            faults.push(format!("quirk `{}`: there is no {evidence}", quirk.id));
        }
    }
    assert!(faults.is_empty(), "\n{}", faults.join("\n"));
}

#[test]
fn comments_cite_ids_and_not_measurements() {
    let mut faults = vec![];
    for (path, text) in code() {
        for comment in joined_comments(&text).lines() {
            let sources = ["measured on", "measured in", "measured)", "POV-Ray 3.7 (measured", "as was measured"];
            if sources.iter().any(|words| comment.contains(words)) && cited(comment).is_empty() {
                faults.push(format!("{}: {comment}", path.display()));
            }
        }
    }
    assert!(faults.is_empty(), "{} comments\n{}", faults.len(), faults.join("\n"));
}

#[test]
fn citations_are_found_in_comments() {
    assert_eq!(cited("// quirk: a_b"), ["a_b"]);
    assert_eq!(cited("/// Longer (quirk: `a_b`)."), ["a_b"]);
    assert_eq!(cited("/// Longer (quirk: `a_b`, `c_d`), and (quirk: `e`)"), ["a_b", "c_d", "e"]);
    assert_eq!(cited("// quirk: a_b, which is so"), ["a_b"]);
    assert_eq!(cited("// no quirk"), [""; 0]);
}
