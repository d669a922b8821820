//! Conversion of linear light to stored integers: the sRGB curve, rounded to the nearest code, by tables.

use super::dither::Ditherer;
use crate::color::{Gamma, transfer};
use std::sync::LazyLock;

/// Quantizes linear light to integer codes of the sRGB curve by a table instead of a power: for each small interval of
/// numbers (with equal leading bits) the code of its start, and the one number in the interval, if any, from which on the
/// code is one more.
struct SrgbQuantizer {
    /// Entry k is the smallest light with a code above k; the last is infinite.
    thresholds: Vec<f32>,
    /// Code of the smallest light in each of the quantizer's intervals.
    starts: Vec<u16>,
    /// Start of the quantizer's first interval, which has code 0.
    lowest: f32,
    /// Number of trailing bits of the light's `f32` that the quantizer's intervals ignore: so few that no two thresholds
    /// are in one interval.
    n_ignored_light_bits: u32,
}

static BITS8: LazyLock<SrgbQuantizer> = LazyLock::new(|| SrgbQuantizer::new(255, 16));
static BITS16: LazyLock<SrgbQuantizer> = LazyLock::new(|| SrgbQuantizer::new(65_535, 8));

impl SrgbQuantizer {
    /// Computes the table for the codes 0 to `max_code`. Its intervals ignore the trailing `n_ignored_light_bits` of the
    /// light's `f32`.
    fn new(max_code: u16, n_ignored_light_bits: u32) -> Self {
        let mut thresholds: Vec<f32> = (1..=max_code).map(|k| srgb_code_lowest_light(k, max_code)).collect();
        thresholds.push(f32::INFINITY);
        let first = (thresholds[0].to_bits() >> n_ignored_light_bits) - 1;
        let mut code = 0;
        let starts = (first..=1f32.to_bits() >> n_ignored_light_bits).map(|interval| {
            while thresholds[code] <= f32::from_bits(interval << n_ignored_light_bits) {
                code += 1;
            }
            code as u16
        });
        Self {
            starts: starts.collect(),
            thresholds,
            lowest: f32::from_bits(first << n_ignored_light_bits),
            n_ignored_light_bits,
        }
    }

    /// Encodes linear light and returns the nearest integer code; 0 for NaN and negative light, the largest code above
    /// 1.
    #[inline]
    fn code_of_light(&self, x: f32) -> u16 {
        let x = if x > self.lowest { x.min(1.0) } else { self.lowest };
        let code = self.starts[((x.to_bits() - self.lowest.to_bits()) >> self.n_ignored_light_bits) as usize];
        code + u16::from(self.thresholds[usize::from(code)] <= x)
    }
}

/// Returns the smallest light with this integer code: that of the half between the code and the one below. As in
/// POV-Ray 3.7 the half itself is rounded up, and the nearest `f32` counts: `rgb 0.7` without any gamma is 178.5 and
/// becomes 179.
fn srgb_code_lowest_light(code: u16, max_code: u16) -> f32 {
    let half = ((f64::from(code) - 0.5) / f64::from(max_code)) as f32;
    transfer::srgb_decode(f64::from(half)) as f32
}

/// Returns the code of alpha and other samples without a transfer curve, plus a half, before truncation to an integer;
/// NaN for NaN, which a conversion to an integer makes 0.
fn linear_code_plus_half(x: f32, max: f32) -> f32 {
    x.clamp(0.0, 1.0) * max + 0.5
}

/// Composites a pixel over black, for pictures without alpha; returns red, green and blue.
pub(super) fn composite_over_black([r, g, b, a]: [f32; 4]) -> [f32; 3] {
    if a == 1.0 {
        return [r, g, b];
    }
    let a = if a > 0.0 { a.min(1.0) } else { 0.0 };
    [r * a, g * a, b * a]
}

/// Encodes pixels by the sRGB curve as three or four bytes a pixel.
pub(super) fn encode_srgb8(pixels: &[[f32; 4]], alpha: bool) -> Vec<u8> {
    let table = &*BITS8;
    pack_pixels(pixels, alpha, |x| table.code_of_light(x) as u8, |a| linear_code_plus_half(a, 255.0) as u8)
}

/// Encodes pixels by the sRGB curve as three or four 16-bit integers a pixel.
pub(super) fn encode_srgb16(pixels: &[[f32; 4]], alpha: bool) -> Vec<u16> {
    let table = &*BITS16;
    pack_pixels(pixels, alpha, |x| table.code_of_light(x), |a| linear_code_plus_half(a, 65_535.0) as u16)
}

/// Encoder of linear light to the integers of a picture file.
pub(super) struct Integers {
    /// True for integers of 16 bits, false for 8 bits.
    pub wide: bool,
    /// True if the file stores alpha as a fourth channel.
    pub alpha: bool,
    pub gamma: Gamma,
    /// Dithering of the rounding errors; `None` for plain rounding.
    pub ditherer: Option<Ditherer>,
    /// Width of the picture, in pixels.
    pub width: usize,
}

impl Integers {
    /// Encodes whole rows of a picture to bytes; 16-bit samples are big-endian if `big_endian` is true, in native order
    /// otherwise.
    pub fn encode_rows(&mut self, rows: &[[f32; 4]], big_endian: bool) -> Vec<u8> {
        let order = if big_endian { u16::to_be_bytes } else { u16::to_ne_bytes };
        if self.ditherer.is_none() && self.gamma == Gamma::Srgb {
            return match self.wide {
                false => encode_srgb8(rows, self.alpha),
                true => encode_srgb16(rows, self.alpha).into_iter().flat_map(order).collect(),
            };
        }
        let scale = Scale { gamma: self.gamma, max: if self.wide { 65_535.0 } else { 255.0 } };
        let channels = if self.alpha { 4 } else { 3 };
        let mut out = vec![];
        for row in rows.chunks(self.width) {
            let lights: Vec<f32> = row.iter().flat_map(|pixel| self.channel_lights(pixel)).collect();
            let codes = match &mut self.ditherer {
                Some(ditherer) => ditherer.dither_row(&lights, scale),
                None => lights
                    .iter()
                    .enumerate()
                    .map(|(i, x)| scale.round_down_to_code(scale.unrounded_code(i % channels, *x) + 0.5))
                    .collect(),
            };
            match self.wide {
                true => out.extend(codes.into_iter().flat_map(order)),
                false => out.extend(codes.into_iter().map(|code| code as u8)),
            }
        }
        out
    }

    /// Returns the channels to encode of a linear RGBA pixel, still linear and clamped to 0..1: RGBA if the file stores
    /// alpha, otherwise RGB composited over black.
    fn channel_lights(&self, &[r, g, b, a]: &[f32; 4]) -> impl Iterator<Item = f32> {
        let [r, g, b] = if self.alpha { [r, g, b] } else { composite_over_black([r, g, b, a]) };
        // (`max` replaces NaN by 0.)
        [r, g, b, a].into_iter().take(if self.alpha { 4 } else { 3 }).map(|x| x.clamp(0.0, 1.0).max(0.0))
    }
}

/// Conversion between light and the integer codes of a picture file. A fourth channel is opacity, which has no curve.
#[derive(Clone, Copy)]
pub(super) struct Scale {
    pub gamma: Gamma,
    /// The largest integer code of a channel: 255 or 65535.
    pub max: f32,
}

impl Scale {
    /// Encodes the linear light of a channel and returns it in units of integer codes, not rounded.
    pub fn unrounded_code(self, channel: usize, light: f32) -> f32 {
        let encoded = if channel == 3 { light } else { self.gamma.encode(f64::from(light)) as f32 };
        encoded.clamp(0.0, 1.0) * self.max
    }

    /// Rounds an encoded light down to an integer code.
    pub fn round_down_to_code(self, unrounded_code_value: f32) -> u16 {
        unrounded_code_value.min(self.max) as u16
    }

    /// Returns the linear light of an integer code in a channel.
    pub fn light_of_code(self, channel: usize, code: u16) -> f32 {
        let number = f64::from(code) / f64::from(self.max);
        (if channel == 3 { number } else { self.gamma.decode(number) }) as f32
    }
}

/// Packs the pixels' channels: colours are encoded by one function and alpha by another.
fn pack_pixels<T: Copy + Default>(
    pixels: &[[f32; 4]],
    alpha: bool,
    color: impl Fn(f32) -> T,
    opacity: impl Fn(f32) -> T,
) -> Vec<T> {
    let channels = if alpha { 4 } else { 3 };
    let mut out = vec![T::default(); pixels.len() * channels];
    if alpha {
        for (to, &[r, g, b, a]) in out.as_chunks_mut::<4>().0.iter_mut().zip(pixels) {
            *to = [color(r), color(g), color(b), opacity(a)];
        }
    } else {
        for (to, &pixel) in out.as_chunks_mut::<3>().0.iter_mut().zip(pixels) {
            *to = composite_over_black(pixel).map(&color);
        }
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The reference for the tables: the curve, times the largest code, rounded.
    fn exact(x: f64, max: u16) -> u16 {
        (transfer::srgb_encode(x).clamp(0.0, 1.0) * f64::from(max) + 0.5) as u16
    }

    #[test]
    fn the_tables_agree_with_the_curve() {
        for (table, max) in [(&BITS8, 255), (&BITS16, 65_535)] {
            let samples = (0..1.5f32.to_bits()).step_by(9973).map(f32::from_bits);
            for x in samples.chain(table.thresholds.iter().step_by(7).copied()) {
                // (the last bits may differ)
                let near = [-2e-7, 2e-7].map(|d| exact(f64::from(x) * (1.0 + d), max));
                assert!((near[0]..=near[1]).contains(&table.code_of_light(x)), "{x}");
            }
            assert!(table.thresholds.is_sorted_by(|a, b| a < b));
        }
    }

    /// Numbers without gamma, as in scenes before version 3.7 (POV-Ray 3.7's output).
    #[test]
    fn a_half_is_rounded_up() {
        let code = |table: &SrgbQuantizer, x: f32| table.code_of_light(transfer::srgb_decode(f64::from(x)) as f32);
        for (table, max) in [(&BITS8, 255), (&BITS16, 65_535)] {
            for k in 0..max {
                let half = ((f64::from(k) + 0.5) / f64::from(max)) as f32;
                let codes = [half * (1.0 - 4e-7), half, half.next_up()].map(|x| code(table, x));
                assert_eq!(codes, [k, k + 1, k + 1], "{half}");
                assert_eq!(code(table, (f64::from(k) / f64::from(max)) as f32), k);
            }
        }
        assert_eq!([0.1, 0.5, 0.7, 0.9].map(|x| code(&BITS8, x)), [26, 128, 179, 230]);
    }

    #[test]
    fn nan_is_black_and_overflow_is_white() {
        for x in [f32::NAN, -1.0, f32::NEG_INFINITY, 0.0, -0.0, 1e-30] {
            assert_eq!((BITS8.code_of_light(x), BITS16.code_of_light(x)), (0, 0), "{x}");
        }
        for x in [1.0, 7.0, f32::INFINITY] {
            assert_eq!((BITS8.code_of_light(x), BITS16.code_of_light(x)), (255, 65_535), "{x}");
        }
        assert_eq!(linear_code_plus_half(f32::NAN, 255.0) as u8, 0);
    }

    #[test]
    fn other_curves_give_the_nearest_code() {
        let mut integers = Integers { wide: false, alpha: true, gamma: Gamma::Power(2.0), ditherer: None, width: 2 };
        let row = [[0.25, f32::NAN, 4.0, 0.5], [-1.0, 1.0, f32::INFINITY, f32::NAN]];
        assert_eq!(integers.encode_rows(&row, true), [128, 0, 255, 128, 0, 255, 255, 0]);
        integers.wide = true;
        assert_eq!(integers.encode_rows(&row, true)[..6], [0x80, 0, 0, 0, 0xff, 0xff]);
    }

    #[test]
    fn alpha_is_kept_or_composited_over_black() {
        let pixels = [[1.0, 1.0, 1.0, 0.5], [1.0, 0.0, 1.0, 1.0]];
        assert_eq!(encode_srgb8(&pixels, true), [255, 255, 255, 128, 255, 0, 255, 255]);
        assert_eq!(encode_srgb8(&pixels, false), [188, 188, 188, 255, 0, 255]);
    }
}
