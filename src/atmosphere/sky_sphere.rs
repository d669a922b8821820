//! `sky_sphere { pigment { … } }`: pigments by direction (manual, "Sky Sphere").
//!
//! ```pov
//! sky_sphere { pigment { gradient y color_map { [0 rgb 1] [1 rgb <0.2, 0.4, 1>] } } }
//! ```

use crate::color::Rgb;
use crate::diagnostic::{Diagnostic, Result, codes};
use crate::math::Transform;
use crate::source::Span;
use crate::texture::{Pigment, Texture};
use crate::value::ValueKind::{Block, Color};
use crate::value::words::word;
use crate::value::{Next, Reader, ReaderExt, Spec, Thing};
use serde::Serialize;

/// Sky sphere: a background whose colour depends on the direction of the ray.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct SkySphere {
    /// Pigments of the sky sphere, from the lowest to the topmost layer.
    pub pigments: Vec<Pigment>,
    /// Factor of the light of the sky sphere's pigments.
    pub emission: Rgb,
    /// Transform of all pigments of the sky sphere, also of those written after it (quirk: `sky_sphere_transform`).
    pub transform: Transform,
}

impl Default for SkySphere {
    fn default() -> Self {
        Self { pigments: vec![], emission: Rgb::ONE, transform: Transform::IDENTITY }
    }
}

impl Thing for SkySphere {
    fn kind(&self) -> &'static str {
        "sky_sphere"
    }
}

/// Words of a `sky_sphere { … }` block.
pub const SKY_SPHERE: Spec = Spec {
    name: "sky_sphere",
    summary: "the sky: pigments that see directions, points at a distance of 1 from the origin, in place of places",
    words: &[
        word(
            "pigment",
            Block,
            "",
            "the sky; of several, each lies over those before it, and shows them where it is clear",
        ),
        word("emission", Color, "1", "a factor of its light, one number or one for each channel"),
    ],
    has_transforms: true,
    ..Spec::EMPTY
};

impl SkySphere {
    /// Reads the items of a `sky_sphere` block; `source` is the span of its word. Pigments start from black, whatever
    /// the default pigment is; only pigments in their maps start from `map_entry_defaults`, the default texture
    /// (quirk: `sky_sphere_pigment`).
    ///
    /// # Errors
    /// A diagnostic at the first item that is not understood.
    pub fn read(r: &mut dyn Reader, map_entry_defaults: &Texture, source: Span) -> Result<Self> {
        let mut sky = Self::default();
        loop {
            match r.peek_next()? {
                Next::End => break,
                Next::Thing("sky_sphere") => {
                    if let Some(declared) = r.take_declared::<SkySphere>()? {
                        sky = (*declared).clone();
                    }
                }
                Next::Thing("pigment") => {
                    if let Some(pigment) = r.take_declared::<Pigment>()? {
                        sky.pigments.push((*pigment).clone());
                    }
                }
                Next::Block("pigment") => {
                    r.take_token()?;
                    sky.pigments.push(Pigment::read(r, &Pigment::default(), map_entry_defaults)?);
                    r.leave_block()?;
                }
                Next::Word("emission") => {
                    r.take_token()?;
                    sky.emission = r.color()?.rgb;
                }
                next if next.is_transform() => {
                    if let Some(step) = r.transform()? {
                        sky.transform = sky.transform.then(&step);
                    }
                }
                _ => return Err(r.unknown_word_in(&SKY_SPHERE)),
            }
        }
        if sky.pigments.is_empty() {
            r.report(Diagnostic::new(
                codes::EMPTY_BLOCK,
                source,
                "this `sky_sphere` holds no `pigment`: it shows nothing",
            ));
        }
        Ok(sky)
    }
}
