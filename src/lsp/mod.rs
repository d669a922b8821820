//! `durer lsp`: the language server (Microsoft, "Language Server Protocol", version 3.17, 2022).
//!
//! Editors tell each change of a text; what is wrong with the text itself is told at once, what a run finds a little later: it runs in a
//! thread of its own, within limits, without writing a file, and the next change stops it. All that editors ask is answered from the
//! lossless tokens (`scan`) of the open texts and of the files that they include (`files`), and from the tables that the readers
//! obey (`words`): there is no second parser, and no second list of words. One file for each family of requests.

// What changes inside of an address is no part of it.
#![allow(clippy::mutable_key_type)]

mod actions;
mod colors;
mod commands;
mod complete;
mod diagnostics;
mod document;
mod files;
mod hover;
mod inlay;
mod layout;
mod lens;
mod manual;
mod names;
mod requests;
mod run;
mod scan;
mod semantic;
mod server;
mod signature;
mod symbols;
mod text;
mod words;

use lsp_server::{Connection, Message};
use server::{Event, Server};
use std::io;
use std::path::PathBuf;
use std::sync::mpsc;

/// Serves the editor at the other end of standard input and output. Tells whether it said goodbye. `include` are folders in which
/// included files are looked for.
///
/// # Errors
/// If the other end can't be read from or written to.
pub fn serve(include: &[PathBuf]) -> io::Result<bool> {
    let (connection, threads) = Connection::stdio();
    let polite = serve_over(&connection, include);
    drop(connection);
    threads.join()?;
    Ok(polite)
}

fn serve_over(connection: &Connection, include: &[PathBuf]) -> bool {
    let Ok((id, asked)) = connection.initialize_start() else { return false };
    let told = serde_json::json!({
        "capabilities": requests::capabilities(&asked),
        "serverInfo": {"name": "durer", "version": env!("CARGO_PKG_VERSION")},
    });
    if connection.initialize_finish(id, told).is_err() {
        return false;
    }
    let (sender, events) = mpsc::channel();
    let out = connection.sender.clone();
    let say = move |message| {
        out.send(message).ok();
    };
    let mut server = Server::new(say, sender.clone(), include.to_vec());
    std::thread::scope(|scope| {
        scope.spawn(move || {
            for message in &connection.receiver {
                let leaves = matches!(&message, Message::Notification(note) if note.method == "exit");
                if sender.send(Event::Client(message)).is_err() || leaves {
                    break;
                }
            }
            // It left, or was ended.
            sender.send(Event::Gone).ok();
        });
        server.run(&events);
    });
    server.is_shut_down
}
