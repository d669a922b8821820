//! `spline { … }` (manual, "Splines"): a curve of two to five numbers through points at values of a parameter.

use super::{ResultType, Sampler};
use crate::value::{Thing, VecN};

/// Interpolation between a spline's points.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum SplineKind {
    /// Linear spline: straight lines between the points.
    Linear,
    /// Quadratic spline: a parabola through three points at a time.
    Quadratic,
    /// Natural spline: cubic with two continuous derivatives, and curvature 0 at the ends.
    Natural,
    /// Cubic spline through all points but the first and last, which only define the direction at their neighbours.
    Cubic,
}

/// Spline: points in the order of their parameters, and their interpolation.
#[derive(Clone, Debug)]
pub struct Spline {
    /// Interpolation of the spline's points, unless a call names another.
    pub kind: SplineKind,
    /// Parameter and point of each of the spline's entries, in ascending order.
    points: Vec<(f64, [f64; 5])>,
    /// Number of components of the spline's points.
    pub len: u8,
    /// Second derivatives of the natural spline at its points.
    bends: Vec<[f64; 5]>,
}

impl SplineKind {
    /// Returns the kind of spline with this word, such as `cubic_spline`.
    pub fn from_word(word: &str) -> Option<Self> {
        Some(match word {
            "linear_spline" => Self::Linear,
            "quadratic_spline" => Self::Quadratic,
            "natural_spline" => Self::Natural,
            "cubic_spline" => Self::Cubic,
            _ => return None,
        })
    }
}

impl Spline {
    /// Creates a spline from points in any order; of two points with one parameter the last counts. At least one point
    /// is required.
    pub fn new(kind: SplineKind, given: &[(f64, VecN)]) -> Self {
        let mut points: Vec<(f64, [f64; 5])> = vec![];
        for (parameter, point) in given {
            match points.binary_search_by(|(known, _)| known.total_cmp(parameter)) {
                Ok(i) => points[i].1 = point.c,
                Err(i) => points.insert(i, (*parameter, point.c)),
            }
        }
        let len = given.iter().map(|(_, p)| p.len).max().unwrap_or(2);
        let bends = natural_second_derivatives(&points);
        Self { kind, points, len, bends }
    }

    /// The spline's parameters and points in ascending order, for a spline that adds more.
    pub fn points(&self) -> impl Iterator<Item = (f64, VecN)> + '_ {
        self.points.iter().map(|(parameter, c)| (*parameter, VecN { c: *c, len: self.len }))
    }

    /// Returns the spline's point at a parameter; constant before the first point and after the last, or for a cubic
    /// spline before the second and after the last but one.
    pub fn point_at(&self, parameter: f64, kind: SplineKind) -> [f64; 5] {
        let (p, n) = (&self.points, self.points.len());
        // The cubic begins at the second point and ends at the last but one.
        let (first, last) = if kind == SplineKind::Cubic && n > 1 { (1, n.max(3) - 2) } else { (0, n - 1) };
        let (first, last) = (first.min(last), last);
        if n == 1 || parameter.is_nan() || parameter <= p[first].0 {
            return p[first].1;
        }
        if parameter >= p[last].0 {
            return p[last].1;
        }
        // parameter is between the points i and i+1.
        let i = p.partition_point(|(known, _)| *known <= parameter) - 1;
        let mut out = [0.0; 5];
        for (c, out) in out.iter_mut().enumerate().take(self.len as usize) {
            *out = match kind {
                SplineKind::Linear => linear_component(p[i], p[i + 1], parameter, c),
                SplineKind::Quadratic if n > 2 => parabola_component(&p[i.max(1) - 1..][..3], parameter, c),
                SplineKind::Quadratic => linear_component(p[i], p[i + 1], parameter, c),
                SplineKind::Cubic => self.cubic_component(i, parameter, c),
                SplineKind::Natural => self.natural_component(i, parameter, c),
            };
        }
        out
    }

    /// Component of a cubic spline between the points `segment` and `segment` + 1, by Hermite's cubic; the slope at a
    /// point is the mean of those of the lines to its neighbours (quirk: `cubic_spline_slopes`).
    fn cubic_component(&self, segment: usize, parameter: f64, component: usize) -> f64 {
        let p = &self.points;
        let slope = |segment: usize| {
            (p[segment + 1].1[component] - p[segment].1[component]) / (p[segment + 1].0 - p[segment].0)
        };
        let h = p[segment + 1].0 - p[segment].0;
        let s = (parameter - p[segment].0) / h;
        let (m0, m1) = ((slope(segment - 1) + slope(segment)) / 2.0, (slope(segment) + slope(segment + 1)) / 2.0);
        let (s2, s3) = (s * s, s * s * s);
        (2.0 * s3 - 3.0 * s2 + 1.0) * p[segment].1[component]
            + (s3 - 2.0 * s2 + s) * h * m0
            + (3.0 * s2 - 2.0 * s3) * p[segment + 1].1[component]
            + (s3 - s2) * h * m1
    }

    /// Component of a natural spline between the points `segment` and `segment` + 1, from the values and second
    /// derivatives at both ends (Press et al., "Numerical Recipes", 1992, section 3.3).
    fn natural_component(&self, segment: usize, parameter: f64, component: usize) -> f64 {
        let p = &self.points;
        let h = p[segment + 1].0 - p[segment].0;
        let (a, b) = ((p[segment + 1].0 - parameter) / h, (parameter - p[segment].0) / h);
        let bend =
            (a * a * a - a) * self.bends[segment][component] + (b * b * b - b) * self.bends[segment + 1][component];
        a * p[segment].1[component] + b * p[segment + 1].1[component] + bend * h * h / 6.0
    }
}

fn linear_component(a: (f64, [f64; 5]), b: (f64, [f64; 5]), parameter: f64, component: usize) -> f64 {
    a.1[component] + (b.1[component] - a.1[component]) * (parameter - a.0) / (b.0 - a.0)
}

/// Component of Lagrange's parabola through three points of a spline.
fn parabola_component(p: &[(f64, [f64; 5])], parameter: f64, component: usize) -> f64 {
    let [t0, t1, t2] = [p[0].0, p[1].0, p[2].0];
    p[0].1[component] * (parameter - t1) * (parameter - t2) / ((t0 - t1) * (t0 - t2))
        + p[1].1[component] * (parameter - t0) * (parameter - t2) / ((t1 - t0) * (t1 - t2))
        + p[2].1[component] * (parameter - t0) * (parameter - t1) / ((t2 - t0) * (t2 - t1))
}

/// Second derivatives of a natural spline at its points, 0 at both ends: a tridiagonal system, solved from both sides.
fn natural_second_derivatives(p: &[(f64, [f64; 5])]) -> Vec<[f64; 5]> {
    let n = p.len();
    let mut out = vec![[0.0; 5]; n];
    if n < 3 {
        return out;
    }
    let (mut upper, mut right) = (vec![0.0; n], vec![0.0; n]);
    let components = 0..5;
    for c in components {
        for i in 1..n - 1 {
            let (h0, h1) = (p[i].0 - p[i - 1].0, p[i + 1].0 - p[i].0);
            let jump = (p[i + 1].1[c] - p[i].1[c]) / h1 - (p[i].1[c] - p[i - 1].1[c]) / h0;
            let pivot = 2.0 * (h0 + h1) - h0 * upper[i - 1];
            upper[i] = h1 / pivot;
            right[i] = (6.0 * jump - h0 * right[i - 1]) / pivot;
        }
        for i in (1..n - 1).rev() {
            out[i][c] = right[i] - upper[i] * out[i + 1][c];
        }
    }
    out
}

impl Thing for Spline {
    fn kind(&self) -> &'static str {
        "spline"
    }
}

impl Sampler for Spline {
    fn arity(&self) -> usize {
        1
    }

    fn result_type(&self) -> ResultType {
        ResultType::Vector(self.len)
    }

    fn sample(&self, arguments: &[f64]) -> [f64; 5] {
        self.point_at(arguments[0], self.kind)
    }
}
