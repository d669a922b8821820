//! From points to curves: interpolation, and the division into outlines.

use super::Curve;
use crate::diagnostic::{Diagnostic, Result, codes};
use crate::math::{DVec2, tolerance};
use crate::source::Span;
use crate::value::words::word;
use crate::value::{Reader, ReaderExt, Value, ValueKind, WordSpec};
use serde::Serialize;

/// Interpolation of a lathe's or prism's outline between its points.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Interpolation {
    /// Outline of straight lines between the points.
    #[default]
    Linear,
    /// Outline of parabolas, each through two points and the one before them.
    Quadratic,
    /// Outline of a smooth curve by two points and their neighbours (Catmull & Rom, 1974).
    Cubic,
    /// Outline of Bézier segments, each with four points.
    Bezier,
}

use Interpolation::*;

/// Words of an outline's interpolations.
pub const KINDS: [WordSpec; 4] = [
    word("linear_spline", ValueKind::Nothing, "", "straight lines join the points; so it is without any such word"),
    word(
        "quadratic_spline",
        ValueKind::Nothing,
        "",
        "parabolas join the points; the first point only gives a direction",
    ),
    word("cubic_spline", ValueKind::Nothing, "", "a smooth curve; the first and the last point only give directions"),
    word(
        "bezier_spline",
        ValueKind::Nothing,
        "",
        "each four points: an end, two that pull at the curve, the other end",
    ),
];

impl Interpolation {
    /// Reads the word of an outline's interpolation, such as `linear_spline`; `None` if another token is next.
    ///
    /// # Errors
    /// Errors of the reader.
    pub fn read(r: &mut dyn Reader) -> Result<Option<Self>> {
        for (kind, word) in [Linear, Quadratic, Cubic, Bezier].into_iter().zip(KINDS) {
            if r.accept(word.name)? {
                return Ok(Some(kind));
            }
        }
        Ok(None)
    }

    fn degree(self) -> usize {
        match self {
            Linear => 1,
            Quadratic => 2,
            Cubic | Bezier => 3,
        }
    }

    /// Minimum number of points of an outline.
    fn min_point_count(self) -> usize {
        self.degree() + 1
    }

    /// Returns the segments of an outline through one row of points.
    fn segments(self, points: &[DVec2]) -> Vec<[DVec2; 4]> {
        let none = DVec2::ZERO;
        let inner = |p: &[DVec2]| [p[1], p[1] + (p[2] - p[0]) / 6.0, p[2] - (p[3] - p[1]) / 6.0, p[2]];
        match self {
            Linear => points.windows(2).map(|p| [p[0], p[1], none, none]).collect(),
            // The parabola through p₀, p₁, p₂ at t = -1, 0, 1 has the slope (p₂ - p₀)/2 at p₁.
            Quadratic => points.windows(3).map(|p| [p[1], p[1] + (p[2] - p[0]) / 4.0, p[2], none]).collect(),
            Cubic => points.windows(4).map(inner).collect(),
            Bezier => points.chunks_exact(4).map(|p| [p[0], p[1], p[2], p[3]]).collect(),
        }
    }
}

/// Reads the number of points of an outline, and the points. `block` is the shape's word, and `fewest` its minimum
/// number of points.
///
/// # Errors
/// E0302 for fewer points than the shape or the interpolation needs, and for a `bezier_spline` unless their number is a
/// multiple of 4; a diagnostic for anything that is not a point.
pub fn read_points(block: &str, kind: Interpolation, fewest: usize, r: &mut dyn Reader) -> Result<Vec<DVec2>> {
    let span = r.span();
    let count = r.float()?.floor();
    let fewest = fewest.max(kind.min_point_count());
    if !(fewest as f64..=f64::from(u32::MAX)).contains(&count) {
        let message = format!("this `{block}` needs at least {fewest} points, it has {count}");
        let help = "the number before the points says how many follow";
        return Err(Diagnostic::new(codes::FEW_POINTS, span, message).help(help).into());
    }
    if kind == Bezier && count % 4.0 != 0.0 {
        let message =
            format!("a `bezier_spline` has four points for each piece, {count} points are no whole number of pieces");
        return Diagnostic::err(codes::FEW_POINTS, span, message);
    }
    (0..count as u32).map(|_| read_point(r)).collect()
}

fn read_point(r: &mut dyn Reader) -> Result<DVec2> {
    let (value, span) = r.value()?;
    let point = match value {
        Value::Float(x) => DVec2::splat(x),
        Value::Vector(v) if v.len == 2 => DVec2::new(v.c[0], v.c[1]),
        other => {
            let message = format!("expected a point of two numbers, found {}", other.describe());
            return Diagnostic::err(codes::WRONG_TYPE, span, message);
        }
    };
    if point.is_finite() {
        return Ok(point);
    }
    Diagnostic::err(codes::NOT_FINITE, span, "one of these numbers is infinite or not a number")
}

/// Creates the curve of one outline through all points.
pub fn single_outline(kind: Interpolation, points: &[DVec2]) -> Curve {
    Curve { degree: kind.degree(), segments: kind.segments(points) }
}

/// Creates the curve of closed outlines: an outline ends where its first point is repeated, and the next starts after
/// it. Also returns true if the last outline is open: a `linear_spline` is then closed, any other is left out.
pub fn outlines_and_is_unclosed(kind: Interpolation, points: &[DVec2]) -> (Curve, bool) {
    let same = |p: DVec2, q: DVec2| (p - q).abs().max_element() < tolerance::SAME_POINT;
    let mut curve = Curve { degree: kind.degree(), segments: vec![] };
    // Number of points before the first and after the last of an outline that only give directions.
    let (before, behind) = match kind {
        Linear | Bezier => (0, 0),
        Quadratic => (1, 0),
        Cubic => (1, 1),
    };
    let mut rest = points;
    while rest.len() > before + 1 {
        let first = rest[before];
        let ends = |(i, p): (usize, &DVec2)| i > before && same(*p, first) && (kind != Bezier || i % 4 == 3);
        let last = rest.iter().enumerate().position(ends);
        let Some(end) = last.map(|last| last + behind).filter(|end| *end < rest.len()) else {
            if kind == Linear {
                let closed: Vec<DVec2> = rest.iter().copied().chain([first]).collect();
                curve.segments.extend(kind.segments(&closed));
            }
            return (curve, true);
        };
        let mut row = rest[..=end].to_vec();
        // Exactly the same numbers, so that no ray passes between them.
        row[end - behind] = first;
        curve.segments.extend(kind.segments(&row));
        rest = &rest[end + 1..];
    }
    let unclosed = !rest.is_empty();
    (curve, unclosed)
}

/// Reports an outline of a lathe or prism that is not closed.
pub fn warn_of_unclosed_outline(block: &str, kind: Interpolation, span: Span, r: &mut dyn Reader) {
    let done = if kind == Linear { "closed now" } else { "left out" };
    let message = format!("the last outline of this `{block}` is not closed; it is {done}");
    let help = "repeat the first point of the outline at its end, and count it";
    r.report(Diagnostic::new(codes::OPEN_OUTLINE, span, message).help(help));
}

#[cfg(test)]
mod tests {
    use super::*;

    fn points(list: &[(f64, f64)]) -> Vec<DVec2> {
        list.iter().map(|&(x, y)| DVec2::new(x, y)).collect()
    }

    #[test]
    fn as_pov_ray_tells() {
        // Largest radius and ends of lathes, by min_extent and max_extent.
        let p = points(&[(0.0, 0.0), (1.0, 0.5), (0.5, 1.0), (0.7, 2.0), (0.2, 3.0), (1.0, 4.0)]);
        let (min, max) = single_outline(Quadratic, &p[..5]).curve_bounds();
        assert!((max - DVec2::new(1.020833333, 3.0)).length() < 1e-7 && min.y == 0.5, "{min} {max}");
        let (min, max) = single_outline(Cubic, &p).curve_bounds();
        assert!((max - DVec2::new(1.008820295, 3.0)).length() < 1e-7 && min.y == 0.5, "{min} {max}");
    }

    #[test]
    fn outlines_of_the_manual() {
        let frame =
            [(0., 0.), (6., 0.), (6., 8.), (0., 8.), (0., 0.), (1., 1.), (5., 1.), (5., 7.), (1., 7.), (1., 1.)];
        let (curve, open) = outlines_and_is_unclosed(Linear, &points(&frame));
        assert!(curve.segments.len() == 8 && !open);
        let inside = |curve: &Curve, x: f64, y: f64| curve.is_crossed_oddly(y, |at| at > x);
        assert!(inside(&curve, 0.5, 4.0) && !inside(&curve, 3.0, 4.0) && !inside(&curve, 7.0, 4.0));
        let frame = [
            (1., -1.),
            (0., 0.),
            (6., 0.),
            (6., 8.),
            (0., 8.),
            (0., 0.),
            (-1., 1.),
            (2., 0.),
            (1., 1.),
            (5., 1.),
            (5., 7.),
            (1., 7.),
            (1., 1.),
            (0., 2.),
        ];
        let (curve, open) = outlines_and_is_unclosed(Cubic, &points(&frame));
        assert!(curve.segments.len() == 8 && !open && inside(&curve, 0.5, 4.0) && !inside(&curve, 3.0, 4.0));
        let (curve, open) = outlines_and_is_unclosed(Cubic, &points(&frame[..6]));
        assert!(curve.segments.is_empty() && open);
        let (curve, open) = outlines_and_is_unclosed(Linear, &points(&[(0., 0.), (1., 0.), (0., 1.)]));
        assert!(curve.segments.len() == 3 && open && inside(&curve, 0.2, 0.2));
    }
}
