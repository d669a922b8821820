//! Transforms of objects and textures: nested blocks become one M and M⁻¹.

use crate::diagnostic::{Diagnostic, Result, codes};
use crate::math::Transform;
use crate::scene::{Object, Painted};
use crate::source::Span;
use crate::texture::Texture;
use crate::value::SharedDefault;
use std::sync::Arc;

/// The coordinate space inside a block, as a transform to world space.
#[derive(Clone, Default)]
pub(super) struct BlockSpace {
    /// Transform from this space to world space.
    pub world_from_block: SharedDefault<Transform>,
}

/// A texture with its transform.
#[derive(Clone)]
pub(super) struct PlacedTexture {
    pub texture: Arc<Texture>,
    pub transform: SharedDefault<Transform>,
}

impl BlockSpace {
    /// Returns the space inside an object's block: world from object = world from block · block from object.
    pub fn inside(&self, object: &Object) -> Result<Self> {
        Ok(Self { world_from_block: checked_product(&object.transform, &self.world_from_block, object.source)? })
    }

    /// Returns the transform of textures that move with the object; the identity under `uv_mapping` (quirk:
    /// `uv_mapping_keeps_space`).
    pub fn texture_transform_of(&self, object: &Object) -> SharedDefault<Transform> {
        if object.uncommon.flags.uv_mapping { SharedDefault::DEFAULT } else { self.world_from_block.clone() }
    }

    /// Returns an object's texture with its transform to world space; `inside` is the space inside the object's block.
    pub fn placed_texture(
        &self,
        painted: Option<&Painted>,
        object: &Object,
        inside: &BlockSpace,
    ) -> Result<Option<PlacedTexture>> {
        let Some(Painted { texture, moved: since }) = painted else { return Ok(None) };
        let transform = match since {
            Some(own) if !object.uncommon.flags.uv_mapping => {
                let own = if own.is_identity() { SharedDefault::DEFAULT } else { (**own).into() };
                checked_product(&own, &self.world_from_block, object.source)?
            }
            _ => inside.texture_transform_of(object),
        };
        Ok(Some(PlacedTexture { texture: texture.clone(), transform }))
    }
}

/// Returns the transform `inner` followed by `outer`. If one is the identity, the other is shared.
fn composed(inner: &SharedDefault<Transform>, outer: &SharedDefault<Transform>) -> SharedDefault<Transform> {
    match (inner.explicit_value(), outer.explicit_value()) {
        (None, _) => outer.clone(),
        (_, None) => inner.clone(),
        (Some(inner), Some(outer)) => inner.then(outer).into(),
    }
}

/// Returns the transform `inner` followed by `outer`, or an error if the product is singular or not finite.
fn checked_product(
    inner: &SharedDefault<Transform>,
    outer: &SharedDefault<Transform>,
    source: Span,
) -> Result<SharedDefault<Transform>> {
    let transform = composed(inner, outer);
    match inner.explicit_value() {
        Some(_) => checked(*transform, source).map(|_| transform),
        // `outer` has been checked.
        None => Ok(transform),
    }
}

/// Returns the transform, or an error if it is singular or not finite.
fn checked(transform: Transform, source: Span) -> Result<Transform> {
    let Transform { m, inv } = &transform;
    if !m.is_finite() {
        return not_finite_error(source);
    }
    if !inv.is_finite() || m.matrix3.determinant() == 0.0 || inv.matrix3.determinant() == 0.0 {
        let message = "all the transforms of this object together flatten it";
        return Diagnostic::new(codes::SINGULAR, source, message)
            .help("a factor that is 0 or nearly so has no way back; take a larger one, or a flat shape such as `disc`")
            .into();
    }
    Ok(transform)
}

pub(super) fn not_finite_error<T>(source: Span) -> Result<T> {
    Diagnostic::new(codes::NOT_FINITE, source, "a number that places this object is infinite or not a number")
        .help("look for a division by zero, or a number that grows in a loop")
        .into()
}
