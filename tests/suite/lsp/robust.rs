//! Invalid input, large texts and long runs.

use super::editor::{Editor, at, codes};
use serde_json::{Value, json};
use std::time::{Duration, Instant};

const HEAD: &str = "#version 3.7;\ncamera { location -5*z look_at 0 }\nlight_source { <5, 5, -5> 1 }\n";

/// Returns the next error response without identity.
fn refusal(editor: &mut Editor) -> i64 {
    loop {
        let message = editor.take(Duration::from_secs(30)).expect("no response");
        if message["id"].is_null() && message["error"].is_object() {
            return message["error"]["code"].as_i64().unwrap();
        }
    }
}

/// Asserts that the server still answers.
#[track_caller]
fn assert_alive(editor: &mut Editor, uri: &str) {
    assert!(editor.ask("textDocument/hover", at(uri, 3, 1)).is_object());
}

#[test]
fn invalid_frames_are_refused_and_the_server_goes_on() {
    let mut editor = Editor::new();
    let uri = editor.open("a.pov", &format!("{HEAD}sphere {{ 0, 1 }}\n"));
    for length in ["99999999999", "99999999999999999999999", "-5", "five", ""] {
        editor.raw(format!("Content-Length: {length}\r\n\r\n{{}}").as_bytes());
        assert_eq!(refusal(&mut editor), -32600, "{length}");
        assert_alive(&mut editor, &uri);
    }
    for header in ["\r\n", "Content-Type: text\r\n\r\n{}", "GET / HTTP/1.1\r\nHost: a\r\n\r\n", &"x".repeat(9000)] {
        editor.raw(header.as_bytes());
        assert_eq!(refusal(&mut editor), -32600, "{header}");
        assert_alive(&mut editor, &uri);
    }
    assert!(editor.resident_kb() < 200_000, "{}", editor.resident_kb());
    editor.bye();
}

#[test]
fn invalid_messages_are_refused_and_the_server_goes_on() {
    let mut editor = Editor::new();
    let uri = editor.open("a.pov", &format!("{HEAD}sphere {{ 0, 1 }}\n"));
    for (body, code) in [
        ("{", -32700),
        ("\u{0}", -32700),
        ("", -32700),
        ("[]", -32600),
        ("{}", -32600),
        ("7", -32600),
        (r#"{"jsonrpc": "2.0", "id": {}, "method": "shutdown"}"#, -32600),
    ] {
        editor.raw(format!("Content-Length: {}\r\n\r\n{body}", body.len()).as_bytes());
        assert_eq!(refusal(&mut editor), code, "{body}");
        assert_alive(&mut editor, &uri);
    }
    let code = |answer: Value| answer["error"]["code"].as_i64();
    let wrong = json!({"textDocument": {"uri": uri}, "position": "x"});
    assert_eq!(code(editor.answer("textDocument/hover", wrong)), Some(-32602));
    assert_eq!(code(editor.answer("textDocument/hover", json!([1]))), Some(-32602));
    let negative = json!({"textDocument": {"uri": uri}, "position": {"line": -1, "character": 0}});
    assert_eq!(code(editor.answer("textDocument/hover", negative)), Some(-32602));
    assert_eq!(code(editor.answer("textDocument/hover", at("file:///nowhere.pov", 0, 0))), Some(-32602));
    assert_eq!(code(editor.answer("textDocument/hover", at("not an address", 0, 0))), Some(-32602));
    assert_eq!(code(editor.answer("no/such", json!({}))), Some(-32601));
    assert_eq!(code(editor.answer("initialize", json!({"capabilities": {}}))), Some(-32600));
    assert!(editor.ask("textDocument/hover", at(&uri, 4_000_000_000, 4_000_000_000)).is_null());
    // A notification has no response: the server logs the failure.
    let logged = |editor: &mut Editor| loop {
        let message = editor.take(Duration::from_secs(30)).expect("no log");
        if message["method"] == "window/logMessage" {
            return message["params"]["message"].as_str().unwrap().to_string();
        }
    };
    editor.say("textDocument/didChange", json!({"textDocument": 5}));
    assert!(logged(&mut editor).contains("`textDocument/didChange` has invalid parameters"));
    editor.change("file:///nowhere.pov", 2, [0, 0, 0, 0], "x");
    assert!(logged(&mut editor).contains("is not open"));
    assert_alive(&mut editor, &uri);
    editor.bye();
}

#[test]
fn unusual_edits_and_addresses_are_accepted() {
    let mut editor = Editor::new();
    let uri = editor.open("a.pov", "// 😀\nsphere { 0, 1 }\n");
    // A range whose end comes first, one beyond the text, and one between the two units of a character.
    editor.change(&uri, 2, [1, 6, 1, 0], "spere");
    let told = editor.until(&uri, |told| codes(told).contains(&"E0204"));
    assert_eq!(told[0]["range"]["start"], json!({"line": 1, "character": 0}));
    editor.change(&uri, 3, [90, 0, 99, 4_000_000_000], "// end\n");
    editor.change(&uri, 4, [0, 4, 0, 4], "x");
    // JavaScript writes half of a character as an escape that is no Unicode.
    let body = format!(
        r#"{{"jsonrpc": "2.0", "method": "textDocument/didChange", "params": {{"textDocument": {{"uri": "{uri}", "version": 5}},
        "contentChanges": [{{"text": "// \ud83d\nspere {{ 0, 1 }}\n"}}]}}}}"#
    );
    editor.raw(format!("Content-Length: {}\r\n\r\n{body}", body.len()).as_bytes());
    editor.until_version(&uri, 5, |told| codes(told) == ["E0204"]);
    for address in ["untitled:Untitled-1", "vscode-notebook-cell:/a#b", "file://%ff", "x:"] {
        let document = json!({"uri": address, "languageId": "povray", "version": 1, "text": "spere { 0, 1 }\n"});
        editor.say("textDocument/didOpen", json!({"textDocument": document}));
        editor.until(address, |told| codes(told).contains(&"E0204"));
        editor.say("textDocument/didClose", json!({"textDocument": {"uri": address}}));
    }
    editor.bye();
}

#[test]
fn large_texts_are_not_checked_and_leave_no_memory() {
    let mut editor = Editor::new();
    let before = editor.resident_kb();
    let text = "sphere { <1,2,3>, 4 pigment { rgb 1 } }\n".repeat(400_000);
    let start = Instant::now();
    let uri = editor.open("large.pov", &text);
    let told = editor.until(&uri, |told| !told.is_empty());
    assert!(told[0]["message"].as_str().unwrap().starts_with("this text has 15.3 MB"), "{told:?}");
    assert!(editor.ask("textDocument/hover", at(&uri, 1, 1)).is_null());
    assert_eq!(editor.ask("textDocument/documentColor", json!({"textDocument": {"uri": uri}})), json!([]));
    let options = json!({"tabSize": 2, "insertSpaces": true});
    let refused = editor.answer("textDocument/formatting", json!({"textDocument": {"uri": uri}, "options": options}));
    assert_eq!(refused["error"]["code"], -32803);
    editor.change(&uri, 2, [5, 0, 5, 0], "// two\n");
    editor.until_version(&uri, 2, |told| told.len() == 1);
    assert!(start.elapsed() < Duration::from_secs(8), "{:?}", start.elapsed());
    editor.say("textDocument/didClose", json!({"textDocument": {"uri": uri}}));
    editor.until(&uri, <[Value]>::is_empty);
    assert!(editor.resident_kb() < before + 100_000, "{} {before}", editor.resident_kb());
    // A text that becomes long loses the results of its last run; one that becomes short has full service.
    let grown = editor.open("grown.pov", "spere { 0, 1 }\n");
    editor.until(&grown, |told| codes(told).contains(&"E0204"));
    editor.change(&grown, 2, [1, 0, 1, 0], &text);
    editor.until_version(&grown, 2, |told| told.len() == 1 && told[0]["code"].is_null());
    let uri = editor.open("large.pov", &text);
    editor.until(&uri, |told| !told.is_empty());
    editor.change(&uri, 2, [0, 0, 400_000, 0], "spere { 0, 1 }\n");
    editor.until(&uri, |told| codes(told).contains(&"E0204"));
    editor.bye();
}

/// Types into a slow scene; the number of threads stays small, and an error is reported soon.
fn type_into(scene: &str) {
    let mut editor = Editor::new();
    let uri = editor.open("slow.pov", scene);
    let idle = editor.n_threads();
    let mut most = 0;
    for version in 2..8 {
        editor.change(&uri, version, [0, 0, 0, 0], "// slow\n");
        // Every other pause is long enough for a run to begin.
        std::thread::sleep(Duration::from_millis(if version % 2 == 0 { 50 } else { 350 }));
        most = most.max(editor.n_threads());
    }
    assert!(most <= idle + 8, "{most} threads after {idle}");
    let start = Instant::now();
    editor.change(&uri, 99, [0, 0, 999_999, 0], "sphre { 0, 1 }\n");
    editor.until(&uri, |told| codes(told).contains(&"E0204"));
    assert!(start.elapsed() < Duration::from_millis(2500), "{:?}", start.elapsed());
    editor.bye();
}

#[test]
fn runs_that_are_given_up_end() {
    type_into(&format!("{HEAD}#while (1) #end\n"));
    type_into(&format!(
        "{HEAD}#declare R = seed(1);\n#declare B = blob {{ threshold 0.6\n#for (I, 1, 20000) sphere {{ <rand(R), rand(R), rand(R)>, 1, 1 }} #end }}\n\
         #declare N = 0;\n#for (I, 1, 4000) #declare T = trace(B, <I/4000, 0, -5>, z, N); #end\n"
    ));
    type_into(&format!(
        "{HEAD}#declare P = parametric {{ function {{ sin(u)*cos(v) }} function {{ sin(u)*sin(v) }} function {{ cos(u) }}\n\
         <0, 0>, <1000000, 1000000> contained_by {{ sphere {{ 0, 1.1 }} }} max_gradient 10 accuracy 1e-6 }}\n\
         #declare N = 0;\n#for (I, 1, 4000) #declare T = trace(P, <I/4000, 0, -5>, z, N); #end\n"
    ));
}

#[test]
fn requests_before_initialize_are_refused() {
    let mut editor = Editor::connect();
    let refused = editor.answer("textDocument/hover", at("file:///a.pov", 0, 0));
    assert_eq!(refused["error"]["code"], -32002);
    editor.ask("initialize", json!({"capabilities": {}}));
    editor.bye();
}

#[test]
fn the_end_of_the_input_is_reported() {
    for (input, code, text) in [
        ("", 1, "disconnected without the request `shutdown`"),
        ("Content-Length: 50\r\n\r\n{}", 5, "the input ended within a message"),
    ] {
        let (exit, errors) = Editor::run_with(input);
        assert_eq!(exit, Some(code), "{errors}");
        assert!(errors.contains(text), "{errors}");
    }
}
