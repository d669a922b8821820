//! Radiosity: diffuse light from other surfaces and the sky, gathered at few points and interpolated between them.
//!
//! `cache` holds the samples, `directions` their rays, `gather` computes samples and the light of surfaces. Preparation
//! passes collect samples; each work item reads the frozen cache of the passes before, and adds to a cache of its own. In
//! the final picture, each camera ray has its own cache, so that a pixel depends on no other pixel.

mod cache;
mod directions;
mod gather;
mod save;

pub use cache::Sample;

use crate::math::DVec3;
use crate::scene::Radiosity;
use cache::Query;
pub(super) use cache::RadiosityCache;
use directions::Directions;

/// Radiosity of a frame: settings and the samples of all finished passes.
#[derive(Debug)]
pub struct RadiosityState<'w> {
    settings: &'w Radiosity,
    /// Directions about z of the rays of a radiosity sample, one list for each number of diffuse bounces; or, with a
    /// pool, one list that all samples choose from.
    directions: Vec<Directions>,
    cache: RadiosityCache,
    /// Centre of the view, from which the limits of the radii are measured.
    eye: DVec3,
    /// Present pass, which decides how many radiosity samples a point needs and how large their errors may be.
    pass: RadiosityPass,
}

/// Pass of radiosity, which decides where new samples are collected and which existing ones are reused.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum RadiosityPass {
    /// Samples are collected where those within the reduced error bound are fewer or less close than `nearest_count` asks.
    Collect,
    /// Samples are collected where none is within the error bound; with `always_sample` where they are fewer or less close
    /// than `nearest_count` asks.
    FillGaps,
    /// Samples are read; those that are still missing serve one camera ray.
    Final,
}

/// Minimum number of rays of a sample after the first bounce.
const MIN_DEEPER_COUNT: u32 = 8;

/// Sum of 1 - error / maximum error that a single usable sample reaches.
const ANY_CLOSENESS: f64 = f64::MIN_POSITIVE;

/// Returns the number of rays that are traced for a radiosity sample after `bounces` diffuse bounces: `count`, halved at
/// each bounce, down to a minimum.
fn ray_count(settings: &Radiosity, bounces: u32) -> u32 {
    (settings.count >> bounces.min(31)).max(MIN_DEEPER_COUNT).min(settings.count)
}

impl<'w> RadiosityState<'w> {
    /// Creates the state before the first pass; `eye` is the camera's location.
    pub fn new(settings: &'w Radiosity, eye: DVec3) -> Self {
        Self {
            settings,
            directions: match settings.pool {
                Some(pool) => vec![Directions::new(pool)],
                None => {
                    (0..settings.recursion_limit).map(|depth| Directions::new(ray_count(settings, depth))).collect()
                }
            },
            cache: RadiosityCache::new(settings.error_bound),
            eye,
            pass: RadiosityPass::Collect,
        }
    }

    /// Starts a radiosity pass, whose rules for collecting and reusing samples then apply.
    pub fn begin_pass(&mut self, pass: RadiosityPass) {
        self.pass = pass;
    }

    /// True in the final pass, when all passes that collect radiosity samples are finished.
    pub fn is_final(&self) -> bool {
        self.pass == RadiosityPass::Final
    }

    /// Returns the number of radiosity samples that are collected so far.
    pub fn n_samples(&self) -> usize {
        self.cache.len()
    }

    /// Adds the radiosity samples that one work item has collected, except those at points for which other work items
    /// have collected enough.
    pub fn merge(&mut self, samples: Vec<Sample>) {
        for sample in samples {
            let query = self.query(sample.point, sample.normal, sample.depth);
            let wanted = self.wanted_closeness(sample.depth);
            if self.cache.closeness_up_to(wanted, &query) < wanted {
                self.cache.insert(sample);
            }
        }
    }

    /// Returns the directions from which a sample after `bounces` bounces chooses its rays.
    fn directions(&self, bounces: u8) -> &Directions {
        &self.directions[usize::from(bounces).min(self.directions.len() - 1)]
    }

    /// Returns the query for the radiosity samples near a point, with the maximum error of the present pass.
    fn query(&self, point: DVec3, normal: DVec3, bounces: u8) -> Query {
        // Errors after the first bounce average out over the rays of a sample.
        let is_tightened = self.pass == RadiosityPass::Collect && bounces == 0;
        let factor = if is_tightened { self.settings.low_error_factor.min(1.0) } else { 1.0 };
        Query { point, normal, depth: bounces, error_bound: self.settings.error_bound * factor }
    }

    /// Returns the sum of 1 - error / maximum error over the radiosity samples that may be reused at a point after
    /// `bounces` bounces, below which a new sample is computed in the present pass.
    fn wanted_closeness(&self, bounces: u8) -> f64 {
        match self.pass {
            RadiosityPass::FillGaps if !self.settings.always_sample => ANY_CLOSENESS,
            RadiosityPass::Final => ANY_CLOSENESS,
            // A quarter of `nearest_count`, and a quarter of that after each bounce
            RadiosityPass::Collect | RadiosityPass::FillGaps => {
                let divisor = (1_u64 << (2 * (u32::from(bounces) + 1))) as f64;
                f64::from(self.settings.nearest_count) / divisor
            }
        }
    }
}
