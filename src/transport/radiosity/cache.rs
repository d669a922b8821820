//! Cache of gathered light: samples with a radius, found by position (Ward, Rubinstein and Clear, A ray tracing solution
//! for diffuse interreflection, 1988).
//!
//! A sample is listed in all cells of a grid that its sphere of influence overlaps. The grid's cells are at least as wide as
//! the sphere, so that a sample is in at most 8 cells, and a query reads one cell of each grid.

use crate::color::Rgb;
use crate::math::DVec3;
use rustc_hash::FxHashMap;
use smallvec::SmallVec;

/// Maximum number of radiosity samples in the cache; later samples are used once and dropped.
const MAX_SAMPLES: usize = 8 << 20;
/// Maximum radius of the sphere in which a radiosity sample may be reused, so that the sphere overlaps at most 8 cells
/// of the widest grid.
const MAX_REACH: f64 = 1e300;
/// Minimum cosine of the angle between the normals of a sample and of a point that uses it.
const MIN_COSINE: f64 = 0.5;
/// Distance in front of a sample, as a share of its radius, up to which points may use it.
const MAX_IN_FRONT: f64 = 0.05;

/// Light that was gathered at a point of a surface.
#[derive(Clone, Copy, Debug)]
pub struct Sample {
    /// Point in world space.
    pub point: DVec3,
    /// Normal at the point, length 1.
    pub normal: DVec3,
    /// Mean radiance over the cosine-weighted hemisphere.
    pub light: Rgb,
    /// Harmonic mean of the distances to other surfaces, limited by the settings.
    pub radius: f64,
    /// Number of diffuse bounces between the camera ray and the point.
    pub depth: u8,
}

/// Weighted sum of the radiosity samples that are reused at a point.
#[derive(Clone, Copy, Debug, Default)]
pub struct Blend {
    light: Rgb,
    weight: f64,
    /// Number of radiosity samples in the weighted sum.
    pub count: u32,
}

impl Blend {
    /// Returns the weighted mean of the samples; `None` without a sample.
    pub fn mean(&self) -> Option<Rgb> {
        (self.count > 0).then(|| self.light / self.weight)
    }
}

/// Query of the radiosity cache: a point of a surface, and the maximum error of the samples that it may reuse.
#[derive(Clone, Copy, Debug)]
pub struct Query {
    /// Point in world space.
    pub point: DVec3,
    /// Normal at the point, length 1.
    pub normal: DVec3,
    /// Number of diffuse bounces between the camera ray and the point.
    pub depth: u8,
    /// Maximum error of a radiosity sample that may be reused, as `error_bound`.
    pub error_bound: f64,
}

/// Cache of radiosity samples after any number of diffuse bounces, in grids by position.
#[derive(Debug, Default)]
pub struct RadiosityCache {
    samples: Vec<Sample>,
    /// Indices of the radiosity samples in each cell; the key is the number of bounces, the exponent of the grid's cell
    /// width, and the cell.
    cells: FxHashMap<(u8, i16, [i32; 3]), SmallVec<[u32; 4]>>,
    /// Exponents of the cell widths of the grids of each depth, in ascending order.
    grids: Vec<Vec<i16>>,
    /// Largest `error_bound` of a query, by which a sample's radius is multiplied to get its sphere of influence.
    reach: f64,
}

impl RadiosityCache {
    /// Creates an empty cache for queries with this `error_bound` or less.
    pub fn new(error_bound: f64) -> Self {
        Self { reach: error_bound, ..Self::default() }
    }

    /// Returns the number of radiosity samples in the cache.
    pub fn len(&self) -> usize {
        self.samples.len()
    }

    /// Returns the samples in the order of their insertion.
    pub fn samples(&self) -> &[Sample] {
        &self.samples
    }

    /// Removes all radiosity samples from the cache.
    pub fn clear(&mut self) {
        if !self.samples.is_empty() {
            self.take_samples();
        }
    }

    /// Removes all samples and returns them, in the order of their insertion.
    pub fn take_samples(&mut self) -> Vec<Sample> {
        self.cells.clear();
        self.grids.clear();
        std::mem::take(&mut self.samples)
    }

    /// Inserts a radiosity sample into the cache; drops it if the cache is full or a number is not finite.
    pub fn insert(&mut self, sample: Sample) {
        if self.samples.len() >= MAX_SAMPLES || !sample.light.is_finite() || !sample.point.is_finite() {
            return;
        }
        let number = self.samples.len() as u32;
        let reach = (sample.radius * self.reach).min(MAX_REACH);
        let grid = cell_width_exponent(2.0 * reach);
        let depth = usize::from(sample.depth);
        if self.grids.len() <= depth {
            self.grids.resize(depth + 1, vec![]);
        }
        let grids = &mut self.grids[depth];
        if let Err(at) = grids.binary_search(&grid) {
            grids.insert(at, grid);
        }
        let (low, high) = (cell(sample.point - reach, grid), cell(sample.point + reach, grid));
        for x in low[0]..=high[0] {
            for y in low[1]..=high[1] {
                for z in low[2]..=high[2] {
                    self.cells.entry((sample.depth, grid, [x, y, z])).or_default().push(number);
                }
            }
        }
        self.samples.push(sample);
    }

    /// Adds to `blend` all radiosity samples of the cache that may be reused for the query, each with its weight.
    pub fn add_to(&self, query: &Query, blend: &mut Blend) {
        let Some(grids) = self.grids.get(usize::from(query.depth)) else { return };
        let inverse_bound = 1.0 / query.error_bound;
        for &grid in grids {
            let Some(cell) = self.cells.get(&(query.depth, grid, cell(query.point, grid))) else { continue };
            for &number in cell {
                let sample = &self.samples[number as usize];
                if let Some(weight) = weight(sample, query, inverse_bound) {
                    blend.light += weight * sample.light;
                    blend.weight += weight;
                    blend.count += 1;
                }
            }
        }
    }
}

/// Returns the weight with which a radiosity sample is reused at a point: it falls to 0 at the maximum error; `None`
/// beyond.
fn weight(sample: &Sample, query: &Query, inverse_error_bound: f64) -> Option<f64> {
    let between = query.point - sample.point;
    let distance2 = between.length_squared();
    let reach = sample.radius * query.error_bound;
    if distance2 >= reach * reach {
        return None;
    }
    let cos = sample.normal.dot(query.normal);
    // Reject samples in front of the point, which light from other surfaces reaches.
    if cos < MIN_COSINE || between.dot(sample.normal + query.normal) < -2.0 * MAX_IN_FRONT * sample.radius {
        return None;
    }
    let error = distance2.sqrt() / sample.radius + (1.0 - cos).max(0.0).sqrt();
    // The sample itself has no error: a lower limit keeps the weight finite.
    let weight = 1.0 / error.max(1e-6) - inverse_error_bound;
    (weight > 0.0).then_some(weight)
}

/// Returns the exponent of the least power of 2 that is greater than `width`, within limits: the cell width of the grid
/// for a sample.
fn cell_width_exponent(width: f64) -> i16 {
    let exponent = ((width.to_bits() >> 52) & 0x7ff) as i16 - 1023;
    exponent.clamp(-300, 1000) + 1
}

/// Returns the cell of a grid that contains a point. Cells far from the origin are clamped to the last ones.
fn cell(p: DVec3, exponent: i16) -> [i32; 3] {
    let per_cell = f64::from_bits(((1023 - i64::from(exponent)) as u64) << 52);
    // (`as` clamps.)
    (p * per_cell).floor().to_array().map(|x| x.clamp(-1e9, 1e9) as i32)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn sample(x: f64, light: f64, radius: f64) -> Sample {
        Sample { point: DVec3::new(x, 0.0, 0.0), normal: DVec3::Y, light: Rgb::splat(light), radius, depth: 0 }
    }

    fn mean_at(cache: &RadiosityCache, x: f64, normal: DVec3) -> Option<f64> {
        let query = Query { point: DVec3::new(x, 0.0, 0.0), normal, depth: 0, error_bound: 0.5 };
        let mut blend = Blend::default();
        cache.add_to(&query, &mut blend);
        blend.mean().map(|light| light.x)
    }

    #[test]
    fn samples_are_found_within_their_reach_only() {
        for radius in [1e-9, 0.3, 1.0, 7.5, 1e9] {
            let mut cache = RadiosityCache::new(0.5);
            cache.insert(sample(0.0, 3.0, radius));
            for at in [-0.499, -0.3, 0.0, 0.1, 0.499] {
                let mean = mean_at(&cache, at * radius, DVec3::Y);
                assert!(mean.is_some_and(|mean| (mean - 3.0).abs() < 1e-12), "{radius} {at}: {mean:?}");
            }
            assert_eq!(mean_at(&cache, 0.51 * radius, DVec3::Y), None);
            assert_eq!(mean_at(&cache, 0.0, -DVec3::Y), None);
        }
    }

    #[test]
    fn nearer_samples_have_more_weight() {
        let mut cache = RadiosityCache::new(0.5);
        cache.insert(sample(0.0, 1.0, 10.0));
        cache.insert(sample(4.0, 2.0, 10.0));
        let middle = mean_at(&cache, 2.0, DVec3::Y).unwrap_or_default();
        assert!((middle - 1.5).abs() < 1e-12);
        assert!(mean_at(&cache, 1.0, DVec3::Y).is_some_and(|light| light < 1.5));
    }
}
