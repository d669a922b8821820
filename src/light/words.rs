//! Words of `light_source`, for the reader and the manual.

use super::area::AREA_ROWS;
use super::beam::BEAM_ROWS;
use super::{Light, read_finite};
use crate::value::ValueKind::{Block, Flag, Float, Nothing, Vector};
use crate::value::words::{Row, joined, set, specs, word};
use crate::value::{Spec, WordSpec};

/// Words of every light source, and how each is read.
pub(super) const LIGHT_ROWS: &[Row<Light>] = &[
    word("point_at", Vector, "<0, 0, 1>", "what beams and parallel light point at")
        .sets(|s, r| set(&mut s.point_at, r.vector())),
    word("parallel", Nothing, "", "all its light goes one way, as the sun's")
        .sets(|s, _| set(&mut s.parallel, Ok(true))),
    word("shadowless", Nothing, "", "it casts no shadows and makes no highlights")
        .sets(|s, _| set(&mut s.shadowless, Ok(true))),
    word("fade_distance", Float, "0", "the distance at which it has its full colour; 0: it does not fade")
        .sets(|s, r| set(&mut s.fade_distance, read_finite(r))),
    word("fade_power", Float, "0", "how fast it fades: 2 is as in nature; 0: it does not fade")
        .sets(|s, r| set(&mut s.fade_power, read_finite(r))),
    word("media_interaction", Flag, "on", "it illuminates media").sets(|s, r| set(&mut s.media_interaction, r.flag())),
    word("media_attenuation", Flag, "off", "fog and media attenuate it on its way")
        .sets(|s, r| set(&mut s.media_attenuation, r.flag())),
];

/// Words of a light source that have an object, which the scene reads: `looks_like` and `projected_through`.
const LIGHT_PARTS: &[WordSpec] = &[
    word(
        "looks_like",
        Block,
        "",
        "an object that is seen at its place and casts no shadow; that lies about the origin",
    ),
    word("projected_through", Block, "", "an object: only what passes it shines, and nothing before it is in the way"),
    word("photons", Block, "", "photons that the light emits at targets"),
];

const OWN: usize = LIGHT_ROWS.len() + BEAM_ROWS.len();

/// Description of `light_source { location, color … }`.
pub const LIGHT: Spec = Spec {
    name: "light_source",
    summary: "a light: `light_source { place, colour … }`; it is not seen itself",
    words: &joined::<{ OWN + AREA_ROWS.len() + LIGHT_PARTS.len() }>(
        &joined::<OWN>(specs!(LIGHT_ROWS), specs!(BEAM_ROWS)),
        &joined::<{ AREA_ROWS.len() + LIGHT_PARTS.len() }>(specs!(AREA_ROWS), LIGHT_PARTS),
    ),
    has_transforms: true,
    ..Spec::EMPTY
};
