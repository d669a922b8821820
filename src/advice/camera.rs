//! Warnings about several cameras, cameras that look along `sky`, and pixels that are not square.

use crate::camera::{Camera, Projection};
use crate::diagnostic::{Diagnostic, codes};
use crate::math::DVec3;
use crate::render;
use crate::scene::Scene;
use crate::source::Span;
use crate::world::World;

/// Allowed deviation of a pixel's aspect ratio from 1. POV-Ray's default window of 1.33 by 1 deviates by 0.25 % in a
/// picture of 4 by 3.
const UNEVEN: f64 = 0.02;

/// Returns the warning about a scene with several cameras.
pub(super) fn several_cameras_warning(scene: &Scene) -> Option<Diagnostic> {
    unused_cameras_warning(&scene.cameras)
}

fn unused_cameras_warning(cameras: &[Span]) -> Option<Diagnostic> {
    let (last, others) = cameras.split_last()?;
    // A macro or a loop may create one camera several times.
    let other = others.iter().find(|other| *other != last)?;
    let message = format!("the scene has {} cameras: the last one is used", cameras.len());
    let d = Diagnostic::new(codes::SEVERAL_CAMERAS, *other, message).label("this one is not used");
    Some(d.also(*last, "this one is used").help("put the others into comments, or choose one with `#if`"))
}

/// Returns the warning about a camera that looks along `sky`, which is mostly intended, as in a view from above.
pub(super) fn view_along_sky_warning(scene: &Scene) -> Option<Diagnostic> {
    let Camera::Povray(camera) = &scene.camera else { return None };
    let ahead = (camera.look_at? - camera.location).try_normalize()?;
    let sky = camera.sky.try_normalize()?;
    if sky.cross(ahead).length() > 1e-10 {
        return None;
    }
    let at = scene.cameras.last().copied().unwrap_or(Span::NONE);
    let other = if sky.z.abs() > 0.9 { "sky y" } else { "sky z" };
    let message = "the camera looks along its `sky`, which leaves the upward direction of the picture undefined";
    let help =
        format!("write `{other}` before `look_at` if that is the upward direction; now `right` alone determines it");
    Some(Diagnostic::new(codes::ALONG_SKY, at, message).help(help))
}

/// Returns the warning about a picture whose pixels are not square.
pub(super) fn non_square_pixels_warning(world: &World, options: &render::Options) -> Option<Diagnostic> {
    let view = world.eye.view(options.width, options.height);
    // Projections without a window are distorted by their nature.
    let window = view.window_of_unperturbed_rays()?;
    let middle = window.ray_at_pixel_position(options.width as f64 / 2.0, options.height as f64 / 2.0).dir;
    let leans = |side: DVec3| side.dot(middle).abs() > 1e-3 * side.length();
    // A window that is not perpendicular to the view is intended.
    if leans(window.across) || leans(window.down) {
        return None;
    }
    let ratio = window.across.length() / window.down.length();
    if !ratio.is_finite() || ratio <= 0.0 || (ratio - 1.0).abs() <= UNEVEN {
        return None;
    }
    let (width, height) = (options.width, options.height);
    // A pixel that covers more horizontally than vertically compresses objects horizontally.
    let (longer, percent) = if ratio < 1.0 { ("wider", 1.0 / ratio - 1.0) } else { ("higher", ratio - 1.0) };
    let percent = (percent * 100.0).round();
    let message = format!("in this picture of {width}x{height}, everything is {percent} % {longer} than it should be");
    let fitting = (height as f64 * ratio * width as f64 / height as f64).round() as usize;
    let size = format!("render it with `--size {fitting}x{height}`");
    let help = match &world.eye.projection {
        Projection::Lecture { .. } => format!("leave out `fov_x` or `fov_y` in the camera, or {size}"),
        _ => format!("write `right x*image_width/image_height` in the camera, or {size}"),
    };
    let d = Diagnostic::new(codes::STRETCHED, world.camera_source, message);
    Some(d.label("its window has another aspect ratio than the picture").help(help))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::camera::PovrayCamera;

    fn looking(location: DVec3, look_at: DVec3, sky: DVec3) -> bool {
        let camera = PovrayCamera { location, look_at: Some(look_at), sky, ..PovrayCamera::default() };
        let scene = Scene { camera: Camera::Povray(camera), ..Scene::default() };
        view_along_sky_warning(&scene).is_some()
    }

    #[test]
    fn views_along_sky_are_found() {
        assert!(looking(DVec3::Y * 10.0, DVec3::ZERO, DVec3::Y));
        assert!(!looking(DVec3::Y * 10.0, DVec3::ZERO, DVec3::Z));
        assert!(!looking(DVec3::new(0.0, 10.0, -0.001), DVec3::ZERO, DVec3::Y));
    }

    #[test]
    fn one_camera_created_twice_counts_once() {
        let at = |lo| Span::new(lo, lo + 6);
        assert!(unused_cameras_warning(&[at(1), at(1)]).is_none());
        assert!(unused_cameras_warning(&[at(1), at(9)]).is_some());
        assert!(unused_cameras_warning(&[]).is_none());
    }
}
