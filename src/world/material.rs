//! Textures as a ray needs them: layers with all constants worked out.

use crate::color::{Color, Rgb};
use crate::math::DVec3;
use crate::texture::{Finish, Paint, Pigment, Reflection, Texture};
use serde::Serialize;

/// A lowered texture.
#[derive(Clone, Debug, Serialize)]
pub struct Material {
    /// From the topmost to the lowest; never empty.
    pub layers: Box<[Layer]>,
    /// Does no light pass anywhere?
    pub opaque: bool,
    /// Is the colour of every layer the same everywhere? Then it needs no point.
    pub solid: bool,
}

/// A lowered layer.
#[derive(Clone, Debug, Serialize)]
pub struct Layer {
    /// Its colour.
    pub ink: Ink,
    /// Its colour where quality is low (`quick_color`).
    pub quick: Option<Color>,
    /// Light without a lamp: `ambient` times the scene's `ambient_light`, and `emission`.
    pub glow: Rgb,
    /// Scattered on the side of the lamp.
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
    /// What it mirrors, if anything.
    pub mirror: Option<Box<Reflection>>,
    /// Takes from the light that passes what the mirror gives.
    pub conserve_energy: bool,
}

/// What gives a layer its colour. Most layers have but one.
#[derive(Clone, Debug, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Ink {
    /// The same everywhere.
    Solid(Color),
    /// Another one at each point.
    Pattern(Box<Pigment>),
}

/// strength · cosⁿ
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Lobe {
    /// At its middle.
    pub strength: f64,
    /// n.
    pub exponent: f64,
}

impl Material {
    /// Lowers a texture under the scene's `ambient_light`.
    pub fn new(texture: &Texture, ambient_light: Rgb) -> Self {
        let lower = |l: &crate::texture::Layer| Layer::new(&l.pigment, &l.finish, ambient_light);
        let layers: Box<[Layer]> = texture.layers.iter().rev().map(lower).collect();
        // One layer that lets nothing pass is enough.
        let opaque = texture.layers.iter().any(|l| l.pigment.is_opaque());
        let solid = layers.iter().all(|l| matches!(l.ink, Ink::Solid(_)));
        Self { layers, opaque, solid }
    }
}

impl Layer {
    fn new(pigment: &Pigment, f: &Finish, ambient_light: Rgb) -> Self {
        let albedo = |on: bool, factor: f64| if on { factor } else { 1.0 };
        // `albedo` scales each lobe by one over its integral over the half sphere (measured on POV-Ray 3.7).
        let diffuse = albedo(f.diffuse_albedo, (f.brilliance + 1.0) / 2.0);
        let phong = albedo(f.phong_albedo, (f.phong_size + 1.0) / 2.0);
        let n = 1.0 / f.roughness;
        let specular = albedo(f.specular_albedo, (n + 2.0) / (4.0 * (2.0 - (-n / 2.0).exp2())));
        Self {
            ink: match pigment.paint {
                Paint::Solid(color) => Ink::Solid(color),
                _ => Ink::Pattern(Box::new(pigment.clone())),
            },
            quick: pigment.quick_color,
            glow: f.ambient * ambient_light + f.emission,
            diffuse: f.diffuse * diffuse,
            diffuse_back: f.diffuse_back * diffuse,
            brilliance: f.brilliance,
            phong: Lobe { strength: f.phong * phong, exponent: f.phong_size },
            specular: Lobe { strength: f.specular * specular, exponent: n },
            metallic: f.metallic,
            crand: f.crand,
            mirror: (!f.reflection.is_none()).then(|| Box::new(f.reflection.clone())),
            conserve_energy: f.conserve_energy,
        }
    }

    /// Its colour at a point of the texture's space; `quick` as the lower qualities show it: nothing is see-through.
    pub fn color(&self, p: DVec3, quick: bool) -> Color {
        let real = || match &self.ink {
            Ink::Solid(color) => *color,
            Ink::Pattern(pigment) => pigment.at(p),
        };
        if quick { Color::opaque(self.quick.unwrap_or_else(real).rgb) } else { real() }
    }
}
