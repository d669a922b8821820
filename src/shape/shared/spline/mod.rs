//! Plane curves that `prism` and `lathe` sweep: chains of Bézier segments (Farin, Curves and Surfaces, 1988).

mod curve;
mod points;

pub use curve::{Curve, bernstein_derivative_at, bernstein_derivative_roots, bernstein_product, evaluate_bernstein};
pub use points::{
    Interpolation, KINDS, outlines_and_is_unclosed, read_points, single_outline, warn_of_unclosed_outline,
};
