//! Triangles in single precision as the items of a hierarchy.

use super::node::{self, Child, Kind, WIDTH};
use super::pack::{self, Pack};
use super::{Bvh, Entry, FlatRay, STACK, flat_ray, nearest_child_pushing_others, pad_up};
use crate::math::{DVec2, Range, Ray, Sheared, fork};
use glam::{Vec3, Vec3A};
use std::ops::ControlFlow;

/// Minimum number of packs that one thread makes in a row.
const PACKS_FOR_A_THREAD: usize = 1 << 11;

/// Bounding volume hierarchy over triangles 0 … n-1 in the order that [`Triangles::build`] returned.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Triangles {
    /// The hierarchy over the packs of triangles.
    bvh: Bvh,
    packs: Vec<Pack>,
}

/// Traverses a BVH of triangles with one of the two implementations of its functions, portable or AVX2.
macro_rules! meet {
    ($flat_ray:path, $slabs:path, $areas:path, $all:ident, $ray:ident, $range:ident, $visit:ident) => {{
        let line = Sheared::new($ray);
        let bvh = &$all.bvh;
        let mut look = |pack: usize, mut max: f64| {
            let pack = &$all.packs[pack];
            for half in pack.used_halves() {
                let mut found = $areas(pack, &line, half);
                while let Some((number, t, uv)) = pack.take_next_hit(&line, half, &mut found) {
                    if t > $range.min && t < max {
                        max = match $visit(number, t, uv) {
                            ControlFlow::Continue(max) => max,
                            flow => return flow,
                        };
                    }
                }
            }
            ControlFlow::Continue(max)
        };
        super::walk!($flat_ray, $slabs, bvh, $ray, $range, |pack| node::prefetch(&$all.packs, pack), look);
    }};
}

impl Triangles {
    /// Builds a BVH over `count` triangles, whose corners are `vertices` with the numbers that `corners` returns for a
    /// triangle's index. [`super::fits_single_precision`] must accept the box of each triangle. Also returns the index of the
    /// triangle at each position of the order.
    pub fn build(count: usize, vertices: &[Vec3], corners: impl Fn(u32) -> [u32; 3] + Sync) -> (Self, Vec<u32>) {
        let box_corners = |i: u32| {
            let [a, b, c] = corners(i).map(|number| Vec3A::from(vertices[number as usize]));
            [a.min(b).min(c), a.max(b).max(c)]
        };
        let fit_in_pack = |items: &[u32]| Pack::fit_in_pack(items.iter().map(|i| corners(*i)), vertices);
        let (bvh, order, rows) = Bvh::build_packs(count, box_corners, fit_in_pack);
        let pack = |i: usize| Pack::new(rows[i].clone(), |place| corners(order[place as usize]), vertices);
        let packs = fork::map(rows.len(), PACKS_FOR_A_THREAD, pack);
        (Self { bvh, packs }, order)
    }

    /// Calls `visit` with index, t and barycentric weights of the second and third corner of each triangle that the ray
    /// hits in the range, near ones mostly first. `visit` returns the new end of the range, or breaks. A ray with a
    /// coordinate that is not finite hits nothing.
    pub fn visit_hits(&self, ray: &Ray, range: Range, visit: impl FnMut(u32, f64, DVec2) -> ControlFlow<(), f64>) {
        if self.bvh.nodes.is_empty() || !ray.is_finite() {
            return;
        }
        #[cfg(target_arch = "x86_64")]
        if is_x86_feature_detected!("avx2") {
            // SAFETY: the processor has the feature that the function needs.
            #[expect(unsafe_code, reason = "the compiler can't know the processor")]
            return unsafe { self.visit_hits_avx2(ray, range, visit) };
        }
        self.visit_hits_portably(ray, range, visit);
    }

    fn visit_hits_portably(
        &self,
        ray: &Ray,
        range: Range,
        mut visit: impl FnMut(u32, f64, DVec2) -> ControlFlow<(), f64>,
    ) {
        meet!(FlatRay::new, node::slabs, pack::test_half_pack, self, ray, range, visit);
    }

    #[cfg(target_arch = "x86_64")]
    #[target_feature(enable = "avx2")]
    fn visit_hits_avx2(&self, ray: &Ray, range: Range, mut visit: impl FnMut(u32, f64, DVec2) -> ControlFlow<(), f64>) {
        meet!(flat_ray::avx2::flat_ray, node::avx2::slabs, pack::avx2::test_half_pack, self, ray, range, visit);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::{DVec3, rng};

    type Found = Vec<(u32, f64, DVec2)>;

    fn random(i: usize, n: u64) -> DVec3 {
        DVec3::from_array([0, 1, 2].map(|axis| rng::random_unit(&[i as u64, n, axis]) * 2.0 - 1.0))
    }

    /// A wavy net, and separate triangles around it.
    fn corners() -> Vec<[[f32; 3]; 3]> {
        let at = |i: usize, j: usize| {
            let [x, y] = [i, j].map(|k| k as f32 / 6.0 - 1.0);
            [x, y, 0.4 * (x * x - y * y)]
        };
        let squares = (0..12).flat_map(|i| (0..12).map(move |j| (i, j)));
        let net = squares.flat_map(|(i, j)| {
            let [a, b, c, d] = [at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)];
            [[a, b, c], [a, c, d]]
        });
        let loose = (0..100).map(|i| [0, 1, 2].map(|k| (random(i, 9) + 0.3 * random(i, k)).as_vec3().to_array()));
        net.chain(loose).collect()
    }

    /// Builds the hierarchy over triangles, each of which has its own vertices.
    fn built(corners: &[[[f32; 3]; 3]]) -> (Triangles, Vec<u32>) {
        let vertices: Vec<Vec3> = corners.iter().flatten().map(|p| Vec3::from(*p)).collect();
        Triangles::build(corners.len(), &vertices, |i| [3 * i, 3 * i + 1, 3 * i + 2])
    }

    /// Rays at random, through corners, through sides, along axes.
    fn rays(corners: &[[[f32; 3]; 3]]) -> impl Iterator<Item = Ray> {
        (0..1200).map(|i| {
            let [a, b, _] = corners[i * 7 % corners.len()].map(|p| Vec3::from(p).as_dvec3());
            let from = random(i, 20) * 3.0;
            match i % 4 {
                0 => Ray::new(from, random(i, 21)),
                1 => Ray::new(from, a - from),
                2 => Ray::new(from, (a + b) / 2.0 - from),
                _ => Ray::new(
                    a - [DVec3::X, DVec3::NEG_Y, DVec3::Z][i % 3] * 4.0,
                    [DVec3::X, DVec3::NEG_Y, DVec3::Z][i % 3],
                ),
            }
        })
    }

    fn all(found: &mut Found, max: f64) -> impl FnMut(u32, f64, DVec2) -> ControlFlow<(), f64> {
        move |number, t, uv| {
            found.push((number, t, uv));
            ControlFlow::Continue(max)
        }
    }

    #[test]
    fn every_hit_is_found_to_the_last_bit() {
        let corners = corners();
        let (triangles, order) = built(&corners);
        let mut hits = 0;
        for ray in rays(&corners) {
            let line = Sheared::new(&ray);
            for range in [Range::ALL, Range { min: 0.5, max: 1.0 }] {
                let mut found = Found::new();
                triangles.visit_hits(&ray, range, all(&mut found, range.max));
                found.sort_by_key(|hit| hit.0);
                let one = |(i, place): (usize, &u32)| {
                    let (t, uv) = line.intersect(corners[*place as usize].map(|p| Vec3::from(p).as_dvec3()))?;
                    range.contains(t).then_some((i as u32, t, uv))
                };
                let want: Found = order.iter().enumerate().filter_map(one).collect();
                assert_eq!(found, want, "{ray:?}");
                hits += want.len();
            }
        }
        assert!(hits > 3000, "{hits}");
    }

    #[cfg(target_arch = "x86_64")]
    #[test]
    fn avx2_matches_portable() {
        if !is_x86_feature_detected!("avx2") {
            return;
        }
        let corners = corners();
        let (triangles, _) = built(&corners);
        for ray in rays(&corners) {
            let (mut plain, mut wide) = (Found::new(), Found::new());
            triangles.visit_hits_portably(&ray, Range::ALL, all(&mut plain, f64::INFINITY));
            // SAFETY: the processor has the feature.
            #[expect(unsafe_code, reason = "as above")]
            unsafe {
                triangles.visit_hits_avx2(&ray, Range::ALL, all(&mut wide, f64::INFINITY));
            }
            assert_eq!(plain, wide, "{ray:?}");
        }
    }
}
