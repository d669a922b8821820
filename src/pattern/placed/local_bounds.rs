//! Bounds on a pattern's numbers around a point: their range and the length of their gradient. Isosurfaces skip balls
//! that cannot contain their surface.

use super::{Modifiers, Wave, modifiers::PERIOD};
use crate::function::{Interval, LocalBounds};
use crate::math::{DMat3, fp};
use std::f64::consts::PI;

impl Modifiers {
    /// Returns local bounds of a pattern's numbers after frequency, phase and wave, from their bounds `raw` before.
    pub fn modified_bounds(&self, raw: LocalBounds) -> LocalBounds {
        let frequency = self.frequency.unwrap_or(1.0);
        let shifted = if frequency == 0.0 {
            raw
        } else {
            // (Computed like the numbers themselves, which preserves their order; a wider range that begins at 0 would
            // begin in the period before.)
            let [a, b] = [raw.range.lo, raw.range.hi].map(|x| x * frequency + self.phase);
            LocalBounds { range: Interval::new(a, b), steepest: raw.steepest * frequency.abs(), ..raw }
        };
        let Interval { lo, hi } = shifted.range;
        // Numbers within one period, from 0 on; negative ones are counted from 1 on.
        let start = match ((lo / PERIOD).floor(), (hi / PERIOD).floor()) {
            _ if frequency == 0.0 && lo >= 0.0 => Some(0.0),
            _ if frequency == 0.0 => None,
            (a, b) if a != b => None,
            (a, _) if a < 0.0 => Some((a + 1.0) * PERIOD - 1.0),
            (a, _) => Some(a * PERIOD),
        };
        match start {
            Some(0.0) => self.wave.bounds_of_wave_over(shifted),
            Some(start) if lo - start >= 0.0 => self.wave.bounds_of_wave_over(LocalBounds {
                range: Interval { lo: lo - start, hi: hi - start }.widened_by_rounding(),
                ..shifted
            }),
            _ => LocalBounds::UNKNOWN,
        }
    }
}

impl Wave {
    /// Returns local bounds of a wave over numbers within one period.
    fn bounds_of_wave_over(self, v: LocalBounds) -> LocalBounds {
        let Interval { lo, hi } = v.range;
        let chain = |range: Interval, factor: f64| LocalBounds {
            range: range.widened_by_rounding(),
            steepest: v.steepest * factor,
            ..v
        };
        match self {
            Wave::Ramp => v,
            _ if !(lo >= 0.0 && hi <= 1.0) => LocalBounds::UNKNOWN,
            Wave::Triangle => {
                let ends = Interval::new(1.0 - (2.0 * lo - 1.0).abs(), 1.0 - (2.0 * hi - 1.0).abs());
                chain(if v.range.contains(0.5) { ends.hull(Interval::point(1.0)) } else { ends }, 2.0)
            }
            Wave::Sine => {
                let sine = (v.range * Interval::point(2.0 * PI)).sin();
                chain(Interval::point(0.5) + sine * Interval::point(0.5), PI)
            }
            Wave::Scallop => chain((v.range * Interval::point(PI)).sin().abs(), PI),
            Wave::Cubic => chain(v.range.map_increasing(|v| v * v * (3.0 - 2.0 * v)), 1.5),
            Wave::Poly(power) if power >= 1.0 => chain(v.range.map_increasing(|v| fp::pow(v, power)), power),
            Wave::Poly(_) => LocalBounds::UNKNOWN,
        }
    }
}

/// Upper bound of the factor by which a matrix lengthens a vector: the square root of the largest eigenvalue of MᵀM,
/// found by repeated squaring.
pub fn max_stretch(m: &DMat3) -> f64 {
    let s = m.transpose() * *m;
    let size = s.to_cols_array().iter().fold(0.0_f64, |most, x| most.max(x.abs()));
    if size == 0.0 || !s.is_finite() {
        return if s.is_finite() { 0.0 } else { f64::INFINITY };
    }
    let mut power = s * (1.0 / size);
    for _ in 0..4 {
        power = power * power;
    }
    let norm = power.to_cols_array().iter().map(|x| x * x).sum::<f64>().sqrt();
    (size * fp::pow(norm, 1.0 / 16.0)).sqrt() * (1.0 + 1e-9)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::noise::NoiseGenerator;
    use crate::math::{DVec3, Transform, rng};
    use crate::pattern::*;

    #[test]
    fn matrices_stretch_as_far_as_their_longest_image() {
        let turned = DMat3::from_rotation_x(0.7) * DMat3::from_diagonal(DVec3::new(2.0, 0.5, -3.0));
        assert!((3.0..3.2).contains(&max_stretch(&turned)), "{}", max_stretch(&turned));
        assert_eq!(max_stretch(&DMat3::ZERO), 0.0);
        assert_eq!(max_stretch(&(DMat3::IDENTITY * f64::NAN)), f64::INFINITY);
    }

    fn kinds() -> Vec<PatternKind> {
        let crackle = |form: [f64; 3], metric| Crackle { form: form.into(), metric, offset: 0.1, solid: false };
        let fields: [FieldPattern; 17] = [
            FieldPattern::Boxed(Boxed {}),
            FieldPattern::Planar(Planar {}),
            FieldPattern::Spherical(Spherical {}),
            FieldPattern::Cylindrical(Cylindrical {}),
            FieldPattern::Bozo(Bozo {}),
            FieldPattern::Dents(Dents {}),
            FieldPattern::Granite(Granite {}),
            FieldPattern::Wrinkles(Wrinkles {}),
            FieldPattern::Leopard(Leopard {}),
            FieldPattern::Onion(Onion {}),
            FieldPattern::Marble(Marble {}),
            FieldPattern::Wood(Wood {}),
            FieldPattern::Gradient(Gradient { direction: DVec3::new(0.6, -0.8, 0.0) }),
            FieldPattern::Crackle(crackle([-1.0, 1.0, 0.0], 2.0)),
            FieldPattern::Crackle(crackle([0.3, 0.2, -0.5], 1.0)),
            FieldPattern::Crackle(crackle([1.0, 0.0, 0.0], 3.0)),
            FieldPattern::Radial(Radial {}),
        ];
        let bricks = Brick { size: DVec3::new(1.0, 0.5, 0.7), mortar: 0.1 };
        let cells = [CellPattern::Checker(Checker {}), CellPattern::Brick(bricks), CellPattern::Hexagon(Hexagon {})];
        fields.into_iter().map(PatternKind::Field).chain(cells.into_iter().map(PatternKind::Cells)).collect()
    }

    /// Each pattern, wave and some frequencies, in a transformed space: the bounds of a ball hold for all points in it.
    #[test]
    fn local_bounds_hold() {
        let waves =
            [Wave::Ramp, Wave::Triangle, Wave::Sine, Wave::Scallop, Wave::Cubic, Wave::Poly(2.5), Wave::Poly(0.5)];
        let (mut known, mut thrown) = (0, 0);
        for kind in kinds() {
            for wave in waves {
                for frequency in [None, Some(0.0), Some(0.7), Some(-1.3)] {
                    let modifiers = Modifiers { frequency, phase: 0.2, wave };
                    let mut space = Space::default();
                    space.append_transform(
                        &Transform::scale(DVec3::new(1.1, 0.6, 0.9))
                            .unwrap()
                            .then(&Transform::rotate(DVec3::new(30.0, 40.0, 50.0))),
                    );
                    let program =
                        PatternProgram::new(&Pattern { kind: kind.clone(), modifiers, space, ..Pattern::default() });
                    for _ in 0..30 {
                        let mut vector = || {
                            thrown += 1;
                            DVec3::from([0, 1, 2].map(|axis| rng::random_unit(&[7, thrown, axis]))) * 2.0 - 1.0
                        };
                        let (p, radius) = (vector() * 3.0, vector().x.abs() * 0.2);
                        let at = |p| TextureContext::without_surface(p, NoiseGenerator::RangeCorrected);
                        let near = program.value_bounds_near(&at(p), radius);
                        known += usize::from(near.steepest.is_finite());
                        let q = p + vector().normalize() * radius * vector().x.abs();
                        let (a, b) =
                            (program.number_and_entry_context(&at(p)).0, program.number_and_entry_context(&at(q)).0);
                        let flat = near.steepest.is_infinite() || (a - b).abs() <= near.steepest * p.distance(q) + 1e-9;
                        let holds = near.range.contains(a) && near.range.contains(b) && flat;
                        assert!(holds, "{kind:?} {modifiers:?} {p} {q} {radius}: {a} {b} {near:?}");
                    }
                }
            }
        }
        assert!(known > 5000, "{known}");
    }
}
