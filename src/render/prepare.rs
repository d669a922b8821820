//! Preparation of a frame: data that is computed before the picture and only read while the picture is rendered.
//!
//! Photon maps and radiosity belong here: each is an ordered map ([`Workers::map`]) whose result becomes a part of the
//! [`FrameContext`], so that no ray of the picture can change it.

use super::sampler::FrameCamera;
use super::workers::Workers;
use super::{Cancelled, Options};
use crate::transport::{CameraOrigin, FrameContext, Quality};
use crate::world::World;

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
