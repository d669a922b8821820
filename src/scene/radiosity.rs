//! `radiosity { … }` of `global_settings` (manual, "Radiosity").

use super::{LightKind, SavedLight};
use crate::diagnostic::{Diagnostic, Result, codes};
use crate::source::Span;
use crate::value::ValueKind::{Flag, Float, Text};
use crate::value::ranges::{in_range, not_negative, positive, positive_up_to_one, whole_from_one};
use crate::value::words::{Row, read_row, set, specs, word};
use crate::value::{Next, Reader, ReaderExt, Spec};
use serde::Serialize;

/// Maximum number of directions of one radiosity sample.
const MAX_COUNT: u32 = 1_000_000;

/// Default of `minimum_reuse`.
const MINIMUM_REUSE: f64 = 0.015;
/// Default of `maximum_reuse`.
const MAXIMUM_REUSE: f64 = 0.2;

/// Settings of radiosity: diffuse light that surfaces receive from other surfaces and the sky.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Radiosity {
    /// Importance below which no light is gathered.
    pub adc_bailout: f64,
    /// True if pixels of the final picture gather light where too few samples are near.
    pub always_sample: bool,
    /// Factor of gathered light at each bounce.
    pub brightness: f64,
    /// Number of rays of a sample.
    pub count: u32,
    /// Size of the pool of directions, of which each sample uses `count`; `None` if all samples use the same
    /// directions.
    pub pool: Option<u32>,
    /// Maximum error of a sample that is reused, relative to the radius of the sample.
    pub error_bound: f64,
    /// Share of the gathered light's saturation that is removed, from 0 to 1.
    pub gray_threshold: f64,
    /// Factor of `error_bound` while samples are collected.
    pub low_error_factor: f64,
    /// Maximum of the largest channel of a ray's light; no limit unless positive.
    pub max_sample: f64,
    /// Maximum radius of a sample, as a share of its distance from the camera; `None` if the scene states none. See
    /// [`Radiosity::reuse_radius_per_distance`].
    pub maximum_reuse: Option<f64>,
    /// Minimum radius of a sample, as a share of its distance from the camera; `None` if the scene states none. See
    /// [`Radiosity::reuse_radius_per_distance`].
    pub minimum_reuse: Option<f64>,
    /// True if rays that gather light show fog and media.
    pub media: bool,
    /// Minimum number of samples that are blended.
    pub nearest_count: u32,
    /// True if bumps change the directions of gathered light.
    pub normal: bool,
    /// Distance of the pixels of the first pass, as a share of the picture's width.
    pub pretrace_start: f64,
    /// Distance of the pixels of the last pass, as a share of the picture's width.
    pub pretrace_end: f64,
    /// Maximum number of diffuse bounces.
    pub recursion_limit: u32,
    /// True for `radiosity { subsurface on }`: rays that gather light show subsurface light transport.
    pub subsurface: bool,
    /// True if `finish { ambient }` has an effect beside radiosity, as in scenes for versions before 3.7.
    pub keeps_ambient: bool,
    /// Files that the radiosity samples are loaded from or saved to (`load_file`, `save_file`).
    #[serde(skip)]
    pub saved: SavedLight,
    /// Span of the word `radiosity` in `global_settings`.
    #[serde(skip)]
    pub source: Span,
}

impl Default for Radiosity {
    fn default() -> Self {
        Self {
            adc_bailout: 0.01,
            always_sample: false,
            brightness: 1.0,
            count: 35,
            pool: None,
            error_bound: 1.8,
            gray_threshold: 0.0,
            low_error_factor: 0.5,
            max_sample: 0.0,
            maximum_reuse: None,
            minimum_reuse: None,
            media: false,
            nearest_count: 5,
            normal: false,
            pretrace_start: 0.08,
            pretrace_end: 0.04,
            recursion_limit: 2,
            subsurface: false,
            keeps_ambient: false,
            saved: SavedLight::default(),
            source: Span::NONE,
        }
    }
}

/// Words of the `radiosity` block of `global_settings`, and how each is read.
const ROWS: &[Row<Radiosity>] = &[
    word("adc_bailout", Float, "0.01", "importance below which no light is gathered")
        .sets(|s, r| set(&mut s.adc_bailout, positive("adc_bailout", r))),
    word("always_sample", Flag, "off", "the final picture gathers light, too, where too few samples are near")
        .sets(|s, r| set(&mut s.always_sample, r.flag())),
    word("brightness", Float, "1", "factor of gathered light at each bounce")
        .sets(|s, r| set(&mut s.brightness, positive("brightness", r))),
    word("count", Float, "35", "number of rays of a sample; a second number: how many directions to choose from")
        .sets(Radiosity::read_direction_count),
    word("error_bound", Float, "1.8", "how far samples are reused: less is slower and more accurate")
        .sets(|s, r| set(&mut s.error_bound, positive("error_bound", r))),
    word("gray_threshold", Float, "0", "share of the gathered light's saturation that is removed, from 0 to 1")
        .sets(|s, r| set(&mut s.gray_threshold, in_range("gray_threshold", 0.0..=1.0, r))),
    word("low_error_factor", Float, "0.5", "factor of `error_bound` while samples are collected")
        .sets(|s, r| set(&mut s.low_error_factor, positive("low_error_factor", r))),
    word("max_sample", Float, "no limit", "maximum brightness of the light of one ray; no limit unless positive")
        .sets(|s, r| set(&mut s.max_sample, r.float())),
    word("maximum_reuse", Float, "0.2", "maximum radius of a sample, as a share of its distance from the camera")
        .sets(|s, r| set(&mut s.maximum_reuse, positive("maximum_reuse", r).map(Some))),
    word("minimum_reuse", Float, "0.015", "minimum radius of a sample, as a share of its distance from the camera")
        .sets(|s, r| set(&mut s.minimum_reuse, not_negative("minimum_reuse", r).map(Some))),
    word("media", Flag, "off", "rays that gather light show fog and media").sets(|s, r| set(&mut s.media, r.flag())),
    word(
        "nearest_count",
        Float,
        "5",
        "number of samples to blend, 1 to 20; a second number, by which POV-Ray leaves out passes, has no effect",
    )
    .sets(Radiosity::read_nearest_count),
    word("normal", Flag, "off", "bumps change the directions of gathered light")
        .sets(|s, r| set(&mut s.normal, r.flag())),
    word("pretrace_start", Float, "0.08", "distance of the first pass's pixels, as a share of the picture's width")
        .sets(|s, r| set(&mut s.pretrace_start, positive_up_to_one("pretrace_start", r))),
    word("pretrace_end", Float, "0.04", "distance of the last pass's pixels, as a share of the picture's width")
        .sets(|s, r| set(&mut s.pretrace_end, positive_up_to_one("pretrace_end", r))),
    word("recursion_limit", Float, "2", "maximum number of diffuse bounces, 1 to 20")
        .sets(|s, r| set(&mut s.recursion_limit, whole_from_one("recursion_limit", 20, r))),
    word("subsurface", Flag, "off", "rays that gather light show `finish { subsurface }`")
        .sets(|s, r| set(&mut s.subsurface, r.flag())),
    word("load_file", Text, "", "file with samples to use in place of computing them")
        .sets(|s, r| s.saved.read_load_file(LightKind::Radiosity, r)),
    word("save_file", Text, "", "file to which the samples are saved")
        .sets(|s, r| s.saved.read_save_file(LightKind::Radiosity, r)),
];

/// Specification of the block `radiosity { … }` of `global_settings`.
pub const RADIOSITY: Spec = Spec {
    name: "radiosity",
    summary: "diffuse light that surfaces receive from other surfaces and the sky",
    words: specs!(ROWS),
    ..Spec::EMPTY
};

impl Radiosity {
    /// Reads a `radiosity` block from its opening to its closing brace.
    ///
    /// # Errors
    /// A diagnostic at the first item that is not understood or out of range.
    pub fn read_with_braces(r: &mut dyn Reader) -> Result<Self> {
        let at = r.span();
        let mut out = Self { source: at, ..Self::default() };
        r.take_token()?;
        loop {
            match r.peek_next()? {
                Next::End => {
                    out.check_ranges(at)?;
                    return r.leave_block().map(|_| out);
                }
                next if read_row(ROWS, &mut out, next, r)? => {}
                _ => return Err(r.unknown_word_in(&RADIOSITY)),
            }
        }
    }

    /// Returns the minimum and the maximum radius of a sample, as shares of its distance from the camera. If only one of
    /// them is stated, the other one is at least twice or at most half as large.
    pub fn reuse_radius_per_distance(&self) -> [f64; 2] {
        match (self.minimum_reuse, self.maximum_reuse) {
            (Some(minimum), Some(maximum)) => [minimum, maximum],
            (Some(minimum), None) => [minimum, MAXIMUM_REUSE.max(2.0 * minimum)],
            (None, Some(maximum)) => [MINIMUM_REUSE.min(maximum / 2.0), maximum],
            (None, None) => [MINIMUM_REUSE, MAXIMUM_REUSE],
        }
    }

    /// Checks settings that depend on each other.
    fn check_ranges(&self, at: Span) -> Result<()> {
        let [minimum, maximum] = self.reuse_radius_per_distance();
        if minimum >= maximum {
            return Diagnostic::err(codes::BAD_ARGUMENT, at, "`minimum_reuse` has to be less than `maximum_reuse`");
        }
        if self.pretrace_end > self.pretrace_start {
            let message = format!(
                "`pretrace_end` has to be at most `pretrace_start`, found {} and {}",
                self.pretrace_end, self.pretrace_start
            );
            return Diagnostic::err(codes::BAD_ARGUMENT, at, message);
        }
        Ok(())
    }

    fn read_direction_count(&mut self, r: &mut dyn Reader) -> Result<()> {
        self.count = whole_from_one("count", MAX_COUNT, r)?;
        let at = r.span();
        self.pool = r.optional_float()?.map(|pool| pool.clamp(0.0, f64::from(MAX_COUNT)) as u32);
        match self.pool {
            Some(pool) if pool < self.count => {
                let message = "the second number of `count` is at least the first: the directions to choose from";
                Diagnostic::err(codes::BAD_ARGUMENT, at, message)
            }
            _ => Ok(()),
        }
    }

    fn read_nearest_count(&mut self, r: &mut dyn Reader) -> Result<()> {
        self.nearest_count = whole_from_one("nearest_count", 20, r)?;
        let at = r.span();
        match r.optional_float()? {
            Some(count) if count > f64::from(self.nearest_count) => {
                Diagnostic::err(codes::BAD_ARGUMENT, at, "the second number of `nearest_count` is at most the first")
            }
            _ => Ok(()),
        }
    }
}
