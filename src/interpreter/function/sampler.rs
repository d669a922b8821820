//! Functions made from a pigment, a pattern or a transform.

use crate::function::{LocalBounds, ResultType, Sampler};
use crate::math::noise::NoiseGenerator;
use crate::math::{DVec3, Transform};
use crate::pattern::TextureContext;
use crate::texture::PigmentProgram;
use std::sync::Arc;
use std::sync::atomic::{AtomicU8, Ordering};

/// Number of the scene's noise generator, which may still change during the run.
pub(super) type SceneNoise = Arc<AtomicU8>;

fn context_without_surface(p: &[f64], noise: &SceneNoise) -> TextureContext {
    let generator = NoiseGenerator::from_number_modulo_4(f64::from(noise.load(Ordering::Relaxed)));
    TextureContext::without_surface(DVec3::new(p[0], p[1], p[2]), generator)
}

/// User-defined function `function { pigment { … } }`: the colour of a pigment at a point.
#[derive(Debug)]
pub(super) struct PigmentSampler(pub(super) PigmentProgram, pub(super) SceneNoise);

impl Sampler for PigmentSampler {
    fn arity(&self) -> usize {
        3
    }

    fn result_type(&self) -> ResultType {
        ResultType::Color
    }

    fn sample(&self, p: &[f64]) -> [f64; 5] {
        self.0.color_at(&context_without_surface(p, &self.1)).to_array()
    }

    fn value_bounds_near(&self, p: &[f64], radius: f64) -> [LocalBounds; 5] {
        self.0.color_bounds_near(&context_without_surface(p, &self.1), radius)
    }
}

/// User-defined function `function { pattern { … } }`: the value of a pattern at a point.
#[derive(Debug)]
pub(super) struct PatternSampler(pub(super) PigmentProgram, pub(super) SceneNoise);

impl Sampler for PatternSampler {
    fn arity(&self) -> usize {
        3
    }

    fn result_type(&self) -> ResultType {
        ResultType::Number
    }

    fn sample(&self, p: &[f64]) -> [f64; 5] {
        [self.sample_component(0, p), 0.0, 0.0, 0.0, 0.0]
    }

    fn sample_component(&self, component: usize, p: &[f64]) -> f64 {
        if component == 0 { self.0.pattern_number_at(&context_without_surface(p, &self.1)) } else { 0.0 }
    }

    fn value_bounds_near(&self, p: &[f64], radius: f64) -> [LocalBounds; 5] {
        [self.0.value_bounds_near(&context_without_surface(p, &self.1), radius); 5]
    }
}

/// User-defined function `function { transform { … } }`: a transformed point.
#[derive(Debug)]
pub(super) struct TransformSampler(pub(super) Transform);

impl Sampler for TransformSampler {
    fn arity(&self) -> usize {
        3
    }

    fn result_type(&self) -> ResultType {
        ResultType::Vector(3)
    }

    /// Returns the coordinates of the transformed point and two unused components, which are 0.
    fn sample(&self, p: &[f64]) -> [f64; 5] {
        let v = self.0.transform_point(DVec3::new(p[0], p[1], p[2]));
        [v.x, v.y, v.z, 0.0, 0.0]
    }
}
