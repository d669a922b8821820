//! Heights from the pixels of a picture, and from the values of a function (quirk: `height_field_heights`).

use crate::color::{GRAY_WEIGHTS, Gamma};
use crate::image_io::{Picture, Samples, expand_pixel, round_gray_like_povray};

/// Converts a number to a height of 16 bits; numbers below 0 and above 1 wrap.
pub fn unit_to_wrapping_u16(x: f64) -> u16 {
    (x * 65535.0) as i64 as u16
}

/// Returns the brightness of a colour whose channels have 16 bits each.
pub fn brightness_u16([r, g, b]: [u16; 3]) -> u16 {
    if r == g && g == b {
        return r;
    }
    let [wr, wg, wb] = GRAY_WEIGHTS;
    (wr * f64::from(r) + wg * f64::from(g) + wb * f64::from(b)) as u16
}

/// Returns the height of each pixel of a picture, row by row from below. Palette indices are heights; colours of 16
/// bits count by their brightness; of other colours red is the higher and green the lower byte.
pub fn picture_heights_bottom_up(picture: &Picture, gamma: Option<Gamma>) -> Vec<u16> {
    let pixels = &picture.pixels;
    let (width, channels) = (pixels.width, pixels.channels);
    let curve = |x: f64| gamma.map_or(x, |gamma| gamma.decode(x));
    let two_bytes = |[r, g]: [f64; 2]| (255.0 * (256.0 * r + g)) as i64 as u16;
    let rows = (0..pixels.height).rev().flat_map(|j| j * width..(j + 1) * width);
    if let Some(indices) = &picture.indices {
        return rows.map(|i| u16::from(indices[i]) << 8).collect();
    }
    match &pixels.samples {
        Samples::U8(all) => {
            let code = |x: u8| {
                let x = curve(f64::from(x) / 255.0);
                if picture.gray_bytes { f64::from(round_gray_like_povray(x as f32)) } else { x }
            };
            let table: Vec<f64> = (0..=255).map(code).collect();
            let pixel = |i: usize| &all[i * channels..(i + 1) * channels];
            let height =
                |p: &[u8]| two_bytes([p[0], p[if channels > 2 { 1 } else { 0 }]].map(|x| table[usize::from(x)]));
            rows.map(|i| height(pixel(i))).collect()
        }
        Samples::U16(all) => {
            let code = |x: u16| if gamma.is_none() { x } else { unit_to_wrapping_u16(curve(f64::from(x) / 65535.0)) };
            rows.map(|i| match all[i * channels..(i + 1) * channels] {
                [r, g, b, ..] => brightness_u16([code(r), code(g), code(b)]),
                [x, ..] => code(x),
                [] => 0,
            })
            .collect()
        }
        Samples::F32(all) => {
            let height = |i: usize| {
                let [r, g, ..] = expand_pixel(&all[i * channels..(i + 1) * channels], |x| x, |x| x);
                two_bytes([curve(f64::from(r)), curve(f64::from(g))])
            };
            rows.map(height).collect()
        }
    }
}

/// Returns the heights of a `pot` picture from rows of palette indices: the left half holds the higher bytes, the right
/// half the lower.
pub fn heights_of_pot_picture(palette_indices: &[u16], width: usize) -> Vec<u16> {
    let half = width / 2;
    let row = |row: &[u16]| (0..half).map(|x| row[x] | row[x + width - half] >> 8).collect::<Vec<_>>();
    palette_indices.chunks_exact(width).flat_map(row).collect()
}
