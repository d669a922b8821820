//! `cylinder { base_point, cap_point, radius }`: a round bar between two points.
//!
//! `open` takes the discs at the ends away and leaves the tube.
//!
//! ```pov
//! cylinder { <0, 0, 0>, <0, 2, 0>, 0.5 open pigment { color rgb <0.5, 0.5, 0.6> } }
//! ```

use super::frustum::{Frustum, OPEN, frustum_kernel};
use super::{Hit, Hits, check_finite};
use crate::diagnostic::{Diagnostic, Result, codes};
use crate::math::{Aabb, DVec2, DVec3, Range, Ray};
use crate::source::Span;
use crate::value::words::{Row, set, specs};
use crate::value::{Param, Readable, Reader, Spec, ValueKind};
use serde::Serialize;

/// Cylinder, open or closed.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Cylinder(pub Frustum);

impl Cylinder {
    /// Creates the cylinder between two different points.
    pub fn new(base: DVec3, cap: DVec3, radius: f64, open: bool) -> Self {
        let radius = radius.abs();
        Self(Frustum::new(base, cap, radius, radius, open))
    }
}

impl Readable for Cylinder {
    const SPEC: Spec = Spec {
        name: "cylinder",
        summary: "a round bar between two points",
        params: &[
            Param { name: "base_point", kind: ValueKind::Vector, summary: "the middle of one end" },
            Param { name: "cap_point", kind: ValueKind::Vector, summary: "the middle of the other end" },
            Param { name: "radius", kind: ValueKind::Float, summary: "its sign does not matter" },
        ],
        words: specs!(Self::WORDS),
        ..Spec::EMPTY
    };

    const WORDS: &'static [Row<Self>] = &[OPEN.sets(|s, _| set(&mut s.0.open, Ok(true)))];

    fn read(r: &mut dyn Reader) -> Result<Self> {
        let span = r.span();
        let (base, cap) = (r.vector()?, r.vector()?);
        let span = span.to(r.span());
        let radius = r.float()?;
        check_finite(span, &[base, cap], &[radius])?;
        super::check_frustum_ends(span, base, cap)?;
        Ok(Self::new(base, cap, radius, false))
    }

    fn complete_and_check(&mut self, span: Span, r: &mut dyn Reader) -> Result<()> {
        if self.0.is_empty() {
            r.report(Diagnostic::new(codes::NO_SURFACE, span, "a `cylinder` of radius 0 has no surface"));
        }
        Ok(())
    }
}

frustum_kernel!(Cylinder);

#[cfg(test)]
mod tests {
    use super::*;
    use crate::shape::Kernel;
    use crate::shape::frustum::{BASE, CAP, WALL};
    use crate::shape::testing::{all_hits, assert_hits, read_shape};

    fn bar(open: bool) -> Cylinder {
        Cylinder::new(DVec3::ZERO, DVec3::Y * 2.0, 1.0, open)
    }

    #[test]
    fn packets_match_single_rays() {
        for open in [false, true] {
            crate::shape::testing::assert_packets_match_single_rays(&Cylinder::new(
                DVec3::new(0.1, -0.8, 0.0),
                DVec3::new(-0.3, 0.7, 0.5),
                0.6,
                open,
            ));
            crate::shape::testing::assert_packets_match_single_rays(&Cylinder::new(DVec3::NEG_Y, DVec3::Y, 0.6, open));
        }
    }

    #[test]
    fn across_and_along() {
        let ray = Ray::new(DVec3::new(-3.0, 1.0, 0.6), DVec3::X * 2.0);
        assert_hits(&all_hits(&bar(false), &ray), &[(1.1, WALL), (1.9, WALL)]);
        assert!(bar(false).normal(ray.at(1.1), &Hit::on_piece(1.1, WALL)).distance(DVec3::new(-0.8, 0.0, 0.6)) < 1e-12);
        let ray = Ray::new(DVec3::new(0.5, 5.0, 0.0), -DVec3::Y);
        assert_hits(&all_hits(&bar(false), &ray), &[(3.0, CAP), (5.0, BASE)]);
        assert_hits(&all_hits(&bar(true), &ray), &[]);
        // The ray enters by the cap at (0.5, 2) and leaves by the wall at (1, 1.5).
        let ray = Ray::new(DVec3::new(0.0, 2.5, 0.0), DVec3::new(1.0, -1.0, 0.0));
        assert_hits(&all_hits(&bar(false), &ray), &[(0.5, CAP), (1.0, WALL)]);
        assert_hits(&all_hits(&bar(true), &ray), &[(1.0, WALL)]);
    }

    #[test]
    fn far_eye() {
        let tilted = Cylinder::new(DVec3::new(1.0, 2.0, 3.0), DVec3::new(2.0, 2.0, 3.0), 0.5, false);
        let ray = Ray::new(DVec3::new(1.5, 2.3, 3.0 - 1e8), DVec3::Z);
        assert_hits(&all_hits(&tilted, &ray), &[(1e8 - 0.4, WALL), (1e8 + 0.4, WALL)]);
    }

    #[test]
    fn inside_of_open_and_closed() {
        // POV-Ray's `inside()`: the surface itself is outside, ends and wall of open cylinders are inside.
        assert!(bar(false).inside(DVec3::Y) && !bar(false).inside(DVec3::new(1.0, 1.0, 0.0)));
        assert!(bar(true).inside(DVec3::new(1.0, 1.0, 0.0)) && !bar(true).inside(DVec3::new(1.0 + 1e-9, 1.0, 0.0)));
        assert!(!bar(false).inside(DVec3::Y * 2.0) && bar(true).inside(DVec3::Y * 2.0));
        assert!(!bar(true).inside(DVec3::Y * 2.01));
    }

    #[test]
    fn reading() {
        let (shape, words) = read_shape::<Cylinder>("0 <0,2,0> -1 open");
        assert_eq!(shape.unwrap(), bar(true));
        assert!(words.is_empty());
        assert_eq!(read_shape::<Cylinder>("1 1 1").0.unwrap_err().code, codes::NO_LENGTH);
        assert_eq!(read_shape::<Cylinder>("0 1 0").1[0].code, codes::NO_SURFACE);
    }
}
