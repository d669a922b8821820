//! The command `durer query INPUT`: lists the contents of a scene, with positions in the text and sizes in the world.

use super::args::QueryArgs;
use super::console::Console;
use super::exit::{Exit, Result};
use super::overlay::Invocation;
use super::pick::Position;
use super::session;
use crate::interpreter::ParsedFiles;
use crate::light::{Beam, Light};
use crate::math::{Aabb, DVec3, Transform};
use crate::scene::{Object, ObjectKind, Scene};
use crate::source::{Sources, Span};
use crate::texture::{Paint, Texture};
use crate::value::format_decimal;
use crate::world::{Probe, World};
use crate::{Built, Keep};
use serde::Serialize;
use serde_json::Value;
use std::collections::HashMap;
use std::sync::Arc;

/// Output of `durer query --json`: the contents of a scene.
#[derive(Serialize, Default)]
struct Contents {
    cameras: Vec<CameraRow>,
    lights: Vec<LightRow>,
    objects: Vec<ObjectRow>,
    textures: Vec<TextureRow>,
}

#[derive(Serialize)]
struct CameraRow {
    source: Option<Position>,
    /// True for the camera that renders the picture.
    used: bool,
    /// Projection of the rendering camera; this and the following fields are null for all other cameras.
    projection: Option<String>,
    location: Option<[f64; 3]>,
    direction: Option<[f64; 3]>,
}

#[derive(Serialize)]
struct LightRow {
    source: Option<Position>,
    kind: &'static str,
    location: [f64; 3],
    color: [f64; 3],
}

#[derive(Serialize)]
struct ObjectRow {
    source: Option<Position>,
    word: &'static str,
    /// Number of shapes in the object.
    shapes: u32,
    /// Corners of the bounding box in world space; null for infinite and for empty objects.
    #[serde(rename = "box")]
    pov_bounds: Option<[[f64; 3]; 2]>,
    infinite: bool,
    /// Index of the object's texture in the list `textures`.
    texture: usize,
}

#[derive(Serialize)]
struct TextureRow {
    pigment: String,
    layers: usize,
    /// Number of outermost objects that have this texture.
    objects: usize,
    /// Position of the first object that has this texture.
    first: Option<Position>,
}

/// Prints a list of a scene's cameras, lights, objects and textures.
pub fn run(console: &Console, args: &QueryArgs) -> Result {
    let invocation = Invocation::without_picture(&session::existing_scene_path(&args.input), &args.scene, None);
    let (_, Invocation { input, args: merged, animation, .. }) = invocation.with_ini(console, &Sources::default())?;
    let scene = merged.scene;
    session::check_input(&input)?;
    let timing = session::timing(&scene, animation.as_ref())?;
    let contents = session::within_limits(&scene, || {
        let sources = Sources::default();
        let file = session::open_or_report(console, &sources, &input)?;
        let options = session::reading_options(&scene, &input, timing);
        let mut built = session::build(console, &ParsedFiles::default(), &sources, file, &options, Keep::Both);
        let world = session::report_and_take_world(console, &sources, &mut built)?;
        Ok(contents(&built, &world, &sources))
    })?;
    if args.json {
        console.write_json_to_stdout(&contents)?;
    } else {
        console.write_to_stdout(in_words(&contents))?;
    }
    Ok(Exit::Fine)
}

fn contents(built: &Built, world: &World, sources: &Sources) -> Contents {
    let Some(scene) = &built.scene else { return Contents::default() };
    let mut out = Contents { cameras: cameras(scene, world, sources), ..Contents::default() };
    let mut numbers = HashMap::new();
    for object in &scene.objects {
        add_lights(object, &Transform::default(), sources, &mut out.lights);
        if matches!(object.kind, ObjectKind::Light(_)) {
            continue;
        }
        let texture = object.texture.as_ref().map_or(&object.default_texture, |painted| &painted.texture);
        let source = sources.place(object.source).map(Position::from);
        let number = *numbers.entry(Arc::as_ptr(texture)).or_insert_with(|| {
            out.textures.push(texture_row(texture, source.clone()));
            out.textures.len() - 1
        });
        out.textures[number].objects += 1;
        let pov_bounds = surface_or_pov_bounds(object);
        let is_infinite = !pov_bounds.is_empty() && !is_finite(&pov_bounds);
        let corners =
            (is_finite(&pov_bounds) && !pov_bounds.is_empty()).then(|| [pov_bounds.min.into(), pov_bounds.max.into()]);
        out.objects.push(ObjectRow {
            source,
            word: object.word,
            shapes: object.weight().n_shapes(),
            pov_bounds: corners,
            infinite: is_infinite,
            texture: number,
        });
    }
    out
}

/// Returns all cameras of the scene; the last one renders the picture.
fn cameras(scene: &Scene, world: &World, sources: &Sources) -> Vec<CameraRow> {
    let spans = if scene.cameras.is_empty() { &[Span::NONE][..] } else { &scene.cameras };
    let row = |(i, span): (usize, &Span)| {
        let used = i + 1 == spans.len();
        let frame = used.then_some(world.eye.frame);
        CameraRow {
            source: sources.place(*span).map(Position::from),
            used,
            projection: used.then(|| kind_word(&world.eye.projection)),
            location: frame.map(|frame| frame.origin.into()),
            direction: frame.and_then(|frame| frame.direction.try_normalize()).map(Into::into),
        }
    };
    spans.iter().enumerate().map(row).collect()
}

/// Adds the lights in an object, whose parent has the transform `parent_transform`.
fn add_lights(object: &Object, parent_transform: &Transform, sources: &Sources, out: &mut Vec<LightRow>) {
    let transform = object.transform.then(parent_transform);
    match &object.kind {
        ObjectKind::Light(lit) => out.push(light_row(&lit.light, &transform, sources)),
        ObjectKind::Csg(_, parts) => parts.iter().for_each(|part| add_lights(part, &transform, sources, out)),
        ObjectKind::Shape(_) => {}
    }
}

fn light_row(light: &Light, world_from_light: &Transform, sources: &Sources) -> LightRow {
    let kind = match light.beam {
        _ if light.parallel => "parallel",
        Beam::Round if light.spreads => "area_light",
        Beam::Round => "point",
        Beam::Spotlight(_) => "spotlight",
        Beam::Cylinder(_) => "cylinder",
    };
    let source = sources.place(light.source).map(Position::from);
    LightRow {
        source,
        kind,
        location: world_from_light.transform_point(light.location).into(),
        color: light.color.into(),
    }
}

fn texture_row(texture: &Texture, first: Option<Position>) -> TextureRow {
    let top = texture.layers.last();
    let pigment = top.map(|layer| match (&layer.choice, &layer.pigment.pattern.explicit_value()) {
        (Some(choice), _) => kind_word(&choice.pattern.kind),
        (None, Some(pattern)) => kind_word(&pattern.kind),
        (None, None) => match &layer.pigment.paint {
            Paint::Solid(color) => {
                let DVec3 { x, y, z } = color.rgb;
                let clear = [color.filter, color.transmit];
                if clear == [0.0; 2] {
                    return format!("rgb {}", format_vector_rounded(&[x, y, z]));
                }
                format!("rgbft {}", format_vector_rounded(&[x, y, z, clear[0], clear[1]]))
            }
            other => kind_word(other),
        },
    });
    TextureRow { pigment: pigment.unwrap_or_default(), layers: texture.layers.len(), objects: 0, first }
}

/// Returns the word for the kind of a serialized item of the language, at most at the second level: `granite` of
/// `{"field": {"granite": …}}`.
fn kind_word(thing: &impl Serialize) -> String {
    let mut value = serde_json::to_value(thing).unwrap_or_default();
    let mut name = String::new();
    for _ in 0..2 {
        match value {
            Value::String(word) => return word,
            Value::Object(fields) if fields.len() == 1 => {
                let Some((word, inner)) = fields.into_iter().next() else { break };
                (name, value) = (word, inner);
            }
            _ => break,
        }
    }
    name
}

/// Returns the bounding box of an object's surfaces, or the box of `max_extent` for an object that the World lacks.
fn surface_or_pov_bounds(object: &Object) -> Aabb {
    Probe::new(object).map_or_else(|_| object.pov_bounds(), |probe| probe.bounds())
}

/// Distance from the origin beyond which an object counts as infinite, in world units.
const FAR: f64 = 1e9;

fn is_finite(pov_bounds: &Aabb) -> bool {
    pov_bounds.is_finite() && pov_bounds.min.min_element() > -FAR && pov_bounds.max.max_element() < FAR
}

// ------------------------------------------------------------ output for a person

fn in_words(contents: &Contents) -> String {
    let mut rows: Vec<[String; 2]> = vec![];
    let place = |source: &Option<Position>| match source {
        Some(source) => format!("{}:{}:{}", source.file, source.line, source.column),
        None => String::new(),
    };
    for camera in &contents.cameras {
        let text = match (&camera.projection, camera.location, camera.direction) {
            (Some(projection), Some(at), Some(to)) => {
                format!("{projection} at {}, looks along {}", format_vector_rounded(&at), format_vector_rounded(&to))
            }
            _ => "not used: another one follows".into(),
        };
        rows.push([place(&camera.source), format!("camera    {text}")]);
    }
    for light in &contents.lights {
        let (at, color) = (format_vector_rounded(&light.location), format_vector_rounded(&light.color));
        rows.push([place(&light.source), format!("light     {} at {at}, rgb {color}", light.kind)]);
    }
    for at_one_position in contents.objects.chunk_by(|a, b| a.source == b.source && a.word == b.word) {
        rows.push([place(&at_one_position[0].source), format!("object    {}", objects_in_words(at_one_position))]);
    }
    let mut number = 1;
    for at_one_position in contents.textures.chunk_by(|a, b| a.first == b.first) {
        rows.push([
            place(&at_one_position[0].first),
            format!("texture   {}", textures_in_words(at_one_position, number)),
        ]);
        number += at_one_position.len();
    }
    let width = rows.iter().map(|[place, _]| place.chars().count()).max().unwrap_or(0).min(40);
    rows.iter().map(|[place, text]| format!("{place:width$}  {text}\n")).collect()
}

/// Describes objects that one position in the text created.
fn objects_in_words(at_one_position: &[ObjectRow]) -> String {
    let first = &at_one_position[0];
    let count = if at_one_position.len() > 1 { format!("{} × ", at_one_position.len()) } else { String::new() };
    let corner = |corners: [f64; 3]| DVec3::from_array(corners);
    let boxes =
        at_one_position.iter().filter_map(|row| row.pov_bounds).map(|[a, b]| Aabb { min: corner(a), max: corner(b) });
    let pov_bounds = match boxes.reduce(Aabb::union) {
        _ if at_one_position.iter().any(|row| row.infinite) => "infinite".into(),
        Some(all) => {
            format!("{} to {}", format_vector_rounded(&all.min.to_array()), format_vector_rounded(&all.max.to_array()))
        }
        None => "empty".into(),
    };
    let shapes =
        if first.shapes > 1 { format!(" of {}", counted(first.shapes as usize, "shape")) } else { String::new() };
    let textures = at_one_position.iter().map(|row| row.texture + 1);
    let range = (textures.clone().min().unwrap_or(0), textures.max().unwrap_or(0));
    format!("{count}{}{shapes}, {pov_bounds}, {}", first.word, number_range_text("texture", range))
}

/// Describes textures that one position in the text created; `first_number` is that of the first one.
fn textures_in_words(at_one_position: &[TextureRow], first_number: usize) -> String {
    let first = &at_one_position[0];
    let layers = if first.layers > 1 { format!(", {} layers", first.layers) } else { String::new() };
    let more =
        if at_one_position.len() > 1 { format!(" and {} more", at_one_position.len() - 1) } else { String::new() };
    let on = counted(at_one_position.iter().map(|texture| texture.objects).sum(), "object");
    format!(
        "{}: {}{layers}{more}; on {on}",
        number_range_text("number", (first_number, first_number + at_one_position.len() - 1)),
        first.pigment
    )
}

fn number_range_text(what: &str, (first, last): (usize, usize)) -> String {
    if first == last { format!("{what} {first}") } else { format!("{what}s {first} to {last}") }
}

fn counted(n: usize, thing: &str) -> String {
    format!("{n} {thing}{}", if n == 1 { "" } else { "s" })
}

/// Formats a vector as `<1, 0.5, 0>`, with at most four decimals (enough to find an object) and without trailing zeros.
fn format_vector_rounded(numbers: &[f64]) -> String {
    let texts: Vec<_> =
        numbers.iter().map(|x| if x.is_finite() { format_decimal(*x, 4) } else { x.to_string() }).collect();
    format!("<{}>", texts.join(", "))
}
