//! `area_light`: soft shadows by the visibility of a grid of lights (manual, "Area Lights").

use super::interface::Interiors;
use super::random::{Purpose, RandomSequence};
use super::tracer::Tracer;
use crate::color::Rgb;
use crate::light::{Area, LightSample};
use crate::math::DVec3;
use crate::world::LightSource;
use rustc_hash::FxHashMap;

/// Maximum difference of the light at a piece's corners, summed over the channels, at which the piece is not subdivided
/// (quirk: `area_light_subdivision`).
const MAX_DIFFERENCE: f64 = 0.1;
/// Maximum number of lights of a grid whose visibilities are stored in an array.
const MAX_ARRAY: usize = 1 << 16;

/// One evaluation of the visibility of a grid of lights.
struct GridVisibility<'a> {
    light: &'a LightSource,
    area: &'a Area,
    point: DVec3,
    /// Sample of the light at the grid's centre.
    center: &'a LightSample,
    /// Interiors that contain the point.
    inside: &'a Interiors,
    random: RandomSequence,
    known: Known,
}

/// Known visibilities of the lights of a grid.
enum Known {
    /// Visibility of each light, row by row; NaN for a light without a shadow ray.
    Array(Vec<Rgb>),
    Map(FxHashMap<[u32; 2], Rgb>),
}

impl Tracer<'_> {
    /// Returns the mean visibility of a grid of lights. The grid is halved both ways down to single lights; a piece
    /// counts as the mean of its corners, so inner lights count twice and four times as much as those at edges and
    /// corners (quirk: `area_light_subdivision`).
    pub(super) fn area_visibility(
        &mut self,
        light: &LightSource,
        area: &Area,
        point: DVec3,
        center: &LightSample,
        inside: &Interiors,
    ) -> Rgb {
        let [n, m] = area.size;
        let count = n as usize * m as usize;
        let known = match count <= MAX_ARRAY {
            true => Known::Array(vec![Rgb::NAN; count]),
            false => Known::Map(FxHashMap::default()),
        };
        let random = self.random.sequence(Purpose::AreaLight);
        let mut grid = GridVisibility { light, area, point, center, inside, random, known };
        if count > MAX_ARRAY && area.adaptive.is_none() {
            return self.mean_of_all_lights(&grid);
        }
        self.piece_visibility(&mut grid, [0, 0], [n - 1, m - 1], 0)
    }

    /// Returns the mean visibility of a large grid that is not adaptive, without storing the lights' visibilities. The
    /// weight of a light is the product of the weights of its column and row.
    fn mean_of_all_lights(&mut self, grid: &GridVisibility) -> Rgb {
        let [columns, rows] = grid.area.size.map(weights_of_halving);
        let mut sum = Rgb::ZERO;
        for (row, row_weight) in (0..).zip(&rows) {
            for (column, weight) in (0..).zip(&columns) {
                if self.is_stopped_at_next_surface() {
                    return sum;
                }
                sum += self.light_visibility(grid, [column, row]) * (row_weight * weight);
            }
        }
        sum
    }

    /// Returns the mean visibility of a piece of the grid, from the light `low` to `high`, after `level` halvings.
    fn piece_visibility(&mut self, grid: &mut GridVisibility, low: [u32; 2], high: [u32; 2], level: u32) -> Rgb {
        let corners = [low, [high[0], low[1]], [low[0], high[1]], high].map(|cell| self.cell_visibility(grid, cell));
        let is_single = (0..2).all(|i| high[i] - low[i] <= 1);
        let is_settled =
            grid.area.adaptive.is_some_and(|least| level >= least) && is_uniform(&corners, grid.center.light);
        if is_single || is_settled || self.is_stopped_at_next_surface() {
            return corners.iter().sum::<Rgb>() * 0.25;
        }
        let halves = |i: usize| {
            let half = (high[i] - low[i]) / 2;
            [(low[i], low[i] + half), (high[i] - half, high[i])]
        };
        let mut sum = Rgb::ZERO;
        for (bottom, top) in halves(1) {
            for (left, right) in halves(0) {
                sum += self.piece_visibility(grid, [left, bottom], [right, top], level + 1);
            }
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
            let visibility = self.light_visibility(grid, cell);
            match &mut grid.known {
                Known::Array(row) => row[at] = visibility,
                Known::Map(map) => drop(map.insert(cell, visibility)),
            }
            visibility
        })
    }

    /// Returns the visibility of one light of the grid by a shadow ray.
    fn light_visibility(&mut self, grid: &GridVisibility, cell: [u32; 2]) -> Rgb {
        let offset = offset(grid.area, cell, -grid.center.from, grid.random);
        let sample = grid.light.emitter.sample(grid.point, offset);
        self.point_visibility(grid.light, grid.point, &sample, grid.inside)
    }
}

/// Returns the weights of the lights along one side of a grid, whose sum is 1: the side is halved down to pairs, and
/// both lights of a pair have equal weights.
fn weights_of_halving(n_lights: u32) -> Vec<f64> {
    let mut out = vec![0.0; n_lights as usize];
    let mut pieces = vec![(0, n_lights - 1, 1.0)];
    while let Some((low, high, weight)) = pieces.pop() {
        let half = (high - low) / 2;
        if high - low <= 1 {
            out[low as usize] += 0.5 * weight;
            out[high as usize] += 0.5 * weight;
        } else {
            pieces.extend([(low, low + half, 0.5 * weight), (high - half, high, 0.5 * weight)]);
        }
    }
    out
}

/// Returns the offset of a light of the grid from the grid's centre, with jitter; `toward` is the direction from the
/// light to the point.
pub(super) fn offset(area: &Area, cell: [u32; 2], toward: DVec3, random: RandomSequence) -> DVec3 {
    let number = 2 * (u64::from(cell[1]) << 32 | u64::from(cell[0]));
    area.light_offset(cell, toward, area.jitter.then(|| [random.at(number), random.at(number + 1)]))
}

/// True if the light at a piece's corners differs so little that the piece is not subdivided.
#[inline]
fn is_uniform(corners: &[Rgb; 4], light: Rgb) -> bool {
    let apart = |a: Rgb, b: Rgb| ((a - b) * light).abs().element_sum() > MAX_DIFFERENCE;
    !(0..4).any(|i| (0..i).any(|j| apart(corners[i], corners[j])))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Returns the weight of the light `at` in the mean from `low` to `high`, a range that is halved down to pairs.
    fn light_weight(at: u32, low: u32, high: u32) -> f64 {
        if high - low <= 1 {
            return 0.5 * (f64::from(at == low) + f64::from(at == high));
        }
        let half = (high - low) / 2;
        0.5 * (light_weight(at, low, low + half) + light_weight(at, high - half, high))
    }

    #[test]
    fn weights_are_those_of_halving() {
        for n in [1, 2, 3, 4, 5, 7, 8, 17, 100] {
            let expected: Vec<f64> = (0..n).map(|at| light_weight(at, 0, n - 1)).collect();
            assert_eq!(weights_of_halving(n), expected, "{n}");
        }
    }
}
