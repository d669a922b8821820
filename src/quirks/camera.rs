//! Cameras, anti-aliasing, focal blur.

use super::{Quirk, differing_quirk, emulated_quirk};

pub(super) const QUIRKS: &[Quirk] = &[
    emulated_quirk(
        "antialias_blocks",
        "Sampling method 1 works on blocks of 32 x 32 pixels, row by row; a pixel is compared with its left and upper \
         neighbours in their current state.",
        &["light_cases/antialias_blocks", "conformance/camera/orthographic.pov"],
    ),
    emulated_quirk(
        "antialias_depth",
        "Sampling method 2 with `+R1` does not subdivide: the depth counts the pixel itself.",
        &["light_cases/antialias_corners_r1", "light_cases/antialias_corners_r2"],
    ),
    emulated_quirk(
        "antialias_gamma",
        "Anti-aliasing compares the numbers of the scene after conversion to light and `Antialias_Gamma`.",
        &["src/render/antialias.rs::differences_count_as_in_pov_ray"],
    ),
    emulated_quirk(
        "antialias_threshold_0",
        "With threshold 0, sampling method 1 samples every pixel.",
        &["light_cases/antialias_threshold_0"],
    ),
    emulated_quirk("antialias_threshold_1", "A threshold above 1 counts as 1.", &["light_cases/antialias_threshold_1"]),
    emulated_quirk(
        "aperture_is_four_radii",
        "The radius of the lens is a quarter of `aperture`.",
        &["src/camera/focal_blur.rs::stops_where_pov_ray_does"],
    ),
    emulated_quirk(
        "bokeh",
        "`bokeh` distributes the rays of a pixel over a square lens by the brightness of its pigment from <0, 0> to \
         <1, 1>, with y down.",
        &["tests/suite/cameras.rs"],
    ),
    emulated_quirk(
        "camera_default_angle",
        "Curved projections without `angle` have an angle of 90 degrees.",
        &["light_cases/cam_fisheye"],
    ),
    emulated_quirk(
        "camera_normal_position",
        "The `normal` of a camera is evaluated at the position in the picture, from -0.5 to 0.5, or at the angles of \
         a curved projection.",
        &["light_cases/camera_normal", "light_cases/camera_normal_fisheye"],
    ),
    emulated_quirk(
        "camera_right_1_33",
        "The default `right` is 1.33*x, not 4/3*x.",
        &["light_cases/cam_default_right"],
    ),
    emulated_quirk(
        "camera_without_handedness",
        "A camera whose `right`, `up` and `direction` are in one plane counts as left-handed.",
        &["light_cases/cam_down"],
    ),
    emulated_quirk(
        "camera_without_ray",
        "Where a camera casts no ray, such as beside the disc of a fisheye, the picture is black, and transparent in \
         a picture that keeps alpha.",
        &["light_cases/cam_fisheye", "light_cases/cam_omnimax"],
    ),
    emulated_quirk(
        "camera_word_order",
        "The order of words in a `camera` does not matter since `#version 3.5`: `angle`, `look_at` and transforms \
         apply in this order.",
        &["light_cases/cam_rotate"],
    ),
    emulated_quirk(
        "camera_words_in_order",
        "Before `#version 3.5` each word of a `camera` takes effect where it is written: `look_at`, `angle`, \
         `orthographic` and transforms change the vectors so far, and later words replace them. The distance of \
         `focal_point` is taken from the `location` so far.",
        &["light_cases/cam_old_order", "light_cases/cam_old_orthographic"],
    ),
    emulated_quirk(
        "default_camera",
        "`camera` blocks start from the properties of the camera in `#default`; without a `camera` block that camera is \
         not used.",
        &["light_cases/camera_default", "light_cases/camera_default_unused"],
    ),
    emulated_quirk(
        "fisheye_disc",
        "Where `right` or `up` has length 1, the disc of a fisheye touches the picture's edge.",
        &["light_cases/cam_fisheye", "light_cases/cam_fisheye_z_up"],
    ),
    emulated_quirk(
        "focal_blur_convergence",
        "Focal blur stops adding rays to a pixel when the variance of its colour is low enough for the `confidence`.",
        &["src/camera/focal_blur.rs::stops_where_pov_ray_does"],
    ),
    emulated_quirk(
        "focal_blur_defaults",
        "`variance` is 1/10000 by default, not the 1/128 of the manual, and at least 7 rays are cast.",
        &["src/camera/focal_blur.rs::stops_where_pov_ray_does"],
    ),
    emulated_quirk(
        "focal_distance",
        "In focus is the plane straight ahead at the distance of `focal_point` from `location`, even if the point is to \
         the side or behind. The camera's transforms do not change this distance.",
        &["src/camera/povray.rs::focal_distance_is_euclidean"],
    ),
    emulated_quirk(
        "mesh_camera_bumps",
        "All rays of a mesh camera through one pixel have the bumps of one position.",
        &["light_cases/mesh_camera_layers"],
    ),
    differing_quirk(
        "mesh_camera_first_row",
        "POV-Ray shows the first row of faces of a mesh camera twice, and shifts the last column by uv by half a \
         pixel.",
        "Each face has one pixel.",
        &["tests/suite/cameras.rs"],
    ),
    emulated_quirk(
        "mesh_camera_location",
        "Of a mesh camera's `location` and `direction` only z counts: the distance before the face, and the sign of \
         the direction.",
        &["light_cases/mesh_camera"],
    ),
    emulated_quirk(
        "nan_pixel_is_black",
        "A pixel with a sample that is not a number is black.",
        &["light_cases/nan_patterns"],
    ),
    emulated_quirk(
        "omnimax_formula",
        "The angle to the axis of an `omnimax` camera is a polynomial of the distance from the centre; directions \
         more than 45 degrees below the axis are black.",
        &["light_cases/cam_omnimax"],
    ),
    emulated_quirk(
        "orthographic_window",
        "Without `right` and `up`, or with `angle`, even `angle 0`, the window of an orthographic camera is as large as \
         that of a perspective camera at `look_at`.",
        &[
            "light_cases/cam_orthographic",
            "light_cases/cam_orthographic_in_plane",
            "light_cases/cam_orthographic_angle_0",
        ],
    ),
    emulated_quirk(
        "panoramic_formula",
        "A `panoramic` camera ignores `angle`; the lengths of `right`, `up` and `direction` determine its scale.",
        &["light_cases/cam_panoramic"],
    ),
    emulated_quirk(
        "spherical_skew",
        "A `spherical` camera rotates its direction about `right` and then about `up`, even if these are not \
         orthogonal.",
        &["light_cases/cam_skew", "light_cases/cam_spherical"],
    ),
    emulated_quirk(
        "ultra_wide_angle_formula",
        "Both angles of an `ultra_wide_angle` camera are proportional to the position in the picture.",
        &["light_cases/cam_ultra_wide_angle"],
    ),
];
