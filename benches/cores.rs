//! Simulation of processors with more cores than this machine has: draws a picture on one thread, records the time of each tile,
//! and prints how busy 2 to 64 threads would be with these tiles.
//!
//! `cargo bench -p durer-benches --bench cores [-- SCENE WIDTH HEIGHT]`; without arguments, benches/instructions/plain.pov at 1920x1080.

#![allow(clippy::unwrap_used, missing_docs)]

use durer::interpreter;
use durer::render::{Options, SampleLayout, Sampling, Tile, Watch, render, simulated_busy_share};
use durer::source::{SearchPath, Sources};
use durer::world::World;
use std::path::Path;
use std::sync::Mutex;
use std::time::Instant;

/// Records the seconds that each tile takes: from the end of the tile before, on one thread.
struct Recorder {
    last: Mutex<Instant>,
    seconds: Mutex<Vec<(Tile, f64)>>,
}

impl Watch for Recorder {
    fn progress(&self, _: usize, _: usize) {
        *self.last.lock().unwrap() = Instant::now();
    }

    fn cancelled(&self) -> bool {
        false
    }

    fn store_tile(&self, tile: Tile, _: &[[f32; 4]]) {
        let seconds = self.last.lock().unwrap().elapsed().as_secs_f64();
        self.seconds.lock().unwrap().push((tile, seconds));
    }
}

fn load(path: &Path, size: (usize, usize)) -> World {
    let sources = Sources::default();
    let file = durer::load_bytes(&sources, "scene", std::fs::read(path).unwrap()).unwrap();
    let folder = path.parent().unwrap();
    let reading =
        interpreter::Options { search: SearchPath::new(folder, &[]), size, ..interpreter::Options::default() };
    durer::build(&sources, file, &reading, &mut |_| {}).world.unwrap()
}

fn main() {
    let arguments: Vec<String> = std::env::args().skip(1).filter(|argument| argument != "--bench").collect();
    let plain = concat!(env!("CARGO_MANIFEST_DIR"), "/instructions/plain.pov");
    let path = arguments.first().map_or(plain, String::as_str);
    let side = |number: usize, default: usize| arguments.get(number).map_or(default, |text| text.parse().unwrap());
    let (width, height) = (side(1, 1920), side(2, 1080));
    let world = load(Path::new(path), (width, height));
    let sampling = Sampling { layout: SampleLayout::Grid, ..Sampling::default() };
    let options = Options { antialias: Some(0.3), sampling, ..Options::new(width, height) };
    let recorder = Recorder { last: Mutex::new(Instant::now()), seconds: Mutex::new(vec![]) };
    render(&world, &options, &recorder).unwrap();
    let recorded = recorder.seconds.into_inner().unwrap();
    let seconds = |tile: Tile| recorded.iter().find(|(other, _)| *other == tile).unwrap().1;
    let total: f64 = recorded.iter().map(|(_, seconds)| seconds).sum();
    let longest = recorded.iter().map(|(_, seconds)| *seconds).fold(0.0, f64::max);
    println!("{} tiles, {total:.2} s, the longest {:.1} ms", recorded.len(), longest * 1e3);
    for threads in [2, 4, 8, 16, 32, 64] {
        let busy = simulated_busy_share(&world, &options, threads, &seconds);
        println!("{threads:3} threads: {:.1} % busy", busy * 100.0);
    }
}
