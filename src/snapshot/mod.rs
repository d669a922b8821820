//! Snapshots: a scene and the picture that it gave, side by side in a folder (`ball.scene`, `ball.png`).

mod compare;
mod find;
mod report;

pub use compare::{Comparison, Tolerance, Verdict, compare, difference};
pub use find::{Case, find, header};
pub use report::{Entry, Report, report};
