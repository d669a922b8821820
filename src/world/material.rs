//! Lowered textures: layers whose constants are computed in advance.

use crate::color::{Color, Rgb};
use crate::pattern::{Pattern, PatternProgram, Space, TextureContext};
use crate::texture::{
    self, Blend, Finish, Irid, Normal, NormalProgram, Pigment, PigmentProgram, Reflection, Shares, Texture,
};
use serde::Serialize;
use std::sync::Arc;

/// A lowered texture.
#[derive(Clone, Debug, Serialize)]
pub struct Material {
    /// Layers from the topmost to the lowest; never empty.
    pub layers: Box<[Layer]>,
    /// True if the material transmits light at no point of a surface.
    pub opaque: bool,
    /// True if every layer has one colour everywhere, so that no point needs to be evaluated.
    pub solid: bool,
    /// Transmittance of all layers, if the material is `solid`.
    pub pass: Rgb,
    /// True if the material transmits all light unchanged and sends none itself, such as the surface of a container of
    /// media.
    pub is_clear: bool,
    /// The simplest way in which the light of the material can be computed.
    #[serde(skip)]
    pub shading: Shading,
    /// True for one layer, opaque or not, that reflects in proportion to the incoming light, without subsurface light.
    #[serde(skip)]
    pub is_single_layer: bool,
    /// True for a pattern that selects one of several materials at each point, without blending two, if each of them is a
    /// single layer.
    #[serde(skip)]
    pub selects_single_layers: bool,
    /// True if a pattern depends on surface coordinates.
    pub uv: bool,
    /// True if two entries of this material in a blend cannot be merged into one: each reflects and transmits by
    /// itself, or the second uses the normal that the first changed.
    repeats: bool,
}

/// Way in which the light of a material can be computed, from the most general to the simplest one.
///
/// Plain materials have one opaque layer that reflects in proportion to the incoming light, without grain, thin film, subsurface light
/// and `conserve_energy`.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Shading {
    /// Any other material.
    General,
    /// Opaque material in which each layer, also of the materials that patterns select, is plain except that it may transmit light to
    /// the layers below, and has no mirror and no `diffuse` for light from behind: it is lit in packets.
    Layers,
    /// Plain material with `diffuse` for light from behind.
    Plain,
    /// Plain material that [`Shading::Layers`] describes, too, without bumps, and whose pigment [takes a long chain of
    /// operations](PigmentProgram::takes_long_chain): it is lit in packets after its pigment is computed at four points at once.
    PlainLongChain,
    /// Other plain material: it is lit in packets.
    PlainInPackets,
}

impl Shading {
    /// True for plain materials.
    #[inline(always)]
    pub fn is_plain(self) -> bool {
        self >= Self::Plain
    }

    fn new(texture: &Texture, layers: &[Layer]) -> Self {
        let is_opaque = texture.layers.iter().any(is_opaque);
        let has_plain_layers = is_opaque && layers.iter().all(Layer::has_plain_layers);
        match layers {
            [layer] if is_opaque && layer.is_plain_if_opaque() => match layer.finish.diffuse_back == 0.0 {
                true if has_plain_layers && layer.takes_long_chain() => Self::PlainLongChain,
                true => Self::PlainInPackets,
                false => Self::Plain,
            },
            _ if has_plain_layers => Self::Layers,
            _ => Self::General,
        }
    }
}

/// A pattern and the materials that it blends.
#[derive(Clone, Debug, Serialize)]
pub struct Choice {
    /// Pattern that selects the materials.
    pub pattern: PatternProgram,
    /// Space of the pattern, for the transformation of normals.
    pub space: Space,
    /// Materials by the value of the pattern.
    pub parts: Blend<Arc<Material>>,
}

impl Choice {
    /// True if all materials are shown at once (`average`).
    pub fn averages(&self) -> bool {
        self.pattern.is_average()
    }

    /// True if the pattern selects one material at each point, without blending two, and each is a single layer.
    fn selects_single_layers(&self) -> bool {
        let selects_one = match &self.parts {
            Blend::List(_) => true,
            Blend::Map(map) => map.entries.windows(2).all(|pair| {
                let [(low, below), (high, above)] = pair else { return true };
                low == high || Arc::ptr_eq(below, above) && !below.repeats
            }),
        };
        selects_one && !self.averages() && self.parts.iter().all(|part| part.is_single_layer)
    }

    /// Returns the material at a pattern value if it is the only one there, with the share 1.
    pub fn only_material(&self, pattern_value: f64) -> Option<&Arc<Material>> {
        match self.shares(pattern_value)[..] {
            [(only, 1.0)] => Some(only),
            _ => None,
        }
    }

    /// Returns the materials at a pattern value, with their shares; two equal neighbours are merged where that is
    /// possible.
    pub fn shares(&self, pattern_value: f64) -> Shares<'_, Arc<Material>> {
        let shares = self.parts.weighted_values(pattern_value, self.averages());
        match shares[..] {
            [(below, _), (above, _)] if Arc::ptr_eq(below, above) && !below.repeats && !self.averages() => {
                Shares::from_slice(&[(below, 1.0)])
            }
            _ => shares,
        }
    }
}

/// A lowered layer of a texture.
#[derive(Clone, Debug, Serialize)]
pub struct Layer {
    /// Pattern of materials that replaces this layer.
    pub choice: Option<Box<Choice>>,
    /// Perturbation of the normal.
    pub normal: Option<Arc<NormalProgram>>,
    /// Colour of the pigment.
    pub pigment: LayerColor,
    /// `quick_color` for low qualities, if it differs from the pigment.
    pub quick: Option<Box<LayerColor>>,
    /// Reflection of light; layers with the same finish share it.
    #[serde(flatten)]
    pub finish: Arc<LoweredFinish>,
}

/// A lowered finish.
#[derive(Clone, Debug, Serialize)]
pub struct LoweredFinish {
    /// `ambient` times the scene's `ambient_light`: a constant in place of indirect light.
    pub ambient: Rgb,
    /// `emission`: light that the surface sends in any case.
    pub emission: Rgb,
    /// Diffuse reflection on the side of the light.
    pub diffuse: f64,
    /// Diffuse transmission: light from the other side.
    pub diffuse_back: f64,
    /// Exponent of the cosine in diffuse reflection (`brilliance`).
    pub brilliance: f64,
    /// Mean distance between two changes of light's direction inside the solid, in world units; `None` for a finish without
    /// subsurface light transport.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub scattering_length: Option<Box<Rgb>>,
    /// Highlight of the Phong model, about the mirror direction.
    pub phong: Lobe,
    /// Highlight of the Blinn model, about the half-way vector.
    pub specular: Lobe,
    /// Share of the pigment's colour in highlights.
    pub metallic: f64,
    /// Amplitude of random grain in diffuse light.
    pub crand: f64,
    /// Thin film on the layer.
    pub irid: Option<Box<Irid>>,
    /// Mirror reflection; `None` for a layer without.
    pub mirror: Option<Box<Reflection>>,
    /// Factor of transmitted light, if this is the topmost layer.
    pub refraction: f64,
    /// True if reflected light is subtracted from transmitted light.
    pub conserve_energy: bool,
}

/// Colour of a layer. Most layers have only one.
#[derive(Clone, Debug, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum LayerColor {
    /// One colour everywhere.
    Solid(Color),
    /// A colour that is computed for each point.
    PigmentProgram(Box<PigmentProgram>),
    /// A colour that is computed for each point, and whose filter transmits light untinted (quirk:
    /// `untinted_upper_layers`).
    Untinted(Box<PigmentProgram>),
}

/// A highlight: strength · cosⁿ.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Lobe {
    /// Strength at the highlight's centre.
    pub strength: f64,
    /// Exponent n of the cosine.
    pub exponent: f64,
}

/// Lowering of finishes and normals that several textures share.
pub trait SharedParts {
    /// Lowers a finish.
    fn lower_finish(&mut self, finish: &Arc<Finish>) -> Arc<LoweredFinish>;
    /// Lowers a normal.
    fn lower_normal(&mut self, normal: &Arc<Normal>) -> Arc<NormalProgram>;
}

/// Returns the pattern of materials that replaces the layers; `None` for layers of their own.
fn chosen_by(layers: &[Layer]) -> Option<&Choice> {
    layers.iter().find_map(|layer| layer.choice.as_deref())
}

impl Material {
    /// Returns the pattern of materials that replaces the material's layers; `None` for layers of their own.
    pub fn choice(&self) -> Option<&Choice> {
        chosen_by(&self.layers)
    }

    /// Lowers a texture; shared finishes and normals are lowered once.
    pub fn new(texture: &Texture, shared: &mut dyn SharedParts) -> Self {
        let layers: Box<[Layer]> = texture.layers.iter().rev().map(|l| Layer::new(l, shared)).collect();
        Self {
            // One opaque layer is enough.
            opaque: texture.layers.iter().any(is_opaque_for_shadows),
            solid: layers
                .iter()
                .all(|l| matches!(l.pigment, LayerColor::Solid(_)) && l.normal.is_none() && l.choice.is_none()),
            pass: layers.iter().rev().filter_map(Layer::solid_transmittance).product(),
            is_clear: layers.iter().all(Layer::is_clear),
            shading: Shading::new(texture, &layers),
            is_single_layer: matches!(&layers[..], [layer] if layer.is_single_layer()),
            selects_single_layers: chosen_by(&layers).is_some_and(Choice::selects_single_layers),
            uv: texture.any_pattern(&Pattern::depends_on_uv),
            repeats: texture.any_layer(&reflects_or_has_grain)
                || !texture.layers.iter().any(is_opaque)
                || (texture.any_layer(&|layer| layer.normal.is_some())
                    && texture.any_pattern(&Pattern::may_depend_on_normal)),
            layers,
        }
    }
}

/// True if a layer counts as opaque for shadows (quirk: `opaque_pigment_map`).
fn is_opaque_for_shadows(layer: &texture::Layer) -> bool {
    match &layer.choice {
        Some(choice) if choice.is_material_map() => {
            choice.parts.iter().all(|part| part.layers.iter().any(is_opaque_for_shadows))
        }
        Some(_) => is_opaque(layer),
        None => layer.pigment.is_opaque_for_shadows(),
    }
}

fn is_opaque(layer: &texture::Layer) -> bool {
    match &layer.choice {
        Some(choice) => choice.parts.iter().all(|part| part.layers.iter().any(is_opaque)),
        None => layer.pigment.is_opaque(),
    }
}

/// True if the layer reflects or has random grain. Two evaluations at one point then differ, and two equal entries of a
/// blend are not merged into one.
fn reflects_or_has_grain(layer: &texture::Layer) -> bool {
    !layer.finish.reflection.is_without_reflection() || layer.finish.crand != 0.0
}

fn lower_choice(choice: &texture::Choice, shared: &mut dyn SharedParts) -> Choice {
    let parts = choice.parts.map_runs(Texture::is_certainly_equal, |texture| Arc::new(Material::new(texture, shared)));
    let (pattern, space) = (PatternProgram::new(&choice.pattern), choice.pattern.space.clone());
    Choice { pattern, space, parts }
}

impl Layer {
    fn new(layer: &texture::Layer, shared: &mut dyn SharedParts) -> Self {
        let texture::Layer { pigment, normal, finish, choice } = layer;
        Self {
            choice: choice.as_ref().map(|choice| Box::new(lower_choice(choice, shared))),
            normal: normal.as_ref().filter(|normal| !normal.is_flat()).map(|normal| shared.lower_normal(normal)),
            pigment: LayerColor::new(pigment),
            quick: pigment.low_quality_replacement().map(|quick| Box::new(LayerColor::new(&quick))),
            finish: shared.lower_finish(finish),
        }
    }

    /// Returns the transmittance of a layer with one colour everywhere; `None` for a patterned pigment.
    fn solid_transmittance(&self) -> Option<Rgb> {
        let LayerColor::Solid(color) = self.pigment else { return None };
        Some(color.transmittance())
    }

    /// True if the layer transmits all light unchanged and sends none itself. Highlights and grain do not depend on the
    /// opacity.
    fn is_clear(&self) -> bool {
        let LayerColor::Solid(color) = self.pigment else { return false };
        let finish = &self.finish;
        color.rgb.is_finite()
            && color.transmittance() == Rgb::ONE
            && [false, true].iter().all(|by_color| color.opacity(*by_color) == 0.0)
            && self.normal.is_none()
            && self.choice.is_none()
            && finish.mirror.is_none()
            && !finish.has_highlights()
            && finish.crand == 0.0
            && finish.refraction == 1.0
    }

    /// True if a material of this layer alone is plain (see [`Shading`]) if it is also opaque.
    fn is_plain_if_opaque(&self) -> bool {
        let finish = &self.finish;
        self.is_single_layer() && finish.crand == 0.0 && finish.irid.is_none() && !finish.conserve_energy
    }

    /// True if the layers of all materials that the layer's pattern selects, or else the layer itself, are plain without mirrors; see
    /// [`Shading::Layers`].
    fn has_plain_layers(&self) -> bool {
        match &self.choice {
            Some(choice) => choice.parts.iter().all(|part| part.layers.iter().all(Self::has_plain_layers)),
            None => self.is_plain_if_opaque() && self.finish.mirror.is_none() && self.finish.diffuse_back == 0.0,
        }
    }

    fn takes_long_chain(&self) -> bool {
        self.normal.is_none()
            && matches!(&self.pigment, LayerColor::PigmentProgram(pigment) if pigment.takes_long_chain())
    }

    /// True if a material of this layer alone is a single layer (see [`Material::is_single_layer`]).
    fn is_single_layer(&self) -> bool {
        self.choice.is_none()
            && self.finish.scattering_length.is_none()
            && self.finish.mirror.as_ref().is_none_or(|mirror| mirror.exponent == 1.0)
    }

    /// Returns the colour of a layer that has one colour everywhere; `use_quick_color` selects `quick_color`.
    pub fn color_everywhere(&self, use_quick_color: bool) -> Option<Color> {
        match self.shown(use_quick_color) {
            LayerColor::Solid(color) => Some(*color),
            LayerColor::PigmentProgram(_) | LayerColor::Untinted(_) => None,
        }
    }

    /// Returns the colour at a point of the texture's space; `use_quick_color` selects `quick_color`.
    pub fn color(&self, ctx: &TextureContext, use_quick_color: bool) -> Color {
        self.shown(use_quick_color).color_at(ctx)
    }

    /// True if the pigment has no colour at a point, for example beside an image map with `once`.
    pub fn is_outside_once_pictures(&self, ctx: &TextureContext, use_quick_color: bool) -> bool {
        match self.shown(use_quick_color) {
            LayerColor::Solid(_) => false,
            LayerColor::PigmentProgram(pigment) | LayerColor::Untinted(pigment) => {
                pigment.is_outside_once_pictures(ctx)
            }
        }
    }

    fn shown(&self, use_quick_color: bool) -> &LayerColor {
        self.quick.as_deref().filter(|_| use_quick_color).unwrap_or(&self.pigment)
    }
}

impl LoweredFinish {
    /// True if the surface has highlights.
    pub fn has_highlights(&self) -> bool {
        self.phong.strength != 0.0 || self.specular.strength != 0.0
    }

    /// Lowers a finish; `ambient_light` is the scene's factor of `ambient`, and `mm_per_unit` the length of one unit of a
    /// scene with subsurface light transport.
    pub fn new(f: &Finish, ambient_light: Rgb, mm_per_unit: Option<f64>) -> Self {
        // Negative strengths count as 0 (quirk: `negative_highlights`).
        let plain = f.with_albedo_folded_in();
        let [diffuse, diffuse_back, phong, specular] =
            [plain.diffuse, plain.diffuse_back, plain.phong, plain.specular].map(|amount| amount.max(0.0));
        Self {
            ambient: f.ambient * ambient_light,
            emission: f.emission,
            diffuse,
            diffuse_back,
            brilliance: f.brilliance,
            scattering_length: f.uncommon.subsurface.zip(mm_per_unit).map(|(s, mm)| Box::new(s.translucency / mm)),
            phong: Lobe { strength: phong, exponent: f.phong_size },
            // A roughness of 0 is the dullest, as in POV-Ray.
            specular: Lobe { strength: specular, exponent: if f.roughness == 0.0 { 0.0 } else { 1.0 / f.roughness } },
            metallic: f.metallic.max(0.0),
            crand: f.crand,
            irid: f.irid.clone().filter(|irid| irid.amount > 0.0),
            mirror: (!f.reflection.is_without_reflection()).then(|| Box::new((*f.reflection).clone())),
            refraction: f.uncommon.refraction,
            conserve_energy: f.conserve_energy,
        }
    }
}

impl LayerColor {
    /// Lowers a pigment.
    pub(super) fn new(pigment: &Pigment) -> Self {
        match (pigment.as_solid(), pigment.pattern.untinted) {
            (Some(color), false) => Self::Solid(color),
            (Some(color), true) => Self::Solid(color.with_filter_as_transmit()),
            (None, false) => Self::PigmentProgram(Box::new(PigmentProgram::new(pigment))),
            (None, true) => Self::Untinted(Box::new(PigmentProgram::new(pigment))),
        }
    }

    /// Returns [`Self::color_at`] at four points.
    pub fn colors_at(&self, ctx: &[TextureContext; 4]) -> [Color; 4] {
        match self {
            Self::PigmentProgram(pigment) => pigment.colors_at(ctx),
            _ => ctx.each_ref().map(|ctx| self.color_at(ctx)),
        }
    }

    /// Returns the colour at a point of the texture's space.
    pub(super) fn color_at(&self, ctx: &TextureContext) -> Color {
        match self {
            Self::Solid(color) => *color,
            Self::PigmentProgram(pigment) => pigment.color_at(ctx),
            Self::Untinted(pigment) => pigment.color_at(ctx).with_filter_as_transmit(),
        }
    }
}
