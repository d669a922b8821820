//! Words of the cameras, for the readers and the manual.

use super::focal_blur::BLUR_ROWS;
use super::lecture::{LectureCamera, read_field_of_view_degrees};
use super::povray::{Kind, PovrayCamera};
use crate::value::ValueKind::{Block, Float, Nothing, Vector};
use crate::value::words::{Row, joined, set, specs, word};
use crate::value::{Spec, WordSpec};

/// Words of POV-Ray's camera block, and how each is read.
pub(super) const POVRAY_ROWS: &[Row<PovrayCamera>] = &[
    word("location", Vector, "<0, 0, 0>", "the eye").sets(|s, r| set(&mut s.location, r.vector())),
    word("direction", Vector, "<0, 0, 1>", "from the eye to the middle of the picture; its length zooms")
        .sets(|s, r| set(&mut s.direction, r.vector())),
    word(
        "right",
        Vector,
        "<1.33, 0, 0>",
        "across the picture; its length over that of `up` is the shape of the picture",
    )
    .sets(|s, r| set(&mut s.sized, Ok(true)).and(set(&mut s.right, r.vector()))),
    word("up", Vector, "<0, 1, 0>", "up the picture")
        .sets(|s, r| set(&mut s.sized, Ok(true)).and(set(&mut s.up, r.vector()))),
    word("sky", Vector, "<0, 1, 0>", "which way `look_at` keeps upright").sets(|s, r| set(&mut s.sky, r.vector())),
    word("look_at", Vector, "", "the point in the middle of the picture")
        .sets(|s, r| set(&mut s.look_at, r.vector().map(Some))),
    word(
        "angle",
        Float,
        "",
        "how much is seen from left to right, in degrees; and of a `spherical` camera, from bottom to top",
    )
    .sets(PovrayCamera::read_angle),
];

/// Words of camera projections, and how each is read.
pub(super) const KIND_ROWS: &[Row<PovrayCamera>] = &[
    word("perspective", Nothing, "", "rays from one point through a flat window: this kind of camera it is anyway")
        .sets(|s, _| set(&mut s.kind, Ok(Kind::Perspective))),
    word("orthographic", Nothing, "", "parallel rays: nothing gets smaller with the distance")
        .sets(|s, _| set(&mut s.kind, Ok(Kind::Orthographic))),
    word("fisheye", Nothing, "", "a disc of directions; `angle` is that of the whole disc")
        .sets(|s, _| set(&mut s.kind, Ok(Kind::Fisheye))),
    word("ultra_wide_angle", Nothing, "", "a fisheye that fills the picture")
        .sets(|s, _| set(&mut s.kind, Ok(Kind::UltraWideAngle))),
    word("omnimax", Nothing, "", "half a turn for a dome; takes no `angle`")
        .sets(|s, _| set(&mut s.kind, Ok(Kind::Omnimax))),
    word("panoramic", Nothing, "", "half a turn on a cylinder; takes no `angle`")
        .sets(|s, _| set(&mut s.kind, Ok(Kind::Panoramic))),
    word(
        "cylinder",
        Float,
        "",
        "on a cylinder, upright (1, 3) or lying (2, 4); with types 3 and 4 the eye moves along it",
    )
    .sets(PovrayCamera::read_cylinder_type),
    word("spherical", Nothing, "", "longitude and latitude; `angle` takes two numbers, 360 and 180 if none is said")
        .sets(|s, _| set(&mut s.kind, Ok(Kind::Spherical))),
];

/// Words of camera projections, for the manual.
pub const KINDS: &[WordSpec] = specs!(KIND_ROWS);

/// Words of the camera block that have blocks of their own: mesh camera, `normal` and `bokeh`.
const BLOCKS: &[WordSpec] = &[
    word(
        "mesh_camera",
        Block,
        "",
        "rays from the faces of meshes: `mesh_camera { rays distribution [distance] mesh { … } … [smooth] }`",
    ),
    word(
        "normal",
        Block,
        "",
        "turns the rays as bumps turn a surface's normal; the pattern lies in the picture, from -0.5 to 0.5",
    ),
    word(
        "bokeh",
        Block,
        "",
        "`bokeh { pigment { … } }`: a square lens, as light as the pigment from <0, 0> to <1, 1>; without it, it is a disc",
    ),
];

/// Words of focal blur, for the manual.
pub const BLUR: &[WordSpec] = specs!(BLUR_ROWS);

/// Description of POV-Ray's camera block.
pub const POVRAY: Spec = Spec {
    name: "camera",
    summary: "where the picture is taken from; x to the right, y up, z away from you",
    words: &joined::<{ POVRAY_ROWS.len() + BLOCKS.len() + KINDS.len() + BLUR.len() }>(
        &joined::<{ POVRAY_ROWS.len() + BLOCKS.len() }>(specs!(POVRAY_ROWS), BLOCKS),
        &joined::<{ KINDS.len() + BLUR.len() }>(KINDS, BLUR),
    ),
    has_transforms: true,
    ..Spec::EMPTY
};

/// Words of the lecture's camera, and how each is read.
pub(super) const LECTURE_ROWS: &[Row<LectureCamera>] = &[
    word("eye", Vector, "<0, 0, 0>", "where it is").sets(|s, r| set(&mut s.eye, r.vector())),
    word("center", Vector, "<0, 0, -1>", "the point in the middle of the picture")
        .sets(|s, r| set(&mut s.center, r.vector())),
    word("up", Vector, "<0, 1, 0>", "which way is up").sets(|s, r| set(&mut s.up, r.vector())),
    word("fov_x", Float, "60", "how much is seen from left to right, in degrees; or by `fov_y` and square pixels")
        .sets(|s, r| set(&mut s.fov_x, read_field_of_view_degrees("fov_x", r).map(Some))),
    word("fov_y", Float, "", "how much is seen from bottom to top, in degrees; or by `fov_x` and square pixels")
        .sets(|s, r| set(&mut s.fov_y, read_field_of_view_degrees("fov_y", r).map(Some))),
];

/// Table of the words that the block of the lecture's camera takes, for parser, messages and manual. The camera is an addition
/// of durer, and right-handed.
pub const LECTURE: Spec = Spec {
    name: "camera",
    summary: "durer's own camera, right-handed: x to the right, y up, z towards you; the word `eye` makes it this one",
    words: specs!(LECTURE_ROWS),
    has_transforms: true,
    ..Spec::EMPTY
};

/// Returns the words of both kinds of camera.
pub(super) fn camera_words() -> Vec<&'static str> {
    let own = LECTURE.words.iter().map(|w| w.name).filter(|name| *name != "up");
    let mut names = POVRAY.word_names();
    names.extend(own);
    names
}
