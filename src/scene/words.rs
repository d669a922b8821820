//! The words of all objects and of `global_settings`: what the readers obey and the manual lists.

use crate::value::Kind::{Block, Color, Flag, Float};
use crate::value::Vocabulary;
use crate::value::words::word;

/// What any object takes behind its own words.
pub const MODIFIERS: Vocabulary = Vocabulary {
    block: "object",
    summary: "what any object takes behind the words of its own",
    words: &[
        word("pigment", Block, "black", "its colour, as `texture { pigment { … } }` says it too"),
        word("texture", Block, "", "what it looks like; several are layers, the last on top"),
        word("normal", Block, "", "its bumps"),
        word("finish", Block, "", "its answer to light"),
        word("interior", Block, "", "what fills it"),
        word("material", Block, "", "texture, interior texture and interior in one"),
        word("interior_texture", Block, "", "what it looks like from inside"),
        word("clipped_by", Block, "", "only what lies in these objects is left; what is cut stays open"),
        word("bounded_by", Block, "", "a hint of its extent for POV-Ray; durer finds it by itself"),
        word("no_shadow", Flag, "off", "it casts no shadow"),
        word("no_image", Flag, "off", "it is not seen directly, but in mirrors and as a shadow"),
        word("no_reflection", Flag, "off", "it is not seen in mirrors"),
        word("no_radiosity", Flag, "off", "it is not seen by radiosity, which is not drawn yet"),
        word("hollow", Flag, "off", "media and fog, which are not drawn yet, are inside too"),
        word("uv_mapping", Flag, "off", "its texture sees the place on the surface, (u, v, 0), instead of the point"),
        word("inverse", Flag, "off", "inside and outside change places"),
        word("double_illuminate", Flag, "off", "light on the far side of a surface shows on this side"),
        word("cutaway_textures", Flag, "off", "a cut shows the texture of what was cut"),
    ],
    moves: true,
    idle: &["sturm", "hierarchy", "split_union", "all_intersections"],
    not_drawn: &["photons"],
};

/// `global_settings { … }`
pub const SETTINGS: Vocabulary = Vocabulary {
    block: "global_settings",
    summary: "what holds for the whole scene",
    words: &[
        word(
            "assumed_gamma",
            Float,
            "see below",
            "how the scene's numbers are meant: 1 is linear light, which is what you want; or `srgb`",
        ),
        word("max_trace_level", Float, "5", "how often a ray may be mirrored and bent, 256 at most"),
        word("adc_bailout", Float, "1/255", "rays that count for less are not followed"),
        word(
            "noise_generator",
            Float,
            "2 for `#version` 3.5 and later",
            "which noise functions are made of: 1, 2 or 3",
        ),
        word(
            "irid_wavelength",
            Color,
            "<0.7, 0.52, 0.48>",
            "of red, green and blue light, in the units of `irid`'s `thickness`",
        ),
        word("number_of_waves", Float, "10", "how many sources the patterns `ripples` and `waves` have"),
        word("ambient_light", Color, "1", "the light that `finish { ambient }` answers to"),
    ],
    moves: false,
    idle: &["charset", "hf_gray_16", "max_intersections", "mm_per_unit"],
    not_drawn: &["photons", "radiosity", "subsurface"],
};
