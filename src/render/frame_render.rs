//! One render of a region: computes its tiles, one at a time.

use super::antialias::Method;
use super::pixel_area::{Pixel, PixelArea};
use super::prepare::FrameCamera;
use super::sampler::Sampler;
use super::workers::Workers;
use super::{Cancelled, FINAL_PASS, RayCounts, Region, Tile};
use crate::transport::FrameContext;
use std::sync::atomic::{AtomicUsize, Ordering};

/// Edge of a tile in pixels, except for tiles that are blocks of anti-aliasing.
pub(super) const TILE: usize = 16;

/// One render of a region.
pub(super) struct FrameRender<'a> {
    pub context: &'a FrameContext<'a>,
    pub camera: &'a FrameCamera,
    pub workers: &'a Workers<'a>,
    pub method: Method,
    pub region: Region,
}

impl FrameRender<'_> {
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
        first_samples: &PixelArea,
    ) -> Result<(Vec<Pixel>, RayCounts), Cancelled> {
        let is_cancelled = || self.workers.is_cancelled();
        let mut sampler = Sampler::new(self.context, self.camera, &is_cancelled);
        let pixels = match tile.pass {
            FINAL_PASS => self.method.tile_pixels(&mut sampler, first_samples, tile.area),
            _ => self.method.first_samples(&mut sampler, tile.area),
        };
        // A search that the token has ended returned any result.
        if sampler.is_stopped() || self.workers.is_cancelled() {
            Err(Cancelled)
        } else {
            Ok((pixels, *sampler.counts()))
        }
    }

    /// Returns the number of pixels that both passes of the render compute together, for the display of progress.
    pub fn pixel_count_of_passes(&self) -> usize {
        let pixels = |area: Region| area.width.saturating_mul(area.height);
        pixels(self.region).saturating_add(self.method.first_area(self.region).map_or(0, pixels))
    }
}
