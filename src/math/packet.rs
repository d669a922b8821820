//! Packets of rays, which are traced side by side (Wald, Slusallek, Benthin and Wagner, Interactive rendering with coherent ray
//! tracing, 2001). Each ray of a packet has the bits that it has alone.

use super::{Aabb, DAffine3, DMat3, DVec3, Lanes, Mask, Ray, Transform};
use std::ops::{Add, Div, Mul, Neg, Sub};

/// Number of rays in a packet.
pub const PACKET: usize = 8;

/// Minimum number of rays that are traced as a packet; fewer are quicker one by one.
pub const MIN_RAYS: usize = 3;

/// A number for each ray of a packet.
pub type Numbers = Lanes<PACKET>;

/// A truth value for each ray of a packet.
pub type Flags = Mask<PACKET>;

/// A vector for each ray of a packet.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Vectors {
    /// The x coordinates.
    pub x: Numbers,
    /// The y coordinates.
    pub y: Numbers,
    /// The z coordinates.
    pub z: Numbers,
}

/// Rays that are traced side by side.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RayPacket {
    /// Origin of each ray.
    pub origin: Vectors,
    /// Direction of each ray.
    pub dir: Vectors,
}

/// Returns the lanes whose bits are set, the lowest first.
#[inline(always)]
pub fn set_lanes(mut bits: u32) -> impl Iterator<Item = usize> {
    std::iter::from_fn(move || {
        let lane = (bits != 0).then(|| bits.trailing_zeros() as usize & (PACKET - 1));
        bits &= bits.wrapping_sub(1);
        lane
    })
}

impl Vectors {
    /// The vector 0 for each ray.
    pub const ZERO: Self = Self { x: Lanes([0.0; PACKET]), y: Lanes([0.0; PACKET]), z: Lanes([0.0; PACKET]) };

    /// Returns the same vector for each ray.
    #[inline(always)]
    pub fn splat(v: DVec3) -> Self {
        Self { x: Lanes::splat(v.x), y: Lanes::splat(v.y), z: Lanes::splat(v.z) }
    }

    /// Returns the columns of a matrix, each the same for each ray. (The compiler does not always inline `map` of arrays.)
    #[inline(always)]
    fn splat_columns(m: &DMat3) -> [Self; 3] {
        [Self::splat(m.x_axis), Self::splat(m.y_axis), Self::splat(m.z_axis)]
    }

    /// Returns the vectors of a list.
    #[inline(always)]
    pub fn from_array(list: &[DVec3; PACKET]) -> Self {
        let mut all = Self::ZERO;
        for (i, v) in list.iter().enumerate() {
            all.set_lane(i, *v);
        }
        all
    }

    /// Returns the vector of one ray.
    #[inline(always)]
    pub fn lane(&self, i: usize) -> DVec3 {
        DVec3::new(self.x.0[i], self.y.0[i], self.z.0[i])
    }

    /// Sets the vector of one ray.
    #[inline(always)]
    pub fn set_lane(&mut self, i: usize, v: DVec3) {
        (self.x.0[i], self.y.0[i], self.z.0[i]) = (v.x, v.y, v.z);
    }

    /// Returns the products by coordinates.
    #[inline(always)]
    pub fn times(self, other: Self) -> Self {
        Self { x: self.x * other.x, y: self.y * other.y, z: self.z * other.z }
    }

    /// True for the vectors that are 0.
    #[inline(always)]
    pub fn is_zero(self) -> Flags {
        let zero = Lanes::splat(0.0);
        self.x.equals(zero) & self.y.equals(zero) & self.z.equals(zero)
    }

    /// Returns the vectors of `if_true` for the rays that are true, and those of `if_false` for the others.
    #[inline(always)]
    pub fn select(flags: Flags, if_true: Self, if_false: Self) -> Self {
        Self {
            x: flags.select(if_true.x, if_false.x),
            y: flags.select(if_true.y, if_false.y),
            z: flags.select(if_true.z, if_false.z),
        }
    }

    /// Returns the coordinates along the three axes.
    #[inline(always)]
    pub fn axes(&self) -> [Numbers; 3] {
        [self.x, self.y, self.z]
    }

    /// Returns the dot products with other vectors.
    #[inline(always)]
    pub fn dot(self, other: Self) -> Numbers {
        self.x * other.x + self.y * other.y + self.z * other.z
    }

    /// Returns the squared lengths.
    #[inline(always)]
    pub fn length_squared(self) -> Numbers {
        self.dot(self)
    }

    /// True for the vectors whose coordinates are finite.
    #[inline(always)]
    pub fn is_finite(self) -> Flags {
        self.x.is_finite() & self.y.is_finite() & self.z.is_finite()
    }

    /// Returns vectors of length 1 in the same directions; those of `fallback` for vectors without a direction.
    #[inline(always)]
    pub fn normalize_or(self, fallback: Self) -> Self {
        let reciprocal = Lanes::splat(1.0) / self.length_squared().sqrt();
        let has_direction = reciprocal.is_finite() & Lanes::splat(0.0).less_than(reciprocal);
        Self::select(has_direction, self * reciprocal, fallback)
    }

    /// Returns the normals M⁻ᵀ·n, as [`Transform::transform_normal`] does.
    #[inline(always)]
    pub fn transformed_as_normals(self, m: &Transform) -> Self {
        let inv = &m.inv.matrix3;
        let [x, y, z] = Self::splat_columns(inv);
        Self { x: x.dot(self), y: y.dot(self), z: z.dot(self) }
    }

    /// Returns the products of a matrix with the vectors.
    #[inline(always)]
    pub fn multiplied_by(self, m: &DMat3) -> Self {
        let [x, y, z] = Self::splat_columns(m);
        x * self.x + y * self.y + z * self.z
    }

    /// Returns the images of points (w = 1) under an affine map.
    #[inline(always)]
    pub fn transformed_as_points(self, m: &DAffine3) -> Self {
        self.multiplied_by(&m.matrix3) + Self::splat(m.translation)
    }
}

impl Neg for Vectors {
    type Output = Self;
    #[inline(always)]
    fn neg(self) -> Self {
        Self { x: -self.x, y: -self.y, z: -self.z }
    }
}

impl Add for Vectors {
    type Output = Self;
    #[inline(always)]
    fn add(self, other: Self) -> Self {
        Self { x: self.x + other.x, y: self.y + other.y, z: self.z + other.z }
    }
}

impl Sub for Vectors {
    type Output = Self;
    #[inline(always)]
    fn sub(self, other: Self) -> Self {
        Self { x: self.x - other.x, y: self.y - other.y, z: self.z - other.z }
    }
}

impl Mul<Numbers> for Vectors {
    type Output = Self;
    #[inline(always)]
    fn mul(self, factors: Numbers) -> Self {
        Self { x: self.x * factors, y: self.y * factors, z: self.z * factors }
    }
}

impl Div<Numbers> for Vectors {
    type Output = Self;
    #[inline(always)]
    fn div(self, divisors: Numbers) -> Self {
        Self { x: self.x / divisors, y: self.y / divisors, z: self.z / divisors }
    }
}

impl RayPacket {
    /// Rays without a direction.
    pub const ZERO: Self = Self { origin: Vectors::ZERO, dir: Vectors::ZERO };

    /// Creates the packet of some rays, at least one; the last one also fills the lanes that are left.
    #[inline(always)]
    pub fn new(n_rays: usize, ray: impl Fn(usize) -> Ray) -> Self {
        let (mut origins, mut dirs) = ([DVec3::ZERO; PACKET], [DVec3::ZERO; PACKET]);
        for i in 0..PACKET {
            let Ray { origin, dir } = ray(i.min(n_rays - 1));
            (origins[i], dirs[i]) = (origin, dir);
        }
        Self { origin: Vectors::from_array(&origins), dir: Vectors::from_array(&dirs) }
    }

    /// Returns the points of the rays at these parameters.
    #[inline(always)]
    pub fn at(&self, t: Numbers) -> Vectors {
        self.origin + self.dir * t
    }

    /// Returns one ray.
    #[inline(always)]
    pub fn ray(&self, i: usize) -> Ray {
        Ray::new(self.origin.lane(i), self.dir.lane(i))
    }

    /// Sets one ray.
    #[inline(always)]
    pub fn set_ray(&mut self, i: usize, ray: &Ray) {
        self.origin.set_lane(i, ray.origin);
        self.dir.set_lane(i, ray.dir);
    }

    /// Returns the rays in the space of an object, M⁻¹·ray, as [`Transform::inverse_transform_ray`] does.
    #[inline(always)]
    pub fn inverse_transformed(&self, m: &Transform) -> Self {
        Self { origin: self.origin.transformed_as_points(&m.inv), dir: self.dir.multiplied_by(&m.inv.matrix3) }
    }

    /// Returns for which rays, in ranges of parameters, some point is in a box, and the parts of the ranges in the box, as
    /// [`Aabb::slabs`] does.
    #[inline(always)]
    pub fn slabs(&self, around: &Aabb, min: Numbers, max: Numbers) -> (Flags, Numbers, Numbers) {
        let (mut near, mut far) = (min, max);
        for (axis, (o, v)) in self.origin.axes().into_iter().zip(self.dir.axes()).enumerate() {
            let inverse = Lanes::splat(1.0) / v;
            let lo = (Lanes::splat(around.min[axis]) - o) * inverse;
            let hi = (Lanes::splat(around.max[axis]) - o) * inverse;
            let is_reversed = inverse.less_than(Lanes::splat(0.0));
            let (enter, leave) = (is_reversed.select(hi, lo), is_reversed.select(lo, hi));
            near = near.less_than(enter).select(enter, near);
            far = leave.less_than(far).select(leave, far);
        }
        (near.at_most(far), near, far)
    }

    /// True for the rays whose coordinates are all finite.
    #[inline(always)]
    pub fn is_finite(&self) -> Flags {
        self.origin.is_finite() & self.dir.is_finite()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::rng;

    fn random_vector(seed: u64) -> DVec3 {
        DVec3::from_array([0, 1, 2].map(|axis| rng::random_unit(&[seed, axis]) * 4.0 - 2.0))
    }

    #[test]
    fn vectors_have_the_bits_of_single_ones() {
        let (a, b) = ([0; PACKET], [0; PACKET]);
        let mut i = 0;
        let [a, b] = [a, b].map(|list| {
            list.map(|_| {
                i += 1;
                // (One vector without a direction)
                if i == 3 { DVec3::ZERO } else { random_vector(i) }
            })
        });
        let [va, vb] = [a, b].map(|list| Vectors::from_array(&list));
        let turn =
            Transform::rotate(DVec3::new(10.0, 20.0, 30.0)).then(&Transform::scale(DVec3::new(2.0, 0.3, 5.0)).unwrap());
        let m = turn.then(&Transform::translate(DVec3::new(0.1, 2.0, -3.0)));
        let rays = RayPacket { origin: va, dir: vb };
        let local = rays.inverse_transformed(&m);
        for i in 0..PACKET {
            let (a, b) = (a[i], b[i]);
            assert_eq!(va.dot(vb).0[i], a.dot(b));
            assert_eq!((va + vb).lane(i), a + b);
            assert_eq!((va - vb).lane(i), a - b);
            assert_eq!(va.times(vb).lane(i), a * b);
            assert_eq!((va * vb.x).lane(i), a * b.x);
            assert_eq!((va / vb.x).lane(i), a / b.x);
            assert_eq!(va.normalize_or(vb).lane(i), a.try_normalize().unwrap_or(b));
            assert_eq!(va.transformed_as_points(&m.m).lane(i), m.transform_point(a));
            assert_eq!(va.transformed_as_normals(&m).lane(i), m.transform_normal(a));
            assert_eq!(va.multiplied_by(&m.m.matrix3).lane(i), m.m.matrix3 * a);
            assert_eq!(local.ray(i), m.inverse_transform_ray(&Ray::new(a, b)));
            assert_eq!(rays.at(va.x).lane(i), Ray::new(a, b).at(a.x));
            assert_eq!(va.is_zero().bits() >> i & 1 == 1, a == DVec3::ZERO);
        }
    }

    #[test]
    fn the_last_ray_fills_a_packet() {
        let packet = RayPacket::new(3, |i| Ray::new(random_vector(i as u64), DVec3::X));
        assert_eq!(packet.ray(1), Ray::new(random_vector(1), DVec3::X));
        assert!((3..PACKET).all(|i| packet.ray(i) == packet.ray(2)));
        assert_eq!(set_lanes(0b1001_0010).collect::<Vec<_>>(), [1, 4, 7]);
    }
}
