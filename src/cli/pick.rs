//! `durer pick INPUT X,Y`: what is seen through one pixel, and which text put it there.

use super::args::PickArgs;
use super::console::Console;
use super::exit::{Exit, Result};
use super::overlay;
use super::session;
use super::values::Size;
use crate::Keep;
use crate::diagnostic::{Diagnostic, codes};
use crate::interpreter::ParsedFiles;
use crate::render::{self, Picked};
use crate::source::{Place, Sources, Span};
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
    source: Option<Source>,
}

#[derive(Serialize)]
struct Source {
    file: String,
    line: usize,
    column: usize,
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
    let mut built = session::build(console, &ParsedFiles::default(), &sources, file, &options, Keep::World);
    let world = session::settle(console, &sources, &mut built)?;
    let drawing = render::Options { frame: timing.frame, ..render::Options::new(size.width, size.height) };
    let picked = render::pick(&world, &drawing, x, y);
    let place = picked.as_ref().and_then(|p| sources.place(p.source));
    if args.json {
        let what = picked.as_ref().map(|p| describe(p, place));
        console.json(&Seen { hit: what.is_some(), what })?;
    } else {
        console.data(in_words(picked.as_ref(), place))?;
    }
    Ok(Exit::Fine)
}

fn outside(args: &PickArgs, size: Size) -> crate::diagnostic::Result<Exit> {
    let (w, h) = (size.width, size.height);
    let text = format!("pixel {},{} is outside the picture of {w}x{h}", args.pixel.x, args.pixel.y);
    let help = format!("pixels go from 0,0 to {},{}; `--size` makes the picture larger", w - 1, h - 1);
    Diagnostic::new(codes::OUTSIDE_PICTURE, Span::NONE, text).help(help).into()
}

fn describe(p: &Picked, place: Option<Place>) -> What<'_> {
    let source = place.map(|p| Source { file: p.file, line: p.line, column: p.column });
    What { shape: p.shape, t: p.t, point: p.point, normal: p.normal, uv: p.uv, source }
}

fn in_words(picked: Option<&Picked>, place: Option<Place>) -> String {
    let Some(p) = picked else {
        return "nothing but the background\n".into();
    };
    let place = place.map_or(String::new(), |p| format!(" at {}:{}:{}", p.file, p.line, p.column));
    let list = |numbers: &[f64]| numbers.iter().map(f64::to_string).collect::<Vec<_>>().join(", ");
    let (point, normal, uv) = (list(&p.point), list(&p.normal), list(&p.uv));
    format!(
        "{}{place}\n  distance  {}\n  point     <{point}>\n  normal    <{normal}>\n  uv        <{uv}>\n",
        p.shape, p.t
    )
}
