//! Radiosity: brightness in closed form, the same bytes for any number of threads and any region.

use crate::drawing::{draw, is_independent_of_threads_and_region, is_near, mean};
use durer::RenderOptions;

const SETTINGS: &str = "count 400 recursion_limit 12 adc_bailout 0.001 nearest_count 4 error_bound 1 pretrace_end 0.08";
const DOWN: &str = "camera { location <0, 5, 0> look_at 0 right x*4/3 up z sky z }";

fn with_radiosity(settings: &str, scene: &str) -> String {
    format!("#version 3.7; global_settings {{ assumed_gamma 1 radiosity {{ {settings} }} }} {scene}")
}

/// Returns the words of a white surface that emits and reflects light.
fn surface(emission: f64, diffuse: f64) -> String {
    format!("pigment {{ rgb 1 }} finish {{ ambient 0 emission {emission} diffuse {diffuse} }}")
}

/// The truth is the solution of the radiosity equation L = e + rho·sum(F·L) with the form factors F of each scene.
#[test]
fn brightness_is_that_of_the_radiosity_equation() {
    for (scene, truth) in [
        // Inside a sphere every point sees the sphere: L = e / (1 - rho).
        (format!("camera {{ location 0 look_at z }} sphere {{ 0, 10 {} }}", surface(0.2, 0.5)), 0.4),
        // The floor sees the sky only: L = rho·L_sky.
        (format!("{DOWN} background {{ rgb 0.5 }} plane {{ y, 0 {} }}", surface(0.0, 0.6)), 0.3),
        // Each plane sees the other only: L0 = 0.1 + 0.6 L1, L1 = 0.3 + 0.5 L0.
        (format!("{DOWN} plane {{ y, 0 {} }} plane {{ -y, -10 {} }}", surface(0.1, 0.6), surface(0.3, 0.5)), 0.4),
        // The outer sphere sees the inner one with F = 1/9: L1 = 1 + 0.5 L2, L2 = 0.6 (L1/9 + 8 L2/9).
        (
            format!(
                "camera {{ location <0, 0, 1.5> look_at z*3 }} sphere {{ 0, 1 {} }} sphere {{ 0, 3 {} }}",
                surface(1.0, 0.5),
                surface(0.0, 0.6)
            ),
            0.153_846,
        ),
    ] {
        let frame = draw(&with_radiosity(SETTINGS, &scene), &RenderOptions::new(16, 12)).0;
        is_near(mean(&frame), truth, 0.01);
    }
}

#[test]
fn threads_and_regions_do_not_change_a_byte() {
    let scene = "camera { location <1, 2, -6> look_at <0, 1, 0> } background { rgb <0.3, 0.4, 0.6> }
                 light_source { <4, 6, -3> rgb 0.8 } plane { y, 0 pigment { checker rgb 1 rgb 0.5 } }
                 sphere { <-1, 1, 0>, 1 pigment { rgb <0.9, 0.4, 0.3> } normal { bumps 0.4 } }
                 box { <0.3, 0, -1>, <1.5, 1.4, 1> pigment { rgb 0.6 } finish { reflection 0.3 } }";
    let settings = "count 20 recursion_limit 3 nearest_count 4 error_bound 1 always_sample on";
    is_independent_of_threads_and_region(&with_radiosity(settings, scene), 48, 36);
}

#[test]
fn settings_of_rad_def_are_read() {
    for setting in 0..=10 {
        let words = format!("Rad_Settings({setting}, on, off) count 10");
        let scene =
            with_radiosity(&words, "camera { location -3*z } background { rgb 1 } sphere { 0, 1 pigment { rgb 1 } }");
        let frame = draw(&format!("#include \"rad_def.inc\"\n{scene}"), &RenderOptions::new(8, 6)).0;
        // Gathered light: the sphere is darker than the sky, and not black.
        let light = f64::from(frame.pixels[3 * 8 + 4][0]);
        assert!(light > 0.0 && light < 1.0, "{setting}: {light}");
    }
}
