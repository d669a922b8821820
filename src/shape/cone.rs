//! `cone { base_point, base_radius, cap_point, cap_radius }`: a cone, or one with its tip cut off.
//!
//! `open` takes the discs at the ends away. Radii of different sign make an hourglass; two negative ones make a cylinder of the
//! smaller radius, and one that is negative with 0 makes nothing, as in POV-Ray 3.7.
//!
//! ```pov
//! cone { <0, 0, 0>, 1, <0, 2, 0>, 0 pigment { color rgb <0.9, 0.8, 0.5> } }
//! ```

use super::frustum::{Frustum, OPEN, frustum_kernel};
use super::{Hit, Hits, check_finite};
use crate::diagnostic::{Diagnostic, Result, codes};
use crate::math::{Aabb, DVec2, DVec3, Range, Ray};
use crate::source::Span;
use crate::value::words::{Row, set, specs};
use crate::value::{Param, Readable, Reader, Spec, ValueKind};
use serde::Serialize;

/// Cone or frustum of a cone.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Cone(pub Frustum);

impl Cone {
    /// Creates the cone between two different points.
    pub fn new(base: DVec3, mut base_radius: f64, cap: DVec3, mut cap_radius: f64, open: bool) -> Self {
        // quirk: cone_negative_radii
        let largest = base_radius.max(cap_radius);
        if largest <= 0.0 {
            (base_radius, cap_radius) = (largest.abs(), largest.abs());
        }
        Self(Frustum::new(base, cap, base_radius, cap_radius, open))
    }
}

impl Readable for Cone {
    const SPEC: Spec = Spec {
        name: "cone",
        summary: "a cone, or one with its tip cut off",
        params: &[
            Param { name: "base_point", kind: ValueKind::Vector, summary: "the middle of one end" },
            Param { name: "base_radius", kind: ValueKind::Float, summary: "the radius there" },
            Param { name: "cap_point", kind: ValueKind::Vector, summary: "the middle of the other end" },
            Param { name: "cap_radius", kind: ValueKind::Float, summary: "the radius there; 0 makes a tip" },
        ],
        words: specs!(Self::WORDS),
        ..Spec::EMPTY
    };

    const WORDS: &'static [Row<Self>] = &[OPEN.sets(|s, _| set(&mut s.0.open, Ok(true)))];

    fn read(r: &mut dyn Reader) -> Result<Self> {
        let span = r.span();
        let (base, base_radius, cap) = (r.vector()?, r.float()?, r.vector()?);
        let span = span.to(r.span());
        let cap_radius = r.float()?;
        check_finite(span, &[base, cap], &[base_radius, cap_radius])?;
        super::check_frustum_ends(span, base, cap)?;
        Ok(Self::new(base, base_radius, cap, cap_radius, false))
    }

    fn complete_and_check(&mut self, span: Span, r: &mut dyn Reader) -> Result<()> {
        if self.0.is_empty() {
            r.report(Diagnostic::new(codes::NO_SURFACE, span, "a `cone` whose larger radius is 0 has no surface"));
        }
        Ok(())
    }
}

frustum_kernel!(Cone);

#[cfg(test)]
mod tests {
    use super::*;
    use crate::shape::Kernel;
    use crate::shape::frustum::{BASE, CAP, WALL};
    use crate::shape::testing::{all_hits, assert_hits, read_shape};

    #[test]
    fn packets_match_single_rays() {
        for (radius, open) in [(0.0, false), (0.2, false), (0.9, true), (-0.5, false)] {
            crate::shape::testing::assert_packets_match_single_rays(&Cone::new(
                DVec3::new(0.1, -0.8, 0.0),
                0.8,
                DVec3::new(-0.3, 0.7, 0.5),
                radius,
                open,
            ));
            crate::shape::testing::assert_packets_match_single_rays(&Cone::new(
                DVec3::NEG_Y,
                0.8,
                DVec3::Y,
                radius,
                open,
            ));
        }
    }

    #[test]
    fn cone_with_tip() {
        // The radius is (1 - y)/2.
        let cone = Cone::new(-DVec3::Y, 1.0, DVec3::Y, 0.0, false);
        let ray = Ray::new(DVec3::new(0.0, 0.0, -5.0), DVec3::Z);
        assert_hits(&all_hits(&cone, &ray), &[(4.5, WALL), (5.5, WALL)]);
        // POV-Ray's trace().
        let n = cone.normal(ray.at(4.5), &Hit::on_piece(4.5, WALL)).normalize();
        assert!(n.distance(DVec3::new(0.0, 0.2_f64.sqrt(), -0.8_f64.sqrt())) < 1e-12);
        // Through the apex along the axis; parallel to the wall.
        let down = all_hits(&cone, &Ray::new(DVec3::Y * 5.0, -DVec3::Y));
        assert!(down.iter().any(|h| h.t == 4.0) && down.iter().any(|h| h.t == 6.0 && h.part == BASE));
        // Parallel to the wall on the other side: x = -0.5 - t/2 meets x = -(1 - y)/2 at t = 3/4.
        let parallel = Ray::new(DVec3::new(-0.5, -1.5, 0.0), DVec3::new(-0.5, 1.0, 0.0));
        assert_hits(&all_hits(&cone, &parallel), &[(0.5, BASE), (0.75, WALL)]);
        assert!(cone.normal(DVec3::Y, &Hit::on_piece(4.0, WALL)).length() > 0.0, "the tip has some normal");
    }

    #[test]
    fn hourglass() {
        let glass = Cone::new(-DVec3::Y, -1.0, DVec3::Y, 1.0, false);
        let across = |y: f64| all_hits(&glass, &Ray::new(DVec3::new(0.0, y, -5.0), DVec3::Z));
        assert_hits(&across(0.5), &[(4.5, WALL), (5.5, WALL)]);
        assert_hits(&across(-0.25), &[(4.75, WALL), (5.25, WALL)]);
        assert!(glass.inside(DVec3::Y * 0.5) && !glass.inside(DVec3::X * 0.1));
        // Along the axis through both halves.
        let ray = Ray::new(DVec3::new(0.5, -3.0, 0.0), DVec3::Y);
        assert_hits(&all_hits(&glass, &ray), &[(2.0, BASE), (2.5, WALL), (3.5, WALL), (4.0, CAP)]);
    }

    #[test]
    fn negative_radii() {
        let cylinder = Cone::new(-DVec3::Y, 0.2, DVec3::Y, 0.2, false);
        assert_eq!(Cone::new(-DVec3::Y, -0.5, DVec3::Y, -0.2, false), cylinder);
        assert_eq!(Cone::new(-DVec3::Y, -0.2, DVec3::Y, -0.5, false), cylinder);
        assert!(Cone::new(-DVec3::Y, 0.0, DVec3::Y, -0.5, false).0.is_empty());
    }

    #[test]
    fn reading() {
        let shape = read_shape::<Cone>("0 1 <0,1,0> 0.5 open").0.unwrap();
        assert_eq!(shape, Cone::new(DVec3::ZERO, 1.0, DVec3::Y, 0.5, true));
        assert_eq!(read_shape::<Cone>("0 1 0 0").0.unwrap_err().code, codes::NO_LENGTH);
        assert_eq!(read_shape::<Cone>("0 0 1 0").1[0].code, codes::NO_SURFACE);
    }
}
