//! Draws what the page shows, and answers what it asks.

use super::desk::{Desk, Next, Wish};
use super::read::{self, Read, Scene};
use crate::cli::args::WatchArgs;
use crate::cli::console::Console;
use crate::cli::exit::Result;
use crate::cli::pick;
use crate::cli::target::Target;
use crate::cli::{memory, values::Size};
use crate::diagnostic::{Diagnostic, codes};
use crate::image_io::Rows;
use crate::preview::{self, Change, Files, Message, Screen, Settings, Spot, Told};
use crate::render::{self, RayCounts, Region, Stopped};
use crate::source::{Sources, Span};
use serde_json::{Value, json};
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::path::Path;
use std::process::Command;
use std::sync::atomic::AtomicBool;
use std::sync::{Arc, Mutex, PoisonError};
use std::time::{Duration, Instant};

/// See the module.
pub struct Studio {
    args: WatchArgs,
    desk: Arc<Desk>,
    screen: Arc<Screen>,
    /// What is seen on the screen.
    shown: Mutex<Option<(Arc<Scene>, render::Options)>>,
}

/// What one picture took.
struct Drawn {
    rays: RayCounts,
    first: Duration,
    whole: Duration,
}

impl Studio {
    pub fn new(args: WatchArgs, desk: Arc<Desk>, screen: Arc<Screen>) -> Self {
        desk.ring(Wish::Scene, |settings| {
            settings.antialias = args.look.aa.is_none_or(|aa| aa.0.is_some());
            settings.quality = args.look.quality.unwrap_or(settings.quality);
        });
        Self { args, desk, screen, shown: Mutex::default() }
    }

    /// Draws until the program ends.
    pub fn work(&self, console: &Console, files: &Files) -> Result {
        let mut scene: Option<Arc<Scene>> = None;
        let mut told = Told {
            name: self.args.input.display().to_string(),
            status: "reading",
            settings: Settings { scale: 1.0, antialias: true, quality: 9, clock: None, zoom: None },
            size: [0; 2],
            clock: [0.0, 0.0, 1.0],
            messages: vec![],
            log: String::new(),
            times: vec![],
            rays: 0,
            editor: self.args.editor.is_some(),
        };
        loop {
            let Next { wish, settings, stop } = self.desk.next();
            told.settings = settings;
            if wish == Wish::Scene || scene.is_none() {
                told.status = "reading";
                self.screen.tell(told.clone());
                let read = self.read(console, &told.settings, &stop);
                let (failed, files_read) = (read.failed, read.files.clone());
                if !Desk::is_stopped(&stop) {
                    scene = take(&mut told, read);
                }
                files.follow(&files_read, &self.args.input, failed);
            }
            if Desk::is_stopped(&stop) {
                continue;
            }
            match &scene {
                Some(scene) => self.draw(console, scene, &mut told, &stop),
                None => told.status = "broken",
            }
            self.screen.tell(told.clone());
        }
    }

    fn read(&self, console: &Console, settings: &Settings, stop: &Arc<AtomicBool>) -> Read {
        let work = || read::read(console, &self.args, settings, stop);
        catch_unwind(AssertUnwindSafe(work)).unwrap_or_else(|_| Read {
            messages: vec![own_fault()],
            failed: true,
            ..Read::default()
        })
    }

    fn draw(&self, console: &Console, scene: &Arc<Scene>, told: &mut Told, stop: &AtomicBool) {
        let options = read::drawing(scene, &told.settings);
        told.status = "drawing";
        told.messages.retain(|message| message.place.is_some() || message.severity == "warning");
        self.screen.tell(told.clone());
        *self.shown.lock().unwrap_or_else(PoisonError::into_inner) = Some((scene.clone(), options.clone()));
        let work = || self.draw_now(scene, &options, stop);
        match catch_unwind(AssertUnwindSafe(work)) {
            Ok(Ok(drawn)) => {
                told.status = "done";
                told.rays = drawn.rays.total();
                told.times.truncate(2);
                told.times.push(("first pixels", drawn.first.as_secs_f64()));
                told.times.push(("picture", drawn.whole.as_secs_f64()));
                console.note(&format!(
                    "{}: drawn in {:.2} s\n",
                    told.name,
                    told.times.iter().map(|t| t.1).sum::<f64>()
                ));
            }
            Ok(Err(Stopped::Cancelled)) if Desk::is_stopped(stop) => {}
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
                told.status = "broken";
                told.messages.insert(0, read::message(&sources, &fault));
            }
            Err(_) => {
                told.status = "broken";
                told.messages.insert(0, own_fault());
            }
        }
    }

    fn draw_now(
        &self,
        scene: &Scene,
        options: &render::Options,
        stop: &AtomicBool,
    ) -> std::result::Result<Drawn, Stopped> {
        let limit = scene.args.scene.max_memory.map(|bytes| bytes.0);
        // The picture, and that of before.
        let Region { width, height, .. } = part_of(options);
        memory::check_drawing(Size { width, height }, None, 2 * size_of::<[f32; 4]>(), limit)?;
        let start = Instant::now();
        let late = scene.args.scene.max_time.map(|seconds| start + Duration::from_secs_f64(seconds.0));
        let stop = || Desk::is_stopped(stop) || late.is_some_and(|late| Instant::now() > late);
        let (rays, first) = preview::draw(&scene.world, options, &self.screen, &stop)?;
        Ok(Drawn { rays, first, whole: start.elapsed().saturating_sub(first) })
    }
}

/// What is shown of the picture.
fn part_of(options: &render::Options) -> Region {
    options.region.unwrap_or(Region { x: 0, y: 0, width: options.width, height: options.height })
}

/// What was read is told, and becomes the scene.
fn take(told: &mut Told, read: Read) -> Option<Arc<Scene>> {
    if let Some(size) = read.size {
        told.size = [size.width, size.height];
        told.clock = read.clock;
    }
    (told.messages, told.log) = (read.messages, read.log);
    let [parse, build] = read.times.map(|time| time.as_secs_f64());
    told.times = vec![("text", parse), ("objects", build)];
    read.scene.map(Arc::new)
}

fn own_fault() -> Message {
    let text = "durer itself has failed here, which is a fault of durer's; the terminal tells more\n".into();
    Message { severity: "error", code: "", text, place: None }
}

impl preview::Studio for Studio {
    fn change(&self, change: Change) {
        let wish = if change.keeps_scene() { Wish::Picture } else { Wish::Scene };
        self.desk.ring(wish, |settings| settings.take(&change));
    }

    fn pick(&self, x: usize, y: usize) -> Value {
        let shown = self.shown.lock().unwrap_or_else(PoisonError::into_inner).clone();
        let Some((scene, options)) = shown else { return json!({"hit": false}) };
        let part = part_of(&options);
        if x >= part.width || y >= part.height {
            return json!({"hit": false});
        }
        let (across, down) = (part.x + x, part.y + y);
        let [r, g, b, _] = self.screen.light(x, y).unwrap_or_default().map(f64::from);
        let picked = render::pick(&scene.world, &options, across, down);
        let sources = scene.sources.lock().unwrap_or_else(PoisonError::into_inner);
        let words = pick::words(&sources, picked.as_ref(), [r, g, b]);
        let place = picked.as_ref().and_then(|picked| read::link(&sources, picked.source));
        json!({"hit": picked.is_some(), "words": words, "place": place})
    }

    fn save(&self) -> std::result::Result<String, String> {
        let image = self.screen.finished().ok_or("the picture is not finished yet")?;
        let shown = self.shown.lock().unwrap_or_else(PoisonError::into_inner).clone();
        let Some((scene, _)) = shown else { return Err("there is no picture yet".into()) };
        let size = Size { width: image.width, height: image.height };
        let save = || {
            let target = Target::new(&scene.args)?;
            target.check()?;
            let mut draft = target.draft()?;
            let mut canvas = target.canvas(draft.as_mut(), size)?;
            canvas.take(&image.pixels)?;
            canvas.finish()?;
            let path = target.place(&Console::plain(), draft)?;
            Ok(path.map(|path| path.display().to_string()).unwrap_or_default())
        };
        save().map_err(|failure| read::in_words(failure).message)
    }

    fn open(&self, Spot { file, line, column }: &Spot) -> std::result::Result<(), String> {
        let editor = self.args.editor.as_ref().ok_or("durer was started without `--editor`")?;
        let shown = self.shown.lock().unwrap_or_else(PoisonError::into_inner).clone();
        let known = |scene: &Scene| {
            let sources = scene.sources.lock().unwrap_or_else(PoisonError::into_inner);
            sources.ids().find(|id| sources.name(*id) == file).and_then(|id| sources.path(id).map(Path::to_path_buf))
        };
        // A broken scene has no picture; its own file can be opened all the same.
        let own = || (self.args.input.display().to_string() == *file).then(|| self.args.input.clone());
        let path = shown.as_ref().and_then(|(scene, _)| known(scene)).or_else(own);
        let path = path.ok_or_else(|| format!("`{file}` is no file of this scene"))?;
        let words = editor.at(&path.to_string_lossy(), *line, *column);
        let started = Command::new(&words[0]).args(&words[1..]).spawn();
        started.map(|_| ()).map_err(|error| format!("`{}` could not be started: {error}", words[0]))
    }
}
