//! Tables of all words of the scene language, for the manual and for editors.

mod words_by_kind;

pub use words_by_kind::{WordsByKind, words_by_kind};

use crate::medium::{INTERIOR, MEDIA, SCATTERING};
use crate::pattern::{CellPattern, FieldPattern, Warp};
use crate::shape::Shape;
use crate::texture::DENSITY;
use crate::texture::words::{FINISH, IMAGE_MAP, IRID, NORMAL, PIGMENT, REFLECTION, SUBSURFACE, TEXTURE};
use crate::value::{Family, Spec};
use crate::{atmosphere, camera, interpreter, light, scene};

/// A block of the language, with its place in the manual's reference.
#[derive(Clone, Copy, Debug)]
pub struct Entry {
    /// Parameters and words of the documented block.
    pub spec: &'static Spec,
    /// Name of the family to which the documented block belongs; `None` outside of the families.
    pub family: Option<&'static str>,
    /// True if the block is written with braces.
    pub has_braces: bool,
    /// Name of the documented block in Markdown; empty for a member of a family.
    title: &'static str,
    /// Page of the block in `docs/src/reference/`.
    pub page: &'static str,
}

impl Entry {
    const fn block(spec: &'static Spec, title: &'static str, page: &'static str) -> Self {
        Self { spec, family: None, has_braces: true, title, page }
    }

    /// Returns a Markdown link to the block's section, for other pages of the reference.
    pub fn link(&self) -> String {
        let Self { spec, title, page, .. } = self;
        if self.family.is_some() { format!("[`{0}`]({page}#{0})", spec.name) } else { format!("[{title}]({page})") }
    }

    /// Returns the syntax of the block, as the manual shows it.
    pub fn usage(&self) -> String {
        if self.has_braces { self.spec.block_usage() } else { self.spec.usage() }
    }
}

/// Documented blocks except shapes, patterns and warps.
pub const BLOCKS: &[Entry] = &[
    Entry::block(&interpreter::STATEMENTS, "the scene", "scene.md"),
    Entry::block(&scene::words::MODIFIERS, "objects", "objects.md"),
    Entry::block(&scene::OBJECT_RADIOSITY, "`radiosity` of objects", "objects.md#radiosity"),
    Entry::block(&scene::PHOTONS, "`photons` of objects", "objects.md#photons"),
    Entry::block(&camera::words::POVRAY, "`camera`", "cameras.md"),
    Entry::block(&camera::words::LECTURE, "durer's own `camera`", "cameras.md"),
    Entry::block(&light::words::LIGHT, "`light_source`", "lights.md"),
    Entry::block(&light::LIGHT_PHOTONS, "`photons` of lights", "photons.md#of-light-sources"),
    Entry::block(&scene::LIGHT_GROUP, "`light_group`", "lights.md#light_group"),
    Entry::block(&atmosphere::SKY_SPHERE, "`sky_sphere`", "atmosphere.md"),
    Entry::block(&atmosphere::FOG, "`fog`", "atmosphere.md"),
    Entry::block(&atmosphere::RAINBOW, "`rainbow`", "atmosphere.md"),
    Entry::block(&PIGMENT, "`pigment`", "pigments.md"),
    Entry::block(&IMAGE_MAP, "`image_map`", "pigments.md#image_map"),
    Entry::block(&TEXTURE, "`texture`", "finishes.md"),
    Entry::block(&NORMAL, "`normal`", "finishes.md"),
    Entry::block(&FINISH, "`finish`", "finishes.md"),
    Entry::block(&REFLECTION, "`reflection`", "finishes.md"),
    Entry::block(&IRID, "`irid`", "finishes.md"),
    Entry::block(&SUBSURFACE, "`subsurface` of `finish`", "finishes.md"),
    Entry::block(&INTERIOR, "`interior`", "finishes.md"),
    Entry::block(&MEDIA, "`media`", "media.md"),
    Entry::block(&SCATTERING, "`scattering`", "media.md#scattering"),
    Entry::block(&DENSITY, "`density`", "media.md#density"),
    Entry::block(&scene::words::SETTINGS, "`global_settings`", "settings.md"),
    Entry::block(&scene::RADIOSITY, "`radiosity` of `global_settings`", "settings.md#radiosity-of-the-scene"),
    Entry::block(&scene::SUBSURFACE, "`subsurface` of `global_settings`", "settings.md#subsurface-of-the-scene"),
    Entry::block(&scene::PHOTON_MAP, "`photons` of `global_settings`", "photons.md#of-global_settings"),
];

/// Returns the documented shapes, patterns and warps.
pub fn shape_pattern_warp_entries() -> impl Iterator<Item = Entry> {
    let families = [
        ("shape", true, "shapes.md", Shape::SPECS),
        ("pattern", false, "pigments.md", CellPattern::SPECS),
        ("pattern", false, "pigments.md", FieldPattern::SPECS),
        ("warp", false, "pigments.md", Warp::SPECS),
    ];
    families.into_iter().flat_map(|(family, has_braces, page, specs)| {
        specs.iter().map(move |&spec| Entry { spec, family: Some(family), has_braces, title: "", page })
    })
}

/// Returns all documented blocks: those of [`BLOCKS`], then shapes, patterns and warps.
pub fn documented_blocks() -> impl Iterator<Item = Entry> {
    BLOCKS.iter().copied().chain(shape_pattern_warp_entries())
}

/// Words that belong to no block's table, and the chapters about them.
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
    ("ttf", "[`text`](shapes.md#text), before the name of the font"),
    ("uint16be", "[`#write`](directives.md)"),
    ("uint16le", "[`#write`](directives.md)"),
    ("uint8", "[`#write`](directives.md)"),
    ("utf8", "behind `charset`"),
    ("warp", "[a block](pigments.md#warps) among transforms"),
    ("write", "[`#fopen`](directives.md)"),
];
