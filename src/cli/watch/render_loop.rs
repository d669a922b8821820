//! Renders the picture of the page, and handles the page's requests.

use super::queue::{RenderQueue, Request, Work};
use super::read::{self, Read, Scene};
use super::worker::{Worker, free_on_own_thread, is_obsolete};
use crate::cli::args::WatchArgs;
use crate::cli::args::values::Size;
use crate::cli::console::Console;
use crate::cli::exit::Result;
use crate::cli::interrupt::{Deadline, Overrun};
use crate::cli::memory;
use crate::cli::pick;
use crate::cli::render::target::Target;
use crate::diagnostic::{Diagnostic, codes};
use crate::image_io::Rows;
use crate::math::cancel::CancelToken;
use crate::preview::{self, Change, FileWatcher, Message, PageSettings, PageState, Screen, TextPosition};
use crate::render::{self, RayCounts, Region, Stopped};
use crate::source::{LookedUpFiles, Sources, Span};
use serde_json::{Value, json};
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::path::Path;
use std::process::{Child, Command};
use std::sync::{Arc, Mutex, PoisonError};
use std::time::{Duration, Instant};

/// Loop of `durer watch` that renders each requested picture.
pub struct RenderLoop {
    args: WatchArgs,
    queue: Arc<RenderQueue>,
    screen: Arc<Screen>,
    /// Scene that the preview page displays, and its rendering options.
    displayed: Mutex<Option<(Arc<Scene>, render::Options)>>,
}

/// Measurements of one picture that `durer watch` rendered.
struct Rendered {
    rays: RayCounts,
    /// Duration of the picture's first, coarse level.
    first: Duration,
    /// Duration of the picture's levels after the first.
    rest: Duration,
}

impl RenderLoop {
    pub fn new(args: WatchArgs, queue: Arc<RenderQueue>, screen: Arc<Screen>) -> Self {
        queue.push(Request::Scene, |settings| {
            settings.antialias = args.look.aa.is_none_or(|aa| aa.0.is_some());
            settings.quality = args.look.quality.unwrap_or(settings.quality);
        });
        Self { args, queue, screen, displayed: Mutex::default() }
    }

    /// Renders requested pictures until the program ends.
    pub fn run(self: &Arc<Self>, console: &Console, files: &Arc<FileWatcher>) -> Result {
        let mut scene: Option<Arc<Scene>> = None;
        let mut worker = Worker::default();
        let mut state = PageState {
            name: self.args.input.display().to_string(),
            status: "reading",
            settings: PageSettings { scale: 1.0, antialias: true, quality: 9, clock: None, zoom: None },
            size: [0; 2],
            clock: [0.0, 0.0, 1.0],
            messages: vec![],
            log: String::new(),
            times: vec![],
            rays: 0,
            editor: self.args.editor.is_some(),
        };
        loop {
            let Work { request, settings, cancel } = self.queue.pop();
            state.settings = settings;
            if request == Request::Scene || scene.is_none() {
                free_on_own_thread(scene.take());
                state.status = "reading";
                self.screen.set_state(state.clone());
            }
            let (this, console, files) = (self.clone(), console.clone(), files.clone());
            let (mut new_scene, mut new_state, token) = (scene.clone(), state.clone(), cancel.clone());
            let work = move || {
                this.read_and_render(&console, &files, &mut new_scene, &mut new_state, &token);
                (new_scene, new_state)
            };
            if let Some(done) = worker.run_until_superseded(&cancel, work) {
                (scene, state) = done;
                self.screen.set_state(state.clone());
            }
        }
    }

    /// Reads the scene unless there is one, and renders it.
    fn read_and_render(
        &self,
        console: &Console,
        files: &FileWatcher,
        scene: &mut Option<Arc<Scene>>,
        state: &mut PageState,
        cancel: &CancelToken,
    ) {
        if scene.is_none() {
            let read = self.read(console, &state.settings, cancel);
            // A cancelled run has not looked up all files: the list of the run before stays.
            if is_obsolete(cancel) {
                return;
            }
            // After a panic nothing is known.
            if read.files != LookedUpFiles::default() {
                files.watch_files(&read.files, &self.args.input);
            }
            *scene = update_page(state, read);
        }
        if is_obsolete(cancel) {
            return;
        }
        match scene {
            Some(scene) => self.render(console, scene, state, cancel),
            None => state.status = "broken",
        }
    }

    fn read(&self, console: &Console, settings: &PageSettings, cancel: &CancelToken) -> Read {
        let work = || read::read(console, &self.args, settings, cancel);
        catch_unwind(AssertUnwindSafe(work)).unwrap_or_else(|_| Read {
            messages: vec![internal_fault()],
            failed: true,
            ..Read::default()
        })
    }

    fn render(&self, console: &Console, scene: &Arc<Scene>, state: &mut PageState, cancel: &CancelToken) {
        let options = read::render_options_for_page(scene, &state.settings);
        state.status = "drawing";
        state.messages.retain(|message| message.place.is_some() || message.severity == "warning");
        self.screen.set_state(state.clone());
        let before =
            self.displayed.lock().unwrap_or_else(PoisonError::into_inner).replace((scene.clone(), options.clone()));
        free_on_own_thread(before);
        let work = || self.render_now(scene, &options, cancel);
        match catch_unwind(AssertUnwindSafe(work)) {
            Ok(Ok(rendered)) => {
                state.status = "done";
                state.rays = rendered.rays.total();
                state.times.truncate(2);
                state.times.push(("first pixels", rendered.first.as_secs_f64()));
                state.times.push(("picture", rendered.rest.as_secs_f64()));
                console.info(&format!(
                    "{}: rendered in {:.2} s\n",
                    state.name,
                    state.times.iter().map(|t| t.1).sum::<f64>()
                ));
            }
            Ok(Err(Stopped::Cancelled)) if is_obsolete(cancel) => {}
            Ok(Err(stopped)) => {
                let fault = match stopped {
                    Stopped::Fault(fault) => *fault,
                    Stopped::Cancelled => {
                        let text = "the picture took longer than `--max-time` allows";
                        Diagnostic::new(codes::TIME_LIMIT, Span::NONE, text)
                    }
                };
                let sources = Sources::default();
                console.report(&sources, std::slice::from_ref(&fault));
                state.status = "broken";
                state.messages.insert(0, read::message(&sources, &fault));
            }
            Err(_) => {
                state.status = "broken";
                state.messages.insert(0, internal_fault());
            }
        }
    }

    fn render_now(
        &self,
        scene: &Scene,
        options: &render::Options,
        cancel: &CancelToken,
    ) -> std::result::Result<Rendered, Stopped> {
        let limit = scene.args.scene.max_memory.map(|bytes| bytes.0);
        // Two pictures are in memory: this one and the previous one.
        let Region { width, height, .. } = displayed_region(options);
        memory::check_memory(Size { width, height }, None, 2 * size_of::<[f32; 4]>(), limit)?;
        let start = Instant::now();
        let deadline = Deadline::start(scene.args.scene.time_limit(), cancel.clone(), Overrun::Continues);
        let (rays, first) = preview::render_levels_timing_first(&scene.world, options, &self.screen, deadline.token())?;
        Ok(Rendered { rays, first, rest: start.elapsed().saturating_sub(first) })
    }
}

/// Returns the displayed part of the picture.
fn displayed_region(options: &render::Options) -> Region {
    options.region.unwrap_or(Region { x: 0, y: 0, width: options.width, height: options.height })
}

/// Moves the result of reading a scene into the page's state, and returns the scene; `None` if reading failed.
fn update_page(state: &mut PageState, read: Read) -> Option<Arc<Scene>> {
    if let Some(size) = read.size {
        state.size = [size.width, size.height];
        state.clock = read.clock;
    }
    (state.messages, state.log) = (read.messages, read.log);
    let [parse, build] = read.times.map(|time| time.as_secs_f64());
    state.times = vec![("text", parse), ("objects", build)];
    read.scene.map(Arc::new)
}

fn internal_fault() -> Message {
    let text = "durer itself has failed, which is a bug of durer; the terminal shows details\n".into();
    Message { severity: "error", code: "", text, place: None }
}

impl preview::Backend for RenderLoop {
    fn change(&self, change: Change) {
        let request = if change.keeps_scene() { Request::Picture } else { Request::Scene };
        self.queue.push(request, |settings| settings.apply(&change));
    }

    fn pick(&self, x: usize, y: usize) -> Value {
        let displayed = self.displayed.lock().unwrap_or_else(PoisonError::into_inner).clone();
        let Some((scene, options)) = displayed else { return json!({"hit": false}) };
        let part = displayed_region(&options);
        if x >= part.width || y >= part.height {
            return json!({"hit": false});
        }
        let (across, down) = (part.x + x, part.y + y);
        let [r, g, b, _] = self.screen.color_at(x, y).unwrap_or_default().map(f64::from);
        let picked = render::pick(&scene.world, &options, across, down);
        let sources = scene.sources.lock().unwrap_or_else(PoisonError::into_inner);
        let words = pick::pixel_in_words(&sources, picked.as_ref(), [r, g, b]);
        let place = picked.as_ref().and_then(|picked| read::link(&sources, picked.source));
        json!({"hit": picked.is_some(), "words": words, "place": place})
    }

    fn save(&self) -> std::result::Result<String, String> {
        let image = self.screen.finished_picture().ok_or("the picture is not finished yet")?;
        let displayed = self.displayed.lock().unwrap_or_else(PoisonError::into_inner).clone();
        let Some((scene, _)) = displayed else { return Err("there is no picture yet".into()) };
        let size = (image.width, image.height);
        let save = || {
            let target = Target::new(&scene.input, &scene.args)?;
            target.check_file_writable()?;
            let mut draft = target.start_draft()?;
            let mut writer = target.writer(draft.as_mut(), size)?;
            writer.write_rows(&image.pixels)?;
            writer.finish()?;
            let path = target.commit(&Console::before_arguments(), draft)?;
            Ok(path.map(|path| path.display().to_string()).unwrap_or_default())
        };
        save().map_err(|failure| read::diagnostic_of(failure).message)
    }

    fn open(&self, TextPosition { file, line, column }: &TextPosition) -> std::result::Result<(), String> {
        let editor = self.args.editor.as_ref().ok_or("durer was started without `--editor`")?;
        let displayed = self.displayed.lock().unwrap_or_else(PoisonError::into_inner).clone();
        let path_in = |scene: &Scene| {
            let sources = scene.sources.lock().unwrap_or_else(PoisonError::into_inner);
            sources.ids().find(|id| sources.name(*id) == file).and_then(|id| sources.path(id).map(Path::to_path_buf))
        };
        // The file of a broken scene can be opened, too, though it has no picture.
        let own = || (self.args.input.display().to_string() == *file).then(|| self.args.input.clone());
        let path = displayed.as_ref().and_then(|(scene, _)| path_in(scene)).or_else(own);
        let path = path.ok_or_else(|| format!("`{file}` is not a file of this scene"))?;
        let words = editor.command_line_for_position(&path.to_string_lossy(), *line, *column);
        let failure = |error| format!("cannot start `{}`: {error}", words[0]);
        let child = Command::new(&words[0]).args(&words[1..]).spawn().map_err(failure)?;
        reap(child).map_err(failure)
    }
}

/// Waits on a thread for the end of a process, so that the process leaves the system's table when it ends.
fn reap(mut child: Child) -> std::io::Result<()> {
    std::thread::Builder::new().name("editor".into()).spawn(move || child.wait()).map(|_| ())
}
