//! `durer lsp`: the language server (Microsoft, "Language Server Protocol", version 3.17, 2022).
//!
//! Faults of a text's syntax are published after each change. Other faults follow from a run of the scene, which takes
//! place on its own thread, within limits, without writing files, and is stopped by the next change (`scheduler`, `run`).
//! Invalid input is refused with an error, and the server goes on (`wire`). Requests are
//! answered from the outlines of the open texts and of the files that these include (`files`), and from the tables of the
//! readers (`words`), so that there is no second parser and no second list of words. `requests/` has
//! a file for each family of requests.

// The interior mutability of an address is no part of its value.
#![allow(clippy::mutable_key_type)]

mod diagnostics;
mod document;
mod files;
mod manual;
mod requests;
mod run;
mod scheduler;
mod server;
mod text;
mod wire;
mod words;

use server::{Event, Server};
use std::io;
use std::path::PathBuf;
use std::sync::mpsc::{Receiver, RecvTimeoutError, SyncSender, channel, sync_channel};
use std::time::Duration;
use wire::{Incoming, Reader, Refusal};

/// Largest number of events, and of messages to the editor, that wait for their turn.
const QUEUE_LENGTH: usize = 16;
/// Time that the last messages to the editor have at the end of the server.
const FLUSH_TIME: Duration = Duration::from_secs(2);

/// Reason for which the server has ended.
#[derive(Debug)]
pub enum End {
    /// The editor shut the server down.
    ShutDown,
    /// The editor disconnected without the request `shutdown`.
    Disconnected,
    /// The editor's messages could not be read.
    Unreadable(io::Error),
    /// A message to the editor could not be written.
    Unwritable(io::Error),
}

/// Message to the editor.
#[derive(Debug)]
pub(in crate::lsp) enum Outgoing {
    /// Outgoing message: a response, a request or a notification to the editor.
    Message(lsp_server::Message),
    /// The error response to invalid input.
    Refusal(Refusal),
}

/// Serves an editor over standard input and output until the editor disconnects. `include` are folders of the include
/// path.
///
/// # Errors
/// If the system has no further thread.
pub fn serve(include: &[PathBuf]) -> io::Result<End> {
    let (sender, events) = sync_channel(QUEUE_LENGTH);
    let (out, outgoing) = sync_channel(QUEUE_LENGTH);
    let (flushed, flush) = channel();
    let failed = sender.clone();
    let write = move || {
        if let Err(error) = write_all(&outgoing) {
            // The server stops sending.
            drop(outgoing);
            let _ = failed.send(Event::Disconnected(End::Unwritable(error)));
        }
        let _ = flushed.send(());
    };
    std::thread::Builder::new().name("writer".into()).spawn(write)?;
    let read_from = sender.clone();
    std::thread::Builder::new().name("reader".into()).spawn(move || read_all(&read_from))?;
    let mut server = Server::new(out, sender, include.to_vec());
    let end = server.run(&events);
    // The writer ends after the last message. An editor that reads no more does not hold the server back.
    drop(server);
    if flush.recv_timeout(FLUSH_TIME) == Err(RecvTimeoutError::Timeout) {
        return Ok(End::Unwritable(io::ErrorKind::TimedOut.into()));
    }
    Ok(end)
}

/// Reads the editor's messages until the end of the input.
fn read_all(events: &SyncSender<Event>) {
    let mut reader = Reader::new(io::stdin().lock());
    loop {
        let event = match reader.read() {
            Ok(Incoming::Message(message)) => Event::Message(message),
            Ok(Incoming::Refused(refusal)) => Event::Refused(refusal),
            Ok(Incoming::Response) => continue,
            Ok(Incoming::End) => Event::Disconnected(End::Disconnected),
            Err(error) => Event::Disconnected(End::Unreadable(error)),
        };
        let is_last = matches!(event, Event::Disconnected(_));
        if events.send(event).is_err() || is_last {
            break;
        }
    }
}

/// Writes messages to the editor until the server ends.
fn write_all(outgoing: &Receiver<Outgoing>) -> io::Result<()> {
    let mut to = io::stdout().lock();
    outgoing.iter().try_for_each(|message| match message {
        Outgoing::Message(message) => message.write(&mut to),
        Outgoing::Refusal(refusal) => refusal.write(&mut to),
    })
}
