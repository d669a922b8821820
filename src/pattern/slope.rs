//! `slope`: angle between the surface and a direction or a point, optionally mixed with altitude (manual, "Slope
//! Pattern").
//!
//! ```pov
//! sphere { 0, 1 pigment { slope { -y, 0.3, 0.7 } color_map { [0 color rgb 1] [1 color rgb <0.3, 0.5, 0.2>] } } }
//! ```

use super::{Field, TextureContext};
use crate::diagnostic::{Diagnostic, Result, codes};
use crate::math::{DVec3, fp};
use crate::value::{Param, Readable, Reader, ReaderExt, Spec, ValueKind};
use serde::Serialize;
use std::f64::consts::PI;

/// Pattern `slope`: 0 for a normal against the direction, 0.5 across it, 1 along it.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Slope {
    /// Direction or point of the pattern `slope`, in world space.
    pub towards: Towards,
    /// Slopes at which the pattern `slope` is 0 and 1.
    pub range: [f64; 2],
    /// Altitude that is mixed into the pattern `slope`.
    pub altitude: Option<Box<Altitude>>,
}

/// Direction of the normal for which the pattern `slope` is 1.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Towards {
    /// Direction of `slope`; its length is its weight against the altitude's.
    Direction(DVec3),
    /// Direction of `slope` towards a point.
    Point(DVec3),
}

/// Ramp of altitude that is mixed into the pattern `slope`.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Altitude {
    /// Upward direction of `slope`'s altitude, in the pattern's space; its length is its weight against the
    /// direction's.
    pub up: DVec3,
    /// Heights at which the altitude of `slope` counts 0 and 1.
    pub range: [f64; 2],
}

impl Readable for Slope {
    const SPEC: Spec = Spec {
        name: "slope",
        summary: "how far the surface is turned towards a direction; a vector, or in braces `<direction>, low, high altitude <up>, low, high` \
                  or `point_at <place>, low, high`",
        params: &[
            Param {
                name: "direction",
                kind: ValueKind::Vector,
                summary: "where a surface that gives 1 faces, in world space",
            },
            Param { name: "low, high", kind: ValueKind::Float, summary: "which slopes give 0 and 1" },
        ],
        ..Spec::EMPTY
    };

    fn read(r: &mut dyn Reader) -> Result<Self> {
        Ok(Self { towards: read_direction(r)?, range: [0.0, 1.0], altitude: None })
    }

    fn read_braced_params(r: &mut dyn Reader) -> Result<Self> {
        let towards = if r.accept("point_at")? { Towards::Point(r.vector()?) } else { read_direction(r)? };
        let range = read_range_or_default(r)?;
        let mut altitude = None;
        if matches!(towards, Towards::Direction(_)) && r.accept("altitude")? {
            let (up, range) = (r.vector()?, read_range_or_default(r)?);
            // POV-Ray ignores an altitude without a direction.
            altitude = (up != DVec3::ZERO).then(|| Box::new(Altitude { up, range }));
        }
        r.leave_block()?;
        Ok(Self { towards, range, altitude })
    }
}

fn read_direction(r: &mut dyn Reader) -> Result<Towards> {
    read_vector(r).map(Towards::Direction)
}

fn read_vector(r: &mut dyn Reader) -> Result<DVec3> {
    let (span, vector) = (r.span(), r.vector()?);
    if vector == DVec3::ZERO {
        return Diagnostic::err(codes::ZERO_VECTOR, span, "a slope needs a direction, this vector is zero");
    }
    Ok(vector)
}

/// Reads `low, high`, any two numbers, if a number comes next; returns 0 and 1 otherwise.
fn read_range_or_default(r: &mut dyn Reader) -> Result<[f64; 2]> {
    match r.optional_float()? {
        Some(low) => Ok([low, r.float()?]),
        None => Ok([0.0, 1.0]),
    }
}

/// Maps x linearly from 0 at the low end to 1 at the high end, and beyond; unchanged if both are equal.
fn unclamped_ramp(x: f64, [low, high]: [f64; 2]) -> f64 {
    if low == high { x } else { (x - low) / (high - low) }
}

impl Field for Slope {
    fn value(&self, at: &TextureContext) -> f64 {
        if !at.is_on_surface() {
            return 0.0;
        }
        let towards = match self.towards {
            Towards::Direction(direction) => direction,
            Towards::Point(point) => point - at.world,
        };
        let facing = 1.0 - fp::acos(at.normal.dot(towards.normalize_or_zero())) / PI;
        let slope = unclamped_ramp(facing, self.range);
        let value = match self.altitude.as_deref() {
            None => slope,
            // weighted by the lengths of the two vectors
            Some(Altitude { up, range }) => {
                let (by_slope, by_height) = (towards.length(), up.length());
                let height = unclamped_ramp(at.p.dot(*up) / by_height, *range);
                (by_slope * slope + by_height * height) / (by_slope + by_height)
            }
        };
        // wraps before the frequency applies (quirk: slope_wraps_first)
        if (0.0..=1.0).contains(&value) { value } else { fp::fraction_above_floor(value) }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::pattern::extreme_points;

    #[test]
    fn facing_and_height() {
        let ctx =
            TextureContext { normal: DVec3::Y, ..TextureContext::without_surface(DVec3::Y * 0.5, Default::default()) };
        let slope = Slope { towards: Towards::Direction(DVec3::X), range: [0.0, 1.0], altitude: None };
        assert_eq!(slope.value(&ctx), 0.5);
        assert_eq!(Slope { range: [0.25, 0.75], ..slope.clone() }.value(&ctx), 0.5);
        let point = Slope { towards: Towards::Point(DVec3::Y * 9.0), ..slope.clone() };
        assert_eq!(point.value(&ctx), 1.0);
        let altitude = Some(Box::new(Altitude { up: DVec3::Y * 3.0, range: [0.0, 2.0] }));
        assert_eq!(Slope { altitude, ..slope }.value(&ctx), (0.5 + 3.0 * 0.25) / 4.0);
    }

    #[test]
    fn extreme_points_and_normals_do_not_panic() {
        let slope = Slope { towards: Towards::Direction(DVec3::X), range: [0.0, 1.0], altitude: None };
        let point = Slope { towards: Towards::Point(DVec3::Y), range: [0.5, 0.5], altitude: None };
        let high = Slope { altitude: Some(Box::new(Altitude { up: DVec3::Y, range: [1.0, -1.0] })), ..slope.clone() };
        for p in extreme_points() {
            let there = TextureContext::without_surface(p, Default::default());
            for ctx in
                [there, TextureContext { normal: p, ..there }, TextureContext { normal: DVec3::ZERO, ray: p, ..there }]
            {
                for pattern in [&slope, &point, &high] {
                    pattern.value(&ctx);
                }
                crate::pattern::Aoi {}.value(&ctx);
            }
        }
    }
}
