//! `mandel`, `julia` and `magnet`: orbits of points of the complex plane under an iterated formula (manual, "Fractal
//! Pattern").
//!
//! ```pov
//! plane { z, 0 pigment { mandel 50 interior 1, 1 color_map { [0 color rgb 0] [0.3 color rgb <1, 0.5, 0>] [1 color rgb 1] } scale 0.4 } }
//! ```

mod orbits;

use super::{Field, FieldParams, GRAYS, SIX_COLORS, TextureContext};
use crate::color::Color;
use crate::diagnostic::{Diagnostic, Result, codes};
use crate::math::{Complex, DVec2};
use crate::value::words::{Row, set, specs, word};
use crate::value::{Next, Param, Readable, Reader, Spec, ValueKind, WordSpec};
use orbits::{ESCAPE, End, FirstMagnet, Formula, Power, SecondMagnet, Square, follow_orbits};
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

    /// Returns the pattern's numbers for orbits that begin at `z` and follow a formula until they leave. `includes_start`
    /// is true if `z` belongs to the orbit. An orbit that has left must stay outside for `BLOCK` steps.
    #[inline(always)]
    fn orbit_pattern_values<const BLOCK: u32, const N: usize>(
        &self,
        z: [Complex; N],
        formula: impl Formula<N>,
        includes_start: bool,
    ) -> [f64; N] {
        // Only interior type 1 needs the least distance from 0: loops without it are faster.
        let ends = match self.interior.kind {
            1 => follow_orbits::<BLOCK, true, N>(z, &formula, self.iterations, includes_start),
            _ => follow_orbits::<BLOCK, false, N>(z, &formula, self.iterations, includes_start),
        };
        ends.map(|end| self.value_at_end(end))
    }

    /// Returns the pattern's number for an orbit with this end.
    fn value_at_end(&self, end: End) -> f64 {
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

    /// Returns the pattern's numbers for N orbits z → zⁿ + c.
    #[inline(always)]
    fn power_orbit_values<const N: usize>(&self, n: u32, z: [Complex; N], c: [Complex; N]) -> [f64; N] {
        // (With a large c, an orbit may come back.)
        let may_return = c.iter().any(|c| c.length_squared() > ESCAPE);
        let c = Complex::side_by_side(c);
        match n {
            2 if !may_return => self.orbit_pattern_values::<8, N>(z, Square { c }, true),
            2 => self.orbit_pattern_values::<1, N>(z, Square { c }, true),
            n => self.orbit_pattern_values::<1, N>(z, Power { n, c }, true),
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

/// Returns the point x + iy of the complex plane at which a texture is evaluated.
fn complex_point(at: &TextureContext) -> Complex {
    Complex::new(at.p.x, at.p.y)
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

impl Mandel {
    /// Returns the pattern's numbers at N points.
    #[inline(always)]
    fn values_at<const N: usize>(&self, points: [Complex; N]) -> [f64; N] {
        self.orbits.power_orbit_values(self.exponent, points, points)
    }

    /// True if the pattern's number at a point is known without its orbit.
    fn is_known(&self, c: Complex) -> bool {
        self.orbits.interior.kind == 0 && self.exponent == 2 && is_in_main_cardioid_or_disc(c)
    }
}

impl Field for Mandel {
    fn value(&self, at: &TextureContext) -> f64 {
        let c = complex_point(at);
        if self.is_known(c) {
            let OrbitValue { kind, factor } = self.orbits.interior;
            return Orbits::last_position_value(kind, c) * factor;
        }
        let [value] = self.values_at([c]);
        value
    }

    fn takes_long_chain(&self) -> bool {
        true
    }

    fn values_with_params(&self, at: &[TextureContext; 4], _: &FieldParams) -> [f64; 4] {
        let points = at.each_ref().map(complex_point);
        if points.iter().any(|c| self.is_known(*c)) {
            return at.each_ref().map(|at| self.value(at));
        }
        self.values_at(points)
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

impl Julia {
    /// Returns the pattern's numbers at N points.
    #[inline(always)]
    fn values_at<const N: usize>(&self, points: [Complex; N]) -> [f64; N] {
        let c = Complex::new(self.constant.x, self.constant.y);
        self.orbits.power_orbit_values(self.exponent, points, [c; N])
    }
}

impl Field for Julia {
    fn value(&self, at: &TextureContext) -> f64 {
        self.values_at([complex_point(at)])[0]
    }

    fn takes_long_chain(&self) -> bool {
        true
    }

    fn values_with_params(&self, at: &[TextureContext; 4], _: &FieldParams) -> [f64; 4] {
        self.values_at(at.each_ref().map(complex_point))
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

impl Magnet {
    /// Returns the pattern's numbers at N points.
    #[inline(always)]
    fn values_at<const N: usize>(&self, points: [Complex; N]) -> [f64; N] {
        let (start, c) = match self.constant {
            Some(c) => (points, [Complex::new(c.x, c.y); N]),
            None => ([Complex::new(0.0, 0.0); N], points),
        };
        let (c, includes_start) = (Complex::side_by_side(c), self.constant.is_some());
        if self.second {
            self.orbits.orbit_pattern_values::<1, N>(start, SecondMagnet { c }, includes_start)
        } else {
            self.orbits.orbit_pattern_values::<1, N>(start, FirstMagnet { c }, includes_start)
        }
    }
}

impl Field for Magnet {
    fn value(&self, at: &TextureContext) -> f64 {
        self.values_at([complex_point(at)])[0]
    }

    fn takes_long_chain(&self) -> bool {
        true
    }

    fn values_with_params(&self, at: &[TextureContext; 4], _: &FieldParams) -> [f64; 4] {
        self.values_at(at.each_ref().map(complex_point))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::DVec3;
    use crate::pattern::FieldPattern;

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
            let orbit = Orbits { iterations: 500, ..orbits(1, 0) }.power_orbit_values(2, [c], [c]) == [0.5];
            within += u32::from(is_in_main_cardioid_or_disc(c));
            stays += u32::from(orbit);
            assert!(orbit || !is_in_main_cardioid_or_disc(c), "{} {}", c.x, c.y);
        }
        // The areas are 3π/8 and π/16, of 1.507 for the whole set.
        let share = f64::from(within) / f64::from(stays);
        assert!((share - 0.912).abs() < 0.01, "{share}");
    }

    #[test]
    fn four_points_have_the_bits_of_single_points() {
        let constant = Some(DVec2::new(0.31, 0.44));
        for (kind, iterations) in [(0, 10), (1, 57), (2, 200), (5, 1), (6, 33)] {
            let orbits = Orbits { iterations, ..orbits(if kind == 0 { 1 } else { kind }, kind) };
            let mut fields: Vec<FieldPattern> = vec![];
            for exponent in [2, 3, 7] {
                fields.push(Mandel { orbits, exponent }.into());
                fields.push(Julia { orbits, exponent, constant: DVec2::new(-0.4, 0.6) }.into());
                fields.push(Julia { orbits, exponent, constant: DVec2::new(-2.4, 0.6) }.into());
            }
            for second in [false, true] {
                fields.push(Magnet { second, constant, orbits }.into());
                fields.push(Magnet { second, constant: None, orbits }.into());
            }
            for field in fields {
                for i in 0..400 {
                    let p = DVec3::new(f64::from(i % 20) * 0.27 - 2.9, f64::from(i / 20) * 0.24 - 2.6, 0.0);
                    let spread = if i % 3 == 0 { 0.5 } else { 1e-3 };
                    let corners = [DVec3::X, DVec3::Y, -DVec3::Y, DVec3::ZERO].map(|d| p + spread * d);
                    let at = corners.map(|p| TextureContext::without_surface(p, Default::default()));
                    let single = at.each_ref().map(|at| field.value(at).to_bits());
                    let four = field.values_with_params(&at, &FieldParams::NONE).map(f64::to_bits);
                    assert_eq!(four, single, "{field:?} at {p}");
                }
            }
        }
    }
}
