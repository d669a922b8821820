//! Passes that collect samples of radiosity (manual, "Radiosity"): rays through a grid of points of the picture, from
//! coarse to fine, and then through each pixel, to find the points without any sample.
//!
//! The order of the points is scattered over the picture, so that the points of a batch, which do not share their samples,
//! are far from each other. All points of the picture are visited, whatever region is rendered.

use super::prepare::{FrameCamera, Pass, Preparation, preparation_options};
use super::sampler::Sampler;
use super::{Cancelled, Options};
use crate::math::{GOLDEN_SECTION, next_coprime};
use crate::scene::Radiosity;
use crate::transport::{FrameContext, RadiosityPass};

/// Divisor of the number of known radiosity samples that gives the number of jobs of the next batch.
const BATCH_SHARE: usize = 16;
/// Minimum number of jobs of a batch of radiosity. The first job computes most samples of deeper bounces, which the
/// next jobs reuse.
const MIN_BATCH: usize = 1;
/// Maximum number of jobs of a batch of radiosity; the jobs of one batch do not use each other's samples.
const MAX_BATCH: usize = 512;
/// Edge in pixels of the squares of the picture that are the work items of the last radiosity pass, which looks for
/// points without a usable sample.
const GAP_SQUARE: usize = 8;

/// Collects the radiosity samples of a frame; does nothing in a scene without radiosity. Samples loaded from a file are
/// added first, and replace all passes if the same computation saved them.
pub(super) fn collect(
    context: &mut FrameContext,
    camera: &FrameCamera,
    options: &Options,
    preparation: &Preparation,
) -> Result<(), Cancelled> {
    let Some(settings) = context.world.radiosity.as_deref() else { return Ok(()) };
    let Some(state) = &mut context.radiosity else { return Ok(()) };
    let world = context.world;
    // Digests of the scene and the computation, for samples in files
    let digests = || {
        let scene = world.scene_digest();
        [scene, world.radiosity_digest(&scene, &preparation_options(options))]
    };
    let file = settings.saved.loaded.as_ref().map(|loaded| &loaded.file);
    let is_complete = file.is_some_and(|file| file.header.computation == digests()[1]);
    file.iter().for_each(|file| state.add_file(file));
    if !is_complete {
        run_passes(context, camera, options, settings, preparation)?;
    }
    if let Some(radiosity) = &mut context.radiosity {
        radiosity.begin_pass(RadiosityPass::Final);
        if let Some(save) = &settings.saved.save {
            preparation.save_light(save, &|out| radiosity.save(digests(), out))?;
        }
    }
    Ok(())
}

/// Runs all radiosity passes of a frame, which collect the radiosity samples.
fn run_passes(
    context: &mut FrameContext,
    camera: &FrameCamera,
    options: &Options,
    settings: &Radiosity,
    preparation: &Preparation,
) -> Result<(), Cancelled> {
    let mut n_passes = 0;
    let mut pass = |context: &mut FrameContext, kind, step, edge| {
        n_passes += 1;
        let grid = PointGrid { size: [options.width, options.height], step, edge };
        run_pass(context, camera, preparation, kind, grid, n_passes)
    };
    let end = (settings.pretrace_end * options.width as f64).max(1.0);
    let mut step = (settings.pretrace_start * options.width as f64).max(end);
    loop {
        pass(context, RadiosityPass::Collect, step, 1)?;
        if step <= end {
            break;
        }
        step = (step / 2.0).max(end);
    }
    pass(context, RadiosityPass::FillGaps, 1.0, GAP_SQUARE)
}

/// Traces the camera rays of one radiosity pass, and adds the radiosity samples that they gathered to those of the
/// frame.
fn run_pass(
    context: &mut FrameContext,
    camera: &FrameCamera,
    preparation: &Preparation,
    kind: RadiosityPass,
    grid: PointGrid,
    number: u64,
) -> Result<(), Cancelled> {
    if let Some(radiosity) = &mut context.radiosity {
        radiosity.begin_pass(kind);
    }
    let n_samples = |context: &FrameContext| context.radiosity.as_ref().map_or(0, |radiosity| radiosity.n_samples());
    let is_cancelled = || preparation.is_cancelled();
    let work = |context: &FrameContext, cell: &[u32; 2]| {
        let mut sampler = Sampler::new(context, camera, &is_cancelled);
        for [x, y] in grid.pixel_positions(*cell) {
            // Random numbers are keyed by the point and the pass.
            sampler.begin_sample(x.to_bits() ^ y.to_bits().rotate_left(32), u64::MAX - number);
            sampler.sample(x, y);
            if sampler.is_stopped() {
                return Err(Cancelled);
            }
        }
        Ok(sampler.take_radiosity_samples())
    };
    preparation.run_pass_in_batches(
        &Pass { name: "radiosity", jobs: &grid.cells_in_spread_order() },
        context,
        |context| (n_samples(context) / BATCH_SHARE).clamp(MIN_BATCH, MAX_BATCH),
        work,
        |context, samples| {
            if let Some(radiosity) = &mut context.radiosity {
                radiosity.merge(samples);
            }
        },
    )
}

/// Grid of points of the picture through which a radiosity pass traces camera rays; each of its cells is a work item.
/// The points of a cell are computed when the cell is visited, to save memory.
#[derive(Clone, Copy, Debug)]
struct PointGrid {
    /// Width and height of the picture in pixels.
    size: [usize; 2],
    /// Distance between neighbouring points in pixels.
    step: f64,
    /// Number of columns and of rows of points in a cell.
    edge: usize,
}

impl PointGrid {
    /// Returns the number of columns and rows of points.
    fn point_columns_and_rows(&self) -> [usize; 2] {
        self.size.map(|size| (size as f64 / self.step).ceil().max(1.0) as usize)
    }

    /// Returns all cells by column and row, in an order in which each part of the list is spread over the picture: the
    /// places in the list are multiples of a number near the golden section of its length, coprime to the length.
    fn cells_in_spread_order(&self) -> Vec<[u32; 2]> {
        let [columns, rows] = self.point_columns_and_rows().map(|n| n.div_ceil(self.edge));
        let n = columns * rows;
        let first = ((n as f64 * GOLDEN_SECTION) as usize).max(1);
        let step = next_coprime(first, n);
        let cell = |i: usize| (i as u128 * step as u128 % n as u128) as usize;
        (0..n).map(cell).map(|cell| [(cell % columns) as u32, (cell / columns) as u32]).collect()
    }

    /// Returns the points of a cell, (x, y) in pixels, row by row.
    fn pixel_positions(self, cell: [u32; 2]) -> impl Iterator<Item = [f64; 2]> {
        let across = self.point_columns_and_rows();
        let range = |i: usize| {
            let first = cell[i] as usize * self.edge;
            first..(first + self.edge).min(across[i])
        };
        let center = move |i: usize, k: usize| ((k as f64 + 0.5) * self.step).min(self.size[i] as f64 - 0.5);
        let columns = range(0);
        range(1).flat_map(move |y| columns.clone().map(move |x| [center(0, x), center(1, y)]))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_cell_and_each_pixel_comes_once() {
        for size in [[1, 1], [1, 7], [13, 10], [16, 16], [21, 34]] {
            for edge in [1, 8] {
                let grid = PointGrid { size, step: 1.0, edge };
                let mut points: Vec<_> =
                    grid.cells_in_spread_order().into_iter().flat_map(|cell| grid.pixel_positions(cell)).collect();
                points.sort_by(|a, b| a[1].total_cmp(&b[1]).then(a[0].total_cmp(&b[0])));
                let pixel = |i: usize| [(i % size[0]) as f64 + 0.5, (i / size[0]) as f64 + 0.5];
                assert_eq!(points, (0..size[0] * size[1]).map(pixel).collect::<Vec<_>>());
            }
        }
    }

    #[test]
    fn coarse_grids_stay_in_the_picture() {
        let grid = PointGrid { size: [20, 13], step: 8.0, edge: 1 };
        let points: Vec<_> =
            grid.cells_in_spread_order().into_iter().flat_map(|cell| grid.pixel_positions(cell)).collect();
        assert_eq!(points.len(), 6);
        assert!(points.iter().all(|[x, y]| *x < 20.0 && *y < 13.0));
    }
}
