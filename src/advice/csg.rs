//! Warnings about empty CSG objects, and about CSG objects with a single part.

use crate::diagnostic::{Diagnostic, codes};
use crate::math::{Aabb, DVec3};
use crate::scene::{CsgOp, Object, ObjectBody, ObjectKind, Scene};
use crate::source::{Sources, Span};
use crate::world::Probe;
use rustc_hash::{FxHashMap, FxHashSet};
use std::sync::Arc;

/// Maximum number of shapes in an object that is examined.
const MAX_SHAPES: u32 = 300;
/// Maximum number of examined objects from one position of the text. If one is not empty, the text is right.
const MAX_COPIES: usize = 8;
/// Largest number of positions of the text that are examined.
const MAX_POSITIONS: usize = 400;
/// Largest number of warnings about CSG objects.
const MAX_WARNINGS: usize = 5;
/// Number of test rays along each side of an object's box in the first test.
const FEW_RAYS: usize = 6;
/// Number of test rays along each side of an object's box in the second test, if all rays of the first test miss.
const MANY_RAYS: usize = 90;

pub(super) fn csg_warnings(scene: &Scene, sources: &Sources) -> Vec<Diagnostic> {
    let mut groups = CsgByTextPosition::default();
    scene.objects.iter().for_each(|object| groups.gather(object));
    let mut out = vec![];
    for copies in groups.in_text_order() {
        let Some((first, op, parts)) =
            copies.first().and_then(|first| Some((first, written_csg_op(first)?, parts(first))))
        else {
            continue;
        };
        let joins = matches!(op, CsgOp::Union | CsgOp::Merge);
        if parts.len() < 2 {
            let counts = parts.is_empty() || !joins;
            out.extend(few_parts_warning(first, parts, sources).filter(|_| counts));
        } else if !joins && copies.iter().all(|copy| is_probably_empty(copy)) {
            out.push(empty_csg_warning(first, op, parts));
        }
        if out.len() >= MAX_WARNINGS {
            break;
        }
    }
    out
}

/// Returns warnings about unions and merges of one object, which are harmless, for `--warn doubtful`.
pub(super) fn single_object_union_warnings(scene: &Scene, sources: &Sources) -> Vec<Diagnostic> {
    let mut groups = CsgByTextPosition::default();
    scene.objects.iter().for_each(|object| groups.gather(object));
    let joins = |object: &Object| matches!(written_csg_op(object), Some(CsgOp::Union | CsgOp::Merge));
    let copies = groups.in_text_order();
    let first =
        copies.filter_map(|copies| copies.first().copied().filter(|first| joins(first) && parts(first).len() == 1));
    first.filter_map(|first| few_parts_warning(first, parts(first), sources)).collect()
}

fn written_csg_op(object: &Object) -> Option<CsgOp> {
    match &object.kind {
        ObjectKind::Csg(op, _) if is_written_as_csg(object) => Some(*op),
        _ => None,
    }
}

/// True if the author wrote the object with the word of a CSG object. (A shape with a number that is not finite also
/// becomes an empty union.)
fn is_written_as_csg(object: &Object) -> bool {
    matches!(object.word, "union" | "composite" | "merge" | "intersection" | "difference")
}

fn parts(object: &Object) -> &[Object] {
    match &object.kind {
        ObjectKind::Csg(_, parts) => parts,
        _ => &[],
    }
}

/// CSG objects by their position in the text.
#[derive(Default)]
struct CsgByTextPosition<'s> {
    /// Bodies that were examined; many objects share one body.
    seen: FxHashSet<*const ObjectBody>,
    numbers: FxHashMap<Span, usize>,
    all: Vec<Vec<&'s Object>>,
}

impl<'s> CsgByTextPosition<'s> {
    fn gather(&mut self, object: &'s Object) {
        let parts = parts(object);
        if written_csg_op(object).is_none() || !self.seen.insert(Arc::as_ptr(&object.body)) {
            return;
        }
        parts.iter().for_each(|part| self.gather(part));
        let next = self.all.len();
        let number = *self.numbers.entry(object.source).or_insert(next);
        if number == next && next < MAX_POSITIONS {
            self.all.push(vec![]);
        }
        if let Some(copies) = self.all.get_mut(number).filter(|copies| copies.len() < MAX_COPIES) {
            copies.push(object);
        }
    }

    /// Returns the groups of CSG objects in the order of the text.
    fn in_text_order(mut self) -> impl Iterator<Item = Vec<&'s Object>> {
        self.all.sort_by_key(|copies| copies.first().map_or(0, |first| first.source.lo));
        self.all.into_iter()
    }
}

/// Returns the warning about a CSG block with fewer than two parts. Blocks with directives are excepted, since a loop
/// may produce a single part.
fn few_parts_warning(object: &Object, parts: &[Object], sources: &Sources) -> Option<Diagnostic> {
    if !has_no_directive(object.source, sources) {
        return None;
    }
    let word = object.word;
    let (message, help) = match parts {
        [] => (format!("this `{word}` contains no object"), "are the objects after its `}`?".to_string()),
        [_] => {
            let message = format!("this `{word}` contains a single object and has no effect");
            (message, format!("is the second object after its `}}`? otherwise remove `{word} {{ … }}`"))
        }
        _ => return None,
    };
    let d = Diagnostic::new(codes::FEW_PARTS, object.source, message).help(help);
    Some(match parts {
        [part] => d.also(part.source, "the only object"),
        _ => d,
    })
}

/// True if the block at a span contains no directive.
fn has_no_directive(source: Span, sources: &Sources) -> bool {
    let Some((file, range)) = sources.locate(source) else { return false };
    let Some(rest) = sources.text(file).get(range.start..) else { return false };
    let (mut depth, mut opened) = (0, false);
    for c in rest.chars() {
        match c {
            '#' => return false,
            '{' => (depth, opened) = (depth + 1, true),
            '}' => depth -= 1,
            _ => {}
        }
        if opened && depth == 0 {
            return true;
        }
    }
    false
}

/// True if test rays hit no surface of the object, so that it is probably empty. False for an object that is not examined,
/// because its box is infinite or it has too many shapes.
fn is_probably_empty(object: &Object) -> bool {
    if object.weight().n_shapes() > MAX_SHAPES {
        return false;
    }
    // Lowering reports singular transforms.
    let Ok(probe) = Probe::new(object) else { return false };
    let bounds = probe.bounds();
    if bounds.is_empty() {
        return true;
    }
    bounds.is_finite() && axis_rays_miss(&probe, &bounds, FEW_RAYS) && axis_rays_miss(&probe, &bounds, MANY_RAYS)
}

/// True if axis-parallel rays through the box `bounds`, an `n_across` by `n_across` grid for each axis, all miss the
/// object of `probe`.
fn axis_rays_miss(probe: &Probe, bounds: &Aabb, n_across: usize) -> bool {
    let (size, far) = (bounds.size(), bounds.size().max_element() + 1.0);
    (0..3).all(|axis| {
        let along = DVec3::AXES[axis];
        (0..n_across * n_across).all(|i| {
            // Avoid the centre, where objects with round numbers have their edges.
            let part = |i: usize| (i as f64 + 0.4637) / n_across as f64;
            let mut at = DVec3::splat(0.0);
            at[(axis + 1) % 3] = part(i % n_across);
            at[(axis + 2) % 3] = part(i / n_across);
            let from = bounds.min + size * at - along * far;
            probe.hit_point_and_normal(from, along).is_none()
        })
    })
}

fn empty_csg_warning(object: &Object, op: CsgOp, parts: &[Object]) -> Diagnostic {
    let word = object.word;
    let first = usize::from(op == CsgOp::Difference);
    let without = |i: usize| {
        let others: Vec<Object> =
            parts.iter().enumerate().filter(|(j, _)| *j != i).map(|(_, part)| part.clone()).collect();
        let mut object = object.clone();
        object.kind = ObjectKind::Csg(op, others.into());
        object
    };
    // A part is guilty if the object without it is not empty.
    let guilty: Vec<&Object> = (first..parts.len().min(20))
        .filter(|&i| !is_probably_empty(&without(i)))
        .filter_map(|i| parts.get(i))
        .collect();
    let d = Diagnostic::new(codes::NOTHING_LEFT, object.source, format!("nothing is left of this `{word}`"));
    if op == CsgOp::Difference {
        let help = "make the subtracted object smaller, or move it";
        return match guilty[..] {
            [] => with_part_labels(d, parts.get(first..).unwrap_or_default(), "this and others remove it").help(help),
            [part] => d.also(part.source, "this removes all of it").help(help),
            _ => with_part_labels(d, guilty, "this and others remove it").help(help),
        };
    }
    match (guilty.iter().find(|part| part.word == "plane"), &guilty[..]) {
        (Some(plane), _) => d
            .also(plane.source, "this cuts all of it off")
            .help("the inside of a plane is the side that its normal points away from; `inverse` reverses it"),
        (None, [part]) => {
            d.also(part.source, "this has no point in common with the others").help("move it to where the others are")
        }
        _ => with_part_labels(d, parts, "one of its parts")
            .help("its parts have no point in common: move them together, or join them with `union`"),
    }
}

/// Adds labels for the first three parts to a warning.
fn with_part_labels<'a>(d: Diagnostic, parts: impl IntoIterator<Item = &'a Object>, label: &str) -> Diagnostic {
    parts.into_iter().take(3).fold(d, |d, part| d.also(part.source, label))
}
