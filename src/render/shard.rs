//! Shards: the blocks of one picture, dealt out to several processes that render at the same time.
//!
//! The blocks are numbered along a Hilbert curve (Hilbert 1891), and shard k of n gets every n-th block from the k-th
//! on, so that each shard has blocks from all of the picture and costs about the same. A block is rendered like a region
//! of the picture, with the first samples around it, so that its pixels are those of the whole picture.

use super::frame_render::FrameRender;
use super::pixel_area::{Pixel, PixelArea};
use super::prepare::{self, FrameCamera};
use super::schedule::TileGrid;
use super::workers::Workers;
use super::{
    Cancelled, FINAL_PASS, FIRST_PASS, Options, OutputConversion, RayCounts, Region, Stopped, Tile, Watch, antialias,
};
use crate::diagnostic;
use crate::world::World;
use std::sync::atomic::AtomicUsize;

/// A share of a picture: one of `count` parts that cover the picture together.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, serde::Serialize, serde::Deserialize)]
pub struct Shard {
    /// Number of the shard, from 1 to `count`.
    pub index: usize,
    /// Number of shards of the picture.
    pub count: usize,
}

/// Edges of blocks in pixels, the largest first. Large blocks sample fewer pixels twice at their borders.
const EDGES: [usize; 3] = [64, 32, 16];
/// Number of blocks for each shard above which a larger edge is chosen, so that shards cost about the same.
const BLOCKS_PER_SHARD: usize = 16;
/// Number of blocks that are rendered together and then passed on, which bounds the memory.
const BATCH: usize = 256;

/// Receives the linear light of a block, row by row.
pub type BlockReceiver<'a> = dyn FnMut(Region, &[[f32; 4]]) -> diagnostic::Result<()> + Send + 'a;

/// Returns the edge of the blocks of a picture, in pixels. The corners of blocks are at multiples of the edge.
pub fn block_edge(options: &Options, shard_count: usize) -> usize {
    let region = options.rendered_region();
    let n_blocks = |edge: usize| region.width.div_ceil(edge) * region.height.div_ceil(edge);
    // The grid of anti-aliasing compares pixels within blocks of its own.
    let is_whole = |edge: usize| edge.is_multiple_of(antialias::antialias_block_edge(options).unwrap_or(1));
    let allowed = || EDGES.into_iter().filter(|&edge| is_whole(edge));
    let fitting = allowed().find(|&edge| n_blocks(edge) >= BLOCKS_PER_SHARD.saturating_mul(shard_count));
    fitting.or(allowed().next_back()).unwrap_or(EDGES[0])
}

/// Returns the blocks of a shard, in the order in which they are rendered, for a region of a picture of `size` and
/// blocks of `edge` pixels.
pub fn shard_blocks(size: [usize; 2], region: Region, edge: usize, shard: Shard) -> Vec<Region> {
    let mut blocks: Vec<Region> = TileGrid::new(region, edge).tiles().collect();
    let side = size[0].max(size[1]).div_ceil(edge).next_power_of_two();
    blocks.sort_by_key(|block| hilbert_index(side, block.x / edge, block.y / edge));
    blocks.into_iter().skip(shard.index - 1).step_by(shard.count).collect()
}

/// Returns the blocks of a shard of a picture with these options.
fn blocks_of(options: &Options, shard: Shard) -> Vec<Region> {
    let edge = block_edge(options, shard.count);
    shard_blocks([options.width, options.height], options.rendered_region(), edge, shard)
}

/// Returns the position of the cell (x, y) along the Hilbert curve through a square of `side` × `side` cells; `side` is a
/// power of two.
fn hilbert_index(side: usize, x: usize, y: usize) -> usize {
    let (mut x, mut y, mut index) = (x, y, 0);
    let mut half = side / 2;
    while half > 0 {
        let (right, lower) = (usize::from(x & half > 0), usize::from(y & half > 0));
        index += half * half * ((3 * right) ^ lower);
        // Turn the quadrant so that its part of the curve begins at the origin
        if lower == 0 {
            if right == 1 {
                (x, y) = (side - 1 - x, side - 1 - y);
            }
            (x, y) = (y, x);
        }
        half /= 2;
    }
    index
}

/// Renders the blocks of a shard and passes each to `receiver`, in the order of [`shard_blocks`]. Finished blocks are
/// loaded from and stored by `watch` as tiles of the final pass.
///
/// # Errors
/// [`Stopped`] if `watch` cancels the render or `receiver` fails.
pub fn draw_shard(
    world: &World,
    options: &Options,
    shard: Shard,
    watch: &dyn Watch,
    receiver: &mut BlockReceiver,
) -> Result<RayCounts, Stopped> {
    let blocks = blocks_of(options, shard);
    let mut counts = RayCounts::default();
    if blocks.is_empty() {
        return Ok(counts);
    }
    let workers = Workers::new(options.threads, watch);
    let camera = FrameCamera::new(&world.eye, options.width, options.height);
    let context = prepare::prepare(world, &camera, options, &workers)?;
    let method = antialias::Method::new(world, camera.lens.as_ref(), options);
    let region = options.rendered_region();
    let frame = FrameRender { context: &context, camera: &camera, workers: &workers, method, region };
    let (n_done, total) = (AtomicUsize::new(0), blocks.iter().map(Region::n_pixels).sum());
    let mut finished: Vec<(Region, Vec<Pixel>)> = vec![];
    let conversion = OutputConversion::new(world, options);
    let mut pass_on = |blocks: &mut Vec<(Region, Vec<Pixel>)>| {
        blocks.drain(..).try_for_each(|(area, mut pixels)| {
            pixels.iter_mut().for_each(|pixel| *pixel = conversion.to_linear_rgba(pixel));
            receiver(area, &pixels)
        })
    };
    for batch in blocks.chunks(BATCH) {
        let work = |area: &Region| frame.load_or_render_block(*area, &n_done, total);
        let (results, passed_on) = workers.map(batch, work, || pass_on(&mut finished));
        passed_on?;
        for (area, (pixels, cast)) in batch.iter().zip(results?) {
            counts.add(&cast);
            finished.push((*area, pixels));
        }
    }
    pass_on(&mut finished)?;
    Ok(counts)
}

impl FrameRender<'_> {
    /// Loads a block from an earlier run, or renders and stores it.
    fn load_or_render_block(
        &self,
        area: Region,
        n_done: &AtomicUsize,
        total: usize,
    ) -> Result<(Vec<Pixel>, RayCounts), Cancelled> {
        self.load_or_render(Tile { pass: FINAL_PASS, area }, n_done, total, || {
            let mut counts = RayCounts::default();
            let mut render = |pass, area, first_samples: &PixelArea| -> Result<Vec<Pixel>, Cancelled> {
                let (pixels, cast) = self.render_tile(&Tile { pass, area }, first_samples)?;
                counts.add(&cast);
                Ok(pixels)
            };
            let around = self.method.first_area(area);
            let mut first_samples = PixelArea::black(Region { height: 0, ..area });
            if let Some(around) = around {
                first_samples = PixelArea { area: around, pixels: render(FIRST_PASS, around, &first_samples)? };
            }
            let mut pixels = PixelArea::black(area);
            let edge = self.method.antialias_block_edge().unwrap_or(EDGES[0]);
            for part in TileGrid::new(area, edge).tiles() {
                pixels.put(part, &render(FINAL_PASS, part, &first_samples)?);
            }
            Ok((pixels.pixels, counts))
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::collections::HashSet;

    fn options(width: usize, height: usize) -> Options {
        Options::new(width, height)
    }

    #[test]
    fn the_curve_visits_each_cell_once_and_steps_to_neighbours() {
        let side = 16;
        let mut cells = vec![None; side * side];
        for y in 0..side {
            for x in 0..side {
                assert!(cells[hilbert_index(side, x, y)].replace((x, y)).is_none());
            }
        }
        let cells: Vec<(usize, usize)> = cells.into_iter().flatten().collect();
        assert!(cells.windows(2).all(|pair| pair[0].0.abs_diff(pair[1].0) + pair[0].1.abs_diff(pair[1].1) == 1));
    }

    #[test]
    fn shards_cover_the_region_once() {
        for (count, region) in [(1, None), (7, None), (16, Some(Region { x: 13, y: 40, width: 101, height: 55 }))] {
            let options = Options { region, ..options(300, 170) };
            let mut pixels = HashSet::new();
            for index in 1..=count {
                for block in blocks_of(&options, Shard { index, count }) {
                    for y in block.y..block.y + block.height {
                        (block.x..block.x + block.width).for_each(|x| assert!(pixels.insert((x, y))));
                    }
                }
            }
            let whole = options.rendered_region();
            assert_eq!(pixels.len(), whole.width * whole.height);
        }
    }

    #[test]
    fn shards_have_about_the_same_number_of_pixels() {
        for count in [2, 8, 64] {
            let n_pixels = |index| {
                let blocks = blocks_of(&options(1280, 720), Shard { index, count });
                blocks.iter().map(Region::n_pixels).sum::<usize>()
            };
            let (least, most) = ((1..=count).map(n_pixels).min(), (1..=count).map(n_pixels).max());
            assert!(most.unwrap_or(0) as f64 <= 1.3 * least.unwrap_or(0) as f64, "{count}: {least:?} {most:?}");
        }
    }
}
