//! Trials that are found in folders and tables.

use libtest_mimic::{Arguments, Trial};

/// Runs them, if there are at least so many: where nothing is found, nothing is tested.
pub fn run(trials: Vec<Trial>, least: usize) -> ! {
    let found = trials.len();
    assert!(found >= least, "only {found} trials were found, and there were {least} before");
    libtest_mimic::run(&Arguments::from_args(), trials).exit()
}
