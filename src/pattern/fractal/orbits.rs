//! Orbits of points of the complex plane under an iterated formula, one or several side by side: an iteration of one orbit
//! waits for the one before, so that several take little more time than one.

use crate::math::{Complex, Lanes};
use std::array::from_fn;

/// Result of a fractal's orbit.
pub enum End {
    /// Orbit that escapes: the step, and the position then.
    Left(u32, Complex),
    /// Orbit that does not escape: last position, and the least squared distance from 0.
    Stays(Complex, f64),
}

/// Squared length beyond which z has escaped: |z| then grows for ever if |c| ≤ 2.
pub const ESCAPE: f64 = 4.0;

/// Returns for each orbit of `magnet` whether it has escaped, or converged to the fixed point 1.
#[inline(always)]
fn have_escaped_or_converged<const N: usize>(z: Complex<Lanes<N>>) -> [bool; N] {
    let (square, from_one) = (z.length_squared(), (z + -1.0).length_squared());
    from_fn(|lane| (square.0[lane] > 10_000.0) | (from_one.0[lane] < 1e-4))
}

/// Formula that N orbits of a fractal follow side by side. (A trait, because the compiler inlines closures only if they are
/// called in one place.)
pub trait Formula<const N: usize> {
    /// Returns the next positions of the orbits.
    fn next(&self, z: Complex<Lanes<N>>) -> Complex<Lanes<N>>;

    /// Returns for each orbit whether it has escaped, or reached a fixed point.
    fn have_left(&self, z: Complex<Lanes<N>>) -> [bool; N];
}

/// Formula z² + c.
pub struct Square<const N: usize> {
    /// The number c of each orbit.
    pub c: Complex<Lanes<N>>,
}

impl<const N: usize> Formula<N> for Square<N> {
    #[inline(always)]
    fn next(&self, z: Complex<Lanes<N>>) -> Complex<Lanes<N>> {
        z.square() + self.c
    }

    #[inline(always)]
    fn have_left(&self, z: Complex<Lanes<N>>) -> [bool; N] {
        z.length_squared().0.map(|square| square > ESCAPE)
    }
}

/// Formula zⁿ + c.
pub struct Power<const N: usize> {
    /// The exponent n of all orbits.
    pub n: u32,
    /// The number c of each orbit.
    pub c: Complex<Lanes<N>>,
}

impl<const N: usize> Formula<N> for Power<N> {
    #[inline(always)]
    fn next(&self, z: Complex<Lanes<N>>) -> Complex<Lanes<N>> {
        z.power(self.n) + self.c
    }

    #[inline(always)]
    fn have_left(&self, z: Complex<Lanes<N>>) -> [bool; N] {
        z.length_squared().0.map(|square| square > ESCAPE)
    }
}

/// First formula of magnetic renormalisation, ((z² + c - 1) / (2z + c - 2))².
pub struct FirstMagnet<const N: usize> {
    /// The number c of each orbit.
    pub c: Complex<Lanes<N>>,
}

impl<const N: usize> Formula<N> for FirstMagnet<N> {
    #[inline(always)]
    fn next(&self, z: Complex<Lanes<N>>) -> Complex<Lanes<N>> {
        ((z.square() + (self.c + -1.0)) / (2.0 * z + (self.c + -2.0))).square()
    }

    #[inline(always)]
    fn have_left(&self, z: Complex<Lanes<N>>) -> [bool; N] {
        have_escaped_or_converged(z)
    }
}

/// Second formula of magnetic renormalisation: with p = (c - 1)(c - 2), the square of the quotient of z³ + 3(c - 1)z + p and
/// 3z² + 3(c - 2)z + p + 1.
pub struct SecondMagnet<const N: usize> {
    /// The number c of each orbit.
    pub c: Complex<Lanes<N>>,
}

impl<const N: usize> Formula<N> for SecondMagnet<N> {
    #[inline(always)]
    fn next(&self, z: Complex<Lanes<N>>) -> Complex<Lanes<N>> {
        let (c1, c2) = (self.c + -1.0, self.c + -2.0);
        let product = c1 * c2;
        let above = z * z.square() + 3.0 * (c1 * z) + product;
        let below = 3.0 * z.square() + 3.0 * (c2 * z) + product + 1.0;
        (above / below).square()
    }

    #[inline(always)]
    fn have_left(&self, z: Complex<Lanes<N>>) -> [bool; N] {
        have_escaped_or_converged(z)
    }
}

/// Position of N orbits of a fractal side by side, and their least squared distances from 0 so far.
#[derive(Clone, Copy)]
struct Position<const N: usize> {
    z: Complex<Lanes<N>>,
    least: Lanes<N>,
}

impl<const N: usize> Position<N> {
    /// Moves to the next position; the least distances are only found if `LEAST` is true.
    #[inline(always)]
    fn advance<const LEAST: bool>(&mut self, formula: &impl Formula<N>) {
        self.z = formula.next(self.z);
        if LEAST {
            self.least = self.least.min(self.z.length_squared());
        }
    }

    /// Returns the result of the orbit in a lane if its last position is this one.
    fn end(&self, lane: usize) -> End {
        End::Stays(self.z.lane(lane), self.least.0[lane])
    }
}

/// Follows N orbits that begin at `z`, side by side, for a number of iterations or until they leave. `includes_start` is true
/// if `z` belongs to the orbit. An orbit that has left must stay outside for `BLOCK` steps. The least distances from 0 are only
/// found if `LEAST` is true.
#[inline(always)]
pub fn follow_orbits<const BLOCK: u32, const LEAST: bool, const N: usize>(
    z: [Complex; N],
    formula: &impl Formula<N>,
    iterations: u32,
    includes_start: bool,
) -> [End; N] {
    let z = Complex::side_by_side(z);
    let least = if includes_start { z.length_squared() } else { Lanes([f64::INFINITY; N]) };
    let (mut now, mut ends, mut goes_on) = (Position { z, least }, [const { None }; N], [true; N]);
    // An orbit that returns to an earlier position is periodic: compare with one position, which is replaced ever
    // more rarely (R. P. Brent, "An improved Monte Carlo factorization algorithm", 1980, section 2).
    let (mut been, mut since, mut change) = (Complex::side_by_side([Complex::new(f64::NAN, f64::NAN); N]), 0, BLOCK);
    let mut i = 0;
    while i < iterations && goes_on.contains(&true) {
        // Iterate some steps without tests; if an orbit has left meanwhile, repeat them one by one.
        let mut ahead = now;
        let blind = iterations - i >= BLOCK;
        if blind {
            // (A loop: the compiler would call the closure of `for_each`.)
            for _ in 0..BLOCK {
                ahead.advance::<LEAST>(formula);
            }
        }
        let (left, sum) = (formula.have_left(ahead.z), ahead.z.x + ahead.z.y);
        if blind && !(0..N).any(|lane| goes_on[lane] & (left[lane] | sum.0[lane].is_nan())) {
            now = ahead;
            i += BLOCK;
        } else {
            for _ in 0..BLOCK.min(iterations - i) {
                now.advance::<LEAST>(formula);
                let left = formula.have_left(now.z);
                for lane in 0..N {
                    if goes_on[lane] && left[lane] {
                        (ends[lane], goes_on[lane]) = (Some(End::Left(i, now.z.lane(lane))), false);
                    }
                }
                i += 1;
            }
        }
        for lane in 0..N {
            if goes_on[lane] & (now.z.x.0[lane] == been.x.0[lane]) & (now.z.y.0[lane] == been.y.0[lane]) {
                let mut last = now;
                for _ in 0..(iterations - i) % (i - since) {
                    last.advance::<LEAST>(formula);
                }
                (ends[lane], goes_on[lane]) = (Some(last.end(lane)), false);
            }
        }
        if i >= change {
            (been, since, change) = (now.z, i, 2 * i);
        }
    }
    let mut lanes = 0..N;
    ends.map(|end| {
        let lane = lanes.next().unwrap_or(0);
        end.unwrap_or_else(|| now.end(lane))
    })
}
