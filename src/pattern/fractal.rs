//! `mandel`, `julia` and `magnet`: orbits of points of the complex plane under an iterated formula (manual, "Fractal
//! Pattern").
//!
//! ```pov
//! plane { z, 0 pigment { mandel 50 interior 1, 1 color_map { [0 color rgb 0] [0.3 color rgb <1, 0.5, 0>] [1 color rgb 1] } scale 0.4 } }
//! ```

use super::{Field, GRAYS, SIX_COLORS, TextureContext};
use crate::color::Color;
use crate::diagnostic::{Diagnostic, Result, codes};
use crate::math::{Complex, DVec2};
use crate::value::words::{Row, set, specs, word};
use crate::value::{Next, Param, Readable, Reader, Spec, ValueKind, WordSpec};
use serde::Serialize;

/// Property of a fractal's orbit that becomes the pattern's number, and its factor.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct OrbitValue {
    /// Number after `exterior` or `interior` of a fractal pattern: 0 to 6 as in the manual; 7 and 8 are undocumented
    /// (quirk: fractal_types).
    pub kind: u8,
    /// Factor of a fractal pattern's number; most types multiply by it.
    pub factor: f64,
}

/// Parameters that all fractal patterns share.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Orbits {
    /// Maximum number of iterations of a fractal pattern.
    pub iterations: u32,
    /// Property for points of a fractal that escape, or that reach a fixed point.
    pub exterior: OrbitValue,
    /// Property for points of a fractal that never escape.
    pub interior: OrbitValue,
}

/// Result of a fractal's orbit.
enum End {
    /// Orbit that escapes: the step, and the position then.
    Left(u32, Complex),
    /// Orbit that does not escape: last position, and the least squared distance from 0.
    Stays(Complex, f64),
}

const EXTERIOR: WordSpec = word(
    "exterior",
    ValueKind::Block,
    "1, 1",
    "of points that leave: 0 the factor, 1 after how many of the iterations, 2 to 6 something of the last point times the factor, 7 and 8 \
     steps in turns",
);

const INTERIOR: WordSpec = word(
    "interior",
    ValueKind::Block,
    "0, 1",
    "of points that stay: 0 the factor, 1 the orbit's least distance, 2 to 6 something of the last point",
);

const EXPONENT: WordSpec = word("exponent", ValueKind::Float, "2", "to which power z goes, 2 to 33");

const ITERATIONS: Param =
    Param { name: "iterations", kind: ValueKind::Float, summary: "how often the formula is applied at most" };

const JULIA: Param =
    Param { name: "complex", kind: ValueKind::Vector2, summary: "the number that is the same for all points" };

impl OrbitValue {
    fn read(word: &str, max_kind: u8, r: &mut dyn Reader) -> Result<Self> {
        let (span, kind) = (r.span(), r.float()?);
        if !(0.0..f64::from(max_kind) + 1.0).contains(&kind) {
            let message = format!("`{word}` is one of 0 to {max_kind}, found {kind}");
            return Diagnostic::err(codes::BAD_ARGUMENT, span, message);
        }
        Ok(Self { kind: kind as u8, factor: r.float()? })
    }
}

impl Orbits {
    /// Reads the number of iterations; the values of points outside and inside get their defaults.
    fn read_iterations(r: &mut dyn Reader) -> Result<Self> {
        let iterations = r.float()? as u32;
        let (exterior, interior) = (OrbitValue { kind: 1, factor: 1.0 }, OrbitValue { kind: 0, factor: 1.0 });
        Ok(Self { iterations, exterior, interior })
    }

    /// Returns the pattern's number for an orbit that begins at `z` and continues by `step` until `has_left` is true.
    /// `includes_start` is true if `z` belongs to the orbit. An orbit that has left must stay outside for `BLOCK` steps.
    fn orbit_pattern_value<const BLOCK: u32>(
        &self,
        z: Complex,
        step: impl Fn(Complex) -> Complex,
        has_left: impl Fn(Complex) -> bool,
        includes_start: bool,
    ) -> f64 {
        // Only interior type 1 needs the least distance from 0: loops without it are faster.
        let end = match self.interior.kind {
            1 => self.follow_orbit::<BLOCK, true>(z, step, has_left, includes_start),
            _ => self.follow_orbit::<BLOCK, false>(z, step, has_left, includes_start),
        };
        match end {
            End::Left(i, z) => {
                let OrbitValue { kind, factor } = self.exterior;
                match kind {
                    1 => f64::from(i) / f64::from(self.iterations),
                    6 => z.length_squared().sqrt() * factor,
                    7 => Self::wrapped_count_over_factor(i, factor.trunc(), factor),
                    8 => Self::wrapped_count_over_factor(i, factor.trunc() + 1.0, factor),
                    _ => Self::last_position_value(kind, z) * factor,
                }
            }
            End::Stays(z, least) => {
                let OrbitValue { kind, factor } = self.interior;
                match kind {
                    1 => least.sqrt() * factor,
                    // The manual says the length; POV-Ray squares the imaginary part alone (quirk: fractal_types).
                    6 => z.x * z.x + z.y * z.y * factor,
                    _ => Self::last_position_value(kind, z) * factor,
                }
            }
        }
    }

    #[inline(always)]
    fn follow_orbit<const BLOCK: u32, const LEAST: bool>(
        &self,
        z: Complex,
        step: impl Fn(Complex) -> Complex,
        has_left: impl Fn(Complex) -> bool,
        includes_start: bool,
    ) -> End {
        let (mut z, mut least) = (z, if includes_start { z.length_squared() } else { f64::INFINITY });
        let next = |z: &mut Complex, least: &mut f64| {
            *z = step(*z);
            if LEAST {
                *least = least.min(z.length_squared());
            }
        };
        // An orbit that returns to an earlier position is periodic: compare with one position, which is replaced ever
        // more rarely (R. P. Brent, "An improved Monte Carlo factorization algorithm", 1980, section 2).
        let (mut been, mut since, mut change) = (Complex::new(f64::NAN, f64::NAN), 0, BLOCK);
        let mut i = 0;
        while i < self.iterations {
            // Iterate some steps without tests; if the orbit has left meanwhile, repeat them one by one.
            let (mut ahead, mut ahead_least) = (z, least);
            let blind = self.iterations - i >= BLOCK;
            if blind {
                (0..BLOCK).for_each(|_| next(&mut ahead, &mut ahead_least));
            }
            if blind && !(ahead.x + ahead.y).is_nan() && !has_left(ahead) {
                (z, least) = (ahead, ahead_least);
                i += BLOCK;
            } else {
                for _ in 0..BLOCK.min(self.iterations - i) {
                    next(&mut z, &mut least);
                    if has_left(z) {
                        return End::Left(i, z);
                    }
                    i += 1;
                }
            }
            if z == been {
                let round = i - since;
                (0..(self.iterations - i) % round).for_each(|_| next(&mut z, &mut least));
                break;
            }
            if i >= change {
                (been, since, change) = (z, i, 2 * i);
            }
        }
        End::Stays(z, least)
    }

    /// Returns the pattern's number for the orbit z → zⁿ + c.
    fn power_orbit_value(&self, n: u32, z: Complex, c: Complex) -> f64 {
        match n {
            2 if !has_escaped(c) => self.orbit_pattern_value::<8>(z, |z| z.square() + c, has_escaped, true),
            2 => self.orbit_pattern_value::<1>(z, |z| z.square() + c, has_escaped, true),
            n => self.orbit_pattern_value::<1>(z, |z| z.power(n) + c, has_escaped, true),
        }
    }

    /// Returns `i` modulo `period`, divided by the factor (quirk: `fractal_types`); 0 for a `period` of 0, where POV-Ray
    /// crashes.
    fn wrapped_count_over_factor(i: u32, period: f64, factor: f64) -> f64 {
        if period == 0.0 { 0.0 } else { f64::from(i) % period / factor }
    }

    /// Returns a number of an orbit's last position `z`, for the types that exterior and interior share.
    fn last_position_value(kind: u8, z: Complex) -> f64 {
        match kind {
            2 => z.x,
            3 => z.y,
            4 => z.x * z.x,
            5 => z.y * z.y,
            _ => 1.0,
        }
    }
}

/// True if z has escaped: |z| then grows for ever if |c| ≤ 2.
fn has_escaped(z: Complex) -> bool {
    z.length_squared() > 4.0
}

fn read_exponent(r: &mut dyn Reader) -> Result<u32> {
    // quirk: fractal_exponents
    let exponent = r.float()?.trunc();
    Ok(if (2.0..=33.0).contains(&exponent) { exponent as u32 } else { 2 })
}

/// Pattern `mandel`: z → zⁿ + c, where c is the point.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Mandel {
    /// Iterations, exterior and interior of the pattern `mandel`.
    pub orbits: Orbits,
    /// Exponent n of the iteration in the pattern `mandel`.
    pub exponent: u32,
}

impl Readable for Mandel {
    const SPEC: Spec = Spec {
        name: "mandel",
        summary: "the Mandelbrot set in the xy plane",
        params: &[ITERATIONS],
        words: specs!(Self::WORDS),
        ..Spec::EMPTY
    };

    const WORDS: &'static [Row<Self>] = &[
        EXPONENT.sets(|s, r| set(&mut s.exponent, read_exponent(r))),
        EXTERIOR.sets(|s, r| set(&mut s.orbits.exterior, OrbitValue::read("exterior", 8, r))),
        INTERIOR.sets(|s, r| set(&mut s.orbits.interior, OrbitValue::read("interior", 6, r))),
    ];

    fn read(r: &mut dyn Reader) -> Result<Self> {
        Ok(Self { orbits: Orbits::read_iterations(r)?, exponent: 2 })
    }
}

/// True if the orbit of z² + c certainly never escapes: in the cardioid, where orbits converge to a point, and in the
/// disc to its left, where they converge to a cycle of two (B. B. Mandelbrot, "Fractal aspects of the iteration of z →
/// Λz(1-z)", 1980). Most of the set is there.
fn is_in_main_cardioid_or_disc(c: Complex) -> bool {
    // Points at the very border, where orbits take longest, are iterated.
    const LEAST: f64 = 1e-9;
    let (x, y2) = (c.x - 0.25, c.y * c.y);
    let q = x * x + y2;
    q * (q + x) < 0.25 * y2 - LEAST || (c.x + 1.0) * (c.x + 1.0) + y2 < 0.0625 - LEAST
}

impl Field for Mandel {
    fn value(&self, at: &TextureContext) -> f64 {
        let c = Complex::new(at.p.x, at.p.y);
        let OrbitValue { kind, factor } = self.orbits.interior;
        if kind == 0 && self.exponent == 2 && is_in_main_cardioid_or_disc(c) {
            return Orbits::last_position_value(kind, c) * factor;
        }
        self.orbits.power_orbit_value(self.exponent, c, c)
    }

    /// Returns the colours of `mandel` without a map; exponents other than 2 have gray defaults (quirk:
    /// `fractal_exponents`).
    fn default_colors(&self) -> Vec<(f64, Color)> {
        if self.exponent != 2 {
            return GRAYS.to_vec();
        }
        let [.., yellow, cyan, magenta] = SIX_COLORS.map(Color::opaque);
        [(0.001, Color::BLACK), (0.001, cyan), (0.012, yellow), (0.015, magenta), (0.1, cyan)].to_vec()
    }
}

/// Pattern `julia`: z → zⁿ + c, where z begins at the point.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Julia {
    /// The number c = x + iy of the pattern `julia`.
    pub constant: DVec2,
    /// Iterations, exterior and interior of the pattern `julia`.
    pub orbits: Orbits,
    /// Exponent n of the iteration in the pattern `julia`.
    pub exponent: u32,
}

impl Readable for Julia {
    const SPEC: Spec = Spec {
        name: "julia",
        summary: "a Julia set in the xy plane",
        params: &[JULIA, ITERATIONS],
        words: specs!(Self::WORDS),
        ..Spec::EMPTY
    };

    const WORDS: &'static [Row<Self>] = &[
        EXPONENT.sets(|s, r| set(&mut s.exponent, read_exponent(r))),
        EXTERIOR.sets(|s, r| set(&mut s.orbits.exterior, OrbitValue::read("exterior", 8, r))),
        INTERIOR.sets(|s, r| set(&mut s.orbits.interior, OrbitValue::read("interior", 6, r))),
    ];

    fn read(r: &mut dyn Reader) -> Result<Self> {
        Ok(Self { constant: r.vector2()?, orbits: Orbits::read_iterations(r)?, exponent: 2 })
    }
}

impl Field for Julia {
    fn value(&self, at: &TextureContext) -> f64 {
        let c = Complex::new(self.constant.x, self.constant.y);
        self.orbits.power_orbit_value(self.exponent, Complex::new(at.p.x, at.p.y), c)
    }
}

/// Pattern `magnet`: one of the two formulas of magnetic renormalisation (H.-O. Peitgen and P. H. Richter, "The Beauty
/// of Fractals", 1986).
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Magnet {
    /// True for the second formula of the pattern `magnet`.
    pub second: bool,
    /// For `magnet … julia`, the number c = x + iy for all points; `None` if c is the point.
    pub constant: Option<DVec2>,
    /// Iterations, exterior and interior of the pattern `magnet`.
    pub orbits: Orbits,
}

impl Readable for Magnet {
    const SPEC: Spec = Spec {
        name: "magnet",
        summary: "`magnet 1 mandel`, `magnet 2 julia` …: sets of magnetic phases in the xy plane",
        params: &[
            Param { name: "type", kind: ValueKind::Float, summary: "1 or 2" },
            Param {
                name: "mandel or julia",
                kind: ValueKind::Nothing,
                summary: "is the point the formula's number or its start?",
            },
            Param {
                name: "complex",
                kind: ValueKind::Vector2,
                summary: "after `julia`: the number that is the same for all points",
            },
            ITERATIONS,
        ],
        words: specs!(Self::WORDS),
        ..Spec::EMPTY
    };

    const WORDS: &'static [Row<Self>] = &[
        EXTERIOR.sets(|s, r| set(&mut s.orbits.exterior, OrbitValue::read("exterior", 8, r))),
        INTERIOR.sets(|s, r| set(&mut s.orbits.interior, OrbitValue::read("interior", 6, r))),
    ];

    fn read(r: &mut dyn Reader) -> Result<Self> {
        let (span, kind) = (r.span(), r.float()?.trunc());
        if kind != 1.0 && kind != 2.0 {
            return Diagnostic::err(
                codes::BAD_ARGUMENT,
                span,
                format!("there are magnets 1 and 2, but none with number {kind}"),
            );
        }
        let constant = match r.peek_next()? {
            Next::Word("mandel") => r.take_token().map(|_| None)?,
            Next::Word("julia") => {
                r.take_token()?;
                Some(r.vector2()?)
            }
            _ => return Err(r.unexpected("`mandel` or `julia`").into()),
        };
        Ok(Self { second: kind == 2.0, constant, orbits: Orbits::read_iterations(r)? })
    }
}

impl Field for Magnet {
    fn value(&self, at: &TextureContext) -> f64 {
        let point = Complex::new(at.p.x, at.p.y);
        let (start, c) = match self.constant {
            Some(c) => (point, Complex::new(c.x, c.y)),
            None => (Complex::new(0.0, 0.0), point),
        };
        // escaped, or converged to the fixed point 1
        let left = |z: Complex| z.length_squared() > 10_000.0 || (z + -1.0).length_squared() < 1e-4;
        let (c1, c2) = (c + -1.0, c + -2.0);
        let includes_start = self.constant.is_some();
        if self.second {
            let product = c1 * c2;
            let step = |z: Complex| {
                let above = z * z.square() + 3.0 * (c1 * z) + product;
                let below = 3.0 * z.square() + 3.0 * (c2 * z) + product + 1.0;
                (above / below).square()
            };
            self.orbits.orbit_pattern_value::<1>(start, step, left, includes_start)
        } else {
            self.orbits.orbit_pattern_value::<1>(
                start,
                |z| ((z.square() + c1) / (2.0 * z + c2)).square(),
                left,
                includes_start,
            )
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::DVec3;

    fn orbits(exterior: u8, interior: u8) -> Orbits {
        let shown = |kind| OrbitValue { kind, factor: 0.5 };
        Orbits { iterations: 10, exterior: shown(exterior), interior: shown(interior) }
    }

    fn mandel(x: f64, y: f64, exterior: u8, interior: u8) -> f64 {
        let pattern = Mandel { orbits: orbits(exterior, interior), exponent: 2 };
        pattern.value(&TextureContext::without_surface(DVec3::new(x, y, 3.0), Default::default()))
    }

    #[test]
    fn orbits_escape_or_stay() {
        assert_eq!(mandel(3.0, 0.0, 1, 0), 0.0);
        // 1, 2, 5: escapes in the second iteration
        assert_eq!(mandel(1.0, 0.0, 1, 0), 0.1);
        assert_eq!(mandel(1.0, 0.0, 2, 0), 2.5);
        assert_eq!(mandel(0.0, 0.0, 1, 0), 0.5);
        // -1, 0, -1, 0 …
        assert_eq!(mandel(-1.0, 0.0, 1, 1), 0.0);
        assert_eq!(mandel(-1.0, 0.0, 1, 2), -0.5);
    }

    #[test]
    fn main_bodies_contain_no_escaping_orbit() {
        let (mut within, mut stays) = (0, 0);
        for i in 0..40_000 {
            let c = Complex::new(f64::from(i % 200) * 0.0131 - 2.05, f64::from(i / 200) * 0.0117 - 1.17);
            let orbit = Orbits { iterations: 500, ..orbits(1, 0) }.power_orbit_value(2, c, c) == 0.5;
            within += u32::from(is_in_main_cardioid_or_disc(c));
            stays += u32::from(orbit);
            assert!(orbit || !is_in_main_cardioid_or_disc(c), "{} {}", c.x, c.y);
        }
        // The areas are 3π/8 and π/16, of 1.507 for the whole set.
        let share = f64::from(within) / f64::from(stays);
        assert!((share - 0.912).abs() < 0.01, "{share}");
    }
}
