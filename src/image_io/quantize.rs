//! From linear light to stored integers: the sRGB curve, rounded to the nearest code, fast.

use super::Frame;
use crate::color::transfer;
use std::sync::LazyLock;

/// Finds the code of a number by table instead of by power: the numbers at which the code grows, and for each small interval
/// of numbers (equal leading bits) the code at its start.
struct Quantizer {
    /// Entry k-1 is the smallest number that is stored as k or more.
    thresholds: Vec<f32>,
    /// The code of the smallest number of each interval.
    starts: Vec<u16>,
    /// The bits of the first interval's start.
    first: u32,
    /// How many trailing bits an interval ignores.
    shift: u32,
}

static BITS8: LazyLock<Quantizer> = LazyLock::new(|| Quantizer::new(255, 17));
static BITS16: LazyLock<Quantizer> = LazyLock::new(|| Quantizer::new(65_535, 9));

/// What the tables must reproduce: the curve, times the largest code, rounded.
fn exact(x: f32, max: u16) -> u16 {
    (transfer::srgb_encode(f64::from(x)).clamp(0.0, 1.0) * f64::from(max) + 0.5) as u16
}

impl Quantizer {
    fn new(max: u16, shift: u32) -> Self {
        let thresholds: Vec<f32> = (1..=max).map(|k| threshold(k, max)).collect();
        let first = thresholds[0].to_bits() >> shift << shift;
        let count = ((1f32.to_bits() - first) >> shift) + 1;
        let starts = (0..count).map(|i| exact(f32::from_bits(first + (i << shift)), max)).collect();
        Self { thresholds, starts, first, shift }
    }

    /// The code nearest to the curve; 0 for NaN and what is below 0, the largest one above 1.
    #[inline]
    fn code(&self, x: f32) -> u16 {
        let top = self.thresholds.len();
        if x >= self.thresholds[top - 1] {
            return top as u16;
        }
        if x >= self.thresholds[0] {
            let mut code = self.starts[((x.to_bits() - self.first) >> self.shift) as usize] as usize;
            while self.thresholds[code] <= x {
                code += 1;
            }
            return code as u16;
        }
        0
    }
}

/// The smallest number with this code: near where the inverse curve says, exactly where [`exact`] says.
fn threshold(code: u16, max: u16) -> f32 {
    let mut x = transfer::srgb_decode((f64::from(code) - 0.5) / f64::from(max)) as f32;
    while exact(x, max) < code {
        x = x.next_up();
    }
    while exact(x.next_down(), max) >= code {
        x = x.next_down();
    }
    x
}

/// Alpha and other numbers without a curve; NaN gives 0.
fn linear(x: f32, max: f32) -> f32 {
    x.clamp(0.0, 1.0) * max + 0.5
}

/// Red, green, blue over black where alpha is not kept.
pub(super) fn over_black([r, g, b, a]: [f32; 4]) -> [f32; 3] {
    if a == 1.0 {
        return [r, g, b];
    }
    let a = if a > 0.0 { a.min(1.0) } else { 0.0 };
    [r * a, g * a, b * a]
}

/// Rows of three or four bytes a pixel, with the sRGB curve.
pub(super) fn bytes(frame: &Frame, alpha: bool) -> Vec<u8> {
    let (quantizer, channels) = (&*BITS8, if alpha { 4 } else { 3 });
    let mut out = Vec::with_capacity(frame.pixels.len() * channels);
    for &pixel in &frame.pixels {
        let rgb = if alpha { [pixel[0], pixel[1], pixel[2]] } else { over_black(pixel) };
        out.extend(rgb.map(|c| quantizer.code(c) as u8));
        if alpha {
            out.push(linear(pixel[3], 255.0) as u8);
        }
    }
    out
}

/// The same with 16 bits a channel.
pub(super) fn words(frame: &Frame, alpha: bool) -> Vec<u16> {
    let (quantizer, channels) = (&*BITS16, if alpha { 4 } else { 3 });
    let mut out = Vec::with_capacity(frame.pixels.len() * channels);
    for &pixel in &frame.pixels {
        let rgb = if alpha { [pixel[0], pixel[1], pixel[2]] } else { over_black(pixel) };
        out.extend(rgb.map(|c| quantizer.code(c)));
        if alpha {
            out.push(linear(pixel[3], 65_535.0) as u16);
        }
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_tables_agree_with_the_curve() {
        for (table, max) in [(&BITS8, 255), (&BITS16, 65_535)] {
            for bits in (0..1.5f32.to_bits()).step_by(9973) {
                let x = f32::from_bits(bits);
                assert_eq!(table.code(x), exact(x, max), "{x}");
            }
            for &x in table.thresholds.iter().step_by(7) {
                assert_eq!(table.code(x), exact(x, max), "{x}");
                assert_eq!(table.code(x.next_down()), exact(x.next_down(), max), "below {x}");
            }
        }
    }

    #[test]
    fn what_is_no_light_is_black_and_what_is_too_much_is_white() {
        for x in [f32::NAN, -1.0, f32::NEG_INFINITY, 0.0, -0.0, 1e-30] {
            assert_eq!((BITS8.code(x), BITS16.code(x)), (0, 0), "{x}");
        }
        for x in [1.0, 7.0, f32::INFINITY] {
            assert_eq!((BITS8.code(x), BITS16.code(x)), (255, 65_535), "{x}");
        }
        assert_eq!(linear(f32::NAN, 255.0) as u8, 0);
    }

    #[test]
    fn alpha_is_kept_or_laid_over_black() {
        let frame = Frame { width: 2, height: 1, pixels: vec![[1.0, 1.0, 1.0, 0.5], [1.0, 0.0, 1.0, 1.0]] };
        assert_eq!(bytes(&frame, true), [255, 255, 255, 128, 255, 0, 255, 255]);
        assert_eq!(bytes(&frame, false), [188, 188, 188, 255, 0, 255]);
    }
}
