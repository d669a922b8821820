//! `bokeh { pigment { … } }`: transmittance of the lens by position, which shapes points that are out of focus (quirk:
//! `bokeh`). The brightness of the picture does not change.

use crate::color::gray;
use crate::math::DVec2;
use crate::math::noise::NoiseGenerator;
use crate::pattern::TextureContext;
use crate::texture::{Pigment, PigmentProgram};

/// Number of cells along a side of the square lens of `bokeh`.
const SIDE: usize = 128;

/// Square lens of focal blur with `bokeh`: the distribution of rays over its cells.
#[derive(Clone, Debug, PartialEq)]
pub struct Bokeh {
    /// Cumulative distribution of light over the lens's rows of cells: for each row, and the end, the share of all
    /// light before it.
    rows: Vec<f64>,
    /// Cumulative distributions of light over the cells of each row: for each cell, and the end, the share of the row's
    /// light before it.
    cells: Vec<Vec<f64>>,
}

impl Bokeh {
    /// Builds the lens from the pigment's brightness, clamped to 0..1, from <0, 0> to <1, 1>. A pigment that is black
    /// everywhere counts as white.
    pub(super) fn new(pigment: &Pigment, noise: NoiseGenerator, waves: usize) -> Self {
        let program = PigmentProgram::new(pigment);
        Self::from_brightness(|at| {
            let ctx = TextureContext { waves, ..TextureContext::without_surface(at.extend(0.0), noise) };
            gray(program.color_at(&ctx).rgb)
        })
    }

    fn from_brightness(brightness_on_unit_square: impl Fn(DVec2) -> f64) -> Self {
        let middle = |cell: usize| (cell as f64 + 0.5) / SIDE as f64;
        let light = |x, y| {
            let light = brightness_on_unit_square(DVec2::new(middle(x), middle(y)));
            // NaN counts as dark.
            if light > 0.0 { light.min(1.0) } else { 0.0 }
        };
        let weights: Vec<Vec<f64>> = (0..SIDE).map(|y| (0..SIDE).map(|x| light(x, y)).collect()).collect();
        let sums: Vec<f64> = weights.iter().map(|row| row.iter().sum()).collect();
        Self { rows: cumulative_shares(&sums), cells: weights.iter().map(|row| cumulative_shares(row)).collect() }
    }

    /// Returns a point of the lens, from -1 to 1 to the right and up. `unit_square_sample` has two numbers in [0, 1).
    /// They invert the distribution of the rows, then of the cells of a row (Pharr, Jakob, Humphreys: Physically Based
    /// Rendering, 2016, 13.6.7). Neighbours stay neighbours.
    pub(super) fn sample_signed_lens_square(&self, unit_square_sample: DVec2) -> DVec2 {
        let (row, y) = cell_and_overall_position(&self.rows, unit_square_sample.y);
        let (_, x) = cell_and_overall_position(&self.cells[row], unit_square_sample.x);
        // The pigment's y axis points down.
        DVec2::new(2.0 * x - 1.0, 1.0 - 2.0 * y)
    }

    /// Mean position of the rays on the lens.
    #[cfg(test)]
    fn mean_position(&self) -> DVec2 {
        let n = 200;
        let at = |i: usize| (i as f64 + 0.5) / n as f64;
        let sum: DVec2 = (0..n * n).map(|i| self.sample_signed_lens_square(DVec2::new(at(i % n), at(i / n)))).sum();
        sum / (n * n) as f64
    }
}

/// Cumulative shares before each weight and before the end; even shares if all weights are 0.
fn cumulative_shares(weights: &[f64]) -> Vec<f64> {
    let total: f64 = weights.iter().sum();
    let share = |weight: f64| if total > 0.0 { weight / total } else { 1.0 / weights.len() as f64 };
    let mut before = 0.0;
    let mut starts = Vec::with_capacity(weights.len() + 1);
    for weight in weights {
        starts.push(before);
        before += share(*weight);
    }
    starts.push(1.0);
    starts
}

/// Finds the cell whose range of cumulative shares contains `share`; returns its index and the position along all
/// cells, from 0 to 1.
fn cell_and_overall_position(shares: &[f64], share: f64) -> (usize, f64) {
    let cells = shares.len() - 1;
    let cell = shares.partition_point(|start| *start <= share).clamp(1, cells) - 1;
    let width = shares[cell + 1] - shares[cell];
    let within = if width > 0.0 { ((share - shares[cell]) / width).clamp(0.0, 1.0) } else { 0.5 };
    (cell, (cell as f64 + within) / cells as f64)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rays_lie_where_the_light_is() {
        // ∫x·x/∫x = 2/3 of the width, which is 1/3 of the lens; y points down
        let sloping = Bokeh::from_brightness(|at| at.x);
        assert!(sloping.mean_position().distance(DVec2::X / 3.0) < 1e-4, "{}", sloping.mean_position());
        let low = Bokeh::from_brightness(|at| f64::from(at.y > 0.5));
        assert!(low.mean_position().distance(DVec2::NEG_Y / 2.0) < 1e-4, "{}", low.mean_position());
        let two = Bokeh::from_brightness(|at| if at.x < 0.5 { 1.0 } else { 0.25 });
        // 0.8·(-½) + 0.2·½
        assert!(two.mean_position().distance(DVec2::X * -0.3) < 1e-2, "{}", two.mean_position());
    }

    #[test]
    fn what_is_no_light_is_as_good_as_any() {
        for none in [0.0, -1.0, f64::NAN, f64::INFINITY] {
            let lens = Bokeh::from_brightness(|_| none);
            assert_eq!(lens.sample_signed_lens_square(DVec2::splat(0.25)), DVec2::new(-0.5, 0.5), "{none}");
        }
    }
}
