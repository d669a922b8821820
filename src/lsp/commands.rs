//! What editors can have done: a scene drawn, a scene watched, a code explained. durer runs itself for it, so that no editor needs an
//! extension.

use super::document::uri_of;
use super::server::{Event, Out, Server};
use crate::diagnostic::codes;
use lsp_server::{Message, Notification, Request};
use lsp_types::{ExecuteCommandParams, MessageType, ShowDocumentParams, ShowMessageParams, Uri};
use serde_json::Value;
use std::collections::BTreeMap;
use std::io::{BufRead, BufReader, Read};
use std::path::{Path, PathBuf};
use std::process::{Child, Command, Stdio};
use std::str::FromStr;
use std::sync::mpsc::Sender;

/// Draws a scene into a picture beside it: its path.
pub const RENDER: &str = "durer.render";
/// Opens the page of `durer watch`: the scene's path.
pub const WATCH: &str = "durer.watch";
/// Tells what a code means: the code.
pub const EXPLAIN: &str = "durer.explain";

/// Pages that are served, by their scenes.
#[derive(Default)]
pub struct Watches(BTreeMap<PathBuf, (Child, String)>);

impl Drop for Watches {
    fn drop(&mut self) {
        for (child, _) in self.0.values_mut() {
            // It may have ended by itself.
            let _ = child.kill();
            let _ = child.wait();
        }
    }
}

/// Begins what is asked for. What comes of it is told when it is done.
pub fn execute<S: Out>(server: &mut Server<S>, params: &ExecuteCommandParams) -> Option<Value> {
    let argument = params.arguments.first()?.as_str()?;
    match params.command.as_str() {
        RENDER => render(Path::new(argument), server.events.clone()),
        WATCH => watch(server, Path::new(argument)),
        EXPLAIN => {
            let found = codes::find(argument)?;
            server.out.send(say(MessageType::INFO, format!("{}: {}\n\n{}", found.code, found.title, found.text)));
        }
        _ => {}
    }
    None
}

fn say(typ: MessageType, message: String) -> Message {
    let params = ShowMessageParams { typ, message };
    Message::Notification(Notification::new("window/showMessage".into(), params))
}

/// In a browser, or what else opens such a thing.
fn show(uri: Uri, number: i32) -> Message {
    let params = ShowDocumentParams { uri, external: Some(true), take_focus: None, selection: None };
    // The answer does not matter.
    Message::Request(Request::new(number.into(), "window/showDocument".into(), params))
}

/// This program, for a scene.
fn durer(words: &[&str], scene: &Path) -> std::io::Result<Command> {
    let mut command = Command::new(std::env::current_exe()?);
    command.args(words).arg(scene).stdin(Stdio::null()).stdout(Stdio::null()).stderr(Stdio::piped());
    if let Some(folder) = scene.parent().filter(|folder| folder.is_dir()) {
        command.current_dir(folder);
    }
    Ok(command)
}

fn render(scene: &Path, events: Sender<Event>) {
    let (scene, picture) = (scene.to_path_buf(), scene.with_extension("png"));
    let work = move || {
        let name = picture.file_name().unwrap_or_default().to_string_lossy().into_owned();
        let drawn =
            durer(&["-q", "render", "-o", &picture.to_string_lossy()], &scene).and_then(|mut command| command.output());
        let messages = match drawn {
            Ok(out) if out.status.success() => {
                let shown = uri_of(&picture).map(|uri| show(uri, 1));
                [Some(say(MessageType::INFO, format!("{name} is drawn"))), shown]
            }
            Ok(out) => [Some(say(MessageType::ERROR, String::from_utf8_lossy(&out.stderr).into_owned())), None],
            Err(error) => [Some(say(MessageType::ERROR, format!("durer can't be started: {error}"))), None],
        };
        messages.into_iter().flatten().for_each(|message| _ = events.send(Event::Say(message)));
    };
    // Without a thread there is nothing to tell.
    let _ = std::thread::Builder::new().name("render".into()).spawn(work);
}

/// A scene has one page.
fn watch<S: Out>(server: &mut Server<S>, scene: &Path) {
    let watches = &mut server.watches.0;
    if watches.get_mut(scene).is_some_and(|(child, _)| !matches!(child.try_wait(), Ok(None))) {
        watches.remove(scene);
    }
    let begun = match watches.get(scene) {
        Some((_, address)) => Ok(address.clone()),
        None => begin(scene).map(|(child, address)| {
            watches.insert(scene.to_path_buf(), (child, address.clone()));
            address
        }),
    };
    match begun {
        Ok(address) => {
            server.out.send(say(MessageType::INFO, format!("{address} shows {}", scene.display())));
            Uri::from_str(&address).iter().for_each(|uri| server.out.send(show(uri.clone(), 2)));
        }
        Err(reason) => server.out.send(say(MessageType::ERROR, reason)),
    }
}

/// Starts a page, and waits for its address, which comes at once.
fn begin(scene: &Path) -> Result<(Child, String), String> {
    let start = || durer(&["watch"], scene)?.spawn();
    let mut child = start().map_err(|error| format!("durer can't be started: {error}"))?;
    let mut told = BufReader::new(child.stderr.take().ok_or("durer tells nothing")?);
    let mut line = String::new();
    let _ = told.read_line(&mut line);
    match line.split_whitespace().next().filter(|word| word.starts_with("http://")) {
        Some(address) => {
            let address = address.to_string();
            // Whatever it tells later is read, so that it never waits.
            let drain = move || std::io::copy(&mut told, &mut std::io::sink());
            let _ = std::thread::Builder::new().name("watch".into()).spawn(drain);
            Ok((child, address))
        }
        None => {
            let mut rest = String::new();
            let _ = told.take(10_000).read_to_string(&mut rest);
            let _ = child.wait();
            Err(line + &rest)
        }
    }
}
