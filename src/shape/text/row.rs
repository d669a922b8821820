//! Letters of a text in a row, and the hits of a ray on them.

use super::glyph::{Glyph, curve_point};
use super::{BACK, FRONT, WALLS};
use crate::math::{Aabb, DVec2, DVec3, Range, Ray, solve_quadratic, tolerance};
use crate::shape::Hit;
use std::ops::ControlFlow;
use std::sync::Arc;

/// Letters of a text, in the order of the string.
#[derive(Clone, Debug, PartialEq)]
pub struct Row {
    /// Letters that have an outline.
    pub letters: Vec<Letter>,
    /// Box around the boxes of all letters.
    bounds: Aabb,
    /// Extent of the letters along z.
    depth: f64,
}

/// Letter of a text at its position.
#[derive(Clone, Debug, PartialEq)]
pub struct Letter {
    /// Outline of the letter, which equal letters share.
    pub glyph: Arc<Glyph>,
    /// Position of the glyph's origin.
    pub at: DVec3,
    /// Number of the letter's first part among the parts of all letters.
    pub first_part: u32,
    /// Bounding box of the letter, in the row's space.
    pub bounds: Aabb,
    /// Largest x of the boxes of this letter and of all earlier ones.
    max_x_so_far: f64,
    /// Smallest x of the boxes of this letter and of all later ones.
    min_x_from_here: f64,
}

/// Search for the hits of a ray on one letter.
struct Search<'a, V> {
    letter: &'a Letter,
    depth: f64,
    /// Origin of the ray relative to the letter's position.
    origin: DVec3,
    dir: DVec3,
    range: Range,
    /// Distance beyond which hits are no longer of interest; `visit` updates it.
    max: f64,
    visit: V,
}

impl Row {
    /// Places glyphs at positions; their outlines must not be empty.
    pub fn new(placed: Vec<(Arc<Glyph>, DVec3)>, depth: f64) -> Self {
        let (mut first_part, mut max_x_so_far) = (0, f64::NEG_INFINITY);
        let mut letters = Vec::with_capacity(placed.len());
        for (glyph, at) in placed {
            let bounds = Aabb::from_corners(at + glyph.min.extend(0.0), at + glyph.max.extend(depth));
            let part_count = WALLS + glyph.curve_count() as u32;
            max_x_so_far = bounds.max.x.max(max_x_so_far);
            letters.push(Letter { glyph, at, first_part, bounds, max_x_so_far, min_x_from_here: bounds.min.x });
            first_part += part_count;
        }
        for i in (1..letters.len()).rev() {
            letters[i - 1].min_x_from_here = letters[i].min_x_from_here.min(letters[i - 1].bounds.min.x);
        }
        let bounds = letters.iter().map(|letter| letter.bounds).fold(Aabb::EMPTY, Aabb::union);
        Self { letters, bounds, depth }
    }

    /// Calls `visit` with each hit in the range, letter by letter, until it returns `Break`; `visit` returns the
    /// distance up to which hits are still of interest. The hits of one letter have no particular order.
    pub fn visit_hits(
        &self,
        ray: &Ray,
        range: Range,
        mut visit: impl FnMut(Hit) -> ControlFlow<(), f64>,
    ) -> ControlFlow<()> {
        let mut max = range.max;
        for letter in self.letters_near_ray(ray, range) {
            if letter.bounds.slabs(ray, range).is_some() {
                let (origin, dir) = (ray.origin - letter.at, ray.dir);
                let mut search = Search { letter, depth: self.depth, origin, dir, range, max, visit: &mut visit };
                search.visit_end_hits()?;
                search.visit_wall_hits()?;
                max = search.max;
            }
        }
        ControlFlow::Continue(())
    }

    /// Returns consecutive letters that include all whose boxes the ray intersects within the range.
    fn letters_near_ray(&self, ray: &Ray, range: Range) -> &[Letter] {
        let all = &self.letters[..];
        if all.len() == 1 {
            return all;
        }
        // Exclude letters that the ray passes before or after the row's box in x. No hit is lost: the distances are rounded
        // as in `slabs`, and the row's box contains each letter's box.
        let Some((near, far)) = self.bounds.slabs(ray, range) else { return &[] };
        let (o, inverse) = (ray.origin.x, 1.0 / ray.dir.x);
        let distance = |x: f64| (x - o) * inverse;
        let is_before = |x: f64| if inverse < 0.0 { distance(x) > far } else { distance(x) < near };
        let is_after = |x: f64| if inverse < 0.0 { distance(x) < near } else { distance(x) > far };
        let first = all.partition_point(|letter| is_before(letter.max_x_so_far));
        let count = all[first..].partition_point(|letter| !is_after(letter.min_x_from_here));
        &all[first..first + count]
    }

    /// Returns the letter that has this part, and the part's number within the letter.
    pub fn letter_and_own_part(&self, part_of_text: u32) -> (&Letter, u32) {
        let letter = &self.letters[self.letters.partition_point(|letter| letter.first_part <= part_of_text) - 1];
        (letter, part_of_text - letter.first_part)
    }

    /// True if the point is inside a letter.
    pub fn contains(&self, p: DVec3) -> bool {
        self.letters.iter().any(|letter| {
            let local = p - letter.at;
            local.z > 0.0 && local.z < self.depth && letter.glyph.outline_contains(local.truncate())
        })
    }
}

impl<V: FnMut(Hit) -> ControlFlow<(), f64>> Search<'_, V> {
    /// True if a hit at `t` is in the range and not beyond the distance of interest.
    fn is_of_interest(&self, t: f64) -> bool {
        self.range.contains(t) && t <= self.max
    }

    /// Calls `visit` with a hit on a part of the letter, and stores the new distance of interest.
    fn report(&mut self, t: f64, part: u32, s: f64) -> ControlFlow<()> {
        self.max = (self.visit)(Hit { t, part: self.letter.first_part + part, uv: DVec2::new(s, 0.0) })?;
        ControlFlow::Continue(())
    }

    /// Visits the hits on the front and the back, in the order along the ray.
    fn visit_end_hits(&mut self) -> ControlFlow<()> {
        let (front, back) = ((FRONT, 0.0), (BACK, self.depth));
        for (part, z) in if self.dir.z < 0.0 { [back, front] } else { [front, back] } {
            let t = (z - self.origin.z) / self.dir.z;
            if self.is_of_interest(t)
                && t.is_finite()
                && self.letter.glyph.outline_contains((self.origin + self.dir * t).truncate())
            {
                self.report(t, part, 0.0)?;
            }
        }
        ControlFlow::Continue(())
    }

    fn visit_wall_hits(&mut self) -> ControlFlow<()> {
        let across = self.dir.truncate();
        let length = across.length_squared();
        if length == 0.0 || self.depth < 0.0 {
            return ControlFlow::Continue(());
        }
        let Some((low, high)) = self.bounds_of_ray_within_depth() else { return ControlFlow::Continue(()) };
        let letter = self.letter;
        letter.glyph.visit_curves_in_rectangle(low, high, |number, curve| {
            let from = curve.map(|p| p - self.origin.truncate());
            // Signed distances from the ray, to the left.
            let [a, b, c] = from.map(|p| across.perp_dot(p));
            if (a > 0.0 && b > 0.0 && c > 0.0) || (a < 0.0 && b < 0.0 && c < 0.0) {
                return ControlFlow::Continue(());
            }
            let Some((s1, s2)) = solve_quadratic(a - 2.0 * b + c, 2.0 * (b - a), a) else {
                return ControlFlow::Continue(());
            };
            for s in [s1, s2] {
                // A curve includes its first end but not its last, so that a corner is hit once.
                if (0.0..1.0).contains(&s) {
                    let t = across.dot(curve_point(from, s)) / length;
                    let z = self.origin.z + self.dir.z * t;
                    if z >= 0.0 && z <= self.depth && self.is_of_interest(t) {
                        self.report(t, WALLS + number as u32, s)?;
                    }
                }
            }
            ControlFlow::Continue(())
        })
    }

    /// Returns a bounding rectangle, in the glyph's plane, of the stretch of the ray between the planes of the front
    /// and back, with a margin for rounding; it contains all hits of interest on the letter's walls. Infinite for a ray
    /// parallel to the front, `None` if the ray can hit no wall.
    fn bounds_of_ray_within_depth(&self) -> Option<(DVec2, DVec2)> {
        let (o, d) = (self.origin, self.dir);
        let (t0, t1) = (-o.z / d.z, (self.depth - o.z) / d.z);
        let (near, far) = (t0.min(t1).max(self.range.min), t0.max(t1).min(self.max));
        // Rounding errors are proportional to the coordinates. An error shifts a hit in the glyph's plane, or along z, which
        // is `t_margin` along the ray.
        let Glyph { min, max, .. } = *self.letter.glyph;
        let size = o.abs().max_element() + self.depth + min.abs().max(max.abs()).max_element();
        let margin = tolerance::BOUNDS * size;
        let t_margin = margin / d.z.abs();
        if near - t_margin > far {
            return None;
        }
        let (p, q) = ((o + d * near).truncate(), (o + d * far).truncate());
        let grown = d.truncate().abs() * t_margin + margin;
        let (low, high) = (p.min(q) - grown, p.max(q) + grown);
        // A ray parallel to the front has no such limits.
        let is_limited = (low + high).is_finite();
        Some(if is_limited { (low, high) } else { (DVec2::NEG_INFINITY, DVec2::INFINITY) })
    }
}
