//! The index: every word of the language, and where it belongs.

use super::{code, list, table};
use crate::pattern::{CellPattern, FieldPattern, Modifiers, Turbulent, Warp, bitmap};
use crate::syntax::word::{CONSTANTS, CONTEXTUAL, FUNCTIONS, KEYWORDS};
use crate::value::words::TRANSFORMS;
use crate::value::{Spec, Vocabulary, WordSpec};
use crate::{atmosphere, camera, function, interpreter, light, scene, shape, texture};
use std::collections::BTreeMap;

/// Words that stand in no table of a block, and the chapter about them.
const ELSEWHERE: &[(&str, &str)] = &[
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

type Index = BTreeMap<&'static str, Vec<String>>;

pub(super) fn index() -> String {
    let mut index = Index::new();
    blocks(&mut index);
    families(&mut index);
    values(&mut index);
    let all = KEYWORDS.iter().chain(FUNCTIONS).copied().chain(CONSTANTS.iter().map(|c| c.0));
    let mut all: Vec<_> = all.chain(CONTEXTUAL.iter().flat_map(|(_, words)| words.iter().copied())).collect();
    all.sort_unstable();
    all.dedup();
    let (told, later): (Vec<_>, Vec<_>) = all.into_iter().partition(|word| index.contains_key(word));
    let rows = told.iter().map(|word| [code(word), index[word].join("; ")]);
    format!(
        "What the language knows, and which blocks take it. No scene can declare these names; those that are *durer's own* are \
         words only in their blocks.\n\n{}\
         ## Not drawn yet\n\nThese too are words of the language, for things that are not drawn yet. durer reads them where \
         POV-Ray does.\n\n{}.\n",
        table(["word", "belongs to"], rows),
        list(later)
    )
}

fn add(index: &mut Index, word: &'static str, place: &str) {
    let places = index.entry(word).or_default();
    if !places.iter().any(|p| p == place) {
        places.push(place.into());
    }
}

fn add_words(index: &mut Index, words: &'static [WordSpec], place: &str) {
    words.iter().for_each(|w| add(index, w.name, place));
}

fn blocks(index: &mut Index) {
    use texture::words::{FINISH, IMAGE_MAP, INTERIOR, IRID, NORMAL, PIGMENT, REFLECTION, TEXTURE};
    let blocks: [(&'static Vocabulary, &str, &str); 17] = [
        (&interpreter::STATEMENTS, "the scene", "scene.md"),
        (&scene::words::MODIFIERS, "objects", "objects.md"),
        (&camera::words::POVRAY, "`camera`", "cameras.md"),
        (&camera::words::LECTURE, "durer's own `camera`", "cameras.md"),
        (&light::words::LIGHT, "`light_source`", "lights.md"),
        (&scene::LIGHT_GROUP, "`light_group`", "lights.md#light_group"),
        (&atmosphere::SKY_SPHERE, "`sky_sphere`", "atmosphere.md"),
        (&atmosphere::FOG, "`fog`", "atmosphere.md"),
        (&atmosphere::RAINBOW, "`rainbow`", "atmosphere.md"),
        (&PIGMENT, "`pigment`", "pigments.md"),
        (&IMAGE_MAP, "`image_map`", "pigments.md#image_map"),
        (&TEXTURE, "`texture`", "finishes.md"),
        (&NORMAL, "`normal`", "finishes.md"),
        (&FINISH, "`finish`", "finishes.md"),
        (&REFLECTION, "`reflection`", "finishes.md"),
        (&IRID, "`irid`", "finishes.md"),
        (&INTERIOR, "`interior`", "finishes.md"),
    ];
    for (block, name, page) in blocks {
        let place = format!("[{name}]({page})");
        add_words(index, block.words, &place);
        block.idle.iter().for_each(|word| add(index, word, &format!("{place}, without effect")));
        block.not_drawn.iter().for_each(|word| add(index, word, &format!("{place}, not drawn yet")));
    }
    let settings: &'static Vocabulary = &scene::words::SETTINGS;
    add_words(index, settings.words, "[`global_settings`](settings.md)");
    settings.idle.iter().for_each(|word| add(index, word, "[`global_settings`](settings.md), without effect"));
    settings.not_drawn.iter().for_each(|word| add(index, word, "[`global_settings`](settings.md), not drawn yet"));
    for (inner, page) in [
        ("finish", "finishes.md"),
        ("normal", "finishes.md"),
        ("interior", "finishes.md"),
        ("reflection", "finishes.md"),
    ] {
        add(index, inner, &format!("[a block]({page})"));
    }
}

fn families(index: &mut Index) {
    let mut family = |specs: &'static [&'static Spec], kind: &str, page: &str| {
        for spec in specs {
            add(index, spec.name, &format!("[a {kind}]({page}#{})", spec.name));
            add_words(index, spec.words, &format!("[`{}`]({page}#{})", spec.name, spec.name));
        }
    };
    family(shape::SPECS, "shape", "shapes.md");
    family(CellPattern::SPECS, "pattern", "pigments.md");
    family(FieldPattern::SPECS, "pattern", "pigments.md");
    family(Warp::SPECS, "warp", "pigments.md");
    add_words(index, bitmap::WORDS, "[pictures](pigments.md#pictures)");
    add_words(index, bitmap::CHANNELS, "[`image_pattern`, `bump_map`](pigments.md#what-counts-of-a-pixel)");
    bitmap::FORMATS.iter().for_each(|word| add(index, word, "[pictures](pigments.md#pictures), without effect"));
    add_words(index, Modifiers::WORDS, "[patterns](pigments.md)");
    add_words(index, Turbulent::WORDS, "[patterns](pigments.md)");
    add_words(index, TRANSFORMS, "[transforms](objects.md#transforms)");
}

fn values(index: &mut Index) {
    add_words(index, interpreter::COLOR_WORDS, "[colours](colors.md)");
    let numeric = function::numeric::TABLE.iter().map(|row| row.name);
    for name in numeric.chain(interpreter::functions().map(|(name, ..)| name)) {
        add(index, name, "[functions](functions.md)");
    }
    CONSTANTS.iter().for_each(|(name, _)| add(index, name, "[constants](constants.md)"));
    for (block, words) in CONTEXTUAL {
        words.iter().filter(|_| *block != "camera").for_each(|word| add(index, word, "*durer's own*"));
    }
    ELSEWHERE.iter().for_each(|(word, place)| add(index, word, place));
}
