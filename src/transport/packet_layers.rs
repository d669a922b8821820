//! Light of opaque surfaces with several layers, or with patterns that blend materials, at the hits of a packet's rays. The surfaces
//! are evaluated one by one; the light that sources send to them is computed side by side, layer by layer.

use super::direct_light::{LitSurface, emitted_light};
use super::interface::Interface;
use super::packet_light::{ArrivingLight, LitPoints};
use super::shading_point::ShadingPoint;
use super::tracer::Tracer;
use crate::color::Rgb;
use crate::math::packet::{Flags, Numbers, RayPacket, Vectors, set_lanes};
use crate::math::registers::wide_versions;
use crate::math::{Lanes, Ray};
use crate::world::{Intersection, LightSource, Surface};

/// One layer at each of several points.
pub(super) struct LitLayer<'w> {
    layer: LitPoints<'w>,
    /// Transmittances of the layers above.
    weight: Vectors,
    /// Lanes in which this layer is the last of its material, as bits.
    last: u32,
    /// Share of the material in a blend, for the lanes `last`.
    share: Numbers,
}

/// Points of surfaces with several layers, side by side, and the light that they send along the rays.
pub(super) struct LitLayers<'w> {
    /// Lanes with a point, as bits.
    existing: u32,
    point: Vectors,
    /// Layers from the topmost on; of a blend, those of one material after another. Those from index `n_layers` on are not used.
    layers: Vec<LitLayer<'w>>,
    n_layers: usize,
    /// Light of each point.
    light: Vectors,
}

impl<'w> LitLayer<'w> {
    #[inline(always)]
    fn new() -> Self {
        Self { layer: LitPoints::new(), weight: Vectors::ZERO, last: 0, share: Lanes::splat(0.0) }
    }
}

impl<'w> LitLayers<'w> {
    /// Creates an empty list, whose layers are stored in the buffer `layers`.
    #[inline(always)]
    pub fn new(layers: Vec<LitLayer<'w>>) -> Self {
        Self { existing: 0, point: Vectors::ZERO, layers, n_layers: 0, light: Vectors::ZERO }
    }

    /// Returns the buffer of the layers.
    pub fn into_buffer(self) -> Vec<LitLayer<'w>> {
        self.layers
    }

    /// Returns the layer with this number, and adds it if it is the next one.
    #[inline(always)]
    fn layer(&mut self, number: usize) -> &mut LitLayer<'w> {
        if number == self.layers.len() {
            self.layers.push(LitLayer::new());
        }
        let layer = &mut self.layers[number];
        if number == self.n_layers {
            self.n_layers += 1;
            layer.layer.clear();
            layer.last = 0;
        }
        layer
    }

    /// Returns the rays with points, and the light of each.
    pub fn light(&self) -> impl Iterator<Item = (usize, Rgb)> {
        set_lanes(self.existing).map(|i| (i, self.light.lane(i)))
    }

    /// Adds the point of ray `i`, with the light that it emits. Returns false, without any effect, if light passes through the
    /// surface there, or its bumps are not finite.
    fn add_and_is_opaque(&mut self, i: usize, at: &ShadingPoint<'w>, has_ambient: bool) -> bool {
        if !at.ends_rays() || at.layers().any(|shaded| shaded.weight.is_nan()) {
            return false;
        }
        let mut number = 0;
        for material in &at.materials {
            for shaded in at.layers_of(material) {
                let LitLayer { layer, weight, .. } = self.layer(number);
                layer.set_layer(i, shaded);
                weight.set_lane(i, shaded.weight);
                number += 1;
            }
            let LitLayer { last, share, .. } = self.layer(number - 1);
            (*last, share.0[i]) = (*last | 1 << i, material.share);
        }
        self.point.set_lane(i, at.point);
        self.light.set_lane(i, at.weighted_layer_sum(|shaded| shaded.weight * emitted_light(shaded, has_ambient)));
        self.existing |= 1 << i;
        true
    }
}

impl<'w> Tracer<'w> {
    /// Evaluates the surface at the hit of ray `i` of a packet, whose material [has plain layers](crate::world::Material::has_plain_layers),
    /// and adds it to the list. Returns false, without any effect, if light passes through the surface there, or its bumps are not finite.
    #[inline(never)]
    pub(super) fn add_layers_and_is_opaque(
        &self,
        lit: &mut LitLayers<'w>,
        (i, ray): (usize, &Ray),
        hit: (&Intersection, &Surface),
    ) -> bool {
        let at = ShadingPoint::new(self.context.world, ray, hit, &self.context.quality, &Interface::NONE);
        lit.add_and_is_opaque(i, &at, self.context.has_ambient)
    }

    /// Adds the light of sources that the points reflect along the rays, which come from the rays `camera`. The sources are points:
    /// see [`Tracer::lights_packets`](super::tracer::Tracer).
    #[inline(never)]
    pub(super) fn add_light_of_sources_to_layers(&mut self, lit: &mut LitLayers, rays: &RayPacket, camera: &RayPacket) {
        let world = self.context.world;
        for &number in &world.lit_by[0] {
            self.add_light_reflected_by_layers(&world.lights[number as usize], lit, rays, camera);
        }
    }

    /// Adds the light of a point light that the points reflect along the rays.
    fn add_light_reflected_by_layers(
        &mut self,
        light: &LightSource,
        lit: &mut LitLayers,
        rays: &RayPacket,
        camera: &RayPacket,
    ) {
        let arriving = ArrivingLight::of_point_light(light, lit.existing, &lit.point);
        let faces = faces_light(lit, &arriving);
        if !faces.any() {
            return;
        }
        let (visible, share) = self.visibility_of_packet(light, (&lit.point, camera), &arriving, faces);
        if visible.any() {
            add_reflected(lit, &rays.dir, &arriving, &share, (visible, !light.emitter.shadowless));
        }
    }
}

wide_versions! {
    /// True for the points that have a layer which reflects light that arrives.
    fn faces_light(lit: &LitLayers, arriving: &ArrivingLight) -> Flags {
        let mut faces = Flags::from_bits(0);
        for LitLayer { layer, .. } in &lit.layers[..lit.n_layers] {
            faces = faces | layer.faces(arriving);
        }
        faces & arriving.is_light()
    }
}

wide_versions! {
    /// Adds the light that the points `visible` reflect; `share` is the share of the light that is visible from them.
    fn add_reflected(
        lit: &mut LitLayers,
        dir: &Vectors,
        arriving: &ArrivingLight,
        share: &Vectors,
        which: (Flags, bool),
    ) {
        let (visible, has_highlights) = which;
        let no_light = Vectors::ZERO;
        let (mut sum, mut sum_of_material) = (no_light, no_light);
        for LitLayer { layer, weight, last, share } in &lit.layers[..lit.n_layers] {
            let is_lit = visible & layer.faces(arriving);
            let reflected = layer.reflected_share(dir, arriving, (is_lit, has_highlights));
            sum_of_material = sum_of_material + Vectors::select(is_lit, weight.times(reflected), no_light);
            let last = Flags::from_bits(*last);
            sum = sum + Vectors::select(last, sum_of_material * *share, no_light);
            sum_of_material = Vectors::select(last, no_light, sum_of_material);
        }
        let light = arriving.light.times(*share);
        // (Light that is black is not reflected.)
        let is_lit = visible & !light.is_zero();
        lit.light = lit.light + Vectors::select(is_lit, sum.times(light), no_light);
    }
}
