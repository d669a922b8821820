//! Data that all rays of a frame share.

use super::interface::{Interiors, copy_interiors};
use super::photons::Photons;
use super::radiosity::RadiosityState;
use crate::math::DVec3;
use crate::world::{ObjectInfo, World};

/// Features of the picture that the quality level `+Q` switches on.
#[derive(Clone, Copy, Debug)]
pub struct Quality {
    /// True from level 2 on: light sources illuminate.
    pub lights: bool,
    /// True from level 4 on: objects cast shadows.
    pub shadows: bool,
    /// True from level 5 on: an `area_light` is a grid of lights, not one.
    pub area_lights: bool,
    /// True from level 6 on: pigments in place of `quick_color`, and transparency.
    pub pigments: bool,
    /// True from level 8 on: reflection, bumped normals and photons.
    pub reflection: bool,
    /// True from level 9 on: fog, rainbows, media and radiosity.
    pub atmosphere: bool,
    /// True from level 9 on: subsurface light transport. [`FrameContext::new`] clears it for a scene without.
    pub subsurface: bool,
}

impl Quality {
    /// Returns the features of a quality level from 0 to 11 (quirk: `quality_levels`).
    pub fn new(q: u8) -> Self {
        Self {
            lights: q >= 2,
            shadows: q >= 4,
            area_lights: q >= 5,
            pigments: q >= 6,
            reflection: q >= 8,
            atmosphere: q >= 9,
            subsurface: q >= 9,
        }
    }
}

/// Origin and reach of camera rays.
#[derive(Clone, Copy, Debug)]
pub struct CameraOrigin {
    /// Common origin of all camera rays, in world space; `None` if each ray has its own.
    pub origin: Option<DVec3>,
    /// Maximum distance of a hit of a camera ray, in world units.
    pub reach: f64,
}

/// Data that all rays of a frame share; read only.
#[derive(Debug)]
pub struct FrameContext<'w> {
    /// The lowered scene.
    pub world: &'w World,
    pub(super) quality: Quality,
    /// Features that are on for rays that gather light for radiosity.
    pub(super) gather_quality: Quality,
    pub(super) camera: CameraOrigin,
    /// Number of the frame, a part of each random number's key.
    pub(super) frame: u32,
    /// True if the picture has an alpha channel.
    pub(super) keeps_alpha: bool,
    /// True if shafts may replace shadow rays to area lights.
    pub(super) has_shafts: bool,
    /// Photon maps; `None` for a scene without photons, and while photons are emitted.
    pub photons: Option<Photons>,
    /// Interiors that contain the common origin of camera rays.
    camera_interiors: Interiors,
    /// Radiosity settings and samples of the frame; `None` for a scene without radiosity and for low quality levels.
    pub radiosity: Option<RadiosityState<'w>>,
    /// True if `finish { ambient }` has an effect.
    pub(super) has_ambient: bool,
    /// True if rays keep a list of the interiors around them.
    pub(super) tracks_interiors: bool,
}

impl<'w> FrameContext<'w> {
    /// Creates the context of a frame, and finds the interiors that contain the camera.
    pub fn new(
        world: &'w World,
        quality: Quality,
        camera: CameraOrigin,
        frame: u32,
        keeps_alpha: bool,
        has_shafts: bool,
    ) -> Self {
        let tracks_interiors = world.needs_interior_lists();
        let around = |origin| interiors_around(world, origin);
        let camera_interiors = camera.origin.filter(|_| tracks_interiors).map_or_else(Interiors::new, around);
        let settings = world.radiosity.as_deref().filter(|_| quality.atmosphere && quality.lights);
        let quality = Quality { subsurface: quality.subsurface && world.subsurface.is_some(), ..quality };
        let gathers_subsurface = world.radiosity.as_ref().is_some_and(|radiosity| radiosity.subsurface);
        Self {
            world,
            quality,
            gather_quality: Quality { subsurface: quality.subsurface && gathers_subsurface, ..quality },
            camera,
            frame,
            keeps_alpha,
            has_shafts,
            photons: None,
            camera_interiors,
            radiosity: settings.map(|settings| RadiosityState::new(settings, world.eye.frame.origin)),
            has_ambient: settings.is_none_or(|settings| settings.keeps_ambient),
            tracks_interiors,
        }
    }

    /// Returns the interiors that contain the origin of a camera ray; none unless rays keep a list of interiors.
    pub(super) fn interiors_of_camera_ray(&self, origin: DVec3) -> Interiors {
        match self.camera.origin {
            None if self.tracks_interiors => interiors_around(self.world, origin),
            _ => copy_interiors(&self.camera_interiors),
        }
    }
}

/// Returns the interiors of all objects that contain a point, in the order of their numbers.
pub(super) fn interiors_around(world: &World, p: DVec3) -> Interiors {
    let mut inside = Interiors::new();
    world.geometry.visit_containing_camera(p, &mut |solid| {
        let interior = world.objects[solid.object() as usize].interior;
        inside.extend((interior != ObjectInfo::VIEW).then_some(interior));
    });
    inside.sort_unstable();
    inside
}
