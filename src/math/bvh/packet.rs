//! Traversal by a packet of rays. A node is tested once for the whole packet, by intervals that contain the numbers of all
//! rays; the box of an item is tested for each ray.

use super::node::{Kind, WIDTH, Wide};
use super::{Bvh, SLACK, STACK, nearest_slot, pad_down};
use crate::math::lanes::for_each_lane;
use crate::math::packet::{Flags, Numbers, PACKET, RayPacket};
use crate::math::{Lanes, sign_bits};
use glam::Vec4;
use smallvec::SmallVec;
use std::ops::ControlFlow;

/// A number in single precision for each ray of a packet, or for each child of a node.
#[derive(Clone, Copy)]
struct Singles([f32; PACKET]);

const _: () = assert!(PACKET == WIDTH);

/// A truth value for each ray of a packet: all bits are 1 for true, 0 for false.
#[derive(Clone, Copy)]
struct Marks([u32; PACKET]);

impl Singles {
    #[inline(always)]
    fn splat(x: f32) -> Self {
        Self([x; PACKET])
    }

    /// Rounds numbers to single precision.
    #[inline(always)]
    fn rounded(numbers: Numbers) -> Self {
        Self(for_each_lane!(i < PACKET => numbers.0[i] as f32))
    }

    #[inline(always)]
    fn minus(self, other: Self) -> Self {
        Self(for_each_lane!(i < PACKET => self.0[i] - other.0[i]))
    }

    #[inline(always)]
    fn times(self, other: Self) -> Self {
        Self(for_each_lane!(i < PACKET => self.0[i] * other.0[i]))
    }

    /// Returns the smaller numbers. (Unlike `f32::min`, it is one instruction, because it need not treat NaN.)
    #[inline(always)]
    fn least(self, other: Self) -> Self {
        Self(for_each_lane!(i < PACKET => if self.0[i] < other.0[i] { self.0[i] } else { other.0[i] }))
    }

    /// Returns the larger numbers.
    #[inline(always)]
    fn most(self, other: Self) -> Self {
        Self(for_each_lane!(i < PACKET => if self.0[i] > other.0[i] { self.0[i] } else { other.0[i] }))
    }

    #[inline(always)]
    fn abs(self) -> Self {
        Self(for_each_lane!(i < PACKET => self.0[i].abs()))
    }

    #[inline(always)]
    fn copysign(self, signs: Self) -> Self {
        Self(for_each_lane!(i < PACKET => self.0[i].copysign(signs.0[i])))
    }

    /// Returns the lanes in which the number is less than the other or equal, as bits.
    #[inline(always)]
    fn bits_at_most(self, other: Self) -> u32 {
        sign_bits(for_each_lane!(i < PACKET => f32::from_bits(if self.0[i] <= other.0[i] { u32::MAX } else { 0 })))
    }

    /// Returns the least and the largest number.
    #[inline(always)]
    fn extremes(self) -> [f32; 2] {
        let [a, b, c, d, e, f, g, h] = self.0;
        let (low, high) = (Vec4::new(a, b, c, d), Vec4::new(e, f, g, h));
        [low.min(high).min_element(), low.max(high).max_element()]
    }
}

impl Marks {
    #[inline(always)]
    fn bits(self) -> u32 {
        sign_bits(for_each_lane!(i < PACKET => f32::from_bits(self.0[i])))
    }

    /// Returns the numbers of `if_true` in the lanes that are true, and those of `if_false` in the others.
    #[inline(always)]
    fn select(self, if_true: Singles, if_false: Singles) -> Singles {
        Singles(for_each_lane!(i < PACKET => if self.0[i] != 0 { if_true.0[i] } else { if_false.0[i] }))
    }
}

/// The rays of a packet in single precision, as [`super::FlatRay`] for one ray.
struct FlatPacket {
    axes: [FlatAxis; 3],
    min: f32,
}

/// One axis of the rays of a packet.
struct FlatAxis {
    enter: Singles,
    leave: Singles,
    enter_inverse: Singles,
    leave_inverse: Singles,
    /// True for the rays whose direction is negative, so that they enter through the upper plane.
    is_negative: Marks,
    /// Bounds of these numbers; `None` if the rays enter through different planes.
    bounds: Option<AxisBounds>,
}

/// Bounds of the numbers of one axis, over the rays of a packet.
struct AxisBounds {
    /// 1 if the rays enter through the upper plane, 0 if through the lower one.
    side: usize,
    /// The origin from which a plane is entered first.
    enter: f32,
    /// The origin from which a plane is left last.
    leave: f32,
    enter_inverse: [f32; 2],
    leave_inverse: [f32; 2],
}

/// Returns the upper ends of the rays' ranges in single precision, as [`super::pad_up`] does; those of rays that do not count have
/// no influence.
#[inline(always)]
fn padded_up(max: &Numbers, counts: Flags) -> Singles {
    let max = counts.select(*max, Lanes::splat(-1.0));
    Singles(for_each_lane!(i < PACKET => super::pad_up(max.0[i])))
}

/// Returns the reciprocals of directions times a factor, in single precision and at least `smallest` in size.
#[inline(always)]
fn scaled(inverse: Numbers, factor: f64, smallest: f32) -> Singles {
    let size = Singles::rounded(factor * inverse).abs();
    size.most(Singles::splat(smallest)).least(Singles::splat(f32::MAX)).copysign(Singles::rounded(inverse))
}

impl FlatAxis {
    /// Converts the numbers of one axis. The bounds contain those of the rays `counts`, of which `first` is one.
    #[inline(always)]
    fn new(origin: Numbers, dir: Numbers, counts: Marks, first: usize) -> Self {
        let error = (2.5e-7 * origin.abs()).max(Lanes::splat(1e-19)).copysign(dir);
        let inverse = Lanes::splat(1.0) / dir;
        let (enter, leave) = (Singles::rounded(origin + error), Singles::rounded(origin - error));
        let enter_inverse = scaled(inverse, 1.0 - SLACK, 0.0);
        let leave_inverse = scaled(inverse, 1.0 + SLACK, f32::MIN_POSITIVE);
        let is_negative = Marks(dir.has_negative_sign().to_u32());
        let (counting, negative) = (counts.bits(), is_negative.bits() & counts.bits());
        let bounds = (negative == 0 || negative == counting).then(
            #[inline(always)]
            || {
                let side = usize::from(negative != 0);
                AxisBounds {
                    side,
                    enter: extremes(enter, counts, first)[1 - side],
                    leave: extremes(leave, counts, first)[side],
                    enter_inverse: extremes(enter_inverse, counts, first),
                    leave_inverse: extremes(leave_inverse, counts, first),
                }
            },
        );
        Self { enter, leave, enter_inverse, leave_inverse, is_negative, bounds }
    }
}

/// Returns the least and the largest of the numbers of the rays `counts`, of which `first` is one.
#[inline(always)]
fn extremes(numbers: Singles, counts: Marks, first: usize) -> [f32; 2] {
    counts.select(numbers, Singles::splat(numbers.0[first % PACKET])).extremes()
}

impl FlatPacket {
    /// Converts the rays of a packet, for ranges that begin at `min`, which is not negative.
    #[inline(always)]
    fn new(rays: &RayPacket, counts: Flags, min: f64) -> Self {
        let (marks, first) = (Marks(counts.to_u32()), counts.bits().trailing_zeros() as usize);
        let RayPacket { origin, dir } = rays;
        let axes = [
            FlatAxis::new(origin.x, dir.x, marks, first),
            FlatAxis::new(origin.y, dir.y, marks, first),
            FlatAxis::new(origin.z, dir.z, marks, first),
        ];
        Self { axes, min: pad_down(min) }
    }

    /// Returns the children of a node whose boxes any ray may hit before `max`, as bits, and values of `t` before which no ray
    /// enters them.
    #[inline(always)]
    fn may_hit(&self, node: &Wide, max: f32) -> (u32, [f32; WIDTH]) {
        let (mut near, mut far) = (Singles::splat(self.min), Singles::splat(max));
        for (axis, flat) in self.axes.iter().enumerate() {
            let Some(bounds) = &flat.bounds else { continue };
            let [low, high] = bounds.enter_inverse;
            let (low, high) = (Singles::splat(low), Singles::splat(high));
            let distance = planes(node, bounds.side, axis).minus(Singles::splat(bounds.enter));
            near = near.most(distance.times(low).least(distance.times(high)));
            let [low, high] = bounds.leave_inverse;
            let (low, high) = (Singles::splat(low), Singles::splat(high));
            let distance = planes(node, bounds.side ^ 1, axis).minus(Singles::splat(bounds.leave));
            far = far.least(distance.times(low).most(distance.times(high)));
        }
        (near.bits_at_most(far), near.0)
    }

    /// Returns the rays that hit the box of a node's child before `max`, as bits.
    #[inline(always)]
    fn rays_that_hit(&self, node: &Wide, slot: usize, max: Singles) -> u32 {
        let (half, place) = (slot / 4 % 2, slot % 4);
        let (mut near, mut far) = (Singles::splat(self.min), max);
        for (axis, flat) in self.axes.iter().enumerate() {
            let lower = Singles::splat(node.planes[0][axis][half][place]);
            let upper = Singles::splat(node.planes[1][axis][half][place]);
            let enter = flat.is_negative.select(upper, lower).minus(flat.enter).times(flat.enter_inverse);
            let leave = flat.is_negative.select(lower, upper).minus(flat.leave).times(flat.leave_inverse);
            (near, far) = (near.most(enter), far.least(leave));
        }
        near.bits_at_most(far)
    }
}

/// Returns the planes of the children of a node on one side along an axis.
#[inline(always)]
fn planes(node: &Wide, side: usize, axis: usize) -> Singles {
    let [low, high] = &node.planes[side & 1][axis];
    let mut all = [0.0; WIDTH];
    low.write_to_slice(&mut all[..4]);
    high.write_to_slice(&mut all[4..]);
    Singles(all)
}

impl Bvh {
    /// Calls `visit` with the items whose boxes any ray of a packet hits in its range, and a few of their neighbours, near boxes
    /// mostly first. The ranges of all rays begin at `min`, which is not negative, and end at `max`. `visit` receives the item's
    /// position, the rays that hit its box, as bits, and the ends of the ranges, which it may decrease; or it breaks. Rays for
    /// which `counts` is false, and those with a coordinate that is not finite, hit nothing. Returns the number of boxes of items
    /// that were tested, and the sum of the numbers of rays that hit each.
    #[inline(always)]
    pub fn traverse_by_packet(
        &self,
        rays: &RayPacket,
        counts: Flags,
        min: f64,
        max: &mut Numbers,
        mut visit: impl FnMut(usize, u32, &mut Numbers) -> ControlFlow<()>,
    ) -> [u32; 2] {
        let mut tests = [0, 0];
        let counts = counts & rays.is_finite();
        if self.nodes.is_empty() || !counts.any() {
            return tests;
        }
        let counting = counts.bits();
        let flat = FlatPacket::new(rays, counts, min);
        let mut flat_max = padded_up(max, counts);
        let [_, mut last_max] = flat_max.extremes();
        // Nodes that are to be visited, the next one last, each with a value of `t` before which no ray enters its box
        let mut stack: SmallVec<[(usize, f32); STACK]> = SmallVec::new();
        let mut number = 0;
        loop {
            let node = &self.nodes[number];
            let (mut mask, near) = flat.may_hit(node, last_max);
            let n_before = stack.len();
            while mask != 0 {
                let slot = nearest_slot(mask, &near);
                mask &= !(1 << slot);
                if near[slot] > last_max {
                    break;
                }
                match node.child[slot].kind() {
                    Kind::Node(child) => stack.push((child, near[slot])),
                    Kind::Items(items) => {
                        let hit = flat.rays_that_hit(node, slot, flat_max) & counting;
                        tests = [tests[0] + 1, tests[1] + hit.count_ones()];
                        if hit == 0 {
                            continue;
                        }
                        for item in items {
                            if visit(item, hit, max).is_break() {
                                return tests;
                            }
                        }
                        flat_max = padded_up(max, counts);
                        [_, last_max] = flat_max.extremes();
                    }
                }
            }
            stack[n_before..].reverse();
            number = loop {
                match stack.pop() {
                    Some((next, near)) if near <= last_max => break next,
                    Some(_) => {}
                    None => return tests,
                }
            };
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::registers::testing::for_all_registers;
    use crate::math::registers::wide_versions;
    use crate::math::{Aabb, DVec3, Range, Ray, rng};

    wide_versions! {
        /// Returns the pairs of items and rays, as bits, that a traversal visits.
        fn visited<'a>(bvh: &'a Bvh, rays: &RayPacket, counts: Flags, min: f64, max: &Numbers) -> Vec<(usize, u32)> {
            let mut visited = vec![];
            bvh.traverse_by_packet(
                rays,
                counts,
                min,
                &mut max.clone(),
                #[inline(always)]
                |item, rays, _| {
                    visited.push((item, rays));
                    ControlFlow::Continue(())
                },
            );
            visited
        }
    }

    fn random(i: usize, n: u64) -> DVec3 {
        DVec3::from_array([0, 1, 2].map(|axis| rng::random_unit(&[i as u64, n, axis]) * 2.0 - 1.0))
    }

    /// Rays from all sides, of packets that are narrow, wide, and along axes.
    fn ray(packet: usize, lane: usize) -> Ray {
        let (from, to) = (random(packet, 1) * 30.0, random(packet, 2) * 8.0);
        let i = packet * PACKET + lane;
        match packet % 4 {
            0 => Ray::new(from, to - from + random(i, 3) * 0.1),
            1 => Ray::new(random(i, 4) * 30.0, random(i, 5)),
            2 => Ray::new(from, (DVec3::AXES[lane % 3] - random(packet, 6) * 0.01) * [1.0, -1.0][lane / 3 % 2]),
            _ => Ray::new(to + random(i, 3), DVec3::AXES[packet / 4 % 3] * [1.0, -2.0][packet / 12 % 2]),
        }
    }

    #[test]
    fn each_ray_meets_the_boxes_that_it_hits() {
        let boxes: Vec<Aabb> = (0..300)
            .map(|i| {
                (random(i, 10) * 10.0, random(i, 11) * [0.1, 0.5, 4.0][i % 3] * DVec3::new(1.0, 1.0, (i % 2) as f64))
            })
            .map(|(corner, size)| Aabb::from_corners(corner, corner + size))
            .collect();
        for count in [0, 1, 5, 300] {
            let (bvh, order) = Bvh::build(boxes[..count].iter().copied());
            let (mut n_met, mut n_hit) = (0, 0);
            for packet in 0..150 {
                let rays = RayPacket::new(PACKET, |lane| ray(packet, lane));
                let counts = Flags::from_bits([0xff, 0x5a, 0x80, 0][packet / 7 % 4]);
                let max = Lanes(std::array::from_fn(|lane| [f64::INFINITY, 12.0, 0.5][(packet + lane) % 3]));
                for_all_registers(|registers| {
                    let met = visited(&bvh, &rays, counts, 1e-3, &max);
                    for (place, number) in order.iter().enumerate() {
                        let by = met.iter().filter(|(item, _)| *item == place).fold(0, |all, (_, rays)| all | rays);
                        for lane in 0..PACKET {
                            let range = Range { min: 1e-3, max: max.0[lane] };
                            let hits = boxes[*number as usize].slabs(&rays.ray(lane), range).is_some();
                            let is_met = by >> lane & 1 == 1;
                            assert!(is_met || !hits || counts.bits() >> lane & 1 == 0, "{registers:?} {packet} {lane}");
                            (n_met, n_hit) = (n_met + u32::from(is_met), n_hit + u32::from(hits && is_met));
                        }
                    }
                    assert!(met.iter().all(|(_, rays)| rays & !counts.bits() == 0 && *rays != 0));
                });
            }
            // A few neighbours, and boxes that rays hit within rounding
            assert!(f64::from(n_met) <= 2.0 * f64::from(n_hit), "{n_met} {n_hit}");
        }
    }

    #[test]
    fn a_full_stack_loses_nothing_and_a_break_ends() {
        let boxes = (1..3000).map(|i| DVec3::new(1.0, 0.5, 2.0) * f64::from(i)).map(|p| Aabb::from_corners(-p, p));
        let (bvh, _) = Bvh::build(boxes.collect::<Vec<_>>().into_iter());
        let rays = RayPacket::new(PACKET, |lane| Ray::new(random(lane, 1) * 0.1, random(lane, 2)));
        let met = visited(&bvh, &rays, Flags::from_bits(0xff), 0.0, &Lanes::splat(f64::INFINITY));
        assert!(met.len() == 2999 && met.iter().all(|(_, rays)| *rays == 0xff), "{}", met.len());
        let mut n_met = 0;
        bvh.traverse_by_packet(&rays, Flags::from_bits(1), 0.0, &mut Lanes::splat(9.0), |_, _, _| {
            n_met += 1;
            ControlFlow::Break(())
        });
        assert_eq!(n_met, 1);
    }

    #[test]
    fn rays_that_are_not_finite_meet_nothing() {
        let (bvh, _) = Bvh::build([Aabb::from_corners(DVec3::NEG_ONE, DVec3::ONE)].into_iter());
        let strange = [f64::NAN, f64::INFINITY, f64::NEG_INFINITY];
        let rays = RayPacket::new(PACKET, |lane| match strange.get(lane) {
            Some(x) => Ray::new(DVec3::new(0.0, *x, -5.0), DVec3::Z),
            None => Ray::new(DVec3::new(0.0, 0.0, -5.0), DVec3::Z),
        });
        let met = visited(&bvh, &rays, Flags::from_bits(0xff), 0.0, &Lanes::splat(f64::INFINITY));
        assert_eq!(met, [(0, 0b1111_1000)]);
    }
}
