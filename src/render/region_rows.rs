//! Rows of the whole picture: the rows of the region, and the pixels outside of the region.

use super::pixel_area::Pixel;
use super::threads::RowReceiver;
use super::{Options, OutputConversion, Region};
use crate::diagnostic;
use crate::image_io::{CompressedPieces, Pieces, Rows};

/// Receiver of the rows of a region that extends them to rows of the picture, in linear light.
pub(super) struct RegionRows<'a> {
    /// Receiver of the picture's rows.
    pub rows: &'a mut dyn Rows,
    pub conversion: OutputConversion,
    pub options: &'a Options,
    pub region: Region,
}

impl RegionRows<'_> {
    fn write(&mut self, pixels: &[Pixel]) -> diagnostic::Result<()> {
        let Region { x, width, .. } = self.region;
        if width == self.options.width {
            return self.rows.write_rows(pixels);
        }
        // One row at a time: rows of the picture can be far longer than those of the region. Their pieces are compressed here,
        // because they would be too large to be kept until the rows are extended.
        let mut whole = vec![outside_pixel(self.options); self.options.width];
        pixels.chunks(width).try_for_each(|row| {
            whole[x..x + width].copy_from_slice(row);
            self.rows.write_rows(&whole)
        })
    }
}

impl RowReceiver for RegionRows<'_> {
    fn receive(&mut self, mut pixels: Vec<Pixel>) -> diagnostic::Result<Pieces> {
        pixels.iter_mut().for_each(|pixel| *pixel = self.conversion.to_linear_rgba(pixel));
        self.write(&pixels)?;
        Ok(self.rows.take_pieces())
    }

    fn write_pieces(&mut self, pieces: CompressedPieces) -> diagnostic::Result<()> {
        self.rows.write_pieces(pieces)
    }
}

/// Returns the colour of the pixels outside of the rendered region.
fn outside_pixel(options: &Options) -> [f32; 4] {
    [0.0, 0.0, 0.0, options.outside_alpha]
}

/// Writes rows of the picture above or below the region.
pub(super) fn write_outside_rows(to: &mut dyn Rows, options: &Options, rows: usize) -> diagnostic::Result<()> {
    let row = vec![outside_pixel(options); if rows > 0 { options.width } else { 0 }];
    (0..rows).try_for_each(|_| to.write_rows(&row))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::diagnostic::{Diagnostic, codes};
    use crate::image_io::{EncodeError, Encoder, Encoding, Format, Frame, encode};
    use crate::render::{Stopped, Tile, Watch, draw};
    use crate::scene::Scene;
    use crate::source::Span;
    use crate::world;
    use std::io::Cursor;

    /// A [`Watch`] with the pixels of all tiles, so that nothing is rendered.
    struct Finished;

    fn pixel(x: usize, y: usize) -> Pixel {
        let code = |number: usize| (number % 256) as f32 / 255.0;
        [code(x * 31 + y * y), code(x * x + 7 * y), code(x ^ y), 0.0]
    }

    impl Watch for Finished {
        fn progress(&self, _: usize, _: usize) {}

        fn cancelled(&self) -> bool {
            false
        }

        fn load_tile(&self, tile: Tile) -> Option<Vec<[f32; 4]>> {
            let Region { x, y, width, height } = tile.area;
            Some((y..y + height).flat_map(|y| (x..x + width).map(move |x| pixel(x, y))).collect())
        }
    }

    /// A PNG file in memory.
    struct PngFile<'a> {
        encoder: Encoder<&'a mut Cursor<Vec<u8>>>,
        /// True if no piece can be written.
        is_full: bool,
        n_written: usize,
    }

    fn fault(error: EncodeError) -> diagnostic::Fault {
        error.into_fault(Format::Png, |error| Diagnostic::new(codes::FORMAT_LIMIT, Span::NONE, error.to_string()))
    }

    impl Rows for PngFile<'_> {
        fn write_rows(&mut self, rows: &[[f32; 4]]) -> diagnostic::Result<()> {
            self.encoder.write_rows(rows).map_err(fault)
        }

        fn take_pieces(&mut self) -> Pieces {
            self.encoder.take_pieces()
        }

        fn write_pieces(&mut self, pieces: CompressedPieces) -> diagnostic::Result<()> {
            self.n_written += 1;
            if self.is_full {
                return Err(fault(EncodeError::Format("the disk is full".into())));
            }
            self.encoder.write_pieces(pieces).map_err(fault)
        }
    }

    /// Returns the PNG file of a picture, and how often the render wrote pieces; or the reason why the render was stopped.
    fn drawn(options: &Options, is_full: bool) -> Result<(Vec<u8>, usize), Stopped> {
        let world = world::lower(&Scene::default()).unwrap();
        let mut out = Cursor::new(vec![]);
        let n_written = {
            let encoder = Encoder::new(&mut out, options.width, options.height, &Encoding::new(Format::Png)).unwrap();
            let mut file = PngFile { encoder, is_full, n_written: 0 };
            draw(&world, options, &Finished, &mut file)?;
            file.encoder.finish().unwrap();
            file.n_written
        };
        Ok((out.into_inner(), n_written))
    }

    #[test]
    fn the_threads_of_a_render_write_the_same_file_as_one_call() {
        let (width, height) = (500, 800);
        for region in [None, Some(Region { x: 3, y: 20, width: 490, height: 700 })] {
            let inside = region.unwrap_or(Region { x: 0, y: 0, width, height });
            let is_inside = |x, y| {
                (inside.x..inside.x + inside.width).contains(&x) && (inside.y..inside.y + inside.height).contains(&y)
            };
            let picture_pixel = |at: usize| {
                let (x, y) = (at % width, at / width);
                let [r, g, b, _] = if is_inside(x, y) { pixel(x, y) } else { [0.0; 4] };
                [r, g, b, 1.0]
            };
            let frame = Frame { width, height, pixels: (0..width * height).map(picture_pixel).collect() };
            let expected = encode(&frame, &Encoding::new(Format::Png)).unwrap();
            for threads in if region.is_none() { vec![1, 2, 3] } else { vec![3] } {
                let options = Options { threads, region, ..Options::new(width, height) };
                let (file, n_written) = drawn(&options, false).unwrap();
                // Pieces of a narrow region are compressed while its rows are extended.
                assert!(file == expected && (n_written > 1 || region.is_some()), "{threads} {region:?} {n_written}");
            }
        }
    }

    #[test]
    fn a_piece_that_cannot_be_written_stops_the_render() {
        for threads in [1, 3] {
            let stopped = drawn(&Options { threads, ..Options::new(500, 400) }, true).unwrap_err();
            assert!(
                matches!(stopped, Stopped::Fault(fault) if fault.message.contains("the disk is full")),
                "{threads}"
            );
        }
    }
}
