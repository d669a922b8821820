//! The words of `light_source`: what the reader obeys and the manual lists.

use super::{Light, finite};
use crate::value::Kind::{Float, Nothing};
use crate::value::Vocabulary;
use crate::value::words::{Row, set, specs, word};

/// How [`LIGHT`]'s words are read.
pub(super) const LIGHT_ROWS: &[Row<Light>] = &[
    word("shadowless", Nothing, "", "it casts no shadows and makes no highlights")
        .sets(|s, _| set(&mut s.shadowless, Ok(true))),
    word("fade_distance", Float, "0", "the distance at which it has its full colour; 0: it does not fade")
        .sets(|s, r| set(&mut s.fade_distance, finite(r))),
    word("fade_power", Float, "0", "how fast it fades: 2 is as in nature; 0: it does not fade")
        .sets(|s, r| set(&mut s.fade_power, finite(r))),
];

/// `light_source { place, colour … }`
pub const LIGHT: Vocabulary = Vocabulary {
    block: "light_source",
    summary: "a point of light: `light_source { place, colour … }`; the point itself is not seen",
    words: specs!(LIGHT_ROWS),
    moves: true,
    idle: &[],
    not_drawn: &[
        "spotlight",
        "cylinder",
        "parallel",
        "area_light",
        "point_at",
        "radius",
        "falloff",
        "tightness",
        "looks_like",
        "projected_through",
        "media_interaction",
        "media_attenuation",
        "adaptive",
        "jitter",
        "circular",
        "orient",
        "photons",
    ],
};
