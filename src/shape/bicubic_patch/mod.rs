//! `bicubic_patch { type u_steps v_steps points … }`: a curved sheet that sixteen points pull at (manual, "Bicubic Patch").
//!
//! The points are four rows of four; the sheet touches those at its corners (Farin, Curves and Surfaces, 1988, on Bézier patches). It is
//! halved `u_steps` times between the rows and `v_steps` times along them, or until the pieces are as flat as `flatness` says; each
//! piece is drawn as two triangles with smooth normals, as in POV-Ray 3.7.
//!
//! ```pov
//! bicubic_patch {
//!   type 1 u_steps 4 v_steps 4
//!   <-1, 0, -1>, <-0.3, 1, -1>, <0.3, 1, -1>, <1, 0, -1>, <-1, 1, -0.3>, <-0.3, 2, -0.3>, <0.3, 2, -0.3>, <1, 1, -0.3>
//!   <-1, 1, 0.3>, <-0.3, 2, 0.3>, <0.3, 2, 0.3>, <1, 1, 0.3>, <-1, 0, 1>, <-0.3, 1, 1>, <0.3, 1, 1>, <1, 0, 1>
//!   pigment { color rgb <0.8, 0.7, 0.3> }
//! }
//! ```

mod net;

use super::{Hit, Hits, Kernel, Quirks, Shape, Triangle, check_finite};
use crate::diagnostic::{Diagnostic, Result, codes};
use crate::math::bvh::{self, Bvh};
use crate::math::{Aabb, DVec2, DVec3, Range, Ray, Sheared, Transform};
use crate::source::Span;
use crate::value::words::word;
use crate::value::{Param, Readable, Reader, ReaderExt, Spec, ValueKind};
use net::{Corner, Net, Steps};
use rustc_hash::FxHashMap;
use serde::Serialize;
use std::ops::ControlFlow;

/// Maximum number of subdivisions of a bicubic patch in one direction.
const MOST_STEPS: u32 = 10;
/// Maximum number of subdivisions of a bicubic patch in both directions together.
const MOST_OF_BOTH: u32 = 16;

/// A bicubic Bézier patch.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct BicubicPatch {
    /// Control points of the bicubic patch, four rows of four.
    pub points: [DVec3; 16],
    /// Maximum subdivisions of the bicubic patch between the rows of control points.
    pub u_steps: u32,
    /// Maximum subdivisions of the bicubic patch along the rows of control points.
    pub v_steps: u32,
    /// Flatness at which a piece of the bicubic patch is not subdivided.
    pub flatness: f64,
    /// Surface coordinates of the bicubic patch's corners: start and end of the first row, end and start of the last
    /// row.
    pub uvs: [DVec2; 4],
    #[serde(skip)]
    corners: Vec<Corner>,
    /// Indices of the corners of each flat cell of the bicubic patch: first and last of the first row, first and last
    /// of the last row.
    #[serde(skip)]
    cells: Vec<[u32; 4]>,
    /// Hierarchy over the bicubic patch's cells, which are in its order.
    #[serde(skip)]
    bvh: Bvh,
    #[serde(skip)]
    bounds: Aabb,
}

/// Corners of both triangles of a bicubic patch's cell: each starts at the cell's first corner and contains its last.
const TRIANGLES: [[usize; 3]; 2] = [[0, 1, 3], [0, 3, 2]];

impl BicubicPatch {
    /// Creates a bicubic patch with these control points.
    pub fn new(points: [DVec3; 16], u_steps: u32, v_steps: u32, flatness: f64) -> Self {
        let corners = [DVec2::ZERO, DVec2::X, DVec2::ONE, DVec2::Y];
        Self {
            points,
            u_steps,
            v_steps,
            flatness,
            uvs: corners,
            corners: vec![],
            cells: vec![],
            bvh: Bvh::default(),
            bounds: Aabb::EMPTY,
        }
        .subdivided_under(&Transform::IDENTITY)
    }

    /// Subdivides the bicubic patch; flatness and normals are evaluated under the transform M (quirk:
    /// `patch_under_transform`).
    fn subdivided_under(mut self, m: &Transform) -> Self {
        let rows = self.u_steps.min(MOST_STEPS);
        let columns = self.v_steps.min(MOST_STEPS);
        let columns = columns.min(MOST_OF_BOTH - rows.min(MOST_OF_BOTH));
        let mut known: FxHashMap<[u64; 5], u32> = FxHashMap::default();
        let (mut corners, mut cells): (Vec<Corner>, Vec<[u32; 4]>) = (vec![], vec![]);
        let still = m.is_identity();
        let image = Net(self.points.map(|p| if still { p } else { m.transform_point(p) }));
        image.subdivide(Steps { rows, columns, flatness: self.flatness }, &mut |leaf| {
            let cell = leaf.map(|mut corner| {
                if !still {
                    let (point, normal) =
                        (m.inverse_transform_point(corner.point), m.inverse_transform_normal(corner.normal));
                    corner = Corner { point, normal, ..corner };
                }
                // (Where an edge collapses to a point, neighbouring pieces can have different normals there.)
                let ([u, v], [x, y, z]) = (corner.place.to_array(), corner.normal.to_array());
                *known.entry([u, v, x, y, z].map(f64::to_bits)).or_insert_with(|| {
                    corners.push(corner);
                    corners.len() as u32 - 1
                })
            });
            cells.push(cell);
        });
        let of = |cell: &[u32; 4]| Aabb::from_points(cell.map(|i| corners[i as usize].point));
        cells.retain(|cell| bvh::fits_single_precision(&of(cell)));
        let (bvh, order) = Bvh::build(cells.iter().map(of));
        self.cells = order.into_iter().map(|i| cells[i as usize]).collect();
        self.bounds = self.cells.iter().map(of).fold(Aabb::EMPTY, Aabb::union);
        (self.corners, self.bvh) = (corners, bvh);
        self
    }
}

impl BicubicPatch {
    /// Interpolates values of the corners of a bicubic patch's triangle at a hit.
    fn interpolate_corners<T>(&self, hit: &Hit, value: impl Fn(&Corner) -> T) -> T
    where
        T: std::ops::Mul<f64, Output = T> + std::ops::Add<Output = T>,
    {
        let cell = self.cells[hit.part as usize / 2];
        let [a, b, c] = TRIANGLES[hit.part as usize % 2].map(|k| value(&self.corners[cell[k] as usize]));
        a * (1.0 - hit.uv.x - hit.uv.y) + b * hit.uv.x + c * hit.uv.y
    }

    /// Calls `visit` with each hit of a ray on the bicubic patch in the range; `visit` returns the distance up to which
    /// hits are still of interest.
    fn visit_hits(&self, ray: &Ray, range: Range, mut visit: impl FnMut(Hit) -> ControlFlow<(), f64>) {
        let sheared = Sheared::new(ray);
        self.bvh.traverse(ray, range, |cell, mut max| {
            let corners = self.cells[cell].map(|i| self.corners[i as usize].point);
            for (k, triangle) in TRIANGLES.iter().enumerate() {
                if let Some((t, uv)) = sheared.intersect(triangle.map(|i| corners[i]))
                    && t > range.min
                    && t < max
                {
                    max = visit(Hit { t, part: (2 * cell + k) as u32, uv })?;
                }
            }
            ControlFlow::Continue(max)
        });
    }
}

impl Readable for BicubicPatch {
    const SPEC: Spec = Spec {
        name: "bicubic_patch",
        summary: "a curved sheet that sixteen points pull at",
        params: &[Param { name: "points", kind: ValueKind::Vectors, summary: "sixteen: four rows of four" }],
        words: &[
            word("type", ValueKind::Float, "", "0 or 1: what POV-Ray keeps in memory; durer draws both alike"),
            word("u_steps", ValueKind::Float, "0", "how often it is halved between the rows"),
            word("v_steps", ValueKind::Float, "0", "how often it is halved along the rows"),
            word("flatness", ValueKind::Float, "0", "pieces are not halved that no point pulls further than this"),
            word("uv_vectors", ValueKind::Vectors, "", "surface coordinates of the four corners, for `uv_mapping`"),
        ],
        ..Spec::EMPTY
    };

    fn read(r: &mut dyn Reader) -> Result<Self> {
        let (mut kind, mut steps, mut flatness) = (None, [0.0; 2], 0.0);
        let mut patch = Self::new([DVec3::ZERO; 16], 0, 0, 0.0);
        loop {
            let span = r.span();
            if r.accept("type")? {
                kind = Some(read_and_check_type(span, r)?);
            } else if r.accept("u_steps")? {
                steps[0] = r.float()?;
            } else if r.accept("v_steps")? {
                steps[1] = r.float()?;
            } else if r.accept("flatness")? {
                flatness = r.float()?;
            } else if r.accept("uv_vectors")? {
                for uv in &mut patch.uvs {
                    *uv = r.vector2()?;
                }
            } else {
                break;
            }
        }
        let span = r.span();
        if kind.is_none() {
            let message = "this `bicubic_patch` does not say its `type`";
            return Err(Diagnostic::new(codes::EXPECTED, span, message).help("put `type 1` before its points").into());
        }
        for point in &mut patch.points {
            *point = r.vector()?;
        }
        check_finite(span, &patch.points, &[flatness, steps[0], steps[1]])?;
        // (The cast saturates at 0 and at the largest number.)
        [patch.u_steps, patch.v_steps] = steps.map(|steps| steps as u32);
        Ok(Self { flatness, ..patch }.subdivided_under(&Transform::IDENTITY))
    }

    fn complete_and_check(&mut self, span: Span, r: &mut dyn Reader) -> Result<()> {
        let has_area = |cell: &[u32; 4]| {
            let corners = cell.map(|i| self.corners[i as usize].point);
            TRIANGLES.iter().any(|t| !Triangle::new(corners[t[0]], corners[t[1]], corners[t[2]]).is_degenerate())
        };
        if !self.cells.iter().any(has_area) {
            r.report(Diagnostic::new(codes::NO_SURFACE, span, "this `bicubic_patch` has no area"));
        }
        Ok(())
    }
}

/// Reads the type of a bicubic patch, 0 or 1; other numbers count as 1, as in POV-Ray.
fn read_and_check_type(span: Span, r: &mut dyn Reader) -> Result<()> {
    let kind = r.float()?;
    if kind >= 0.0 {
        return Ok(());
    }
    Diagnostic::err(codes::BAD_ARGUMENT, span, format!("the `type` of a `bicubic_patch` is 0 or 1, not {kind}"))
}

impl Kernel for BicubicPatch {
    const QUIRKS: Quirks = Quirks { ignores_clipping: true, ..Quirks::NONE };

    fn bounds(&self) -> Aabb {
        self.bounds
    }

    fn bounds_under(&self, m: &Transform) -> Aabb {
        Aabb::from_points(self.cells.iter().flatten().map(|&i| m.transform_point(self.corners[i as usize].point)))
    }

    /// Box of the bicubic patch's control points (quirk: `extent_boxes`).
    fn pov_bounds(&self, m: &Transform) -> Aabb {
        Aabb::from_points(self.points.iter().map(|p| m.transform_point(*p)))
    }

    fn hits(&self, ray: &Ray, range: Range, out: &mut Hits) {
        self.visit_hits(ray, range, |hit| {
            out.push(hit);
            ControlFlow::Continue(range.max)
        });
    }

    fn closest(&self, ray: &Ray, range: Range) -> Option<Hit> {
        let mut best = None;
        self.visit_hits(ray, range, |hit| {
            best = Some(hit);
            ControlFlow::Continue(hit.t)
        });
        best
    }

    fn any_hit(&self, ray: &Ray, range: Range) -> bool {
        let mut found = false;
        self.visit_hits(ray, range, |_| {
            found = true;
            ControlFlow::Break(())
        });
        found
    }

    fn inside(&self, _: DVec3) -> bool {
        false
    }

    fn normal(&self, _: DVec3, hit: &Hit) -> DVec3 {
        let sum = self.interpolate_corners(hit, |corner| corner.normal);
        if sum == DVec3::ZERO { DVec3::X } else { sum }
    }

    fn uv(&self, _: DVec3, hit: &Hit) -> DVec2 {
        let place = self.interpolate_corners(hit, |corner| corner.place);
        let [a, b, c, d] = self.uvs;
        a.lerp(b, place.x).lerp(d.lerp(c, place.x), place.y)
    }

    fn is_open(&self) -> bool {
        true
    }

    fn adapted_to_transform(&self, m: &Transform) -> Option<Shape> {
        let [x, y, z] = DVec3::AXES.map(|axis| m.transform_vector(axis));
        let size = x.length_squared();
        let near = |a: f64, b: f64| (a - b).abs() <= 1e-12 * size;
        let even = near(y.length_squared(), size) && near(z.length_squared(), size);
        let straight = near(x.dot(y), 0.0) && near(y.dot(z), 0.0) && near(z.dot(x), 0.0);
        // A similarity transform leaves the subdivision unchanged.
        let alike = even && straight && x.cross(y).dot(z) > 0.0 && (self.flatness <= 0.0 || near(size, 1.0));
        (!alike).then(|| self.clone().subdivided_under(m).into())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::shape::testing::{all_hits, read_shape};

    /// Heights over a square of side 3, with height `a` by row and `b` by column.
    fn tent(a: f64, b: f64, steps: u32, flatness: f64) -> BicubicPatch {
        let inner = |k: usize| f64::from(u8::from(k == 1 || k == 2));
        let point = |k: usize| DVec3::new((k % 4) as f64, (k / 4) as f64, a * inner(k / 4) + b * inner(k % 4));
        BicubicPatch::new(std::array::from_fn(point), steps, steps, flatness)
    }

    fn height(patch: &BicubicPatch, x: f64, y: f64) -> f64 {
        patch.closest(&Ray::new(DVec3::new(x, y, -50.0), DVec3::Z), Range::FORWARD).unwrap().t - 50.0
    }

    /// All numbers from POV-Ray's `trace()`.
    #[test]
    fn as_flat_as_pov_ray_draws() {
        let near = |patch: BicubicPatch, want: [f64; 2]| {
            let found = [height(&patch, 0.01, 0.75), height(&patch, 0.75, 0.01)];
            assert!((found[0] - want[0]).abs() + (found[1] - want[1]).abs() < 1e-9, "{found:?} {want:?}");
        };
        near(tent(1.0, 0.2, 4, 1.3), [0.0, 0.0]);
        near(tent(1.0, 0.2, 4, 0.3), [0.376, 0.08]);
        near(tent(1.0, 0.2, 4, 0.2), [0.564, 0.12]);
        near(tent(0.2, 1.0, 4, 0.1), [0.12, 0.564]);
        near(tent(1.0, 0.0, 6, 0.0), [0.5625, 0.009843750]);
        // Flatness and normals are those of the scaled image.
        let far = Transform::scale(DVec3::new(1.0, 1.0, 5.0)).unwrap();
        let patch = tent(0.5, 0.1, 2, 0.99);
        let patch = patch.adapted_to_transform(&far).unwrap();
        let ray = Ray::new(DVec3::new(1.1, 0.7, -50.0), DVec3::Z);
        let hit = patch.closest(&ray, Range::FORWARD).unwrap();
        let n = far.transform_normal(patch.normal(ray.at(hit.t), &hit)).normalize();
        assert!((hit.t - 50.23).abs() < 1e-9 && n.distance(DVec3::new(0.058905, 0.594083, -0.802244)) < 1e-5, "{n}");
        assert!(patch.adapted_to_transform(&Transform::rotate(DVec3::splat(30.0))).is_none());
    }

    #[test]
    fn collapsed_edges() {
        let mut points = tent(1.0, 0.0, 0, 0.0).points;
        points[..4].fill(DVec3::ZERO);
        let patch = BicubicPatch::new(points, 0, 0, 0.0);
        // The normal is along x where the edge is one point.
        let hits = all_hits(&patch, &Ray::new(DVec3::new(0.1, 0.5, -5.0), DVec3::Z));
        assert_eq!(hits.len(), 1, "{hits:?}");
        let flat = |points| BicubicPatch::new(points, 1, 1, 100.0).cells.len();
        assert_eq!(flat(points), 1);
        for row in 0..4 {
            points[4 * row] = DVec3::ZERO;
        }
        assert_eq!(flat(points), 4, "no plane tells how flat it is");
        assert_eq!(flat([DVec3::ZERO; 16]), 4);
    }

    #[test]
    fn reading() {
        let points = "<0,0,0> <1,0,0> <2,0,0> <3,0,0> <0,1,0> <1,1,1> <2,1,0> <3,1,0> \
            <0,2,0> <1,2,0> <2,2,0> <3,2,0> <0,3,0> <1,3,0> <2,3,0> <3,3,0>";
        let made = |text: &str| read_shape::<BicubicPatch>(&format!("{text} {points}")).0;
        let patch = made("flatness 0 u_steps 2.7 type 1 v_steps -3").unwrap();
        assert_eq!((patch.u_steps, patch.v_steps, patch.cells.len()), (2, 0, 4));
        assert_eq!(made("type 1 u_steps 1e99 v_steps 1e99").unwrap().cells.len(), 1 << MOST_OF_BOTH);
        assert_eq!(made("type 0 flatness NaN").unwrap_err().code, codes::NOT_FINITE);
        assert_eq!(made("type -1").unwrap_err().code, codes::BAD_ARGUMENT);
        assert_eq!(made("u_steps 1").unwrap_err().code, codes::EXPECTED);
        let far = read_shape::<BicubicPatch>(&format!("type 1 {}", "<1e40,0,0> ".repeat(16)));
        assert_eq!(far.1[0].code, codes::NO_SURFACE);
    }

    #[test]
    fn watertight() {
        let patch = tent(1.0, 0.7, 4, 0.0);
        for k in 1..96 {
            for l in 1..96 {
                let p = DVec3::new(f64::from(k) / 32.0, f64::from(l) / 32.0, -9.0);
                assert!(patch.any_hit(&Ray::new(p, DVec3::Z), Range::FORWARD), "{p}");
            }
        }
    }
}
