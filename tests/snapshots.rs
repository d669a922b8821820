//! Every scene below `scenes/` that has a snapshot still looks like it. `durer test scenes --report DIR` shows what differs,
//! `durer test scenes --accept` takes it.

mod trials;

use durer::cli::{Exit, test};
use libtest_mimic::{Failed, Trial};
use std::path::PathBuf;

fn main() {
    let cases = durer::snapshot::find(&durer::source::Disk, &[PathBuf::from("scenes")]).unwrap_or_default();
    let trial = |case: durer::snapshot::Case| {
        Trial::test(case.scene.display().to_string(), move || {
            let setting = test::Setting { threads: 1, ..Default::default() };
            let outcome = durer::on_big_stack(|| test::try_quietly(&case, &setting));
            if outcome.exit == Exit::Fine {
                return Ok(());
            }
            Err(Failed::from(format!("{}\n{}", outcome.text, outcome.messages)))
        })
    };
    trials::run(cases.into_iter().map(trial).collect(), 100);
}
