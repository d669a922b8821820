//! Dithering (manual, "Output File Dithering"): neighbouring pixels are rounded up and down alternately, which shows
//! more shades than a file has. Patterns, shares and rounding are POV-Ray's (quirk: `dithering`); the result does not
//! depend on how rows are grouped. Patterns are added to the numbers of the file; errors are diffused as light, which
//! preserves the total light.

use super::quantize::Scale;

/// Dithering method for rounding light to integer codes.
#[derive(Clone, Copy, Debug, PartialEq, Eq, serde::Serialize, serde::Deserialize)]
pub enum Dither {
    /// Ordered dithering by a pattern with a side of 2, 3 or 4 pixels (Bayer, An optimum method for two-level
    /// rendition, 1973).
    Bayer(usize),
    /// Dithering that adds the rounding error to the row's next pixel.
    Row,
    /// Dithering that divides the rounding error among the next pixel and two below.
    Simple,
    /// Dithering that divides the rounding error among the next pixel and three below (Floyd and Steinberg, An adaptive
    /// algorithm for spatial greyscale, 1976).
    FloydSteinberg,
}

const TWO: [usize; 4] = [1, 4, 3, 2];
const THREE: [usize; 9] = [3, 6, 2, 7, 1, 8, 4, 9, 5];
const FOUR: [usize; 16] = [1, 13, 4, 16, 9, 5, 12, 8, 3, 15, 2, 14, 11, 7, 10, 6];

/// A receiver of a pixel's rounding error in dithering: offset to the right, offset down, share.
type Share = (isize, usize, f32);
const SIMPLE: &[Share] = &[(1, 0, 0.5), (0, 1, 0.25), (1, 1, 0.25)];
const FLOYD_STEINBERG: &[Share] = &[(1, 0, 7.0 / 16.0), (-1, 1, 3.0 / 16.0), (0, 1, 5.0 / 16.0), (1, 1, 1.0 / 16.0)];

/// State of a picture's dithering, row after row.
pub(super) struct Ditherer {
    dither: Dither,
    channels: usize,
    row: usize,
    /// Rounding errors to be added to this row and the two below, by pixel and channel.
    errors: [Vec<f32>; 3],
    /// Rounding error of the last pixel in the row, by channel.
    last: [f32; 4],
}

impl Ditherer {
    pub fn new(dither: Dither, width: usize, channels: usize) -> Self {
        let errors = [(); 3].map(|()| vec![0.0; width * channels]);
        Self { dither, channels, row: 0, errors, last: [0.0; 4] }
    }

    /// Dithers a row of light, from 0 to 1, channel by channel, to integer codes.
    pub fn dither_row(&mut self, row: &[f32], scale: Scale) -> Vec<u16> {
        let codes = row.iter().enumerate().map(|(i, &x)| self.dither_sample(i, x, scale)).collect();
        self.errors.rotate_left(1);
        self.errors[2].fill(0.0);
        self.row += 1;
        codes
    }

    /// Dithers the light with index `i` in its row to an integer code.
    fn dither_sample(&mut self, i: usize, light: f32, scale: Scale) -> u16 {
        let (column, channel) = (i / self.channels, i % self.channels);
        let round = |light| scale.round_down_to_code(scale.unrounded_code(channel, light) + 0.5);
        match self.dither {
            Dither::Bayer(n) => {
                let pattern: &[usize] = [&TWO[..], &THREE, &FOUR][n.clamp(2, 4) - 2];
                let level = pattern[self.row % n * n + column % n] as f32;
                scale.round_down_to_code(scale.unrounded_code(channel, light) + level / (n * n) as f32)
            }
            Dither::Row => {
                let wanted = light + self.last[channel];
                let code = round(wanted);
                self.last[channel] = wanted - scale.light_of_code(channel, code);
                code
            }
            Dither::Simple | Dither::FloydSteinberg => {
                let wanted = light + self.errors[0][i];
                let code = round(wanted);
                self.distribute_error(i, wanted - scale.light_of_code(channel, code));
                code
            }
        }
    }

    /// Distributes a pixel's rounding error to its neighbours. The first column receives errors from above one row
    /// late, and errors beyond the sides are lost (quirk: `dithering`).
    fn distribute_error(&mut self, i: usize, error: f32) {
        let shares = if self.dither == Dither::Simple { SIMPLE } else { FLOYD_STEINBERG };
        for &(right, down, share) in shares {
            let Some(at) = i.checked_add_signed(right * self.channels as isize) else { continue };
            let late = usize::from(at < self.channels);
            if let Some(sum) = self.errors[down + late].get_mut(at) {
                *sum += error * share;
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::color::Gamma;

    const ALL: [Dither; 6] =
        [Dither::Bayer(2), Dither::Bayer(3), Dither::Bayer(4), Dither::Row, Dither::Simple, Dither::FloydSteinberg];

    fn scale(gamma: Gamma) -> Scale {
        Scale { gamma, max: 255.0 }
    }

    #[test]
    fn light_between_codes_is_kept_on_the_whole() {
        for (dither, gamma) in ALL.into_iter().flat_map(|dither| [(dither, Gamma::Raw), (dither, Gamma::Srgb)]) {
            for shade in [0.25, 100.4, 254.7] {
                let (scale, light) = (scale(gamma), gamma.decode(f64::from(shade) / 255.0) as f32);
                let mut ditherer = Ditherer::new(dither, 120, 3);
                let codes: Vec<u16> = (0..120).flat_map(|_| ditherer.dither_row(&[light; 360], scale)).collect();
                let mean = codes.iter().map(|&c| f64::from(c)).sum::<f64>() / codes.len() as f64;
                // A pattern of nine or sixteen pixels has as many shades, and all of its levels are rounded up.
                assert!((mean - f64::from(shade)).abs() < 0.27, "{dither:?}: {mean}, not {shade}");
                assert!(codes.iter().all(|&code| (f32::from(code) - shade).abs() <= 1.0), "{dither:?}");
                let lights = codes.iter().map(|&code| f64::from(scale.light_of_code(0, code)));
                let mean = lights.sum::<f64>() / codes.len() as f64;
                let pattern = matches!(dither, Dither::Bayer(_));
                assert!(pattern || (mean - f64::from(light)).abs() < 2e-5, "{dither:?}: {mean}, not {light}");
            }
        }
    }

    /// On a picture of one shade, 100.53/255 (POV-Ray 3.7, `+THB4`).
    #[test]
    fn patterns_are_povrays() {
        let mut ditherer = Ditherer::new(Dither::Bayer(4), 4, 1);
        let row = [100.53 / 255.0; 4];
        let rows: Vec<Vec<u16>> = (0..4).map(|_| ditherer.dither_row(&row, scale(Gamma::Raw))).collect();
        assert_eq!(rows, [[100, 101, 100, 101], [101, 100, 101, 101], [100, 101, 100, 101], [101, 100, 101, 100]]);
    }

    /// On a picture of `rgb 0.03` (POV-Ray 3.7, `+THD1`, `+THD2`, `+THFS`).
    #[test]
    fn errors_go_where_povrays_go() {
        let rows = |dither| {
            let mut ditherer = Ditherer::new(dither, 12, 1);
            [(); 4].map(|()| {
                let up = ditherer
                    .dither_row(&[0.03; 12], scale(Gamma::Srgb))
                    .into_iter()
                    .map(|code| (code - 48).to_string());
                up.collect::<String>()
            })
        };
        assert_eq!(rows(Dither::Row), ["010100100101", "001010010010", "100100101001", "010010010100"]);
        assert_eq!(rows(Dither::Simple), ["010010010010", "010100100100", "010010101010", "010100100100"]);
        assert_eq!(rows(Dither::FloydSteinberg), ["010010010010", "001001001001", "010101010100", "100100100101"]);
    }
    #[test]
    fn nan_leaves_no_error() {
        for dither in ALL {
            let mut ditherer = Ditherer::new(dither, 1, 4);
            let codes = [(); 3].map(|()| ditherer.dither_row(&[0.0, 1.0, 1.0, 0.0], scale(Gamma::Srgb)));
            assert!(
                codes.iter().all(|row| *row == [0, 255, 255, 0]) || matches!(dither, Dither::Bayer(_)),
                "{dither:?}"
            );
        }
    }
}
