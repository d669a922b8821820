//! Callbacks of a render: progress, journal, Ctrl-C and `--max-time`.

use crate::cli::console::print_message;
use crate::cli::exit::{Exit, Failure, Result};
use crate::cli::interrupt;
use crate::cli::journal::Journal;
use crate::cli::render::pass_times::PassTimes;
use crate::cli::render::progress::Progress;
use crate::cli::shard::ShardWriter;
use crate::diagnostic::{Diagnostic, codes};
use crate::image_io::{Frame, Rows};
use crate::math::cancel::{CancelReason, CancelToken};
use crate::render::{self, RayCounts, Shard, Stopped, Tile, Watch};
use crate::scene::SaveFile;
use crate::source::Span;
use crate::world::World;
use std::io::{self, Write};
use std::sync::Arc;

/// Watches a render: shows progress, stores tiles, and stops on Ctrl-C, on cancellation and after the time limit.
pub struct Monitor<'a> {
    progress: Progress,
    /// Token that ends the rendering.
    cancel: CancelToken,
    /// True if another part of the program may cancel the rendering, which is then not reported.
    pub is_silent: bool,
    /// Journal of the picture's finished tiles.
    pub journal: Option<Arc<Journal>>,
    /// Durations of the passes that prepared the picture.
    pub passes: PassTimes,
    /// Receives the photons and radiosity samples to save; `None` to save nothing.
    pub light: Option<&'a dyn ReceiveLight>,
}

/// Receiver of photons and radiosity samples that a scene or a command saves.
pub trait ReceiveLight: Sync {
    /// Receives the photons or radiosity samples for a file; `write` writes the contents of the file.
    fn receive(&self, file: &SaveFile, write: &dyn Fn(&mut dyn Write) -> io::Result<()>);
}

impl Watch for Monitor<'_> {
    fn progress(&self, done: usize, total: usize) {
        self.progress.show_progress(done, total);
    }

    fn preparing(&self, pass: &'static str, done: usize, total: usize) {
        self.progress.show_preparation(pass, done, total);
        self.passes.record(pass, done, total);
    }

    fn cancelled(&self) -> bool {
        self.cancel.is_cancelled()
    }

    fn cancel_token(&self) -> CancelToken {
        self.cancel.clone()
    }

    fn save_light(&self, file: &SaveFile, write: &dyn Fn(&mut dyn Write) -> io::Result<()>) {
        self.light.iter().for_each(|light| light.receive(file, write));
    }

    fn load_tile(&self, tile: Tile) -> Option<Vec<[f32; 4]>> {
        self.journal.as_ref()?.load_tile(tile)
    }

    fn store_tile(&self, tile: Tile, pixels: &[[f32; 4]]) {
        if let Some(journal) = &self.journal {
            journal.store_tile(tile, pixels);
        }
    }
}

impl Monitor<'_> {
    /// Creates the monitor of a render that `cancel` ends.
    pub fn new(progress: Progress, cancel: CancelToken) -> Self {
        Self { progress, cancel, is_silent: false, journal: None, passes: PassTimes::default(), light: None }
    }

    /// Renders a World and passes the rows to `rows`, unless the render is stopped.
    pub fn render_rows(&self, world: &World, options: &render::Options, rows: &mut dyn Rows) -> Result<RayCounts> {
        self.render_with(|| render::draw(world, options, self, rows))
    }

    /// Renders a shard of a World into a shard file, unless the render is stopped.
    pub fn render_shard(
        &self,
        world: &World,
        options: &render::Options,
        shard: Shard,
        file: &mut ShardWriter,
    ) -> Result<RayCounts> {
        let mut take = |area, pixels: &[[f32; 4]]| file.write_block(area, pixels);
        self.render_with(|| render::draw_shard(world, options, shard, self, &mut take))
    }

    /// Computes the photons and radiosity samples of a picture and saves those with a [`SaveFile`], unless the work is
    /// stopped.
    pub fn compute_and_save_light(&self, world: &World, options: &render::Options) -> Result<()> {
        self.render_with(|| render::compute_and_save_light(world, options, self).map_err(Stopped::from))
    }

    fn render_with<T>(&self, render: impl FnOnce() -> std::result::Result<T, Stopped>) -> Result<T> {
        if self.cancelled() {
            return Err(self.stop_failure());
        }
        let rendered = render();
        self.progress.clear();
        rendered.map_err(|stopped| match stopped {
            Stopped::Cancelled => self.stop_failure(),
            Stopped::Fault(fault) => Failure::Fault(fault),
        })
    }

    /// Renders a World into memory, unless the render is stopped.
    pub fn render(&self, world: &World, options: &render::Options) -> Result<Frame> {
        let mut frame = Frame { width: options.width, height: options.height, pixels: vec![] };
        frame.pixels.reserve_exact(options.width * options.height);
        self.render_rows(world, options, &mut frame)?;
        Ok(frame)
    }

    /// Returns the failure of a picture that was not finished, and acknowledges the cancellation. If a signal ended the
    /// rendering, prints so.
    fn stop_failure(&self) -> Failure {
        interrupt::acknowledge_cancellation();
        if let Some(signal) = interrupt::received_end_signal() {
            print_message(&format!("{}; no picture was written\n", signal.reason));
            return Failure::Reported(signal.exit);
        }
        if self.is_silent && self.cancel.reason() == Some(CancelReason::Request) {
            return Failure::Reported(Exit::Fine);
        }
        let text = "the picture took longer than `--max-time` allows";
        Failure::Fault(Box::new(Diagnostic::new(codes::TIME_LIMIT, Span::NONE, text)))
    }
}
