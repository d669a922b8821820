//! Shafts of area lights: pictures with and without shafts are equal, and shafts replace many shadow rays.

use crate::drawing::draw;
use durer::{Frame, RenderOptions};

/// Occluders of many kinds above a floor, below a ceiling.
const OCCLUDERS: &str = "
#version 3.7;
global_settings { assumed_gamma 1 }
#default { finish { ambient 0 diffuse 1 phong 0.3 } }
camera { location <0, 3, -9> look_at <0, 1, 0> }
plane { y, 0 pigment { checker rgb 1 rgb 0.6 } }
plane { -y, -20 pigment { rgb 0.5 } }
#declare Seed = seed(7);
#declare Ball = union { sphere { 0, 0.2 } cone { 0.2*y, 0.2, 0.6*y, 0 } };
#macro Odd(I)
  #switch (mod(I, 11))
    #case (0) sphere { 0, 0.4 #break
    #case (1) box { -0.3, 0.3 #break
    #case (2) cylinder { -0.4*x, 0.4*x, 0.2 open #break
    #case (3) torus { 0.4, 0.1 #break
    #case (4) difference { box { -0.4, 0.4 } cylinder { -y, y, 0.3 } #break
    #case (5) sphere { 0, 0.5 clipped_by { plane { y, 0.1 } } #break
    #case (6) triangle { <-0.5, 0, 0>, <0.5, 0, 0.2>, <0, 0.6, 0> #break
    #case (7) disc { 0, y, 0.5, 0.2 #break
    #case (8) object { Ball #break
    #case (9) mesh { triangle { 0, x, y } triangle { x, y, z } #break
    #else intersection { plane { y, 0.2 } plane { -y, 0.2 } sphere { 0, 0.6 } inverse
  #end
    #switch (mod(I, 4))
      #case (0) pigment { rgbt <1, 0.6, 0.3, 0.5> } #break
      #case (1) pigment { rgbf <0.5, 0.6, 1, 0.6> } finish { reflection 0.2 } #break
      #else pigment { rgb <0.9, 0.7, 0.4> }
    #end
    #if (mod(I, 7) = 3) no_shadow #end
    #if (mod(I, 7) = 5) no_image #end
    rotate 360*<rand(Seed), rand(Seed), rand(Seed)>
    translate <10*rand(Seed) - 5, 3*rand(Seed), 8*rand(Seed) - 4>
  }
#end
#for (I, 0, 43) #if (mod(I, 11) < 10) Odd(I) #end #end
";

fn options((width, height): (usize, usize), has_shafts: bool) -> RenderOptions {
    RenderOptions { has_shafts, ..RenderOptions::new(width, height) }
}

/// Renders the occluders and a light with and without shafts, and returns the numbers of shadow rays.
fn compare(light: &str, size: (usize, usize)) -> [u64; 2] {
    let text = format!("{OCCLUDERS}{light}");
    let ((with, with_rays), (without, without_rays)) =
        (draw(&text, &options(size, true)), draw(&text, &options(size, false)));
    let bits = |frame: &Frame, i: usize| frame.pixels[i].map(f32::to_bits);
    let differs = (0..with.pixels.len()).find(|&i| bits(&with, i) != bits(&without, i));
    assert_eq!(differs.map(|i| (i, with.pixels[i], without.pixels[i])), None, "{light}");
    assert!(with.pixels.iter().any(|pixel| pixel[0] > 0.05), "the picture is black: {light}");
    [with_rays.shadow, without_rays.shadow]
}

#[test]
fn pictures_with_and_without_shafts_are_equal() {
    for light in [
        "light_source { <3, 9, -4>, 1 area_light 4*x, 4*z, 5, 5 }",
        "light_source { <3, 9, -4>, 1 area_light 4*x, 4*z, 17, 17 }",
        "light_source { <3, 9, -4>, 1 area_light 4*x, 4*z, 20, 20 jitter }",
        "light_source { <3, 9, -4>, 1 area_light x, y, 9, 9 jitter circular orient }",
        "light_source { <3, 9, -4>, 1 area_light 3*x, 3*z, 20, 20 circular }",
        "light_source { <-3, 6, -4>, 1 area_light 3*x, 0.01*y, 30, 1 }",
        "light_source { <-3, 6, -4>, 1 area_light 3*x, 2*z, 6, 6 area_illumination on }",
        "light_source { <3, 9, -4>, 1 area_light 3*x, 2*y, 6, 6 fade_distance 3 fade_power 2 }",
        "light_source { <3, 9, -4>, 1 area_light 4*x, 4*z, 9, 9 adaptive 1 }",
        "light_source { <3, 9, -4>, 1 area_light 4*x, 4*z, 17, 9 adaptive 2 jitter }",
        "light_source { <3, 9, -4>, 1 spotlight point_at 0 radius 20 falloff 30 area_light 2*x, 2*z, 5, 5 }",
        "light_group { light_source { <3, 9, -4>, 1 area_light 2*x, 2*z, 5, 5 } Odd(1) Odd(4) global_lights on }
         light_source { <-3, 9, -4>, 0.5 area_light 2*x, 2*z, 5, 5 }",
        // Fog that does not attenuate the light, and an interior around the camera and shaded points
        "light_source { <3, 9, -4>, 1 area_light 4*x, 4*z, 6, 6 } fog { distance 20 color rgb <0.4, 0.5, 0.6> }",
        "light_source { <3, 4, -4>, 1 area_light 4*x, 4*z, 5, 5 }
         box { <-20, -1, -20>, <20, 2, 20> hollow pigment { rgbf 1 }
           interior { ior 1.1 caustics 0.5 media { scattering { 1, 0.02 } samples 3 intervals 1 } } }",
    ] {
        let [with, without] = compare(light, (48, 36));
        assert!(with * 20 < without * 19, "{with} of {without} rays: {light}");
    }
}

#[test]
fn lights_without_clear_shafts_get_all_shadow_rays() {
    for light in [
        "light_source { <3, 9, -4>, 1 area_light 4*x, 4*z, 6, 4 }",
        "light_source { <3, 9, -4>, 1 area_light 4*x, 4*z, 9, 9 adaptive 0 }",
        "light_source { <3, 9, -4>, 1 parallel point_at 0 area_light 4*x, 4*z, 5, 5 }",
        "light_source { <3, 9, -4>, 1 cylinder point_at 0 radius 5 falloff 6 area_light 4*x, 4*z, 5, 5 }",
        "light_source { <3, 9, -4>, 1 area_light 4*x, 4*z, 5, 5 projected_through { disc { <2, 7, -3>, y, 2 } } }",
        "light_source { <3, 9, -4>, 1 area_light 4*x, 4*z, 5, 5 media_attenuation on }
         fog { distance 20 color rgb <0.4, 0.5, 0.6> }",
        "light_source { <3, 9, -4>, 1 area_light 4*x, 4*z, 5, 5 media_attenuation on }
         media { absorption 0.05 samples 3 intervals 1 }",
        // A light that intersects the floor, and an object whose box contains all points
        "light_source { <0, 0.5, 0>, 1 area_light 3*x, 2*y, 6, 6 }",
        "light_source { <3, 4, -4>, 1 area_light 4*x, 4*z, 5, 5 media_attenuation on }
         sphere { 0, 12 hollow pigment { rgbf 1 } interior { media { absorption 0.05 } fade_distance 9 fade_power 2 } }",
    ] {
        let [with, without] = compare(light, (24, 18));
        assert_eq!(with, without, "{light}");
    }
}

#[test]
fn pictures_of_large_grids_with_and_without_shafts_are_equal() {
    let [with, without] = compare("light_source { <3, 9, -4>, 1 area_light 2*x, 2*z, 300, 300 jitter }", (5, 4));
    assert!(with * 3 < without * 2, "{with} of {without} rays");
}

#[test]
fn nine_million_lights_behind_a_small_box() {
    let look_down = "#version 3.7; global_settings { assumed_gamma 1 } #default { finish { ambient 0 diffuse 1 } }
        camera { location <0, 5, 0> look_at 0 angle 0.01 sky z }
        plane { y, 0 pigment { rgb 1 } }
        light_source { <0, 10, 0>, 1 area_light 2*x, 2*z, 3000, 3000 }";
    let (frame, rays) = draw(look_down, &options((2, 2), true));
    assert_eq!(rays.shadow, 0);
    let lit = frame.pixels[0][0];
    // A box before a corner of the light, 0.2 x 0.2 of 2 x 2
    let (frame, rays) = draw(&format!("{look_down} box {{ <0.4, 5, 0.4>, <1, 5.001, 1> }}"), &options((2, 2), true));
    let share = frame.pixels[0][0] / lit;
    assert!((share - 0.99).abs() < 1e-3, "{share}");
    assert!(rays.shadow < 4 * 150_000, "{}", rays.shadow);
}
