//! `warp`: moves points in ways that no matrix can (manual, "Warps"). A new warp is a file here and a row in the table
//! below.

mod black_hole;
mod mapping;
mod repeat;
mod turbulence;

pub use black_hole::BlackHole;
pub use mapping::{CubicWarp, CylindricalWarp, Layout, PlanarWarp, SphericalWarp, ToroidalWarp};
pub use repeat::Repeat;
pub use turbulence::TurbulenceWarp;

use super::Readable;
use crate::diagnostic::Result;
use crate::math::DVec3;
use crate::value::{Next, Reader, Spec};
use serde::Serialize;

/// Interface of a warp, which displaces the points of a pattern.
pub trait Bend {
    /// Maps the evaluated point to the point that the pattern receives.
    fn apply(&self, p: DVec3) -> DVec3;
}

macro_rules! warps {
    ($($variant:ident $name:ident)*) => {
        /// A warp of any kind.
        #[derive(Clone, Debug, PartialEq, Serialize)]
        #[serde(rename_all = "snake_case")]
        pub enum Warp { $(#[doc = concat!("See [`", stringify!($name), "`].")] $variant($name)),* }

        impl Warp {
            /// Keyword and words of each warp.
            pub const SPECS: &[&Spec] = &[$(&$name::SPEC),*];

            /// Maps the evaluated point to the point that the pattern receives.
            pub fn apply(&self, p: DVec3) -> DVec3 { match self { $(Warp::$variant(w) => w.apply(p)),* } }

            fn begin(name: &str, r: &mut dyn Reader) -> Option<Result<Warp>> {
                $(if name == $name::SPEC.name { return Some($name::read(r).map(Warp::$variant)); })*
                None
            }

            fn spec(&self) -> &'static Spec { match self { $(Warp::$variant(_) => &$name::SPEC),* } }

            fn read_own(&mut self, next: Next, r: &mut dyn Reader) -> Result<bool> {
                match self { $(Warp::$variant(w) => w.read_own(next, r)),* }
            }
        }
    };
}

warps! {
    Turbulence TurbulenceWarp
    Repeat Repeat
    BlackHole BlackHole
    Cylindrical CylindricalWarp
    Spherical SphericalWarp
    Toroidal ToroidalWarp
    Planar PlanarWarp
    Cubic CubicWarp
}

impl Warp {
    /// Reads the items of a `warp` block.
    ///
    /// # Errors
    /// A diagnostic at the item that is not understood.
    pub fn read(r: &mut dyn Reader) -> Result<Self> {
        let names: Vec<&'static str> = Self::SPECS.iter().map(|s| s.name).collect();
        let Next::Word(name) = r.next()? else { return Err(r.unknown_word("warp", &names).into()) };
        if !names.contains(&name) {
            return Err(r.unknown_word("warp", &names).into());
        }
        r.take_token()?;
        let Some(warp) = Self::begin(name, r) else { return Err(r.unknown_word("warp", &names).into()) };
        let mut warp = warp?;
        loop {
            match r.next()? {
                Next::End => return Ok(warp),
                next if warp.read_own(next, r)? => {}
                _ => return Err(r.unknown_word("warp", &warp.spec().word_names().collect::<Vec<_>>()).into()),
            }
        }
    }
}
