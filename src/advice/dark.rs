//! The warning about a picture that is black although it shows objects.

use super::{first_shape_and_span, hit_shape_and_span, unseen};
use crate::diagnostic::{Diagnostic, codes};
use crate::math::DVec3;
use crate::render;
use crate::source::Span;
use crate::world::{LayerColor, World};

/// Returns the warning that explains why the picture, which is known to be black, is black; `None` for an empty world.
pub(super) fn known_black_picture_warning(world: &World, options: &render::Options) -> Option<Diagnostic> {
    if world.geometry.is_empty() {
        return None;
    }
    let BlackPictureCause { span, reason, help } = black_picture_cause(world, options);
    let d = Diagnostic::new(codes::BLACK_PICTURE, span, format!("the picture is black: {reason}"));
    Some(d.help(help))
}

/// Cause of a black picture.
struct BlackPictureCause {
    /// Span of the cause; [`Span::NONE`] without a place in the text.
    span: Span,
    /// Reason in words.
    reason: String,
    /// Remedy in words.
    help: String,
}

/// Returns the cause of a black picture.
fn black_picture_cause(world: &World, options: &render::Options) -> BlackPictureCause {
    let emitter = || "`light_source { <10, 20, -10>, rgb 1 }`".to_string();
    if world.lights.is_empty() {
        let reason = "the scene has no light, and no object is luminous".into();
        return BlackPictureCause { span: Span::NONE, reason, help: emitter() };
    }
    if world.lights.iter().all(|light| light.emitter.color.max_element() <= 0.0) {
        return BlackPictureCause { span: Span::NONE, reason: "all of its lights are black".into(), help: emitter() };
    }
    if let Some(found) = enclosed_lights_cause(world) {
        return found;
    }
    if let Some(found) = black_objects_cause(world, options) {
        return found;
    }
    let help = "move a `light_source` so that it illuminates the visible objects".to_string();
    BlackPictureCause { span: Span::NONE, reason: "no light reaches the visible objects".into(), help }
}

/// Returns the cause if all lights are inside of opaque objects; else `None`.
fn enclosed_lights_cause(world: &World) -> Option<BlackPictureCause> {
    let mut first = None;
    for light in &world.lights {
        let around = enclosing_shape_and_span(world, light.emitter.location)?;
        first.get_or_insert(around);
    }
    let (word, source) = first?;
    let help = "move the light out of it, or write `no_shadow` in the object".to_string();
    Some(BlackPictureCause { span: source, reason: format!("the light is inside of this `{word}`"), help })
}

fn enclosing_shape_and_span(world: &World, p: DVec3) -> Option<(&'static str, Span)> {
    let mut found = None;
    world.geometry.visit_containing(p, &mut |item| {
        let casts = world.objects.get(item.object() as usize).is_some_and(|o| o.opaque && o.shadow);
        if casts && found.is_none() {
            found = first_shape_and_span(world, item);
        }
    });
    found
}

/// Returns the cause if all visible objects are black; else `None`.
fn black_objects_cause(world: &World, options: &render::Options) -> Option<BlackPictureCause> {
    let mut first = None;
    for found in unseen::sampled_first_hits(world, options) {
        let material = world.parts.get(found.part_number() as usize)?.outside.material;
        let mut layers = world.materials.get(material as usize)?.layers.iter();
        let black = |color: &LayerColor| matches!(color, LayerColor::Solid(c) if c.rgb.max_element() <= 0.0);
        if !layers.all(|layer| layer.choice.is_none() && black(&layer.pigment)) {
            return None;
        }
        first.get_or_insert(hit_shape_and_span(world, &found));
    }
    let (word, source) = first?;
    let help = "`pigment { rgb <1, 0.5, 0> }`; an object without a pigment is black".to_string();
    let reason = format!("all visible objects are black, such as this `{word}`");
    Some(BlackPictureCause { span: source, reason, help })
}
