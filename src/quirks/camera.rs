//! Cameras, anti-aliasing, focal blur.

use super::{Quirk, emulated};

pub(super) const QUIRKS: &[Quirk] = &[
    emulated(
        "antialias_blocks",
        "Sampling method 1 works on blocks of 32 x 32 pixels, row by row; a pixel is compared with its left and upper \
         neighbours in their current state.",
        &["conformance/camera/orthographic.pov"],
    ),
    emulated(
        "antialias_depth",
        "Sampling method 2 with `+R1` does not subdivide: the depth counts the pixel itself.",
        &["tests/suite/lowering.rs"],
    ),
    emulated(
        "antialias_gamma",
        "Anti-aliasing compares the numbers of the scene after conversion to light and `Antialias_Gamma`.",
        &["src/render/antialias.rs::differences_count_as_in_pov_ray"],
    ),
    emulated(
        "antialias_threshold_0",
        "With threshold 0, sampling method 1 samples every pixel.",
        &["src/render/antialias.rs::differences_count_as_in_pov_ray"],
    ),
    emulated(
        "antialias_threshold_1",
        "With a threshold of 1 or more, sampling method 1 takes no more samples.",
        &["src/render/antialias.rs::differences_count_as_in_pov_ray"],
    ),
    emulated(
        "camera_without_ray",
        "Where a camera casts no ray, such as beside the disc of a fisheye, the picture is black, and transparent in \
         a picture that keeps alpha.",
        &["light_cases/cam_fisheye", "light_cases/cam_omnimax"],
    ),
    emulated(
        "focal_blur_convergence",
        "Focal blur stops adding rays to a pixel when the variance of its colour is low enough for the `confidence`.",
        &["src/camera/focal_blur.rs::stops_where_pov_ray_does"],
    ),
    emulated(
        "nan_pixel_is_black",
        "A pixel with a sample that is not a number is black.",
        &["light_cases/nan_patterns"],
    ),
];
