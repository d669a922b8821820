//! Hits where POV-Ray reports them: not at the root of the function, but at the end of a piece of the ray shorter than
//! `accuracy`, slightly behind the root (quirk: `isosurface_hits`).
//!
//! The ray from its origin, or from where it enters the container, to where it leaves is bisected until its pieces are
//! shorter than `accuracy`, in world units. The first piece at whose end the function has changed its sign is a hit.
//! The search goes on five times `accuracy` behind the hit; so does the first search of a ray that starts in the
//! container, if the value there is less than 4 times `accuracy` times `max_gradient`.

/// Distance that POV-Ray skips behind a hit on an isosurface, in units of `accuracy`.
const SKIPPED: f64 = 5.0;
/// Value of the isosurface's function at the origin, in units of `accuracy` times `max_gradient`, below which a ray
/// starts on the surface or inside.
const NEAR: f64 = 4.0;

/// Required accuracy of an isosurface's roots, in units of `accuracy`.
pub const ROOTS: f64 = 0.002;
/// Distance between a root and the end of a piece, relative to the piece, below which the order of both is uncertain.
/// (Pieces are longer than half of `accuracy`.)
const DOUBT: f64 = 0.02;

/// POV-Ray's search along a ray through an isosurface's container, behind the last hit.
pub struct Walk<'a> {
    /// Value of the isosurface's function along the ray.
    value: &'a dyn Fn(f64) -> f64,
    accuracy: f64,
    to: f64,
    from: f64,
    /// Length of the pieces into which POV-Ray divides the ray.
    piece: f64,
    /// True if the ray starts inside the isosurface; `None` before that is evaluated.
    inside: Option<bool>,
}

impl<'a> Walk<'a> {
    /// Creates the search of a ray that enters the isosurface's container from outside; `enters_solid` is true if it
    /// enters the solid there. `None` if the way is not longer than `accuracy`, and so has no hits.
    pub fn entering_container(
        value: &'a dyn Fn(f64) -> f64,
        enters_solid: bool,
        container_is_open: bool,
        to: f64,
        accuracy: f64,
    ) -> Option<Self> {
        let mut walk = Self { value, accuracy, to, from: 0.0, piece: 0.0, inside: Some(enters_solid) };
        walk.reset_piece_length();
        // Behind the container's own face the end of the first piece counts as a hit, which that face hides.
        if !container_is_open && enters_solid {
            walk.skip_after_hit(walk.piece);
        }
        walk.has_whole_piece().then_some(walk)
    }

    /// Creates the search of a ray that starts within the isosurface's container; `None` if the way is not longer than
    /// `accuracy`.
    pub fn starting_in_container(
        value: &'a dyn Fn(f64) -> f64,
        from: f64,
        to: f64,
        accuracy: f64,
        max_gradient: f64,
    ) -> Option<Self> {
        let first = value(from);
        let mut walk = Self { value, accuracy, to, from, piece: 0.0, inside: Some(first < 0.0) };
        walk.reset_piece_length();
        if first < NEAR * accuracy * max_gradient {
            walk.skip_after_hit(from);
        }
        walk.has_whole_piece().then_some(walk)
    }

    /// Position on the ray before which roots are ignored.
    pub fn search_start(&self) -> f64 {
        self.from
    }

    /// Returns POV-Ray's hit on an isosurface for a root, if any; roots must be passed in ascending order.
    pub fn povray_hit(&mut self, root: f64) -> Option<f64> {
        if root <= self.from || !self.has_whole_piece() {
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
            // Two roots in one piece are not seen.
            true => Some(end_of(nearest + 1.0)).filter(|&end| has_changed(end))?,
            false => Some(end_of(place.max(f64::MIN_POSITIVE).ceil())).filter(|&end| has_changed(end))?,
        };
        self.skip_after_hit(end);
        Some(end)
    }

    fn is_inside(&mut self) -> bool {
        *self.inside.get_or_insert_with(|| (self.value)(self.from) < 0.0)
    }

    fn skip_after_hit(&mut self, hit: f64) {
        self.from = hit + SKIPPED * self.accuracy;
        self.inside = None;
        self.reset_piece_length();
    }

    fn has_whole_piece(&self) -> bool {
        self.to - self.from > self.accuracy
    }

    fn reset_piece_length(&mut self) {
        self.piece = self.to - self.from;
        // (An infinite piece is never short enough.)
        while self.piece.is_finite() && self.piece >= self.accuracy {
            self.piece *= 0.5;
        }
    }
}
