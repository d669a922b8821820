//! Patterns: noise, cells, waves, warps.

use super::{Quirk, emulated_quirk};

pub(super) const QUIRKS: &[Quirk] = &[
    emulated_quirk(
        "agate_constants",
        "`agate` is (1 + sin(2π (1.3 agate_turb turbulence + 1.1 z))) / 2 to the power 0.77.",
        &["tests/patterns/agate.txt"],
    ),
    emulated_quirk(
        "black_hole_random_cells",
        "A repeated `black_hole` is displaced at random by the numbers that `cells` and `crackle` have in the unit cube with the number of the block.",
        &["tests/patterns/warp_black_hole.txt"],
    ),
    emulated_quirk(
        "cell_edges",
        "Patterns of cells add 1e-10 to coordinates, so that a surface exactly at an edge of cells is in one of them.",
        &["tests/patterns/checker.txt", "light_cases/pat_checker_box"],
    ),
    emulated_quirk(
        "density_file_wraps",
        "The number before the first one of a `density_file` is the last one only if the size of the file is a power of two.",
        &["tests/patterns/density_file.txt"],
    ),
    emulated_quirk(
        "facets_least_size",
        "`facets` with a size of 0 behaves as with a size of 1e-6.",
        &["tests/patterns/facets.txt"],
    ),
    emulated_quirk(
        "facets_signed_metric",
        "`facets` with `metric 1` adds the differences of coordinates with their signs, so that the chosen point is not the nearest.",
        &["tests/patterns/facets.txt"],
    ),
    emulated_quirk(
        "fractal_exponents",
        "`exponent` of `mandel` and `julia` outside of 2 to 33 counts as 2; all exponents but 2 show grays without a map.",
        &["tests/patterns/mandel.txt", "light_cases/pat_default_mandel"],
    ),
    emulated_quirk(
        "fractal_types",
        "Types 7 and 8 of `exterior` and `interior` exist and use the factor as a period; interior type 6 is x² + factor · y², not a length.",
        &["tests/patterns/mandel.txt", "tests/patterns/julia.txt"],
    ),
    emulated_quirk(
        "hexagon_edges",
        "On z = 0, `hexagon` shows the cell on the far side of z = 0, and at corners the outer one.",
        &["tests/patterns/hexagon.txt", "light_cases/pat_hexagon"],
    ),
    emulated_quirk(
        "noise_generator_bits",
        "A second `noise_generator` in a pigment is combined bitwise with the first, which may be that of a declared or default pigment.",
        &["light_cases/pigment_defaults"],
    ),
    emulated_quirk(
        "noise_tables",
        "Noise, turbulence and random cells come from fixed tables, offsets and ranges; `cells` and `crackle` use the Mersenne Twister with its default seed.",
        &["tests/noise/points.txt", "tests/noise/turbulence.txt", "tests/patterns/cells.txt"],
    ),
    emulated_quirk(
        "pavement_plans",
        "`pavement` lays its tiles, and shapes its joints, in ways that the manual leaves open.",
        &["tests/patterns/pavement.txt"],
    ),
    emulated_quirk(
        "penrose_bevels",
        "The last three tilings are Penrose's, with the origin as their centre; a bevel ends 1e-6 before the first number of the next kind of tile.",
        &["tests/patterns/tiling_penrose.txt"],
    ),
    emulated_quirk(
        "pigment_pattern_sees_surface",
        "The pigment of a `pigment_pattern` on a surface depends on that surface, with `slope` and `uv_mapping` for instance.",
        &["light_cases/pigment_pattern_surface"],
    ),
    emulated_quirk("quilted_constant", "`quilted` has 0.577350269 for 1/√3.", &["tests/patterns/quilted.txt"]),
    emulated_quirk(
        "repeat_single_precision",
        "`warp { repeat }` computes the start of a slice in single precision.",
        &["tests/patterns/warp_repeat.txt"],
    ),
    emulated_quirk(
        "single_precision_modifiers",
        "`frequency`, `phase` and the exponent of `poly_wave` have single precision.",
        &["tests/patterns/wave_ramp.txt", "tests/patterns/wave_poly.txt"],
    ),
    emulated_quirk(
        "slope_without_surface",
        "Patterns that depend on the direction of a surface, `slope` and `aoi`, are 0 without one, in the sky and in functions.",
        &["tests/patterns/slope.txt", "light_cases/sky_without_surface"],
    ),
    emulated_quirk(
        "slope_wraps_first",
        "Numbers of `slope` outside of 0 to 1 wrap before the frequency applies.",
        &["tests/patterns/slope.txt"],
    ),
    emulated_quirk(
        "still_patterns",
        "Cells and some other patterns have frequency 0, so that `phase` has no effect until a `frequency` is given.",
        &["light_cases/quilted_phase"],
    ),
    emulated_quirk(
        "tiling_bevels",
        "In the tiling of dodecagons and triangles, three sides of a dodecagon have a deeper bevel.",
        &["tests/patterns/tiling.txt"],
    ),
    emulated_quirk(
        "tiling_joints",
        "A point exactly on a joint of a `tiling` belongs to the tile with the larger coordinates; on some lines through the origin it has a number of neither tile.",
        &["tests/patterns/tiling.txt"],
    ),
    emulated_quirk(
        "uv_mapping_keeps_space",
        "Transforms after a pigment or normal with `uv_mapping` do not move it; they apply to a pattern that is named later, whose only entry is the mapped one.",
        &["light_cases/uv_fixed"],
    ),
    emulated_quirk(
        "warp_orientation",
        "`orientation` of a mapping warp is a rotation only for directions along an axis; others shear the pattern.",
        &["tests/patterns/warp_cylindrical.txt", "tests/patterns/warp_spherical.txt"],
    ),
    emulated_quirk(
        "wave_period",
        "Frequency and phase wrap at 1.00001, not at 1: 3.9375 below 0 becomes 0.0625 + 0.00003.",
        &["tests/patterns/wave_ramp.txt"],
    ),
    emulated_quirk(
        "wave_sources",
        "The sources of `waves` and `ripples` are fixed points on the unit sphere with fixed frequencies.",
        &["tests/patterns/waves.txt", "tests/patterns/ripples.txt"],
    ),
];
