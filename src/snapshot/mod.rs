//! Snapshots: a scene and its expected picture, side by side in a folder (`ball.scene`, `ball.snapshot.png`).

mod compare;
mod find;
mod report;

pub use compare::{Comparison, Tolerance, Verdict, compare, difference_map};
pub use find::{Case, find, is_snapshot, test_options};
pub use report::{Entry, Report, report};
