//! Netpbm's pgm and ppm with a maximum value below 255, which the crate `image` scales to eight bits with rounding
//! errors.

use super::{Pixels, Samples};

/// Decodes a PPM or PGM file with a maximum value below 255; `None` for any other file.
pub(super) fn decode_netpbm_max_below_255(bytes: &[u8]) -> Option<Result<Pixels, String>> {
    let (channels, plain) = match bytes.get(..2)? {
        b"P2" => (1, true),
        b"P3" => (3, true),
        b"P5" => (1, false),
        b"P6" => (3, false),
        _ => return None,
    };
    let mut rest = &bytes[2..];
    let [width, height, max] = [read_number(&mut rest)?, read_number(&mut rest)?, read_number(&mut rest)?];
    if !(1..255).contains(&max) || width == 0 || height == 0 {
        return None;
    }
    let mut read = || -> Option<Vec<u16>> {
        let count = width.checked_mul(height)?.checked_mul(channels).filter(|&count| count <= rest.len())?;
        let wide = |n: usize| (n.min(max) * 65_535 + max / 2).div_euclid(max) as u16;
        if plain {
            return (0..count).map(|_| read_number(&mut rest).map(wide)).collect();
        }
        // one whitespace character ends the header
        Some(rest.get(1..=count)?.iter().map(|&byte| wide(usize::from(byte))).collect())
    };
    let samples = read().ok_or_else(|| "it is cut off".to_string());
    Some(samples.map(|samples| Pixels { width, height, channels, samples: Samples::U16(samples) }))
}

/// Reads the next number of a PPM or PGM file, after whitespace and comments.
fn read_number(rest: &mut &[u8]) -> Option<usize> {
    loop {
        match rest.first()? {
            b'#' => *rest = &rest[memchr::memchr(b'\n', rest)?..],
            byte if byte.is_ascii_whitespace() => *rest = &rest[1..],
            _ => break,
        }
    }
    let end = rest.iter().position(|byte| !byte.is_ascii_digit()).unwrap_or(rest.len());
    let (digits, after) = rest.split_at(end);
    *rest = after;
    std::str::from_utf8(digits).ok()?.parse().ok()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_keep_their_fractions() {
        let expected = Samples::U16(vec![0, 6554, 65535]);
        for file in [&b"P3 # a\n1 1 100\n0 10 100"[..], b"P6\n1 1\n100\n\x00\x0a\x64"] {
            assert_eq!(decode_netpbm_max_below_255(file).unwrap().unwrap().samples, expected);
        }
        assert_eq!(decode_netpbm_max_below_255(b"P5 1 1 255 a"), None);
        assert!(decode_netpbm_max_below_255(b"P6\n9 9\n100\n\x00").unwrap().is_err());
    }
}
