//! `radiosity { … }` of `global_settings` (manual, "Radiosity").

use crate::diagnostic::{Diagnostic, Result, codes};
use crate::source::Span;
use crate::value::ValueKind::{Flag, Float, Text};
use crate::value::words::{Row, read_row, set, specs, word};
use crate::value::{Next, Reader, ReaderExt, Spec};
use serde::Serialize;

/// Maximum number of directions of one radiosity sample.
const MAX_COUNT: f64 = 1e6;

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
    /// Number of directions from which each sample takes `count`; `None` if all samples use the same directions.
    pub pool: Option<u32>,
    /// Maximum error of a sample that is reused, relative to the radius of the sample.
    pub error_bound: f64,
    /// Share of the gathered light's saturation that is removed, from 0 to 1.
    pub gray_threshold: f64,
    /// Factor of `error_bound` while samples are collected.
    pub low_error_factor: f64,
    /// Maximum of the largest channel of a ray's light; no limit unless positive.
    pub max_sample: f64,
    /// Maximum radius of a sample, as a share of its distance from the camera.
    pub maximum_reuse: f64,
    /// Minimum radius of a sample, as a share of its distance from the camera.
    pub minimum_reuse: f64,
    /// True if rays that gather light show fog and media.
    pub media: bool,
    /// Minimum number of samples that are blended.
    pub nearest_count: u32,
    /// Number of samples at which a region of the picture is no longer refined; `None` to refine every region.
    pub adaptive_count: Option<u32>,
    /// True if bumps change the directions of gathered light.
    pub normal: bool,
    /// Distance of the pixels of the first pass, as a share of the picture's width.
    pub pretrace_start: f64,
    /// Distance of the pixels of the last pass, as a share of the picture's width.
    pub pretrace_end: f64,
    /// Maximum number of diffuse bounces.
    pub recursion_limit: u32,
    /// True if gathered light is scattered below surfaces.
    pub subsurface: bool,
    /// True if `finish { ambient }` has an effect beside radiosity, as in scenes for versions before 3.7.
    pub keeps_ambient: bool,
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
            maximum_reuse: 0.2,
            minimum_reuse: 0.015,
            media: false,
            nearest_count: 5,
            adaptive_count: None,
            normal: false,
            pretrace_start: 0.08,
            pretrace_end: 0.04,
            recursion_limit: 2,
            subsurface: false,
            keeps_ambient: false,
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
        .sets(Radiosity::read_count),
    word("error_bound", Float, "1.8", "how far samples are reused: less is slower and more accurate")
        .sets(|s, r| set(&mut s.error_bound, positive("error_bound", r))),
    word("gray_threshold", Float, "0", "share of the gathered light's saturation that is removed, from 0 to 1")
        .sets(|s, r| set(&mut s.gray_threshold, in_range("gray_threshold", [0.0, 1.0], r))),
    word("low_error_factor", Float, "0.5", "factor of `error_bound` while samples are collected")
        .sets(|s, r| set(&mut s.low_error_factor, positive("low_error_factor", r))),
    word("max_sample", Float, "no limit", "maximum brightness of the light of one ray; no limit unless positive")
        .sets(|s, r| set(&mut s.max_sample, r.float())),
    word("maximum_reuse", Float, "0.2", "maximum radius of a sample, as a share of its distance from the camera")
        .sets(|s, r| set(&mut s.maximum_reuse, positive("maximum_reuse", r))),
    word("minimum_reuse", Float, "0.015", "minimum radius of a sample, as a share of its distance from the camera")
        .sets(|s, r| set(&mut s.minimum_reuse, in_range("minimum_reuse", [0.0, f64::MAX], r))),
    word("media", Flag, "off", "rays that gather light show fog and media").sets(|s, r| set(&mut s.media, r.flag())),
    word(
        "nearest_count",
        Float,
        "5",
        "number of samples to blend, 1 to 20; a second number: the number at which a region is fine enough",
    )
    .sets(Radiosity::read_nearest_count),
    word("normal", Flag, "off", "bumps change the directions of gathered light")
        .sets(|s, r| set(&mut s.normal, r.flag())),
    word("pretrace_start", Float, "0.08", "distance of the first pass's pixels, as a share of the picture's width")
        .sets(|s, r| set(&mut s.pretrace_start, share("pretrace_start", r))),
    word("pretrace_end", Float, "0.04", "distance of the last pass's pixels, as a share of the picture's width")
        .sets(|s, r| set(&mut s.pretrace_end, share("pretrace_end", r))),
    word("recursion_limit", Float, "2", "maximum number of diffuse bounces, 1 to 20")
        .sets(|s, r| set(&mut s.recursion_limit, integer("recursion_limit", 20.0, r))),
    word("subsurface", Flag, "off", "gathered light is scattered below surfaces")
        .sets(|s, r| set(&mut s.subsurface, r.flag())),
    word("load_file", Text, "", "in old scenes: file of samples; has no effect").sets(|_, r| r.text().map(drop)),
    word("save_file", Text, "", "in old scenes: file of samples; has no effect").sets(|_, r| r.text().map(drop)),
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
    pub fn read(r: &mut dyn Reader) -> Result<Self> {
        let (mut out, at) = (Self::default(), r.span());
        r.take_token()?;
        loop {
            match r.next()? {
                Next::End => {
                    out.check_ranges(at)?;
                    return r.leave_block().map(|_| out);
                }
                next if read_row(ROWS, &mut out, next, r)? => {}
                _ => return Err(r.unknown_word_in(&RADIOSITY)),
            }
        }
    }

    /// Checks settings that depend on each other; a `minimum_reuse` or `maximum_reuse` that is stated alone adapts the other.
    fn check_ranges(&mut self, at: Span) -> Result<()> {
        let default = Self::default();
        if self.minimum_reuse > self.maximum_reuse / 2.0 {
            if self.maximum_reuse == default.maximum_reuse {
                self.maximum_reuse = self.minimum_reuse * 2.0;
            } else if self.minimum_reuse == default.minimum_reuse {
                self.minimum_reuse = self.maximum_reuse / 2.0;
            }
        }
        if self.minimum_reuse >= self.maximum_reuse {
            return Diagnostic::err(codes::BAD_ARGUMENT, at, "`minimum_reuse` has to be less than `maximum_reuse`");
        }
        if self.pretrace_end > self.pretrace_start {
            if self.pretrace_end == default.pretrace_end {
                self.pretrace_end = self.pretrace_start;
            } else if self.pretrace_start == default.pretrace_start {
                self.pretrace_start = self.pretrace_end;
            } else {
                return Diagnostic::err(codes::BAD_ARGUMENT, at, "`pretrace_end` is at most `pretrace_start`");
            }
        }
        Ok(())
    }

    fn read_count(&mut self, r: &mut dyn Reader) -> Result<()> {
        self.count = integer("count", MAX_COUNT, r)?;
        let at = r.span();
        self.pool = r.optional_float()?.map(|pool| pool.clamp(0.0, MAX_COUNT) as u32);
        match self.pool {
            Some(pool) if pool < self.count => {
                let message = "the second number of `count` is at least the first: the directions to choose from";
                Diagnostic::err(codes::BAD_ARGUMENT, at, message)
            }
            _ => Ok(()),
        }
    }

    fn read_nearest_count(&mut self, r: &mut dyn Reader) -> Result<()> {
        self.nearest_count = integer("nearest_count", 20.0, r)?;
        let at = r.span();
        self.adaptive_count = r.optional_float()?.map(|count| count.clamp(0.0, 1e9) as u32);
        match self.adaptive_count {
            Some(count) if count > self.nearest_count => {
                Diagnostic::err(codes::BAD_ARGUMENT, at, "the second number of `nearest_count` is at most the first")
            }
            _ => Ok(()),
        }
    }
}

fn out_of_range<T>(word: &str, range: &str, found: f64, at: Span) -> Result<T> {
    Diagnostic::err(codes::BAD_ARGUMENT, at, format!("`{word}` is {range}, found {found}"))
}

fn positive(word: &str, r: &mut dyn Reader) -> Result<f64> {
    let (at, value) = (r.span(), r.float()?);
    if value > 0.0 { Ok(value) } else { out_of_range(word, "more than 0", value, at) }
}

fn share(word: &str, r: &mut dyn Reader) -> Result<f64> {
    let (at, value) = (r.span(), r.float()?);
    if value > 0.0 && value <= 1.0 { Ok(value) } else { out_of_range(word, "more than 0 and at most 1", value, at) }
}

fn in_range(word: &str, [least, most]: [f64; 2], r: &mut dyn Reader) -> Result<f64> {
    let (at, value) = (r.span(), r.float()?);
    let range = if most == f64::MAX { "at least 0" } else { "between 0 and 1" };
    if value >= least && value <= most { Ok(value) } else { out_of_range(word, range, value, at) }
}

fn integer(word: &str, most: f64, r: &mut dyn Reader) -> Result<u32> {
    let (at, value) = (r.span(), r.float()?);
    let integer = value.floor();
    if integer >= 1.0 && integer <= most {
        Ok(integer as u32)
    } else {
        out_of_range(word, &format!("a whole number from 1 to {most}"), value, at)
    }
}
