//! Functions made of a pigment, a pattern or a transform.

use crate::function::{Gives, Sampler};
use crate::math::{DVec3, Transform};
use crate::texture::Pigment;

/// `function { pigment { … } }`
#[derive(Debug)]
pub(super) struct PigmentSampler(pub(super) Pigment);

impl Sampler for PigmentSampler {
    fn arity(&self) -> usize {
        3
    }

    fn gives(&self) -> Gives {
        Gives::Color
    }

    fn sample(&self, p: &[f64]) -> [f64; 5] {
        self.0.at(DVec3::new(p[0], p[1], p[2])).to_array()
    }
}

/// `function { pattern { … } }`: a pigment without colours.
#[derive(Debug)]
pub(super) struct PatternSampler(pub(super) Pigment);

impl Sampler for PatternSampler {
    fn arity(&self) -> usize {
        3
    }

    fn gives(&self) -> Gives {
        Gives::Number
    }

    fn sample(&self, p: &[f64]) -> [f64; 5] {
        [self.0.number_at(DVec3::new(p[0], p[1], p[2])), 0.0, 0.0, 0.0, 0.0]
    }
}

/// `function { transform { … } }`
#[derive(Debug)]
pub(super) struct TransformSampler(pub(super) Transform);

impl Sampler for TransformSampler {
    fn arity(&self) -> usize {
        3
    }

    fn gives(&self) -> Gives {
        Gives::Vector(3)
    }

    fn sample(&self, p: &[f64]) -> [f64; 5] {
        let v = self.0.point(DVec3::new(p[0], p[1], p[2]));
        [v.x, v.y, v.z, 0.0, 0.0]
    }
}
