//! `warp`: moves points in ways that no matrix can (manual, "Warps"). A new warp is a file here and a row in the table
//! below.

mod black_hole;
mod mapping;
mod repeat;
mod turbulence;

pub use black_hole::BlackHole;
pub use mapping::{CubicWarp, CylindricalWarp, PlanarWarp, PlaneLayout, SphericalWarp, ToroidalWarp};
pub use repeat::Repeat;
pub use turbulence::TurbulenceWarp;

use crate::diagnostic::Result;
use crate::math::DVec3;
use crate::source::Span;
use crate::value::{Family, Next, Reader, delegate, family};

/// Interface of a warp, which displaces the points of a pattern.
pub trait Bend {
    /// Maps the evaluated point to the point that the pattern receives.
    fn apply(&self, p: DVec3) -> DVec3;
}

family! {
    /// A warp of any kind.
    pub enum Warp {
        Turbulence(TurbulenceWarp)
        Repeat(Repeat)
        BlackHole(BlackHole)
        Cylindrical(CylindricalWarp)
        Spherical(SphericalWarp)
        Toroidal(ToroidalWarp)
        Planar(PlanarWarp)
        Cubic(CubicWarp)
    }
}

delegate! {
    impl Bend for Warp {
        fn apply(&self, p: DVec3) -> DVec3;
    }
}

impl Warp {
    /// Reads the items of a `warp` block; `span` is the span of its word.
    ///
    /// # Errors
    /// A diagnostic at the item that is not understood.
    pub fn read(span: Span, r: &mut dyn Reader) -> Result<Self> {
        let next = r.peek_next()?;
        let Some(mut warp) = Self::read_named(next, r)? else {
            let names: Vec<_> = Self::SPECS.iter().map(|s| s.name).collect();
            return Err(r.unknown_word("warp", &names).into());
        };
        loop {
            match r.peek_next()? {
                Next::End => return warp.complete_and_check(span, r).map(|()| warp),
                next if warp.read_own(next, r)? => {}
                _ => return Err(r.unknown_word("warp", &warp.spec().word_names()).into()),
            }
        }
    }
}
