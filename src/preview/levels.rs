//! From coarse to fine: a few pixels at once, then all of them, tile by tile.

use super::screen::{Image, Screen, View};
use crate::diagnostic;
use crate::image_io::Rows;
use crate::render::{self, Options, RayCounts, Region, Stopped, Tile, Watch};
use crate::world::World;
use std::time::{Duration, Instant};

/// The first picture has so many pixels at most.
const FIRST: usize = 2_000;
/// Each further one has so many times as many.
const STEP: usize = 16;
/// What takes less than so many seconds needs no coarser one before it.
const SOON: f64 = 0.3;

/// Draws to the screen as `options` say, and stops when it is told to. What is outside of a `region` is not shown. Tells also how long the
/// first pixels took, if there were coarse ones.
///
/// # Errors
/// When it was told to stop.
pub fn draw(
    world: &World,
    options: &Options,
    screen: &Screen,
    stop: &(dyn Fn() -> bool + Sync),
) -> Result<(RayCounts, Duration), Stopped> {
    let (begin, mut first) = (Instant::now(), None);
    let whole = Region { x: 0, y: 0, width: options.width, height: options.height };
    let area = options.region.unwrap_or(whole);
    screen.begin(View { area });
    let pixels = area.width * area.height;
    let mut count = FIRST;
    while count < pixels {
        let start = Instant::now();
        let drawn = coarse(world, options, area, (count as f64 / pixels as f64).sqrt(), stop)?;
        let rate = start.elapsed().as_secs_f64() / (drawn.width * drawn.height).max(1) as f64;
        screen.put_coarse(drawn);
        first.get_or_insert_with(|| begin.elapsed());
        count *= STEP;
        if rate * (pixels as f64) < SOON || rate * (count as f64) > rate * (pixels as f64) / 3.0 {
            break;
        }
    }
    let watch = Fine { world, options, screen, stop };
    let rays = render::draw(world, options, &watch, &mut Drop)?;
    screen.finish();
    Ok((rays, first.unwrap_or_default()))
}

/// The area, with so many times its pixels across and down, and one sample each.
fn coarse(
    world: &World,
    options: &Options,
    area: Region,
    share: f64,
    stop: &(dyn Fn() -> bool + Sync),
) -> Result<Image, Stopped> {
    let less = |length: usize| ((length as f64 * share).round() as usize).max(1);
    let part =
        Region { x: less(area.x + 1) - 1, y: less(area.y + 1) - 1, width: less(area.width), height: less(area.height) };
    let (width, height) =
        (less(options.width).max(part.x + part.width), less(options.height).max(part.y + part.height));
    let options = Options { width, height, region: Some(part), antialias: None, ..options.clone() };
    let (mut image, watch) = (Image { width: part.width, height: part.height, pixels: vec![] }, Asked { stop });
    render::draw(world, &options, &watch, &mut Cut { part, across: width, row: 0, to: &mut image })?;
    Ok(image)
}

struct Asked<'a> {
    stop: &'a (dyn Fn() -> bool + Sync),
}

impl Watch for Asked<'_> {
    fn progress(&self, _: usize, _: usize) {}
    fn cancelled(&self) -> bool {
        (self.stop)()
    }
}

/// Shows tiles as they are drawn.
struct Fine<'a> {
    world: &'a World,
    options: &'a Options,
    screen: &'a Screen,
    stop: &'a (dyn Fn() -> bool + Sync),
}

impl Watch for Fine<'_> {
    fn progress(&self, done: usize, total: usize) {
        self.screen.progress(done as f32 / total.max(1) as f32);
    }

    fn cancelled(&self) -> bool {
        (self.stop)()
    }

    fn store_tile(&self, tile: Tile, pixels: &[[f32; 4]]) {
        let lit: Vec<_> = pixels.iter().map(|pixel| render::light(self.world, self.options, pixel)).collect();
        self.screen.put(tile.area, &lit);
    }
}

/// The tiles are shown already.
struct Drop;

impl Rows for Drop {
    fn take(&mut self, _: &[[f32; 4]]) -> diagnostic::Result<()> {
        Ok(())
    }
}

/// A part of each row.
struct Cut<'a> {
    part: Region,
    /// Pixels of a row.
    across: usize,
    row: usize,
    to: &'a mut Image,
}

impl Rows for Cut<'_> {
    fn take(&mut self, rows: &[[f32; 4]]) -> diagnostic::Result<()> {
        let Region { x, y, width, height } = self.part;
        for row in rows.chunks(self.across) {
            if (y..y + height).contains(&self.row) {
                self.to.pixels.extend_from_slice(&row[x..x + width]);
            }
            self.row += 1;
        }
        Ok(())
    }
}
