//! Where POV-Ray sees a surface: not where the function is 0, but at the end of a piece of the ray shorter than `accuracy`, a little behind.
//!
//! Measured on POV-Ray 3.7 to the last digits, by `trace()` and with first hits clipped away. The way from where the ray begins, or enters the
//! container, to where it leaves it is halved until its pieces are shorter than `accuracy`, in units of the world. The first piece at whose end
//! the function has changed its sign is a hit there. The next way begins five times `accuracy` behind it; and so does the first one of a ray
//! that begins in the container, if the value there is less than 4 times `accuracy` times `max_gradient`.

/// How much of `accuracy` is skipped behind a surface.
const SKIPPED: f64 = 5.0;
/// Parts of `accuracy` times `max_gradient` below which a ray begins on the surface or inside.
const NEAR: f64 = 4.0;

/// Roots need be known no better than this part of `accuracy`.
pub const ROOTS: f64 = 0.002;
/// Roots that are nearer than this part of a piece to where one ends may lie before that or behind. (Pieces are longer than half of
/// `accuracy`.)
const DOUBT: f64 = 0.02;

/// A ray's way through a container, behind the last hit.
pub struct Walk<'a> {
    /// The function's value along the ray.
    value: &'a dyn Fn(f64) -> f64,
    accuracy: f64,
    to: f64,
    from: f64,
    /// How long the pieces are.
    piece: f64,
    /// Whether it begins inside of the solid; nobody has asked as yet where it is not known.
    inside: Option<bool>,
}

impl<'a> Walk<'a> {
    /// Of a ray that comes from outside of the container, and enters the solid with it or not. What is too short to be divided has no hits.
    pub fn entering(value: &'a dyn Fn(f64) -> f64, inside: bool, open: bool, to: f64, accuracy: f64) -> Option<Self> {
        let mut walk = Self { value, accuracy, to, from: 0.0, piece: 0.0, inside: Some(inside) };
        walk.divide();
        // Behind the container's own face the end of the first piece counts as a hit, which that face hides.
        if !open && inside {
            walk.skip(walk.piece);
        }
        walk.is_long().then_some(walk)
    }

    /// Of a ray that begins within the container.
    pub fn within(value: &'a dyn Fn(f64) -> f64, from: f64, to: f64, accuracy: f64, max_gradient: f64) -> Option<Self> {
        let first = value(from);
        let mut walk = Self { value, accuracy, to, from, piece: 0.0, inside: Some(first < 0.0) };
        walk.divide();
        if first < NEAR * accuracy * max_gradient {
            walk.skip(from);
        }
        walk.is_long().then_some(walk)
    }

    /// Roots before this are not seen.
    pub fn from(&self) -> f64 {
        self.from
    }

    /// The hit that POV-Ray sees for a root, if any: roots are told in ascending order.
    pub fn hit(&mut self, root: f64) -> Option<f64> {
        if root <= self.from || !self.is_long() {
            return None;
        }
        let inside = self.is_inside();
        let place = (root - self.from) / self.piece;
        let end_of = |number: f64| (self.from + number * self.piece).min(self.to);
        let has_changed = |t: f64| ((self.value)(t) < 0.0) != inside;
        let nearest = place.round();
        let in_doubt = nearest > 0.0 && (place - nearest).abs() < DOUBT;
        let end = match in_doubt {
            true if has_changed(end_of(nearest)) => end_of(nearest),
            // Between two roots in one piece nothing is seen.
            true => Some(end_of(nearest + 1.0)).filter(|&end| has_changed(end))?,
            false => Some(end_of(place.max(f64::MIN_POSITIVE).ceil())).filter(|&end| has_changed(end))?,
        };
        self.skip(end);
        Some(end)
    }

    fn is_inside(&mut self) -> bool {
        *self.inside.get_or_insert_with(|| (self.value)(self.from) < 0.0)
    }

    fn skip(&mut self, hit: f64) {
        self.from = hit + SKIPPED * self.accuracy;
        self.inside = None;
        self.divide();
    }

    fn is_long(&self) -> bool {
        self.to - self.from > self.accuracy
    }

    fn divide(&mut self) {
        self.piece = self.to - self.from;
        // (What has no end is never short enough.)
        while self.piece.is_finite() && self.piece >= self.accuracy {
            self.piece *= 0.5;
        }
    }
}
