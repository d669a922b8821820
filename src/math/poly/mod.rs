//! Real roots of polynomials. Coefficients start with that of the highest power.

mod bernstein;

pub use bernstein::{MAX_DEGREE, bernstein_roots, roots_on_line};
use smallvec::SmallVec;

/// Real roots of a polynomial, ascending; a double root counts twice.
pub type Roots = SmallVec<[f64; 4]>;

/// Real roots of a·x² + b·x + c, ascending, by the stable pair (lecture, "Solving ax²+bx+c=0"). With a = 0 the line's
/// root is one of them and the other is infinite; `None` if there is no real root.
pub fn solve_quadratic(a: f64, b: f64, c: f64) -> Option<(f64, f64)> {
    let half_b = 0.5 * b;
    solve_quadratic_with_discriminant(a, half_b, c, half_b * half_b - a * c)
}

/// Real roots of a·x² + 2·half_b·x + c, ascending, for a caller that has an accurate half_b² - a·c: that difference of
/// nearly equal numbers is the source of inaccurate roots, and geometry often has it as a product or a distance.
pub fn solve_quadratic_with_discriminant(a: f64, half_b: f64, c: f64, quarter_disc: f64) -> Option<(f64, f64)> {
    if quarter_disc < 0.0 || (a == 0.0 && half_b == 0.0) {
        return None;
    }
    // q = -(b/2 ± √(D/4)) with the sign that adds two numbers of one sign; one root is q/a, the other (Vieta) c/q.
    let q = -(half_b + quarter_disc.sqrt().copysign(half_b));
    let (x1, x2) = if q == 0.0 { (0.0, 0.0) } else { (q / a, c / q) };
    Some((x1.min(x2), x1.max(x2)))
}

/// Real roots of c₀·x³ + c₁·x² + c₂·x + c₃.
pub fn solve_cubic(c: [f64; 4]) -> Roots {
    let mut out = Roots::new();
    solve_polynomial(&c, &mut out);
    out
}

/// Real roots of c₀·x⁴ + … + c₄.
pub fn solve_quartic(c: [f64; 5]) -> Roots {
    let mut out = Roots::new();
    solve_polynomial(&c, &mut out);
    out
}

/// Real roots of a polynomial of any degree between `lo` and `hi`.
///
/// Between two neighbouring roots of its derivative a polynomial is monotone, so it has at most one root there, and a
/// change of sign decides: the derivative's roots (found recursively) split the line into brackets, and in each bracket
/// Newton's step, guarded by bisection, can't fail. Where the polynomial touches zero without crossing it, to rounding,
/// the derivative's root is a double root.
pub fn solve_polynomial_between(c: &[f64], lo: f64, hi: f64, out: &mut Roots) {
    match c {
        [] | [_] => {}
        [0.0, rest @ ..] => solve_polynomial_between(rest, lo, hi, out),
        &[a, b] => out.extend(Some(-b / a).filter(|x| (lo..=hi).contains(x))),
        &[a, b, c] => {
            let (x1, x2) = match solve_quadratic(a, b, c) {
                Some(pair) => pair,
                // Touches zero to rounding: the apex is a double root.
                None if is_zero_to_rounding(&[a, b, c], -b / (2.0 * a)) => (-b / (2.0 * a), -b / (2.0 * a)),
                None => return,
            };
            out.extend([x1, x2].into_iter().filter(|x| (lo..=hi).contains(x)));
        }
        // A last coefficient of 0 is a root at 0, which no relative tolerance would find.
        [rest @ .., 0.0] => {
            solve_polynomial_between(rest, lo, hi, out);
            if (lo..=hi).contains(&0.0) {
                out.insert(out.partition_point(|x| *x < 0.0), 0.0);
            }
        }
        _ => solve_by_derivative(c, lo, hi, out),
    }
}

/// Finds all real roots of a polynomial, within the bound on their size.
fn solve_polynomial(c: &[f64], out: &mut Roots) {
    match c {
        [] | [_] => {}
        [lead, rest @ ..] => {
            let bound = root_bound(*lead, rest);
            // A leading coefficient so small that its root is out of range is dropped.
            if bound.is_finite() {
                solve_polynomial_between(c, -bound, bound, out)
            } else {
                solve_polynomial(rest, out)
            }
        }
    }
}

/// Fujiwara's bound (1916) on the size of a polynomial's roots: no root is larger than 2·max |cₖ/c₀|^(1/k).
fn root_bound(lead: f64, rest: &[f64]) -> f64 {
    let size = |(k, c): (usize, &f64)| crate::math::fp::pow((c / lead).abs(), 1.0 / (k + 1) as f64);
    2.02 * rest.iter().enumerate().map(size).fold(1e-60, f64::max)
}

fn solve_by_derivative(c: &[f64], lo: f64, hi: f64, out: &mut Roots) {
    let degree = c.len() - 1;
    // p'(x)
    let derivative: SmallVec<[f64; 8]> = c[..degree].iter().enumerate().map(|(i, c)| c * (degree - i) as f64).collect();
    let mut nodes = Roots::new();
    solve_polynomial_between(&derivative, lo, hi, &mut nodes);
    nodes.push(hi);
    // The last position with a known sign, and the positions since then where p is zero to rounding.
    let (mut at, mut sign) = (lo, evaluate_polynomial(c, lo).signum());
    let mut zeros: Roots = Roots::new();
    if evaluate_polynomial(c, lo) == 0.0 {
        out.push(lo);
    }
    for x in nodes {
        if x < hi && is_zero_to_rounding(c, x) {
            zeros.push(x);
            continue;
        }
        let here = evaluate_polynomial(c, x).signum();
        match (zeros.is_empty(), here != sign) {
            (true, true) => out.push(bracketed_root(c, at, x)),
            (true, false) => {}
            // One cluster: crossed an odd number of times, or touched.
            (false, crossed) => {
                let root = zeros[zeros.len() / 2];
                out.extend(std::iter::repeat_n(root, if crossed { 1 } else { 2 }));
            }
        }
        zeros.clear();
        (at, sign) = (x, here);
    }
}

/// Evaluates the polynomial p(x) by Horner's rule.
fn evaluate_polynomial(c: &[f64], x: f64) -> f64 {
    c.iter().fold(0.0, |sum, c| sum * x + c)
}

/// True if the polynomial p(x) is zero to rounding: small against the sum of the absolute values of its terms.
fn is_zero_to_rounding(c: &[f64], x: f64) -> bool {
    let (sum, sizes) = c.iter().fold((0.0, 0.0), |(sum, sizes), c| (sum * x + c, sizes * x.abs() + c.abs()));
    f64::abs(sum) <= crate::math::tolerance::POLYNOMIAL * sizes
}

/// Returns the root between two positions where the polynomial p has different signs: Newton's step where it stays in
/// the bracket and halves it fast enough, bisection otherwise (Press et al., Numerical Recipes, "rtsafe").
fn bracketed_root(c: &[f64], a: f64, b: f64) -> f64 {
    // `neg` and `pos`: the ends where p is negative and where it is not.
    let (mut neg, mut pos) = if evaluate_polynomial(c, a) < 0.0 { (a, b) } else { (b, a) };
    let mut x = 0.5 * (a + b);
    let mut last_step = (b - a).abs();
    for _ in 0..200 {
        let (f, slope) = c.iter().fold((0.0, 0.0), |(f, slope), c| (f * x + c, slope * x + f));
        if f < 0.0 {
            neg = x
        } else {
            pos = x
        }
        let newton = x - f / slope;
        let inside = (newton - neg) * (newton - pos) <= 0.0;
        let next = if inside && (newton - x).abs() <= 0.5 * last_step { newton } else { 0.5 * (neg + pos) };
        last_step = (next - x).abs();
        if last_step <= f64::EPSILON * (x.abs() + 1e-8 * (b - a)) {
            return next;
        }
        x = next;
    }
    x
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::fp;
    use proptest::prelude::*;

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

    #[test]
    fn special_quartics() {
        assert_eq!(solve_quartic([1.0, 0.0, -2.0, 0.0, 1.0]).as_slice(), [-1.0, -1.0, 1.0, 1.0]);
        assert_eq!(solve_quartic([1.0, 0.0, 0.0, 0.0, 1.0]).as_slice(), [0.0; 0]);
        assert_eq!(solve_quartic([0.0, 0.0, 0.0, 2.0, -1.0]).as_slice(), [0.5]);
        assert_eq!(solve_quartic([0.0; 5]).as_slice(), [0.0; 0]);
        assert!(solve_quartic([3.0, 0.0, 0.0, 0.0, 0.0]).iter().all(|x| x.abs() < 1e-15));
        assert_eq!(solve_quartic([1.0, -8.25, -9.25, 0.0, 0.0]).as_slice(), [-1.0, 0.0, 0.0, 9.25]);
        assert_eq!(solve_cubic([1.0, 0.0, 0.0, -8.0]).as_slice(), [2.0]);
        assert_eq!(solve_cubic([1e-320, 0.0, 1.0, -8.0]).as_slice(), [8.0]);
    }

    /// The coefficients of s·∏(x - rᵢ).
    fn from_roots(scale: f64, roots: &[f64]) -> Vec<f64> {
        roots.iter().fold(vec![scale], |c, r| {
            let mut next = c.clone();
            next.push(0.0);
            for (i, c) in c.iter().enumerate() {
                next[i + 1] -= c * r;
            }
            next
        })
    }

    fn root() -> impl Strategy<Value = f64> {
        // Multiples of 1/4, so that coefficients are exact and equal roots are frequent.
        (-40i32..40).prop_map(|k| f64::from(k) / 4.0)
    }

    proptest! {
        #[test]
        fn quartic_finds_its_roots(roots in proptest::array::uniform4(root()), scale in 0.01..100.0f64) {
            let mut roots = roots;
            roots.sort_by(f64::total_cmp);
            let scale = fp::exp2(scale).round();
            let c = from_roots(scale, &roots);
            let found = solve_quartic([c[0], c[1], c[2], c[3], c[4]]);
            // A root of multiplicity m is accurate to the m-th root of rounding.
            for r in roots {
                let m = roots.iter().filter(|x| **x == r).count() as i32;
                let tol = [1e-9, 2e-6, 3e-4, 3e-3][m as usize - 1];
                prop_assert!(found.iter().any(|x| (x - r).abs() < tol), "{r} of {roots:?} not in {found:?}");
            }
            for x in &found {
                prop_assert!(roots.iter().any(|r| (x - r).abs() < 3e-3), "{x} is not in {roots:?}");
            }
            prop_assert!(found.len().is_multiple_of(2), "{found:?} for {roots:?}");
            prop_assert!(found.is_sorted());
        }

        #[test]
        fn cubic_finds_its_roots(roots in proptest::array::uniform3(root()), lead in prop_oneof![Just(1.0), Just(-8.0)]) {
            let c = from_roots(lead, &roots);
            let found = solve_cubic([c[0], c[1], c[2], c[3]]);
            for r in roots {
                let m = roots.iter().filter(|x| **x == r).count() as i32;
                let tol = [1e-10, 1e-6, 1e-4][m as usize - 1];
                prop_assert!(found.iter().any(|x| (x - r).abs() < tol), "{r} of {roots:?} not in {found:?}");
            }
            prop_assert!(found.len() % 2 == 1);
        }

        #[test]
        fn complex_pairs_are_not_found(r in -5.0..5.0f64, re in -5.0..5.0f64, im in 0.1..5.0f64, s in 0.1..3.0f64) {
            // (x - r)(x - r - s)((x - re)² + im²)
            let pair = [1.0, -2.0 * re, re * re + im * im];
            let real = from_roots(1.0, &[r, r + s]);
            let mut c = [0.0; 5];
            for (i, a) in real.iter().enumerate() {
                for (j, b) in pair.iter().enumerate() {
                    c[i + j] += a * b;
                }
            }
            let found = solve_quartic(c);
            prop_assert_eq!(found.len(), 2);
            prop_assert!((found[0] - r).abs() < 1e-8 && (found[1] - r - s).abs() < 1e-8);
        }
    }
}
