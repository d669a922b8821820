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
    /// Upper bound of the segment's squared radius.
    most: f64,
}

impl Piece {
    fn new(height: &[f64], radius2: Vec<f64>) -> Self {
        let raised = |b: Vec<f64>| bernstein_product(&b, &vec![1.0; radius2.len() + 1 - b.len()]);
        let (height, height2) = (raised(height.to_vec()), raised(bernstein_product(height, height)));
        let most = radius2.iter().copied().fold(0.0, f64::max);
        Self { height, height2, radius2, most }
    }
}

/// A ray relative to its point nearest to the centre of a surface of revolution, in units of length.
struct Line {
    o: DVec3,
    v: DVec3,
    /// Parameter of the point nearest to the centre on the ray, and length of the ray's direction.
    middle: f64,
    length: f64,
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
        let from = ray.origin - DVec3::Y * self.origin_height;
        let length = ray.dir.length();
        let v = ray.dir / length;
        let middle = -from.dot(v);
        let line = Line { o: from + middle * v, v, middle, length };
        let distance2 = min_squared_axis_distance(line.o, v);
        for (part, piece) in self.pieces.iter().enumerate() {
            if piece.most < distance2 {
                continue;
            }
            let mut visit = |s: f64, at: f64| {
                let t = (s + line.middle) / line.length;
                if range.contains(t) {
                    out.push(Hit { t, part: part as u32, uv: DVec2::new(at, 0.0) });
                }
            };
            if v.y.abs() < LEVEL {
                piece.visit_level_ray_hits(&line, &mut visit)
            } else {
                piece.visit_hits(&line, &mut visit)
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

/// Lower bound of the squared distance between a line and the y axis.
fn min_squared_axis_distance(o: DVec3, v: DVec3) -> f64 {
    let across = v.x * v.x + v.z * v.z;
    let turn = o.x * v.z - o.z * v.x;
    if across > 1e-12 { turn * turn / across * (1.0 - 1e-9) } else { 0.0 }
}

impl Piece {
    /// Calls `visit_s_and_position` with the hits on one segment of the walls. The ray is at height y where s = (y -
    /// o_y)/v_y, and there |(o + s·v)ₓ𝓏|² = r². Times v_y², that is a polynomial along the segment.
    fn visit_hits(&self, line: &Line, visit_s_and_position: &mut dyn FnMut(f64, f64)) {
        let (o, v) = (line.o, line.v);
        let (k, m, q) = (v.x * v.x + v.z * v.z, o.x * v.x + o.z * v.z, o.x * o.x + o.z * o.z);
        let by_height = 2.0 * (v.y * m - k * o.y);
        let constant = k * o.y * o.y - 2.0 * v.y * m * o.y + v.y * v.y * q;
        let terms = self.height.iter().zip(&self.height2).zip(&self.radius2);
        let b: SmallVec<[f64; 8]> =
            terms.map(|((y, y2), r2)| k * y2 + by_height * y + constant - v.y * v.y * r2).collect();
        bernstein_roots(&b, &mut |at| {
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
        let (o, v) = (line.o, line.v);
        let b: SmallVec<[f64; 8]> = self.height.iter().map(|y| y - o.y).collect();
        bernstein_roots(&b, &mut |at| {
            let (k, m) = (v.x * v.x + v.z * v.z, o.x * v.x + o.z * v.z);
            let c = o.x * o.x + o.z * o.z - evaluate_bernstein(&self.radius2, at);
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
