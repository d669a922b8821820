//! From rays to light: shading, shadows, reflection; tiles, anti-aliasing, progress.

mod antialias;
mod area;
mod blur;
mod dispersion;
mod mirror;
mod output;
mod pick;
mod refract;
mod shade;
mod shading_point;
mod shadow;
mod tiles;
mod trace;
mod travel;

pub use pick::pick;

use crate::image_io::Frame;
use crate::source::Span;
use crate::world::World;
use serde::Serialize;
use tiles::Workers;
use trace::Setup;

/// How a picture is made. None of it but size, antialias, quality, region and frame changes a byte of it.
#[derive(Clone, Debug)]
pub struct Options {
    /// Pixels across.
    pub width: usize,
    /// Pixels down.
    pub height: usize,
    /// Threshold of adaptive anti-aliasing; `None` is off.
    pub antialias: Option<f64>,
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
        Self { width, height, antialias: None, quality: 9, threads: 1, region: None, frame: 0, alpha: false }
    }
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

/// Whoever waits for the picture.
pub trait Watch: Sync {
    /// So many pixels of the total are done (with anti-aliasing, both passes count).
    fn progress(&self, done: usize, total: usize);
    /// Should the work stop?
    fn cancelled(&self) -> bool;
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

/// Draws the picture. The same bytes whatever the number of threads.
///
/// # Errors
/// When the watcher wants it to stop.
pub fn render(world: &World, options: &Options, watch: &dyn Watch) -> Result<(Frame, Rays), Cancelled> {
    let Options { width, height, .. } = *options;
    let (mut frame, mut rays) = (Frame::new(width, height), Rays::default());
    let whole = Region { x: 0, y: 0, width, height };
    let region = options.region.unwrap_or(whole).within(width, height);
    if region.width == 0 || region.height == 0 {
        return Ok((frame, rays));
    }
    let setup = Setup::new(world, options);
    let workers = Workers::new(options.threads, antialias::total(&setup, options, region), watch);
    let pixels = antialias::draw(&setup, &workers, options, region, &mut rays)?;
    for (row, line) in pixels.chunks(region.width).enumerate() {
        let start = (region.y + row) * width + region.x;
        for (to, pixel) in frame.pixels[start..].iter_mut().zip(line) {
            *to = output::light(pixel, world.gamma, options.alpha);
        }
    }
    Ok((frame, rays))
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
