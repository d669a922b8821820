//! What a ray needs: every object with M and M⁻¹; no names, versions, degrees or nested blocks.

mod bvh;
mod crowd;
mod geometry;
mod leaf;
mod node;

pub use geometry::Geometry;
pub use leaf::{Found, FoundList, Leaf, Surface};
pub use node::{Node, NodeKind};

use crate::diagnostic::Result;
use crate::scene::Scene;
use serde::Serialize;

/// The lowered scene.
#[derive(Debug, Serialize)]
pub struct World {}

/// Lowers what the author said to what a ray needs.
pub fn lower(_scene: &Scene) -> Result<World> {
    Ok(World {})
}
