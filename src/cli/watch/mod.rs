//! `durer watch INPUT`: renders a scene again whenever a file that it reads is saved, on a page or into a file.

mod queue;
mod read;
mod render_loop;
mod worker;

use super::args::values::Seconds;
use super::args::{RenderArgs, WatchArgs};
use super::console::{Console, print_message};
use super::exit::{Exit, Failure, Result, usage_error};
use super::{interrupt, render, session};
use crate::cli::render::target::Target;
use crate::diagnostic::{Diagnostic, codes, file};
use crate::preview::{FileWatcher, Screen, serve};
use crate::source::{ContentHash, Disk, FileKind, Files, LookedUpFiles, ReadError, Span};
use queue::{RenderQueue, Request};
use render_loop::RenderLoop;
use std::io;
use std::path::Path;
use std::sync::Arc;
use worker::Worker;

/// Renders the scene again after each change, for a page or a file, until the program is interrupted.
pub fn run(console: &Console, args: &WatchArgs) -> Result {
    let input = session::existing_scene_path(&args.input);
    if input == Path::new("-") {
        return usage_error("standard input can't be watched; name a file");
    }
    session::check_input(&input)?;
    if args.output.as_deref() == Some(Path::new("-")) {
        return usage_error("standard output can't take a picture that is rendered again and again");
    }
    let args = WatchArgs { input, ..args.clone() };
    // Report an output name without a format at once.
    Target::new(&args.input, &render_args(&args))?;
    if args.no_page { write_after_each_change(console, &args) } else { serve_page(console, &args) }
}

/// The arguments of `durer render` for the same picture.
fn render_args(args: &WatchArgs) -> RenderArgs {
    RenderArgs {
        inputs: vec![args.input.clone()],
        output: args.output.clone(),
        scene: args.scene.clone(),
        look: args.look.clone(),
        threads: args.threads,
        // No journal: an interrupted picture is rendered from the beginning.
        keep_after: Seconds(f64::from(u32::MAX)),
        ..RenderArgs::default()
    }
}

/// Writes the picture file after each change.
fn write_after_each_change(console: &Console, args: &WatchArgs) -> Result {
    let queue = Arc::new(RenderQueue::default());
    let files = start_file_watcher(&queue, &args.input);
    let mut worker = Worker::default();
    loop {
        let cancel = queue.pop().cancel;
        let (console_of_work, render_args, token) = (console.clone(), render_args(args), cancel.clone());
        let input = args.input.clone();
        let work = move || {
            if let Err(fault) = refuse_device_or_pipe(&input) {
                return (Err(fault.into()), LookedUpFiles::default());
            }
            render::run(
                &console_of_work,
                &render_args,
                render::RenderContext { cancel: Some(token), ..Default::default() },
            )
        };
        let Some((rendered, looked_up)) = worker.run_until_superseded(&cancel, work) else {
            if let Some(signal) = interrupt::received_end_signal() {
                return Ok(signal.exit);
            }
            // The list of files stays: a cancelled run has not looked up all of them.
            continue;
        };
        let has_failed = match rendered {
            Err(Failure::Reported(exit)) if exit.is_signal() => return Ok(exit),
            Ok(exit) => exit != Exit::Fine,
            Err(failure) => console.print_failure(failure) != Exit::Fine,
        };
        if !has_failed && !cancel.is_cancelled() {
            console.info(&format!("{}: rendered; waiting for the next change\n", args.input.display()));
        }
        files.watch_files(&looked_up, &args.input);
    }
}

/// Returns an error if the scene is a device or a pipe now, which `durer render` would read to its end.
fn refuse_device_or_pipe(input: &Path) -> std::result::Result<(), Box<Diagnostic>> {
    match Disk.metadata(input) {
        Ok(metadata) if metadata.kind == FileKind::Special => {
            let error = io::Error::new(io::ErrorKind::InvalidInput, "it is a device or a pipe");
            Err(Box::new(file::unreadable(&Disk, input, &ReadError::Io(error))))
        }
        // `durer render` reports a missing file and a folder.
        _ => Ok(()),
    }
}

/// Serves the preview page with the scene's picture until the program is interrupted.
fn serve_page(console: &Console, args: &WatchArgs) -> Result {
    let (queue, screen) = (Arc::new(RenderQueue::default()), Arc::new(Screen::default()));
    let files = start_file_watcher(&queue, &args.input);
    let render_loop = Arc::new(RenderLoop::new(args.clone(), queue, screen.clone()));
    let address = match serve(args.port, render_loop.clone(), screen) {
        Ok(address) => address,
        Err(error) => {
            let text = format!("cannot serve a page on port {} of 127.0.0.1: {error}", args.port);
            let fault = Diagnostic::new(codes::FILE_UNWRITABLE, Span::NONE, text);
            return Err(Failure::Fault(Box::new(fault.help("without `--port`, durer takes a free port"))));
        }
    };
    // The address is the result of the command: `--quiet` does not hide it.
    print_message(&format!("{address} shows {} (Ctrl-C ends it)\n", args.input.display()));
    if args.open
        && let Err(error) = open::that_detached(&address)
    {
        console.info(&format!("cannot open a browser: {error}\n"));
    }
    render_loop.run(console, &Arc::new(files))
}

/// Starts to watch the scene's own file, so that a save ends even the first run.
fn start_file_watcher(queue: &Arc<RenderQueue>, input: &Path) -> FileWatcher {
    let queue = queue.clone();
    let files = FileWatcher::new(move || queue.push(Request::Scene, |_| {}));
    let content = Disk.read(input).map(|bytes| (input.to_path_buf(), ContentHash::of(&bytes)));
    let looked_up = LookedUpFiles { read: content.into_iter().collect(), ..LookedUpFiles::default() };
    files.watch_files(&looked_up, input);
    files
}
