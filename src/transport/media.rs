//! Media along segments of rays: emission, scattering and extinction (manual, "Sampling Parameters & Methods"). Where
//! samples are placed and how they are weighted is POV-Ray's way (quirk: `media_sampling`).

use super::interface::Interiors;
use super::random::{Purpose, RandomSequence};
use super::tracer::Tracer;
use crate::atmosphere::Segment;
use crate::color::Rgb;
use crate::math::{DVec3, Ray, fp};
use crate::medium::{MediaSampling, SamplingMethod};
use crate::world::{LightSource, Medium};
use smallvec::SmallVec;

/// Maximum depth of halving: further halves of a stretch do not differ from it.
const MAX_LEVEL: u32 = 24;

/// Optical depth beyond which no light is left that a picture could show: exp(-25) is 1e-11.
const OPAQUE_DEPTH: f64 = 25.0;

/// A stretch of a ray in media.
pub(super) struct MediaStretch<'a, 'w> {
    pub ray: &'a Ray,
    /// Distances from the ray's origin between which the media are.
    pub range: [f64; 2],
    /// Media, the outermost first. The parameters of the first one apply to all (quirk: `media_of_first`).
    pub media: &'a [&'w Medium],
    /// Interiors that contain the stretch.
    pub inside: &'a Interiors,
    /// True for a shadow ray, for which extinction alone counts.
    pub is_shadow: bool,
}

/// Properties of media at one point, per world unit.
#[derive(Clone, Copy, Default)]
struct PointSample {
    /// Light that is emitted and scattered towards the eye.
    light: Rgb,
    extinction: Rgb,
}

impl PointSample {
    fn sum(parts: &[(f64, Self)]) -> Self {
        let light = parts.iter().map(|(weight, part)| *weight * part.light).sum();
        let extinction = parts.iter().map(|(weight, part)| *weight * part.extinction).sum();
        Self { light, extinction }
    }

    /// Returns the difference of the light, summed over the channels.
    fn difference(&self, other: &Self) -> f64 {
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
            self.light += transmittance(self.depth) * mean.light * length;
        }
        self.depth += mean.extinction * length;
    }
}

/// Returns the transmittance of an optical depth.
fn transmittance(depth: Rgb) -> Rgb {
    if depth == Rgb::ZERO { Rgb::ONE } else { (-depth).map(fp::exp) }
}

/// A light that a medium scatters, and where on a ray the light shines.
struct BeamOnRay<'w> {
    light: &'w LightSource,
    /// Stretches of the ray within the light's beam; `None` for a light that shines in all directions.
    stretches: Option<SmallVec<[[f64; 2]; 2]>>,
}

impl BeamOnRay<'_> {
    /// True if the light shines on a part of the interval, or touches it.
    fn reaches(&self, [from, to]: [f64; 2]) -> bool {
        let slack = 1e-6 * (to - from);
        let touches = |[start, end]: &[f64; 2]| *start <= to + slack && *end >= from - slack;
        self.stretches.as_ref().is_none_or(|stretches| stretches.iter().any(touches))
    }
}

/// An interval of a stretch in media.
struct Interval<'a, 'w> {
    stretch: &'a MediaStretch<'a, 'w>,
    range: [f64; 2],
    /// For each medium, the lights that it scatters in the interval.
    lights: &'a [LightList<'w>],
    draws: Draws,
}

/// Lights that a medium scatters.
type LightList<'w> = SmallVec<[&'w LightSource; 4]>;

impl<'w> Tracer<'w> {
    /// Returns the light that media add along a stretch of a ray, and their transmittance.
    pub(super) fn media_segment(&mut self, stretch: &MediaStretch<'_, 'w>) -> Segment {
        let is_homogeneous = stretch.media.iter().all(|medium| medium.is_homogeneous());
        if stretch.is_shadow && is_homogeneous {
            let extinction: Rgb = stretch.media.iter().map(|medium| medium.extinction).sum();
            let depth = extinction * (stretch.range[1] - stretch.range[0]);
            return Segment { radiance: Rgb::ZERO, transmittance: transmittance(depth) };
        }
        let sampling = stretch.media[0].sampling;
        let random = self.random.sequence(Purpose::Media);
        let beams: SmallVec<[_; 2]> = stretch.media.iter().map(|medium| self.beams(stretch, medium)).collect();
        let mut sum = Accumulated::default();
        for (number, range) in (0..).zip(media_intervals(stretch, &beams[0], &sampling)) {
            let reaching = |(medium, beams): (&&Medium, &Vec<BeamOnRay<'w>>)| -> LightList<'w> {
                let scatters = medium.scattering.color != Rgb::ZERO;
                beams.iter().filter(|beam| scatters && beam.reaches(range)).map(|beam| beam.light).collect()
            };
            let lights: SmallVec<[_; 2]> = stretch.media.iter().zip(&beams).map(reaching).collect();
            let interval = Interval { stretch, range, lights: &lights, draws: Draws { random, first: number << 32 } };
            match sampling.method {
                SamplingMethod::Adaptive if is_homogeneous && lights.iter().all(SmallVec::is_empty) => {
                    self.add_constant(&sampling, &interval, &mut sum);
                }
                SamplingMethod::Adaptive => self.add_adaptive(&sampling, &interval, &mut sum),
                _ => self.add_sampled(&sampling, &interval, &mut sum),
            }
            if self.is_stopped() || sum.depth.min_element() > OPAQUE_DEPTH {
                break;
            }
        }
        Segment { radiance: sum.light, transmittance: transmittance(sum.depth) }
    }

    /// Returns the lights that a medium scatters; none for a shadow ray.
    fn beams(&self, stretch: &MediaStretch, medium: &Medium) -> Vec<BeamOnRay<'w>> {
        if stretch.is_shadow {
            return vec![];
        }
        let world = self.context.world;
        let lights = world.lit_by[medium.lights as usize].iter().map(|&number| &world.lights[number as usize]);
        let beam = |light: &'w LightSource| BeamOnRay {
            light,
            stretches: light.emitter.lit_stretches(stretch.ray, stretch.range),
        };
        lights.filter(|light| light.emitter.scattered).map(beam).collect()
    }

    /// Adds an interval in which all samples of method 3 are equal.
    fn add_constant(&mut self, sampling: &MediaSampling, interval: &Interval<'_, 'w>, sum: &mut Accumulated) {
        let [from, to] = interval.range;
        let mean = self.point_sample(interval, from);
        let n = f64::from(adaptive_count(sampling) - 1);
        for _ in 1..adaptive_count(sampling) {
            sum.add(&mean, (to - from) / n);
        }
    }

    /// Adds an interval by methods 1 and 2: the mean of samples, each attenuated by its own extinction.
    fn add_sampled(&mut self, sampling: &MediaSampling, interval: &Interval<'_, 'w>, sum: &mut Accumulated) {
        let [from, to] = interval.range;
        let (length, draws) = (to - from, interval.draws);
        let mut mean = RunningMean::default();
        let (least, most) = (sampling.min_samples, sampling.max_samples);
        for i in 0..most {
            if i >= least && mean.is_certain(sampling) || self.is_stopped_at_next_surface() {
                break;
            }
            let share = match sampling.method {
                SamplingMethod::Even if i < least => {
                    (f64::from(i) + 0.5 + draws.jittered(sampling.jitter, i)) / f64::from(least)
                }
                _ => draws.centered(i) + 0.5,
            };
            let distance = share * length;
            let sample = self.point_sample(interval, from + distance);
            mean.add(&PointSample { light: sample.light * transmittance(sample.extinction * distance), ..sample });
        }
        sum.add(&mean.value(), length);
    }

    /// Adds an interval by method 3: samples at equal distances from its start on, and more between two of them if their
    /// light differs.
    fn add_adaptive(&mut self, sampling: &MediaSampling, interval: &Interval<'_, 'w>, sum: &mut Accumulated) {
        let ([from, to], draws) = (interval.range, interval.draws);
        let n = adaptive_count(sampling);
        let step = (to - from) / f64::from(n);
        let at = |i: u32| from + step * (f64::from(i) + draws.jittered(sampling.jitter, i));
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
        level: u32,
    ) -> PointSample {
        let at = 0.5 * (start.0 + end.0);
        let middle = (at, self.point_sample(interval, at));
        let is_last = level >= halving.max_level || self.is_stopped();
        let mut half = |outer: &(f64, PointSample)| {
            if is_last || outer.1.difference(&middle.1) <= halving.max_difference {
                return PointSample::sum(&[(2.0 / 3.0, outer.1), (1.0 / 3.0, middle.1)]);
            }
            self.mean_between(interval, halving, outer, &middle, level + 1)
        };
        let (first, second) = (half(start), half(end));
        PointSample::sum(&[(0.5, first), (0.5, second)])
    }

    /// Returns the properties of all media at a distance along the ray.
    fn point_sample(&mut self, interval: &Interval<'_, 'w>, t: f64) -> PointSample {
        self.is_stopped_at_next_surface();
        let (world, stretch) = (self.context.world, interval.stretch);
        let p = stretch.ray.at(t);
        let mut sum = PointSample::default();
        for (medium, lights) in stretch.media.iter().zip(interval.lights) {
            let density = medium.density_at(p, stretch.ray.dir, world.noise, world.waves);
            if density == Rgb::ZERO {
                continue;
            }
            sum.extinction += density * medium.extinction;
            if !stretch.is_shadow {
                sum.light += density * (medium.emission + self.scattered_light(stretch, medium, lights, p));
            }
        }
        sum
    }

    /// Returns the light that a medium scatters at a point towards the eye.
    fn scattered_light(
        &mut self,
        stretch: &MediaStretch<'_, 'w>,
        medium: &Medium,
        lights: &[&'w LightSource],
        p: DVec3,
    ) -> Rgb {
        let mut sum = Rgb::ZERO;
        for light in lights {
            let sample = light.emitter.sample(p, DVec3::ZERO);
            if sample.light == Rgb::ZERO || !sample.from.is_finite() {
                continue;
            }
            // quirk: phase_of_several
            let cos = stretch.ray.dir.dot(sample.from);
            let phases: f64 = stretch.media.iter().map(|medium| medium.scattering.phase_factor(cos)).sum();
            sum +=
                phases / stretch.media.len() as f64 * sample.light * self.visibility(light, p, &sample, stretch.inside);
        }
        medium.scattering.color * sum
    }
}

/// Random numbers for the samples of one interval.
#[derive(Clone, Copy)]
struct Draws {
    random: RandomSequence,
    first: u64,
}

impl Draws {
    /// Returns the number of a sample, in [-0.5, 0.5).
    fn centered(self, sample: u32) -> f64 {
        self.random.at(self.first + u64::from(sample)) - 0.5
    }

    /// Returns the offset of a sample by `jitter`, relative to the distance of samples.
    fn jittered(self, jitter: f64, sample: u32) -> f64 {
        if jitter == 0.0 { 0.0 } else { jitter * self.centered(sample) }
    }
}

/// Mean and variance of samples.
#[derive(Default)]
struct RunningMean {
    count: f64,
    sum: PointSample,
    squares: Rgb,
}

impl RunningMean {
    fn add(&mut self, sample: &PointSample) {
        self.count += 1.0;
        self.sum = PointSample::sum(&[(1.0, self.sum), (1.0, *sample)]);
        self.squares += sample.light * sample.light;
    }

    fn value(&self) -> PointSample {
        let weight = 1.0 / self.count.max(1.0);
        PointSample::sum(&[(weight, self.sum)])
    }

    /// True if the variance of the mean is below `variance` with the probability `confidence`, by Chebyshev's
    /// inequality.
    fn is_certain(&self, sampling: &MediaSampling) -> bool {
        let mean = self.sum.light / self.count;
        let variance = (self.squares / self.count - mean * mean).max_element() / self.count;
        variance <= sampling.variance * (1.0 - sampling.confidence)
    }
}

/// Returns the number of samples of an interval by method 3 before it is refined.
fn adaptive_count(sampling: &MediaSampling) -> u32 {
    (sampling.min_samples / 2 + 2).max(3)
}

/// Divides a stretch into intervals. If only spotlights and cylinder lights illuminate media, their beams divide the
/// stretch first, and `ratio` distributes the intervals. A medium without densities has one interval where no light
/// shines (quirk: `media_intervals`).
fn media_intervals(stretch: &MediaStretch, beams: &[BeamOnRay], sampling: &MediaSampling) -> Vec<[f64; 2]> {
    let is_all_lit = beams.iter().any(|beam| beam.stretches.is_none());
    let lit: Vec<[f64; 2]> = beams.iter().flat_map(|beam| beam.stretches.iter().flatten().copied()).collect();
    let is_dark = lit.is_empty() && !is_all_lit;
    let is_uniform = is_dark && !stretch.is_shadow && stretch.media[0].is_homogeneous();
    let pieces = if is_all_lit { vec![(stretch.range, true)] } else { beam_pieces(lit, stretch.range) };
    let intervals = if is_uniform { 1 } else { sampling.intervals as usize };
    let counts = interval_counts(&pieces.iter().map(|(_, lit)| *lit).collect::<Vec<_>>(), intervals, sampling.ratio);
    let parts = pieces.iter().zip(counts).flat_map(|(([from, to], _), count)| {
        let at = move |i: usize| from + (to - from) * (i as f64 / count as f64);
        (0..count).map(move |i| [at(i), at(i + 1)])
    });
    parts.collect()
}

/// Divides a range at the ends of the lit stretches; overlapping stretches are united. Each piece states whether it is
/// lit.
fn beam_pieces(mut lit: Vec<[f64; 2]>, [from, to]: [f64; 2]) -> Vec<([f64; 2], bool)> {
    lit.sort_by(|a, b| a[0].total_cmp(&b[0]));
    let mut pieces: Vec<([f64; 2], bool)> = vec![];
    let mut last = from;
    for [start, end] in lit {
        match pieces.last_mut() {
            Some((piece, true)) if start <= piece[1] => piece[1] = piece[1].max(end),
            _ => {
                if start > last {
                    pieces.push(([last, start], false));
                }
                pieces.push(([start, end], true));
            }
        }
        last = last.max(end);
    }
    if last < to || pieces.is_empty() {
        pieces.push(([last, to], false));
    }
    pieces
}

/// Distributes intervals over pieces of a stretch: each gets one, and a share by `ratio` if it is lit, by 1 - `ratio`
/// otherwise; the last one gets the rest.
fn interval_counts(lit: &[bool], intervals: usize, ratio: f64) -> Vec<usize> {
    let weight = |lit: bool| if lit { ratio } else { 1.0 - ratio };
    let total: f64 = lit.iter().map(|lit| weight(*lit)).sum();
    let n_pieces = lit.len();
    let mut left = intervals.max(n_pieces);
    let counts = (1..=lit.len()).zip(lit).map(|(number, lit)| {
        let n_after = n_pieces - number;
        let wanted = (weight(*lit) / total * intervals as f64).ceil() as usize;
        let count = if n_after == 0 { left } else { wanted.clamp(1, left - n_after) };
        left -= count;
        count
    });
    counts.collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// With POV-Ray's own numbers.
    #[test]
    fn intervals_are_distributed_by_ratio() {
        let one = [false, true, false];
        for (intervals, ratio, counts) in [
            (1, 0.9, [1, 1, 1]),
            (5, 0.9, [1, 3, 1]),
            (10, 0.9, [1, 8, 1]),
            (20, 0.9, [2, 17, 1]),
            (10, 0.5, [4, 4, 2]),
            (10, 0.1, [5, 1, 4]),
        ] {
            assert_eq!(interval_counts(&one, intervals, ratio), counts, "{intervals} {ratio}");
        }
        assert_eq!(interval_counts(&[false, true, false, true, false], 10, 0.9), [1, 5, 1, 2, 1]);
    }

    #[test]
    fn beams_divide_a_stretch() {
        let pieces = |lit: &[[f64; 2]]| beam_pieces(lit.to_vec(), [0.0, 1.0]);
        assert_eq!(pieces(&[]), [([0.0, 1.0], false)]);
        assert_eq!(pieces(&[[0.5, 0.7], [0.2, 0.6]]), [([0.0, 0.2], false), ([0.2, 0.7], true), ([0.7, 1.0], false)]);
        assert_eq!(pieces(&[[0.0, 1.0]]), [([0.0, 1.0], true)]);
    }
}
