//! `global_settings { photons { … } }` (manual, "Photon Global Settings").

use super::{LightKind, SavedLight};
use crate::diagnostic::Result;
use crate::source::Span;
use crate::value::ValueKind::{Float, Text};
use crate::value::ranges::positive;
use crate::value::words::{Row, read_row, set, specs, word};
use crate::value::{Next, Reader, ReaderExt, Spec};
use serde::Serialize;

/// Settings of the photon map.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct PhotonMapSettings {
    /// Distance between neighbouring photons at a target, in world units; 0 if none is stated. Without effect beside
    /// `count`.
    pub spacing: f64,
    /// Approximate number of photons to store; 0 if none is stated.
    pub count: f64,
    /// Minimum and maximum number of photons of one estimate.
    pub gather: [u32; 2],
    /// Maximum number of photons that one ray stores in a stretch of a medium; 0 for no photons in media.
    pub media_steps: u32,
    /// Factor of `spacing` along rays in media.
    pub media_factor: f64,
    /// Random displacement of the emitted photons, as a share of their distance.
    pub jitter: f64,
    /// Maximum number of reflections and refractions of a photon; `None` for that of rays.
    pub max_trace_level: Option<u32>,
    /// Weight below which a photon is not traced; `None` for that of rays.
    pub adc_bailout: Option<f64>,
    /// Share of a target's extent after which a ring of photons that misses the target ends the emission.
    pub autostop: f64,
    /// Maximum relative increase of the density by a wider search.
    pub max_increase: f64,
    /// Number of photons below which the wider search is used in any case.
    pub expand_min: u32,
    /// Radius of the search on surfaces and in media, in world units; 0 for a radius that fits the photons.
    pub radius: [f64; 2],
    /// Factor of the radius on surfaces and in media.
    pub radius_factor: [f64; 2],
    /// Files that the photons are loaded from or saved to (`load_file`, `save_file`).
    #[serde(skip)]
    pub saved: SavedLight,
    /// Span of the word `photons` in `global_settings`.
    #[serde(skip)]
    pub source: Span,
}

impl Default for PhotonMapSettings {
    fn default() -> Self {
        Self {
            spacing: 0.0,
            count: 0.0,
            gather: [20, 100],
            media_steps: 0,
            media_factor: 1.0,
            jitter: 0.4,
            max_trace_level: None,
            adc_bailout: None,
            autostop: 1.0,
            max_increase: 0.2,
            expand_min: 40,
            radius: [0.0; 2],
            radius_factor: [1.0; 2],
            saved: SavedLight::default(),
            source: Span::NONE,
        }
    }
}

/// Words of the block `photons` of `global_settings`, and how each is read.
const PHOTON_MAP_ROWS: &[Row<PhotonMapSettings>] = &[
    word("spacing", Float, "", "distance between neighbouring photons at a target, in world units")
        .sets(|s, r| set(&mut s.spacing, positive("spacing", r))),
    word("count", Float, "", "approximate number of photons, in place of `spacing`")
        .sets(|s, r| set(&mut s.count, positive("count", r))),
    word("gather", Float, "20, 100", "minimum and maximum number of photons of one estimate").sets(|s, r| {
        s.gather[0] = limited_count(r.float()?);
        s.gather[1] = r.optional_float()?.map_or(s.gather[1], limited_count);
        s.gather[1] = s.gather[1].max(s.gather[0]).max(1);
        Ok(())
    }),
    word("media", Float, "0", "maximum number of photons that a ray stores in a medium, and a factor of `spacing`")
        .sets(|s, r| {
            s.media_steps = limited_count(r.float()?);
            s.media_factor = r.optional_float()?.filter(|factor| *factor > 0.0).unwrap_or(s.media_factor);
            Ok(())
        }),
    word("jitter", Float, "0.4", "random displacement of the emitted photons, as a share of their distance")
        .sets(|s, r| set(&mut s.jitter, r.float().map(|jitter| jitter.clamp(0.0, 1.0)))),
    word("max_trace_level", Float, "that of rays", "maximum number of reflections and refractions of a photon")
        .sets(|s, r| set(&mut s.max_trace_level, r.float().map(|level| Some(level.clamp(1.0, 256.0) as u32)))),
    word("adc_bailout", Float, "that of rays", "minimum weight of a photon; fainter photons are not traced")
        .sets(|s, r| set(&mut s.adc_bailout, r.float().map(|weight| Some(weight.max(0.0))))),
    word("autostop", Float, "1", "share of a target after which a ring of photons that misses the target is the last")
        .sets(|s, r| set(&mut s.autostop, r.float().map(|share| share.clamp(0.0, 1.0)))),
    word(
        "expand_thresholds",
        Float,
        "0.2, 40",
        "maximum relative increase of the density by a wider search, and the number of photons below which that search \
         is used in any case",
    )
    .sets(|s, r| {
        s.max_increase = r.float()?.max(0.0);
        s.expand_min = r.optional_float()?.map_or(s.expand_min, limited_count);
        Ok(())
    }),
    word("radius", Float, "found by durer", "radius of the search and its factor, on surfaces and then in media").sets(
        |s, r| {
            for i in 0..2 {
                // (A comma before the first number means that durer finds the radius.)
                let is_left_out = i == 0 && r.peek_next_unless_separated()? == Next::End;
                let radius = if is_left_out { None } else { r.optional_float()? };
                s.radius[i] = radius.map_or(s.radius[i], |radius| radius.max(0.0));
                s.radius_factor[i] = r.optional_float()?.map_or(s.radius_factor[i], |factor| factor.max(0.0));
            }
            Ok(())
        },
    ),
    word("load_file", Text, "", "file with photons to use in place of computing them")
        .sets(|s, r| s.saved.read_load_file(LightKind::Photons, r)),
    word("save_file", Text, "", "file to which the photons are saved")
        .sets(|s, r| s.saved.read_save_file(LightKind::Photons, r)),
];

/// Specification of the block `photons { … }` of `global_settings`.
pub const PHOTON_MAP: Spec = Spec {
    name: "photons",
    summary: "photon map of the scene: caustics of targets",
    words: specs!(PHOTON_MAP_ROWS),
    ..Spec::EMPTY
};

impl PhotonMapSettings {
    /// Reads the block `photons` of `global_settings` from its opening to its closing brace.
    ///
    /// # Errors
    /// A diagnostic at the first item that is not understood.
    pub fn read_with_braces(r: &mut dyn Reader) -> Result<Self> {
        let mut this = Self { source: r.span(), ..Self::default() };
        r.take_token()?;
        loop {
            match r.peek_next()? {
                Next::End => return r.leave_block().map(|_| this),
                next if read_row(PHOTON_MAP_ROWS, &mut this, next, r)? => {}
                _ => return Err(r.unknown_word_in(&PHOTON_MAP)),
            }
        }
    }
}

/// Converts a number of the scene to a number of photons: rounded down, and limited to 0 … 1 000 000.
fn limited_count(number: f64) -> u32 {
    number.clamp(0.0, 1e6) as u32
}
