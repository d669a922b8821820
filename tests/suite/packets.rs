//! Camera rays are traced in packets. A region of two pixels is too small for a packet, so its rays are traced one by one: each such
//! region must have the bytes of the whole picture.

use durer::{BuildOptions, Memory, Region, RenderOptions, Sources, Unwatched, World};
use std::sync::Arc;

const WIDTH: usize = 40;
const HEIGHT: usize = 30;

/// Textures of one layer that light reaches in packets: with all terms of `finish`, patterns, bumps, mirrors.
const TEXTURES: [&str; 6] = [
    "pigment { rgb <0.9, 0.5, 0.2> } finish { phong 0.7 phong_size 35 }",
    "pigment { checker rgb 0.9 rgb <0.1, 0.4, 0.2> scale 0.5 } finish { specular 0.6 roughness 0.03 metallic }",
    "pigment { bozo scale 0.4 } normal { bumps 0.6 scale 0.2 } finish { phong 0.4 phong_size 3.5 specular 0.2 brilliance 1.5 }",
    "pigment { rgb <0.4, 0.6, 1> } finish { reflection { 0.1, 0.8 metallic } brilliance 3 diffuse 0.6 }",
    "pigment { rgb 0.8 } normal { ripples 0.3 scale 0.3 } finish { reflection 0.5 diffuse 0.4 emission 0.05 }",
    "pigment { rgb 0.6 } finish { diffuse 0 ambient 0.3 }",
];

/// Textures whose light is computed ray by ray: they transmit light, have grain, or reflect light from behind.
const OTHERS: [&str; 3] = [
    "pigment { rgbf <0.9, 1, 0.9, 0.8> } finish { reflection 0.2 specular 0.5 }",
    "pigment { rgb 0.7 } finish { crand 0.1 }",
    "pigment { rgb 0.7 } finish { diffuse 0.4, 0.3 }",
];

/// Textures of several layers or materials that light reaches in packets, some of them not everywhere. (Each ends the block of its
/// first layer by itself.)
const LAYERED: [&str; 7] = [
    "pigment { wood scale 0.3 } finish { specular 0.4 } }
     texture { pigment { gradient x color_map { [0 rgbt 1] [1 rgbt <1, 0, 0, 0.3>] } } finish { phong 0.5 phong_size 9.5 }",
    "pigment { checker rgb 0.3 rgb 0.8 scale 0.4 } normal { bumps 0.5 scale 0.1 } } texture { pigment { rgbf <1, 0.8, 0.7, 0.6> } }
     texture { pigment { bozo color_map { [0.4 rgbt 1] [0.6 rgb y] } scale 0.2 } normal { ripples 0.4 scale 0.2 }",
    "gradient y texture_map { [0.2 pigment { rgb x } finish { phong 1 }] [0.8 pigment { rgb z } normal { dents 0.4 }] } scale 0.9",
    "average texture_map { [1 pigment { rgb x }] [2 pigment { rgb y } finish { ambient 0.2 specular 0.4 metallic }] }",
    "checker texture { pigment { rgb 0.9 } }, texture { pigment { rgb 0.1 } finish { reflection 0.3 } } scale 0.4",
    "pigment { rgb 0.5 } } texture { pigment { rgbt <0.4, 0.9, 0.2, 0.05> } finish { ambient 0 diffuse 0.9 brilliance 2 }",
    "pigment { gradient x color_map { [0.5 rgb 0.8] [0.5 rgbt <0, 0, 1, 0.7>] } scale 0.3 } } texture { pigment { rgbt 0.5 }",
];

/// Textures of patterns that are evaluated at several points together.
const FRACTALS: [&str; 4] = [
    "pigment { mandel 40 color_map { [0 rgb 0.1] [0.3 rgb <1, 0.7, 0>] [1 rgb 1] } scale 0.7 } finish { specular 0.3 }",
    "pigment { julia <0.32, 0.04>, 25 interior 1, 3 exterior 6, 0.1 }",
    "pigment { magnet 1 mandel 20 turbulence 0.2 scale 0.6 }",
    "pigment { mandel 30 exponent 4 interior 2, 1 } finish { reflection 0.2 }",
];

/// Lights of all kinds.
const LIGHTS: &str = "light_source { <5, 8, -6>, rgb 0.6 }
    light_source { <-6, 5, -5>, rgb <0.2, 0.3, 0.5> fade_distance 5 fade_power 1.5 }
    light_source { <0, 9, -3>, rgb 0.5 spotlight point_at <0, 0, 0.5> radius 12 falloff 20 tightness 3 }
    light_source { <3, 4, -9>, rgb <0.2, 0.1, 0.1> parallel point_at 0 }
    light_source { <-3, 2, -4>, rgb 0.15 shadowless }
    light_source { <1, 7, 2>, rgb 0.3 cylinder point_at <1, 0, 2> radius 1 falloff 1.5 }";

/// Returns the objects of a scene, with these textures in turn.
fn objects(textures: &[&str]) -> String {
    let texture = |i: usize| format!("texture {{ {} }}", textures[i % textures.len()]);
    let shapes = [
        "sphere { <-1.2, 0.9, 0>, 0.9",
        "box { <0.1, 0, -0.6>, <1.1, 1, 0.4> rotate 20 * y",
        "cylinder { <1.9, 0, 0.5>, <1.6, 1.8, 0.2>, 0.4",
        "cone { <-2.6, 0, -0.8>, 0.5, <-2.4, 1.2, -0.6>, 0.1",
        "difference { sphere { <0.2, 0.7, 1.9>, 1.2 } box { <-0.4, 0.6, -1>, <0.8, 3, 3> }",
        "torus { 0.5, 0.15 rotate 70 * x translate <-0.3, 0.5, -1.4>",
        "disc { <2.4, 1.4, 1.5>, <-1, 0.2, -1>, 0.8, 0.2",
        "quadric { <4, 1, 4>, 0, 0, -0.5 translate <-1.5, 1.2, 2.5>",
        "triangle { <-3, 0, 3>, <-1, 2.5, 3>, <0.5, 0, 3.5>",
    ];
    let shapes = shapes.iter().enumerate().map(|(i, shape)| format!("{shape} {} }}", texture(i + 1)));
    format!("plane {{ y, 0 {} }} {}", texture(0), shapes.collect::<Vec<_>>().join("\n"))
}

fn world(text: &str) -> World {
    let sources = Sources::new(Arc::new(Memory::default()));
    let file = durer::load_bytes(&sources, "main.scene", text.as_bytes()).unwrap();
    let build = BuildOptions { size: (WIDTH, HEIGHT), ..BuildOptions::default() };
    let built = durer::build(&sources, file, &build, &mut |_| {});
    built.world.unwrap_or_else(|| panic!("{:?}\n{text}", built.diagnostics))
}

/// Asserts that regions of two pixels have the bytes of the whole picture.
#[track_caller]
fn assert_single_rays_agree(text: &str, alpha: bool) {
    let world = world(text);
    let options = RenderOptions { alpha, ..RenderOptions::new(WIDTH, HEIGHT) };
    let (whole, rays) = durer::render(&world, &options, &Unwatched).unwrap();
    let mut counts = durer::RayCounts::default();
    for at in (0..WIDTH * HEIGHT).step_by(2) {
        let region = Region { x: at % WIDTH, y: at / WIDTH, width: 2, height: 1 };
        let options = RenderOptions { region: Some(region), ..options.clone() };
        let (part, rays_of_part) = durer::render(&world, &options, &Unwatched).unwrap();
        assert!(part.pixels[at..at + 2] == whole.pixels[at..at + 2], "{region:?}\n{text}");
        counts.add(&rays_of_part);
    }
    assert_eq!(rays, counts, "{text}");
    assert!(rays.shadow > 500 || !text.contains("light_source"), "{rays:?}");
}

/// Returns a scene with these settings, camera, lights and objects.
fn scene(settings: &str, camera: &str, rest: &str) -> String {
    format!(
        "#version 3.7; global_settings {{ assumed_gamma 1 max_trace_level 6 {settings} }}
         #default {{ finish {{ ambient 0.1 diffuse 0.7 }} }}
         camera {{ {camera} location <0, 2.2, -6> look_at <0, 0.8, 0> }}
         sky_sphere {{ pigment {{ gradient y color_map {{ [0 rgb 0.8] [1 rgb <0.2, 0.3, 0.9>] }} }} }} {rest}"
    )
}

#[test]
fn plain_surfaces() {
    for (first, lights) in [(0, LIGHTS), (2, ""), (3, "light_source { <5, 8, -6>, rgb 1 }")] {
        let textures: Vec<&str> = TEXTURES.iter().cycle().skip(first).take(TEXTURES.len()).copied().collect();
        assert_single_rays_agree(&scene("", "", &format!("{lights} {}", objects(&textures))), false);
    }
    // One finish for all
    assert_single_rays_agree(&scene("", "", &format!("{LIGHTS} {}", objects(&TEXTURES[2..3]))), false);
    assert_single_rays_agree(&scene("", "orthographic", &format!("{LIGHTS} {}", objects(&TEXTURES))), true);
}

#[test]
fn surfaces_of_all_kinds() {
    let others = OTHERS.iter().chain(&LAYERED).cycle();
    let mixed: Vec<&str> = TEXTURES.iter().zip(others).flat_map(|(a, b)| [*a, *b]).collect();
    assert_single_rays_agree(&scene("", "", &format!("{LIGHTS} {}", objects(&mixed))), false);
    assert_single_rays_agree(&scene("", "spherical angle 120", &format!("{LIGHTS} {}", objects(&mixed[3..]))), false);
    let refracting =
        "sphere { <0.3, 1.4, -2>, 0.6 pigment { rgbf 0.9 } interior { ior 1.4 } finish { reflection 0.1 } }";
    assert_single_rays_agree(&scene("", "", &format!("{LIGHTS} {refracting} {}", objects(&mixed))), false);
}

#[test]
fn surfaces_of_several_layers() {
    assert_single_rays_agree(&scene("", "", &format!("{LIGHTS} {}", objects(&LAYERED))), false);
    for texture in [LAYERED[1], LAYERED[2], LAYERED[4]] {
        assert_single_rays_agree(&scene("", "", &format!("{LIGHTS} {}", objects(&[texture]))), false);
    }
    let fog = "fog { distance 9 rgb <0.7, 0.8, 0.9> }";
    assert_single_rays_agree(&scene("", "", &format!("{fog} {LIGHTS} {}", objects(&LAYERED[..4]))), true);
}

#[test]
fn patterns_at_several_points() {
    assert_single_rays_agree(&scene("", "", &format!("{LIGHTS} {}", objects(&FRACTALS))), false);
    assert_single_rays_agree(&scene("", "", &format!("{LIGHTS} {}", objects(&FRACTALS[2..3]))), false);
}

#[test]
fn soft_shadows() {
    let light = |words: &str| format!("light_source {{ <4, 6, -5>, rgb 0.6 area_light 3*x, 2*y, {words} }}");
    let point = "light_source { <-4, 6, -5>, rgb 0.4 }";
    let textures: Vec<&str> = TEXTURES.iter().zip(LAYERED).flat_map(|(a, b)| [*a, b]).collect();
    for words in [
        "5, 4",
        "5, 5 adaptive 0 fade_distance 5 fade_power 1",
        "9, 9 adaptive 1 jitter",
        "8, 8 adaptive 2 jitter circular orient",
        "3, 1 adaptive 1 orient spotlight point_at 0 radius 12 falloff 20",
        "4, 4 adaptive 1 parallel point_at 0",
        "3, 3 shadowless",
        "17, 17 jitter",
        "40, 40 adaptive 1",
        "3, 3 area_illumination",
    ] {
        let lights = format!("{} {} {point}", light(words), light("4, 4 adaptive 1 jitter translate 8 * z"));
        assert_single_rays_agree(&scene("", "", &format!("{lights} {}", objects(&textures[..7]))), false);
    }
    let filtering = format!("{} {point} {}", light("6, 6 adaptive 1 jitter"), objects(&[OTHERS[0], TEXTURES[3]]));
    assert_single_rays_agree(&scene("", "", &filtering), false);
}

#[test]
fn air_and_lights_that_need_single_rays() {
    let fog = "fog { distance 9 rgb <0.7, 0.8, 0.9> } fog { fog_type 2 distance 4 fog_offset 0.3 fog_alt 0.4 rgb 0.6 }";
    assert_single_rays_agree(&scene("", "", &format!("{fog} {LIGHTS} {}", objects(&TEXTURES))), false);
    let group =
        format!("light_group {{ light_source {{ <4, 6, -5>, rgb 0.6 }} {} global_lights on }}", objects(&TEXTURES));
    assert_single_rays_agree(&scene("", "", &format!("light_source {{ <-4, 6, -5>, rgb 0.4 }} {group}")), false);
    let media = format!("{LIGHTS} {} media {{ scattering {{ 1, 0.02 }} }}", objects(&TEXTURES));
    assert_single_rays_agree(&scene("", "", &media), false);
    let radiosity = "radiosity { count 5 error_bound 1 pretrace_start 1 pretrace_end 1 }";
    assert_single_rays_agree(&scene(radiosity, "", &format!("{LIGHTS} {}", objects(&TEXTURES))), false);
}

#[test]
fn rays_that_begin_in_different_interiors() {
    // The camera rays on the left begin within coloured glass. Objects on the right are in glass that camera rays do not see: their
    // light crosses its surface, but does not leave an interior that the rays have entered.
    let glass =
        "pigment { rgbf <0.9, 0.8, 0.7, 0.9> } interior { fade_power 2 fade_distance 2 fade_color <0.6, 0.9, 0.3> }";
    let rest = format!(
        "{LIGHTS} {} sphere {{ <-3, 2, -6>, 2.8 {glass} }} sphere {{ <1.5, 0.5, 0>, 2.2 {glass} no_image no_reflection }}",
        objects(&TEXTURES)
    );
    assert_single_rays_agree(&scene("", "orthographic", &rest), false);
    assert_single_rays_agree(&scene("", "", &rest), false);
}

#[test]
fn hidden_objects() {
    let hidden = [
        "sphere { <-0.5, 1.5, -2.5>, 0.5 pigment { rgb x } no_image }",
        "sphere { <0.8, 1.6, -2>, 0.4 pigment { rgb y } no_reflection }",
        "box { <-3, 2, -2>, <3, 2.3, -1.5> pigment { rgb z } no_shadow double_illuminate }",
    ];
    assert_single_rays_agree(&scene("", "", &format!("{LIGHTS} {} {}", objects(&TEXTURES), hidden.join("\n"))), false);
}
