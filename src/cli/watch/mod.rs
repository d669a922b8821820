//! `durer watch INPUT`: draws a scene again whenever a file that it reads is saved, on a page or into a file.

mod desk;
mod read;
mod studio;

use super::args::{RenderArgs, WatchArgs};
use super::console::{Console, say};
use super::exit::{Exit, Failure, Result, usage};
use super::target::Target;
use super::values::Seconds;
use super::{render, session};
use crate::diagnostic::{Diagnostic, codes};
use crate::preview::{Files, Screen, serve};
use crate::source::{ReadFiles, Span};
use desk::Desk;
use std::path::Path;
use std::sync::Arc;
use studio::Studio;

/// Draws until it is interrupted.
pub fn run(console: &Console, args: &WatchArgs) -> Result {
    let input = session::named(&args.input);
    if input == Path::new("-") {
        return usage("what comes from standard input is never saved again; name a file");
    }
    session::check_input(&input)?;
    if args.output.as_deref() == Some(Path::new("-")) {
        return usage("the picture is drawn again and again, and can't go to standard output");
    }
    let args = WatchArgs { input, ..args.clone() };
    // A name that can't be written is told at once.
    Target::new(&as_render(&args))?;
    if args.no_page { redraw(console, &args) } else { show(console, &args) }
}

/// What `durer render` would be given.
fn as_render(args: &WatchArgs) -> RenderArgs {
    RenderArgs {
        inputs: vec![args.input.clone()],
        input: args.input.clone(),
        output: args.output.clone(),
        scene: args.scene.clone(),
        look: args.look.clone(),
        threads: args.threads,
        // A picture that is begun anew is not gone on with.
        keep_after: Seconds(f64::from(u32::MAX)),
        ..RenderArgs::default()
    }
}

/// The file is written again and again.
fn redraw(console: &Console, args: &WatchArgs) -> Result {
    let desk = Arc::new(Desk::default());
    let files = files(&desk);
    loop {
        let stop = desk.next().stop;
        let args_of_run = RenderArgs { stop: Some(stop.clone()), ..as_render(args) };
        let (drawn, read) = render::run_and_record(console, &args_of_run, ReadFiles::new());
        let failed = match drawn {
            Err(Failure::Told(Exit::Interrupted)) => return Ok(Exit::Interrupted),
            Ok(exit) => exit != Exit::Fine,
            Err(failure) => console.tell(failure) != Exit::Fine,
        };
        if !failed && !Desk::is_stopped(&stop) {
            console.note(&format!("{}: drawn; waiting for the next change\n", args.input.display()));
        }
        files.follow(&read, &args.input, failed);
    }
}

/// The page is served until the program is interrupted.
fn show(console: &Console, args: &WatchArgs) -> Result {
    let (desk, screen) = (Arc::new(Desk::default()), Arc::new(Screen::default()));
    let files = files(&desk);
    let studio = Arc::new(Studio::new(args.clone(), desk, screen.clone()));
    let address = match serve(args.port, studio.clone(), screen) {
        Ok(address) => address,
        Err(error) => {
            let text = format!("no page can be served on port {} of 127.0.0.1: {error}", args.port);
            let fault = Diagnostic::new(codes::FILE_UNWRITABLE, Span::NONE, text);
            return Err(Failure::Fault(Box::new(fault.help("without `--port` any port that is free is taken"))));
        }
    };
    // The address is what was asked for, so that `--quiet` shows it too.
    say(&format!("{address} shows {} (Ctrl-C ends it)\n", args.input.display()));
    if args.open
        && let Err(error) = open::that_detached(&address)
    {
        console.note(&format!("no browser could be opened: {error}\n"));
    }
    studio.work(console, &files)
}

fn files(desk: &Arc<Desk>) -> Files {
    let desk = desk.clone();
    Files::new(move || desk.ring(desk::Wish::Scene, |_| {}))
}
