//! Where a pattern lies: transforms and warps in the order in which they are written, then `turbulence` (manual, "Pattern
//! Modifiers").

use super::{Turbulent, Warp};
use crate::math::{DVec3, Transform};
use crate::value::SharedDefault;
use serde::Serialize;

/// From the space around a pattern to its own.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
pub struct Space {
    /// What was written first, with its warps; mostly there are none.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub inner: Vec<Step>,
    /// The transforms behind the last warp.
    pub transform: SharedDefault<Transform>,
    /// `turbulence`, nearest to the pattern wherever it stands.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub turbulence: Option<Box<Turbulent>>,
}

/// One of the steps that move a point.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Step {
    /// By a matrix.
    Moved(Transform),
    /// By anything else.
    Warped(Warp),
}

impl Space {
    /// Moves the pattern after all it has been moved before.
    pub fn then(&mut self, by: &Transform) {
        self.transform = self.transform.then(by).into();
    }

    /// Adds a warp, which moves along with transforms that come later.
    pub fn warp(&mut self, warp: Warp) {
        if !self.transform.is_identity() {
            self.inner.push(Step::Moved(*std::mem::take(&mut self.transform)));
        }
        self.inner.push(Step::Warped(warp));
    }

    /// The `turbulence` words, to be changed.
    pub fn turbulence_mut(&mut self) -> &mut Turbulent {
        self.turbulence.get_or_insert_default()
    }

    /// A normal of the space around, in the pattern's own: transposed matrices turn it, warps do not.
    pub fn normal_inside(&self, n: DVec3) -> DVec3 {
        self.inner.iter().rev().fold(self.transform.inverse_normal(n), |n, step| match step {
            Step::Moved(transform) => transform.inverse_normal(n),
            Step::Warped(_) => n,
        })
    }

    /// A normal of the pattern's own space, in the space around.
    pub fn normal_outside(&self, n: DVec3) -> DVec3 {
        let n = self.inner.iter().fold(n, |n, step| match step {
            Step::Moved(transform) => transform.normal(n),
            Step::Warped(_) => n,
        });
        self.transform.normal(n)
    }

    /// Does it leave all points where they are?
    pub fn is_plain(&self) -> bool {
        self.inner.is_empty() && self.turbulence.is_none() && self.transform.is_identity()
    }
}
