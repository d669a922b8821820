//! The scene under construction: objects, settings, defaults and the language version in force.

pub(super) mod compat;

use crate::atmosphere::{Background, Fog, Rainbow, SkySphere};
use crate::camera::Camera;
use crate::color::Color;
use crate::diagnostic::Label;
use crate::math::noise::NoiseGenerator;
use crate::medium::Media;
use crate::scene::{Defaults, Object, ObjectRadiosity, Scene, Settings};
use crate::source::Span;
use crate::texture::Texture;
use crate::value::Language;
use std::sync::Arc;
use std::sync::atomic::{AtomicU8, Ordering};

/// The scene under construction while the interpreter runs.
pub(super) struct SceneBuilder {
    scene: Scene,
    defaults: Defaults,
    language: Language,
    /// True once a `#version` or an option has set the language version.
    version_stated: bool,
    /// Number of the scene's noise generator. Functions read it when they are called, because it may still change.
    noise_generator: Arc<AtomicU8>,
    /// Call traces of the objects, filled if [`super::Options::record_origins`] is set.
    origins: Vec<Vec<Label>>,
}

impl SceneBuilder {
    pub(super) fn new() -> Self {
        Self {
            scene: Scene::default(),
            defaults: Defaults::default(),
            language: Language {
                version: compat::DEFAULT_VERSION,
                bare_textures: false,
                random_media: false,
                untinted_layers: false,
                ordered_cameras: false,
                bare_operators: true,
                assumed_gamma: None,
                other_gamma: compat::gamma_without_setting(None),
                srgb_files: false,
            },
            version_stated: false,
            noise_generator: Arc::new(AtomicU8::new(compat::default_noise_generator(compat::DEFAULT_VERSION))),
            origins: vec![],
        }
    }

    /// Sets the language version for the rest of the text.
    pub(super) fn set_version(&mut self, version: u32) {
        self.language.version = version;
        self.language.bare_textures = compat::has_bare_textures(version);
        self.language.random_media = compat::has_random_media(version);
        self.language.ordered_cameras = compat::has_ordered_cameras(version);
        self.language.untinted_layers = compat::has_untinted_layers(version);
        self.language.bare_operators = compat::has_bare_operators(version);
        if self.scene.settings.noise_generator.is_none() {
            self.noise_generator.store(compat::default_noise_generator(version), Ordering::Relaxed);
        }
        self.version_stated = true;
    }

    /// Returns the language version in force; `None` if the scene has not stated one.
    pub(super) fn stated_version(&self) -> Option<u32> {
        self.version_stated.then_some(self.language.version)
    }

    /// Returns the language version, the rules that depend on it, and the gamma, all as they are in force at this point of the
    /// scene.
    pub(super) fn language(&self) -> Language {
        let version = self.stated_version();
        let srgb_files = version.is_some_and(compat::has_srgb_files);
        Language { other_gamma: compat::gamma_without_setting(version), srgb_files, ..self.language }
    }

    /// Returns the number of the scene's noise generator, which may still change.
    pub(super) fn noise_generator(&self) -> &Arc<AtomicU8> {
        &self.noise_generator
    }

    /// Returns the defaults that `#default` has set for the text that follows.
    pub(super) fn defaults(&self) -> &Defaults {
        &self.defaults
    }

    pub(super) fn set_default_texture(&mut self, texture: Arc<Texture>) {
        self.defaults.texture = texture;
    }

    pub(super) fn set_default_radiosity(&mut self, radiosity: ObjectRadiosity) {
        self.defaults.radiosity = Some(radiosity);
    }

    pub(super) fn settings(&self) -> &Settings {
        &self.scene.settings
    }

    pub(super) fn set_settings(&mut self, settings: Settings) {
        self.language.assumed_gamma = settings.gamma;
        if let Some(generator) = settings.noise_generator {
            self.noise_generator.store(generator.number(), Ordering::Relaxed);
        }
        self.scene.settings = settings;
    }

    pub(super) fn has_camera(&self) -> bool {
        !self.scene.cameras.is_empty()
    }

    /// Sets the camera of `#default`, from whose properties the `camera` blocks that follow start (quirk: `default_camera`).
    pub(super) fn set_default_camera(&mut self, camera: Camera) {
        self.defaults.camera = Arc::new(camera);
    }

    /// Sets the camera; `span` is that of the word `camera`.
    pub(super) fn set_camera(&mut self, camera: Camera, span: Span) {
        self.scene.camera = camera;
        self.scene.cameras.push(span);
    }

    pub(super) fn set_background(&mut self, color: Color) {
        let by_picture = compat::has_pre_3_7_background(self.stated_version());
        self.scene.background = Some(Background { color, by_picture });
    }

    pub(super) fn set_sky_sphere(&mut self, sky: SkySphere) {
        self.scene.sky_sphere = Some(sky);
    }

    pub(super) fn add_fog(&mut self, fog: Fog) {
        self.scene.fogs.push(fog);
    }

    pub(super) fn add_media(&mut self, media: Media) {
        self.scene.media.push(media);
    }

    pub(super) fn add_rainbow(&mut self, rainbow: Rainbow) {
        self.scene.rainbows.push(rainbow);
    }

    /// Adds an object. Without a texture, it gets the present default texture, even if it was declared earlier.
    pub(super) fn add_object(&mut self, mut object: Object) {
        object.default_texture = self.defaults.texture.clone();
        self.scene.objects.push(object);
    }

    /// Adds the call trace of the object that was added last.
    pub(super) fn add_object_call_trace(&mut self, trace: Vec<Label>) {
        self.origins.push(trace);
    }

    /// Sets the properties that depend on the language version at the end of the text.
    pub(super) fn set_final_version_properties(&mut self) {
        self.scene.version = self.language.version;
        let version = self.stated_version();
        let generator = self.noise_generator.load(Ordering::Relaxed);
        let settings = &mut self.scene.settings;
        settings.noise_generator.get_or_insert(NoiseGenerator::from_number_modulo_4(f64::from(generator)));
        settings.opacity_by_color = compat::has_opacity_by_brightest_channel(version);
        if let Some(radiosity) = &mut settings.radiosity {
            radiosity.keeps_ambient = compat::has_ambient_with_radiosity(version);
        }
        settings.sky_by_share = compat::has_pre_3_7_sky(version);
        settings.gamma.get_or_insert(compat::gamma_without_setting(version));
    }

    /// Returns the finished scene, and the call traces of its objects.
    pub(super) fn into_scene_and_call_traces(self) -> (Scene, Vec<Vec<Label>>) {
        (self.scene, self.origins)
    }
}
