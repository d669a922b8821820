//! What a curve beside the y axis sweeps when it turns about it: the walls of `lathe` and `sor`.

use super::spline::{blend, blend_slope, product, turns};
use super::{Hit, Hits};
use crate::math::{DVec2, DVec3, Range, Ray, bernstein_roots, fp, stable_pair};
use smallvec::SmallVec;

/// A ray is level where it rises less than this along its way: its hits are found at one height then.
const LEVEL: f64 = 1e-7;
/// A ray is steep where it rises more than this: then the height of a hit tells where on the ray it is.
const STEEP: f64 = 0.1;

/// The walls.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Walls {
    pieces: Vec<Piece>,
    /// Heights in `pieces` are above this one.
    level: f64,
}

/// One segment, all in Bernstein coefficients of one degree, at most 6: height, its square, and the radius' square. At their ends,
/// neighbours have the very same numbers.
#[derive(Clone, Debug, PartialEq)]
struct Piece {
    height: Vec<f64>,
    height2: Vec<f64>,
    radius2: Vec<f64>,
    /// No square of a radius is larger.
    most: f64,
}

impl Piece {
    fn new(height: &[f64], radius2: Vec<f64>) -> Self {
        let raised = |b: Vec<f64>| product(&b, &vec![1.0; radius2.len() + 1 - b.len()]);
        let (height, height2) = (raised(height.to_vec()), raised(product(height, height)));
        let most = radius2.iter().copied().fold(0.0, f64::max);
        Self { height, height2, radius2, most }
    }
}

/// The ray by its point nearest to the middle of the walls, in units of length.
struct Line {
    o: DVec3,
    v: DVec3,
    /// Where on the ray this point is, and the length of its direction.
    middle: f64,
    length: f64,
}

impl Walls {
    /// From segments: Bernstein coefficients of their heights, and of the squares of their radii.
    pub fn new(segments: impl IntoIterator<Item = (SmallVec<[f64; 4]>, Vec<f64>)>, level: f64) -> Self {
        let raise = |(height, radius2): (SmallVec<[f64; 4]>, Vec<f64>)| {
            let height: Vec<f64> = height.iter().map(|y| y - level).collect();
            Piece::new(&height, radius2)
        };
        Self { pieces: segments.into_iter().map(raise).collect(), level }
    }

    /// Appends the hits in the range; part and uv.x are the segment and the place in it.
    pub fn hits(&self, ray: &Ray, range: Range, out: &mut Hits) {
        let from = ray.origin - DVec3::Y * self.level;
        let length = ray.dir.length();
        let v = ray.dir / length;
        let middle = -from.dot(v);
        let line = Line { o: from + middle * v, v, middle, length };
        let distance2 = closest_to_axis(line.o, v);
        for (part, piece) in self.pieces.iter().enumerate() {
            if piece.most < distance2 {
                continue;
            }
            let mut tell = |s: f64, at: f64| {
                let t = (s + line.middle) / line.length;
                if range.contains(t) {
                    out.push(Hit { t, part: part as u32, uv: DVec2::new(at, 0.0) });
                }
            };
            if v.y.abs() < LEVEL { piece.level_hits(&line, &mut tell) } else { piece.hits(&line, &mut tell) }
        }
    }

    /// Outwards of a curve that goes up, at a hit.
    pub fn normal(&self, p: DVec3, hit: &Hit) -> DVec3 {
        let piece = &self.pieces[hit.part as usize];
        let up = blend_slope(&piece.height, hit.uv.x);
        // 2·r·r'
        let out = blend_slope(&piece.radius2, hit.uv.x);
        let n = DVec3::new(p.x * up, -0.5 * out, p.z * up);
        if n.length_squared() > 0.0 { n } else { DVec3::Y }
    }

    /// Around the axis, and along the curve, each segment as long as the others; as seen in POV-Ray.
    pub fn uv(&self, p: DVec3, hit: &Hit) -> DVec2 {
        DVec2::new(fp::turn(p.z, p.x), (f64::from(hit.part) + hit.uv.x) / self.pieces.len() as f64)
    }
}

/// The square of the distance between a line and the y axis, or a little less.
fn closest_to_axis(o: DVec3, v: DVec3) -> f64 {
    let across = v.x * v.x + v.z * v.z;
    let turn = o.x * v.z - o.z * v.x;
    if across > 1e-12 { turn * turn / across * (1.0 - 1e-9) } else { 0.0 }
}

impl Piece {
    /// The ray is at height y where s = (y - o_y)/v_y, and there |(o + s·v)ₓ𝓏|² = r². Times v_y², that is a polynomial along
    /// the segment.
    fn hits(&self, line: &Line, tell: &mut dyn FnMut(f64, f64)) {
        let (o, v) = (line.o, line.v);
        let (k, m, q) = (v.x * v.x + v.z * v.z, o.x * v.x + o.z * v.z, o.x * o.x + o.z * o.z);
        let by_height = 2.0 * (v.y * m - k * o.y);
        let constant = k * o.y * o.y - 2.0 * v.y * m * o.y + v.y * v.y * q;
        let terms = self.height.iter().zip(&self.height2).zip(&self.radius2);
        let b: SmallVec<[f64; 8]> =
            terms.map(|((y, y2), r2)| k * y2 + by_height * y + constant - v.y * v.y * r2).collect();
        bernstein_roots(&b, &mut |at| {
            let s = (blend(&self.height, at) - o.y) / v.y;
            if v.y.abs() > STEEP {
                tell(s, at);
                return false;
            }
            // The nearest of the two places as far from the axis.
            let c = q - blend(&self.radius2, at);
            if let Some((s1, s2)) = stable_pair(k, m, c, (m * m - k * c).max(0.0)) {
                tell(if (s - s1).abs() < (s - s2).abs() { s1 } else { s2 }, at);
            }
            false
        });
    }

    /// Of a level ray: where the segment is as high, two places on the ray are as far from the axis.
    fn level_hits(&self, line: &Line, tell: &mut dyn FnMut(f64, f64)) {
        let (o, v) = (line.o, line.v);
        let b: SmallVec<[f64; 8]> = self.height.iter().map(|y| y - o.y).collect();
        bernstein_roots(&b, &mut |at| {
            let (k, m) = (v.x * v.x + v.z * v.z, o.x * v.x + o.z * v.z);
            let c = o.x * o.x + o.z * o.z - blend(&self.radius2, at);
            if let Some((s1, s2)) = stable_pair(k, m, c, m * m - k * c) {
                tell(s1, at);
                tell(s2, at);
            }
            false
        });
    }
}

/// The largest value of a function with these Bernstein coefficients, of a degree up to 3, on [0, 1]; at least 0.
pub fn widest(b: &[f64]) -> f64 {
    let inner = turns(b).into_iter().flatten().map(|t| blend(b, t));
    inner.chain([b[0], b[b.len() - 1]]).fold(0.0, f64::max)
}
