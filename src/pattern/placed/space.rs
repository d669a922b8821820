//! The space of a pattern: transforms and warps in the order in which they are written, then `turbulence` (manual,
//! "Pattern Modifiers").

use super::TurbulenceParams;
use crate::math::{DVec3, Transform};
use crate::pattern::Warp;
use crate::value::SharedDefault;
use serde::Serialize;

/// Transforms, warps and turbulence between the outer space and the pattern's own.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
pub struct Space {
    /// The steps up to the last warp, in the order written; usually none.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub inner: Vec<Step>,
    /// The transforms after the last warp.
    pub transform: SharedDefault<Transform>,
    /// `turbulence`, which applies last to a point wherever it is written.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub turbulence: Option<Box<TurbulenceParams>>,
}

/// A step that moves a point.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Step {
    /// Moves the point by a matrix.
    Moved(Transform),
    /// Moves the point by a warp.
    Warped(Warp),
}

impl Space {
    /// Appends a transform of the pattern.
    pub fn then(&mut self, by: &Transform) {
        self.transform = self.transform.then(by).into();
    }

    /// Appends a warp, which later transforms move too.
    pub fn warp(&mut self, warp: Warp) {
        if !self.transform.is_identity() {
            self.inner.push(Step::Moved(*std::mem::take(&mut self.transform)));
        }
        self.inner.push(Step::Warped(warp));
    }

    /// The parameters of `turbulence`, to be changed.
    pub fn turbulence_mut(&mut self) -> &mut TurbulenceParams {
        self.turbulence.get_or_insert_default()
    }

    /// A normal of the outer space, in the pattern's own: transforms by transposed matrices; warps have no effect.
    pub fn normal_inside(&self, n: DVec3) -> DVec3 {
        self.inner.iter().rev().fold(self.transform.inverse_normal(n), |n, step| match step {
            Step::Moved(transform) => transform.inverse_normal(n),
            Step::Warped(_) => n,
        })
    }

    /// A normal of the pattern's own space, in the outer space.
    pub fn normal_outside(&self, n: DVec3) -> DVec3 {
        let n = self.inner.iter().fold(n, |n, step| match step {
            Step::Moved(transform) => transform.normal(n),
            Step::Warped(_) => n,
        });
        self.transform.normal(n)
    }

    /// True if no point moves.
    pub fn is_plain(&self) -> bool {
        self.inner.is_empty() && self.turbulence.is_none() && self.transform.is_identity()
    }
}
