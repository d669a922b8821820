//! Cache of gathered light: samples with a radius, found by position (Ward, Rubinstein and Clear, A ray tracing solution
//! for diffuse interreflection, 1988).
//!
//! A sample is listed in all cells of a grid that its sphere of influence overlaps. The grid's cells are at least half as
//! wide as the sphere, so that a sample is in at most 27 cells, and a query reads one cell of each grid.

use crate::color::Rgb;
use crate::math::DVec3;
use rustc_hash::FxHashMap;
use smallvec::SmallVec;
use std::ops::ControlFlow;

/// Maximum number of radiosity samples in the cache; later samples are used once and dropped.
const MAX_SAMPLES: usize = 8 << 20;
/// Maximum radius of the sphere in which a radiosity sample may be reused, so that the sphere overlaps at most 27 cells
/// of the widest grid.
const MAX_REACH: f64 = 1e300;
/// Height of a sample above the tangent plane of a point, as a share of the distance between them, up to which the point
/// may use it.
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
    /// Distance to the nearest surface that the sample's rays hit, at most `radius`.
    pub nearest: f64,
    /// Direction to that surface, length 1; zero if the rays hit none.
    pub toward_nearest: DVec3,
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
    /// Sum over these samples of 1 - error / maximum error.
    pub closeness: f64,
}

impl Sample {
    /// True if the sample may be reused for the query.
    pub(super) fn is_usable_for(&self, query: &Query) -> bool {
        self.depth == query.depth && error_share(self, query).is_some()
    }

    /// Returns the sample's radius in the direction of the vector `to_point`, which has the length `distance`: the
    /// nearest surface limits it in the directions toward that surface, since light changes fast there.
    fn radius_along(&self, to_point: DVec3, distance: f64) -> f64 {
        let approach = to_point.dot(self.toward_nearest);
        if approach > 0.0 { self.radius + (self.nearest - self.radius) * (approach / distance) } else { self.radius }
    }
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

    /// Inserts a radiosity sample into the cache; drops it if the cache is full, or if its light or point is not
    /// finite.
    pub fn insert(&mut self, sample: Sample) {
        if self.samples.len() >= MAX_SAMPLES || !sample.light.is_finite() || !sample.point.is_finite() {
            return;
        }
        let number = self.samples.len() as u32;
        let reach = (sample.radius * self.reach).min(MAX_REACH);
        let grid = cell_width_exponent(reach);
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
    pub fn add_usable_samples_to(&self, query: &Query, blend: &mut Blend) {
        self.visit_usable_with_error_share(query, |sample, share| {
            // Tukey's biweight: the mean has no peaks at the samples.
            let root = 1.0 - share * share;
            let weight = root * root;
            blend.light += weight * sample.light;
            blend.weight += weight;
            blend.count += 1;
            blend.closeness += 1.0 - share;
            ControlFlow::Continue(())
        });
    }

    /// Returns the sum of 1 - error / maximum error over the radiosity samples that may be reused for the query, or only
    /// over the first of them whose sum is at least `limit`.
    pub fn closeness_up_to(&self, limit: f64, query: &Query) -> f64 {
        let mut sum = 0.0;
        self.visit_usable_with_error_share(query, |_, share| {
            sum += 1.0 - share;
            if sum >= limit { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
        });
        sum
    }

    /// Returns a radiosity sample that may be reused for the query; `None` if no sample may.
    pub fn any_usable_sample(&self, query: &Query) -> Option<&Sample> {
        let mut found = None;
        self.visit_usable_with_error_share(query, |sample, _| {
            found = Some(sample);
            ControlFlow::Break(())
        });
        found
    }

    /// Calls `visit` for the radiosity samples that may be reused for the query, each with its error as a share of the
    /// maximum error (from 0, the best, to below 1), until `visit` returns `Break`.
    #[inline]
    fn visit_usable_with_error_share<'s>(
        &'s self,
        query: &Query,
        mut visit: impl FnMut(&'s Sample, f64) -> ControlFlow<()>,
    ) {
        let Some(grids) = self.grids.get(usize::from(query.depth)) else { return };
        for &grid in grids {
            let Some(cell) = self.cells.get(&(query.depth, grid, cell(query.point, grid))) else { continue };
            for &number in cell {
                let sample = &self.samples[number as usize];
                if let Some(share) = error_share(sample, query)
                    && visit(sample, share).is_break()
                {
                    return;
                }
            }
        }
    }
}

/// Returns the error of a radiosity sample that is reused at a point, as a share of the maximum error; `None` from the
/// maximum on. The error is that of Ward et al. (1988), in which the term of the normals counts twice.
fn error_share(sample: &Sample, query: &Query) -> Option<f64> {
    let between = query.point - sample.point;
    let distance2 = between.length_squared();
    let reach = sample.radius * query.error_bound;
    if distance2 >= reach * reach {
        return None;
    }
    let distance = distance2.sqrt();
    // Reject samples in front of the point, which light from other surfaces reaches.
    if between.dot(sample.normal + query.normal) < -2.0 * MAX_IN_FRONT * distance {
        return None;
    }
    let cos = sample.normal.dot(query.normal);
    let error = distance / sample.radius_along(between, distance) + 2.0 * (1.0 - cos).max(0.0).sqrt();
    let share = error / query.error_bound;
    (share < 1.0).then_some(share)
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
    use crate::math::fp;

    fn sample(x: f64, light: f64, radius: f64) -> Sample {
        Sample {
            point: DVec3::new(x, 0.0, 0.0),
            normal: DVec3::Y,
            light: Rgb::splat(light),
            radius,
            nearest: radius,
            toward_nearest: DVec3::ZERO,
            depth: 0,
        }
    }

    fn mean_at(cache: &RadiosityCache, x: f64, normal: DVec3) -> Option<f64> {
        let query = Query { point: DVec3::new(x, 0.0, 0.0), normal, depth: 0, error_bound: 0.5 };
        let mut blend = Blend::default();
        cache.add_usable_samples_to(&query, &mut blend);
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

    /// Returns how far along x from the only sample of a cache a point with `normal` may be to use it.
    fn reach_along_x(sample: Sample, normal: DVec3, error_bound: f64) -> f64 {
        let mut cache = RadiosityCache::new(error_bound);
        cache.insert(sample);
        let is_used = |x: f64| {
            let query = Query { point: DVec3::new(x, 0.0, 0.0), normal, depth: 0, error_bound };
            let mut blend = Blend::default();
            cache.add_usable_samples_to(&query, &mut blend);
            blend.count > 0
        };
        (1..=1000).map(|i| f64::from(i) / 1000.0).take_while(|&x| is_used(x)).last().unwrap_or(0.0)
    }

    #[test]
    fn the_nearest_surface_limits_the_reach_toward_it() {
        // POV-Ray 3.7 reaches 0.0975, 0.149, 0.294 and 0.419 in these directions, and 0.489 with no surface near.
        for (degrees, reach) in [(0.0, 0.1), (30.0, 0.1536), (60.0, 0.3), (80.0, 0.4305), (180.0, 0.5)] {
            let (sin, cos) = fp::sin_cos(f64::to_radians(degrees));
            let near = Sample { nearest: 0.2, toward_nearest: DVec3::new(cos, sin, 0.0), ..sample(0.0, 1.0, 1.0) };
            assert!((reach_along_x(near, DVec3::Y, 0.5) - reach).abs() < 0.002, "{degrees}");
        }
    }

    #[test]
    fn other_normals_limit_the_reach() {
        // POV-Ray 3.7 reaches 0.653, 0.388 and 0.153 with these angles between the normals.
        for (degrees, reach) in [(9.1_f64, 0.676), (19.9, 0.411), (29.8, 0.173), (40.0, 0.0)] {
            let (sin, cos) = fp::sin_cos(degrees.to_radians());
            let tilted = Sample { normal: DVec3::new(sin, cos, 0.0), ..sample(0.0, 1.0, 1.0) };
            assert!((reach_along_x(tilted, DVec3::Y, 0.9) - reach).abs() < 0.003, "{degrees}");
        }
    }

    #[test]
    fn samples_in_front_of_a_point_are_not_used() {
        for (height, is_used) in [(-0.2, true), (0.0, true), (0.014, true), (0.016, false), (0.2, false)] {
            let mut cache = RadiosityCache::new(0.5);
            cache.insert(Sample { point: DVec3::new(0.0, height, 0.0), ..sample(0.0, 1.0, 1.0) });
            assert_eq!(mean_at(&cache, 0.3, DVec3::Y).is_some(), is_used, "{height}");
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
