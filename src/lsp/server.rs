//! State of the server, and its reactions to events.

use super::diagnostics::{EditorDiagnostic, diagnostics_after_change, from_syntax_fault};
use super::document::{Document, uri_of};
use super::files::{self, Files, ReachableText};
use super::requests::commands::Watches;
use super::requests::{self, capabilities};
use super::run::RunResult;
use super::scheduler::ActiveRuns;
use super::wire::Refusal;
use super::{End, Outgoing};
use crate::diagnostic::INTERNAL_FAILURE;
use crate::math::cancel::CancelReason;
use lsp_server::{ErrorCode, Message, Notification, Request, Response};
use lsp_types::{
    DidChangeTextDocumentParams, DidCloseTextDocumentParams, DidOpenTextDocumentParams, LogMessageParams, MessageType,
    PublishDiagnosticsParams, Uri,
};
use serde::de::DeserializeOwned;
use serde_json::{Value, json};
use std::collections::BTreeMap;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::path::PathBuf;
use std::str::FromStr;
use std::sync::mpsc::{Receiver, RecvTimeoutError, SyncSender};
use std::time::Instant;

/// An event that the language server handles.
#[derive(Debug)]
pub enum Event {
    /// Event: a message from the editor.
    Message(Message),
    /// Event: invalid input from the editor.
    Refused(Refusal),
    /// Event: the connection to the editor has ended.
    Disconnected(End),
    /// Event: a background run of a scene has ended.
    RunEnded(RunResult),
    /// Event: another thread has a message for the editor.
    Send(Message),
}

/// State of the language server.
pub struct Server<S> {
    pub(in crate::lsp) client: S,
    pub(in crate::lsp) events: SyncSender<Event>,
    /// Pages of `durer watch` that are open.
    pub(in crate::lsp) watches: Watches,
    /// Open documents of the language server by address.
    pub open: BTreeMap<String, Document>,
    /// The language server's cache of included files.
    pub files: Files,
    /// Folders of the language server's include path.
    pub include: Vec<PathBuf>,
    /// Background runs that have not ended yet.
    pub(in crate::lsp) runs: ActiveRuns,
    /// Diagnostics of the last background run of each scene: by the address of the scene, then by the address of the
    /// file that they are about.
    pub(in crate::lsp) results: BTreeMap<String, BTreeMap<String, Vec<EditorDiagnostic>>>,
    state: State,
}

/// State of the connection to the editor: before `initialize`, running, or after `shutdown`.
#[derive(Clone, Copy, Debug, PartialEq)]
enum State {
    /// State before the editor's request `initialize`.
    Created,
    /// State in which requests are answered.
    Running,
    /// State after the editor's request `shutdown`.
    ShutDown,
}

/// Receiver of messages to the editor.
pub trait Client {
    /// Sends a message; ignores a closed connection.
    fn send(&self, message: Message);
    /// Sends an error response to invalid input; ignores a closed connection.
    fn refuse(&self, refusal: Refusal);
}

impl Client for SyncSender<Outgoing> {
    fn send(&self, message: Message) {
        let _ = SyncSender::send(self, Outgoing::Message(message));
    }

    fn refuse(&self, refusal: Refusal) {
        let _ = SyncSender::send(self, Outgoing::Refusal(refusal));
    }
}

impl<S: Client> Server<S> {
    /// Creates a language server without open documents.
    pub fn new(client: S, events: SyncSender<Event>, include: Vec<PathBuf>) -> Self {
        let (open, results) = (BTreeMap::new(), BTreeMap::new());
        Self {
            client,
            events,
            watches: Watches::default(),
            open,
            files: Files::default(),
            include,
            runs: ActiveRuns::default(),
            results,
            state: State::Created,
        }
    }

    /// Handles events until the editor disconnects.
    pub fn run(&mut self, events: &Receiver<Event>) -> End {
        let end = loop {
            let event = match self.next_action_time() {
                Some(time) => events.recv_timeout(time.saturating_duration_since(Instant::now())),
                None => events.recv().map_err(|_| RecvTimeoutError::Disconnected),
            };
            match event {
                Ok(Event::Message(Message::Notification(note))) if note.method == "exit" => break End::Disconnected,
                Ok(Event::Disconnected(end)) => break end,
                Err(RecvTimeoutError::Disconnected) => break End::Disconnected,
                Ok(Event::Message(Message::Request(request))) => self.handle_request(request),
                Ok(event) => self.run_catching_panics(|server| server.handle_non_request(event)),
                Err(RecvTimeoutError::Timeout) => {}
            }
            self.run_catching_panics(Self::update_runs);
        };
        self.runs.cancel_all();
        if self.state == State::ShutDown && matches!(end, End::Disconnected) { End::ShutDown } else { end }
    }

    /// Handles an event other than a request: a notification, invalid input, the end of a run, or a message to pass to
    /// the editor.
    fn handle_non_request(&mut self, event: Event) {
        match event {
            Event::Message(Message::Notification(note)) if self.state == State::Running => {
                self.handle_notification(note)
            }
            Event::Refused(refusal) => self.client.refuse(refusal),
            Event::RunEnded(ran) => self.end_run(ran),
            Event::Send(message) => self.client.send(message),
            Event::Message(_) | Event::Disconnected(_) => {}
        }
    }

    /// Runs `work` on the language server, which continues after a panic in it with its texts unharmed.
    fn run_catching_panics(&mut self, work: impl FnOnce(&mut Self)) {
        if catch_unwind(AssertUnwindSafe(|| work(self))).is_err() {
            self.log(INTERNAL_FAILURE.into());
        }
    }

    fn handle_request(&mut self, request: Request) {
        let id = request.id.clone();
        let refuse = |code: ErrorCode, text: &str| Response::new_err(id.clone(), code as i32, text.into());
        let response = match (self.state, request.method.as_str()) {
            (State::Created, "initialize") => {
                self.state = State::Running;
                Response::new_ok(id, initialize_result(&request.params))
            }
            (State::Created, _) => refuse(ErrorCode::ServerNotInitialized, "the first request must be `initialize`"),
            (State::Running, "initialize") => refuse(ErrorCode::InvalidRequest, "the server is initialized already"),
            (State::Running, "shutdown") => {
                self.state = State::ShutDown;
                Response::new_ok(id, ())
            }
            (State::ShutDown, _) => refuse(ErrorCode::InvalidRequest, "the server is shut down"),
            (State::Running, _) => catch_unwind(AssertUnwindSafe(|| requests::answer(self, request)))
                .unwrap_or_else(|_| refuse(ErrorCode::InternalError, INTERNAL_FAILURE)),
        };
        self.client.send(Message::Response(response));
    }

    fn handle_notification(&mut self, note: Notification) {
        let result = match note.method.as_str() {
            "textDocument/didOpen" => parse_params(note).map(|params| self.add_document(params)),
            "textDocument/didChange" => parse_params(note).and_then(|params| self.apply_changes(params)),
            "textDocument/didSave" | "workspace/didChangeWatchedFiles" => {
                // Included files may have changed on the disk.
                let all: Vec<_> = self.open.keys().cloned().collect();
                all.iter().for_each(|key| self.schedule_scenes_reading(key));
                Ok(())
            }
            "textDocument/didClose" => parse_params(note)
                .and_then(|DidCloseTextDocumentParams { text_document: old }| self.remove_document(old.uri.as_str())),
            _ => Ok(()),
        };
        if let Err(text) = result {
            self.log(text);
        }
    }

    /// Sends the editor a log message about a failed notification, which has no response.
    fn log(&self, message: String) {
        let params = LogMessageParams { typ: MessageType::ERROR, message };
        self.client.send(Message::Notification(Notification::new("window/logMessage".into(), params)));
    }

    fn add_document(&mut self, DidOpenTextDocumentParams { text_document: new }: DidOpenTextDocumentParams) {
        let key = new.uri.as_str().to_string();
        self.open.insert(key.clone(), Document::new(new.uri, new.version, new.text));
        self.publish_and_schedule(&key);
    }

    fn apply_changes(&mut self, params: DidChangeTextDocumentParams) -> Result<(), String> {
        let key = params.text_document.uri.as_str().to_string();
        let document = self.open.get_mut(&key).ok_or_else(|| not_open(&key))?;
        for change in params.content_changes {
            let mut results: Vec<_> = self.results.values_mut().filter_map(|found| found.get_mut(&key)).collect();
            let before = (!results.is_empty()).then(|| document.text.clone());
            let (bytes, new) = document.text.change_with_extent(change);
            for (found, before) in results.iter_mut().flat_map(|found| before.as_ref().map(|before| (found, before))) {
                **found = diagnostics_after_change(std::mem::take(*found), before, &document.text, &bytes, new);
            }
        }
        document.update_to_version(params.text_document.version);
        if document.is_too_large() {
            // What the last run has found no longer belongs to the text.
            document.due = None;
            if let Some(cancel) = document.cancel.take() {
                cancel.cancel(CancelReason::Request);
            }
            let gone = self.results.remove(&key).unwrap_or_default();
            gone.keys().filter(|address| **address != key).for_each(|address| self.publish(address));
        }
        self.publish_and_schedule(&key);
        Ok(())
    }

    fn publish_and_schedule(&mut self, address: &str) {
        self.publish(address);
        self.schedule_scenes_reading(address);
    }

    /// Returns the addresses of the open scenes that read the text with this address, including the text itself if it is
    /// a scene; empty if the text is not open.
    pub(in crate::lsp) fn scenes_reading(&mut self, address: &str) -> Vec<String> {
        let Some(document) = self.open.get(address) else { return vec![] };
        let (path, is_scene) = (document.path.clone(), document.is_scene());
        let mut out = vec![];
        for (other, scene) in self.open.iter().filter(|(_, scene)| scene.is_scene()) {
            let mut reads = || {
                let reached = files::texts_reachable_from(&mut self.files, &self.open, scene, &self.include);
                reached.iter().any(|one| matches!((&one.path, &path), (Some(a), Some(b)) if files::are_same_file(a, b)))
            };
            let belongs = if other == address {
                is_scene
            } else {
                path.is_some() && !scene.outline.includes.is_empty() && reads()
            };
            if belongs {
                out.push(other.clone());
            }
        }
        out
    }

    /// Returns the editor's address of the file at `path` if it is open, or else the `file:` address of the path.
    pub(in crate::lsp) fn address_of_path(&self, path: &std::path::Path) -> Option<String> {
        let is_it =
            |document: &&Document| document.path.as_deref().is_some_and(|open| files::are_same_file(open, path));
        let open = self.open.values().find(is_it).map(|document| document.uri.clone());
        open.or_else(|| uri_of(path)).map(|uri| uri.as_str().to_string())
    }

    /// Publishes all diagnostics of a text: faults of its syntax, and results of runs.
    pub(in crate::lsp) fn publish(&self, address: &str) {
        let Ok(uri) = Uri::from_str(address) else { return };
        let document = self.open.get(address);
        let faults = document.iter().flat_map(|document| {
            document.faults.iter().map(|fault| from_syntax_fault(fault, &document.text, &document.uri))
        });
        let mut all: Vec<EditorDiagnostic> = faults.collect();
        all.extend(document.and_then(Document::too_large_notice));
        for new in self.results.values().filter_map(|found| found.get(address)).flatten() {
            // A run finds the faults of the syntax, too, and two scenes may find the same fault in a shared file.
            if !all.iter().any(|other| other.range == new.range && other.code == new.code) {
                all.push(new.clone());
            }
        }
        let params =
            PublishDiagnosticsParams { uri, diagnostics: all, version: document.map(|document| document.version) };
        self.client.send(Message::Notification(Notification::new("textDocument/publishDiagnostics".into(), params)));
    }

    /// Returns the diagnostics of a text from all background runs.
    pub fn diagnostics_from_runs(&self, address: &str) -> Vec<EditorDiagnostic> {
        self.results.values().filter_map(|found| found.get(address)).flatten().cloned().collect()
    }

    fn remove_document(&mut self, address: &str) -> Result<(), String> {
        let scenes = self.scenes_reading(address);
        let closed = self.open.remove(address).ok_or_else(|| not_open(address))?;
        if let Some(cancel) = closed.cancel {
            cancel.cancel(CancelReason::Request);
        }
        // Files that only the closed text includes are no longer needed; the others are read again.
        self.files = Files::default();
        let gone = self.results.remove(address).unwrap_or_default();
        gone.keys().map(String::as_str).chain([address]).for_each(|address| self.publish(address));
        scenes.iter().filter(|scene| *scene != address).for_each(|scene| self.schedule_scenes_reading(scene));
        Ok(())
    }

    /// Returns the open document with an address.
    pub fn document(&self, uri: &Uri) -> Option<&Document> {
        self.open.get(uri.as_str())
    }

    /// Returns an open text, first, and all files that it includes; empty if the text is not open.
    pub fn reachable(&mut self, uri: &Uri) -> Vec<ReachableText> {
        match self.open.get(uri.as_str()) {
            Some(document) => files::texts_reachable_from(&mut self.files, &self.open, document, &self.include),
            None => vec![],
        }
    }

    /// Returns all texts that share names with an open text: first itself and the files that it includes, then the open scenes
    /// that include it, with their files.
    pub fn texts_sharing_names(&mut self, uri: &Uri) -> Vec<ReachableText> {
        let mut out = self.reachable(uri);
        for scene in self.scenes_reading(uri.as_str()) {
            let Some(document) = self.open.get(&scene) else { continue };
            for reached in files::texts_reachable_from(&mut self.files, &self.open, document, &self.include) {
                if !out.iter().any(|one| one.path == reached.path) {
                    out.push(reached);
                }
            }
        }
        out
    }

    /// Returns the editor's address of a text that the document `from` reaches by includes.
    pub fn uri_of_reached(&self, reached: &ReachableText, from: &Uri) -> Option<Uri> {
        match &reached.path {
            None => Some(from.clone()),
            Some(path) => self.address_of_path(path).and_then(|address| Uri::from_str(&address).ok()),
        }
    }
}

/// Returns the result of the request `initialize`.
fn initialize_result(params: &Value) -> Value {
    let version = env!("CARGO_PKG_VERSION");
    json!({"capabilities": capabilities(params), "serverInfo": {"name": "durer", "version": version}})
}

/// Reads the parameters of a notification.
fn parse_params<P: DeserializeOwned>(note: Notification) -> Result<P, String> {
    let Notification { method, params } = note;
    serde_json::from_value(params).map_err(|error| format!("`{method}` has invalid parameters: {error}"))
}

/// Returns the message about an address that is not open.
pub fn not_open(address: &str) -> String {
    format!("the document `{address}` is not open")
}
