//! Textures as a ray needs them: layers with all constants worked out.

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
    /// From the topmost to the lowest; never empty.
    pub layers: Box<[Layer]>,
    /// Does no light pass anywhere?
    pub opaque: bool,
    /// Is every layer the same everywhere? Then it needs no point.
    pub solid: bool,
    /// What passes it, where it is the same everywhere.
    pub pass: Rgb,
    /// Does it ask where the point lies on its shape?
    pub uv: bool,
    /// Is it seen as often as it is looked at? Then two shares of it are not one: light goes on from each, or the second sees the bumps of
    /// the first.
    repeats: bool,
}

/// A pattern and the materials among which it chooses.
#[derive(Clone, Debug, Serialize)]
pub struct Choice {
    /// What tells points apart.
    pub pattern: PatternProgram,
    /// Where it lies: normals go another way than points.
    pub space: Space,
    /// The materials.
    pub parts: Blend<Arc<Material>>,
}

impl Choice {
    /// Does it show all of them at once?
    pub fn averages(&self) -> bool {
        self.pattern.averages()
    }

    /// What is seen at a number; between two entries that are the same it is one.
    pub fn shares(&self, number: f64) -> Shares<'_, Arc<Material>> {
        let shares = self.parts.shares(number, self.averages());
        match shares[..] {
            [(below, _), (above, _)] if Arc::ptr_eq(below, above) && !below.repeats && !self.averages() => {
                Shares::from_slice(&[(below, 1.0)])
            }
            _ => shares,
        }
    }
}

/// A lowered layer.
#[derive(Clone, Debug, Serialize)]
pub struct Layer {
    /// Other materials in its place.
    pub choice: Option<Box<Choice>>,
    /// Its bumps.
    pub normal: Option<Arc<NormalProgram>>,
    /// Its colour.
    pub pigment: LayerColor,
    /// Its colour where quality is low (`quick_color`), if that is another.
    pub quick: Option<Box<LayerColor>>,
    /// Its answer to light; layers of one finish share it.
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
    /// Scattered on the side of the light.
    pub diffuse: f64,
    /// Scattered on the other side.
    pub diffuse_back: f64,
    /// Exponent of the cosine.
    pub brilliance: f64,
    /// The highlight about the mirrored ray.
    pub phong: Lobe,
    /// The highlight about the half-way vector.
    pub specular: Lobe,
    /// How much highlights take the pigment's colour.
    pub metallic: f64,
    /// Grain of the diffuse light.
    pub crand: f64,
    /// A thin film on top.
    pub irid: Option<Box<Irid>>,
    /// What it mirrors, if anything.
    pub mirror: Option<Box<Reflection>>,
    /// Factor of the light that passes, if it is the topmost layer.
    pub refraction: f64,
    /// Takes from the light that passes what the mirror gives.
    pub conserve_energy: bool,
}

/// What gives a layer its colour. Most layers have but one.
#[derive(Clone, Debug, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum LayerColor {
    /// The same everywhere.
    Solid(Color),
    /// Another one at each point.
    PigmentProgram(Box<PigmentProgram>),
}

/// strength · cosⁿ
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Lobe {
    /// At its middle.
    pub strength: f64,
    /// n.
    pub exponent: f64,
}

/// Lowers what several textures have in common.
pub trait SharedParts {
    /// A finish.
    fn finish(&mut self, finish: &Arc<Finish>) -> Arc<LoweredFinish>;
    /// A normal.
    fn normal(&mut self, normal: &Arc<Normal>) -> Arc<NormalProgram>;
}

impl Material {
    /// Lowers a texture; what it has in common with others is lowered once.
    pub fn new(texture: &Texture, shared: &mut dyn SharedParts) -> Self {
        let layers: Box<[Layer]> = texture.layers.iter().rev().map(|l| Layer::new(l, shared)).collect();
        Self {
            // One layer that lets nothing pass is enough.
            opaque: texture.layers.iter().any(seems_opaque),
            solid: layers
                .iter()
                .all(|l| matches!(l.pigment, LayerColor::Solid(_)) && l.normal.is_none() && l.choice.is_none()),
            pass: texture.layers.iter().filter_map(|l| l.pigment.as_solid()).map(|c| c.passing()).product(),
            uv: texture.any_pattern(&Pattern::asks_uv),
            repeats: texture.any_layer(&sends_light_on)
                || !texture.layers.iter().any(is_opaque)
                || (texture.any_layer(&|layer| layer.normal.is_some())
                    && texture.any_pattern(&Pattern::may_see_normal)),
            layers,
        }
    }
}

/// As POV-Ray 3.7 tells it (measured): of pigments in a `pigment_map` it does not see all that light passes, but it asks each
/// texture of a `texture_map` at the place.
fn seems_opaque(layer: &texture::Layer) -> bool {
    match &layer.choice {
        Some(choice) if choice.is_material_map() => {
            choice.parts.iter().all(|part| part.layers.iter().any(seems_opaque))
        }
        Some(_) => is_opaque(layer),
        None => layer.pigment.seems_opaque(),
    }
}

fn is_opaque(layer: &texture::Layer) -> bool {
    match &layer.choice {
        Some(choice) => choice.parts.iter().all(|part| part.layers.iter().any(is_opaque)),
        None => layer.pigment.is_opaque(),
    }
}

/// Does it mirror, or is it of another brightness each time?
fn sends_light_on(layer: &texture::Layer) -> bool {
    !layer.finish.reflection.is_none() || layer.finish.crand != 0.0
}

fn lower_choice(choice: &texture::Choice, shared: &mut dyn SharedParts) -> Choice {
    let parts = choice.parts.map_runs(Texture::is_plainly, |texture| Arc::new(Material::new(texture, shared)));
    let (pattern, space) = (PatternProgram::new(&choice.pattern), choice.pattern.space.clone());
    Choice { pattern, space, parts }
}

impl Layer {
    fn new(layer: &texture::Layer, shared: &mut dyn SharedParts) -> Self {
        let texture::Layer { pigment, normal, finish, choice } = layer;
        Self {
            choice: choice.as_ref().map(|choice| Box::new(lower_choice(choice, shared))),
            normal: normal.as_ref().filter(|normal| !normal.is_flat()).map(|normal| shared.normal(normal)),
            pigment: LayerColor::new(pigment),
            quick: pigment.quick().map(|quick| Box::new(LayerColor::new(&quick))),
            finish: shared.finish(finish),
        }
    }

    /// Its colour at a point in the texture's space; `quick` as the lower qualities show it.
    pub fn color(&self, ctx: &TextureContext, quick: bool) -> Color {
        match self.shown(quick) {
            LayerColor::Solid(color) => *color,
            LayerColor::PigmentProgram(pigment) => pigment.at(ctx),
        }
    }

    /// Does it show no colour at all there?
    pub fn is_nothing(&self, ctx: &TextureContext, quick: bool) -> bool {
        match self.shown(quick) {
            LayerColor::Solid(_) => false,
            LayerColor::PigmentProgram(pigment) => pigment.is_nothing(ctx),
        }
    }

    fn shown(&self, quick: bool) -> &LayerColor {
        self.quick.as_deref().filter(|_| quick).unwrap_or(&self.pigment)
    }
}

impl LoweredFinish {
    /// Lowers a finish under the scene's `ambient_light`.
    pub fn new(f: &Finish, ambient_light: Rgb) -> Self {
        // What is negative counts as none (measured on POV-Ray 3.7).
        let plain = f.without_albedo();
        let [diffuse, diffuse_back, phong, specular] =
            [plain.diffuse, plain.diffuse_back, plain.phong, plain.specular].map(|amount| amount.max(0.0));
        Self {
            ambient: f.ambient * ambient_light,
            emission: f.emission,
            diffuse,
            diffuse_back,
            brilliance: f.brilliance,
            phong: Lobe { strength: phong, exponent: f.phong_size },
            // (A roughness of 0 is as dull as can be, in POV-Ray 3.7 too.)
            specular: Lobe { strength: specular, exponent: if f.roughness == 0.0 { 0.0 } else { 1.0 / f.roughness } },
            metallic: f.metallic.max(0.0),
            crand: f.crand,
            irid: f.irid.clone().filter(|irid| irid.amount > 0.0),
            mirror: (!f.reflection.is_none()).then(|| Box::new((*f.reflection).clone())),
            refraction: f.uncommon.refraction,
            conserve_energy: f.conserve_energy,
        }
    }
}

impl LayerColor {
    /// Lowers a pigment.
    pub(super) fn new(pigment: &Pigment) -> Self {
        match pigment.as_solid() {
            Some(color) => Self::Solid(color),
            None => Self::PigmentProgram(Box::new(PigmentProgram::new(pigment))),
        }
    }
}
