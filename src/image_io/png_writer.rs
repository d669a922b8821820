//! PNG files, row by row, by the crate `png`.

use super::encode::{EncodeError, Encoded, Encoding};
use crate::color::Gamma;
use png::{BitDepth, ColorType, DeflateCompression, EncodingError, Filter, ScaledFloat, SrgbRenderingIntent};
use std::io::{self, Write};
use std::sync::{Arc, Mutex, PoisonError};

/// Compression level of a PNG file's deflate data, from 1 to 9. Pictures of POV-Ray's scenes at 640x480 take 7 ms with filters by
/// the sum of differences, and 13 ms at level 6 with filters by entropy, whose files are 3.5 % smaller.
const LEVEL: u8 = 4;
/// Size of a chunk of a PNG file's compressed data, in bytes.
const CHUNK: usize = 1 << 16;

/// A PNG file that is being written.
pub(super) struct PngWriter<W: Write> {
    out: W,
    png: png::StreamWriter<'static, MemoryBuffer>,
    encoded: MemoryBuffer,
}

/// Bytes of the PNG file that are not yet written to `out`. (The stream writer has to own what it writes to, and `out`
/// may be borrowed.)
#[derive(Clone, Default)]
struct MemoryBuffer(Arc<Mutex<Vec<u8>>>);

impl MemoryBuffer {
    fn take_bytes(&self) -> Vec<u8> {
        std::mem::take(&mut self.0.lock().unwrap_or_else(PoisonError::into_inner))
    }
}

impl Write for MemoryBuffer {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        self.0.lock().unwrap_or_else(PoisonError::into_inner).extend(bytes);
        Ok(bytes.len())
    }

    fn flush(&mut self) -> io::Result<()> {
        Ok(())
    }
}

impl<W: Write> PngWriter<W> {
    /// Writes all chunks of a PNG file before the pixels.
    pub fn new(out: W, width: usize, height: usize, encoding: &Encoding) -> Encoded<Self> {
        let side = |side: usize| {
            let side = u32::try_from(side).ok().filter(|side| i32::try_from(*side).is_ok());
            side.ok_or_else(|| EncodeError::Format("it is too large".into()))
        };
        let encoded = MemoryBuffer::default();
        let mut encoder = png::Encoder::new(encoded.clone(), side(width)?, side(height)?);
        encoder.set_color(match (encoding.gray, encoding.keeps_alpha()) {
            (true, false) => ColorType::Grayscale,
            (true, true) => ColorType::GrayscaleAlpha,
            (false, false) => ColorType::Rgb,
            (false, true) => ColorType::Rgba,
        });
        encoder.set_depth(if encoding.depth == 16 { BitDepth::Sixteen } else { BitDepth::Eight });
        match encoding.gamma {
            Gamma::Power(gamma) => {
                encoder.set_source_gamma(ScaledFloat::from_scaled((100_000.0 / gamma).round() as u32));
            }
            Gamma::Srgb | Gamma::Raw => {
                // Readers that do not support the chunk `sRGB` use the gamma chunk.
                encoder.set_source_gamma(ScaledFloat::from_scaled(45_455));
                encoder.set_source_srgb(SrgbRenderingIntent::Perceptual);
            }
        }
        encoder.set_deflate_compression(DeflateCompression::Level(LEVEL));
        encoder.set_filter(Filter::Adaptive);
        let png = encoder.write_header()?.into_stream_writer_with_size(CHUNK)?;
        Ok(Self { out, png, encoded })
    }

    /// Writes whole rows of a PNG file; 16-bit samples have the high byte first.
    pub fn write_rows(&mut self, rows: &[u8]) -> Encoded {
        self.png.write_all(rows)?;
        Ok(self.out.write_all(&self.encoded.take_bytes())?)
    }

    /// Ends the PNG file after its last row.
    pub fn finish(mut self) -> Encoded {
        self.png.finish()?;
        self.out.write_all(&self.encoded.take_bytes())?;
        Ok(self.out.flush()?)
    }
}

impl From<EncodingError> for EncodeError {
    fn from(error: EncodingError) -> Self {
        match error {
            EncodingError::IoError(error) => error.into(),
            error => Self::Format(error.to_string()),
        }
    }
}
