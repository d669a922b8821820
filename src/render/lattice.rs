//! durer's own anti-aliasing: a pixel that differs from a neighbour gets 5 samples, and 10 if its samples differ much.
//!
//! Samples are at the points of a lattice (Sloan and Joe, Lattice Methods for Multiple Integration, 1994): the
//! multiples of (1, 3)/10 modulo 1, of which every other one is a multiple of (1, 3)/5. Both lattices are square,
//! rotated by 18° and 63°, so horizontal and vertical edges have ten and five levels. The pixel's centre, whose sample
//! is known, is one of the points. Random bits transpose and mirror the lattice of each pixel.

use super::antialias::Difference;
use super::pixel_area::Pixel;
use super::sampler::{SamplePoint, Sampler};
use crate::transport::Purpose;

/// Number of samples of a pixel that differs from a neighbour, the centre included.
const FIRST_SAMPLES: u32 = 5;
/// Number of samples of a pixel whose first samples differ.
const ALL_SAMPLES: u32 = 10;
/// Multiple of the threshold by which a pixel's first samples must differ to get more.
const LARGE_DIFFERENCE: f64 = 2.0;

/// Returns point `index` of the lattice in the unit square; point 0 is the centre. `symmetry` is one of 8, 0 to 7.
fn lattice_point(index: u32, symmetry: u32) -> [f64; 2] {
    let multiple = if index < FIRST_SAMPLES { 2 * index } else { 2 * (index - FIRST_SAMPLES) + 1 };
    let from_middle = |n: u32| f64::from((n + ALL_SAMPLES / 2) % ALL_SAMPLES) / f64::from(ALL_SAMPLES) - 0.5;
    let [x, y] = [from_middle(multiple), from_middle(3 * multiple)];
    let [x, y] = [if symmetry & 1 == 0 { x } else { -x }, if symmetry & 2 == 0 { y } else { -y }];
    if symmetry & 4 == 0 { [0.5 + x, 0.5 + y] } else { [0.5 + y, 0.5 + x] }
}

/// Computes a pixel with lattice samples; `middle` is the sample at its centre.
pub(super) fn pixel(
    sampler: &mut Sampler,
    difference: &Difference,
    pixel_key: u64,
    [x, y]: [usize; 2],
    middle: &Pixel,
) -> Pixel {
    let symmetry = (sampler.random().pixel_sequence(pixel_key, Purpose::PixelPosition).at(0) * 8.0) as u32;
    let point = |number: u32| {
        let [right, down] = lattice_point(number, symmetry);
        let (x_pixels, y_pixels) = (x as f64 + right, y as f64 + down);
        SamplePoint { x_pixels, y_pixels, pixel: pixel_key, sample: u64::from(number) }
    };
    let (mut sum, mut differ, mut count) = (middle.map(f64::from), false, FIRST_SAMPLES);
    let add =
        |sum: &mut [f64; 4], sample: &Pixel| sum.iter_mut().zip(sample).for_each(|(sum, c)| *sum += f64::from(*c));
    sampler.samples_at((1..FIRST_SAMPLES).map(point), |_, sample| {
        add(&mut sum, &sample);
        differ |= difference.reaches_threshold_times(&sample, middle, LARGE_DIFFERENCE);
    });
    if differ {
        sampler.samples_at((FIRST_SAMPLES..ALL_SAMPLES).map(point), |_, sample| add(&mut sum, &sample));
        count = ALL_SAMPLES;
    }
    sum.map(|c| (c / f64::from(count)) as f32)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rows_and_columns_are_evenly_filled() {
        for symmetry in 0..8 {
            assert_eq!(lattice_point(0, symmetry), [0.5, 0.5]);
            for (indices, many) in [(0..FIRST_SAMPLES, FIRST_SAMPLES), (0..ALL_SAMPLES, ALL_SAMPLES)] {
                let mut found: Vec<[f64; 2]> = indices.map(|index| lattice_point(index, symmetry)).collect();
                for axis in [0, 1] {
                    found.sort_by(|a, b| a[axis].total_cmp(&b[axis]));
                    let apart = |pair: &[[f64; 2]]| (pair[1][axis] - pair[0][axis]) * f64::from(many);
                    assert!(found.windows(2).all(|pair| (apart(pair) - 1.0).abs() < 1e-12), "{symmetry} {many}");
                    assert!(found.iter().all(|point| (0.0..=1.0).contains(&point[axis])));
                }
            }
        }
    }
}
