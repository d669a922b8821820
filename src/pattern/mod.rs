//! Patterns: a number, or the index of a cell, for each point of space. A new pattern is a file here and a row in the
//! tables below.

mod agate;
mod aoi;
pub mod bitmap;
mod boxed;
mod bozo;
mod brick;
mod bumps;
mod cells;
mod checker;
mod context;
mod crackle;
mod cubic;
mod cylindrical;
mod density_file;
mod dents;
mod facets;
mod fractal;
mod function;
mod gradient;
mod granite;
mod hexagon;
mod leopard;
mod local_bounds;
mod marble;
mod modifiers;
mod object;
mod onion;
mod pavement;
mod pigment;
mod placed;
mod planar;
mod program;
mod quilted;
mod radial;
mod ripples;
mod slope;
mod space;
mod spherical;
mod spiral1;
mod spiral2;
mod spotted;
mod square;
mod tiling;
mod triangular;
mod turbulence;
mod warp;
mod waves;
mod wood;
mod wrinkles;

use crate::function::LocalBounds;
pub use agate::Agate;
pub use aoi::Aoi;
pub use bitmap::{ImagePattern, MaterialMap};
pub use boxed::Boxed;
pub use bozo::Bozo;
pub use brick::Brick;
pub use bumps::Bumps;
pub use cells::RandomCells;
pub use checker::Checker;
use context::GRAYS;
pub use context::{Field, FieldParams, TextureContext};
pub use crackle::Crackle;
pub use cubic::Cubic;
pub use cylindrical::Cylindrical;
pub use density_file::{DensityFile, Voxel};
pub use dents::Dents;
pub use facets::Facets;
pub use fractal::{Julia, Magnet, Mandel, Orbits};
pub use function::FunctionPattern;
pub use gradient::Gradient;
pub use granite::Granite;
pub use hexagon::Hexagon;
pub use leopard::Leopard;
pub use marble::Marble;
pub use modifiers::{Modifiers, Wave};
pub use object::ObjectPattern;
pub use onion::Onion;
pub use pavement::Pavement;
pub use pigment::{PigmentBrightness, PigmentPattern};
pub use placed::{Pattern, PatternKind, read_noise_generator};
pub use planar::Planar;
pub use program::PatternProgram;
pub use quilted::Quilted;
pub use radial::Radial;
pub use ripples::Ripples;
pub use slope::{Altitude, Slope, Towards};
pub use space::{Space, Step};
pub use spherical::Spherical;
pub use spiral1::Spiral1;
pub use spiral2::Spiral2;
pub use spotted::Spotted;
pub use square::Square;
pub use tiling::Tiling;
pub use triangular::Triangular;
pub use turbulence::TurbulenceParams;
pub use warp::{
    BlackHole, CubicWarp, CylindricalWarp, Layout, PlanarWarp, Repeat, SphericalWarp, ToroidalWarp, TurbulenceWarp,
    Warp,
};
pub use waves::Waves;
pub use wood::Wood;
pub use wrinkles::Wrinkles;

use crate::color::{Color, Rgb};
use crate::diagnostic::Result;
use crate::math::DVec3;
use crate::value::words::{Row, read_row};
use crate::value::{Next, Reader, Spec};
use serde::Serialize;

/// Points at which arithmetic fails, for tests: far away, next to zero, and not finite, in all combinations.
#[cfg(test)]
pub(crate) fn extreme_points() -> impl Iterator<Item = DVec3> {
    const EXTREMES: [f64; 17] = [
        0.0,
        -0.0,
        0.5,
        -1.0,
        5e-324,
        -1e-310,
        1e3,
        -1e9,
        1e9,
        -1e15,
        1e15,
        -1e18,
        1e18,
        1e300,
        -1e300,
        f64::INFINITY,
        f64::NAN,
    ];
    let n = EXTREMES.len();
    (0..n * n * n).map(move |i| DVec3::new(EXTREMES[i % n], EXTREMES[i / n % n], EXTREMES[i / n / n]))
}

/// A pattern of cells: each kind of cell has a colour, pigment or texture of its own.
pub trait Cells {
    /// Number of the pattern's kinds of cells.
    fn cell_kind_count(&self) -> usize;
    /// Returns the kind of the pattern's cell that contains the point.
    fn cell_kind(&self, p: DVec3) -> usize;
    /// True if all points within a radius are certainly in the same cell of the pattern; false if that is not quickly
    /// decided.
    fn is_uniform(&self, _p: DVec3, _radius: f64) -> bool {
        false
    }
    /// Default colour of a kind of the pattern's cells.
    fn default_color(&self, cell: usize) -> Color;
}

/// Reads a pattern's own words.
pub trait Readable: Sized + 'static {
    /// The keyword that begins the pattern, with its parameters and words.
    const SPEC: Spec;

    /// Words that only this pattern has, which `SPEC` names.
    const WORDS: &'static [Row<Self>] = &[];

    /// Reads the parameters after the pattern's name.
    ///
    /// # Errors
    /// With the place of what is not understood, and what was expected there.
    fn read(_r: &mut dyn Reader) -> Result<Self>;

    /// Reads the contents of the braces after the name of a pattern that may have braces; the closing brace is left.
    ///
    /// # Errors
    /// With the place of what is not understood, and what was expected there.
    fn read_block(r: &mut dyn Reader) -> Result<Self> {
        Self::read(r)
    }

    /// Reads one of [`Self::WORDS`] and its argument if it comes next; false if not.
    ///
    /// # Errors
    /// With the place of what is not understood, and what was expected there.
    fn read_own(&mut self, next: Next, r: &mut dyn Reader) -> Result<bool> {
        read_row(Self::WORDS, self, next, r)
    }
}

macro_rules! family {
    ($(#[$doc:meta])* $enum:ident: $($name:ident)*) => {
        $(#[$doc])*
        #[derive(Clone, Debug, PartialEq, Serialize)]
        #[serde(rename_all = "snake_case")]
        pub enum $enum { $(#[doc = concat!("See [`", stringify!($name), "`].")] $name($name)),* }

        impl $enum {
            /// Reads the pattern of this name, which is already consumed; `None` if no pattern has this name.
            pub fn read(name: &str, block: bool, r: &mut dyn Reader) -> Option<Result<$enum>> {
                $(if name == $name::SPEC.name {
                    let read = if block { $name::read_block(r) } else { $name::read(r) };
                    return Some(read.map($enum::$name));
                })*
                None
            }

            /// True if a pattern has this name.
            pub fn is_name(word: &str) -> bool { Self::SPECS.iter().any(|s| s.name == word) }

            /// The table of its words.
            pub fn spec(&self) -> &'static Spec { match self { $($enum::$name(_) => &$name::SPEC),* } }

            /// Reads one of the pattern's own words if it comes next; false if not.
            ///
            /// # Errors
            /// With the place of what is not understood, and what was expected there.
            pub fn read_own(&mut self, next: Next, r: &mut dyn Reader) -> Result<bool> {
                match self { $($enum::$name(p) => p.read_own(next, r)),* }
            }

            /// Every table of this kind of pattern.
            pub const SPECS: &[&Spec] = &[$(&$name::SPEC),*];
        }
    };
}

macro_rules! fields {
    ($($name:ident)*) => {
        family! {
            /// Any pattern of numbers.
            FieldPattern: $($name)*
        }

        impl Field for FieldPattern {
            fn value(&self, at: &TextureContext) -> f64 { match self { $(FieldPattern::$name(f) => f.value(at)),* } }
            fn value_with_params(&self, at: &TextureContext, params: &FieldParams) -> f64 {
                match self { $(FieldPattern::$name(f) => f.value_with_params(at, params)),* }
            }
            fn bounds_near(&self, at: &TextureContext, params: &FieldParams, radius: f64) -> LocalBounds {
                match self { $(FieldPattern::$name(f) => f.bounds_near(at, params, radius)),* }
            }
            fn default_wave(&self) -> Option<Wave> { match self { $(FieldPattern::$name(f) => f.default_wave()),* } }
            fn starts_with_zero_frequency(&self) -> bool { match self { $(FieldPattern::$name(f) => f.starts_with_zero_frequency()),* } }
            fn owns_turbulence(&self) -> bool { match self { $(FieldPattern::$name(f) => f.owns_turbulence()),* } }
            fn bumped_normal(&self, at: &TextureContext, params: &FieldParams, n: DVec3, amount: f64) -> Option<DVec3> {
                match self { $(FieldPattern::$name(f) => f.bumped_normal(at, params, n, amount)),* }
            }
            fn default_colors(&self) -> Vec<(f64, Color)> {
                match self { $(FieldPattern::$name(f) => f.default_colors()),* }
            }
        }
    };
}

macro_rules! cells {
    ($($name:ident)*) => {
        family! {
            /// Any pattern of cells.
            CellPattern: $($name)*
        }

        impl Cells for CellPattern {
            fn cell_kind_count(&self) -> usize { match self { $(CellPattern::$name(c) => c.cell_kind_count()),* } }
            fn cell_kind(&self, p: DVec3) -> usize { match self { $(CellPattern::$name(c) => c.cell_kind(p)),* } }
            fn is_uniform(&self, p: DVec3, radius: f64) -> bool { match self { $(CellPattern::$name(c) => c.is_uniform(p, radius)),* } }
            fn default_color(&self, cell: usize) -> Color {
                match self { $(CellPattern::$name(c) => c.default_color(cell)),* }
            }
        }
    };
}

cells! { Checker Hexagon Brick ObjectPattern MaterialMap Cubic Square Triangular }

fields! {
    Gradient FunctionPattern ImagePattern PigmentPattern
    Planar Boxed Spherical Cylindrical
    Agate Bozo Bumps Crackle Dents Granite Leopard Marble Onion Quilted Radial RandomCells Ripples Spiral1 Spiral2 Spotted Waves
    Wood Wrinkles Mandel Julia Magnet Aoi Slope DensityFile Facets Tiling Pavement
}

/// Red, green, blue, yellow, cyan, magenta: default colours of cells.
const SIX_COLORS: [Rgb; 6] =
    [Rgb::X, Rgb::Y, Rgb::Z, Rgb::new(1.0, 1.0, 0.0), Rgb::new(0.0, 1.0, 1.0), Rgb::new(1.0, 0.0, 1.0)];

/// Number added before `floor`, so that a surface at a whole number is entirely in one cell of a pattern (quirk:
/// cell_edges).
const EDGE: f64 = 1e-10;
