//! Warnings about photons and radiosity.

use crate::diagnostic::{Diagnostic, codes};
use crate::scene::{LightKind, SavedLight};
use crate::world::World;

/// Returns the warning about light that was saved for another scene.
pub fn other_light_warning(world: &World, kind: LightKind) -> Option<Diagnostic> {
    let saved: Option<&SavedLight> = match kind {
        LightKind::Photons => world.photon_map.as_ref().map(|settings| &settings.saved),
        LightKind::Radiosity => world.radiosity.as_ref().map(|settings| &settings.saved),
    };
    let loaded = saved?.loaded.as_ref()?;
    if loaded.file.header.scene == world.scene_digest() {
        return None;
    }
    let text = format!("the {} of `{}` were saved for another scene, and may not fit", kind.contents(), loaded.name);
    let help = "save the file again if an object, a light or a texture has changed";
    Some(Diagnostic::new(codes::OTHER_LIGHT, loaded.source, text).help(help))
}
