//! Bad input of every kind ends in a message with a place and the right exit code: never in a panic, a signal, a hang,
//! without bound in time or memory, or with a file half written.
//!
//! Three parts: a table of hostile input for the command, seeded mutations of all our scenes for the library, and every
//! file of POV-Ray's distribution where it is installed. `DURER_FUZZ=100000 cargo test --test hostile fuzz` mutates longer,
//! `DURER_SEED=N` repeats one.

#![allow(clippy::unwrap_used)]

#[path = "hostile/arena.rs"]
mod arena;
#[path = "hostile/files.rs"]
mod files;
#[path = "hostile/format.rs"]
mod format;
#[path = "hostile/fuzz.rs"]
mod fuzz;
#[path = "hostile/geometry.rs"]
mod geometry;
#[path = "hostile/library.rs"]
mod library;
#[path = "hostile/mutate.rs"]
mod mutate;
#[path = "hostile/outside.rs"]
mod outside;
#[path = "hostile/pieces.rs"]
mod pieces;
#[path = "hostile/povray.rs"]
mod povray;
#[path = "hostile/runaway.rs"]
mod runaway;
#[path = "hostile/text.rs"]
mod text;

mod trials;

use libtest_mimic::Trial;

fn main() {
    let tables = [
        text::cases(),
        runaway::cases(),
        pieces::cases(),
        geometry::cases(),
        outside::cases(),
        files::cases(),
        format::cases(),
    ];
    let cases = tables.into_iter().flatten();
    let mut trials: Vec<Trial> = cases.map(|case| Trial::test(case.name, move || case.run())).collect();
    trials.extend(outside::trials());
    trials.extend(files::trials());
    trials.extend(fuzz::trials());
    trials.extend(povray::trials());
    trials::run(trials, 460);
}
