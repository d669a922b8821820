//! Filters of the rows of a PNG file: PNG specification, third edition, sections 9 and 12.7.

/// Number of bytes that are summed in 32 bits.
const SUM_BLOCK: usize = 64;

/// Filters the rows of a PNG file. The filter of each row is that with the smallest sum of absolute differences.
pub(super) struct RowFilter {
    /// Bytes from a sample to the same sample of the next pixel.
    pixel_bytes: usize,
    /// Number of the best filter of the row, and the filtered samples.
    best: Vec<u8>,
    /// Number of another filter, and the samples that it filtered.
    trial: Vec<u8>,
}

impl RowFilter {
    /// Creates the filter of rows of `row_bytes` bytes, whose pixels take `pixel_bytes` bytes each.
    pub fn new(row_bytes: usize, pixel_bytes: usize) -> Self {
        Self { pixel_bytes, best: vec![0; row_bytes + 1], trial: vec![0; row_bytes + 1] }
    }

    /// Returns the number of the best filter of a row, followed by the filtered samples. `above` is the previous row, and
    /// zero for the first one.
    pub fn filter(&mut self, row: &[u8], above: &[u8]) -> &[u8] {
        // The last of equal sums counts, and a sum of 0 ends the search.
        let filters = [(2, filter_up as Filter), (1, filter_sub), (3, filter_average), (4, filter_paeth)];
        let mut smallest = u64::MAX;
        for (number, filter) in filters {
            self.trial[0] = number;
            filter(row, above, self.pixel_bytes, &mut self.trial[1..]);
            let sum = sum_of_magnitudes(&self.trial[1..]);
            if sum <= smallest {
                smallest = sum;
                std::mem::swap(&mut self.best, &mut self.trial);
            }
            if sum == 0 {
                break;
            }
        }
        &self.best
    }
}

/// Writes the differences of a row from a prediction to the last argument. The arguments before it are the row, the row
/// above and the number of bytes per pixel.
type Filter = fn(&[u8], &[u8], usize, &mut [u8]);

/// Predicts a sample by the sample above.
fn filter_up(row: &[u8], above: &[u8], _: usize, out: &mut [u8]) {
    for ((out, x), b) in out.iter_mut().zip(row).zip(above) {
        *out = x.wrapping_sub(*b);
    }
}

/// Predicts a sample by the sample to the left.
fn filter_sub(row: &[u8], _: &[u8], pixel: usize, out: &mut [u8]) {
    out[..pixel].copy_from_slice(&row[..pixel]);
    for ((out, x), a) in out[pixel..].iter_mut().zip(&row[pixel..]).zip(row) {
        *out = x.wrapping_sub(*a);
    }
}

/// Predicts a sample by the mean of the samples to the left and above, rounded down.
fn filter_average(row: &[u8], above: &[u8], pixel: usize, out: &mut [u8]) {
    for ((out, x), b) in out[..pixel].iter_mut().zip(row).zip(above) {
        *out = x.wrapping_sub(b / 2);
    }
    for (((out, x), a), b) in out[pixel..].iter_mut().zip(&row[pixel..]).zip(row).zip(&above[pixel..]) {
        // Half of the sum, without its ninth bit
        *out = x.wrapping_sub((a & b) + ((a ^ b) >> 1));
    }
}

/// Predicts a sample by the sample to the left, above or above to the left, by A. Paeth's choice.
fn filter_paeth(row: &[u8], above: &[u8], pixel: usize, out: &mut [u8]) {
    for ((out, x), b) in out[..pixel].iter_mut().zip(row).zip(above) {
        *out = x.wrapping_sub(paeth(0, *b, 0));
    }
    let samples = out[pixel..].iter_mut().zip(&row[pixel..]).zip(row).zip(&above[pixel..]).zip(above);
    for ((((out, x), a), b), c) in samples {
        *out = x.wrapping_sub(paeth(*a, *b, *c));
    }
}

/// Returns that of the samples to the left (`a`), above (`b`) and above to the left (`c`) which is nearest to `a + b - c`;
/// of equally near ones the first.
#[inline]
fn paeth(a: u8, b: u8, c: u8) -> u8 {
    let [wide_a, wide_b, wide_c] = [a, b, c].map(i16::from);
    let (from_a, from_b) = (wide_b - wide_c, wide_a - wide_c);
    let (near_a, near_b, near_c) = (from_a.abs(), from_b.abs(), (from_a + from_b).abs());
    let b_or_c = if near_b <= near_c { b } else { c };
    if near_a <= near_b && near_a <= near_c { a } else { b_or_c }
}

/// Returns the sum of the magnitudes of bytes as signed numbers.
fn sum_of_magnitudes(bytes: &[u8]) -> u64 {
    let block_sum = |block: &[u8]| block.iter().map(|&x| u32::from((x as i8).unsigned_abs())).sum::<u32>();
    let blocks = bytes.chunks_exact(SUM_BLOCK);
    let rest = block_sum(blocks.remainder());
    u64::from(rest) + blocks.map(|block| u64::from(block_sum(block))).sum::<u64>()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Predicts a sample from the samples to the left, above and above to the left.
    type Prediction = fn(i32, i32, i32) -> i32;

    /// Test: a row that a filter predicts exactly gets that filter, and all its samples but those of the first pixel
    /// become zero.
    #[test]
    fn the_best_filter_wins() {
        // By the definitions of the specification; `a` is to the left, `b` above and `c` above to the left.
        let predictions: [(u8, Prediction); 4] = [
            (1, |a, _, _| a),
            (2, |_, b, _| b),
            (3, |a, b, _| (a + b) / 2),
            (4, |a, b, c| {
                let near = |x: i32| (a + b - c - x).abs();
                [a, b, c].into_iter().min_by_key(|x| near(*x)).unwrap()
            }),
        ];
        for pixel_bytes in [1, 2, 3, 4, 6, 8] {
            let row_bytes = 97 * pixel_bytes;
            let above: Vec<u8> = (0..row_bytes as u32).map(|i| (i.wrapping_mul(2_654_435_761) >> 24) as u8).collect();
            for (number, prediction) in predictions {
                // Rows that are equal would suit several filters.
                let first = if number == 2 { 0 } else { 100 };
                let mut row: Vec<u8> = above[..pixel_bytes].iter().map(|x| x.wrapping_add(first)).collect();
                for i in pixel_bytes..row_bytes {
                    let [a, b, c] = [row[i - pixel_bytes], above[i], above[i - pixel_bytes]].map(i32::from);
                    row.push(prediction(a, b, c) as u8);
                }
                let mut filter = RowFilter::new(row_bytes, pixel_bytes);
                let filtered = filter.filter(&row, &above);
                assert_eq!(filtered[0], number, "{pixel_bytes}");
                assert!(filtered[1 + pixel_bytes..].iter().all(|x| *x == 0), "{number} {pixel_bytes}");
            }
        }
    }

    #[test]
    fn magnitudes_are_of_signed_bytes() {
        let bytes: Vec<u8> = (0..=255).collect();
        assert_eq!(sum_of_magnitudes(&bytes), 128 * 127 + 128);
        assert_eq!(sum_of_magnitudes(&bytes[..200]), (0..128).sum::<u64>() + (57..=128).sum::<u64>());
    }
}
