//! A picture in bands of rows, from the top: each is handed on when it is done, so that a large picture needs no more room than a
//! few bands. While the second pass goes over one band, the first goes over the next one already.

use super::antialias::Method;
use super::grid::{Grid, Pixel};
use super::trace::{Setup, Tracer};
use super::workers::Workers;
use super::{Cancelled, Rays, Region, Stopped, Tile};
use crate::diagnostic;
use std::ops::Range;
use std::sync::atomic::{AtomicUsize, Ordering};

/// Edge of a tile in pixels.
const TILE: usize = 16;
/// A band has about so many pixels, but a whole row at least: enough for many threads.
const BAND: usize = 1 << 18;
/// A pixel of a band takes so many bytes: in the tiles of both passes and twice in the rows of both.
const BYTES: u128 = 6 * size_of::<Pixel>() as u128;

/// How many rows the bands of an area have.
fn band_rows(area: Region) -> usize {
    let bands = area.width.saturating_mul(area.height).div_ceil(BAND).max(1);
    let rows = area.height.div_ceil(bands).max(1);
    if rows < TILE { rows } else { rows.next_multiple_of(TILE) }
}

/// The bytes that drawing an area takes, beside the World and what becomes of the bands.
pub(super) fn room(area: Region) -> u128 {
    area.width as u128 * band_rows(area).min(area.height) as u128 * BYTES
}

/// What both passes share.
pub(super) struct Drawing<'a> {
    pub setup: &'a Setup<'a>,
    pub workers: &'a Workers<'a>,
    pub method: Method,
    pub region: Region,
}

/// Hands the pixels of some whole rows of the region on.
pub(super) type Taker<'a> = dyn FnMut(Vec<Pixel>) -> diagnostic::Result<()> + Send + 'a;

impl Drawing<'_> {
    /// Every pixel of the region, row by row.
    pub fn draw(&self, taker: &mut Taker) -> Result<Rays, Stopped> {
        let (region, area) = (self.region, self.first_area());
        let rows = band_rows(region);
        let (mut rays, done) = (Rays::default(), AtomicUsize::new(0));
        let mut seen = Grid::new(area.unwrap_or(Region { height: 0, ..region }));
        let (mut drawn, mut ready) = (region.y, vec![]);
        while drawn < region.y + region.height {
            let first = area.map_or(0..0, |area| seen.bottom()..(seen.bottom() + rows).min(area.y + area.height));
            let second = drawn..self.ready_until(&seen, drawn, rows);
            let jobs: Vec<Tile> = tiles(&seen.area, first.clone(), TILE)
                .map(|area| Tile { second: false, area })
                .chain(tiles(&region, second.clone(), self.edge()).map(|area| Tile { second: true, area }))
                .collect();
            let done_rows = std::mem::take(&mut ready);
            let hand_on = || if done_rows.is_empty() { Ok(()) } else { taker(done_rows) };
            let (tiles, handed) = self.workers.map(&jobs, |job| self.tile(job, &seen, &done), hand_on);
            handed?;
            let mut band = Grid::new(Region { height: 0, y: second.start, ..region });
            seen.add(first.len());
            band.add(second.len());
            for (job, (pixels, cast)) in jobs.iter().zip(tiles?) {
                if job.second { &mut band } else { &mut seen }.put(job.area, &pixels);
                rays.add(&cast);
            }
            (drawn, ready) = (second.end, band.pixels);
            seen.forget((drawn / self.reach() * self.reach()).saturating_sub(1));
        }
        taker(ready)?;
        Ok(rays)
    }

    /// Up to which row the second pass can go now: it asks for what the first one saw around each pixel.
    fn ready_until(&self, seen: &Grid, drawn: usize, rows: usize) -> usize {
        let end = self.region.y + self.region.height;
        match self.first_area() {
            None => (drawn + rows).min(end),
            Some(area) if seen.bottom() == area.y + area.height => end,
            Some(_) => (seen.bottom().saturating_sub(1) / self.reach() * self.reach()).clamp(drawn, end),
        }
    }

    fn tile(&self, tile: &Tile, seen: &Grid, done: &AtomicUsize) -> Result<(Vec<Pixel>, Rays), Cancelled> {
        let watch = self.workers.watch;
        let (pixels, rays) = match watch.recall(*tile) {
            Some(pixels) if pixels.len() == tile.area.width * tile.area.height => (pixels, Rays::default()),
            _ => {
                let drawn = self.trace(tile, seen)?;
                watch.keep(*tile, &drawn.0);
                drawn
            }
        };
        let done = done.fetch_add(pixels.len(), Ordering::Relaxed) + pixels.len();
        watch.progress(done, self.total());
        Ok((pixels, rays))
    }

    fn trace(&self, tile: &Tile, seen: &Grid) -> Result<(Vec<Pixel>, Rays), Cancelled> {
        let mut tracer = Tracer::new(self.setup, Some(self.workers.watch));
        let pixels = match tile.second {
            true => self.method.tile(&mut tracer, seen, tile.area),
            false => self.first_tile(&mut tracer, &tile.area),
        };
        if tracer.stopped() { Err(Cancelled) } else { Ok((pixels, tracer.rays)) }
    }

    /// What the first pass goes over, if there is one.
    fn first_area(&self) -> Option<Region> {
        self.method.first_area(self.region)
    }

    /// What the second pass asks for begins and ends at multiples of this, and one row before and behind them.
    fn reach(&self) -> usize {
        self.method.tile_edge().unwrap_or(1)
    }

    /// Tiles of the second pass begin at multiples of this.
    fn edge(&self) -> usize {
        self.method.tile_edge().unwrap_or(TILE)
    }

    fn first_tile(&self, tracer: &mut Tracer, area: &Region) -> Vec<Pixel> {
        let mut pixels = Vec::with_capacity(area.width * area.height);
        for y in area.y..area.y + area.height {
            pixels.extend((area.x..area.x + area.width).map(|x| self.method.first(tracer, x, y)));
            if tracer.stopped() {
                break;
            }
        }
        pixels
    }

    /// How many pixels both passes have.
    fn total(&self) -> usize {
        let pixels = |area: Region| area.width.saturating_mul(area.height);
        pixels(self.region).saturating_add(self.first_area().map_or(0, pixels))
    }
}

/// Some rows of an area in tiles, which begin at multiples of an edge.
fn tiles(area: &Region, rows: Range<usize>, edge: usize) -> impl Iterator<Item = Region> + use<> {
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
    fn bands_of_large_pictures_are_small() {
        let rows = |width, height| band_rows(Region { x: 0, y: 0, width, height });
        assert_eq!((rows(640, 480), rows(3840, 2160), rows(1 << 30, 5), rows(1, 1)), (240, 80, 1, 1));
        assert!(room(Region { x: 0, y: 0, width: 3840, height: 2160 }) < 32 << 20);
    }

    #[test]
    fn tiles_cover_their_rows_once() {
        let area = Region { x: 3, y: 5, width: 40, height: 100 };
        let mut seen = Grid::new(Region { height: 0, y: 10, ..area });
        seen.add(37);
        for tile in tiles(&area, 10..47, 16) {
            for y in tile.y..tile.y + tile.height {
                for x in tile.x..tile.x + tile.width {
                    let count = seen.at(x, y)[0] + 1.0;
                    seen.put(Region { x, y, width: 1, height: 1 }, &[[count; 4]]);
                }
            }
        }
        assert!(seen.pixels.iter().all(|p| p[0] == 1.0) && seen.pixels.len() == 40 * 37);
        assert_eq!(tiles(&area, 10..10, 16).count(), 0);
    }
}
