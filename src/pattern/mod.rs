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
mod marble;
mod object;
mod onion;
mod pavement;
mod pigment;
mod placed;
mod planar;
mod quilted;
mod radial;
mod ripples;
mod slope;
mod spherical;
mod spiral1;
mod spiral2;
mod spotted;
mod square;
mod support;
mod tiling;
mod triangular;
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
pub use object::ObjectPattern;
pub use onion::Onion;
pub use pavement::Pavement;
pub use pigment::{PigmentBrightness, PigmentPattern};
pub use placed::{
    Modifiers, Pattern, PatternKind, PatternProgram, Space, Step, TurbulenceParams, Wave, read_noise_generator,
};
pub use planar::Planar;
pub use quilted::Quilted;
pub use radial::Radial;
pub use ripples::Ripples;
pub use slope::{Altitude, Slope, Towards};
pub use spherical::Spherical;
pub use spiral1::Spiral1;
pub use spiral2::Spiral2;
pub use spotted::Spotted;
pub use square::Square;
pub use support::Support;
pub use tiling::Tiling;
pub use triangular::Triangular;
pub use warp::{
    BlackHole, CubicWarp, CylindricalWarp, PlanarWarp, PlaneLayout, Repeat, SphericalWarp, ToroidalWarp,
    TurbulenceWarp, Warp,
};
pub use waves::Waves;
pub use wood::Wood;
pub use wrinkles::Wrinkles;

use crate::color::{Color, Rgb};
use crate::math::DVec3;
use crate::value::{delegate, family};

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

family! {
    /// Any pattern of cells.
    pub enum CellPattern { Checker Hexagon Brick ObjectPattern MaterialMap Cubic Square Triangular }
}

delegate! {
    impl Cells for CellPattern {
        fn cell_kind_count(&self) -> usize;
        fn cell_kind(&self, p: DVec3) -> usize;
        fn is_uniform(&self, p: DVec3, radius: f64) -> bool;
        fn default_color(&self, cell: usize) -> Color;
    }
}

family! {
    /// Any pattern of numbers.
    pub enum FieldPattern {
        Gradient FunctionPattern ImagePattern PigmentPattern
        Planar Boxed Spherical Cylindrical
        Agate Bozo Bumps Crackle Dents Granite Leopard Marble Onion Quilted Radial RandomCells Ripples Spiral1 Spiral2 Spotted Waves
        Wood Wrinkles Mandel Julia Magnet Aoi Slope DensityFile Facets Tiling Pavement
    }
}

delegate! {
    impl Field for FieldPattern {
        fn value(&self, at: &TextureContext) -> f64;
        fn value_with_params(&self, at: &TextureContext, params: &FieldParams) -> f64;
        fn values_with_params(&self, at: &[TextureContext; 4], params: &FieldParams) -> [f64; 4];
        fn takes_long_chain(&self) -> bool;
        fn value_bounds_near(&self, at: &TextureContext, params: &FieldParams, radius: f64) -> LocalBounds;
        fn support(&self) -> Option<Support>;
        fn default_wave(&self) -> Option<Wave>;
        fn starts_with_zero_frequency(&self) -> bool;
        fn handles_turbulence_itself(&self) -> bool;
        fn bumped_normal(&self, at: &TextureContext, params: &FieldParams, n: DVec3, amount: f64) -> Option<DVec3>;
        fn default_colors(&self) -> Vec<(f64, Color)>;
    }
}

/// Red, green, blue, yellow, cyan, magenta: default colours of cells.
const SIX_COLORS: [Rgb; 6] =
    [Rgb::X, Rgb::Y, Rgb::Z, Rgb::new(1.0, 1.0, 0.0), Rgb::new(0.0, 1.0, 1.0), Rgb::new(1.0, 0.0, 1.0)];

/// Number added before `floor`, so that a surface at a whole number is entirely in one cell of a pattern (quirk:
/// cell_edges).
const EDGE: f64 = 1e-10;
