//! Writes the rows of a picture to its file while the picture is rendered.

use crate::diagnostic::{self, Diagnostic};
use crate::image_io::{CompressedPieces, EncodeError, Encoder, Encoding, Format, Pieces, Rows};
use crate::source::Draft;
use std::io;
use std::time::{Duration, Instant};

/// Maximum linear light that an 8-bit file stores as 0.
const BLACK: f32 = 1.5e-4;

/// Encoder of a picture's rows into a draft file.
pub struct PictureWriter<'d> {
    /// Encoder of the picture's rows; `None` if the picture has no destination.
    encoder: Option<Encoder<&'d mut Draft>>,
    format: Format,
    unwritable: Box<dyn Fn(&io::Error) -> Diagnostic + Send + 'd>,
    written: Written,
}

/// Properties of the rows that were written.
#[derive(Clone, Copy, Debug)]
pub struct Written {
    /// True if all pixels of the written picture are black.
    pub is_black: bool,
    /// Duration of encoding the picture, without the compression of pieces that were taken.
    pub time: Duration,
}

impl<'d> PictureWriter<'d> {
    /// Starts a picture of `width` by `height` pixels; `unwritable` creates the message for a write error.
    pub fn new(
        draft: Option<&'d mut Draft>,
        (width, height): (usize, usize),
        encoding: &Encoding,
        unwritable: impl Fn(&io::Error) -> Diagnostic + Send + 'd,
    ) -> diagnostic::Result<Self> {
        let format = encoding.format;
        let encoder = draft.map(|draft| Encoder::new(draft, width, height, encoding)).transpose();
        let encoder = encoder.map_err(|error| error.into_fault(format, &unwritable))?;
        let written = Written { is_black: true, time: Duration::ZERO };
        Ok(Self { encoder, format, unwritable: Box::new(unwritable), written })
    }

    /// Ends the picture after its last row.
    pub fn finish(mut self) -> diagnostic::Result<Written> {
        let start = Instant::now();
        let done = self.encoder.take().map_or(Ok(()), Encoder::finish);
        done.map_err(|error| self.fault(error))?;
        Ok(Written { time: self.written.time + start.elapsed(), ..self.written })
    }

    fn fault(&self, error: EncodeError) -> diagnostic::Fault {
        error.into_fault(self.format, &self.unwritable)
    }
}

impl Rows for PictureWriter<'_> {
    fn write_rows(&mut self, rows: &[[f32; 4]]) -> diagnostic::Result<()> {
        let start = Instant::now();
        self.written.is_black &= rows.iter().all(|pixel| pixel[..3].iter().all(|c| *c <= BLACK));
        let done = self.encoder.as_mut().map_or(Ok(()), |encoder| encoder.write_rows(rows));
        self.written.time += start.elapsed();
        done.map_err(|error| self.fault(error))
    }

    fn take_pieces(&mut self) -> Pieces {
        self.encoder.as_mut().map_or_else(Pieces::default, Encoder::take_pieces)
    }

    fn write_pieces(&mut self, pieces: CompressedPieces) -> diagnostic::Result<()> {
        let start = Instant::now();
        let done = self.encoder.as_mut().map_or(Ok(()), |encoder| encoder.write_pieces(pieces));
        self.written.time += start.elapsed();
        done.map_err(|error| self.fault(error))
    }
}
