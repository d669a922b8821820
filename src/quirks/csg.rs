//! Unions, intersections, clipping, bounding, and which texture their surfaces show.

use super::{Quirk, differs, emulated};

pub(super) const QUIRKS: &[Quirk] = &[
    emulated(
        "bounded_by_box",
        "If `bounded_by` belongs to a single shape, the bounding box of the bounding objects is obeyed in place of \
         the objects.",
        &["light_cases/bounded_polynomials"],
    ),
    emulated(
        "bounded_by_exact",
        "`bounded_by` of a single cubic, quartic, poly or polynomial is obeyed as it is written: what is outside is \
         not seen.",
        &["light_cases/bounded_polynomials"],
    ),
    emulated(
        "bounded_by_ignored",
        "`bounded_by` of a single plane, blob, julia fractal or height field has no effect.",
        &["light_cases/bounded_polynomials"],
    ),
    differs(
        "camera_in_clipped",
        "A camera counts as inside an object although `clipped_by` removes that part of it, as long as the camera is \
         within the object's \
         bounding box.",
        "The camera is inside an object where the clipped object is.",
        &["tests/random/README.md"],
    ),
    emulated(
        "intersection_box",
        "An `intersection` or `difference` is seen only by rays that meet the box that `min_extent` and `max_extent` \
         return, which can be \
         too small where parts of parts are inverted.",
        &["light_cases/csg_disc_halves"],
    ),
    emulated("patch_never_clipped", "`clipped_by` has no effect on a `bicubic_patch`.", &["light_cases/patch_clipped"]),
];
