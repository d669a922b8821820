//! Commands of the server: render a scene, watch a scene, explain a code. The server runs durer itself, so that no
//! editor needs an extension.

use crate::diagnostic::codes;
use crate::lsp::document::uri_of;
use crate::lsp::server::{Client, Event, Server};
use lsp_server::{Message, Notification, Request};
use lsp_types::{ExecuteCommandParams, MessageType, ShowDocumentParams, ShowMessageParams, Uri};
use serde_json::Value;
use std::collections::BTreeMap;
use std::io::{BufRead, BufReader, Read};
use std::path::{Path, PathBuf};
use std::process::{Child, Command, Stdio};
use std::str::FromStr;
use std::sync::mpsc::SyncSender;

/// Name of the editor command that renders a scene into a picture beside it; the command's argument is the scene's
/// path.
pub const RENDER: &str = "durer.render";
/// Name of the editor command that opens the page of `durer watch`; the command's argument is the scene's path.
pub const WATCH: &str = "durer.watch";
/// Name of the editor command that explains a diagnostic code; the command's argument is the code.
pub const EXPLAIN: &str = "durer.explain";

/// Processes and addresses of `durer watch`, by scene.
#[derive(Default)]
pub struct Watches(BTreeMap<PathBuf, (Child, String)>);

impl Drop for Watches {
    fn drop(&mut self) {
        for (child, _) in self.0.values_mut() {
            // The process may have ended already.
            let _ = child.kill();
            let _ = child.wait();
        }
    }
}

/// Starts the command that the editor asks for (render, watch or explain). Always returns `None`: the result is sent to the
/// editor as a message later.
pub fn execute<S: Client>(server: &mut Server<S>, params: &ExecuteCommandParams) -> Option<Value> {
    let argument = params.arguments.first()?.as_str()?;
    match params.command.as_str() {
        RENDER => start_render(Path::new(argument), server.events.clone()),
        WATCH => open_watch_page(server, Path::new(argument)),
        EXPLAIN => {
            let found = codes::find_explanation(argument)?;
            server
                .client
                .send(show_message(MessageType::INFO, format!("{}: {}\n\n{}", found.code, found.title, found.text)));
        }
        _ => {}
    }
    None
}

fn show_message(typ: MessageType, message: String) -> Message {
    let params = ShowMessageParams { typ, message };
    Message::Notification(Notification::new("window/showMessage".into(), params))
}

/// Returns the request to open an address in a browser or another program.
fn show_document(uri: Uri, request_id: i32) -> Message {
    let params = ShowDocumentParams { uri, external: Some(true), take_focus: None, selection: None };
    // The response is ignored.
    Message::Request(Request::new(request_id.into(), "window/showDocument".into(), params))
}

/// Returns the process to start for a scene: this program with `words` as its arguments, then the scene's path.
fn durer_command(words: &[&str], scene: &Path) -> std::io::Result<Command> {
    let mut command = Command::new(std::env::current_exe()?);
    command.args(words).arg(scene).stdin(Stdio::null()).stdout(Stdio::null()).stderr(Stdio::piped());
    if let Some(folder) = scene.parent().filter(|folder| folder.is_dir()) {
        command.current_dir(folder);
    }
    Ok(command)
}

fn start_render(scene: &Path, events: SyncSender<Event>) {
    let (scene, picture) = (scene.to_path_buf(), scene.with_extension("png"));
    let work = move || {
        let name = picture.file_name().unwrap_or_default().to_string_lossy().into_owned();
        let rendered = durer_command(&["-q", "render", "-o", &picture.to_string_lossy()], &scene)
            .and_then(|mut command| command.output());
        let messages = match rendered {
            Ok(out) if out.status.success() => {
                let document = uri_of(&picture).map(|uri| show_document(uri, 1));
                [Some(show_message(MessageType::INFO, format!("{name} is rendered"))), document]
            }
            Ok(out) => {
                [Some(show_message(MessageType::ERROR, String::from_utf8_lossy(&out.stderr).into_owned())), None]
            }
            Err(error) => [Some(show_message(MessageType::ERROR, format!("cannot start durer: {error}"))), None],
        };
        messages.into_iter().flatten().for_each(|message| _ = events.send(Event::Send(message)));
    };
    // Without a thread there is no result.
    let _ = std::thread::Builder::new().name("render".into()).spawn(work);
}

/// Starts `durer watch` for a scene unless it already runs, and asks the editor to open its page.
fn open_watch_page<S: Client>(server: &mut Server<S>, scene: &Path) {
    let watches = &mut server.watches.0;
    // `try_wait` also removes an ended process from the system's table.
    watches.retain(|_, (child, _)| matches!(child.try_wait(), Ok(None)));
    let begun = match watches.get(scene) {
        Some((_, address)) => Ok(address.clone()),
        None => start_watch(scene).map(|(child, address)| {
            watches.insert(scene.to_path_buf(), (child, address.clone()));
            address
        }),
    };
    match begun {
        Ok(address) => {
            server.client.send(show_message(MessageType::INFO, format!("{address} shows {}", scene.display())));
            Uri::from_str(&address).iter().for_each(|uri| server.client.send(show_document(uri.clone(), 2)));
        }
        Err(reason) => server.client.send(show_message(MessageType::ERROR, reason)),
    }
}

/// Starts `durer watch` for a scene, and waits for the address of its page, which comes at once. Returns the process
/// and the address.
fn start_watch(scene: &Path) -> Result<(Child, String), String> {
    let start = || durer_command(&["watch"], scene)?.spawn();
    let mut child = start().map_err(|error| format!("cannot start durer: {error}"))?;
    let mut output = BufReader::new(child.stderr.take().ok_or("durer has no output")?);
    let mut line = String::new();
    let _ = output.read_line(&mut line);
    match line.split_whitespace().next().filter(|word| word.starts_with("http://")) {
        Some(address) => {
            let address = address.to_string();
            // Read later output, so that the process never blocks.
            let drain = move || std::io::copy(&mut output, &mut std::io::sink());
            let _ = std::thread::Builder::new().name("watch".into()).spawn(drain);
            Ok((child, address))
        }
        None => {
            let mut rest = String::new();
            let _ = output.take(10_000).read_to_string(&mut rest);
            let _ = child.wait();
            Err(line + &rest)
        }
    }
}
