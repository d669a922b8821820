//! Pigments as a ray needs them: a row of nodes in place of a tree.

use super::{Blend, ColorMap, ImageMap, Paint, Pigment};
use crate::color::{Color, gray};
use crate::function::LocalBounds;
use crate::pattern::{Kind, Pattern, PatternProgram, PigmentBrightness, TextureContext};
use serde::Serialize;
use std::sync::Arc;

/// A lowered pigment: the one way in which colours of an author's [`Pigment`] are seen.
#[derive(Clone, Debug, Serialize)]
pub struct PigmentProgram {
    /// That of the whole pigment is the last: each stands behind those it is made of.
    nodes: Box<[PigmentNode]>,
    /// It is mapped by uv because all of its texture is.
    #[serde(skip_serializing_if = "std::ops::Not::not")]
    framed: bool,
}

/// A pigment within a pigment.
#[derive(Clone, Debug, Serialize)]
struct PigmentNode {
    pattern: PatternProgram,
    shows: Shows,
}

/// What is seen.
#[derive(Clone, Debug, Serialize)]
enum Shows {
    Solid(Color),
    Colors(Arc<ColorMap>),
    /// Nodes.
    Pigments(Blend<u32>),
    Image(Arc<ImageMap>),
}

impl PigmentProgram {
    /// Lowers a pigment.
    pub fn new(pigment: &Pigment) -> Self {
        let mut nodes = vec![];
        push(pigment, &mut nodes);
        Self { nodes: nodes.into(), framed: pigment.pattern.framed }
    }

    /// The colour at a point of the space around it.
    pub fn at(&self, ctx: &TextureContext) -> Color {
        self.node(self.nodes.len() - 1, ctx)
    }

    /// Is there no colour at a point, because it lies outside of pictures that are there `once`?
    pub fn is_nothing(&self, ctx: &TextureContext) -> bool {
        self.has_nothing(self.nodes.len() - 1, ctx, self.framed)
    }

    /// (What is averaged, or has a `uv_mapping` of its own, always is something: measured on POV-Ray 3.7.)
    fn has_nothing(&self, i: usize, ctx: &TextureContext, framed: bool) -> bool {
        let PigmentNode { pattern, shows } = &self.nodes[i];
        match shows {
            _ if pattern.averages() || (pattern.by_uv() && !framed) => false,
            Shows::Solid(_) | Shows::Colors(_) => false,
            Shows::Image(image) => !image.holds(pattern.enter(ctx).p),
            Shows::Pigments(parts) => {
                let (number, inner) = pattern.see(ctx);
                parts.shares(number, false).iter().all(|(i, _)| self.has_nothing(**i as usize, &inner, false))
            }
        }
    }

    /// What the pattern gives at a point, without its map: the number of the cell, or what the wave makes of the number.
    pub fn number_at(&self, ctx: &TextureContext) -> f64 {
        self.nodes.last().map_or(0.0, |node| node.pattern.number_at(ctx))
    }

    /// What is known of [`Self::number_at`] no farther from a point than a radius.
    pub fn bounds_near(&self, ctx: &TextureContext, radius: f64) -> LocalBounds {
        self.nodes.last().map_or(LocalBounds::UNKNOWN, |node| node.pattern.bounds_near(ctx, radius))
    }

    /// The same of what [`Self::at`] gives: red, green, blue, filter, transmit.
    pub fn colors_near(&self, ctx: &TextureContext, radius: f64) -> [LocalBounds; 5] {
        match self.nodes.last() {
            Some(PigmentNode { shows: Shows::Solid(color), .. }) => color.to_array().map(LocalBounds::constant),
            Some(PigmentNode { shows: Shows::Colors(map), pattern }) => {
                map.bounds_near(pattern.bounds_near(ctx, radius))
            }
            _ => [LocalBounds::UNKNOWN; 5],
        }
    }

    fn node(&self, i: usize, ctx: &TextureContext) -> Color {
        let PigmentNode { pattern, shows } = &self.nodes[i];
        match shows {
            Shows::Solid(color) => *color,
            Shows::Colors(map) => map.at(pattern.number_at(ctx)),
            Shows::Image(image) => image.at(pattern.enter(ctx).p),
            Shows::Pigments(parts) => {
                let (number, inner) = pattern.see(ctx);
                match parts.shares(number, pattern.averages())[..] {
                    [(i, 1.0)] => self.node(*i as usize, &inner),
                    // Between two that are the same.
                    [(i, _), (j, _)] if i == j && !pattern.averages() => self.node(*i as usize, &inner),
                    ref shares => shares
                        .iter()
                        .fold(Color::BLACK, |sum, (i, share)| sum.plus(self.node(**i as usize, &inner), *share)),
                }
            }
        }
    }
}

/// What `pigment_pattern { … }` sees of a pigment.
#[derive(Debug)]
pub struct Brightness {
    pigment: PigmentProgram,
    asks_uv: bool,
}

impl Brightness {
    /// Lowers a pigment.
    pub fn new(pigment: &Pigment) -> Self {
        Self { pigment: PigmentProgram::new(pigment), asks_uv: pigment.any_pattern(&Pattern::asks_uv) }
    }
}

impl PigmentBrightness for Brightness {
    fn brightness(&self, at: &TextureContext) -> f64 {
        // Where it has no colour it is dark, though its colour is a clear white there (measured on POV-Ray 3.7).
        if self.pigment.is_nothing(at) { 0.0 } else { gray(self.pigment.at(at).rgb) }
    }

    fn asks_uv(&self) -> bool {
        self.asks_uv
    }
}

/// Appends the nodes of a pigment; the number of its own.
fn push(pigment: &Pigment, nodes: &mut Vec<PigmentNode>) -> u32 {
    let shows = match &pigment.paint {
        // A map without a pattern is black (measured on POV-Ray 3.7).
        Paint::Colors(_) | Paint::Pigments(Blend::Map(_)) if matches!(pigment.pattern.kind, Kind::Plain) => {
            Shows::Solid(Color::BLACK)
        }
        Paint::Solid(color) => Shows::Solid(*color),
        Paint::Colors(map) => Shows::Colors(map.clone()),
        Paint::Image(image) => Shows::Image(image.clone()),
        Paint::Pigments(parts) => Shows::Pigments(parts.map_runs(Pigment::is_plainly, |entry| push(entry, nodes))),
    };
    nodes.push(PigmentNode { pattern: PatternProgram::new(&pigment.pattern), shows });
    nodes.len() as u32 - 1
}
