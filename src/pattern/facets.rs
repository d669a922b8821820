//! `facets`: surfaces that are cut like a gem, for normals only (manual, "Facets").
//!
//! ```pov
//! sphere { 0, 1 pigment { color rgb 0.8 } normal { facets coords 0.4 scale 3 } }
//! ```

use super::crackle::{lowest, nearest};
use super::{Field, Readable, TextureContext, Words};
use crate::diagnostic::Result;
use crate::math::{DVec3, noise};
use crate::value::words::{Row, set, specs, word};
use crate::value::{Kind, Reader, Spec};
use serde::Serialize;

/// How large the facets are.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Cut {
    /// `coords`: cells of space, each with a normal that is turned at random so far.
    Coords(f64),
    /// `size`: normals that are alike become the same.
    Size(f64),
}

/// Flat pieces.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Facets {
    /// How large they are.
    pub cut: Cut,
    /// How distances are counted: 2 as usual.
    pub metric: f64,
}

impl Readable for Facets {
    const SPEC: Spec = Spec {
        name: "facets",
        summary: "surfaces that are cut like a gem; for normals only",
        params: &[],
        words: specs!(Self::WORDS),
    };

    const WORDS: &'static [Row<Self>] = &[
        word("coords", Kind::Float, "", "cells of space: how far normals turn")
            .sets(|s, r| set(&mut s.cut, r.float().map(Cut::Coords))),
        word("size", Kind::Float, "0.1", "for curved shapes: how large they are")
            .sets(|s, r| set(&mut s.cut, r.float().map(Cut::Size))),
        word("metric", Kind::Float, "2", "how distances are counted").sets(|s, r| set(&mut s.metric, r.float())),
    ];

    fn read(_: &mut dyn Reader) -> Result<Self> {
        Ok(Self { cut: Cut::Size(0.1), metric: 2.0 })
    }
}

impl Field for Facets {
    /// As a pigment it shows nothing.
    fn value(&self, _: &TextureContext) -> f64 {
        0.0
    }

    fn bumped(&self, at: &TextureContext, _: &Words, n: DVec3, _: f64) -> Option<DVec3> {
        let unit = n.normalize_or_zero();
        Some(match self.cut {
            Cut::Coords(turn) => {
                // a random vector for each cell, without its part along the normal
                let random = noise::noise_vector(nearest(at.p * 10.0, self.metric).site);
                unit + turn * (random - random.dot(unit) * unit)
            }
            // POV-Ray 3.7 adds the differences up with their signs, as was measured: near and far do not matter.
            Cut::Size(size) if self.metric == 1.0 => lowest(unit / size),
            Cut::Size(size) => nearest(unit / size, self.metric).site,
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::pattern::extreme_points;

    #[test]
    fn no_place_and_no_normal_is_too_strange() {
        for p in extreme_points() {
            let there = TextureContext::free(p, Default::default());
            for (cut, metric) in [(Cut::Coords(0.5), 2.0), (Cut::Size(0.1), 1.0), (Cut::Size(0.0), -3.0)] {
                let facets = Facets { cut, metric };
                for normal in [DVec3::Y, p] {
                    assert!(facets.bumped(&there, &Words::NONE, normal, 1.0).is_some());
                }
            }
        }
    }
}
