//! Words of all objects and of `global_settings`, for the readers and the manual.

use super::object::Flags;
use super::settings::{Settings, read_gamma};
use crate::pattern::read_noise_generator;
use crate::value::ValueKind::{Block, Color, Flag, Float};
use crate::value::words::{Row, joined, set, specs, word};
use crate::value::{Spec, WordSpec};

/// Words of blocks inside objects.
const PARTS: &[WordSpec] = &[
    word("pigment", Block, "black", "its colour, as `texture { pigment { … } }` says it too"),
    word("texture", Block, "", "what it looks like; several are layers, the last on top"),
    word("normal", Block, "", "its bumps"),
    word("finish", Block, "", "its answer to light"),
    word("interior", Block, "", "what fills it"),
    word("material", Block, "", "texture, interior texture and interior in one"),
    word("interior_texture", Block, "", "what it looks like from inside"),
    word("photons", Block, "", "which photons the object receives; photons are not drawn yet"),
    word("radiosity", Block, "", "how exactly radiosity gathers light at the object; radiosity is not drawn yet"),
    word("clipped_by", Block, "", "only what lies in these objects is left; what is cut stays open"),
    word("bounded_by", Block, "", "rays that miss one of these objects see nothing of it; durer needs no such hint"),
];

/// Words of the switches of objects; `on` or `off` may follow each.
pub(super) const FLAGS: &[Row<Flags>] = &[
    word("no_shadow", Flag, "off", "it casts no shadow").sets(|s, r| set(&mut s.no_shadow, r.flag())),
    word("no_image", Flag, "off", "it is not seen directly, but in mirrors and as a shadow")
        .sets(|s, r| set(&mut s.no_image, r.flag())),
    word("no_reflection", Flag, "off", "it is not seen in mirrors").sets(|s, r| set(&mut s.no_reflection, r.flag())),
    word("no_radiosity", Flag, "off", "it is not seen by radiosity, which is not drawn yet")
        .sets(|s, r| set(&mut s.no_radiosity, r.flag())),
    word("hollow", Flag, "off", "media and fog, which are not drawn yet, are inside too")
        .sets(|s, r| set(&mut s.hollow, r.flag())),
    word("uv_mapping", Flag, "off", "its texture sees the place on the surface, (u, v, 0), instead of the point")
        .sets(|s, r| set(&mut s.uv_mapping, r.flag())),
    // Each `inverse` toggles (quirk: `inverse_toggles`).
    word("inverse", Flag, "off", "inside and outside change places").sets(|s, r| r.flag().map(|on| s.inverse ^= on)),
    word("double_illuminate", Flag, "off", "light on the far side of a surface shows on this side")
        .sets(|s, r| set(&mut s.double_illuminate, r.flag())),
    word("cutaway_textures", Flag, "off", "a cut shows the texture of what was cut")
        .sets(|s, r| set(&mut s.cutaway_textures, r.flag())),
];

/// Words that every object takes, after those of its shape.
pub const MODIFIERS: Spec = Spec {
    name: "object",
    summary: "what any object takes behind the words of its own",
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
        "how the scene's numbers are meant: 1 is linear light, which is what you want; or `srgb`",
    )
    .sets(|s, r| set(&mut s.gamma, read_gamma(r).map(Some))),
    word("max_trace_level", Float, "5", "how often a ray may be mirrored and bent, 256 at most")
        .sets(Settings::read_max_trace_level),
    word("adc_bailout", Float, "1/255", "rays that count for less are not followed")
        .sets(|s, r| set(&mut s.adc_bailout, r.float())),
    word("noise_generator", Float, "2 for `#version` 3.5 and later", "which noise functions are made of: 1, 2 or 3")
        .sets(|s, r| set(&mut s.noise_generator, read_noise_generator(r, 1.0))),
    word(
        "irid_wavelength",
        Color,
        "<0.7, 0.52, 0.48>",
        "of red, green and blue light, in the units of `irid`'s `thickness`",
    )
    .sets(|s, r| set(&mut s.irid_wavelength, r.color().map(|c| c.rgb))),
    word("number_of_waves", Float, "10", "how many sources the patterns `ripples` and `waves` have")
        .sets(|s, r| set(&mut s.number_of_waves, r.float().map(|n| n.max(1.0) as usize))),
    word("ambient_light", Color, "1", "the light that `finish { ambient }` answers to")
        .sets(|s, r| set(&mut s.ambient_light, r.color().map(|c| c.rgb))),
];

/// Specification of the block `global_settings`.
pub const SETTINGS: Spec = Spec {
    name: "global_settings",
    summary: "what holds for the whole scene",
    words: specs!(SETTINGS_ROWS),
    ignored: &["charset", "hf_gray_16", "max_intersections", "mm_per_unit"],
    unsupported: &["photons", "radiosity", "subsurface"],
    ..Spec::EMPTY
};
