//! `warp { cylindrical }`, `spherical`, `toroidal`, `planar`, `cubic`: wrap the xy plane of a pattern around a surface,
//! as image maps do (manual, "Mapping using warps").
//!
//! ```pov
//! sphere { 0, 1 pigment { checker color rgb 1, color rgb <0.6, 0, 0> scale 1/8 warp { spherical } } }
//! ```

use super::super::{Cells, Cubic};
use super::Bend;
use crate::diagnostic::Result;
use crate::math::{DVec3, fp};
use crate::value::words::{Row, set, specs, word};
use crate::value::{Next, Param, Readable, Reader, Spec, ValueKind, WordSpec};
use serde::Serialize;
use std::f64::consts::{PI, TAU};

/// Orientation of the pattern's plane in a mapping warp, and growth of the plane with the distance.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct PlaneLayout {
    /// Direction of the pattern that is the depth of a mapping warp, a unit vector or zero. The plane is unchanged for z
    /// and rotated for x and y; other directions mirror or shear the plane (quirk: `warp_orientation`), and zero maps all
    /// points to the origin.
    pub orientation: DVec3,
    /// Exponent of the distance with which the pattern's plane grows in a mapping warp.
    pub dist_exp: f64,
}

impl Default for PlaneLayout {
    fn default() -> Self {
        Self { orientation: DVec3::Z, dist_exp: 0.0 }
    }
}

const ORIENTATION: WordSpec =
    word("orientation", ValueKind::Vector, "z", "along which axis of the pattern its depth lies");

const DIST_EXP: WordSpec = word("dist_exp", ValueKind::Float, "0", "the pattern grows with this power of the distance");

impl PlaneLayout {
    fn read_orientation(&mut self, r: &mut dyn Reader) -> Result<()> {
        set(&mut self.orientation, r.vector().map(DVec3::normalize_or_zero))
    }

    /// Returns the point of the pattern for (u, v) and a depth in a mapping warp.
    fn pattern_point(&self, u: f64, v: f64, depth: f64) -> DVec3 {
        // A rotation only for x, y and z (quirk: warp_orientation); for y the depth is -y.
        let n = self.orientation;
        DVec3::new((n.y + n.z) * u + n.x * depth, (n.x + n.z) * v - n.y * depth, n.y * v - n.x * u + n.z * depth)
    }

    /// Scale of the pattern's plane at this distance in a mapping warp.
    fn pattern_plane_scale(&self, distance: f64) -> f64 {
        if self.dist_exp == 0.0 { 1.0 } else { fp::pow(distance, self.dist_exp) }
    }
}

/// Warp `cylindrical`, around the y axis: u is a part of a turn, v is y.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize)]
pub struct CylindricalWarp(pub PlaneLayout);

impl Readable for CylindricalWarp {
    const SPEC: Spec = Spec {
        name: "cylindrical",
        summary: "lays the pattern's xy plane around the y axis",
        words: specs!(Self::WORDS),
        ..Spec::EMPTY
    };

    const WORDS: &'static [Row<Self>] =
        &[ORIENTATION.sets(|s, r| s.0.read_orientation(r)), DIST_EXP.sets(|s, r| set(&mut s.0.dist_exp, r.float()))];

    fn read(_: &mut dyn Reader) -> Result<Self> {
        Ok(Self::default())
    }
}

impl Bend for CylindricalWarp {
    fn apply(&self, p: DVec3) -> DVec3 {
        let distance = fp::hypot(p.x, p.z);
        if distance == 0.0 {
            return p;
        }
        self.0.pattern_point(
            fp::positive_angle_in_turns(p.z, p.x) * self.0.pattern_plane_scale(distance),
            p.y,
            distance,
        )
    }
}

/// Warp `spherical`, around the origin: u is a part of a turn, v runs from pole to pole.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize)]
pub struct SphericalWarp(pub PlaneLayout);

impl Readable for SphericalWarp {
    const SPEC: Spec = Spec {
        name: "spherical",
        summary: "lays the unit square of the pattern's xy plane around the origin",
        words: specs!(Self::WORDS),
        ..Spec::EMPTY
    };

    const WORDS: &'static [Row<Self>] =
        &[ORIENTATION.sets(|s, r| s.0.read_orientation(r)), DIST_EXP.sets(|s, r| set(&mut s.0.dist_exp, r.float()))];

    fn read(_: &mut dyn Reader) -> Result<Self> {
        Ok(Self::default())
    }
}

impl Bend for SphericalWarp {
    fn apply(&self, p: DVec3) -> DVec3 {
        let distance = p.length();
        if distance == 0.0 {
            return p;
        }
        let grown = self.0.pattern_plane_scale(distance);
        let latitude = fp::asin(p.y / distance) / PI + 0.5;
        self.0.pattern_point(fp::positive_angle_in_turns(p.z, p.x) * grown, latitude * grown, distance)
    }
}

/// Warp `toroidal`, around a ring about the y axis: u is a part of a turn about the axis, v of one about the ring.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct ToroidalWarp {
    /// Orientation and growth of the pattern's plane in the toroidal warp.
    pub layout: PlaneLayout,
    /// Major radius of the ring of the toroidal warp.
    pub major_radius: f64,
}

impl Readable for ToroidalWarp {
    const SPEC: Spec = Spec {
        name: "toroidal",
        summary: "lays the unit square of the pattern's xy plane around a ring",
        words: specs!(Self::WORDS),
        ..Spec::EMPTY
    };

    const WORDS: &'static [Row<Self>] = &[
        ORIENTATION.sets(|s, r| s.layout.read_orientation(r)),
        DIST_EXP.sets(|s, r| set(&mut s.layout.dist_exp, r.float())),
        word("major_radius", ValueKind::Float, "1", "radius of the ring")
            .sets(|s, r| set(&mut s.major_radius, r.float())),
    ];

    fn read(_: &mut dyn Reader) -> Result<Self> {
        Ok(Self { layout: PlaneLayout::default(), major_radius: 1.0 })
    }
}

impl Bend for ToroidalWarp {
    fn apply(&self, p: DVec3) -> DVec3 {
        if p.x == 0.0 && p.z == 0.0 {
            return p;
        }
        let outwards = fp::hypot(p.x, p.z) - self.major_radius;
        let distance = fp::hypot(outwards, p.y);
        let part = fp::atan2(p.y, outwards) / TAU + 0.5;
        let grown = self.layout.pattern_plane_scale(distance);
        self.layout.pattern_point(
            fp::positive_angle_in_turns(p.z, p.x) * grown,
            fp::fraction_above_floor(part) * grown,
            distance,
        )
    }
}

/// Warp `planar`: projects every point along the normal to the plane.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct PlanarWarp {
    /// Orientation of the planar warp's plane, which is its normal, of length 1 or 0.
    pub layout: PlaneLayout,
    /// Distance of the planar warp's plane from the origin.
    pub distance: f64,
}

impl Readable for PlanarWarp {
    const SPEC: Spec = Spec {
        name: "planar",
        summary: "extends a plane of the pattern along z",
        params: &[
            Param {
                name: "normal",
                kind: ValueKind::Vector,
                summary: "normal of the plane; z, with distance 0, if left out",
            },
            Param { name: "distance", kind: ValueKind::Float, summary: "how far from the origin the plane lies" },
        ],
        ..Spec::EMPTY
    };

    fn read(r: &mut dyn Reader) -> Result<Self> {
        let (mut orientation, mut distance) = (DVec3::Z, 0.0);
        if r.peek_next()? == Next::Value {
            orientation = r.vector()?.normalize_or_zero();
            distance = r.float()?;
        }
        Ok(Self { layout: PlaneLayout { orientation, dist_exp: 0.0 }, distance })
    }
}

impl Bend for PlanarWarp {
    fn apply(&self, p: DVec3) -> DVec3 {
        self.layout.pattern_point(p.x, p.y, self.distance)
    }
}

/// Warp `cubic`, around a cube about the origin, unfolded like the uv mapping of a box.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct CubicWarp {}

impl Readable for CubicWarp {
    const SPEC: Spec = Spec {
        name: "cubic",
        summary: "lays the unit square of the pattern's xy plane around a cube about the origin",
        ..Spec::EMPTY
    };

    fn read(_: &mut dyn Reader) -> Result<Self> {
        Ok(Self {})
    }
}

impl Bend for CubicWarp {
    fn apply(&self, p: DVec3) -> DVec3 {
        let depth = p.abs().max_element();
        if depth == 0.0 {
            return p;
        }
        let q = p / depth;
        // Six squares, 4 side by side and 3 above each other: find the square, and the offset right and up from its
        // centre; edges as in the pattern `cubic`.
        let ((column, row), right, up) = match (Cubic {}).cell_kind(p) {
            0 => ((2.0, 1.0), -q.z, q.y),
            1 => ((1.0, 2.0), q.x, -q.z),
            2 => ((1.0, 1.0), q.x, q.y),
            3 => ((0.0, 1.0), q.z, q.y),
            4 => ((1.0, 0.0), q.x, q.z),
            _ => ((3.0, 1.0), -q.x, q.y),
        };
        DVec3::new((column + 0.5 + right / 2.0) / 4.0, (row + 0.5 + up / 2.0) / 3.0, depth)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn turns_and_distances() {
        let p = DVec3::new(0.0, 0.3, 2.0);
        assert_eq!(CylindricalWarp::default().apply(p), DVec3::new(0.25, 0.3, 2.0));
        let grown = CylindricalWarp(PlaneLayout { dist_exp: 1.0, ..PlaneLayout::default() });
        assert_eq!(grown.apply(p), DVec3::new(0.5, 0.3, 2.0));
        let deep_y = CylindricalWarp(PlaneLayout { orientation: DVec3::Y, ..PlaneLayout::default() });
        assert_eq!(deep_y.apply(p), DVec3::new(0.25, -2.0, 0.3));
    }

    #[test]
    fn the_inner_side_of_a_ring_is_the_edge() {
        let ring = ToroidalWarp { layout: PlaneLayout::default(), major_radius: 2.0 };
        assert_eq!(ring.apply(DVec3::new(3.0, 0.0, 0.0)), DVec3::new(0.0, 0.5, 1.0));
        assert_eq!(ring.apply(DVec3::new(1.0, 0.0, 0.0)), DVec3::new(0.0, 0.0, 1.0));
    }

    #[test]
    fn a_cube_unfolds_to_a_cross() {
        let map = |x, y, z| CubicWarp {}.apply(DVec3::new(x, y, z)) * DVec3::new(8.0, 6.0, 1.0);
        assert!(map(0.0, 0.0, 2.0).distance(DVec3::new(3.0, 3.0, 2.0)) < 1e-12);
        assert!(map(0.0, 0.0, -1.0).distance(DVec3::new(7.0, 3.0, 1.0)) < 1e-12);
        assert!(map(0.0, 1.0, 0.0).distance(DVec3::new(3.0, 5.0, 1.0)) < 1e-12);
    }
}
