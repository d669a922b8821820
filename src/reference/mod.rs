//! All tables of words of the readers, for the manual and for editors.

mod sorts;

pub use sorts::{Sorts, sorts};

use crate::medium::INTERIOR;
use crate::pattern::{CellPattern, FieldPattern, Warp};
use crate::texture::words::{FINISH, IMAGE_MAP, IRID, NORMAL, PIGMENT, REFLECTION, TEXTURE};
use crate::value::{Spec, Vocabulary};
use crate::{atmosphere, camera, interpreter, light, scene, shape};

/// A block and its page in the manual's reference.
#[derive(Debug)]
pub struct Block {
    /// Words of the documented block.
    pub words: &'static Vocabulary,
    /// Name of the documented block in Markdown.
    pub name: &'static str,
    /// Page of the block in `docs/src/reference/`.
    pub page: &'static str,
}

/// Shapes, patterns or warps, each with its own table.
#[derive(Debug)]
pub struct Family {
    /// Word tables of the family's members.
    pub specs: &'static [&'static Spec],
    /// Name for the kind of the family's members.
    pub kind: &'static str,
    /// Page of the family in `docs/src/reference/`.
    pub page: &'static str,
}

const fn block(words: &'static Vocabulary, name: &'static str, page: &'static str) -> Block {
    Block { words, name, page }
}

/// Documented blocks outside of the families.
pub const BLOCKS: &[Block] = &[
    block(&interpreter::STATEMENTS, "the scene", "scene.md"),
    block(&scene::words::MODIFIERS, "objects", "objects.md"),
    block(&scene::PHOTONS, "`photons` of objects", "objects.md#photons"),
    block(&camera::words::POVRAY, "`camera`", "cameras.md"),
    block(&camera::words::LECTURE, "durer's own `camera`", "cameras.md"),
    block(&light::words::LIGHT, "`light_source`", "lights.md"),
    block(&scene::LIGHT_GROUP, "`light_group`", "lights.md#light_group"),
    block(&atmosphere::SKY_SPHERE, "`sky_sphere`", "atmosphere.md"),
    block(&atmosphere::FOG, "`fog`", "atmosphere.md"),
    block(&atmosphere::RAINBOW, "`rainbow`", "atmosphere.md"),
    block(&PIGMENT, "`pigment`", "pigments.md"),
    block(&IMAGE_MAP, "`image_map`", "pigments.md#image_map"),
    block(&TEXTURE, "`texture`", "finishes.md"),
    block(&NORMAL, "`normal`", "finishes.md"),
    block(&FINISH, "`finish`", "finishes.md"),
    block(&REFLECTION, "`reflection`", "finishes.md"),
    block(&IRID, "`irid`", "finishes.md"),
    block(&INTERIOR, "`interior`", "finishes.md"),
    block(&scene::words::SETTINGS, "`global_settings`", "settings.md"),
];

/// All documented families of blocks, such as shapes.
pub const FAMILIES: &[Family] = &[
    Family { specs: shape::SPECS, kind: "shape", page: "shapes.md" },
    Family { specs: CellPattern::SPECS, kind: "pattern", page: "pigments.md" },
    Family { specs: FieldPattern::SPECS, kind: "pattern", page: "pigments.md" },
    Family { specs: Warp::SPECS, kind: "warp", page: "pigments.md" },
];

/// Words that are in no table of a block, and the chapters about them.
pub const ELSEWHERE: &[(&str, &str)] = &[
    ("albedo", "[`finish`](finishes.md), before the number of `diffuse`, `phong` or `specular`"),
    ("all", "`filter all` and `transmit all` in [`image_map`](pigments.md#image_map)"),
    ("altitude", "[`slope`](pigments.md#slope)"),
    ("append", "[`#fopen`](directives.md)"),
    ("ascii", "behind `charset`"),
    ("array", "[arrays](../arrays.md)"),
    ("average", "[a pattern](pigments.md#average)"),
    ("b_spline", "[splines](../functions.md)"),
    ("cubic_spline", "[splines](../functions.md)"),
    ("deprecated", "behind `#declare`: using the name gets a warning"),
    ("df3", "[`density_file`](pigments.md#density_file)"),
    ("function", "[functions](../functions.md)"),
    ("gray", "a component of a [pigment's function](../functions.md)"),
    ("internal", "functions of `functions.inc`, in `function { }`"),
    ("linear_spline", "[splines](../functions.md)"),
    ("natural_spline", "[splines](../functions.md)"),
    ("once", "behind `#declare deprecated`: warns only once"),
    ("pattern", "[a function](../functions.md) made of a pattern"),
    ("prod", "products in `function { }`"),
    ("quadratic_spline", "[splines](../functions.md)"),
    ("read", "[`#fopen`](directives.md)"),
    ("sint16be", "[`#write`](directives.md)"),
    ("sint16le", "[`#write`](directives.md)"),
    ("sint32be", "[`#write`](directives.md)"),
    ("sint32le", "[`#write`](directives.md)"),
    ("sint8", "[`#write`](directives.md)"),
    ("spline", "[splines](../functions.md)"),
    ("sum", "sums in `function { }`"),
    ("sys", "behind `charset`"),
    ("tile2", "`tiles` in [`texture`](finishes.md)"),
    ("uint16be", "[`#write`](directives.md)"),
    ("uint16le", "[`#write`](directives.md)"),
    ("uint8", "[`#write`](directives.md)"),
    ("utf8", "behind `charset`"),
    ("warp", "[a block](pigments.md#warps) among transforms"),
    ("write", "[`#fopen`](directives.md)"),
];
