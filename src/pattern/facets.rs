//! `facets`: surfaces cut like a gem, for normals only (manual, "Facets").
//!
//! ```pov
//! sphere { 0, 1 pigment { color rgb 0.8 } normal { facets coords 0.4 scale 3 } }
//! ```

use super::crackle::{least_coordinate_sum_site, nearest_sites};
use super::{Field, FieldParams, TextureContext};
use crate::diagnostic::Result;
use crate::math::{DVec3, noise};
use crate::value::words::{Row, set, specs, word};
use crate::value::{Readable, Reader, Spec, ValueKind};
use serde::Serialize;

/// Pattern `facets`: normals of a surface of flat pieces.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Facets {
    /// Strength of the random turn of the normal in each cell of space. At 0 there are no cells of space; instead
    /// similar normals become equal.
    pub coords: f64,
    /// Size of the cells of space in `facets`, or of the cells of normals.
    pub size: f64,
    /// Exponent of the metric of `facets`; 2 is Euclidean.
    pub metric: f64,
}

/// POV-Ray 3.7's replacement for a size of 0 in `facets` (quirk: facets_least_size).
const LEAST_SIZE: f64 = 1e-6;

impl Readable for Facets {
    const SPEC: Spec = Spec {
        name: "facets",
        summary: "surfaces that are cut like a gem; for normals only",
        words: specs!(Self::WORDS),
        ..Spec::EMPTY
    };

    const WORDS: &'static [Row<Self>] = &[
        word("coords", ValueKind::Float, "", "cells of space: how far normals turn")
            .sets(|s, r| set(&mut s.coords, r.float())),
        word("size", ValueKind::Float, "0.1", "for curved shapes: how large they are")
            .sets(|s, r| set(&mut s.size, r.float())),
        word("metric", ValueKind::Float, "2", "how distances are counted").sets(|s, r| set(&mut s.metric, r.float())),
    ];

    fn read(_: &mut dyn Reader) -> Result<Self> {
        Ok(Self { coords: 0.0, size: 0.1, metric: 2.0 })
    }
}

impl Field for Facets {
    /// Returns 0: as a pigment, the pattern `facets` is uniform.
    fn value(&self, _: &TextureContext) -> f64 {
        0.0
    }

    fn bumped_normal(&self, at: &TextureContext, _: &FieldParams, n: DVec3, _: f64) -> Option<DVec3> {
        let unit = n.normalize_or_zero();
        let size = if self.size > 0.0 { self.size } else { LEAST_SIZE };
        // With metric 1, POV-Ray 3.7 adds the signed differences (quirk: facets_signed_metric).
        let site = |p: DVec3| {
            if self.metric == 1.0 {
                least_coordinate_sum_site(p / size)
            } else {
                nearest_sites(p / size, self.metric).site
            }
        };
        if self.coords == 0.0 {
            return Some(site(unit));
        }
        // a random vector for each cell, projected into the tangent plane
        let random = noise::noise_vector(site(at.p));
        Some(unit + self.coords * (random - random.dot(unit) * unit))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::pattern::extreme_points;

    #[test]
    fn extreme_points_and_normals_do_not_panic() {
        for p in extreme_points() {
            let there = TextureContext::without_surface(p, Default::default());
            for (coords, size, metric) in [(0.5, 0.1, 2.0), (0.0, 0.1, 1.0), (0.0, 0.0, -3.0)] {
                let facets = Facets { coords, size, metric };
                for normal in [DVec3::Y, p] {
                    assert!(facets.bumped_normal(&there, &FieldParams::NONE, normal, 1.0).is_some());
                }
            }
        }
    }
}
