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
    /// Starts a server and initializes it.
    pub fn new() -> Self {
        let mut editor = Self::connect();
        let told = editor.ask("initialize", json!({"capabilities": {}, "processId": null, "rootUri": null}));
        assert_eq!(told["capabilities"]["positionEncoding"], "utf-16");
        editor.say("initialized", json!({}));
        editor
    }

    /// Starts a server.
    pub fn connect() -> Self {
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
        Self { child, stdin, messages, next: 0, told: HashMap::new(), shown: vec![], place }
    }

    /// Runs a server on the whole of its input; returns its exit code and its messages.
    pub fn run_with(input: &str) -> (Option<i32>, String) {
        let mut durer = Command::new(env!("CARGO_BIN_EXE_durer"));
        durer.arg("lsp").stdin(Stdio::piped()).stdout(Stdio::null()).stderr(Stdio::piped());
        let mut child = durer.spawn().unwrap();
        child.stdin.take().unwrap().write_all(input.as_bytes()).unwrap();
        let output = child.wait_with_output().unwrap();
        (output.status.code(), String::from_utf8_lossy(&output.stderr).into_owned())
    }

    pub fn send(&mut self, message: &Value) {
        let body = message.to_string();
        self.raw(format!("Content-Length: {}\r\n\r\n{body}", body.len()).as_bytes());
    }

    /// Sends bytes as they are.
    pub fn raw(&mut self, bytes: &[u8]) {
        self.stdin.write_all(bytes).unwrap();
        self.stdin.flush().unwrap();
    }

    /// Returns a number of the server's `/proc/PID/status`; 0 on systems without that file.
    fn status(&self, name: &str) -> usize {
        let text = std::fs::read_to_string(format!("/proc/{}/status", self.child.id())).unwrap_or_default();
        let value = text.lines().find_map(|line| line.strip_prefix(name)?.strip_prefix(':'));
        value.map_or(0, |value| value.split_whitespace().next().unwrap().parse().unwrap())
    }

    pub fn resident_kb(&self) -> usize {
        self.status("VmRSS")
    }

    pub fn n_threads(&self) -> usize {
        self.status("Threads")
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

    /// Waits until the diagnostics of a version of a text satisfy `holds`.
    #[track_caller]
    pub fn until_version(&mut self, uri: &str, version: i64, holds: impl Fn(&[Value]) -> bool) {
        let start = Instant::now();
        loop {
            let told = self.told.get(uri).filter(|told| told["version"] == version);
            if told.is_some_and(|told| holds(told["diagnostics"].as_array().unwrap())) {
                return;
            }
            assert!(self.take(PATIENCE).is_some() && start.elapsed() < PATIENCE, "{:?}", self.told.get(uri));
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
    told.iter().map(|one| one["code"].as_str().unwrap_or_default()).collect()
}
