//! `area_light`: soft shadows by the visibility of a grid of lights (manual, "Area Lights").

use super::interface::Interiors;
use super::random::RandomSequence;
use super::tracer::Tracer;
use crate::color::Rgb;
use crate::light::{Area, LightSample};
use crate::math::bvh::Shaft;
use crate::math::{DVec3, Ray};
use crate::world::LightSource;
use rustc_hash::FxHashMap;

/// Maximum difference of the light at a piece's corners, summed over the channels, at which the piece is not subdivided
/// (quirk: `area_light_subdivision`).
pub(super) const MAX_DIFFERENCE: f64 = 0.1;
/// Maximum number of lights of a grid whose visibilities are stored in an array.
const MAX_ARRAY: usize = 1 << 16;
/// Minimum number of lights of a grid for shaft tests, each of which costs as much as a few shadow rays.
const MIN_LIGHTS: usize = 25;
/// Minimum number of lights of a part of a grid for a shaft test.
const MIN_PART: usize = 64;
/// Number of halvings of a grid that is too large for an array, after which a piece is not subdivided if the light at its
/// corners is nearly equal: 128 × 128 pieces, which miss only occluders narrower than 1/128 of the grid.
const LARGE_GRID_LEVEL: u32 = 7;

/// One evaluation of the visibility of a grid of lights.
struct GridVisibility<'a> {
    light: &'a LightSource,
    area: &'a Area,
    point: DVec3,
    /// Sample of the light at the grid's centre.
    center: &'a LightSample,
    /// Sides of the grid, as vectors.
    sides: [DVec3; 2],
    /// Interiors that contain the point.
    inside: &'a Interiors,
    random: RandomSequence,
    /// Number of halvings after which a piece is not subdivided if the light at its corners is nearly equal; `None` to
    /// subdivide down to single lights.
    settle_level: Option<u32>,
    /// True if a shaft test is made for each piece whose corners are lit.
    has_shafts: bool,
    known: Known,
}

/// Known visibilities of the lights of a grid.
enum Known {
    /// Visibility of each light of the area light's grid, row by row; NaN for a light whose shadow ray is not traced
    /// yet.
    Array(Vec<Rgb>),
    Map(FxHashMap<[u32; 2], Rgb>),
}

impl Default for Known {
    fn default() -> Self {
        Self::Map(FxHashMap::default())
    }
}

/// A rectangle of lights in a grid, both ends included.
#[derive(Clone, Copy, Debug)]
pub(super) struct LightGridPiece {
    pub low: [u32; 2],
    pub high: [u32; 2],
}

impl LightGridPiece {
    /// Returns the number of lights in this piece of an area light's grid.
    fn count(&self) -> usize {
        (0..2).map(|i| (self.high[i] - self.low[i] + 1) as usize).product()
    }

    /// Returns the lights at the corners of the piece.
    pub fn corners(&self) -> [[u32; 2]; 4] {
        let Self { low, high } = *self;
        [low, [high[0], low[1]], [low[0], high[1]], high]
    }

    /// True if the piece has no lights but those at its corners.
    pub fn is_smallest(&self) -> bool {
        (0..2).all(|i| self.high[i] - self.low[i] <= 1)
    }

    /// Divides the piece in halves along each side, which share the lights in their middle.
    pub fn quarters(&self) -> [Self; 4] {
        let Self { low, high } = *self;
        let halves = |i: usize| {
            let half = (high[i] - low[i]) / 2;
            [(low[i], low[i] + half), (high[i] - half, high[i])]
        };
        let ([left, right], [bottom, top]) = (halves(0), halves(1));
        let piece =
            |columns: (u32, u32), rows: (u32, u32)| Self { low: [columns.0, rows.0], high: [columns.1, rows.1] };
        [piece(left, bottom), piece(right, bottom), piece(left, top), piece(right, top)]
    }

    /// Divides the piece in halves along each side with more than one light, so that each light is in one part; `None`
    /// takes the place of a part without lights.
    fn parts(&self) -> [Option<LightGridPiece>; 4] {
        let Self { low, high } = *self;
        let ends = |i: usize| {
            let middle = low[i] + (high[i] - low[i]) / 2;
            [Some((low[i], middle)), (middle < high[i]).then_some((middle + 1, high[i]))]
        };
        let ([a, b], [c, d]) = (ends(0), ends(1));
        [(a, c), (b, c), (a, d), (b, d)].map(|(columns, rows)| {
            let ((left, right), (bottom, top)) = (columns?, rows?);
            Some(LightGridPiece { low: [left, bottom], high: [right, top] })
        })
    }
}

impl GridVisibility<'_> {
    /// Stores `visibility` for each light of a piece; without effect unless the grid's visibilities are in an array.
    fn store_if_array(&mut self, piece: LightGridPiece, visibility: Rgb) {
        let width = self.area.size[0] as usize;
        let [first, last] = [piece.low[0], piece.high[0]].map(|column| column as usize);
        if let Known::Array(all) = &mut self.known {
            for row in piece.low[1] as usize..=piece.high[1] as usize {
                all[row * width..][first..=last].fill(visibility);
            }
        }
    }
}

impl Tracer<'_> {
    /// Returns the mean visibility of a grid of lights. The grid is halved both ways down to single lights; a piece
    /// counts as the mean of its corners, so inner lights count twice and four times as much as those at edges and
    /// corners (quirk: `area_light_subdivision`). `random` gives the jitter of the lights.
    pub(super) fn area_visibility(
        &mut self,
        (light, area): (&LightSource, &Area),
        point: DVec3,
        center: &LightSample,
        inside: &Interiors,
        random: RandomSequence,
    ) -> Rgb {
        let [n, m] = area.size;
        let count = n as usize * m as usize;
        let all = LightGridPiece { low: [0, 0], high: [n - 1, m - 1] };
        let mut grid = GridVisibility {
            light,
            area,
            point,
            center,
            sides: area.sides(-center.to_light),
            inside,
            random,
            settle_level: area.adaptive,
            has_shafts: false,
            known: Known::default(),
        };
        let mut has_shafts = self.may_test_shafts(light, area, point);
        let is_stored = count <= MAX_ARRAY;
        // Trace two shadow rays that are needed in any case: in full shadow, no shaft is clear.
        let is_traced = has_shafts && is_stored;
        let ends = [all.low, all.high].map(|end| (end, is_traced.then(|| self.trace_cell_visibility(&grid, end))));
        if has_shafts {
            let is_lit = ends.iter().all(|(_, visibility)| visibility.is_none_or(|visibility| visibility == Rgb::ONE));
            if is_lit && self.is_own_piece_unoccluded(&grid, all) {
                return Rgb::ONE;
            }
            // (An adaptive grid has too few rays for tests of its parts.)
            has_shafts = area.adaptive.is_none() && !self.last_occluder_surrounds(light, point);
        }
        if is_stored {
            grid.known = Known::Array(vec![Rgb::NAN; count]);
        }
        for (end, visibility) in ends {
            visibility
                .into_iter()
                .for_each(|visibility| grid.store_if_array(LightGridPiece { low: end, high: end }, visibility));
        }
        if is_stored {
            if has_shafts {
                self.store_unoccluded_parts(&mut grid, all);
            }
        } else {
            grid.has_shafts = has_shafts;
            grid.settle_level = area.adaptive.or(Some(LARGE_GRID_LEVEL));
        }
        self.piece_visibility(&mut grid, all, 0)
    }

    /// True if shaft tests may replace shadow rays from the point: the point needs many of them, and nothing attenuates a
    /// shadow ray without hits. (A grid with `adaptive 0` needs only four where it is lit.) Air attenuates such a ray, but
    /// interiors around the point do not, since their media end at a surface (quirk: `light_inside_media`).
    pub(super) fn may_test_shafts(&self, light: &LightSource, area: &Area, point: DVec3) -> bool {
        let count = area.size[0] as usize * area.size[1] as usize;
        self.context.has_shafts
            && area.adaptive != Some(0)
            && count >= MIN_LIGHTS
            && light.through.is_none()
            && !light.emitter.is_parallel()
            && !(light.emitter.attenuated && self.has_air())
            && !self.last_occluder_surrounds(light, point)
    }

    /// True if the object that made the last shaft to the light fail makes every shaft from the point fail, too,
    /// because the point is in its box.
    fn last_occluder_surrounds(&self, light: &LightSource, point: DVec3) -> bool {
        self.shaft_occluders[light.number].is_some_and(|last| last.surrounds(point))
    }

    /// True only if no object occludes any light of a piece of a grid from a point, where the grid's centre is in the direction
    /// `to_center`: no object that casts shadows is in the shaft from the point to the lights.
    pub(super) fn is_piece_unoccluded(
        &mut self,
        (light, area): (&LightSource, &Area),
        point: DVec3,
        to_center: DVec3,
        piece: LightGridPiece,
    ) -> bool {
        let world = self.context.world;
        let hull = area.offset_parallelogram(piece.low, piece.high, -to_center);
        let corners = hull.map(|offset| light.emitter.location + offset);
        let casts_shadow = |id: u32| world.objects[id as usize].shadow;
        let last = &mut self.shaft_occluders[light.number];
        Shaft::new(point, corners)
            .is_some_and(|shaft| world.geometry.is_shaft_clear(&shaft, world.epsilon.shadow, casts_shadow, last))
    }

    /// Returns [`Self::is_piece_unoccluded`] for a piece of a grid, from the point at which it is evaluated.
    fn is_own_piece_unoccluded(&mut self, grid: &GridVisibility, piece: LightGridPiece) -> bool {
        self.is_piece_unoccluded((grid.light, grid.area), grid.point, grid.center.to_light, piece)
    }

    /// Divides a piece that failed the shaft test, and stores full visibility for the lights of each part that passes
    /// it. Parts of few lights are not tested.
    fn store_unoccluded_parts(&mut self, grid: &mut GridVisibility, piece: LightGridPiece) {
        if piece.count() <= MIN_PART {
            return;
        }
        for part in piece.parts().into_iter().flatten().filter(|part| part.count() >= MIN_PART) {
            let is_lit = [part.low, part.high].iter().all(|end| self.cell_visibility(grid, *end) == Rgb::ONE);
            match is_lit && self.is_own_piece_unoccluded(grid, part) {
                true => grid.store_if_array(part, Rgb::ONE),
                false => self.store_unoccluded_parts(grid, part),
            }
        }
    }

    /// Returns the mean visibility of a piece of the grid after `halvings_done` halvings.
    fn piece_visibility(&mut self, grid: &mut GridVisibility, piece: LightGridPiece, halvings_done: u32) -> Rgb {
        let corners = piece.corners().map(|cell| self.cell_visibility(grid, cell));
        let is_settled = grid.settle_level.is_some_and(|least| halvings_done >= least)
            && differs_too_little_to_split(&corners, grid.center.light);
        if piece.is_smallest() || is_settled || self.count_surface_and_is_stopped() {
            return corners.iter().sum::<Rgb>() * 0.25;
        }
        if grid.has_shafts
            && corners == [Rgb::ONE; 4]
            && piece.count() >= MIN_PART
            && self.is_own_piece_unoccluded(grid, piece)
        {
            return Rgb::ONE;
        }
        let mut sum = Rgb::ZERO;
        for quarter in piece.quarters() {
            sum += self.piece_visibility(grid, quarter, halvings_done + 1);
        }
        sum * 0.25
    }

    /// Returns the visibility of one light of the grid, which is computed once.
    fn cell_visibility(&mut self, grid: &mut GridVisibility, cell: [u32; 2]) -> Rgb {
        let at = cell[1] as usize * grid.area.size[0] as usize + cell[0] as usize;
        let known = match &grid.known {
            Known::Array(row) => Some(row[at]).filter(|known| !known.is_nan()),
            Known::Map(map) => map.get(&cell).copied(),
        };
        known.unwrap_or_else(|| {
            let visibility = self.trace_cell_visibility(grid, cell);
            match &mut grid.known {
                Known::Array(all) => all[at] = visibility,
                Known::Map(map) => drop(map.insert(cell, visibility)),
            }
            visibility
        })
    }

    /// Returns the visibility of one light of the grid by a shadow ray.
    #[inline]
    fn trace_cell_visibility(&mut self, grid: &GridVisibility, cell: [u32; 2]) -> Rgb {
        let offset = jittered_offset(grid.area, cell, &grid.sides, grid.random);
        let (from, distance) = grid.light.emitter.direction_and_distance(grid.point, offset);
        self.visibility_along_ray(grid.light, &Ray::new(grid.point, from), distance, grid.inside)
    }
}

/// Returns the offset of a light of the grid from the grid's centre, with jitter if the area light has it; `sides` are
/// the sides of the grid.
#[inline]
pub(super) fn jittered_offset(area: &Area, cell: [u32; 2], sides: &[DVec3; 2], random: RandomSequence) -> DVec3 {
    let number = number_of_jitter(cell);
    area.light_offset(cell, sides, area.jitter.then(|| [random.at(number), random.at(number + 1)]))
}

/// Returns the number of the first of the two random numbers that displace a light of a grid.
#[inline(always)]
pub(super) fn number_of_jitter(cell: [u32; 2]) -> u64 {
    2 * (u64::from(cell[1]) << 32 | u64::from(cell[0]))
}

/// True if the light at a piece's corners differs so little that the piece is not subdivided.
#[inline]
fn differs_too_little_to_split(corner_visibilities: &[Rgb; 4], light_color: Rgb) -> bool {
    let apart = |a: Rgb, b: Rgb| ((a - b) * light_color).abs().element_sum() > MAX_DIFFERENCE;
    !(0..4).any(|i| (0..i).any(|j| apart(corner_visibilities[i], corner_visibilities[j])))
}
