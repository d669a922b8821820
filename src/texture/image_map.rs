//! `image_map`: a picture as the colours of a surface (manual, "Image Map").

use super::words::IMAGE_MAP;
use crate::color::{Color, Rgb};
use crate::diagnostic::Result;
use crate::math::DVec3;
use crate::pattern::bitmap::{self, Bitmap, Mapping, Texels};
use crate::value::{Next, Reader, ReaderExt};
use serde::Serialize;

/// A picture in space.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct ImageMap {
    /// Its pixels.
    pub texels: Texels,
    /// Where it lies.
    pub mapping: Mapping,
    /// Of all colours.
    pub filter: Option<f64>,
    /// Of all colours; added to what alpha lets through.
    pub transmit: Option<f64>,
    /// (number in the palette, filter, transmit): what is said of single colours.
    pub palette: Vec<(u8, Option<f64>, Option<f64>)>,
}

impl ImageMap {
    /// Reads what stands between the braces.
    ///
    /// # Errors
    /// With the place of what is not understood, and what was expected there.
    pub fn read(r: &mut dyn Reader) -> Result<Self> {
        let mut bitmap = Bitmap::read(r)?;
        let (mut filter, mut transmit, mut palette) = (None, None, vec![]);
        loop {
            match r.next()? {
                Next::End => break,
                Next::Word(word @ ("filter" | "transmit")) => {
                    r.take()?;
                    let filters = word == "filter";
                    if r.accept("all")? {
                        *(if filters { &mut filter } else { &mut transmit }) = Some(r.float()?);
                    } else {
                        let (number, amount) = (r.float()?, r.float()?);
                        let pair = if filters { (Some(amount), None) } else { (None, Some(amount)) };
                        palette.push((number.clamp(0.0, 255.0) as u8, pair.0, pair.1));
                    }
                }
                next if bitmap.read_word(r, next)? => {}
                _ => {
                    let words: Vec<_> = bitmap::word_names().chain(IMAGE_MAP.names()).collect();
                    return Err(r.unknown_word("image_map", &words).into());
                }
            }
        }
        Ok(Self { texels: bitmap.colors(r), mapping: bitmap.mapping, filter, transmit, palette })
    }

    /// The colour at a point; past the edges of a picture that is there `once`, nothing but what is behind.
    pub fn at(&self, p: DVec3) -> Color {
        let Some(place) = self.mapping.place(p) else {
            return Color { rgb: Rgb::ONE, filter: 0.0, transmit: 1.0 };
        };
        let pixels = self.mapping.pixels(place, self.texels.width(), self.texels.height());
        pixels.iter().fold(Color::BLACK, |sum, (i, weight)| sum.plus(self.pixel(*i), *weight))
    }

    fn pixel(&self, i: usize) -> Color {
        let [r, g, b, a] = self.texels.rgba(i);
        let index = self.texels.index(i);
        let transmit = match (self.transmit, index) {
            (None, _) => 1.0 - a,
            // In a palette it replaces alpha (measured on POV-Ray 3.7).
            (Some(all), Some(_)) => all,
            (Some(all), None) => 1.0 - a + all,
        };
        let mut color = Color { rgb: Rgb::new(r, g, b), filter: self.filter.unwrap_or(0.0), transmit };
        for (_, filter, transmit) in self.palette.iter().filter(|(number, ..)| Some(*number) == index) {
            color.filter = filter.unwrap_or(color.filter);
            color.transmit = transmit.unwrap_or(color.transmit);
        }
        color
    }

    /// Does no light pass anywhere?
    pub fn is_opaque(&self) -> bool {
        let none = |amount: Option<f64>| amount.is_none_or(|x| x == 0.0);
        let solid = none(self.filter) && none(self.transmit) && self.palette.is_empty();
        solid && !self.mapping.once && !self.texels.has_alpha()
    }
}
