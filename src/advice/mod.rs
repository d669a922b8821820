//! What a scene says that is allowed and hardly meant, told as warnings: "the picture is black, because …".
//!
//! Nothing here changes a picture. [`of_scene`] looks at what the author said, before the World is built; [`of_picture`] looks at what came
//! of it, and only as far as it must: a picture that shows something costs it a few rays. What is known as soon as a word is read is told
//! there ([`crate::texture`], [`crate::interpreter`]). Each family of warnings has a file.

mod camera;
mod csg;
mod dark;
mod overlap;
mod unseen;

use crate::diagnostic::{Diagnostic, codes};
use crate::render;
use crate::scene::Scene;
use crate::source::{FileId, Sources, Span};
use crate::value::decimal;
use crate::world::{Intersection, PlacedSolid, World};
use std::path::Path;

/// What is to be said of a scene that is read.
pub fn of_scene(scene: &Scene, sources: &Sources) -> Vec<Diagnostic> {
    camera::of_scene(scene).into_iter().chain(csg::of_scene(scene, sources)).collect()
}

/// What is mostly meant as it is said, but not always: for those who ask (`--warn doubtful`).
pub fn doubtful(scene: &Scene, sources: &Sources) -> Vec<Diagnostic> {
    camera::along_sky(scene).into_iter().chain(csg::doubtful(scene, sources)).collect()
}

/// What was told while the text was read, without what the author can't help: slips in files that lie elsewhere, such as the standard
/// includes.
pub fn keep_own(told: &mut Vec<Diagnostic>, sources: &Sources, scene: FileId) {
    let doubts = [codes::COLOR_OF_BYTES, codes::ALL_AXES, codes::FALLING_MAP];
    told.retain(|d| !doubts.contains(&d.code) || is_own(sources, scene, d.span()));
}

/// Is the place in the scene's own file, or in one beside it or below?
fn is_own(sources: &Sources, scene: FileId, at: Span) -> bool {
    let Some((file, _)) = sources.locate(at) else { return true };
    let folder = |file: FileId| sources.files().canonicalize(sources.path(file)?).ok()?.parent().map(Path::to_path_buf);
    file == scene || folder(file).zip(folder(scene)).is_some_and(|(of_file, of_scene)| of_file.starts_with(of_scene))
}

/// Pixels across: nobody looks at smaller pictures, and their few rays pass by what is there.
const TINY: usize = 10;

/// What is known of a picture beside itself.
#[derive(Clone, Copy, Debug)]
pub struct Circumstances {
    /// Is it one of many? Then it may be empty or black.
    pub one_of_many: bool,
    /// Is something left out that the scene says? Then nobody knows what would be seen.
    pub incomplete: bool,
    /// Is it black all over?
    pub black: bool,
}

/// What is to be said of a picture that is drawn.
pub fn of_picture(world: &World, options: &render::Options, circumstances: Circumstances) -> Vec<Diagnostic> {
    let mut out = vec![];
    if options.width.min(options.height) < TINY {
        return out;
    }
    if !circumstances.incomplete {
        out.extend(camera::stretched(world, options));
    }
    // A part of a picture may well be empty.
    if options.region.is_some() {
        return out;
    }
    out.extend(overlap::of_picture(world, options));
    if !circumstances.incomplete && !circumstances.one_of_many {
        out.extend(
            unseen::of_picture(world, options)
                .or_else(|| circumstances.black.then(|| dark::of_picture(world, options)).flatten()),
        );
    }
    out
}

/// Was something left out of the picture, by what was told of the scene?
pub fn is_incomplete(told: &[Diagnostic]) -> bool {
    told.iter().any(|d| d.code == codes::UNSUPPORTED)
}

/// Does the camera see the object of this number?
fn shows(world: &World, object: u32) -> bool {
    world.objects.get(object as usize).is_some_and(|o| o.image)
}

/// The word of the shape that stands for an object, and its place in the text.
fn first_named(world: &World, item: PlacedSolid) -> Option<(&'static str, Span)> {
    item.first_shape().map(|(word, part)| (word, source_of(world, part)))
}

/// The word of the shape that was hit, and its place in the text.
fn named(world: &World, found: &Intersection) -> (&'static str, Span) {
    (found.leaf.shape.spec().name, source_of(world, found.part()))
}

fn source_of(world: &World, part: u32) -> Span {
    world.parts.get(part as usize).map_or(Span::NONE, |part| part.source)
}

/// A vector as one types it, with as many digits as help.
fn typed(p: crate::math::DVec3) -> String {
    let short = |x: f64| decimal(x, if x.abs() >= 100.0 { 0 } else { 2 });
    format!("<{}, {}, {}>", short(p.x), short(p.y), short(p.z))
}

/// Does any box of an object hold numbers to reckon with?
fn is_somewhere(item: &PlacedSolid) -> bool {
    let bounds = item.bounds();
    !bounds.is_empty() && bounds.is_finite()
}
