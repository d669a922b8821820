//! `media { … }`: particles that absorb, emit and scatter light (manual, "Media").
//!
//! ```pov
//! sphere {
//!   0, 1
//!   pigment { rgbt 1 }
//!   hollow
//!   interior { media { emission 0.5 density { spherical } } }
//! }
//! ```

use super::scattering::Scattering;
use crate::color::Rgb;
use crate::diagnostic::{Diagnostic, Result, codes};
use crate::math::Transform;
use crate::source::Span;
use crate::texture::Density;
use crate::value::ValueKind::{Block, Color, Flag, Float};
use crate::value::words::{Row, joined, read_row, set, specs, word};
use crate::value::{Next, Reader, ReaderExt, Spec, Thing, WordSpec};
use serde::Serialize;

/// Method by which a medium is sampled along a ray.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum SamplingMethod {
    /// Sampling method 1 of media: random points along the ray.
    Random,
    /// Sampling method 2 of media: points at equal distances along the ray.
    Even,
    /// Sampling method 3 of media: points at equal distances along the ray, and more of them where the light changes.
    Adaptive,
}

/// Parameters of the sampling of a medium along a ray.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct MediaSampling {
    /// Method by which the medium is sampled along a ray.
    pub method: SamplingMethod,
    /// Number of intervals into which a stretch of the ray is divided.
    pub intervals: u32,
    /// Minimum number of samples of an interval.
    pub min_samples: u32,
    /// Maximum number of samples of an interval, for methods 1 and 2.
    pub max_samples: u32,
    /// Probability with which the mean of the samples must have the variance, for methods 1 and 2; below 1.
    pub confidence: f64,
    /// Variance of the mean below which no further samples are taken, for methods 1 and 2.
    pub variance: f64,
    /// Share of the intervals for the parts of a ray that spotlights and cylinder lights illuminate.
    pub ratio: f64,
    /// Random offset of samples, relative to their distance.
    pub jitter: f64,
    /// Maximum depth of halving for method 3, at least 1.
    pub aa_level: u32,
    /// Difference of two samples, summed over the channels, above which method 3 takes another one between them.
    pub aa_threshold: f64,
}

impl MediaSampling {
    /// Returns the default parameters; with `random_method`, those before version 3.5 (quirk: `media_defaults`).
    pub fn new(random_method: bool) -> Self {
        Self {
            method: if random_method { SamplingMethod::Random } else { SamplingMethod::Adaptive },
            intervals: if random_method { 10 } else { 1 },
            min_samples: if random_method { 1 } else { 10 },
            max_samples: if random_method { 1 } else { 10 },
            confidence: 0.9,
            variance: 1.0 / 128.0,
            ratio: 0.9,
            jitter: 0.0,
            aa_level: 3,
            aa_threshold: 0.1,
        }
    }
}

/// A medium: particles between surfaces.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Media {
    /// Light that is absorbed per world unit at density 1.
    pub absorption: Rgb,
    /// Light that is emitted per world unit at density 1.
    pub emission: Rgb,
    /// Scattering of light by the medium: colour, phase function and extinction.
    pub scattering: Scattering,
    /// Densities whose product is the medium's; without one, the density is 1.
    pub densities: Vec<Density>,
    /// Parameters of the sampling along rays.
    pub sampling: MediaSampling,
    /// True if the medium neither stores nor shows photons (`collect off`).
    pub ignores_photons: bool,
    /// Span of the `media` block in the scene.
    #[serde(skip)]
    pub source: Span,
}

impl Thing for Media {
    fn kind(&self) -> &'static str {
        "media"
    }
}

/// Words of a `media` block, and how each is read.
const MEDIA_ROWS: &[Row<Media>] = &[
    word("absorption", Color, "0", "how much light is taken away on each unit of the way")
        .sets(|s, r| set(&mut s.absorption, r.color().map(|c| c.rgb))),
    word("emission", Color, "0", "how much light the particles send out themselves")
        .sets(|s, r| set(&mut s.emission, r.color().map(|c| c.rgb))),
    word("method", Float, "3", "1 samples at random places, 2 evenly, 3 more where it changes")
        .sets(|s, r| set(&mut s.sampling.method, read_method(r))),
    word("intervals", Float, "1", "into how many parts a ray's way is divided")
        .sets(|s, r| set(&mut s.sampling.intervals, read_count("intervals", r))),
    word("samples", Float, "10", "the number of samples of each interval; a second number is the maximum").sets(
        |s, r| {
            s.sampling.min_samples = read_count("samples", r)?;
            let at = r.span();
            let most = r.optional_float()?.map(|most| checked_count("samples", most, at)).transpose()?;
            s.sampling.max_samples = most.unwrap_or(0).max(s.sampling.min_samples);
            Ok(())
        },
    ),
    word("confidence", Float, "0.9", "methods 1 and 2: how sure the mean is to have the `variance`")
        .sets(|s, r| set(&mut s.sampling.confidence, read_confidence(r))),
    word("variance", Float, "0.0078125", "methods 1 and 2: how much the mean may vary")
        .sets(|s, r| set(&mut s.sampling.variance, r.float())),
    word("ratio", Float, "0.9", "the share of intervals where spotlights and cylinder lights shine")
        .sets(|s, r| set(&mut s.sampling.ratio, r.float().map(|ratio| ratio.clamp(0.0, 1.0)))),
    word("jitter", Float, "0", "moves samples at random, by up to this part of their distance")
        .sets(|s, r| set(&mut s.sampling.jitter, r.float())),
    word("aa_level", Float, "3", "method 3: how often a stretch is halved, 1 or more")
        .sets(|s, r| set(&mut s.sampling.aa_level, read_count("aa_level", r))),
    word("aa_threshold", Float, "0.1", "method 3: the difference above which a stretch is halved")
        .sets(|s, r| set(&mut s.sampling.aa_threshold, read_aa_threshold(r))),
    word("collect", Flag, "on", "whether photons are stored in it")
        .sets(|s, r| set(&mut s.ignores_photons, r.flag().map(|collects| !collects))),
];

/// Parts of a `media` block with braces of their own.
const MEDIA_PARTS: &[WordSpec] = &[
    word("scattering", Block, "", "light that the particles redirect"),
    word("density", Block, "1", "where the particles are; several multiply"),
];

/// Description of the block `media { … }`.
pub const MEDIA: Spec = Spec {
    name: "media",
    summary: "smoke, fire, dust, haze: particles that absorb, emit and scatter light; the object around it needs `hollow`",
    words: &joined::<{ MEDIA_ROWS.len() + MEDIA_PARTS.len() }>(specs!(MEDIA_ROWS), MEDIA_PARTS),
    has_transforms: true,
    ..Spec::EMPTY
};

impl Media {
    /// Reads the items of a `media` block; `source` is the span of the block.
    ///
    /// # Errors
    /// A diagnostic at the first item that is not understood.
    pub fn read(r: &mut dyn Reader, source: Span) -> Result<Self> {
        let mut media = match r.take_declared::<Media>()? {
            Some(declared) => (*declared).clone(),
            None => Self {
                absorption: Rgb::ZERO,
                emission: Rgb::ZERO,
                scattering: Scattering::default(),
                densities: vec![],
                sampling: MediaSampling::new(r.language().random_media),
                ignores_photons: false,
                source,
            },
        };
        media.source = source;
        loop {
            match r.peek_next()? {
                Next::End => return Ok(media),
                next if read_row(MEDIA_ROWS, &mut media, next, r)? => {}
                Next::Block("scattering") => {
                    r.take_token()?;
                    media.scattering = Scattering::read(r)?;
                    r.leave_block()?;
                }
                Next::Block("density") => {
                    r.take_token()?;
                    media.densities.push(Density::read(r)?);
                    r.leave_block()?;
                }
                next if next.is_transform() => {
                    if let Some(step) = r.transform()? {
                        media.transform(&step);
                    }
                }
                _ => return Err(r.unknown_word_in(&MEDIA)),
            }
        }
    }

    /// Transforms the density patterns of the medium.
    pub fn transform(&mut self, by: &Transform) {
        self.densities.iter_mut().for_each(|density| density.transform(by));
    }
}

/// Reads a number of intervals, samples or halvings.
fn read_count(word: &str, r: &mut dyn Reader) -> Result<u32> {
    let (at, number) = (r.span(), r.float()?);
    checked_count(word, number, at)
}

fn checked_count(word: &str, number: f64, at: Span) -> Result<u32> {
    if !(1.0..1e6).contains(&number) {
        let message = format!("`{word}` is {number}; it goes from 1 to 999999");
        return Diagnostic::err(codes::BAD_ARGUMENT, at, message);
    }
    Ok(number as u32)
}

/// Reads the value of `confidence`, a probability below 1.
fn read_confidence(r: &mut dyn Reader) -> Result<f64> {
    let (at, number) = (r.span(), r.float()?);
    if number < 1.0 {
        return Ok(number.max(0.0));
    }
    Diagnostic::err(codes::BAD_ARGUMENT, at, format!("`confidence` is {number}; it is below 1"))
}

/// Reads the value of `aa_threshold`, a difference of samples above 0.
fn read_aa_threshold(r: &mut dyn Reader) -> Result<f64> {
    let (at, number) = (r.span(), r.float()?);
    if number > 0.0 {
        return Ok(number);
    }
    Diagnostic::err(codes::BAD_ARGUMENT, at, format!("`aa_threshold` is {number}; it is above 0"))
}

fn read_method(r: &mut dyn Reader) -> Result<SamplingMethod> {
    let (at, number) = (r.span(), r.float()?);
    match number as i64 {
        1 => Ok(SamplingMethod::Random),
        2 => Ok(SamplingMethod::Even),
        3 => Ok(SamplingMethod::Adaptive),
        _ => Diagnostic::err(codes::BAD_ARGUMENT, at, format!("there is no method {number}; there are 1, 2 and 3")),
    }
}
