//! Hits of packets of rays on a height field: the pyramid is descended once for all rays, and the cells of its smallest squares are
//! searched ray by ray. The hits have the bits of single rays.

use super::HeightField;
use super::grid::{Grid, Place};
use super::line::{Line, SLACK};
use crate::math::packet::{Flags, MIN_RAYS, Numbers, RayPacket, Vectors, set_lanes};
use crate::math::registers::wide_versions;
use crate::math::{DVec2, Lanes, Range};
use crate::shape::{Kernel, PacketHits};
use std::ops::ControlFlow;

/// Rays in units of a height field's cells and steps of height, side by side; see [`Line`].
struct PacketLines {
    o: Vectors,
    d: Vectors,
    /// Inverses of the directions' components along x and z.
    inverse: [Numbers; 2],
    /// Distances at which the rays enter and leave the height field's box.
    box_ends: [Numbers; 2],
    /// Ends of the ranges in which hits count.
    range: [Numbers; 2],
    /// Ends of the pieces of the rays that are in both.
    ends: [Numbers; 2],
    /// Distance of each line's origin from that of its ray.
    start: Numbers,
}

/// Search for the first hits of a packet's rays.
struct Search<'a> {
    field: &'a HeightField,
    grid: &'a Grid,
    lines: PacketLines,
    /// Ranges of the rays.
    range: (f64, Numbers),
    /// Rays that have a hit, as bits.
    done: u32,
    hits: PacketHits,
}

/// Returns the first hits of the rays of a packet on a field, as [`Kernel::closest_of_packet`] does.
pub(super) fn closest_of_packet(field: &HeightField, rays: &RayPacket, min: f64, max: &Numbers) -> PacketHits {
    let Some(grid) = &field.grid else { return PacketHits::NONE };
    let ([meets_box, over_field], lines) = lines_over_field(field, grid, rays, (min, max));
    let mut search = Search { field, grid, lines, range: (min, *max), done: 0, hits: PacketHits::NONE };
    // Rays that are parallel to an axis, or too few for a packet, are traced one by one.
    let zero = Lanes::splat(0.0);
    let is_parallel = rays.dir.x.equals(zero) | rays.dir.y.equals(zero) | rays.dir.z.equals(zero);
    let (mut single, mut left) = ((meets_box & is_parallel).bits(), (over_field & !is_parallel).bits());
    let signs = [rays.dir.x, rays.dir.z].map(|d| d.less_than(zero).bits());
    while left != 0 {
        // All rays that leave the squares of the pyramid in the same order
        let first = left.trailing_zeros();
        let flip = signs.map(|negative| negative >> first & 1);
        let is_same = signs.map(|negative| if negative >> first & 1 == 1 { negative } else { !negative });
        let group = left & is_same[0] & is_same[1];
        left &= !group;
        match group.count_ones() as usize >= MIN_RAYS {
            true => search.visit_square(grid.top_level(), [0, 0], group, flip.map(|flip| flip as usize)),
            false => single |= group,
        }
    }
    for lane in set_lanes(single) {
        if let Some(hit) = field.closest(&rays.ray(lane), Range { min, max: max.0[lane] }) {
            search.set_hit(lane, hit.t, hit.part);
        }
    }
    search.hits.is_hit = Flags::from_bits(search.done);
    search.hits
}

impl Search<'_> {
    fn set_hit(&mut self, lane: usize, t: f64, part: u32) {
        self.done |= 1 << lane;
        (self.hits.t.0[lane], self.hits.part[lane]) = (t, part);
    }

    /// Finds the first hits of the rays `lanes` in a square of the pyramid, if the heights there are within their reach. `flip` is 1
    /// for each axis, x and z, along which the rays' coordinates decrease.
    fn visit_square(&mut self, level: usize, [a, b]: [usize; 2], lanes: u32, flip: [usize; 2]) {
        let Some(heights) = self.grid.heights_of_square_if_there(level, [a, b]) else { return };
        let [from, to] = self.grid.first_and_end_cells(level, a, b);
        let lanes = lanes & !self.done & lanes_near_square(&self.lines, from, to, heights).bits();
        if lanes == 0 {
            return;
        }
        if level == 0 {
            return set_lanes(lanes).for_each(|lane| self.visit_cells(lane, from, to));
        }
        // A ray is over only one of the two squares in the middle.
        for [beyond_x, beyond_z] in [[0, 0], [1, 0], [0, 1], [1, 1]] {
            self.visit_square(level - 1, [2 * a + (beyond_x ^ flip[0]), 2 * b + (beyond_z ^ flip[1])], lanes, flip);
        }
    }

    /// Finds the first hit of one ray in a block of cells.
    fn visit_cells(&mut self, lane: usize, from: [usize; 2], to: [usize; 2]) {
        let PacketLines { o, d, inverse, box_ends, range, start, .. } = &self.lines;
        let (o, d, start) = (o.lane(lane), d.lane(lane), start.0[lane]);
        let (field, grid) = (self.field, self.grid);
        let whole = Range { min: self.range.0, max: self.range.1.0[lane] };
        let mut found = None;
        let mut visit = |t: f64, place: Place| {
            let y = o.y + d.y * t;
            if field.is_visible(y, t + start, whole) {
                found = Some((t + start, grid.number_of_triangle(place)));
                return ControlFlow::Break(());
            }
            ControlFlow::Continue(())
        };
        let mut line = Line {
            o,
            d,
            inverse: DVec2::new(inverse[0].0[lane], inverse[1].0[lane]),
            near: box_ends[0].0[lane],
            far: box_ends[1].0[lane],
            range: Range { min: range[0].0[lane], max: range[1].0[lane] },
            visit: &mut visit,
        };
        let _ = grid.visit_hits_in_cells(from, to, &mut line);
        if let Some((t, part)) = found {
            self.set_hit(lane, t, part);
        }
    }
}

wide_versions! {
    /// Returns the rays of a packet as lines; for which rays a piece in the range is in the field's box, and for which, unless they are
    /// parallel to an axis, a piece is over the field and between its lowest and highest point.
    fn lines_over_field(
        field: &HeightField,
        grid: &Grid,
        rays: &RayPacket,
        range: (f64, &Numbers),
    ) -> ([Flags; 2], PacketLines) {
        // The operations of `HeightField::visit_hits` and `Grid::line_over_field`, in the same order
        let everywhere = [f64::NEG_INFINITY, f64::INFINITY].map(Lanes::splat);
        let (crosses_box, start, leave) = rays.slabs(&field.search_box(), everywhere[0], everywhere[1]);
        let (min, max) = range;
        let meets_box = crosses_box & start.at_most(*max) & Lanes::splat(min).at_most(leave) & start.is_finite();
        let scale = Vectors::splat(grid.grid_from_object_scale());
        let (o, d) = (rays.at(start).times(scale), rays.dir.times(scale));
        let range = [Lanes::splat(min) - start, *max - start];
        let inverse = [Lanes::splat(1.0) / d.x, Lanes::splat(1.0) / d.z];
        let [lo, hi] = grid.height_range();
        let (below, above) = ((Lanes::splat(lo - 1.0) - o.y) / d.y, (Lanes::splat(hi + 1.0) - o.y) / d.y);
        let [x, z] = distances_of_sides(&o, &inverse, [0, 0], [grid.across, grid.deep]);
        let near = below.min(above).max(x[0].max(z[0]));
        let far = below.max(above).min(x[1].min(z[1]));
        let ends = [near.max(range[0]), far.min(range[1])];
        let is_finite = near.less_than(far) & near.is_finite() & far.is_finite();
        let over_field = meets_box & is_finite & ends[0].at_most(ends[1]);
        ([meets_box, over_field], PacketLines { o, d, inverse, box_ends: [near, far], range, ends, start })
    }
}

wide_versions! {
    /// True for the lines that may reach heights in this range over a rectangle of cells.
    fn lanes_near_square(lines: &PacketLines, from: [usize; 2], to: [usize; 2], heights: [u16; 2]) -> Flags {
        let [x, z] = distances_of_sides(&lines.o, &lines.inverse, from, to);
        let (enter, leave) = (x[0].max(z[0]).max(lines.ends[0]), x[1].min(z[1]).min(lines.ends[1]));
        let (y0, y1) = (lines.o.y + lines.d.y * enter, lines.o.y + lines.d.y * leave);
        let [lo, hi] = heights.map(f64::from);
        let is_below_top = y0.min(y1).at_most(Lanes::splat(hi + SLACK));
        let is_above_bottom = Lanes::splat(lo - SLACK).at_most(y0.max(y1));
        enter.at_most(leave) & is_below_top & is_above_bottom
    }
}

/// Returns the distances, in order, at which the lines cross the two sides of a rectangle of cells along x, and those along z.
#[inline(always)]
fn distances_of_sides(o: &Vectors, inverse: &[Numbers; 2], from: [usize; 2], to: [usize; 2]) -> [[Numbers; 2]; 2] {
    let along = |o: Numbers, inverse: Numbers, from: usize, to: usize| {
        let (a, b) = ((Lanes::splat(from as f64) - o) * inverse, (Lanes::splat(to as f64) - o) * inverse);
        [a.min(b), a.max(b)]
    };
    [along(o.x, inverse[0], from[0], to[0]), along(o.z, inverse[1], from[1], to[1])]
}
