//! `blob { threshold T sphere { … } cylinder { … } }`: fields of balls and rods that flow into each other (manual, "Blob").
//!
//! A component has the strength s·(1 - (d/r)²)² at the distance d < r from its centre or its axis; the surface is where all of them
//! together are as strong as the threshold. Along a ray that is a polynomial of degree 4 in each stretch between the places where
//! components begin and end.
//!
//! ```pov
//! blob { threshold 0.3 sphere { <-0.6, 0.8, 0>, 1.2, 1 } sphere { <0.7, 0.9, 0>, 1, 1 } pigment { color rgb <0.8, 0.4, 0.3> } }
//! ```

mod component;

pub use component::Component;

use super::pov_bounds::NOTHING;
use super::{Bounding, HUGE, Hit, Hits, Kernel, Paints, Quirks, TextureWeights, transformed_box};
use crate::diagnostic::{Diagnostic, Result, codes};
use crate::math::bvh::{self, Bvh};
use crate::math::cancel::{self, Poll};
use crate::math::{Aabb, DVec3, Range, Ray, Transform, bernstein_roots, tolerance};
use crate::source::Span;
use crate::value::words::word;
use crate::value::{Next, Readable, Reader, ReaderExt, Spec, ValueKind};
use component::{Stretch, Stretches};
use serde::Serialize;
use smallvec::SmallVec;
use std::ops::ControlFlow;

/// Blob: the surface of fields that merge into each other.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Blob {
    /// Strength of the field on the blob's surface; inside it is stronger.
    pub threshold: f64,
    /// Components of the blob in the order of its hierarchy.
    pub components: Vec<Component>,
    /// True if any component of the blob, even one without strength, has a texture.
    #[serde(skip)]
    textured: bool,
    #[serde(skip)]
    bvh: Bvh,
    #[serde(skip)]
    bounds: Aabb,
}

impl Blob {
    /// Builds the hierarchy over the blob's components; leaves out those without strength and those beyond the range of
    /// numbers.
    fn build_hierarchy(&mut self) {
        self.components
            .retain(|component| component.strength != 0.0 && bvh::fits_single_precision(&component.bounds()));
        let (bvh, order) = Bvh::build(self.components.iter().map(Component::bounds));
        let mut places: Vec<Option<Component>> = std::mem::take(&mut self.components).into_iter().map(Some).collect();
        self.components = order.into_iter().filter_map(|i| places[i as usize].take()).collect();
        self.bvh = bvh;
        let strong = self.components.iter().filter(|component| component.strength > 0.0);
        self.bounds = strong.map(Component::bounds).fold(Aabb::EMPTY, Aabb::union);
    }

    fn visit_components_near<'a>(&'a self, p: DVec3, visit: &mut dyn FnMut(&'a Component)) {
        self.bvh.visit_items_near_point(p, |i| {
            visit(&self.components[i]);
            ControlFlow::Continue(())
        });
    }

    fn field_at(&self, p: DVec3) -> f64 {
        let mut sum = 0.0;
        self.visit_components_near(p, &mut |component| sum += component.field_at(p));
        sum
    }

    /// Calls `visit` with each hit on the blob in `range`, in ascending `t`, until it returns `Break`.
    fn visit_hits(&self, ray: &Ray, range: Range, mut visit: impl FnMut(f64) -> ControlFlow<()>) {
        let range = range.raised_to_min_distance(Self::QUIRKS.min_distance);
        let Some((enter, _)) = self.bounds.slabs(ray, range) else { return };
        // Start near the blob, so that a distant eye costs no digits.
        let start = if enter.is_finite() { enter } else { -ray.origin.dot(ray.dir) / ray.dir.length_squared() };
        let near = Ray::new(ray.at(start), ray.dir);
        let mut stretches = Stretches::new();
        let mut poll = Poll::default();
        self.bvh.traverse(&near, Range::ALL, |i, max| {
            self.components[i].add_stretches(&near, &mut stretches);
            if stretches.len() > FEW_STRETCHES && poll.is_cancelled() {
                return ControlFlow::Break(());
            }
            ControlFlow::Continue(max)
        });
        stretches.sort_unstable_by(|a, b| a.from.total_cmp(&b.from));
        let mut ends: SmallVec<[f64; 32]> = stretches.iter().flat_map(|stretch| [stretch.from, stretch.to]).collect();
        ends.sort_unstable_by(f64::total_cmp);
        ends.dedup();
        let mut running = (stretches.len() > FEW_STRETCHES).then(|| RunningSum::new(&stretches, self.threshold));
        for pair in ends.windows(2) {
            let (lo, hi) = (pair[0], pair[1]);
            if let Some(running) = &mut running {
                if cancel::is_cancelled() {
                    return;
                }
                if running.advance_excludes_root(lo, hi) {
                    continue;
                }
            }
            if hi + start <= range.min || lo + start >= range.max {
                continue;
            }
            let middle = (lo + hi) / 2.0;
            let mut sum = [0.0, 0.0, 0.0, 0.0, -self.threshold];
            for stretch in stretches.iter().take_while(|stretch| stretch.from < hi).filter(|s| s.to > lo) {
                stretch.add_to_polynomial(middle, &mut sum);
            }
            let mut is_stopped = false;
            bernstein_roots(&bernstein_from_descending(&sum, (hi - lo) / 2.0), &mut |u| {
                let t = lo + u * (hi - lo) + start;
                is_stopped = range.contains(t) && visit(t).is_break();
                is_stopped
            });
            if is_stopped {
                return;
            }
        }
    }
}

/// Number of a blob's stretches on a ray below which no [`RunningSum`] is used: the polynomials of each piece of the
/// ray are then added anew.
const FEW_STRETCHES: usize = 64;
/// Bound of the relative error of a [`RunningSum`]: that of several 100 000 additions.
const RUNNING_ERROR: f64 = 1e-10;

/// Sum of the polynomials of a blob's stretches around a position that moves along a ray: each step adds the stretches
/// that begin and subtracts those that end. It is not exact enough for roots, but shows where none can be, so that a
/// ray through n overlapping components does not take n² steps.
struct RunningSum<'a> {
    /// Stretches of the blob in the order of their beginnings that are still ahead.
    starting: &'a [Stretch],
    /// Stretches of the blob in the order of their ends that are still ahead, the next one last.
    ending: Vec<&'a Stretch>,
    /// Coefficients t⁴ … t⁰ of the blob's polynomial.
    sum: [f64; 5],
    /// Sum of the absolute values of all that was added to each coefficient of the blob's polynomial.
    size: [f64; 5],
}

impl<'a> RunningSum<'a> {
    /// Creates the running sum in front of all stretches of a blob, which are in the order of their beginnings.
    fn new(stretches: &'a [Stretch], threshold: f64) -> Self {
        let mut ending: Vec<&Stretch> = stretches.iter().collect();
        ending.sort_unstable_by(|a, b| b.to.total_cmp(&a.to));
        let sum = [0.0, 0.0, 0.0, 0.0, -threshold];
        Self { starting: stretches, ending, sum, size: sum.map(f64::abs) }
    }

    /// Moves to the piece of the ray from `lo` to `hi`; true if the sum certainly has no root there. Pieces must be
    /// passed in ascending order.
    fn advance_excludes_root(&mut self, lo: f64, hi: f64) -> bool {
        while let Some((first, rest)) = self.starting.split_first().filter(|(first, _)| first.from < hi) {
            self.add(first, 1.0);
            self.starting = rest;
        }
        while let Some(last) = self.ending.pop_if(|last| last.to <= lo) {
            self.add(last, -1.0);
        }
        let (middle, half) = ((lo + hi) / 2.0, (hi - lo) / 2.0);
        let reach = lo.abs().max(hi.abs());
        let error = RUNNING_ERROR * self.size.iter().fold(0.0, |sum, c| sum * reach + c);
        // Taylor shift to the middle of the piece by repeated synthetic division.
        let mut c = self.sum;
        for end in (1..5).rev() {
            for i in 1..=end {
                c[i] += c[i - 1] * middle;
            }
        }
        // With all Bernstein coefficients of one sign, there is no root (Farouki and Rajan, On the numerical condition of
        // polynomials in Bernstein form, 1987).
        let b = bernstein_from_descending(&c, half);
        b.iter().all(|b| *b > error) || b.iter().all(|b| *b < -error)
    }

    fn add(&mut self, stretch: &Stretch, sign: f64) {
        let mut own = [0.0; 5];
        stretch.add_to_polynomial(0.0, &mut own);
        for ((sum, size), c) in self.sum.iter_mut().zip(&mut self.size).zip(own) {
            *sum += sign * c;
            *size += c.abs();
        }
    }
}

/// Returns the Bernstein coefficients of a polynomial of degree 4 between -half_width and half_width, whose coefficients are
/// those of t⁴ … t⁰.
fn bernstein_from_descending(coefficients: &[f64; 5], half_width: f64) -> [f64; 5] {
    // As a polynomial of x = t/half_width: p(x) = Σ pᵢ·xⁱ; with x = 2s - 1 the coefficients are linear in those.
    let [p4, p3, p2, p1, p0] = [
        coefficients[0] * half_width * half_width * half_width * half_width,
        coefficients[1] * half_width * half_width * half_width,
        coefficients[2] * half_width * half_width,
        coefficients[3] * half_width,
        coefficients[4],
    ];
    [
        p0 - p1 + p2 - p3 + p4,
        p0 - p1 / 2.0 + p3 / 2.0 - p4,
        p0 - p2 / 3.0 + p4,
        p0 + p1 / 2.0 - p3 / 2.0 - p4,
        p0 + p1 + p2 + p3 + p4,
    ]
}

impl Readable for Blob {
    const SPEC: Spec = Spec {
        name: "blob",
        summary: "fields of balls and rods that flow into each other",
        words: &[
            word("threshold", ValueKind::Float, "1", "how strong the field is on the surface"),
            word(
                "sphere",
                ValueKind::Block,
                "",
                "a ball: centre, radius and strength; it may have a texture and transforms of its own",
            ),
            word("cylinder", ValueKind::Block, "", "a rod with round ends: both ends, radius and strength"),
            word("component", ValueKind::Float, "", "an older way to write a ball: strength, radius, centre"),
        ],
        ..Spec::EMPTY
    };

    fn read(_: &mut dyn Reader) -> Result<Self> {
        Ok(Self { threshold: 1.0, components: vec![], textured: false, bvh: Bvh::default(), bounds: Aabb::EMPTY })
    }

    fn read_own(&mut self, next: Next, r: &mut dyn Reader) -> Result<bool> {
        match next {
            Next::Word("threshold") => {
                r.take_token()?;
                self.threshold = r.float()?;
            }
            Next::Word("component") => {
                let span = r.take_token()?;
                let (strength, radius, base) = (r.float()?, r.float()?, r.vector()?);
                self.components.push(Component::new(span, base, DVec3::ZERO, radius, strength)?);
            }
            _ => return Ok(false),
        }
        Ok(true)
    }

    fn complete_and_check(&mut self, span: Span, r: &mut dyn Reader) -> Result<()> {
        self.build_hierarchy();
        if self.bounds.is_empty() {
            r.report(Diagnostic::new(
                codes::NO_SURFACE,
                span,
                "this `blob` has no component that could give it a surface",
            ));
        }
        Ok(())
    }
}

impl Kernel for Blob {
    const QUIRKS: Quirks = Quirks {
        min_distance: tolerance::BLOB_SURFACE,
        bounding: Bounding::Ignored,
        shadow_by_outside: true,
        embedded_textures_on_both_sides: true,
        moves_embedded_textures: true,
        ..Quirks::NONE
    };

    fn bounds(&self) -> Aabb {
        self.bounds
    }

    /// Box of the blob's components with positive strength; without any the blob is inverted, and infinite once it is
    /// transformed (quirk: `extent_boxes`).
    fn pov_bounds(&self, m: &Transform) -> Aabb {
        let strong = self.components.iter().filter(|component| component.strength > 0.0);
        match strong.map(Component::pov_bounds).reduce(Aabb::union) {
            Some(all) => transformed_box(m, &all),
            None if m.is_identity() => NOTHING,
            None => HUGE,
        }
    }

    fn hits(&self, ray: &Ray, range: Range, out: &mut Hits) {
        self.visit_hits(ray, range, |t| {
            out.push(Hit::on_single_piece(t));
            ControlFlow::Continue(())
        });
    }

    fn closest(&self, ray: &Ray, range: Range) -> Option<Hit> {
        let mut found = None;
        self.visit_hits(ray, range, |t| {
            found = Some(Hit::on_single_piece(t));
            ControlFlow::Break(())
        });
        found
    }

    fn inside(&self, p: DVec3) -> bool {
        self.field_at(p) >= self.threshold
    }

    fn is_solid_unbounded(&self) -> bool {
        self.threshold <= 0.0
    }

    fn normal(&self, p: DVec3, _: &Hit) -> DVec3 {
        let mut sum = DVec3::ZERO;
        self.visit_components_near(p, &mut |component| sum -= component.field_gradient(p));
        if sum == DVec3::ZERO { DVec3::Y } else { sum }
    }

    fn read_textured(&mut self, next: Next, r: &mut dyn Reader, paints: &mut dyn Paints) -> Result<bool> {
        let Next::Block(kind @ ("sphere" | "cylinder")) = next else { return Ok(false) };
        let span = r.take_token()?;
        let base = r.vector()?;
        let axis = if kind == "cylinder" { r.vector()? - base } else { DVec3::ZERO };
        let radius = r.float()?;
        r.accept("strength")?;
        let strength = r.float()?;
        let mut component = Component::new(span, base, axis, radius, strength)?;
        component.read_modifiers(kind, r, paints)?;
        r.leave_block()?;
        self.textured |= component.texture_number_or_0 != 0;
        self.components.push(component);
        Ok(true)
    }

    fn texture_weights(&self, p: DVec3, _: &Hit) -> TextureWeights {
        let mut texture_weights = TextureWeights::new();
        let mut sum = 0.0;
        self.visit_components_near(p, &mut |component| {
            let field = component.field_at(p).abs();
            if field > 0.0 {
                sum += field;
                texture_weights.push((component.texture_number_or_0, field));
            }
        });
        texture_weights.iter_mut().for_each(|(_, share)| *share /= sum);
        texture_weights
    }

    fn has_uv_mapping(&self) -> bool {
        false
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::shape::testing::all_hits;

    fn blob(threshold: f64, components: &[(DVec3, DVec3, f64, f64)]) -> Blob {
        let component = |&(base, axis, radius, strength): &(DVec3, DVec3, f64, f64)| {
            Component::new(Span::new(1, 2), base, axis, radius, strength).unwrap()
        };
        let components = components.iter().map(component).collect();
        let mut blob = Blob { threshold, components, textured: false, bvh: Bvh::default(), bounds: Aabb::EMPTY };
        blob.build_hierarchy();
        blob
    }

    #[test]
    fn a_single_ball_in_closed_form() {
        // (1 - d²)² = 1/4 at d² = 1/2
        let shape = blob(0.25, &[(DVec3::ZERO, DVec3::ZERO, 1.0, 1.0)]);
        let hits = all_hits(&shape, &Ray::new(DVec3::new(0.0, 0.0, -9.0), DVec3::Z));
        let r = 0.5_f64.sqrt();
        assert!(hits.len() == 2 && (hits[0].t - 9.0 + r).abs() < 1e-12 && (hits[1].t - 9.0 - r).abs() < 1e-12);
        let far = all_hits(&shape, &Ray::new(DVec3::new(0.0, 0.0, -1e7), DVec3::Z));
        assert!((far[0].t - 1e7 + r).abs() < 1e-8, "{far:?}");
    }

    #[test]
    fn fields_join_and_take_away() {
        let x = DVec3::X;
        let shape =
            blob(0.4, &[(-x, 2.0 * x, 0.8, 1.0), (DVec3::Y * 0.3, DVec3::ZERO, 1.1, 0.8), (x, DVec3::ZERO, 0.6, -0.7)]);
        let mut met = 0;
        for k in 0..2000 {
            let at = |m: usize| (k * m % 997) as f64 / 498.5 - 1.0;
            let ray = Ray::new(DVec3::new(at(13), at(29), at(5)) * 2.0, DVec3::new(at(7), at(11), at(3)));
            let hits = all_hits(&shape, &ray);
            met += hits.len();
            for hit in &hits {
                let p = ray.at(hit.t);
                assert!(
                    (shape.field_at(p) - 0.4).abs() < 1e-9 && shape.bounds().grown(1e-9).contains(p),
                    "{ray:?} {hit:?}"
                );
                // The normal is opposite to the gradient.
                let n = shape.normal(p, hit).normalize();
                let slope = (shape.field_at(p + n * 1e-6) - shape.field_at(p - n * 1e-6)) / 2e-6;
                assert!(slope < 0.0 && (slope.abs() - shape.normal(p, hit).length()).abs() < 1e-4 * slope.abs());
            }
            for pair in hits.windows(2).filter(|pair| pair[1].t - pair[0].t > 1e-9) {
                let middle = (pair[0].t + pair[1].t) / 2.0;
                let before = hits.iter().filter(|hit| hit.t < middle).count();
                assert_eq!(shape.inside(ray.at(middle)), before % 2 == 1, "{ray:?}");
            }
        }
        assert!(met > 500, "{met}");
    }

    #[test]
    fn many_overlapping_components_have_the_roots_of_their_sum() {
        let random = |i: usize, k: u64| crate::math::rng::random_unit(&[i as u64, k]) - 0.5;
        let at = |i: usize| DVec3::new(random(i, 0), random(i, 1), random(i, 2));
        let components: Vec<_> =
            (0..400).map(|i| (at(i) * 3.0, DVec3::ZERO, 0.9 + 0.4 * random(i, 3), 0.2 + 0.4 * random(i, 4))).collect();
        let shape = blob(12.0, &components);
        let mut many = 0;
        for i in 0..100 {
            let ray = Ray::new(at(1000 + i) * 8.0, at(2000 + i) - at(1000 + i));
            let mut stretches = Stretches::new();
            shape.components.iter().for_each(|component| component.add_stretches(&ray, &mut stretches));
            many += usize::from(stretches.len() > FEW_STRETCHES);
            // Changes of sign between close points of the ray, which lie on both sides of each root.
            let inside: Vec<bool> = (0..=4000).map(|k| shape.inside(ray.at(f64::from(k) * 0.005))).collect();
            let changes = inside.windows(2).filter(|pair| pair[0] != pair[1]).count();
            let hits = all_hits(&shape, &ray).iter().filter(|hit| hit.t < 20.0).count();
            assert!(hits >= changes && (hits - changes).is_multiple_of(2), "{hits} {changes}");
        }
        assert!(many > 10, "{many}");
    }

    #[test]
    fn reading() {
        let (shape, reports) = crate::shape::testing::read_shape::<Blob>("threshold 0.6 component 1 2 <1,0,0>");
        let shape = shape.unwrap();
        assert_eq!((shape.threshold, shape.components.len(), reports.len()), (0.6, 1, 0));
        assert_eq!(crate::shape::testing::read_shape::<Blob>("threshold 0.6").1[0].code, codes::NO_SURFACE);
        // A component of radius 0 adds nothing, and a negative radius counts by its size.
        let (shape, _) = crate::shape::testing::read_shape::<Blob>("component 1 0 <1,0,0> component 1 -2 <1,0,0>");
        let components = shape.unwrap().components;
        assert_eq!(components.iter().map(|c| c.strength).collect::<Vec<_>>(), [1.0]);
        assert_eq!(components[0].radius, 2.0);
    }
}
