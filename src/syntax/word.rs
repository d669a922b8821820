//! All words of the scene language (manual, "Keywords"), and the words that only durer has.

use rustc_hash::FxHashMap;
use std::sync::LazyLock;

/// Category of a reserved word in the grammar.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Category {
    /// Word that names a block, or a parameter in a block.
    Keyword,
    /// Word that takes arguments in parentheses. Without them it is a keyword, as in `julia_fractal { … sqr }`.
    Function,
    /// Category of built-in values such as `x`, `pi`, `clock` and `on`.
    Constant,
    /// Word that only durer has, inside the blocks of [`durer_words_of_block`]; elsewhere an ordinary name.
    Contextual,
}

/// A keyword or other reserved word of the scene language.
#[derive(Debug)]
pub struct Word {
    /// Spelling of the reserved word.
    pub name: &'static str,
    /// Category of the reserved word.
    pub category: Category,
    /// Index of the word among all words, for a [`WordTable`].
    number: u32,
}

/// Table of values for some of the words, found without a hash of the spelling.
pub struct WordTable<T>(Box<[Option<T>]>);

impl<T> WordTable<T> {
    /// Creates the table from words and their values. Names that are no words are left out.
    pub fn new(entries: impl Iterator<Item = (&'static str, T)>) -> Self {
        let mut values: Box<[Option<T>]> = TABLE.words.iter().map(|_| None).collect();
        for (name, value) in entries {
            if let Some((number, _)) = word_number_and_category(name) {
                values[number as usize] = Some(value);
            }
        }
        Self(values)
    }

    /// Returns the value for a word; `None` if the table has none.
    pub fn get(&self, word: &Word) -> Option<&T> {
        self.0[word.number as usize].as_ref()
    }

    /// Returns the value for the word with this spelling; `None` if the table has none.
    pub fn get_by_spelling(&self, name: &str) -> Option<&T> {
        self.get(entry(name)?)
    }
}

impl Category {
    /// True if a word of this category can neither be declared nor used as a value.
    pub(super) fn is_reserved(self) -> bool {
        matches!(self, Category::Keyword | Category::Function)
    }
}

/// Returns a word of any category as a static string, with its category; `None` for any other name. Scenes may declare
/// some of these words; [`reserved`] returns the others.
pub fn lookup(word: &str) -> Option<(&'static str, Category)> {
    word_number_and_category(word).map(|(number, category)| (word_of_number(number).name, category))
}

/// Returns the table entry of a word of any category; `None` for any other name.
pub fn entry(word: &str) -> Option<&'static Word> {
    word_number_and_category(word).map(|(number, _)| word_of_number(number))
}

/// Returns the number of a reserved word, for [`word_of_number`], and the word's category.
pub(super) fn word_number_and_category(word: &str) -> Option<(u32, Category)> {
    TABLE.numbers.get(word).map(|&number| (number, TABLE.words[number as usize].category))
}

/// Returns the reserved word with this number.
pub(super) fn word_of_number(number: u32) -> &'static Word {
    &TABLE.words[number as usize]
}

struct Table {
    words: Vec<Word>,
    numbers: FxHashMap<&'static str, u32>,
}

static TABLE: LazyLock<Table> = LazyLock::new(|| {
    let of = |words: &'static [&'static str], category| words.iter().map(move |&name| (name, category));
    let words: Vec<_> = of(KEYWORDS, Category::Keyword)
        .chain(of(FUNCTIONS, Category::Function))
        .chain(CONSTANTS.iter().map(|&(name, _)| (name, Category::Constant)))
        .chain(CONTEXTUAL.iter().flat_map(move |(_, words)| of(words, Category::Contextual)))
        .zip(0..)
        .map(|((name, category), number)| Word { name, category, number })
        .collect();
    let numbers = words.iter().enumerate().map(|(i, word)| (word.name, i as u32)).collect();
    Table { words, numbers }
});

/// Returns the reserved word that a name equals, so that no scene may declare the name; `None` for a free name, or for
/// a constant that scenes may declare anew.
pub fn reserved(name: &str) -> Option<&'static str> {
    const DECLARABLE: &[&str] = &[
        "clock_delta",
        "final_clock",
        "final_frame",
        "frame_number",
        "image_height",
        "image_width",
        "initial_clock",
        "initial_frame",
        "input_file_name",
    ];
    let (word, category) = lookup(name)?;
    (category != Category::Contextual && !DECLARABLE.contains(&word)).then_some(word)
}

/// Returns the words that are known only to durer, for the block of this name.
pub fn durer_words_of_block(block: &str) -> &'static [&'static str] {
    CONTEXTUAL.iter().find(|(name, _)| *name == block).map_or(&[], |(_, words)| words)
}

/// Words that only durer has, each with the block in which it is a word.
pub const CONTEXTUAL: &[(&str, &[&str])] =
    &[("camera", &["eye", "center", "fov_x", "fov_y"]), ("mesh", &["file"]), ("plane", &["implicit", "point", "span"])];

/// Words of shapes that contain no other objects. The module `shape` has their parameters.
#[rustfmt::skip]
pub const SHAPES: &[&str] = &[
    "bicubic_patch", "blob", "box", "cone", "cubic", "cylinder", "disc", "height_field", "isosurface", "julia_fractal", "lathe",
    "mesh", "mesh2", "ovus", "parametric", "plane", "poly", "polygon", "polynomial", "prism", "quadric", "quartic", "smooth_triangle",
    "sor", "sphere", "sphere_sweep", "superellipsoid", "text", "torus", "triangle",
];

/// Words of objects that contain other objects.
pub const GROUPS: &[&str] = &["object", "union", "merge", "intersection", "difference"];

/// Words of blocks and of their parameters.
#[rustfmt::skip]
pub const KEYWORDS: &[&str] = &[
    "aa_level", "aa_threshold", "absorption", "accuracy", "adaptive", "adc_bailout", "agate", "agate_turb",
    "albedo", "all", "all_intersections", "alpha", "altitude", "always_sample", "ambient", "ambient_light",
    "angle", "aoi", "aperture", "append", "arc_angle", "area_illumination", "area_light", "array", "ascii",
    "assumed_gamma", "autostop", "average", "b_spline", "background", "bezier_spline", "bicubic_patch",
    "black_hole", "blob", "blue", "blur_samples", "bmp", "bokeh", "bounded_by", "box", "boxed", "bozo", "brick",
    "brick_size", "brightness", "brilliance", "bump_map", "bump_size", "bumps", "camera", "caustics", "cells",
    "charset", "checker", "circular", "clipped_by", "collect", "color", "color_map", "colour", "colour_map",
    "component", "composite", "cone", "confidence", "conic_sweep", "conserve_energy", "contained_by",
    "control0", "control1", "coords", "count", "crackle", "crand", "cubic", "cubic_spline", "cubic_wave",
    "cutaway_textures", "cylinder", "cylindrical", "declare", "default", "density", "density_file", "density_map", "dents",
    "deprecated", "df3", "difference", "diffuse", "direction", "disc", "dispersion", "dispersion_samples",
    "dist_exp", "distance", "double_illuminate", "eccentricity", "emission", "error_bound", "evaluate",
    "expand_thresholds", "exponent", "exr", "exterior", "extinction", "face_indices", "facets", "fade_color",
    "fade_colour", "fade_distance", "fade_power", "falloff", "falloff_angle", "filter", "finish", "fisheye",
    "flatness", "flip", "focal_point", "fog", "fog_alt", "fog_offset", "fog_type", "form", "frequency",
    "fresnel", "function", "gamma", "gather", "gif", "global_lights", "global_settings", "gradient", "granite",
    "gray", "gray_threshold", "green", "hdr", "height_field", "hexagon", "hf_gray_16", "hierarchy", "hollow",
    "hypercomplex", "iff", "image_map", "image_pattern", "importance", "include", "inside_vector", "interior",
    "interior_texture", "interpolate", "intersection", "intervals", "inverse", "ior", "irid", "irid_wavelength",
    "isosurface", "jitter", "jpeg", "julia", "julia_fractal", "lambda", "lathe", "leopard", "light_group",
    "light_source", "linear_spline", "linear_sweep", "load_file", "location", "look_at", "looks_like",
    "low_error_factor", "magnet", "major_radius", "mandel", "map_type", "marble", "material", "material_map",
    "matrix", "max_gradient", "max_intersections", "max_iteration", "max_sample", "max_trace",
    "max_trace_level", "maximum_reuse", "media", "media_attenuation", "media_interaction", "merge", "mesh",
    "mesh2", "mesh_camera", "metallic", "method", "metric", "minimum_reuse", "mm_per_unit", "mortar",
    "natural_spline", "nearest_count", "no_bump_scale", "no_image", "no_radiosity", "no_reflection",
    "no_shadow", "noise_generator", "normal", "normal_indices", "normal_map", "normal_vectors",
    "number_of_sides", "number_of_tiles", "number_of_waves", "object", "octaves", "offset", "omega", "omnimax",
    "once", "onion", "open", "orient", "orientation", "orthographic", "ovus", "panoramic", "parallel",
    "parametric", "pass_through", "pattern", "pavement", "perspective", "pgm", "phase", "phong", "phong_size",
    "photons", "pigment", "pigment_map", "pigment_pattern", "planar", "plane", "png", "point_at", "poly",
    "poly_wave", "polygon", "polynomial", "pot", "ppm", "precision", "precompute", "premultiplied",
    "pretrace_end", "pretrace_start", "prism", "projected_through", "pwr", "quadratic_spline", "quadric",
    "quartic", "quaternion", "quick_color", "quick_colour", "quilted", "radial", "radiosity", "radius",
    "rainbow", "ramp_wave", "ratio", "read", "reciprocal", "recursion_limit", "red", "reflection",
    "reflection_exponent", "refraction", "repeat", "rgb", "rgbf", "rgbft", "rgbt", "right", "ripples",
    "rotate", "roughness", "samples", "save_file", "scale", "scallop_wave", "scattering", "shadowless",
    "sine_wave", "sint16be", "sint16le", "sint32be", "sint32le", "sint8", "size", "sky", "sky_sphere", "slice",
    "slope", "slope_map", "smooth", "smooth_triangle", "solid", "sor", "spacing", "specular", "sphere",
    "sphere_sweep", "spherical", "spiral1", "spiral2", "spline", "split_union", "spotlight", "spotted",
    "square", "srgb", "srgbf", "srgbft", "srgbt", "strength", "sturm", "subsurface", "superellipsoid", "sys",
    "target", "text", "texture", "texture_list", "texture_map", "tga", "thickness", "threshold", "tiff",
    "tightness", "tile2", "tiles", "tiling", "tolerance", "toroidal", "torus", "transform", "translate",
    "translucency", "transmit", "triangle", "triangle_wave", "triangular", "ttf", "turb_depth", "turbulence",
    "type", "u_steps", "uint16be", "uint16le", "uint8", "ultra_wide_angle", "union", "up", "use_alpha",
    "use_color", "use_colour", "use_index", "utf8", "uv_indices", "uv_mapping", "uv_vectors", "v_steps",
    "variance", "vertex_vectors", "warp", "water_level", "waves", "width", "wood", "wrinkles", "write", "xyz",
];

/// Names of functions that take arguments in parentheses.
#[rustfmt::skip]
pub const FUNCTIONS: &[&str] = &[
    "abs", "acos", "acosh", "asc", "asin", "asinh", "atan", "atan2", "atanh", "bitwise_and", "bitwise_or",
    "bitwise_xor", "ceil", "chr", "concat", "cos", "cosh", "cube", "datetime", "defined", "degrees",
    "dimension_size", "dimensions", "div", "exp", "file_exists", "floor", "inside", "int", "internal", "ln",
    "log", "max", "max_extent", "min", "min_extent", "mod", "pow", "prod", "radians", "rand", "seed", "select",
    "sin", "sinh", "sqr", "sqrt", "str", "strcmp", "strlen", "strlwr", "strupr", "substr", "sum", "tan", "tanh",
    "trace", "val", "vaxis_rotate", "vcross", "vdot", "vlength", "vnormalize", "vrotate", "vstr", "vturbulence",
];

/// Words of built-in values, each with its description in the manual.
pub const CONSTANTS: &[(&str, &str)] = &[
    ("clock", "time of an animation's frame, from 0 to 1 unless `--clock` or an INI file sets it"),
    ("clock_delta", "difference of `clock` between two consecutive frames"),
    ("clock_on", "1 for an animation and with `--clock`, else 0"),
    ("false", "0"),
    ("final_clock", "value of `clock` in the last frame"),
    ("final_frame", "number of the last frame"),
    ("frame_number", "number of the present frame; 0 without an animation"),
    ("image_height", "height of the picture, in pixels"),
    ("image_width", "width of the picture, in pixels"),
    ("initial_clock", "value of `clock` in the first frame"),
    ("initial_frame", "number of the first frame"),
    ("input_file_name", "name of the scene file, without its folder"),
    ("no", "0"),
    ("now", "time at which the render began, in days since the beginning of 2000; differs in every run"),
    ("off", "0"),
    ("on", "1"),
    ("pi", "3.14159…"),
    ("t", "`<0, 0, 0, 1>`"),
    ("true", "1"),
    ("u", "`<1, 0>`; in `function { }` the same as `x`"),
    ("v", "`<0, 1>`; in `function { }` the same as `y`"),
    ("version", "language version that the last `#version` set"),
    ("x", "`<1, 0, 0>`; in `function { }` the first parameter, unless others are named"),
    ("y", "`<0, 1, 0>`; in `function { }` the second"),
    ("yes", "1"),
    ("z", "`<0, 0, 1>`; in `function { }` the third"),
];
