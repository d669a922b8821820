//! Outline of a glyph: its curves, a table of the curves by height, and the test whether a point is inside.

use crate::font::{Curve, Outline};
use crate::math::{DVec2, solve_quadratic};
use std::ops::ControlFlow;

/// Maximum number of bands in a glyph's table of curves.
const MAX_BANDS: usize = 64;

/// Outline of a glyph, in em.
#[derive(Debug, PartialEq)]
pub struct Glyph {
    curves: Vec<BoundedCurve>,
    /// Lower left corner of the outline's bounding rectangle.
    pub min: DVec2,
    /// Upper right corner of the outline's bounding rectangle.
    pub max: DVec2,
    bands: Bands,
}

/// Curve of a glyph's outline with the bounding rectangle of its control points.
#[derive(Debug, PartialEq)]
struct BoundedCurve {
    curve: Curve,
    min: DVec2,
    max: DVec2,
    /// Lowest band of the glyph's table that lists the curve.
    first_band: usize,
}

/// Table of a glyph's curves by horizontal bands of equal height. A curve is listed in each band that the rectangle
/// around its control points overlaps.
#[derive(Debug, PartialEq)]
struct Bands {
    /// y of the lower edge of the lowest band.
    bottom: f64,
    /// Number of bands per unit of y; infinite for an outline without height.
    bands_per_unit: f64,
    /// Curve numbers of all bands: those of band `i` are `listed[starts[i]..starts[i + 1]]`.
    listed: Vec<u32>,
    starts: Vec<usize>,
}

impl Glyph {
    /// Creates the outline of a glyph and its table of curves.
    pub fn new(outline: Outline) -> Self {
        let ends = |better: fn(DVec2, DVec2) -> DVec2| {
            outline
                .iter()
                .flat_map(|curve| [curve[0], extremum_of_turning_points(curve, better), curve[2]])
                .reduce(better)
        };
        let (min, max) = (ends(DVec2::min).unwrap_or_default(), ends(DVec2::max).unwrap_or_default());
        let mut curves: Vec<BoundedCurve> = outline.into_iter().map(BoundedCurve::new).collect();
        let bands = Bands::new(&mut curves, min.y, max.y);
        Self { curves, min, max, bands }
    }

    /// Returns the number of curves of the outline.
    pub fn curve_count(&self) -> usize {
        self.curves.len()
    }

    /// Returns the outline's curve with this number.
    pub fn curve(&self, number: usize) -> &Curve {
        &self.curves[number].curve
    }

    /// True if the half-line from the point along +x crosses the glyph's outlines an odd number of times. Each
    /// monotonic piece of a curve includes its lower end but not its upper end.
    pub fn outline_contains(&self, p: DVec2) -> bool {
        if p.y < self.min.y || p.y > self.max.y || p.x < self.min.x || p.x > self.max.x {
            return false;
        }
        let mut odd = false;
        for &number in self.bands.curves_in_band(self.bands.band_at(p.y)) {
            odd ^= self.curves[number as usize].is_crossed_oddly(p);
        }
        odd
    }

    /// Calls `visit` with the number and the curve, for each curve whose bounding rectangle overlaps the rectangle from
    /// `low` to `high`, in no particular order, until it returns `Break`.
    pub fn visit_curves_in_rectangle(
        &self,
        low: DVec2,
        high: DVec2,
        mut visit: impl FnMut(usize, &Curve) -> ControlFlow<()>,
    ) -> ControlFlow<()> {
        let (first, last) = (self.bands.band_at(low.y), self.bands.band_at(high.y));
        for band in first..=last {
            for &number in self.bands.curves_in_band(band) {
                let curve = &self.curves[number as usize];
                // Visit a curve of several bands only in the first one.
                if band == first.max(curve.first_band) && curve.overlaps(low, high) {
                    visit(number as usize, &curve.curve)?;
                }
            }
        }
        ControlFlow::Continue(())
    }
}

impl BoundedCurve {
    fn new(curve: Curve) -> Self {
        let [a, b, c] = curve;
        Self { curve, min: a.min(b).min(c), max: a.max(b).max(c), first_band: 0 }
    }

    /// True if the rectangle of the control points overlaps the rectangle from `low` to `high`.
    fn overlaps(&self, low: DVec2, high: DVec2) -> bool {
        self.min.y <= high.y && self.max.y >= low.y && self.min.x <= high.x && self.max.x >= low.x
    }

    /// True if the half-line from the point along +x crosses the curve an odd number of times.
    fn is_crossed_oddly(&self, p: DVec2) -> bool {
        // Reject a curve above, below or to the left of the point.
        if p.y < self.min.y || p.y >= self.max.y || p.x >= self.max.x {
            return false;
        }
        // Right of the point, every crossing counts: the ends decide whether their number is odd.
        if p.x < self.min.x {
            return (self.curve[0].y <= p.y) != (self.curve[2].y <= p.y);
        }
        curve_is_crossed_oddly(self.curve.map(|q| q - p))
    }
}

impl Bands {
    /// Creates the table of the curves of an outline from `bottom` to `top`, and stores each curve's first band.
    fn new(curves: &mut [BoundedCurve], bottom: f64, top: f64) -> Self {
        let count = curves.len().clamp(1, MAX_BANDS);
        let bands_per_unit = count as f64 / (top - bottom);
        let mut bands = Self { bottom, bands_per_unit, listed: vec![], starts: vec![0; count + 1] };
        let mut spans = Vec::with_capacity(curves.len());
        for curve in curves {
            curve.first_band = bands.band_at(curve.min.y);
            spans.push((curve.first_band, bands.band_at(curve.max.y)));
        }
        for band in 0..count {
            let in_band = (0..).zip(&spans).filter(|(_, (first, last))| (*first..=*last).contains(&band));
            bands.listed.extend(in_band.map(|(number, _)| number));
            bands.starts[band + 1] = bands.listed.len();
        }
        bands
    }

    /// Returns the band that contains `y`, or the nearest band for `y` outside of the table. The result never decreases with
    /// `y`, so that rounding cannot separate a point of a curve from the curve's bands.
    fn band_at(&self, y: f64) -> usize {
        // The conversion turns negative numbers and NaN into 0.
        (((y - self.bottom) * self.bands_per_unit) as usize).min(self.starts.len() - 2)
    }

    fn curves_in_band(&self, band: usize) -> &[u32] {
        &self.listed[self.starts[band]..self.starts[band + 1]]
    }
}

/// True if the half-line from the origin along +x crosses the curve an odd number of times.
pub fn curve_is_crossed_oddly([a, b, c]: Curve) -> bool {
    // y(s) = (a - 2b + c)·s² + 2(b - a)·s + a has at most one extremum.
    let turn = (a.y - b.y) / (a.y - 2.0 * b.y + c.y);
    let mut odd = false;
    let mut piece = |s0: f64, y0: f64, s1: f64, y1: f64| {
        if (y0 <= 0.0) != (y1 <= 0.0) {
            odd ^= curve_point([a, b, c], bernstein_quadratic_root_between(a.y, b.y, c.y, s0, s1)).x > 0.0;
        }
    };
    if turn > 0.0 && turn < 1.0 {
        let top = curve_point([a, b, c], turn).y;
        piece(0.0, a.y, turn, top);
        piece(turn, top, 1.0, c.y);
    } else {
        piece(0.0, a.y, 1.0, c.y);
    }
    odd
}

/// Returns the curve's turning points along x and y, combined by `better` (componentwise minimum or maximum). The
/// curve's start replaces a turning point that is not between the ends.
fn extremum_of_turning_points(curve: &Curve, better: fn(DVec2, DVec2) -> DVec2) -> DVec2 {
    let turn = (curve[0] - curve[1]) / (curve[0] - 2.0 * curve[1] + curve[2]);
    let inner = |s: f64| if s > 0.0 && s < 1.0 { curve_point(*curve, s) } else { curve[0] };
    better(inner(turn.x), inner(turn.y))
}

/// Returns the point of a curve at the parameter `s`.
pub fn curve_point([a, b, c]: Curve, s: f64) -> DVec2 {
    let r = 1.0 - s;
    a * (r * r) + b * (2.0 * r * s) + c * (s * s)
}

/// Returns the only root of (1 - s)²·a + 2s(1 - s)·b + s²·c between s0 and s1.
fn bernstein_quadratic_root_between(a: f64, b: f64, c: f64, s0: f64, s1: f64) -> f64 {
    let middle = (s0 + s1) / 2.0;
    let off = |s: &f64| (s - middle).abs();
    match solve_quadratic(a - 2.0 * b + c, 2.0 * (b - a), a) {
        Some((s, t)) if off(&t) < off(&s) => t.clamp(s0, s1),
        Some((s, _)) => s.clamp(s0, s1),
        None => middle,
    }
}
