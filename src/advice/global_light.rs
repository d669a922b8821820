//! Warnings about photons and radiosity.

use crate::color::Rgb;
use crate::diagnostic::{Diagnostic, codes};
use crate::render;
use crate::scene::{LightKind, PhotonMapSettings, Radiosity, SavedLight};
use crate::world::{Material, Medium, World};
use std::collections::BTreeSet;
use std::f64::consts::PI;

/// Returns the warning about loaded light that was saved for another scene; `None` if no light of this kind is loaded, or
/// if it was saved for this scene.
pub fn foreign_saved_light_warning(world: &World, kind: LightKind) -> Option<Diagnostic> {
    let saved: Option<&SavedLight> = match kind {
        LightKind::Photons => world.photon_map.as_ref().map(|settings| &settings.saved),
        LightKind::Radiosity => world.radiosity.as_ref().map(|settings| &settings.saved),
    };
    let loaded = saved?.loaded.as_ref()?;
    if loaded.file.header.scene == world.scene_digest() {
        return None;
    }
    let text = format!("the {} of `{}` were saved for another scene, and may not fit", kind.plural_name(), loaded.name);
    let help = "save the file again if an object, a light or a texture has changed";
    Some(Diagnostic::new(codes::OTHER_LIGHT, loaded.source, text).help(help))
}

/// Returns warnings about photons, or settings of photons, that have no effect.
pub(super) fn ineffective_photon_warnings(world: &World) -> Vec<Diagnostic> {
    let Some(settings) = world.photon_map.as_ref().filter(|settings| settings.saved.loaded.is_none()) else {
        return vec![];
    };
    let warning = |text: &str, help: &str| Diagnostic::new(codes::IDLE_PHOTONS, settings.source, text).help(help);
    let settings_of_targets = |is_hit: bool| -> BTreeSet<u32> {
        let objects = world.objects.iter().filter(|object| object.is_hit_by_photons == is_hit);
        objects.map(|object| object.photons).filter(|&number| is_photon_target_setting(world, number)).collect()
    };
    let targets = settings_of_targets(true);
    let interacts = |&number: &u32| {
        let settings = &world.photons[number as usize];
        world.lights.iter().any(|light| settings.refracts_and_reflects(&light.emitter.photons).contains(&true))
    };
    let mut warnings = vec![];
    if targets.is_empty() && !settings_of_targets(false).is_empty() {
        let help = "remove `no_image` and `no_shadow` from the target: photons do not hit such objects";
        warnings.push(warning("no photon is shot, because all targets are hidden", help));
    } else if targets.is_empty() {
        let help = "`photons { target refraction on reflection on }` in an object of glass or metal makes it a target; \
                    in a `light_group`, it also needs `global_lights on`";
        warnings.push(warning("no photon is shot, because no object is a target", help));
    } else if !targets.iter().any(interacts) {
        let help = "write `refraction on` or `reflection on` into the `photons` of the target; lights in a `light_group` \
                    shoot no photons";
        warnings.push(warning("no photon is shot, because the targets neither refract nor reflect photons", help));
    }
    let scatters = |medium: &Medium| medium.scattering.color != Rgb::ZERO;
    if settings.media_steps > 0 && !world.air.iter().chain(world.media.values().flatten()).any(scatters) {
        let help = "remove `media`, or give the media of the scene a `scattering`";
        warnings.push(warning("no photon is stored in media, because no media scatter light", help));
    }
    if settings.count > 0.0 && settings.spacing > 0.0 {
        warnings.push(warning("`spacing` has no effect beside `count`", "remove one of them"));
    }
    warnings
}

/// True if objects with the photon settings of this number are targets.
fn is_photon_target_setting(world: &World, photon_settings: u32) -> bool {
    world.photons[photon_settings as usize].target.is_some_and(|factor| factor > 0.0)
}

/// Maximum `ambient` of a finish whose `ambient` imitates indirect light. Brighter surfaces are lamps.
const MAX_AMBIENT: f64 = 0.3;

/// Returns the warning about `ambient` that adds to the light of radiosity, if most materials have it.
pub(super) fn ambient_with_radiosity_warning(world: &World) -> Option<Diagnostic> {
    let settings = world.radiosity.as_ref().filter(|settings| settings.keeps_ambient)?;
    let has_ambient = |material: &&Material| {
        let largest = material.layers.iter().map(|layer| layer.finish.ambient.max_element()).fold(0.0, f64::max);
        largest > 0.0 && largest <= MAX_AMBIENT
    };
    let (found, all) = (world.materials.iter().filter(has_ambient).count(), world.materials.len());
    if 2 * found <= all {
        return None;
    }
    let text = format!("`ambient` of {found} of {all} materials is added to the light of radiosity");
    let help = "`#default { finish { ambient 0 } }` at the beginning, or `#version 3.7;`, leaves it out";
    Some(Diagnostic::new(codes::DOUBLE_AMBIENT, settings.source, text).help(help))
}

/// Approximate time of a ray of a radiosity sample, in seconds.
const GATHER_RAY_TIME: f64 = 2e-6;
/// Approximate time to examine a photon, in seconds.
const PHOTON_TIME: f64 = 5e-8;
/// Approximate number of samples that overlap at a point, for each of `nearest_count`.
const OVERLAP: f64 = 4.0;

/// Returns the warning about photons or radiosity that take more than an hour of one processor.
pub(super) fn slow_global_light_warning(world: &World, options: &render::Options) -> Option<Diagnostic> {
    let radiosity = world.radiosity.as_ref().filter(|settings| settings.saved.loaded.is_none());
    let radiosity = radiosity.map(|settings| {
        (max_radiosity_cpu_seconds(settings, options), settings.source, "`count` or `recursion_limit`")
    });
    let gathering = |settings: &PhotonMapSettings| {
        let n_photons = if settings.count > 0.0 { settings.count } else { f64::INFINITY };
        options.rendered_region().n_pixels() as f64 * f64::from(settings.gather[1]).min(n_photons) * PHOTON_TIME
    };
    let photons = world
        .photon_map
        .as_ref()
        .map(|settings| (gathering(settings), settings.source, "the second number of `gather`"));
    let slowest = radiosity.into_iter().chain(photons).max_by(|a, b| a.0.total_cmp(&b.0));
    let (seconds, source, word) = slowest.filter(|(seconds, ..)| *seconds >= 3600.0)?;
    let text = format!("with these settings, the picture takes up to {:.0} hours of one processor", seconds / 3600.0);
    Some(Diagnostic::new(codes::SLOW_LIGHT, source, text).help(format!("lower {word}")))
}

/// Returns an upper estimate of the time that radiosity takes, in seconds of one processor. The radius of a sample is at
/// least `minimum_reuse` times its distance, so that it covers an area of the picture.
fn max_radiosity_cpu_seconds(settings: &Radiosity, options: &render::Options) -> f64 {
    let radius = settings.reuse_radius_per_distance()[0] * options.width as f64;
    let n_pixels = (options.width * options.height) as f64;
    let n_samples = n_pixels * OVERLAP * f64::from(settings.nearest_count) / (PI * radius * radius);
    n_samples.min(n_pixels) * f64::from(settings.count) * f64::from(settings.recursion_limit) * GATHER_RAY_TIME
}
