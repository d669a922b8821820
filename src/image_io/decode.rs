//! Decoders of picture files.

use super::{Frame, bmp, netpbm, open_exr, png_palette, radiance, tga, tiff_palette};
use crate::color::transfer;
use crate::diagnostic::{Diagnostic, Result, codes, file};
use crate::source::{Activity, Files, ReadError, Span};
use image::{DynamicImage, ImageFormat, ImageReader};
use std::io::Cursor;
use std::path::Path;

/// A picture as stored in its file, without any transfer curve.
#[derive(Clone, Debug, PartialEq)]
pub struct Pixels {
    /// Width of the decoded picture in pixels.
    pub width: usize,
    /// Height of the decoded picture in pixels.
    pub height: usize,
    /// Channels of a decoded picture: 1 gray, 2 gray and alpha, 3 colour, 4 colour and alpha.
    pub channels: usize,
    /// Samples of a decoded picture, row by row from the top left, the channels of a pixel adjacent; colours are not
    /// multiplied by alpha.
    pub samples: Samples,
}

/// Samples of a decoded picture, by their type.
#[derive(Clone, Debug, PartialEq)]
pub enum Samples {
    /// Samples of a decoded picture as codes from 0 to 255.
    U8(Vec<u8>),
    /// Samples of a decoded picture as codes from 0 to 65535.
    U16(Vec<u16>),
    /// Samples of a decoded picture as linear light.
    F32(Vec<f32>),
}

/// A picture, with the palette indices of its pixels if the decoder returns them.
pub(super) struct Decoded {
    pub pixels: Pixels,
    /// Palette index of each pixel, from the top left; `None` if the decoder returns none.
    pub indices: Option<Vec<u8>>,
}

impl From<Pixels> for Decoded {
    fn from(pixels: Pixels) -> Self {
        Self { pixels, indices: None }
    }
}

/// Decodes a picture file.
///
/// # Errors
/// E0002 if the file does not exist, E0003 if it can't be read, E0007 if it is not a picture.
pub fn decode_picture_file(files: &dyn Files, path: &Path) -> Result<Pixels> {
    let bytes = files.read(path).map_err(|e| file::unreadable(files, path, &ReadError::Io(e)))?;
    decode_picture_bytes(&bytes, path).map(|decoded| decoded.pixels)
}

/// Decodes the bytes of a picture file.
///
/// # Errors
/// E0007 if it is not a picture.
pub(super) fn decode_picture_bytes(bytes: &[u8], path: &Path) -> Result<Decoded> {
    let _activity = Activity::begin("while a picture was decoded");
    let ending = path.extension().and_then(|e| e.to_str()).unwrap_or_default();
    decode_non_empty(bytes, ending).map_err(|reason| {
        let reason = reason.lines().next().unwrap_or_default();
        let text = format!("`{}` can't be decoded: {reason}", path.display());
        let fault = Diagnostic::new(codes::PICTURE_BROKEN, Span::NONE, text);
        // (POV-Ray 3.7.0.10 accepts the word `iff`, but can't read such a file either.)
        let help = match bytes {
            [b'F', b'O', b'R', b'M', ..] => "IFF pictures have to be made into png first",
            _ if ImageReader::new(Cursor::new(bytes)).with_guessed_format().is_ok_and(|r| r.format().is_some()) => {
                return Box::new(fault);
            }
            _ => "pictures are png, jpeg, gif, tga, tiff, bmp, ppm, pgm, hdr or exr",
        };
        Box::new(fault.help(help))
    })
}

/// Decodes a picture in the format png, jpg, bmp, tga, tiff, gif, ppm, hdr or exr. The bytes decide which; the ending
/// of the file's name counts only for tga, which has no signature.
///
/// # Errors
/// The reason why the bytes are not a picture, in words.
pub fn decode_pixels(bytes: &[u8], extension: &str) -> Result<Pixels, String> {
    decode_non_empty(bytes, extension).map(|decoded| decoded.pixels)
}

/// Decodes a picture, and refuses one without pixels, which no pattern could look up.
fn decode_non_empty(bytes: &[u8], extension: &str) -> Result<Decoded, String> {
    let decoded = decode_by_signature(bytes, extension)?;
    match (decoded.pixels.width, decoded.pixels.height) {
        (0, _) | (_, 0) => Err("it has no pixels".into()),
        _ => Ok(decoded),
    }
}

fn decode_by_signature(bytes: &[u8], extension: &str) -> Result<Decoded, String> {
    if let Some(pixels) = netpbm::decode_netpbm_max_below_255(bytes) {
        return pixels.map(Decoded::from);
    }
    match bytes {
        [0x76, 0x2f, 0x31, 0x01, ..] => {
            return open_exr::decode_exr(bytes).map(Decoded::from);
        }
        [b'#', b'?', ..] => return radiance::decode_radiance(bytes).map(Decoded::from),
        [b'F', b'O', b'R', b'M', ..] => return Err("iff pictures are not read, as they are not by POV-Ray 3.7".into()),
        _ => {}
    }
    if let Some(fault) = png_palette::palette_fault(bytes) {
        return Err(fault);
    }
    if let Some(decoded) = tiff_palette::decode_tiff_palette(bytes, decode_with_image_crate) {
        return decoded;
    }
    let format = image::guess_format(bytes).ok();
    if format.is_none() && extension.eq_ignore_ascii_case("tga") {
        return tga::decode_tga(bytes);
    }
    let pixels = decode_with_image_crate(bytes)?;
    if format != Some(ImageFormat::Bmp) {
        return Ok(pixels.into());
    }
    let pixels = match bmp::bmp_alpha(bytes) {
        Some(alpha) => pixels.with_alpha_if_rgb8(&alpha),
        None => pixels,
    };
    let indices = bmp::bmp_palette_indices(bytes, [pixels.width, pixels.height]);
    Ok(Decoded { pixels, indices })
}

/// Decodes a picture whose format the crate `image` supports.
fn decode_with_image_crate(bytes: &[u8]) -> Result<Pixels, String> {
    let reader = ImageReader::new(Cursor::new(bytes)).with_guessed_format().map_err(|e| e.to_string())?;
    reader.decode().map(Pixels::from).map_err(|e| e.to_string())
}

impl From<DynamicImage> for Pixels {
    fn from(image: DynamicImage) -> Self {
        let (width, height) = (image.width() as usize, image.height() as usize);
        let channels = image.color().channel_count() as usize;
        let samples = match image {
            DynamicImage::ImageLuma16(i) => Samples::U16(i.into_raw()),
            DynamicImage::ImageLumaA16(i) => Samples::U16(i.into_raw()),
            DynamicImage::ImageRgb16(i) => Samples::U16(i.into_raw()),
            DynamicImage::ImageRgba16(i) => Samples::U16(i.into_raw()),
            DynamicImage::ImageRgb32F(i) => Samples::F32(i.into_raw()),
            DynamicImage::ImageRgba32F(i) => Samples::F32(i.into_raw()),
            other => Samples::U8(other.into_bytes()),
        };
        Self { width, height, channels, samples }
    }
}

impl Pixels {
    /// Removes the alpha channel of the decoded pixels.
    pub(super) fn without_alpha(self) -> Self {
        fn drop_last_channel<T: Copy>(samples: &[T], n: usize) -> Vec<T> {
            samples.chunks_exact(n).flat_map(|pixel| &pixel[..n - 1]).copied().collect()
        }
        let n = self.channels;
        if !matches!(n, 2 | 4) {
            return self;
        }
        let samples = match &self.samples {
            Samples::U8(v) => Samples::U8(drop_last_channel(v, n)),
            Samples::U16(v) => Samples::U16(drop_last_channel(v, n)),
            Samples::F32(v) => Samples::F32(drop_last_channel(v, n)),
        };
        Self { channels: n - 1, samples, ..self }
    }

    /// Replaces the alpha channel of a decoded picture of 8-bit colours by `alpha`; any other picture only loses its
    /// own alpha channel.
    fn with_alpha_if_rgb8(self, alpha: &[u8]) -> Self {
        let solid = self.without_alpha();
        let (Samples::U8(v), 3) = (&solid.samples, solid.channels) else { return solid };
        if alpha.len() != solid.width * solid.height {
            return solid;
        }
        let pixels = v.as_chunks::<3>().0.iter().zip(alpha);
        let samples = Samples::U8(pixels.flat_map(|(&[r, g, b], &a)| [r, g, b, a]).collect());
        Self { channels: 4, samples, ..solid }
    }

    /// Converts a decoded picture to linear light: integers are decoded by the sRGB curve, floating-point numbers are
    /// linear already.
    pub fn to_linear_image(&self) -> Frame {
        let pixels = match &self.samples {
            Samples::U8(v) => {
                self.to_linear_pixels(v, &srgb_decoding_table(255), |x| f32::from(x) / 255.0, usize::from)
            }
            Samples::U16(v) => {
                self.to_linear_pixels(v, &srgb_decoding_table(65_535), |x| f32::from(x) / 65_535.0, usize::from)
            }
            Samples::F32(v) => v.chunks_exact(self.channels).map(|p| expand_pixel(p, |x| x, |x| x)).collect(),
        };
        Frame { width: self.width, height: self.height, pixels }
    }

    fn to_linear_pixels<T: Copy>(
        &self,
        samples: &[T],
        curve: &[f32],
        alpha: impl Fn(T) -> f32,
        index: impl Fn(T) -> usize,
    ) -> Vec<[f32; 4]> {
        samples.chunks_exact(self.channels).map(|p| expand_pixel(p, |x| curve[index(x)], &alpha)).collect()
    }
}

/// Expands a pixel of one to four channels to red, green, blue and alpha, each converted by its function; a missing
/// alpha is 1.
pub fn expand_pixel<T: Copy>(pixel: &[T], color: impl Fn(T) -> f32, alpha: impl Fn(T) -> f32) -> [f32; 4] {
    match *pixel {
        [gray] => [color(gray), color(gray), color(gray), 1.0],
        [gray, a] => [color(gray), color(gray), color(gray), alpha(a)],
        [r, g, b] => [color(r), color(g), color(b), 1.0],
        [r, g, b, a] => [color(r), color(g), color(b), alpha(a)],
        _ => [0.0, 0.0, 0.0, 1.0],
    }
}

/// Returns the linear light of each sRGB code from 0 to `max`.
fn srgb_decoding_table(max: u16) -> Vec<f32> {
    (0..=max).map(|code| transfer::srgb_decode(f64::from(code) / f64::from(max)) as f32).collect()
}
