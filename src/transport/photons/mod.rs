//! Photon maps: light that targets reflect and refract (manual, "Photons"). Photons replace the direct light that a
//! target transmits.

mod emission;
mod gather;
mod map;
mod save;
mod trace;

use super::context::FrameContext;
use crate::scene::PhotonMapSettings;
use crate::world::{LightSource, World};
use emission::{Job, Plan};
pub(super) use map::Found;
use map::{Photon, PhotonMap};

/// Radius of a search, as a multiple of the mean distance of the farthest photon of an estimate.
const RADIUS_FACTOR: f64 = 3.0;
/// Factor of the radius of a search in media (quirk: `photon_radius_in_media`).
const MEDIA_RADIUS_FACTOR: f64 = 2.0;

/// Photons of a frame, and the parameters of their estimates.
#[derive(Debug)]
pub struct Photons {
    surface: SearchedMap,
    media: SearchedMap,
    gather: [usize; 2],
    max_increase: f64,
    expand_min: usize,
}

/// A photon map with the parameter of its estimates.
#[derive(Debug)]
struct SearchedMap {
    photons: PhotonMap,
    /// Radius within which photons are searched for an estimate, in world units.
    radius: f64,
}

/// Photon pass of a frame: the plan of all photons to emit, and the settings of the photon map.
pub struct PhotonPass {
    plan: Plan,
    settings: PhotonMapSettings,
}

/// Photons that were stored for one job of the photon pass, ring by ring.
pub struct PhotonShard {
    source: usize,
    rings: Vec<Ring>,
}

/// Photons that were stored on surfaces and in media for one emitted ring, and whether the ring hits the target.
struct Ring {
    number: u32,
    hits_target: bool,
    surface: Vec<Photon>,
    media: Vec<Photon>,
}

impl Photons {
    /// Creates the photons of a frame from their maps.
    fn new(surface: PhotonMap, media: PhotonMap, settings: &PhotonMapSettings) -> Self {
        let gather = settings.gather.map(|n| n as usize);
        let radius = |map: &PhotonMap, i: usize| match settings.radius[i] {
            0.0 => RADIUS_FACTOR * map.mean_radius_holding_count(gather[1]) * settings.radius_factor[i],
            stated => stated * settings.radius_factor[i],
        };
        Self {
            surface: SearchedMap { radius: radius(&surface, 0), photons: surface },
            media: SearchedMap { radius: MEDIA_RADIUS_FACTOR * radius(&media, 1), photons: media },
            gather,
            max_increase: settings.max_increase,
            expand_min: settings.expand_min as usize,
        }
    }

    /// True if no photon is stored.
    pub(super) fn is_empty(&self) -> bool {
        self.surface.photons.is_empty() && self.media.photons.is_empty()
    }

    /// True if any photon is stored in a medium.
    pub(super) fn has_media_photons(&self) -> bool {
        !self.media.photons.is_empty()
    }
}

impl PhotonPass {
    /// Plans which photons each light of the scene emits at which targets; `None` for a scene or a quality without
    /// photons.
    pub fn new(context: &FrameContext) -> Option<Self> {
        let settings = context.world.photon_map.as_ref().filter(|_| context.quality.reflection)?;
        if settings.spacing <= 0.0 && settings.count <= 0.0 {
            return None;
        }
        Some(Self { plan: Plan::new(context, settings), settings: settings.clone() })
    }

    /// Returns the jobs of the emission.
    pub fn jobs(&self) -> &[Job] {
        &self.plan.jobs
    }

    /// Builds the maps of the photons of all jobs, which are in the order of the jobs; drops those of rings after the
    /// one where autostop ends a source.
    pub fn finish(&self, shards: Vec<PhotonShard>) -> Photons {
        let (mut surface, mut media) = (vec![], vec![]);
        // Source that autostop has ended, and the source that has hit its target
        let (mut ended, mut hit) = (None, None);
        for shard in shards {
            for mut ring in shard.rings {
                if ended == Some(shard.source) {
                    break;
                }
                if ring.hits_target {
                    hit = Some(shard.source);
                } else if hit == Some(shard.source)
                    && self.plan.sources[shard.source].may_stop_at(ring.number, self.settings.autostop)
                {
                    ended = Some(shard.source);
                }
                surface.append(&mut ring.surface);
                media.append(&mut ring.media);
            }
        }
        Photons::new(PhotonMap::new(surface), PhotonMap::new(media), &self.settings)
    }
}

/// True if photons of a light replace the light that an object with these settings transmits.
pub(super) fn photons_replace_transmitted(world: &World, light: &LightSource, settings_number: u32) -> bool {
    world.photons[settings_number as usize].target.is_some()
        && world.photon_refracts_and_reflects(light, settings_number)[0]
}
