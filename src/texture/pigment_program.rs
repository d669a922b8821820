//! Pigments in the form that rays evaluate: a list of nodes instead of a tree.

use super::{Blend, ColorMap, ImageMap, Paint, Pigment};
use crate::color::{Color, Rgb, gray};
use crate::function::LocalBounds;
use crate::math::{DVec3, Ray, cancel};
use crate::pattern::{Pattern, PatternKind, PatternProgram, PigmentBrightness, TextureContext};
use serde::Serialize;
use std::sync::Arc;

/// Lowered pigment, in the form that is evaluated.
#[derive(Clone, Debug, Serialize)]
pub struct PigmentProgram {
    /// Nodes of the lowered pigment and of those nested in it. Each node follows the nodes that it refers to; the last
    /// one is the whole pigment.
    nodes: Box<[PigmentNode]>,
    /// True if the whole texture of the lowered pigment has `uv_mapping`.
    #[serde(skip_serializing_if = "std::ops::Not::not")]
    framed: bool,
}

/// Node of a lowered pigment: the pigment itself, or one nested in it.
#[derive(Clone, Debug, Serialize)]
struct PigmentNode {
    pattern: PatternProgram,
    shows: Shows,
}

/// Source of the colour of a lowered pigment's node.
#[derive(Clone, Debug, Serialize)]
enum Shows {
    Solid(Color),
    /// Colour map, and the number below which a pattern need not compute numbers exactly
    /// ([`FieldParams::constant_below`](crate::pattern::FieldParams::constant_below)).
    Colors(Arc<ColorMap>, #[serde(skip)] f64),
    /// Selection from other pigments, by the indices of their nodes.
    Pigments(Blend<u32>),
    Image(Arc<ImageMap>),
}

impl PigmentProgram {
    /// Lowers a pigment to the form that is evaluated.
    pub fn new(pigment: &Pigment) -> Self {
        let mut nodes = vec![];
        push_nodes_returning_root(pigment, &mut nodes);
        Self { nodes: nodes.into(), framed: pigment.pattern.framed }
    }

    /// Returns the pigment's colour at a point in the texture's space, before the pigment's own transforms and warps.
    pub fn color_at(&self, ctx: &TextureContext) -> Color {
        self.node_color(self.nodes.len() - 1, ctx)
    }

    /// Returns [`Self::color_at`] at four points.
    pub fn colors_at(&self, ctx: &[TextureContext; 4]) -> [Color; 4] {
        match self.nodes.last() {
            Some(PigmentNode { pattern, shows: Shows::Colors(map, _) }) => pattern
                .numbers_in_pattern_space(ctx.each_ref().map(|ctx| pattern.to_pattern_space(ctx)))
                .map(|number| map.color_at(number)),
            _ => ctx.each_ref().map(|ctx| self.color_at(ctx)),
        }
    }

    /// True if the pigment's pattern takes a long chain of operations, so that [`Self::colors_at`] takes little more time than one
    /// colour.
    pub fn takes_long_chain(&self) -> bool {
        matches!(self.nodes.last(), Some(PigmentNode { pattern, shows: Shows::Colors(..) }) if pattern.takes_long_chain())
    }

    /// True if the pigment has no colour at the point because it is outside of pictures with `once`.
    pub fn is_outside_once_pictures(&self, ctx: &TextureContext) -> bool {
        self.node_has_no_color(self.nodes.len() - 1, ctx, self.framed)
    }

    /// True if a node of the lowered pigment has no colour at the point. (False for an average and for a pigment with a
    /// `uv_mapping` of its own; quirk: `pictures_once`.)
    fn node_has_no_color(&self, i: usize, ctx: &TextureContext, uv_mapped_by_texture: bool) -> bool {
        let PigmentNode { pattern, shows } = &self.nodes[i];
        match shows {
            _ if pattern.is_average() || (pattern.receives_uv() && !uv_mapped_by_texture) => false,
            Shows::Solid(_) | Shows::Colors(..) => false,
            Shows::Image(image) => !image.covers_point(pattern.to_pattern_space(ctx).p),
            Shows::Pigments(parts) => {
                let (number, inner) = pattern.number_and_entry_context(ctx);
                parts
                    .weighted_values(number, false)
                    .iter()
                    .all(|(i, _)| self.node_has_no_color(**i as usize, &inner, false))
            }
        }
    }

    /// Returns the number of the pigment's pattern at a point, without the map: the index of the cell, or the number
    /// after the wave.
    pub fn pattern_number_at(&self, ctx: &TextureContext) -> f64 {
        self.nodes.last().map_or(0.0, |node| node.pattern.pattern_number_at(ctx))
    }

    /// Bounds on [`Self::pattern_number_at`] within a radius of a point.
    pub fn value_bounds_near(&self, ctx: &TextureContext, radius: f64) -> LocalBounds {
        self.nodes.last().map_or(LocalBounds::UNKNOWN, |node| node.pattern.value_bounds_near(ctx, radius))
    }

    /// Bounds on the components of [`Self::color_at`] (red, green, blue, filter, transmit) within a radius of a point.
    pub fn color_bounds_near(&self, ctx: &TextureContext, radius: f64) -> [LocalBounds; 5] {
        match self.nodes.last() {
            Some(PigmentNode { shows: Shows::Solid(color), .. }) => color.to_array().map(LocalBounds::constant),
            Some(PigmentNode { shows: Shows::Colors(map, _), pattern }) => {
                map.component_bounds_for(pattern.value_bounds_near(ctx, radius))
            }
            _ => [LocalBounds::UNKNOWN; 5],
        }
    }

    /// True if [`Self::known_support_on_ray`] returns the ends of a region.
    pub fn has_support(&self) -> bool {
        self.pattern_if_black_outside().is_some()
    }

    /// Returns distances along a ray of the outer space outside of which the pigment is black: an empty range if it is
    /// black along the whole ray; `None` if no such region is known.
    pub fn known_support_on_ray(&self, ray: &Ray) -> Option<[f64; 2]> {
        self.pattern_if_black_outside()?.known_support_on_ray(ray)
    }

    /// True if the pigment is certainly black everywhere in the parallelepiped with these eight corners, in the outer
    /// space; its edges need not be parallel to the axes.
    pub fn is_black_in_hull_of(&self, corners: [DVec3; 8]) -> bool {
        self.pattern_if_black_outside().is_some_and(|pattern| pattern.is_hull_outside_support(corners))
    }

    /// Returns the pigment's pattern if the pigment is black outside of the pattern's support.
    fn pattern_if_black_outside(&self) -> Option<&PatternProgram> {
        match self.nodes.last() {
            Some(PigmentNode { shows: Shows::Colors(map, _), pattern }) => {
                let outside = pattern.number_outside_support()?;
                (map.color_at(outside).rgb == Rgb::ZERO).then_some(pattern)
            }
            _ => None,
        }
    }

    fn node_color(&self, i: usize, ctx: &TextureContext) -> Color {
        let PigmentNode { pattern, shows } = &self.nodes[i];
        match shows {
            Shows::Solid(color) => *color,
            Shows::Colors(map, constant_below) => map.color_at(pattern.pattern_number_for_map(ctx, *constant_below)),
            Shows::Image(image) => image.color_at(pattern.to_pattern_space(ctx).p),
            Shows::Pigments(parts) => {
                let (number, inner) = pattern.number_and_entry_context(ctx);
                match parts.weighted_values(number, pattern.is_average())[..] {
                    [(i, 1.0)] => self.node_color(*i as usize, &inner),
                    // Both neighbours are the same node.
                    [(i, _), (j, _)] if i == j && !pattern.is_average() => self.node_color(*i as usize, &inner),
                    ref shares => self.sum_colors(shares, &inner),
                }
            }
        }
    }
}

impl PigmentProgram {
    /// Returns the sum of the nodes' colours, each times its share. Nodes that follow each other and are the same one
    /// are evaluated once, so that nested averages of one pigment do not take exponential time.
    fn sum_colors(&self, shares: &[(&u32, f64)], inner: &TextureContext) -> Color {
        let (mut sum, mut last) = (Color::BLACK, None);
        for &(&i, share) in shares {
            let color = match last {
                Some((known, color)) if known == i => color,
                _ if cancel::is_cancelled() => return sum,
                _ => self.node_color(i as usize, inner),
            };
            sum = sum.plus_scaled(color, share);
            last = Some((i, color));
        }
        sum
    }
}

/// Brightness of a pigment, for `pigment_pattern { … }`.
#[derive(Debug)]
pub struct Brightness {
    pigment: PigmentProgram,
    depends_on_uv: bool,
}

impl Brightness {
    /// Lowers a pigment whose brightness a pattern uses.
    pub fn new(pigment: &Pigment) -> Self {
        Self { pigment: PigmentProgram::new(pigment), depends_on_uv: pigment.any_pattern(&Pattern::depends_on_uv) }
    }
}

impl PigmentBrightness for Brightness {
    fn brightness(&self, at: &TextureContext) -> f64 {
        // Points without a colour are dark, although their colour is a clear white (quirk: pictures_once).
        if self.pigment.is_outside_once_pictures(at) { 0.0 } else { gray(self.pigment.color_at(at).rgb) }
    }

    fn depends_on_uv(&self) -> bool {
        self.depends_on_uv
    }
}

/// Appends the nodes of a lowered pigment; returns the index of its own node.
fn push_nodes_returning_root(pigment: &Pigment, nodes: &mut Vec<PigmentNode>) -> u32 {
    let shows = match &pigment.paint {
        // A map without a pattern is black (quirk: map_without_pattern).
        Paint::Colors(_) | Paint::Pigments(Blend::Map(_)) if matches!(pigment.pattern.kind, PatternKind::Plain) => {
            Shows::Solid(Color::BLACK)
        }
        Paint::Solid(color) => Shows::Solid(*color),
        Paint::Colors(map) => {
            let unchanged = pigment.pattern.modifiers.keep_unit_interval();
            Shows::Colors(map.clone(), if unchanged { map.end_of_constant_start() } else { 0.0 })
        }
        Paint::Image(image) => Shows::Image(image.clone()),
        Paint::Pigments(parts) => Shows::Pigments(
            parts.map_runs(Pigment::is_certainly_equal, |entry| push_nodes_returning_root(entry, nodes)),
        ),
    };
    nodes.push(PigmentNode { pattern: PatternProgram::new(&pigment.pattern), shows });
    nodes.len() as u32 - 1
}
