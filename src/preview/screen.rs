//! Contents of the pages: the picture, tile by tile as it is rendered, and the state beside it.

use super::PageState;
use crate::color::transfer::srgb_encode;
use crate::image_io::Frame;
use crate::render::Region;
use std::sync::{Arc, Condvar, Mutex, MutexGuard, PoisonError};
use std::time::Duration;

/// Edge of the tiles in which a picture is sent, in pixels; equals the edge of the rendered tiles.
const TILE: usize = 16;

/// Picture of linear red, green, blue and alpha per pixel, row by row.
pub type Image = Frame;

/// The displayed part of a larger picture.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct View {
    /// Pixel region of the view in the larger picture.
    pub area: Region,
}

/// Picture on the preview page, shared by renderer and clients.
#[derive(Default)]
pub struct Screen {
    contents: Mutex<Contents>,
    changed: Condvar,
}

#[derive(Default)]
struct Contents {
    picture: Option<Picture>,
    previous: Option<Arc<Image>>,
    state: Option<Arc<PageState>>,
    /// Number of changes to the screen so far.
    stamp: u64,
    /// Stamp of the last change of `state`.
    state_stamp: u64,
}

struct Picture {
    /// Ordinal number of the present picture, counted since the preview began.
    run: u64,
    view: View,
    image: Image,
    /// Stamp of the last change of each tile, row by row; 0 for a tile that is not rendered yet.
    tiles: Vec<u64>,
    /// The whole picture in a lower resolution, and its stamp.
    coarse: Option<(Image, u64)>,
    /// Rendered share of the picture, from 0 to 1.
    progress: f32,
    done: bool,
}

/// Record of the screen's changes that one page has already received.
#[derive(Debug, Default)]
pub(super) struct Cursor {
    stamp: u64,
    run: u64,
}

/// Changes of the screen since a [`Cursor`].
pub(super) struct Update {
    pub run: u64,
    /// Width and height of a new picture.
    pub new_size: Option<[usize; 2]>,
    /// True if the screen has a previous picture to compare with.
    pub has_previous: bool,
    pub state: Option<Arc<PageState>>,
    pub coarse: Option<Image>,
    /// Left edge, top edge and pixels of each changed tile.
    pub tiles: Vec<(usize, usize, Image)>,
    pub progress: f32,
    pub done: bool,
}

/// Largest number of tiles in an update.
const BATCH: usize = 256;

impl Picture {
    /// Returns the number of tiles in a row. Tiles start at multiples of their edge in the larger picture.
    fn tile_columns(&self) -> usize {
        let Region { x, width, .. } = self.view.area;
        (x + width).div_ceil(TILE) - x / TILE
    }

    /// Returns the rectangle of the tile with this index, relative to the displayed picture's top left corner.
    fn tile(&self, index: usize) -> Region {
        let Region { x, y, width, height } = self.view.area;
        let (column, row) = (index % self.tile_columns() + x / TILE, index / self.tile_columns() + y / TILE);
        let (left, top) = ((column * TILE).max(x), (row * TILE).max(y));
        let (right, bottom) = ((column * TILE + TILE).min(x + width), (row * TILE + TILE).min(y + height));
        Region { x: left - x, y: top - y, width: right - left, height: bottom - top }
    }

    /// Returns a copy of this region of the picture.
    fn crop(&self, Region { x, y, width, height }: Region) -> Image {
        let rows = self.image.pixels.chunks(self.image.width.max(1)).skip(y).take(height);
        Image { width, height, pixels: rows.flat_map(|row| &row[x..x + width]).copied().collect() }
    }
}

impl Screen {
    fn lock(&self) -> MutexGuard<'_, Contents> {
        // After a panic of another thread the picture can still be displayed.
        self.contents.lock().unwrap_or_else(PoisonError::into_inner)
    }

    fn change(&self, change: impl FnOnce(&mut Contents, u64)) {
        let mut contents = self.lock();
        contents.stamp += 1;
        let stamp = contents.stamp;
        change(&mut contents, stamp);
        drop(contents);
        self.changed.notify_all();
    }

    /// Replaces the state of the work (settings, messages, times), which the page displays beside the picture.
    pub fn set_state(&self, state: PageState) {
        self.change(|contents, stamp| (contents.state, contents.state_stamp) = (Some(Arc::new(state)), stamp));
    }

    /// Starts a new picture. The last finished picture becomes the previous one.
    pub fn begin_picture(&self, view: View) {
        self.change(|contents, stamp| {
            let last = contents.picture.take();
            let run = last.as_ref().map_or(1, |last| last.run + 1);
            if let Some(last) = last.filter(|last| last.done) {
                contents.previous = Some(Arc::new(last.image));
            }
            let Region { width, height, .. } = view.area;
            let image = Image { width, height, pixels: vec![[0.0; 4]; width * height] };
            let picture = Picture { run, view, image, tiles: vec![], coarse: None, progress: 0.0, done: false };
            let Region { y, .. } = view.area;
            let tiles = picture.tile_columns() * ((y + height).div_ceil(TILE) - y / TILE);
            contents.picture = Some(Picture { tiles: vec![0; tiles], ..picture });
            contents.state_stamp = stamp;
        });
    }

    /// Displays the whole picture in a lower resolution.
    pub fn put_coarse(&self, image: Image) {
        self.change(|contents, stamp| {
            if let Some(picture) = &mut contents.picture {
                picture.coarse = Some((image, stamp));
            }
        });
    }

    /// Displays an area of the larger picture, in linear colour and row by row. Pixels outside of the view are ignored.
    pub fn put_pixels(&self, area_of_larger_picture: Region, pixels: &[[f32; 4]]) {
        self.change(|contents, stamp| {
            let Some(picture) = &mut contents.picture else { return };
            let view = picture.view.area;
            let columns = picture.tile_columns();
            for (y, row) in (area_of_larger_picture.y..).zip(pixels.chunks(area_of_larger_picture.width.max(1))) {
                for (x, pixel) in (area_of_larger_picture.x..).zip(row) {
                    let (Some(left), Some(top)) = (x.checked_sub(view.x), y.checked_sub(view.y)) else { continue };
                    if left < view.width && top < view.height {
                        picture.image.pixels[top * view.width + left] = *pixel;
                        picture.tiles[(y / TILE - view.y / TILE) * columns + x / TILE - view.x / TILE] = stamp;
                    }
                }
            }
        });
    }

    /// Sets the rendered share of the picture, from 0 to 1, which pages receive with the next change.
    pub fn set_progress(&self, progress: f32) {
        if let Some(picture) = &mut self.lock().picture {
            picture.progress = progress;
        }
    }

    /// Marks the picture on the screen as finished.
    pub fn mark_finished(&self) {
        self.change(|contents, stamp| {
            if let Some(picture) = &mut contents.picture {
                (picture.done, picture.progress) = (true, 1.0);
                contents.state_stamp = stamp;
            }
        });
    }

    /// Returns the picture if it is finished.
    pub fn finished_picture(&self) -> Option<Image> {
        let contents = self.lock();
        contents.picture.as_ref().filter(|picture| picture.done).map(|picture| picture.image.clone())
    }

    /// Returns the linear red, green, blue and alpha of a pixel, counted from the top left of the displayed part; `None` outside.
    pub fn color_at(&self, x: usize, y: usize) -> Option<[f32; 4]> {
        let contents = self.lock();
        let picture = contents.picture.as_ref().filter(|picture| x < picture.image.width)?;
        picture.image.pixels.get(y * picture.image.width + x).copied()
    }

    /// Returns the last finished picture before the present one, if there is one.
    pub fn previous_picture(&self) -> Option<Arc<Image>> {
        self.lock().previous.clone()
    }

    /// Waits for changes that a page has not received, returns them, and records in `cursor` that the page has them; `None`
    /// after `time`.
    pub(super) fn wait(&self, cursor: &mut Cursor, time: Duration) -> Option<Update> {
        let contents = self.lock();
        let quiet = |contents: &mut Contents| contents.stamp <= cursor.stamp;
        let (contents, _) =
            self.changed.wait_timeout_while(contents, time, quiet).unwrap_or_else(PoisonError::into_inner);
        (contents.stamp > cursor.stamp).then(|| contents.update(cursor))
    }
}

impl Contents {
    fn update(&self, cursor: &mut Cursor) -> Update {
        let run = self.picture.as_ref().map_or(0, |picture| picture.run);
        let another = run != cursor.run;
        // All tiles of another picture are new.
        let since = if another { 0 } else { cursor.stamp };
        let mut update = Update {
            run,
            new_size: None,
            has_previous: self.previous.is_some(),
            state: self.state.clone().filter(|_| self.state_stamp > cursor.stamp),
            coarse: None,
            tiles: vec![],
            progress: 0.0,
            done: false,
        };
        let mut stamp = self.stamp;
        if let Some(picture) = &self.picture {
            update.new_size = another.then_some([picture.image.width, picture.image.height]);
            update.coarse = picture.coarse.as_ref().filter(|(_, at)| *at > since).map(|(image, _)| image.clone());
            (update.progress, update.done) = (picture.progress, picture.done);
            let mut fresh: Vec<_> = picture.tiles.iter().enumerate().filter(|(_, at)| **at > since).collect();
            if fresh.len() > BATCH {
                // Send the oldest tiles first, and the others with the next update.
                fresh.sort_by_key(|(_, at)| **at);
                let last = *fresh[BATCH - 1].1;
                fresh.retain(|(_, at)| **at <= last);
                stamp = last.max(since);
            }
            let tile = |at| {
                let area = picture.tile(at);
                (area.x, area.y, picture.crop(area))
            };
            update.tiles = fresh.into_iter().map(|(at, _)| tile(at)).collect();
            // The picture is not complete on the page while tiles are pending.
            update.done &= stamp == self.stamp;
        }
        (cursor.stamp, cursor.run) = (stamp, run);
        update
    }
}

/// Converts a picture to four bytes per pixel: red, green and blue in sRGB, and linear alpha.
pub(super) fn to_srgb_bytes(image: &Image) -> Vec<u8> {
    let byte = |x: f32| (srgb_encode(f64::from(x).clamp(0.0, 1.0)) * 255.0).round() as u8;
    let pixel = |[r, g, b, a]: &[f32; 4]| [byte(*r), byte(*g), byte(*b), (a.clamp(0.0, 1.0) * 255.0).round() as u8];
    image.pixels.iter().flat_map(pixel).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn collect(screen: &Screen, cursor: &mut Cursor) -> Vec<Update> {
        std::iter::from_fn(|| screen.wait(cursor, Duration::ZERO)).collect()
    }

    #[test]
    fn a_page_receives_each_tile_once_and_after_each_change() {
        let (screen, mut page) = (Screen::default(), Cursor::default());
        assert!(screen.wait(&mut page, Duration::ZERO).is_none());
        let area = Region { x: 5, y: 20, width: 40, height: 30 };
        screen.begin_picture(View { area });
        let update = collect(&screen, &mut page);
        assert_eq!((update.len(), update[0].new_size, update[0].tiles.len()), (1, Some([40, 30]), 0));
        // A tile that is partly outside of the view.
        screen.put_pixels(Region { x: 0, y: 16, width: 16, height: 16 }, &[[0.5; 4]; 256]);
        let update = collect(&screen, &mut page);
        let (x, y, tile) = &update[0].tiles[0];
        assert_eq!((*x, *y, tile.width, tile.height, tile.pixels[0]), (0, 0, 11, 12, [0.5; 4]));
        assert_eq!(screen.color_at(10, 11), Some([0.5; 4]));
        assert_eq!(screen.color_at(11, 11), Some([0.0; 4]));
        assert!(collect(&screen, &mut page).is_empty());
        // A new page receives all tiles.
        assert_eq!(collect(&screen, &mut Cursor::default())[0].tiles.len(), 1);
        screen.put_pixels(Region { x: 0, y: 16, width: 16, height: 16 }, &[[0.25; 4]; 256]);
        assert_eq!(collect(&screen, &mut page)[0].tiles.len(), 1);
        assert!(screen.finished_picture().is_none());
        screen.mark_finished();
        assert!(screen.finished_picture().is_some());
        screen.begin_picture(View { area });
        assert_eq!(screen.previous_picture().map(|image| image.pixels[0]), Some([0.25; 4]));
    }

    #[test]
    fn many_tiles_are_sent_in_batches() {
        let (screen, mut page) = (Screen::default(), Cursor::default());
        let area = Region { x: 0, y: 0, width: 640, height: 480 };
        screen.begin_picture(View { area });
        for at in 0..1200 {
            let (x, y) = (at % 40 * 16, at / 40 * 16);
            screen.put_pixels(Region { x, y, width: 16, height: 16 }, &[[1.0; 4]; 256]);
        }
        screen.mark_finished();
        let update = collect(&screen, &mut page);
        assert_eq!(update.iter().map(|update| update.tiles.len()).sum::<usize>(), 1200);
        assert!(update.iter().all(|update| update.tiles.len() <= BATCH));
        assert_eq!(update.iter().filter(|update| update.done).count(), 1);
        // A tile that changes while others are pending is sent again.
        let mut page = Cursor::default();
        screen.wait(&mut page, Duration::ZERO);
        screen.put_pixels(Region { x: 0, y: 0, width: 16, height: 16 }, &[[0.5; 4]; 256]);
        let tiles: Vec<_> = collect(&screen, &mut page).into_iter().flat_map(|update| update.tiles).collect();
        assert!(tiles.iter().any(|(x, y, tile)| (*x, *y, tile.pixels[0]) == (0, 0, [0.5; 4])));
    }
}
