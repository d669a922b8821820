//! Real roots of polynomials. The arguments of the quadratic solvers start with the coefficient of the highest power.

mod bernstein;

pub use bernstein::{MAX_DEGREE, bernstein_roots, bernstein_roots_in_window, polynomial_roots_between};

use super::Lanes;

/// Real roots of a·x² + b·x + c, ascending, by the stable pair (lecture, "Solving ax²+bx+c=0"). With a = 0 the line's
/// root is one of them and the other is infinite; `None` if there is no real root.
pub fn solve_quadratic(a: f64, b: f64, c: f64) -> Option<(f64, f64)> {
    let half_b = 0.5 * b;
    solve_quadratic_with_discriminant(a, half_b, c, half_b * half_b - a * c)
}

/// Real roots of a·x² + 2·half_b·x + c, ascending, for a caller that has an accurate `quarter_disc`, half_b² - a·c;
/// `None` if there is no real root. That difference of nearly equal numbers is the source of inaccurate roots, and
/// geometry often has it as a product or a distance.
pub fn solve_quadratic_with_discriminant(a: f64, half_b: f64, c: f64, quarter_disc: f64) -> Option<(f64, f64)> {
    if quarter_disc < 0.0 || (a == 0.0 && half_b == 0.0) {
        return None;
    }
    // q = -(b/2 ± √(D/4)) with the sign that adds two numbers of one sign; one root is q/a, the other (Vieta) c/q.
    let q = -(half_b + quarter_disc.sqrt().copysign(half_b));
    let (x1, x2) = if q == 0.0 { (0.0, 0.0) } else { (q / a, c / q) };
    Some((x1.min(x2), x1.max(x2)))
}

/// Returns the roots that [`solve_quadratic_with_discriminant`] returns, the lesser ones first, for several equations that have
/// roots.
#[inline(always)]
pub fn quadratic_roots_of_lanes<const N: usize>(
    a: Lanes<N>,
    half_b: Lanes<N>,
    c: Lanes<N>,
    quarter_disc: Lanes<N>,
) -> [Lanes<N>; 2] {
    let zero = Lanes::splat(0.0);
    let q = -(half_b + quarter_disc.sqrt().copysign(half_b));
    let is_zero = q.equals(zero);
    let (x1, x2) = (is_zero.select(zero, q / a), is_zero.select(zero, c / q));
    [x1.min(x2), x1.max(x2)]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn roots_in_lanes_have_the_bits_of_single_ones() {
        let numbers = [0.0, -0.0, 1.0, -3.0, 1e-9, 7.5, -1e12, 0.25];
        for shift in 0..64 {
            let pick = |step: usize| Lanes::<8>(std::array::from_fn(|i| numbers[(i * step + shift) % 8]));
            let (a, half_b, c) = (pick(1), pick(3), Lanes(numbers.map(|x| x - 1.0)));
            let discriminant = half_b * half_b - a * c;
            let [low, high] = quadratic_roots_of_lanes(a, half_b, c, discriminant);
            for i in 0..8 {
                let alone = solve_quadratic_with_discriminant(a.0[i], half_b.0[i], c.0[i], discriminant.0[i]);
                let Some((t1, t2)) = alone else { continue };
                assert!(
                    [(low.0[i], t1), (high.0[i], t2)].iter().all(|(a, b)| a == b || a.is_nan() && b.is_nan()),
                    "{i}"
                );
            }
        }
    }

    #[test]
    fn quadratic_keeps_both_roots() {
        // x² - (10⁸ + 10⁻⁸)·x + 1: the naive formula gives 7.45e-9 for the small root.
        assert_eq!(solve_quadratic(1.0, -(1e8 + 1e-8), 1.0), Some((1e-8, 1e8)));
        let (x1, x2) = solve_quadratic(-1.0, -1e8, -1.0).unwrap();
        assert!((x1 + 1e8).abs() < 1e-7 && (x2 + 1e-8).abs() < 1e-22, "{x1} {x2}");
    }

    #[test]
    fn quadratic_without_square() {
        let (x1, x2) = solve_quadratic(0.0, 2.0, -6.0).unwrap();
        assert!(x1 == 3.0 || x2 == 3.0);
        let (x1, x2) = solve_quadratic(1e-300, 2.0, -6.0).unwrap();
        assert!(x1 == 3.0 || x2 == 3.0);
        assert_eq!(solve_quadratic(0.0, 0.0, 1.0), None);
        assert_eq!(solve_quadratic(1.0, 0.0, 1.0), None);
        assert_eq!(solve_quadratic(1.0, 0.0, 0.0), Some((0.0, 0.0)));
    }
}
