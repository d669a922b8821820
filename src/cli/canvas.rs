//! What a picture is drawn on: the rows that come are stored, and what is to be known of the whole picture is noted.

use crate::diagnostic::{self, Diagnostic};
use crate::image_io::{EncodeError, Encoder, Encoding, Format, Rows};
use crate::source::Draft;
use std::io;
use std::time::{Duration, Instant};

/// Linear light that an 8-bit file stores as 0.
const BLACK: f32 = 1.5e-4;

/// A picture on its way into a file.
pub struct Canvas<'d> {
    encoder: Option<Encoder<&'d mut Draft>>,
    format: Format,
    unwritable: Box<dyn Fn(&io::Error) -> Diagnostic + Send + 'd>,
    /// What is known of the rows so far.
    noted: Noted,
}

/// What is known of a picture that is drawn.
#[derive(Clone, Copy, Debug)]
pub struct Noted {
    /// Is it black all over?
    pub black: bool,
    /// What storing it took.
    pub time: Duration,
}

impl<'d> Canvas<'d> {
    /// Into a draft, if the picture goes anywhere; `unwritable` tells why it can't be written.
    pub fn new(
        draft: Option<&'d mut Draft>,
        (width, height): (usize, usize),
        encoding: &Encoding,
        unwritable: impl Fn(&io::Error) -> Diagnostic + Send + 'd,
    ) -> diagnostic::Result<Self> {
        let format = encoding.format;
        let encoder = draft.map(|draft| Encoder::new(draft, width, height, encoding)).transpose();
        let encoder = encoder.map_err(|error| error.told(format, &unwritable))?;
        let noted = Noted { black: true, time: Duration::ZERO };
        Ok(Self { encoder, format, unwritable: Box::new(unwritable), noted })
    }

    /// All rows are here.
    pub fn finish(mut self) -> diagnostic::Result<Noted> {
        let start = Instant::now();
        let done = self.encoder.take().map_or(Ok(()), Encoder::finish);
        done.map_err(|error| self.told(error))?;
        Ok(Noted { time: self.noted.time + start.elapsed(), ..self.noted })
    }

    fn told(&self, error: EncodeError) -> diagnostic::Fault {
        error.told(self.format, &self.unwritable)
    }
}

impl Rows for Canvas<'_> {
    fn take(&mut self, rows: &[[f32; 4]]) -> diagnostic::Result<()> {
        let start = Instant::now();
        self.noted.black &= rows.iter().all(|pixel| pixel[..3].iter().all(|c| *c <= BLACK));
        let done = self.encoder.as_mut().map_or(Ok(()), |encoder| encoder.rows(rows));
        self.noted.time += start.elapsed();
        done.map_err(|error| self.told(error))
    }
}
