//! Patterns in the form that rays evaluate: the transform from the outer space to the pattern's own is precomputed.

use super::local_bounds::max_stretch;
use super::{Modifiers, Pattern, PatternKind, Step, TurbulenceParams};
use crate::math::noise::{self, NoiseGenerator, Turbulence};
use crate::math::{Aabb, DVec3, Ray};
use crate::pattern::warp::Bend;
use crate::pattern::{CellPattern, Cells, Field, FieldParams, FieldPattern, LocalBounds, TextureContext, Warp};
use glam::DAffine3;
use serde::Serialize;

/// A lowered pattern: pigments, normals, texture maps and functions all evaluate patterns through this type.
#[derive(Clone, Debug, Serialize)]
pub struct PatternProgram {
    /// True for `uv_mapping`: the pattern's steps begin at (u, v, 0).
    uv: bool,
    /// Steps from the outer space to the pattern's own space, in the order in which they apply to a point.
    way: Box<[SpaceStep]>,
    value: Value,
}

/// Step of a lowered pattern from one space to the next.
#[derive(Clone, Debug, Serialize)]
enum SpaceStep {
    /// Product of the inverses of consecutive transforms of a pattern.
    Affine(DAffine3),
    Warp(Warp),
    /// Turbulence of a pattern: strength along each axis, and its octaves.
    Turbulence(DVec3, #[serde(skip)] Turbulence),
}

/// Function from points to numbers of a lowered pattern.
#[derive(Clone, Debug, Serialize)]
enum Value {
    Plain,
    /// Lowered pattern `average`: all entries of the map are mixed.
    Average,
    Field(Box<Number>),
    Cells(Box<(CellPattern, Modifiers)>),
}

/// Lowered pattern of numbers with its parameters. (Boxed, because most pigments are colours.)
#[derive(Clone, Debug, Serialize)]
struct Number {
    field: FieldPattern,
    modifiers: Modifiers,
    turbulence: TurbulenceParams,
    noise: Option<NoiseGenerator>,
}

impl PatternProgram {
    /// Lowers a pattern to the form that is evaluated.
    pub fn new(pattern: &Pattern) -> Self {
        Self { uv: pattern.receives_uv(), way: lower_steps(pattern), value: lower_value(pattern) }
    }

    /// True if the lowered pattern is constant.
    pub fn is_constant(&self) -> bool {
        matches!(self.value, Value::Plain)
    }

    /// True if the lowered pattern mixes all entries of the map.
    pub fn is_average(&self) -> bool {
        matches!(self.value, Value::Average)
    }

    /// True if the lowered pattern receives (u, v, 0) instead of the point.
    pub fn receives_uv(&self) -> bool {
        self.uv
    }

    /// Evaluates the lowered pattern at a point. Returns the number that the map receives, or the index of the cell;
    /// and the point in the space of the pattern's entries.
    pub fn number_and_entry_context(&self, ctx: &TextureContext) -> (f64, TextureContext) {
        let inner = self.to_pattern_space(ctx);
        (self.number_in_pattern_space(&inner), inner)
    }

    /// Evaluates the lowered pattern at a point. Returns the number that the map receives, or the index of the cell.
    pub fn pattern_number_at(&self, ctx: &TextureContext) -> f64 {
        self.pattern_number_for_map(ctx, 0.0)
    }

    /// Evaluates the lowered pattern at a point for a map whose value is constant below a number. Returns
    /// [`Self::pattern_number_at`], or any other number in the constant start of the map in place of one in it. A
    /// pattern whose modifiers change numbers from 0 to 1 needs 0 for `constant_below`.
    pub fn pattern_number_for_map(&self, ctx: &TextureContext, constant_below: f64) -> f64 {
        if self.way.is_empty() && !self.uv {
            self.map_number_in_pattern_space(ctx, constant_below)
        } else {
            self.map_number_in_pattern_space(&self.to_pattern_space(ctx), constant_below)
        }
    }

    /// Returns a point in the space of the lowered pattern and its entries.
    pub fn to_pattern_space(&self, ctx: &TextureContext) -> TextureContext {
        let p = if self.uv { ctx.uv.extend(0.0) } else { ctx.p };
        ctx.with_point(self.way.iter().fold(p, |p, step| match step {
            SpaceStep::Affine(inverse) => inverse.transform_point3(p),
            SpaceStep::Warp(warp) => warp.apply(p),
            SpaceStep::Turbulence(amount, series) => p + *amount * noise::vturbulence(p, *series),
        }))
    }

    /// Returns the number that the map receives, or the index of the cell, at a point in the lowered pattern's space.
    pub fn number_in_pattern_space(&self, inner: &TextureContext) -> f64 {
        self.map_number_in_pattern_space(inner, 0.0)
    }

    /// Returns [`Self::number_in_pattern_space`] at four points.
    pub fn numbers_in_pattern_space(&self, mut inner: [TextureContext; 4]) -> [f64; 4] {
        let Value::Field(number) = &self.value else {
            return inner.each_ref().map(|inner| self.number_in_pattern_space(inner));
        };
        if let Some(noise) = number.noise {
            inner.iter_mut().for_each(|inner| inner.noise = noise);
        }
        let values = number.field.values_with_params(&inner, &number.field_params());
        values.map(|value| number.modifiers.apply_to_number(value))
    }

    /// True if the lowered pattern's number takes a long chain of operations, see [`Field::takes_long_chain`].
    pub fn takes_long_chain(&self) -> bool {
        matches!(&self.value, Value::Field(number) if number.field.takes_long_chain())
    }

    /// Returns the number of [`Self::pattern_number_for_map`] at a point in the lowered pattern's space.
    fn map_number_in_pattern_space(&self, inner: &TextureContext, constant_below: f64) -> f64 {
        match &self.value {
            Value::Plain | Value::Average => 0.0,
            Value::Cells(pattern) => pattern.1.apply_to_cell(pattern.0.cell_kind(inner.p)),
            Value::Field(number) => {
                let words = FieldParams { constant_below, ..number.field_params() };
                number.modifiers.apply_to_number(match number.noise {
                    None => number.field.value_with_params(inner, &words),
                    Some(_) => number.field.value_with_params(&number.with_own_noise(inner), &words),
                })
            }
        }
    }

    /// Returns bounds on the numbers of [`Self::number_and_entry_context`] within a radius of a point.
    pub fn value_bounds_near(&self, ctx: &TextureContext, radius: f64) -> LocalBounds {
        let mut longer = if self.uv { f64::INFINITY } else { 1.0 };
        for step in &self.way {
            longer *= match step {
                SpaceStep::Affine(inverse) => max_stretch(&inverse.matrix3),
                SpaceStep::Warp(_) | SpaceStep::Turbulence(..) => f64::INFINITY,
            };
        }
        let (inner, radius) = (self.to_pattern_space(ctx), radius * longer);
        let near = match &self.value {
            Value::Plain | Value::Average => LocalBounds::constant(0.0),
            Value::Cells(pattern) if pattern.0.is_uniform(inner.p, radius) => {
                LocalBounds::constant(self.number_in_pattern_space(&inner))
            }
            Value::Cells(_) => LocalBounds::UNKNOWN,
            Value::Field(number) => number.modifiers.modified_bounds(number.field.value_bounds_near(
                &number.with_own_noise(&inner),
                &number.field_params(),
                radius,
            )),
        };
        LocalBounds { steepest: if near.steepest == 0.0 { 0.0 } else { near.steepest * longer }, ..near }
    }

    /// Returns the number that the map receives outside of the lowered pattern's support; `None` if no support is known.
    pub fn number_outside_support(&self) -> Option<f64> {
        let Value::Field(number) = &self.value else { return None };
        let is_affine = !self.uv && matches!(&*self.way, [] | [SpaceStep::Affine(_)]);
        (is_affine && number.field.support().is_some()).then(|| number.modifiers.apply_to_number(0.0))
    }

    /// Returns distances along a ray of the outer space outside of which the lowered pattern's number is that of
    /// [`Self::number_outside_support`]: an empty range if the ray misses the support; `None` if no support is known.
    pub fn known_support_on_ray(&self, ray: &Ray) -> Option<[f64; 2]> {
        let Value::Field(number) = &self.value else { return None };
        let support = number.field.support()?;
        match &*self.way {
            _ if self.uv => None,
            [] => Some(support.range_on_line(ray.origin, ray.dir)),
            [SpaceStep::Affine(inverse)] => {
                let dir = inverse.transform_vector3(ray.dir);
                Some(support.range_on_line(inverse.transform_point3(ray.origin), dir))
            }
            _ => None,
        }
    }

    /// True if the parallelepiped with these eight corners, in the outer space, is certainly outside of the lowered
    /// pattern's support; its edges need not be parallel to the axes.
    pub fn is_hull_outside_support(&self, corners: [DVec3; 8]) -> bool {
        let Value::Field(number) = &self.value else { return false };
        let corners = match &*self.way {
            _ if self.uv => return false,
            [] => corners,
            [SpaceStep::Affine(inverse)] => corners.map(|p| inverse.transform_point3(p)),
            _ => return false,
        };
        number.field.support().is_some_and(|support| support.misses_box(&Aabb::from_points(corners)))
    }

    /// Returns the normal `n` with bumps that the lowered pattern computes itself, at a point in the pattern's space.
    pub fn bumped_normal(&self, inner: &TextureContext, n: DVec3, amount: f64) -> Option<DVec3> {
        match &self.value {
            Value::Field(number) => {
                number.field.bumped_normal(&number.with_own_noise(inner), &number.field_params(), n, amount)
            }
            _ => None,
        }
    }
}

impl Number {
    fn field_params(&self) -> FieldParams<'_> {
        FieldParams { modifiers: &self.modifiers, turbulence: &self.turbulence, constant_below: 0.0 }
    }

    /// Returns the point with the pattern's own noise generator, if the pattern has one.
    fn with_own_noise(&self, inner: &TextureContext) -> TextureContext {
        TextureContext { noise: self.noise.unwrap_or(inner.noise), ..*inner }
    }
}

fn lower_value(pattern: &Pattern) -> Value {
    let modifiers = pattern.modifiers;
    match &pattern.kind {
        PatternKind::Plain | PatternKind::Surface => Value::Plain,
        PatternKind::Average => Value::Average,
        PatternKind::Cells(cells) => Value::Cells(Box::new((cells.clone(), modifiers))),
        PatternKind::Field(field) => {
            let turbulence = pattern.space.turbulence.as_deref().copied().unwrap_or_default();
            Value::Field(Box::new(Number { field: field.clone(), modifiers, turbulence, noise: pattern.noise }))
        }
    }
}

/// Returns the steps of a pattern: the transform that was written last applies first.
fn lower_steps(pattern: &Pattern) -> Box<[SpaceStep]> {
    if pattern.kind == PatternKind::Surface {
        return Box::default();
    }
    let space = &pattern.space;
    let mut way = vec![];
    let mut affine = space.transform.inv;
    for step in space.inner.iter().rev() {
        match step {
            Step::Moved(transform) => affine = transform.inv * affine,
            Step::Warped(warp) => {
                way.push(SpaceStep::Affine(std::mem::take(&mut affine)));
                way.push(SpaceStep::Warp(warp.clone()));
            }
        }
    }
    way.push(SpaceStep::Affine(affine));
    let handles_turbulence_itself =
        matches!(&pattern.kind, PatternKind::Field(field) if field.handles_turbulence_itself());
    if let Some(turbulence) =
        space.turbulence.as_deref().filter(|t| !handles_turbulence_itself && t.amount != DVec3::ZERO)
    {
        way.push(SpaceStep::Turbulence(turbulence.amount, turbulence.to_octaves()));
    }
    way.retain(|step| !matches!(step, SpaceStep::Affine(inverse) if *inverse == DAffine3::IDENTITY));
    way.into()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::Transform;
    use crate::pattern::{Space, TurbulenceWarp};

    #[test]
    fn steps_are_undone_from_the_last_to_the_first() {
        let mut space = Space::default();
        space.append_transform(&Transform::translate(DVec3::X));
        space.append_warp(Warp::Turbulence(TurbulenceWarp(TurbulenceParams::default())));
        space.append_transform(&Transform::rotate(DVec3::Z * 90.0));
        assert_eq!(space.inner.len(), 2);
        let program = PatternProgram::new(&Pattern { space, ..Pattern::default() });
        // (0, 3, 0) comes from (3, 0, 0), which comes from (2, 0, 0)
        let inner = program.to_pattern_space(&TextureContext::without_surface(DVec3::Y * 3.0, NoiseGenerator::Perlin));
        assert!(inner.p.distance(DVec3::X * 2.0) < 1e-12);
    }
}
