//! Sky sphere and background: light from a direction.

use super::LayerColor;
use crate::atmosphere::{Background, Segment, SkySphere, ViewKind};
use crate::color::{Color, Rgb};
use crate::math::noise::NoiseGenerator;
use crate::math::{DVec3, Transform};
use crate::pattern::TextureContext;
use crate::scene::Scene;
use serde::Serialize;

/// Sky sphere and background of the scene.
#[derive(Clone, Debug, Serialize)]
pub struct Sky {
    /// Colour of the background, behind the sky sphere.
    background: Background,
    /// Layers of the sky sphere, from the lowest to the topmost.
    layers: Vec<SkyLayer>,
    /// Factor of the light of all layers of the sky sphere.
    emission: Rgb,
    /// Transform from the space of the pigments to world space.
    place: Transform,
    /// True for scenes before version 3.7, in which layers are mixed by shares, and pictures with alpha show no sky
    /// (quirk: `sky_by_share`).
    by_share: bool,
}

#[derive(Clone, Debug, Serialize)]
struct SkyLayer {
    color: LayerColor,
    /// Colour at low quality levels (`quick_color`), if it differs.
    #[serde(skip_serializing_if = "Option::is_none")]
    quick: Option<LayerColor>,
}

impl Sky {
    /// Lowers the sky sphere and background of a scene.
    pub(super) fn new(scene: &Scene) -> Self {
        let background = scene.background.unwrap_or(Background::NONE);
        let none = SkySphere::default();
        let SkySphere { pigments, emission, transform } = scene.sky_sphere.as_ref().unwrap_or(&none);
        let layers = pigments.iter().map(|pigment| SkyLayer {
            color: LayerColor::new(pigment),
            quick: pigment.low_quality_replacement().map(|quick| LayerColor::new(&quick)),
        });
        let by_share = scene.settings.sky_by_share;
        Self { background, layers: layers.collect(), emission: *emission, place: *transform, by_share }
    }

    /// True if pictures with alpha show the sky in reflections only.
    pub fn is_transparent_in_alpha_pictures(&self) -> bool {
        self.by_share
    }

    /// Returns the light from a direction of length 1, and the transmittance for what is behind the picture.
    pub fn light_from(
        &self,
        dir: DVec3,
        view: ViewKind,
        use_quick_color: bool,
        noise: NoiseGenerator,
        waves: usize,
    ) -> Segment {
        let behind = self.background.segment_for_view(view);
        if self.layers.is_empty() {
            return behind;
        }
        let p = self.place.inverse_transform_point(dir);
        let ctx = TextureContext { waves, world: dir, ray: dir, ..TextureContext::without_surface(p, noise) };
        let colors = self
            .layers
            .iter()
            .rev()
            .map(|layer| layer.quick.as_ref().filter(|_| use_quick_color).unwrap_or(&layer.color).color_at(&ctx));
        if self.by_share { self.mix_by_share(colors, behind) } else { self.composite_layers(colors, behind) }
    }

    /// Composites the colours of the layers of the sky sphere, from the topmost on, over the light `behind`.
    fn composite_layers(&self, colors_from_top: impl Iterator<Item = Color>, behind: Segment) -> Segment {
        let veil = |color: Color| Segment {
            radiance: self.emission * color.rgb * (1.0 - color.filter - color.transmit),
            transmittance: color.transmittance(),
        };
        colors_from_top.fold(Segment::NONE, |above, color| above.in_front_of(veil(color))).in_front_of(behind)
    }

    /// Mixes the colours of the layers of the sky sphere, from the topmost on, by their shares, as before version 3.7.
    /// Light that passes all layers is tinted by the product of their colours (quirk: `sky_by_share`).
    fn mix_by_share(&self, colors_from_top: impl Iterator<Item = Color>, behind: Segment) -> Segment {
        let (mut light, mut share) = (Rgb::ZERO, 1.0);
        let (mut transmit, mut filter, mut tint) = (1.0, 1.0, Rgb::ONE);
        for color in colors_from_top {
            light += color.rgb * (share * (1.0 - color.filter - color.transmit));
            share *= color.filter + color.transmit;
            (transmit, filter, tint) = (transmit * color.transmit, filter * color.filter, tint * color.rgb);
        }
        Segment { radiance: self.emission * light, transmittance: Rgb::splat(transmit) + filter * tint }
            .in_front_of(behind)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::texture::Pigment;

    fn seen(by_share: bool) -> Rgb {
        let color = |rgb, filter| Color { rgb: Rgb::from_array(rgb), filter, transmit: 0.2 };
        let pigments = vec![Pigment::solid(color([0.3, 0.6, 0.9], 0.3)), Pigment::solid(color([0.5, 1.0, 0.2], 0.5))];
        let mut scene = Scene {
            background: Some(Background { color: Color::opaque(Rgb::new(1.0, 0.8, 0.6)), by_picture: false }),
            sky_sphere: Some(SkySphere { pigments, ..SkySphere::default() }),
            ..Scene::default()
        };
        scene.settings.sky_by_share = by_share;
        Sky::new(&scene).light_from(DVec3::Y, ViewKind::Opaque, false, NoiseGenerator::default(), 10).radiance
    }

    #[test]
    fn layers_by_version() {
        assert!(seen(false).distance(Rgb::new(0.348, 0.7228, 0.2796)) < 2e-5, "{}", seen(false));
        assert!(seen(true).distance(Rgb::new(0.3175, 0.614, 0.4152)) < 2e-5, "{}", seen(true));
    }
}
