//! `camera`: POV-Ray's (manual, "Camera") and the lecture's; both are lowered to [`LoweredCamera`].

mod bokeh;
mod bumps;
mod focal_blur;
mod frame;
mod lecture;
mod lowered;
mod mesh_camera;
mod ordered;
mod perspective;
mod povray;
mod projection;
pub mod words;

pub use bokeh::Bokeh;
pub use bumps::Bumps;
pub use focal_blur::{FocalBlur, Lens};
pub use frame::Frame;
pub use lecture::LectureCamera;
pub use lowered::{LoweredCamera, View};
pub use mesh_camera::{Distribution, MeshCamera, MeshRays, PlacedMesh, ReadMesh};
pub use perspective::Window;
pub use povray::{Kind, PovrayCamera};
pub use projection::Projection;

use crate::diagnostic::Result;
use crate::math::Transform;
use crate::math::noise::NoiseGenerator;
use crate::source::Span;
use crate::texture::{Normal, Pigment, Texture};
use crate::value::words::read_row;
use crate::value::{Next, Reader, ReaderExt, Thing};
use focal_blur::BLUR_ROWS;
use serde::Serialize;
use std::sync::Arc;
use words::{KIND_ROWS, LECTURE, LECTURE_ROWS, POVRAY_ROWS};

/// Camera as written in a scene.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Camera {
    /// Camera of POV-Ray's language.
    Povray(PovrayCamera),
    /// The lecture's camera: `eye center up fov_x fov_y`.
    Lecture(LectureCamera),
}

impl Thing for Camera {
    fn kind(&self) -> &'static str {
        "camera"
    }
}

impl Default for Camera {
    fn default() -> Self {
        Camera::Povray(PovrayCamera::default())
    }
}

impl Camera {
    /// Reads the items of a `camera` block. `source` is the span of its word. It starts from the properties of `start`
    /// (quirk: `default_camera`), unless that is a lecture camera, and its `normal` from that of `default_texture`. `mesh`
    /// reads the meshes of a mesh camera.
    ///
    /// # Errors
    /// A diagnostic at the first item that is not understood.
    pub fn read(
        r: &mut dyn Reader,
        source: Span,
        start: &Camera,
        default_texture: &Texture,
        mesh: ReadMesh,
    ) -> Result<Self> {
        let mut povray = match start {
            Camera::Povray(camera) => camera.clone(),
            Camera::Lecture(_) => PovrayCamera::default(),
        };
        if let Some(declared) = r.take_declared::<Camera>()? {
            match &*declared {
                Camera::Povray(camera) => povray = camera.clone(),
                lecture => {
                    let mut camera = lecture.clone();
                    return camera.read_transforms(r).map(|()| camera);
                }
            }
        }
        let ordered = r.language().ordered_cameras;
        match ordered {
            true => povray.begin_immediate_words(),
            false => povray.end_immediate_words(),
        }
        let mut lecture: Option<LectureCamera> = None;
        let mut transform = Transform::IDENTITY;
        loop {
            match r.peek_next()? {
                Next::End => break,
                Next::Word(word) if LECTURE.has_effect(word) && (word != "up" || lecture.is_some()) => {
                    read_row(LECTURE_ROWS, lecture.get_or_insert_default(), Next::Word(word), r)?;
                }
                next if next.is_transform() => {
                    if let Some(step) = r.transform()? {
                        match ordered && lecture.is_none() {
                            true => povray.transform_location_and_axes(&step),
                            false => transform = transform.then(&step),
                        }
                    }
                }
                next if read_row(POVRAY_ROWS, &mut povray, next, r)?
                    || read_row(KIND_ROWS, &mut povray, next, r)?
                    || read_row(BLUR_ROWS, &mut povray, next, r)? =>
                {
                    if let (true, Next::Word(word)) = (ordered, next) {
                        povray.apply_word(word);
                    }
                }
                Next::Block("mesh_camera") => {
                    r.take_token()?;
                    povray.read_mesh_camera(r, mesh)?;
                    r.leave_block()?;
                }
                Next::Block("bokeh") => {
                    r.take_token()?;
                    povray.bokeh = read_bokeh(r, default_texture)?;
                    r.leave_block()?;
                }
                Next::Thing("normal") => povray.normal = r.take_declared::<Normal>()?,
                Next::Block("normal") => {
                    r.take_token()?;
                    povray.normal =
                        Some(Arc::new(Normal::read(r, default_texture.layers[0].normal.as_deref(), default_texture)?));
                    r.leave_block()?;
                }
                _ => return Err(r.unknown_word("camera", &words::camera_words()).into()),
            }
        }
        match lecture {
            Some(mut camera) => {
                camera.transform = transform;
                camera.check_camera(source)?;
                Ok(Camera::Lecture(camera))
            }
            None => {
                povray.transform = povray.transform.then(&transform);
                povray.check_camera(source)?;
                Ok(Camera::Povray(povray))
            }
        }
    }

    fn read_transforms(&mut self, r: &mut dyn Reader) -> Result<()> {
        while let Some(step) = r.transform()? {
            match self {
                Camera::Povray(camera) => camera.transform = camera.transform.then(&step),
                Camera::Lecture(camera) => camera.transform = camera.transform.then(&step),
            }
        }
        if r.peek_next()? == Next::End { Ok(()) } else { Err(r.unknown_word("camera", &words::camera_words()).into()) }
    }

    /// Lowers the camera; `noise` and `waves` are the scene's settings for patterns, used by the camera's `normal`.
    pub fn lower(&self, noise: NoiseGenerator, waves: usize) -> LoweredCamera {
        match self {
            Camera::Povray(camera) => {
                let bumps = camera.normal.as_deref().map(|normal| Bumps::new(normal, noise, waves));
                let mut eye = camera.lower();
                if let (Some(lens), Some(pigment)) = (&mut eye.lens, camera.bokeh.as_deref()) {
                    lens.bokeh = Some(Arc::new(Bokeh::new(pigment, noise, waves)));
                }
                LoweredCamera { bumps, ..eye }
            }
            Camera::Lecture(camera) => camera.lower(),
        }
    }
}

/// Reads a camera's `bokeh { }` block and returns the last of its pigments; `None` for an empty block.
fn read_bokeh(r: &mut dyn Reader, defaults: &Texture) -> Result<Option<Arc<Pigment>>> {
    let mut pigment = None;
    loop {
        match r.peek_next()? {
            Next::End => return Ok(pigment),
            Next::Thing("pigment") => pigment = r.take_declared::<Pigment>()?,
            Next::Block("pigment") => {
                r.take_token()?;
                pigment = Some(Arc::new(Pigment::read(r, &defaults.layers[0].pigment, defaults)?));
                r.leave_block()?;
            }
            _ => return Err(r.unknown_word("bokeh", &["pigment"]).into()),
        }
    }
}
