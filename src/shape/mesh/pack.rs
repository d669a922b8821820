//! Four triangles side by side, which a ray is asked of at once.

use super::sheared::Sheared;
use crate::math::DVec2;
use crate::math::bvh::PACK;
use std::array::from_fn;
use std::ops::Range;

/// Triangles that stand in a row.
#[derive(Clone, Debug, PartialEq)]
#[repr(align(32))]
pub struct Pack {
    /// Corner by corner x, y and z; what is left free repeats the first triangle.
    corners: [[[f32; PACK]; 3]; 3],
    first: u32,
    count: u32,
}

/// A number for each triangle.
type Lanes = [f64; PACK];

impl Pack {
    /// Of the triangles of these numbers.
    pub fn new(row: Range<u32>, face: impl Fn(u32) -> [[f32; 3]; 3]) -> Self {
        let mut corners = [[[0.0; PACK]; 3]; 3];
        let numbers = row.clone().chain(std::iter::repeat(row.start));
        for (lane, number) in numbers.take(PACK).enumerate() {
            for (corner, p) in corners.iter_mut().zip(face(number)) {
                corner.iter_mut().zip(p).for_each(|(axis, x): (&mut [f32; PACK], f32)| axis[lane] = x);
            }
        }
        Self { corners, first: row.start, count: row.end - row.start }
    }

    /// Number, t and weights of the second and third corner of each triangle that the line meets: [`Sheared::meet`], side by side.
    #[inline(always)]
    pub fn meet(&self, line: &Sheared) -> impl Iterator<Item = (u32, f64, DVec2)> + use<> {
        let z = line.axes[2] % 3;
        let from: [Lanes; 3] = self.corners.each_ref().map(|c| from_fn(|i| f64::from(c[z][i]) - line.origin[z]));
        let sheared = |corner: usize, k: usize| -> Lanes {
            let (axis, shear) = (line.axes[k] % 3, line.shear[k]);
            let at = &self.corners[corner][axis];
            from_fn(|i| (f64::from(at[i]) - line.origin[axis]) - shear * from[corner][i])
        };
        let [a, b, c] = [0, 1, 2].map(|corner| [sheared(corner, 0), sheared(corner, 1)]);
        // Twice the areas of the parts that each side cuts off with the ray.
        let side = |p: &[Lanes; 2], q: &[Lanes; 2]| -> Lanes { from_fn(|i| p[0][i] * q[1][i] - q[0][i] * p[1][i]) };
        let (u, v, w) = (side(&c, &b), side(&a, &c), side(&b, &a));
        let low: Lanes = from_fn(|i| least(least(u[i], v[i]), w[i]));
        let high: Lanes = from_fn(|i| -least(least(-u[i], -v[i]), -w[i]));
        let mut mask = 0;
        (0..self.count as usize % (PACK + 1)).for_each(|i| mask |= u32::from(low[i] >= 0.0 || high[i] <= 0.0) << i);
        let (first, scale) = (self.first, line.shear.z);
        std::iter::from_fn(move || {
            while mask != 0 {
                let i = mask.trailing_zeros() as usize % PACK;
                mask &= mask - 1;
                let det = u[i] + v[i] + w[i];
                if det != 0.0 {
                    let t = scale * (u[i] * from[0][i] + v[i] * from[1][i] + w[i] * from[2][i]) / det;
                    return Some((first + i as u32, t, DVec2::new(v[i], w[i]) / det));
                }
            }
            None
        })
    }
}

/// The smaller one, as one instruction.
#[inline(always)]
fn least(a: f64, b: f64) -> f64 {
    if a < b { a } else { b }
}
