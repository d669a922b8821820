//! Warnings about media that cannot show.

use crate::diagnostic::{Diagnostic, codes};
use crate::scene::{Object, ObjectKind, Scene};
use crate::source::Span;
use rustc_hash::FxHashSet;
use std::sync::Arc;

/// Maximum number of warnings about media.
const MAX_WARNINGS: usize = 5;

/// Returns warnings about media in objects that are not `hollow`.
pub(super) fn solid_media_warnings(scene: &Scene) -> Vec<Diagnostic> {
    let mut search = Search::default();
    scene.objects.iter().for_each(|object| search.examine(object, false));
    let warning = |(media, object): &(Span, Span)| {
        let text = "these media show nothing, because the object is not `hollow`";
        Diagnostic::new(codes::SOLID_MEDIA, *media, text).also(*object, "add `hollow` to this object")
    };
    search.found.iter().map(warning).collect()
}

/// Search for media in solid objects.
#[derive(Default)]
struct Search {
    /// Spans of media, each with the span of the first solid object that holds them.
    found: Vec<(Span, Span)>,
    /// Addresses of the examined parts of groups that have copies, each within hollow or within solid groups. Copies
    /// share their parts, so that a scene can have far more parts than memory.
    examined: FxHashSet<(*const Object, bool)>,
}

impl Search {
    /// Examines an object and its parts; `is_hollow` is true within a hollow group.
    fn examine(&mut self, object: &Object, is_hollow: bool) {
        if self.found.len() >= MAX_WARNINGS {
            return;
        }
        let is_hollow = is_hollow || object.uncommon.flags.hollow;
        let parts: &[Object] = match &object.kind {
            ObjectKind::Csg(_, parts) => {
                let has_copies = Arc::strong_count(parts) > 1 || Arc::strong_count(&object.body) > 1;
                if has_copies && !self.examined.insert((parts.as_ptr(), is_hollow)) {
                    return;
                }
                parts
            }
            _ => &[],
        };
        let media = object.uncommon.interior.as_ref().and_then(|interior| interior.media.first());
        let has_hollow_part = parts.iter().any(|part| part.uncommon.flags.hollow);
        if let Some(media) = media.filter(|_| !is_hollow && !has_hollow_part)
            && self.found.iter().all(|(known, _)| *known != media.source)
        {
            self.found.push((media.source, object.source));
        }
        parts.iter().for_each(|part| self.examine(part, is_hollow));
    }
}
