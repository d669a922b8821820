//! Tests found in folders and tables: each file of `tests/ui`, each section of `tests/lang`, each row of a table is a
//! test. One binary, since each links the whole program. `cargo test --test cases ui::` runs those of one kind.

#![allow(clippy::unwrap_used)]

mod hostile;
mod lang;
mod library;
mod manual;
#[path = "../support/mutate.rs"]
mod mutate;
mod patterns;
mod snapshots;
mod ui;

use libtest_mimic::{Arguments, Trial};

/// The tests of one module, and the least number of them: a folder that is not found would otherwise pass as "no failures".
struct Group {
    tests: Vec<Trial>,
    at_least: usize,
}

fn main() {
    // Scenes write their files to the current folder.
    std::env::set_current_dir(env!("CARGO_TARGET_TMPDIR")).unwrap();
    let groups = [
        hostile::group(),
        lang::group(),
        library::group(),
        manual::group(),
        patterns::group(),
        snapshots::group(),
        ui::group(),
    ];
    let tests = groups.into_iter().flat_map(|group| {
        let found = group.tests.len();
        let first = group.tests.first().map_or("", Trial::name).to_string();
        assert!(found >= group.at_least, "{first} …: {found} tests were found, at least {} exist", group.at_least);
        group.tests
    });
    libtest_mimic::run(&Arguments::from_args(), tests.collect()).exit()
}
