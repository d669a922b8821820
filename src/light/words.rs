//! The words of `light_source`: what the reader obeys and the manual lists.

use crate::value::Kind::{Float, Nothing};
use crate::value::Vocabulary;
use crate::value::words::word;

/// `light_source { place, colour … }`
pub const LIGHT: Vocabulary = Vocabulary {
    block: "light_source",
    summary: "a point of light: `light_source { place, colour … }`; the point itself is not seen",
    words: &[
        word("shadowless", Nothing, "", "it casts no shadows and makes no highlights"),
        word("fade_distance", Float, "0", "the distance at which it has its full colour; 0: it does not fade"),
        word("fade_power", Float, "0", "how fast it fades: 2 is as in nature; 0: it does not fade"),
    ],
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
