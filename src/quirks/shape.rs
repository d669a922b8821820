//! Shapes: hits, inside, normals, uv, boxes.

use super::{Quirk, differs, emulated};

pub(super) const QUIRKS: &[Quirk] = &[
    emulated(
        "blob_min_distance",
        "Rays do not hit a blob closer than 0.01 to their origin; for other shapes that distance is 0.0001.",
        &["light_cases/blob_thin_glass"],
    ),
    emulated(
        "blob_textures_move",
        "The textures of a blob's components move with the blob, even under `uv_mapping`, which keeps other textures \
         in place.",
        &["light_cases/uv_fixed"],
    ),
    emulated(
        "blob_textures_on_both_sides",
        "If a component of a blob has a texture, the blob's `interior_texture` is ignored.",
        &["light_cases/shadow_of_interior_texture"],
    ),
    differs(
        "flat_triangle_sides",
        "Which side of a single `triangle` shows its `interior_texture` depends on each transform between the \
         triangle and the scene.",
        "The order of the three corners alone decides.",
        &["light_cases/csg_polygon_sides"],
    ),
    emulated(
        "inside_margins",
        "`inside()` and CSG count points 1e-10 beyond a plane as inside; closed cylinders and cones end 1e-10 before their surface, open ones 1e-10 beyond their ends.",
        &["tests/lang/geometry.scene"],
    ),
    emulated("mesh_single_precision", "The corners of meshes have single precision.", &["light_cases/mesh_camera"]),
    emulated(
        "own_space_min_distance",
        "Rays do not hit tori, superellipsoids, cubics, quartics and polynomials closer than 0.0001 to their origin in units of the space of the shape.",
        &["light_cases/near_own_space"],
    ),
    emulated("plane_max_distance", "Rays do not hit a plane farther away than 1e7.", &["light_cases/plane_ends"]),
    emulated(
        "polynomial_inside_margin",
        "A polynomial surface contains the points where its polynomial is less than 1e-4.",
        &["tests/lang/geometry.scene"],
    ),
    emulated(
        "quadric_keeps_sides",
        "`inverse` does not exchange `texture` and `interior_texture` of a quadric, as it does for other shapes.",
        &["light_cases/interior_texture_quadric_inverse"],
    ),
    differs(
        "smooth_triangle_normal_steps",
        "The normals of a single `smooth_triangle` get length 1 at each `scale`; other transforms that stretch them \
         change their lengths, \
         and a triangle that one transform twists is lost, whatever follows.",
        "Normals get length 1 under the whole transform, as they do in meshes.",
        &["light_cases/smooth_stretched"],
    ),
    emulated(
        "smooth_triangle_normals",
        "The normals of a `smooth_triangle` have length 1 after scaling, before they are interpolated.",
        &["light_cases/smooth_stretched", "light_cases/twisted_by_scale"],
    ),
    emulated(
        "text_layout",
        "In a `text`, kerning pairs of an unsorted table are found too, and composite glyphs are shifted to the right by their left bearing.",
        &["src/font/tests.rs::kerning_pairs_need_not_be_sorted"],
    ),
];
