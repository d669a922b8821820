//! Parameters of all patterns of numbers: `frequency`, `phase` and wave type (manual, "Pattern Modifiers").

use crate::math::fp;
use crate::value::words::{Row, set, specs, word};
use crate::value::{ValueKind, WordSpec};
use serde::Serialize;
use std::f64::consts::PI;

/// Wave type of a pattern: function from [0, 1) to [0, 1] after frequency and phase.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Wave {
    /// Wave type `ramp_wave`: the number grows from 0 to 1, then jumps back to 0.
    #[default]
    Ramp,
    /// Wave type `triangle_wave`: linear up, then linear down.
    Triangle,
    /// Wave type `sine_wave`: sine from 0 to 1 and back.
    Sine,
    /// Wave type `scallop_wave`: absolute value of a sine.
    Scallop,
    /// Wave type `cubic_wave`: cubic, with zero slope at both ends.
    Cubic,
    /// Wave type `poly_wave`: power with this exponent.
    Poly(f64),
}

/// Frequency, phase and wave type of a pattern. They have single precision, as in POV-Ray (quirk:
/// `single_precision_modifiers`).
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize)]
pub struct Modifiers {
    /// Repetitions of the pattern's map per unit; 0 leaves the pattern's number unchanged. The default is 1, or 0 for
    /// cells and some other patterns.
    pub frequency: Option<f64>,
    /// Offset of the pattern's map.
    pub phase: f64,
    /// Wave type: function of the fractional part that frequency and phase give.
    pub wave: Wave,
}

/// Period of a pattern's wave (quirk: wave_period).
pub(super) const PERIOD: f64 = 1.00001;
/// The period rounded to 26 bits, whose products with numbers of 27 bits are exact, and the rest.
const PERIOD_PARTS: [f64; 2] = [HIGH, PERIOD - HIGH];
const HIGH: f64 = f64::from_bits(PERIOD.to_bits() & !0x7ff_ffff);
/// Number that is certainly above 1/[`PERIOD`], by a few units in the last place.
const FREQUENCY: f64 = f64::from_bits((1.0 / PERIOD).to_bits() + 4);
/// Magnitude of a number below which [`remainder_of_period`] needs no general remainder.
const FAR: f64 = 1e6;

impl Modifiers {
    /// The default frequency, phase and wave type of a pattern.
    pub const NONE: Self = Self { frequency: None, phase: 0.0, wave: Wave::Ramp };

    /// Keywords of a pattern's frequency, phase and wave types.
    pub const WORDS: &[WordSpec] = specs!(Self::ROWS);

    pub(super) const ROWS: &[Row<Self>] = &[
        word("frequency", ValueKind::Float, "1", "passes through the map in a unit")
            .sets(|s, r| set(&mut s.frequency, r.float().map(|x| Some(to_single_precision(x))))),
        word("phase", ValueKind::Float, "0", "where the map begins")
            .sets(|s, r| set(&mut s.phase, r.float().map(to_single_precision))),
        word("ramp_wave", ValueKind::Nothing, "", "rises and falls back at once")
            .sets(|s, _| set(&mut s.wave, Ok(Wave::Ramp))),
        word("triangle_wave", ValueKind::Nothing, "", "rises and falls")
            .sets(|s, _| set(&mut s.wave, Ok(Wave::Triangle))),
        word("sine_wave", ValueKind::Nothing, "", "rises and falls, rounded")
            .sets(|s, _| set(&mut s.wave, Ok(Wave::Sine))),
        word("scallop_wave", ValueKind::Nothing, "", "a row of arches")
            .sets(|s, _| set(&mut s.wave, Ok(Wave::Scallop))),
        word("cubic_wave", ValueKind::Nothing, "", "flat at both ends").sets(|s, _| set(&mut s.wave, Ok(Wave::Cubic))),
        word("poly_wave", ValueKind::Float, "1", "to this power").sets(|s, r| {
            set(&mut s.wave, r.optional_float().map(|x| Wave::Poly(to_single_precision(x.unwrap_or(1.0)))))
        }),
    ];

    /// Applies frequency, phase and wave type to a pattern's number; returns the number that the map receives. A
    /// frequency of 0 leaves the number unchanged except for the wave.
    pub fn apply_to_number(&self, raw: f64) -> f64 {
        let frequency = self.frequency.unwrap_or(1.0);
        let shifted = if frequency == 0.0 { raw } else { raw * frequency + self.phase };
        let shifted = if frequency == 0.0 { shifted } else { remainder_of_period(shifted) };
        let v = if shifted < 0.0 { fp::fraction_above_floor(shifted) } else { shifted };
        match self.wave {
            Wave::Ramp => v,
            Wave::Triangle => 1.0 - (2.0 * v.fract() - 1.0).abs(),
            Wave::Sine => (1.0 + fp::sin(2.0 * PI * v)) / 2.0,
            Wave::Scallop => fp::sin(PI * v).abs(),
            Wave::Cubic => v * v * (3.0 - 2.0 * v),
            Wave::Poly(exponent) => fp::pow(v, exponent),
        }
    }

    /// True if [`Self::apply_to_number`] returns each number from 0 to 1 unchanged.
    pub fn keep_unit_interval(&self) -> bool {
        let is_unshifted = match self.frequency {
            None | Some(1.0) => self.phase == 0.0,
            Some(frequency) => frequency == 0.0,
        };
        is_unshifted && self.wave == Wave::Ramp
    }

    /// Returns the index that a pattern's list of cells receives: frequency and phase apply only if a frequency is
    /// given.
    pub fn apply_to_cell(&self, cell: usize) -> f64 {
        let cells = Self { frequency: Some(self.frequency.unwrap_or(0.0)), ..*self };
        cells.apply_to_number(cell as f64)
    }
}

/// Returns the remainder of a number and the period, with the sign of the number: exactly that of the operator `%`. (Quicker than
/// [`fp::remainder`], since the parts and the inverse of the divisor are constants.)
fn remainder_of_period(number: f64) -> f64 {
    let x = number.abs();
    if x < PERIOD {
        return number;
    }
    if x < FAR {
        // The quotient is right or one too large. Both differences are multiples of 2⁻⁵² and below 2, so that neither is rounded.
        let quotient = (x * FREQUENCY).trunc();
        let rest = (x - quotient * PERIOD_PARTS[0]) - quotient * PERIOD_PARTS[1];
        return (if rest < 0.0 { rest + PERIOD } else { rest }).copysign(number);
    }
    fp::remainder(number, PERIOD)
}

fn to_single_precision(x: f64) -> f64 {
    f64::from(x as f32)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn wrapping_is_a_remainder() {
        for i in 0..4000 {
            let x = f64::from(i) * 0.010_001 - 20.0;
            assert_eq!(remainder_of_period(x), x % PERIOD, "{x}");
            let near = f64::from(i - 2000) * PERIOD;
            for x in [near, near.next_up(), near.next_down()] {
                assert_eq!(remainder_of_period(x), x % PERIOD, "{x}");
            }
        }
    }
}
