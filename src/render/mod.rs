//! From rays to light: shading, shadows, reflection; tiles, anti-aliasing, progress.

use crate::image_io::Frame;
use crate::source::Span;
use crate::world::World;
use serde::Serialize;

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

/// Draws the picture.
pub fn render(_world: &World, options: &Options, _watch: &dyn Watch) -> Result<(Frame, Rays), Cancelled> {
    Ok((Frame::new(options.width, options.height), Rays::default()))
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

/// The nearest thing through the centre of pixel (x, y) counted from the top left.
pub fn pick(_world: &World, _options: &Options, _x: usize, _y: usize) -> Option<Picked> {
    None
}
