//! Preparation of a frame: data that is computed before the picture and only read while the picture is rendered.
//!
//! Photon maps and radiosity belong here: each is an ordered map ([`Workers::map`]) whose result becomes a part of the
//! [`FrameContext`], so that no ray of the picture can change it.

use super::workers::Workers;
use super::{Cancelled, Options};
use crate::camera::{Lens, LoweredCamera, View};
use crate::math::DVec3;
use crate::transport::{CameraOrigin, FrameContext, Quality};
use crate::world::World;

/// The camera of a frame, prepared for a picture of one size.
pub(super) struct FrameCamera {
    pub view: View,
    /// Lens of a camera with focal blur.
    pub lens: Option<Lens>,
    /// Unit vectors right, up and ahead, in world space.
    pub axes: [DVec3; 3],
}

impl FrameCamera {
    /// Creates the camera of a picture of `width` × `height` pixels.
    pub fn new(camera: &LoweredCamera, width: usize, height: usize) -> Self {
        let (axes, _) = camera.frame.unit_axes_and_lengths();
        Self { view: camera.view(width, height), lens: camera.lens.clone(), axes }
    }
}

/// Computes the data that all rays of a frame share.
pub(super) fn prepare<'w>(
    world: &'w World,
    camera: &FrameCamera,
    options: &Options,
    workers: &Workers,
) -> Result<FrameContext<'w>, Cancelled> {
    if workers.is_cancelled() {
        return Err(Cancelled);
    }
    let origin = CameraOrigin { origin: camera.view.common_origin(), reach: camera.view.max_distance() };
    let quality = Quality::new(options.quality);
    Ok(FrameContext::new(world, quality, origin, options.frame, options.alpha, options.has_shafts))
}
