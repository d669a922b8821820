//! State of the server, and its reactions to events.

use super::diagnostics::{EditorDiagnostic, moved, of_syntax};
use super::document::{Document, uri_of};
use super::files::{self, Files, ReachableText};
use super::requests;
use super::requests::commands::Watches;
use super::run::{self, Job, RunResult};
use super::text::Text;
use crate::math::cancel::{CancelReason, CancelToken};
use lsp_server::{ErrorCode, Message, Notification, Request, Response};
use lsp_types::{
    DidChangeTextDocumentParams, DidCloseTextDocumentParams, DidOpenTextDocumentParams, PublishDiagnosticsParams, Uri,
};
use serde::de::DeserializeOwned;
use std::collections::BTreeMap;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::path::PathBuf;
use std::str::FromStr;
use std::sync::mpsc::{Receiver, RecvTimeoutError, Sender};
use std::time::{Duration, Instant};

/// Time after the last change before a scene is run.
const PAUSE: Duration = Duration::from_millis(250);

/// An event that the language server handles.
pub enum Event {
    /// Event: a message from the editor.
    Message(Message),
    /// Event: the editor has disconnected.
    Disconnected,
    /// Event: a background run of a scene has ended.
    RunEnded(RunResult),
    /// Event: another thread has a message for the editor.
    Send(Message),
}

/// State of the language server.
pub struct Server<S> {
    pub(in crate::lsp) client: S,
    pub(in crate::lsp) events: Sender<Event>,
    /// Pages of `durer watch` that are open.
    pub(in crate::lsp) watches: Watches,
    /// Open documents of the language server by address.
    pub open: BTreeMap<String, Document>,
    /// The language server's cache of included files.
    pub files: Files,
    /// Folders of the language server's include path.
    pub include: Vec<PathBuf>,
    /// Diagnostics of the last run of each scene, for each address.
    results: BTreeMap<String, BTreeMap<String, Vec<EditorDiagnostic>>>,
    /// True after the editor's shutdown request.
    pub is_shut_down: bool,
}

/// Receiver of messages to the editor.
pub trait Client {
    /// Sends a message; ignores a closed connection.
    fn send(&self, message: Message);
}

impl<F: Fn(Message)> Client for F {
    fn send(&self, message: Message) {
        self(message);
    }
}

impl<S: Client> Server<S> {
    /// Creates a language server without open documents.
    pub fn new(client: S, events: Sender<Event>, include: Vec<PathBuf>) -> Self {
        let (open, results) = (BTreeMap::new(), BTreeMap::new());
        Self {
            client,
            events,
            watches: Watches::default(),
            open,
            files: Files::default(),
            include,
            results,
            is_shut_down: false,
        }
    }

    /// Handles events until the editor disconnects.
    pub fn run(&mut self, events: &Receiver<Event>) {
        loop {
            let event = match self.open.values().filter_map(|document| document.due).min() {
                Some(due) => events.recv_timeout(due.saturating_duration_since(Instant::now())),
                None => events.recv().map_err(|_| RecvTimeoutError::Disconnected),
            };
            match event {
                Ok(Event::Message(Message::Request(request))) => self.request(request),
                Ok(Event::Message(Message::Notification(note))) if note.method == "exit" => break,
                Ok(Event::Message(Message::Notification(note))) => self.notification(note),
                Ok(Event::Message(Message::Response(_))) => {}
                Ok(Event::RunEnded(ran)) => self.publish_run(ran),
                Ok(Event::Send(message)) => self.client.send(message),
                Ok(Event::Disconnected) | Err(RecvTimeoutError::Disconnected) => break,
                Err(RecvTimeoutError::Timeout) => self.start_runs(),
            }
        }
        self.open
            .values()
            .filter_map(|document| document.cancel.as_ref())
            .for_each(|cancel| cancel.cancel(CancelReason::Request));
    }

    fn request(&mut self, request: Request) {
        let id = request.id.clone();
        let response = match request.method.as_str() {
            "shutdown" => {
                self.is_shut_down = true;
                Response::new_ok(id, ())
            }
            _ if self.is_shut_down => {
                Response::new_err(id, ErrorCode::InvalidRequest as i32, "the server is shut down".into())
            }
            _ => catch_unwind(AssertUnwindSafe(|| requests::answer(self, request))).unwrap_or_else(|_| {
                // A panic does not harm the texts: the server continues after a failed request.
                Response::new_err(
                    id,
                    ErrorCode::InternalError as i32,
                    "durer has failed, which is a bug; please report it".into(),
                )
            }),
        };
        self.client.send(Message::Response(response));
    }

    fn notification(&mut self, note: Notification) {
        fn read<P: DeserializeOwned>(note: Notification) -> Option<P> {
            serde_json::from_value(note.params).ok()
        }
        match note.method.as_str() {
            "textDocument/didOpen" => {
                let Some(DidOpenTextDocumentParams { text_document: new }) = read(note) else { return };
                let key = new.uri.as_str().to_string();
                self.open.insert(key.clone(), Document::new(new.uri, new.version, new.text));
                self.changed(&key);
            }
            "textDocument/didChange" => {
                if let Some(params) = read(note) {
                    self.change(params);
                }
            }
            "textDocument/didSave" | "workspace/didChangeWatchedFiles" => {
                // Included files may have changed on the disk.
                let all: Vec<_> = self.open.keys().cloned().collect();
                all.iter().for_each(|key| self.schedule(key));
            }
            "textDocument/didClose" => {
                let Some(DidCloseTextDocumentParams { text_document: old }) = read(note) else { return };
                self.close(old.uri.as_str());
            }
            _ => {}
        }
    }

    fn change(&mut self, params: DidChangeTextDocumentParams) {
        let key = params.text_document.uri.as_str().to_string();
        let Some(document) = self.open.get_mut(&key) else { return };
        let mut before: Text = document.text.clone();
        for change in params.content_changes {
            let made = document.change(params.text_document.version, vec![change]);
            for found in self.results.values_mut().filter_map(|found| found.get_mut(&key)) {
                for (bytes, new) in &made {
                    *found = moved(std::mem::take(found), &before, &document.text, bytes, *new);
                }
            }
            before = document.text.clone();
        }
        self.changed(&key);
    }

    fn changed(&mut self, key: &str) {
        self.publish(key);
        self.schedule(key);
    }

    /// Schedules a run of the scenes that read this text.
    fn schedule(&mut self, key: &str) {
        let due = Some(Instant::now() + PAUSE);
        for scene in self.scenes_of(key) {
            if let Some(document) = self.open.get_mut(&scene) {
                document.due = due;
                if let Some(cancel) = document.cancel.take() {
                    cancel.cancel(CancelReason::Request);
                }
            }
        }
    }

    /// The open scenes that read a text, including the text itself if it is a scene.
    fn scenes_of(&mut self, key: &str) -> Vec<String> {
        let Some(document) = self.open.get(key) else { return vec![] };
        let (path, is_scene) = (document.path.clone(), document.is_scene());
        let mut out = vec![];
        for (other, scene) in self.open.iter().filter(|(_, scene)| scene.is_scene()) {
            let mut reads = || {
                let reached = files::reachable(&mut self.files, &self.open, scene, &self.include);
                reached.iter().any(|one| matches!((&one.path, &path), (Some(a), Some(b)) if files::same(a, b)))
            };
            let belongs =
                if other == key { is_scene } else { path.is_some() && !scene.scan.includes.is_empty() && reads() };
            if belongs {
                out.push(other.clone());
            }
        }
        out
    }

    fn start_runs(&mut self) {
        let now = Instant::now();
        let due: Vec<_> =
            self.open.iter().filter(|(_, d)| d.due.is_some_and(|due| due <= now)).map(|(k, _)| k.clone()).collect();
        for key in due {
            let others = self.open.iter().filter(|(other, _)| **other != key);
            let open =
                others.filter_map(|(_, other)| Some((other.path.clone()?, other.text.as_str().to_string()))).collect();
            let Some(document) = self.open.get_mut(&key) else { continue };
            let cancel = CancelToken::default();
            (document.due, document.cancel) = (None, Some(cancel.clone()));
            let job = Job {
                uri: key,
                version: document.version,
                path: document.path.clone(),
                text: document.text.as_str().to_string(),
                open,
                include: self.include.clone(),
                cancel,
            };
            let events = self.events.clone();
            run::start(job, move |ran| {
                events.send(Event::RunEnded(ran)).ok();
            });
        }
    }

    /// Publishes the result of a run, unless the text has changed since.
    fn publish_run(&mut self, ran: RunResult) {
        let Some(document) = self.open.get_mut(&ran.uri) else { return };
        if document.version != ran.version || document.due.is_some() {
            return;
        }
        document.cancel = None;
        let mut found = BTreeMap::new();
        for (path, diagnostics) in ran.diagnostics {
            let address = match path {
                None => Some(ran.uri.clone()),
                Some(path) => self.address(&path),
            };
            found.extend(address.map(|address| (address, diagnostics)));
        }
        let old = self.results.insert(ran.uri.clone(), found).unwrap_or_default();
        let new = self.results.get(&ran.uri).into_iter().flat_map(BTreeMap::keys);
        let mut all: Vec<String> = old.into_keys().chain(new.cloned()).chain([ran.uri]).collect();
        all.sort();
        all.dedup();
        all.iter().for_each(|address| self.publish(address));
    }

    /// The editor's address of an open file, or the address of its path.
    fn address(&self, path: &std::path::Path) -> Option<String> {
        let is_it = |document: &&Document| document.path.as_deref().is_some_and(|open| files::same(open, path));
        let open = self.open.values().find(is_it).map(|document| document.uri.clone());
        open.or_else(|| uri_of(path)).map(|uri| uri.as_str().to_string())
    }

    /// Publishes all diagnostics of a text: faults of its syntax, and results of runs.
    fn publish(&self, address: &str) {
        let Ok(uri) = Uri::from_str(address) else { return };
        let document = self.open.get(address);
        let faults = document
            .iter()
            .flat_map(|document| document.faults.iter().map(|fault| of_syntax(fault, &document.text, &document.uri)));
        let mut all: Vec<EditorDiagnostic> = faults.collect();
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
    pub fn run_diagnostics(&self, address: &str) -> Vec<EditorDiagnostic> {
        self.results.values().filter_map(|found| found.get(address)).flatten().cloned().collect()
    }

    fn close(&mut self, key: &str) {
        let scenes = self.scenes_of(key);
        if let Some(cancel) = self.open.remove(key).and_then(|document| document.cancel) {
            cancel.cancel(CancelReason::Request);
        }
        let gone = self.results.remove(key).unwrap_or_default();
        gone.keys().map(String::as_str).chain([key]).for_each(|address| self.publish(address));
        scenes.iter().filter(|scene| *scene != key).for_each(|scene| self.schedule(scene));
    }

    /// Returns the open document with an address.
    pub fn document(&self, uri: &Uri) -> Option<&Document> {
        self.open.get(uri.as_str())
    }

    /// Returns an open text and all files that it includes.
    pub fn reachable(&mut self, uri: &Uri) -> Vec<ReachableText> {
        match self.open.get(uri.as_str()) {
            Some(document) => files::reachable(&mut self.files, &self.open, document, &self.include),
            None => vec![],
        }
    }

    /// All texts that share names with one: the files that it includes, and the open scenes that include it with their
    /// files.
    pub fn related(&mut self, uri: &Uri) -> Vec<ReachableText> {
        let mut out = self.reachable(uri);
        for scene in self.scenes_of(uri.as_str()) {
            let Some(document) = self.open.get(&scene) else { continue };
            for reached in files::reachable(&mut self.files, &self.open, document, &self.include) {
                if !out.iter().any(|one| one.path == reached.path) {
                    out.push(reached);
                }
            }
        }
        out
    }

    /// The address of a text that was reached from `from`.
    pub fn uri(&self, reached: &ReachableText, from: &Uri) -> Option<Uri> {
        match &reached.path {
            None => Some(from.clone()),
            Some(path) => self.address(path).and_then(|address| Uri::from_str(&address).ok()),
        }
    }
}
