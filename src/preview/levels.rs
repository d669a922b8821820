//! Progressive rendering: the whole picture in low resolutions first, then all pixels tile by tile.

use super::screen::{Image, Screen, View};
use crate::diagnostic;
use crate::image_io::Rows;
use crate::math::cancel::CancelToken;
use crate::render::{self, Options, OutputConversion, RayCounts, Region, Stopped, Tile, Watch};
use crate::world::World;
use std::time::{Duration, Instant};

/// Largest number of pixels of the first, coarsest picture of a progressive render.
const FIRST_PIXELS: usize = 2_000;
/// Factor of the number of pixels from one picture of a progressive render to the next finer one.
const LEVEL_FACTOR: usize = 16;
/// Estimated time of the full resolution, in seconds, below which a progressive render skips the remaining coarse
/// pictures.
const SHORT: f64 = 0.3;

/// Renders all levels and the full resolution to the screen, until `cancel` is cancelled; pixels outside of the region
/// in `options` are not displayed. Returns the number of rays of the full resolution, and the duration of the first level,
/// 0 if there was only the full resolution.
///
/// # Errors
/// If `cancel` was cancelled, or rendering fails.
pub fn render_levels_timing_first(
    world: &World,
    options: &Options,
    screen: &Screen,
    cancel: &CancelToken,
) -> Result<(RayCounts, Duration), Stopped> {
    let (begin, mut first) = (Instant::now(), None);
    let whole = Region { x: 0, y: 0, width: options.width, height: options.height };
    let area = options.region.unwrap_or(whole);
    // Cancelled work may go on for a while beside the next one, which then owns the screen.
    let check = || if cancel.is_cancelled() { Err(Stopped::Cancelled) } else { Ok(()) };
    check()?;
    screen.begin_picture(View { area });
    let pixels = area.width * area.height;
    let mut count = FIRST_PIXELS;
    while count < pixels {
        let start = Instant::now();
        let image = render_coarse(world, options, area, (count as f64 / pixels as f64).sqrt(), cancel)?;
        let rate = start.elapsed().as_secs_f64() / (image.width * image.height).max(1) as f64;
        check()?;
        screen.put_coarse(image);
        first.get_or_insert_with(|| begin.elapsed());
        count *= LEVEL_FACTOR;
        if rate * (pixels as f64) < SHORT || rate * (count as f64) > rate * (pixels as f64) / 3.0 {
            break;
        }
    }
    let watch = TileDisplay { world, options, screen, cancel };
    let rays = render::draw(world, options, &watch, &mut Discard)?;
    check()?;
    screen.mark_finished();
    Ok((rays, first.unwrap_or_default()))
}

/// Renders `area` with a resolution multiplied by `scale`, one sample a pixel.
fn render_coarse(
    world: &World,
    options: &Options,
    area: Region,
    scale: f64,
    cancel: &CancelToken,
) -> Result<Image, Stopped> {
    let scaled = |length: usize| ((length as f64 * scale).round() as usize).max(1);
    let part = Region {
        x: scaled(area.x + 1) - 1,
        y: scaled(area.y + 1) - 1,
        width: scaled(area.width),
        height: scaled(area.height),
    };
    let (width, height) =
        (scaled(options.width).max(part.x + part.width), scaled(options.height).max(part.y + part.height));
    let options = Options { width, height, region: Some(part), antialias: None, ..options.clone() };
    let (mut image, watch) = (Image { width: part.width, height: part.height, pixels: vec![] }, StopOnly { cancel });
    render::draw(world, &options, &watch, &mut Crop { part, row_width: width, row: 0, to: &mut image })?;
    Ok(image)
}

struct StopOnly<'a> {
    cancel: &'a CancelToken,
}

impl Watch for StopOnly<'_> {
    fn progress(&self, _: usize, _: usize) {}
    fn cancelled(&self) -> bool {
        self.cancel.is_cancelled()
    }

    fn cancel_token(&self) -> CancelToken {
        self.cancel.clone()
    }
}

/// Displays tiles as they are rendered.
struct TileDisplay<'a> {
    world: &'a World,
    options: &'a Options,
    screen: &'a Screen,
    cancel: &'a CancelToken,
}

impl Watch for TileDisplay<'_> {
    fn preparing(&self, _: &'static str, done: usize, total: usize) {
        self.progress(done, total);
    }

    fn progress(&self, done: usize, total: usize) {
        if !self.cancelled() {
            self.screen.set_progress(done as f32 / total.max(1) as f32);
        }
    }

    fn cancelled(&self) -> bool {
        self.cancel.is_cancelled()
    }

    fn cancel_token(&self) -> CancelToken {
        self.cancel.clone()
    }

    fn store_tile(&self, tile: Tile, pixels: &[[f32; 4]]) {
        if self.cancelled() {
            return;
        }
        let conversion = OutputConversion::new(self.world, self.options);
        let lit: Vec<_> = pixels.iter().map(|pixel| conversion.to_linear_rgba(pixel)).collect();
        self.screen.put_pixels(tile.area, &lit);
    }
}

/// Receiver that ignores the finished rows of a picture, because their tiles are already displayed.
struct Discard;

impl Rows for Discard {
    fn write_rows(&mut self, _: &[[f32; 4]]) -> diagnostic::Result<()> {
        Ok(())
    }
}

/// Receiver of a picture's rows that copies one region of the picture to an image.
struct Crop<'a> {
    part: Region,
    /// Number of pixels in a row of the whole picture, not of the part that is copied.
    row_width: usize,
    row: usize,
    to: &'a mut Image,
}

impl Rows for Crop<'_> {
    fn write_rows(&mut self, rows: &[[f32; 4]]) -> diagnostic::Result<()> {
        let Region { x, y, width, height } = self.part;
        for row in rows.chunks(self.row_width) {
            if (y..y + height).contains(&self.row) {
                self.to.pixels.extend_from_slice(&row[x..x + width]);
            }
            self.row += 1;
        }
        Ok(())
    }
}
