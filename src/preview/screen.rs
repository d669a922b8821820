//! What the pages show: the picture, tile by tile as it is drawn, and what is told beside it.

use super::Told;
use crate::color::transfer::srgb_encode;
use crate::image_io::Frame;
use crate::render::Region;
use std::sync::{Arc, Condvar, Mutex, MutexGuard, PoisonError};
use std::time::Duration;

/// Edge of the tiles in which a picture is sent: that of the tiles in which it is drawn.
const TILE: usize = 16;

/// Linear light and alpha, row by row.
pub type Image = Frame;

/// Which pixels of a larger picture are shown.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct View {
    /// In the larger picture.
    pub area: Region,
}

/// See the module.
#[derive(Default)]
pub struct Screen {
    shown: Mutex<Shown>,
    changed: Condvar,
}

#[derive(Default)]
struct Shown {
    picture: Option<Picture>,
    before: Option<Arc<Image>>,
    told: Option<Arc<Told>>,
    /// Counts all changes.
    stamp: u64,
    /// When `told` changed.
    told_at: u64,
}

struct Picture {
    /// Pictures are numbered.
    run: u64,
    view: View,
    image: Image,
    /// When each tile was drawn last, row by row; 0 is never.
    tiles: Vec<u64>,
    /// The whole of it, but smaller, and when that was drawn.
    coarse: Option<(Image, u64)>,
    /// How much of it is drawn, from 0 to 1.
    progress: f32,
    done: bool,
}

/// How much of the screen a page has seen.
#[derive(Debug, Default)]
pub(super) struct Cursor {
    stamp: u64,
    run: u64,
}

/// What it has not seen.
pub(super) struct News {
    pub run: u64,
    /// Width and height of the picture, if it is another one.
    pub begins: Option<[usize; 2]>,
    /// Is there one of before?
    pub before: bool,
    pub told: Option<Arc<Told>>,
    pub coarse: Option<Image>,
    /// Left and top of each, and its pixels.
    pub tiles: Vec<(usize, usize, Image)>,
    pub progress: f32,
    pub done: bool,
}

/// Tiles that are sent at once.
const BATCH: usize = 256;

impl Picture {
    /// How many tiles stand in a row: they begin at multiples of their edge in the larger picture.
    fn columns(&self) -> usize {
        let Region { x, width, .. } = self.view.area;
        (x + width).div_ceil(TILE) - x / TILE
    }

    /// Where a tile is, in this picture.
    fn tile(&self, at: usize) -> Region {
        let Region { x, y, width, height } = self.view.area;
        let (column, row) = (at % self.columns() + x / TILE, at / self.columns() + y / TILE);
        let (left, top) = ((column * TILE).max(x), (row * TILE).max(y));
        let (right, bottom) = ((column * TILE + TILE).min(x + width), (row * TILE + TILE).min(y + height));
        Region { x: left - x, y: top - y, width: right - left, height: bottom - top }
    }

    fn part(&self, Region { x, y, width, height }: Region) -> Image {
        let rows = self.image.pixels.chunks(self.image.width.max(1)).skip(y).take(height);
        Image { width, height, pixels: rows.flat_map(|row| &row[x..x + width]).copied().collect() }
    }
}

impl Screen {
    fn lock(&self) -> MutexGuard<'_, Shown> {
        // Whoever panicked has left a picture that is whole enough to be looked at.
        self.shown.lock().unwrap_or_else(PoisonError::into_inner)
    }

    fn change(&self, change: impl FnOnce(&mut Shown, u64)) {
        let mut shown = self.lock();
        shown.stamp += 1;
        let stamp = shown.stamp;
        change(&mut shown, stamp);
        drop(shown);
        self.changed.notify_all();
    }

    /// Something else stands beside the picture.
    pub fn tell(&self, told: Told) {
        self.change(|shown, stamp| (shown.told, shown.told_at) = (Some(Arc::new(told)), stamp));
    }

    /// Another picture begins. The last one that was finished becomes that of before.
    pub fn begin(&self, view: View) {
        self.change(|shown, stamp| {
            let last = shown.picture.take();
            let run = last.as_ref().map_or(1, |last| last.run + 1);
            if let Some(last) = last.filter(|last| last.done) {
                shown.before = Some(Arc::new(last.image));
            }
            let Region { width, height, .. } = view.area;
            let image = Image { width, height, pixels: vec![[0.0; 4]; width * height] };
            let picture = Picture { run, view, image, tiles: vec![], coarse: None, progress: 0.0, done: false };
            let Region { y, .. } = view.area;
            let tiles = picture.columns() * ((y + height).div_ceil(TILE) - y / TILE);
            shown.picture = Some(Picture { tiles: vec![0; tiles], ..picture });
            shown.told_at = stamp;
        });
    }

    /// The whole picture, but smaller.
    pub fn put_coarse(&self, image: Image) {
        self.change(|shown, stamp| {
            if let Some(picture) = &mut shown.picture {
                picture.coarse = Some((image, stamp));
            }
        });
    }

    /// An area of the larger picture is drawn: linear light, row by row. What of it is not shown is passed over.
    pub fn put(&self, area: Region, pixels: &[[f32; 4]]) {
        self.change(|shown, stamp| {
            let Some(picture) = &mut shown.picture else { return };
            let view = picture.view.area;
            let columns = picture.columns();
            for (y, row) in (area.y..).zip(pixels.chunks(area.width.max(1))) {
                for (x, pixel) in (area.x..).zip(row) {
                    let (Some(left), Some(top)) = (x.checked_sub(view.x), y.checked_sub(view.y)) else { continue };
                    if left < view.width && top < view.height {
                        picture.image.pixels[top * view.width + left] = *pixel;
                        picture.tiles[(y / TILE - view.y / TILE) * columns + x / TILE - view.x / TILE] = stamp;
                    }
                }
            }
        });
    }

    /// So much of the picture is drawn, from 0 to 1.
    pub fn progress(&self, progress: f32) {
        if let Some(picture) = &mut self.lock().picture {
            picture.progress = progress;
        }
    }

    /// The picture is finished.
    pub fn finish(&self) {
        self.change(|shown, stamp| {
            if let Some(picture) = &mut shown.picture {
                (picture.done, picture.progress) = (true, 1.0);
                shown.told_at = stamp;
            }
        });
    }

    /// The picture, if it is finished.
    pub fn finished(&self) -> Option<Image> {
        let shown = self.lock();
        shown.picture.as_ref().filter(|picture| picture.done).map(|picture| picture.image.clone())
    }

    /// The light of a pixel, if it is drawn.
    pub fn light(&self, x: usize, y: usize) -> Option<[f32; 4]> {
        let shown = self.lock();
        let picture = shown.picture.as_ref().filter(|picture| x < picture.image.width)?;
        picture.image.pixels.get(y * picture.image.width + x).copied()
    }

    /// The picture that was finished before this one.
    pub fn before(&self) -> Option<Arc<Image>> {
        self.lock().before.clone()
    }

    /// Waits until there is something that a page has not seen; nothing if there is none for so long.
    pub(super) fn wait(&self, cursor: &mut Cursor, time: Duration) -> Option<News> {
        let shown = self.lock();
        let quiet = |shown: &mut Shown| shown.stamp <= cursor.stamp;
        let (shown, _) = self.changed.wait_timeout_while(shown, time, quiet).unwrap_or_else(PoisonError::into_inner);
        (shown.stamp > cursor.stamp).then(|| shown.news(cursor))
    }
}

impl Shown {
    fn news(&self, cursor: &mut Cursor) -> News {
        let run = self.picture.as_ref().map_or(0, |picture| picture.run);
        let another = run != cursor.run;
        // Of another picture everything is new.
        let since = if another { 0 } else { cursor.stamp };
        let mut news = News {
            run,
            begins: None,
            before: self.before.is_some(),
            told: self.told.clone().filter(|_| self.told_at > cursor.stamp),
            coarse: None,
            tiles: vec![],
            progress: 0.0,
            done: false,
        };
        let mut stamp = self.stamp;
        if let Some(picture) = &self.picture {
            news.begins = another.then_some([picture.image.width, picture.image.height]);
            news.coarse = picture.coarse.as_ref().filter(|(_, at)| *at > since).map(|(image, _)| image.clone());
            (news.progress, news.done) = (picture.progress, picture.done);
            let mut fresh: Vec<_> = picture.tiles.iter().enumerate().filter(|(_, at)| **at > since).collect();
            if fresh.len() > BATCH {
                // The oldest go first; the others stay news.
                fresh.sort_by_key(|(_, at)| **at);
                let last = *fresh[BATCH - 1].1;
                fresh.retain(|(_, at)| **at <= last);
                stamp = last.max(since);
            }
            let tile = |at| {
                let area = picture.tile(at);
                (area.x, area.y, picture.part(area))
            };
            news.tiles = fresh.into_iter().map(|(at, _)| tile(at)).collect();
            // Of a batch, more is to come.
            news.done &= stamp == self.stamp;
        }
        (cursor.stamp, cursor.run) = (stamp, run);
        news
    }
}

/// Red, green, blue and alpha as a screen takes them.
pub(super) fn on_screen(image: &Image) -> Vec<u8> {
    let byte = |x: f32| (srgb_encode(f64::from(x).clamp(0.0, 1.0)) * 255.0).round() as u8;
    let pixel = |[r, g, b, a]: &[f32; 4]| [byte(*r), byte(*g), byte(*b), (a.clamp(0.0, 1.0) * 255.0).round() as u8];
    image.pixels.iter().flat_map(pixel).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn collect(screen: &Screen, cursor: &mut Cursor) -> Vec<News> {
        std::iter::from_fn(|| screen.wait(cursor, Duration::ZERO)).collect()
    }

    #[test]
    fn a_page_sees_each_tile_once_and_again_if_it_changes() {
        let (screen, mut page) = (Screen::default(), Cursor::default());
        assert!(screen.wait(&mut page, Duration::ZERO).is_none());
        let area = Region { x: 5, y: 20, width: 40, height: 30 };
        screen.begin(View { area });
        let news = collect(&screen, &mut page);
        assert_eq!((news.len(), news[0].begins, news[0].tiles.len()), (1, Some([40, 30]), 0));
        // One tile, of which a part lies outside.
        screen.put(Region { x: 0, y: 16, width: 16, height: 16 }, &[[0.5; 4]; 256]);
        let news = collect(&screen, &mut page);
        let (x, y, tile) = &news[0].tiles[0];
        assert_eq!((*x, *y, tile.width, tile.height, tile.pixels[0]), (0, 0, 11, 12, [0.5; 4]));
        assert_eq!(screen.light(10, 11), Some([0.5; 4]));
        assert_eq!(screen.light(11, 11), Some([0.0; 4]));
        assert!(collect(&screen, &mut page).is_empty());
        // Another page sees all of it.
        assert_eq!(collect(&screen, &mut Cursor::default())[0].tiles.len(), 1);
        screen.put(Region { x: 0, y: 16, width: 16, height: 16 }, &[[0.25; 4]; 256]);
        assert_eq!(collect(&screen, &mut page)[0].tiles.len(), 1);
        assert!(screen.finished().is_none());
        screen.finish();
        assert!(screen.finished().is_some());
        screen.begin(View { area });
        assert_eq!(screen.before().map(|image| image.pixels[0]), Some([0.25; 4]));
    }

    #[test]
    fn many_tiles_come_in_batches_and_none_is_lost() {
        let (screen, mut page) = (Screen::default(), Cursor::default());
        let area = Region { x: 0, y: 0, width: 640, height: 480 };
        screen.begin(View { area });
        for at in 0..1200 {
            let (x, y) = (at % 40 * 16, at / 40 * 16);
            screen.put(Region { x, y, width: 16, height: 16 }, &[[1.0; 4]; 256]);
        }
        screen.finish();
        let news = collect(&screen, &mut page);
        assert_eq!(news.iter().map(|news| news.tiles.len()).sum::<usize>(), 1200);
        assert!(news.iter().all(|news| news.tiles.len() <= BATCH));
        assert_eq!(news.iter().filter(|news| news.done).count(), 1);
        // A tile that changes while others wait comes again.
        let mut page = Cursor::default();
        screen.wait(&mut page, Duration::ZERO);
        screen.put(Region { x: 0, y: 0, width: 16, height: 16 }, &[[0.5; 4]; 256]);
        let tiles: Vec<_> = collect(&screen, &mut page).into_iter().flat_map(|news| news.tiles).collect();
        assert!(tiles.iter().any(|(x, y, tile)| (*x, *y, tile.pixels[0]) == (0, 0, [0.5; 4])));
    }
}
