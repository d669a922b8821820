//! Numbers by which points are spread evenly.

/// The golden section, (√5 - 1) / 2: its multiples, without their whole parts, are spread evenly over 0 to 1.
pub const GOLDEN_SECTION: f64 = 0.618_033_988_749_894_9;

/// Returns the least number from `from` on that is coprime to `n`: its multiples, modulo `n`, visit each number below `n`
/// once. `n` is more than 0.
pub fn next_coprime(from: usize, n: usize) -> usize {
    (from..).find(|step| greatest_common_divisor(*step, n) == 1).unwrap_or(1)
}

fn greatest_common_divisor(a: usize, b: usize) -> usize {
    if b == 0 { a } else { greatest_common_divisor(b, a % b) }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn multiples_of_a_coprime_number_visit_each_number_once() {
        for (from, n) in [(1, 1), (5, 12), (7, 7), (38, 60), (100, 97)] {
            let step = next_coprime(from, n);
            let mut visited: Vec<usize> = (0..n).map(|i| i * step % n).collect();
            visited.sort_unstable();
            assert!(step >= from && visited == (0..n).collect::<Vec<_>>(), "{from} {n}: {step}");
        }
    }
}
