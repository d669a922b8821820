//! Plane curves that `prism` and `lathe` sweep: chains of Bézier segments (Farin, Curves and Surfaces, 1988).

mod curve;
mod points;

pub use curve::{Curve, bernstein_derivative_at, bernstein_product, derivative_roots, evaluate_bernstein};
pub use points::{Interpolation, KINDS, closed_outlines, read_points, report_open, single_outline};
