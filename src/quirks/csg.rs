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
        "extent_boxes",
        "The boxes that `min_extent` and `max_extent` return are not the smallest ones: each transform is applied to the box of a CSG object, and not to its parts.",
        &["tests/lang/geometry.scene"],
    ),
    emulated(
        "infinite_shapes_vanish",
        "A shape with a number that is not finite is not seen, nor is an object that such a number transforms.",
        &["light_cases/infinite_shapes"],
    ),
    emulated(
        "intersection_box",
        "An `intersection` or `difference` is seen only by rays that meet the box that `min_extent` and `max_extent` \
         return, which can be \
         too small where parts of parts are inverted.",
        &["light_cases/csg_disc_halves"],
    ),
    emulated(
        "inverse_toggles",
        "Each `inverse` turns an object inside out again: two of them have no effect.",
        &["light_cases/csg_inverse_twice"],
    ),
    emulated("patch_never_clipped", "`clipped_by` has no effect on a `bicubic_patch`.", &["light_cases/patch_clipped"]),
    emulated(
        "textures_add_layers",
        "A `texture` in an object that has one already, perhaps from its declaration, adds layers to it.",
        &["light_cases/layers_apart"],
    ),
    emulated(
        "uv_mapping_of_group",
        "`uv_mapping` of a group of objects also applies to its parts, except those with an `interior_texture`.",
        &["light_cases/csg_uv_inside"],
    ),
];
