//! Maps points to pixels of a picture: `map_type`, `once`, `interpolate` (manual, "Bitmap Modifiers"; quirk:
//! `image_pixel_centres`).

use crate::math::{DVec3, fp};
use crate::pattern::EDGE;
use serde::Serialize;
use smallvec::{SmallVec, smallvec};
use std::f64::consts::{PI, TAU};

/// Projection of a bitmap's picture and interpolation between its pixels.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize)]
pub struct Mapping {
    /// Projection from points of space to the bitmap's picture.
    pub wrap: Wrap,
    /// True if the bitmap's picture is not repeated.
    pub once: bool,
    /// Interpolation between the bitmap's pixels nearest to a point.
    pub between: PixelInterpolation,
}

/// Projection from points to a bitmap's picture, by the number after `map_type`.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Wrap {
    /// Bitmap projection 0: on the xy plane, from (0, 0) to (1, 1).
    #[default]
    Planar,
    /// Bitmap projection 1: around a sphere.
    Spherical,
    /// Bitmap projection 2: around a cylinder about the y axis, from y = 0 to 1.
    Cylindrical,
    /// Bitmap projection 5: around a torus of major radius 1.
    Toroidal,
}

/// Interpolation between a bitmap's pixels, by the number after `interpolate`.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum PixelInterpolation {
    /// No interpolation: the bitmap's pixel that contains the point.
    #[default]
    Nearest,
    /// Bitmap interpolation 2: linear in both directions.
    Bilinear,
    /// Bitmap interpolation 3: cubic curves through 16 pixels.
    Bicubic,
    /// Bitmap interpolation 4: four pixels, weighted by their distance.
    Distance,
}

/// Indices of a bitmap's pixels, row by row from the top, each with its weight.
pub type Weighted = SmallVec<[(usize, f64); 4]>;

impl Wrap {
    /// Returns the projection for the number after `map_type`; unknown numbers give the planar projection.
    pub fn from_map_type(n: f64) -> Self {
        match n as i64 {
            1 => Self::Spherical,
            2 => Self::Cylindrical,
            5 => Self::Toroidal,
            _ => Self::Planar,
        }
    }
}

impl PixelInterpolation {
    /// Returns the interpolation for the number after `interpolate`; `None` for an unknown number.
    pub fn from_interpolate_number(n: f64) -> Option<Self> {
        Some(match n as i64 {
            0 => Self::Nearest,
            2 => Self::Bilinear,
            3 => Self::Bicubic,
            4 => Self::Distance,
            _ => return None,
        })
    }
}

impl Mapping {
    /// Projects a point to a position on the bitmap's picture: (0, 0) is the lower left corner, (1, 1) the upper right
    /// one. `None` outside of a picture with `once`, and where the projection is undefined: at the centre of a sphere,
    /// and on the axis of a cylinder or torus.
    pub fn project_to_unit_square(&self, p: DVec3) -> Option<(f64, f64)> {
        let around = || fp::positive_angle_in_turns(p.z, p.x);
        let axis = p.x == 0.0 && p.z == 0.0;
        match self.wrap {
            Wrap::Planar => {
                let unit = 0.0..=1.0;
                let inside = !self.once || (unit.contains(&p.x) && unit.contains(&p.y));
                inside.then(|| (fp::fraction_above_floor(p.x), fp::fraction_above_floor(p.y)))
            }
            Wrap::Spherical => {
                let r = p.length();
                (r != 0.0).then(|| (if axis { 0.0 } else { around() }, fp::asin((p.y / r).clamp(-1.0, 1.0)) / PI + 0.5))
            }
            Wrap::Cylindrical => {
                let inside = !axis && (!self.once || (0.0..=1.0).contains(&p.y));
                inside.then(|| (around(), fp::fraction_above_floor(p.y)))
            }
            Wrap::Toroidal => {
                let tube = fp::atan2(p.y, fp::hypot(p.x, p.z) - 1.0) / TAU + 0.5;
                (!axis).then(|| (around(), fp::fraction_above_floor(tube)))
            }
        }
    }

    /// Returns the bitmap's pixels, with weights, that are interpolated at a position, for a picture of this size.
    pub fn weighted_pixels(&self, (u, v): (f64, f64), width: usize, height: usize) -> Weighted {
        let (w, h) = (width as f64, height as f64);
        let size = Size { width, height, once: self.once };
        // Pixel centres are at half numbers, counted from the top left corner.
        let (a, b) = (u * w - 0.5, (1.0 - v) * h - 0.5);
        let (i, j) = (a.floor(), b.floor());
        let (s, t) = (a - i, b - j);
        let (i, j) = (i as i64, j as i64);
        match self.between {
            PixelInterpolation::Nearest => {
                let column = (u * w + EDGE).floor() as usize % width;
                let row = height - 1 - (v * h + EDGE).floor() as usize % height;
                smallvec![(row * width + column, 1.0)]
            }
            PixelInterpolation::Bilinear => weighted_grid(i, j, &[1.0 - s, s], &[1.0 - t, t], size),
            PixelInterpolation::Bicubic => {
                let row = |f: f64| [1.0 + f, f, 1.0 - f, 2.0 - f].map(catmull_rom_weight);
                weighted_grid(i - 1, j - 1, &row(s), &row(t), size)
            }
            PixelInterpolation::Distance => {
                // Lower left of the four pixels; a point level with the centres takes those and the next.
                let (left, above) = ((a + EDGE).floor(), (b - EDGE).ceil() - 1.0);
                inverse_square_weighted_pixels(left as i64, above as i64, a - left, b - above, size)
            }
        }
    }
}

/// Size of a bitmap's picture, and whether pixels beyond an edge repeat the edge or continue at the opposite side.
#[derive(Clone, Copy)]
struct Size {
    width: usize,
    height: usize,
    once: bool,
}

impl Size {
    fn pixel_index(self, i: i64, j: i64) -> usize {
        let bring = |k: i64, n: usize| {
            let n = n as i64;
            (if self.once { k.clamp(0, n - 1) } else { k.rem_euclid(n) }) as usize
        };
        bring(j, self.height) * self.width + bring(i, self.width)
    }
}

/// Returns the pixels of a grid that begins at (i, j), each with the product of its column's and row's weight, for
/// interpolation in a bitmap.
fn weighted_grid(i: i64, j: i64, column_weights: &[f64], row_weights: &[f64], size: Size) -> Weighted {
    let mut out = Weighted::new();
    for (y, t) in (j..).zip(row_weights) {
        for (x, s) in (i..).zip(column_weights) {
            out.push((size.pixel_index(x, y), s * t));
        }
    }
    out
}

/// Weight of a bitmap's pixel at a distance below 2 (Catmull and Rom, A class of local interpolating splines, 1974).
fn catmull_rom_weight(d: f64) -> f64 {
    if d < 1.0 { 1.0 - 2.5 * d * d + 1.5 * d * d * d } else { 2.0 - 4.0 * d + 2.5 * d * d - 0.5 * d * d * d }
}

/// Returns four pixels of a bitmap, weighted by the inverse squares of their distances.
fn inverse_square_weighted_pixels(i: i64, j: i64, s: f64, t: f64, size: Size) -> Weighted {
    let mut out = Weighted::new();
    for (x, y) in [(0, 0), (1, 0), (0, 1), (1, 1)] {
        let (dx, dy) = (s - f64::from(x), t - f64::from(y));
        let squared = dx * dx + dy * dy;
        let number = size.pixel_index(i + i64::from(x), j + i64::from(y));
        if squared == 0.0 {
            return smallvec![(number, 1.0)];
        }
        out.push((number, 1.0 / squared));
    }
    let sum: f64 = out.iter().map(|(_, weight)| weight).sum();
    out.iter_mut().for_each(|(_, weight)| *weight /= sum);
    out
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn nearest_counts_from_the_top() {
        let flat = Mapping::default();
        let at =
            |x, y| flat.project_to_unit_square(DVec3::new(x, y, 0.0)).map(|uv| flat.weighted_pixels(uv, 4, 3)[0].0);
        assert_eq!([at(0.1, 0.1), at(0.9, 0.9), at(1.3, -0.1)], [Some(8), Some(3), Some(1)]);
    }

    #[test]
    fn weights_add_up_to_one() {
        for between in [PixelInterpolation::Bilinear, PixelInterpolation::Bicubic, PixelInterpolation::Distance] {
            let mapping = Mapping { between, ..Mapping::default() };
            let sum: f64 = mapping.weighted_pixels((0.37, 0.81), 5, 7).iter().map(|(_, weight)| weight).sum();
            assert!((sum - 1.0).abs() < 1e-12, "{between:?}");
        }
    }

    #[test]
    fn once_ends_at_the_edges() {
        let once = Mapping { once: true, between: PixelInterpolation::Bilinear, ..Mapping::default() };
        assert_eq!(once.project_to_unit_square(DVec3::new(1.01, 0.5, 0.0)), None);
        assert!(once.weighted_pixels((0.01, 0.99), 4, 4).iter().all(|(number, _)| *number == 0));
    }
}
