//! PNG files, row by row. The crate `png` writes the chunks; the pixels are compressed in pieces of a fixed number of rows,
//! so that the bytes of a file depend neither on threads nor on the calls in which its rows arrive.

use super::adler32::Adler32;
use super::encode::{EncodeError, Encoded, Encoding};
use super::png_piece::{CompressedPiece, CompressedPieces, Piece, Pieces, RowFormat};
use crate::color::Gamma;
use crate::math::fork;
use flate2::CompressError;
use png::{BitDepth, ColorType, EncodingError, ScaledFloat, SrgbRenderingIntent};
use std::collections::BTreeMap;
use std::io::Write;

/// Maximum size of a chunk of a PNG file's compressed data, in bytes.
const CHUNK: usize = 1 << 16;

/// A PNG file that is being written.
pub(super) struct PngWriter<W: Write> {
    out: png::Writer<W>,
    format: RowFormat,
    /// Number of rows that have not yet arrived.
    n_rows_left: usize,
    /// Samples of the rows that are not yet a piece.
    gathered: Vec<u8>,
    /// Samples of the row above those in `gathered`.
    above: Vec<u8>,
    /// Pieces that are not yet compressed.
    complete: Vec<Piece>,
    /// Number of pieces that were formed so far.
    n_formed: usize,
    /// Number of pieces that were written so far.
    n_written: usize,
    /// Compressed pieces by their indices, which wait for an earlier piece.
    waiting: BTreeMap<usize, CompressedPiece>,
    /// True after the last piece was written.
    has_all_pixels: bool,
    /// Checksum of the filtered rows that were written so far.
    checksum: Adler32,
}

impl<W: Write> PngWriter<W> {
    /// Writes all chunks of a PNG file before the pixels.
    pub fn new(out: W, width: usize, height: usize, encoding: &Encoding) -> Encoded<Self> {
        let side = |side: usize| {
            let side = u32::try_from(side).ok().filter(|side| i32::try_from(*side).is_ok());
            side.ok_or_else(|| EncodeError::Format("it is too large".into()))
        };
        let mut encoder = png::Encoder::new(out, side(width)?, side(height)?);
        let color = match (encoding.gray, encoding.keeps_alpha()) {
            (true, false) => ColorType::Grayscale,
            (true, true) => ColorType::GrayscaleAlpha,
            (false, false) => ColorType::Rgb,
            (false, true) => ColorType::Rgba,
        };
        encoder.set_color(color);
        let (depth, sample_bytes) = if encoding.depth == 16 { (BitDepth::Sixteen, 2) } else { (BitDepth::Eight, 1) };
        encoder.set_depth(depth);
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
        let pixel_bytes = color.samples() * sample_bytes;
        let format = RowFormat { row_bytes: width * pixel_bytes, pixel_bytes };
        Ok(Self {
            out: encoder.write_header()?,
            format,
            n_rows_left: height,
            gathered: vec![],
            above: vec![0; format.row_bytes],
            complete: vec![],
            n_formed: 0,
            n_written: 0,
            waiting: BTreeMap::new(),
            has_all_pixels: false,
            checksum: Adler32::default(),
        })
    }

    /// Adds whole rows; 16-bit samples have the high byte first. Pieces that an earlier call has completed and nobody has
    /// taken are written first, as soon as there is one for each thread that the calling thread may use.
    pub fn write_rows(&mut self, mut samples: &[u8]) -> Encoded {
        if !self.complete.is_empty() && self.complete.len() >= fork::threads() {
            self.write_complete_pieces()?;
        }
        let n_rows = samples.len() / self.format.row_bytes;
        let rows_left = self.n_rows_left.checked_sub(n_rows);
        self.n_rows_left = rows_left.ok_or_else(|| EncodeError::Format("it has more rows than its height".into()))?;
        while !samples.is_empty() {
            let n_missing = self.format.samples_per_piece() - self.gathered.len();
            let (taken, rest) = samples.split_at(n_missing.min(samples.len()));
            self.gathered.extend_from_slice(taken);
            samples = rest;
            let is_last = rest.is_empty() && self.n_rows_left == 0;
            if is_last || taken.len() == n_missing {
                self.form_piece(is_last);
            }
        }
        Ok(())
    }

    /// Makes a piece of the rows that were gathered.
    fn form_piece(&mut self, is_last: bool) {
        let samples = std::mem::take(&mut self.gathered);
        let last_row = samples[samples.len() - self.format.row_bytes..].to_vec();
        let above = std::mem::replace(&mut self.above, last_row);
        self.complete.push(Piece { format: self.format, index: self.n_formed, above, samples, is_last });
        self.n_formed += 1;
    }

    /// Removes the pieces that are not yet compressed. The caller passes them to `write_pieces`.
    pub fn take_pieces(&mut self) -> Pieces {
        Pieces(std::mem::take(&mut self.complete))
    }

    /// Writes compressed pieces, in the order of their rows: a piece waits until all earlier pieces are written.
    pub fn write_pieces(&mut self, pieces: CompressedPieces) -> Encoded {
        self.waiting.extend(pieces.0?.into_iter().map(|piece| (piece.index, piece)));
        while let Some(mut piece) = self.waiting.remove(&self.n_written) {
            self.n_written += 1;
            self.checksum = self.checksum.then(piece.checksum);
            if piece.is_last {
                piece.data.extend(self.checksum.to_bytes());
                self.has_all_pixels = true;
            }
            for chunk in piece.data.chunks(CHUNK) {
                self.out.write_chunk(png::chunk::IDAT, chunk)?;
            }
        }
        Ok(())
    }

    fn write_complete_pieces(&mut self) -> Encoded {
        let pieces = self.take_pieces();
        self.write_pieces(pieces.compress())
    }

    /// Ends the PNG file after its last row.
    pub fn finish(mut self) -> Encoded {
        self.write_complete_pieces()?;
        if !self.has_all_pixels {
            return Err(EncodeError::Format("some of its rows are missing".into()));
        }
        Ok(self.out.finish()?)
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

impl From<CompressError> for EncodeError {
    fn from(error: CompressError) -> Self {
        Self::Format(error.to_string())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::image_io::Format;
    use std::io::{self, Cursor};

    /// Samples of a picture: gradients, with noise in some rows.
    fn samples(width: usize, height: usize, pixel_bytes: usize) -> Vec<u8> {
        let noise = |i: usize| (i as u32).wrapping_mul(2_654_435_761) >> 28;
        let sample =
            |y: usize, i: usize| (i / 8 + y * 3) as u8 ^ if y % 7 < 3 { noise(y * width + i) as u8 } else { 0 };
        (0..height).flat_map(|y| (0..width * pixel_bytes).map(move |i| sample(y, i))).collect()
    }

    fn encoding(depth: u8, alpha: bool, gray: bool) -> Encoding {
        Encoding { depth, alpha, gray, ..Encoding::new(Format::Png) }
    }

    /// Returns the file of a picture whose rows arrive in bands of these numbers of rows, again and again.
    fn file(size: [usize; 2], encoding: &Encoding, samples: &[u8], bands: &[usize]) -> Vec<u8> {
        let mut out = vec![];
        let mut writer = PngWriter::new(&mut out, size[0], size[1], encoding).unwrap();
        let mut rest = samples;
        for band in bands.iter().cycle() {
            let taken = rest.split_off(..(band * writer.format.row_bytes).min(rest.len())).unwrap();
            writer.write_rows(taken).unwrap();
            if rest.is_empty() {
                break;
            }
        }
        writer.finish().unwrap();
        out
    }

    fn decoded(file: &[u8]) -> Vec<u8> {
        let mut options = png::DecodeOptions::default();
        options.set_ignore_adler32(false);
        let mut reader = png::Decoder::new_with_options(Cursor::new(file), options).read_info().unwrap();
        let mut samples = vec![0; reader.output_buffer_size().unwrap()];
        reader.next_frame(&mut samples).unwrap();
        samples
    }

    #[test]
    fn samples_survive_for_every_number_of_pieces() {
        for (depth, alpha, gray) in
            [8, 16].into_iter().flat_map(|d| [(d, false, false), (d, true, false), (d, false, true), (d, true, true)])
        {
            let encoding = encoding(depth, alpha, gray);
            let pixel_bytes = usize::from(depth / 8) * (if gray { 1 } else { 3 } + usize::from(alpha));
            let width = 4096 / pixel_bytes;
            let format = RowFormat { row_bytes: width * pixel_bytes, pixel_bytes };
            let piece = format.samples_per_piece() / format.row_bytes;
            assert!(piece > 100);
            let heights = if pixel_bytes == 3 { vec![1, piece - 1, piece, 2 * piece] } else { vec![piece + 1] };
            for height in heights {
                let samples = samples(width, height, pixel_bytes);
                let file = file([width, height], &encoding, &samples, &[height]);
                assert!(decoded(&file) == samples, "{depth} {alpha} {gray} {height}");
            }
        }
    }

    #[test]
    fn rows_that_are_larger_than_a_piece_survive() {
        let (width, height) = (200_000, 3);
        let samples = samples(width, height, 3);
        assert!(decoded(&file([width, height], &encoding(8, false, false), &samples, &[1])) == samples);
    }

    #[test]
    fn bytes_depend_neither_on_bands_nor_on_threads() {
        let (width, height, encoding) = (512, 600, encoding(8, true, false));
        let samples = samples(width, height, 4);
        let whole = file([width, height], &encoding, &samples, &[height]);
        for (threads, bands) in
            [(1, &[1][..]), (1, &[7, 13, 300]), (2, &[height]), (2, &[1, 64]), (3, &[height]), (3, &[300, 1, 256, 5])]
        {
            let other = fork::with_threads(threads, || file([width, height], &encoding, &samples, bands));
            assert!(other == whole, "{threads} {bands:?}");
        }
    }

    #[test]
    fn taken_pieces_may_be_written_in_any_order() {
        let (width, height, encoding) = (512, 800, encoding(8, true, false));
        let samples = samples(width, height, 4);
        let mut out = vec![];
        let mut writer = PngWriter::new(&mut out, width, height, &encoding).unwrap();
        let mut taken = vec![];
        for (i, rows) in samples.chunks(256 * width * 4).enumerate() {
            writer.write_rows(rows).unwrap();
            // The other pieces are compressed by the writer.
            if i != 1 {
                taken.push(writer.take_pieces());
            }
        }
        assert_eq!(taken.iter().map(|pieces| pieces.0.len()).collect::<Vec<_>>(), [1, 1, 1]);
        taken.iter().rev().for_each(|pieces| writer.write_pieces(pieces.compress()).unwrap());
        writer.finish().unwrap();
        assert!(out == file([width, height], &encoding, &samples, &[height]));
    }

    /// A file on a disk with this number of free bytes.
    struct Disk(usize);

    impl Write for Disk {
        fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
            self.0 = self.0.checked_sub(bytes.len()).ok_or(io::ErrorKind::StorageFull)?;
            Ok(bytes.len())
        }

        fn flush(&mut self) -> io::Result<()> {
            Ok(())
        }
    }

    #[test]
    fn a_full_disk_is_an_error() {
        let (size, encoding) = ([512, 260], encoding(8, true, false));
        let samples = samples(size[0], size[1], 4);
        let length = file(size, &encoding, &samples, &[260]).len();
        for n_free in [0, 60, length / 2, length - 1, length] {
            let written = PngWriter::new(Disk(n_free), size[0], size[1], &encoding).and_then(|mut writer| {
                samples.chunks(52 * 512 * 4).try_for_each(|rows| writer.write_rows(rows))?;
                writer.finish()
            });
            match written {
                Ok(()) => assert_eq!(n_free, length),
                Err(EncodeError::Io(error)) => assert_eq!(error.kind(), io::ErrorKind::StorageFull),
                Err(error) => panic!("{error:?}"),
            }
        }
    }

    #[test]
    fn sizes_and_missing_rows_are_errors() {
        let encoding = encoding(8, false, false);
        let reason = |size: [usize; 2], n_rows: usize| {
            let written = PngWriter::new(vec![], size[0], size[1], &encoding).and_then(|mut writer| {
                writer.write_rows(&vec![0; n_rows * size[0] * 3])?;
                writer.finish()
            });
            written.map_err(|error| if let EncodeError::Format(reason) = error { reason } else { panic!("{error:?}") })
        };
        assert_eq!(reason([2, 3], 3), Ok(()));
        assert_eq!(reason([2, 3], 2).unwrap_err(), "some of its rows are missing");
        assert_eq!(reason([2, 3], 4).unwrap_err(), "it has more rows than its height");
        assert_eq!(reason([2, 1 << 31], 0).unwrap_err(), "it is too large");
        assert!(reason([2, 0], 0).is_err() && reason([0, 2], 0).is_err());
    }
}
