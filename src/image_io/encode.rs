//! Encoders of picture files, row by row from the top. Equal pictures give equal bytes.

use super::dither::{Dither, Ditherer};
use super::png_piece::{CompressedPieces, Pieces};
use super::png_writer::PngWriter;
use super::quantize::{Integers, composite_over_black};
use super::{Format, Frame};
use crate::color::{Gamma, gray};
use crate::diagnostic::{Diagnostic, Fault, Result, codes};
use crate::source::Span;
use exr::image::Blocks;
use exr::prelude::{Compression, Encoding as ExrEncoding, Image, LineOrder, SpecificChannels, WritableImage, f16};
use image::codecs::{bmp::BmpEncoder, hdr::HdrEncoder, jpeg::JpegEncoder, tga::TgaEncoder, tiff::TiffEncoder};
use image::{ExtendedColorType, ImageEncoder, ImageError, Rgb};
use std::io::{self, Cursor, Seek, Write};

/// Format and options of a picture file.
#[derive(Clone, Copy, Debug, PartialEq, serde::Serialize, serde::Deserialize)]
pub struct Encoding {
    /// File format of the encoded picture.
    pub format: Format,
    /// Bits per channel of the encoded picture, where the format has a choice: 8 or 16, for exr 16 or 32.
    pub depth: u8,
    /// True to encode transparency, where the format can; otherwise the picture is composited over black.
    pub alpha: bool,
    /// True to encode brightness alone, as height fields do, where the format can: png and ppm, which is then pgm.
    pub gray: bool,
    /// Transfer curve of the picture's integer codes.
    pub gamma: Gamma,
    /// Dithering of the picture's codes; formats without integers ignore it.
    pub dither: Option<Dither>,
    /// Compression of an OpenEXR or TGA picture; the other formats have no choice.
    pub packing: Packing,
}

/// Compression methods of OpenEXR and TGA pictures.
#[derive(Clone, Copy, Debug, PartialEq, Eq, serde::Serialize, serde::Deserialize)]
pub enum Packing {
    /// Stores an OpenEXR or TGA picture without compression.
    None,
    /// Run-length encoding by lines; for OpenEXR ten times as fast as the denser methods.
    Runs,
    /// Deflate, sixteen lines at once; for OpenEXR alone.
    Zip,
}

impl Encoding {
    /// Default encoding for a format: 8 bits a channel, or 32 for exr; the sRGB curve, no transparency; run lengths for
    /// exr, and tga uncompressed.
    pub fn new(format: Format) -> Self {
        let depth = if format == Format::Exr { 32 } else { 8 };
        let packing = if format == Format::Exr { Packing::Runs } else { Packing::None };
        Self { format, depth, alpha: false, gray: false, gamma: Gamma::Srgb, dither: None, packing }
    }

    pub(super) fn keeps_alpha(&self) -> bool {
        self.alpha && self.format.has_alpha()
    }

    /// True if the encoder stores the light of all pixels until the last row: the rows of bmp files start at the
    /// bottom, and error diffusion does too (quirk: `bmp_dithers_upwards`; patterns start at the top).
    fn buffers_light(&self) -> bool {
        let hands_on = self.dither.is_some_and(|dither| !matches!(dither, Dither::Bayer(_)));
        self.format == Format::Exr || self.format == Format::Bmp && hands_on
    }

    /// Memory that the encoder needs per pixel until the file is finished, in bytes.
    pub fn buffered_bytes_per_pixel(&self) -> usize {
        match self.format {
            Format::Png | Format::Ppm | Format::Hdr => 0,
            _ if self.buffers_light() => size_of::<[f32; 4]>(),
            _ => usize::from(self.depth / 8) * if self.keeps_alpha() { 4 } else { 3 },
        }
    }
}

/// Consumer of a picture's rows of linear light, some whole rows at a time, from the top; pixels are those of a
/// [`Frame`].
pub trait Rows: Send {
    /// Consumes the picture's next rows.
    ///
    /// # Errors
    /// The reason why the rows can't be stored.
    fn write_rows(&mut self, rows: &[[f32; 4]]) -> Result<()>;

    /// Removes and returns the pieces of the file that are complete and not yet compressed. The caller compresses them on any
    /// thread, and passes them to [`write_pieces`](Rows::write_pieces). Pieces that are not taken are compressed in later calls
    /// of `write_rows`, and at the end of the file.
    fn take_pieces(&mut self) -> Pieces {
        Pieces::default()
    }

    /// Writes compressed pieces.
    ///
    /// # Errors
    /// The reason why the pieces can't be stored.
    fn write_pieces(&mut self, _: CompressedPieces) -> Result<()> {
        Ok(())
    }
}

impl Rows for Frame {
    fn write_rows(&mut self, rows: &[[f32; 4]]) -> Result<()> {
        self.pixels.extend_from_slice(rows);
        Ok(())
    }
}

/// The reason why a picture could not be encoded or written.
#[derive(Debug)]
pub enum EncodeError {
    /// Encoding failed because the picture's file can't be written.
    Io(io::Error),
    /// Encoding failed because the format can't hold the picture, with the reason.
    Format(String),
}

impl EncodeError {
    /// Converts the error to a diagnostic: E0008 if the format can't hold the picture, or the result of `unwritable` if
    /// the file can't be written.
    pub fn into_fault(self, format: Format, unwritable: impl FnOnce(&io::Error) -> Diagnostic) -> Fault {
        Box::new(match self {
            Self::Io(error) => unwritable(&error),
            Self::Format(reason) => {
                let text = format!("{} can't hold this picture: {reason}", format.name());
                Diagnostic::new(codes::FORMAT_LIMIT, Span::NONE, text)
            }
        })
    }
}

impl From<io::Error> for EncodeError {
    fn from(error: io::Error) -> Self {
        Self::Io(error)
    }
}

impl From<ImageError> for EncodeError {
    fn from(error: ImageError) -> Self {
        match error {
            ImageError::IoError(error) => Self::Io(error),
            other => Self::Format(other.to_string()),
        }
    }
}

impl From<exr::error::Error> for EncodeError {
    fn from(error: exr::error::Error) -> Self {
        match error {
            exr::error::Error::Io(error) => Self::Io(error),
            other => Self::Format(other.to_string()),
        }
    }
}

pub(super) type Encoded<T = ()> = std::result::Result<T, EncodeError>;

/// Quality of JPEG, from 1 to 100.
const JPEG_QUALITY: u8 = 92;

/// A picture file that is being written: rows are passed from the top, and are written immediately where the format
/// allows it.
pub struct Encoder<W: Write + Seek> {
    encoding: Encoding,
    width: usize,
    height: usize,
    integers: Integers,
    out: Out<W>,
}

enum Out<W: Write + Seek> {
    /// PNG encoder, which collects the rows of a few pieces.
    Png(Box<PngWriter<W>>),
    Flat(W),
    /// Encoder of a format of integers, which collects the samples of all rows until the last one.
    Integers(W, Vec<u8>),
    Floats(W, Vec<[f32; 4]>),
}

impl<W: Write + Seek> Encoder<W> {
    /// Begins the file of a picture of this size: integers follow the transfer curve of `encoding`, floating-point
    /// formats have linear light.
    ///
    /// # Errors
    /// If the format can't hold the picture, or the file can't be written.
    pub fn new(mut out: W, width: usize, height: usize, encoding: &Encoding) -> Encoded<Self> {
        let out = match encoding.format {
            Format::Png => Out::Png(Box::new(PngWriter::new(out, width, height, encoding)?)),
            Format::Ppm => {
                let kind = if encoding.gray { "P5" } else { "P6" };
                write!(out, "{kind}\n{width} {height}\n{}\n", if encoding.depth == 16 { 65_535 } else { 255 })?;
                Out::Flat(out)
            }
            Format::Hdr => {
                out.write_all(encode_hdr_around_size(&[Rgb([0.0; 3])], 1, 1)?.0.as_slice())?;
                writeln!(out, "-Y {height} +X {width}")?;
                Out::Flat(out)
            }
            _ if encoding.buffers_light() => Out::Floats(out, vec![]),
            _ => Out::Integers(out, vec![]),
        };
        let alpha = encoding.keeps_alpha();
        let dither = encoding.dither.filter(|_| encoding.format != Format::Jpg);
        let ditherer = dither.map(|dither| Ditherer::new(dither, width, if alpha { 4 } else { 3 }));
        let integers = Integers { wide: encoding.depth == 16, alpha, gamma: encoding.gamma, ditherer, width };
        Ok(Self { encoding: *encoding, width, height, integers, out })
    }

    /// Adds rows to a picture file.
    ///
    /// # Errors
    /// If they can't be written.
    pub fn write_rows(&mut self, rows: &[[f32; 4]]) -> Encoded {
        let Self { encoding, width, .. } = *self;
        let grays: Vec<_>;
        let rows = if encoding.gray {
            grays = rows.iter().map(gray_pixel).collect();
            &grays[..]
        } else {
            rows
        };
        let mut stored = |high_first| {
            let all = self.integers.encode_rows(rows, high_first);
            if encoding.gray { drop_equal_channels(&all, encoding) } else { all }
        };
        match &mut self.out {
            Out::Png(out) => out.write_rows(&stored(true))?,
            Out::Flat(out) if encoding.format == Format::Hdr => {
                let rgb: Vec<_> = rows.iter().map(|&p| Rgb(composite_over_black(p).map(clamp_to_rgbe))).collect();
                out.write_all(&encode_hdr_around_size(&rgb, width, rows.len() / width)?.1)?;
            }
            Out::Flat(out) => out.write_all(&stored(true))?,
            Out::Integers(_, kept) => {
                kept.reserve_exact(
                    (self.height * width * encoding.buffered_bytes_per_pixel()).saturating_sub(kept.len()),
                );
                kept.extend(stored(false));
            }
            Out::Floats(_, kept) => {
                kept.reserve_exact((self.height * width).saturating_sub(kept.len()));
                kept.extend(rows);
            }
        }
        Ok(())
    }

    /// Removes and returns the pieces of the file that are complete and not yet compressed, as [`Rows::take_pieces`] does.
    pub fn take_pieces(&mut self) -> Pieces {
        match &mut self.out {
            Out::Png(out) => out.take_pieces(),
            Out::Flat(_) | Out::Integers(..) | Out::Floats(..) => Pieces::default(),
        }
    }

    /// Writes compressed pieces, in any order.
    ///
    /// # Errors
    /// If they can't be written.
    pub fn write_pieces(&mut self, pieces: CompressedPieces) -> Encoded {
        match &mut self.out {
            Out::Png(out) => out.write_pieces(pieces),
            Out::Flat(_) | Out::Integers(..) | Out::Floats(..) => Ok(()),
        }
    }

    /// Ends a picture file: writes what is not yet written.
    ///
    /// # Errors
    /// If it can't be written, or the format can't hold the picture.
    pub fn finish(mut self) -> Encoded {
        let size = (self.width, self.height);
        match self.out {
            Out::Png(out) => out.finish()?,
            Out::Flat(mut out) => out.flush()?,
            Out::Floats(mut out, pixels) if self.encoding.format == Format::Bmp => {
                let rows = pixels.chunks(self.width.max(1)).rev();
                let rows: Vec<_> = rows.map(|row| self.integers.encode_rows(row, false)).collect();
                encode_integers(&mut out, size, &rows.into_iter().rev().flatten().collect::<Vec<_>>(), &self.encoding)?;
            }
            Out::Floats(mut out, pixels) => encode_exr(&mut out, size, &pixels, &self.encoding)?,
            Out::Integers(mut out, data) => encode_integers(&mut out, size, &data, &self.encoding)?,
        }
        Ok(())
    }
}

/// Encodes a whole picture; returns the bytes of the file.
///
/// # Errors
/// E0008 if the format can't hold the picture.
pub fn encode(frame: &Frame, encoding: &Encoding) -> Result<Vec<u8>> {
    let mut out = Cursor::new(Vec::new());
    let written = Encoder::new(&mut out, frame.width, frame.height, encoding).and_then(|mut encoder| {
        encoder.write_rows(&frame.pixels)?;
        encoder.finish()
    });
    let fault = |e: &io::Error| Diagnostic::new(codes::FORMAT_LIMIT, Span::NONE, e.to_string());
    written.map_err(|error| error.into_fault(encoding.format, fault))?;
    Ok(out.into_inner())
}

fn encode_integers<W: Write + Seek>(
    out: &mut W,
    (width, height): (usize, usize),
    data: &[u8],
    how: &Encoding,
) -> Encoded {
    let color = match (how.depth == 16, how.keeps_alpha()) {
        (false, false) => ExtendedColorType::Rgb8,
        (false, true) => ExtendedColorType::Rgba8,
        (true, false) => ExtendedColorType::Rgb16,
        (true, true) => ExtendedColorType::Rgba16,
    };
    let (width, height) = (width as u32, height as u32);
    match how.format {
        Format::Jpg => JpegEncoder::new_with_quality(out, JPEG_QUALITY).write_image(data, width, height, color)?,
        Format::Bmp => BmpEncoder::new(out).write_image(data, width, height, color)?,
        Format::Tga if how.packing == Packing::None => {
            TgaEncoder::new(out).disable_rle().write_image(data, width, height, color)?;
        }
        Format::Tga => encode_tga_runs(out, data, (width, height), color)?,
        _ => TiffEncoder::new(out).write_image(data, width, height, color)?,
    }
    Ok(())
}

/// Writes a TGA picture in run lengths. Each row is encoded by itself, since a packet may not continue in the next row
/// (Truevision TGA File Format Specification 2.0, 1991, page 24).
fn encode_tga_runs<W: Write>(
    out: &mut W,
    data: &[u8],
    (width, height): (u32, u32),
    color: ExtendedColorType,
) -> Encoded {
    const HEADER: usize = 18;
    const HEIGHT_FIELD: std::ops::Range<usize> = 14..16;
    let row_bytes = width as usize * usize::from(color.channel_count());
    for (i, row) in data.chunks(row_bytes.max(1)).enumerate() {
        let mut file = vec![];
        TgaEncoder::new(&mut file).write_image(row, width, 1, color)?;
        if i == 0 {
            file[HEIGHT_FIELD].copy_from_slice(&(height as u16).to_le_bytes());
        } else {
            file.drain(..HEADER);
        }
        out.write_all(&file)?;
    }
    Ok(())
}

/// Writes an OpenEXR picture. Alpha is associated (colours are multiplied by it), as OpenEXR's specification demands.
fn encode_exr<W: Write + Seek>(out: &mut W, size: (usize, usize), pixels: &[[f32; 4]], how: &Encoding) -> Encoded {
    let compression = match how.packing {
        Packing::None => Compression::Uncompressed,
        Packing::Runs => Compression::RLE,
        Packing::Zip => Compression::ZIP16,
    };
    let packing = ExrEncoding { compression, blocks: Blocks::ScanLines, line_order: LineOrder::Increasing };
    let pixel = |at: exr::math::Vec2<usize>| pixels[at.y() * size.0 + at.x()].map(nan_to_zero);
    let rgb = |at| composite_over_black(pixel(at));
    let rgba = |at| {
        let [r, g, b, a] = pixel(at);
        [r * a, g * a, b * a, a]
    };
    let half = f16::from_f32;
    // (Each of these is a type of its own in the crate.)
    macro_rules! write {
        ($channels:expr) => {
            Image::from_encoded_channels(size, packing, $channels).write().non_parallel().to_buffered(out)?
        };
    }
    match (how.keeps_alpha(), how.depth == 16) {
        (false, false) => write!(SpecificChannels::rgb(|at| <(f32, f32, f32)>::from(rgb(at)))),
        (false, true) => write!(SpecificChannels::rgb(|at| <(f16, f16, f16)>::from(rgb(at).map(half)))),
        (true, false) => write!(SpecificChannels::rgba(|at| <(f32, f32, f32, f32)>::from(rgba(at)))),
        (true, true) => write!(SpecificChannels::rgba(|at| <(f16, f16, f16, f16)>::from(rgba(at).map(half)))),
    }
    Ok(())
}

/// Clamps a channel to what a shared exponent of eight bits can express: 0, or 2⁻¹²⁷ to 2¹²⁶.
fn clamp_to_rgbe(channel: f32) -> f32 {
    let (least, largest) = (2f32.powi(-127), 2f32.powi(126));
    let channel = nan_to_zero(channel);
    if channel < least { 0.0 } else { channel.min(largest) }
}

/// Encodes a Radiance HDR picture of these rows; returns the file's bytes before the size and after it.
fn encode_hdr_around_size(rows: &[Rgb<f32>], width: usize, height: usize) -> Encoded<(Vec<u8>, Vec<u8>)> {
    let mut file = Vec::new();
    HdrEncoder::new(&mut file).encode(rows, width, height)?;
    let size = format!("-Y {height} +X {width}\n");
    let at = memchr::memmem::find(&file, size.as_bytes()).unwrap_or(0);
    let behind = file.split_off(at + size.len());
    file.truncate(at);
    Ok((file, behind))
}

/// Returns a gray pixel of equal brightness.
fn gray_pixel(&[r, g, b, a]: &[f32; 4]) -> [f32; 4] {
    let gray = gray(crate::color::Rgb::new(f64::from(r), f64::from(g), f64::from(b))) as f32;
    [gray, gray, gray, a]
}

/// Removes two of three equal colour channels from encoded gray pixels, and keeps alpha.
fn drop_equal_channels(pixels: &[u8], encoding: Encoding) -> Vec<u8> {
    let number = usize::from(encoding.depth / 8);
    let pixel = number * if encoding.keeps_alpha() { 4 } else { 3 };
    pixels.chunks(pixel).flat_map(|pixel| pixel[..number].iter().chain(&pixel[3 * number..])).copied().collect()
}

/// Replaces NaN by 0 in a sample: NaN would spread through every program that reads the file.
fn nan_to_zero(x: f32) -> f32 {
    if x.is_nan() { 0.0 } else { x }
}
