//! TextMate grammars for Visual Studio Code and others: scenes and INI files.

use super::{File, GENERATED};
use durer::reference::WordsByKind;
use serde_json::{Value, json};

const NAME: &str = "[A-Za-z_][A-Za-z0-9_]*";
const NUMBER: &str = r"(?:(?<![A-Za-z0-9_])\d+(?:\.\d*)?|\.\d+)(?:[eE][-+]?\d+)?(?![A-Za-z0-9_])";

pub fn files(by_kind: &WordsByKind, options: &[&str]) -> Vec<File> {
    let text = |value: &Value| serde_json::to_string_pretty(value).unwrap_or_default() + "\n";
    vec![
        ("vscode/syntaxes/povray.tmLanguage.json", text(&scene(by_kind))),
        ("vscode/syntaxes/povray-ini.tmLanguage.json", text(&ini(options))),
        ("vscode/language-configuration.json", text(&configuration(by_kind))),
        ("vscode/options.json", text(&json!({"comment": GENERATED, "options": options}))),
    ]
}

/// A pattern that matches any of the words.
fn any(words: &[&str]) -> String {
    format!(r"\b(?:{})\b", words.join("|"))
}

fn scene(by_kind: &WordsByKind) -> Value {
    json!({
        "comment": GENERATED,
        "name": "POV-Ray scene",
        "scopeName": "source.povray",
        "fileTypes": ["pov", "inc", "scene"],
        "patterns": [{"include": "#comment"}, {"include": "#string"}, {"include": "#directive"}, {"include": "#word"}],
        "repository": {
            "comment": {"patterns": [
                {"name": "comment.line.double-slash.povray", "match": "//.*$"},
                {"include": "#nested"},
            ]},
            // Comments nest.
            "nested": {"name": "comment.block.povray", "begin": r"/\*", "end": r"\*/", "patterns": [{"include": "#nested"}]},
            "string": {
                "name": "string.quoted.double.povray", "begin": "\"", "end": "\"",
                "patterns": [{"name": "constant.character.escape.povray", "match": r"\\(?:u[0-9A-Fa-f]{4}|.)"}],
            },
            "directive": {"patterns": directives(&by_kind.directives)},
            "word": {"patterns": [
                {"name": "constant.numeric.povray", "match": NUMBER},
                {"name": "support.class.povray", "match": any(&by_kind.objects)},
                {"name": "keyword.other.block.povray", "match": any(&by_kind.blocks)},
                {"name": "support.function.povray", "match": any(&by_kind.functions)},
                {"name": "constant.language.povray", "match": any(&by_kind.constants)},
                {"name": "support.type.property-name.povray", "match": any(&by_kind.words)},
                {"name": "variable.other.povray", "match": format!(r"\b{NAME}\b")},
                {"name": "keyword.operator.povray", "match": r"[-+*/=!&|?:]|[<>]=?"},
            ]},
        },
    })
}

/// Patterns of directives; some name a symbol.
fn directives(names: &[&str]) -> Value {
    let directive = json!({"name": "keyword.control.directive.povray"});
    let named = |names: &str, between: &str, scope: &str| {
        json!({
            "match": format!(r"(#[ \t]*(?:{names})\b){between}((?!deprecated\b){NAME})"),
            "captures": {"1": directive, "2": {"name": scope}},
        })
    };
    json!([
        {
            "begin": format!(r"(#[ \t]*macro\b)\s+({NAME})\s*\("),
            "beginCaptures": {"1": directive, "2": {"name": "entity.name.function.povray"}},
            "end": r"\)",
            "patterns": [
                {"include": "#comment"},
                {"name": "keyword.control.povray", "match": r"\boptional\b"},
                {"name": "variable.parameter.povray", "match": format!(r"\b{NAME}\b")},
            ],
        },
        named("declare|local", r"\s+", "variable.other.definition.povray"),
        named("for", r"\s*\(\s*", "variable.other.definition.povray"),
        {"match": format!(r"#[ \t]*(?:{})\b", names.join("|")), "name": "keyword.control.directive.povray"},
    ])
}

fn ini(options: &[&str]) -> Value {
    json!({
        "comment": GENERATED,
        "name": "POV-Ray INI file",
        "scopeName": "source.povray-ini",
        "patterns": [
            {"name": "comment.line.povray-ini", "match": "[;#].*$"},
            {"name": "entity.name.section.povray-ini", "match": r"^\s*\[[^\]]*\]?"},
            {"name": "string.quoted.double.povray-ini", "match": "\"[^\"]*\""},
            {"name": "support.type.property-name.povray-ini", "match": format!(r"(?i)\b(?:{})\b(?=\s*=)", options.join("|"))},
            {"name": "keyword.other.switch.povray-ini", "match": r"(?<!\S)[-+][A-Za-z]+"},
            {"name": "constant.language.povray-ini", "match": r"(?i)\b(?:on|off|true|false|yes|no)\b"},
            {"name": "constant.numeric.povray-ini", "match": format!("[-+]?{NUMBER}")},
        ],
    })
}

/// Brackets, comments, and the indentation of the next line.
fn configuration(by_kind: &WordsByKind) -> Value {
    let (openers, continuers) = (by_kind.openers.join("|"), by_kind.continuers.join("|"));
    let pairs = json!([["{", "}"], ["[", "]"], ["(", ")"]]);
    let closing = |open: &str, close: &str| json!({"open": open, "close": close, "notIn": ["string", "comment"]});
    let around = json!([["{", "}"], ["[", "]"], ["(", ")"], ["<", ">"], ["\"", "\""]]);
    json!({
        "comments": {"lineComment": "//", "blockComment": ["/*", "*/"]},
        "brackets": pairs,
        "autoClosingPairs": [closing("{", "}"), closing("[", "]"), closing("(", ")"), closing("\"", "\"")],
        "surroundingPairs": around,
        "wordPattern": format!("#?{NAME}"),
        "indentationRules": {
            "increaseIndentPattern":
                format!(r"^((?!//).)*\{{[^}}]*$|^\s*#\s*({openers}|{continuers})\b((?!#\s*end\b).)*$"),
            "decreaseIndentPattern": format!(r"^\s*(\}}|#\s*(end|{continuers})\b)"),
        },
        "folding": {"markers": {"start": format!(r"^\s*#\s*({openers})\b((?!#\s*end\b).)*$"), "end": r"^\s*#\s*end\b"}},
    })
}
