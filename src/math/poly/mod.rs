//! Real roots of polynomials. The arguments of the quadratic solvers start with the coefficient of the highest power.

mod bernstein;

pub use bernstein::{MAX_DEGREE, bernstein_roots, bernstein_roots_in_window, polynomial_roots_between};

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

#[cfg(test)]
mod tests {
    use super::*;

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
