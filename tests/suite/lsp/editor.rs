//! An editor: the client's end of the connection.

use serde_json::{Value, json};
use std::collections::HashMap;
use std::io::{BufRead, BufReader, Read, Write};
use std::process::{Child, ChildStdin, Command, Stdio};
use std::sync::mpsc::{Receiver, channel};
use std::time::{Duration, Instant};

/// Timeout for an answer.
const PATIENCE: Duration = Duration::from_secs(30);

/// An editor connected to a server.
pub struct Editor {
    child: Child,
    stdin: ChildStdin,
    messages: Receiver<Value>,
    next: i64,
    /// Latest diagnostics by URI.
    told: HashMap<String, Value>,
    /// Documents that the server wants shown, and that the test has not taken yet.
    shown: Vec<String>,
    pub place: tempfile::TempDir,
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
    pub fn new() -> Self {
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

    pub fn send(&mut self, message: &Value) {
        let body = message.to_string();
        write!(self.stdin, "Content-Length: {}\r\n\r\n{body}", body.len()).unwrap();
        self.stdin.flush().unwrap();
    }

    pub fn say(&mut self, method: &str, params: Value) {
        self.send(&json!({"jsonrpc": "2.0", "method": method, "params": params}));
    }

    /// The next message; notifications are recorded.
    pub fn take(&mut self, patience: Duration) -> Option<Value> {
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

    /// Waits until the server wants something shown.
    pub fn shown(&mut self) -> String {
        while self.shown.is_empty() {
            self.take(PATIENCE).expect("nothing is shown");
        }
        self.shown.remove(0)
    }

    pub fn answer(&mut self, method: &str, params: Value) -> Value {
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
    pub fn ask(&mut self, method: &str, params: Value) -> Value {
        let answer = self.answer(method, params);
        assert!(answer["error"].is_null(), "{method}: {answer}");
        answer["result"].clone()
    }

    pub fn uri(&self, name: &str) -> String {
        format!("file://{}", self.place.path().canonicalize().unwrap().join(name).display())
    }

    pub fn open(&mut self, name: &str, text: &str) -> String {
        let uri = self.uri(name);
        let document = json!({"uri": uri, "languageId": "povray", "version": 1, "text": text});
        self.say("textDocument/didOpen", json!({"textDocument": document}));
        uri
    }

    pub fn put(&self, name: &str, text: &str) {
        std::fs::write(self.place.path().join(name), text).unwrap();
    }

    /// One change: a range as four numbers, and its replacement.
    pub fn change(&mut self, uri: &str, version: i64, [a, b, c, d]: [u64; 4], text: &str) {
        let range = json!({"start": {"line": a, "character": b}, "end": {"line": c, "character": d}});
        let changes = json!([{"range": range, "text": text}]);
        self.say(
            "textDocument/didChange",
            json!({"textDocument": {"uri": uri, "version": version}, "contentChanges": changes}),
        );
    }

    /// Waits until the diagnostics of a text satisfy `holds`.
    #[track_caller]
    pub fn until(&mut self, uri: &str, holds: impl Fn(&[Value]) -> bool) -> Vec<Value> {
        let start = Instant::now();
        loop {
            let told = self.told.get(uri).and_then(|told| told["diagnostics"].as_array().cloned());
            match told {
                Some(told) if holds(&told) => return told,
                _ => assert!(self.take(PATIENCE).is_some() && start.elapsed() < PATIENCE, "{:?}", self.told.get(uri)),
            }
        }
    }

    pub fn bye(mut self) {
        self.ask("shutdown", Value::Null);
        self.say("exit", Value::Null);
        assert_eq!(self.child.wait().unwrap().code(), Some(0));
    }
}

pub fn at(uri: &str, line: u64, character: u64) -> Value {
    json!({"textDocument": {"uri": uri}, "position": {"line": line, "character": character}})
}

pub fn codes(told: &[Value]) -> Vec<&str> {
    told.iter().map(|one| one["code"].as_str().unwrap()).collect()
}
