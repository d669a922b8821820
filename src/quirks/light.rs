//! Lights, shadows, and what light does on its way.

use super::{Quirk, differs, emulated};

pub(super) const QUIRKS: &[Quirk] = &[
    differs(
        "remembered_occluder",
        "POV-Ray asks the object that last blocked a light first, and what that object transmits is counted twice, so a shadow depends \
         on the pixels drawn before.",
        "A pixel of durer depends on the scene, the options and its position alone; the surfaces along a shadow ray each count once.",
        &["tests/random/README.md"],
    ),
    emulated(
        "shadow_by_outside",
        "Meshes and blobs cast shadows by their outer texture alone, whatever their `interior_texture` transmits.",
        &["light_cases/shadow_of_interior_texture"],
    ),
    emulated(
        "shadow_min_distance",
        "A shadow ray ignores hits closer than 0.001 to either of its ends.",
        &["light_cases/shadow_thin"],
    ),
];
