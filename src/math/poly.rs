//! Real roots of polynomials up to the fourth degree.

/// Up to four real roots, ascending.
pub type Roots = smallvec::SmallVec<[f64; 4]>;

/// Real roots of a·x² + b·x + c, ascending, by the stable pair (lecture, "Solving ax²+bx+c=0"): one root where
/// nothing is subtracted, the other by Vieta.
pub fn solve_quadratic(a: f64, b: f64, c: f64) -> Option<(f64, f64)> {
    let disc = b * b - 4.0 * a * c;
    if disc < 0.0 || a == 0.0 {
        return None;
    }
    // q = -(b ± √disc)/2 with the sign that adds two numbers of one sign
    let q = -0.5 * (b + disc.sqrt().copysign(b));
    let (x1, x2) = if q == 0.0 { (0.0, 0.0) } else { (q / a, c / q) };
    Some((x1.min(x2), x1.max(x2)))
}

/// Placeholder until the geometry lands.
pub fn solve_cubic(_: [f64; 4]) -> Roots {
    Roots::new()
}

/// Placeholder until the geometry lands.
pub fn solve_quartic(_: [f64; 5]) -> Roots {
    Roots::new()
}
