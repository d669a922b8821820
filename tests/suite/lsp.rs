//! The language server over its protocol.

mod editor;
mod help;
mod robust;
mod typing;

use editor::{Editor, at, codes};
use serde_json::{Value, json};
use std::path::Path;
use std::time::{Duration, Instant};

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
fn diagnostics_of_text_first_and_of_runs_later() {
    let (mut editor, uri) = hall();
    editor.until(&uri, <[Value]>::is_empty);
    // An unknown block, and a string without an end.
    editor.change(&uri, 2, [13, 0, 13, 6], "spere");
    let told = editor.until(&uri, |told| codes(told).contains(&"E0204"));
    assert_eq!(told[0]["range"], json!({"start": {"line": 13, "character": 0}, "end": {"line": 13, "character": 5}}));
    assert!(told[0]["message"].as_str().unwrap().contains("did you mean `sphere`?"), "{told:?}");
    let actions = editor.ask(
        "textDocument/codeAction",
        json!({"textDocument": {"uri": uri}, "range": told[0]["range"], "context": {"diagnostics": told}}),
    );
    assert_eq!(actions[0]["edit"]["changes"][&uri][0]["newText"], "sphere");
    // Inserted lines move the diagnostics.
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
fn unused_names_are_faded() {
    let (mut editor, uri) = hall();
    editor.change(&uri, 2, [2, 0, 2, 0], "#declare Nobody = 1;\n");
    let told = editor.until(&uri, |told| codes(told) == ["W0209"]);
    assert_eq!((&told[0]["severity"], &told[0]["tags"]), (&json!(4), &json!([1])));
    editor.bye();
}

#[test]
fn endless_runs_are_stopped_by_the_next_key() {
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
fn unsaved_includes_are_used() {
    let (mut editor, uri) = hall();
    editor.until(&uri, <[Value]>::is_empty);
    let parts = editor.open("parts.inc", PARTS);
    editor.change(&parts, 2, [0, 9, 0, 13], "Boll");
    editor.until(&uri, |told| codes(told).contains(&"E0203"));
    editor.change(&parts, 3, [0, 9, 0, 13], "Ball");
    editor.until(&uri, <[Value]>::is_empty);
    // Faults that a run finds in an included file are reported there.
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
fn completion() {
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
fn hover() {
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
fn symbols_folding_and_selection() {
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

#[test]
fn links_to_a_local_manual() {
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
fn branches_that_do_not_run_are_faded() {
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
fn render_and_watch_commands() {
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
    // A scene has one preview page, which ends with the server.
    run(&mut editor, &lenses[1]);
    assert_eq!(editor.shown(), first);
    let host = first["http://".len()..].split('/').next().unwrap().to_string();
    assert!(std::net::TcpStream::connect(&host).is_ok());
    editor.bye();
    assert!(std::net::TcpStream::connect(&host).is_err());
}

#[test]
fn unsupported_requests() {
    let mut editor = Editor::new();
    let nowhere = editor.uri("nowhere.pov");
    assert!(editor.answer("textDocument/hover", json!({"wrong": 1}))["error"]["code"].is_i64());
    assert!(editor.answer("textDocument/unheardOf", json!({}))["error"]["code"].is_i64());
    assert_eq!(editor.answer("textDocument/hover", at(&nowhere, 3, 4))["error"]["code"], -32602);
    editor.change(&nowhere, 3, [0, 0, 0, 0], "text");
    editor.say("textDocument/didChange", json!({"nonsense": true}));
    let deep = "union{".repeat(20_000);
    let uri = editor.open("deep.pov", &deep);
    editor.until(&uri, |told| codes(told).contains(&"E0104"));
    // A text without a file.
    let document = json!({"uri": "untitled:Untitled-1", "languageId": "povray", "version": 1, "text": "spere { }"});
    editor.say("textDocument/didOpen", json!({"textDocument": document}));
    editor.until("untitled:Untitled-1", |told| codes(told).contains(&"E0204"));
    editor.say("textDocument/didClose", json!({"textDocument": {"uri": "untitled:Untitled-1"}}));
    editor.until("untitled:Untitled-1", <[Value]>::is_empty);
    assert!(Path::new(&editor.place.path().join("nowhere.pov")).metadata().is_err());
    editor.bye();
}
