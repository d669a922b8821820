//! Division of a stretch of a ray in media into intervals (manual, "Sampling Parameters & Methods"; quirk:
//! `media_intervals`).

use super::media::MediaStretch;
use crate::medium::MediaSampling;
use crate::world::LightSource;
use smallvec::SmallVec;

/// A light that a medium scatters, and where on a ray the light shines.
pub(super) struct BeamOnRay<'w> {
    pub light: &'w LightSource,
    /// Stretches of the ray within the light's beam; `None` for a light that shines in all directions.
    pub stretches: Option<SmallVec<[[f64; 2]; 2]>>,
}

impl BeamOnRay<'_> {
    /// True if the light shines on a part of the interval.
    pub fn reaches(&self, [from, to]: [f64; 2]) -> bool {
        let slack = 1e-6 * (to - from);
        let overlaps = |[start, end]: &[f64; 2]| *start < to - slack && *end > from + slack;
        self.stretches.as_ref().is_none_or(|stretches| stretches.iter().any(overlaps))
    }

    /// True if the light shines at the distance `t`.
    pub fn shines_at(&self, t: f64) -> bool {
        let contains = |[start, end]: &[f64; 2]| (*start..=*end).contains(&t);
        self.stretches.as_ref().is_none_or(|stretches| stretches.iter().any(contains))
    }
}

/// Divides a stretch into intervals. If only spotlights and cylinder lights illuminate media, their beams divide the
/// stretch first, and `ratio` distributes the intervals. A medium without densities has one interval where no light
/// shines (quirk: `media_intervals`).
pub(super) fn media_intervals(
    stretch: &MediaStretch,
    beams: &[BeamOnRay],
    sampling: &MediaSampling,
) -> SmallVec<[[f64; 2]; 8]> {
    let is_all_lit = beams.iter().any(|beam| beam.stretches.is_none());
    let intervals = sampling.intervals as usize;
    if is_all_lit || beams.iter().all(|beam| beam.stretches.as_ref().is_none_or(|stretches| stretches.is_empty())) {
        let is_uniform = !is_all_lit && stretch.media[stretch.leading_medium_index()].is_homogeneous();
        return equal_parts(stretch.range, if is_uniform { 1 } else { intervals.max(1) }).collect();
    }
    let lit: SmallVec<[[f64; 2]; 8]> = beams.iter().flat_map(|beam| beam.stretches.iter().flatten().copied()).collect();
    let pieces = lit_and_unlit_pieces(lit, stretch.range);
    let counts = interval_counts(
        &pieces.iter().map(|(_, lit)| *lit).collect::<SmallVec<[bool; 8]>>(),
        intervals,
        sampling.ratio,
    );
    pieces.iter().zip(counts).flat_map(|((piece, _), count)| equal_parts(*piece, count)).collect()
}

/// Divides a range of distances into a number of equal parts.
fn equal_parts([from, to]: [f64; 2], count: usize) -> impl Iterator<Item = [f64; 2]> {
    let at = move |i: usize| from + (to - from) * (i as f64 / count as f64);
    (0..count).map(move |i| [at(i), at(i + 1)])
}

/// Pieces of a range; true marks those that are lit.
type Pieces = SmallVec<[([f64; 2], bool); 8]>;

/// Divides a range at the ends of the lit stretches; overlapping stretches are united. Each piece states whether it is
/// lit.
fn lit_and_unlit_pieces(mut lit: SmallVec<[[f64; 2]; 8]>, [from, to]: [f64; 2]) -> Pieces {
    lit.sort_by(|a, b| a[0].total_cmp(&b[0]));
    let mut pieces = Pieces::new();
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
fn interval_counts(lit: &[bool], intervals: usize, ratio: f64) -> SmallVec<[usize; 8]> {
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
            assert_eq!(interval_counts(&one, intervals, ratio)[..], counts, "{intervals} {ratio}");
        }
        assert_eq!(interval_counts(&[false, true, false, true, false], 10, 0.9)[..], [1, 5, 1, 2, 1]);
    }

    #[test]
    fn beams_divide_a_stretch() {
        let pieces = |lit: &[[f64; 2]]| lit_and_unlit_pieces(lit.into(), [0.0, 1.0]);
        assert_eq!(pieces(&[])[..], [([0.0, 1.0], false)]);
        assert_eq!(
            pieces(&[[0.5, 0.7], [0.2, 0.6]])[..],
            [([0.0, 0.2], false), ([0.2, 0.7], true), ([0.7, 1.0], false)]
        );
        assert_eq!(pieces(&[[0.0, 1.0]])[..], [([0.0, 1.0], true)]);
    }
}
