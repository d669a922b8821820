//! Formats of picture files that durer writes.

use crate::diagnostic::{Diagnostic, Result, codes, did_you_mean};
use crate::source::Span;
use std::path::Path;

/// A file format for pictures.
#[derive(Clone, Copy, Debug, PartialEq, Eq, serde::Serialize, serde::Deserialize)]
pub enum Format {
    /// PNG: 8 or 16 bits a channel, with alpha.
    Png,
    /// OpenEXR: linear floating point, with alpha.
    Exr,
    /// Radiance HDR: linear light with a shared exponent.
    Hdr,
    /// JPEG: 8 bits a channel, lossy.
    Jpg,
    /// PPM: 8 or 16 bits a channel.
    Ppm,
    /// BMP: 8 bits a channel, with alpha.
    Bmp,
    /// TGA: 8 bits a channel, with alpha.
    Tga,
    /// TIFF: 8 or 16 bits a channel, with alpha.
    Tiff,
}

/// Capabilities of a picture format, as a row of the table of formats.
struct Row {
    format: Format,
    /// Endings of file names in a picture format; the first one is the format's name.
    endings: &'static [&'static str],
    /// Bits per channel that a picture format allows; empty for floating-point numbers.
    depths: &'static [u8],
    alpha: bool,
    max_side: usize,
}

const fn format_row(
    format: Format,
    endings: &'static [&'static str],
    depths: &'static [u8],
    alpha: bool,
    max_side: usize,
) -> Row {
    Row { format, endings, depths, alpha, max_side }
}

const ROWS: &[Row] = &[
    format_row(Format::Png, &["png"], &[8, 16], true, i32::MAX as usize),
    format_row(Format::Exr, &["exr"], &[16, 32], true, i32::MAX as usize),
    format_row(Format::Hdr, &["hdr"], &[], false, i32::MAX as usize),
    format_row(Format::Jpg, &["jpg", "jpeg"], &[8], false, 65_535),
    format_row(Format::Ppm, &["ppm", "pnm", "pgm"], &[8, 16], false, usize::MAX),
    format_row(Format::Bmp, &["bmp"], &[8], true, i32::MAX as usize),
    format_row(Format::Tga, &["tga"], &[8], true, 65_535),
    format_row(Format::Tiff, &["tiff", "tif"], &[8, 16], true, i32::MAX as usize),
];

impl Format {
    fn capabilities(self) -> &'static Row {
        &ROWS[self as usize]
    }

    /// Returns the name of the picture format, such as `png` or `exr`.
    pub fn name(self) -> &'static str {
        self.capabilities().endings[0]
    }

    /// Returns the names of all picture formats, in the order of the manual.
    pub fn names() -> impl Iterator<Item = &'static str> {
        ROWS.iter().map(|row| row.endings[0])
    }

    /// True if the picture format's channels have a number of bits; Radiance HDR shares an exponent among them.
    pub fn has_depth(self) -> bool {
        !self.capabilities().depths.is_empty()
    }

    /// True if the picture format can hold transparency.
    pub fn has_alpha(self) -> bool {
        self.capabilities().alpha
    }

    /// True if the picture format can hold brightness alone.
    pub fn has_gray(self) -> bool {
        matches!(self, Self::Png | Self::Ppm)
    }

    /// Returns the picture format with a name or ending, in any letter case.
    pub fn from_name(name: &str) -> Option<Format> {
        ROWS.iter().find(|row| row.endings.iter().any(|e| e.eq_ignore_ascii_case(name))).map(|row| row.format)
    }

    /// Returns the picture format that the ending of a file's name indicates.
    ///
    /// # Errors
    /// E0005 if no format has the ending.
    pub fn from_path(path: &Path) -> Result<Format> {
        let ending = path.extension().and_then(|e| e.to_str()).unwrap_or_default();
        if let Some(format) = Self::from_name(ending) {
            return Ok(format);
        }
        let known: Vec<_> = Self::names().collect();
        let help = did_you_mean(ending, Self::names())
            .unwrap_or_else(|| format!("endings are {}; or say `--format`", known.join(", ")));
        let message = match ending {
            "" => format!("`{}` has no ending that names a picture format", path.display()),
            _ => format!("`.{ending}` is no picture format"),
        };
        Diagnostic::new(codes::UNKNOWN_FORMAT, Span::NONE, message).help(help).into()
    }

    /// Checks whether the picture format can hold a picture of this size with this number of bits per channel; `None`
    /// for the format's own number.
    ///
    /// # Errors
    /// E0008 if it can't.
    pub fn check_limits(self, width: usize, height: usize, bits_per_channel: Option<u8>) -> Result<()> {
        let (row, name) = (self.capabilities(), self.name());
        let fault = |text: String, help: &str| Diagnostic::new(codes::FORMAT_LIMIT, Span::NONE, text).help(help).into();
        match bits_per_channel {
            Some(_) if row.depths.is_empty() => {
                let text = format!("{name} always holds floating-point numbers, which `--bit-depth` can't change");
                return fault(text, "leave `--bit-depth` out");
            }
            Some(depth) if !row.depths.contains(&depth) => {
                let help = if depth == 32 { "exr can" } else { "png, tiff, ppm and exr can hold 16" };
                return fault(format!("{name} can't hold {depth} bits a channel"), help);
            }
            _ => {}
        }
        if width.max(height) > row.max_side {
            let text = format!("{name} holds at most {} pixels a side, not {width}x{height}", row.max_side);
            return fault(text, "ppm has no limit");
        }
        Ok(())
    }
}

/// Number of bytes at the start of a file that [`begins_like_a_picture`] needs.
pub const SIGNATURE_BYTES: usize = 18;

/// True if a file that begins with these bytes is a picture in one of the formats that durer writes, or in another that the crate
/// `image` knows.
pub fn begins_like_a_picture(start: &[u8]) -> bool {
    // TGA has no signature: the kinds of palette and picture, and the bits of a pixel.
    let is_tga = start.len() >= SIGNATURE_BYTES
        && start[1] <= 1
        && matches!(start[2], 1..=3 | 9..=11)
        && matches!(start[16], 8 | 15 | 16 | 24 | 32);
    is_tga || image::guess_format(start).is_ok()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rows_stand_in_the_order_of_the_enum() {
        assert!(ROWS.iter().enumerate().all(|(i, row)| row.format as usize == i));
    }

    #[test]
    fn endings_name_formats() {
        assert_eq!(Format::from_path(Path::new("a/b.PNG")).unwrap(), Format::Png);
        assert_eq!(Format::from_path(Path::new("b.jpeg")).unwrap(), Format::Jpg);
        assert_eq!(Format::from_path(Path::new("b.pgn")).unwrap_err().help.as_deref(), Some("did you mean `png`?"));
        assert!(Format::from_path(Path::new("b")).is_err());
    }

    #[test]
    fn limits_are_reported() {
        assert!(Format::Jpg.check_limits(70_000, 1, None).is_err());
        assert!(Format::Jpg.check_limits(10, 10, Some(16)).is_err());
        assert!(
            Format::Exr.check_limits(10, 10, Some(8)).is_err() && Format::Png.check_limits(10, 10, Some(32)).is_err()
        );
        assert!(Format::Png.check_limits(10, 10, Some(16)).is_ok());
    }
}
