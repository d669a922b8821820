//! The words of `pigment`, `finish`, `texture` and `interior`: what the readers obey and the manual lists.

use crate::pattern::{CellPattern, FieldPattern, Modifiers};
use crate::value::Kind::{Block, Color, Flag, Float};
use crate::value::words::word;
use crate::value::{Spec, Vocabulary};

/// `pigment { … }`, beside colours, patterns and [`Modifiers::WORDS`].
pub const PIGMENT: Vocabulary = Vocabulary {
    block: "pigment",
    summary: "the colour of every point: one colour, or a pattern with its colours",
    words: &[
        word(
            "color_map",
            Block,
            "black to white",
            "`[number color]` entries: which colour each number of the pattern gets",
        ),
        word("colour_map", Block, "", "the same"),
        word("pigment_map", Block, "", "`[number pigment]` entries: which pigment each number of the pattern gets"),
        word("image_map", Block, "", "a picture"),
        word("quick_color", Color, "", "drawn in its place with `--quality 5` and less"),
        word("quick_colour", Color, "", "the same"),
    ],
    moves: true,
    idle: &["no_bump_scale"],
    not_drawn: &[],
};

/// `image_map { … }`, beside the words of all pictures ([`bitmap::WORDS`](crate::pattern::bitmap::WORDS)).
pub const IMAGE_MAP: Vocabulary = Vocabulary {
    block: "image_map",
    summary: "a picture as the colours of a surface",
    words: &[
        word("filter", Float, "0", "`filter all A` or, for one colour of a palette, `filter N, A`"),
        word("transmit", Float, "0", "`transmit all A` or, for one colour of a palette, `transmit N, A`"),
    ],
    moves: false,
    idle: &[],
    not_drawn: &[],
};

/// All words of a pigment, those of colours and patterns among them.
pub fn pigment_names() -> Vec<&'static str> {
    let colors = ["color", "rgb", "rgbf", "rgbt", "rgbft", "srgb", "red", "green", "blue", "filter", "transmit"];
    let specs = || CellPattern::SPECS.iter().chain(FieldPattern::SPECS);
    let patterns = specs().map(|s| s.name).chain(Modifiers::WORDS.iter().map(|w| w.name));
    let own = specs().flat_map(|s: &&Spec| s.word_names());
    colors.into_iter().chain(patterns).chain(PIGMENT.names()).chain(own).collect()
}

/// `texture { … }`
pub const TEXTURE: Vocabulary = Vocabulary {
    block: "texture",
    summary: "what a surface looks like; several behind one another are layers, the last on top",
    words: &[
        word("pigment", Block, "black", "its colour"),
        word("normal", Block, "", "its bumps"),
        word("finish", Block, "see `finish`", "its answer to light"),
        word("texture_map", Block, "", "behind a pattern: which texture each of its numbers gets"),
        word("uv_mapping", Flag, "off", "it sees the place on the surface, (u, v, 0), instead of the point"),
        word("no_bump_scale", Flag, "off", "bumps keep their depth when they are scaled"),
        word("material_map", Block, "", "a picture whose numbers choose among textures"),
        word("tiles", Block, "", "of old scenes: a checker of two textures, `tiles { texture … tile2 texture … }`"),
    ],
    moves: true,
    idle: &[],
    not_drawn: &[],
};

/// `normal { … }`, beside patterns and their words.
pub const NORMAL: Vocabulary = Vocabulary {
    block: "normal",
    summary: "bumps that only light sees: a pattern and how deep it seems, `normal { bumps 0.5 }`",
    words: &[
        word("bump_size", Float, "0.5", "how deep the bumps seem; also as a number behind the pattern's name"),
        word(
            "accuracy",
            Float,
            "0.02",
            "the distance at which heights are compared, for patterns without bumps of their own",
        ),
        word("no_bump_scale", Flag, "off", "bumps keep their depth when they are scaled"),
        word("slope_map", Block, "", "`[number <height, slope>]` entries: the form of the bumps"),
        word("bump_map", Block, "", "a picture whose brightness is the height"),
        word("normal_map", Block, "", "`[number normal]` entries: which bumps each number of the pattern gets"),
    ],
    moves: true,
    idle: &[],
    not_drawn: &[],
};

/// `finish { … }`
pub const FINISH: Vocabulary = Vocabulary {
    block: "finish",
    summary: "how a surface answers to light",
    words: &[
        word("ambient", Color, "0.1", "light that comes from everywhere, times `ambient_light` of `global_settings`"),
        word("emission", Color, "0", "light of its own; it lights nothing else"),
        word(
            "diffuse",
            Float,
            "0.6",
            "how much of a light is scattered; `albedo` before it, and a second number for light from behind",
        ),
        word("brilliance", Float, "1", "above 1, light that falls at a slant counts for less"),
        word(
            "phong",
            Float,
            "0",
            "strength of a highlight, brightest in the mirrored ray; `albedo` may stand before the number",
        ),
        word("phong_size", Float, "40", "how small that highlight is"),
        word("specular", Float, "0", "strength of a highlight of the other kind; `albedo` may stand before the number"),
        word("roughness", Float, "0.05", "how large that highlight is: 0.0005 is polished, 1 is dull"),
        word("metallic", Float, "0; 1 without a number", "how much the highlights take the pigment's colour"),
        word("crand", Float, "0", "grain, for rough stone"),
        word("reflection", Color, "0", "how much is mirrored; in braces with the words of `reflection`"),
        word("reflection_exponent", Float, "1", "old spelling of `exponent` in `reflection { }`"),
        word("irid", Block, "", "the colours of a thin film, as on soap bubbles"),
        word("conserve_energy", Flag, "off", "what is mirrored is taken from what shines through"),
        word(
            "ior",
            Float,
            "",
            "as in `interior`, which is newer; that of the topmost layer goes before the interior's",
        ),
        word(
            "caustics",
            Float,
            "",
            "45 times what it is in `interior`, which is newer; the topmost layer's goes before",
        ),
        word(
            "refraction",
            Float,
            "1",
            "in old scenes: factor of the light that passes the topmost layer, but not of shadows",
        ),
    ],
    moves: false,
    idle: &["fade_distance", "fade_power"],
    not_drawn: &["subsurface"],
};

/// `finish { irid { … } }`
pub const IRID: Vocabulary = Vocabulary {
    block: "irid",
    summary: "the colours of a thin film: `{ amount thickness T turbulence U }`",
    words: &[
        word("thickness", Float, "0", "of the film, in the units of `irid_wavelength`"),
        word("turbulence", Float, "0", "how much the thickness varies"),
    ],
    moves: false,
    idle: &[],
    not_drawn: &[],
};

/// `finish { reflection { … } }`
pub const REFLECTION: Vocabulary = Vocabulary {
    block: "reflection",
    summary: "a mirror: `{ colour }`, or `{ colour seen straight on, colour seen at a slant }`",
    words: &[
        word("fresnel", Flag, "off", "the angle counts as for glass and water, by the `ior` of the interior"),
        word("falloff", Float, "1", "how late the second colour comes in"),
        word("exponent", Float, "1", "of the light that is mirrored"),
        word("metallic", Float, "0; 1 without a number", "how much the mirror takes the pigment's colour"),
    ],
    moves: false,
    idle: &[],
    not_drawn: &[],
};

/// `interior { … }`
pub const INTERIOR: Vocabulary = Vocabulary {
    block: "interior",
    summary: "what fills a shape",
    words: &[
        word("ior", Float, "1", "how much light is bent that enters: 1.33 is water, 1.5 glass, 2.4 diamond"),
        word(
            "dispersion",
            Float,
            "1",
            "the ratio of violet's index of refraction to red's: 1.01 to 1.1 shows the colours of a prism",
        ),
        word("dispersion_samples", Float, "7", "into how many colours light splits, 2 or more"),
        word("fade_distance", Float, "0", "how far light goes until it has lost half; 0 if it loses nothing"),
        word("fade_power", Float, "0", "how fast light fades; 1 to 2 is usual, from 1000 on it fades exponentially"),
        word("fade_color", Color, "0", "what is left of light that has gone far"),
        word("fade_colour", Color, "", "the same"),
        word("caustics", Float, "0", "makes shadows bright where light falls straight in; larger is narrower"),
    ],
    moves: false,
    idle: &["refraction"],
    not_drawn: &["media"],
};
