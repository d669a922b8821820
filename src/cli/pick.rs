//! The command `durer pick INPUT X,Y`: describes the object that one pixel shows, and the text that created the object.

use super::animation::Animation;
use super::args::values::Size;
use super::args::{PickArgs, SceneArgs};
use super::console::Console;
use super::exit::{Exit, Result};
use super::overlay::Invocation;
use super::session;
use crate::color::transfer;
use crate::diagnostic::{Diagnostic, Label, codes};
use crate::interpreter::{self, ParsedFiles, Timing};
use crate::math::fp;
use crate::render::{self, Picked, Region, Unwatched};
use crate::scene::Scene;
use crate::source::{Place, Sources, Span};
use crate::value::format_decimal;
use crate::world::World;
use crate::{Built, Keep};
use serde::Serialize;
use std::path::Path;

/// Output of `durer pick --json`.
#[derive(Serialize)]
struct Output<'a> {
    hit: bool,
    #[serde(flatten)]
    object: Option<PickedObject<'a>>,
}

#[derive(Serialize)]
struct PickedObject<'a> {
    shape: &'a str,
    /// Distance of the hit from the camera, in world units.
    t: f64,
    point: [f64; 3],
    normal: [f64; 3],
    uv: [f64; 2],
    /// Linear red, green and blue of the picture at the picked pixel.
    color: [f64; 3],
    source: Option<Position>,
    /// Position of the outermost object that contains the picked object.
    placed: Option<Position>,
    /// Macro calls and includes that created the object, innermost first.
    trace: Vec<Step>,
}

/// A position in a text, as JSON output gives it.
#[derive(Serialize, Clone, PartialEq)]
pub(super) struct Position {
    pub file: String,
    pub line: usize,
    pub column: usize,
}

impl From<Place> for Position {
    fn from(place: Place) -> Self {
        Self { file: place.file, line: place.line, column: place.column }
    }
}

#[derive(Serialize)]
struct Step {
    text: String,
    #[serde(flatten)]
    place: Option<Position>,
}

/// Prints the object that a pixel shows. `animation` comes from POV-Ray's options.
pub fn run(console: &Console, args: &PickArgs, animation: Option<Animation>) -> Result {
    let invocation = Invocation::without_picture(&session::existing_scene_path(&args.input), &args.scene, animation);
    let (_, Invocation { input, args: merged, animation, .. }) = invocation.with_ini(console, &Sources::default())?;
    let size = merged.scene.size();
    let inside = |at: i64, side: usize| usize::try_from(at).ok().filter(|&at| at < side);
    let (Some(x), Some(y)) = (inside(args.pixel.x, size.width), inside(args.pixel.y, size.height)) else {
        return Ok(outside_picture_error(args, size)?);
    };
    let timing = session::timing(&merged.scene, animation.as_ref())?;
    let text =
        session::within_limits(&merged.scene, || describe_pixel(console, args, &input, &merged.scene, timing, (x, y)))?;
    console.write_to_stdout(text).map(|()| Exit::Fine)
}

/// Returns the output about a pixel of the picture.
fn describe_pixel(
    console: &Console,
    args: &PickArgs,
    input: &Path,
    scene: &SceneArgs,
    timing: Timing,
    (x, y): (usize, usize),
) -> Result<String> {
    let sources = &Sources::default();
    let size = scene.size();
    let file = session::open_or_report(console, sources, input)?;
    let options = session::reading_options(scene, input, timing);
    let options = interpreter::Options { record_origins: true, ..options };
    let mut built = session::build(console, &ParsedFiles::default(), sources, file, &options, Keep::Both);
    let world = session::report_and_take_world(console, sources, &mut built)?;
    let drawing = render::Options { frame: timing.frame, ..render::Options::new(size.width, size.height) };
    let pixel = PixelReport { sources, color: color_of(&world, &drawing, x, y), built: Some(&built) };
    let picked = render::pick(&world, &drawing, x, y);
    let outermost_index = picked.as_ref().and_then(|picked| outermost_object_index(&built, &drawing, (x, y), picked));
    if args.json {
        let object = picked.as_ref().map(|p| pixel.describe(p, outermost_index));
        let output = Output { hit: object.is_some(), object };
        return Ok(serde_json::to_string(&output).unwrap_or_default() + "\n");
    }
    Ok(pixel.in_words(picked.as_ref(), outermost_index))
}

/// Describes a pixel of a finished picture for a person; `linear_rgb` is the pixel's colour in linear light.
#[cfg(feature = "watch")]
pub(super) fn pixel_in_words(sources: &Sources, picked: Option<&Picked>, linear_rgb: [f64; 3]) -> String {
    PixelReport { sources, built: None, color: linear_rgb }.in_words(picked, None)
}

/// Returns the linear colour of one pixel without anti-aliasing; black if rendering fails.
fn color_of(world: &World, drawing: &render::Options, x: usize, y: usize) -> [f64; 3] {
    let region = Some(Region { x, y, width: 1, height: 1 });
    let rendered = render::render(world, &render::Options { region, ..drawing.clone() }, &Unwatched);
    let pixel = rendered.ok().and_then(|(frame, _)| frame.pixels.get(y * frame.width + x).copied());
    let [r, g, b, _] = pixel.unwrap_or_default().map(f64::from);
    [r, g, b]
}

/// Returns the number of the outermost object that a pixel shows. A World does not contain the outermost objects, so a
/// bisection over subsets of them renders the pixel until one object is left.
fn outermost_object_index(
    built: &Built,
    drawing: &render::Options,
    (x, y): (usize, usize),
    picked: &Picked,
) -> Option<usize> {
    let scene = built.scene.as_ref()?;
    let mut range = 0..scene.objects.len();
    while range.len() > 1 {
        let middle = range.start + range.len() / 2;
        let half = Scene { objects: scene.objects[range.start..middle].to_vec(), ..scene_without_objects(scene) };
        let found = crate::world::lower(&half).ok().and_then(|world| render::pick(&world, drawing, x, y));
        let is_there = found.is_some_and(|found| found.source == picked.source && found.t == picked.t);
        range = if is_there { range.start..middle } else { middle..range.end };
    }
    Some(range.start).filter(|at| *at < built.origins.len())
}

/// Returns the scene's settings without its objects.
fn scene_without_objects(scene: &Scene) -> Scene {
    Scene { camera: scene.camera.clone(), settings: scene.settings.clone(), version: scene.version, ..Scene::default() }
}

fn outside_picture_error(args: &PickArgs, size: Size) -> crate::diagnostic::Result<Exit> {
    let (w, h) = (size.width, size.height);
    let text = format!("pixel {},{} is outside the picture of {w}x{h}", args.pixel.x, args.pixel.y);
    let help = format!("pixels go from 0,0 to {},{}; `--size` makes the picture larger", w - 1, h - 1);
    Diagnostic::new(codes::OUTSIDE_PICTURE, Span::NONE, text).help(help).into()
}

/// Data for the description of one pixel in `durer pick`.
struct PixelReport<'a> {
    sources: &'a Sources,
    /// Built scene with the origins of its objects, if it was built with them.
    built: Option<&'a Built>,
    color: [f64; 3],
}

impl PixelReport<'_> {
    /// Returns the position of the outermost object; `None` if the picked object has the same position.
    fn outermost_position(&self, picked: &Picked, outermost_index: Option<usize>) -> Option<Place> {
        let object = self.built?.scene.as_ref()?.objects.get(outermost_index?)?;
        self.sources.place(object.source).filter(|_| object.source != picked.source)
    }

    fn call_frames(&self, outermost_index: Option<usize>) -> &[Label] {
        outermost_index.and_then(|at| self.built?.origins.get(at)).map_or(&[], Vec::as_slice)
    }

    fn describe<'p>(&self, p: &'p Picked, outermost_index: Option<usize>) -> PickedObject<'p> {
        let place = |span: Span| self.sources.place(span).map(Position::from);
        let step = |label: &Label| Step { text: label.text.clone(), place: place(label.span) };
        PickedObject {
            shape: p.shape,
            t: p.t,
            point: p.point,
            normal: p.normal,
            uv: p.uv,
            color: self.color,
            source: place(p.source),
            placed: self.outermost_position(p, outermost_index).map(Position::from),
            trace: self.call_frames(outermost_index).iter().map(step).collect(),
        }
    }

    fn in_words(&self, picked: Option<&Picked>, outermost_index: Option<usize>) -> String {
        let color = format!(
            "  colour    rgb <{}>, on the screen {}\n",
            list_with_significant_digits(&self.color, 1.0),
            hex_color(self.color)
        );
        let Some(p) = picked else {
            return format!("nothing but the background\n{color}");
        };
        let place = |span: Span| self.sources.place(span).map(|place| format!(" at {place}")).unwrap_or_default();
        let placed = self
            .outermost_position(p, outermost_index)
            .map(|place| format!("  placed at {place}\n"))
            .unwrap_or_default();
        let trace: String =
            self.call_frames(outermost_index).iter().map(|l| format!("  {}{}\n", l.text, place(l.span))).collect();
        let (point, normal, uv) = (
            list_with_significant_digits(&p.point, p.t),
            list_with_significant_digits(&p.normal, 1.0),
            list_with_significant_digits(&p.uv, 1.0),
        );
        format!(
            "{}{}\n{placed}{trace}  distance  {}\n  point     <{point}>\n  normal    <{normal}>\n  uv        <{uv}>\n{color}",
            p.shape,
            place(p.source),
            list_with_significant_digits(&[p.t], 0.0)
        )
    }
}

/// Encodes a colour of linear light as sRGB, in the notation of painting programs: `#ff8000`.
fn hex_color(linear_rgb: [f64; 3]) -> String {
    let byte = |x: f64| (transfer::srgb_encode(x.clamp(0.0, 1.0)) * 255.0).round() as u8;
    let [r, g, b] = linear_rgb.map(byte);
    format!("#{r:02x}{g:02x}{b:02x}")
}

/// Formats numbers with the decimal places that six digits of the largest one need (or of `reference_size`, if that is larger),
/// since further digits are noise.
fn list_with_significant_digits(numbers: &[f64], reference_size: f64) -> String {
    let largest = numbers.iter().fold(reference_size.abs(), |most, x| most.max(x.abs()));
    if !largest.is_finite() || largest == 0.0 {
        return numbers.iter().map(f64::to_string).collect::<Vec<_>>().join(", ");
    }
    let places = (5.0 - fp::log10(largest).floor()).clamp(0.0, 300.0) as usize;
    numbers.iter().map(|x| format_decimal(*x, places)).collect::<Vec<_>>().join(", ")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lists_have_six_digits_of_the_largest_number() {
        assert_eq!(list_with_significant_digits(&[4.008710037062282], 0.0), "4.00871");
        assert_eq!(list_with_significant_digits(&[-0.0000001, 1.0, 0.99999999], 1.0), "0, 1, 1");
        assert_eq!(list_with_significant_digits(&[1e-9, -1e-9], 4.0), "0, 0");
        assert_eq!(list_with_significant_digits(&[1234567.25, 0.5], 0.0), "1234567, 0");
        assert_eq!(list_with_significant_digits(&[0.000123456789], 0.0), "0.000123457");
        assert_eq!(list_with_significant_digits(&[100.0, 20.0], 0.0), "100, 20");
        assert_eq!(list_with_significant_digits(&[0.0, f64::INFINITY], 0.0), "0, inf");
    }

    #[test]
    fn colours_are_clamped_and_encoded() {
        assert_eq!(hex_color([1.0, 0.2158605, -1.0]), "#ff8000");
    }
}
