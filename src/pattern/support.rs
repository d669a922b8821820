//! Regions outside of which a pattern's number is 0.

use crate::math::{Aabb, DVec3, fp};

/// Region outside of which a pattern's number is 0: a ball, cube, infinite cylinder or infinite slab around the origin,
/// of radius or half-width 1.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Support {
    /// Ball of radius 1.
    Ball,
    /// Cube from -1 to 1 along each axis.
    Cube,
    /// Infinite cylinder of radius 1 around the y axis.
    Cylinder,
    /// Infinite slab of the points whose y is between -1 and 1.
    Slab,
}

/// Extent of the regions: slightly more than 1, so that rounding excludes no point of a region.
const EXTENT: f64 = 1.0 + 1e-9;

impl Support {
    /// Returns a range of t that contains all points origin + t dir of the region. The range is empty (its end before its
    /// start) if the line misses the region; NaN marks an unknown end.
    pub fn range_on_line(self, origin: DVec3, dir: DVec3) -> [f64; 2] {
        match self {
            Self::Ball => ball_range(origin, dir),
            Self::Cylinder => ball_range(DVec3 { y: 0.0, ..origin }, DVec3 { y: 0.0, ..dir }),
            Self::Slab => slab_range(origin.y, dir.y),
            Self::Cube => {
                let ranges = [0, 1, 2].map(|axis: usize| slab_range(origin[axis], dir[axis]));
                let [x, y, z] = ranges;
                [x[0].max(y[0]).max(z[0]), x[1].min(y[1]).min(z[1])]
            }
        }
    }

    /// True if a box is entirely outside of the region.
    pub fn misses_box(self, bounds: &Aabb) -> bool {
        // The point of the box that is nearest to the origin along each axis.
        let nearest = DVec3::ZERO.clamp(bounds.min, bounds.max).abs();
        match self {
            Self::Ball => nearest.length() > EXTENT,
            Self::Cube => nearest.max_element() > EXTENT,
            Self::Cylinder => fp::hypot(nearest.x, nearest.z) > EXTENT,
            Self::Slab => nearest.y > EXTENT,
        }
    }
}

const EVERYWHERE: [f64; 2] = [f64::NEG_INFINITY, f64::INFINITY];
const NOWHERE: [f64; 2] = [f64::INFINITY, f64::NEG_INFINITY];

/// Returns the range of t in which origin + t dir is between -[`EXTENT`] and [`EXTENT`].
fn slab_range(origin: f64, dir: f64) -> [f64; 2] {
    if dir == 0.0 {
        return if origin.abs() > EXTENT { NOWHERE } else { EVERYWHERE };
    }
    let (a, b) = ((-EXTENT - origin) / dir, (EXTENT - origin) / dir);
    if a < b { [a, b] } else { [b, a] }
}

/// Returns the range of t in which the length of origin + t dir is at most [`EXTENT`].
fn ball_range(origin: DVec3, dir: DVec3) -> [f64; 2] {
    let a = dir.length_squared();
    let outside = origin.length_squared() - EXTENT * EXTENT;
    if a == 0.0 {
        return if outside > 0.0 { NOWHERE } else { EVERYWHERE };
    }
    // The distance of the line's nearest point, from which rounding takes less than from b² - ac.
    let nearest = -origin.dot(dir) / a;
    let half_squared = (EXTENT * EXTENT - (origin + nearest * dir).length_squared()) / a;
    if half_squared < 0.0 {
        return NOWHERE;
    }
    let half = half_squared.sqrt();
    [nearest - half, nearest + half]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::pattern::{Boxed, Cylindrical, Field, Planar, Spherical, TextureContext};
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn patterns_are_0_outside_of_their_support(
            origin in prop::array::uniform3(-3.0..3.0f64),
            dir in prop::array::uniform3(-1.0..1.0f64),
            along in prop::collection::vec(-9.0..9.0f64, 20),
        ) {
            let (origin, dir) = (DVec3::from(origin), DVec3::from(dir));
            let fields: [&dyn Field; 4] = [&Spherical {}, &Boxed {}, &Cylindrical {}, &Planar {}];
            for field in fields {
                let [from, to] = field.support().unwrap().range_on_line(origin, dir);
                for t in &along {
                    let p = origin + *t * dir;
                    let value = field.value(&TextureContext::without_surface(p, Default::default()));
                    prop_assert!(value == 0.0 || (from..=to).contains(t), "{value} at {p}, {from} to {to}");
                }
            }
        }
    }

    #[test]
    fn boxes_beside_the_regions() {
        let small = |center: DVec3| Aabb::from_corners(center - 0.4, center + 0.4);
        let missed = |center: DVec3| {
            [Support::Ball, Support::Cube, Support::Cylinder, Support::Slab]
                .map(|support| support.misses_box(&small(center)))
        };
        assert_eq!(missed(DVec3::splat(0.9)), [false; 4]);
        assert_eq!(missed(DVec3::splat(1.3)), [true, false, true, false]);
        assert_eq!(missed(DVec3::X * 1.5), [true, true, true, false]);
        assert_eq!(missed(DVec3::NEG_Y * 1.5), [true, true, false, true]);
    }

    #[test]
    fn parallel_lines_are_inside_or_outside() {
        for (support, outside) in [
            (Support::Slab, DVec3::Y * 2.0),
            (Support::Cube, DVec3::Y * 2.0),
            (Support::Cylinder, DVec3::Z * 2.0),
            (Support::Ball, DVec3::Y * 2.0),
        ] {
            let [from, to] = support.range_on_line(outside, DVec3::X);
            assert!(from > to, "{support:?}");
        }
        assert_eq!(Support::Slab.range_on_line(DVec3::ZERO, DVec3::X), EVERYWHERE);
        assert_eq!(Support::Cylinder.range_on_line(DVec3::Z * 2.0, DVec3::Y), NOWHERE);
    }
}
