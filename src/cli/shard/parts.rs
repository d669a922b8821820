//! Combination of pictures that each show a part of one picture, as people render rows of a picture on several machines
//! with POV-Ray's options `+SR` and `+ER` (manual, "Partial Output Options").
//!
//! The rest of such a picture is black or transparent. The files say nothing about their scene, so only the pixels can
//! be checked: two pictures must not show different things at the same pixel.

use super::merge::unusable;
use crate::cli::console::Console;
use crate::cli::exit::{Exit, Result, usage_error};
use crate::cli::render::target::Target;
use crate::color::Gamma;
use crate::diagnostic::{Diagnostic, codes};
use crate::image_io::{self, Encoding, Format, Frame, Picture, Pixels, Rows, Samples, Stored};
use crate::source::{Disk, Span};
use std::path::{Path, PathBuf};

/// Combines pictures that each show a part of one picture, and writes the whole to the file `picture`.
pub fn merge(console: &Console, picture: &Path, parts: &[PathBuf]) -> Result {
    let format = Format::from_path(picture)?;
    if format == Format::Jpg {
        return usage_error("jpg files can't be combined without loss; render the parts as png");
    }
    let [first_path, rest @ ..] = parts else { return usage_error("no picture was named") };
    let mut whole = Picture::read(&Disk, first_path)?;
    // Index of the picture that each pixel was taken from, for messages
    let mut owners = vec![0; whole.pixels.width * whole.pixels.height];
    for (number, path) in (1..).zip(rest) {
        let part = Picture::read(&Disk, path)?;
        if !has_same_size_and_kind(&part, &whole) {
            let reason = format!("it has another size or kind of pixels than `{}`", first_path.display());
            return Err(unusable(path, &reason));
        }
        if let Some(at) = add_until_conflicting_pixel(&mut whole.pixels, &part.pixels, &mut owners, number) {
            let (x, y) = (at % whole.pixels.width, at / whole.pixels.width);
            let other = parts[owners[at]].display();
            return Err(unusable(path, &format!("its pixel {x},{y} is another than that of `{other}`")));
        }
    }
    write(console, picture, format, &whole)?;
    console.info(&format!("{}: {} pictures merged\n", picture.display(), parts.len()));
    empty_rows_note(&whole.pixels).iter().for_each(|note| console.info(note));
    Ok(Exit::Fine)
}

/// True if two pictures have the same size and the same kind of pixels.
fn has_same_size_and_kind(a: &Picture, b: &Picture) -> bool {
    let kind = |picture: &Picture| {
        let Pixels { width, height, channels, samples } = &picture.pixels;
        (*width, *height, *channels, std::mem::discriminant(samples))
    };
    kind(a) == kind(b) && a.stored == b.stored
}

/// Copies the pixels of `part` into those pixels of `whole` that are empty, and notes `part_number` as their owner.
/// Stops at the first pixel at which the pictures show different things, and returns its index; `None` without such a
/// pixel.
fn add_until_conflicting_pixel(
    whole: &mut Pixels,
    part: &Pixels,
    owners: &mut [usize],
    part_number: usize,
) -> Option<usize> {
    fn add<T: Copy + Default + PartialEq>(
        whole: &mut [T],
        part: &[T],
        channels: usize,
        owners: &mut [usize],
        part_number: usize,
    ) -> Option<usize> {
        let pixels = whole.chunks_exact_mut(channels).zip(part.chunks_exact(channels));
        for (at, (to, from)) in pixels.enumerate() {
            if is_empty_pixel(to, channels) {
                to.copy_from_slice(from);
                owners[at] = part_number;
            } else if !is_empty_pixel(from, channels) && to != from {
                return Some(at);
            }
        }
        None
    }
    let channels = whole.channels;
    match (&mut whole.samples, &part.samples) {
        (Samples::U8(whole), Samples::U8(part)) => add(whole, part, channels, owners, part_number),
        (Samples::U16(whole), Samples::U16(part)) => add(whole, part, channels, owners, part_number),
        (Samples::F32(whole), Samples::F32(part)) => add(whole, part, channels, owners, part_number),
        _ => Some(0),
    }
}

/// True for a pixel that is black or transparent.
fn is_empty_pixel<T: Default + PartialEq>(pixel: &[T], channels: usize) -> bool {
    let (color, alpha) = pixel.split_at(if matches!(channels, 2 | 4) { channels - 1 } else { channels });
    color.iter().all(|sample| *sample == T::default()) || alpha.iter().any(|alpha| *alpha == T::default())
}

/// Writes the picture with the kind of pixels that its parts have.
///
/// # Errors
/// E0008 if the format can't hold the pixels as they are.
fn write(console: &Console, path: &Path, format: Format, picture: &Picture) -> Result<()> {
    let Picture { pixels, stored, .. } = picture;
    let depth = match (&pixels.samples, format) {
        (Samples::U16(_), _) => 16,
        (Samples::F32(_), Format::Exr) => 32,
        _ => 8,
    };
    format.check_limits(pixels.width, pixels.height, format.has_depth().then_some(depth))?;
    let gamma = match stored {
        Stored::Power(gamma) => Gamma::Power(*gamma),
        Stored::Plain | Stored::Unsaid | Stored::Srgb => Gamma::Srgb,
    };
    let plain = Encoding::new(format);
    // The decoder of exr adds an opaque alpha to files without alpha.
    let alpha = matches!(pixels.channels, 2 | 4) && !(format == Format::Exr && is_opaque_float_picture(pixels));
    let gray = pixels.channels <= 2;
    let encoding = Encoding { depth, alpha, gray: gray && format.has_gray(), gamma, ..plain };
    let light = linear_frame(pixels, gamma);
    let bytes = image_io::encode(&light, &encoding)?;
    let ending = path.extension().and_then(|ending| ending.to_str()).unwrap_or_default();
    if !image_io::decode_pixels(&bytes, ending).is_ok_and(|stored| stored == *pixels) {
        let text = format!("{} can't hold the pixels of the parts without loss", format.name());
        let help = "give the picture the format of the parts";
        return Err(Box::new(Diagnostic::new(codes::FORMAT_LIMIT, Span::NONE, text).help(help)).into());
    }
    let target = Target::of_file(path, encoding);
    target.check_file_writable()?;
    let mut draft = target.start_draft()?;
    let mut writer = target.writer(draft.as_mut(), (light.width, light.height))?;
    writer.write_rows(&light.pixels)?;
    writer.finish()?;
    target.commit(console, draft)?;
    Ok(())
}

/// True for a picture of floating-point numbers whose alpha is 1 everywhere.
fn is_opaque_float_picture(pixels: &Pixels) -> bool {
    let Samples::F32(samples) = &pixels.samples else { return false };
    samples.iter().skip(pixels.channels - 1).step_by(pixels.channels).all(|alpha| *alpha == 1.0)
}

/// Returns the linear light of a picture whose samples have this transfer curve.
fn linear_frame(pixels: &Pixels, gamma: Gamma) -> Frame {
    let Gamma::Power(_) = gamma else { return pixels.to_linear_image() };
    let decode = |sample: f64| gamma.decode(sample) as f32;
    let expand = |pixel: &[f64]| image_io::expand_pixel(pixel, decode, |alpha| alpha as f32);
    let samples: Vec<f64> = match &pixels.samples {
        Samples::U8(codes) => codes.iter().map(|&code| f64::from(code) / 255.0).collect(),
        Samples::U16(codes) => codes.iter().map(|&code| f64::from(code) / 65_535.0).collect(),
        Samples::F32(light) => light.iter().map(|&light| f64::from(light)).collect(),
    };
    let light = samples.chunks_exact(pixels.channels).map(expand).collect();
    Frame { width: pixels.width, height: pixels.height, pixels: light }
}

/// Returns a line about rows that no picture shows; `None` if there are none.
fn empty_rows_note(pixels: &Pixels) -> Option<String> {
    fn empty_rows<T: Default + PartialEq>(samples: &[T], width: usize, channels: usize) -> Vec<usize> {
        let rows = samples.chunks_exact(width * channels).enumerate();
        let is_empty_row = |row: &[T]| row.chunks_exact(channels).all(|pixel| is_empty_pixel(pixel, channels));
        rows.filter(|(_, row)| is_empty_row(row)).map(|(y, _)| y).collect()
    }
    let rows = match &pixels.samples {
        Samples::U8(samples) => empty_rows(samples, pixels.width, pixels.channels),
        Samples::U16(samples) => empty_rows(samples, pixels.width, pixels.channels),
        Samples::F32(samples) => empty_rows(samples, pixels.width, pixels.channels),
    };
    let (first, n) = (rows.first()?, rows.len());
    let rows = if n == 1 { "row is" } else { "rows are" };
    Some(format!("{n} {rows} black in all pictures; the first is row {}, counted from 1\n", first + 1))
}
