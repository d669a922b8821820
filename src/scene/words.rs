//! Words of all objects and of `global_settings`, for the readers and the manual.

use super::object::Flags;
use super::settings::{Settings, read_gamma};
use crate::pattern::read_noise_generator;
use crate::value::ValueKind::{Block, Color, Flag, Float};
use crate::value::ranges::positive;
use crate::value::words::{Row, joined, set, specs, word};
use crate::value::{Spec, WordSpec};

/// Words of the blocks that may stand inside an object, such as `texture` and `clipped_by`, with their descriptions.
const PARTS: &[WordSpec] = &[
    word("pigment", Block, "black", "colour of the surface, as in `texture { pigment { … } }`"),
    word("texture", Block, "", "appearance of the surface; several are layers, the last on top"),
    word("normal", Block, "", "bumps of the surface"),
    word("finish", Block, "", "reflection and emission of light by the surface"),
    word("interior", Block, "", "medium inside the object, such as its index of refraction"),
    word("material", Block, "", "texture, interior texture and interior together"),
    word("interior_texture", Block, "", "appearance of the surface from inside"),
    word("photons", Block, "", "interaction with photons"),
    word("radiosity", Block, "", "share of radiosity rays that are traced beyond the object's surface"),
    word("clipped_by", Block, "", "removes the parts outside of these objects; the cut stays open"),
    word(
        "bounded_by",
        Block,
        "",
        "hint: rays that miss these objects skip this one; rarely needed, since durer computes its own bounds",
    ),
];

/// Words of the switches of objects; `on` or `off` may follow each.
pub(super) const FLAGS: &[Row<Flags>] = &[
    word("no_shadow", Flag, "off", "the object casts no shadow").sets(|s, r| set(&mut s.no_shadow, r.flag())),
    word("no_image", Flag, "off", "camera rays miss the object; mirrors and shadows show it")
        .sets(|s, r| set(&mut s.no_image, r.flag())),
    word("no_reflection", Flag, "off", "reflected rays miss the object")
        .sets(|s, r| set(&mut s.no_reflection, r.flag())),
    word("no_radiosity", Flag, "off", "rays that gather light for radiosity miss the object")
        .sets(|s, r| set(&mut s.no_radiosity, r.flag())),
    word("hollow", Flag, "off", "fog fills the inside of the object, too").sets(|s, r| set(&mut s.hollow, r.flag())),
    word(
        "uv_mapping",
        Flag,
        "off",
        "the texture is evaluated at the surface coordinates (u, v, 0) instead of the point",
    )
    .sets(|s, r| set(&mut s.uv_mapping, r.flag())),
    // Each `inverse` toggles (quirk: `inverse_toggles`).
    word("inverse", Flag, "off", "exchanges inside and outside").sets(|s, r| r.flag().map(|on| s.inverse ^= on)),
    word("double_illuminate", Flag, "off", "light from behind illuminates the front of a surface, too")
        .sets(|s, r| set(&mut s.double_illuminate, r.flag())),
    word("cutaway_textures", Flag, "off", "cut surfaces show the texture of the object that was cut")
        .sets(|s, r| set(&mut s.cutaway_textures, r.flag())),
];

/// Words that every object takes, after those of its shape.
pub const MODIFIERS: Spec = Spec {
    name: "object",
    summary: "words that every object takes after those of its shape",
    words: &joined::<{ PARTS.len() + FLAGS.len() }>(PARTS, specs!(FLAGS)),
    has_transforms: true,
    ignored: &["sturm", "hierarchy", "split_union", "all_intersections"],
    ..Spec::EMPTY
};

/// Words of `global_settings`, and how each is read.
pub(super) const SETTINGS_ROWS: &[Row<Settings>] = &[
    word(
        "assumed_gamma",
        Float,
        "see below",
        "gamma of the scene's colours: 1 for linear light (recommended), or `srgb`",
    )
    // quirk: first_assumed_gamma
    .sets(|s, r| {
        let gamma = read_gamma(r)?;
        s.gamma.get_or_insert(gamma);
        Ok(())
    }),
    word("max_trace_level", Float, "5", "maximum number of reflections and refractions of a ray, 256 at most")
        .sets(Settings::read_max_trace_level),
    word("adc_bailout", Float, "1/255", "minimum weight of a ray; fainter rays are not traced")
        .sets(|s, r| set(&mut s.adc_bailout, r.float())),
    word("noise_generator", Float, "2 for `#version` 3.5 and later", "noise of patterns and functions: 1, 2 or 3")
        .sets(|s, r| set(&mut s.noise_generator, read_noise_generator(r, 1.0))),
    word(
        "irid_wavelength",
        Color,
        "<0.7, 0.52, 0.48>",
        "wavelengths of red, green and blue, in the units of `irid { thickness }`",
    )
    .sets(|s, r| set(&mut s.irid_wavelength, r.color().map(|c| c.rgb))),
    word("number_of_waves", Float, "10", "number of wave sources of the patterns `ripples` and `waves`")
        .sets(|s, r| set(&mut s.number_of_waves, r.float().map(|n| n.max(1.0) as usize))),
    word("ambient_light", Color, "1", "factor of `finish { ambient }` of all objects")
        .sets(|s, r| set(&mut s.ambient_light, r.color().map(|c| c.rgb))),
    word("mm_per_unit", Float, "10", "millimetres per unit of the scene, for `finish { subsurface }`")
        .sets(|s, r| set(&mut s.mm_per_unit, positive("mm_per_unit", r))),
];

/// Parts of `global_settings` with braces of their own.
const SETTINGS_PARTS: &[WordSpec] = &[
    word("photons", Block, "", "photon map: caustics of the objects that are targets of photons"),
    word("radiosity", Block, "", "diffuse light that surfaces receive from other surfaces and the sky"),
    word("subsurface", Block, "", "switches `finish { subsurface }` on"),
];

/// Specification of the block `global_settings`.
pub const SETTINGS: Spec = Spec {
    name: "global_settings",
    summary: "settings of the whole scene",
    words: &joined::<{ SETTINGS_ROWS.len() + SETTINGS_PARTS.len() }>(specs!(SETTINGS_ROWS), SETTINGS_PARTS),
    ignored: &["charset", "hf_gray_16", "max_intersections"],
    ..Spec::EMPTY
};
