//! Targa files, as POV-Ray 3.7 reads them: five bits of a channel are extended by zeros, and the sixteenth bit is
//! alpha.

use super::{Decoded, Pixels, Samples};

/// Fields of a TGA file's header that are needed.
struct Header {
    /// True if the TGA file has a palette.
    mapped: bool,
    kind: u8,
    first: usize,
    colors: usize,
    color_bits: u8,
    width: usize,
    height: usize,
    bits: u8,
    /// True if the TGA file's first row is the top.
    down: bool,
    /// True if the TGA file's rows begin at the right.
    leftwards: bool,
}

const HEADER: usize = 18;

/// Decodes a TGA file.
///
/// # Errors
/// The reason why it can't be decoded, in words.
pub(super) fn decode_tga(bytes: &[u8]) -> Result<Decoded, String> {
    let head = bytes.get(..HEADER).ok_or("it ends within its header")?;
    let word = |at: usize| usize::from(u16::from_le_bytes([head[at], head[at + 1]]));
    let header = Header {
        mapped: head[1] == 1,
        kind: head[2] & 7,
        first: word(3),
        colors: word(5),
        color_bits: head[7],
        width: word(12),
        height: word(14),
        bits: head[16],
        down: head[17] & 0x20 != 0,
        leftwards: head[17] & 0x10 != 0,
    };
    if header.width == 0 || header.height == 0 {
        return Err(format!("its size is {} × {}", header.width, header.height));
    }
    let palette = HEADER + usize::from(head[0]);
    let entry = usize::from(header.color_bits.div_ceil(8));
    let start = palette + if header.mapped { header.colors * entry } else { 0 };
    let (colors, data) =
        bytes.get(palette..).and_then(|rest| rest.split_at_checked(start - palette)).ok_or("it is cut off")?;
    let size = usize::from(header.bits.div_ceil(8));
    let data =
        if head[2] & 8 == 0 { data.to_vec() } else { decode_runs(data, size, header.width * header.height * size)? };
    let pixels = data.get(..header.width * header.height * size).ok_or("it is cut off")?;
    match header.kind {
        1 if header.mapped && size == 1 && entry > 0 => decode_palette(&header, colors, entry, pixels),
        2 if matches!(header.bits, 15 | 16 | 24 | 32) => {
            let samples =
                header.pixels_from_top_left(size, pixels).flat_map(|p| decode_color(p, header.bits)).collect();
            Ok(header.to_decoded(4, header.bits == 16 || header.bits == 32, samples, None))
        }
        3 if size == 1 => {
            Ok(header.to_decoded(1, true, header.pixels_from_top_left(1, pixels).map(|p| p[0]).collect(), None))
        }
        kind => Err(format!("there is no targa picture of kind {kind} with {} bits a pixel", header.bits)),
    }
}

/// Expands the run-length data of a TGA file: a byte below 128 is the number of literal pixels minus 1; a larger one
/// repeats the next pixel, as often as it exceeds 127.
fn decode_runs(mut data: &[u8], bytes_per_pixel: usize, decoded_length: usize) -> Result<Vec<u8>, String> {
    let mut out = vec![];
    while out.len() < decoded_length {
        let (&run, rest) = data.split_first().ok_or("it is cut off")?;
        let count = usize::from(run & 0x7f) + 1;
        let length = if run < 128 { count * bytes_per_pixel } else { bytes_per_pixel };
        let (pixels, rest) = rest.split_at_checked(length).ok_or("it is cut off")?;
        (0..if run < 128 { 1 } else { count }).for_each(|_| out.extend_from_slice(pixels));
        data = rest;
    }
    Ok(out)
}

fn decode_palette(header: &Header, colors: &[u8], bytes_per_entry: usize, pixels: &[u8]) -> Result<Decoded, String> {
    let indices: Vec<u8> = header.pixels_from_top_left(1, pixels).map(|p| p[0]).collect();
    let mut samples = vec![];
    for &index in &indices {
        let at = usize::from(index).checked_sub(header.first).ok_or("a pixel is not in the palette")?;
        let bytes =
            colors.get(at * bytes_per_entry..(at + 1) * bytes_per_entry).ok_or("a pixel is not in the palette")?;
        samples.extend(decode_color(bytes, header.color_bits));
    }
    Ok(header.to_decoded(4, matches!(header.color_bits, 16 | 32), samples, Some(indices)))
}

/// Decodes a TGA pixel to red, green, blue and alpha.
fn decode_color(bytes: &[u8], bits: u8) -> [u8; 4] {
    match *bytes {
        [b, g, r] => [r, g, b, 255],
        [b, g, r, a] => [r, g, b, a],
        [low, high] => {
            let v = u16::from_le_bytes([low, high]);
            let five = |shift: u32| ((v >> shift) as u8 & 31) << 3;
            let alpha = if bits == 16 && v < 0x8000 { 0 } else { 255 };
            [five(10), five(5), five(0), alpha]
        }
        _ => [0, 0, 0, 255],
    }
}

impl Header {
    /// Returns the pixels of a TGA file from the top left.
    fn pixels_from_top_left<'a>(&self, bytes_per_pixel: usize, pixels: &'a [u8]) -> impl Iterator<Item = &'a [u8]> {
        let (width, height, down, leftwards) = (self.width, self.height, self.down, self.leftwards);
        (0..width * height).map(move |i| {
            let (x, y) = (i % width, i / width);
            let x = if leftwards { width - 1 - x } else { x };
            let y = if down { y } else { height - 1 - y };
            &pixels[(y * width + x) * bytes_per_pixel..][..bytes_per_pixel]
        })
    }

    /// Returns the decoded TGA picture; alpha is dropped if the file has none.
    fn to_decoded(&self, channels: usize, has_alpha: bool, samples: Vec<u8>, indices: Option<Vec<u8>>) -> Decoded {
        let pixels = Pixels { width: self.width, height: self.height, channels, samples: Samples::U8(samples) };
        Decoded { pixels: if has_alpha { pixels } else { pixels.without_alpha() }, indices }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn header(kind: u8, bits: u8, colors: u8, descriptor: u8) -> Vec<u8> {
        let mapped = u8::from(colors > 0);
        vec![0, mapped, kind, 0, 0, colors, 0, 24 * mapped, 0, 0, 0, 0, 2, 0, 1, 0, bits, descriptor]
    }

    #[test]
    fn sixteen_bits_hold_alpha() {
        let pixels =
            |bits| decode_tga(&[header(2, bits, 0, 0x20), vec![0xff, 0x7f, 0x01, 0x80]].concat()).unwrap().pixels;
        assert_eq!(pixels(16).samples, Samples::U8(vec![248, 248, 248, 0, 0, 0, 8, 255]));
        assert_eq!(pixels(15).samples, Samples::U8(vec![248, 248, 248, 0, 0, 8]));
    }

    #[test]
    fn runs_and_palettes() {
        let file = [header(9, 8, 2, 0x20), vec![1, 2, 3, 4, 5, 6, 0x81, 1]].concat();
        let decoded = decode_tga(&file).unwrap();
        assert_eq!(decoded.pixels.samples, Samples::U8(vec![6, 5, 4, 6, 5, 4]));
        assert_eq!(decoded.indices, Some(vec![1, 1]));
        for end in 0..file.len() {
            assert!(decode_tga(&file[..end]).is_err());
        }
    }

    #[test]
    fn rows_run_both_ways() {
        let at = |descriptor| decode_tga(&[header(3, 8, 0, descriptor), vec![7, 9]].concat()).unwrap().pixels.samples;
        assert_eq!((at(0), at(0x10)), (Samples::U8(vec![7, 9]), Samples::U8(vec![9, 7])));
    }
}
