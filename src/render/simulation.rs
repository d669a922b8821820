//! Simulation of the threads of a render, from the times that its tiles take: shows how busy more processors would be than
//! this machine has.

use super::antialias::Method;
use super::prepare::FrameCamera;
use super::schedule::{Schedule, Task};
use super::threads::PassTiles;
use super::{Options, Tile};
use crate::world::World;

/// Returns the share of the time in which `threads` threads would be busy with the tiles of a picture, of which each takes
/// the time `seconds`. Passing on rows takes no time.
#[doc(hidden)]
pub fn simulated_busy_share(world: &World, options: &Options, threads: usize, seconds: &dyn Fn(Tile) -> f64) -> f64 {
    let camera = FrameCamera::new(&world.eye, options.width, options.height);
    let method = Method::new(world, camera.lens.as_ref(), options);
    let tiles = PassTiles::new(&method, options.rendered_region());
    simulate(tiles.schedule(&method), threads, |task| tiles.tile(task).map_or(0.0, seconds)).1
}

/// Simulates threads that take `seconds` for each task. Returns all tasks in the order in which they are finished, and the
/// share of the time in which the threads are busy.
pub(super) fn simulate(mut schedule: Schedule<()>, threads: usize, seconds: impl Fn(Task) -> f64) -> (Vec<Task>, f64) {
    let mut running: Vec<(f64, Task)> = vec![];
    let (mut now, mut busy, mut finished) = (0.0, 0.0, vec![]);
    loop {
        while running.len() < threads {
            let task = schedule.next_task();
            if matches!(task, Task::Wait | Task::End) {
                break;
            }
            busy += seconds(task);
            running.push((now + seconds(task), task));
        }
        let Some(earliest) = (0..running.len()).min_by(|&a, &b| running[a].0.total_cmp(&running[b].0)) else { break };
        let (end, task) = running.swap_remove(earliest);
        if let Task::PassOn(row) = task {
            schedule.take_row(row);
            schedule.finish_passing_on(row);
        } else {
            schedule.finish_tile(task, ());
        }
        finished.push(task);
        now = end;
    }
    (finished, busy / (now * threads as f64))
}
