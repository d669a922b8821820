//! Decoder of OpenEXR files, by the crate `exr`.

use super::Frame;
use super::decode::{Pixels, Samples};
use exr::meta::MetaData;
use exr::prelude::{ReadChannels, ReadLayers, ReadSpecificChannel};
use std::io::Cursor;

/// Maximum number of pixels for each byte of the file. No compression of the format exceeds that of ZIP, 1032 to 1, and
/// a sample has at least two bytes.
const MAX_PIXELS_PER_BYTE: usize = 516;

/// Decodes an OpenEXR file: the first layer with red, green and blue, or with luminance alone.
///
/// # Errors
/// The reason why the bytes are not such a picture, in words.
pub(super) fn decode_exr(bytes: &[u8]) -> Result<Pixels, String> {
    refuse_too_few_bytes(bytes)?;
    let pixels = decode_rgba(bytes).or_else(|fault| decode_luminance(bytes).map_err(|_| fault));
    pixels.map_err(|fault| fault.to_string())
}

/// Refuses a file that is too small for the size in its header, before memory for that size is reserved.
fn refuse_too_few_bytes(bytes: &[u8]) -> Result<(), String> {
    let meta = MetaData::read_from_buffered(Cursor::new(bytes), false).map_err(|fault| fault.to_string())?;
    let fits = |size: exr::math::Vec2<usize>| {
        let area = size.width().checked_mul(size.height());
        area.is_some_and(|area| area <= bytes.len().saturating_mul(MAX_PIXELS_PER_BYTE))
    };
    match meta.headers.iter().map(|header| header.layer_size).find(|size| !fits(*size)) {
        Some(size) => Err(format!("its header says {} x {} pixels, but it is too small", size.width(), size.height())),
        None => Ok(()),
    }
}

/// Decodes an OpenEXR file that has red, green and blue.
fn decode_rgba(bytes: &[u8]) -> exr::error::Result<Pixels> {
    let image = exr::prelude::read()
        .no_deep_data()
        .largest_resolution_level()
        .rgba_channels(
            |size, _| Frame::new(size.width(), size.height()),
            |frame: &mut Frame, at, (r, g, b, a): (f32, f32, f32, f32)| {
                let k = if a == 0.0 { 1.0 } else { 1.0 / a };
                frame.pixels[at.y() * frame.width + at.x()] = [r * k, g * k, b * k, a];
            },
        )
        .first_valid_layer()
        .all_attributes()
        .non_parallel()
        .from_buffered(Cursor::new(bytes))?;
    let frame = image.layer_data.channel_data.pixels;
    let samples = Samples::F32(frame.pixels.into_iter().flatten().collect());
    Ok(Pixels { width: frame.width, height: frame.height, channels: 4, samples })
}

/// Decodes an OpenEXR file that has luminance alone.
fn decode_luminance(bytes: &[u8]) -> exr::error::Result<Pixels> {
    let image = exr::prelude::read()
        .no_deep_data()
        .largest_resolution_level()
        .specific_channels()
        .required("Y")
        .collect_pixels(
            |size, _| Pixels {
                width: size.width(),
                height: size.height(),
                channels: 1,
                samples: Samples::F32(vec![0.0; size.area()]),
            },
            |pixels: &mut Pixels, at, (y,): (f32,)| {
                if let Samples::F32(samples) = &mut pixels.samples {
                    samples[at.y() * pixels.width + at.x()] = y;
                }
            },
        )
        .first_valid_layer()
        .all_attributes()
        .non_parallel()
        .from_buffered(Cursor::new(bytes))?;
    Ok(image.layer_data.channel_data.pixels)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Encodes a black OpenEXR file, and returns it with the place of its data window's upper corner.
    fn black(width: usize, height: usize) -> (Vec<u8>, usize) {
        let mut bytes = Cursor::new(vec![]);
        let image = exr::image::Image::from_channels(
            (width, height),
            exr::image::SpecificChannels::rgb(|_| (0f32, 0f32, 0f32)),
        );
        exr::prelude::WritableImage::write(&image).non_parallel().to_buffered(&mut bytes).unwrap();
        let bytes = bytes.into_inner();
        let name = b"dataWindow\0box2i\0";
        let place = bytes.windows(name.len()).position(|part| part == name).unwrap() + name.len() + 4 + 8;
        (bytes, place)
    }

    #[test]
    fn a_size_beyond_the_file_is_refused() {
        let (mut bytes, place) = black(64, 32);
        let pixels = decode_exr(&bytes).unwrap();
        assert_eq!((pixels.width, pixels.height, pixels.channels), (64, 32, 4));
        for corner in [[0x00ff_ffff, 0x00ff_ffff], [0x0fff_fff0, 31], [63, 0x000f_ffff]] {
            bytes[place..place + 8].copy_from_slice(&corner.map(i32::to_le_bytes).concat());
            let fault = decode_exr(&bytes).unwrap_err();
            assert!(fault.contains("too small"), "{fault}");
        }
    }
}
