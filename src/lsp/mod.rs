//! `durer lsp`: the language server (Microsoft, "Language Server Protocol", version 3.17, 2022).
//!
//! Faults of a text's syntax are published after each change. Other faults follow from a run of the scene, which takes
//! place on its own thread, within limits, without writing files, and is stopped by the next change. Requests are
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
mod server;
mod text;
mod words;

use lsp_server::{Connection, Message};
use server::{Event, Server};
use std::io;
use std::path::PathBuf;
use std::sync::mpsc;

/// Serves an editor over standard input and output. Returns true if the editor shut the server down before it
/// disconnected. `include` are folders of the include path.
///
/// # Errors
/// If reading or writing fails.
pub fn serve(include: &[PathBuf]) -> io::Result<bool> {
    let (connection, threads) = Connection::stdio();
    let is_shut_down = serve_over(&connection, include);
    drop(connection);
    threads.join()?;
    Ok(is_shut_down)
}

fn serve_over(connection: &Connection, include: &[PathBuf]) -> bool {
    let Ok((id, asked)) = connection.initialize_start() else { return false };
    let result = serde_json::json!({
        "capabilities": requests::capabilities(&asked),
        "serverInfo": {"name": "durer", "version": env!("CARGO_PKG_VERSION")},
    });
    if connection.initialize_finish(id, result).is_err() {
        return false;
    }
    let (sender, events) = mpsc::channel();
    let out = connection.sender.clone();
    let send = move |message| {
        out.send(message).ok();
    };
    let mut server = Server::new(send, sender.clone(), include.to_vec());
    std::thread::scope(|scope| {
        scope.spawn(move || {
            for message in &connection.receiver {
                let is_exit = matches!(&message, Message::Notification(note) if note.method == "exit");
                if sender.send(Event::Message(message)).is_err() || is_exit {
                    break;
                }
            }
            // The editor has exited.
            sender.send(Event::Disconnected).ok();
        });
        server.run(&events);
    });
    server.is_shut_down
}
