//! The pixels of a picture: anti-aliasing, focal blur, tiles and their order, worker threads, progress.

mod antialias;
mod blocks;
mod blur;
mod corners;
mod frame_render;
mod lattice;
mod output;
mod pick;
mod pixel_area;
mod prepare;
mod radiosity;
mod region_rows;
mod sampler;
mod schedule;
mod shard;
mod simulation;
mod threads;
mod workers;

pub use output::OutputConversion;
pub use pick::pick;
pub use prepare::{compute_and_save_light, photon_and_radiosity_digests};
pub use shard::{BlockReceiver, Shard, block_edge, draw_shard, shard_blocks};
#[doc(hidden)]
pub use simulation::simulated_busy_share;

use crate::diagnostic::Fault;
use crate::image_io::{Frame, Rows};
use crate::math::cancel::CancelToken;
use crate::scene::SaveFile;
use crate::source::Span;
pub use crate::transport::RayCounts;
use crate::world::World;
use prepare::FrameCamera;
use region_rows::{RegionRows, write_outside_rows};
use std::io::{self, Write};
use workers::Workers;

/// Options of a render. Size, anti-aliasing, quality, region, frame and alpha determine every byte of the picture; the
/// number of threads and shafts do not.
#[derive(Clone, Debug)]
pub struct Options {
    /// Width of the whole picture in pixels.
    pub width: usize,
    /// Height of the whole picture in pixels.
    pub height: usize,
    /// Threshold of adaptive anti-aliasing; `None` for one sample per pixel.
    pub antialias: Option<f64>,
    /// Positions of the samples of anti-aliasing.
    pub sampling: Sampling,
    /// Quality level, 0 to 11, as POV-Ray's `+Q`.
    pub quality: u8,
    /// Number of threads; 0 for one per processor.
    pub threads: usize,
    /// Part of the picture to render; `None` for all of it.
    pub region: Option<Region>,
    /// Alpha of the pixels outside of `region`, which are black.
    pub outside_alpha: f32,
    /// Number of the frame, which is a part of each random number's key.
    pub frame: u32,
    /// True for a picture with alpha (`+UA`), whose background is transparent.
    pub alpha: bool,
    /// True to trace no shadow rays to the parts of an area light that a shaft test proves to be visible. Shafts change
    /// no byte of the picture.
    pub has_shafts: bool,
}

impl Options {
    /// Creates the options of a whole picture at full quality on one thread, with one sample per pixel.
    pub fn new(width: usize, height: usize) -> Self {
        Self {
            width,
            height,
            antialias: None,
            sampling: Sampling::default(),
            quality: 9,
            threads: 1,
            region: None,
            outside_alpha: 0.0,
            frame: 0,
            alpha: false,
            has_shafts: true,
        }
    }

    /// Returns the part of the picture that is rendered.
    pub fn rendered_region(&self) -> Region {
        let (width, height) = (self.width, self.height);
        self.region.unwrap_or(Region { x: 0, y: 0, width, height }).clipped_to(width, height)
    }
}

/// Method and parameters of anti-aliasing.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sampling {
    /// Layout of the samples in a pixel.
    pub layout: SampleLayout,
    /// Rows and columns of a grid, 1 to 9; for corners, the number of subdivisions, plus one.
    pub depth: u32,
    /// Random displacement of samples, from 0 to 1, as a share of the sample's cell.
    pub jitter: f64,
    /// Gamma that is applied to two samples before they are compared; above 0.
    pub gamma: f64,
}

impl Default for Sampling {
    fn default() -> Self {
        Self { layout: SampleLayout::Lattice, depth: 3, jitter: 1.0, gamma: 2.5 }
    }
}

/// Positions of the samples of anti-aliasing.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum SampleLayout {
    /// Points of a lattice; depth and jitter have no effect.
    Lattice,
    /// A grid of samples in each pixel that differs: POV-Ray's first method.
    Grid,
    /// Samples at the corners of pixels, with subdivision: POV-Ray's second method.
    Corners,
}

/// A rectangle of pixels, counted from the top left.
#[derive(Clone, Copy, Debug, PartialEq, Eq, serde::Serialize, serde::Deserialize)]
pub struct Region {
    /// Leftmost column of the rectangle of pixels, counted from 0.
    pub x: usize,
    /// Topmost row of the rectangle of pixels, counted from 0.
    pub y: usize,
    /// Width of the rectangle in pixels.
    pub width: usize,
    /// Height of the rectangle in pixels.
    pub height: usize,
}

/// A unit of work: one pass over a rectangle of pixels. The result depends only on the World, the options and the tile.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Tile {
    /// Number of the pass: [`FIRST_PASS`] takes the samples that anti-aliasing compares, [`FINAL_PASS`] computes the
    /// pixels.
    pub pass: u8,
    /// Rectangle of pixels that the tile covers.
    pub area: Region,
}

/// The pass that takes the samples which adaptive anti-aliasing compares.
pub const FIRST_PASS: u8 = 0;
/// The pass that computes the pixels of the picture.
pub const FINAL_PASS: u8 = 1;

/// Callbacks of a render: progress, cancellation, and storage of finished tiles.
pub trait Watch: Sync {
    /// Reports the number of finished pixels after each tile. Adaptive anti-aliasing counts the pixels of both passes.
    fn progress(&self, done: usize, total: usize);
    /// Reports the number of finished work items of a pass that prepares the frame, such as the emission of photons. The
    /// first call of a pass has `done` = 0. The later calls come from several threads, so `done` can decrease from one call
    /// to the next. One of these calls, not always the last, has `done` = `total`; a cancelled pass can lack that call.
    fn preparing(&self, _pass: &'static str, _done: usize, _total: usize) {}
    /// True if the render must stop; the render asks at each sample and at every 64th surface that a ray hits.
    fn cancelled(&self) -> bool;
    /// Returns a token that stops the render inside a long search for a hit; by default the calling thread's token.
    fn cancel_token(&self) -> CancelToken {
        CancelToken::current()
    }
    /// Returns the pixels of a tile, row by row, if an earlier run stored them; `None` to render the tile.
    fn load_tile(&self, _: Tile) -> Option<Vec<[f32; 4]>> {
        None
    }
    /// Saves the light of a preparation pass to a file that the scene names. `write` writes the contents of the file.
    fn save_light(&self, _: &SaveFile, _write: &dyn Fn(&mut dyn Write) -> io::Result<()>) {}
    /// Stores the pixels of a finished tile; [`OutputConversion`] converts them to linear
    /// light.
    fn store_tile(&self, _: Tile, _: &[[f32; 4]]) {}
}

/// A [`Watch`] that ignores progress and never cancels.
pub struct Unwatched;

impl Watch for Unwatched {
    fn progress(&self, _: usize, _: usize) {}
    fn cancelled(&self) -> bool {
        false
    }
}

/// The error of a render that was cancelled.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Cancelled;

impl Region {
    /// Returns the number of pixels in the rectangle: width times height.
    pub fn n_pixels(&self) -> usize {
        self.width * self.height
    }

    /// Returns the part of the region that is within a picture of this size.
    fn clipped_to(self, width: usize, height: usize) -> Region {
        let (x, y) = (self.x.min(width), self.y.min(height));
        Region { x, y, width: self.width.min(width - x), height: self.height.min(height - y) }
    }
}

/// Reason for which a render ended early.
#[derive(Debug)]
pub enum Stopped {
    /// The caller cancelled the render.
    Cancelled,
    /// The receiver of the rows failed.
    Fault(Fault),
}

impl From<Cancelled> for Stopped {
    fn from(_: Cancelled) -> Self {
        Self::Cancelled
    }
}

impl From<Fault> for Stopped {
    fn from(fault: Fault) -> Self {
        Self::Fault(fault)
    }
}

/// Renders a picture into memory.
///
/// # Errors
/// [`Cancelled`] if `watch` cancels the render.
pub fn render(world: &World, options: &Options, watch: &dyn Watch) -> Result<(Frame, RayCounts), Cancelled> {
    let mut frame = Frame { width: options.width, height: options.height, pixels: vec![] };
    frame.pixels.reserve_exact(options.width * options.height);
    let counts = draw(world, options, watch, &mut frame).map_err(|_| Cancelled)?;
    Ok((frame, counts))
}

/// Renders a picture and passes its rows to `rows`, from the top, as soon as they are finished.
///
/// # Errors
/// [`Stopped`] if `watch` cancels the render or `rows` fails.
pub fn draw(world: &World, options: &Options, watch: &dyn Watch, rows: &mut dyn Rows) -> Result<RayCounts, Stopped> {
    let (width, height) = (options.width, options.height);
    let region = options.rendered_region();
    if region.width == 0 || region.height == 0 {
        write_outside_rows(rows, options, height)?;
        return Ok(RayCounts::default());
    }
    let workers = Workers::new(options.threads, watch);
    let camera = FrameCamera::new(&world.eye, width, height);
    let context = prepare::prepare(world, &camera, options, &workers)?;
    let method = antialias::Method::new(world, camera.lens.as_ref(), options);
    write_outside_rows(rows, options, region.y)?;
    let conversion = OutputConversion::new(world, options);
    let mut receiver = RegionRows { rows: &mut *rows, conversion, options, region };
    let frame = frame_render::FrameRender { context: &context, camera: &camera, workers: &workers, method, region };
    let counts = frame.run(&mut receiver)?;
    write_outside_rows(rows, options, height - region.y - region.height)?;
    Ok(counts)
}

/// Returns the maximum memory for the render of a region, in bytes, besides the World and the stored rows.
pub fn memory_bytes(region: Region) -> u128 {
    threads::memory_bytes(region)
}

/// The first hit through the centre of a pixel.
#[derive(Clone, Debug, PartialEq)]
pub struct Picked {
    /// Name of the shape that was hit, such as `sphere`.
    pub shape: &'static str,
    /// Distance of the hit from the camera, in world units.
    pub t: f64,
    /// Point of the hit in world space.
    pub point: [f64; 3],
    /// Outward normal of the hit in world space, length 1.
    pub normal: [f64; 3],
    /// Surface coordinates of the hit, as `uv_mapping` uses them.
    pub uv: [f64; 2],
    /// Span of the block of the hit object.
    pub source: Span,
}
