//! Light of opaque surfaces with several layers, or with patterns that blend materials, at the hits of a packet's rays. The surfaces
//! are evaluated one by one; the light that sources send to them is computed side by side, layer by layer.

use super::super::direct_light::{LitSurface, emitted_light};
use super::super::interface::Interface;
use super::super::radiance::Radiance;
use super::super::shading_point::{ShadedLayer, ShadingPoint, texture_context};
use super::super::single_layer::facing_normal;
use super::super::tracer::Tracer;
use super::light::{ArrivingLight, LitInPacket, PacketLayer};
use super::{Packet, lanes_of_hits};
use crate::color::Rgb;
use crate::math::packet::{Flags, Numbers, PACKET, Vectors, set_lanes};
use crate::math::registers::wide_versions;
use crate::math::{DVec3, Lanes, Ray};
use crate::world::{ClosestHits, Intersection, PacketSurfaces, Shading, Surface, surfaces_of_packet};
use smallvec::SmallVec;

/// One layer at each of several points.
pub struct LitLayer<'w> {
    layer: PacketLayer<'w>,
    /// Transmittances of the layers above.
    weight: Vectors,
    /// Lanes in which this layer is the last of its material, as bits.
    last: u32,
    /// Share of the material in a blend, for the lanes `last`.
    share: Numbers,
}

/// Points of surfaces with several layers, side by side, and the light that they send along the rays.
struct LitLayers<'w> {
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
        Self { layer: PacketLayer::new(), weight: Vectors::ZERO, last: 0, share: Lanes::splat(0.0) }
    }
}

impl<'w> LitLayers<'w> {
    /// Creates an empty list, whose layers are stored in the buffer `layers`.
    #[inline(always)]
    fn new(layers: Vec<LitLayer<'w>>) -> Self {
        Self { existing: 0, point: Vectors::ZERO, layers, n_layers: 0, light: Vectors::ZERO }
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

    /// Adds the point of ray `i`, with the light that it emits, unless light passes through the surface there, or its bumps are not
    /// finite.
    fn add_if_opaque(&mut self, i: usize, at: &ShadingPoint<'w>, has_ambient: bool) {
        if !at.ends_rays() || at.layers().any(|shaded| shaded.weight.is_nan()) {
            return;
        }
        let mut number = 0;
        for material in &at.materials {
            for shaded in at.layers_of(material) {
                let LitLayer { layer, weight, .. } = self.layer(number);
                layer.set(i, shaded);
                weight.set_lane(i, shaded.weight);
                number += 1;
            }
            self.end_material(i, number, material.share);
        }
        let emitted = at.weighted_layer_sum(|shaded| shaded.weight * emitted_light(shaded, has_ambient));
        self.set_point(i, at.point, emitted);
    }

    /// Adds the point of ray `i` on a surface with one layer, with the light that it emits.
    fn add_single_layer(&mut self, i: usize, point: DVec3, shaded: &ShadedLayer<'w>, has_ambient: bool) {
        let LitLayer { layer, weight, .. } = self.layer(0);
        layer.set(i, shaded);
        weight.set_lane(i, shaded.weight);
        self.end_material(i, 1, 1.0);
        self.set_point(i, point, shaded.weight * emitted_light(shaded, has_ambient));
    }

    /// Notes that a material of ray `i` ends with the layer before index `n_layers`.
    fn end_material(&mut self, i: usize, n_layers: usize, share_of_material: f64) {
        let LitLayer { last, share, .. } = self.layer(n_layers - 1);
        (*last, share.0[i]) = (*last | 1 << i, share_of_material);
    }

    fn set_point(&mut self, i: usize, point: DVec3, emitted: Rgb) {
        self.point.set_lane(i, point);
        self.light.set_lane(i, emitted);
        self.existing |= 1 << i;
    }
}

impl<'w> Tracer<'w> {
    /// Adds the light at hits of a packet's rays, whose materials are [`Shading::Layers`] or [`Shading::PlainLongChain`], to the
    /// radiances of the rays' samples. Returns the rays for which it did: not those that pass through their surfaces, or meet
    /// bumps that are not finite. `lanes` are the rays, as bits.
    pub(super) fn shade_layered_hits(
        &mut self,
        packet: &mut Packet,
        hits: &ClosestHits<'w>,
        lanes: u32,
        radiances: &mut [Radiance; PACKET],
    ) -> u32 {
        let mut lit = LitLayers::new(std::mem::take(&mut self.layer_buffer));
        let surfaces = surfaces_of_packet(&packet.rays, hits, lanes);
        let shading = |hit: &Intersection| self.context.world.material_outside(hit).shading;
        let chains = lanes & lanes_of_hits(hits, |hit| shading(hit) == Shading::PlainLongChain);
        self.add_long_chains(&mut lit, packet, (hits, &surfaces), chains);
        for i in set_lanes(lanes & !chains) {
            if let Some(hit) = &hits[i] {
                self.add_layers_if_opaque(&mut lit, (i, &packet.rays.ray(i)), (hit, &surfaces.lane(i)));
            }
        }
        let shaded = lit.existing;
        if self.has_air() {
            for (i, hit) in set_lanes(shaded).filter_map(|i| Some((i, hits[i].as_ref()?))) {
                self.cross_air(packet, i, hit, &mut radiances[i]);
            }
        }
        self.add_light_of_sources_to_points(&mut lit, packet);
        for i in set_lanes(shaded) {
            radiances[i].rgb += packet.throughput.lane(i) * lit.light.lane(i);
        }
        self.layer_buffer = lit.layers;
        shaded
    }

    /// Evaluates the surface at the hit of ray `i` of a packet, and adds it to the list, unless light passes through the surface
    /// there, or its bumps are not finite.
    #[inline(never)]
    fn add_layers_if_opaque(&self, lit: &mut LitLayers<'w>, (i, ray): (usize, &Ray), hit: (&Intersection, &Surface)) {
        let at = ShadingPoint::new(self.context.world, ray, hit, &self.context.quality, &Interface::NONE);
        lit.add_if_opaque(i, &at, self.context.has_ambient);
    }

    /// Evaluates the surfaces at the hits of the rays `lanes` of a packet, whose materials are [`Shading::PlainLongChain`], four by
    /// four, and adds them to the list.
    fn add_long_chains(
        &self,
        lit: &mut LitLayers<'w>,
        packet: &Packet,
        (hits, surfaces): (&ClosestHits<'w>, &PacketSurfaces),
        lanes: u32,
    ) {
        let world = self.context.world;
        let mut left = lanes;
        while let Some(first) = set_lanes(left).next()
            && let Some(first_hit) = &hits[first]
        {
            let material = world.material_outside(first_hit);
            let is_same = |hit: &Intersection| std::ptr::eq(world.material_outside(hit), material);
            let same = set_lanes(left).filter_map(|i| Some((i, hits[i].as_ref().filter(|hit| is_same(hit))?)));
            let same: SmallVec<[_; 4]> = same.take(4).collect();
            // Places that are left repeat the last hit.
            let four = [0, 1, 2, 3].map(|n| same[n.min(same.len() - 1)]);
            let contexts = four.map(|(i, hit)| {
                let (ray, surface) = (packet.rays.ray(i), surfaces.lane(i));
                let placed = &world.parts[hit.part_number() as usize].outside;
                texture_context(world, placed, hit, &surface, facing_normal(&surface, &ray), &ray).1
            });
            let layer = &material.layers[0];
            let colors = layer.pigment.colors_at(&contexts);
            for ((&(i, _), context), color) in same.iter().zip(&contexts).zip(colors) {
                left &= !(1 << i);
                let shaded = ShadedLayer::on_top(layer, color, context, world.opacity_by_color);
                lit.add_single_layer(i, context.world, &shaded, self.context.has_ambient);
            }
        }
    }
}

impl LitInPacket for LitLayers<'_> {
    fn points(&self) -> (u32, &Vectors) {
        (self.existing, &self.point)
    }

    fn faces_light(&self, arriving: &ArrivingLight) -> Flags {
        faces_light(self, arriving)
    }

    fn add_reflected(&mut self, dir: &Vectors, arriving: &ArrivingLight, share: &Vectors, which: (Flags, bool)) {
        add_reflected(self, dir, arriving, share, which);
    }
}

wide_versions! {
    /// True for the points that have a layer which reflects light that arrives.
    fn faces_light(lit: &LitLayers, arriving: &ArrivingLight) -> Flags {
        let mut faces = Flags::NONE;
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
