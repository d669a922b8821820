//! Media between surfaces: the interior of shapes, and particles that absorb, emit and scatter light. One file a medium.

mod interior;
mod media;
mod scattering;

pub use interior::{INTERIOR, Interior};
pub use media::{MEDIA, Media, MediaSampling, SamplingMethod};
pub use scattering::{Phase, SCATTERING, Scattering};
