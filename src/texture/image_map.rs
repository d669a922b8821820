//! `image_map`: a picture as the colours of a surface (manual, "Image Map").

use super::words::{IMAGE_MAP, IMAGE_MAP_ROWS};
use crate::color::{Color, Rgb};
use crate::diagnostic::Result;
use crate::math::DVec3;
use crate::pattern::bitmap::{self, Bitmap, Mapping, Texels};
use crate::value::words::read_row;
use crate::value::{Next, Reader, ReaderExt};
use serde::Serialize;

/// Pigment `image_map`: a picture that gives colours.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct ImageMap {
    /// Pixels of the `image_map`'s picture.
    pub texels: Texels,
    /// Projection of the `image_map`'s picture.
    pub mapping: Mapping,
    /// Transparency that `filter` and `transmit` add to the `image_map`'s picture.
    #[serde(flatten)]
    pub clearness: Clearness,
}

/// Values of `filter` and `transmit` in an `image_map`.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
pub struct Clearness {
    /// Filter of all colours of the `image_map`, from `filter all`.
    pub filter: Option<f64>,
    /// Transmittance of all colours of the `image_map`, from `transmit all`; added to the picture's transparency, or in
    /// place of it if the picture has a palette.
    pub transmit: Option<f64>,
    /// Palette index, filter and transmit for single colours of the `image_map`'s palette.
    pub palette: Vec<(u8, Option<f64>, Option<f64>)>,
}

impl Clearness {
    /// Reads the words `filter all A` or `filter N, A` of an `image_map`.
    pub(super) fn read_filter(&mut self, r: &mut dyn Reader) -> Result<()> {
        match read_palette_index_and_amount(r)? {
            (None, amount) => self.filter = Some(amount),
            (Some(number), amount) => self.palette.push((number, Some(amount), None)),
        }
        Ok(())
    }

    /// Reads the words `transmit all A` or `transmit N, A` of an `image_map`.
    pub(super) fn read_transmit(&mut self, r: &mut dyn Reader) -> Result<()> {
        match read_palette_index_and_amount(r)? {
            (None, amount) => self.transmit = Some(amount),
            (Some(number), amount) => self.palette.push((number, None, Some(amount))),
        }
        Ok(())
    }
}

/// Reads the palette index, or `None` for `all`, and the amount after `filter` or `transmit`.
fn read_palette_index_and_amount(r: &mut dyn Reader) -> Result<(Option<u8>, f64)> {
    if r.accept("all")? {
        return Ok((None, r.float()?));
    }
    Ok((Some(r.float()?.clamp(0.0, 255.0) as u8), r.float()?))
}

impl ImageMap {
    /// Reads the items of an `image_map` block.
    ///
    /// # Errors
    /// A diagnostic at the item that is not understood.
    pub fn read(r: &mut dyn Reader) -> Result<Self> {
        let mut bitmap = Bitmap::read_picture(r)?;
        let mut clearness = Clearness::default();
        loop {
            match r.peek_next()? {
                Next::End => break,
                next if read_row(IMAGE_MAP_ROWS, &mut clearness, next, r)? => {}
                next if bitmap.read_bitmap_word(r, next)? => {}
                _ => {
                    let words: Vec<_> = bitmap::bitmap_word_names().chain(IMAGE_MAP.word_names()).collect();
                    return Err(r.unknown_word("image_map", &words).into());
                }
            }
        }
        Ok(Self { texels: bitmap.color_texels(r), mapping: bitmap.mapping, clearness })
    }

    /// Returns the `image_map`'s colour at a point; transparent beyond the edges of a picture with `once`.
    pub fn color_at(&self, p: DVec3) -> Color {
        let Some(place) = self.mapping.project_to_unit_square(p) else {
            return Color { rgb: Rgb::ONE, filter: 0.0, transmit: 1.0 };
        };
        let pixels = self.mapping.weighted_pixels(place, self.texels.width(), self.texels.height());
        pixels.iter().fold(Color::BLACK, |sum, (i, weight)| sum.plus_scaled(self.pixel_color(*i), *weight))
    }

    /// True if the `image_map`'s picture covers the point.
    pub fn covers_point(&self, p: DVec3) -> bool {
        self.mapping.project_to_unit_square(p).is_some()
    }

    fn pixel_color(&self, i: usize) -> Color {
        let [r, g, b, a] = self.texels.rgba(i);
        let index = self.texels.palette_index(i);
        let transmit = match (self.clearness.transmit, index) {
            (None, _) => 1.0 - a,
            // In a palette, `transmit all` replaces alpha (quirk: image_palette_transmit).
            (Some(all), Some(_)) => all,
            (Some(all), None) => 1.0 - a + all,
        };
        let mut color = Color { rgb: Rgb::new(r, g, b), filter: self.clearness.filter.unwrap_or(0.0), transmit };
        for (_, filter, transmit) in self.clearness.palette.iter().filter(|(number, ..)| Some(*number) == index) {
            color.filter = filter.unwrap_or(color.filter);
            color.transmit = transmit.unwrap_or(color.transmit);
        }
        color
    }

    /// True if no pixel of the `image_map` transmits light.
    pub fn is_opaque(&self) -> bool {
        let none = |amount: Option<f64>| amount.is_none_or(|x| x == 0.0);
        let solid = none(self.clearness.filter) && none(self.clearness.transmit) && self.clearness.palette.is_empty();
        solid && !self.mapping.once && !self.has_alpha_below_one()
    }

    /// True if the alpha channel of the `image_map`'s picture is below 1 at some pixel (quirk: `image_alpha_of_one`).
    /// The words `filter` and `transmit` of the `image_map` do not count.
    fn has_alpha_below_one(&self) -> bool {
        let pixels = self.texels.width() * self.texels.height();
        self.texels.has_alpha() && (0..pixels).any(|i| self.texels.rgba(i)[3] < 1.0)
    }

    /// True if the `image_map`'s picture, as one of several pigments, counts as opaque: only its own alpha and palette
    /// count, not `filter`, nor `transmit all` of a picture without a palette (quirk: `image_seems_opaque`).
    pub fn is_opaque_in_blend(&self) -> bool {
        let clear = |i: usize| match self.texels.palette_index(i) {
            Some(_) => self.pixel_color(i).transmit != 0.0,
            None => self.texels.rgba(i)[3] < 1.0,
        };
        let pixels = self.texels.width() * self.texels.height();
        self.is_opaque() || !(self.mapping.once || (0..pixels).any(clear))
    }
}
