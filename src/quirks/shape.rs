//! Shapes: hits, inside, normals, uv, boxes.

use super::{Quirk, differing_quirk, emulated_quirk};

pub(super) const QUIRKS: &[Quirk] = &[
    emulated_quirk(
        "blob_component_boxes",
        "The bounding box of a blob is made of cubes around its components; the cube of a sphere that is transformed \
         by anything but translation, rotation and uniform scale grows to the longest side of its image.",
        &["tests/library/values.scene"],
    ),
    emulated_quirk(
        "blob_min_distance",
        "Rays do not hit a blob closer than 0.01 to their origin; for other shapes that distance is 0.0001.",
        &["light_cases/blob_thin_glass"],
    ),
    emulated_quirk(
        "blob_textures_move",
        "The textures of a blob's components move with the blob, even under `uv_mapping`, which keeps other textures \
         in place.",
        &["light_cases/uv_fixed"],
    ),
    emulated_quirk(
        "blob_textures_on_both_sides",
        "If a component of a blob has a texture, the blob's `interior_texture` is ignored.",
        &["light_cases/shadow_of_interior_texture"],
    ),
    differing_quirk(
        "blob_thin_components",
        "A blob of thousands of thin components has holes, where rays pass many components.",
        "Every component is hit.",
        &["light_cases/blob_thin_components"],
    ),
    emulated_quirk(
        "cone_negative_radii",
        "A `cone` with two negative radii is a cylinder of the smaller one, one negative radius with 0 is nothing, \
         and radii of different signs make an hourglass.",
        &["light_cases/csg_cone_of_quadric"],
    ),
    emulated_quirk(
        "extent_boxes",
        "`min_extent` and `max_extent` return boxes by rules of each shape, which are not always the smallest: \
         infinite shapes have 1e10, flat ones a thickness of 0.001, cones and cylinders the box of a cylinder, \
         splines that of their control points.",
        &["tests/library/values.scene"],
    ),
    differing_quirk(
        "far_hits",
        "Spheres, triangles and most other shapes farther away than 1e7 are not hit and cast no shadows; boxes are hit.",
        "Only planes end there, because each shape would need a test of its own.",
        &["light_cases/far_away"],
    ),
    differing_quirk(
        "flat_triangle_sides",
        "The order of the corners decides which side of a single `triangle` is its outside only without a transform. \
         After a transform the outside is the side towards -x, +y or -z, whichever axis is closest to the normal, in the \
         coordinates before the last transform.",
        "The coordinates are those before the first transform.",
        &["light_cases/triangle_sides", "src/shape/triangle.rs::outside_of_transformed_triangle"],
    ),
    emulated_quirk(
        "height_field_function_precision",
        "The heights of `function` in a height field are rounded to single precision before they become 16 bits.",
        &["light_cases/height_field_single_precision"],
    ),
    emulated_quirk(
        "height_field_heights",
        "Palette indices are heights by themselves, colours of 16 bits count by their brightness, and of other \
         colours red is the higher and green the lower byte of a height.",
        &["light_cases/function_image_bits", "src/shape/height_field/tests.rs::heights_follow_from_pixels"],
    ),
    emulated_quirk(
        "height_field_inside",
        "The inside of a height field is what is below its surface or its water, without a bottom.",
        &["src/shape/height_field/tests.rs::heights_of_corners_and_triangles"],
    ),
    emulated_quirk(
        "height_field_normals",
        "Normals of a `smooth` height field are means over neighbours and are stored in 16 bits a coordinate.",
        &["src/shape/height_field/tests.rs::smooth_normals_as_povray_has_them"],
    ),
    emulated_quirk(
        "hypercomplex_cube",
        "`hypercomplex cube` squares in a julia fractal.",
        &["conformance/objects/fractal1.pov"],
    ),
    differing_quirk(
        "hypercomplex_functions",
        "Hypercomplex Julia fractals of other functions than `sqr` have hits up to a step of 1/`precision` off the \
         surface, specks on the ball of radius 4, and normals in other directions than the gradient of the orbit's length.",
        "Hits are exact, and normals are gradients: rounding decides where POV-Ray's specks are, and its normals \
         follow no product of two iterates or derivatives.",
        &["light_cases/julia_transcendental"],
    ),
    emulated_quirk(
        "infinite_box",
        "A `box` with an infinite corner has no end there.",
        &["light_cases/infinite_boxes"],
    ),
    emulated_quirk(
        "inside_margins",
        "`inside()` and CSG count points 1e-10 beyond a plane as inside; closed cylinders and cones end 1e-10 before their surface, open ones 1e-10 beyond their ends.",
        &["tests/lang/geometry.scene"],
    ),
    emulated_quirk(
        "isosurface_csg_shadows",
        "At each transparent surface that a shadow ray passes, `max_trace` counts the hits on an isosurface in CSG anew.",
        &["light_cases/isosurface_csg_shadow"],
    ),
    emulated_quirk(
        "isosurface_hits",
        "A ray hits an isosurface at the end of a piece of the ray shorter than `accuracy`, slightly behind the \
         surface; the search goes on five times `accuracy` behind each hit.",
        &["light_cases/isosurface_accuracy"],
    ),
    emulated_quirk(
        "isosurface_normal",
        "Normals of an isosurface are differences over a step of `accuracy`.",
        &["light_cases/isosurface_accuracy"],
    ),
    emulated_quirk(
        "isosurface_start",
        "A ray that enters the container of an isosurface closer than 1e-6 starts inside it.",
        &["light_cases/isosurface_accuracy"],
    ),
    emulated_quirk(
        "julia_escape_radius",
        "An orbit of a julia fractal has escaped at the radius 1 + |c| for quaternions, and 4 for hypercomplex \
         numbers.",
        &["conformance/objects/fractal1.pov"],
    ),
    emulated_quirk(
        "julia_normal",
        "Normals of a julia fractal ignore the fourth dimension, even if the slice makes it depend on the others.",
        &["conformance/objects/fractal1.pov"],
    ),
    emulated_quirk(
        "lathe_inner_radius",
        "No point closer to the axis than the smallest radius of a `lathe` is inside, even if the lathe is open at both ends.",
        &["src/shape/lathe.rs::outside_near_the_axis", "light_cases/lathe_open"],
    ),
    emulated_quirk(
        "lathe_uv",
        "v of a lathe or sor runs along the curve, where all segments count as equally long.",
        &["light_cases/lathe_uv"],
    ),
    emulated_quirk(
        "mesh_single_precision",
        "The corners of meshes have single precision.",
        &["light_cases/mesh_camera"],
    ),
    emulated_quirk(
        "mesh_without_uv",
        "Triangles of a mesh without uv vectors have the coordinates (0, 0).",
        &["light_cases/mesh_uv_flag"],
    ),
    emulated_quirk(
        "negative_torus",
        "A `torus` with a negative radius shows parts of the ring, only to rays that hit the outer wall or the lids \
         of a pipe around it.",
        &["src/shape/torus.rs::negative_radii"],
    ),
    emulated_quirk(
        "open_wall_inside",
        "The wall of an `open` cylinder or cone is inside: where two such walls coincide, a difference shows the wall that is taken away, and nothing once it is taken away twice.",
        &["src/shape/cylinder.rs::inside_of_open_and_closed", "light_cases/open_walls"],
    ),
    emulated_quirk(
        "ovus_shape",
        "The band between the two balls of an `ovus` is an arc with twice the larger radius.",
        &["src/shape/ovus.rs::as_pov_ray_traces"],
    ),
    emulated_quirk(
        "ovus_uv",
        "v of an ovus is the angle seen from the middle of its height.",
        &["src/shape/ovus.rs::as_pov_ray_traces"],
    ),
    emulated_quirk(
        "own_space_min_distance",
        "Rays do not hit tori, superellipsoids, cubics, quartics and polynomials closer than 0.0001 to their origin in units of the space of the shape.",
        &["light_cases/near_own_space"],
    ),
    differing_quirk(
        "parametric_accuracy",
        "A `parametric` with a coarse `accuracy` is blocky, swollen or has holes.",
        "Hits are exact; `accuracy` is only the size of details that may be lost.",
        &["light_cases/parametric_coarse"],
    ),
    emulated_quirk(
        "parametric_in_csg",
        "In CSG only the first hit of a ray on a `parametric` counts.",
        &["light_cases/parametric_in_csg"],
    ),
    emulated_quirk(
        "parametric_normal",
        "The normal of a `parametric` is the cross product of its derivatives by u and v.",
        &["light_cases/parametric_normal"],
    ),
    emulated_quirk(
        "patch_flatness",
        "A bicubic patch is flat where no control point is farther than `flatness` from a plane through three \
         corners; normals at corners depend on neighbouring control points.",
        &["src/shape/bicubic_patch/mod.rs::collapsed_edges"],
    ),
    emulated_quirk(
        "patch_under_transform",
        "Flatness and normals of a bicubic patch are evaluated after its transforms.",
        &["src/shape/bicubic_patch/mod.rs::as_flat_as_pov_ray_draws"],
    ),
    emulated_quirk("plane_max_distance", "Rays do not hit a plane farther away than 1e7.", &["light_cases/plane_ends"]),
    emulated_quirk(
        "polygon_side",
        "The outside of a polygon depends on its first point, the next different one and the first that is not \
         collinear.",
        &["light_cases/csg_polygon_sides"],
    ),
    emulated_quirk(
        "polynomial_inside_margin",
        "A polynomial surface contains the points where its polynomial is less than 1e-4.",
        &["tests/lang/geometry.scene"],
    ),
    emulated_quirk(
        "quadric_keeps_sides",
        "`inverse` does not exchange `texture` and `interior_texture` of a quadric, as it does for other shapes.",
        &["light_cases/interior_texture_quadric_inverse"],
    ),
    differing_quirk(
        "rotated_infinite_box",
        "A rotated `box` with an infinite corner is lost, or a part of it if it belongs to an `intersection` or \
         `difference`; its `max_extent` is not a number.",
        "The whole box is drawn, and `min_extent` and `max_extent` end at 1e10.",
        &["light_cases/infinite_boxes_rotated"],
    ),
    differing_quirk(
        "smooth_triangle_normal_steps",
        "The normals of a single `smooth_triangle` get length 1 at each `scale`; other transforms that stretch them \
         change their lengths, \
         and a triangle that one transform twists is lost, whatever follows.",
        "Normals get length 1 under the whole transform, as they do in meshes.",
        &["light_cases/smooth_stretched"],
    ),
    emulated_quirk(
        "smooth_triangle_normals",
        "The normals of a `smooth_triangle` have length 1 after scaling, before they are interpolated.",
        &["light_cases/smooth_stretched", "light_cases/twisted_by_scale"],
    ),
    differing_quirk(
        "sor_sturm",
        "A ray that starts on a `sor` with `sturm`, behind the surface by less than about 1e-11, misses the next hit on the \
         same segment if that is the only one ahead: a sixth of the rays that pass a transparent `sor`.",
        "`sturm` has no effect: all surfaces are hit. Rounding errors of POV-Ray's hit points decide which rays miss, so \
         its pictures show noise.",
        &["light_cases/sor_sturm_transparent"],
    ),
    emulated_quirk(
        "sphere_sweep_negative_radius",
        "Where the radius of a sphere sweep is negative, normals point to the centre.",
        &["src/shape/sphere_sweep/mod.rs::as_pov_ray_traces"],
    ),
    emulated_quirk(
        "surface_min_distance",
        "Rays ignore hits closer than 0.0001 to their origin, in world units.",
        &["light_cases/near_own_space"],
    ),
    emulated_quirk(
        "sweep_normal_side",
        "Normals of lathes and prisms point to the right of the curve's direction, those of a prism with \
         `bezier_spline` to the left.",
        &["light_cases/prism_bezier_inside"],
    ),
    emulated_quirk(
        "text_layout",
        "In a `text`, kerning pairs of an unsorted table are found too, and composite glyphs are shifted to the right by their left bearing.",
        &["src/font/tests.rs::kerning_pairs_need_not_be_sorted"],
    ),
    emulated_quirk(
        "text_tilt",
        "Letters are rotated by 0.001 degrees about each axis.",
        &["src/shape/text/tests.rs::letters_lean"],
    ),
    emulated_quirk(
        "text_walls",
        "Normals of the walls of letters point inwards.",
        &["src/shape/text/tests.rs::walls_point_inwards"],
    ),
    emulated_quirk(
        "text_without_depth",
        "Letters with a `depth` of 0 or below have both ends and no inside.",
        &["src/shape/text/tests.rs::of_a_negative_depth_only_the_ends_are_left"],
    ),
    emulated_quirk(
        "torus_uv",
        "v of a torus runs around the tube from the inside of the hole.",
        &["src/shape/torus.rs::uv_around_ring_and_tube"],
    ),
    emulated_quirk(
        "twisted_smooth_triangle",
        "A `smooth_triangle` whose normals point to both sides after its transforms is left out.",
        &["light_cases/twisted_by_scale"],
    ),
    emulated_quirk(
        "uv_of_world_point",
        "For a shape without a uv mapping, `uv_mapping` uses x and y of the point in world space.",
        &["light_cases/uv_fixed", "light_cases/default_uv"],
    ),
    emulated_quirk(
        "water_level_depth",
        "`water_level` removes what is more than 0.001 of a step of height below it.",
        &["src/shape/height_field/tests.rs::heights_of_corners_and_triangles"],
    ),
];
