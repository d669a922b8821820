//! `durer pick INPUT X,Y`: what is seen through one pixel, and which text put it there.

use super::args::PickArgs;
use super::console::Console;
use super::exit::{Exit, Result};
use super::overlay;
use super::session;
use super::values::Size;
use crate::color::transfer;
use crate::diagnostic::{Diagnostic, Label, codes};
use crate::interpreter::{self, ParsedFiles};
use crate::math::fp;
use crate::render::{self, Picked, Region, Unwatched};
use crate::scene::Scene;
use crate::source::{Place, Sources, Span};
use crate::value::decimal;
use crate::world::World;
use crate::{Built, Keep};
use serde::Serialize;

/// What `--json` prints; `t` is the distance in world space along the unit ray.
#[derive(Serialize)]
struct Seen<'a> {
    hit: bool,
    #[serde(flatten)]
    what: Option<What<'a>>,
}

#[derive(Serialize)]
struct What<'a> {
    shape: &'a str,
    t: f64,
    point: [f64; 3],
    normal: [f64; 3],
    uv: [f64; 2],
    /// What the picture shows there: linear red, green and blue.
    color: [f64; 3],
    source: Option<Source>,
    /// Where the outermost object around it stands.
    placed: Option<Source>,
    /// The macro calls and includes through which it came into the scene, innermost first.
    trace: Vec<Step>,
}

/// Where something stands, for programs.
#[derive(Serialize, Clone, PartialEq)]
pub(super) struct Source {
    pub file: String,
    pub line: usize,
    pub column: usize,
}

impl From<Place> for Source {
    fn from(place: Place) -> Self {
        Self { file: place.file, line: place.line, column: place.column }
    }
}

#[derive(Serialize)]
struct Step {
    text: String,
    #[serde(flatten)]
    place: Option<Source>,
}

/// Prints what the pixel sees.
pub fn run(console: &Console, args: &PickArgs) -> Result {
    let (input, scene) = overlay::scene_with_ini(console, &session::named(&args.input), &args.scene)?;
    let args = &PickArgs { input, scene, ..args.clone() };
    let size = args.scene.size();
    let inside = |at: i64, side: usize| usize::try_from(at).ok().filter(|&at| at < side);
    let (Some(x), Some(y)) = (inside(args.pixel.x, size.width), inside(args.pixel.y, size.height)) else {
        return Ok(outside(args, size)?);
    };
    let sources = Sources::default();
    let file = session::open_or_tell(console, &sources, &args.input)?;
    let timing = session::timing(&args.scene)?;
    let options = session::reading_options(&args.scene, &args.input, timing);
    let options = interpreter::Options { origins: true, ..options };
    let mut built = session::build(console, &ParsedFiles::default(), &sources, file, &options, Keep::Both);
    let world = session::settle(console, &sources, &mut built)?;
    let drawing = render::Options { frame: timing.frame, ..render::Options::new(size.width, size.height) };
    let seen = Sight { sources: &sources, color: color_of(&world, &drawing, x, y), built: Some(&built) };
    let picked = render::pick(&world, &drawing, x, y);
    let origin = picked.as_ref().and_then(|picked| origin_of(&built, &drawing, (x, y), picked));
    if args.json {
        let what = picked.as_ref().map(|p| seen.describe(p, origin));
        console.json(&Seen { hit: what.is_some(), what })?;
    } else {
        console.data(seen.in_words(picked.as_ref(), origin))?;
    }
    Ok(Exit::Fine)
}

/// The same for those who have a picture already, whose light there is known.
pub(super) fn words(sources: &Sources, picked: Option<&Picked>, color: [f64; 3]) -> String {
    Sight { sources, built: None, color }.in_words(picked, None)
}

/// The colour of one pixel, as it is drawn without anti-aliasing.
fn color_of(world: &World, drawing: &render::Options, x: usize, y: usize) -> [f64; 3] {
    let region = Some(Region { x, y, width: 1, height: 1 });
    let drawn = render::render(world, &render::Options { region, ..drawing.clone() }, &Unwatched);
    let pixel = drawn.ok().and_then(|(frame, _)| frame.pixels.get(y * frame.width + x).copied());
    let [r, g, b, _] = pixel.unwrap_or_default().map(f64::from);
    [r, g, b]
}

/// Which of the scene's outermost objects is seen there. A World has no outermost objects any more, so the scene is drawn with
/// half of them, and half of those, until one is left.
fn origin_of(built: &Built, drawing: &render::Options, (x, y): (usize, usize), picked: &Picked) -> Option<usize> {
    let scene = built.scene.as_ref()?;
    let mut range = 0..scene.objects.len();
    while range.len() > 1 {
        let middle = range.start + range.len() / 2;
        let half = Scene { objects: scene.objects[range.start..middle].to_vec(), ..frame_of(scene) };
        let seen = crate::world::lower(&half).ok().and_then(|world| render::pick(&world, drawing, x, y));
        let there = seen.is_some_and(|seen| seen.source == picked.source && seen.t == picked.t);
        range = if there { range.start..middle } else { middle..range.end };
    }
    Some(range.start).filter(|at| *at < built.origins.len())
}

/// The scene without its objects.
fn frame_of(scene: &Scene) -> Scene {
    Scene { camera: scene.camera.clone(), settings: scene.settings.clone(), version: scene.version, ..Scene::default() }
}

fn outside(args: &PickArgs, size: Size) -> crate::diagnostic::Result<Exit> {
    let (w, h) = (size.width, size.height);
    let text = format!("pixel {},{} is outside the picture of {w}x{h}", args.pixel.x, args.pixel.y);
    let help = format!("pixels go from 0,0 to {},{}; `--size` makes the picture larger", w - 1, h - 1);
    Diagnostic::new(codes::OUTSIDE_PICTURE, Span::NONE, text).help(help).into()
}

/// What one pixel shows.
struct Sight<'a> {
    sources: &'a Sources,
    /// Tells where things were placed.
    built: Option<&'a Built>,
    color: [f64; 3],
}

impl Sight<'_> {
    /// Where the outermost object stands, unless the thing itself stands there.
    fn placed(&self, picked: &Picked, origin: Option<usize>) -> Option<Place> {
        let object = self.built?.scene.as_ref()?.objects.get(origin?)?;
        self.sources.place(object.source).filter(|_| object.source != picked.source)
    }

    fn trace(&self, origin: Option<usize>) -> &[Label] {
        origin.and_then(|at| self.built?.origins.get(at)).map_or(&[], Vec::as_slice)
    }

    fn describe<'p>(&self, p: &'p Picked, origin: Option<usize>) -> What<'p> {
        let place = |span: Span| self.sources.place(span).map(Source::from);
        let step = |label: &Label| Step { text: label.text.clone(), place: place(label.span) };
        What {
            shape: p.shape,
            t: p.t,
            point: p.point,
            normal: p.normal,
            uv: p.uv,
            color: self.color,
            source: place(p.source),
            placed: self.placed(p, origin).map(Source::from),
            trace: self.trace(origin).iter().map(step).collect(),
        }
    }

    fn in_words(&self, picked: Option<&Picked>, origin: Option<usize>) -> String {
        let color = format!("  colour    rgb <{}>, on the screen {}\n", list(&self.color, 1.0), on_screen(self.color));
        let Some(p) = picked else {
            return format!("nothing but the background\n{color}");
        };
        let place = |span: Span| self.sources.place(span).map(|place| format!(" at {place}")).unwrap_or_default();
        let placed = self.placed(p, origin).map(|place| format!("  placed at {place}\n")).unwrap_or_default();
        let trace: String = self.trace(origin).iter().map(|l| format!("  {}{}\n", l.text, place(l.span))).collect();
        let (point, normal, uv) = (list(&p.point, p.t), list(&p.normal, 1.0), list(&p.uv, 1.0));
        format!(
            "{}{}\n{placed}{trace}  distance  {}\n  point     <{point}>\n  normal    <{normal}>\n  uv        <{uv}>\n{color}",
            p.shape,
            place(p.source),
            list(&[p.t], 0.0)
        )
    }
}

/// As painting programs write it: `#ff8000`.
fn on_screen(color: [f64; 3]) -> String {
    let byte = |x: f64| (transfer::srgb_encode(x.clamp(0.0, 1.0)) * 255.0).round() as u8;
    let [r, g, b] = color.map(byte);
    format!("#{r:02x}{g:02x}{b:02x}")
}

/// Numbers as a person would write them: six digits of the largest, or of `scale` if that is larger, and no more behind the
/// point for the others, whose further digits are noise.
fn list(numbers: &[f64], scale: f64) -> String {
    let largest = numbers.iter().fold(scale.abs(), |most, x| most.max(x.abs()));
    if !largest.is_finite() || largest == 0.0 {
        return numbers.iter().map(f64::to_string).collect::<Vec<_>>().join(", ");
    }
    let places = (5.0 - fp::log10(largest).floor()).clamp(0.0, 300.0) as usize;
    numbers.iter().map(|x| decimal(*x, places)).collect::<Vec<_>>().join(", ")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_those_of_a_person() {
        assert_eq!(list(&[4.008710037062282], 0.0), "4.00871");
        assert_eq!(list(&[-0.0000001, 1.0, 0.99999999], 1.0), "0, 1, 1");
        assert_eq!(list(&[1e-9, -1e-9], 4.0), "0, 0");
        assert_eq!(list(&[1234567.25, 0.5], 0.0), "1234567, 0");
        assert_eq!(list(&[0.000123456789], 0.0), "0.000123457");
        assert_eq!(list(&[100.0, 20.0], 0.0), "100, 20");
        assert_eq!(list(&[0.0, f64::INFINITY], 0.0), "0, inf");
    }

    #[test]
    fn colours_on_the_screen() {
        assert_eq!(on_screen([1.0, 0.2158605, -1.0]), "#ff8000");
    }
}
