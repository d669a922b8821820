//! Impossible numbers for shapes, cameras and lights.

use super::limited_run::{Case, case, drawn, nested};

/// All cases.
pub fn cases() -> Vec<Case> {
    [numbers(), shapes(), cameras(), lights(), csg(), finishes()].into_iter().flatten().collect()
}

fn numbers() -> Vec<Case> {
    let not_finite: &[&str] = &["W0213", "a.scene:1:13"];
    let bad_argument: &[&str] = &["E0209", "a.scene:1:"];
    vec![
        drawn("division_by_zero", "sphere { 0, 1/0 }", 0, &["W0213", "W0200", "a.scene:1:13"]),
        drawn("zero_by_zero", "sphere { 0, 0/0 }", 0, not_finite),
        drawn("root_of_minus_one", "sphere { 0, sqrt(-1) }", 1, bad_argument),
        drawn("log_of_minus_one", "sphere { 0, ln(-1) }", 1, bad_argument),
        drawn("log_of_zero", "sphere { 0, log(0) }", 1, bad_argument),
        drawn("asin_of_two", "sphere { 0, asin(2) }", 0, &[]),
        drawn("acos_of_two", "sphere { 0, acos(2) }", 0, &["W0300"]),
        drawn("mod_zero", "sphere { 0, mod(1, 0) }", 0, &["a.scene:1:"]),
        drawn("div_zero", "sphere { 0, div(1, 0) }", 0, &["a.scene:1:"]),
        drawn("pow_huge", "sphere { 0, pow(10, 1000) }", 0, &["a.scene:1:13"]),
        drawn("pow_negative", "sphere { 0, pow(-1, 0.5) }", 0, &["a.scene:1:13"]),
        drawn("exp_huge", "sphere { 0, exp(1e9) }", 0, not_finite),
        drawn("overflow", "sphere { 0, 1e308 * 10 }", 0, not_finite),
        drawn("number_too_large", "sphere { 0, 1e999 }", 0, not_finite),
        drawn("infinite_place", "sphere { <0, 1/0, 0>, 1 }", 0, &["W0213", "a.scene:1:10"]),
        drawn("nan_place", "sphere { <0, 0/0, 0>, 1 }", 0, &["W0213", "a.scene:1:10"]),
        drawn("nan_colour", "sphere { 0, 1 pigment { rgb <0/0, 0, 0> } }", 0, &["W0213", "a.scene:1:29"]),
        drawn("nan_rotation", "sphere { 0, 1 rotate 0/0 }", 0, &["W0213", "a.scene:1:22"]),
        drawn("infinite_move", "sphere { 0, 1 translate 1/0 }", 0, &["W0213", "a.scene:1:25"]),
        drawn("huge_move", "sphere { 0, 1 translate 1e300 translate 1e308 translate 1e308 }", 1, &["a.scene:1:"]),
        drawn("huge_scales", "sphere { 0, 1 scale 1e200 scale 1e200 }", 1, &["a.scene:1:"]),
        drawn("tiny_scales", "sphere { 0, 1 scale 1e-200 scale 1e-200 }", 1, &["a.scene:1:"]),
        drawn("nan_condition", "#if (0/0) sphere { 0, 1 } #end", 0, &["W0200"]),
        drawn("random_stream_missing", "sphere { 0, rand(1e300) }", 1, &["a.scene:1:"]),
        drawn("seed_nan", "#declare R = seed(0/0); sphere { 0, rand(R) + 0.5 }", 0, &[]),
        drawn("chr_huge", "#debug chr(1e300)", 1, &["a.scene:1:"]),
        drawn("str_huge", "#debug str(1e300, 1e9, 1e9)", 0, &[]),
        drawn("substr_nan", "#debug substr(\"abc\", 0/0, 2)", 1, &["a.scene:1:"]),
        drawn("substr_huge", "#debug substr(\"abc\", 1, 1e300)", 1, &["a.scene:1:"]),
        drawn("vstr_nan", "#debug vstr(0/0, <1, 2, 3>, \",\", 0/0, 0/0)", 0, &[]),
        drawn("tan_of_right_angle", "sphere { 0, tan(pi / 2) }", 0, &[]),
    ]
}

fn shapes() -> Vec<Case> {
    vec![
        drawn("radius_zero", "sphere { 0, 0 }", 0, &["W0300", "a.scene:1:1"]),
        drawn("radius_negative", "sphere { 0, -1 }", 0, &[]),
        drawn("radius_denormal", "sphere { 0, 1e-310 }", 0, &[]),
        drawn("radius_huge", "sphere { 0, 1e300 }", 0, &[]),
        drawn("place_huge", "sphere { 1e300, 1 }", 0, &[]),
        drawn("box_huge", "box { -1e300, 1e300 }", 0, &[]),
        drawn("box_flat", "box { <0, 0, 0>, <1, 1, 0> }", 0, &[]),
        drawn("box_point", "box { 0, 0 }", 0, &[]),
        drawn("box_swapped", "box { 1, -1 }", 0, &[]),
        drawn("cylinder_flat", "cylinder { 0, 0, 1 }", 1, &["E0301", "a.scene:1:1"]),
        drawn("cylinder_huge", "cylinder { 0, 1e300, 1 }", 1, &["E0301", "a.scene:1:12"]),
        drawn("cone_flat", "cone { 0, 1, 0, 1 }", 1, &["E0301", "a.scene:1:8"]),
        drawn("cone_line", "cone { 0, 0, y, 0 }", 0, &[]),
        drawn("cone_negative", "cone { 0, -1, y, 1 }", 0, &[]),
        drawn("torus_zero", "torus { 0, 0 }", 0, &["a.scene:1:1"]),
        drawn("torus_negative", "torus { -1, -0.5 }", 0, &[]),
        drawn("torus_huge", "torus { 1e150, 1e149 }", 0, &[]),
        drawn("disc_nowhere", "disc { 0, 0, 1 }", 0, &["W0300", "a.scene:1:1"]),
        drawn("disc_hole", "disc { 0, y, 1, 2 }", 0, &["W0300", "a.scene:1:1"]),
        drawn("plane_nowhere", "plane { 0, 1 }", 1, &["E0300", "a.scene:1:"]),
        drawn("plane_far", "plane { y, 1e300 }", 0, &[]),
        drawn("plane_tiny_normal", "plane { y * 1e-300, 1 }", 1, &["E0300", "a.scene:1:9"]),
        drawn("plane_implicit_zero", "plane { implicit <0, 0, 0, 1> }", 1, &["E0300", "a.scene:1:"]),
        drawn("plane_span_parallel", "plane { point 0 span x, 2 * x }", 1, &["E0300", "a.scene:1:"]),
        drawn("triangle_point", "triangle { 0, 0, 0 }", 0, &["W0301", "a.scene:1:1"]),
        drawn("triangle_line", "triangle { 0, x, 2 * x }", 0, &["W0301", "a.scene:1:1"]),
        drawn("triangle_huge", "triangle { -1e300, x * 1e300, y * 1e300 }", 0, &[]),
        drawn("triangle_no_normals", "smooth_triangle { 0, 0, x, 0, y, 0 }", 0, &["a.scene:1:1"]),
        drawn("polygon_0", "polygon { 0 }", 1, &["E0302", "a.scene:1:"]),
        drawn("polygon_1", "polygon { 1, <0, 0> }", 1, &["E0302", "a.scene:1:"]),
        drawn("polygon_2", "polygon { 2, <0, 0>, <1, 0> }", 1, &["E0302", "a.scene:1:"]),
        drawn("polygon_3", "polygon { 3, <0, 0>, <1, 0>, <0, 1> }", 0, &["W0303", "a.scene:1:"]),
        drawn("polygon_line", "polygon { 4, <0, 0>, <1, 0>, <2, 0>, <0, 0> }", 0, &["a.scene:1:"]),
        drawn("polygon_same_points", "polygon { 4, 0, 0, 0, 0 }", 0, &["a.scene:1:"]),
        drawn("polygon_negative", "polygon { -3, <0, 0>, <1, 0>, <0, 1> }", 1, &["a.scene:1:"]),
        drawn("polygon_huge_count", "polygon { 1e18, <0, 0>, <1, 0>, <0, 1> }", 1, &["a.scene:1:"]),
        drawn("polygon_nan_count", "polygon { 0/0, <0, 0>, <1, 0>, <0, 1> }", 0, &["a.scene:1:"]),
        drawn("matrix_singular", "sphere { 0, 1 matrix <1,0,0, 1,0,0, 0,0,1, 0,0,0> }", 1, &["E0211", "a.scene:1:"]),
        drawn("matrix_zero", "sphere { 0, 1 matrix <0,0,0, 0,0,0, 0,0,0, 0,0,0> }", 1, &["E0211", "a.scene:1:"]),
        drawn("matrix_short", "sphere { 0, 1 matrix <1, 2, 3> }", 1, &["a.scene:1:"]),
        drawn("matrix_nan", "sphere { 0, 1 matrix <0/0,0,0, 0,1,0, 0,0,1, 0,0,0> }", 0, &["a.scene:1:"]),
        drawn("scale_zero", "sphere { 0, 1 scale 0 }", 0, &["W0207", "a.scene:1:"]),
        drawn("scale_zero_axis", "sphere { 0, 1 scale <1, 0, 1> }", 0, &["W0207", "a.scene:1:"]),
        drawn("scale_negative", "sphere { 0, 1 scale -1 }", 0, &[]),
        drawn("field_of_one", "height_field { function 1, 1 { 0.5 } }", 0, &["W0300", "a.scene:1:1"]),
        drawn("field_no_number", "height_field { function 9, 9 { sqrt(x - 2) } smooth }", 0, &[]),
        drawn("field_huge", "height_field { function 9, 9 { 1e300 * x } smooth scale 1e6 }", 0, &[]),
        drawn("field_too_large", "height_field { function 1e9, 1e9 { x } }", 1, &["a.scene:1:"]),
        drawn("field_under_water", "height_field { function 9, 9 { x } water_level 2 }", 0, &["W0300", "a.scene:1:1"]),
        drawn("field_unsized", "height_field { function { x } }", 1, &["E0200", "a.scene:1:"]),
        drawn("iso_no_number", "isosurface { function { sqrt(-1 - x*x) } }", 0, &[]),
        drawn("iso_poles", "isosurface { function { 1/(x*y*z) - 5 } open }", 0, &[]),
        drawn(
            "iso_huge",
            "isosurface { function { exp(999*x) - exp(999*y) } contained_by { box { -1e9, 1e9 } } }",
            0,
            &[],
        ),
        drawn("iso_steep", "isosurface { function { 1e30*(x + y*z) } accuracy 1e-30 max_gradient 1e30 }", 0, &[]),
        drawn("iso_everywhere", "isosurface { function { 0*x } }", 0, &[]),
        drawn("iso_flat_container", "isosurface { function { x } contained_by { box { 0, <1, 1, 0> } } }", 0, &[]),
        drawn("iso_no_container", "isosurface { function { x } contained_by { sphere { 0, -1 } } }", 0, &[]),
        drawn("iso_jumps", "isosurface { function { mod(floor(9*x) + floor(9*y), 2) - 0.5 + z } }", 0, &["a.scene:1:"]),
        drawn("iso_two_numbers", "isosurface { function(a, b) { a + b } }", 1, &["E0202", "a.scene:1:"]),
        drawn("iso_accuracy", "isosurface { function { x } accuracy 0 max_gradient -1 max_trace 0 }", 0, &["W0310"]),
        drawn("iso_accuracy_nan", "isosurface { function { x } accuracy 0/0 }", 1, &["a.scene:1:38"]),
        drawn("param_point", "parametric { function { 0 } function { 0 } function { 0 } 0, 1 }", 0, &[]),
        drawn("param_line", "parametric { function { u } function { u } function { 0 } 0, 1 }", 0, &[]),
        drawn(
            "param_nowhere",
            "parametric { function { u } function { v } function { 0 } 1, 1 }",
            0,
            &["W0300", "a.scene:1:1"],
        ),
        drawn(
            "param_no_number",
            "parametric { function { sqrt(-u) } function { v } function { 0 } <1, 0>, <2, 1> }",
            0,
            &[],
        ),
        drawn(
            "param_wild",
            "parametric { function { tan(u*99) } function { v/u } function { sin(1/u) } -1, 1 }",
            0,
            &[],
        ),
    ]
}

fn cameras() -> Vec<Case> {
    let camera = |name, words: &str, exit, told| {
        let camera = format!("camera {{ {words} }}\nsphere {{ 0, 1 }}\nlight_source {{ <3, 4, -5> rgb 1 }}\n");
        case(name, camera, exit, told)
    };
    const BLUR: &str = "location -5 * z aperture 1 blur_samples 9";
    let bokeh = |light| format!("{BLUR} bokeh {{ pigment {{ rgb {light} }} }}");
    let bad: &[&str] = &["E0213", "a.scene:1:1"];
    vec![
        camera("camera_no_direction", "location -5 * z direction 0", 1, bad),
        camera("camera_right_is_direction", "location -5 * z direction z right z", 0, &[]),
        camera("camera_no_right", "location -5 * z right 0", 1, bad),
        camera("camera_no_up", "location -5 * z up 0", 1, bad),
        camera("camera_nan", "location -5 * z direction <0, 0, 0/0>", 1, &["E0210", "a.scene:1:"]),
        camera("camera_looks_at_itself", "location -5 * z look_at -5 * z", 1, bad),
        camera("camera_looks_along_sky", "location 5 * y look_at 0", 0, &[]),
        camera("camera_no_sky", "location -5 * z sky 0 look_at 0", 1, &["a.scene:1:"]),
        camera("camera_angle_denormal", "location -5 * z look_at 0 angle 1e-308", 0, &[]),
        camera("camera_denormally_near", "location <0, 0, -1e-308> look_at 0", 0, &[]),
        camera("camera_angle_zero", "location -5 * z angle 0", 0, &[]),
        camera("camera_angle_negative", "location -5 * z angle -60", 1, &["a.scene:1:"]),
        camera("camera_angle_straight", "location -5 * z angle 180", 1, &["a.scene:1:"]),
        camera("camera_angle_huge", "location -5 * z angle 1e300", 1, &["a.scene:1:"]),
        camera("camera_far", "location 1e300 look_at 0", 0, &[]),
        camera("camera_flat", "location -5 * z scale <1, 1, 0>", 0, &["W0207"]),
        camera("lecture_camera_nowhere", "eye 0 center 0 up y fov_x 60", 1, bad),
        camera("lecture_camera_up", "eye 0 center z up z fov_x 60", 1, bad),
        camera("lecture_camera_wide", "eye -5 * z center 0 up y fov_x 180", 1, &["a.scene:1:"]),
        camera("lecture_camera_no_angle", "eye -5 * z center 0 up y", 0, &[]),
        camera("bokeh_black", &bokeh("0"), 0, &[]),
        camera("bokeh_nan", &bokeh("0/0"), 0, &["W0213", "a.scene:1:"]),
        camera("bokeh_huge", &bokeh("1e300"), 0, &[]),
        camera("bokeh_of_nothing", &format!("{BLUR} bokeh {{ }}"), 0, &[]),
        camera("bokeh_of_a_sphere", &format!("{BLUR} bokeh {{ sphere {{ 0, 1 }} }}"), 1, &["a.scene:1:"]),
        camera("camera_empty", "", 0, &[]),
    ]
}

fn lights() -> Vec<Case> {
    vec![
        drawn("light_at_camera", "light_source { <0, 0, -5> rgb 1 } sphere { 0, 1 }", 0, &[]),
        drawn("light_on_surface", "light_source { <0, 0, -1> rgb 1 } sphere { 0, 1 }", 0, &[]),
        drawn("light_inside", "light_source { 0 rgb 1 } sphere { 0, 1 }", 0, &[]),
        drawn("light_far", "light_source { 1e300 rgb 1 } sphere { 0, 1 }", 0, &[]),
        drawn("light_bright", "light_source { -9 rgb 1e308 } sphere { 0, 1 finish { specular 1 } }", 0, &[]),
        drawn("light_negative", "light_source { -9 rgb -1e308 } sphere { 0, 1 }", 0, &[]),
        drawn("light_nan", "light_source { -9 rgb 0/0 } sphere { 0, 1 }", 0, &["W0213", "a.scene:1:"]),
        drawn("light_fades_at_once", "light_source { -9 rgb 1 fade_distance 0 fade_power 2 } sphere { 0, 1 }", 0, &[]),
        drawn(
            "light_fades_wildly",
            "light_source { -9 rgb 1 fade_distance 1e-300 fade_power 1e300 } sphere { 0, 1 }",
            0,
            &[],
        ),
        case("light_alone", "light_source { }", 1, &["a.scene:1:"]),
    ]
}

fn csg() -> Vec<Case> {
    let deep = "#declare A = sphere { 0, 1 }\n#for (I, 1, 10000)\n  #declare A = difference { object { A } sphere { <I, 9, 9>, 1 } }\n#end\nobject { A }\n";
    let deep_union = "#declare A = sphere { 0, 1 }\n#for (I, 1, 10000)\n  #declare A = union { object { A } sphere { <I, 9, 9>, 1 } rotate x }\n#end\nobject { A }\n";
    let moved = "#declare A = sphere { 0, 1 }\n#for (I, 1, 10000)\n  #declare A = object { A translate x / 1e4 }\n#end\nobject { A }\n";
    let just = "#declare A = sphere { 0, 1 }\n#for (I, 1, 1000)\n  #declare A = difference { object { A } sphere { <I, 9, 9>, 1 } }\n#end\nobject { A }\n";
    let merged = "#declare A = sphere { 0, 1 }\n#for (I, 1, 4900)\n  #declare A = merge { object { A } sphere { <I / 9, 0, 0>, 2 } }\n#end\nobject { A }\n";
    let doubled = "#declare A = sphere { 0, 1 }\n#for (I, 1, 40)\n  #declare A = union { object { A } object { A translate I } }\n#end\nobject { A }\n";
    vec![
        drawn("csg_deep", deep, 1, &["E0104", "a.scene:3:"]),
        drawn("csg_deep_union", deep_union, 1, &["E0104", "a.scene:3:"]),
        drawn("csg_deep_objects", moved, 0, &[]),
        drawn("csg_deep_difference", just, 0, &[]),
        drawn("csg_as_deep_as_can_be", merged, 0, &[]),
        drawn("csg_doubled", doubled, 4, &["E0242", "a.scene:5:1"]),
        drawn("csg_empty", "difference { }", 0, &[]),
        drawn("csg_single", "difference { sphere { 0, 1 } }", 0, &[]),
        drawn("csg_itself", "difference { sphere { 0, 1 } sphere { 0, 1 } }", 0, &[]),
        drawn("csg_of_nothing", "intersection { sphere { 0, 1 } sphere { 9, 1 } }", 0, &[]),
        drawn("csg_of_planes", "intersection { plane { y, 0 } plane { -y, -1 } }", 0, &[]),
        drawn("csg_of_triangles", "difference { triangle { -x, x, y } triangle { -x, x, y } }", 0, &[]),
        drawn("csg_inverse", "intersection { sphere { 0, 1 inverse } sphere { 0, 1 inverse } inverse }", 0, &[]),
        drawn("csg_clipped_by_nothing", "sphere { 0, 1 clipped_by { } }", 0, &["W0205", "a.scene:1:15"]),
        drawn("csg_just_deep", nested("difference { ", "sphere { 0, 1 }", " sphere { 9, 1 } }", 900), 0, &[])
            .args("render a.scene -o out.png --size 4x3"),
    ]
}

fn finishes() -> Vec<Case> {
    let mirrors = "global_settings { max_trace_level 1e9 adc_bailout 0 }\n\
                   box { -10, 10 pigment { rgb 1 } finish { reflection 1 diffuse 0 } }\n";
    let glass = "global_settings { max_trace_level 1e9 adc_bailout 0 }\n\
                 box { -10, 10 pigment { rgbt 0.9 } finish { reflection 1 } interior { ior 1.5 } hollow }\n\
                 sphere { 0, 1 pigment { rgbt 0.9 } finish { reflection 1 } interior { ior 1.5 } }\n";
    let limited = "render a.scene -o out.png --size 8x6 --max-time 0.5";
    let endless = "global_settings { subsurface { samples 1e9, 1e9 } }\n\
                   sphere { 0, 1 pigment { rgb 0.5 } finish { subsurface { translucency 1 } } }\n";
    let extreme = "global_settings { mm_per_unit 1e-300 subsurface { samples 3, 3 radiosity on } }\n\
                   sphere { x, 1 pigment { rgb <0.5, 0, 1e300> } finish { subsurface { translucency <1e300, 1, 1> } } }\n\
                   sphere { 0, 1 pigment { rgb 1 } finish { diffuse 1 subsurface { translucency 1e-300 } } interior { ior 0 } }\n\
                   sphere { y, 1 pigment { rgb 1 } finish { subsurface { translucency -1 } } interior { ior -1 } }\n\
                   sphere { z, 1 pigment { rgb 0.3 } finish { subsurface { translucency 1e-200 } } interior { ior 1e300 } }\n";
    vec![
        drawn("subsurface_endless", endless, 4, &["E0241"]).args("render a.scene -o out.png --size 8x6 --max-time 2"),
        drawn("subsurface_extreme", extreme, 0, &[]),
        drawn("mirror_box", mirrors, 0, &[]),
        drawn("glass_box", glass, 4, &["E0241"]).args(limited),
        drawn(
            "phong_huge",
            "sphere { 0, 1 finish { phong 1e300 phong_size 1e300 specular 1e300 roughness 0 } }",
            0,
            &[],
        ),
        drawn("ior_zero", "sphere { 0, 1 pigment { rgbt 1 } interior { ior 0 } }", 0, &[]),
        drawn("ior_negative", "sphere { 0, 1 pigment { rgbt 1 } interior { ior -1.5 } }", 0, &[]),
        drawn("ior_huge", "sphere { 0, 1 pigment { rgbt 1 } interior { ior 1e300 } }", 0, &[]),
        drawn("diffuse_negative", "sphere { 0, 1 finish { diffuse -1e300 ambient 1e300 brilliance -1e300 } }", 0, &[]),
        drawn("map_backwards", "sphere { 0, 1 pigment { gradient x color_map { [1 rgb 0] [0 rgb 1] } } }", 0, &[]),
        drawn("map_empty", "sphere { 0, 1 pigment { gradient x color_map { } } }", 1, &["E0214", "a.scene:1:"]),
        drawn("map_nan", "sphere { 0, 1 pigment { gradient x color_map { [0/0 rgb 0] } } }", 1, &["a.scene:1:"]),
        drawn("gradient_zero", "sphere { 0, 1 pigment { gradient 0 } }", 1, &["a.scene:1:"]),
        drawn("brick_zero", "sphere { 0, 1 pigment { brick brick_size 0 mortar 0 } }", 0, &[]),
        drawn("frequency_huge", "sphere { 0, 1 pigment { gradient x frequency 1e300 phase 1e300 } }", 0, &[]),
        drawn("pattern_far", "sphere { 0, 1 pigment { checker translate 1e300 scale 1e-300 } }", 0, &[]),
    ]
}
