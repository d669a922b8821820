//! Order in which threads render the tiles of a picture, without a moment at which all threads wait for the slowest.
//!
//! Tiles are started row by row from the top. A tile of the final pass is started as soon as the first samples around its
//! row of tiles are complete, and before any tile of the first pass, so that few rows are kept in memory. The first pass
//! is at most a window of rows ahead of the rows that are passed on.

use super::Region;
use std::collections::VecDeque;
use std::ops::Range;

/// Tiles of an area: squares whose corners are at multiples of their edge, cut off at the ends of the area.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct TileGrid {
    area: Region,
    edge: usize,
}

impl TileGrid {
    /// Creates the grid of tiles with edges of `edge` pixels.
    pub fn new(area: Region, edge: usize) -> Self {
        Self { area, edge }
    }

    /// Returns the edge of the tiles in pixels.
    pub fn edge(&self) -> usize {
        self.edge
    }

    /// Returns the number of tiles side by side.
    pub fn n_columns(&self) -> usize {
        n_cuts(self.area.x, self.area.width, self.edge)
    }

    /// Returns the number of rows of tiles.
    pub fn n_rows(&self) -> usize {
        n_cuts(self.area.y, self.area.height, self.edge)
    }

    /// Returns the tile in a row and column of tiles.
    pub fn tile(&self, place: Place) -> Region {
        let (x, y) = (self.columns_of_pixels(place.column), self.rows_of_pixels(place.row));
        Region { x: x.start, y: y.start, width: x.len(), height: y.len() }
    }

    /// Returns all tiles, row by row from the top.
    pub fn tiles(self) -> impl Iterator<Item = Region> {
        let places =
            (0..self.n_rows()).flat_map(move |row| (0..self.n_columns()).map(move |column| Place { row, column }));
        places.map(move |place| self.tile(place))
    }

    /// Returns the pixel rows that a row of tiles covers.
    pub fn rows_of_pixels(&self, row: usize) -> Range<usize> {
        cut(self.area.y, self.area.height, self.edge, row)
    }

    fn columns_of_pixels(&self, column: usize) -> Range<usize> {
        cut(self.area.x, self.area.width, self.edge, column)
    }

    /// Returns the rows and the columns of the tiles that overlap `part`, a part of the area that is not empty.
    pub fn rows_and_columns_around(&self, part: Region) -> (Range<usize>, Range<usize>) {
        let around = |start: usize, part_start: usize, length: usize| {
            let first = start / self.edge;
            part_start / self.edge - first..(part_start + length - 1) / self.edge - first + 1
        };
        (around(self.area.y, part.y, part.height), around(self.area.x, part.x, part.width))
    }
}

/// Returns the number of pieces into which multiples of `edge` cut the numbers from `start` on.
fn n_cuts(start: usize, length: usize, edge: usize) -> usize {
    if length == 0 { 0 } else { (start + length).div_ceil(edge) - start / edge }
}

/// Returns piece `number` of these numbers.
fn cut(start: usize, length: usize, edge: usize, number: usize) -> Range<usize> {
    let from = (start / edge + number) * edge;
    from.max(start)..(from + edge).min(start + length)
}

/// Row and column of a tile in its grid.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Place {
    pub row: usize,
    pub column: usize,
}

/// Next step of a thread.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Task {
    /// Render this tile of the first pass.
    First(Place),
    /// Render this tile of the final pass.
    Final(Place),
    /// Pass on this row of finished tiles of the final pass. Only one thread does so at a time.
    PassOn(usize),
    /// Wait until another thread has finished its task.
    Wait,
    /// Nothing is left for this thread.
    End,
}

/// State of one pass: the results `T` of its finished tiles, as long as they are needed.
#[derive(Debug)]
struct Pass<T> {
    n_rows: usize,
    n_columns: usize,
    /// Tile that is started next.
    next: Place,
    /// Number of complete rows of tiles from the top.
    n_complete: usize,
    /// Number of rows that were dropped from `rows`.
    n_dropped: usize,
    /// Results of the tiles, from the first row on that is kept to the last that was started.
    rows: VecDeque<Vec<Option<T>>>,
}

impl<T> Pass<T> {
    fn new(grid: Option<TileGrid>) -> Self {
        Self {
            n_rows: grid.map_or(0, |grid| grid.n_rows()),
            n_columns: grid.map_or(0, |grid| grid.n_columns()),
            next: Place { row: 0, column: 0 },
            n_complete: 0,
            n_dropped: 0,
            rows: VecDeque::new(),
        }
    }

    /// True if no tile of the pass is left to be started.
    fn is_started(&self) -> bool {
        self.next.row == self.n_rows
    }

    /// Starts the next tile.
    fn start(&mut self) -> Place {
        let place = self.next;
        if place.column == 0 {
            self.rows.push_back(std::iter::repeat_with(|| None).take(self.n_columns).collect());
        }
        self.next.column += 1;
        if self.next.column == self.n_columns {
            self.next = Place { row: place.row + 1, column: 0 };
        }
        place
    }

    fn finish(&mut self, place: Place, result: T) {
        self.rows[place.row - self.n_dropped][place.column] = Some(result);
        while self.n_complete < self.next.row && self.row(self.n_complete).iter().all(Option::is_some) {
            self.n_complete += 1;
        }
    }

    /// Returns the tiles of a row that is kept.
    fn row(&self, row: usize) -> &[Option<T>] {
        &self.rows[row - self.n_dropped]
    }

    /// Drops the results of the rows above `row`, which are complete.
    fn drop_above(&mut self, row: usize) {
        let n_dropped = row.saturating_sub(self.n_dropped);
        self.rows.drain(..n_dropped);
        self.n_dropped += n_dropped;
    }
}

/// Order of the tiles of both passes, and the results `T` of those that are finished and still needed.
pub(super) struct Schedule<'a, T> {
    first: Pass<T>,
    last: Pass<T>,
    /// Returns the rows of first tiles that a row of final tiles needs.
    needed_rows: Box<dyn Fn(usize) -> Range<usize> + Send + 'a>,
    /// Number of rows of final tiles that threads may be ahead of the first row that is not passed on.
    window: usize,
    n_passed_on: usize,
    is_passing_on: bool,
}

impl<'a, T> Schedule<'a, T> {
    /// Creates the schedule of a picture with these tiles in both passes; `first` is `None` for a picture of one pass.
    /// `needed_rows` returns the rows of first tiles that a row of final tiles needs, which increase from row to row. Threads
    /// are at most `window` rows of final tiles ahead of the first row that is not passed on.
    pub fn new(
        first: Option<TileGrid>,
        last: TileGrid,
        window: usize,
        needed_rows: impl Fn(usize) -> Range<usize> + Send + 'a,
    ) -> Self {
        Self {
            first: Pass::new(first),
            last: Pass::new(Some(last)),
            needed_rows: Box::new(needed_rows),
            window,
            n_passed_on: 0,
            is_passing_on: false,
        }
    }

    /// Returns the next step of a thread; a tile or row in it counts as started.
    pub fn next_task(&mut self) -> Task {
        if !self.is_passing_on && self.n_passed_on < self.last.n_complete {
            self.is_passing_on = true;
            return Task::PassOn(self.n_passed_on);
        }
        let last_allowed = (self.n_passed_on + self.window).min(self.last.n_rows.saturating_sub(1));
        if !self.last.is_started() && self.last.next.row <= last_allowed {
            if (self.needed_rows)(self.last.next.row).end <= self.first.n_complete {
                return Task::Final(self.last.start());
            }
            if !self.first.is_started() && self.first.next.row < (self.needed_rows)(last_allowed).end {
                return Task::First(self.first.start());
            }
        }
        if self.last.is_started() { Task::End } else { Task::Wait }
    }

    /// Stores the result of the tile that a task has rendered, and drops the first tiles that no other tile needs.
    pub fn finish_tile(&mut self, task: Task, result: T) {
        match task {
            Task::First(place) => self.first.finish(place, result),
            Task::Final(place) => {
                self.last.finish(place, result);
                if self.last.n_complete < self.last.n_rows {
                    let needed = (self.needed_rows)(self.last.n_complete);
                    self.first.drop_above(needed.start.min(self.first.n_complete));
                }
            }
            Task::PassOn(_) | Task::Wait | Task::End => {}
        }
    }

    /// Removes and returns the results of the row that is now passed on, from left to right.
    pub fn take_row(&mut self, row: usize) -> Vec<T> {
        self.last.rows[row - self.last.n_dropped].drain(..).flatten().collect()
    }

    /// Ends the task of passing on a row.
    pub fn finish_passing_on(&mut self, row: usize) {
        self.last.drop_above(row + 1);
        self.n_passed_on = row + 1;
        self.is_passing_on = false;
    }
}

impl<T: Clone> Schedule<'_, T> {
    /// Returns the results of first tiles in a rectangle of rows and columns.
    pub fn first_results(&self, (rows, columns): (Range<usize>, Range<usize>)) -> Vec<(Place, T)> {
        let places = rows.flat_map(|row| columns.clone().map(move |column| Place { row, column }));
        places.filter_map(|place| Some((place, self.first.row(place.row)[place.column].clone()?))).collect()
    }
}

#[cfg(test)]
mod tests;
