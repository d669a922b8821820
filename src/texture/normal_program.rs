//! Normals in the form that rays evaluate: functions from the geometric normal to the shading normal.

use super::blend::Blend;
use super::normal::{Normal, Relief, Slope, SlopeMap};
use crate::math::{DVec3, cancel};
use crate::pattern::{PatternProgram, Space, TextureContext};
use serde::Serialize;
use std::f64::consts::SQRT_2;
use std::sync::Arc;

/// Lowered normal of a texture, which perturbs normals.
#[derive(Clone, Debug, Serialize)]
pub struct NormalProgram {
    pattern: PatternProgram,
    /// Space of the normal's pattern: normals are transformed differently from points.
    space: Space,
    relief: ReliefProgram,
    /// Apparent depth of the lowered normal's bumps.
    amount: f64,
    /// Half the distance between the points at which the lowered normal's pattern is sampled.
    accuracy: f64,
    /// True if the lowered normal's bumps ignore the object's rotation; see [`Normal::stays`].
    pub stays: bool,
    /// True if `uv_mapping` is in the texture of the lowered normal; see [`Normal::framed`].
    pub framed: bool,
    /// True if scaling changes the depth of the lowered normal's bumps; see [`Normal::bump_scale`].
    bump_scale: bool,
}

/// Source of a lowered normal's bumps; see [`Relief`].
#[derive(Clone, Debug, Serialize)]
enum ReliefProgram {
    Own,
    Slopes(Arc<SlopeMap>),
    Normals(Blend<NormalProgram>),
}

impl Slope {
    /// Returns the height at `t` on the cubic Hermite spline from this entry of a `slope_map` to another.
    fn hermite_height(&self, other: &Slope, t: f64) -> f64 {
        let (t2, t3) = (t * t, t * t * t);
        (2.0 * t3 - 3.0 * t2 + 1.0) * self.height
            + (t3 - 2.0 * t2 + t) * self.slope
            + (3.0 * t2 - 2.0 * t3) * other.height
            + (t3 - t2) * other.slope
    }
}

/// Corners of a regular tetrahedron, as unit vectors.
const TETRAHEDRON: [DVec3; 4] = [
    DVec3::new(2.0 * SQRT_2 / 3.0, -1.0 / 3.0, 0.0),
    DVec3::new(0.0, 1.0, 0.0),
    DVec3::new(-SQRT_2 / 3.0, -1.0 / 3.0, 0.816_496_580_927_726),
    DVec3::new(-SQRT_2 / 3.0, -1.0 / 3.0, -0.816_496_580_927_726),
];

impl NormalProgram {
    /// Lowers a texture's normal, and those in its map or list, to the form that is evaluated.
    pub fn new(normal: &Normal) -> Self {
        let relief = match &normal.relief {
            Relief::Own => ReliefProgram::Own,
            Relief::Slopes(map) => ReliefProgram::Slopes(map.clone()),
            Relief::Normals(parts) => ReliefProgram::Normals(parts.map(Self::new)),
        };
        let &Normal { amount, accuracy, stays, framed, bump_scale, .. } = normal;
        let (pattern, space) = (PatternProgram::new(&normal.pattern), normal.pattern.space.clone());
        Self { pattern, space, relief, amount, accuracy, stays, framed, bump_scale }
    }

    /// Perturbs a surface normal by the texture's bumps, at a point in the outer space; `n` is in the same space, of
    /// any length. Each space transforms the normal by the transpose of its matrix, so that stretching flattens bumps
    /// (quirk: `normals_by_transpose`).
    pub fn perturb(&self, ctx: &TextureContext, n: DVec3) -> DVec3 {
        self.perturb_keeping_length_if(ctx, n, !self.bump_scale)
    }

    /// True if the result of [`Self::perturb`] must not be normalised: for `no_bump_scale`, except in a block with a
    /// `normal_map` or a list of normals.
    pub fn forbids_normalization(&self) -> bool {
        !self.bump_scale && !matches!(self.relief, ReliefProgram::Normals(_))
    }

    /// Perturbs a surface normal; `keep_length` is true if this normal or one around it has `no_bump_scale`.
    fn perturb_keeping_length_if(&self, ctx: &TextureContext, n: DVec3, keep_length: bool) -> DVec3 {
        let space = &self.space;
        let inside = space.normal_to_pattern_space(n);
        let n = if keep_length { inside } else { inside.normalize_or(inside) };
        let inner = self.pattern.to_pattern_space(ctx);
        let bumped = match &self.relief {
            ReliefProgram::Normals(parts) => self.blend_normals(parts, &inner, n, keep_length),
            _ => match self.pattern.bumped_normal(&inner, n, self.amount) {
                Some(bumped) => bumped,
                None => n + self.normal_change(&inner),
            },
        };
        space.normal_from_pattern_space(bumped)
    }

    /// Blends the surface normals of several entries of a normal map. The patterns of an entry receive the normal that
    /// the entry before has bumped, and the upper of two is first, which only `slope` and `aoi` show (quirk:
    /// `blended_normals`).
    fn blend_normals(
        &self,
        parts: &Blend<NormalProgram>,
        inner: &TextureContext,
        n: DVec3,
        keep_length: bool,
    ) -> DVec3 {
        let average = self.pattern.is_average();
        let number = if average { 0.0 } else { self.pattern.number_in_pattern_space(inner) };
        let (mut sum, mut seen) = (DVec3::ZERO, *inner);
        let mut shares = parts.weighted_values(number, average);
        if !average {
            shares.reverse();
        }
        for (entry, share) in shares {
            if cancel::is_cancelled() {
                return n;
            }
            let keep = keep_length || !entry.bump_scale;
            let one = entry.perturb_keeping_length_if(&seen, n, keep);
            let one = if keep { one } else { one.normalize_or(one) };
            if seen.is_on_surface() && one.is_finite() {
                seen.normal = one;
            }
            sum += share * one;
        }
        // The blend of two entries has length 1, even with `no_bump_scale` (quirk: blended_normals).
        if average { sum } else { sum.normalize_or(sum) }
    }

    /// Vector that the bumps add to a normal: against the gradient of their height, in proportion to their amount. The
    /// heights at the corners of a tetrahedron around the point are compared.
    fn normal_change(&self, inner: &TextureContext) -> DVec3 {
        if self.pattern.is_constant() || self.pattern.is_average() {
            return DVec3::ZERO;
        }
        let h = self.accuracy;
        let corners = TETRAHEDRON.map(|d| inner.with_point(inner.p + h * d));
        let numbers = self.pattern.numbers_in_pattern_space(corners);
        let heights = numbers.into_iter().map(|number| self.height_of_number(number));
        let sum: DVec3 = heights.zip(TETRAHEDRON).map(|(height, d)| height * d).sum();
        sum * (-self.amount * 0.1 / h)
    }

    /// Apparent height of the surface with bumps where the pattern has this number.
    fn height_of_number(&self, number: f64) -> f64 {
        match &self.relief {
            ReliefProgram::Slopes(map) => match map.entries_and_fraction_at(number) {
                (only, None) => only.height,
                (below, Some((above, t))) => below.hermite_height(above, t),
            },
            _ => number,
        }
    }
}
