//! Soft shadows: the shadows of all lights of a grid in one (manual, "Area Lights"; details measured on POV-Ray 3.7).

use super::random::{Purpose, Row};
use super::trace::{Path, Tracer};
use crate::color::Rgb;
use crate::light::{Area, LightSample};
use crate::math::DVec3;
use crate::world::LightSource;
use rustc_hash::FxHashMap;

/// Corners whose light differs by more, summed over the channels, do not agree.
const AGREE: f64 = 0.1;
/// A grid of no more lights is kept as a row.
const FEW: usize = 1 << 16;

/// A grid of lights that shines on a place.
struct Shadow<'a> {
    light: &'a LightSource,
    area: &'a Area,
    point: DVec3,
    arriving: &'a LightSample,
    path: &'a Path,
    random: Row,
    known: Known,
}

/// What has been asked.
enum Known {
    /// Row by row; not a number where nobody asked.
    Few(Vec<Rgb>),
    Many(FxHashMap<[u32; 2], Rgb>),
}

impl Tracer<'_> {
    /// The part of the light that comes through from a grid of lights. It is halved both ways down to single lights, and what counts of a
    /// piece is the mean of its corners; so those within a grid count twice and four times as much as those at its edges.
    pub(super) fn through_area(
        &mut self,
        light: &LightSource,
        area: &Area,
        point: DVec3,
        arriving: &LightSample,
        path: &Path,
    ) -> Rgb {
        let [n, m] = area.size;
        let count = n as usize * m as usize;
        let known = if count <= FEW { Known::Few(vec![Rgb::NAN; count]) } else { Known::Many(FxHashMap::default()) };
        let random = self.random.row(Purpose::AreaLight);
        let mut shadow = Shadow { light, area, point, arriving, path, random, known };
        self.piece(&mut shadow, [0, 0], [n - 1, m - 1], 0)
    }

    /// The mean over a piece of the grid, from one light to another, after so many halvings.
    fn piece(&mut self, shadow: &mut Shadow, low: [u32; 2], high: [u32; 2], level: u32) -> Rgb {
        let corners = [low, [high[0], low[1]], [low[0], high[1]], high].map(|cell| self.one(shadow, cell));
        let single = (0..2).all(|i| high[i] - low[i] <= 1);
        let settled =
            shadow.area.adaptive.is_some_and(|least| level >= least) && agree(&corners, shadow.arriving.light);
        if single || settled || self.stopped() {
            return corners.iter().sum::<Rgb>() * 0.25;
        }
        let halves = |i: usize| {
            let half = (high[i] - low[i]) / 2;
            [(low[i], low[i] + half), (high[i] - half, high[i])]
        };
        let mut sum = Rgb::ZERO;
        for (bottom, top) in halves(1) {
            for (left, right) in halves(0) {
                sum += self.piece(shadow, [left, bottom], [right, top], level + 1);
            }
        }
        sum * 0.25
    }

    /// What comes through from one light.
    fn one(&mut self, shadow: &mut Shadow, cell: [u32; 2]) -> Rgb {
        let at = cell[1] as usize * shadow.area.size[0] as usize + cell[0] as usize;
        let known = match &shadow.known {
            Known::Few(row) => Some(row[at]).filter(|known| !known.is_nan()),
            Known::Many(map) => map.get(&cell).copied(),
        };
        known.unwrap_or_else(|| {
            let toward = -shadow.arriving.from;
            let offset = offset(shadow.area, cell, toward, shadow.random);
            let ray = shadow.light.emitter.sample(shadow.point, offset);
            let passed = self.unshadowed(shadow.light, shadow.point, &ray, shadow.path);
            match &mut shadow.known {
                Known::Few(row) => row[at] = passed,
                Known::Many(map) => drop(map.insert(cell, passed)),
            }
            passed
        })
    }
}

/// Where a light of a grid stands, seen from a place in the direction `toward`.
pub(super) fn offset(area: &Area, cell: [u32; 2], toward: DVec3, random: Row) -> DVec3 {
    let number = 2 * (u64::from(cell[1]) << 32 | u64::from(cell[0]));
    area.offset(cell, toward, area.jitter.then(|| [random.at(number), random.at(number + 1)]))
}

/// Does the light of all corners hardly differ?
#[inline]
fn agree(corners: &[Rgb; 4], light: Rgb) -> bool {
    let apart = |a: Rgb, b: Rgb| ((a - b) * light).abs().element_sum() > AGREE;
    !(0..4).any(|i| (0..i).any(|j| apart(corners[i], corners[j])))
}
