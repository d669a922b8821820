//! Light that sources send to the plain surfaces of a packet's hits: the terms of [`super::super::direct_light`] side by side, each with
//! the bits that it has alone.

use super::super::direct_light::{emitted_light, lobe_strength, metal_tint};
use super::super::shading_point::ShadedLayer;
use super::super::single_layer::SingleLayerPoint;
use super::super::tracer::Tracer;
use super::Packet;
use super::area_light::PacketShadows;
use crate::color::Rgb;
use crate::light::LightSample;
use crate::math::packet::{Flags, Numbers, PACKET, RayPacket, Vectors, set_lanes};
use crate::math::registers::wide_versions;
use crate::math::{DVec3, Lanes, Mask, fp};
use crate::world::{LightSource, Lobe, LoweredFinish};

/// Point of a plain surface without diffuse transmission.
pub(super) type PlainPoint<'w> = SingleLayerPoint<'w, true>;

/// One layer of a texture at each of several points, side by side: what its light depends on.
pub(super) struct PacketLayer<'w> {
    /// Lanes with a layer, as bits.
    existing: u32,
    /// Lanes with a layer that reflects light, as bits.
    reflecting: u32,
    /// Normals with bumps, length 1.
    normal: Vectors,
    /// Red, green and blue of the pigments.
    color: Vectors,
    opacity: Numbers,
    diffuse: Numbers,
    /// Finish of each layer.
    finish: [Option<&'w LoweredFinish>; PACKET],
    /// The finish of all layers; `None` if they have several.
    only_finish: Option<&'w LoweredFinish>,
}

/// Points of plain surfaces, side by side, and the light that they send along the rays.
pub(super) struct LitPoints<'w> {
    point: Vectors,
    layer: PacketLayer<'w>,
    /// Light of each point.
    light: Vectors,
}

/// Light of one source that reaches the points without occlusion.
pub(super) struct ArrivingLight {
    /// Directions to the light's centre, length 1.
    pub to_light: Vectors,
    pub distance: Numbers,
    /// Red, green and blue.
    pub light: Vectors,
}

impl<'w> PacketLayer<'w> {
    /// Creates an empty layer.
    #[inline(always)]
    pub fn new() -> Self {
        let zero = Vectors::ZERO;
        Self {
            existing: 0,
            reflecting: 0,
            normal: zero,
            color: zero,
            opacity: zero.x,
            diffuse: zero.x,
            finish: [None; PACKET],
            only_finish: None,
        }
    }

    /// Removes the layers of all points. (Their numbers stay, but do not count.)
    pub fn clear(&mut self) {
        (self.existing, self.reflecting, self.only_finish) = (0, 0, None);
    }

    /// Sets the layer at the point of ray `i`.
    #[inline(always)]
    pub fn set(&mut self, i: usize, shaded: &ShadedLayer<'w>) {
        let finish: &'w LoweredFinish = &shaded.layer.finish;
        self.normal.set_lane(i, shaded.normal);
        self.color.set_lane(i, shaded.color.rgb);
        (self.opacity.0[i], self.diffuse.0[i], self.finish[i]) = (shaded.opacity, finish.diffuse, Some(finish));
        let is_only = self.existing == 0 || self.only_finish.is_some_and(|only| std::ptr::eq(only, finish));
        self.only_finish = is_only.then_some(finish);
        self.existing |= 1 << i;
        self.reflecting |= u32::from(finish.diffuse != 0.0 || finish.has_highlights()) << i;
    }

    /// True for the points that reflect light from the directions of the light.
    #[inline(always)]
    pub fn faces(&self, arriving: &ArrivingLight) -> Flags {
        Mask::from_bits(self.reflecting) & Lanes::splat(0.0).less_than(self.normal.dot(arriving.to_light))
    }

    /// Returns the shares of the arriving light that the points `visible` reflect along the rays, diffusely and, if `has_highlights`,
    /// as highlights.
    #[inline(always)]
    pub fn reflected_share(
        &self,
        dir: &Vectors,
        arriving: &ArrivingLight,
        (visible, has_highlights): (Flags, bool),
    ) -> Vectors {
        let cos = self.normal.dot(arriving.to_light);
        let factor = self.opacity * self.diffuse * powers(self, visible, cos.abs(), |finish| finish.brilliance);
        let is_dark = self.diffuse.equals(Lanes::splat(0.0));
        let reflected = Vectors::select(is_dark, Vectors::ZERO, self.color * factor);
        match has_highlights {
            true => reflected + highlights(self, dir, arriving, cos, visible),
            false => reflected,
        }
    }
}

impl<'w> LitPoints<'w> {
    /// Creates an empty list.
    #[inline(always)]
    pub fn new() -> Self {
        Self { point: Vectors::ZERO, layer: PacketLayer::new(), light: Vectors::ZERO }
    }

    /// Adds the point of ray `i`, with the light that it emits.
    #[inline(always)]
    pub fn add(&mut self, i: usize, at: &PlainPoint<'w>, has_ambient: bool) {
        self.point.set_lane(i, at.point);
        self.light.set_lane(i, at.shaded.weight * emitted_light(&at.shaded, has_ambient));
        self.layer.set(i, &at.shaded);
    }

    /// True if the list has no point.
    pub fn is_empty(&self) -> bool {
        self.layer.existing == 0
    }

    /// Returns the rays with points, and the light of each.
    pub fn light(&self) -> impl Iterator<Item = (usize, Rgb)> {
        set_lanes(self.layer.existing).map(|i| (i, self.light.lane(i)))
    }
}

/// Points of surfaces at the hits of a packet's rays, side by side, with the light that they send along the rays.
pub(super) trait LitInPacket {
    /// Returns the lanes with a point, as bits, and the points.
    fn points(&self) -> (u32, &Vectors);

    /// True for the points that reflect light which arrives.
    fn faces_light(&self, arriving: &ArrivingLight) -> Flags;

    /// Adds the light that the points `which.0` reflect, with highlights if `which.1` is true; `share` is the share of the light that
    /// is visible from them.
    fn add_reflected(&mut self, dir: &Vectors, arriving: &ArrivingLight, share: &Vectors, which: (Flags, bool));
}

impl LitInPacket for LitPoints<'_> {
    fn points(&self) -> (u32, &Vectors) {
        (self.layer.existing, &self.point)
    }

    fn faces_light(&self, arriving: &ArrivingLight) -> Flags {
        faces_light(self, arriving)
    }

    fn add_reflected(&mut self, dir: &Vectors, arriving: &ArrivingLight, share: &Vectors, which: (Flags, bool)) {
        add_reflected(self, dir, arriving, share, which);
    }
}

impl Tracer<'_> {
    /// Adds the light of sources that the points at the hits of a packet's rays reflect along the rays.
    pub(super) fn add_light_of_sources_to_points(&mut self, lit: &mut impl LitInPacket, packet: &Packet) {
        let (world, mut shadows) = (self.context.world, PacketShadows::new(packet));
        // (Parts without uncommon properties belong to the first set.)
        for &number in &world.lit_by[0] {
            self.add_reflected_light(&world.lights[number as usize], lit, &mut shadows);
        }
    }

    /// Adds the light of a source that the points reflect along the rays.
    fn add_reflected_light(&mut self, light: &LightSource, lit: &mut impl LitInPacket, shadows: &mut PacketShadows) {
        let (existing, points) = lit.points();
        let arriving = ArrivingLight::from_center(light, existing, points);
        let faces = lit.faces_light(&arriving);
        if !faces.any() {
            return;
        }
        let (visible, share) = self.visibility_of_packet(light, points, &arriving, faces, shadows);
        if visible.any() {
            lit.add_reflected(&shadows.packet.rays.dir, &arriving, &share, (visible, !light.emitter.shadowless));
        }
    }

    /// Returns for which of the points `faces` the light is visible at all, and the share that is visible, per channel. The points
    /// are those of the rays of `shadows`.
    #[inline]
    fn visibility_of_packet(
        &mut self,
        light: &LightSource,
        points: &Vectors,
        arriving: &ArrivingLight,
        faces: Flags,
        shadows: &mut PacketShadows,
    ) -> (Flags, Vectors) {
        if let Some(area) = self.light_grid(light, 0) {
            return self.area_visibility_of_packet((light, area), points, arriving, faces, shadows);
        }
        let (context, packet) = (self.context, shadows.packet);
        let inside = |i: usize| packet.interiors(context, i);
        let shadow_rays = RayPacket { origin: *points, dir: arriving.to_light };
        self.visibility_along_rays(light, (&shadow_rays, &arriving.distance), faces, inside)
    }
}

impl ArrivingLight {
    /// Samples the centre of a light at the points `existing`.
    #[inline(always)]
    pub fn from_center(light: &LightSource, existing: u32, points: &Vectors) -> Self {
        if light.emitter.is_even_point() {
            return arriving_from_point(light.emitter.location, light.emitter.color, points);
        }
        let zero = Vectors::ZERO;
        let mut all = Self { to_light: zero, distance: Lanes::splat(0.0), light: zero };
        for i in set_lanes(existing) {
            let LightSample { to_light, distance, light } = light.emitter.sample(points.lane(i), DVec3::ZERO);
            all.to_light.set_lane(i, to_light);
            all.distance.0[i] = distance;
            all.light.set_lane(i, light);
        }
        all
    }

    /// Returns the light that arrives at one point.
    pub fn lane(&self, i: usize) -> LightSample {
        let Self { to_light, distance, light } = self;
        LightSample { to_light: to_light.lane(i), distance: distance.0[i], light: light.lane(i) }
    }

    /// True for the points that light reaches from a direction that is known.
    #[inline(always)]
    pub fn is_light(&self) -> Flags {
        !self.light.is_zero() & self.to_light.is_finite()
    }
}

wide_versions! {
    /// Returns the light of a point light that shines evenly in all directions and does not fade.
    fn arriving_from_point(location: DVec3, color: Rgb, points: &Vectors) -> ArrivingLight {
        // The operations of `LoweredLight::sample`, in the same order; by the first, -0 becomes 0.
        let way = Vectors::splat(location + DVec3::ZERO) - *points;
        let distance = way.length_squared().sqrt();
        ArrivingLight { to_light: way / distance, distance, light: Vectors::splat(color) }
    }
}

wide_versions! {
    /// True for the points that reflect light which arrives.
    fn faces_light(lit: &LitPoints, arriving: &ArrivingLight) -> Flags {
        lit.layer.faces(arriving) & arriving.is_light()
    }
}

wide_versions! {
    /// Adds the light that the points `visible` reflect; `share` is the share of the light that is visible from them.
    fn add_reflected(
        lit: &mut LitPoints,
        dir: &Vectors,
        arriving: &ArrivingLight,
        share: &Vectors,
        which: (Flags, bool),
    ) {
        let light = arriving.light.times(*share);
        let reflected = lit.layer.reflected_share(dir, arriving, which);
        // (Light that is black is not reflected.)
        let is_lit = which.0 & !light.is_zero();
        lit.light = lit.light + Vectors::select(is_lit, reflected.times(light), Vectors::ZERO);
    }
}

/// Returns the powers of numbers, one for each of the points `visible`, with exponents of their finishes.
#[inline(always)]
fn powers(layer: &PacketLayer, visible: Flags, numbers: Numbers, exponent: fn(&LoweredFinish) -> f64) -> Numbers {
    if let Some(only) = layer.only_finish
        && let Some(whole) = fp::small_whole_exponent(exponent(only))
    {
        return fp::integer_power_of_lanes(numbers, whole);
    }
    let mut powers = Lanes::splat(0.0);
    for i in set_lanes(visible.bits()) {
        powers.0[i] = layer.finish[i].map_or(0.0, |finish| fp::power(numbers.0[i], exponent(finish)));
    }
    powers
}

/// Returns the shares of incident light that the points `visible` reflect as highlights, as
/// [`super::super::direct_light::highlight_factor`] does.
#[inline(always)]
fn highlights(layer: &PacketLayer, dir: &Vectors, arriving: &ArrivingLight, cos: Numbers, visible: Flags) -> Vectors {
    let (mut phong, mut specular, mut metallic) = (0, 0, 0);
    for i in set_lanes(visible.bits()) {
        let Some(finish) = layer.finish[i] else { continue };
        phong |= u32::from(finish.phong.strength != 0.0) << i;
        specular |= u32::from(finish.specular.strength != 0.0) << i;
        metallic |= u32::from(finish.metallic != 0.0) << i;
    }
    let zero = Lanes::splat(0.0);
    let mut amount = zero;
    if phong != 0 {
        let twice = 2.0 * dir.dot(layer.normal);
        let mirror_cos = (*dir - layer.normal * twice).dot(arriving.to_light);
        amount = amount + lobes(layer, mirror_cos, phong, |finish| &finish.phong);
    }
    if specular != 0 {
        let half_cos = layer.normal.dot((arriving.to_light - *dir).normalize_or(Vectors::ZERO));
        amount = amount + lobes(layer, half_cos, specular, |finish| &finish.specular);
    }
    let mut tint = Vectors::splat(Rgb::ONE);
    for i in set_lanes(metallic & !amount.equals(zero).bits()) {
        let tint_of = |finish: &LoweredFinish| metal_tint(finish.metallic, cos.0[i], layer.color.lane(i));
        tint.set_lane(i, layer.finish[i].map_or(Rgb::ONE, tint_of));
    }
    Vectors::select(amount.equals(zero), Vectors::ZERO, tint * amount)
}

/// Returns the strengths of the highlights of the points `counting`, and 0 for the others.
#[inline(always)]
fn lobes(layer: &PacketLayer, cos: Numbers, counting: u32, lobe: fn(&LoweredFinish) -> &Lobe) -> Numbers {
    let zero = Lanes::splat(0.0);
    let counts = Mask::from_bits(counting) & zero.less_than(cos);
    if !counts.any() {
        return zero;
    }
    if let Some(only) = layer.only_finish.map(lobe)
        && let Some(whole) = fp::small_whole_exponent(only.exponent)
    {
        return counts.select(only.strength * fp::integer_power_of_lanes(cos, whole), zero);
    }
    let mut strengths = zero;
    for i in set_lanes(counts.bits()) {
        strengths.0[i] = layer.finish[i].map_or(0.0, |finish| lobe_strength(lobe(finish), cos.0[i]));
    }
    strengths
}
