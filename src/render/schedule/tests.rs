use super::*;
use crate::math::rng;
use crate::render::simulation::simulate;
use std::collections::HashSet;

/// Edge of the tiles of the first pass, and of the blocks of the final pass, in pixels.
const EDGES: [usize; 2] = [16, 32];

fn grids(area: Region) -> [TileGrid; 2] {
    EDGES.map(|edge| TileGrid::new(area, edge))
}

/// Schedule of a picture whose final tiles need the first samples of their own rows and of one row below.
fn schedule(area: Region, window: usize) -> Schedule<'static, ()> {
    let [first, last] = grids(area);
    let needed_rows = move |row: usize| {
        let pixels = last.rows_of_pixels(row);
        let end = (pixels.end + 1).min(area.y + area.height);
        let part = Region { y: pixels.start, height: end - pixels.start, ..area };
        first.rows_and_columns_around(part).0
    };
    Schedule::new(Some(first), last, window, needed_rows)
}

/// Random seconds for each task, from 0.5 to 1.5 times the number of pixels; passing on takes none.
fn random_seconds(task: Task) -> f64 {
    let (pass, place) = match task {
        Task::First(place) => (0, place),
        Task::Final(place) => (1, place),
        _ => return 0.0,
    };
    let random = rng::random_unit(&[pass as u64, place.row as u64, place.column as u64]);
    (EDGES[pass] * EDGES[pass]) as f64 * (0.5 + random)
}

#[test]
fn tiles_cover_their_area_once() {
    let area = Region { x: 3, y: 5, width: 40, height: 100 };
    for grid in [TileGrid::new(area, 16), TileGrid::new(area, 32), TileGrid::new(area, 1)] {
        let mut pixels = HashSet::new();
        for row in 0..grid.n_rows() {
            for column in 0..grid.n_columns() {
                let tile = grid.tile(Place { row, column });
                assert_eq!(grid.rows_and_columns_around(tile), (row..row + 1, column..column + 1));
                for y in tile.y..tile.y + tile.height {
                    (tile.x..tile.x + tile.width).for_each(|x| assert!(pixels.insert((x, y))));
                }
            }
        }
        assert_eq!(pixels.len(), area.n_pixels());
        assert_eq!(grid.rows_and_columns_around(area), (0..grid.n_rows(), 0..grid.n_columns()));
    }
    assert_eq!(TileGrid::new(Region { height: 0, ..area }, 16).n_rows(), 0);
}

#[test]
fn each_tile_is_finished_once_and_after_the_tiles_it_needs() {
    let area = Region { x: 3, y: 21, width: 130, height: 170 };
    let [first, last] = grids(area);
    for (threads, window) in [(1, 1), (1, 5), (2, 0), (7, 1), (64, 3)] {
        let (tasks, _) = simulate(schedule(area, window), threads, random_seconds);
        let n_tasks = |is_wanted: fn(&Task) -> bool| tasks.iter().filter(|task| is_wanted(task)).count();
        assert_eq!(n_tasks(|task| matches!(task, Task::First(_))), first.n_rows() * first.n_columns());
        assert_eq!(n_tasks(|task| matches!(task, Task::Final(_))), last.n_rows() * last.n_columns());
        let rows = tasks.iter().filter_map(|task| if let Task::PassOn(row) = task { Some(*row) } else { None });
        assert!(rows.eq(0..last.n_rows()), "rows are passed on from the top");
        let mut done = HashSet::new();
        for task in tasks {
            if let Task::Final(place) = task {
                let pixels = last.tile(place);
                let below = (pixels.y + pixels.height).min(area.y + area.height - 1);
                let (rows, _) = first.rows_and_columns_around(Region { y: below, height: 1, ..pixels });
                assert!((0..first.n_columns()).all(|column| done.contains(&(rows.start, column))), "{place:?}");
            }
            if let Task::First(Place { row, column }) = task {
                done.insert((row, column));
            }
        }
    }
}

#[test]
fn threads_stay_in_the_window() {
    let area = Region { x: 0, y: 0, width: 64, height: 32 * 20 };
    let mut schedule = schedule(area, 2);
    // Row 0 is never passed on: the three rows of the window can be rendered, and the first pass as far as they need it.
    let (mut n_first, mut n_final) = (0, 0);
    loop {
        match schedule.next_task() {
            task @ Task::First(_) => (n_first, _) = (n_first + 1, schedule.finish_tile(task, ())),
            task @ Task::Final(_) => (n_final, _) = (n_final + 1, schedule.finish_tile(task, ())),
            Task::PassOn(_) => {}
            Task::Wait | Task::End => break,
        }
    }
    assert_eq!((n_first, n_final), (7 * 4, 3 * 2));
}

#[test]
fn sixty_four_threads_are_busy() {
    let area = Region { x: 0, y: 0, width: 1920, height: 1080 };
    let (_, busy) = simulate(schedule(area, 4), 64, random_seconds);
    assert!(busy > 0.9, "{busy}");
}

#[test]
fn picture_of_one_pass() {
    let area = Region { x: 0, y: 0, width: 100, height: 40 };
    let schedule = Schedule::new(None, TileGrid::new(area, 16), 1, |_| 0..0);
    let (tasks, _) = simulate(schedule, 3, random_seconds);
    assert_eq!(tasks.iter().filter(|task| matches!(task, Task::Final(_))).count(), 7 * 3);
}
