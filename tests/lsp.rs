//! The language server over the wire, as an editor speaks with it.

#![allow(clippy::unwrap_used)]

use serde_json::{Value, json};
use std::collections::HashMap;
use std::io::{BufRead, BufReader, Read, Write};
use std::path::Path;
use std::process::{Child, ChildStdin, Command, Stdio};
use std::sync::mpsc::{Receiver, channel};
use std::time::{Duration, Instant};

/// Whoever takes longer hangs.
const PATIENCE: Duration = Duration::from_secs(30);

/// An editor with a server at its other end.
struct Editor {
    child: Child,
    stdin: ChildStdin,
    messages: Receiver<Value>,
    next: i64,
    /// What was told last, by address.
    told: HashMap<String, Value>,
    /// What was to be shown, and has not been asked for.
    shown: Vec<String>,
    place: tempfile::TempDir,
}

fn read_all(stdout: impl Read, mut take: impl FnMut(Value) -> bool) {
    let mut reader = BufReader::new(stdout);
    loop {
        let mut length = 0;
        loop {
            let mut line = String::new();
            if reader.read_line(&mut line).unwrap_or(0) == 0 {
                return;
            }
            if line.trim().is_empty() {
                break;
            }
            if let Some(number) = line.to_lowercase().strip_prefix("content-length:") {
                length = number.trim().parse().unwrap();
            }
        }
        let mut body = vec![0; length];
        if reader.read_exact(&mut body).is_err() || !take(serde_json::from_slice(&body).unwrap()) {
            return;
        }
    }
}

impl Editor {
    fn new() -> Self {
        let place = tempfile::tempdir().unwrap();
        let mut child = Command::new(env!("CARGO_BIN_EXE_durer"))
            .arg("lsp")
            .env("DURER_MANUAL", concat!(env!("CARGO_MANIFEST_DIR"), "/docs/src"))
            .current_dir(place.path())
            .stdin(Stdio::piped())
            .stdout(Stdio::piped())
            .spawn()
            .unwrap();
        let (sender, messages) = channel();
        let stdout = child.stdout.take().unwrap();
        std::thread::spawn(move || read_all(stdout, |message| sender.send(message).is_ok()));
        let stdin = child.stdin.take().unwrap();
        let mut editor = Self { child, stdin, messages, next: 0, told: HashMap::new(), shown: vec![], place };
        let told = editor.ask("initialize", json!({"capabilities": {}, "processId": null, "rootUri": null}));
        assert_eq!(told["capabilities"]["positionEncoding"], "utf-16");
        editor.say("initialized", json!({}));
        editor
    }

    fn send(&mut self, message: &Value) {
        let body = message.to_string();
        write!(self.stdin, "Content-Length: {}\r\n\r\n{body}", body.len()).unwrap();
        self.stdin.flush().unwrap();
    }

    fn say(&mut self, method: &str, params: Value) {
        self.send(&json!({"jsonrpc": "2.0", "method": method, "params": params}));
    }

    /// The next message; notices are kept.
    fn take(&mut self, patience: Duration) -> Option<Value> {
        let message = self.messages.recv_timeout(patience).ok()?;
        if message["method"] == "textDocument/publishDiagnostics" {
            let uri = message["params"]["uri"].as_str().unwrap().to_string();
            self.told.insert(uri, message["params"].clone());
        }
        if message["method"] == "window/showDocument" {
            self.shown.push(message["params"]["uri"].as_str().unwrap().to_string());
        }
        Some(message)
    }

    /// Waits until something is to be shown.
    fn shown(&mut self) -> String {
        while self.shown.is_empty() {
            self.take(PATIENCE).expect("nothing is shown");
        }
        self.shown.remove(0)
    }

    fn answer(&mut self, method: &str, params: Value) -> Value {
        self.next += 1;
        let id = self.next;
        self.send(&json!({"jsonrpc": "2.0", "id": id, "method": method, "params": params}));
        loop {
            let message = self.take(PATIENCE).expect("no answer");
            if message["id"] == id {
                return message;
            }
        }
    }

    #[track_caller]
    fn ask(&mut self, method: &str, params: Value) -> Value {
        let answer = self.answer(method, params);
        assert!(answer["error"].is_null(), "{method}: {answer}");
        answer["result"].clone()
    }

    fn uri(&self, name: &str) -> String {
        format!("file://{}", self.place.path().canonicalize().unwrap().join(name).display())
    }

    fn open(&mut self, name: &str, text: &str) -> String {
        let uri = self.uri(name);
        let document = json!({"uri": uri, "languageId": "povray", "version": 1, "text": text});
        self.say("textDocument/didOpen", json!({"textDocument": document}));
        uri
    }

    fn put(&self, name: &str, text: &str) {
        std::fs::write(self.place.path().join(name), text).unwrap();
    }

    /// One change: a range as four numbers, and what takes its place.
    fn change(&mut self, uri: &str, version: i64, [a, b, c, d]: [u64; 4], text: &str) {
        let range = json!({"start": {"line": a, "character": b}, "end": {"line": c, "character": d}});
        let changes = json!([{"range": range, "text": text}]);
        self.say(
            "textDocument/didChange",
            json!({"textDocument": {"uri": uri, "version": version}, "contentChanges": changes}),
        );
    }

    /// Waits until what is told of a text is so.
    #[track_caller]
    fn until(&mut self, uri: &str, holds: impl Fn(&[Value]) -> bool) -> Vec<Value> {
        let start = Instant::now();
        loop {
            let told = self.told.get(uri).and_then(|told| told["diagnostics"].as_array().cloned());
            match told {
                Some(told) if holds(&told) => return told,
                _ => assert!(self.take(PATIENCE).is_some() && start.elapsed() < PATIENCE, "{:?}", self.told.get(uri)),
            }
        }
    }

    fn bye(mut self) {
        self.ask("shutdown", Value::Null);
        self.say("exit", Value::Null);
        assert_eq!(self.child.wait().unwrap().code(), Some(0));
    }
}

fn at(uri: &str, line: u64, character: u64) -> Value {
    json!({"textDocument": {"uri": uri}, "position": {"line": line, "character": character}})
}

fn codes(told: &[Value]) -> Vec<&str> {
    told.iter().map(|one| one["code"].as_str().unwrap()).collect()
}

const HALL: &str = "#version 3.7;
#include \"parts.inc\"
// How far apart
#declare Gap = 2.5;
#macro Row(Count, Thing)
  #local Shift = 0.5;
  #for (I, 1, Count)
    object { Thing translate <I * Gap + Shift, 0, 0> }
  #end
#end
camera { location <0, 1, -9> look_at 0 }
light_source { <2, 5, -5> rgb 1 }
Row(3, Ball)
sphere { <0, 2, 0>, 1 pigment { rgb <1, 0, 0> } }
";
const PARTS: &str = "#declare Ball = sphere { 0, 1 pigment { srgb <1, 0.5, 0> } }\n#declare Shift = 3;\n";

fn hall() -> (Editor, String) {
    let mut editor = Editor::new();
    editor.put("parts.inc", PARTS);
    let uri = editor.open("hall.pov", HALL);
    (editor, uri)
}

#[test]
fn faults_are_told_at_once_and_what_a_run_finds_a_little_later() {
    let (mut editor, uri) = hall();
    editor.until(&uri, <[Value]>::is_empty);
    // A word that is no block, and a string that is not closed.
    editor.change(&uri, 2, [13, 0, 13, 6], "spere");
    let told = editor.until(&uri, |told| codes(told).contains(&"E0204"));
    assert_eq!(told[0]["range"], json!({"start": {"line": 13, "character": 0}, "end": {"line": 13, "character": 5}}));
    assert!(told[0]["message"].as_str().unwrap().contains("did you mean `sphere`?"), "{told:?}");
    let actions = editor.ask(
        "textDocument/codeAction",
        json!({"textDocument": {"uri": uri}, "range": told[0]["range"], "context": {"diagnostics": told}}),
    );
    assert_eq!(actions[0]["edit"]["changes"][&uri][0]["newText"], "sphere");
    // Lines above move what was found.
    editor.change(&uri, 3, [0, 0, 0, 0], "// two\n// lines\n");
    let told = editor.until(&uri, |told| told.first().is_some_and(|one| one["range"]["start"]["line"] == 15));
    assert_eq!(codes(&told), ["E0204"]);
    editor.change(&uri, 4, [15, 0, 15, 5], "#if (1) sphere");
    let told = editor.until(&uri, |told| codes(told).contains(&"E0101"));
    assert_eq!(codes(&told), ["E0101"]);
    editor.change(&uri, 5, [15, 0, 15, 8], "");
    editor.until(&uri, <[Value]>::is_empty);
    editor.bye();
}

#[test]
fn names_that_nobody_uses_are_faint() {
    let (mut editor, uri) = hall();
    editor.change(&uri, 2, [2, 0, 2, 0], "#declare Nobody = 1;\n");
    let told = editor.until(&uri, |told| codes(told) == ["W0209"]);
    assert_eq!((&told[0]["severity"], &told[0]["tags"]), (&json!(4), &json!([1])));
    editor.bye();
}

#[test]
fn a_run_that_never_ends_is_stopped_by_the_next_key() {
    let mut editor = Editor::new();
    let uri = editor.open("loop.pov", "#while (1) #end\n");
    std::thread::sleep(Duration::from_millis(600));
    editor.change(&uri, 2, [0, 0, 0, 15], "sphre { 0, 1 }");
    let start = Instant::now();
    editor.until(&uri, |told| codes(told) == ["E0204"]);
    assert!(start.elapsed() < Duration::from_secs(10));
    editor.bye();
}

#[test]
fn includes_are_seen_as_they_are_typed() {
    let (mut editor, uri) = hall();
    editor.until(&uri, <[Value]>::is_empty);
    let parts = editor.open("parts.inc", PARTS);
    editor.change(&parts, 2, [0, 9, 0, 13], "Boll");
    editor.until(&uri, |told| codes(told).contains(&"E0203"));
    editor.change(&parts, 3, [0, 9, 0, 13], "Ball");
    editor.until(&uri, <[Value]>::is_empty);
    // What a run finds in a file that is included is told there.
    editor.change(&parts, 4, [1, 0, 1, 0], "#declare A = 1 + Nowhere;\n");
    editor.until(&parts, |told| codes(told).contains(&"E0203"));
    editor.bye();
}

#[test]
fn names_are_found_across_includes_and_renamed() {
    let (mut editor, uri) = hall();
    let parts = editor.uri("parts.inc");
    let found = editor.ask("textDocument/definition", at(&uri, 12, 8));
    assert_eq!((&found[0]["uri"], &found[0]["range"]["start"]["character"]), (&json!(parts), &json!(9)));
    let found = editor.ask("textDocument/definition", at(&uri, 1, 12));
    assert_eq!(found["uri"], json!(parts));
    let mut params = at(&uri, 3, 10);
    params["context"] = json!({"includeDeclaration": true});
    assert_eq!(editor.ask("textDocument/references", params).as_array().unwrap().len(), 2);
    // The macro's own `Shift` is not that of the other file.
    let mut params = at(&uri, 7, 41);
    params["newName"] = json!("Step");
    let edit = editor.ask("textDocument/rename", params.clone());
    let lines: Vec<_> =
        edit["changes"][&uri].as_array().unwrap().iter().map(|e| e["range"]["start"]["line"].clone()).collect();
    assert_eq!((lines, edit["changes"].as_object().unwrap().len()), (vec![json!(5), json!(7)], 1));
    let mut ball = at(&uri, 12, 8);
    ball["newName"] = json!("Marble");
    assert_eq!(editor.ask("textDocument/rename", ball)["changes"].as_object().unwrap().len(), 2);
    for bad in ["sphere", "2x", "a b", "", "Gap"] {
        params["newName"] = json!(bad);
        let refused = editor.answer("textDocument/rename", params.clone());
        assert!(
            refused["error"]["message"].as_str().is_some_and(|text| text.contains(&format!("`{bad}`"))),
            "{refused}"
        );
    }
    assert_eq!(editor.ask("textDocument/documentHighlight", at(&uri, 6, 8)).as_array().unwrap().len(), 2);
    assert_eq!(editor.ask("textDocument/prepareRename", at(&uri, 3, 10))["start"]["character"], 9);
    assert!(editor.ask("textDocument/prepareRename", at(&uri, 13, 2)).is_null());
    editor.bye();
}

fn labels(list: &Value) -> Vec<&str> {
    list["items"].as_array().unwrap().iter().map(|item| item["label"].as_str().unwrap()).collect()
}

#[test]
fn what_may_be_typed() {
    let (mut editor, uri) = hall();
    let outside = editor.ask("textDocument/completion", at(&uri, 12, 0));
    for word in ["sphere", "camera", "Ball", "Row", "Gap", "sin", "pi"] {
        assert!(labels(&outside).contains(&word), "{word}");
    }
    let row = outside["items"].as_array().unwrap().iter().find(|item| item["label"] == "Row").unwrap();
    assert_eq!(row["insertText"], "Row(${1:Count}, ${2:Thing})");
    let camera = editor.ask("textDocument/completion", at(&uri, 10, 9));
    assert!(labels(&camera).contains(&"look_at") && !labels(&camera).contains(&"sphere"));
    let inside = editor.ask("textDocument/completion", at(&uri, 7, 4));
    assert!(["Shift", "Count", "I"].iter().all(|name| labels(&inside).contains(name)), "{:?}", labels(&inside));
    editor.change(&uri, 2, [12, 0, 12, 0], "#\nT_Woo\n#include \"pa\n");
    assert!(labels(&editor.ask("textDocument/completion", at(&uri, 12, 1))).contains(&"declare"));
    let wood = editor.ask("textDocument/completion", at(&uri, 13, 5));
    let item = wood["items"].as_array().unwrap().iter().find(|item| item["label"] == "T_Wood1").unwrap();
    assert_eq!(item["additionalTextEdits"][0]["newText"], "#include \"woods.inc\"\n");
    assert_eq!(item["additionalTextEdits"][0]["range"]["start"], json!({"line": 2, "character": 0}));
    assert!(labels(&editor.ask("textDocument/completion", at(&uri, 14, 12))).contains(&"parts.inc"));
    assert!(editor.ask("textDocument/completion", at(&uri, 2, 10)).is_null());
    editor.bye();
}

#[test]
fn what_words_and_names_are() {
    let (mut editor, uri) = hall();
    let mut about = |line, character| {
        editor.ask("textDocument/hover", at(&uri, line, character))["contents"]["value"]
            .as_str()
            .unwrap_or("")
            .to_string()
    };
    let gap = about(7, 34);
    assert!(gap.contains("// How far apart\n#declare Gap = 2.5;") && gap.contains("hall.pov, line 4"), "{gap}");
    assert!(about(12, 1).contains("#macro Row(Count, Thing)"));
    assert!(about(12, 8).contains("parts.inc, line 1"));
    assert!(about(13, 2).contains("sphere { center, radius"), "{}", about(13, 2));
    let sphere = about(13, 2);
    let picture = sphere.split("![sphere](file://").nth(1).and_then(|rest| rest.split(')').next()).unwrap();
    assert!(Path::new(&picture.replace("%20", " ")).is_file(), "{picture}");
    assert!(about(10, 30).contains("in `camera`"), "{}", about(10, 30));
    assert!(about(6, 4).contains("#for"));
    assert_eq!(about(2, 5), "");
    let help = editor.ask("textDocument/signatureHelp", at(&uri, 12, 7));
    assert_eq!((&help["signatures"][0]["label"], &help["activeParameter"]), (&json!("Row(Count, Thing)"), &json!(1)));
    editor.bye();
}

#[test]
fn the_shape_of_a_text() {
    let (mut editor, uri) = hall();
    let document = json!({"textDocument": {"uri": uri}});
    let symbols = editor.ask("textDocument/documentSymbol", document.clone());
    let names: Vec<_> = symbols.as_array().unwrap().iter().map(|one| one["name"].as_str().unwrap()).collect();
    assert_eq!(names, ["Gap", "Row", "camera", "light_source", "sphere"]);
    let found = editor.ask("workspace/symbol", json!({"query": "bal"}));
    assert_eq!(found[0]["location"]["uri"], json!(editor.uri("parts.inc")));
    let folds = editor.ask("textDocument/foldingRange", document.clone());
    assert_eq!(folds[0], json!({"startLine": 4, "endLine": 8, "kind": "region"}));
    let selection = editor.ask(
        "textDocument/selectionRange",
        json!({"textDocument": {"uri": uri}, "positions": [{"line": 13, "character": 41}]}),
    );
    assert_eq!(selection[0]["parent"]["range"]["start"]["line"], 13);
    let tokens = editor.ask("textDocument/semanticTokens/full", document.clone());
    assert!(tokens["data"].as_array().unwrap().len() % 5 == 0 && tokens["data"][0] == 0);
    let colors = editor.ask("textDocument/documentColor", document);
    assert_eq!(colors[0]["color"], json!({"red": 1.0, "green": 0.0, "blue": 0.0, "alpha": 1.0}));
    let mut params = json!({"textDocument": {"uri": uri}, "range": colors[0]["range"]});
    params["color"] = json!({"red": 1.0, "green": 1.0, "blue": 0.0, "alpha": 1.0});
    let offered = editor.ask("textDocument/colorPresentation", params);
    assert_eq!((&offered[0]["label"], &offered[1]["label"]), (&json!("rgb <1, 1, 0>"), &json!("srgb <1, 1, 0>")));
    let all = json!({"start": {"line": 0, "character": 0}, "end": {"line": 99, "character": 0}});
    let hints = editor.ask("textDocument/inlayHint", json!({"textDocument": {"uri": uri}, "range": all}));
    let hints: Vec<_> = hints.as_array().unwrap().iter().map(|one| one["label"].as_str().unwrap()).collect();
    assert_eq!(hints, ["Count:", "Thing:"]);
    editor.bye();
}

/// Applies edits to a text, the last one first.
fn apply(text: &str, edits: &Value) -> String {
    let mut lines: Vec<String> = text.split_inclusive('\n').map(String::from).collect();
    for edit in edits.as_array().unwrap().iter().rev() {
        let line = |end: &str| edit["range"][end]["line"].as_u64().unwrap() as usize;
        assert_eq!(edit["range"]["start"]["character"], 0);
        let to = if edit["range"]["end"]["character"] == 0 { line("end") } else { lines.len() };
        lines.splice(line("start")..to, [edit["newText"].as_str().unwrap().to_string()]);
    }
    lines.concat()
}

#[test]
fn texts_are_formatted() {
    let mut editor = Editor::new();
    for ugly in [
        "sphere{0,1}\n\n\n\nbox   {0,1\n pigment{rgb 1}}\n// end",
        "sphere{0,1}",
        "",
        "#if(1)\r\nsphere{0,1}\r\n#end\r\n",
    ] {
        let uri = editor.open("ugly.pov", ugly);
        let options = json!({"tabSize": 2, "insertSpaces": true});
        let edits = editor.ask("textDocument/formatting", json!({"textDocument": {"uri": uri}, "options": options}));
        let wanted = durer::format::format(&ugly.replace("\r\n", "\n"), 0, durer::format::WIDTH).unwrap();
        let wanted = if ugly.contains('\r') { wanted.replace('\n', "\r\n") } else { wanted };
        assert_eq!(apply(ugly, &edits), wanted);
    }
    let uri = editor.open("broken.pov", "sphere { \"");
    let options = json!({"tabSize": 2, "insertSpaces": true});
    assert!(editor.ask("textDocument/formatting", json!({"textDocument": {"uri": uri}, "options": options})).is_null());
    editor.bye();
}

/// A simple generator of numbers.
fn number(seed: &mut u64, below: u64) -> u64 {
    *seed = seed.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
    (*seed >> 33) % below.max(1)
}

/// A text as an editor keeps it: lines, and places in UTF-16.
struct Copy(Vec<u16>);

impl Copy {
    fn of(text: &str) -> Self {
        Self(text.encode_utf16().collect())
    }

    /// Where a line begins, and how long it is.
    fn line(&self, line: u64) -> (usize, usize) {
        let mut lines = self.0.split(|unit| *unit == u16::from(b'\n'));
        let before: usize = lines.by_ref().take(line as usize).map(|line| line.len() + 1).sum();
        (before, lines.next().map_or(0, <[u16]>::len))
    }

    fn lines(&self) -> u64 {
        self.0.iter().filter(|unit| **unit == u16::from(b'\n')).count() as u64 + 1
    }

    /// Does a place stand inside of one character?
    fn splits(&self, at: usize) -> bool {
        at > 0 && at < self.0.len() && (0xDC00..0xE000).contains(&self.0[at])
    }

    fn text(&self) -> String {
        String::from_utf16(&self.0).unwrap()
    }
}

/// All that an editor may ask of a place, or of a text.
const OF_PLACES: [&str; 5] = ["hover", "completion", "definition", "signatureHelp", "documentHighlight"];
const OF_TEXTS: [&str; 7] =
    ["documentSymbol", "foldingRange", "semanticTokens/full", "documentColor", "formatting", "codeLens", "inlayHint"];

impl Editor {
    /// Types something over a part of a line, and asks this and that; sometimes whether the server's text is still ours.
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

    /// The colours of its words are at the places where another server that is given our text whole sees them.
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

/// Keys, one at a time: all of a text forwards, all over it, and all of it away from its end. At the end nothing is told that isn't so.
#[test]
fn typing_leaves_nothing_behind() {
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
    // Backwards.
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

/// A text of ASCII after edits that don't touch each other.
fn edited(text: &str, edits: &Value) -> String {
    let offset = |at: &Value| {
        let line = at["line"].as_u64().unwrap() as usize;
        text.split_inclusive('\n').take(line).map(str::len).sum::<usize>() + at["character"].as_u64().unwrap() as usize
    };
    let range = |edit: &Value| offset(&edit["range"]["start"])..offset(&edit["range"]["end"]);
    let mut all: Vec<_> =
        edits.as_array().unwrap().iter().map(|edit| (range(edit), edit["newText"].as_str().unwrap())).collect();
    all.sort_by_key(|(range, _)| std::cmp::Reverse(range.start));
    let mut out = text.to_string();
    all.into_iter().for_each(|(range, new)| out.replace_range(range, new));
    out
}

/// The first action of this title.
fn action<'a>(actions: &'a Value, title: &str) -> &'a Value {
    let all = actions.as_array().unwrap();
    all.iter().find(|one| one["title"] == title).unwrap_or_else(|| panic!("{title}: {actions}"))
}

#[test]
fn help_is_done() {
    let mut editor = Editor::new();
    let text = "#version 3.7;\ncamera { location -5*z look_at 0 }\n#declare Ball = sphere { 0, 1 }\n#declare Oak = texture { pigment { rgb 1 } }\n#declare Far = 2\n\
                Ball { translate Far * x }\nsphere { 0, 1 Oak }\n";
    let mended = text
        .replace("Far = 2\n", "Far = 2;\n")
        .replace("Ball {", "object { Ball")
        .replace("1 Oak", "1 texture { Oak }");
    let uri = editor.open("a.pov", text);
    let told = editor.until(&uri, |told| codes(told).contains(&"E0204"));
    let ask = |editor: &mut Editor, told: &[Value]| {
        let all = json!({"start": {"line": 0, "character": 0}, "end": {"line": 9, "character": 0}});
        editor.ask(
            "textDocument/codeAction",
            json!({"textDocument": {"uri": uri}, "range": all, "context": {"diagnostics": told}}),
        )
    };
    let actions = ask(&mut editor, &told);
    let text = edited(text, &action(&actions, "Write `object { Ball … }`")["edit"]["changes"][&uri]);
    assert!(text.contains("object { Ball translate Far * x }"), "{text}");
    assert_eq!(action(&actions, "Explain E0204")["command"]["command"], "durer.explain");
    let all = json!([{"text": text}]);
    editor.say("textDocument/didChange", json!({"textDocument": {"uri": uri, "version": 2}, "contentChanges": all}));
    let told = editor.until(&uri, |told| codes(told).iter().filter(|code| **code == "W0420").count() == 2);
    let actions = ask(&mut editor, &told);
    let text = edited(&text, &action(&actions, "Write `texture { Oak }`")["edit"]["changes"][&uri]);
    let text = edited(&text, &action(&actions, "Write `;`")["edit"]["changes"][&uri]);
    assert_eq!(text, mended);
    editor.ask("workspace/executeCommand", json!({"command": "durer.explain", "arguments": ["E0204"]}));
    editor.bye();
}

/// What is offered for a text, and the text after the first offer.
fn offered(editor: &mut Editor, name: &str, text: &str) -> (Vec<String>, String) {
    let uri = editor.open(name, text);
    let told = editor.until(&uri, |told| !told.is_empty());
    let actions = editor.ask(
        "textDocument/codeAction",
        json!({"textDocument": {"uri": uri}, "range": told[0]["range"], "context": {"diagnostics": told}}),
    );
    let titles = actions.as_array().unwrap().iter().map(|one| one["title"].as_str().unwrap().to_string()).collect();
    let edits = &actions[0]["edit"]["changes"][&uri];
    assert!(edits.is_array(), "{told:?}\n{actions}");
    editor.say("textDocument/didClose", json!({"textDocument": {"uri": uri}}));
    (titles, edited(text, edits))
}

#[test]
fn more_help_is_done() {
    let mut editor = Editor::new();
    let tail = "camera { location -5*z look_at 0 }\nlight_source { -9, 1 }\n";
    for (i, (text, wanted)) in [
        ("#declare Ball = sphere { 0, 1 };\nBall translate 2*x\n", "object { Ball translate 2*x }\n"),
        ("Size = 3;\n", "#declare Size = 3;\n"),
        ("#set Size = 3;\n", "#declare Size = 3;\n"),
        ("sphere { 0, 1 pigmant { rgb 1 } }\n", "sphere { 0, 1 pigment { rgb 1 } }\n"),
        ("sphere { 0, 1 pigment { Red } }\n", "#include \"colors.inc\"\nsphere { 0, 1 pigment { Red } }\n"),
    ]
    .into_iter()
    .enumerate()
    {
        let (titles, after) = offered(&mut editor, &format!("help{i}.pov"), &format!("{text}{tail}"));
        assert!(after.ends_with(&format!("{wanted}{tail}")), "{titles:?}\n{after}");
    }
    let (_, after) = offered(&mut editor, "open.pov", "sphere { 0, 1");
    assert_eq!(after, "sphere { 0, 1\n}");
    let (_, after) = offered(&mut editor, "blind.pov", "// Mine\nsphere { 0, 1 }\nlight_source { -9, 1 }\n");
    assert!(after.starts_with("// Mine\ncamera { location <0, 2, -5> look_at 0 }\nsphere"), "{after}");
    editor.bye();
}

#[test]
fn the_manual_is_linked_where_it_lies() {
    let mut editor = Editor::new();
    let uri = editor.open("a.pov", "spere { 0, 1 }\nsphere { 0, 1 }\n");
    let told = editor.until(&uri, |told| !told.is_empty());
    let link = told[0]["codeDescription"]["href"].as_str().unwrap();
    assert!(link.ends_with("/docs/src/reference/codes.md#e0204-a-block-does-not-take-this-word"), "{link}");
    let about = editor.ask("textDocument/hover", at(&uri, 1, 2));
    let about = about["contents"]["value"].as_str().unwrap();
    assert!(about.contains("![sphere](file:///") && about.contains("/pictures/reference/sphere.png)"), "{about}");
    editor.bye();
}

#[test]
fn what_does_not_run_is_faint() {
    let mut editor = Editor::new();
    let text = "#version 3.7;\ncamera { location -5*z look_at 0 }\n#declare Big = false;\n#if (Big)\n  sphere { 0, 2 }\n#else\n  sphere { 0, 1 }\n#end\n\
                #for (I, 0, 1) #if (I = 1) sphere { I, 1 } #else box { I, 1 } #end #end\n";
    let uri = editor.open("a.pov", text);
    let faint = |told: &[Value]| {
        told.iter()
            .filter(|one| one["tags"] == json!([1]))
            .map(|one| one["range"]["start"]["line"].as_u64().unwrap())
            .collect::<Vec<_>>()
    };
    let told = editor.until(&uri, |told| !faint(told).is_empty());
    assert_eq!(faint(&told), [4]);
    editor.change(&uri, 2, [2, 15, 2, 20], "true");
    let told = editor.until(&uri, |told| faint(told) == [6]);
    assert_eq!(told.len(), 1, "{told:?}");
    editor.bye();
}

#[test]
fn scenes_are_drawn_and_watched() {
    let mut editor = Editor::new();
    let text =
        "// A ball.\n#version 3.7;\ncamera { location -5*z look_at 0 }\nlight_source { -9*z, 1 }\nsphere { 0, 1 }\n";
    editor.put("a.pov", text);
    let uri = editor.open("a.pov", text);
    let lenses = editor.ask("textDocument/codeLens", json!({"textDocument": {"uri": uri}}));
    let titles: Vec<_> =
        lenses.as_array().unwrap().iter().map(|lens| lens["command"]["title"].as_str().unwrap()).collect();
    assert_eq!(titles, ["Render", "Watch and pick"]);
    assert_eq!(lenses[0]["range"]["start"]["line"], 1);
    let inc = editor.open("b.inc", "#declare A = 1;");
    assert!(editor.ask("textDocument/codeLens", json!({"textDocument": {"uri": inc}})).is_null());
    let run = |editor: &mut Editor, lens: &Value| {
        let command = &lens["command"];
        editor
            .ask("workspace/executeCommand", json!({"command": command["command"], "arguments": command["arguments"]}));
    };
    run(&mut editor, &lenses[0]);
    assert!(editor.shown().ends_with("/a.png"));
    assert!(editor.place.path().join("a.png").metadata().unwrap().len() > 100);
    run(&mut editor, &lenses[1]);
    let first = editor.shown();
    assert!(first.starts_with("http://127.0.0.1:"), "{first}");
    // A scene has one page, and it ends with the server.
    run(&mut editor, &lenses[1]);
    assert_eq!(editor.shown(), first);
    let host = first["http://".len()..].split('/').next().unwrap().to_string();
    assert!(std::net::TcpStream::connect(&host).is_ok());
    editor.bye();
    assert!(std::net::TcpStream::connect(&host).is_err());
}

#[test]
fn what_is_not_understood() {
    let mut editor = Editor::new();
    let nowhere = editor.uri("nowhere.pov");
    assert!(editor.answer("textDocument/hover", json!({"wrong": 1}))["error"]["code"].is_i64());
    assert!(editor.answer("textDocument/unheardOf", json!({}))["error"]["code"].is_i64());
    assert!(editor.ask("textDocument/hover", at(&nowhere, 3, 4)).is_null());
    editor.change(&nowhere, 3, [0, 0, 0, 0], "text");
    editor.say("textDocument/didChange", json!({"nonsense": true}));
    let deep = "union{".repeat(20_000);
    let uri = editor.open("deep.pov", &deep);
    editor.until(&uri, |told| codes(told).contains(&"E0104"));
    // A text that lies nowhere.
    let document = json!({"uri": "untitled:Untitled-1", "languageId": "povray", "version": 1, "text": "spere { }"});
    editor.say("textDocument/didOpen", json!({"textDocument": document}));
    editor.until("untitled:Untitled-1", |told| codes(told).contains(&"E0204"));
    editor.say("textDocument/didClose", json!({"textDocument": {"uri": "untitled:Untitled-1"}}));
    editor.until("untitled:Untitled-1", <[Value]>::is_empty);
    assert!(Path::new(&editor.place.path().join("nowhere.pov")).metadata().is_err());
    editor.bye();
}
