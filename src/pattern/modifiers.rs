//! What any field pattern takes: `frequency`, `phase` and the wave's shape (manual, "Pattern Modifiers").

use crate::math::fp;
use crate::value::words::{Row, set, specs, word};
use crate::value::{Kind, WordSpec};
use serde::Serialize;
use std::f64::consts::PI;

/// How a number in [0, 1) becomes another.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Wave {
    /// As it is.
    #[default]
    Ramp,
    /// Up and down again.
    Triangle,
    /// Up and down, rounded.
    Sine,
    /// Two half circles, more or less.
    Scallop,
    /// Flat at both ends.
    Cubic,
    /// To a power.
    Poly(f64),
}

/// Frequency, phase, wave. Numbers are kept in single precision, as in POV-Ray (seen from the 8th digit on).
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize)]
pub struct Modifiers {
    /// How often the map is run through in a unit; 0 leaves the pattern as it is. Unless said, 1; the names of cells and of some
    /// other patterns set it to 0.
    pub frequency: Option<f64>,
    /// Where the map begins.
    pub phase: f64,
    /// The wave's shape.
    pub wave: Wave,
}

/// POV-Ray 3.7 wraps at this rather than at 1, as was measured: 3.9375 below 0 comes out at 0.0625 + 0.00003.
pub(super) const PERIOD: f64 = 1.00001;

impl Modifiers {
    /// Nothing said.
    pub const NONE: Self = Self { frequency: None, phase: 0.0, wave: Wave::Ramp };

    /// The words it takes.
    pub const WORDS: &[WordSpec] = specs!(Self::ROWS);

    pub(super) const ROWS: &[Row<Self>] = &[
        word("frequency", Kind::Float, "1", "passes through the map in a unit")
            .sets(|s, r| set(&mut s.frequency, r.float().map(|x| Some(single(x))))),
        word("phase", Kind::Float, "0", "where the map begins").sets(|s, r| set(&mut s.phase, r.float().map(single))),
        word("ramp_wave", Kind::Nothing, "", "rises and falls back at once")
            .sets(|s, _| set(&mut s.wave, Ok(Wave::Ramp))),
        word("triangle_wave", Kind::Nothing, "", "rises and falls").sets(|s, _| set(&mut s.wave, Ok(Wave::Triangle))),
        word("sine_wave", Kind::Nothing, "", "rises and falls, rounded").sets(|s, _| set(&mut s.wave, Ok(Wave::Sine))),
        word("scallop_wave", Kind::Nothing, "", "a row of arches").sets(|s, _| set(&mut s.wave, Ok(Wave::Scallop))),
        word("cubic_wave", Kind::Nothing, "", "flat at both ends").sets(|s, _| set(&mut s.wave, Ok(Wave::Cubic))),
        word("poly_wave", Kind::Float, "1", "to this power")
            .sets(|s, r| set(&mut s.wave, r.optional_float().map(|x| Wave::Poly(single(x.unwrap_or(1.0)))))),
    ];

    /// The pattern's number as the map sees it. A frequency of 0 leaves it as it is, but the wave still works on it.
    pub fn apply(&self, raw: f64) -> f64 {
        let frequency = self.frequency.unwrap_or(1.0);
        let shifted = if frequency == 0.0 { raw } else { raw * frequency + self.phase };
        let shifted = if frequency == 0.0 { shifted } else { wrapped(shifted) };
        let v = if shifted < 0.0 { fp::fraction(shifted) } else { shifted };
        match self.wave {
            Wave::Ramp => v,
            Wave::Triangle => 1.0 - (2.0 * v.fract() - 1.0).abs(),
            Wave::Sine => (1.0 + fp::sin(2.0 * PI * v)) / 2.0,
            Wave::Scallop => fp::sin(PI * v).abs(),
            Wave::Cubic => v * v * (3.0 - 2.0 * v),
            Wave::Poly(exponent) => fp::pow(v, exponent),
        }
    }

    /// The number of a cell as the list sees it: cells have no frequency unless it is said.
    pub fn apply_to_cell(&self, cell: usize) -> f64 {
        let cells = Self { frequency: Some(self.frequency.unwrap_or(0.0)), ..*self };
        cells.apply(cell as f64)
    }
}

/// What `%` leaves of a number after all of its periods, by subtractions that are exact too, as long as they are few.
fn wrapped(x: f64) -> f64 {
    let mut rest = x.abs();
    if rest < PERIOD {
        return x;
    }
    if rest >= 16.0 * PERIOD {
        return x % PERIOD;
    }
    // A difference is exact if neither number is more than twice the other (Sterbenz, Floating-point computation, 1974).
    for periods in [8.0, 4.0, 2.0, 1.0] {
        if rest >= periods * PERIOD {
            rest -= periods * PERIOD;
        }
    }
    rest.copysign(x)
}

fn single(x: f64) -> f64 {
    f64::from(x as f32)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn wrapping_is_a_remainder() {
        for i in 0..4000 {
            let x = f64::from(i) * 0.010_001 - 20.0;
            assert_eq!(wrapped(x), x % PERIOD, "{x}");
            let near = f64::from(i - 2000) * PERIOD;
            for x in [near, near.next_up(), near.next_down()] {
                assert_eq!(wrapped(x), x % PERIOD, "{x}");
            }
        }
    }
}
