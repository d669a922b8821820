//! Every scene below `scenes/` with a snapshot still matches it. `durer test scenes --report DIR` shows the
//! differences, `durer test scenes --accept` updates the snapshots.

use crate::Group;
use durer::cli::{Exit, test};
use libtest_mimic::{Failed, Trial};
use std::path::Path;

pub fn group() -> Group {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let cases = durer::snapshot::find(&durer::source::Disk, &[root.join("scenes")]).unwrap_or_default();
    let trial = |case: durer::snapshot::Case| {
        let name = case.scene.strip_prefix(root).unwrap_or(&case.scene).display().to_string();
        Trial::test(format!("snapshots::{name}"), move || {
            let setting = test::Setting { threads: 1, ..Default::default() };
            let outcome = durer::on_big_stack(|| test::try_quietly(&case, &setting));
            if outcome.exit == Exit::Fine {
                return Ok(());
            }
            Err(Failed::from(format!("{}\n{}", outcome.text, outcome.messages)))
        })
    };
    Group { tests: cases.into_iter().map(trial).collect(), at_least: 100 }
}
