//! `image_pattern`: the brightness of a picture (manual, "Image Pattern").

use super::{Bitmap, Mapping, Texels, bitmap_word_names};
use crate::color::{Rgb, gray};
use crate::diagnostic::Result;
use crate::math::{DVec3, fp};
use crate::pattern::{Field, FieldParams, TextureContext};
use crate::value::words::{Row, read_row, set, specs, word};
use crate::value::{Next, Param, Readable, Reader, Spec, ValueKind, WordSpec};
use serde::Serialize;

/// Pattern `image_pattern` or `bump_map`: a picture's brightness, alpha or palette index.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct ImagePattern {
    /// Pixels of the bitmap pattern's picture.
    pub texels: Texels,
    /// Projection of the bitmap pattern's picture.
    pub mapping: Mapping,
    /// Channel of the picture that gives the bitmap pattern's number.
    pub channel: Channel,
    /// True for `bump_map`: bumps come from the differences of neighbouring pixels.
    pub bumps: bool,
}

/// Channel of a pixel that gives a bitmap pattern's number.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Channel {
    /// Brightness of a pixel as a bitmap pattern's number.
    Gray,
    /// Alpha of a pixel as a bitmap pattern's number, with `use_alpha`: 1 - alpha.
    Alpha,
    /// Palette index of a pixel as a bitmap pattern's number, with `use_index`.
    Index,
}

const CHANNEL_ROWS: &[Row<Channel>] = &[
    word("use_alpha", ValueKind::Nothing, "", "how much shines through counts, where the file says it")
        .sets(|s, _| set(s, Ok(Channel::Alpha))),
    word("use_color", ValueKind::Nothing, "", "brightness counts, which is so without it too")
        .sets(|s, _| set(s, Ok(Channel::Gray))),
    word("use_colour", ValueKind::Nothing, "", "the same").sets(|s, _| set(s, Ok(Channel::Gray))),
    word(
        "use_index",
        ValueKind::Nothing,
        "",
        "of a `bump_map`: the number in the palette counts, where the file has one",
    )
    .sets(|s, _| set(s, Ok(Channel::Index))),
];

/// Words that choose the channel of an `image_pattern` or `bump_map`.
pub const CHANNELS: &[WordSpec] = specs!(CHANNEL_ROWS);

impl Readable for ImagePattern {
    const SPEC: Spec = Spec {
        name: "image_pattern",
        summary: "the brightness of a picture; file and words stand in braces",
        params: &[Param { name: "file", kind: ValueKind::Text, summary: "a picture file's name" }],
        ..Spec::EMPTY
    };

    fn read(r: &mut dyn Reader) -> Result<Self> {
        let out = Self::read_words(r, "image_pattern", &mut |_, _| Ok(false))?;
        r.leave_block()?;
        // quirk: image_pattern_ignores_index
        let channel = if out.channel == Channel::Index { Channel::Gray } else { out.channel };
        Ok(Self { channel, ..out })
    }
}

impl ImagePattern {
    /// Reads the items of an `image_pattern` or `bump_map`; `other` reads the words that the block takes besides.
    /// `block` is the block's name.
    ///
    /// # Errors
    /// A diagnostic at the item that is not understood.
    pub fn read_words(
        r: &mut dyn Reader,
        block: &str,
        other: &mut dyn FnMut(&mut dyn Reader, Next) -> Result<bool>,
    ) -> Result<Self> {
        let mut bitmap = Bitmap::read_picture(r)?;
        let mut channel = Channel::Gray;
        loop {
            match r.peek_next()? {
                Next::End => break,
                next if read_row(CHANNEL_ROWS, &mut channel, next, r)? => {}
                next if bitmap.read_bitmap_word(r, next)? || other(r, next)? => {}
                _ => {
                    let own = CHANNELS.iter().map(|w| w.name);
                    let size = (block == "bump_map").then_some("bump_size");
                    let words: Vec<_> = bitmap_word_names().chain(own).chain(size).collect();
                    return Err(r.unknown_word(block, &words).into());
                }
            }
        }
        let texels = bitmap.number_texels();
        let channel = match channel {
            Channel::Alpha if !texels.has_alpha() => Channel::Gray,
            Channel::Index if texels.palette_index(0).is_none() => Channel::Gray,
            other => other,
        };
        Ok(Self { texels, mapping: bitmap.mapping, channel, bumps: false })
    }

    /// Returns the number of the bitmap's pixel `i` in a channel.
    fn pixel_value(&self, i: usize, channel: Channel) -> f64 {
        let [r, g, b, a] = self.texels.rgba(i);
        match channel {
            Channel::Gray => gray(Rgb::new(r, g, b)),
            Channel::Alpha => 1.0 - a,
            Channel::Index => f64::from(self.texels.palette_index(i).unwrap_or(0)),
        }
    }
}

impl ImagePattern {
    /// Returns the interpolated number at a position on the bitmap.
    fn interpolated_value(&self, uv: (f64, f64)) -> f64 {
        let pixels = self.mapping.weighted_pixels(uv, self.texels.width(), self.texels.height());
        let sum = |channel| pixels.iter().map(|(i, weight)| weight * self.pixel_value(*i, channel)).sum::<f64>();
        match self.channel {
            // quirk: palette_index_truncated
            Channel::Index => sum(Channel::Index).trunc(),
            channel => sum(channel),
        }
    }
}

impl Field for ImagePattern {
    fn starts_with_zero_frequency(&self) -> bool {
        true
    }

    fn value(&self, at: &TextureContext) -> f64 {
        self.mapping.project_to_unit_square(at.p).map_or(0.0, |place| self.interpolated_value(place).clamp(0.0, 1.0))
    }

    fn bumped_normal(&self, at: &TextureContext, _: &FieldParams, n: DVec3, amount: f64) -> Option<DVec3> {
        if !self.bumps {
            return None;
        }
        let Some((u, v)) = self.mapping.project_to_unit_square(at.p) else { return Some(n) };
        // The slope of the triangle of three pixels: this one, the one below and the one to the right or left (quirk:
        // bump_map_three_pixels).
        let (across, up) = (1.0 / self.texels.width() as f64, 1.0 / self.texels.height() as f64);
        // Past an edge the picture continues at its opposite side, also with `once`.
        let height = |du: f64, dv: f64| {
            self.interpolated_value((fp::fraction_above_floor(u + du), fp::fraction_above_floor(v + dv)))
        };
        let (here, right, left) = (height(0.0, 0.0), height(across, -up), height(-across, -up));
        // The picture's directions in the surface; for a surface level to 1e-10 these are x and z (quirk:
        // bump_map_three_pixels).
        let x = n.cross(DVec3::Y);
        let x = if x.length() < 1e-10 { DVec3::X } else { x.normalize() };
        let y = x.cross(n).normalize_or_zero();
        Some(n - amount * ((right - left) / 2.0 * x + (here - (right + left) / 2.0) * y))
    }
}
