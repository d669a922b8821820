//! Palette of PNG files: a check that the crate `png` 0.18 leaves out.

/// First bytes of every PNG file.
const SIGNATURE: &[u8] = b"\x89PNG\r\n\x1a\n";

/// Returns the reason why a PNG file's palette is broken, in words; `None` for a file without such a fault. A palette
/// holds three bytes for each colour (PNG specification, third edition, 2025, section 11.2.2); the crate `png` panics on
/// other lengths.
pub(super) fn palette_fault(bytes: &[u8]) -> Option<String> {
    let mut rest = bytes.strip_prefix(SIGNATURE)?;
    // A chunk is its length, its name, its content and a checksum.
    while let Some((length, after)) = rest.split_first_chunk::<4>() {
        let (name, content) = after.split_first_chunk::<4>()?;
        let length = u32::from_be_bytes(*length) as usize;
        match name {
            b"PLTE" if !length.is_multiple_of(3) => {
                return Some(format!("its palette has {length} bytes, which is no multiple of 3"));
            }
            b"PLTE" | b"IDAT" => return None,
            _ => rest = content.get(length.checked_add(4)?..)?,
        }
    }
    None
}

#[cfg(test)]
mod tests {
    use super::*;

    fn chunk(name: &[u8; 4], length: u32) -> Vec<u8> {
        [&length.to_be_bytes()[..], name, &vec![0; length as usize + 4]].concat()
    }

    #[test]
    fn palettes_have_three_bytes_for_each_color() {
        let file = |chunks: &[Vec<u8>]| [SIGNATURE, &chunks.concat()].concat();
        let (header, data) = (chunk(b"IHDR", 13), chunk(b"IDAT", 10));
        for (length, is_sound) in [(3, true), (768, true), (1, false), (29, false), (767, false)] {
            let bytes = file(&[header.clone(), chunk(b"PLTE", length), data.clone()]);
            assert_eq!(palette_fault(&bytes).is_none(), is_sound, "{length} bytes");
        }
        assert_eq!(palette_fault(&file(&[header.clone(), data])), None);
        let cut = file(&[header]);
        (0..cut.len()).for_each(|n| assert_eq!(palette_fault(&cut[..n]), None));
    }
}
