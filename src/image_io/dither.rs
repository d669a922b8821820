//! Dithering (manual, "Output File Dithering"): where neighbours are rounded up and down in turn, more shades are seen than a file has.
//! The patterns and directions are those of POV-Ray 3.7, measured on it; a file is the same however its rows come.

/// How numbers are rounded.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Dither {
    /// By a square pattern of 2, 3 or 4 pixels (Bayer, An optimum method for two-level rendition, 1973).
    Bayer(usize),
    /// The error goes to the next pixel.
    Row,
    /// To the next one and two of those below.
    Simple,
    /// To the next one and three below (Floyd and Steinberg, An adaptive algorithm for spatial greyscale, 1976).
    FloydSteinberg,
}

const TWO: [usize; 4] = [1, 4, 3, 2];
const THREE: [usize; 9] = [3, 6, 2, 7, 1, 8, 4, 9, 5];
const FOUR: [usize; 16] = [1, 13, 4, 16, 9, 5, 12, 8, 3, 15, 2, 14, 11, 7, 10, 6];

/// Where the error of a pixel goes: pixels to the right, rows down, share of it.
type Share = (isize, usize, f32);
const SIMPLE: &[Share] = &[(1, 0, 0.5), (0, 1, 0.25), (1, 1, 0.25)];
const FLOYD_STEINBERG: &[Share] = &[(1, 0, 7.0 / 16.0), (-1, 1, 3.0 / 16.0), (0, 1, 5.0 / 16.0), (1, 1, 1.0 / 16.0)];

/// Rounds one row after the other.
pub(super) struct Ditherer {
    dither: Dither,
    channels: usize,
    row: usize,
    /// Errors that this row and the next one get.
    errors: [Vec<f32>; 2],
    /// What the last pixel left, by channel.
    last: [f32; 4],
}

impl Ditherer {
    pub fn new(dither: Dither, width: usize, channels: usize) -> Self {
        let errors = [vec![0.0; width * channels], vec![0.0; width * channels]];
        Self { dither, channels, row: 0, errors, last: [0.0; 4] }
    }

    /// Numbers of a row, which are at most `max`, to codes.
    pub fn codes(&mut self, row: &[f32], max: f32) -> Vec<u16> {
        let codes = row.iter().enumerate().map(|(i, &x)| self.code(i, x, max) as u16).collect();
        self.errors.swap(0, 1);
        self.errors[1].fill(0.0);
        self.row += 1;
        codes
    }

    /// The code of the number with this index in its row.
    fn code(&mut self, i: usize, x: f32, max: f32) -> f32 {
        let (column, channel) = (i / self.channels, i % self.channels);
        let shares = match self.dither {
            Dither::Bayer(n) => {
                let pattern: &[usize] = [&TWO[..], &THREE, &FOUR][n.clamp(2, 4) - 2];
                let level = pattern[self.row % n * n + column % n] as f32;
                return (x + level / (n * n) as f32).floor().clamp(0.0, max);
            }
            Dither::Row => {
                let wanted = x + self.last[channel];
                let code = (wanted + 0.5).floor().clamp(0.0, max);
                self.last[channel] = wanted - code;
                return code;
            }
            Dither::Simple => SIMPLE,
            Dither::FloydSteinberg => FLOYD_STEINBERG,
        };
        let wanted = x + self.errors[0][i];
        let code = (wanted + 0.5).floor().clamp(0.0, max);
        for &(right, down, share) in shares {
            let at = i.checked_add_signed(right * self.channels as isize);
            if let Some(error) = at.and_then(|at| self.errors[down].get_mut(at)) {
                *error += share * (wanted - code);
            }
        }
        code
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const ALL: [Dither; 6] =
        [Dither::Bayer(2), Dither::Bayer(3), Dither::Bayer(4), Dither::Row, Dither::Simple, Dither::FloydSteinberg];

    #[test]
    fn shades_between_codes_are_kept_on_the_whole() {
        for dither in ALL {
            for shade in [0.25, 100.4, 254.7] {
                let mut ditherer = Ditherer::new(dither, 120, 3);
                let codes: Vec<u16> = (0..120).flat_map(|_| ditherer.codes(&[shade; 360], 255.0)).collect();
                let mean = codes.iter().map(|&c| f64::from(c)).sum::<f64>() / codes.len() as f64;
                // A pattern of nine or sixteen has so many shades; and all of its levels are rounded up.
                assert!((mean - f64::from(shade)).abs() < 0.27, "{dither:?}: {mean}, not {shade}");
                assert!(codes.iter().all(|&code| (f32::from(code) - shade).abs() <= 1.0), "{dither:?}");
            }
        }
    }

    /// Of a picture of one shade, 100.53/255 (POV-Ray 3.7, `+THB4`).
    #[test]
    fn patterns_are_povrays() {
        let mut ditherer = Ditherer::new(Dither::Bayer(4), 4, 1);
        let rows: Vec<Vec<u16>> = (0..4).map(|_| ditherer.codes(&[100.53; 4], 255.0)).collect();
        assert_eq!(rows, [[100, 101, 100, 101], [101, 100, 101, 101], [100, 101, 100, 101], [101, 100, 101, 100]]);
    }
}
