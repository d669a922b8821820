//! What is computed before the picture, and is then only read.
//!
//! Photons and radiosity belong here: each an ordered map ([`Workers::map`]) whose results go into the [`Setup`], so that no ray of
//! the picture can change them and none depends on who was first.

use super::trace::Setup;
use super::workers::Workers;
use super::{Cancelled, Options};
use crate::world::World;

/// All that the rays of a picture share.
pub(super) fn prepare<'w>(world: &'w World, options: &Options, workers: &Workers) -> Result<Setup<'w>, Cancelled> {
    if workers.watch.cancelled() { Err(Cancelled) } else { Ok(Setup::new(world, options)) }
}
