//! Single keystrokes, with the requests that an editor sends meanwhile.

use super::editor::{Editor, at, codes};
use super::{HALL, PARTS};
use serde_json::{Value, json};
use std::time::Duration;

/// A simple random generator.
fn number(seed: &mut u64, below: u64) -> u64 {
    *seed = seed.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
    (*seed >> 33) % below.max(1)
}

/// A text as an editor stores it: lines, and positions in UTF-16.
struct Copy(Vec<u16>);

impl Copy {
    fn of(text: &str) -> Self {
        Self(text.encode_utf16().collect())
    }

    /// Start and length of a line.
    fn line(&self, line: u64) -> (usize, usize) {
        let mut lines = self.0.split(|unit| *unit == u16::from(b'\n'));
        let before: usize = lines.by_ref().take(line as usize).map(|line| line.len() + 1).sum();
        (before, lines.next().map_or(0, <[u16]>::len))
    }

    fn lines(&self) -> u64 {
        self.0.iter().filter(|unit| **unit == u16::from(b'\n')).count() as u64 + 1
    }

    /// True if a position is inside a character.
    fn splits(&self, at: usize) -> bool {
        at > 0 && at < self.0.len() && (0xDC00..0xE000).contains(&self.0[at])
    }

    fn text(&self) -> String {
        String::from_utf16(&self.0).unwrap()
    }
}

/// Requests about a position, or about a text.
const OF_PLACES: [&str; 5] = ["hover", "completion", "definition", "signatureHelp", "documentHighlight"];
const OF_TEXTS: [&str; 7] =
    ["documentSymbol", "foldingRange", "semanticTokens/full", "documentColor", "formatting", "codeLens", "inlayHint"];

impl Editor {
    /// Replaces a part of a line, and sends some requests; sometimes compares the server's text with the copy.
    fn key(&mut self, uri: &str, copy: &mut Copy, (version, seed): (i64, &mut u64), [line, a, b]: [u64; 3], key: &str) {
        let (start, length) = copy.line(line);
        let place = |character: u64| {
            let at = start + (character as usize).min(length);
            if copy.splits(at) { at - 1 } else { at }
        };
        let (from, to) = (place(a), place(b.max(a)));
        let [a, b] = [from - start, to - start].map(|at| at as u64);
        copy.0.splice(from..to, key.encode_utf16());
        self.change(uri, version, [line, a, line, b], key);
        let asked = OF_PLACES[number(seed, 5) as usize];
        self.answer(&format!("textDocument/{asked}"), at(uri, number(seed, copy.lines()), number(seed, 40)));
        let asked = OF_TEXTS[number(seed, 7) as usize];
        let whole = json!({"start": {"line": 0, "character": 0}, "end": {"line": copy.lines(), "character": 0}});
        let options = json!({"tabSize": 2, "insertSpaces": true});
        self.answer(
            &format!("textDocument/{asked}"),
            json!({"textDocument": {"uri": uri}, "options": options, "range": whole}),
        );
        if number(seed, 20) == 0 {
            self.compare(uri, copy);
        }
    }

    /// Semantic tokens are at the positions that another server reports for the whole text.
    fn compare(&mut self, uri: &str, copy: &Copy) {
        let other = self.open("copy.inc", &copy.text());
        let [ours, theirs] = [uri, other.as_str()].map(|uri| {
            let whole = json!({"textDocument": {"uri": uri}});
            ["foldingRange", "documentColor"].map(|asked| self.ask(&format!("textDocument/{asked}"), whole.clone()))
        });
        assert_eq!(ours, theirs, "{}", copy.text());
        self.say("textDocument/didClose", json!({"textDocument": {"uri": other}}));
    }
}

const KEYS: [&str; 16] =
    ["{", "}", "\"", "#end\n", "#if (1)\n", "ä😀", "/*", "*/", "\n", "(", ")", "<", "sphere", " ", "//", "#macro A(B"];

/// Types a whole text forwards, then edits at random, then deletes it from its end. No diagnostics are left at the end.
#[test]
fn typing_leaves_no_stale_state() {
    let mut editor = Editor::new();
    editor.put("parts.inc", PARTS);
    let uri = editor.open("hall.pov", "");
    let (mut copy, mut seed, mut version) = (Copy::of(""), 11, 1);
    let mut typed = (0, 0);
    for c in HALL.chars() {
        version += 1;
        let key = c.to_string();
        editor.key(&uri, &mut copy, (version, &mut seed), [typed.0, typed.1, typed.1], &key);
        typed = if c == '\n' { (typed.0 + 1, 0) } else { (typed.0, typed.1 + 1) };
    }
    assert_eq!(copy.text(), HALL);
    editor.compare(&uri, &copy);
    editor.until(&uri, <[Value]>::is_empty);
    for _ in 0..400 {
        version += 1;
        let (line, a, b) = (number(&mut seed, copy.lines()), number(&mut seed, 30), number(&mut seed, 4));
        let key = KEYS[number(&mut seed, KEYS.len() as u64) as usize];
        editor.key(&uri, &mut copy, (version, &mut seed), [line, a, a + b], key);
    }
    editor.compare(&uri, &copy);
    let all = json!([{"text": HALL}]);
    version += 1;
    editor.say(
        "textDocument/didChange",
        json!({"textDocument": {"uri": uri, "version": version}, "contentChanges": all}),
    );
    copy = Copy::of(HALL);
    std::thread::sleep(Duration::from_secs(1));
    editor.until(&uri, <[Value]>::is_empty);
    // Delete from the end.
    while let Some(last) = copy.0.last().copied() {
        version += 1;
        let line = copy.lines() - 1;
        let (start, length) = copy.line(line);
        if last == u16::from(b'\n') {
            let (before, above) = copy.line(line - 1);
            assert_eq!(before + above + 1, start);
            copy.0.pop();
            editor.change(&uri, version, [line - 1, above as u64, line, 0], "");
        } else {
            editor.key(&uri, &mut copy, (version, &mut seed), [line, length as u64 - 1, length as u64], "");
        }
    }
    editor.until(&uri, |told| codes(told).iter().all(|code| code.starts_with('W')));
    editor.bye();
}
