//! Surfaces that show a single layer have code of their own: what makes the program use the general code, a clear layer above
//! or an `average` of one texture, changes nothing.

use crate::drawing::draw;
use durer::RenderOptions;

/// Textures of one layer: glass, thin films, mirrors, patterns with and without transparency.
const LAYERS: [&str; 9] = [
    "pigment { rgbf <0.9, 0.95, 1, 0.9> } finish { specular 0.8 reflection { 0.05, 0.9 fresnel } conserve_energy }",
    "pigment { rgbt <1, 0.5, 0.2, 0.6> } finish { phong 0.7 reflection 0.3 diffuse 0.5, 0.2 }",
    "pigment { rgbf 1 } finish { irid { 0.4 thickness 0.4 turbulence 0.2 } reflection 0.2 diffuse 0 }",
    "pigment { checker rgb <1, 0, 0>, rgbt <0, 1, 0, 0.7> scale 0.4 } finish { reflection { 0.4 metallic } }",
    "pigment { bozo color_map { [0 rgbf <1, 1, 0, 0.9>] [1 rgb <0, 0, 1>] } } finish { emission 0.1 }",
    "pigment { rgb <1, 0.8, 0.3> } finish { metallic specular 0.7 reflection { 0.2, 0.7 falloff 3 } conserve_energy }",
    "pigment { rgb 0.5 } finish { irid { 0.3 thickness 0.3 } }",
    "pigment { rgbft <0.8, 0.9, 1, 0.5, 0.4> } finish { brilliance 2 }",
    "pigment { rgbf <1, 1, 1, 0.995> } finish { diffuse 0 }",
];

/// Returns a scene with a solid of this texture and interior in front of a floor and a wall.
fn scene(texture: &str, interior: &str) -> String {
    format!(
        "#version 3.7; global_settings {{ assumed_gamma 1 max_trace_level 8 }}
         #default {{ finish {{ ambient 0.1 diffuse 0.7 }} }}
         camera {{ location <0, 2, -5> look_at <0, 0.8, 0> }}
         light_source {{ <5, 8, -6>, rgb 0.8 }} light_source {{ <-6, 4, -5>, rgb <0.2, 0.3, 0.5> }}
         plane {{ y, 0 pigment {{ checker rgb 0.9 rgb <0.2, 0.3, 0.6> }} }}
         plane {{ z, 6 pigment {{ gradient y color_map {{ [0 rgb 0.3] [1 rgb <1, 0.7, 0.4>] }} }} }}
         sphere {{ <-1.1, 1, 0>, 1 {texture} {interior} }}
         difference {{ box {{ <0.2, 0, -0.8>, <2, 1.6, 0.8> }} sphere {{ <0.6, 1.6, -0.8>, 0.7 }} {texture} {interior} }}"
    )
}

/// Renders two scenes; fails unless their pictures and the numbers of their rays are equal. Returns the number of rays that
/// surfaces reflected or transmitted.
fn assert_equal_pictures(scenes: [&str; 2], what: &str) -> u64 {
    let [one, two] = scenes.map(|text| draw(text, &RenderOptions::new(48, 36)));
    let differs = |(a, b): (&[f32; 4], &[f32; 4])| a.iter().zip(b).any(|(a, b)| (a - b).abs() > 2e-6);
    let all: Vec<_> = one.0.pixels.iter().zip(&two.0.pixels).enumerate().collect();
    let worst = all.iter().find(|(_, pair)| differs(*pair));
    assert_eq!(worst, None, "{what}");
    let rays = |rays: &durer::RayCounts| [rays.camera, rays.shadow, rays.reflected, rays.transmitted];
    assert_eq!(rays(&one.1), rays(&two.1), "{what}");
    one.1.reflected + one.1.transmitted
}

#[test]
fn a_clear_layer_above_changes_nothing() {
    let clear = "texture { pigment { rgbt 1 } finish { ambient 0 diffuse 0 } }";
    let mut n_continued = 0;
    for layer in LAYERS {
        for interior in ["", "interior { ior 1.4 fade_power 2 fade_distance 1 fade_color <0.8, 0.5, 0.5> }"] {
            // Total internal reflection has the film of the topmost layer.
            if layer.contains("irid") && interior.contains("ior") {
                continue;
            }
            let texts = ["", clear].map(|above| scene(&format!("texture {{ {layer} }} {above}"), interior));
            n_continued += assert_equal_pictures(texts.each_ref().map(String::as_str), &format!("{layer} {interior}"));
        }
    }
    assert!(n_continued > 10_000, "{n_continued}");
}

#[test]
fn an_average_of_one_pattern_of_textures_changes_nothing() {
    let other = "pigment { granite scale 0.3 } normal { bumps 0.4 scale 0.2 } finish { reflection 0.1 }";
    let mut n_continued = 0;
    for layer in LAYERS {
        let selections = [
            format!("checker texture {{ {layer} }} texture {{ {other} }} scale 0.4 rotate 20"),
            format!("gradient x texture_map {{ [0.4 {layer}] [0.4 {other}] }} scale <0.7, 0.5, 0.5> rotate 30"),
        ];
        for selection in selections {
            let average = format!("average texture_map {{ [1 {selection}] }}");
            let texts = [&selection, &average]
                .map(|texture| scene(&format!("texture {{ {texture} }}"), "interior { ior 1.2 }"));
            n_continued += assert_equal_pictures(texts.each_ref().map(String::as_str), &selection);
        }
    }
    assert!(n_continued > 10_000, "{n_continued}");
}
