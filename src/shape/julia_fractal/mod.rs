//! `julia_fractal { <c> function max_iteration precision slice … }`: points of four dimensions that stay near the origin however often h
//! becomes f(h) + c (manual, "Julia Fractal").
//!
//! Seen is a slice of three dimensions. Rays walk as Hart, Sandin and Kauffman do (Ray tracing deterministic 3-D fractals, 1989): from
//! each place as far as no point of the surface can be. How far that is follows from how far the rounds can carry two neighbours apart, which
//! is proved for h² and h³. Where nothing is known steps are 1/`precision` long, as in POV-Ray 3.7: thinner pieces may be missed, and mostly
//! those that POV-Ray misses.
//!
//! ```pov
//! julia_fractal {
//!   <-0.083, 0, -0.83, -0.025> quaternion sqr max_iteration 8 precision 100
//!   translate y pigment { color rgb <0.4, 0.7, 0.6> }
//! }
//! ```

mod function;
mod orbit;

pub use function::Function;

use super::{Bounding, Hit, Hits, Kernel, Quirks, check_finite, transformed_box};
use crate::diagnostic::{Diagnostic, Result, codes};
use crate::math::{Aabb, DVec3, Range, Ray, Transform, root_between};
use crate::source::Span;
use crate::value::words::{Row, read_row, set, specs_of, word};
use crate::value::{Next, Param, Readable, Reader, Spec, Value, ValueKind, WordSpec};
use function::{FUNCTIONS, WORDS};
use orbit::{Four, Rule, Trail, mean_of_squared_lengths};
use serde::Serialize;

/// Maximum number of iterations of a Julia fractal; points inside take all of them.
const MOST_ROUNDS: usize = 1000;
/// Maximum precision of a Julia fractal: the number of steps in a unit.
const MOST_PRECISE: f64 = 1000.0;
/// Step of a ray beyond the proven distance to a Julia fractal, as a share of that distance: the next distance is
/// usually similar.
const AHEAD: f64 = 0.6;

/// Algebra of a Julia fractal's four-dimensional numbers.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Algebra {
    /// Hamilton's quaternions, whose product depends on the order of the factors.
    Quaternion,
    /// Hypercomplex numbers: pairs of complex numbers.
    Hypercomplex,
}

/// Julia fractal: a three-dimensional slice of a four-dimensional set.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct JuliaFractal {
    /// Constant that is added in each iteration of a Julia fractal.
    pub parameter: Four,
    /// Algebra of the Julia fractal's numbers.
    pub algebra: Algebra,
    /// Function that a Julia fractal applies in each iteration.
    pub function: Function,
    /// Number of points of a Julia fractal's orbit that must be near the origin, the first included.
    pub max_iteration: usize,
    /// Steps of a ray in a unit of length where distances to the Julia fractal are not proven.
    pub precision: f64,
    /// Normal of the Julia fractal's slice in four dimensions, length 1.
    pub slice: Four,
    /// Distance of the Julia fractal's slice from the origin.
    pub distance: f64,
}

/// Function that receives an interval in which a ray crosses a Julia fractal, and a function that refines it; returns
/// true to stop.
type StopsAt<'a> = &'a mut dyn FnMut([f64; 2], &dyn Fn() -> f64) -> bool;

impl JuliaFractal {
    /// Creates the Julia fractal of h² + c in quaternions.
    pub fn new(parameter: Four) -> Self {
        Self {
            parameter,
            algebra: Algebra::Quaternion,
            function: Function::Sqr,
            max_iteration: 20,
            precision: 20.0,
            slice: [0.0, 0.0, 0.0, 1.0],
            distance: 0.0,
        }
    }

    fn iteration_rule(&self) -> Rule {
        match (self.algebra, self.function) {
            (Algebra::Quaternion, Function::Cube) => Rule::Cube,
            (Algebra::Quaternion, _) => Rule::Square,
            // quirk: hypercomplex_cube
            (Algebra::Hypercomplex, Function::Cube) => Rule::Pair(Function::Sqr),
            (Algebra::Hypercomplex, function) => Rule::Pair(function),
        }
    }

    /// Radius beyond which a Julia fractal's orbit has escaped: 1 + |c| for quaternions, 4 for others (quirk:
    /// `julia_escape_radius`).
    fn escape_radius(&self) -> f64 {
        match self.algebra {
            Algebra::Quaternion => 1.0 + self.parameter.iter().map(|x| x * x).sum::<f64>().sqrt(),
            Algebra::Hypercomplex => 4.0,
        }
    }

    /// Radius of a ball that contains the Julia fractal, in four dimensions.
    fn bounding_radius(&self) -> f64 {
        let radius = self.escape_radius();
        let ball = self.iteration_rule().bounding_radius(self.parameter, radius, self.iteration_count());
        // Slightly more, since the whole ball is inside if c is 0. A surface at the escape radius itself does not count
        // for pairs.
        let largest = radius * if self.algebra == Algebra::Quaternion { 1.0 + 1e-6 } else { 1.0 - 1e-6 };
        (ball * (1.0 + 1e-6)).min(largest)
    }

    /// Number of iterations during which a point's orbit must stay within the escape radius for the point to be inside
    /// a Julia fractal.
    fn iteration_count(&self) -> usize {
        self.max_iteration.saturating_sub(1).min(MOST_ROUNDS)
    }

    /// Maps a point of three dimensions to the four-dimensional slice of a Julia fractal.
    fn point_in_slice(&self, p: DVec3) -> Four {
        let [x, y, z, w] = self.slice;
        [p.x, p.y, p.z, (self.distance - x * p.x - y * p.y - z * p.z) / w]
    }

    /// Returns the start of a point's orbit in a Julia fractal, and the constant.
    fn orbit_start_and_constant(&self, p: DVec3) -> [Four; 2] {
        [self.point_in_slice(p), self.parameter]
    }

    /// Returns true if the point is inside the Julia fractal, and a radius around it within which all points share
    /// that.
    fn is_inside_with_clearance(&self, p: DVec3, escape_radius: f64, trail: &mut Trail) -> (bool, f64) {
        let (inside, clearance) = self.iteration_rule().stays_with_clearance(
            self.orbit_start_and_constant(p),
            escape_radius,
            self.iteration_count(),
            trail,
        );
        // (In a steep slice, points are farther apart than their projections.)
        (inside, clearance * self.slice[3].abs())
    }

    /// Returns a value below 0 inside the Julia fractal, and at most 1; `squared_escape_radius` is the squared escape
    /// radius.
    fn escape_value_negative_inside(&self, p: DVec3, squared_escape_radius: f64) -> f64 {
        1.0 - squared_escape_radius
            / self.iteration_rule().max_squared_length(self.orbit_start_and_constant(p), self.iteration_count())
    }

    fn contains(&self, p: DVec3) -> bool {
        let exit = self.escape_radius() * self.escape_radius();
        let mut stays = true;
        self.iteration_rule().iterate_orbit(self.orbit_start_and_constant(p), self.iteration_count(), |squares| {
            stays = mean_of_squared_lengths(squares) <= exit;
            stays
        });
        stays
    }

    /// Returns the interval of a line within the ball around a Julia fractal; positions are distances from the line's
    /// point nearest to the origin.
    fn interval_in_ball(&self, nearest_to_origin: DVec3, from: f64, to: f64) -> Option<(f64, f64)> {
        let ball = self.bounding_radius();
        let half = (ball * ball - nearest_to_origin.length_squared()).sqrt();
        // (The square root of a negative number is excluded.)
        let (from, to) = (from.max(-half), to.min(half));
        (half > 0.0 && half.is_finite() && from < to).then_some((from, to))
    }

    /// Calls `stops_at` with each interval in which a ray crosses a Julia fractal's surface, ascending, until it
    /// returns true.
    fn search_crossing_intervals(&self, ray: &Ray, range: Range, stops_at: StopsAt) {
        if self.iteration_count() == 0 {
            return;
        }
        let length = ray.dir.length();
        let v = ray.dir / length;
        let middle = -ray.origin.dot(v);
        let o = ray.origin + middle * v;
        let Some((from, to)) = self.interval_in_ball(o, range.min * length - middle, range.max * length - middle)
        else {
            return;
        };
        let (radius, mut trail) = (self.escape_radius(), Trail::new());
        let at = |s: f64| o + v * s;
        let t = |s: f64| (s + middle) / length;
        // (Limit the number of steps in a huge ball.)
        let shortest = (1.0 / self.precision).max(2e-5 * radius);
        let (mut s, (mut inside, mut alike)) = (from, self.is_inside_with_clearance(at(from), radius, &mut trail));
        while s < to {
            let mut next = (s + alike + shortest.max(AHEAD * alike)).min(to);
            let mut there = self.is_inside_with_clearance(at(next), radius, &mut trail);
            // Both points decide for all between them, except for a short piece.
            while next - s - alike - there.1 > 1.001 * shortest {
                next = (0.5 * (s + alike + next - there.1)).max(s + alike + shortest);
                there = self.is_inside_with_clearance(at(next), radius, &mut trail);
            }
            if there.0 != inside {
                let value = |s: f64| self.escape_value_negative_inside(at(s), radius * radius);
                let root = || t(root_between(&value, (s, value(s)), (next, value(next)), 1e-11 * (1.0 + s.abs())));
                if stops_at([t(s), t(next)], &root) {
                    return;
                }
            }
            (s, (inside, alike)) = (next, there);
        }
    }

    /// Returns the iteration after which |h| is largest in a point's orbit, among the iterations that count.
    fn iteration_of_max_length(&self, p: DVec3) -> usize {
        let (mut k, mut last, mut most) = (0, 0, f64::NEG_INFINITY);
        self.iteration_rule().iterate_orbit(self.orbit_start_and_constant(p), self.iteration_count(), |squares| {
            // (NaN counts as larger.)
            if mean_of_squared_lengths(squares).total_cmp(&most).is_ge() {
                (last, most) = (k, mean_of_squared_lengths(squares));
            }
            k += 1;
            squares.iter().all(|x| x.is_finite())
        });
        last
    }

    /// Returns a vector along the gradient of |h|² after some iterations of a Julia fractal; its length has no meaning.
    /// Its fourth component is ignored, even if the slice makes it depend on the others (quirk: `julia_normal`).
    fn gradient_of_squared_length(&self, p: DVec3, rounds: usize) -> DVec3 {
        let rule = self.iteration_rule();
        let mut h = self.point_in_slice(p);
        let mut tangents = [[1.0, 0.0, 0.0, 0.0], [0.0, 1.0, 0.0, 0.0], [0.0, 0.0, 1.0, 0.0]];
        for _ in 0..rounds {
            (h, tangents) = rule.next_point_and_tangents(h, self.parameter, tangents);
            // (Only the direction matters.)
            let size = tangents.iter().flatten().fold(0.0_f64, |size, x| size.max(x.abs()));
            tangents = tangents.map(|turn| turn.map(|x| x / size));
        }
        tangents.map(|turn| turn.iter().zip(h).map(|(a, b)| a * b).sum()).into()
    }
}

impl Readable for JuliaFractal {
    const SPEC: Spec = Spec {
        name: "julia_fractal",
        summary: "a slice of a fractal of four dimensions",
        params: &[Param {
            name: "<c>",
            kind: ValueKind::Vectors,
            summary: "four numbers: what is added in each round",
        }],
        words: &{
            let own: [WordSpec; 5] = specs_of(Self::WORDS);
            let mut words = [own[0]; 23];
            let mut i = 0;
            while i < 23 {
                words[i] = if i < 5 { own[i] } else { FUNCTIONS[i - 5] };
                i += 1;
            }
            words
        },
        ..Spec::EMPTY
    };

    const WORDS: &'static [Row<Self>] = &[
        word(
            "quaternion",
            ValueKind::Nothing,
            "",
            "calculates with quaternions, of which only `sqr` and `cube` are known; so it is without it",
        )
        .sets(|j, _| set(&mut j.algebra, Ok(Algebra::Quaternion))),
        word("hypercomplex", ValueKind::Nothing, "", "calculates with pairs of complex numbers")
            .sets(|j, _| set(&mut j.algebra, Ok(Algebra::Hypercomplex))),
        word("max_iteration", ValueKind::Float, "20", "how many points of a row must stay near").sets(|j, r| {
            // (The cast saturates at 0 and at the largest number.)
            set(&mut j.max_iteration, r.float().map(|n| n as usize))
        }),
        word("precision", ValueKind::Float, "20", "more finds smaller things and takes longer")
            .sets(|j, r| set(&mut j.precision, r.float().map(|n| n.clamp(1.0, MOST_PRECISE)))),
        word(
            "slice",
            ValueKind::Vectors,
            "<0, 0, 0, 1>, 0",
            "a direction in four dimensions, and how far from the origin it is cut across that",
        )
        .sets(Self::read_slice),
    ];

    fn read(r: &mut dyn Reader) -> Result<Self> {
        Ok(Self::new(read_four(r)?))
    }

    fn read_own(&mut self, next: Next, r: &mut dyn Reader) -> Result<bool> {
        let Next::Word(name) = next else { return Ok(false) };
        if name == "pwr" {
            let span = r.take_token()?;
            let power = r.numbers_in_parentheses(2)?;
            check_finite(span, &[], &power)?;
            self.function = Function::Pwr(power[0], power[1]);
            return Ok(true);
        }
        match WORDS.iter().find(|(word, _)| *word == name) {
            Some((_, function)) => {
                r.take_token()?;
                self.function = *function;
                Ok(true)
            }
            None => read_row(Self::WORDS, self, next, r),
        }
    }

    fn complete_and_check(&mut self, span: Span, r: &mut dyn Reader) -> Result<()> {
        if self.algebra == Algebra::Quaternion && !matches!(self.function, Function::Sqr | Function::Cube) {
            let message = "quaternions know only `sqr` and `cube`";
            let help = "write `hypercomplex` before the function";
            return Err(Diagnostic::new(codes::BAD_ARGUMENT, span, message).help(help).into());
        }
        if self.iteration_count() == 0 {
            let message = "a `julia_fractal` with `max_iteration` less than 2 has no surface";
            r.report(Diagnostic::new(codes::NO_SURFACE, span, message));
        }
        Ok(())
    }
}

/// Reads a four-dimensional number of a Julia fractal; a single number is used for all components, and missing ones are
/// 0.
fn read_four(r: &mut dyn Reader) -> Result<Four> {
    let (value, span) = r.value()?;
    let four = match value {
        Value::Float(x) => [x; 4],
        Value::Vector(v) if v.len <= 4 => std::array::from_fn(|i| if i < usize::from(v.len) { v.c[i] } else { 0.0 }),
        other => {
            let message = format!("expected a vector of four numbers, found {}", other.describe());
            return Diagnostic::err(codes::WRONG_TYPE, span, message);
        }
    };
    check_finite(span, &[], &four)?;
    Ok(four)
}

impl JuliaFractal {
    fn read_slice(&mut self, r: &mut dyn Reader) -> Result<()> {
        let span = r.span();
        let (slice, distance) = (read_four(r)?, r.float()?);
        check_finite(span, &[], &[distance])?;
        let length = slice.iter().map(|x| x * x).sum::<f64>().sqrt();
        let unit = slice.map(|x| x / length);
        if unit[3].is_nan() || unit[3].abs() <= 1e-9 {
            let message = "the fourth number of this `slice` is 0: such a slice can't be laid into space";
            return Diagnostic::err(codes::BAD_ARGUMENT, span, message);
        }
        (self.slice, self.distance) = (unit, distance);
        Ok(())
    }
}

impl Kernel for JuliaFractal {
    const QUIRKS: Quirks = Quirks { bounding: Bounding::Ignored, ..Quirks::NONE };

    fn bounds(&self) -> Aabb {
        if self.iteration_count() == 0 {
            Aabb::EMPTY
        } else {
            Aabb::from_corners(DVec3::ZERO, DVec3::ZERO).grown(self.bounding_radius() * (1.0 + 2e-6))
        }
    }

    fn pov_bounds(&self, m: &Transform) -> Aabb {
        transformed_box(m, &Aabb::from_corners(DVec3::ZERO, DVec3::ZERO).grown(self.escape_radius()))
    }

    fn hits(&self, ray: &Ray, range: Range, out: &mut Hits) {
        self.search_crossing_intervals(ray, range, &mut |_, root| {
            out.extend(Some(root()).filter(|t| range.contains(*t)).map(Hit::on_single_piece));
            false
        });
    }

    fn closest(&self, ray: &Ray, range: Range) -> Option<Hit> {
        let mut first = None;
        self.search_crossing_intervals(ray, range, &mut |_, root| {
            first = Some(root()).filter(|t| range.contains(*t)).map(Hit::on_single_piece);
            first.is_some()
        });
        first
    }

    fn any_hit(&self, ray: &Ray, range: Range) -> bool {
        let mut any = false;
        self.search_crossing_intervals(ray, range, &mut |ends, root| {
            any = ends.iter().all(|t| range.contains(*t)) || range.contains(root());
            any
        });
        any
    }

    fn inside(&self, p: DVec3) -> bool {
        p.length() <= self.escape_radius() && self.contains(p)
    }

    /// Normal of a Julia fractal: the direction of the steepest growth of h after the last iteration (quirk:
    /// `julia_normal`). POV-Ray's normals of functions other than `sqr` and `cube` do not belong to the surface; there
    /// the iteration that escapes is used.
    fn normal(&self, p: DVec3, _: &Hit) -> DVec3 {
        let rounds = if self.iteration_rule().has_proven_deviation_bound() {
            self.iteration_count() + 1
        } else {
            self.iteration_of_max_length(p)
        };
        let n = self.gradient_of_squared_length(p, rounds);
        let n = if n.is_finite() && n != DVec3::ZERO { n } else { self.gradient_of_squared_length(p, 0) };
        if n.is_finite() && n != DVec3::ZERO { n } else { DVec3::Y }
    }

    /// Returns false: POV-Ray defines no uv mapping for a Julia fractal.
    fn has_uv_mapping(&self) -> bool {
        false
    }
}

#[cfg(test)]
mod tests;
