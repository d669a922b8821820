//! Pigments as a ray needs them: a row of nodes in place of a tree, and for each the way from the space around it worked out.

use crate::color::Color;
use crate::math::DVec3;
use crate::math::noise::{self, NoiseGenerator, Turbulence};
use crate::pattern::{
    CellPattern, Cells, Field, FieldPattern, Kind, Modifiers, Pattern, Step, TextureContext, Turbulent, Warp, Words,
};
use crate::texture::{Blend, ColorMap, ImageMap, Map, Paint, Pigment};
use glam::DAffine3;
use serde::Serialize;
use std::sync::Arc;

/// A lowered pigment; shows what [`Pigment::at`] does.
#[derive(Clone, Debug, Serialize)]
pub struct PigmentProgram {
    /// That of the whole pigment is the last: each stands behind those it is made of.
    nodes: Box<[PigmentNode]>,
}

/// A pigment within a pigment.
#[derive(Clone, Debug, Serialize)]
struct PigmentNode {
    /// `uv_mapping`: the way begins with the place on the surface.
    uv: bool,
    /// From the space around it to its own, in the order in which a point goes it.
    way: Box<[Leg]>,
    value: Value,
    shows: Shows,
}

/// A piece of the way.
#[derive(Clone, Debug, Serialize)]
enum Leg {
    /// M⁻¹ of all transforms in a row.
    Affine(DAffine3),
    Warp(Warp),
    /// `turbulence`: how far, and its octaves.
    Turbulence(DVec3, #[serde(skip)] Turbulence),
}

/// What gives a point its number.
#[derive(Clone, Debug, Serialize)]
enum Value {
    /// Nothing: there is no pattern, or all its entries are seen at once.
    Nothing,
    Field(Box<Number>),
    Cells(Box<(CellPattern, Modifiers)>),
}

/// A pattern of numbers with what it takes. (Apart, because most nodes are colours.)
#[derive(Clone, Debug, Serialize)]
struct Number {
    field: FieldPattern,
    modifiers: Modifiers,
    turbulence: Turbulent,
    noise: Option<NoiseGenerator>,
}

/// What is seen.
#[derive(Clone, Debug, Serialize)]
enum Shows {
    Solid(Color),
    Colors(Arc<ColorMap>),
    /// Nodes.
    Inks(Blend<u32>, bool),
    Image(Arc<ImageMap>),
}

impl PigmentProgram {
    /// Lowers a pigment.
    pub fn new(pigment: &Pigment) -> Self {
        let mut nodes = vec![];
        push(pigment, &mut nodes);
        Self { nodes: nodes.into() }
    }

    /// The colour at a point of the texture's space.
    pub fn at(&self, ctx: &TextureContext) -> Color {
        self.node(self.nodes.len() - 1, ctx)
    }

    fn node(&self, i: usize, ctx: &TextureContext) -> Color {
        let node = &self.nodes[i];
        let inner = || ctx.at(node.enter(ctx));
        match &node.shows {
            Shows::Solid(color) => *color,
            Shows::Colors(map) => map.at(node.value.at(inner())),
            Shows::Image(image) => image.at(node.enter(ctx)),
            Shows::Inks(parts, average) => {
                let inner = inner();
                match parts.shares(node.value.at(inner), *average)[..] {
                    [(i, 1.0)] => self.node(*i as usize, &inner),
                    ref shares => shares
                        .iter()
                        .fold(Color::BLACK, |sum, (i, share)| sum.plus(self.node(**i as usize, &inner), *share)),
                }
            }
        }
    }
}

impl PigmentNode {
    /// Where a point lies in its own space.
    fn enter(&self, ctx: &TextureContext) -> DVec3 {
        let p = if self.uv { ctx.uv.extend(0.0) } else { ctx.p };
        self.way.iter().fold(p, |p, leg| match leg {
            Leg::Affine(inverse) => inverse.transform_point3(p),
            Leg::Warp(warp) => warp.apply(p),
            Leg::Turbulence(amount, series) => p + *amount * noise::vturbulence(p, *series),
        })
    }
}

impl Value {
    fn at(&self, mut inner: TextureContext) -> f64 {
        match self {
            Value::Nothing => 0.0,
            Value::Cells(pattern) => pattern.1.apply_to_cell(pattern.0.cell(inner.p)),
            Value::Field(number) => {
                let Number { field, modifiers, turbulence, noise } = &**number;
                inner.noise = noise.unwrap_or(inner.noise);
                modifiers.apply(field.value_as(&inner, &Words { modifiers, turbulence }))
            }
        }
    }
}

/// Appends the nodes of a pigment; the number of its own.
fn push(pigment: &Pigment, nodes: &mut Vec<PigmentNode>) -> u32 {
    let pattern = &pigment.pattern;
    let shows = match &pigment.paint {
        Paint::Solid(color) => Shows::Solid(*color),
        Paint::Colors(map) => Shows::Colors(map.clone()),
        Paint::Image(image) => Shows::Image(image.clone()),
        Paint::Pigments(parts) => {
            let parts = match parts {
                Blend::Map(map) => {
                    let entries = map.entries.iter().map(|(number, entry)| (*number, push(entry, nodes)));
                    Blend::Map(Arc::new(Map { entries: entries.collect() }))
                }
                Blend::List(list) => Blend::List(list.iter().map(|entry| push(entry, nodes)).collect()),
            };
            Shows::Inks(parts, pattern.averages())
        }
    };
    nodes.push(PigmentNode { uv: pattern.uv, way: way(pattern), value: value(pattern), shows });
    nodes.len() as u32 - 1
}

fn value(pattern: &Pattern) -> Value {
    let modifiers = pattern.modifiers;
    match &pattern.kind {
        Kind::Plain | Kind::Average => Value::Nothing,
        Kind::Cells(cells) => Value::Cells(Box::new((cells.clone(), modifiers))),
        Kind::Field(field) => {
            let turbulence = pattern.space.turbulence.as_deref().copied().unwrap_or_default();
            Value::Field(Box::new(Number { field: field.clone(), modifiers, turbulence, noise: pattern.noise }))
        }
    }
}

/// What was written last is undone first.
fn way(pattern: &Pattern) -> Box<[Leg]> {
    let space = &pattern.space;
    let mut way = vec![];
    let mut affine = space.transform.inv;
    for step in space.inner.iter().rev() {
        match step {
            Step::Moved(transform) => affine = transform.inv * affine,
            Step::Warped(warp) => {
                way.push(Leg::Affine(std::mem::take(&mut affine)));
                way.push(Leg::Warp(warp.clone()));
            }
        }
    }
    way.push(Leg::Affine(affine));
    let stirs = matches!(&pattern.kind, Kind::Field(field) if field.stirs());
    if let Some(turbulence) = space.turbulence.as_deref().filter(|t| !stirs && t.amount != DVec3::ZERO) {
        way.push(Leg::Turbulence(turbulence.amount, turbulence.series()));
    }
    way.retain(|leg| !matches!(leg, Leg::Affine(inverse) if *inverse == DAffine3::IDENTITY));
    way.into()
}
