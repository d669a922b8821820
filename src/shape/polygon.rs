//! `polygon { number_of_points, point_1, point_2, … }`: a flat piece with any outline; it has no inside.
//!
//! A point that repeats the first one closes an outline, and the next point starts another: where an even number of
//! outlines overlap, there is a hole. Points of two numbers lie at z = 0. All points must lie in one plane.
//!
//! ```pov
//! polygon { 10, <0,0> <4,0> <4,4> <0,4> <0,0>  <1,1> <3,1> <3,3> <1,3> <1,1> pigment { color rgb 1 } }
//! ```

use super::{Hit, Hits, Kernel, check_finite, pov_bounds, transformed_box};
use crate::diagnostic::{Diagnostic, Result, codes};
use crate::math::{Aabb, DVec2, DVec3, Range, Ray, Transform, tolerance};
use crate::source::Span;
use crate::value::{Param, Readable, Reader, Spec, Value, ValueKind};
use serde::Serialize;

/// Polygon: one or more outlines in a plane.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Polygon {
    /// Points of each outline of the polygon; the first is not repeated at the end.
    pub outlines: Vec<Vec<DVec3>>,
    /// Normal of the polygon, of length 1; zero if the points are collinear or not coplanar, and then nothing is
    /// rendered.
    pub normal: DVec3,
    /// Index of the axis along which the polygon is projected: the one nearest to the normal.
    drop: usize,
    /// All sides of the projected polygon.
    #[serde(skip)]
    sides: Vec<[DVec2; 2]>,
    /// Reason why the polygon is not rendered; `None` if it is.
    #[serde(skip)]
    fault: Option<&'static str>,
    /// True if the polygon's last outline is not closed.
    #[serde(skip)]
    unclosed: bool,
}

impl Polygon {
    /// Creates a polygon from points; a repeated first point ends an outline.
    pub fn new(points: &[DVec3]) -> Self {
        let (outlines, unclosed) = outlines_and_is_unclosed(points);
        let area = outlines.iter().map(|o| vector_area(o)).max_by(|a, b| a.length().total_cmp(&b.length()));
        let area = area.unwrap_or_default().normalize_or_zero();
        let normal = if normal_of_first_turn(points).dot(area) < 0.0 { -area } else { area };
        let off_plane = |p: &DVec3| (*p - points[0]).dot(normal).abs() > tolerance::FLAT;
        let fault = match () {
            () if normal == DVec3::ZERO => Some("has no area"),
            () if points.iter().any(off_plane) => Some("is not flat: its points are not in one plane"),
            () => None,
        };
        let drop = normal.abs().max_position();
        let sides = outlines.iter().flat_map(|outline| {
            let next = outline.iter().cycle().skip(1);
            outline.iter().zip(next).map(|(a, b)| [project_along_axis(*a, drop), project_along_axis(*b, drop)])
        });
        Self { sides: sides.collect(), outlines, normal, drop, fault, unclosed }
    }

    /// True if the half-line from the point along +x crosses an odd number of the polygon's sides (lecture,
    /// "Point-in-polygon problem"). A side includes its lower end but not its upper end, so that a corner is crossed
    /// once.
    fn contains_projected(&self, p: DVec2) -> bool {
        let mut odd = false;
        for [a, b] in &self.sides {
            if (a.y <= p.y) != (b.y <= p.y) {
                // s = (y₀ - yᵢ)/(yᵢ₊₁ - yᵢ) gives the x of the crossing
                let s = (p.y - a.y) / (b.y - a.y);
                odd ^= p.x < a.x + s * (b.x - a.x);
            }
        }
        odd
    }
}

/// Projects a point along the coordinate axis with index `axis`.
fn project_along_axis(p: DVec3, axis: usize) -> DVec2 {
    DVec2::new(p[(axis + 1) % 3], p[(axis + 2) % 3])
}

/// Splits a polygon's points where an outline returns to its first point; also returns true if the last outline does
/// not.
fn outlines_and_is_unclosed(points: &[DVec3]) -> (Vec<Vec<DVec3>>, bool) {
    let mut outlines = vec![];
    let mut current: Vec<DVec3> = vec![];
    for &p in points {
        match current.first() {
            Some(first) if (p - first).abs().max_element() <= tolerance::SAME_POINT => {
                outlines.push(std::mem::take(&mut current));
            }
            _ => current.push(p),
        }
    }
    let unclosed = !current.is_empty();
    outlines.extend(unclosed.then_some(current));
    (outlines, unclosed)
}

/// Returns the normal of a polygon by the first point, the first that differs, and the first that is not collinear with
/// both (quirk: `polygon_side`).
fn normal_of_first_turn(points: &[DVec3]) -> DVec3 {
    let sides = points.iter().map(|p| *p - points[0]);
    let Some(first) = sides.clone().find(|side| side.length() > tolerance::SAME_POINT) else { return DVec3::ZERO };
    let turns = |side: &DVec3| first.cross(*side).length() > tolerance::FLAT * first.length() * side.length();
    sides.clone().find(turns).map_or(DVec3::ZERO, |second| first.cross(second))
}

/// Half the sum of the cross products around a polygon's outline: its length is the area, its direction a normal.
fn vector_area(outline: &[DVec3]) -> DVec3 {
    let Some(&first) = outline.first() else { return DVec3::ZERO };
    let corners = outline.windows(2).map(|w| (w[0] - first).cross(w[1] - first));
    let area = 0.5 * corners.sum::<DVec3>();
    let size = Aabb::from_points(outline.iter().copied()).size().length();
    // A smaller area is rounding noise.
    if area.length() > 1e-14 * size * size { area } else { DVec3::ZERO }
}

/// Reads a point of a polygon: two or three numbers, or one number for all three.
fn read_point(r: &mut dyn Reader) -> Result<DVec3> {
    let (value, span) = r.value()?;
    let point = match value {
        Value::Float(x) => DVec3::splat(x),
        Value::Vector(v) if v.len <= 3 => v.xyz(),
        other => {
            let message = format!("expected a point of two or three numbers, found {}", other.describe());
            return Diagnostic::err(codes::WRONG_TYPE, span, message);
        }
    };
    check_finite(span, &[point], &[])?;
    Ok(point)
}

impl Readable for Polygon {
    const SPEC: Spec = Spec {
        name: "polygon",
        summary: "a flat piece with any outline, which may have holes",
        params: &[
            Param { name: "number_of_points", kind: ValueKind::Float, summary: "how many follow, at least three" },
            Param { name: "points", kind: ValueKind::Vectors, summary: "repeating the first one closes an outline" },
        ],
        ..Spec::EMPTY
    };

    fn read(r: &mut dyn Reader) -> Result<Self> {
        let span = r.span();
        let count = r.float()?.floor();
        if !(3.0..=f64::from(u32::MAX)).contains(&count) {
            let message = format!("a `polygon` needs at least three points, this one has {count}");
            let help = "the first number says how many points follow";
            return Err(Diagnostic::new(codes::FEW_POINTS, span, message).help(help).into());
        }
        let points = (0..count as u32).map(|_| read_point(r)).collect::<Result<Vec<_>>>()?;
        Ok(Self::new(&points))
    }

    fn complete_and_check(&mut self, span: Span, r: &mut dyn Reader) -> Result<()> {
        if self.unclosed {
            let message = "the last outline of this `polygon` is not closed; it is closed now";
            let help = "repeat the first point of the outline at its end, and count it";
            r.report(Diagnostic::new(codes::OPEN_OUTLINE, span, message).help(help));
        }
        if let Some(fault) = self.fault {
            let message = format!("this `polygon` {fault}, so it is left out");
            r.report(Diagnostic::new(codes::NOT_FLAT, span, message));
        }
        Ok(())
    }
}

impl Kernel for Polygon {
    fn bounds(&self) -> Aabb {
        let points = self.outlines.iter().flatten().copied();
        if self.fault.is_some() { Aabb::EMPTY } else { Aabb::from_points(points) }
    }

    fn bounds_under(&self, m: &Transform) -> Aabb {
        let points = self.outlines.iter().flatten().map(|p| m.transform_point(*p));
        if self.fault.is_some() { Aabb::EMPTY } else { Aabb::from_points(points) }
    }

    fn pov_bounds(&self, m: &Transform) -> Aabb {
        let (thick, b) = (self.normal.abs() * pov_bounds::THIN, self.bounds());
        transformed_box(m, &Aabb { min: b.min - thick, max: b.max + thick })
    }

    fn hits(&self, ray: &Ray, range: Range, out: &mut Hits) {
        out.extend(self.closest(ray, range));
    }

    fn closest(&self, ray: &Ray, range: Range) -> Option<Hit> {
        // Intersect the plane of the polygon, then test whether the point is within the outlines.
        let t = self.normal.dot(self.outlines[0][0] - ray.origin) / self.normal.dot(ray.dir);
        let found = self.fault.is_none()
            && range.contains(t)
            && self.contains_projected(project_along_axis(ray.at(t), self.drop));
        found.then(|| Hit::on_single_piece(t))
    }

    fn inside(&self, _: DVec3) -> bool {
        false
    }

    fn is_open(&self) -> bool {
        true
    }

    fn normal(&self, _: DVec3, _: &Hit) -> DVec3 {
        self.normal
    }

    /// Surface coordinates of a polygon: the two coordinates of the projection. POV-Ray defines no uv mapping for
    /// polygons.
    fn uv(&self, p: DVec3, _: &Hit) -> DVec2 {
        project_along_axis(p, self.drop)
    }

    fn has_uv_mapping(&self) -> bool {
        false
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::fp;
    use crate::shape::testing::read_shape;

    /// True if a ray hits at (x, y) of the plane that was rotated about x = y = z.
    fn at(shape: &Polygon, x: f64, y: f64) -> bool {
        shape.closest(&Ray::new(DVec3::new(x, y, -4.0), DVec3::Z * 2.0), Range::FORWARD).is_some_and(|h| h.t == 2.0)
    }

    fn flat(points: &[(f64, f64)]) -> Polygon {
        Polygon::new(&points.iter().map(|&(x, y)| DVec3::new(x, y, 0.0)).collect::<Vec<_>>())
    }

    #[test]
    fn concave() {
        // An arrow head: the notch at (2, 1) is outside.
        let arrow = flat(&[(0.0, 0.0), (2.0, 1.0), (4.0, 0.0), (2.0, 4.0), (0.0, 0.0)]);
        assert!(at(&arrow, 2.0, 1.5) && at(&arrow, 0.5, 0.5) && at(&arrow, 3.5, 0.5));
        assert!(!at(&arrow, 2.0, 0.5) && !at(&arrow, -0.5, 0.0) && !at(&arrow, 1.0, 4.0));
    }

    #[test]
    fn hole_from_the_manual() {
        let p = "12 <0,0> <0,6> <4,6> <4,3> <1,3> <1,0> <0,0> <1,4> <1,5> <3,5> <3,4> <1,4>";
        let (letter, reports) = read_shape::<Polygon>(p);
        let letter = letter.unwrap();
        assert!(reports.is_empty() && letter.outlines.len() == 2);
        assert!(at(&letter, 0.5, 1.0) && at(&letter, 2.0, 3.5) && at(&letter, 3.5, 4.5));
        assert!(!at(&letter, 2.0, 4.5) && !at(&letter, 2.0, 1.0));
        assert!(at(&letter, 0.5, 3.0) && at(&letter, 0.5, 4.0), "level with corners");
    }

    #[test]
    fn star() {
        // A pentagram: its centre is crossed twice, so it is a hole.
        let corner = |k: usize| {
            let a = std::f64::consts::TAU * k as f64 / 5.0;
            (fp::sin(a), fp::cos(a))
        };
        let star = flat(&[0, 2, 4, 1, 3, 0].map(corner));
        assert!(!at(&star, 0.0, 0.0) && at(&star, 0.0, 0.8) && !at(&star, 0.0, -0.5));
        let (x, y) = corner(1);
        assert!(at(&star, 0.8 * x, 0.8 * y));
    }

    #[test]
    fn any_plane() {
        // x + y + z = 1, of which two coordinates are used.
        let tilted = Polygon::new(&[DVec3::X, DVec3::Y, DVec3::Z, DVec3::X]);
        let hit = tilted.closest(&Ray::new(DVec3::ONE, -DVec3::ONE), Range::FORWARD).unwrap();
        assert!((hit.t - 2.0 / 3.0).abs() < 1e-15);
        assert_eq!(tilted.closest(&Ray::new(DVec3::ONE * 2.0, DVec3::new(-1.0, -1.0, -4.0)), Range::FORWARD), None);
        for axis in DVec3::AXES {
            let (i, j) = axis.any_orthonormal_pair();
            let square = Polygon::new(&[i + j, i - j, -i - j, j - i, i + j]);
            assert!(square.closest(&Ray::new(axis * 3.0 + 0.9 * i - 0.9 * j, -axis), Range::FORWARD).is_some());
            assert!(square.closest(&Ray::new(axis * 3.0 + 1.1 * i, -axis), Range::FORWARD).is_none());
        }
    }

    #[test]
    fn reports() {
        assert_eq!(read_shape::<Polygon>("2 0 1").0.unwrap_err().code, codes::FEW_POINTS);
        assert_eq!(read_shape::<Polygon>("3 <0,0> <1,0> <0,1>").1[0].code, codes::OPEN_OUTLINE);
        assert_eq!(read_shape::<Polygon>("4 <0,0> <1,0> <2,0> <0,0>").1[0].code, codes::NOT_FLAT);
        let bent = read_shape::<Polygon>("5 0 <1,0,0> <1,1,0> <0,1,1e-6> 0");
        assert_eq!(bent.1[0].code, codes::NOT_FLAT);
        assert!(bent.0.unwrap().bounds().is_empty());
        assert!(read_shape::<Polygon>("5 0 <1,0,0> <1,1,0> <0,1,1e-12> 0").1.is_empty());
        assert!(read_shape::<Polygon>("4.7 0 <1,0,0> <1,1,0> 0").1.is_empty());
    }
}
