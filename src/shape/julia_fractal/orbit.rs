//! Where a point of four dimensions goes, round by round: as a quaternion, or as a pair of complex numbers.
//!
//! A hypercomplex number x + iy + jz + kw is a pair of complex ones, (x + w) + i(y - z) and (x - w) + i(y + z): sums, products and
//! functions are those of both, and its square is half the sum of theirs.

use super::function::Function;
use crate::math::Complex;
use smallvec::SmallVec;

/// x + iy + jz + kw.
pub type Four = [f64; 4];

/// The rounds that may be taken from a point.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Rule {
    /// h² of a quaternion.
    Square,
    /// h³ of a quaternion.
    Cube,
    /// Of each number of a pair.
    Pair(Function),
}

/// Two lengths for each round: of both numbers of the pair, or twice that of the quaternion.
pub type Trail = SmallVec<[[f64; 2]; 16]>;

/// Hamilton's product.
pub fn product(a: Four, b: Four) -> Four {
    [
        a[0] * b[0] - a[1] * b[1] - a[2] * b[2] - a[3] * b[3],
        a[0] * b[1] + a[1] * b[0] + a[2] * b[3] - a[3] * b[2],
        a[0] * b[2] - a[1] * b[3] + a[2] * b[0] + a[3] * b[1],
        a[0] * b[3] + a[1] * b[2] - a[2] * b[1] + a[3] * b[0],
    ]
}

/// h², whose vector part is twice the product of both parts.
fn square([x, y, z, w]: Four) -> Four {
    let twice = x + x;
    [x * x - y * y - z * z - w * w, twice * y, twice * z, twice * w]
}

fn sum(a: Four, b: Four) -> Four {
    std::array::from_fn(|i| a[i] + b[i])
}

fn length_squared(h: Four) -> f64 {
    h.iter().map(|x| x * x).sum()
}

/// The pair of complex numbers.
pub fn pair([x, y, z, w]: Four) -> [Complex; 2] {
    [Complex::new(x + w, y - z), Complex::new(x - w, y + z)]
}

impl Rule {
    /// The next round and, of each of three directions, where it turns.
    pub fn moved(self, h: Four, c: Four, turns: [Four; 3]) -> (Four, [Four; 3]) {
        let twice = |d: Four| sum(product(h, d), product(d, h));
        match self {
            Rule::Square => (sum(square(h), c), turns.map(twice)),
            Rule::Cube => {
                let h2 = square(h);
                let turn = |d: Four| sum(sum(product(h2, d), product(product(h, d), h)), product(d, h2));
                (sum(product(h2, h), c), turns.map(turn))
            }
            Rule::Pair(f) => {
                let both = pair(h).map(|z| f.value_and_slope(z));
                let back =
                    |[a, b]: [Complex; 2]| [0.5 * (a.x + b.x), 0.5 * (a.y + b.y), 0.5 * (b.y - a.y), 0.5 * (a.x - b.x)];
                let turn = |d: Four| {
                    let [a, b] = pair(d);
                    back([a * both[0].1, b * both[1].1])
                };
                (sum(back(both.map(|(value, _)| value)), c), turns.map(turn))
            }
        }
    }

    /// Writes down the lengths from h₀ on, `count` rounds, but only `more` behind the first that is longer than √`exit`. Is there one?
    pub fn escapes(self, [h, c]: [Four; 2], exit: f64, [count, more]: [usize; 2], trail: &mut Trail) -> bool {
        trail.clear();
        match self {
            Rule::Pair(f) => {
                let c = pair(c);
                let next = |z: [Complex; 2]| std::array::from_fn(|i| f.value_and_slope(z[i]).0 + c[i]);
                follow(pair(h), next, |z| z.map(Complex::length_squared), exit, [count, more], trail)
            }
            Rule::Square => follow(h, |h| sum(square(h), c), |h| [length_squared(h); 2], exit, [count, more], trail),
            Rule::Cube => {
                let next = |h: Four| sum(product(square(h), h), c);
                follow(h, next, |h| [length_squared(h); 2], exit, [count, more], trail)
            }
        }
    }

    /// How far a length at most strays in the next round, if it strays by `d` in this one; `None` if that is not known.
    fn stray(self, length: f64, d: f64) -> Option<f64> {
        match self {
            // |(h + d)² - h²| ≤ 2|h||d| + |d|²
            Rule::Square | Rule::Pair(Function::Sqr) => Some(d * (2.0 * length + d)),
            Rule::Cube => Some(d * (3.0 * length * (length + d) + d * d)),
            Rule::Pair(_) => None,
        }
    }

    /// Is it known how far neighbours stray?
    pub fn is_proved(self) -> bool {
        self.stray(0.0, 0.0).is_some()
    }

    /// A radius within which all points share the fate that the trail tells: that its last length is more than √`exit`, or that all are
    /// less. 0 where it is not known.
    pub fn clearance(self, trail: &[[f64; 2]], escapes: bool, exit: f64) -> f64 {
        if !self.is_proved() {
            return 0.0;
        }
        let limit = exit.sqrt();
        // Both numbers of a pair stray more than the point by √2.
        let spread = if matches!(self, Rule::Pair(_)) { std::f64::consts::SQRT_2 } else { 1.0 };
        let holds = |radius: f64| {
            let mut stray = [radius * spread; 2];
            for (k, lengths) in trail.iter().enumerate() {
                if !escapes && mean([lengths[0] + stray[0], lengths[1] + stray[1]]) > limit {
                    return false;
                }
                if k + 1 == trail.len() {
                    let least = [(lengths[0] - stray[0]).max(0.0), (lengths[1] - stray[1]).max(0.0)];
                    return !escapes || mean(least) > limit;
                }
                for i in 0..2 {
                    match self.stray(lengths[i], stray[i]) {
                        Some(next) => stray[i] = next,
                        None => return false,
                    }
                }
            }
            false
        };
        // By first derivatives, and then less.
        let mut radius = self.first_guess(trail, escapes, limit) / spread;
        for _ in 0..6 {
            if holds(radius) {
                return radius;
            }
            radius *= 0.6;
        }
        0.0
    }

    fn first_guess(self, trail: &[[f64; 2]], escapes: bool, limit: f64) -> f64 {
        let (mut least, mut slope) = (f64::INFINITY, 1.0);
        for (k, lengths) in trail.iter().enumerate() {
            let gap = (mean(*lengths) - limit).abs() / slope;
            if k + 1 == trail.len() || !escapes {
                least = least.min(gap);
            }
            let length = lengths[0].max(lengths[1]);
            slope *= if self == Rule::Cube { 3.0 * length * length } else { 2.0 * length };
        }
        least
    }
}

/// The length of the point from those of its pair.
fn mean([a, b]: [f64; 2]) -> f64 {
    (0.5 * (a * a + b * b)).sqrt()
}

fn follow<T: Copy>(
    mut h: T,
    next: impl Fn(T) -> T,
    squares: impl Fn(T) -> [f64; 2],
    exit: f64,
    [count, more]: [usize; 2],
    trail: &mut Trail,
) -> bool {
    let (mut left, mut escapes) = (count, false);
    loop {
        let both = squares(h);
        trail.push(both.map(f64::sqrt));
        // (What is no number has gone, too.)
        let within = 0.5 * (both[0] + both[1]) <= exit;
        if !within && !escapes {
            (escapes, left) = (true, left.min(more));
        }
        if left == 0 || !both[0].is_finite() || !both[1].is_finite() {
            return escapes;
        }
        left -= 1;
        h = next(h);
    }
}
