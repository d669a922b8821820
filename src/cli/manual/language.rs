//! Manual pages about blocks and their words.

use super::{in_backticks, list_in_backticks, section, table, value_description, word_table};
use crate::pattern::{CellPattern, FieldPattern, Modifiers, TurbulenceParams, Warp, bitmap};
use crate::shape::Shape;
use crate::syntax::word::durer_words_of_block;
use crate::value::words::TRANSFORMS;
use crate::value::{Family, Spec};
use crate::{atmosphere, camera, interpreter, light, medium, scene, texture};

pub(super) fn scene_page() -> String {
    let shapes = list_in_backticks(Shape::SPECS.iter().map(|s| s.name));
    section(&interpreter::STATEMENTS, "Outside of all braces", &[]) + &format!("[Shapes](shapes.md): {shapes}.\n")
}

pub(super) fn shapes_page() -> String {
    let intro = "Behind what is listed here, every shape takes what [any object](objects.md) takes.\n\n";
    let each = Shape::SPECS.iter().map(|spec| shape_section(spec)).collect::<String>();
    intro.to_string() + &each
}

fn shape_section(spec: &Spec) -> String {
    let mut text = format!("## {}\n\n`{}`: {}.\n\n", spec.name, spec.block_usage(), spec.summary.trim_end_matches('.'));
    if !spec.params.is_empty() {
        let row = |p: &crate::value::Param| [p.name.to_string(), value_description(p.kind).into(), p.summary.into()];
        text += &table(["in this order", "is a", ""], spec.params.iter().map(row));
    }
    if !spec.words.is_empty() {
        let behind = if spec.params.is_empty() { "" } else { "Behind these, in any order:\n\n" };
        text += &(behind.to_string() + &word_table(spec.words, durer_words_of_block(spec.name)));
    }
    text
}

pub(super) fn objects_page() -> String {
    let moves = word_table(TRANSFORMS, &[]);
    let intro = "`union`, `merge`, `intersection` and `difference` take objects, `object` takes one, and a shape what \
                 [its own page](shapes.md) says; then each takes these words.\n\n";
    let transforms = format!("## Transforms\n\nObeyed in the order in which they are written.\n\n{moves}");
    intro.to_string()
        + &section(&scene::words::MODIFIERS, "Any object", &[])
        + &transforms
        + &section(&scene::PHOTONS, "photons", &[])
        + &section(&scene::OBJECT_RADIOSITY, "radiosity", &[])
}

pub(super) fn cameras_page() -> String {
    let kinds = camera::words::KINDS.iter().map(|kind| {
        // Shapes and patterns have these names, too.
        let more = if matches!(kind.name, "cylinder" | "spherical") { " camera" } else { "" };
        format!("## {}{more}\n\nWith the word {}: {}.\n\n", kind.name, in_backticks(kind.name), kind.summary)
    });
    let mesh = "Rays begin in the middle of the faces of meshes, and go along their normals: a camera of any form, or, with distribution 3, a \
                picture of the light on a mesh, for its `uv_mapping`. `mesh_camera { rays distribution [distance] mesh { … } … }`: of several \
                rays a pixel each has a mesh of its own, and the mean is seen; what is farther away than the distance is not seen. With \
                distribution 0 each mesh has a face for each pixel, row by row; with 1 all meshes have together; with 2 each has a \
                stripe of the picture; with 3 a pixel belongs to the face whose uv it lies in, and `smooth` behind the mesh takes the \
                normals of the corners. Of `location` and `direction` only z counts: how far before the face a ray begins, and, below \
                0, that it goes the other way.\n\n";
    let bumps = "A `normal { … }` turns the rays as bumps turn the normal of a surface, as glass with bumps would. Its pattern lies in \
                 the picture, which goes from -0.5 to 0.5 in x and y; for cameras of angles, in those, in radians.\n\n";
    let blur = "What is not as far ahead as `focal_point` is from `location` is blurred. More rays a pixel make it smoother: as many as the pixel needs, \
                up to the number of `blur_samples`.\n\n";
    let bokeh = "What is far out of focus shows the lens: a disc, or what `bokeh { pigment { … } }` says from <0, 0> to <1, 1>: more of the light \
                 passes where the pigment is lighter; y goes down. The picture as a whole stays as bright.\n\n";
    section(&camera::words::POVRAY, "POV-Ray's camera", &[])
        + &kinds.collect::<String>()
        + &format!("## Mesh camera\n\n{mesh}## Bumps before the camera\n\n{bumps}")
        + &format!("## Focal blur\n\n{blur}{}", word_table(camera::words::BLUR, &[]))
        + &format!("## Bokeh\n\n{bokeh}")
        + &section(&camera::words::LECTURE, "durer's own camera", durer_words_of_block("camera"))
}

pub(super) fn lights_page() -> String {
    let kinds = [
        (
            "spotlight",
            "`spotlight`",
            "it shines into a cone about the line to `point_at`; `radius` and `falloff` are angles from that line",
        ),
        (
            "cylinder light",
            "`cylinder`",
            "it shines along a tube; `radius` and `falloff` are lengths, and the light is parallel",
        ),
        ("parallel", "`parallel`", "its light comes from the plane through its place, across the line to `point_at`"),
        (
            "area_light",
            "`area_light`",
            "a grid of lights about its place, whose shadows are soft; `adaptive 1` makes it quick",
        ),
        ("looks_like", "`looks_like`", "an object about the origin is seen in the light's place"),
        (
            "projected_through",
            "`projected_through`",
            "light falls only where it has passed an object, which is not seen itself",
        ),
    ];
    let kinds = kinds.map(|(title, word, text)| format!("## {title}\n\n{word}: {text}.\n\n")).concat();
    section(&light::words::LIGHT, "light_source", &[]) + &kinds + &section(&scene::LIGHT_GROUP, "light_group", &[])
}

pub(super) fn atmosphere_page() -> String {
    let fog = "Of several fogs each covers what lies behind it. It is not in what is not `hollow`, and not seen with `--quality 8` and \
               less. Light on its way to a surface goes through it freely, but for lights with `media_attenuation on`.\n\n";
    section(&atmosphere::SKY_SPHERE, "sky_sphere", &[])
        + &section(&atmosphere::FOG, "fog", &[])
        + fog
        + &section(&atmosphere::RAINBOW, "rainbow", &[])
}

pub(super) fn media_page() -> String {
    let intro = "`media { … }` fills the `interior` of an object, or the whole scene if it is outside of objects. The chapter \
                 [Smoke, fire and light shafts](../media.md) shows how to begin.\n\n";
    let density = "A density begins like a [pigment](pigments.md): a colour, or a pattern with its words, its map and its \
                   [transforms](objects.md#transforms). Without a map, a pattern has the colours that it has in a pigment.\n\n";
    intro.to_string()
        + &section(&medium::MEDIA, "media", &[])
        + &section(&medium::SCATTERING, "scattering", &[])
        + &section(&texture::DENSITY, "density", &[])
        + density
}

pub(super) fn photons_page() -> String {
    let intro = "Three blocks are named `photons`: one in `global_settings`, one in light sources, and one in \
                 [objects](objects.md#photons). The chapter [Caustics](../photons.md) shows how to begin.\n\n";
    intro.to_string()
        + &section(&scene::PHOTON_MAP, "Of global_settings", &[])
        + &section(&light::LIGHT_PHOTONS, "Of light sources", &[])
}

pub(super) fn colors_page() -> String {
    let words = word_table(interpreter::COLOR_WORDS, &[]);
    format!(
        "A colour has five numbers: red, green, blue, filter and transmit. A number in a vector's place stands for all of \
         them that the word names.\n\n{words}"
    )
}

pub(super) fn pigments_page() -> String {
    let modifiers = word_table(Modifiers::WORDS, &[])
        + "And what stirs the point that the pattern is asked about:\n\n"
        + &word_table(TurbulenceParams::WORDS, &[]);
    let warps = Warp::SPECS.iter().map(|spec| pattern_section(spec)).collect::<String>();
    let cells = CellPattern::SPECS.iter().map(|spec| pattern_section(spec)).collect::<String>();
    let fields = FieldPattern::SPECS.iter().map(|spec| pattern_section(spec)).collect::<String>();
    section(&texture::words::PIGMENT, "pigment", &[])
        + &image_block_sections()
        + "# Patterns of cells\n\nEach kind of cell has a colour, or a pigment, of its own.\n\n"
        + &cells
        + "# Patterns of numbers\n\nEach point has a number, which `color_map` turns into a colour.\n\n"
        + &fields
        + AVERAGE
        + &format!(
            "## Words of all patterns of numbers\n\n{modifiers}# Warps\n\n`warp {{ … }}` moves \
                    points in ways that no matrix can; it stands among the transforms, which are obeyed in the order in \
                    which they are written.\n\n{warps}"
        )
}

/// Section of the manual about the pattern `average`, which has no values of its own.
const AVERAGE: &str = "## average\n\n`average`: all entries of a `pigment_map`, `normal_map` or `texture_map` at once. Their \
                       numbers are weights; one that is left out is 1, but before a colour it must be there.\n\n";

/// Returns the sections about `image_map` and related blocks.
fn image_block_sections() -> String {
    let formats = list_in_backticks(bitmap::FORMATS);
    let all = word_table(bitmap::WORDS, &[]);
    let image_map = section(&texture::words::IMAGE_MAP, "image_map", &[]);
    let channels = word_table(bitmap::CHANNELS, &[]);
    format!(
        "## Pictures\n\n`image_map`, [`image_pattern`](#image_pattern), [`bump_map` and `material_map`](finishes.md) begin with \
         a file's name, or with `function W, H {{ … }}`: a picture of W by H points from (0, 0), on top, to (1, 1). The name of a \
         format may stand before the file's name and changes nothing: {formats}. All of them take these words:\n\n{all}{image_map}\
         ## What counts of a pixel\n\nIn `image_pattern` and `bump_map`.\n\n{channels}"
    )
}

fn pattern_section(spec: &Spec) -> String {
    let mut text = format!("## {}\n\n{}: {}.\n\n", spec.name, in_backticks(&spec.usage()), spec.summary);
    if !spec.words.is_empty() {
        text += &word_table(spec.words, &[]);
    }
    text
}

pub(super) fn finishes_page() -> String {
    use crate::medium::INTERIOR;
    use texture::words::{FINISH, IRID, NORMAL, REFLECTION, SUBSURFACE, TEXTURE};
    let blocks = [&TEXTURE, &NORMAL, &FINISH, &REFLECTION, &IRID, &SUBSURFACE, &INTERIOR];
    blocks.map(|block| section(block, block.name, &[])).concat()
}

pub(super) fn settings_page() -> String {
    section(&scene::words::SETTINGS, "global_settings", &[])
        + "Without `assumed_gamma`, durer does what POV-Ray does for the file's `#version`. Write \
           `global_settings { assumed_gamma 1 }` into every new scene.\n\n"
        + &section(&scene::RADIOSITY, "Radiosity of the scene", &[])
        + &section(&scene::SUBSURFACE, "Subsurface of the scene", &[])
}
