//! Warnings about media that cannot show, or that take hours.

use crate::color::Rgb;
use crate::diagnostic::{Diagnostic, codes};
use crate::medium::SamplingMethod;
use crate::render;
use crate::scene::{Object, ObjectKind, Scene};
use crate::source::Span;
use crate::world::{Medium, World};
use rustc_hash::FxHashSet;
use std::sync::Arc;

/// Maximum number of warnings about media.
const MAX_WARNINGS: usize = 5;

/// Returns warnings about media in objects that are not `hollow`.
pub(super) fn media_in_solid_warnings(scene: &Scene) -> Vec<Diagnostic> {
    let mut search = SolidMediaSearch::default();
    scene.objects.iter().for_each(|object| search.examine(object, false));
    let warning = |(media, object): &(Span, Span)| {
        let text = "these media show nothing, because the object is not `hollow`";
        Diagnostic::new(codes::SOLID_MEDIA, *media, text).also(*object, "add `hollow` to this object")
    };
    search.found.iter().map(warning).collect()
}

/// Returns the warning about media that scatter light in a scene whose lights do not reach them.
pub(super) fn unlit_media_warning(world: &World) -> Option<Diagnostic> {
    let shows_photons = world.photon_map.as_ref().is_some_and(|settings| settings.media_steps > 0);
    let is_unlit = |medium: &&Medium| {
        let mut lights = world.lit_by[medium.light_set as usize].iter().map(|&number| &world.lights[number as usize]);
        let scatters = medium.scattering.color != Rgb::ZERO && medium.emission == Rgb::ZERO;
        let collects = shows_photons && medium.collects_photons;
        scatters && !collects && !lights.any(|light| light.emitter.scattered)
    };
    let medium = all_media(world).find(is_unlit)?;
    let text = "these media scatter the light of lights, but no light shines on them";
    let help = "add a `light_source`, or give the media an `emission`";
    Some(Diagnostic::new(codes::UNLIT_MEDIA, medium.source, text).help(help))
}

/// Returns warnings about media whose density is 0 in all of their object.
pub(super) fn empty_density_warnings(world: &World) -> Vec<Diagnostic> {
    let mut found: Vec<Span> = vec![];
    for item in world.geometry.items() {
        let interior = item.first_shape_name_and_part().map(|(_, part)| world.parts[part as usize].interior);
        let media = interior.and_then(|interior| world.media.get(&interior)).into_iter().flatten();
        for medium in media.filter(|medium| medium.is_empty_in(&item.bounds())) {
            if !found.contains(&medium.source) && found.len() < MAX_WARNINGS {
                found.push(medium.source);
            }
        }
    }
    let text = "these media show nothing, because their density is 0 in all of the object";
    let help = "the density's pattern ends one unit from the origin: `scale` and `translate` it to where the object is";
    found.into_iter().map(|span| Diagnostic::new(codes::EMPTY_DENSITY, span, text).help(help)).collect()
}

/// Time that a sample of a medium takes, in seconds.
const SAMPLE_TIME: f64 = 2e-7;

/// Returns the warning about media whose samples take more than an hour of one processor.
pub(super) fn slow_media_warning(world: &World, options: &render::Options) -> Option<Diagnostic> {
    let lists = world.media.values().chain([&world.air]).filter(|media| !media.is_empty());
    let (samples, slowest) =
        lists.map(|media| (media_samples_per_ray(world, media), &media[0])).max_by(|a, b| a.0.total_cmp(&b.0))?;
    let pixels = options.region.map_or(options.width * options.height, |region| region.width * region.height);
    let hours = pixels as f64 * samples * SAMPLE_TIME / 3600.0;
    if hours < 1.0 {
        return None;
    }
    let text = format!("with these media, the picture takes about {hours:.0} hours of one processor");
    let diagnostic = Diagnostic::new(codes::SLOW_MEDIA, slowest.source, text);
    Some(diagnostic.label(format!("about {samples:.0} samples for each pixel")).help("lower `samples` or `intervals`"))
}

/// Returns the number of samples of media that are sampled together on a ray, those of its shadow rays included.
fn media_samples_per_ray(world: &World, media: &[Medium]) -> f64 {
    let sampling = media[0].sampling;
    let of_interval = match sampling.method {
        SamplingMethod::Adaptive => sampling.min_samples + 1,
        _ => sampling.min_samples,
    };
    let on_ray = f64::from(sampling.intervals) * f64::from(of_interval);
    let on_shadow_ray = |medium: &Medium| {
        let is_sampled = !medium.is_homogeneous() && medium.extinction != Rgb::ZERO;
        1.0 + if is_sampled { on_ray } else { 0.0 }
    };
    let scattering = media.iter().filter(|medium| medium.scattering.color != Rgb::ZERO);
    let lights = |medium: &Medium| {
        let lights = world.lit_by[medium.light_set as usize].iter().map(|&number| &world.lights[number as usize]);
        lights.filter(|light| light.emitter.scattered).count() as f64
    };
    on_ray * (1.0 + scattering.map(|medium| lights(medium) * on_shadow_ray(medium)).fold(0.0, f64::max))
}

/// Returns the media of the whole scene and of all interiors.
fn all_media(world: &World) -> impl Iterator<Item = &Medium> {
    world.air.iter().chain(world.media.values().flatten())
}

/// Search for media in solid objects.
#[derive(Default)]
struct SolidMediaSearch {
    /// Spans of media, each with the span of the first solid object that holds them.
    found: Vec<(Span, Span)>,
    /// Addresses of the examined parts of groups that have copies, each within hollow or within solid groups. Copies
    /// share their parts, so that a scene can have far more parts than memory.
    examined: FxHashSet<(*const Object, bool)>,
}

impl SolidMediaSearch {
    /// Examines an object and its parts; `in_hollow_group` is true within a hollow group.
    fn examine(&mut self, object: &Object, in_hollow_group: bool) {
        if self.found.len() >= MAX_WARNINGS {
            return;
        }
        let is_hollow = in_hollow_group || object.uncommon.flags.hollow;
        let parts: &[Object] = match &object.kind {
            ObjectKind::Csg(_, parts) => {
                let has_copies = Arc::strong_count(parts) > 1 || Arc::strong_count(&object.body) > 1;
                if has_copies && !self.examined.insert((parts.as_ptr(), is_hollow)) {
                    return;
                }
                parts
            }
            _ => &[],
        };
        let media = object.uncommon.interior.as_ref().and_then(|interior| interior.media.first());
        let has_hollow_part = parts.iter().any(|part| part.uncommon.flags.hollow);
        if let Some(media) = media.filter(|_| !is_hollow && !has_hollow_part)
            && self.found.iter().all(|(known, _)| *known != media.source)
        {
            self.found.push((media.source, object.source));
        }
        parts.iter().for_each(|part| self.examine(part, is_hollow));
    }
}
