//! `density { … }`: how dense a medium is at every point, for each channel (manual, "Density").
//!
//! ```pov
//! media { emission 0.5 density { spherical color_map { [0 rgb 0] [1 rgb <1, 0.5, 0.2>] } } }
//! ```

use super::blend::Entry;
use super::pigment::PigmentEntry;
use super::{Pigment, Texture};
use crate::diagnostic::Result;
use crate::math::Transform;
use crate::value::ValueKind::Block;
use crate::value::words::word;
use crate::value::{Next, Reader, ReaderExt, Spec, WordSpec};
use serde::Serialize;

/// Words of a `density` block that have braces of their own.
const DENSITY_PARTS: &[WordSpec] = &[
    word("color_map", Block, "as a pigment's", "`[number color]` entries: the density at each number of the pattern"),
    word("colour_map", Block, "", "the same"),
    word("density_map", Block, "", "`[number density]` entries: which density each number of the pattern gets"),
];

/// Description of `density { … }`, except colours, patterns and their modifiers.
pub const DENSITY: Spec = Spec {
    name: "density",
    summary: "factor of the medium at every point: one colour, or a pattern with its colours",
    words: DENSITY_PARTS,
    has_transforms: true,
    ..Spec::EMPTY
};

/// Density of a medium at every point: a pigment whose colour is a factor for each channel.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
#[serde(transparent)]
pub struct Density(Pigment);

impl Density {
    /// Reads the items of a `density` block, on top of black. Without a map, a pattern has the colours that it has in a
    /// pigment.
    ///
    /// # Errors
    /// A diagnostic at the item that is not understood.
    pub fn read(r: &mut dyn Reader) -> Result<Self> {
        let defaults = Texture::default();
        let mut pigment = r.take_declared::<Density>()?.map_or_else(Pigment::default, |declared| declared.0.clone());
        loop {
            match r.peek_next()? {
                Next::End => break,
                next => pigment.read_element::<Density>(r, next, &defaults)?,
            }
        }
        pigment.set_default_colors();
        if pigment.pattern.uv {
            pigment.pattern.separate_uv_space();
        }
        Ok(Self(pigment))
    }

    /// Appends a transform to those of the density.
    pub fn transform(&mut self, by: &Transform) {
        self.0.pattern.transform(by);
    }

    /// Returns the pigment that computes the density.
    pub fn as_pigment(&self) -> &Pigment {
        &self.0
    }
}

impl From<Pigment> for Density {
    fn from(pigment: Pigment) -> Self {
        Self(pigment)
    }
}

impl From<Density> for Pigment {
    fn from(density: Density) -> Self {
        density.0
    }
}

impl PigmentEntry for Density {}

impl Entry for Density {
    const MAP: &'static str = "density_map";
    const BLOCK: &'static str = "density";

    fn read_entry(r: &mut dyn Reader, _: &Texture) -> Result<Self> {
        Self::read(r)
    }

    /// Reads a declared density, or a colour, which is a density too.
    fn read_declared_or_color(r: &mut dyn Reader) -> Result<Option<Self>> {
        Ok(match r.take_declared::<Density>()? {
            Some(density) => Some((*density).clone()),
            None if r.may_be_at_color()? => Some(Self(Pigment::solid(r.color()?))),
            None => None,
        })
    }
}
