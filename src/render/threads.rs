//! Threads that render the tiles of one picture, in the order of a [`Schedule`]. Each finished row of tiles is passed on, so
//! that a large picture needs memory for a window of rows only.

use super::antialias::Method;
use super::blocks::BLOCK;
use super::frame_render::{FrameRender, TILE};
use super::pixel_area::{Pixel, PixelArea};
use super::schedule::{Place, Schedule, Task, TileGrid};
use super::{Cancelled, FINAL_PASS, FIRST_PASS, RayCounts, Region, Stopped, Tile};
use crate::diagnostic;
use crate::image_io::{CompressedPieces, Pieces};
use std::collections::VecDeque;
use std::sync::atomic::AtomicUsize;
use std::sync::{Arc, Condvar, Mutex, MutexGuard, PoisonError};

/// Approximate number of pixels of the rows that are rendered at the same time, which are at least one row of tiles: enough
/// work for many threads.
const WINDOW: usize = 1 << 18;

/// Returns the number of rows of tiles in the window, for tiles with edges of `edge` pixels.
fn rows_in_window(area: Region, edge: usize) -> usize {
    (WINDOW / area.width.max(1) / edge).max(1)
}

/// Returns the maximum memory for the rows of an area that are rendered at the same time, in bytes.
pub(super) fn memory_bytes(area: Region) -> u128 {
    // Both passes of the window and of the row before it, which is passed on from a copy
    let window = (rows_in_window(area, BLOCK) + 1) * BLOCK;
    let rows = 2 * window.min(area.height) + BLOCK.min(area.height);
    area.width as u128 * rows as u128 * size_of::<Pixel>() as u128
}

/// Receiver of the pixels of whole rows of the region.
pub(super) trait RowReceiver: Send {
    /// Receives the next rows. Returns pieces of the file that are to be compressed and passed to `write_pieces`.
    fn receive(&mut self, pixels: Vec<Pixel>) -> diagnostic::Result<Pieces>;
    /// Writes compressed pieces.
    fn write_pieces(&mut self, pieces: CompressedPieces) -> diagnostic::Result<()>;
}

/// Pixels of a finished tile, row by row.
type TilePixels = Arc<Vec<Pixel>>;

/// Pixels of a tile, and the rays that were traced for them.
type TileResult = Result<(Vec<Pixel>, RayCounts), Cancelled>;

/// A render whose tiles several threads compute.
struct SharedRender<'a> {
    frame: &'a FrameRender<'a>,
    tiles: PassTiles,
    state: Mutex<State<'a>>,
    /// Signals threads that wait for a tile of another thread.
    changed: Condvar,
    n_pixels_done: AtomicUsize,
}

/// State of a render that threads change one at a time.
struct State<'a> {
    schedule: Schedule<'a, TilePixels>,
    counts: RayCounts,
    /// Rows of tiles whose pieces of the file are being compressed, from the top.
    rows_in_compression: VecDeque<usize>,
    /// Reason to stop all threads.
    stopped: Option<Stopped>,
}

/// Tiles of both passes of a render.
#[derive(Clone, Copy)]
pub(super) struct PassTiles {
    region: Region,
    /// Tiles of the first pass; `None` for methods of one pass.
    first: Option<TileGrid>,
    /// Tiles of the final pass.
    last: TileGrid,
}

impl PassTiles {
    /// Returns the tiles of a region.
    pub fn new(method: &Method, region: Region) -> Self {
        let first = method.first_area(region).map(|area| TileGrid::new(area, TILE));
        Self { region, first, last: TileGrid::new(region, method.antialias_block_edge().unwrap_or(TILE)) }
    }

    /// Returns the order in which threads render the tiles, whose results have the type `T`.
    pub fn schedule<'a, T>(self, method: &'a Method) -> Schedule<'a, T> {
        let Self { region, first, last } = self;
        let needed_rows = move |row: usize| {
            let rows = last.rows_of_pixels(row);
            let around = method.first_area(Region { y: rows.start, height: rows.len(), ..region });
            first.zip(around).map_or(0..0, |(grid, around)| grid.rows_and_columns_around(around).0)
        };
        Schedule::new(first, last, rows_in_window(region, last.edge()), needed_rows)
    }

    /// Returns the tile that a task renders; `None` for other tasks.
    pub fn tile(&self, task: Task) -> Option<Tile> {
        match task {
            Task::First(place) => self.first.map(|grid| Tile { pass: FIRST_PASS, area: grid.tile(place) }),
            Task::Final(place) => Some(Tile { pass: FINAL_PASS, area: self.last.tile(place) }),
            Task::PassOn(_) | Task::Wait | Task::End => None,
        }
    }
}

impl FrameRender<'_> {
    /// Renders every pixel of the region and passes the rows to `receiver`.
    pub fn run(&self, receiver: &mut dyn RowReceiver) -> Result<RayCounts, Stopped> {
        let tiles = PassTiles::new(&self.method, self.region);
        let schedule = tiles.schedule(&self.method);
        let state =
            State { schedule, counts: RayCounts::default(), rows_in_compression: VecDeque::new(), stopped: None };
        let render = SharedRender {
            frame: self,
            tiles,
            state: Mutex::new(state),
            changed: Condvar::new(),
            n_pixels_done: AtomicUsize::new(0),
        };
        let receiver = Mutex::new(receiver);
        self.workers.run_on_each_thread(|| render.work(&receiver));
        let State { counts, stopped, .. } = render.state.into_inner().unwrap_or_else(PoisonError::into_inner);
        stopped.map_or(Ok(counts), Err)
    }
}

impl<'a> SharedRender<'a> {
    /// Renders tiles and passes on rows until nothing is left for this thread.
    fn work(&self, receiver: &Mutex<&mut dyn RowReceiver>) {
        let mut guard = StopOnPanic { render: self, has_ended: false };
        let mut state = self.lock();
        while state.stopped.is_none() {
            let task = state.schedule.next_task();
            match task {
                Task::End => break,
                Task::Wait => {
                    state = self.changed.wait(state).unwrap_or_else(PoisonError::into_inner);
                    continue;
                }
                Task::First(_) | Task::Final(_) => {
                    let first_tiles = self.first_tiles_around(&state, task);
                    drop(state);
                    let result = self.render(task, &first_tiles);
                    state = self.lock();
                    state.finish(task, result);
                }
                Task::PassOn(row) => {
                    let tiles = state.schedule.take_row(row);
                    drop(state);
                    let pixels = self.joined_row(row, &tiles);
                    let pieces = receiver.lock().unwrap_or_else(PoisonError::into_inner).receive(pixels);
                    state = self.lock();
                    state.schedule.finish_passing_on(row);
                    match pieces {
                        Ok(pieces) if pieces.is_empty() => {}
                        Ok(pieces) => state = self.compress(state, row, &pieces, receiver),
                        Err(fault) => state.stop(fault.into()),
                    }
                }
            }
            self.changed.notify_all();
        }
        guard.has_ended = true;
    }

    /// Compresses pieces that were complete after this row of tiles, while other threads pass on the next rows. Waits for
    /// the threads that compress the rows above, so that few pieces are in memory.
    fn compress<'s>(
        &'s self,
        mut state: MutexGuard<'s, State<'a>>,
        row: usize,
        pieces: &Pieces,
        receiver: &Mutex<&mut dyn RowReceiver>,
    ) -> MutexGuard<'s, State<'a>> {
        state.rows_in_compression.push_back(row);
        drop(state);
        self.changed.notify_all();
        let compressed = pieces.compress();
        let mut state = self.lock();
        while state.stopped.is_none() && state.rows_in_compression.front() != Some(&row) {
            state = self.changed.wait(state).unwrap_or_else(PoisonError::into_inner);
        }
        if state.stopped.is_some() {
            return state;
        }
        drop(state);
        let result = receiver.lock().unwrap_or_else(PoisonError::into_inner).write_pieces(compressed);
        let mut state = self.lock();
        state.rows_in_compression.pop_front();
        if let Err(fault) = result {
            state.stop(fault.into());
        }
        state
    }

    fn lock(&self) -> MutexGuard<'_, State<'a>> {
        self.state.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// Returns the tiles of the first pass around the tile of the final pass that a task renders.
    fn first_tiles_around(&self, state: &State, task: Task) -> Vec<(Region, TilePixels)> {
        let around = self.tiles.tile(task).filter(|tile| tile.pass == FINAL_PASS);
        let around = around.and_then(|tile| self.frame.method.first_area(tile.area));
        let Some((grid, around)) = self.tiles.first.zip(around) else { return vec![] };
        let results = state.schedule.first_results(grid.rows_and_columns_around(around));
        results.into_iter().map(|(place, pixels)| (grid.tile(place), pixels)).collect()
    }

    /// Renders the tile of a task, or loads it from an earlier run.
    fn render(&self, task: Task, first_tiles: &[(Region, TilePixels)]) -> TileResult {
        let frame = self.frame;
        let Some(tile) = self.tiles.tile(task).filter(|_| !frame.workers.is_cancelled()) else { return Err(Cancelled) };
        frame.load_or_render(tile, &self.n_pixels_done, frame.pixel_count_of_passes(), || {
            let around = frame.method.first_area(tile.area).filter(|_| tile.pass == FINAL_PASS);
            let mut first_samples = PixelArea::black(around.unwrap_or(Region { height: 0, ..tile.area }));
            first_tiles.iter().for_each(|(area, pixels)| first_samples.put(*area, pixels));
            frame.render_tile(&tile, &first_samples)
        })
    }

    /// Joins the tiles of a row to rows of pixels.
    fn joined_row(&self, row: usize, tiles: &[TilePixels]) -> Vec<Pixel> {
        let rows = self.tiles.last.rows_of_pixels(row);
        let mut joined = PixelArea::black(Region { y: rows.start, height: rows.len(), ..self.frame.region });
        for (column, pixels) in tiles.iter().enumerate() {
            joined.put(self.tiles.last.tile(Place { row, column }), pixels);
        }
        joined.pixels
    }
}

impl State<'_> {
    /// Stores the result of a tile, or stops all threads if the render was cancelled.
    fn finish(&mut self, task: Task, result: TileResult) {
        match result {
            Ok((pixels, counts)) => {
                self.counts.add(&counts);
                self.schedule.finish_tile(task, Arc::new(pixels));
            }
            Err(cancelled) => self.stop(cancelled.into()),
        }
    }

    /// Stops all threads; the first reason counts.
    fn stop(&mut self, reason: Stopped) {
        self.stopped.get_or_insert(reason);
    }
}

/// Stops all threads if this thread panics: they would wait for its tile for ever.
struct StopOnPanic<'s, 'a> {
    render: &'s SharedRender<'a>,
    has_ended: bool,
}

impl Drop for StopOnPanic<'_, '_> {
    fn drop(&mut self) {
        if !self.has_ended {
            self.render.lock().stop(Stopped::Cancelled);
            self.render.changed.notify_all();
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rows_bound_the_memory_of_large_pictures() {
        let rows = |width, edge| rows_in_window(Region { x: 0, y: 0, width, height: 5000 }, edge);
        assert_eq!((rows(640, 32), rows(3840, 16), rows(1 << 30, 16)), (12, 4, 1));
        assert!(memory_bytes(Region { x: 0, y: 0, width: 3840, height: 2160 }) < 32 << 20);
    }
}
