//! The words of the cameras: what the readers obey and the manual lists.

use crate::value::Kind::{Float, Nothing, Vector};
use crate::value::Vocabulary;
use crate::value::words::word;

/// POV-Ray's camera.
pub const PERSPECTIVE: Vocabulary = Vocabulary {
    block: "camera",
    summary: "where the picture is taken from; x to the right, y up, z away from you",
    words: &[
        word("location", Vector, "<0, 0, 0>", "the eye"),
        word("direction", Vector, "<0, 0, 1>", "from the eye to the middle of the picture; its length zooms"),
        word(
            "right",
            Vector,
            "<1.33, 0, 0>",
            "across the picture; its length over that of `up` is the shape of the picture",
        ),
        word("up", Vector, "<0, 1, 0>", "up the picture"),
        word("sky", Vector, "<0, 1, 0>", "which way `look_at` keeps upright"),
        word("look_at", Vector, "", "the point in the middle of the picture"),
        word("angle", Float, "", "how much is seen from left to right, in degrees, below 180"),
        word("perspective", Nothing, "", "this kind of camera, which it is anyway"),
    ],
    moves: true,
    idle: &[],
    not_drawn: &[
        "orthographic",
        "fisheye",
        "ultra_wide_angle",
        "omnimax",
        "panoramic",
        "cylinder",
        "spherical",
        "mesh_camera",
        "aperture",
        "blur_samples",
        "focal_point",
        "confidence",
        "variance",
        "normal",
        "bokeh",
        "smooth",
    ],
};

/// durer's own, right-handed.
pub const LECTURE: Vocabulary = Vocabulary {
    block: "camera",
    summary: "durer's own camera, right-handed: x to the right, y up, z towards you; the word `eye` makes it this one",
    words: &[
        word("eye", Vector, "<0, 0, 0>", "where it is"),
        word("center", Vector, "<0, 0, -1>", "the point in the middle of the picture"),
        word("up", Vector, "<0, 1, 0>", "which way is up"),
        word("fov_x", Float, "60", "how much is seen from left to right, in degrees; or by `fov_y` and square pixels"),
        word("fov_y", Float, "", "how much is seen from bottom to top, in degrees; or by `fov_x` and square pixels"),
    ],
    moves: true,
    idle: &[],
    not_drawn: &[],
};

/// All words of both.
pub(super) fn names() -> Vec<&'static str> {
    let own = LECTURE.words.iter().map(|w| w.name).filter(|name| *name != "up");
    let mut names = PERSPECTIVE.names();
    let at = names.len() - PERSPECTIVE.not_drawn.len();
    names.splice(at..at, own);
    names
}
