//! Work for many threads: the only file that knows rayon. Results come back in the order of the tiles, so the picture
//! never depends on who did what.

use super::trace::{Setup, Tracer};
use super::{Cancelled, Rays, Region, Watch};
use rayon::prelude::*;
use std::sync::atomic::{AtomicUsize, Ordering};

/// Edge of a tile in pixels.
const TILE: usize = 16;
const STACK: usize = 16 << 20;

/// Red, green, blue and what shows of the background, in the numbers of the scene.
pub(super) type Pixel = [f32; 4];

/// The threads, who waits for them, and how far they are.
pub(super) struct Workers<'a> {
    pool: Option<rayon::ThreadPool>,
    watch: &'a dyn Watch,
    done: AtomicUsize,
    total: usize,
}

impl<'a> Workers<'a> {
    /// So many threads (0: one for each processor) for so many pixels in all.
    pub fn new(threads: usize, total: usize, watch: &'a dyn Watch) -> Self {
        let builder = rayon::ThreadPoolBuilder::new().num_threads(threads).stack_size(STACK);
        // A system that gives no threads still gets its picture.
        Self { pool: builder.build().ok(), watch, done: AtomicUsize::new(0), total }
    }

    /// Computes every pixel of an area, row by row; `pixel` gets a tracer and the pixel's place.
    pub fn draw(
        &self,
        setup: &Setup,
        area: Region,
        rays: &mut Rays,
        pixel: impl Fn(&mut Tracer, usize, usize) -> Pixel + Sync,
    ) -> Result<Vec<Pixel>, Cancelled> {
        let tiles = tiles(area);
        let work = |tile: &Region| {
            if self.watch.cancelled() {
                return Err(Cancelled);
            }
            let mut tracer = Tracer::new(setup, Some(self.watch));
            let mut pixels = Vec::with_capacity(tile.width * tile.height);
            for y in tile.y..tile.y + tile.height {
                pixels.extend((tile.x..tile.x + tile.width).map(|x| pixel(&mut tracer, x, y)));
                if tracer.stopped() {
                    return Err(Cancelled);
                }
            }
            let done = self.done.fetch_add(pixels.len(), Ordering::Relaxed) + pixels.len();
            self.watch.progress(done, self.total);
            Ok((pixels, tracer.rays))
        };
        let done: Vec<_> = match &self.pool {
            Some(pool) => pool.install(|| tiles.par_iter().with_max_len(1).map(work).collect::<Result<_, _>>())?,
            None => tiles.iter().map(work).collect::<Result<_, _>>()?,
        };
        let mut out = vec![[0.0; 4]; area.width * area.height];
        for (tile, (pixels, cast)) in tiles.iter().zip(done) {
            for (row, line) in pixels.chunks(tile.width).enumerate() {
                let start = (tile.y - area.y + row) * area.width + tile.x - area.x;
                out[start..start + tile.width].copy_from_slice(line);
            }
            rays.add(&cast);
        }
        Ok(out)
    }
}

/// The area in tiles, row by row.
fn tiles(area: Region) -> Vec<Region> {
    let mut out = vec![];
    for y in (0..area.height).step_by(TILE) {
        for x in (0..area.width).step_by(TILE) {
            let (width, height) = (TILE.min(area.width - x), TILE.min(area.height - y));
            out.push(Region { x: area.x + x, y: area.y + y, width, height });
        }
    }
    out
}
