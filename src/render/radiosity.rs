//! Passes that collect samples of radiosity (manual, "Radiosity"): rays through a grid of points of the picture, from
//! coarse to fine, and then through each pixel, to find the points without any sample.
//!
//! The order of the points is scattered over the picture, so that the points of a batch, which do not share their samples,
//! are far from each other. All points of the picture are visited, whatever region is rendered.

use super::prepare::{FrameCamera, Pass, Preparation};
use super::sampler::Sampler;
use super::{Cancelled, Options};
use crate::transport::{FrameContext, RadiosityPass};

/// Share of the number of known samples by which a batch may add samples.
const BATCH_SHARE: usize = 16;
/// Minimum number of jobs of a batch. The first job computes most samples of deeper bounces, which the next jobs reuse.
const MIN_BATCH: usize = 1;
/// Maximum number of jobs of a batch.
const MAX_BATCH: usize = 512;
/// Edge in pixels of the squares in which gaps are searched.
const GAP_SQUARE: usize = 8;

/// Points of the picture that one work item visits: (x, y) in pixels.
type Points = Vec<[f64; 2]>;

/// Collects the samples of a frame; does nothing without radiosity.
pub(super) fn collect(
    context: &mut FrameContext,
    camera: &FrameCamera,
    options: &Options,
    preparation: &Preparation,
) -> Result<(), Cancelled> {
    let Some(settings) = context.world.radiosity.as_deref().filter(|_| context.radiosity.is_some()) else {
        return Ok(());
    };
    let mut n_passes = 0;
    let mut pass = |context: &mut FrameContext, kind, jobs: &[Points]| {
        n_passes += 1;
        run_pass(context, camera, preparation, kind, jobs, n_passes)
    };
    let end = (settings.pretrace_end * options.width as f64).max(1.0);
    let mut step = (settings.pretrace_start * options.width as f64).max(end);
    loop {
        pass(context, RadiosityPass::Collect, &grid_points(options, step))?;
        if step <= end {
            break;
        }
        step = (step / 2.0).max(end);
    }
    // (Finding the interiors around each origin of a mesh camera takes longer than to fill gaps ray by ray.)
    if camera.view.common_origin().is_some() {
        pass(context, RadiosityPass::FillGaps, &gap_squares(options))?;
    }
    if let Some(radiosity) = &mut context.radiosity {
        radiosity.begin(RadiosityPass::Final);
    }
    Ok(())
}

/// Traces the camera rays of a pass, and merges the samples that they gathered.
fn run_pass(
    context: &mut FrameContext,
    camera: &FrameCamera,
    preparation: &Preparation,
    kind: RadiosityPass,
    jobs: &[Points],
    number: u64,
) -> Result<(), Cancelled> {
    if let Some(radiosity) = &mut context.radiosity {
        radiosity.begin(kind);
    }
    let n_samples = |context: &FrameContext| context.radiosity.as_ref().map_or(0, |radiosity| radiosity.n_samples());
    let is_cancelled = || preparation.is_cancelled();
    let work = |context: &FrameContext, points: &Points| {
        let mut sampler = Sampler::new(context, camera, &is_cancelled);
        for &[x, y] in points {
            // Random numbers are keyed by the point and the pass.
            sampler.begin_sample(x.to_bits() ^ y.to_bits().rotate_left(32), u64::MAX - number);
            sampler.sample(x, y);
            if sampler.is_stopped() {
                return Err(Cancelled);
            }
        }
        Ok(sampler.take_radiosity_samples())
    };
    preparation.pass_in_batches(
        &Pass { name: "radiosity", jobs },
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

/// Returns the centres of squares of `step` pixels that cover the picture, in a scattered order.
fn grid_points(options: &Options, step: f64) -> Vec<Points> {
    let columns = (options.width as f64 / step).ceil().max(1.0) as usize;
    let rows = (options.height as f64 / step).ceil().max(1.0) as usize;
    let center = |i: usize, size: usize| ((i as f64 + 0.5) * step).min(size as f64 - 0.5);
    scattered(columns, rows).map(|[i, j]| vec![[center(i, options.width), center(j, options.height)]]).collect()
}

/// Returns the centres of all pixels, square by square, in a scattered order of the squares.
fn gap_squares(options: &Options) -> Vec<Points> {
    let (columns, rows) = (options.width.div_ceil(GAP_SQUARE), options.height.div_ceil(GAP_SQUARE));
    let square = |[i, j]: [usize; 2]| {
        let range = |k: usize, size: usize| k * GAP_SQUARE..((k + 1) * GAP_SQUARE).min(size);
        let row = |y: usize| range(i, options.width).map(move |x| [x as f64 + 0.5, y as f64 + 0.5]);
        range(j, options.height).flat_map(row).collect()
    };
    scattered(columns, rows).map(square).collect()
}

/// Returns all cells of a grid in an order in which each part of the list is spread over the grid: the steps are the golden
/// section of the number of cells, made coprime to that number.
fn scattered(columns: usize, rows: usize) -> impl Iterator<Item = [usize; 2]> {
    let n = columns * rows;
    let mut step = ((n as f64 * 0.618_033_988_749_894_9) as usize).max(1);
    while greatest_common_divisor(step, n) != 1 {
        step += 1;
    }
    (0..n)
        .map(move |i| (i as u128 * step as u128 % n as u128) as usize)
        .map(move |cell| [cell % columns, cell / columns])
}

fn greatest_common_divisor(a: usize, b: usize) -> usize {
    if b == 0 { a } else { greatest_common_divisor(b, a % b) }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_cell_comes_once() {
        for [columns, rows] in [[1, 1], [1, 7], [13, 10], [16, 16], [21, 34]] {
            let mut cells: Vec<_> = scattered(columns, rows).collect();
            cells.sort_unstable();
            cells.dedup();
            assert_eq!(cells.len(), columns * rows);
        }
    }

    #[test]
    fn gaps_are_searched_in_every_pixel() {
        let points: usize = gap_squares(&Options::new(20, 13)).iter().map(Vec::len).sum();
        assert_eq!(points, 260);
        assert!(grid_points(&Options::new(20, 13), 8.0).iter().flatten().all(|[x, y]| *x < 20.0 && *y < 13.0));
    }
}
