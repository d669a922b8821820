//! Lowering: converts the scene as written to the data that rays need. Each shape gets one transform, the parts of a
//! group inherit its properties, and shared textures are lowered once.

mod cutaway;
mod inherited;
mod instances;
mod lights;
mod place;
mod shared;
mod views;

use super::geometry::GeometryBuilder;
use super::leaf::non_identity;
use super::medium::Medium;
use super::{
    Geometry, Leaf, LightSource, Material, ObjectInfo, Part, PlacedMaterial, RayEpsilon, Sky, SolidNode, UncommonPart,
    World,
};
use crate::color::Gamma;
use crate::diagnostic::Result;
use crate::math::{Transform, cancel};
use crate::medium::{Interior, Media};
use crate::scene::{CsgOp, Flags, Object, ObjectKind, Painted, PhotonSettings, Scene, Settings};
use crate::shape::{Bounding, Kernel, Shape, transformed_box};
use crate::source::{Activity, Span};
use crate::texture::Texture;
use crate::value::SharedDefault;
use inherited::{Inherited, combined_flags, hollow_of_last_shape, interior_of};
use instances::Copies;
use place::{PlacedTexture, not_finite_error};
use shared::{LoweredTable, SharedSurfaceParts};
use std::collections::BTreeMap;
use std::sync::Arc;

/// Lowers a scene.
///
/// # Errors
/// If numbers are not finite or the product of transforms is singular.
pub fn lower(scene: &Scene) -> Result<World> {
    // (Cloning an object copies a few pointers.)
    lower_objects(scene.objects.iter().cloned(), scene)
}

/// Lowers a scene and frees each object as soon as it is lowered, which needs less memory.
///
/// # Errors
/// As [`lower`].
pub fn lower_and_free(mut scene: Scene) -> Result<World> {
    lower_objects(std::mem::take(&mut scene.objects).into_iter(), &scene)
}

fn lower_objects(objects: impl ExactSizeIterator<Item = Object>, scene: &Scene) -> Result<World> {
    let _activity = Activity::begin("while its objects were prepared for rendering");
    let mut lowering = Lowering::new(&scene.settings);
    // Most objects have one part or more. Lists that grow from nothing leave gaps in the memory.
    lowering.parts.reserve(objects.len());
    lowering.objects.reserve(objects.len());
    let mut builder = GeometryBuilder::with_capacity(objects.len());
    for object in objects {
        // (Whoever cancelled the lowering discards its result.)
        if cancel::is_cancelled() {
            break;
        }
        lowering.default_texture = object.default_texture.clone();
        let before = lowering.present_counts();
        if let Some(solid) = lowering.lower_object(&object, &Inherited::default())? {
            // quirk: bounded_by_box
            let node = match &object.kind {
                ObjectKind::Shape(shape)
                    if object.uncommon.bounded_by.is_some() && shape.quirks().bounding != Bounding::Exact =>
                {
                    solid.node.with_bounds_replaced_by_box(
                        Some(object.pov_bounds()).filter(|_| shape.quirks().bounding == Bounding::Box),
                    )
                }
                _ => solid.node,
            };
            let number = node.can_be_split_into_children().then_some(node.object);
            match lowering.instance_of_copy(&object, &node, before)? {
                Some(copied) => builder.add_instance(copied),
                None => lowering.add_views(node, before.objects, &mut builder),
            }
            lowering.free_number_if_last(number);
        }
        drop(object);
        lowering.drop_unused();
    }
    let lit_by = lowering.lights_of_groups();
    let noise = scene.settings.noise_generator.unwrap_or_default();
    let Lowering { parts, objects, cuts, materials, interiors, media, filled, lights, photons, .. } = lowering;
    let restarts_shadow_rays = lowering.has_origin_dependent_hits;
    let eye = scene.camera.lower(noise, scene.settings.number_of_waves);
    let geometry = Geometry::from(builder);
    Ok(World {
        epsilon: RayEpsilon::for_scene(&geometry, eye.frame.origin),
        eye,
        camera_source: scene.cameras.last().copied().unwrap_or(Span::NONE),
        geometry,
        see_through: objects.iter().any(|o| !o.opaque),
        restarts_shadow_rays,
        bends: interiors.iter().any(|interior| interior.ior != 1.0 || interior.dispersion != 1.0),
        disperses: interiors.iter().any(|interior| interior.dispersion != 1.0),
        colors_light: interiors.iter().any(|interior| interior.changes_crossing_light()),
        parts,
        objects,
        cuts,
        materials,
        interiors,
        media,
        air: lowered_media(&scene.media, &Transform::IDENTITY, 0),
        filled,
        lights,
        lit_by,
        sky: Sky::new(scene),
        fogs: scene.fogs.iter().filter(|fog| fog.has_effect()).cloned().collect(),
        rainbows: scene.rainbows.clone(),
        gamma: scene.settings.gamma.unwrap_or(Gamma::Power(1.0)),
        noise,
        photons,
        radiosity: scene.settings.radiosity.clone(),
        photon_map: scene.settings.photons.clone(),
        subsurface: scene.settings.subsurface.clone(),
        waves: scene.settings.number_of_waves,
        max_trace_level: scene.settings.max_trace_level,
        adc_bailout: scene.settings.adc_bailout,
        opacity_by_color: scene.settings.opacity_by_color,
        irid_wavelength: scene.settings.irid_wavelength,
    })
}

/// Lowers media; those without effect count, too (quirk: `phase_of_several`).
fn lowered_media(media: &[Media], place: &Transform, light_set: u32) -> Box<[Medium]> {
    media.iter().map(|media| Medium::new(media, place, light_set)).collect()
}

/// Lowers one object into a geometry of its own.
pub(super) fn lower_alone(object: &Object) -> Result<Geometry> {
    let texture = object.default_texture.clone();
    let mut lowering = Lowering { default_texture: texture, ..Lowering::default() };
    let solid = lowering.lower_object(object, &Inherited::default())?;
    let mut builder = GeometryBuilder::default();
    builder.extend(solid.map(|solid| solid.node));
    Ok(builder.into())
}

/// A lowered object.
struct Solid {
    node: SolidNode,
    opaque: bool,
}

#[derive(Default)]
struct Lowering {
    /// Texture of shapes without a texture in the current outermost object.
    default_texture: Arc<Texture>,
    parts: Vec<Part>,
    objects: Vec<ObjectInfo>,
    cuts: Vec<Vec<(SolidNode, PlacedMaterial)>>,
    materials: Vec<Material>,
    /// Materials of textures that later objects may share.
    textures: LoweredTable<Texture, u32>,
    shared: SharedSurfaceParts,
    copies: Copies,
    interiors: Vec<Arc<Interior>>,
    media: BTreeMap<u32, Box<[Medium]>>,
    /// Distinct photon settings; the first entry is the default.
    photons: Vec<PhotonSettings>,
    /// Interior of all shapes that have none.
    air: Arc<Interior>,
    /// True for each interior that is not hollow.
    filled: Vec<bool>,
    lights: Vec<LightSource>,
    /// Light groups; the first one has the number 1.
    groups: Vec<Group>,
    /// Numbers of the lights outside of all groups.
    global: Vec<u32>,
    /// True if the hits on any lowered shape depend on the ray's origin (quirk: `isosurface_csg_shadows`).
    has_origin_dependent_hits: bool,
}

/// A `light_group` while it is lowered.
struct Group {
    lights: Vec<u32>,
    /// Number of an enclosing group whose lights illuminate this group, too.
    within: Option<u32>,
    /// True if lights outside of the group illuminate it.
    global: bool,
}

impl Lowering {
    /// Creates the state before any object of a scene with these settings is lowered.
    fn new(settings: &Settings) -> Self {
        let photons = vec![PhotonSettings::default()];
        Self { shared: SharedSurfaceParts::new(settings), photons, ..Self::default() }
    }

    /// Drops shared textures that no object uses any more.
    fn drop_unused(&mut self) {
        self.textures.drop_unused();
        self.shared.drop_unused();
    }

    /// Frees the number of an object that was split into its parts, for the next object; only the number given last can
    /// be freed.
    fn free_number_if_last(&mut self, number: Option<u32>) {
        if number.is_some_and(|number| number as usize + 1 == self.objects.len()) {
            self.objects.pop();
        }
    }

    /// Lowers an object; `None` for what rays cannot hit: a light without `looks_like`, an empty group or an empty
    /// surface.
    fn lower_object(&mut self, object: &Object, inherited: &Inherited) -> Result<Option<Solid>> {
        let own = self.inherited_by_parts(object, inherited)?;
        let clip = self.lower_clipping_objects(object, inherited)?;
        let solid = match &object.kind {
            ObjectKind::Light(light) => self.lower_light(light, &own, inherited)?,
            ObjectKind::Shape(shape) => {
                let shape = shape.shape_under_transform(&own.place.world_from_block);
                let is_there = !shape.is_open() || !shape.bounds_under(&own.place.world_from_block).is_empty();
                is_there.then(|| self.lower_shape(object, &shape, &own)).transpose()?
            }
            ObjectKind::Csg(op, parts) => self.lower_csg(*op, parts, &own)?,
        };
        let Some(Solid { mut node, opaque }) = solid else { return Ok(None) };
        if matches!(object.kind, ObjectKind::Csg(CsgOp::Intersection | CsgOp::Difference, _)) {
            node =
                node.visible_to_rays_through(transformed_box(&inherited.place.world_from_block, &object.pov_bounds()));
        }
        if object.uncommon.flags.inverse {
            node = node.inverted();
        }
        let clips = !matches!(&object.kind, ObjectKind::Shape(shape) if shape.quirks().ignores_clipping);
        if clips && !clip.is_empty() {
            node = node.clipped(clip);
        }
        Ok(Some(Solid { node: node.bounded(self.lower_bounding_objects(object, inherited)?), opaque }))
    }

    /// Returns the properties of an object, which its parts inherit. Adds its interior, light group and photon settings
    /// to the lists.
    fn inherited_by_parts(&mut self, object: &Object, inherited: &Inherited) -> Result<Inherited> {
        let place = inherited.place.inside(object)?;
        let look = |painted: &Option<Painted>| inherited.place.placed_texture(painted.as_ref(), object, &place);
        let texture = look(&object.texture)?;
        let inside = look(&object.uncommon.interior_texture)?;
        let of_group = inherited.interior.is_some() && object.uncommon.interior.is_none();
        let interior = if of_group { None } else { interior_of(object) };
        let flags = combined_flags(object, inherited.flags);
        let lights = object.uncommon.light_group.map(|global| self.add_light_group(global));
        let group = lights.unwrap_or(inherited.light_set);
        let hollow = || hollow_of_last_shape(object, inherited.flags.hollow).unwrap_or(flags.hollow);
        Ok(Inherited {
            hollow_air: inherited.hollow_air.or_else(|| interior.is_none().then(hollow)),
            place,
            // quirk: interior_texture_of_group
            inside: inside.or_else(|| inherited.inside.clone()),
            texture: texture.or_else(|| inherited.texture.clone()),
            cut: inherited.cut,
            inverted: inherited.inverted != object.uncommon.flags.inverse,
            interior: interior
                .map(|i| self.add_interior_with_media(i, hollow(), inherited, group))
                .or(inherited.interior),
            light_set: group,
            lights_here: lights.is_some(),
            flags,
            importance: object.uncommon.radiosity.map(|own| own.importance as f32).or(inherited.importance),
            photons: self.add_photon_settings(object, inherited.photons, group),
        })
    }

    /// Adds the photon settings of an object that the lights of `light_set` illuminate, in a group with the settings
    /// number `group_settings`, and returns their number.
    fn add_photon_settings(&mut self, object: &Object, group_settings: u32, light_set: u32) -> u32 {
        // quirk: photons_of_global_lights
        let is_lit_by_emitters = light_set == 0 || self.groups[light_set as usize - 1].global;
        if object.uncommon.photons.is_none() && is_lit_by_emitters {
            return group_settings;
        }
        let own = object.uncommon.photons.unwrap_or_default();
        let mut settings = own.inherit(self.photons.get(group_settings as usize).copied().unwrap_or_default());
        settings.target = settings.target.filter(|_| is_lit_by_emitters);
        let known = self.photons.iter().position(|other| *other == settings);
        let number = known.unwrap_or(self.photons.len());
        if number == self.photons.len() {
            self.photons.push(settings);
        }
        number as u32
    }

    /// Adds an interior with its media, which are in the space `around` the object and illuminated by the lights of a
    /// group, and returns the interior's number.
    fn add_interior_with_media(
        &mut self,
        interior: Arc<Interior>,
        hollow: bool,
        around: &Inherited,
        light_set: u32,
    ) -> u32 {
        let media = lowered_media(&interior.media, &around.place.world_from_block, light_set);
        let number = self.add_interior(interior, hollow);
        if !media.is_empty() {
            self.media.insert(number, media);
        }
        number
    }

    /// Adds an interior and returns its number. Equal interiors get different numbers, so that a ray that leaves an
    /// object finds the interior that it entered.
    fn add_interior(&mut self, mut interior: Arc<Interior>, hollow: bool) -> u32 {
        if !interior.has_ior && interior.dispersion != 1.0 {
            Arc::make_mut(&mut interior).dispersion = 1.0;
        }
        self.interiors.push(interior);
        self.filled.push(!hollow);
        self.interiors.len() as u32 - 1
    }

    fn add_default_interior(&mut self, hollow: bool) -> u32 {
        self.add_interior(self.air.clone(), hollow)
    }

    /// Lowers the objects of `clipped_by`.
    fn lower_clipping_objects(&mut self, object: &Object, inherited: &Inherited) -> Result<Vec<SolidNode>> {
        self.lower_in_surrounding_space(object.uncommon.clipped_by.as_deref(), inherited)
    }

    /// Lowers the objects of `bounded_by`, unless they clip as well.
    fn lower_bounding_objects(&mut self, object: &Object, inherited: &Inherited) -> Result<Vec<SolidNode>> {
        let (clipped_by, bounded_by) = (&object.uncommon.clipped_by, &object.uncommon.bounded_by);
        self.lower_in_surrounding_space(bounded_by.as_deref().filter(|_| bounded_by != clipped_by), inherited)
    }

    /// Lowers objects in the space around another object.
    fn lower_in_surrounding_space(
        &mut self,
        parts: Option<&[Object]>,
        inherited: &Inherited,
    ) -> Result<Vec<SolidNode>> {
        let mut all = vec![];
        for part in parts.into_iter().flatten() {
            all.extend(self.lower_object(part, inherited)?.map(|solid| solid.node));
        }
        Ok(all)
    }

    fn lower_shape(&mut self, object: &Object, shape: &Shape, own: &Inherited) -> Result<Solid> {
        let bounds = shape.bounds_under(&own.place.world_from_block);
        if bounds.min.is_nan() || bounds.max.is_nan() {
            return not_finite_error(object.source);
        }
        self.has_origin_dependent_hits |= shape.quirks().hits_depend_on_origin;
        let look = own.texture.clone().unwrap_or_else(|| self.default_placed_texture());
        let outside = self.lower_placed_texture(&look);
        let hides_inside = shape.quirks().embedded_textures_on_both_sides && object.uncommon.embedded.is_some();
        let inside = own.inside.as_ref().filter(|_| !hides_inside);
        let inside = inside.map(|look| self.lower_placed_texture(look));
        let embedded = object.uncommon.embedded.iter().flat_map(|all| all.iter());
        let embedded: Box<[PlacedMaterial]> = embedded
            .map(|painted| {
                let along = shape.quirks().moves_embedded_textures;
                let transform =
                    if along { own.place.world_from_block.clone() } else { own.place.texture_transform_of(object) };
                self.lower_placed_texture(&PlacedTexture { texture: painted.texture.clone(), transform })
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
        let interior = own.interior.unwrap_or_else(|| self.add_default_interior(own.has_hollow_air()));
        let id = self.parts.len() as u32;
        let Flags { double_illuminate, uv_mapping: uv, no_shadow, .. } = own.flags;
        let light_set = own.light_set;
        let importance = own.importance.unwrap_or(1.0);
        let is_rare = inside.is_some() || cut.is_some() || light_set != 0 || !embedded.is_empty() || importance != 1.0;
        let uncommon = is_rare.then(|| Box::new(UncommonPart { inside, embedded, light_set, cut, importance }));
        let collects_photons = !self.photons.get(own.photons as usize).is_some_and(|photons| photons.ignores_photons);
        self.parts.push(Part {
            outside,
            uncommon,
            interior,
            double_illuminate,
            uv,
            collects_photons,
            no_shadow,
            source: object.source,
        });
        let leaf = Leaf::placed(shape.clone(), &own.place.world_from_block, id);
        let number = self.add_object(own, opaque, interior);
        Ok(Solid { node: SolidNode::leaf(leaf, number), opaque })
    }

    fn add_object(&mut self, own: &Inherited, opaque: bool, interior: u32) -> u32 {
        let Flags { no_shadow, no_image, no_reflection, no_radiosity, .. } = own.flags;
        let (shadow, image, reflection, radiosity) = (!no_shadow, !no_image, !no_reflection, !no_radiosity);
        // quirk: photons_by_visibility
        let is_hit_by_photons = shadow && image;
        self.add_info(ObjectInfo {
            shadow,
            image,
            through: image,
            reflection,
            radiosity,
            is_hit_by_photons,
            photons: own.photons,
            opaque,
            interior,
        })
    }

    fn add_info(&mut self, info: ObjectInfo) -> u32 {
        self.objects.push(info);
        self.objects.len() as u32 - 1
    }

    /// Returns the default texture with its transform, for shapes that have none.
    fn default_placed_texture(&self) -> PlacedTexture {
        PlacedTexture { texture: self.default_texture.clone(), transform: SharedDefault::DEFAULT }
    }

    fn lower_placed_texture(&mut self, placed: &PlacedTexture) -> PlacedMaterial {
        let Self { textures, shared, materials, .. } = self;
        let material = *textures.get_or_lower(&placed.texture, |texture| {
            materials.push(Material::new(texture, shared));
            materials.len() as u32 - 1
        });
        let place = if self.materials[material as usize].solid { None } else { non_identity(&placed.transform) };
        PlacedMaterial { material, place }
    }

    fn lower_csg(&mut self, op: CsgOp, parts: &[Object], own: &Inherited) -> Result<Option<Solid>> {
        let mut within = own.clone();
        let joins = matches!(op, CsgOp::Union | CsgOp::Merge);
        if within.interior.is_none() {
            // quirk: csg_parts_share_interior
            within.interior = Some(self.add_default_interior(own.has_hollow_air()));
        }
        // Inverted, a union is an intersection and vice versa. Parts of a union do not cut each other.
        if joins != own.inverted {
            within.cut = None;
        } else if own.flags.cutaway_textures && within.texture.is_none() && within.cut.is_none() {
            let mut cut = vec![];
            self.collect_cutaway_materials(op, parts, &own.place, None, &mut cut)?;
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
                // A difference without its first part is empty, and so is an intersection with an empty part.
                None if op == CsgOp::Intersection || (op == CsgOp::Difference && i == 0) => return Ok(None),
                None => {}
            }
        }
        // quirk: empty_intersection
        if nodes.is_empty() && (joins || !parts.is_empty()) {
            return Ok(None);
        }
        let interior = match within.interior {
            Some(interior) => interior,
            None => self.add_default_interior(own.has_hollow_air()),
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
