//! durer's own anti-aliasing: of a pixel that differs from one around it, five places are looked at, and five more if those differ.
//!
//! The places are lattices (Sloan and Joe, Lattice Methods for Multiple Integration, 1994): the multiples of (1, 3)/10, of which every other
//! one is a multiple of (1, 3)/5, modulo 1. Both are square, turned by 18° and 63°, so that edges across and down see ten and five steps;
//! and the pixel's middle, which is known, is one of them. Each pixel has them turned or mirrored by random bits.

use super::antialias::{Difference, pixel as pixel_of};
use super::grid::Pixel;
use super::random::Purpose;
use super::trace::Tracer;

/// So many places of a pixel are looked at first, its middle included.
const FEW: u32 = 5;
/// And so many if those differ.
const MANY: u32 = 10;
/// By so many thresholds.
const FAR: f64 = 2.0;

/// A place in the unit square, from its number, of which 0 is the middle, and bits that turn and mirror all.
fn place(number: u32, bits: u32) -> [f64; 2] {
    let multiple = if number < FEW { 2 * number } else { 2 * (number - FEW) + 1 };
    let from_middle = |n: u32| f64::from((n + MANY / 2) % MANY) / f64::from(MANY) - 0.5;
    let [x, y] = [from_middle(multiple), from_middle(3 * multiple)];
    let [x, y] = [if bits & 1 == 0 { x } else { -x }, if bits & 2 == 0 { y } else { -y }];
    if bits & 4 == 0 { [0.5 + x, 0.5 + y] } else { [0.5 + y, 0.5 + x] }
}

/// A pixel, of whose middle it is known how it looks.
pub(super) fn pixel(
    tracer: &mut Tracer,
    difference: &Difference,
    number: u64,
    [x, y]: [usize; 2],
    middle: &Pixel,
) -> Pixel {
    tracer.begin(number, 0);
    let bits = (tracer.random.of_pixel(Purpose::Place).at(0) * 8.0) as u32;
    let (mut sum, mut differ, mut count) = (middle.map(f64::from), false, 1);
    while count < FEW || differ && count < MANY {
        let [right, down] = place(count, bits);
        tracer.begin(number, u64::from(count));
        let seen = pixel_of(&tracer.see(x as f64 + right, y as f64 + down));
        sum.iter_mut().zip(seen).for_each(|(sum, c)| *sum += f64::from(c));
        differ |= count < FEW && difference.exceeds(&seen, middle, FAR);
        count += 1;
    }
    sum.map(|c| (c / f64::from(count)) as f32)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rows_and_columns_are_evenly_filled() {
        for bits in 0..8 {
            assert_eq!(place(0, bits), [0.5, 0.5]);
            for (places, many) in [(0..FEW, FEW), (0..MANY, MANY)] {
                let mut found: Vec<[f64; 2]> = places.map(|number| place(number, bits)).collect();
                for axis in [0, 1] {
                    found.sort_by(|a, b| a[axis].total_cmp(&b[axis]));
                    let apart = |pair: &[[f64; 2]]| (pair[1][axis] - pair[0][axis]) * f64::from(many);
                    assert!(found.windows(2).all(|pair| (apart(pair) - 1.0).abs() < 1e-12), "{bits} {many}");
                    assert!(found.iter().all(|place| (0.0..=1.0).contains(&place[axis])));
                }
            }
        }
    }
}
