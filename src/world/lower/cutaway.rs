//! `cutaway_textures`: the materials of parts that cut each other (manual, "Cutaway Textures").

use super::Lowering;
use super::place::{BlockSpace, PlacedTexture};
use crate::diagnostic::Result;
use crate::scene::{CsgOp, Object, ObjectKind};
use crate::world::{Leaf, PlacedMaterial, SolidNode};

impl Lowering {
    /// Appends the shapes of a CSG object's parts, of a difference those of the first part only, each with the material
    /// that it shows on surfaces that cut it; `texture` is the one around the parts. A shape without any texture has
    /// the default texture in a union or merge, and is left out otherwise (manual, "Cutaway Textures", quirk:
    /// `cutaway_without_texture`).
    pub(super) fn collect_cutaway_materials(
        &mut self,
        op: CsgOp,
        parts: &[Object],
        around: &BlockSpace,
        texture: Option<&PlacedTexture>,
        out: &mut Vec<(SolidNode, PlacedMaterial)>,
    ) -> Result<()> {
        let cut = if op == CsgOp::Difference { 1 } else { parts.len() };
        let any = matches!(op, CsgOp::Union | CsgOp::Merge);
        for part in parts.iter().take(cut) {
            let place = around.inside(part)?;
            let own = around.placed_texture(part.texture.as_ref(), part, &place)?;
            let texture = own.as_ref().or(texture);
            match (&part.kind, texture) {
                (ObjectKind::Csg(op, parts), texture) => {
                    self.collect_cutaway_materials(*op, parts, &place, texture, out)?
                }
                (ObjectKind::Shape(shape), texture) if texture.is_some() || any => {
                    let placed =
                        self.lower_placed_texture(&texture.cloned().unwrap_or_else(|| self.default_placed_texture()));
                    let node = SolidNode::leaf(Leaf::placed(shape.clone(), &place.world_from_block, 0), 0);
                    out.push((if part.uncommon.flags.inverse { node.inverted() } else { node }, placed));
                }
                _ => {}
            }
        }
        Ok(())
    }
}
