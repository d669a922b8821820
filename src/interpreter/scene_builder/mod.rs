//! The scene under construction.

pub(super) mod compat;

use crate::diagnostic::Label;
use crate::scene::{Defaults, Scene};
use crate::value::Language;
use std::sync::Arc;
use std::sync::atomic::AtomicU8;

/// The scene under construction.
pub(super) struct SceneBuilder {
    pub(super) language: Language,
    /// The number of the scene's noise generator, which functions ask for when they run.
    pub(super) noise_generator: Arc<AtomicU8>,
    pub(super) version_stated: bool,
    pub(super) defaults: Defaults,
    pub(super) scene: Scene,
    /// Kept where [`super::Options::origins`] asks for it.
    pub(super) origins: Vec<Vec<Label>>,
}

impl SceneBuilder {
    pub(super) fn new() -> Self {
        Self {
            language: Language {
                version: compat::DEFAULT_VERSION,
                bare_textures: false,
                assumed_gamma: None,
                other_gamma: compat::gamma_without_setting(None),
                srgb_files: false,
            },
            noise_generator: Arc::new(AtomicU8::new(compat::noise_generator(compat::DEFAULT_VERSION))),
            version_stated: false,
            defaults: Defaults::default(),
            scene: Scene::default(),
            origins: vec![],
        }
    }
}
