//! Detects copies of one declared object, which become instances (see [`crate::world::instance`]).

use super::{Inherited, Lowering};
use crate::diagnostic::Result;
use crate::math::bvh;
use crate::scene::{Object, ObjectKind};
use crate::value::SharedDefault;
use crate::world::ObjectInfo;
use crate::world::geometry::{Geometry, GeometryBuilder};
use crate::world::instance::Instance;
use crate::world::leaf::non_identity;
use crate::world::node::{SolidKind, SolidNode};
use rustc_hash::FxHashMap;
use std::sync::Arc;

/// Minimum number of equal objects that become instances; fewer get shapes of their own.
const MANY: usize = 32;

/// Declared objects that have many copies.
#[derive(Default)]
pub(super) struct Copies {
    /// Originals by the address of their parts, which are kept alive; `None` for parts that can't be shared.
    known: FxHashMap<*const Object, Option<Arc<Original>>>,
}

/// The geometry that instances share.
struct Original {
    /// Parts of the original object, whose address is the key in [`Copies::known`].
    _address_owner: Arc<[Object]>,
    /// The original object, lowered at the origin into a geometry of its own.
    node: SolidNode,
    shared: Arc<Geometry>,
}

/// Numbers of parts and objects that were lowered before an object.
#[derive(Clone, Copy)]
pub(super) struct LoweredCounts {
    pub parts: usize,
    pub objects: usize,
}

impl Lowering {
    pub(super) fn present_counts(&self) -> LoweredCounts {
        LoweredCounts { parts: self.parts.len(), objects: self.objects.len() }
    }

    /// Returns an instance that replaces the object just lowered to `node`; `None` if the object has few copies or
    /// can't share the geometry of the others.
    pub(super) fn instance_of_copy(
        &mut self,
        object: &Object,
        node: &SolidNode,
        counts_before: LoweredCounts,
    ) -> Result<Option<Instance>> {
        let ObjectKind::Csg(_, parts) = &object.kind else { return Ok(None) };
        if !is_seen_as_one(&self.objects[counts_before.objects..]) {
            return Ok(None);
        }
        let address = parts.as_ptr();
        let few = || Arc::strong_count(parts).max(Arc::strong_count(&object.body)) < MANY;
        let original = match self.copies.known.get(&address) {
            Some(original) => original.clone(),
            None if few() => return Ok(None),
            None => {
                let original = Original::lower_if_shareable(object, parts)?.map(Arc::new);
                self.copies.known.insert(address, original.clone());
                original
            }
        };
        let Some(original) = original else { return Ok(None) };
        if !is_copy(node, &original.node, counts_before) {
            return Ok(None);
        }
        let shared = original.shared.clone();
        let copied = Instance::new(
            shared,
            non_identity(&object.transform),
            counts_before.parts as u32,
            counts_before.objects as u32,
        );
        Ok(Some(copied).filter(|copied| bvh::fits_single_precision(&copied.bounds())))
    }
}

impl Original {
    /// Lowers the object that copies share, without its transform; `None` if copies can't share it. The original owns
    /// `address_owner`, the object's parts, so that their address stays a valid key in [`Copies::known`].
    fn lower_if_shareable(object: &Object, address_owner: &Arc<[Object]>) -> Result<Option<Self>> {
        let mut alone = Lowering::default();
        let object = Object { transform: SharedDefault::DEFAULT, ..object.clone() };
        let Some(solid) = alone.lower_object(&object, &Inherited::default())? else { return Ok(None) };
        let mut builder = GeometryBuilder::default();
        builder.add(solid.node.clone());
        let shared = Geometry::from(builder);
        let original = Self { _address_owner: address_owner.clone(), node: solid.node, shared: Arc::new(shared) };
        let is_more = |node: &SolidNode| !matches!(node.kind(), SolidKind::Leaf(_));
        let fits = |shared: &Geometry| {
            shared.is_finite()
                && (shared.non_instanced_solids().count() > 1 || shared.non_instanced_solids().all(is_more))
        };
        Ok(Some(original).filter(|original| fits(&original.shared)))
    }
}

/// True if all objects are visible to the same kinds of rays, and have one view only.
fn is_seen_as_one(objects: &[ObjectInfo]) -> bool {
    let alike = |info: &ObjectInfo| ObjectInfo { interior: 0, ..*info };
    objects.iter().all(|info| info.image && info.reflection && alike(info) == alike(&objects[0]))
}

/// True if the node, whose numbers follow `counts_before`, has the same shapes as the original and depends on no other
/// data.
fn is_copy(node: &SolidNode, original: &SolidNode, counts_before: LoweredCounts) -> bool {
    if !node.has_no_clips_or_bounds()
        || !original.has_no_clips_or_bounds()
        || node.object as usize != counts_before.objects + original.object as usize
    {
        return false;
    }
    match (node.kind(), original.kind()) {
        (SolidKind::Leaf(a), SolidKind::Leaf(b)) => {
            let numbered = a.id as usize == counts_before.parts + b.id as usize;
            numbered && a.inverse == b.inverse && a.shape.shares_with(&b.shape)
        }
        (SolidKind::Union(a), SolidKind::Union(b))
        | (SolidKind::Intersection(a), SolidKind::Intersection(b))
        | (SolidKind::Merge(a), SolidKind::Merge(b)) => {
            let one_by_one = || a.iter().zip(b).all(|(a, b)| is_copy(a, b, counts_before));
            a.len() == b.len() && one_by_one()
        }
        _ => false,
    }
}
