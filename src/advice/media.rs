//! Warnings about media that cannot show.

use crate::diagnostic::{Diagnostic, codes};
use crate::scene::{Object, ObjectKind, Scene};
use crate::source::Span;

/// Maximum number of warnings about media.
const MAX_WARNINGS: usize = 5;

/// Returns warnings about media in objects that are not `hollow`.
pub(super) fn solid_media_warnings(scene: &Scene) -> Vec<Diagnostic> {
    let mut found = vec![];
    scene.objects.iter().for_each(|object| add_solid_media(object, false, &mut found));
    let warning = |(media, object): &(Span, Span)| {
        let d =
            Diagnostic::new(codes::SOLID_MEDIA, *media, "these media show nothing, because the object is not `hollow`");
        d.also(*object, "add `hollow` to this object")
    };
    found.iter().map(warning).collect()
}

/// Adds the spans of media and of the object for each solid object with media; `is_hollow` is true within a hollow
/// group.
fn add_solid_media(object: &Object, is_hollow: bool, found: &mut Vec<(Span, Span)>) {
    let is_hollow = is_hollow || object.uncommon.flags.hollow;
    let parts: &[Object] = match &object.kind {
        ObjectKind::Csg(_, parts) => parts,
        _ => &[],
    };
    let media = object.uncommon.interior.as_ref().and_then(|interior| interior.media.first());
    let has_hollow_part = parts.iter().any(|part| part.uncommon.flags.hollow);
    if let Some(media) = media.filter(|_| !is_hollow && !has_hollow_part)
        && found.len() < MAX_WARNINGS
        && found.iter().all(|(known, _)| *known != media.source)
    {
        found.push((media.source, object.source));
    }
    parts.iter().for_each(|part| add_solid_media(part, is_hollow, found));
}
