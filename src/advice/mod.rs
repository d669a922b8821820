//! Warnings about scenes that are valid but probably not intended: "the picture is black: …".
//!
//! Advice never changes a picture. [`scene_warnings`] examines the Scene before the World is built, [`world_warnings`] and
//! [`time_warnings`] the World before it is rendered.
//! [`picture_warnings`] examines a rendered picture with as few rays as possible. Warnings that concern a single word
//! come from the reader of that word. Each family of warnings has a file.

mod camera;
mod csg;
mod dark;
mod global_light;
mod media;
mod overlap;
mod unseen;

use crate::diagnostic::{Diagnostic, codes};
use crate::render;
use crate::scene::{LightKind, Scene};
use crate::source::{FileId, Sources, Span};
use crate::value::{Family, format_decimal};
use crate::world::{Intersection, PlacedSolid, World};
pub use global_light::foreign_saved_light_warning;
use std::path::Path;

/// Returns warnings about a scene before it is rendered.
pub fn scene_warnings(scene: &Scene, sources: &Sources) -> Vec<Diagnostic> {
    let csg = csg::csg_warnings(scene, sources);
    camera::several_cameras_warning(scene).into_iter().chain(csg).chain(media::media_in_solid_warnings(scene)).collect()
}

/// Returns warnings about a World, before it is rendered.
pub fn world_warnings(world: &World) -> Vec<Diagnostic> {
    let saved = [LightKind::Photons, LightKind::Radiosity].into_iter();
    let saved = saved.filter_map(|kind| foreign_saved_light_warning(world, kind));
    let light = global_light::ineffective_photon_warnings(world)
        .into_iter()
        .chain(global_light::ambient_with_radiosity_warning(world));
    let media = media::unlit_media_warning(world).into_iter().chain(media::empty_density_warnings(world));
    media.chain(saved).chain(light).collect()
}

/// Returns warnings about a picture that takes hours, before it is rendered.
pub fn time_warnings(world: &World, options: &render::Options) -> Vec<Diagnostic> {
    let media = media::slow_media_warning(world, options);
    media.into_iter().chain(global_light::slow_global_light_warning(world, options)).collect()
}

/// Returns warnings about parts of the scene that are often, but not always, a mistake, for `--warn doubtful`.
pub fn doubtful_scene_warnings(scene: &Scene, sources: &Sources) -> Vec<Diagnostic> {
    camera::view_along_sky_warning(scene).into_iter().chain(csg::single_object_union_warnings(scene, sources)).collect()
}

/// Removes three kinds of doubtful warnings (colours as bytes, rotations about all axes, falling map values) about
/// files outside of the scene's folder, such as the standard includes. All other diagnostics stay.
pub fn remove_doubtful_outside_folder(diagnostics: &mut Vec<Diagnostic>, sources: &Sources, scene: FileId) {
    let doubts = [codes::COLOR_OF_BYTES, codes::ALL_AXES, codes::FALLING_MAP];
    diagnostics.retain(|d| !doubts.contains(&d.code) || is_in_scene_folder(sources, scene, d.span()));
}

/// True if the span is in the scene's own file, or in a file that is beside the scene or below its folder. True for a span
/// without a position.
fn is_in_scene_folder(sources: &Sources, scene: FileId, at: Span) -> bool {
    let Some((file, _)) = sources.locate(at) else { return true };
    let folder = |file: FileId| sources.files().canonicalize(sources.path(file)?).ok()?.parent().map(Path::to_path_buf);
    file == scene || folder(file).zip(folder(scene)).is_some_and(|(of_file, of_scene)| of_file.starts_with(of_scene))
}

/// Width or height in pixels below which a picture is not examined, since its few rays miss most objects.
const TINY: usize = 10;

/// Properties of a rendered picture that its World does not contain.
#[derive(Clone, Copy, Debug)]
pub struct Circumstances {
    /// True for a picture of an animation, where an empty or black picture is normal.
    pub one_of_many: bool,
    /// True if all pixels of the rendered picture are black.
    pub black: bool,
}

/// Returns warnings about a rendered picture; none about a tiny picture, and few about a region.
pub fn picture_warnings(world: &World, options: &render::Options, circumstances: Circumstances) -> Vec<Diagnostic> {
    let mut out = vec![];
    if options.width.min(options.height) < TINY {
        return out;
    }
    out.extend(camera::non_square_pixels_warning(world, options));
    // A region of a picture may be empty.
    if options.region.is_some() {
        return out;
    }
    out.extend(overlap::coincidence_warnings(world, options));
    if !circumstances.one_of_many {
        out.extend(
            unseen::no_object_visible_warning(world, options)
                .or_else(|| circumstances.black.then(|| dark::known_black_picture_warning(world, options)).flatten()),
        );
    }
    out
}

/// True if the object with this index is visible to the camera.
fn is_visible_to_camera(world: &World, object: u32) -> bool {
    world.objects.get(object as usize).is_some_and(|o| o.image)
}

/// Returns the word and the span of an object's first shape.
fn first_shape_and_span(world: &World, item: PlacedSolid) -> Option<(&'static str, Span)> {
    item.first_shape_name_and_part().map(|(word, part)| (word, span_of_part(world, part)))
}

/// Returns the word and the span of a hit shape.
fn hit_shape_and_span(world: &World, found: &Intersection) -> (&'static str, Span) {
    (found.leaf.shape.spec().name, span_of_part(world, found.part_number()))
}

fn span_of_part(world: &World, part: u32) -> Span {
    world.parts.get(part as usize).map_or(Span::NONE, |part| part.source)
}

/// Formats a vector in the syntax of scenes with a suitable number of digits.
fn vector_in_scene_syntax(p: crate::math::DVec3) -> String {
    let short = |x: f64| format_decimal(x, if x.abs() >= 100.0 { 0 } else { 2 });
    format!("<{}, {}, {}>", short(p.x), short(p.y), short(p.z))
}

/// True if the bounds of an object are finite and not empty.
fn has_finite_box(item: &PlacedSolid) -> bool {
    let bounds = item.bounds();
    !bounds.is_empty() && bounds.is_finite()
}
