//! `parametric { function { … } function { … } function { … } <u1, v1>, <u2, v2> … }`: the points whose x, y and z are functions of u and v.
//!
//! It is a sheet without an inside, and ends at `contained_by`, a box or a sphere. durer bounds the functions by interval arithmetic;
//! `max_gradient` counts only for functions that nothing is known of, and `precompute` changes nothing.
//!
//! ```pov
//! parametric {
//!   function { sin(u)*cos(v) } function { sin(u)*sin(v) } function { cos(u)*(1 + 0.2*sin(3*v)) } <0, 0>, <pi, 2*pi>
//!   contained_by { box { -1.3, 1.3 } } pigment { color rgb <0.3, 0.6, 0.9> }
//! }
//! ```

mod patches;

use super::formula::{Container, Formula};
use super::{Hit, Hits, Kernel, check_finite};
use crate::diagnostic::{Diagnostic, Result, codes};
use crate::math::{Aabb, DVec2, DVec3, Range, Ray, tolerance};
use crate::source::Span;
use crate::value::words::{Row, read_row, set, specs, word};
use crate::value::{Next, Param, Readable, Reader, Spec, ValueKind};
use patches::Patches;
use serde::Serialize;
use std::sync::{Arc, OnceLock};

/// Parametric surface, whose x, y and z are functions of u and v.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Parametric {
    /// Functions of u and v that give x, y and z of the parametric surface.
    pub functions: [Formula; 3],
    /// Minimum u and v of the parametric surface.
    pub from: DVec2,
    /// Maximum u and v of the parametric surface.
    pub to: DVec2,
    /// Solid that bounds the parametric surface.
    pub container: Container,
    /// Size of details of the parametric surface that can be missed.
    pub accuracy: f64,
    /// Maximum derivative of the parametric surface's functions, where they have no computed bounds.
    pub max_gradient: f64,
    #[serde(skip)]
    patches: Lazy,
}

/// Patches of the parametric surface, built when the first ray arrives.
#[derive(Clone, Debug, Default)]
struct Lazy(Arc<OnceLock<Patches>>);

impl PartialEq for Lazy {
    fn eq(&self, _: &Self) -> bool {
        true
    }
}

impl Parametric {
    /// Creates a parametric surface between two corners of the (u, v) plane, with defaults.
    pub fn new(functions: [Formula; 3], a: DVec2, b: DVec2) -> Self {
        Self {
            functions,
            from: a.min(b),
            to: a.max(b),
            container: Container::default(),
            accuracy: 0.001,
            max_gradient: 1.0,
            patches: Lazy::default(),
        }
    }

    /// Returns the point of the parametric surface at (u, v).
    fn point_at(&self, uv: DVec2) -> DVec3 {
        let p = uv.extend(0.0);
        DVec3::from_array([0, 1, 2].map(|i| self.functions[i].value_at(p)))
    }

    fn patches(&self) -> &Patches {
        self.patches.0.get_or_init(|| Patches::new(self))
    }

    fn visit_hits(&self, ray: &Ray, range: Range, only_nearer: bool, found: &mut dyn FnMut(Hit)) {
        let Some((enter, leave)) = self.container.interval_inside(ray) else { return };
        let (min, max) = (range.min.max(enter), range.max.min(leave));
        if min >= max {
            return;
        }
        // Start where the ray enters the container, so that a distant eye costs no digits.
        let near = Ray::new(ray.at(enter), ray.dir);
        let within = Range { min: min - enter, max: max - enter };
        self.patches().visit_hits(self, &near, within, only_nearer, &mut |t, uv| {
            let t = t + enter;
            if range.contains(t) {
                found(Hit { t, part: 0, uv });
            }
        });
    }
}

impl Readable for Parametric {
    const SPEC: Spec = Spec {
        name: "parametric",
        summary: "the points whose x, y and z are functions of u and v",
        params: &[
            Param {
                name: "function { … }",
                kind: ValueKind::Block,
                summary: "x, as a function of u and v; then y and z",
            },
            Param { name: "<u1, v1>", kind: ValueKind::Vector2, summary: "where u and v begin" },
            Param { name: "<u2, v2>", kind: ValueKind::Vector2, summary: "where they end" },
        ],
        words: &crate::value::words::joined::<4>(
            &[
                word(
                    "contained_by",
                    ValueKind::Block,
                    "box { -1, 1 }",
                    "a box or a sphere in braces, at which it ends",
                ),
                word("precompute", ValueKind::Block, "", "changes nothing: durer always looks at pieces first"),
            ],
            specs!(Self::WORDS),
        ),
        ..Spec::EMPTY
    };

    const WORDS: &'static [Row<Self>] = &[
        word("accuracy", ValueKind::Float, "0.001", "how small details are that may be lost")
            .sets(|s, r| set(&mut s.accuracy, super::formula::read_default_unless_positive(r, "accuracy", 0.001))),
        word("max_gradient", ValueKind::Float, "1", "how steep the functions are, where durer can't know it").sets(
            |s, r| set(&mut s.max_gradient, super::formula::read_default_unless_positive(r, "max_gradient", 1.0)),
        ),
    ];

    fn read(r: &mut dyn Reader) -> Result<Self> {
        let mut next = || Formula::read(r, "u and v");
        let functions = [next()?, next()?, next()?];
        let span = r.span();
        let (a, b) = (r.vector2()?, r.vector2()?);
        check_finite(span, &[a.extend(0.0), b.extend(0.0)], &[])?;
        Ok(Self::new(functions, a, b))
    }

    fn read_own(&mut self, next: Next, r: &mut dyn Reader) -> Result<bool> {
        match next {
            Next::Block("contained_by") => self.container = Container::read(r)?,
            Next::Word("precompute") => {
                r.take_token()?;
                r.float()?;
                while r.peek_next()? == Next::Value {
                    r.value()?;
                }
            }
            _ => return read_row(Self::WORDS, self, next, r),
        }
        Ok(true)
    }

    fn complete_and_check(&mut self, span: Span, r: &mut dyn Reader) -> Result<()> {
        let b = self.container.bounds();
        check_finite(span, &[b.min, b.max], &[])?;
        if self.from.x == self.to.x || self.from.y == self.to.y {
            let message = "this `parametric` has no surface: its u or v begins where it ends";
            r.report(Diagnostic::new(codes::NO_SURFACE, span, message));
        }
        Ok(())
    }
}

impl Kernel for Parametric {
    fn caches_lazily(&self) -> bool {
        true
    }

    fn bounds(&self) -> Aabb {
        self.container.bounds()
    }

    fn hits(&self, ray: &Ray, range: Range, out: &mut Hits) {
        self.visit_hits(ray, range, false, &mut |hit| {
            // A point on the common edge of two patches is found twice.
            if out.iter().all(|other| (other.t - hit.t).abs() > 1e-9 * (1.0 + hit.t.abs())) {
                out.push(hit);
            }
        });
    }

    /// Appends the first hit on the parametric surface in front of the ray's origin, and those behind it (quirk:
    /// `parametric_in_csg`).
    fn limited_hits_for_csg(&self, ray: &Ray, range: Range, out: &mut Hits) {
        self.hits(ray, Range { max: range.max.min(tolerance::SURFACE), ..range }, out);
        let first = self.closest(ray, Range { min: tolerance::SURFACE, max: range.max });
        out.extend(first.filter(|hit| range.contains(hit.t)));
    }

    fn closest(&self, ray: &Ray, range: Range) -> Option<Hit> {
        let mut first = None;
        self.visit_hits(ray, range, true, &mut |hit| first = Some(hit));
        first
    }

    fn inside(&self, _: DVec3) -> bool {
        false
    }

    fn is_open(&self) -> bool {
        true
    }

    /// Normal of the parametric surface, ∂p/∂u × ∂p/∂v, by differences (quirk: `parametric_normal`).
    fn normal(&self, _: DVec3, hit: &Hit) -> DVec3 {
        let step = (self.to - self.from) * 1e-6;
        let along = |step: DVec2| {
            let (a, b) = ((hit.uv - step).max(self.from), (hit.uv + step).min(self.to));
            self.point_at(b) - self.point_at(a)
        };
        let n = along(DVec2::new(step.x, 0.0)).cross(along(DVec2::new(0.0, step.y)));
        n.try_normalize().unwrap_or(DVec3::Y)
    }

    fn uv(&self, _: DVec3, hit: &Hit) -> DVec2 {
        hit.uv
    }
}

#[cfg(test)]
mod tests;
