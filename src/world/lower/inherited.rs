//! Properties that the parts of a group take from the blocks around them.

use super::place::{BlockSpace, PlacedTexture};
use crate::medium::Interior;
use crate::scene::{Flags, Object, ObjectKind};
use crate::texture::Uncommon;
use std::sync::Arc;

/// Properties that an object inherits from the blocks around it.
#[derive(Clone, Default)]
pub struct Inherited {
    pub place: BlockSpace,
    pub texture: Option<PlacedTexture>,
    pub inside: Option<PlacedTexture>,
    /// Index in [`super::World::cuts`] of the solids that the object's shapes cut; shapes without a texture show the
    /// materials of these solids.
    pub cut: Option<u32>,
    /// True if the object and the blocks around it are inverted an odd number of times.
    pub inverted: bool,
    pub interior: Option<u32>,
    /// Value of `hollow` of an enclosing object, for objects without an interior.
    pub hollow_air: Option<bool>,
    /// Number of the group of lights around the object; 0 for none.
    pub light_set: u32,
    /// True if the innermost enclosing block is that light group.
    pub lights_here: bool,
    pub flags: Flags,
    /// Importance of the object for radiosity; `None` if neither the object nor a block around it states one.
    pub importance: Option<f32>,
    /// Index of the photon settings in [`super::Lowering::photons`].
    pub photons: u32,
}

impl Inherited {
    pub fn has_hollow_air(&self) -> bool {
        self.hollow_air.unwrap_or(self.flags.hollow)
    }
}

/// Returns the interior of an object: that of its block, with `ior` and `caustics` of finishes, as in old scenes.
pub fn interior_of(object: &Object) -> Option<Arc<Interior>> {
    let mut interior = object.uncommon.interior.clone();
    copy_ior_and_caustics(object, &mut interior);
    interior
}

/// Writes `ior` and `caustics` of the topmost layer's finish to the interior (quirk: `finish_ior_first`). The parts of a
/// group that have no `interior` block write to that of the group, one after the other (quirk: `finish_ior_of_parts`).
fn copy_ior_and_caustics(object: &Object, interior: &mut Option<Arc<Interior>>) {
    let top = object.texture.as_ref().and_then(|painted| painted.texture.layers.last());
    if let Some(&Uncommon { ior, caustics, .. }) = top.map(|top| &*top.finish.uncommon)
        && (ior.is_some() || caustics.is_some())
    {
        let inside = Arc::make_mut(interior.get_or_insert_default());
        inside.ior = ior.unwrap_or(inside.ior);
        inside.caustics = caustics.unwrap_or(inside.caustics);
    }
    if let ObjectKind::Csg(_, parts) = &object.kind {
        parts
            .iter()
            .filter(|part| part.uncommon.interior.is_none())
            .for_each(|part| copy_ior_and_caustics(part, interior));
    }
}

/// Returns the value of `hollow` for interiors whose blocks do not state it: that of the last shape (quirk:
/// `hollow_of_last_part`); `None` without any such shape.
pub fn hollow_of_last_shape(object: &Object, inherited_hollow: bool) -> Option<bool> {
    let hollow = object.uncommon.flags.hollow || inherited_hollow;
    match &object.kind {
        ObjectKind::Shape(_) => Some(hollow),
        ObjectKind::Light(_) => None,
        ObjectKind::Csg(_, parts) => {
            let open = parts.iter().rev().filter(|part| part.uncommon.interior.is_none());
            open.filter_map(|part| hollow_of_last_shape(part, hollow)).next()
        }
    }
}

/// Combines the flags of an object with those of its group; `inverse` is not inherited.
pub fn combined_flags(object: &Object, inherited: Flags) -> Flags {
    let own = object.uncommon.flags;
    Flags {
        no_shadow: own.no_shadow || inherited.no_shadow,
        no_image: own.no_image || inherited.no_image,
        no_reflection: own.no_reflection || inherited.no_reflection,
        no_radiosity: own.no_radiosity || inherited.no_radiosity,
        hollow: own.hollow || inherited.hollow,
        inverse: own.inverse,
        double_illuminate: own.double_illuminate || inherited.double_illuminate,
        cutaway_textures: own.cutaway_textures || inherited.cutaway_textures,
        uv_mapping: own.uv_mapping || (inherited.uv_mapping && object.takes_group_uv_mapping()),
    }
}
