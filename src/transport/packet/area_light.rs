//! Soft shadows at several points side by side: the visibilities of [`super::super::area_light`], with the same results.

use super::super::area_light::{LightGridPiece, MAX_DIFFERENCE, number_of_jitter};
use super::super::random::{Purpose, RandomSequence};
use super::super::tracer::Tracer;
use super::Packet;
use super::light::ArrivingLight;
use crate::color::Rgb;
use crate::light::Area;
use crate::math::Lanes;
use crate::math::packet::{Flags, MIN_RAYS, Numbers, PACKET, RayPacket, Vectors, set_lanes};
use crate::math::registers::wide_versions;
use crate::world::LightSource;

/// Maximum number of lights of a grid whose shadow rays are traced side by side.
const MAX_LIGHTS: usize = 1024;
/// Maximum number of lights of such a grid without `adaptive`: for a larger grid, tests of shafts to its parts save more.
const MAX_NOT_ADAPTIVE: usize = 256;

/// State of the shadows at the hits of a packet's rays, from light to light.
pub(super) struct PacketShadows<'a> {
    pub packet: &'a Packet<'a>,
    /// Number of soft shadows so far at each hit, by which their random numbers are keyed.
    soft_shadows: [u64; PACKET],
}

/// Visibilities of the lights of a grid from several points.
#[derive(Default)]
pub struct KnownLights {
    /// Points from which each light's visibility is known, as bits; row by row.
    known: Vec<u32>,
    /// Visibility of each light.
    visibility: Vec<Vectors>,
}

/// One evaluation of the visibilities of a grid of lights from several points.
struct PacketGrid<'a> {
    light: &'a LightSource,
    area: &'a Area,
    points: &'a Vectors,
    arriving: &'a ArrivingLight,
    /// Sides of the grid, as vectors.
    sides: [Vectors; 2],
    random: [RandomSequence; PACKET],
    packet: &'a Packet<'a>,
    lights: KnownLights,
}

impl<'a> PacketShadows<'a> {
    /// Creates the state before the first light.
    pub fn new(packet: &'a Packet<'a>) -> Self {
        Self { packet, soft_shadows: [0; PACKET] }
    }
}

impl Tracer<'_> {
    /// Returns for which of the points `faces` any light of a grid is visible, and the mean visibilities, per channel: those of
    /// [`Self::area_visibility`]. `arriving` is the light from the grid's centre.
    #[inline(never)]
    pub(super) fn area_visibility_of_packet(
        &mut self,
        (light, area): (&LightSource, &Area),
        points: &Vectors,
        arriving: &ArrivingLight,
        faces: Flags,
        shadows: &mut PacketShadows,
    ) -> (Flags, Vectors) {
        let (packet, lanes) = (shadows.packet, faces.bits());
        let mut random = [RandomSequence::default(); PACKET];
        for i in set_lanes(lanes) {
            shadows.soft_shadows[i] += 1;
            let key = [packet.samples.pixel[i], packet.samples.sample[i], u64::from(packet.vertex) + 1];
            random[i] = self.random.nth_sequence(key, Purpose::AreaLight, shadows.soft_shadows[i]);
        }
        let count = area.size[0] as usize * area.size[1] as usize;
        let is_small = count <= if area.adaptive.is_some() { MAX_LIGHTS } else { MAX_NOT_ADAPTIVE };
        let mut share = Vectors::ZERO;
        if !is_small || light.emitter.is_parallel() || (lanes.count_ones() as usize) < MIN_RAYS {
            for i in set_lanes(lanes) {
                let inside = packet.interiors(self.context, i);
                let center = arriving.lane(i);
                share.set_lane(i, self.area_visibility((light, area), points.lane(i), &center, &inside, random[i]));
            }
        } else {
            let mut sides = [Vectors::splat(area.axes[0]), Vectors::splat(area.axes[1])];
            if area.orient {
                for i in set_lanes(lanes) {
                    let [a, b] = area.sides(-arriving.to_light.lane(i));
                    sides[0].set_lane(i, a);
                    sides[1].set_lane(i, b);
                }
            }
            let mut lights = std::mem::take(&mut self.known_lights);
            lights.forget_all(count);
            let mut grid = PacketGrid { light, area, points, arriving, sides, random, packet, lights };
            share = self.grid_visibility(&mut grid, lanes);
            self.known_lights = grid.lights;
        }
        (faces & !share.is_zero(), share)
    }

    /// Returns the mean visibilities of the lights of a grid from the points `lanes`, given as bits.
    fn grid_visibility(&mut self, grid: &mut PacketGrid, lanes: u32) -> Vectors {
        let &mut PacketGrid { light, area, points, arriving, .. } = grid;
        let all = LightGridPiece { low: [0, 0], high: area.size.map(|n| n - 1) };
        let mut unoccluded = 0;
        for i in set_lanes(lanes) {
            unoccluded |= u32::from(self.may_test_shafts(light, area, points.lane(i))) << i;
        }
        // Trace two shadow rays that are needed in any case: in full shadow, no shaft is clear.
        if unoccluded != 0 {
            for end in [all.low, all.high] {
                let visibility = self.cell_visibilities(grid, end, lanes);
                unoccluded &= (visibility - Vectors::splat(Rgb::ONE)).is_zero().bits();
            }
        }
        for i in set_lanes(unoccluded) {
            if !self.is_piece_unoccluded((light, area), points.lane(i), arriving.to_light.lane(i), all) {
                unoccluded &= !(1 << i);
            }
        }
        let left = lanes & !unoccluded;
        let one = Vectors::splat(Rgb::ONE);
        if left == 0 {
            one
        } else {
            Vectors::select(Flags::from_bits(unoccluded), one, self.piece_visibilities(grid, all, 0, left))
        }
    }

    /// Returns the mean visibilities of a piece of the grid, after `halvings_done` halvings, from the points `lanes`.
    fn piece_visibilities(
        &mut self,
        grid: &mut PacketGrid,
        piece: LightGridPiece,
        halvings_done: u32,
        lanes: u32,
    ) -> Vectors {
        let [a, b, c, d] = piece.corners();
        let corners = [
            self.cell_visibilities(grid, a, lanes),
            self.cell_visibilities(grid, b, lanes),
            self.cell_visibilities(grid, c, lanes),
            self.cell_visibilities(grid, d, lanes),
        ];
        let mean = (Vectors::ZERO + corners[0] + corners[1] + corners[2] + corners[3]) * Lanes::splat(0.25);
        if piece.is_smallest() || self.count_surface_and_is_stopped() {
            return mean;
        }
        let may_settle = grid.area.adaptive.is_some_and(|least| halvings_done >= least);
        let split =
            if may_settle { lanes & differ_enough_to_split(&corners, &grid.arriving.light).bits() } else { lanes };
        if split == 0 {
            return mean;
        }
        let mut sum = Vectors::ZERO;
        for quarter in piece.quarters() {
            sum = sum + self.piece_visibilities(grid, quarter, halvings_done + 1, split);
        }
        Vectors::select(Flags::from_bits(split), sum * Lanes::splat(0.25), mean)
    }

    /// Returns the visibilities of one light of the grid from the points `lanes`, which are computed once.
    fn cell_visibilities(&mut self, grid: &mut PacketGrid, cell: [u32; 2], lanes: u32) -> Vectors {
        let at = cell[1] as usize * grid.area.size[0] as usize + cell[0] as usize;
        let missing = lanes & !grid.lights.known[at];
        if missing != 0 {
            let (rays, distance) = shadow_rays(grid, cell);
            let (context, packet) = (self.context, grid.packet);
            let inside = |i: usize| packet.interiors(context, i);
            let missing_flags = Flags::from_bits(missing);
            let (visible, share) = self.visibility_along_rays(grid.light, (&rays, &distance), missing_flags, inside);
            let traced = Vectors::select(visible, share, Vectors::ZERO);
            let all = &mut grid.lights.visibility[at];
            *all = Vectors::select(missing_flags, traced, *all);
            grid.lights.known[at] |= missing;
        }
        grid.lights.visibility[at]
    }
}

impl KnownLights {
    /// Forgets all visibilities, for a grid of `count` lights.
    fn forget_all(&mut self, count: usize) {
        self.known.clear();
        self.known.resize(count, 0);
        self.visibility.resize(count.max(self.visibility.len()), Vectors::ZERO);
    }
}

wide_versions! {
    /// Returns the shadow rays from the points to one light of the grid, and the light's distances.
    fn shadow_rays(grid: &PacketGrid, cell: [u32; 2]) -> (RayPacket, Numbers) {
        // The operations of `jittered_offset` and of `LoweredLight::direction_and_distance`, in the same order
        let random = grid.area.jitter.then(|| {
            let number = number_of_jitter(cell);
            let (mut along, mut across) = (Lanes::splat(0.0), Lanes::splat(0.0));
            for i in 0..PACKET {
                along.0[i] = grid.random[i].at(number);
                across.0[i] = grid.random[i].at(number + 1);
            }
            [along, across]
        });
        let offsets = grid.area.light_offsets(cell, &grid.sides, random);
        let way = Vectors::splat(grid.light.emitter.location) + offsets - *grid.points;
        let distance = way.length_squared().sqrt();
        (RayPacket { origin: *grid.points, dir: way / distance }, distance)
    }
}

wide_versions! {
    /// True for the points at which the light at a piece's corners differs so much that the piece is subdivided.
    fn differ_enough_to_split(corners: &[Vectors; 4], light: &Vectors) -> Flags {
        let mut differ = Flags::NONE;
        for i in 0..4 {
            for j in 0..i {
                let apart = (corners[i] - corners[j]).times(*light);
                let sum = apart.x.abs() + apart.y.abs() + apart.z.abs();
                differ = differ | Lanes::splat(MAX_DIFFERENCE).less_than(sum);
            }
        }
        differ
    }
}
