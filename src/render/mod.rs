//! From rays to light: shading, shadows, reflection; tiles, anti-aliasing, progress.

mod antialias;
mod area;
mod bands;
mod blocks;
mod blur;
mod corners;
mod dispersion;
mod grid;
mod mirror;
mod net;
mod output;
mod pick;
mod prepare;
mod random;
mod refract;
mod shade;
mod shading_point;
mod shadow;
mod trace;
mod travel;
mod workers;

pub use pick::pick;

use crate::diagnostic::{self, Fault};
use crate::image_io::{Frame, Rows};
use crate::source::Span;
use crate::world::World;
use serde::Serialize;
use workers::Workers;

/// How a picture is made. None of it but size, antialias, quality, region and frame changes a byte of it.
#[derive(Clone, Debug)]
pub struct Options {
    /// Pixels across.
    pub width: usize,
    /// Pixels down.
    pub height: usize,
    /// Threshold of adaptive anti-aliasing; `None` is off.
    pub antialias: Option<f64>,
    /// How it is done.
    pub sampling: Sampling,
    /// 0 to 11, as POV-Ray's `+Q`.
    pub quality: u8,
    /// 0: one for each processor.
    pub threads: usize,
    /// Draw only this part; the rest stays transparent.
    pub region: Option<Region>,
    /// Seeds everything random.
    pub frame: u32,
    /// Keep alpha (`+UA`): the background is then see-through.
    pub alpha: bool,
}

impl Options {
    /// A whole picture of this size at full quality on one thread, with one sample a pixel.
    pub fn new(width: usize, height: usize) -> Self {
        Self {
            width,
            height,
            antialias: None,
            sampling: Sampling::default(),
            quality: 9,
            threads: 1,
            region: None,
            frame: 0,
            alpha: false,
        }
    }
}

/// How anti-aliasing is done.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sampling {
    /// Where samples lie.
    pub spread: Spread,
    /// How many rows and columns the grid has, 1 to 9; or how often pieces between corners are halved, and one more.
    pub depth: u32,
    /// How far samples are off their places at random: 0 to 1, of what is theirs.
    pub jitter: f64,
    /// Differences are judged after this gamma, which is above 0.
    pub gamma: f64,
}

impl Default for Sampling {
    fn default() -> Self {
        Self { spread: Spread::Net, depth: 3, jitter: 1.0, gamma: 2.5 }
    }
}

/// Where samples lie.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Spread {
    /// As evenly as possible; depth and jitter say nothing.
    Net,
    /// POV-Ray's first method.
    Grid,
    /// POV-Ray's second method.
    Corners,
}

/// Pixels, counted from the top left.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Region {
    /// Left.
    pub x: usize,
    /// Top.
    pub y: usize,
    /// Pixels across.
    pub width: usize,
    /// Pixels down.
    pub height: usize,
}

/// A part of the work; what becomes of it depends on nothing but the World and the options.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Tile {
    /// Of the second pass?
    pub second: bool,
    /// Where it is in the picture.
    pub area: Region,
}

/// Whoever waits for the picture.
pub trait Watch: Sync {
    /// So many pixels of the total are done (with anti-aliasing, both passes count).
    fn progress(&self, done: usize, total: usize);
    /// Should the work stop?
    fn cancelled(&self) -> bool;
    /// The pixels of a tile, row by row, if it was drawn before.
    fn recall(&self, _: Tile) -> Option<Vec<[f32; 4]>> {
        None
    }
    /// A tile is drawn; [`light`] makes of its pixels what the picture shows.
    fn keep(&self, _: Tile, _: &[[f32; 4]]) {}
}

/// Nobody watches.
pub struct Unwatched;

impl Watch for Unwatched {
    fn progress(&self, _: usize, _: usize) {}
    fn cancelled(&self) -> bool {
        false
    }
}

/// How many rays were cast.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize)]
pub struct Rays {
    /// From the eye.
    pub camera: u64,
    /// Towards lights.
    pub shadow: u64,
    /// Off mirrors.
    pub reflected: u64,
    /// Through see-through surfaces.
    pub transmitted: u64,
}

/// The watcher wanted it to stop.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Cancelled;

impl Rays {
    fn add(&mut self, other: &Rays) {
        self.camera += other.camera;
        self.shadow += other.shadow;
        self.reflected += other.reflected;
        self.transmitted += other.transmitted;
    }

    /// All of them.
    pub fn total(&self) -> u64 {
        self.camera + self.shadow + self.reflected + self.transmitted
    }
}

impl Region {
    /// What of it lies in a picture of this size.
    fn within(self, width: usize, height: usize) -> Region {
        let (x, y) = (self.x.min(width), self.y.min(height));
        Region { x, y, width: self.width.min(width - x), height: self.height.min(height - y) }
    }
}

/// What ends a picture before its end.
#[derive(Debug)]
pub enum Stopped {
    /// The watcher wanted it to stop.
    Cancelled,
    /// Its rows could not be handed on.
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

/// Draws the picture into memory. The same bytes whatever the number of threads.
///
/// # Errors
/// When the watcher wants it to stop.
pub fn render(world: &World, options: &Options, watch: &dyn Watch) -> Result<(Frame, Rays), Cancelled> {
    let mut frame = Frame { width: options.width, height: options.height, pixels: vec![] };
    frame.pixels.reserve_exact(options.width * options.height);
    let rays = draw(world, options, watch, &mut frame).map_err(|_| Cancelled)?;
    Ok((frame, rays))
}

/// Draws the picture and hands its rows on, from the top, as they are done.
///
/// # Errors
/// When the watcher wants it to stop, or the rows can't be handed on.
pub fn draw(world: &World, options: &Options, watch: &dyn Watch, rows: &mut dyn Rows) -> Result<Rays, Stopped> {
    let (width, height) = (options.width, options.height);
    let whole = Region { x: 0, y: 0, width, height };
    let region = options.region.unwrap_or(whole).within(width, height);
    if region.width == 0 || region.height == 0 {
        empty(rows, width, height)?;
        return Ok(Rays::default());
    }
    let workers = Workers::new(options.threads, watch);
    let setup = prepare::prepare(world, options, &workers)?;
    let method = antialias::Method::new(&setup, options);
    empty(rows, width, region.y)?;
    let mut take = |mut pixels: Vec<grid::Pixel>| {
        pixels.iter_mut().for_each(|pixel| *pixel = light(world, options, pixel));
        if region.width == width {
            return rows.take(&pixels);
        }
        // One by one: the rows of the whole picture may be far longer than those of the region.
        let mut whole = vec![[0.0; 4]; width];
        pixels.chunks(region.width).try_for_each(|row| {
            whole[region.x..region.x + region.width].copy_from_slice(row);
            rows.take(&whole)
        })
    };
    let rays = bands::Drawing { setup: &setup, workers: &workers, method, region }.draw(&mut take)?;
    empty(rows, width, height - region.y - region.height)?;
    Ok(rays)
}

/// Transparent rows.
fn empty(to: &mut dyn Rows, width: usize, rows: usize) -> diagnostic::Result<()> {
    let row = vec![[0.0; 4]; if rows > 0 { width } else { 0 }];
    (0..rows).try_for_each(|_| to.take(&row))
}

/// Linear light and alpha of a pixel that [`Watch::keep`] was given.
pub fn light(world: &World, options: &Options, pixel: &[f32; 4]) -> [f32; 4] {
    output::light(pixel, world.gamma, options.alpha)
}

/// The most bytes that drawing a part of a picture takes, beside the World and what becomes of its rows.
pub fn room(part: Region) -> u128 {
    bands::room(part)
}

/// What is seen through one pixel.
#[derive(Clone, Debug, PartialEq)]
pub struct Picked {
    /// The word of the language: `sphere` …
    pub shape: &'static str,
    /// Distance in world space along the unit ray.
    pub t: f64,
    /// World space.
    pub point: [f64; 3],
    /// World space, unit length, as the surface has it (outward).
    pub normal: [f64; 3],
    /// As `uv_mapping` sees it.
    pub uv: [f64; 2],
    /// The text that put it there.
    pub source: Span,
}
