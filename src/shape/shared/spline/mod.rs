//! Plane curves that `prism` and `lathe` sweep: chains of Bézier segments (Farin, Curves and Surfaces, 1988).

mod curve;
mod points;

pub use curve::{Curve, blend, blend_slope, product, turns};
pub use points::{Interpolation, KINDS, outlines, read_points, report_open, single_row};
