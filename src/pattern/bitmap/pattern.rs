//! `image_pattern`: the brightness of a picture (manual, "Image Pattern").

use super::{Bitmap, Mapping, Texels, WORDS};
use crate::color::{Rgb, gray};
use crate::diagnostic::Result;
use crate::pattern::{Field, Readable, Spot};
use crate::value::{Kind, Next, Param, Reader, Spec};
use serde::Serialize;

/// A picture's brightness, or its alpha.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct ImagePattern {
    /// Its pixels.
    pub texels: Texels,
    /// Where it lies.
    pub mapping: Mapping,
    /// What counts of a pixel.
    pub channel: Channel,
}

/// What counts of a pixel.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Channel {
    /// Its brightness.
    Gray,
    /// `use_alpha`: 1 - alpha.
    Alpha,
    /// `use_index`: its number in the palette, of 255.
    Index,
}

impl Readable for ImagePattern {
    const SPEC: Spec = Spec {
        name: "image_pattern",
        summary: "the brightness of a picture; file and words stand in braces",
        params: &[Param { name: "file", kind: Kind::Text, summary: "a picture file's name" }],
        words: &[],
    };

    fn read(r: &mut dyn Reader) -> Result<Self> {
        let out = Self::read_words(r, "image_pattern", &mut |_, _| Ok(false))?;
        r.leave()?;
        // Of an `image_pattern`, the palette's numbers do not count (measured on POV-Ray 3.7).
        let channel = if out.channel == Channel::Index { Channel::Gray } else { out.channel };
        Ok(Self { channel, ..out })
    }
}

impl ImagePattern {
    /// Reads what stands between the braces of `block`, which takes other words too.
    pub fn read_words(
        r: &mut dyn Reader,
        block: &str,
        other: &mut dyn FnMut(&mut dyn Reader, Next) -> Result<bool>,
    ) -> Result<Self> {
        let mut bitmap = Bitmap::read(r)?;
        let mut channel = Channel::Gray;
        loop {
            match r.next()? {
                Next::End => break,
                Next::Word(word @ ("use_alpha" | "use_color" | "use_colour" | "use_index")) => {
                    r.take()?;
                    channel = match word {
                        "use_alpha" => Channel::Alpha,
                        "use_index" => Channel::Index,
                        _ => Channel::Gray,
                    };
                }
                next if bitmap.read_word(r, next)? || other(r, next)? => {}
                _ => {
                    let own = ["use_alpha", "use_color", "use_index", "bump_size"];
                    let words: Vec<_> = WORDS.iter().map(|w| w.name).chain(own).collect();
                    return Err(r.unknown_word(block, &words).into());
                }
            }
        }
        let texels = bitmap.numbers();
        let channel = match channel {
            Channel::Alpha if !texels.has_alpha() => Channel::Gray,
            Channel::Index if texels.index(0).is_none() => Channel::Gray,
            other => other,
        };
        Ok(Self { texels, mapping: bitmap.mapping, channel })
    }

    /// What counts of a pixel, in [0, 1].
    fn number(&self, i: usize) -> f64 {
        let [r, g, b, a] = self.texels.rgba(i);
        match self.channel {
            Channel::Gray => gray(Rgb::new(r, g, b)),
            Channel::Alpha => 1.0 - a,
            Channel::Index => f64::from(self.texels.index(i).unwrap_or(0)) / 255.0,
        }
    }
}

impl Field for ImagePattern {
    fn value(&self, at: &Spot) -> f64 {
        let Some(place) = self.mapping.place(at.p) else { return 0.0 };
        let pixels = self.mapping.pixels(place, self.texels.width(), self.texels.height());
        pixels.iter().map(|(i, weight)| weight * self.number(*i)).sum::<f64>().clamp(0.0, 1.0)
    }
}
