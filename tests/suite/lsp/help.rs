//! Applies the code actions that are offered for messages.

use super::editor::{Editor, codes};
use serde_json::{Value, json};

/// An ASCII text after edits that don't overlap.
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

/// The first action with this title.
fn action<'a>(actions: &'a Value, title: &str) -> &'a Value {
    let all = actions.as_array().unwrap();
    all.iter().find(|one| one["title"] == title).unwrap_or_else(|| panic!("{title}: {actions}"))
}

#[test]
fn code_actions_apply() {
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

/// The titles of the offered actions, and the text after the first one.
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
fn more_code_actions_apply() {
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
