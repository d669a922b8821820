//! Renders a picture in scanline bands from the top. Each finished band is passed on, so that a large picture needs
//! memory for a few bands only. While the final pass works on one band, the first pass works on the next.

use super::antialias::Method;
use super::pixel_rows::{Pixel, PixelRows};
use super::prepare::FrameCamera;
use super::sampler::Sampler;
use super::workers::Workers;
use super::{Cancelled, FINAL_PASS, FIRST_PASS, RayCounts, Region, Stopped, Tile};
use crate::diagnostic;
use crate::transport::FrameContext;
use std::ops::Range;
use std::sync::atomic::{AtomicUsize, Ordering};

/// Edge of a tile in pixels.
const TILE: usize = 16;
/// Approximate number of pixels in a band, which is at least one row: enough work for many threads.
const BAND: usize = 1 << 18;
/// Memory for each pixel of a band, in bytes: in the tiles of both passes and twice in the rows of both.
const BYTES_PER_PIXEL: u128 = 6 * size_of::<Pixel>() as u128;

/// Returns the number of rows of each band of an area.
fn rows_per_band(area: Region) -> usize {
    let bands = area.width.saturating_mul(area.height).div_ceil(BAND).max(1);
    let rows = area.height.div_ceil(bands).max(1);
    if rows < TILE { rows } else { rows.next_multiple_of(TILE) }
}

/// Returns the maximum memory for the bands of an area, in bytes.
pub(super) fn memory_bytes(area: Region) -> u128 {
    area.width as u128 * rows_per_band(area).min(area.height) as u128 * BYTES_PER_PIXEL
}

/// One render of a region.
pub(super) struct FrameRender<'a> {
    pub context: &'a FrameContext<'a>,
    pub camera: &'a FrameCamera,
    pub workers: &'a Workers<'a>,
    pub method: Method,
    pub region: Region,
}

/// Receives the pixels of whole rows of the region.
pub(super) type RowReceiver<'a> = dyn FnMut(Vec<Pixel>) -> diagnostic::Result<()> + Send + 'a;

impl FrameRender<'_> {
    /// Renders every pixel of the region and passes the rows to `receiver`.
    pub fn run(&self, receiver: &mut RowReceiver) -> Result<RayCounts, Stopped> {
        let (region, area) = (self.region, self.first_area());
        let rows = rows_per_band(region);
        let (mut counts, n_done) = (RayCounts::default(), AtomicUsize::new(0));
        let mut first_samples = PixelRows::new(area.unwrap_or(Region { height: 0, ..region }));
        let (mut next_row, mut finished) = (region.y, vec![]);
        while next_row < region.y + region.height {
            // Tiles of both passes that can be rendered now
            let bottom = first_samples.end_row();
            let first_rows = area.map_or(0..0, |area| bottom..(bottom + rows).min(area.y + area.height));
            let final_rows = next_row..self.final_rows_end(&first_samples, next_row, rows);
            let tile = |pass| move |area| Tile { pass, area };
            let jobs: Vec<Tile> = tiles(&first_samples.area, first_rows.clone(), TILE)
                .map(tile(FIRST_PASS))
                .chain(tiles(&region, final_rows.clone(), self.tile_edge()).map(tile(FINAL_PASS)))
                .collect();
            // Render them while the rows of the band before are passed on
            let band_before = std::mem::take(&mut finished);
            let pass_on = || if band_before.is_empty() { Ok(()) } else { receiver(band_before) };
            let render = |job: &Tile| {
                self.load_or_render(*job, &n_done, self.pixel_count_of_passes(), || {
                    self.render_tile(job, &first_samples)
                })
            };
            let (tiles, passed_on) = self.workers.map(&jobs, render, pass_on);
            passed_on?;
            // Collect the results
            let mut band = PixelRows::new(Region { height: 0, y: final_rows.start, ..region });
            first_samples.add_black_rows(first_rows.len());
            band.add_black_rows(final_rows.len());
            for (job, (pixels, cast)) in jobs.iter().zip(tiles?) {
                if job.pass == FINAL_PASS { &mut band } else { &mut first_samples }.put(job.area, &pixels);
                counts.add(&cast);
            }
            (next_row, finished) = (final_rows.end, band.pixels);
            first_samples
                .drop_above((next_row / self.final_rows_per_group() * self.final_rows_per_group()).saturating_sub(1));
        }
        receiver(finished)?;
        Ok(counts)
    }

    /// Returns the end of the rows for which the final pass has the first samples around each pixel.
    fn final_rows_end(&self, first_samples: &PixelRows, next_row: usize, max_rows: usize) -> usize {
        let end = self.region.y + self.region.height;
        let alignment = self.final_rows_per_group();
        match self.first_area() {
            None => (next_row + max_rows).min(end),
            Some(area) if first_samples.end_row() == area.y + area.height => end,
            Some(_) => (first_samples.end_row().saturating_sub(1) / alignment * alignment).clamp(next_row, end),
        }
    }

    /// Loads a tile from an earlier run, or computes it with `render` and stores it. `n_done` and `total` are the pixels
    /// of finished and of all tiles.
    pub(super) fn load_or_render(
        &self,
        tile: Tile,
        n_done: &AtomicUsize,
        total: usize,
        render: impl FnOnce() -> Result<(Vec<Pixel>, RayCounts), Cancelled>,
    ) -> Result<(Vec<Pixel>, RayCounts), Cancelled> {
        let watch = self.workers.watch;
        let (pixels, counts) = match watch.load_tile(tile) {
            Some(pixels) if pixels.len() == tile.area.n_pixels() => (pixels, RayCounts::default()),
            _ => {
                let rendered = render()?;
                watch.store_tile(tile, &rendered.0);
                rendered
            }
        };
        let n_done = n_done.fetch_add(pixels.len(), Ordering::Relaxed) + pixels.len();
        watch.progress(n_done, total);
        Ok((pixels, counts))
    }

    /// Renders a tile of either pass; the final pass needs the first samples around the tile.
    pub(super) fn render_tile(
        &self,
        tile: &Tile,
        first_samples: &PixelRows,
    ) -> Result<(Vec<Pixel>, RayCounts), Cancelled> {
        let is_cancelled = || self.workers.is_cancelled();
        let mut sampler = Sampler::new(self.context, self.camera, &is_cancelled);
        let pixels = match tile.pass {
            FINAL_PASS => self.method.tile_pixels(&mut sampler, first_samples, tile.area),
            _ => self.first_pass_tile(&mut sampler, &tile.area),
        };
        // A search that the token has ended returned any result.
        if sampler.is_stopped() || self.workers.is_cancelled() {
            Err(Cancelled)
        } else {
            Ok((pixels, *sampler.counts()))
        }
    }

    /// Returns the area of the first pass; `None` for methods of one pass.
    fn first_area(&self) -> Option<Region> {
        self.method.first_area(self.region)
    }

    /// Returns the number of rows in each group that the final pass computes together.
    fn final_rows_per_group(&self) -> usize {
        self.method.antialias_block_edge().unwrap_or(1)
    }

    /// Returns the edge of the tiles of the final pass, in pixels.
    fn tile_edge(&self) -> usize {
        self.method.antialias_block_edge().unwrap_or(TILE)
    }

    fn first_pass_tile(&self, sampler: &mut Sampler, area: &Region) -> Vec<Pixel> {
        let mut pixels = Vec::with_capacity(area.n_pixels());
        for y in area.y..area.y + area.height {
            pixels.extend((area.x..area.x + area.width).map(|x| self.method.first_sample(sampler, x, y)));
            if sampler.is_stopped() {
                break;
            }
        }
        pixels
    }

    /// Returns the number of pixels that both passes of the render compute together, for the display of progress.
    fn pixel_count_of_passes(&self) -> usize {
        let pixels = |area: Region| area.width.saturating_mul(area.height);
        pixels(self.region).saturating_add(self.first_area().map_or(0, pixels))
    }
}

/// Splits rows of an area into tiles whose corners are at multiples of `edge`.
pub(super) fn tiles(area: &Region, rows: Range<usize>, edge: usize) -> impl Iterator<Item = Region> + use<> {
    let cuts = move |range: Range<usize>| {
        let first = if range.is_empty() { range.end } else { range.start / edge * edge };
        let starts = (first..range.end).step_by(edge);
        starts.map(move |start| start.max(range.start)..(start + edge).min(range.end))
    };
    let columns = area.x..area.x + area.width;
    cuts(rows).flat_map(move |rows| {
        let tile = move |x: Range<usize>| Region { x: x.start, y: rows.start, width: x.len(), height: rows.len() };
        cuts(columns.clone()).map(tile)
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn bands_bound_the_memory_of_large_pictures() {
        let rows = |width, height| rows_per_band(Region { x: 0, y: 0, width, height });
        assert_eq!((rows(640, 480), rows(3840, 2160), rows(1 << 30, 5), rows(1, 1)), (240, 80, 1, 1));
        assert!(memory_bytes(Region { x: 0, y: 0, width: 3840, height: 2160 }) < 32 << 20);
    }

    #[test]
    fn tiles_cover_their_rows_once() {
        let area = Region { x: 3, y: 5, width: 40, height: 100 };
        let mut counts = PixelRows::new(Region { height: 0, y: 10, ..area });
        counts.add_black_rows(37);
        for tile in tiles(&area, 10..47, 16) {
            for y in tile.y..tile.y + tile.height {
                for x in tile.x..tile.x + tile.width {
                    let count = counts.at(x, y)[0] + 1.0;
                    counts.put(Region { x, y, width: 1, height: 1 }, &[[count; 4]]);
                }
            }
        }
        assert!(counts.pixels.iter().all(|p| p[0] == 1.0) && counts.pixels.len() == 40 * 37);
        assert_eq!(tiles(&area, 10..10, 16).count(), 0);
    }
}
