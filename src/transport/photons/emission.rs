//! Emission of photons: rings of photons about the line from a light to a target (manual, "Autostop").

use super::super::context::FrameContext;
use crate::color::Rgb;
use crate::light::Area;
use crate::math::{Aabb, DVec3, GOLDEN_SECTION, Ray, fp, rng};
use crate::scene::PhotonMapSettings;
use crate::world::{LightSource, ObjectInfo, World};
use std::f64::consts::PI;
use std::ops::Range;

/// Approximate number of photons of a job.
const PHOTONS_PER_JOB: f64 = 4096.0;
/// Maximum number of photons of a frame; with a smaller `spacing` they are spread wider.
const MAX_PHOTONS: f64 = 1e7;

/// Shape of the bundle of rays from a light to a target.
#[derive(Clone, Copy, Debug)]
enum Bundle {
    /// Rays from one point, up to an angle from the axis.
    Cone,
    /// Parallel rays, up to a distance from the axis.
    Tube,
}

/// Photons that one point of a light emits at one target, in rings about the direction to the target.
#[derive(Clone, Copy, Debug)]
pub struct Source {
    /// Index of the light in [`World::lights`].
    pub light: u32,
    /// Number of the target, [`crate::world::SolidNode::object`].
    pub target: u32,
    /// Distance between photons at the target, in world units.
    pub spacing: f64,
    /// Distance from the light to the target.
    pub distance: f64,
    bundle: Bundle,
    origin: DVec3,
    /// Unit vectors right, up and ahead of the bundle of photon rays, whose axis is ahead, in world space.
    axes: [DVec3; 3],
    /// Distance between neighbouring rings of photons about the bundle's axis: an angle in radians for a cone, a length
    /// in world units for parallel rays.
    step: f64,
    /// Largest angle (radians) or distance (world units) from the bundle's axis at which photons are emitted.
    extent: f64,
    /// Share of the light's power that these photons carry: 1, or that of one light of an area light's grid.
    share: f64,
    jitter: f64,
    key: u64,
}

/// Work item of the photon pass: a few rings of the photons that one light emits at one target.
#[derive(Clone, Debug)]
pub struct Job {
    /// Index, in the plan's list of sources, of the light and target whose photons the job emits.
    pub source: usize,
    /// Numbers of the rings, the innermost first.
    pub rings: Range<u32>,
}

/// An emitted photon.
pub struct Emitted {
    pub ray: Ray,
    /// Solid angle of a cone's ray or area of a parallel ray, times the share of the light. The light's
    /// colour is not included.
    pub measure: f64,
}

impl Source {
    /// True if the power of photons is per solid angle, and not per area.
    pub fn is_cone(&self) -> bool {
        matches!(self.bundle, Bundle::Cone)
    }

    /// Returns the approximate number of photons: the area of the bundle's end divided by the area of a photon.
    fn n_photons(&self) -> f64 {
        let area = match self.bundle {
            Bundle::Cone => 2.0 * PI * (1.0 - fp::cos(self.extent)),
            Bundle::Tube => PI * self.extent * self.extent,
        };
        area / (self.step * self.step)
    }

    /// Multiplies the spacing of the photons.
    fn widen_spacing(&mut self, factor: f64) {
        (self.step, self.spacing) = (self.step * factor, self.spacing * factor);
    }

    /// Returns the number of photons in a ring.
    pub fn n_in_ring(&self, ring: u32) -> u32 {
        let middle = (f64::from(ring) + 0.5) * self.step;
        let length = match self.bundle {
            Bundle::Cone => fp::sin(middle.min(PI)),
            Bundle::Tube => middle,
        };
        (2.0 * PI * length / self.step).round().max(1.0) as u32
    }

    /// Returns the emitted photon with the index `number` in a ring: its ray, and its solid angle or area times the share
    /// of the light. Rings are of directions from one point, or of origins of parallel rays.
    pub fn emit(&self, ring: u32, number: u32) -> Emitted {
        let n = self.n_in_ring(ring);
        let random = |which: u64| rng::random_unit(&[self.key, u64::from(ring), u64::from(number), which]) - 0.5;
        let from_axis = (f64::from(ring) + 0.5 + self.jitter * random(0)) * self.step;
        let turn =
            (f64::from(number) + 0.5 + self.jitter * random(1)) / f64::from(n) + GOLDEN_SECTION * f64::from(ring);
        let (sin, cos) = fp::sin_cos(2.0 * PI * turn.fract());
        let [right, up, ahead] = self.axes;
        let beside = right * cos + up * sin;
        let (inner, outer) = (f64::from(ring) * self.step, f64::from(ring + 1) * self.step);
        match self.bundle {
            Bundle::Cone => {
                let (sin, cos) = fp::sin_cos(from_axis.min(PI));
                let solid_angle = 2.0 * PI * (fp::cos(inner) - fp::cos(outer.min(PI)));
                let ray = Ray::new(self.origin, (ahead * cos + beside * sin).normalize());
                Emitted { ray, measure: self.share * solid_angle / f64::from(n) }
            }
            Bundle::Tube => {
                let area = PI * (outer * outer - inner * inner);
                let ray = Ray::new(self.origin + beside * from_axis, ahead);
                Emitted { ray, measure: self.share * area / f64::from(n) }
            }
        }
    }

    /// Divides the rings of this source into jobs of about 4096 photons each, and appends them to `jobs`.
    fn append_jobs(&self, source_number: usize, jobs: &mut Vec<Job>) {
        let (mut first, mut count) = (0, 0.0);
        let n_rings = (self.extent / self.step).ceil().clamp(1.0, 1e6) as u32;
        for ring in 0..n_rings {
            count += f64::from(self.n_in_ring(ring));
            if count >= PHOTONS_PER_JOB || ring + 1 == n_rings {
                jobs.push(Job { source: source_number, rings: first..ring + 1 });
                (first, count) = (ring + 1, 0.0);
            }
        }
    }

    /// True if autostop may end the emission at this ring.
    pub fn may_stop_at(&self, ring: u32, autostop: f64) -> bool {
        f64::from(ring) * self.step >= autostop * self.extent
    }
}

/// A target of photons.
struct Target {
    object: u32,
    bounds: Aabb,
    /// Factor of the distance between photons at this target, from the object's `photons` block.
    factor: f64,
    settings: u32,
}

/// Plan of a frame's photon pass: all pairs of a light and a target, and the jobs that emit their photons.
#[derive(Debug)]
pub struct Plan {
    pub sources: Vec<Source>,
    pub jobs: Vec<Job>,
}

impl Plan {
    /// Plans the emission of all lights at all targets.
    pub fn new(context: &FrameContext, settings: &PhotonMapSettings) -> Self {
        let world = context.world;
        let targets = targets(world);
        let pairs = || {
            world.lights.iter().flat_map(|light| targets.iter().map(move |target| (light, target))).filter(
                |(light, target)| {
                    let [refracts, reflects] = world.photon_refracts_and_reflects(light, target.settings);
                    refracts || reflects
                },
            )
        };
        let spacing = if settings.count > 0.0 { spacing_of_count(world, settings, pairs()) } else { settings.spacing };
        let mut sources: Vec<Source> = vec![];
        for (light, target) in pairs() {
            for (offset, share) in light_offsets_and_shares(light, context.quality.area_lights) {
                let key = rng::random_word(&[u64::from(context.frame), sources.len() as u64]);
                let source = source(light, offset, target, spacing * target.factor / share.sqrt());
                sources.push(Source { share, jitter: settings.jitter, key, ..source });
            }
        }
        // Widen the spacing of too many photons
        let count: f64 = sources.iter().map(Source::n_photons).sum();
        if count > MAX_PHOTONS {
            sources.iter_mut().for_each(|source| source.widen_spacing((count / MAX_PHOTONS).sqrt()));
        }
        let mut plan = Self { sources, jobs: vec![] };
        for (number, source) in plan.sources.iter().enumerate() {
            source.append_jobs(number, &mut plan.jobs);
        }
        plan
    }
}

/// Returns, for each point of a light source that emits photons, its offset from the light's location and its share of
/// the power.
fn light_offsets_and_shares(light: &LightSource, area_lights: bool) -> Vec<(DVec3, f64)> {
    let grid = light.emitter.area.as_ref().filter(|_| light.emitter.photons.area_light && area_lights);
    let Some(Area { axes, size: [n, m], .. }) = grid else { return vec![(DVec3::ZERO, 1.0)] };
    let along = |i: u32, n: u32| if n > 1 { f64::from(i) / f64::from(n - 1) - 0.5 } else { 0.0 };
    let share = 1.0 / (f64::from(*n) * f64::from(*m));
    let cells = (0..*m).flat_map(|j| (0..*n).map(move |i| (i, j)));
    cells.map(|(i, j)| (axes[0] * along(i, *n) + axes[1] * along(j, *m), share)).collect()
}

fn targets(world: &World) -> Vec<Target> {
    let target = |object: u32, bounds: Aabb| {
        let ObjectInfo { photons: settings, is_hit_by_photons, .. } = world.objects[object as usize];
        let factor = world.photons[settings as usize].target.filter(|_| is_hit_by_photons)?;
        (factor > 0.0 && !bounds.is_empty()).then_some(Target { object, bounds, factor, settings })
    };
    let mut targets: Vec<Target> =
        world.geometry.items().filter_map(|item| target(item.object(), item.bounds())).collect();
    // The order of the geometry is that of a hierarchy; the order of the scene is stable.
    targets.sort_by_key(|target| target.object);
    targets
}

/// Returns the distance between photons at which about as many are stored as the setting `count` states. A target with
/// both reflection and refraction counts four times.
fn spacing_of_count<'a>(
    world: &World,
    settings: &PhotonMapSettings,
    pairs: impl Iterator<Item = (&'a LightSource, &'a Target)>,
) -> f64 {
    let area = |(light, target): (&LightSource, &Target)| {
        let [refracts, reflects] = world.photon_refracts_and_reflects(light, target.settings);
        let radius = 0.5 * diagonal_or_substitute(&target.bounds, light.emitter.location);
        0.5 * PI * radius * radius * if refracts && reflects { 4.0 } else { 1.0 }
    };
    (pairs.map(area).sum::<f64>() / settings.count.max(1.0)).sqrt()
}

/// Returns the diagonal of a box, or a replacement for an infinite one.
fn diagonal_or_substitute(bounds: &Aabb, light: DVec3) -> f64 {
    if bounds.is_finite() { bounds.size().length() } else { 2.0 * light.length().max(1.0) }
}

/// Returns the source of photons from one point of a light at a target, with all of the light's power and without
/// jitter; the caller sets the share, the jitter and the key.
fn source(light: &LightSource, offset: DVec3, target: &Target, spacing: f64) -> Source {
    let emitter = &light.emitter;
    let (bounds, origin) = (target.bounds, emitter.location + offset);
    let is_finite = bounds.is_finite();
    let center = if is_finite { bounds.center() } else { origin - DVec3::Y * origin.length().max(1.0) };
    let radius = 0.5 * diagonal_or_substitute(&bounds, origin);
    let (bundle, origin, ahead, extent, unit, distance) = if emitter.is_parallel() {
        // Start in the plane of the light, or before the target if that is behind the light.
        let ahead = emitter.axis();
        let distance = (center - origin).dot(ahead);
        (Bundle::Tube, center - ahead * distance, ahead, radius, 1.0, distance.abs())
    } else {
        let way = center - origin;
        let ahead = way.normalize_or(DVec3::Y);
        let distance = way.length().max(if bounds.contains(origin) { radius } else { 0.0 });
        let angle = |corner: DVec3| fp::acos((corner - origin).normalize_or_zero().dot(ahead).clamp(-1.0, 1.0));
        let extent = match is_finite && !bounds.contains(origin) {
            true => bounds.corners().map(angle).into_iter().fold(0.0, f64::max),
            false => PI,
        };
        (Bundle::Cone, origin, ahead, extent, distance.max(1e-9), distance)
    };
    let (right, up) = ahead.any_orthonormal_pair();
    let step = spacing / unit;
    let step = if step.is_finite() && step > 0.0 { step.min(extent.max(1e-9)) } else { extent.max(1e-9) };
    Source {
        light: light.number as u32,
        target: target.object,
        spacing,
        distance,
        bundle,
        origin,
        axes: [right, up, ahead],
        step,
        extent,
        share: 1.0,
        jitter: 0.0,
        key: 0,
    }
}

/// Returns the power of a photon after a path of this length, per [`Emitted::measure`] (solid angle or area). POV-Ray's
/// light does not fall off by itself, so that the power grows with the square of the path.
pub fn photon_power_per_measure(source: &Source, light: &LightSource, path_length: f64) -> Rgb {
    let spread = if source.is_cone() { path_length * path_length } else { 1.0 };
    light.emitter.strength_at(path_length) * spread
}
