//! Media along segments of rays: emission, scattering and extinction (manual, "Sampling Parameters & Methods"). Where
//! samples are placed and how they are weighted is POV-Ray's way (quirk: `media_sampling`).

use super::media_intervals::{BeamOnRay, media_intervals};
use super::photons::Photons;
use super::random::{Purpose, RandomSequence};
use super::segment::{SegmentContext, Span};
use super::tracer::Tracer;
use crate::atmosphere::Segment;
use crate::color::Rgb;
use crate::math::{DVec3, Ray, fp, statistics};
use crate::medium::{MediaSampling, SamplingMethod};
use crate::world::{LightSource, Medium};
use smallvec::SmallVec;

/// Upper limit of the scene's `aa_level`: halves of halves of a stretch of media, 24 times, are too short to be seen.
const MAX_LEVEL: u32 = 24;

/// Optical depth beyond which hardly any light is left: exp(-16) is 1e-7.
const OPAQUE_DEPTH: f64 = 16.0;

/// A stretch of a ray in media.
pub(super) struct MediaStretch<'a, 'w> {
    pub ray: &'a Ray,
    /// Distances from the ray's origin between which the media are.
    pub range: [f64; 2],
    /// Media, the outermost first. The sampling of one applies to all ([`MediaStretch::leading_medium_index`]).
    pub media: &'a [&'w Medium],
    /// Interiors and lights of the stretch.
    pub context: &'a SegmentContext<'a>,
}

impl<'a, 'w> MediaStretch<'a, 'w> {
    /// Creates the stretch of media along a span of a ray.
    pub fn new(ray: &'a Ray, span: &Span, media: &'a [&'w Medium], context: &'a SegmentContext<'a>) -> Self {
        Self { ray, range: [span.from, span.to], media, context }
    }

    /// Returns the index of the medium whose sampling applies to all: the first one of those with the most intervals
    /// (quirk: `media_of_several`).
    pub(super) fn leading_medium_index(&self) -> usize {
        let intervals = |i: &usize| self.media[*i].sampling.intervals;
        (0..self.media.len()).rev().max_by_key(intervals).unwrap_or(0)
    }

    /// Returns the parameters of the sampling: the leader's, but the least `aa_threshold` of all media (quirk:
    /// `media_of_several`).
    fn sampling(&self) -> MediaSampling {
        let thresholds = self.media.iter().map(|medium| medium.sampling.aa_threshold);
        let aa_threshold = thresholds.fold(f64::INFINITY, f64::min);
        MediaSampling { aa_threshold, ..self.media[self.leading_medium_index()].sampling }
    }
}

/// Properties of media at one point, per world unit.
#[derive(Clone, Copy, Default)]
struct PointSample {
    /// Light that is emitted and scattered towards the eye.
    light: Rgb,
    extinction: Rgb,
}

impl PointSample {
    fn weighted_sum(parts: &[(f64, Self)]) -> Self {
        let light = parts.iter().map(|(weight, part)| *weight * part.light).sum();
        let extinction = parts.iter().map(|(weight, part)| *weight * part.extinction).sum();
        Self { light, extinction }
    }

    /// Returns the absolute difference between the light of two points in media, summed over the channels.
    fn light_difference(&self, other: &Self) -> f64 {
        (self.light - other.light).abs().element_sum()
    }
}

/// Condition for the halving of a stretch between two samples.
struct Halving {
    max_level: u32,
    /// Maximum difference of the light at the ends of a half that is not halved again, per world unit. For a whole
    /// interval it is `aa_threshold` (quirk: `media_sampling`).
    max_difference: f64,
}

/// Light and optical depth of the stretches so far, from the eye on.
#[derive(Default)]
struct Accumulated {
    light: Rgb,
    depth: Rgb,
}

impl Accumulated {
    /// Adds a stretch of the length `length` with these mean properties, behind the others.
    fn add(&mut self, mean: &PointSample, length: f64) {
        if mean.light != Rgb::ZERO {
            self.light += transmittance_of_optical_depth(self.depth) * mean.light * length;
        }
        self.depth += mean.extinction * length;
    }
}

/// Returns the transmittance of an optical depth.
fn transmittance_of_optical_depth(depth: Rgb) -> Rgb {
    if depth == Rgb::ZERO {
        Rgb::ONE
    } else if depth.x == depth.y && depth.y == depth.z {
        Rgb::splat(fp::exp(-depth.x))
    } else {
        (-depth).map(fp::exp)
    }
}

/// A medium along a stretch of a ray.
struct MediumOnRay<'w> {
    medium: &'w Medium,
    /// Distances outside of which the medium's density is 0.
    extent: [f64; 2],
}

impl MediumOnRay<'_> {
    /// True if the medium's density is 0 between two distances.
    fn is_empty_between(&self, [from, to]: [f64; 2]) -> bool {
        to < self.extent[0] || from > self.extent[1]
    }
}

/// An interval of a stretch in media.
struct Interval<'a, 'w> {
    stretch: &'a MediaStretch<'a, 'w>,
    range: [f64; 2],
    media: &'a [MediumOnRay<'w>],
    /// Lights that the media scatter in the interval.
    lights: &'a [&'a BeamOnRay<'w>],
    draws: Draws,
}

/// Lights that a medium scatters, with the stretches that they illuminate.
type BeamList<'w> = SmallVec<[BeamOnRay<'w>; 2]>;

impl<'w> Tracer<'w> {
    /// Returns the light that media add along a stretch of a ray, and their transmittance; for a shadow ray, the
    /// transmittance alone.
    pub(super) fn media_segment(&mut self, stretch: &MediaStretch<'_, 'w>) -> Segment {
        if stretch.context.is_shadow && stretch.media.iter().all(|medium| medium.extinction == Rgb::ZERO) {
            return Segment::NONE;
        }
        let is_homogeneous = stretch.media.iter().all(|medium| medium.is_homogeneous());
        if stretch.context.is_shadow && is_homogeneous {
            let extinction: Rgb = stretch.media.iter().map(|medium| medium.extinction).sum();
            let depth = extinction * (stretch.range[1] - stretch.range[0]);
            return Segment { radiance: Rgb::ZERO, transmittance: transmittance_of_optical_depth(depth) };
        }
        let mut media = SmallVec::<[MediumOnRay; 2]>::new();
        for medium in stretch.media {
            media.push(MediumOnRay { medium, extent: medium.extent_on_ray(stretch.ray) });
        }
        if media.iter().all(|medium| medium.is_empty_between(stretch.range)) {
            return Segment::NONE;
        }
        let sampling = stretch.sampling();
        let beams = self.scattered_lights(stretch);
        let scatters = stretch.media.iter().any(|medium| medium.scattering.color != Rgb::ZERO);
        let has_photons = self.context.photons.as_ref().is_some_and(Photons::has_media_photons);
        let random = self.random.sequence(Purpose::Media);
        let mut sum = Accumulated::default();
        for (number, range) in (0..).zip(media_intervals(stretch, &beams, &sampling)) {
            if media.iter().all(|medium| medium.is_empty_between(range)) {
                continue;
            }
            let mut lights = SmallVec::<[&BeamOnRay; 4]>::new();
            for beam in beams.iter().filter(|beam| scatters && beam.reaches(range)) {
                lights.push(beam);
            }
            let draws = Draws { random, first: number << 32 };
            let interval = Interval { stretch, range, media: &media, lights: &lights, draws };
            match sampling.method {
                SamplingMethod::Adaptive if is_homogeneous && lights.is_empty() && !has_photons => {
                    self.add_homogeneous(&sampling, &interval, &mut sum);
                }
                SamplingMethod::Adaptive => self.add_adaptive(&sampling, &interval, &mut sum),
                _ => self.add_mean_of_samples(&sampling, &interval, &mut sum),
            }
            if self.is_stopped() || sum.depth.min_element() > OPAQUE_DEPTH {
                break;
            }
        }
        Segment { radiance: sum.light, transmittance: transmittance_of_optical_depth(sum.depth) }
    }

    /// Returns the lights that media scatter; none for a shadow ray.
    fn scattered_lights(&self, stretch: &MediaStretch) -> BeamList<'w> {
        if stretch.context.is_shadow {
            return BeamList::new();
        }
        let world = self.context.world;
        let mut beams = BeamList::new();
        for &number in &world.lit_by[stretch.context.light_set as usize] {
            let light = &world.lights[number as usize];
            if light.emitter.scattered {
                beams.push(BeamOnRay { light, stretches: light.emitter.beam_stretches(stretch.ray, stretch.range) });
            }
        }
        beams
    }

    /// Adds an interval by method 3 if the media have the same properties at all its points, so that one sample stands
    /// for all.
    fn add_homogeneous(&mut self, sampling: &MediaSampling, interval: &Interval<'_, 'w>, sum: &mut Accumulated) {
        let [from, to] = interval.range;
        let mean = self.point_sample(interval, from);
        let n = f64::from(unrefined_sample_count(sampling) - 1);
        for _ in 1..unrefined_sample_count(sampling) {
            sum.add(&mean, (to - from) / n);
        }
    }

    /// Adds an interval by methods 1 and 2: the mean of samples, each attenuated by its own extinction.
    fn add_mean_of_samples(&mut self, sampling: &MediaSampling, interval: &Interval<'_, 'w>, sum: &mut Accumulated) {
        let [from, to] = interval.range;
        let (length, draws) = (to - from, interval.draws);
        let mut mean = RunningMean::default();
        let (least, most) = (sampling.min_samples, sampling.max_samples);
        let rule = (least < most).then(|| StoppingRule::new(sampling, length));
        for i in 0..most {
            let is_certain = i >= least && rule.as_ref().is_none_or(|rule| rule.is_certain(&mean));
            if is_certain || self.count_surface_and_is_stopped() {
                break;
            }
            let share = match sampling.method {
                SamplingMethod::Even if i < least => {
                    (f64::from(i) + 0.5 + draws.jitter_offset(sampling.jitter, i)) / f64::from(least)
                }
                _ => draws.centered_random(i) + 0.5,
            };
            let distance = share * length;
            let sample = self.point_sample(interval, from + distance);
            mean.add(&PointSample {
                light: sample.light * transmittance_of_optical_depth(sample.extinction * distance),
                ..sample
            });
        }
        sum.add(&mean.value(), length);
    }

    /// Adds an interval by method 3: samples at equal distances from its start on, and more between two of them if their
    /// light differs.
    fn add_adaptive(&mut self, sampling: &MediaSampling, interval: &Interval<'_, 'w>, sum: &mut Accumulated) {
        let ([from, to], draws) = (interval.range, interval.draws);
        let n = unrefined_sample_count(sampling);
        let step = (to - from) / f64::from(n);
        let at = |i: u32| from + step * (f64::from(i) + draws.jitter_offset(sampling.jitter, i));
        let halving = Halving {
            max_level: sampling.aa_level.min(MAX_LEVEL),
            max_difference: sampling.aa_threshold / (to - from),
        };
        let mut before = (at(0), self.point_sample(interval, at(0)));
        for i in 1..n {
            let next = (at(i), self.point_sample(interval, at(i)));
            let mean = self.mean_between(interval, &halving, &before, &next, 1);
            sum.add(&mean, (to - from) / f64::from(n - 1));
            before = next;
            if self.is_stopped() || sum.depth.min_element() > OPAQUE_DEPTH {
                return;
            }
        }
    }

    /// Returns the mean of a stretch between two samples: of both halves, which are halved again if the light at their
    /// ends differs.
    fn mean_between(
        &mut self,
        interval: &Interval<'_, 'w>,
        halving: &Halving,
        start: &(f64, PointSample),
        end: &(f64, PointSample),
        halvings_done: u32,
    ) -> PointSample {
        let at = 0.5 * (start.0 + end.0);
        let middle = (at, self.point_sample(interval, at));
        let is_last = halvings_done >= halving.max_level || self.is_stopped();
        let mut half = |outer: &(f64, PointSample)| {
            if is_last || outer.1.light_difference(&middle.1) <= halving.max_difference {
                return PointSample::weighted_sum(&[(2.0 / 3.0, outer.1), (1.0 / 3.0, middle.1)]);
            }
            self.mean_between(interval, halving, outer, &middle, halvings_done + 1)
        };
        let (first, second) = (half(start), half(end));
        PointSample::weighted_sum(&[(0.5, first), (0.5, second)])
    }

    /// Returns the properties of all media at a distance along the ray.
    fn point_sample(&mut self, interval: &Interval<'_, 'w>, t: f64) -> PointSample {
        self.count_surface_and_is_stopped();
        let (world, stretch) = (self.context.world, interval.stretch);
        let p = stretch.ray.at(t);
        let mut sum = PointSample::default();
        // Light is computed for the first medium that scatters it.
        let mut phased = None;
        for part in interval.media {
            let medium = part.medium;
            if part.is_empty_between([t, t]) || (stretch.context.is_shadow && medium.extinction == Rgb::ZERO) {
                continue;
            }
            let density = medium.density_at(p, stretch.ray.dir, world.noise, world.waves);
            if density == Rgb::ZERO {
                continue;
            }
            sum.extinction += density * medium.extinction;
            if !stretch.context.is_shadow {
                sum.light += density * medium.emission;
                if medium.scattering.color != Rgb::ZERO {
                    let phased = *phased.get_or_insert_with(|| self.light_times_phase(interval, t));
                    sum.light += density * medium.scattering.color * phased;
                }
            }
        }
        sum
    }

    /// Returns the light that arrives at the distance `t` along the ray, times the phase function towards the eye.
    fn light_times_phase(&mut self, interval: &Interval<'_, 'w>, t: f64) -> Rgb {
        let stretch = interval.stretch;
        let p = stretch.ray.at(t);
        let lights = interval.lights.iter().filter(|beam| beam.shines_at(t));
        let mut sum: Rgb = lights.map(|beam| self.light_times_phase_of(stretch, beam.light, p)).sum();
        if self.context.photons.is_some() && stretch.media.iter().any(|medium| medium.collects_photons) {
            let phase = |cos| stretch.media.iter().map(|medium| medium.scattering.phase_factor(cos)).sum::<f64>();
            sum += self.photon_fluence(p, stretch.ray.dir, phase) / stretch.media.len() as f64;
        }
        sum
    }

    /// Returns the light that arrives at a point from one source, times the phase function towards the eye.
    fn light_times_phase_of(&mut self, stretch: &MediaStretch<'_, 'w>, light: &'w LightSource, p: DVec3) -> Rgb {
        let mut sample = light.emitter.sample(p, DVec3::ZERO);
        // quirk: area_illumination_in_media
        let SegmentContext { inside, bounces, .. } = *stretch.context;
        if self.light_grid(light, bounces).is_some_and(|area| area.illumination) {
            sample.light = light.emitter.color;
        }
        if sample.light == Rgb::ZERO || !sample.to_light.is_finite() {
            return Rgb::ZERO;
        }
        // quirk: phase_of_several
        let cos = stretch.ray.dir.dot(sample.to_light);
        let phases: f64 = stretch.media.iter().map(|medium| medium.scattering.phase_factor(cos)).sum();
        let visibility = self.visibility(light, p, &sample, inside, bounces);
        phases / stretch.media.len() as f64 * sample.light * visibility
    }
}

/// Random numbers for the samples of one interval.
#[derive(Clone, Copy)]
struct Draws {
    random: RandomSequence,
    first: u64,
}

impl Draws {
    /// Returns the random number of the sample with this index, in [-0.5, 0.5).
    fn centered_random(self, sample: u32) -> f64 {
        self.random.at(self.first + u64::from(sample)) - 0.5
    }

    /// Returns the offset of a sample by `jitter`, relative to the distance of samples.
    fn jitter_offset(self, jitter: f64, sample: u32) -> f64 {
        if jitter == 0.0 { 0.0 } else { jitter * self.centered_random(sample) }
    }
}

/// Running mean and variance of the samples that are taken of media in one interval of a ray.
#[derive(Default)]
struct RunningMean {
    count: f64,
    sum: PointSample,
    squares: Rgb,
}

impl RunningMean {
    fn add(&mut self, sample: &PointSample) {
        self.count += 1.0;
        self.sum = PointSample::weighted_sum(&[(1.0, self.sum), (1.0, *sample)]);
        self.squares += sample.light * sample.light;
    }

    fn value(&self) -> PointSample {
        let weight = 1.0 / self.count.max(1.0);
        PointSample::weighted_sum(&[(weight, self.sum)])
    }

    /// Returns the largest variance of the mean light of all channels.
    fn variance_of_mean(&self) -> f64 {
        let mean = self.sum.light / self.count;
        (self.squares / self.count - mean * mean).max_element() / self.count
    }
}

/// Rule by which methods 1 and 2 stop between the minimum and the maximum number of samples (quirk: `media_confidence`).
struct StoppingRule {
    /// Maximum variance of the mean, per squared world unit, divided by the chi-square quantile for the maximum number
    /// of samples.
    scaled_variance: f64,
    /// Quantile of the standard normal distribution for 1 - `confidence`.
    normal_quantile: f64,
}

impl StoppingRule {
    /// Creates the rule for an interval of the length `length`.
    fn new(sampling: &MediaSampling, length: f64) -> Self {
        let normal_quantile = statistics::normal_quantile(1.0 - sampling.confidence);
        let most = f64::from(sampling.max_samples.max(2) - 1);
        let per_sample = sampling.variance / statistics::chi_square_quantile(most, normal_quantile);
        Self { scaled_variance: per_sample / (length * length), normal_quantile }
    }

    /// True if the mean of the media samples is certain enough, so that no further sample is taken.
    fn is_certain(&self, mean: &RunningMean) -> bool {
        let quantile = statistics::chi_square_quantile(mean.count, self.normal_quantile);
        mean.variance_of_mean() <= self.scaled_variance * quantile
    }
}

/// Returns the number of samples of an interval by method 3 before it is refined.
fn unrefined_sample_count(sampling: &MediaSampling) -> u32 {
    (sampling.min_samples / 2 + 2).max(3)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// With POV-Ray's own numbers: the largest amplitude of light, at every other sample, at which n samples are enough.
    #[test]
    fn sampling_stops_where_pov_ray_does() {
        // Samples, maximum, confidence, length, and POV-Ray's squared amplitude / 4 / `variance`.
        for (n, most, confidence, length, found) in [
            (8, 5000, 0.5, 2.0, 0.00294),
            (8, 5000, 0.5, 4.0, 0.00294 / 4.0),
            (8, 500, 0.5, 2.0, 0.02948),
            (8, 50, 0.5, 2.0, 0.3039),
            (32, 5000, 0.9, 2.0, 0.03657),
            (64, 5000, 0.1, 2.0, 0.24607),
            (64, 5000, 0.99, 2.0, 0.13637),
        ] {
            let mut sampling = MediaSampling::new(false);
            (sampling.variance, sampling.confidence, sampling.max_samples) = (0.01, confidence, most);
            let is_certain = |squared: f64| {
                let mut mean = RunningMean::default();
                let amplitude = (4.0 * 0.01 * squared).sqrt();
                for i in 0..n {
                    let light = Rgb::splat(amplitude * f64::from(i % 2));
                    mean.add(&PointSample { light, extinction: Rgb::ZERO });
                }
                StoppingRule::new(&sampling, length).is_certain(&mean)
            };
            assert!(is_certain(0.98 * found) && !is_certain(1.02 * found), "{n} of {most}, {confidence}, {length}");
        }
    }
}
