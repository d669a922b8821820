//! Surfaces of revolution about the y axis: the walls of `lathe` and `sor`.

use super::spline::{bernstein_derivative_at, bernstein_derivative_roots, bernstein_product, evaluate_bernstein};
use crate::math::{DVec2, DVec3, Range, Ray, bernstein_roots, fp, solve_quadratic_with_discriminant};
use crate::shape::{Hit, Hits};
use smallvec::SmallVec;

/// Slope below which a ray counts as level for a surface of revolution: its hits are all found at one height.
const LEVEL: f64 = 1e-7;
/// Slope above which a ray counts as steep for a surface of revolution: the height of a hit determines its position on
/// the ray.
const STEEP: f64 = 0.1;

/// Maximum number of Bernstein coefficients of a segment.
const MAX_COEFFICIENTS: usize = 7;

/// Walls of a surface of revolution, such as a lathe.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Walls {
    pieces: Vec<Piece>,
    /// Height that is y = 0 for the walls' `pieces`: it has been subtracted from all of their heights.
    origin_height: f64,
}

/// One segment of the walls of a surface of revolution, in Bernstein coefficients of one degree, at most 6: height,
/// squared height, and squared radius. Neighbours have identical numbers at their common end.
#[derive(Clone, Debug, PartialEq)]
struct Piece {
    height: Vec<f64>,
    height2: Vec<f64>,
    radius2: Vec<f64>,
    /// Lower and upper bound of the segment's height.
    height_range: [f64; 2],
    /// Upper bound of the segment's squared radius.
    max_radius2: f64,
}

impl Piece {
    fn new(height: &[f64], radius2: Vec<f64>) -> Self {
        let raised = |b: Vec<f64>| bernstein_product(&b, &vec![1.0; radius2.len() + 1 - b.len()]);
        let (height, height2) = (raised(height.to_vec()), raised(bernstein_product(height, height)));
        // The curve is in the convex hull of its coefficients.
        let lowest = height.iter().copied().fold(f64::INFINITY, f64::min);
        let highest = height.iter().copied().fold(f64::NEG_INFINITY, f64::max);
        let max_radius2 = radius2.iter().copied().fold(0.0, f64::max);
        Self { height, height2, radius2, height_range: [lowest, highest], max_radius2 }
    }
}

/// A ray o + s·v relative to its point o nearest to the centre of a surface of revolution, with v of length 1.
struct Line {
    o: DVec3,
    v: DVec3,
    /// Parameter of the point nearest to the centre on the ray, and length of the ray's direction.
    middle: f64,
    length: f64,
    /// Coefficients k, m and q of the squared distance from the axis, k·s² + 2·m·s + q.
    axis_distance2: [f64; 3],
    /// Parameter of the point nearest to the axis on the ray; without meaning for a ray that is nearly parallel to the axis.
    nearest_to_axis: f64,
    /// Inverse of v's component along the axis.
    inverse_rise: f64,
}

impl Line {
    fn new(ray: &Ray, origin_height: f64) -> Self {
        let from = ray.origin - DVec3::Y * origin_height;
        let length = ray.dir.length();
        let v = ray.dir / length;
        let middle = -from.dot(v);
        let o = from + middle * v;
        let axis_distance2 = [v.x * v.x + v.z * v.z, o.x * v.x + o.z * v.z, o.x * o.x + o.z * o.z];
        let nearest_to_axis = -axis_distance2[1] / axis_distance2[0];
        Self { o, v, middle, length, axis_distance2, nearest_to_axis, inverse_rise: 1.0 / v.y }
    }

    /// Returns the distance along the ray for a parameter s.
    fn distance(&self, s: f64) -> f64 {
        (s + self.middle) / self.length
    }

    /// Returns the interval of s that belongs to a range of distances along the ray, enlarged by more than rounding errors.
    fn interval_of_range(&self, range: Range) -> [f64; 2] {
        let slack = 1e-12 * self.middle.abs();
        [range.min * self.length - self.middle - slack, range.max * self.length - self.middle + slack]
    }

    /// Returns a lower bound of the squared distance from the axis for s between `first` and `last`.
    fn min_axis_distance2(&self, [first, last]: [f64; 2]) -> f64 {
        let [k, m, q] = self.axis_distance2;
        // For a ray that is nearly parallel to the axis, m/k is a rounding error.
        if k <= 1e-12 {
            return 0.0;
        }
        let nearest = self.nearest_to_axis.clamp(first, last);
        let distance2 = (k * nearest + 2.0 * m) * nearest + q;
        // The rounding errors of the three terms are far smaller.
        distance2 - 1e-12 * (q + k * nearest * nearest)
    }

    /// Returns the interval of s in which the ray, which is not level, is between two heights, enlarged by far more than
    /// rounding errors.
    fn interval_between_heights(&self, [lowest, highest]: [f64; 2]) -> [f64; 2] {
        const SLACK: f64 = 1e-9;
        let slack = |height: f64| SLACK * (height.abs() + self.o.y.abs());
        let (below, above) = (lowest - slack(lowest) - self.o.y, highest + slack(highest) - self.o.y);
        let (a, b) = (below * self.inverse_rise, above * self.inverse_rise);
        if a < b { [a, b] } else { [b, a] }
    }
}

impl Walls {
    /// Builds the walls of a surface of revolution from Bernstein coefficients of heights and of squared radii. The
    /// walls' pieces are stored relative to `origin_height`.
    pub fn new(segments: impl IntoIterator<Item = (SmallVec<[f64; 4]>, Vec<f64>)>, origin_height: f64) -> Self {
        let raise = |(height, radius2): (SmallVec<[f64; 4]>, Vec<f64>)| {
            let height: Vec<f64> = height.iter().map(|y| y - origin_height).collect();
            Piece::new(&height, radius2)
        };
        Self { pieces: segments.into_iter().map(raise).collect(), origin_height }
    }

    /// Appends the hits on the walls in the range; `part` and `uv.x` are the segment and the position in it.
    pub fn hits(&self, ray: &Ray, range: Range, out: &mut Hits) {
        let line = Line::new(ray, self.origin_height);
        let is_level = line.v.y.abs() < LEVEL;
        let min_distance2 = line.min_axis_distance2([f64::NEG_INFINITY, f64::INFINITY]);
        let wanted = line.interval_of_range(range);
        for (part, piece) in self.pieces.iter().enumerate() {
            if piece.max_radius2 < min_distance2 || !is_level && !piece.may_be_hit(&line, wanted) {
                continue;
            }
            let mut visit = |s: f64, at: f64| {
                let t = line.distance(s);
                if range.contains(t) {
                    out.push(Hit { t, part: part as u32, uv: DVec2::new(at, 0.0) });
                }
            };
            match is_level {
                true => piece.visit_level_ray_hits(&line, &mut visit),
                false => piece.visit_hits(&line, &mut visit),
            }
        }
    }

    /// Outward normal of the walls at a hit, for a curve that goes up.
    pub fn normal(&self, p: DVec3, hit: &Hit) -> DVec3 {
        let piece = &self.pieces[hit.part as usize];
        let up = bernstein_derivative_at(&piece.height, hit.uv.x);
        // 2·r·r'
        let out = bernstein_derivative_at(&piece.radius2, hit.uv.x);
        let n = DVec3::new(p.x * up, -0.5 * out, p.z * up);
        if n.length_squared() > 0.0 { n } else { DVec3::Y }
    }

    /// Surface coordinates of the walls: angle about the axis, and position along the curve, where all segments count
    /// as equally long (quirk: `lathe_uv`).
    pub fn uv(&self, p: DVec3, hit: &Hit) -> DVec2 {
        DVec2::new(fp::positive_angle_in_turns(p.z, p.x), (f64::from(hit.part) + hit.uv.x) / self.pieces.len() as f64)
    }
}

impl Piece {
    /// False only if a ray, which is not level, has no hit on the segment for s in the interval `wanted`: where the ray is at
    /// the segment's heights, it is outside of the interval or farther from the axis than the segment.
    fn may_be_hit(&self, line: &Line, wanted: [f64; 2]) -> bool {
        let [first, last] = line.interval_between_heights(self.height_range);
        let is_in_range = first <= wanted[1] && last >= wanted[0];
        is_in_range && line.min_axis_distance2([first, last]) <= self.max_radius2
    }

    /// Calls `visit_s_and_position` with the hits on one segment of the walls. The ray is at height y where s = (y -
    /// o_y)/v_y, and there |(o + s·v)ₓ𝓏|² = r². Times v_y², that is a polynomial along the segment.
    fn visit_hits(&self, line: &Line, visit_s_and_position: &mut dyn FnMut(f64, f64)) {
        let (o, v) = (line.o, line.v);
        let [k, m, q] = line.axis_distance2;
        let by_height = 2.0 * (v.y * m - k * o.y);
        let constant = k * o.y * o.y - 2.0 * v.y * m * o.y + v.y * v.y * q;
        let mut b = [0.0; MAX_COEFFICIENTS];
        let terms = self.height.iter().zip(&self.height2).zip(&self.radius2);
        for (b, ((y, y2), r2)) in b.iter_mut().zip(terms) {
            *b = k * y2 + by_height * y + constant - v.y * v.y * r2;
        }
        bernstein_roots(&b[..self.height.len()], &mut |at| {
            let s = (evaluate_bernstein(&self.height, at) - o.y) / v.y;
            if v.y.abs() > STEEP {
                visit_s_and_position(s, at);
                return false;
            }
            // Select the nearer of the two points at this distance from the axis.
            let c = q - evaluate_bernstein(&self.radius2, at);
            if let Some((s1, s2)) = solve_quadratic_with_discriminant(k, m, c, (m * m - k * c).max(0.0)) {
                visit_s_and_position(if (s - s1).abs() < (s - s2).abs() { s1 } else { s2 }, at);
            }
            false
        });
    }

    /// Calls `visit_s_and_position` with the hits of a level ray: where the segment has the ray's height, two points of
    /// the ray have its radius.
    fn visit_level_ray_hits(&self, line: &Line, visit_s_and_position: &mut dyn FnMut(f64, f64)) {
        let b: SmallVec<[f64; MAX_COEFFICIENTS]> = self.height.iter().map(|y| y - line.o.y).collect();
        bernstein_roots(&b, &mut |at| {
            let [k, m, q] = line.axis_distance2;
            let c = q - evaluate_bernstein(&self.radius2, at);
            if let Some((s1, s2)) = solve_quadratic_with_discriminant(k, m, c, m * m - k * c) {
                visit_s_and_position(s1, at);
                visit_s_and_position(s2, at);
            }
            false
        });
    }
}

/// Maximum on [0, 1] of a polynomial with these Bernstein coefficients, of degree up to 3; at least 0.
pub fn bernstein_max_or_zero(b: &[f64]) -> f64 {
    let inner = bernstein_derivative_roots(b).into_iter().flatten().map(|t| evaluate_bernstein(b, t));
    inner.chain([b[0], b[b.len() - 1]]).fold(0.0, f64::max)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Hits of a ray that is not level, with all pieces.
    fn hits_on_all_pieces(walls: &Walls, ray: &Ray) -> Hits {
        let (line, mut all) = (Line::new(ray, walls.origin_height), Hits::new());
        for (part, piece) in walls.pieces.iter().enumerate() {
            piece.visit_hits(&line, &mut |s, at| {
                let hit = Hit { t: line.distance(s), part: part as u32, uv: DVec2::new(at, 0.0) };
                all.extend(Range::FORWARD.contains(hit.t).then_some(hit));
            });
        }
        all
    }

    proptest::proptest! {
        /// Pieces that a ray is tested not to hit have no hits.
        #[test]
        fn pieces_that_are_skipped_have_no_hits(
            radii in proptest::collection::vec(0.0..2.0_f64, 7),
            heights in proptest::collection::vec(-1.0..2.0_f64, 7),
            origin in proptest::array::uniform3(-3.0..3.0_f64),
            dir in proptest::array::uniform3(-1.0..1.0_f64),
            size in -6..6_i32,
        ) {
            let unit = 10.0_f64.powi(size);
            let piece = |i: usize| {
                let height = SmallVec::from_iter(heights[3 * i..3 * i + 4].iter().map(|y| y * unit));
                let radius: Vec<f64> = radii[3 * i..3 * i + 4].iter().map(|r| r * unit).collect();
                (height, bernstein_product(&radius, &radius))
            };
            let walls = Walls::new([piece(0), piece(1)], 0.5 * unit);
            let ray = Ray::new(DVec3::from(origin) * unit, DVec3::from(dir));
            proptest::prop_assume!(ray.dir.y.abs() > LEVEL * ray.dir.length());
            let mut found = Hits::new();
            walls.hits(&ray, Range::FORWARD, &mut found);
            proptest::prop_assert_eq!(found, hits_on_all_pieces(&walls, &ray));
        }
    }
}
