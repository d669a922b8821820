//! The functions, by number.

use super::{
    Internal, Prepare, SCENE_NOISE, algebraic, bounds_plus_minus_ten, call_with_array, helix, misc, noise, planar,
    quadric,
};
use crate::function::Interval;

type Bounds = Option<fn(&[Interval]) -> Interval>;

const STRENGTH: &str = "field strength, which multiplies";
const LIMIT: &str = "field limit: values lie between it and its opposite";
const SWITCH: &str = "sweep around y if above 0";
const OFFSET: &str = "shift along x before sweeping";
const ANGLE: &str = "rotation before sweeping, in degrees";
const SECTION: &str = "cross section: 0 square, 1 round, 2 diamond, 3 hollow diamond";
const GENERATOR: &str = "noise generator: 1, 2 or 3";
const FIELD: &[&str] = &[STRENGTH];
const CYLINDER: &[&str] = &[STRENGTH, LIMIT, SWITCH, OFFSET, ANGLE];
const TORUS: &[&str] = &[STRENGTH, "major radius", "minor radius"];
const ELLIPSOIDS: &[&str] = &["eccentricity: 1 for spheres", "inverse size", "strength", "threshold"];

const FIELD_BOUNDS: Bounds = Some(bounds_plus_minus_ten);

/// All internal functions: number, name, summary, formula, bounds, and the parameters' meanings.
#[rustfmt::skip]
pub static TABLE: &[Internal] = &[
    internal_row(0, "f_algbr_cyl1", "A figure of eight along z or swept around y",
        |a| call_with_array(a, planar::f_algbr_cyl1), None, CYLINDER),
    internal_row(1, "f_algbr_cyl2", "The tacnode curve along z or swept around y",
        |a| call_with_array(a, planar::f_algbr_cyl2), None, CYLINDER),
    internal_row(2, "f_algbr_cyl3", "The keratoid cusp along z or swept around y",
        |a| call_with_array(a, planar::f_algbr_cyl3), None, CYLINDER),
    internal_row(3, "f_algbr_cyl4", "A trifolium along z or swept around y", |a| call_with_array(a, planar::f_algbr_cyl4), None, CYLINDER),
    internal_row(4, "f_bicorn", "A bicorn swept around y", |a| call_with_array(a, algebraic::f_bicorn), FIELD_BOUNDS, &[STRENGTH, "scale"]),
    internal_row(5, "f_bifolia", "A bifolium swept around y: a paraboloid on another",
        |a| call_with_array(a, algebraic::f_bifolia), FIELD_BOUNDS, &[STRENGTH, "scale"]),
    internal_row(6, "f_blob", "Two blob components; negative inside",
        |a| call_with_array(a, misc::f_blob), None, &["distance of the components along x", "strength of the first",
        "inverse radius of the first", "strength of the second", "inverse radius of the second"]),
    internal_row(7, "f_blob2", "Two Gaussian blobs; negative inside",
        |a| call_with_array(a, misc::f_blob2), None, &["distance of the components along x", "inverse size", "strength",
        "threshold"]),
    internal_row(8, "f_boy_surface", "Boy's surface",
        |a| call_with_array(a, algebraic::f_boy_surface), FIELD_BOUNDS, &[STRENGTH,
        "scale, which multiplies like the field strength"]),
    internal_row(9, "f_comma", "A comma", |a| call_with_array(a, misc::f_comma), None, &["size"]),
    internal_row(10, "f_cross_ellipsoids", "The union of three crossed ellipsoids",
        |a| call_with_array(a, misc::f_cross_ellipsoids), None, ELLIPSOIDS),
    internal_row(11, "f_crossed_trough", "Two troughs that cross", |a| call_with_array(a, algebraic::f_crossed_trough), FIELD_BOUNDS, FIELD),
    internal_row(12, "f_cubic_saddle", "A cubic saddle", |a| call_with_array(a, algebraic::f_cubic_saddle), FIELD_BOUNDS, FIELD),
    internal_row(13, "f_cushion", "A cushion", |a| call_with_array(a, algebraic::f_cushion), FIELD_BOUNDS, FIELD),
    internal_row(14, "f_devils_curve", "A devil's curve in space", |a| call_with_array(a, algebraic::f_devils_curve), FIELD_BOUNDS, FIELD),
    internal_row(15, "f_devils_curve_2d", "The devil's curve along z or swept around y",
        |a| call_with_array(a, planar::f_devils_curve_2d), FIELD_BOUNDS, &[STRENGTH, "size along x", "size along y", SWITCH,
        OFFSET, ANGLE]),
    internal_row(16, "f_dupin_cyclid", "Dupin's cyclide: a torus inverted in a sphere",
        |a| call_with_array(a, algebraic::f_dupin_cyclid), FIELD_BOUNDS, &[STRENGTH, "major radius of the torus",
        "minor radius of the torus", "displacement of the torus along x", "displacement of the torus along y",
        "radius of inversion"]),
    internal_row(17, "f_ellipsoid", "1 on an ellipsoid",
        |a| call_with_array(a, quadric::f_ellipsoid), Some(quadric::ellipsoid_bounds), &["inverse half axis along x",
        "inverse half axis along y", "inverse half axis along z"]).with_max_gradient(quadric::ellipsoid_max_gradient),
    internal_row(18, "f_enneper", "Enneper's surface", |a| call_with_array(a, algebraic::f_enneper), FIELD_BOUNDS, FIELD),
    internal_row(19, "f_flange_cover", "Spikes with flanges between them",
        |a| call_with_array(a, misc::f_flange_cover), None, &["spikiness: 1 for a sphere, small for spikes", "inverse size",
        "flange: 1 for none", "threshold"]),
    internal_row(20, "f_folium_surface", "A folium swept around x: a paraboloid on a plane",
        |a| call_with_array(a, algebraic::f_folium_surface), FIELD_BOUNDS, &[STRENGTH, "how narrow the neck is",
        "how wide the paraboloid is"]),
    internal_row(21, "f_folium_surface_2d", "A folium along z or swept around y",
        |a| call_with_array(a, planar::f_folium_surface_2d), FIELD_BOUNDS, &[STRENGTH, "how narrow the neck is", "how wide it is",
        SWITCH, OFFSET, ANGLE]),
    internal_row(22, "f_glob", "A drop", |a| call_with_array(a, algebraic::f_glob), FIELD_BOUNDS, FIELD),
    internal_row(23, "f_heart", "A heart", |a| call_with_array(a, algebraic::f_heart), FIELD_BOUNDS, FIELD),
    internal_row(24, "f_helical_torus", "A torus with windings around it",
        |a| call_with_array(a, helix::f_helical_torus), None, &["major radius", "number of windings",
        "into which next winding each one turns", "depth of the grooves", "threshold",
        "radius on which the windings lie", "how thin the windings are", "number of grooves around a winding",
        "how far the grooves turn from the axis", "how often the grooves turn on the way around"]),
    internal_row(25, "f_helix1", "Tubes that wind around y",
        |a| call_with_array(a, helix::f_helix1), None, &["number of tubes", "2 pi over the height of a turn of one",
        "minor radius", "major radius", "stretch along y", SECTION, "rotation of the cross section, in degrees"]),
    internal_row(26, "f_helix2", "A column that winds around y",
        |a| call_with_array(a, helix::f_helix2), None, &["no effect", "2 pi over the height of a turn", "minor radius",
        "major radius", "no effect", SECTION, "no effect"]),
    internal_row(27, "f_hex_x", "Hexagonal cylinders along z", |a| call_with_array(a, misc::f_hex_x), None, &["no effect"]),
    internal_row(28, "f_hex_y", "Planes along z that cross at 60 degrees", |a| call_with_array(a, misc::f_hex_y), None, &["no effect"]),
    internal_row(29, "f_hetero_mf", "A multifractal whose roughness depends on the altitude",
        |a| call_with_array(a, noise::f_hetero_mf), Some(noise::hetero_bounds), &["H: how fast high frequencies fade",
        "lacunarity: from one frequency to the next", "octaves", "offset",
        "heterogeneity: power of the altitude, a whole number", GENERATOR]).with_preparation(noise::prepared_hetero_mf),
    internal_row(30, "f_hunt_surface", "Hunt's surface", |a| call_with_array(a, algebraic::f_hunt_surface), FIELD_BOUNDS, FIELD),
    internal_row(31, "f_hyperbolic_torus", "A torus that opens along z",
        |a| call_with_array(a, algebraic::f_hyperbolic_torus), FIELD_BOUNDS, TORUS),
    internal_row(32, "f_isect_ellipsoids", "The intersection of three crossed ellipsoids",
        |a| call_with_array(a, misc::f_isect_ellipsoids), None, ELLIPSOIDS),
    internal_row(33, "f_kampyle_of_eudoxus", "Two sheets with a dimple each, around x",
        |a| call_with_array(a, algebraic::f_kampyle_of_eudoxus), FIELD_BOUNDS, &[STRENGTH, "dimple: 0 where they meet",
        "closeness of the sheets"]),
    internal_row(34, "f_kampyle_of_eudoxus_2d", "The kampyle of Eudoxus along z or swept around y",
        |a| call_with_array(a, planar::f_kampyle_of_eudoxus_2d), FIELD_BOUNDS, &[STRENGTH, "dimple: 0 where they meet",
        "closeness of the sheets", SWITCH, OFFSET, ANGLE]),
    internal_row(35, "f_klein_bottle", "Klein's bottle", |a| call_with_array(a, algebraic::f_klein_bottle), FIELD_BOUNDS, FIELD),
    internal_row(36, "f_kummer_surface_v1", "Kummer's surface", |a| call_with_array(a, algebraic::f_kummer_surface_v1), FIELD_BOUNDS, FIELD),
    internal_row(37, "f_kummer_surface_v2", "A family around Kummer's surface",
        |a| call_with_array(a, algebraic::f_kummer_surface_v2), FIELD_BOUNDS, &[STRENGTH, "width of the rods, negative",
        "divergence, negative", "lengthens half of the rods"]),
    internal_row(38, "f_lemniscate_of_gerono", "An hourglass along x",
        |a| call_with_array(a, algebraic::f_lemniscate_of_gerono), FIELD_BOUNDS, FIELD),
    internal_row(39, "f_lemniscate_of_gerono_2d", "The lemniscate of Gerono along z or swept around y",
        |a| call_with_array(a, planar::f_lemniscate_of_gerono_2d), FIELD_BOUNDS, &[STRENGTH, "size", "width", SWITCH, OFFSET,
        ANGLE]),
    internal_row(40, "f_mesh1", "Woven threads",
        |a| call_with_array(a, misc::f_mesh1), None, &["distance of threads along x", "distance of threads along z",
        "how thin they are along x and z", "height of the waves", "how thin they are along y"]),
    internal_row(41, "f_mitre", "A mitre", |a| call_with_array(a, algebraic::f_mitre), FIELD_BOUNDS, FIELD),
    internal_row(42, "f_nodal_cubic", "The folium of Descartes along x",
        |a| call_with_array(a, algebraic::f_nodal_cubic), FIELD_BOUNDS, FIELD),
    internal_row(43, "f_odd", "The same as f_cushion", |a| call_with_array(a, algebraic::f_cushion), FIELD_BOUNDS, FIELD),
    internal_row(44, "f_ovals_of_cassini", "Ovals of Cassini swept around y",
        |a| call_with_array(a, algebraic::f_ovals_of_cassini), FIELD_BOUNDS, &[STRENGTH, "major radius", "filling of the hole",
        "thickness"]),
    internal_row(45, "f_paraboloid", "A paraboloid around y", |a| call_with_array(a, algebraic::f_paraboloid), FIELD_BOUNDS, FIELD),
    internal_row(46, "f_parabolic_torus", "A torus that closes on one side",
        |a| call_with_array(a, algebraic::f_parabolic_torus), FIELD_BOUNDS, TORUS),
    internal_row(47, "f_ph", "The angle from the y axis, in radians", |a| call_with_array(a, quadric::f_ph), None, &[]),
    internal_row(48, "f_pillow", "A pillow", |a| call_with_array(a, algebraic::f_pillow), FIELD_BOUNDS, FIELD),
    internal_row(49, "f_piriform", "A piriform swept around x", |a| call_with_array(a, algebraic::f_piriform), FIELD_BOUNDS, FIELD),
    internal_row(50, "f_piriform_2d", "The piriform along z or swept around y",
        |a| call_with_array(a, planar::f_piriform_2d), FIELD_BOUNDS, &[STRENGTH, "size", "second size", "fatness", SWITCH, OFFSET,
        ANGLE]),
    internal_row(51, "f_poly4", "A polynomial of y as radius around y",
        |a| call_with_array(a, misc::f_poly4), Some(misc::poly4_bounds), &["constant", "factor of y", "factor of y^2",
        "factor of y^3", "factor of y^4"]),
    internal_row(52, "f_polytubes", "Tubes around y whose distance from it is a polynomial of y",
        |a| call_with_array(a, misc::f_polytubes), None, &["number of tubes", "constant", "factor of y", "factor of y^2",
        "factor of y^3", "factor of y^4"]),
    internal_row(53, "f_quantum", "The density of a d orbital along y", |a| call_with_array(a, misc::f_quantum), None, &["no effect"]),
    internal_row(54, "f_quartic_paraboloid", "A square paraboloid around y",
        |a| call_with_array(a, algebraic::f_quartic_paraboloid), FIELD_BOUNDS, FIELD),
    internal_row(55, "f_quartic_saddle", "A square saddle", |a| call_with_array(a, algebraic::f_quartic_saddle), FIELD_BOUNDS, FIELD),
    internal_row(56, "f_quartic_cylinder", "A cylinder that swallowed an egg",
        |a| call_with_array(a, algebraic::f_quartic_cylinder), FIELD_BOUNDS, &[STRENGTH, "diameter of the egg",
        "width of the tube"]),
    internal_row(57, "f_r", "The distance from the origin", |a| call_with_array(a, quadric::f_r), Some(quadric::r_bounds), &[]).with_max_gradient(|_| 1.0),
    internal_row(58, "f_ridge", "Turbulence with ridges",
        |a| call_with_array(a, noise::f_ridge), Some(noise::ridge_bounds), &["lambda: from one frequency to the next", "octaves",
        "omega: from one weight to the next", "offset", "ridge: where the noise is folded", GENERATOR]),
    internal_row(59, "f_ridged_mf", "A multifractal with ridges",
        |a| call_with_array(a, noise::f_ridged_mf), Some(noise::ridged_bounds), &["H: how fast high frequencies fade",
        "lacunarity: from one frequency to the next", "octaves", "offset",
        "gain: how much of an octave the next one keeps", GENERATOR]).with_preparation(noise::prepared_ridged_mf),
    internal_row(60, "f_rounded_box", "A box with round edges",
        |a| call_with_array(a, quadric::f_rounded_box), Some(quadric::rounded_box_bounds), &["radius of the edges",
        "half size along x", "half size along y", "half size along z"]).with_max_gradient(|_| 1.0),
    internal_row(61, "f_sphere", "The distance from a sphere",
        |a| call_with_array(a, quadric::f_sphere), Some(quadric::sphere_bounds), &["radius"]).with_max_gradient(|_| 1.0),
    internal_row(62, "f_spikes", "Six spikes",
        |a| call_with_array(a, misc::f_spikes), None, &["spikiness: 1 for a sphere, small for spikes", "hollowness", "size",
        "roundness", "fatness"]),
    internal_row(63, "f_spikes_2d", "A field of spikes on the plane y = 0",
        |a| call_with_array(a, misc::f_spikes_2d), None, &["height of the central spike", "frequency along x", "frequency along z",
        "how fast they fade"]),
    internal_row(64, "f_spiral", "A spiral tube around y",
        |a| call_with_array(a, helix::f_spiral), None, &["distance of the windings", "thickness", "outer radius", "no effect",
        "no effect", SECTION]),
    internal_row(65, "f_steiners_roman", "Steiner's Roman surface",
        |a| call_with_array(a, algebraic::f_steiners_roman), FIELD_BOUNDS, FIELD),
    internal_row(66, "f_strophoid", "A plane with a bulb along x",
        |a| call_with_array(a, algebraic::f_strophoid), FIELD_BOUNDS, &[STRENGTH, "size of the bulb", "sharpness", "flatness"]),
    internal_row(67, "f_strophoid_2d", "The strophoid along z or swept around y",
        |a| call_with_array(a, planar::f_strophoid_2d), FIELD_BOUNDS, &[STRENGTH, "size of the bulb", "sharpness", "fatness",
        SWITCH, OFFSET, ANGLE]),
    internal_row(68, "f_superellipsoid", "A superellipsoid; positive inside",
        |a| call_with_array(a, quadric::f_superellipsoid), Some(quadric::superellipsoid_bounds), &["east-west exponent",
        "north-south exponent"]),
    internal_row(69, "f_th", "The angle around the y axis, in radians", |a| call_with_array(a, quadric::f_th), None, &[]),
    internal_row(70, "f_torus", "The distance from a torus around y",
        |a| call_with_array(a, quadric::f_torus), Some(quadric::torus_bounds), &["major radius", "minor radius"]).with_max_gradient(|_| 1.0),
    internal_row(71, "f_torus2", "A torus around y as a quartic", |a| call_with_array(a, algebraic::f_torus2), FIELD_BOUNDS, TORUS),
    internal_row(72, "f_torus_gumdrop", "A torus with a gumdrop on both sides",
        |a| call_with_array(a, algebraic::f_torus_gumdrop), FIELD_BOUNDS, FIELD),
    internal_row(73, "f_umbrella", "Whitney's umbrella", |a| call_with_array(a, algebraic::f_umbrella), FIELD_BOUNDS, FIELD),
    internal_row(74, "f_witch_of_agnesi", "A witch's hat around y",
        |a| call_with_array(a, algebraic::f_witch_of_agnesi), FIELD_BOUNDS, &[STRENGTH, "width of the spike"]),
    internal_row(75, "f_witch_of_agnesi_2d", "The witch of Agnesi along z or swept around y",
        |a| call_with_array(a, planar::f_witch_of_agnesi_2d), FIELD_BOUNDS, &[STRENGTH, "size of the spike", "height of the spike",
        SWITCH, OFFSET, ANGLE]),
    internal_row(SCENE_NOISE, "f_noise3d", "Noise from 0 to 1", |a| call_with_array(a, noise::f_noise3d), Some(noise::noise_bounds), &[]),
    internal_row(78, "f_noise_generator", "Noise from 0 to 1",
        |a| call_with_array(a, noise::f_noise_generator), Some(noise::noise_bounds), &[GENERATOR]).with_max_gradient(noise::max_noise_gradient)
        .with_max_gradient_change(noise::max_noise_gradient_change),
];

const fn internal_row(
    number: u32,
    name: &'static str,
    summary: &'static str,
    compute: fn(&[f64]) -> f64,
    bounds: Bounds,
    parameters: &'static [&'static str],
) -> Internal {
    Internal { number, name, summary, parameters, compute, bounds, steepest: None, bend: None, prepare: None }
}

impl Internal {
    const fn with_max_gradient(self, steepest: fn(&[f64]) -> f64) -> Self {
        Self { steepest: Some(steepest), ..self }
    }

    const fn with_max_gradient_change(self, bend: fn(&[f64]) -> f64) -> Self {
        Self { bend: Some(bend), ..self }
    }

    const fn with_preparation(self, prepare: Prepare) -> Self {
        Self { prepare: Some(prepare), ..self }
    }
}
