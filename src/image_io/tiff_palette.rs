//! Tiff files with a palette of 256 colours: decoded as gray, then looked up in the palette.

use super::{Decoded, Pixels, Samples};

/// Numbers of TIFF tags (TIFF 6.0, 1992, section 8).
const BITS: u16 = 258;
const PHOTOMETRIC: u16 = 262;
const COLOR_MAP: u16 = 320;

/// Values of the TIFF tag `PhotometricInterpretation` for a palette and for gray.
const BY_PALETTE: u16 = 3;
const GRAY: u16 = 1;

/// Bytes of a TIFF file with their byte order.
struct File<'a> {
    bytes: &'a [u8],
    little: bool,
}

impl File<'_> {
    fn read_u16(&self, at: usize) -> Option<u16> {
        let pair = self.bytes.get(at..)?.first_chunk()?;
        Some(if self.little { u16::from_le_bytes(*pair) } else { u16::from_be_bytes(*pair) })
    }

    fn read_u32(&self, at: usize) -> Option<usize> {
        let four = self.bytes.get(at..)?.first_chunk()?;
        Some((if self.little { u32::from_le_bytes(*four) } else { u32::from_be_bytes(*four) }) as usize)
    }

    /// Offset of the value of a tag of the TIFF file's first picture.
    fn value_offset(&self, tag: u16) -> Option<usize> {
        let start = self.read_u32(4)?;
        let count = usize::from(self.read_u16(start)?);
        let entry = (0..count).map(|i| start + 2 + 12 * i).find(|&entry| self.read_u16(entry) == Some(tag))?;
        Some(entry + 8)
    }
}

/// Decodes a TIFF file with a palette; `None` if the file has no palette that is read. `decode_gray` decodes the bytes of a
/// file that is modified to be gray.
pub(super) fn decode_tiff_palette(
    bytes: &[u8],
    decode_gray: impl Fn(&[u8]) -> Result<Pixels, String>,
) -> Option<Result<Decoded, String>> {
    let little = match bytes.get(..4)? {
        b"II*\0" => true,
        b"MM\0*" => false,
        _ => return None,
    };
    let file = File { bytes, little };
    let photometric = file.value_offset(PHOTOMETRIC)?;
    if file.read_u16(photometric)? != BY_PALETTE || file.read_u16(file.value_offset(BITS)?)? != 8 {
        return None;
    }
    let map = file.read_u32(file.value_offset(COLOR_MAP)?)?;
    // All reds, all greens, all blues.
    let channel =
        |index: u8, c: usize| file.read_u16(map.saturating_add(2 * (256 * c + usize::from(index)))).unwrap_or(0);
    let mut plain = bytes.to_vec();
    let value = if little { GRAY.to_le_bytes() } else { GRAY.to_be_bytes() };
    plain[photometric..photometric + 2].copy_from_slice(&value);
    Some(decode_gray(&plain).map(|pixels| {
        let Samples::U8(indices) = pixels.samples else { return pixels.into() };
        let samples = indices.iter().flat_map(|&index| [0, 1, 2].map(|c| channel(index, c))).collect();
        Decoded { pixels: Pixels { channels: 3, samples: Samples::U16(samples), ..pixels }, indices: Some(indices) }
    }))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn usual(bytes: &[u8]) -> Result<Pixels, String> {
        crate::image_io::decode_pixels(bytes, "tiff")
    }

    #[test]
    fn colors_come_from_the_palette() {
        let (width, palette_at) = (3u32, 11u32);
        // the pixels, then the palette: reds i, greens 2i, blues 3i
        let mut file = [&b"II*\0"[..], &(palette_at + 3 * 512).to_le_bytes(), &[0, 7, 255]].concat();
        for c in 1..=3 {
            file.extend((0..256u16).flat_map(|i| (i * c).to_le_bytes()));
        }
        let short = |tag: u16, value: u32| [&tag.to_le_bytes()[..], &[3, 0, 1, 0, 0, 0], &value.to_le_bytes()].concat();
        let map = [&COLOR_MAP.to_le_bytes()[..], &[3, 0], &768u32.to_le_bytes(), &palette_at.to_le_bytes()].concat();
        let tags = [
            short(256, width),
            short(257, 1),
            short(BITS, 8),
            short(259, 1),
            short(PHOTOMETRIC, u32::from(BY_PALETTE)),
            short(273, 8),
            short(277, 1),
            short(278, 1),
            short(279, width),
            map,
        ];
        file.extend((tags.len() as u16).to_le_bytes());
        file.extend(tags.concat());
        file.extend([0; 4]);
        let decoded = decode_tiff_palette(&file, usual).unwrap().unwrap();
        assert_eq!(decoded.pixels.samples, Samples::U16(vec![0, 0, 0, 7, 14, 21, 255, 510, 765]));
        assert_eq!(decoded.indices, Some(vec![0, 7, 255]));
        for end in 0..file.len() {
            drop(usual(&file[..end]));
        }
    }
}
