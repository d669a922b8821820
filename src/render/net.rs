//! durer's own anti-aliasing: a pixel that differs from a neighbour gets samples that lie as evenly as possible; if it only differs from one
//! at a corner, it gets the latter half of them only if the first half differs too. The places are a (0,2)-sequence, of which every power of two fills all boxes of equal area once (Sobol'
//! 1967; Kollig and Keller, Efficient multidimensional sampling, 2002), turned by random bits for each pixel.

use super::antialias::{Difference, pixel as pixel_of};
use super::grid::Pixel;
use super::random::Purpose;
use super::trace::Tracer;

/// So many samples of a pixel that differs from one beside it.
const MANY: u32 = 8;
/// So many at first of one that only differs from one it shares a corner with.
const FEW: u32 = 4;

/// Why a pixel is looked at.
#[derive(Clone, Copy)]
pub(super) enum Start {
    /// It differs from one that it shares an edge with.
    Edge,
    /// From one that it only shares a corner with.
    Corner,
}

/// A place in the unit square, from its number and the bits that turn the whole sequence.
fn place(number: u32, bits: [u32; 2]) -> [f64; 2] {
    let (mut second, mut direction, mut rest) = (0, 1 << 31, number);
    while rest != 0 {
        if rest & 1 == 1 {
            second ^= direction;
        }
        // Pascal's triangle modulo two, column by column.
        direction ^= direction >> 1;
        rest >>= 1;
    }
    [number.reverse_bits() ^ bits[0], second ^ bits[1]].map(|x| (f64::from(x) + 0.5) / 4_294_967_296.0)
}

/// A pixel, of whose middle it is known how it looks.
pub(super) fn pixel(
    tracer: &mut Tracer,
    difference: &Difference,
    number: u64,
    [x, y]: [usize; 2],
    middle: &Pixel,
    start: Start,
) -> Pixel {
    let few = match start {
        Start::Edge => MANY,
        Start::Corner => FEW,
    };
    tracer.begin(number, 0);
    let random = tracer.random.of_pixel(Purpose::Place);
    let bits = [0, 1].map(|i| (random.at(i) * 4_294_967_296.0) as u32);
    let (mut sum, mut differ, mut count) = ([0.0; 4], false, 0);
    while count < few || differ && count < MANY {
        let [right, down] = place(count, bits);
        tracer.begin(number, u64::from(count) + 1);
        let seen = pixel_of(&tracer.see(x as f64 + right, y as f64 + down));
        sum.iter_mut().zip(seen).for_each(|(sum, c)| *sum += f64::from(c));
        differ |= count < few && difference.counts(&seen, middle);
        count += 1;
    }
    if !differ {
        // The middle is as good as any other place.
        sum.iter_mut().zip(middle).for_each(|(sum, c)| *sum += f64::from(*c));
        count += 1;
    }
    sum.map(|c| (c / f64::from(count)) as f32)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn powers_of_two_fill_all_boxes_of_equal_area() {
        for (columns, rows) in [(16, 1), (8, 2), (4, 4), (2, 8), (1, 16)] {
            let mut boxes = vec![0; 16];
            for number in 0..16 {
                let [x, y] = place(number, [0x1234_5678, 0x9abc_def0]);
                boxes[(y * f64::from(rows)) as usize * columns as usize + (x * f64::from(columns)) as usize] += 1;
            }
            assert_eq!(boxes, [1; 16], "{columns} by {rows}");
        }
    }
}
