//! Views: a union or merge whose parts have `no_image` or `no_reflection` has another geometry for each kind of ray.

use super::Lowering;
use crate::world::ObjectInfo;
use crate::world::geometry::GeometryBuilder;
use crate::world::node::{NodeParts, SolidKind, SolidNode};

impl Lowering {
    /// Adds an object of the scene with a separate view for each kind of ray from which parts are hidden. The numbers
    /// of the object's parts in [`Lowering::objects`] start at `first_object`.
    pub(super) fn add_views(&mut self, node: SolidNode, first_object: usize, builder: &mut GeometryBuilder) {
        match self.objects[first_object..].iter().all(|object| object.image && object.reflection) {
            true => builder.add(node),
            false => self.add_each_view(node, builder),
        }
    }

    /// Adds a node; if some of its parts are hidden from some rays, adds one view for camera rays, one for transmitted
    /// rays, one for reflected rays, and one for all others (quirk: `no_image_in_union`).
    fn add_each_view(&mut self, node: SolidNode, builder: &mut GeometryBuilder) {
        let mut node = match node.into_parts() {
            NodeParts::Many(parts) => return parts.into_iter().for_each(|part| self.add_each_view(part, builder)),
            NodeParts::One(node) => node,
        };
        let info = |object: u32| self.objects[object as usize];
        let mut rest = info(node.object);
        let none = ObjectInfo {
            shadow: false,
            image: false,
            through: false,
            reflection: false,
            radiosity: false,
            is_hit_by_photons: false,
            interior: ObjectInfo::VIEW,
            ..rest
        };
        let of_camera = ObjectInfo { image: rest.image, ..none };
        let of_passed = ObjectInfo { through: rest.through, ..none };
        let of_mirrors = ObjectInfo { reflection: rest.reflection, ..none };
        let hidden_from_camera = |kind: &SolidKind, part| matches!(kind, SolidKind::Merge(_)) && !info(part).image;
        let for_camera = if rest.image { node.without_hidden_if_any(&hidden_from_camera) } else { None };
        let for_passed = if rest.through { node.without_hidden_if_any(&|_, part| !info(part).image) } else { None };
        let for_mirrors =
            if rest.reflection { node.without_hidden_if_any(&|_, part| !info(part).reflection) } else { None };
        rest.image &= for_camera.is_none();
        rest.through &= for_passed.is_none();
        rest.reflection &= for_mirrors.is_none();
        if for_camera.is_some() || for_passed.is_some() || for_mirrors.is_some() {
            node.object = self.add_info(rest);
        }
        for (view, info) in [(for_camera, of_camera), (for_passed, of_passed), (for_mirrors, of_mirrors)] {
            if let Some(mut view) = view {
                view.object = self.add_info(info);
                builder.add(view);
            }
        }
        builder.add(node);
    }
}
