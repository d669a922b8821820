//! Patterns: a number, or the index of a cell, for each point of space. Adding one is a file here and a row in the
//! tables below.

mod brick;
mod checker;
mod gradient;
mod hexagon;
mod modifiers;

pub use brick::Brick;
pub use checker::Checker;
pub use gradient::Gradient;
pub use hexagon::Hexagon;
pub use modifiers::{Modifiers, Wave};

use crate::color::Color;
use crate::diagnostic::Result;
use crate::math::DVec3;
use crate::value::{Reader, Spec};
use serde::Serialize;

/// A pattern that tells cells apart: each has a colour, pigment or texture of its own.
pub trait Cells {
    /// How many kinds of cells there are.
    fn count(&self) -> usize;
    /// Which kind the point is in.
    fn cell(&self, p: DVec3) -> usize;
    /// What cells are painted that the author gives nothing for.
    fn default_color(&self, cell: usize) -> Color;
}

/// A pattern that gives every point a number, which a map turns into colour.
pub trait Field {
    /// The number before frequency, phase and wave; mostly in [0, 1].
    fn value(&self, p: DVec3) -> f64;
}

/// Reads a pattern's own words.
pub trait Readable: Sized {
    /// Its table.
    const SPEC: Spec;

    /// Reads what follows its name.
    fn read(_r: &mut dyn Reader) -> Result<Self>;

    /// Reads what follows one of `SPEC.words`; the word itself is consumed.
    fn read_word(&mut self, _word: &'static str, _r: &mut dyn Reader) -> Result<()> {
        Ok(())
    }
}

macro_rules! family {
    ($(#[$doc:meta])* $enum:ident: $($name:ident)*) => {
        $(#[$doc])*
        #[derive(Clone, Debug, PartialEq, Serialize)]
        #[serde(rename_all = "snake_case")]
        pub enum $enum { $(#[doc = concat!("See [`", stringify!($name), "`].")] $name($name)),* }

        impl $enum {
            /// Reads the pattern of this name, which is consumed; `None` if there is no such pattern.
            pub fn read(name: &str, r: &mut dyn Reader) -> Option<Result<$enum>> {
                $(if name == $name::SPEC.name { return Some($name::read(r).map($enum::$name)); })*
                None
            }

            /// The table of its words.
            pub fn spec(&self) -> &'static Spec { match self { $($enum::$name(_) => &$name::SPEC),* } }

            /// Reads one of the words of its own table; the word itself is consumed.
            pub fn read_word(&mut self, word: &'static str, r: &mut dyn Reader) -> Result<()> {
                match self { $($enum::$name(p) => p.read_word(word, r)),* }
            }

            /// Every table of this kind of pattern.
            pub const SPECS: &[&Spec] = &[$(&$name::SPEC),*];
        }
    };
}

family! {
    /// Any pattern of cells.
    CellPattern: Checker Hexagon Brick
}

family! {
    /// Any pattern of numbers.
    FieldPattern: Gradient
}

impl Cells for CellPattern {
    fn count(&self) -> usize {
        match self {
            CellPattern::Checker(p) => p.count(),
            CellPattern::Hexagon(p) => p.count(),
            CellPattern::Brick(p) => p.count(),
        }
    }

    fn cell(&self, p: DVec3) -> usize {
        match self {
            CellPattern::Checker(c) => c.cell(p),
            CellPattern::Hexagon(c) => c.cell(p),
            CellPattern::Brick(c) => c.cell(p),
        }
    }

    fn default_color(&self, cell: usize) -> Color {
        match self {
            CellPattern::Checker(p) => p.default_color(cell),
            CellPattern::Hexagon(p) => p.default_color(cell),
            CellPattern::Brick(p) => p.default_color(cell),
        }
    }
}

impl Field for FieldPattern {
    fn value(&self, p: DVec3) -> f64 {
        match self {
            FieldPattern::Gradient(f) => f.value(p),
        }
    }
}

/// Patterns of the language that are not drawn yet.
pub const NOT_DRAWN: &[&str] = &[
    "agate",
    "aoi",
    "average",
    "boxed",
    "bozo",
    "bumps",
    "cells",
    "crackle",
    "cubic",
    "cylindrical",
    "density_file",
    "dents",
    "facets",
    "function",
    "granite",
    "image_pattern",
    "julia",
    "leopard",
    "magnet",
    "mandel",
    "marble",
    "object",
    "onion",
    "pavement",
    "pigment_pattern",
    "planar",
    "quilted",
    "radial",
    "ripples",
    "slope",
    "spherical",
    "spiral1",
    "spiral2",
    "spotted",
    "square",
    "tiling",
    "triangular",
    "waves",
    "wood",
    "wrinkles",
];

/// Words about patterns that are not drawn yet.
pub const WORDS_NOT_DRAWN: &[&str] = &[
    "accuracy",
    "agate_turb",
    "altitude",
    "bump_size",
    "control0",
    "control1",
    "coords",
    "cube",
    "df3",
    "exponent",
    "exterior",
    "form",
    "image_map",
    "interior",
    "interpolate",
    "lambda",
    "map_type",
    "metric",
    "no_bump_scale",
    "noise_generator",
    "normal_map",
    "octaves",
    "offset",
    "omega",
    "once",
    "orientation",
    "pigment_map",
    "size",
    "slope_map",
    "solid",
    "texture_map",
    "tile2",
    "tiles",
    "turbulence",
    "use_alpha",
    "use_color",
    "use_index",
    "uv_mapping",
    "warp",
];

/// Added before `floor`, so that a surface at a whole number lies on one side (measured on POV-Ray 3.7).
const EDGE: f64 = 1e-10;
