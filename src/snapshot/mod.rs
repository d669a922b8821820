//! Snapshots: a scene and its expected picture, side by side in a folder (`ball.scene`, `ball.snapshot.png`).

mod compare;
mod find;
mod report;

pub use compare::{Comparison, Tolerance, Verdict, compare, difference};
pub use find::{Case, find, header, is_snapshot};
pub use report::{Entry, Report, report};
