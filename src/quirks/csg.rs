//! Unions, intersections, clipping, bounding, and which texture their surfaces show.

use super::{Quirk, differing_quirk, emulated_quirk};

pub(super) const QUIRKS: &[Quirk] = &[
    emulated_quirk(
        "bounded_by_box",
        "If `bounded_by` belongs to a single shape, the bounding box of the bounding objects is obeyed in place of \
         the objects.",
        &["light_cases/bounded_polynomials"],
    ),
    emulated_quirk(
        "bounded_by_exact",
        "`bounded_by` of a single cubic, quartic, poly or polynomial is obeyed as it is written: what is outside is \
         not seen.",
        &["light_cases/bounded_polynomials"],
    ),
    emulated_quirk(
        "bounded_by_ignored",
        "`bounded_by` of a single plane, blob, julia fractal or height field has no effect.",
        &["light_cases/bounded_polynomials"],
    ),
    emulated_quirk(
        "bounded_by_trusted",
        "A ray that misses every object of `bounded_by` hits nothing of the bounded object, even where the object \
         extends beyond.",
        &["light_cases/bounded_polynomials"],
    ),
    differing_quirk(
        "camera_in_clipped",
        "A camera counts as inside an object although `clipped_by` removes that part of it, as long as the camera is \
         within the object's \
         bounding box.",
        "The camera is inside an object where the clipped object is.",
        &["tests/random/README.md"],
    ),
    emulated_quirk(
        "camera_inside_box",
        "A camera is inside an object whose inside is infinite, such as an inverted sphere or the half-space of a \
         disc, only within the bounding box of its surface; and inside an object with `bounded_by`, or an intersection \
         with a finite box, only within that box.",
        &[
            "light_cases/camera_in_inverse",
            "light_cases/camera_in_endless_blob",
            "light_cases/fog_inverse_quadric",
            "light_cases/camera_beside_bounds",
            "light_cases/camera_beside_bounded_by",
        ],
    ),
    differing_quirk(
        "coplanar_boxes",
        "Of boxes of different sizes with faces in one plane, the one that POV-Ray's bounding hierarchy tests first shows.",
        "The box that comes first in the scene shows.",
        &["light_cases/coplanar_boxes"],
    ),
    emulated_quirk(
        "csg_extent_boxes",
        "The boxes that `min_extent` and `max_extent` return are not the smallest ones: each transform is applied to the box of a CSG object, and not to its parts.",
        &["tests/lang/geometry.scene"],
    ),
    emulated_quirk(
        "csg_parts_share_interior",
        "Parts of a CSG object without an `interior` share one interior, also in a union: a ray that leaves one part \
         and enters another is not refracted.",
        &["light_cases/glass_union", "light_cases/csg_merge_parts"],
    ),
    emulated_quirk(
        "cutaway_without_texture",
        "With `cutaway_textures`, a part without a texture shows on its cut surfaces the textures of the parts that \
         it cuts; the parts that a `difference` removes are not cut.",
        &["light_cases/csg_cutaway", "light_cases/csg_cutaway_hole", "light_cases/csg_cutaway_joined"],
    ),
    emulated_quirk(
        "empty_intersection",
        "An empty `intersection` has no surface, but every camera is inside it.",
        &["light_cases/empty_intersection"],
    ),
    emulated_quirk(
        "first_object_wins",
        "Of several surfaces at one point, that of an infinite object is seen, then that of the object that was \
         declared first.",
        &["light_cases/same_place"],
    ),
    emulated_quirk(
        "hollow_of_last_part",
        "Whether the inside of a CSG object without an `interior` is `hollow` is decided by its last part.",
        &["light_cases/hollow_last"],
    ),
    emulated_quirk(
        "infinite_shapes_vanish",
        "A shape with a number that is not finite is not seen, except a `box` with an infinite corner, nor is an \
         object that such a number transforms.",
        &["light_cases/infinite_shapes"],
    ),
    emulated_quirk(
        "interior_texture_of_group",
        "`interior_texture` of a CSG object also applies to parts that have a texture of their own.",
        &["light_cases/csg_interior_texture_parent"],
    ),
    emulated_quirk(
        "intersection_box",
        "An `intersection` or `difference` is seen only by rays that meet the box that `min_extent` and `max_extent` \
         return, which can be \
         too small where parts of parts are inverted.",
        &["light_cases/csg_disc_halves"],
    ),
    emulated_quirk(
        "inverse_toggles",
        "Each `inverse` turns an object inside out again: two of them have no effect.",
        &["light_cases/csg_inverse_twice"],
    ),
    emulated_quirk(
        "last_part_wins",
        "Of several surfaces of one CSG object at one point, that of the last part is seen.",
        &["light_cases/csg_cutaway_overlap", "light_cases/same_place"],
    ),
    emulated_quirk(
        "no_image_in_union",
        "Parts of a union or merge with `no_image` or `no_reflection` are hidden from those rays and hide no other \
         part of a merge, but still belong to the inside of what is around.",
        &["light_cases/merge_no_image", "light_cases/union_no_reflection", "light_cases/no_image_within"],
    ),
    emulated_quirk(
        "patch_never_clipped",
        "`clipped_by` has no effect on a `bicubic_patch`.",
        &["light_cases/patch_clipped"],
    ),
    emulated_quirk(
        "textures_add_layers",
        "A `texture` in an object that has one already, perhaps from its declaration, adds layers to it.",
        &["light_cases/layers_apart"],
    ),
    emulated_quirk(
        "uv_mapping_of_group",
        "`uv_mapping` of a group of objects also applies to its parts, except those with an `interior_texture`.",
        &["light_cases/csg_uv_inside"],
    ),
];
