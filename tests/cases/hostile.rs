//! Bad input of every kind ends in a message with a span and the right exit code: without a panic, a signal, a hang,
//! unbounded time or memory, or a partly written file.
//!
//! Three parts: a table of hostile input for the command, seeded mutations of all our scenes for the library, and all
//! files of POV-Ray's distribution where it is installed. `DURER_FUZZ=100000 cargo test --test cases hostile::fuzz`
//! tests more mutants, `DURER_SEED=N` repeats one.

mod command_line;
mod format;
mod fuzz;
mod geometry;
mod library_run;
mod limited_run;
mod not_a_scene;
mod povray_distribution;
mod runaway;
mod scene_files;
mod split_brackets;

use crate::Group;
use libtest_mimic::Trial;

pub fn group() -> Group {
    let tables = [
        not_a_scene::cases(),
        runaway::cases(),
        split_brackets::cases(),
        geometry::cases(),
        command_line::cases(),
        scene_files::cases(),
        format::cases(),
    ];
    let cases = tables.into_iter().flatten();
    let mut trials: Vec<Trial> =
        cases.map(|case| Trial::test(format!("hostile::{}", case.name), move || case.run())).collect();
    trials.extend(command_line::trials());
    trials.extend(scene_files::trials());
    trials.extend(fuzz::trials());
    trials.extend(povray_distribution::trials());
    Group { tests: trials, at_least: 460 }
}
