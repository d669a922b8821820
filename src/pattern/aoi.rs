//! `aoi`: the angle at which a ray meets the surface (manual, "Aoi Pattern").
//!
//! ```pov
//! sphere { 0, 1 pigment { aoi color_map { [0.5 color rgb <1, 0.5, 0>] [1 color rgb <0, 0, 0.5>] } } }
//! ```

use super::{Field, TextureContext};
use crate::diagnostic::Result;
use crate::math::fp;
use crate::value::{Readable, Reader, Spec};
use serde::Serialize;
use std::f64::consts::PI;

/// Pattern `aoi`, by the angle of incidence: from 0.5 where the ray grazes the surface to 1 where it is perpendicular.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Aoi {}

impl Readable for Aoi {
    const SPEC: Spec = Spec {
        name: "aoi",
        summary: "the angle at which the ray meets the surface: 0.5 grazing, 1 head on",
        ..Spec::EMPTY
    };

    fn read(_: &mut dyn Reader) -> Result<Self> {
        Ok(Self {})
    }
}

impl Field for Aoi {
    fn value(&self, at: &TextureContext) -> f64 {
        if !at.is_on_surface() {
            return 0.0;
        }
        1.0 - fp::acos(-at.normal.normalize_or_zero().dot(at.ray)) / PI
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::DVec3;

    #[test]
    fn head_on_and_grazing() {
        let ctx = TextureContext::without_surface(DVec3::ZERO, Default::default());
        let seen = |ray| Aoi {}.value(&TextureContext { normal: DVec3::Y, ray, ..ctx });
        assert_eq!(seen(DVec3::NEG_Y), 1.0);
        assert_eq!(seen(DVec3::X), 0.5);
    }
}
