//! CSG of which nothing is left, and CSG of a single part.

use crate::diagnostic::{Diagnostic, codes};
use crate::math::{Aabb, DVec3};
use crate::scene::{CsgOp, Object, ObjectBody, ObjectKind, Scene};
use crate::source::{Sources, Span};
use crate::world::Probe;
use rustc_hash::{FxHashMap, FxHashSet};
use std::sync::Arc;

/// Larger objects are taken as they are: to look for what is left of them takes too long.
const SHAPES: u32 = 300;
/// As many objects that one place of the text made are looked at: if one of them is there, the text is right.
const COPIES: usize = 8;
/// As many places are looked at, and as many are told.
const PLACES: usize = 400;
const TOLD: usize = 5;
/// Rays across a side of an object's box: first a few, and where none meets anything, many.
const FEW: usize = 6;
const MANY: usize = 90;

pub(super) fn of_scene(scene: &Scene, sources: &Sources) -> Vec<Diagnostic> {
    let mut groups = Groups::default();
    scene.objects.iter().for_each(|object| groups.gather(object));
    let mut out = vec![];
    for copies in groups.in_order() {
        let Some((first, op, parts)) = copies.first().and_then(|first| Some((first, op(first)?, parts(first)))) else {
            continue;
        };
        let joins = matches!(op, CsgOp::Union | CsgOp::Merge);
        if parts.len() < 2 {
            let counts = parts.is_empty() || !joins;
            out.extend(few_parts(first, parts, sources).filter(|_| counts));
        } else if !joins && copies.iter().all(|copy| is_nothing(copy)) {
            out.push(nothing_left(first, op, parts));
        }
        if out.len() >= TOLD {
            break;
        }
    }
    out
}

/// Unions of one object, which do no harm.
pub(super) fn doubtful(scene: &Scene, sources: &Sources) -> Vec<Diagnostic> {
    let mut groups = Groups::default();
    scene.objects.iter().for_each(|object| groups.gather(object));
    let joins = |object: &Object| matches!(op(object), Some(CsgOp::Union | CsgOp::Merge));
    let copies = groups.in_order();
    let first =
        copies.filter_map(|copies| copies.first().copied().filter(|first| joins(first) && parts(first).len() == 1));
    first.filter_map(|first| few_parts(first, parts(first), sources)).collect()
}

fn op(object: &Object) -> Option<CsgOp> {
    match &object.kind {
        ObjectKind::Csg(op, _) if is_written(object) => Some(*op),
        _ => None,
    }
}

/// (A shape with a number that is not finite has become an empty union.)
fn is_written(object: &Object) -> bool {
    matches!(object.word, "union" | "composite" | "merge" | "intersection" | "difference")
}

fn parts(object: &Object) -> &[Object] {
    match &object.kind {
        ObjectKind::Csg(_, parts) => parts,
        _ => &[],
    }
}

/// CSG objects by the place that made them.
#[derive(Default)]
struct Groups<'s> {
    /// A body that many objects share is looked at once.
    seen: FxHashSet<*const ObjectBody>,
    numbers: FxHashMap<Span, usize>,
    all: Vec<Vec<&'s Object>>,
}

impl<'s> Groups<'s> {
    fn gather(&mut self, object: &'s Object) {
        let parts = parts(object);
        if op(object).is_none() || !self.seen.insert(Arc::as_ptr(&object.body)) {
            return;
        }
        parts.iter().for_each(|part| self.gather(part));
        let next = self.all.len();
        let number = *self.numbers.entry(object.source).or_insert(next);
        if number == next && next < PLACES {
            self.all.push(vec![]);
        }
        if let Some(copies) = self.all.get_mut(number).filter(|copies| copies.len() < COPIES) {
            copies.push(object);
        }
    }

    /// By their places in the text.
    fn in_order(mut self) -> impl Iterator<Item = Vec<&'s Object>> {
        self.all.sort_by_key(|copies| copies.first().map_or(0, |first| first.source.lo));
        self.all.into_iter()
    }
}

/// Told only of blocks that are written out: what a directive puts together may now and then have a single part.
fn few_parts(object: &Object, parts: &[Object], sources: &Sources) -> Option<Diagnostic> {
    if !is_plain_block(object.source, sources) {
        return None;
    }
    let word = object.word;
    let (message, help) = match parts {
        [] => (format!("this `{word}` holds no object"), "are the objects behind its `}`?".to_string()),
        [_] => {
            let message = format!("this `{word}` holds a single object, and changes nothing");
            (message, format!("is the second object behind its `}}`? otherwise leave out `{word} {{ … }}`"))
        }
        _ => return None,
    };
    let d = Diagnostic::new(codes::FEW_PARTS, object.source, message).help(help);
    Some(match parts {
        [part] => d.also(part.source, "all that is in it"),
        _ => d,
    })
}

/// Is there no directive in the block that begins at this place?
fn is_plain_block(source: Span, sources: &Sources) -> bool {
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

/// Does no ray meet any of its surfaces?
fn is_nothing(object: &Object) -> bool {
    if object.weight().shapes() > SHAPES {
        return false;
    }
    // (A transform that can't be undone is told when the world is built.)
    let Ok(probe) = Probe::new(object) else { return false };
    let bounds = probe.bounds();
    if bounds.is_empty() {
        return true;
    }
    bounds.is_finite() && is_missed(&probe, &bounds, FEW) && is_missed(&probe, &bounds, MANY)
}

/// Do all rays along the axes, so many across each side of the box, miss it?
fn is_missed(probe: &Probe, bounds: &Aabb, across: usize) -> bool {
    let (size, far) = (bounds.size(), bounds.size().max_element() + 1.0);
    (0..3).all(|axis| {
        let along = DVec3::AXES[axis];
        (0..across * across).all(|i| {
            // Not through the middle, where things that are drawn with round numbers have their edges.
            let part = |i: usize| (i as f64 + 0.4637) / across as f64;
            let mut at = DVec3::splat(0.0);
            at[(axis + 1) % 3] = part(i % across);
            at[(axis + 2) % 3] = part(i / across);
            let from = bounds.min + size * at - along * far;
            probe.trace(from, along).is_none()
        })
    })
}

fn nothing_left(object: &Object, op: CsgOp, parts: &[Object]) -> Diagnostic {
    let word = object.word;
    let first = usize::from(op == CsgOp::Difference);
    let without = |i: usize| {
        let others: Vec<Object> =
            parts.iter().enumerate().filter(|(j, _)| *j != i).map(|(_, part)| part.clone()).collect();
        let mut object = object.clone();
        object.kind = ObjectKind::Csg(op, others.into());
        object
    };
    // Without a guilty part, something is left.
    let guilty: Vec<&Object> =
        (first..parts.len().min(20)).filter(|&i| !is_nothing(&without(i))).filter_map(|i| parts.get(i)).collect();
    let d = Diagnostic::new(codes::NOTHING_LEFT, object.source, format!("nothing is left of this `{word}`"));
    if op == CsgOp::Difference {
        let help = "make what is taken away smaller, or move it";
        return match guilty[..] {
            [] => blamed(d, parts.get(first..).unwrap_or_default(), "this and others take it away").help(help),
            [part] => d.also(part.source, "this takes all of it away").help(help),
            _ => blamed(d, guilty, "this and others take it away").help(help),
        };
    }
    match (guilty.iter().find(|part| part.word == "plane"), &guilty[..]) {
        (Some(plane), _) => d
            .also(plane.source, "this cuts all of it off")
            .help("a plane holds the side that its normal points away from; `inverse` in it turns it around"),
        (None, [part]) => {
            d.also(part.source, "this has no point in common with the others").help("move it to where the others are")
        }
        _ => blamed(d, parts, "one of its parts")
            .help("its parts have no point in common: move them together, or join them with `union`"),
    }
}

/// With the places of the first few parts.
fn blamed<'a>(d: Diagnostic, parts: impl IntoIterator<Item = &'a Object>, label: &str) -> Diagnostic {
    parts.into_iter().take(3).fold(d, |d, part| d.also(part.source, label))
}
