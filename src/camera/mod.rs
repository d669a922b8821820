//! `camera`: POV-Ray's perspective camera (manual, "Camera") and the lecture's.

mod lecture;
mod perspective;
pub mod words;

pub use lecture::LectureCamera;
pub use perspective::Perspective;

use crate::diagnostic::Result;
use crate::math::{DVec3, Ray, Transform};
use crate::source::Span;
use crate::value::words::read_row;
use crate::value::{Next, RawItem, Reader, ReaderExt, Thing};
use serde::Serialize;
use words::{LECTURE, LECTURE_ROWS, PERSPECTIVE, PERSPECTIVE_ROWS};

/// Any camera.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Camera {
    /// POV-Ray's.
    Perspective(Perspective),
    /// `eye center up fov_x fov_y`.
    Lecture(LectureCamera),
}

impl Thing for Camera {
    fn kind(&self) -> &'static str {
        "camera"
    }
}

impl Default for Camera {
    fn default() -> Self {
        Camera::Perspective(Perspective::default())
    }
}

/// Where the rays of a picture come from: p(x, y) = origin, direction corner + x·across + y·down, with x and y in
/// pixels from the top left corner of the picture. All in world space; directions are not normalised.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Window {
    /// The eye.
    pub origin: DVec3,
    /// Towards the top left corner.
    pub corner: DVec3,
    /// One pixel to the right.
    pub across: DVec3,
    /// One pixel down.
    pub down: DVec3,
}

impl Window {
    /// The unit ray through a point of the picture; the centre of pixel (i, j) is (i + ½, j + ½).
    pub fn ray(&self, x: f64, y: f64) -> Ray {
        let dir = self.corner + self.across * x + self.down * y;
        Ray::new(self.origin, dir.normalize())
    }
}

impl Camera {
    /// Reads what stands between the braces; `source` is the block's place.
    ///
    /// # Errors
    /// With the place of what is not understood, and what was expected there.
    pub fn read(r: &mut dyn Reader, source: Span) -> Result<Self> {
        let mut povray = Perspective::default();
        if let Some(declared) = r.thing::<Camera>()? {
            match &*declared {
                Camera::Perspective(camera) => povray = camera.clone(),
                lecture => {
                    let mut camera = lecture.clone();
                    return camera.read_transforms(r).map(|()| camera);
                }
            }
        }
        let mut undrawn = vec![];
        let mut lecture: Option<LectureCamera> = None;
        let mut transform = Transform::IDENTITY;
        loop {
            match r.next()? {
                Next::End => break,
                Next::Word(word) if LECTURE.obeys(word) && (word != "up" || lecture.is_some()) => {
                    read_row(LECTURE_ROWS, lecture.get_or_insert_default(), Next::Word(word), r)?;
                }
                next if next.moves() => {
                    if let Some(step) = r.transform()? {
                        transform = transform.then(&step);
                    }
                }
                next if read_row(PERSPECTIVE_ROWS, &mut povray, next, r)? => {}
                Next::Word(word) | Next::Block(word) if PERSPECTIVE.leaves_out(word) => {
                    undrawn.push(r.keep_undrawn(word)?);
                }
                _ => return Err(r.unknown_word("camera", &words::names()).into()),
            }
        }
        match lecture {
            Some(mut camera) => {
                camera.transform = transform;
                camera.undrawn = undrawn;
                camera.check(source)?;
                Ok(Camera::Lecture(camera))
            }
            None => {
                povray.transform = povray.transform.then(&transform);
                if !undrawn.is_empty() {
                    // Another kind of camera may see more than half a turn; the perspective that stands for it can't.
                    let own = povray.angle.filter(|a| !(1.0..=120.0).contains(a));
                    undrawn.extend(
                        own.map(|a| RawItem::Block("angle", Box::new([RawItem::Numbers { width: 1, all: vec![a] }]))),
                    );
                    povray.angle = povray.angle.map(|a| a.clamp(1.0, 120.0));
                }
                povray.undrawn.extend(undrawn);
                povray.check(source)?;
                Ok(Camera::Perspective(povray))
            }
        }
    }

    fn read_transforms(&mut self, r: &mut dyn Reader) -> Result<()> {
        while let Some(step) = r.transform()? {
            match self {
                Camera::Perspective(camera) => camera.transform = camera.transform.then(&step),
                Camera::Lecture(camera) => camera.transform = camera.transform.then(&step),
            }
        }
        if r.next()? == Next::End { Ok(()) } else { Err(r.unknown_word("camera", &words::names()).into()) }
    }

    /// The rays of a picture of this size.
    pub fn window(&self, width: usize, height: usize) -> Window {
        match self {
            Camera::Perspective(camera) => camera.window(width, height),
            Camera::Lecture(camera) => camera.window(width, height),
        }
    }
}
