//! Picture of what a render has finished so far, which the signal USR1 asks for.

use super::target::Target;
use crate::cli::exit::{Failure, Result};
use crate::cli::journal::Journal;
use crate::diagnostic::{Diagnostic, codes, file};
use crate::image_io::{Encoding, Format, Rows};
use crate::render::{OutputConversion, Region};
use crate::source::{Disk, Span};
use std::path::{Path, PathBuf};
use std::sync::Arc;

/// Approximate number of pixels that are converted at a time.
const BAND: usize = 1 << 18;
/// Maximum height of a tile in a journal, in pixels.
const MAX_TILE_HEIGHT: usize = 64;

/// Writer of the finished tiles in a journal as a PNG file. All other pixels are transparent.
pub struct PartialPicture {
    journal: Arc<Journal>,
    path: PathBuf,
    picture_size: [usize; 2],
    /// Number of pixels that the process renders: those of the region, or of the shard's blocks.
    n_pixels_to_render: usize,
    conversion: OutputConversion,
}

impl PartialPicture {
    /// Creates the writer for a render whose output is the file `output`. The process renders `n_pixels_to_render` of
    /// the picture's pixels: a region, or the blocks of a shard. The partial picture is a file beside `output`.
    pub fn new(
        journal: &Arc<Journal>,
        output: &Path,
        picture_size: [usize; 2],
        n_pixels_to_render: usize,
        conversion: OutputConversion,
    ) -> Self {
        let mut path = output.as_os_str().to_os_string();
        path.push(".partial.png");
        Self { journal: journal.clone(), path: path.into(), picture_size, n_pixels_to_render, conversion }
    }

    /// Writes the finished tiles as a PNG file, and returns a line for people about the result.
    pub fn write_and_describe(&self) -> String {
        let path = self.path.display();
        match self.write_returning_finished_fraction() {
            Ok(share) => format!("{path}: {:.0} % of the picture\n", (100.0 * share).floor()),
            Err(Failure::Fault(fault)) => format!("{}\n", fault.message),
            Err(_) => format!("{path} could not be written\n"),
        }
    }

    /// Writes the finished tiles as a PNG file, whole or not at all. Returns the finished share of the pixels, from 0
    /// to 1.
    fn write_returning_finished_fraction(&self) -> Result<f64> {
        let unreadable = |reason: String| {
            let text = format!("the journal of `{}` can't be read: {reason}", self.path.display());
            Failure::Fault(Box::new(Diagnostic::new(codes::FILE_UNREADABLE, Span::NONE, text)))
        };
        let tiles = self.journal.finished_tiles_and_offsets().map_err(unreadable)?;
        let target = Target::of_file(&self.path, Encoding { alpha: true, ..Encoding::new(Format::Png) });
        target.check_file_writable()?;
        let [width, height] = self.picture_size;
        let mut draft = target.start_draft()?;
        let mut writer = target.writer(draft.as_mut(), (width, height))?;
        let band_height = (BAND / width.max(1)).clamp(1, MAX_TILE_HEIGHT);
        for top in (0..height).step_by(band_height) {
            writer.write_rows(&self.band(&tiles, top..(top + band_height).min(height)))?;
        }
        writer.finish()?;
        let unwritable = |e| Box::new(file::unwritable(&Disk, &self.path, &e));
        draft.map_or(Ok(()), |draft| draft.commit(&Disk)).map_err(unwritable)?;
        let n_finished: usize = tiles.iter().map(|(area, _)| area.width * area.height).sum();
        Ok(n_finished as f64 / self.n_pixels_to_render.max(1) as f64)
    }

    /// Returns the pixels of these rows of the picture, as linear light and alpha.
    fn band(&self, tiles_and_offsets: &[(Region, u64)], rows: std::ops::Range<usize>) -> Vec<[f32; 4]> {
        let width = self.picture_size[0];
        let mut band = vec![[0.0; 4]; width * rows.len()];
        let first = tiles_and_offsets.partition_point(|(area, _)| area.y + MAX_TILE_HEIGHT <= rows.start);
        let last = tiles_and_offsets.partition_point(|(area, _)| area.y < rows.end);
        for &(area, offset) in &tiles_and_offsets[first..last] {
            let Some(pixels) = self.journal.pixels_at(area, offset) else { continue };
            for (y, pixels) in (area.y..).zip(pixels.chunks(area.width)).filter(|(y, _)| rows.contains(y)) {
                let start = (y - rows.start) * width + area.x;
                let to = &mut band[start..start + area.width];
                to.iter_mut().zip(pixels).for_each(|(to, pixel)| *to = self.conversion.to_linear_rgba(pixel));
            }
        }
        band
    }
}
