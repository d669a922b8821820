//! The warning about a picture that is black although it shows objects.

use super::{first_shape_name, hit_shape_name, unseen};
use crate::diagnostic::{Diagnostic, codes};
use crate::math::DVec3;
use crate::render;
use crate::source::Span;
use crate::world::{LayerColor, World};

/// Returns the warning that explains a black picture.
pub(super) fn black_picture_warning(world: &World, options: &render::Options) -> Option<Diagnostic> {
    if world.geometry.is_empty() {
        return None;
    }
    let (at, reason, help) = reason(world, options);
    let d = Diagnostic::new(codes::BLACK_PICTURE, at, format!("the picture is black: {reason}"));
    Some(d.help(help))
}

/// Returns the cause of a black picture: the span of the cause, the reason in words, and the remedy.
fn reason(world: &World, options: &render::Options) -> (Span, String, String) {
    let emitter = || "`light_source { <10, 20, -10>, rgb 1 }`".to_string();
    if world.lights.is_empty() {
        return (Span::NONE, "the scene has no light, and no object is luminous".into(), emitter());
    }
    if world.lights.iter().all(|light| light.emitter.color.max_element() <= 0.0) {
        return (Span::NONE, "all of its lights are black".into(), emitter());
    }
    if let Some(found) = enclosed_lights(world) {
        return found;
    }
    if let Some(found) = black_objects(world, options) {
        return found;
    }
    let help = "move a `light_source` so that it illuminates the visible objects".to_string();
    (Span::NONE, "no light reaches the visible objects".into(), help)
}

/// Returns the span, the reason in words and the remedy, if all lights are inside of opaque objects; else `None`.
fn enclosed_lights(world: &World) -> Option<(Span, String, String)> {
    let mut first = None;
    for light in &world.lights {
        let around = enclosing_object(world, light.emitter.location)?;
        first.get_or_insert(around);
    }
    let (word, source) = first?;
    let help = "move the light out of it, or write `no_shadow` in the object".to_string();
    Some((source, format!("the light is inside of this `{word}`"), help))
}

fn enclosing_object(world: &World, p: DVec3) -> Option<(&'static str, Span)> {
    let mut found = None;
    world.geometry.containing(p, &mut |item| {
        let casts = world.objects.get(item.object() as usize).is_some_and(|o| o.opaque && o.shadow);
        if casts && found.is_none() {
            found = first_shape_name(world, item);
        }
    });
    found
}

/// Returns the span, the reason in words and the remedy, if all visible objects are black; else `None`.
fn black_objects(world: &World, options: &render::Options) -> Option<(Span, String, String)> {
    let mut first = None;
    for found in unseen::sample(world, options) {
        let material = world.parts.get(found.part_number() as usize)?.outside.material;
        let mut layers = world.materials.get(material as usize)?.layers.iter();
        let black = |color: &LayerColor| matches!(color, LayerColor::Solid(c) if c.rgb.max_element() <= 0.0);
        if !layers.all(|layer| layer.choice.is_none() && black(&layer.pigment)) {
            return None;
        }
        first.get_or_insert(hit_shape_name(world, &found));
    }
    let (word, source) = first?;
    let help = "`pigment { rgb <1, 0.5, 0> }`; an object without a pigment is black".to_string();
    Some((source, format!("all visible objects are black, such as this `{word}`"), help))
}
