//! Parsing, values, versions.

use super::{Quirk, differing_quirk, emulated_quirk};

pub(super) const QUIRKS: &[Quirk] = &[
    emulated_quirk(
        "call_runs_directives",
        "To find out whether the name of a function is called, directives after the name run, even where directives after a value wait until \
         the value has been used.",
        &["tests/lang/tokens.scene"],
    ),
    emulated_quirk(
        "choices_evaluate_all",
        "`a ? b : c` and `select` evaluate all of their values, also those that are not chosen: macros run, and random numbers advance.",
        &["tests/lang/choices.scene"],
    ),
    emulated_quirk(
        "comparison_tolerance",
        "Numbers that differ by less than 1e-10 are equal, and a number closer to 0 than that is false.",
        &["tests/lang/operators.scene"],
    ),
    emulated_quirk(
        "cubic_spline_slopes",
        "The slope of a `cubic_spline` at a point is the mean of the slopes of the lines to its two neighbours.",
        &["tests/lang/functions.scene"],
    ),
    emulated_quirk(
        "exact_comparisons_in_functions",
        "Inside `function { }` comparisons are exact, and every number but 0 is true; outside of it 1e-10 separates numbers.",
        &["tests/lang/functions.scene"],
    ),
    emulated_quirk(
        "first_assumed_gamma",
        "Of several `assumed_gamma` in a scene the first one counts.",
        &["light_cases/assumed_gamma_first"],
    ),
    emulated_quirk(
        "gamma_by_version",
        "Colours of a scene without `assumed_gamma` are not converted at all if the scene states an older version than 3.7, or none; with \
         `#version 3.7`, `assumed_gamma` is 1.",
        &["light_cases/no_version"],
    ),
    emulated_quirk(
        "hf_component_weights",
        "The component `.hf` of a colour is 0.996093 times its red plus 0.003906 times its green.",
        &["tests/lang/functions.scene"],
    ),
    emulated_quirk(
        "index_follows_name",
        "Between the name of an array and its index no directive and no macro runs, and no macro ends.",
        &["tests/lang/tokens.scene"],
    ),
    emulated_quirk(
        "infinite_colors",
        "An infinite component of a colour is as bright as the picture allows, and one that is not a number is 0.",
        &["light_cases/infinite_colors"],
    ),
    emulated_quirk(
        "internal_functions",
        "The functions of `functions.inc` have signs, scales and weights of parameters of their own beside the published formulas.",
        &["tests/internals/values.txt"],
    ),
    emulated_quirk(
        "logical_precedence",
        "`&` and `|` have one precedence and apply from left to right, but inside `function { }` `&` binds more tightly than `|`.",
        &["tests/lang/operators.scene", "tests/lang/functions.scene"],
    ),
    emulated_quirk(
        "object_color_ignored",
        "A colour in an object itself, outside of a `pigment`, has no effect.",
        &["light_cases/object_color"],
    ),
    emulated_quirk(
        "object_in_any_block",
        "A declared object is allowed in the block of any shape: `box { Ball }` is the same as `object { Ball }`.",
        &["tests/lang/geometry.scene"],
    ),
    emulated_quirk(
        "opacity_by_version",
        "Before `#version 3.7`, a surface with `filter` shows of its own light only the share that the filter's colour absorbs.",
        &["light_cases/opacity_before_37"],
    ),
    emulated_quirk(
        "operators_before_1_5",
        "Below `#version 1.5` binary operators are allowed only inside parentheses: `<1 -2 3>` has three components.",
        &["tests/lang/old.scene"],
    ),
    emulated_quirk(
        "optional_argument_commas",
        "Commas between arguments may be left out, except in functions of any number of arguments such as `min` and `max`.",
        &["tests/lang/functions.scene"],
    ),
    emulated_quirk(
        "pigment_function_ignores_default",
        "The pigments of functions and of `pigment_pattern` do not begin with the pigment of `#default`.",
        &["light_cases/pigments_of_functions"],
    ),
    emulated_quirk(
        "random_generator",
        "`rand` is a linear congruential generator of 32 bits: each state is 1812433253 times the one before, plus 12345.",
        &["tests/lang/numeric_functions.scene"],
    ),
    emulated_quirk(
        "reference_without_comma",
        "In a macro call, a name of a number, vector or colour that another name follows without a comma refers to that other name: \
         after `#macro M(A B)`, the call `M(one two)` has two in both parameters.",
        &["tests/lang/choices.scene"],
    ),
    emulated_quirk(
        "seed_overflow",
        "A seed beyond 32 bits is the seed -2147483648.",
        &["tests/lang/numeric_functions.scene"],
    ),
    emulated_quirk(
        "srgb_files_since_3_7",
        "Picture files without gamma information are read as sRGB since `#version 3.7`, and as linear before.",
        &["light_cases/image_alpha_one"],
    ),
    differing_quirk(
        "strict_separators",
        "Some commas, such as those between the objects of a `union`, and missing semicolons after values are errors.",
        "durer accepts them; `--warn portable` reports them.",
        &["tests/ui/portable.scene"],
    ),
    emulated_quirk(
        "unsigned_infinity",
        "A division by zero is infinite without a sign: 1/0, -1/0 and 0/0 are the same.",
        &["tests/lang/operators.scene"],
    ),
];
