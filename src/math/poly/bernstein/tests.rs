//! Tests of the roots of polynomials.

use super::*;

/// Real roots of a polynomial, ascending; a double root counts twice.
type Roots = Vec<f64>;
use proptest::prelude::*;

/// The coefficients of s·∏(x - rᵢ), lowest first.
fn from_roots(scale: f64, roots: &[f64]) -> Vec<f64> {
    roots.iter().fold(vec![scale], |c, r| {
        let mut next = vec![0.0; c.len() + 1];
        for (i, c) in c.iter().enumerate() {
            next[i + 1] += c;
            next[i] -= c * r;
        }
        next
    })
}

/// All roots as a list.
fn all_on_line(c: &[f64], lo: f64, hi: f64) -> Roots {
    let mut all = Roots::new();
    polynomial_roots_between(c, lo, hi, &mut |x| {
        all.push(x);
        false
    });
    all
}

fn everywhere(c: &[f64]) -> Roots {
    all_on_line(c, f64::NEG_INFINITY, f64::INFINITY)
}

#[test]
fn special_ones() {
    assert_eq!(everywhere(&[0.0; 9]).as_slice(), [0.0; 0]);
    assert_eq!(everywhere(&[7.0, 0.0]).as_slice(), [0.0; 0]);
    assert_eq!(everywhere(&[-6.0, 2.0, 0.0]).as_slice(), [3.0]);
    let close = |found: Roots, want: &[f64]| {
        let same = found.iter().zip(want).all(|(x, w)| (x - w).abs() < 1e-14);
        assert!(found.len() == want.len() && same, "{found:?}");
    };
    close(everywhere(&[-8.0, 0.0, 0.0, 1.0]), &[2.0]);
    assert_eq!(everywhere(&[1.0, 0.0, 0.0, 0.0, 1.0]).as_slice(), [0.0; 0]);
    assert!(everywhere(&[0.0, 0.0, 0.0, 5.0]).iter().all(|x| x.abs() < 1e-15), "three in one place");
    close(everywhere(&from_roots(-3.0, &[-1.0, 0.0, 1.0])), &[-1.0, 0.0, 1.0]);
    let touched = everywhere(&from_roots(-1.0, &[-1.0, -1.0, 1.0, 1.0]));
    assert!(touched.len().is_multiple_of(2) && touched.iter().all(|x| (x.abs() - 1.0).abs() < 1e-6), "{touched:?}");
}

#[test]
fn tiny_and_huge_coefficients() {
    let roots = [0.25, 0.5, 0.8];
    for exponent in [-980, -600, -400, 0, 400, 600, 980] {
        let found = everywhere(&from_roots(power_of_two(exponent), &roots));
        let is_close = |(x, root): (&f64, f64)| (x - root).abs() < 1e-14;
        assert!(found.len() == 3 && found.iter().zip(roots).all(is_close), "{exponent}: {found:?}");
    }
}

#[test]
fn window_and_end() {
    let c = from_roots(1.0, &[-3.0, -0.5, 0.25, 2.0, 9.0]);
    let close = |found: &Roots, want: &[f64]| {
        assert!(
            found.len() == want.len() && found.iter().zip(want).all(|(x, w)| (x - w).abs() < 1e-13 * w.abs()),
            "{found:?}"
        );
    };
    close(&everywhere(&c), &[-3.0, -0.5, 0.25, 2.0, 9.0]);
    close(&all_on_line(&c, -1.0, 3.0), &[-0.5, 0.25, 2.0]);
    close(&all_on_line(&c, 3.0, f64::INFINITY), &[9.0]);
    let mut first = Roots::new();
    polynomial_roots_between(&c, 0.0, 20.0, &mut |x| {
        first.push(x);
        true
    });
    // The same number as among all roots.
    assert_eq!(first.as_slice(), &everywhere(&c)[2..3]);
}

/// All roots in [0, 1] that the search reports for a window.
fn in_window(b: &[f64], window: (f64, f64)) -> Roots {
    let mut all = Roots::new();
    bernstein_roots_in_window(b, window, &mut |t| {
        all.push(t);
        false
    });
    all
}

#[test]
fn single_root_outside_the_window_is_not_computed() {
    let cubic = [-1.0, -0.5, 0.5, 1.0];
    assert_eq!(in_window(&cubic, (0.0, 1.0)).len(), 1);
    assert_eq!(in_window(&cubic, (0.6, 0.9)).as_slice(), [0.0; 0]);
    assert_eq!(in_window(&cubic, (0.1, 0.4)).as_slice(), [0.0; 0]);
    assert_eq!(in_window(&cubic, (0.5, 0.9)).as_slice(), [0.5]);
    assert_eq!(in_window(&cubic, (0.1, 0.5)).as_slice(), [0.5]);
}

#[test]
fn of_degree_35() {
    // Chebyshev's polynomial: 35 roots cos((k - ½)π/35), between which it oscillates from -1 to 1.
    let (mut before, mut c) = (vec![1.0], vec![0.0, 1.0]);
    for _ in 1..35 {
        let mut next = vec![0.0; c.len() + 1];
        c.iter().enumerate().for_each(|(i, c)| next[i + 1] += 2.0 * c);
        before.iter().enumerate().for_each(|(i, c)| next[i] -= c);
        before = std::mem::replace(&mut c, next);
    }
    let found = everywhere(&c);
    assert_eq!(found.len(), 35);
    for (k, x) in found.iter().rev().enumerate() {
        let want = crate::math::fp::cos((k as f64 + 0.5) * std::f64::consts::PI / 35.0);
        assert!((x - want).abs() < 1e-4, "{x} {want}");
    }
}

proptest! {
    #[test]
    fn roots_of_products(
        roots in proptest::collection::vec((-40i32..40).prop_map(|k| f64::from(k) / 8.0), 3..9),
        size in -40i32..40,
    ) {
        // Any unit of length, and any factor.
        let unit = power_of_two(size);
        let mut roots: Vec<f64> = roots.iter().map(|r| r * unit).collect();
        roots.sort_by(f64::total_cmp);
        let found = everywhere(&from_roots(power_of_two(-size), &roots));
        prop_assert!(found.is_sorted());
        prop_assert_eq!(found.len() % 2, roots.len() % 2, "{:?} {:?}", found, roots);
        for r in &roots {
            let m = roots.iter().filter(|x| *x == r).count();
            let tolerance = [1e-7, 1e-5, 1e-3, 1e-2, 0.1, 0.2, 0.5, 1.0][m - 1] * unit;
            // (Rounding may miss a double root.)
            let seen = found.iter().any(|x| (x - r).abs() < tolerance);
            prop_assert!(seen || m % 2 == 0, "{} of {:?}: {:?}", r, roots, found);
        }
    }

    #[test]
    fn window_changes_no_root_in_it(
        b in proptest::collection::vec(-1.0..1.0f64, 4..9),
        start in -0.2..1.2f64, length in 0.0..1.0f64,
    ) {
        let window = (start, start + length);
        let is_wanted = |t: &f64| (window.0..=window.1).contains(t);
        let of_all: Roots = in_window(&b, (f64::NEG_INFINITY, f64::INFINITY)).into_iter().filter(is_wanted).collect();
        let found: Roots = in_window(&b, window).into_iter().filter(is_wanted).collect();
        prop_assert_eq!(found, of_all);
    }
}
