//! The space of a pattern: transforms and warps in the order in which they are written, then `turbulence` (manual,
//! "Pattern Modifiers").

use super::TurbulenceParams;
use crate::math::{DVec3, Transform};
use crate::pattern::Warp;
use crate::value::SharedDefault;
use serde::Serialize;

/// Transforms, warps and turbulence between the outer space and a pattern's own space.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
pub struct Space {
    /// Steps of the pattern up to the last warp, in the order written; usually none.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub inner: Vec<Step>,
    /// Transforms of the pattern after the last warp.
    pub transform: SharedDefault<Transform>,
    /// Turbulence of the pattern, which applies last to a point wherever it is written.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub turbulence: Option<Box<TurbulenceParams>>,
}

/// Step that moves the point of a pattern.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Step {
    /// Step of a pattern that moves the point by a transform.
    Moved(Transform),
    /// Step of a pattern that moves the point by a warp.
    Warped(Warp),
}

impl Space {
    /// Appends a transform to the pattern's space.
    pub fn append_transform(&mut self, by: &Transform) {
        self.transform = self.transform.then(by).into();
    }

    /// Appends a warp to the pattern's space; later transforms move it too.
    pub fn append_warp(&mut self, warp: Warp) {
        if !self.transform.is_identity() {
            self.inner.push(Step::Moved(*std::mem::take(&mut self.transform)));
        }
        self.inner.push(Step::Warped(warp));
    }

    /// Returns the parameters of the pattern's `turbulence` for modification.
    pub fn turbulence_mut(&mut self) -> &mut TurbulenceParams {
        self.turbulence.get_or_insert_default()
    }

    /// Transforms a normal from the outer space to the pattern's space, by transposed matrices; warps have no effect.
    pub fn normal_to_pattern_space(&self, n: DVec3) -> DVec3 {
        self.inner.iter().rev().fold(self.transform.inverse_transform_normal(n), |n, step| match step {
            Step::Moved(transform) => transform.inverse_transform_normal(n),
            Step::Warped(_) => n,
        })
    }

    /// Transforms a normal from the pattern's space to the outer space.
    pub fn normal_from_pattern_space(&self, n: DVec3) -> DVec3 {
        let n = self.inner.iter().fold(n, |n, step| match step {
            Step::Moved(transform) => transform.transform_normal(n),
            Step::Warped(_) => n,
        });
        self.transform.transform_normal(n)
    }

    /// True if the pattern's space equals the outer space.
    pub fn is_identity(&self) -> bool {
        self.inner.is_empty() && self.turbulence.is_none() && self.transform.is_identity()
    }
}
