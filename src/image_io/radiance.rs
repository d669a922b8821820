//! Radiance's pictures: three mantissas share an exponent (Ward, Real pixels, Graphics Gems II, 1991).

use super::{Pixels, Samples};

/// Decodes a Radiance HDR file.
///
/// # Errors
/// The reason why it can't be decoded, in words.
pub(super) fn decode_radiance(bytes: &[u8]) -> Result<Pixels, String> {
    let mut rest = bytes;
    while !read_line(&mut rest)?.is_empty() {}
    let size = String::from_utf8_lossy(read_line(&mut rest)?).into_owned();
    let words: Vec<&str> = size.split_whitespace().collect();
    let ["-Y", height, "+X", width] = words[..] else { return Err(format!("its size is `{size}`")) };
    let (Ok(width), Ok(height)) = (width.parse::<usize>(), height.parse::<usize>()) else {
        return Err(format!("its size is `{size}`"));
    };
    if width == 0 || height == 0 {
        return Err(format!("its size is `{size}`"));
    }
    if width.checked_mul(height).is_none_or(|count| count > MOST) {
        return Err(format!("its size is `{size}`, which is too large"));
    }
    let mut samples = vec![];
    for _ in 0..height {
        for [r, g, b, e] in decode_row(&mut rest, width)? {
            // A mantissa is the middle of its step, as in Ward's own programs and in POV-Ray 3.7.
            let step = 2f64.powi(i32::from(e) - 136);
            samples.extend([r, g, b].map(|m| if e == 0 { 0.0 } else { ((f64::from(m) + 0.5) * step) as f32 }));
        }
    }
    Ok(Pixels { width, height, channels: 3, samples: Samples::F32(samples) })
}

/// Maximum number of pixels of a Radiance HDR file: a short file can claim any number.
const MOST: usize = 1 << 26;

const CUT_OFF: &str = "it is cut off";

fn read_line<'a>(rest: &mut &'a [u8]) -> Result<&'a [u8], String> {
    let end = memchr::memchr(b'\n', rest).ok_or("it ends within its header")?;
    let (line, after) = rest.split_at(end);
    *rest = &after[1..];
    Ok(line)
}

fn take_bytes<'a>(rest: &mut &'a [u8], count: usize) -> Result<&'a [u8], String> {
    let (head, after) = rest.split_at_checked(count).ok_or(CUT_OFF)?;
    *rest = after;
    Ok(head)
}

/// Decodes a row of a Radiance HDR file: the four channels one after the other, each run-length encoded, or else pixel
/// by pixel.
fn decode_row(rest: &mut &[u8], width: usize) -> Result<Vec<[u8; 4]>, String> {
    match **rest {
        [2, 2, a, b, ..] if usize::from(u16::from_be_bytes([a, b])) == width => *rest = &rest[4..],
        _ => return decode_row_by_pixels(rest, width),
    }
    let mut channels = [const { vec![] }; 4];
    for channel in &mut channels {
        while channel.len() < width {
            let run = usize::from(take_bytes(rest, 1)?[0]);
            if run > 128 {
                channel.resize(channel.len() + run - 128, take_bytes(rest, 1)?[0]);
            } else {
                channel.extend_from_slice(take_bytes(rest, run.max(1))?);
            }
        }
    }
    let [r, g, b, e] = &channels;
    Ok((0..width).map(|i| [r[i], g[i], b[i], e[i]]).collect())
}

/// Decodes a row of a Radiance HDR file pixel by pixel; (1, 1, 1, n) repeats the previous pixel n times; consecutive
/// ones are digits of base 256.
fn decode_row_by_pixels(rest: &mut &[u8], width: usize) -> Result<Vec<[u8; 4]>, String> {
    let mut out: Vec<[u8; 4]> = vec![];
    let mut shift = 0;
    while out.len() < width {
        let pixel: [u8; 4] = take_bytes(rest, 4)?.try_into().map_err(|_| CUT_OFF)?;
        match (pixel, out.last()) {
            ([1, 1, 1, n], Some(&last)) if shift < 24 => {
                let count = usize::from(n) << shift;
                out.resize((out.len() + count).min(width), last);
                shift += 8;
            }
            _ => {
                out.push(pixel);
                shift = 0;
            }
        }
    }
    Ok(out)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rows_in_runs_and_without() {
        let head = b"#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 1 +X 2\n".to_vec();
        let plain = [head.clone(), vec![128, 0, 64, 129, 1, 1, 1, 1]].concat();
        let runs = [head, vec![2, 2, 0, 2, 130, 128, 2, 0, 0, 130, 64, 130, 129]].concat();
        let expected = [128.5, 0.5, 64.5, 128.5, 0.5, 64.5].map(|m| m / 128.0).to_vec();
        for file in [plain, runs] {
            assert_eq!(decode_radiance(&file).unwrap().samples, Samples::F32(expected.clone()));
            assert!(decode_radiance(&file[..file.len() - 1]).is_err());
        }
    }

    #[test]
    fn rows_without_pixels_are_refused() {
        // As many empty rows as the header names would take years.
        let file = b"#?RADIANCE\n\n-Y 18446744073709551615 +X 0\n";
        assert_eq!(decode_radiance(file), Err("its size is `-Y 18446744073709551615 +X 0`".into()));
        assert!(decode_radiance(b"#?RADIANCE\n\n-Y 0 +X 5\n").is_err());
    }
}
