//! From what the author said to what a ray needs: nested blocks become one M and M⁻¹ per shape, what a group says goes
//! down to its parts, textures are lowered once however often they are used.

mod instances;
mod lights;
mod place;
mod shared;
mod views;

use super::geometry::GeometryBuilder;
use super::leaf::place;
use super::{
    Geometry, Leaf, LightSource, Material, ObjectInfo, Part, PlacedMaterial, RayEpsilon, Sky, SolidNode, UncommonPart,
    World,
};
use crate::color::Gamma;
use crate::color::Rgb;
use crate::diagnostic::Result;
use crate::medium::Interior;
use crate::scene::{CsgOp, Flags, Object, ObjectKind, Painted, Scene};
use crate::shape::{Bounding, Kernel, Shape, moved_box};
use crate::source::Span;
use crate::texture::{Texture, Uncommon};
use crate::value::SharedDefault;
use instances::Copies;
use place::{Look, Place, not_finite};
use shared::{Lowered, Shared};
use std::sync::Arc;

/// Lowers what the author said to what a ray needs.
///
/// # Errors
/// Where a number is not finite or transforms, put together, flatten space.
pub fn lower(scene: &Scene) -> Result<World> {
    // (An object is a few pointers.)
    lower_objects(scene.objects.iter().cloned(), scene)
}

/// The same of a scene that nobody needs afterwards: each object goes when it is lowered, so that there is no room for both at
/// once.
///
/// # Errors
/// As [`lower`].
pub fn lower_away(mut scene: Scene) -> Result<World> {
    lower_objects(std::mem::take(&mut scene.objects).into_iter(), &scene)
}

fn lower_objects(objects: impl Iterator<Item = Object>, scene: &Scene) -> Result<World> {
    let mut lowering = Lowering::under(scene.settings.ambient_light);
    let mut builder = GeometryBuilder::default();
    for object in objects {
        lowering.default_texture = object.default_texture.clone();
        let before = lowering.mark();
        if let Some(solid) = lowering.lower_object(&object, &Inherited::default())? {
            // Of most shapes by themselves, POV-Ray 3.7 takes but the box.
            let node = match &object.kind {
                ObjectKind::Shape(shape)
                    if object.uncommon.bounded_by.is_some() && shape.quirks().bounding != Bounding::Exact =>
                {
                    solid
                        .node
                        .bounded_by_box(Some(object.pov_bounds()).filter(|_| shape.quirks().bounding == Bounding::Box))
                }
                _ => solid.node,
            };
            let number = node.is_dissolved().then_some(node.object);
            match lowering.copied(&object, &node, before)? {
                Some(copied) => builder.add_copied(copied),
                None => lowering.add_views(node, before.objects, &mut builder),
            }
            lowering.forget_dissolved(number);
        }
        drop(object);
        lowering.forget_spent();
    }
    let lit_by = lowering.lit_by();
    let noise = scene.settings.noise_generator.unwrap_or_default();
    let Lowering { parts, objects, cuts, materials, interiors, filled, lights, .. } = lowering;
    let eye = scene.camera.eye(noise, scene.settings.number_of_waves);
    let geometry = Geometry::from(builder);
    Ok(World {
        epsilon: RayEpsilon::of(&geometry, eye.frame.origin),
        eye,
        camera_source: scene.cameras.last().copied().unwrap_or(Span::NONE),
        geometry,
        see_through: objects.iter().any(|o| !o.opaque),
        bends: interiors.iter().any(|interior| interior.ior != 1.0 || interior.dispersion != 1.0),
        disperses: interiors.iter().any(|interior| interior.dispersion != 1.0),
        colors_light: interiors.iter().any(|interior| interior.colors_light()),
        parts,
        objects,
        cuts,
        materials,
        interiors,
        filled,
        lights,
        lit_by,
        sky: Sky::new(scene),
        fogs: scene.fogs.iter().filter(|fog| fog.shows()).cloned().collect(),
        rainbows: scene.rainbows.clone(),
        gamma: scene.settings.gamma.unwrap_or(Gamma::Power(1.0)),
        noise,
        waves: scene.settings.number_of_waves,
        max_trace_level: scene.settings.max_trace_level,
        adc_bailout: scene.settings.adc_bailout,
        opacity_by_color: scene.settings.opacity_by_color,
        irid_wavelength: scene.settings.irid_wavelength,
    })
}

/// The surfaces of one object by itself.
pub(super) fn lower_alone(object: &Object) -> Result<Geometry> {
    let texture = object.default_texture.clone();
    let mut lowering = Lowering { default_texture: texture, ..Lowering::default() };
    let solid = lowering.lower_object(object, &Inherited::default())?;
    let mut builder = GeometryBuilder::default();
    builder.extend(solid.map(|solid| solid.node));
    Ok(builder.into())
}

/// What the blocks around an object say.
#[derive(Clone, Default)]
struct Inherited {
    place: Place,
    texture: Option<Look>,
    inside: Option<Look>,
    /// Number of what its shapes cut, if they say nothing of their texture.
    cut: Option<u32>,
    /// Is it turned inside out an odd number of times?
    inverted: bool,
    interior: Option<u32>,
    /// Is the air in the object around it hollow, if no block said what is in there?
    hollow_air: Option<bool>,
    /// Number of the group of lights around it; 0 for none.
    lights: u32,
    /// Is the block around it that group itself?
    lights_here: bool,
    flags: Flags,
}

/// What fills the object. Old scenes name some of it in the finish; what the topmost layer says goes before the interior
/// (measured on POV-Ray 3.7).
fn interior_of(object: &Object) -> Option<Arc<Interior>> {
    let said = object.uncommon.interior.clone();
    let finish = object.texture.as_ref().and_then(|painted| painted.texture.layers.last()).map(|top| &top.finish);
    match finish.map(|finish| &*finish.uncommon) {
        Some(&Uncommon { ior, caustics, .. }) if ior.is_some() || caustics.is_some() => {
            let inside = said.unwrap_or_default();
            let (ior, caustics) = (ior.unwrap_or(inside.ior), caustics.unwrap_or(inside.caustics));
            Some(Arc::new(Interior { ior, caustics, ..(*inside).clone() }))
        }
        _ => said,
    }
}

/// A lowered object.
struct Solid {
    node: SolidNode,
    opaque: bool,
}

#[derive(Default)]
struct Lowering {
    /// For shapes of the outermost object at hand that say nothing.
    default_texture: Arc<Texture>,
    parts: Vec<Part>,
    objects: Vec<ObjectInfo>,
    cuts: Vec<Vec<(SolidNode, PlacedMaterial)>>,
    materials: Vec<Material>,
    /// Textures that may come again, and their materials.
    textures: Lowered<Texture, u32>,
    shared: Shared,
    copies: Copies,
    interiors: Vec<Arc<Interior>>,
    /// That of all shapes that say nothing.
    air: Arc<Interior>,
    /// By number of the interior: is what it fills not hollow?
    filled: Vec<bool>,
    lights: Vec<LightSource>,
    /// Groups of lights, the first of which is number 1.
    groups: Vec<Group>,
    /// The lights of no group.
    global: Vec<u32>,
}

impl Inherited {
    fn has_hollow_air(&self) -> bool {
        self.hollow_air.unwrap_or(self.flags.hollow)
    }
}

/// A `light_group`.
struct Group {
    lights: Vec<u32>,
    /// The number of another group, whose lights shine on it too.
    within: Option<u32>,
    /// Do lights outside shine on it too?
    global: bool,
}

impl Lowering {
    /// Under the scene's `ambient_light`.
    fn under(ambient_light: Rgb) -> Self {
        Self { shared: Shared::under(ambient_light), ..Self::default() }
    }

    /// What only this still holds will not come again.
    fn forget_spent(&mut self) {
        self.textures.forget_spent();
        self.shared.forget_spent();
    }

    /// What fell into its parts is no object any more.
    fn forget_dissolved(&mut self, number: Option<u32>) {
        if number.is_some_and(|number| number as usize + 1 == self.objects.len()) {
            self.objects.pop();
        }
    }

    /// `None` for what can't be hit: lights, empty groups.
    fn lower_object(&mut self, object: &Object, inherited: &Inherited) -> Result<Option<Solid>> {
        let own = self.own(object, inherited)?;
        let clip = self.lower_clip(object, inherited)?;
        let solid = match &object.kind {
            ObjectKind::Light(light) => self.lower_light(light, &own, inherited)?,
            ObjectKind::Shape(shape) => {
                let shape = shape.under(&own.place.now);
                let is_there = !shape.is_open() || !shape.bounds_under(&own.place.now).is_empty();
                is_there.then(|| self.lower_shape(object, &shape, &own)).transpose()?
            }
            ObjectKind::Csg(op, parts) => self.lower_csg(*op, parts, &own)?,
        };
        let Some(Solid { mut node, opaque }) = solid else { return Ok(None) };
        if matches!(object.kind, ObjectKind::Csg(CsgOp::Intersection | CsgOp::Difference, _)) {
            node = node.visible_within(moved_box(&inherited.place.now, &object.pov_bounds()));
        }
        if object.uncommon.flags.inverse {
            node = node.inverted();
        }
        let clips = !matches!(&object.kind, ObjectKind::Shape(shape) if shape.quirks().ignores_clipping);
        if clips && !clip.is_empty() {
            node = node.clipped(clip);
        }
        Ok(Some(Solid { node: node.bounded(self.lower_bounds(object, inherited)?), opaque }))
    }

    /// What holds inside the object's block.
    fn own(&mut self, object: &Object, inherited: &Inherited) -> Result<Inherited> {
        let place = inherited.place.inside(object)?;
        let look = |painted: &Option<Painted>| inherited.place.look(painted.as_ref(), object, &place);
        let texture = look(&object.texture)?;
        let inside = look(&object.uncommon.interior_texture)?;
        let interior = interior_of(object);
        let flags = joined(object, inherited.flags);
        let lights = object.uncommon.light_group.map(|global| self.add_group(global));
        let hollow = || hollow_inside(object, inherited.flags.hollow).unwrap_or(flags.hollow);
        Ok(Inherited {
            hollow_air: inherited.hollow_air.or_else(|| interior.is_none().then(hollow)),
            place,
            // (Of parts with textures of their own too: measured on POV-Ray 3.7.)
            inside: inside.or_else(|| inherited.inside.clone()),
            texture: texture.or_else(|| inherited.texture.clone()),
            cut: inherited.cut,
            inverted: inherited.inverted != object.uncommon.flags.inverse,
            interior: interior.map(|i| self.add_interior(i, hollow())).or(inherited.interior),
            lights: lights.unwrap_or(inherited.lights),
            lights_here: lights.is_some(),
            flags,
        })
    }

    /// Each is another one, even if it is like the one before: a ray leaves what it has entered.
    fn add_interior(&mut self, mut interior: Arc<Interior>, hollow: bool) -> u32 {
        if !interior.unsupported.is_empty() {
            Arc::make_mut(&mut interior).unsupported.clear();
        }
        if !interior.has_ior && interior.dispersion != 1.0 {
            Arc::make_mut(&mut interior).dispersion = 1.0;
        }
        self.interiors.push(interior);
        self.filled.push(!hollow);
        self.interiors.len() as u32 - 1
    }

    fn add_air(&mut self, hollow: bool) -> u32 {
        self.add_interior(self.air.clone(), hollow)
    }

    /// The objects that clip this one.
    fn lower_clip(&mut self, object: &Object, inherited: &Inherited) -> Result<Vec<SolidNode>> {
        self.lower_around(object.uncommon.clipped_by.as_deref(), inherited)
    }

    /// The objects that bound it, unless they clip it too.
    fn lower_bounds(&mut self, object: &Object, inherited: &Inherited) -> Result<Vec<SolidNode>> {
        let (clipped_by, bounded_by) = (&object.uncommon.clipped_by, &object.uncommon.bounded_by);
        self.lower_around(bounded_by.as_deref().filter(|_| bounded_by != clipped_by), inherited)
    }

    /// Objects that are in the space around another.
    fn lower_around(&mut self, parts: Option<&[Object]>, inherited: &Inherited) -> Result<Vec<SolidNode>> {
        let mut all = vec![];
        for part in parts.into_iter().flatten() {
            all.extend(self.lower_object(part, inherited)?.map(|solid| solid.node));
        }
        Ok(all)
    }

    fn lower_shape(&mut self, object: &Object, shape: &Shape, own: &Inherited) -> Result<Solid> {
        let bounds = shape.bounds_under(&own.place.now);
        if bounds.min.is_nan() || bounds.max.is_nan() {
            return not_finite(object.source);
        }
        let look = own.texture.clone().unwrap_or_else(|| self.default_look());
        let outside = self.lower_look(&look);
        let hides_inside = shape.quirks().embedded_textures_on_both_sides && object.uncommon.embedded.is_some();
        let inside = own.inside.as_ref().filter(|_| !hides_inside);
        let inside = inside.map(|look| self.lower_look(look));
        let embedded = object.uncommon.embedded.iter().flat_map(|all| all.iter());
        let embedded: Box<[PlacedMaterial]> = embedded
            .map(|painted| {
                let along = shape.quirks().moves_embedded_textures;
                let transform = if along { own.place.now.clone() } else { own.place.of_textures(object) };
                self.lower_look(&Look { texture: painted.texture.clone(), transform })
            })
            .collect();
        let cut = own.cut.filter(|_| own.texture.is_none());
        let others = cut.map(|cut| self.cuts[cut as usize].iter().map(|(_, placed)| placed));
        let opaque = [Some(&outside), inside.as_ref().filter(|_| !shape.quirks().shadow_by_outside)]
            .into_iter()
            .flatten()
            .chain(others.into_iter().flatten())
            .chain(embedded.iter())
            .all(|placed| self.materials[placed.material as usize].opaque);
        let interior = own.interior.unwrap_or_else(|| self.add_air(own.has_hollow_air()));
        let id = self.parts.len() as u32;
        let Flags { double_illuminate, uv_mapping: uv, no_shadow, .. } = own.flags;
        let lights = own.lights;
        let is_rare = inside.is_some() || cut.is_some() || lights != 0 || !embedded.is_empty();
        let uncommon = is_rare.then(|| Box::new(UncommonPart { inside, embedded, lights, cut }));
        self.parts.push(Part { outside, uncommon, interior, double_illuminate, uv, no_shadow, source: object.source });
        let leaf = Leaf::placed(shape.clone(), &own.place.now, id);
        let number = self.add_object(own, opaque, interior);
        Ok(Solid { node: SolidNode::leaf(leaf, number), opaque })
    }

    fn add_object(&mut self, own: &Inherited, opaque: bool, interior: u32) -> u32 {
        let Flags { no_shadow, no_image, no_reflection, .. } = own.flags;
        let (shadow, image, reflection) = (!no_shadow, !no_image, !no_reflection);
        self.add_info(ObjectInfo { shadow, image, through: image, reflection, opaque, interior })
    }

    fn add_info(&mut self, info: ObjectInfo) -> u32 {
        self.objects.push(info);
        self.objects.len() as u32 - 1
    }

    /// What shapes show that say nothing.
    fn default_look(&self) -> Look {
        Look { texture: self.default_texture.clone(), transform: SharedDefault::DEFAULT }
    }

    fn lower_look(&mut self, look: &Look) -> PlacedMaterial {
        let Self { textures, shared, materials, .. } = self;
        let material = *textures.of(&look.texture, |texture| {
            materials.push(Material::new(texture, shared));
            materials.len() as u32 - 1
        });
        let place = if self.materials[material as usize].solid { None } else { place(&look.transform) };
        PlacedMaterial { material, place }
    }

    /// Appends the shapes in a group by themselves, with what each shows where it is cut (manual, "Cutaway Textures"). What has no
    /// texture cuts the others where all have to hold a point, and shows the default where one is enough; what a difference takes away
    /// is not cut (measured on POV-Ray 3.7).
    fn find_cut(
        &mut self,
        op: CsgOp,
        parts: &[Object],
        around: &Place,
        look: Option<&Look>,
        out: &mut Vec<(SolidNode, PlacedMaterial)>,
    ) -> Result<()> {
        let cut = if op == CsgOp::Difference { 1 } else { parts.len() };
        let any = matches!(op, CsgOp::Union | CsgOp::Merge);
        for part in parts.iter().take(cut) {
            let place = around.inside(part)?;
            let own = around.look(part.texture.as_ref(), part, &place)?;
            let look = own.as_ref().or(look);
            match (&part.kind, look) {
                (ObjectKind::Csg(op, parts), look) => self.find_cut(*op, parts, &place, look, out)?,
                (ObjectKind::Shape(shape), look) if look.is_some() || any => {
                    let placed = self.lower_look(&look.cloned().unwrap_or_else(|| self.default_look()));
                    let node = SolidNode::leaf(Leaf::placed(shape.clone(), &place.now, 0), 0);
                    out.push((if part.uncommon.flags.inverse { node.inverted() } else { node }, placed));
                }
                _ => {}
            }
        }
        Ok(())
    }

    fn lower_csg(&mut self, op: CsgOp, parts: &[Object], own: &Inherited) -> Result<Option<Solid>> {
        let mut within = own.clone();
        let joins = matches!(op, CsgOp::Union | CsgOp::Merge);
        if within.interior.is_none() {
            // All faces border on the same inside, of a union too (measured on POV-Ray 3.7).
            within.interior = Some(self.add_air(own.has_hollow_air()));
        }
        // Turned inside out, a union is an intersection, and an intersection a union. What is joined cuts nothing.
        if joins != own.inverted {
            within.cut = None;
        } else if own.flags.cutaway_textures && within.texture.is_none() && within.cut.is_none() {
            let mut cut = vec![];
            self.find_cut(op, parts, &own.place, None, &mut cut)?;
            within.cut = Some(self.cuts.len() as u32);
            self.cuts.push(cut);
        }
        let (mut nodes, mut opaque) = (vec![], true);
        for (i, part) in parts.iter().enumerate() {
            if op == CsgOp::Difference && i == 1 {
                within.inverted = !within.inverted;
            }
            match self.lower_object(part, &within)? {
                Some(solid) => {
                    opaque &= solid.opaque;
                    nodes.push(solid.node);
                }
                // Nothing without something is nothing, and so is what nothing shares with anything.
                None if op == CsgOp::Intersection || (op == CsgOp::Difference && i == 0) => return Ok(None),
                None => {}
            }
        }
        // (What nothing shares is everything: an empty intersection has no surface, but cameras start in it, as in POV-Ray 3.7.)
        if nodes.is_empty() && (joins || !parts.is_empty()) {
            return Ok(None);
        }
        let interior = match within.interior {
            Some(interior) => interior,
            None => self.add_air(own.has_hollow_air()),
        };
        let number = self.add_object(own, opaque, interior);
        let node = match op {
            CsgOp::Union => SolidNode::union(nodes, number),
            CsgOp::Intersection => SolidNode::intersection(nodes, number),
            CsgOp::Difference => SolidNode::difference(nodes, number),
            CsgOp::Merge => SolidNode::merge(nodes, number),
        };
        Ok(Some(Solid { node, opaque }))
    }
}

/// Is it hollow where blocks within it do not say what is in there? The last shape of all tells, of a union too (measured on POV-Ray
/// 3.7). `None` where there is no such shape.
fn hollow_inside(object: &Object, inherited: bool) -> Option<bool> {
    let hollow = object.uncommon.flags.hollow || inherited;
    match &object.kind {
        ObjectKind::Shape(_) => Some(hollow),
        ObjectKind::Light(_) => None,
        ObjectKind::Csg(_, parts) => {
            let open = parts.iter().rev().filter(|part| interior_of(part).is_none());
            open.filter_map(|part| hollow_inside(part, hollow)).next()
        }
    }
}

/// Switches of a part and of the group around it. `inverse` is each one's own.
fn joined(object: &Object, inherited: Flags) -> Flags {
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
        uv_mapping: own.uv_mapping || (inherited.uv_mapping && object.follows_uv()),
    }
}
