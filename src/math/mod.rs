//! Vectors, transforms, rays and boxes: mathematics without any concept of the scene language.

mod aabb;
pub mod bvh;
pub mod cancel;
mod complex;
mod crossing;
pub mod fork;
pub mod fp;
mod lanes;
pub mod noise;
pub mod packet;
mod poly;
mod quadratic;
mod ray;
pub mod registers;
pub mod rng;
mod sheared;
mod spread;
pub mod statistics;
pub mod tolerance;
mod transform;

pub use aabb::Aabb;
pub use complex::Complex;
pub use crossing::root_between;
pub use glam::{DAffine3, DMat3, DQuat, DVec2, DVec3};
pub use lanes::{Lanes, Mask, Real, sign_bits};
pub use poly::{
    MAX_DEGREE, bernstein_roots, bernstein_roots_in_window, polynomial_roots_between, quadratic_roots_of_lanes,
    solve_quadratic, solve_quadratic_with_discriminant,
};
pub use quadratic::Quadratic;
pub use ray::{Range, Ray};
pub use sheared::Sheared;
pub use spread::{GOLDEN_SECTION, next_coprime};
pub use transform::{Singular, Transform};
