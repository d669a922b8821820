//! Geometry and readers that several shapes share; no shape by themselves.

pub mod formula;
pub mod frustum;
pub mod spline;
pub mod turned;

pub use formula::{Container, Formula};
pub use frustum::Frustum;
pub use spline::{Curve, Interpolation};
