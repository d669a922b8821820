//! `crackle`: cells of random shape, each around a point of its own (manual, "Crackle").
//!
//! ```pov
//! sphere { 0, 1 pigment { crackle color_map { [0.05 color rgb 0.1] [0.1 color rgb <0.8, 0.6, 0.4>] } scale 0.3 } }
//! ```

use super::{Field, FieldParams, LocalBounds, TextureContext};
use crate::diagnostic::Result;
use crate::math::noise::{self, Around, Cell};
use crate::math::{DVec3, fp};
use crate::value::words::{Row, set, specs, word};
use crate::value::{Readable, Reader, Spec, ValueKind};
use serde::Serialize;

/// Pattern `crackle`: distances to the nearest of random sites; each unit cube holds one.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Crackle {
    /// Weights of the distances to the nearest, second and third site of `crackle`.
    pub form: DVec3,
    /// Exponent m of the metric of `crackle`: a distance is (Σ|d|ᵐ)^(1/m).
    pub metric: f64,
    /// Distance of all sites of `crackle` in a fourth dimension.
    pub offset: f64,
    /// True if all points of a cell of `crackle` have the same number.
    pub solid: bool,
}

impl Readable for Crackle {
    const SPEC: Spec =
        Spec { name: "crackle", summary: "cells of random shape", words: specs!(Self::WORDS), ..Spec::EMPTY };

    const WORDS: &'static [Row<Self>] = &[
        word(
            "form",
            ValueKind::Vector,
            "<-1, 1, 0>",
            "what the distances to the nearest, second and third point count",
        )
        .sets(|s, r| set(&mut s.form, r.vector())),
        word(
            "metric",
            ValueKind::Float,
            "2",
            "the power that makes a distance; 1 counts along the axes, 2 is the usual",
        )
        .sets(|s, r| set(&mut s.metric, r.float())),
        word("offset", ValueKind::Float, "0", "distance in a fourth dimension")
            .sets(|s, r| set(&mut s.offset, r.float())),
        word("solid", ValueKind::Nothing, "", "one number for each cell").sets(|s, _| set(&mut s.solid, Ok(true))),
    ];

    fn read(_: &mut dyn Reader) -> Result<Self> {
        Ok(Self { form: DVec3::new(-1.0, 1.0, 0.0), metric: 2.0, offset: 0.0, solid: false })
    }
}

impl Field for Crackle {
    fn value(&self, at: &TextureContext) -> f64 {
        let near = nearest_sites(at.p, self.metric);
        if self.solid {
            return noise::noise(near.site, at.noise);
        }
        let offset = metric_power(self.offset, self.metric);
        let distance = |sum: f64| metric_root(sum + offset, self.metric);
        let value = (0..3).filter(|&i| self.form[i] != 0.0).map(|i| self.form[i] * distance(near.sums[i])).sum::<f64>();
        value.clamp(0.0, 1.0)
    }

    fn value_bounds_near(&self, at: &TextureContext, _: &FieldParams, radius: f64) -> LocalBounds {
        // No distance grows faster than the point moves, except the largest-component metric along the axes.
        let steepest = match self.metric {
            1.0 => 3f64.sqrt(),
            2.0 => 1.0,
            _ => return LocalBounds::UNKNOWN.clamp_range(0.0, 1.0),
        };
        if self.solid || self.offset < 0.0 {
            return LocalBounds::UNKNOWN.clamp_range(0.0, 1.0);
        }
        LocalBounds::from_max_gradient(self.value(at), steepest * self.form.abs().element_sum(), radius)
            .clamp_range(0.0, 1.0)
    }
}

/// The three nearest sites of a point in the pattern `crackle`.
#[derive(Clone, Copy, Debug)]
pub struct Nearest {
    /// Sums of powers of the distances to the three nearest sites, ascending.
    pub sums: [f64; 3],
    /// Position of the site of `crackle` that is nearest to the point.
    pub site: DVec3,
}

/// Finds the three sites of `crackle` nearest to a point; the sums of powers of their distances are smallest.
pub fn nearest_sites(p: DVec3, metric: f64) -> Nearest {
    let (cell, within) = Cell::cell_and_position(p);
    let mut near = Nearest { sums: [f64::INFINITY; 3], site: p };
    let next = if metric == 2.0 {
        near = cell.with_neighbour_points(|around| near.with_squared_distances(around, within));
        // No site in a cube two steps away is nearer than that cube's side.
        let side = |x: f64| metric_power(2.0 - x, 2.0).min(metric_power(1.0 + x, 2.0));
        if side(within.x).min(side(within.y)).min(side(within.z)) >= near.sums[2] {
            return near;
        }
        27
    } else {
        0
    };
    // Distance of a cube along an axis, as a power: 0 for the point's own cube. Negative exponents give no bound.
    let gap = |axis: usize, step: isize| match step {
        _ if metric <= 0.0 => 0.0,
        0 => 0.0,
        1.. => metric_power(step as f64 - within[axis], metric),
        _ => metric_power(within[axis] - step as f64 - 1.0, metric),
    };
    let gaps = [0, 1, 2].map(|axis| [-2, -1, 0, 1, 2].map(|step| gap(axis, step)));
    for &[i, j, k] in &AROUND[next..] {
        let least = gaps[0][(i + 2) as usize] + gaps[1][(j + 2) as usize] + gaps[2][(k + 2) as usize];
        if least >= near.sums[2] {
            continue;
        }
        let step = DVec3::new(i as f64, j as f64, k as f64);
        let site = step + cell.offset_by([i, j, k]).random_offset_in_cell() - within;
        near.insert_site(metric_sum(site, metric), p + site);
    }
    near
}

/// Returns, of the sites in the cubes around the point, the site whose coordinates x + y + z have the least sum.
pub fn least_coordinate_sum_site(p: DVec3) -> DVec3 {
    let (cell, within) = Cell::cell_and_position(p);
    let corner = p - within;
    let sites = AROUND.iter().map(|&[i, j, k]| {
        corner + DVec3::new(i as f64, j as f64, k as f64) + cell.offset_by([i, j, k]).random_offset_in_cell()
    });
    sites.min_by(|a, b| a.element_sum().total_cmp(&b.element_sum())).unwrap_or(p)
}

impl Nearest {
    /// Inserts the squared distances from the position `within` a cube to the sites `around` it; `self` is empty.
    fn with_squared_distances(self, around: &Around, within: DVec3) -> Self {
        let (sums, nearest) = around.nearest_squared_distances(within);
        let [xs, ys, zs] = &around.points;
        let of = |i: usize| DVec3::new(xs[i] - within.x, ys[i] - within.y, zs[i] - within.z);
        Self { sums, site: nearest.map_or(self.site, |i| self.site + of(i)) }
    }

    /// Inserts a site of `crackle` with the sum of powers of its distance; keeps the three smallest sums, ascending.
    fn insert_site(&mut self, distance_sum: f64, site: DVec3) {
        let [first, second, third] = self.sums;
        if distance_sum < first {
            *self = Self { sums: [distance_sum, first, second], site };
        } else if distance_sum < second {
            self.sums = [first, distance_sum, second];
        } else if distance_sum < third {
            self.sums[2] = distance_sum;
        }
    }
}

/// Offsets of the cubes that `crackle` searches, nearest first: one step along each axis, or two along a single one.
const AROUND: [[isize; 3]; 81] = search_offsets();

const fn search_offsets() -> [[isize; 3]; 81] {
    let (mut out, mut n) = ([[0; 3]; 81], 0);
    // sorted by the sum of the squares of their steps
    let mut square = 0;
    while square <= 6 {
        let mut code = 0;
        while code < 125 {
            let [i, j, k] = [code % 5 - 2, code / 5 % 5 - 2, code / 25 - 2];
            let far = (i * i == 4) as u8 + (j * j == 4) as u8 + (k * k == 4) as u8;
            if i * i + j * j + k * k == square && far < 2 {
                out[n] = [i, j, k];
                n += 1;
            }
            code += 1;
        }
        square += 1;
    }
    out
}

fn metric_sum(v: DVec3, metric: f64) -> f64 {
    let v = v.abs();
    metric_power(v.x, metric) + metric_power(v.y, metric) + metric_power(v.z, metric)
}

fn metric_power(x: f64, metric: f64) -> f64 {
    match metric {
        1.0 => x,
        2.0 => x * x,
        _ if x == 0.0 => 0.0,
        _ => fp::pow(x, metric),
    }
}

fn metric_root(x: f64, metric: f64) -> f64 {
    match metric {
        1.0 => x,
        2.0 => x.sqrt(),
        _ => fp::pow(x, 1.0 / metric),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn skipping_far_cubes_changes_nothing(p in prop::array::uniform3(-9.0..9.0f64), metric in 0.3..9.0f64) {
            let p = DVec3::from(p);
            let (cell, within) = Cell::cell_and_position(p);
            let site = |s: &[isize; 3]| DVec3::from(s.map(|i| i as f64)) + cell.offset_by(*s).random_offset_in_cell() - within;
            let mut sums = AROUND.map(|step| metric_sum(site(&step), metric));
            sums.sort_by(f64::total_cmp);
            prop_assert_eq!(sums[..3].to_vec(), nearest_sites(p, metric).sums.to_vec());
        }

        #[test]
        fn several_at_once_change_nothing(p in prop::array::uniform3(-9.0..9.0f64)) {
            let p = DVec3::from(p);
            let (cell, within) = Cell::cell_and_position(p);
            let mut slow = Nearest { sums: [f64::INFINITY; 3], site: p };
            for step in &AROUND {
                let site = DVec3::from(step.map(|i| i as f64)) + cell.offset_by(*step).random_offset_in_cell() - within;
                slow.insert_site(metric_sum(site, 2.0), p + site);
            }
            let fast = nearest_sites(p, 2.0);
            prop_assert_eq!((fast.sums, fast.site), (slow.sums, slow.site));
        }
    }
}
