//! The camera: several of them, one that looks along `sky`, one whose window has another shape than the picture.

use crate::camera::{Camera, Projection};
use crate::diagnostic::{Diagnostic, codes};
use crate::math::DVec3;
use crate::render;
use crate::scene::Scene;
use crate::source::Span;
use crate::world::World;

/// How much longer one side of a pixel may be: POV-Ray's default window of 1.33 by 1 is 0.25 % off in a picture of 4 by 3.
const UNEVEN: f64 = 0.02;

/// What can be said before a picture is drawn.
pub(super) fn of_scene(scene: &Scene) -> Option<Diagnostic> {
    several(&scene.cameras)
}

fn several(cameras: &[Span]) -> Option<Diagnostic> {
    let (last, others) = cameras.split_last()?;
    // A macro or a loop may say the same camera again.
    let other = others.iter().find(|other| *other != last)?;
    let message = format!("the scene has {} cameras: the last one counts", cameras.len());
    let d = Diagnostic::new(codes::SEVERAL_CAMERAS, *other, message).label("nobody looks through this one");
    Some(d.also(*last, "this one counts").help("put the others into comments, or choose one with `#if`"))
}

/// A view straight from above, which is mostly meant so.
pub(super) fn along_sky(scene: &Scene) -> Option<Diagnostic> {
    let Camera::Povray(camera) = &scene.camera else { return None };
    let ahead = (camera.look_at? - camera.location).try_normalize()?;
    let sky = camera.sky.try_normalize()?;
    if sky.cross(ahead).length() > 1e-10 {
        return None;
    }
    let at = scene.cameras.last().copied().unwrap_or(Span::NONE);
    let other = if sky.z.abs() > 0.9 { "sky y" } else { "sky z" };
    let message = "the camera looks straight along its `sky`, so that nothing tells what is up in the picture";
    let help = format!("write `{other}` in front of `look_at`, if that is to be up; now `right` alone decides");
    Some(Diagnostic::new(codes::ALONG_SKY, at, message).help(help))
}

/// Pixels that are not square.
pub(super) fn stretched(world: &World, options: &render::Options) -> Option<Diagnostic> {
    let view = world.eye.view(options.width, options.height);
    // (Others stretch all by their nature.)
    let window = view.window()?;
    let middle = window.ray(options.width as f64 / 2.0, options.height as f64 / 2.0).dir;
    let leans = |side: DVec3| side.dot(middle).abs() > 1e-3 * side.length();
    // Whoever sets the window askew knows what it shows.
    if leans(window.across) || leans(window.down) {
        return None;
    }
    let ratio = window.across.length() / window.down.length();
    if !ratio.is_finite() || ratio <= 0.0 || (ratio - 1.0).abs() <= UNEVEN {
        return None;
    }
    let (width, height) = (options.width, options.height);
    // A pixel that shows more across than down squeezes things across.
    let (longer, percent) = if ratio < 1.0 { ("wider", 1.0 / ratio - 1.0) } else { ("higher", ratio - 1.0) };
    let percent = (percent * 100.0).round();
    let message = format!("in this picture of {width}x{height}, all is {percent} % {longer} than it should be");
    let fitting = (height as f64 * ratio * width as f64 / height as f64).round() as usize;
    let size = format!("draw it with `--size {fitting}x{height}`");
    let help = match &world.eye.projection {
        Projection::Lecture { .. } => format!("leave out `fov_x` or `fov_y` in the camera, or {size}"),
        _ => format!("write `right x*image_width/image_height` in the camera, or {size}"),
    };
    let d = Diagnostic::new(codes::STRETCHED, world.camera_source, message);
    Some(d.label("its window has other sides than the picture").help(help))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::camera::PovrayCamera;

    fn looking(location: DVec3, look_at: DVec3, sky: DVec3) -> bool {
        let camera = PovrayCamera { location, look_at: Some(look_at), sky, ..PovrayCamera::default() };
        let scene = Scene { camera: Camera::Povray(camera), ..Scene::default() };
        along_sky(&scene).is_some()
    }

    #[test]
    fn only_straight_along_sky() {
        assert!(looking(DVec3::Y * 10.0, DVec3::ZERO, DVec3::Y));
        assert!(!looking(DVec3::Y * 10.0, DVec3::ZERO, DVec3::Z));
        assert!(!looking(DVec3::new(0.0, 10.0, -0.001), DVec3::ZERO, DVec3::Y));
    }

    #[test]
    fn one_camera_said_twice_is_one() {
        let at = |lo| Span::new(lo, lo + 6);
        assert!(several(&[at(1), at(1)]).is_none());
        assert!(several(&[at(1), at(9)]).is_some());
        assert!(several(&[]).is_none());
    }
}
