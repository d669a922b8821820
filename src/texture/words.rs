//! The keywords of `pigment`, `finish` and `texture`, for readers and manual.

use super::finish::{Finish, Irid, Reflection, Subsurface};
use super::image_map::Clearness;
use super::normal::Normal;
use super::pigment::Pigment;
use crate::pattern::{CellPattern, FieldPattern, Modifiers};
use crate::value::ValueKind::{Block, Color, Flag, Float};
use crate::value::words::{Row, joined, set, specs, word};
use crate::value::{Family, ReaderExt, Spec, WordSpec};

/// Parts of a `pigment` block that have braces of their own.
const PIGMENT_PARTS: &[WordSpec] = &[
    word(
        "color_map",
        Block,
        "black to white",
        "`[number color]` entries: which colour each number of the pattern gets",
    ),
    word("colour_map", Block, "", "the same"),
    word("pigment_map", Block, "", "`[number pigment]` entries: which pigment each number of the pattern gets"),
    word("image_map", Block, "", "a picture"),
];

/// Words of a `pigment` block without braces, and how each is read.
pub(super) const PIGMENT_ROWS: &[Row<Pigment>] = &[
    word("quick_color", Color, "", "drawn in its place with `--quality 5` and less")
        .sets(|s, r| set(&mut s.quick_color, r.color().map(|c| Some(Box::new(c))))),
    word("quick_colour", Color, "", "the same")
        .sets(|s, r| set(&mut s.quick_color, r.color().map(|c| Some(Box::new(c))))),
];

/// Description of `pigment { … }`, except colours, patterns and [`Modifiers::WORDS`].
pub const PIGMENT: Spec = Spec {
    name: "pigment",
    summary: "the colour of every point: one colour, or a pattern with its colours",
    words: &joined::<{ PIGMENT_PARTS.len() + PIGMENT_ROWS.len() }>(PIGMENT_PARTS, specs!(PIGMENT_ROWS)),
    has_transforms: true,
    ignored: &["no_bump_scale"],
    ..Spec::EMPTY
};

/// Words of an `image_map` block, and how each is read.
pub(super) const IMAGE_MAP_ROWS: &[Row<Clearness>] = &[
    word("filter", Float, "0", "`filter all A` or, for one colour of a palette, `filter N, A`")
        .sets(Clearness::read_filter),
    word("transmit", Float, "0", "`transmit all A` or, for one colour of a palette, `transmit N, A`")
        .sets(Clearness::read_transmit),
];

/// Description of `image_map { … }`, except the words of all pictures
/// ([`bitmap::WORDS`](crate::pattern::bitmap::WORDS)).
pub const IMAGE_MAP: Spec = Spec {
    name: "image_map",
    summary: "a picture as the colours of a surface",
    words: specs!(IMAGE_MAP_ROWS),
    ..Spec::EMPTY
};

/// All words of a pigment, including those of colours and patterns.
pub fn words_of_pigment_block() -> Vec<&'static str> {
    let colors = ["color", "rgb", "rgbf", "rgbt", "rgbft", "srgb", "red", "green", "blue", "filter", "transmit"];
    let specs = || CellPattern::SPECS.iter().chain(FieldPattern::SPECS);
    let patterns = specs().map(|s| s.name).chain(Modifiers::WORDS.iter().map(|w| w.name));
    let own = specs().flat_map(|s: &&Spec| s.word_names());
    colors.into_iter().chain(patterns).chain(PIGMENT.word_names()).chain(own).collect()
}

/// Description of `texture { … }`.
pub const TEXTURE: Spec = Spec {
    name: "texture",
    summary: "what a surface looks like; several in a row are layers, the last on top",
    words: &[
        word("pigment", Block, "black", "its colour"),
        word("normal", Block, "", "its bumps"),
        word("finish", Block, "see `finish`", "its answer to light"),
        word("texture_map", Block, "", "after a pattern: which texture each of its numbers gets"),
        word("uv_mapping", Flag, "off", "it sees the place on the surface, (u, v, 0), instead of the point"),
        word("no_bump_scale", Flag, "off", "bumps keep their depth when they are scaled"),
        word("material_map", Block, "", "a picture whose numbers choose among textures"),
        word("tiles", Block, "", "of old scenes: a checker of two textures, `tiles { texture … tile2 texture … }`"),
    ],
    has_transforms: true,
    ..Spec::EMPTY
};

/// Parts of a `normal` block that have braces of their own.
const NORMAL_PARTS: &[WordSpec] = &[
    word("slope_map", Block, "", "`[number <height, slope>]` entries: the form of the bumps"),
    word("bump_map", Block, "", "a picture whose brightness is the height"),
    word("normal_map", Block, "", "`[number normal]` entries: which bumps each number of the pattern gets"),
];

/// Words of a `normal` block without braces, and how each is read.
pub(super) const NORMAL_ROWS: &[Row<Normal>] = &[
    word("bump_size", Float, "0.5", "how deep the bumps seem; also as a number after the pattern's name")
        .sets(|s, r| set(&mut s.amount, r.float())),
    word(
        "accuracy",
        Float,
        "0.02",
        "the distance at which heights are compared, for patterns without bumps of their own",
    )
    .sets(|s, r| set(&mut s.accuracy, r.float())),
    word("no_bump_scale", Flag, "off", "bumps keep their depth when they are scaled")
        .sets(|s, r| set(&mut s.bump_scale, r.flag().map(|on| !on))),
];

/// Description of `normal { … }`, except patterns and their words.
pub const NORMAL: Spec = Spec {
    name: "normal",
    summary: "bumps that only light sees: a pattern and how deep it seems, `normal { bumps 0.5 }`",
    words: &joined::<{ NORMAL_PARTS.len() + NORMAL_ROWS.len() }>(NORMAL_PARTS, specs!(NORMAL_ROWS)),
    has_transforms: true,
    ..Spec::EMPTY
};

/// Words of a `finish` block, and how each is read.
pub(super) const FINISH_ROWS: &[Row<Finish>] = &[
    word("ambient", Color, "0.1", "light that comes from everywhere, times `ambient_light` of `global_settings`")
        .sets(|s, r| set(&mut s.ambient, r.color().map(|c| c.rgb))),
    word("emission", Color, "0", "light of its own; it lights nothing else")
        .sets(|s, r| set(&mut s.emission, r.color().map(|c| c.rgb))),
    word(
        "diffuse",
        Float,
        "0.6",
        "how much of a light is scattered; `albedo` before it, and a second number for light from behind",
    )
    .sets(Finish::read_diffuse),
    word("brilliance", Float, "1", "above 1, light that falls at a slant counts for less")
        .sets(|s, r| set(&mut s.brilliance, r.float())),
    word(
        "phong",
        Float,
        "0",
        "strength of a highlight, brightest in the mirrored ray; `albedo` may stand before the number",
    )
    .sets(|s, r| {
        s.phong_albedo |= r.accept("albedo")?;
        set(&mut s.phong, r.float())
    }),
    word("phong_size", Float, "40", "how small that highlight is").sets(|s, r| set(&mut s.phong_size, r.float())),
    word("specular", Float, "0", "strength of a highlight of the other kind; `albedo` may stand before the number")
        .sets(|s, r| {
            s.specular_albedo |= r.accept("albedo")?;
            set(&mut s.specular, r.float())
        }),
    word("roughness", Float, "0.05", "how large that highlight is: 0.0005 is polished, 1 is dull")
        .sets(|s, r| set(&mut s.roughness, r.float())),
    word("metallic", Float, "0; 1 without a number", "how much the highlights take the pigment's colour")
        .sets(|s, r| set(&mut s.metallic, r.optional_float().map(|x| x.unwrap_or(1.0)))),
    word("crand", Float, "0", "grain, for rough stone").sets(|s, r| set(&mut s.crand, r.float())),
    word("reflection", Color, "0", "how much is mirrored; in braces with the words of `reflection`")
        .sets(Finish::read_plain_reflection),
    word("reflection_exponent", Float, "1", "old spelling of `exponent` in `reflection { }`")
        .sets(|s, r| set(&mut s.reflection.exponent, r.float())),
    word("irid", Block, "", "the colours of a thin film, as on soap bubbles")
        .sets(|_, r| Err(r.unexpected("`{`").into())),
    word("subsurface", Block, "", "light that enters the solid and leaves it elsewhere, as in wax and marble")
        .sets(|_, r| Err(r.unexpected("`{`").into())),
    word("conserve_energy", Flag, "off", "what is mirrored is taken from what shines through")
        .sets(|s, r| set(&mut s.conserve_energy, r.flag())),
    word("ior", Float, "", "as in `interior`, which is newer; that of the topmost layer goes before the interior's")
        .sets(|s, r| set(&mut s.uncommon.ior, r.float().map(Some))),
    word("caustics", Float, "", "45 times what it is in `interior`, which is newer; the topmost layer's goes before")
        .sets(|s, r| set(&mut s.uncommon.caustics, r.float().map(|x| Some(x / 45.0)))),
    word(
        "refraction",
        Float,
        "1",
        "in old scenes: factor of the light that passes the topmost layer, but not of shadows",
    )
    .sets(|s, r| set(&mut s.uncommon.refraction, r.float())),
];

/// Description of `finish { … }`.
pub const FINISH: Spec = Spec {
    name: "finish",
    summary: "how a surface answers to light",
    words: specs!(FINISH_ROWS),
    ignored: &["fade_distance", "fade_power"],
    ..Spec::EMPTY
};

/// Words of a finish's `irid` block, and how each is read.
pub(super) const IRID_ROWS: &[Row<Irid>] = &[
    word("thickness", Float, "0", "of the film, in the units of `irid_wavelength`")
        .sets(|s, r| set(&mut s.thickness, r.float())),
    word("turbulence", Float, "0", "how much the thickness varies").sets(|s, r| set(&mut s.turbulence, r.float())),
];

/// Description of `finish { irid { … } }`.
pub const IRID: Spec = Spec {
    name: "irid",
    summary: "the colours of a thin film: `{ amount thickness T turbulence U }`",
    words: specs!(IRID_ROWS),
    ..Spec::EMPTY
};

/// Words of a finish's `subsurface` block, and how each is read.
pub(super) const SUBSURFACE_ROWS: &[Row<Subsurface>] = &[word(
    "translucency",
    Color,
    "0",
    "mean distance that light travels inside between two changes of its direction, in millimetres, per channel",
)
.sets(|s, r| set(&mut s.translucency, r.color().map(|c| c.rgb)))];

/// Description of `finish { subsurface { … } }`.
pub const SUBSURFACE: Spec = Spec {
    name: "subsurface",
    summary: "light that enters the solid and leaves it elsewhere, if `global_settings` has a `subsurface` block",
    words: specs!(SUBSURFACE_ROWS),
    ..Spec::EMPTY
};

/// Words of a finish's `reflection` block, and how each is read.
pub(super) const REFLECTION_ROWS: &[Row<Reflection>] = &[
    word("fresnel", Flag, "off", "the angle counts as for glass and water, by the `ior` of the interior")
        .sets(|s, r| set(&mut s.fresnel, r.flag())),
    word("falloff", Float, "1", "how late the second colour comes in").sets(|s, r| set(&mut s.falloff, r.float())),
    word("exponent", Float, "1", "of the light that is mirrored").sets(|s, r| set(&mut s.exponent, r.float())),
    word("metallic", Float, "0; 1 without a number", "how much the mirror takes the pigment's colour")
        .sets(|s, r| set(&mut s.metallic, r.optional_float().map(|x| x.unwrap_or(1.0)))),
];

/// Description of `finish { reflection { … } }`.
pub const REFLECTION: Spec = Spec {
    name: "reflection",
    summary: "a mirror: `{ colour }`, or `{ colour seen straight on, colour seen at a slant }`",
    words: specs!(REFLECTION_ROWS),
    ..Spec::EMPTY
};
