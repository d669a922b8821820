//! Pictures in space: what `image_map`, `image_pattern`, `bump_map` and `material_map` have in common (manual, "Image Map",
//! "Bitmap Modifiers").

mod mapping;
mod material;
mod pattern;
mod texels;

pub use mapping::{Mapping, PixelInterpolation, Weighted, Wrap};
pub use material::MaterialMap;
pub use pattern::{CHANNELS, Channel, ImagePattern};
pub use texels::{Texels, color_curve};

use crate::color::Gamma;
use crate::diagnostic::{Diagnostic, Result, codes};
use crate::function::{Function, ResultType};
use crate::image_io::{Picture, Pixels, Samples, Stored, scale_and_wrap_to_u16};
use crate::math::DVec3;
use crate::value::words::{Row, read_row, set, specs, word};
use crate::value::{Next, Reader, ReaderExt, Value, ValueKind, WordSpec, downcast};
use std::sync::Arc;

const ROWS: &[Row<Bitmap>] = &[
    word(
        "gamma",
        ValueKind::Float,
        "",
        "how the file's numbers stand to light, instead of what the file says; or `srgb`",
    )
    .sets(|s, r| set(&mut s.gamma, read_gamma(r).map(Some))),
    word("premultiplied", ValueKind::Flag, "", "the file's colours are multiplied with alpha already")
        .sets(|s, r| set(&mut s.premultiplied, r.flag())),
    word("map_type", ValueKind::Float, "0", "0 is flat, 1 around a sphere, 2 around a cylinder, 5 around a torus")
        .sets(|s, r| set(&mut s.mapping.wrap, r.float().map(Wrap::from_map_type))),
    word("once", ValueKind::Nothing, "", "it is there once, not again and again")
        .sets(|s, _| set(&mut s.mapping.once, Ok(true))),
    word("interpolate", ValueKind::Float, "0", "between pixels: 2 straight lines, 3 curves, 4 by distance")
        .sets(|s, r| set(&mut s.mapping.between, read_interpolation(r))),
];

/// Words that every bitmap pattern takes after the file's name.
pub const WORDS: &[WordSpec] = specs!(ROWS);

/// Names of the keywords in [`WORDS`].
pub fn bitmap_word_names() -> impl Iterator<Item = &'static str> {
    WORDS.iter().map(|w| w.name)
}

/// Names of picture formats before a bitmap's file name. They are accepted and ignored: the bytes of the file decide.
pub const FORMATS: &[&str] =
    &["exr", "gif", "hdr", "iff", "jpeg", "pgm", "png", "ppm", "sys", "tga", "tiff", "pot", "bmp"];

/// Picture formats that POV-Ray 3.7 rejects too, with the reason.
const NO_PICTURES: &[(&str, &str)] = &[
    ("pot", "only a `height_field` takes a pot file; the picture in it can be read by `gif`"),
    ("sys", "`sys` is a format of the system where POV-Ray runs, and there is none; save the picture as a png"),
    ("iff", "iff pictures are not read, as they are not by POV-Ray 3.7; save the picture as a png"),
];

/// Picture of an `image_map` or other bitmap, with the settings that all kinds of bitmaps share.
#[derive(Clone, Debug)]
pub struct Bitmap {
    /// Picture of the bitmap, from a file or a function.
    pub picture: Arc<Picture>,
    /// Gamma of the bitmap's picture, from `gamma`; `None` without that keyword.
    pub gamma: Option<Gamma>,
    /// True if the bitmap's colours are multiplied by its alpha (`premultiplied`).
    pub premultiplied: bool,
    /// Projection of the bitmap's picture.
    pub mapping: Mapping,
}

impl Bitmap {
    /// Reads the picture of a bitmap: the file's name, or a function with a size; the words after it are not read.
    ///
    /// # Errors
    /// A diagnostic at the item that is not understood.
    pub fn read_picture(r: &mut dyn Reader) -> Result<Self> {
        let (mut format, mut named) = (None, None);
        // quirk: old_picture_orientation
        if r.peek_next()? == Next::Value {
            match r.value()? {
                (Value::Text(name), at) => named = Some((name.to_string(), at)),
                (_, at) => {
                    let message = "an orientation or map type before the picture has no effect";
                    r.report(
                        Diagnostic::new(codes::MISPLACED, at, message)
                            .help("`map_type` after the picture's name has one"),
                    );
                }
            }
        }
        while let Next::Word(word) = r.peek_next()?
            && FORMATS.contains(&word)
        {
            if let Some((_, reason)) = NO_PICTURES.iter().find(|(format, _)| *format == word) {
                return Diagnostic::new(codes::BAD_ARGUMENT, r.span(), format!("`{word}` is no picture here"))
                    .help(*reason)
                    .into();
            }
            r.take_token()?;
            format = Some(word);
        }
        let picture = match (named, r.peek_next()?) {
            (Some((name, at)), _) => r.open_picture(&name, at, format)?,
            (None, Next::Function) => read_function_picture(r)?,
            (None, _) => {
                let (at, name) = (r.span(), r.text()?);
                r.open_picture(&name, at, format)?
            }
        };
        Ok(Self { picture, gamma: None, premultiplied: false, mapping: Mapping::default() })
    }

    /// Reads the next word of a bitmap if it is one of [`WORDS`]; returns false if not.
    ///
    /// # Errors
    /// A diagnostic at the item that is not understood.
    pub fn read_bitmap_word(&mut self, r: &mut dyn Reader, next: Next) -> Result<bool> {
        read_row(ROWS, self, next, r)
    }

    /// Returns the bitmap's pixels as colours of the scene.
    pub fn color_texels(&self, r: &dyn Reader) -> Texels {
        let language = r.language();
        let scene = language.assumed_gamma.unwrap_or(language.other_gamma);
        let curve = color_curve(self.picture.stored, self.gamma, scene, language.srgb_files);
        Texels::new(self.picture.clone(), curve, self.premultiplied)
    }

    /// Returns the bitmap's pixels as numbers, exactly as the file stores them unless `gamma` is given.
    pub fn number_texels(&self) -> Texels {
        let curve = color_curve(Stored::Plain, self.gamma, Gamma::Power(1.0), false);
        Texels::new(self.picture.clone(), curve, self.premultiplied)
    }
}

/// Reads the gamma of a bitmap: `srgb`, or a number.
fn read_gamma(r: &mut dyn Reader) -> Result<Gamma> {
    if r.accept("srgb")? { Ok(Gamma::Srgb) } else { r.float().map(Gamma::Power) }
}

/// Reads the number after `interpolate` in a bitmap.
fn read_interpolation(r: &mut dyn Reader) -> Result<PixelInterpolation> {
    let (at, n) = (r.span(), r.float()?);
    PixelInterpolation::from_interpolate_number(n).ok_or_else(|| {
        let message = format!("`interpolate` takes 2, 3 or 4, found {n}");
        Diagnostic::new(codes::BAD_ARGUMENT, at, message).into()
    })
}

/// Reads a bitmap from a function, `function W, H { … }`: a picture of W by H samples from (0, 0), at the top, to (1,
/// 1), with 16 bits per channel.
fn read_function_picture(r: &mut dyn Reader) -> Result<Arc<Picture>> {
    let at = r.span();
    let Some(([width, height], thing)) = r.read_function_if_sized()? else {
        return Diagnostic::new(codes::WRONG_TYPE, at, "a function as a picture needs a size")
            .help("`function 200, 200 { … }`")
            .into();
    };
    let Some(function) = downcast::<Function>(&thing).filter(|f| f.arity() == 3) else {
        return Diagnostic::err(codes::WRONG_TYPE, at, "expected a function of x and y");
    };
    let color = function.result_type() == ResultType::Color;
    let step = |i: usize, n: usize| i as f64 / (n.max(2) - 1) as f64;
    let points = (0..height).flat_map(|j| (0..width).map(move |i| DVec3::new(step(i, width), step(j, height), 0.0)));
    // Reserve all memory at once: a growing list would need twice as much.
    let mut samples = Vec::with_capacity(width * height * 4);
    samples.extend(points.flat_map(|p| {
        let c = function.call(&p.to_array());
        // A number is a gray; alpha is 1 minus `transmit`.
        let [r, g, b] = if color { [c[0], c[1], c[2]] } else { [c[0]; 3] }.map(|x| x as f32);
        let alpha = if color { 1.0 - c[4] as f32 } else { 1.0 };
        [r, g, b, alpha].map(|x| f32::from(scale_and_wrap_to_u16(x)) / 65535.0)
    }));
    let pixels = Pixels { width, height, channels: 4, samples: Samples::F32(samples) };
    Ok(Arc::new(Picture { pixels, stored: Stored::Plain, indices: None, gray_bytes: false }))
}
