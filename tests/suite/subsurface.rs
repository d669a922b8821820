//! Subsurface light: the share of light that a half-space reflects, scaling, the same bytes for any number of threads.

use crate::drawing::{draw, is_independent_of_threads_and_region, is_near, mean};
use durer::RenderOptions;

/// Returns a scene whose objects are seen from above, with parallel light from above and subsurface light.
fn from_above(settings: &str, scale: f64, objects: &str) -> String {
    format!(
        "#version 3.7; global_settings {{ assumed_gamma 1 {settings} }}
         camera {{ orthographic location {scale}*10*y direction -y right {scale}*x*4/3 up {scale}*z }}
         light_source {{ 1000*y rgb 1 parallel point_at 0 }} union {{ {objects} scale {scale} }}"
    )
}

/// Returns the words of a translucent surface.
fn translucent(color: &str, translucency: f64) -> String {
    format!("pigment {{ rgb {color} }} finish {{ ambient 0 diffuse 1 subsurface {{ translucency {translucency} }} }}")
}

/// Diffuse light alone: the pigment's colour, times the transmittance of the surface for light and view, 0.96².
#[test]
fn a_half_space_reflects_its_color() {
    for (color, ior, truth) in [(0.5, 1.0, 0.5), (0.5, 1.5, 0.4608), (0.9, 1.5, 0.829_44), (0.1, 1.5, 0.092_16)] {
        let surface = translucent(&color.to_string(), 1.0);
        let object = format!("box {{ <-90, -90, -90>, <90, 0, 90> {surface} interior {{ ior {ior} }} }}");
        let frame = draw(&from_above("subsurface { samples 200, 0 }", 1.0, &object), &RenderOptions::new(8, 6)).0;
        is_near(mean(&frame), truth, 0.004);
    }
}

/// Light scattered once: α'/24 at a right angle, where α' is nearly 1 for a white material.
#[test]
fn a_white_half_space_scatters_once() {
    let object = format!("box {{ <-90, -90, -90>, <90, 0, 90> {} }}", translucent("1", 1.0));
    let frame = draw(&from_above("subsurface { samples 0, 400 }", 1.0, &object), &RenderOptions::new(8, 6)).0;
    is_near(mean(&frame), 1.0 / 24.0, 0.005);
}

#[test]
fn units_do_not_matter() {
    let object = format!("sphere {{ 0, 0.4 {} }}", translucent("<0.8, 0.5, 0.3>", 2.0));
    let [one, ten] = [(1.0, 20.0), (10.0, 2.0)].map(|(scale, mm)| {
        let settings = format!("mm_per_unit {mm} subsurface {{ samples 100, 20 }}");
        mean(&draw(&from_above(&settings, scale, &object), &RenderOptions::new(16, 12)).0)
    });
    is_near(one, ten, 0.002);
}

#[test]
fn without_global_settings_light_is_diffuse() {
    let object = format!("plane {{ y, 0 {} }}", translucent("0.5", 1.0));
    let frame = draw(&from_above("", 1.0, &object), &RenderOptions::new(4, 3)).0;
    is_near(mean(&frame), 0.5, 1e-6);
}

#[test]
fn threads_and_regions_do_not_change_a_byte() {
    let objects = format!(
        "sphere {{ 0, 0.3 {} interior {{ ior 1.4 }} }} plane {{ y, -0.3 {} normal {{ bumps 0.4 }} }}",
        translucent("<0.8, 0.5, 0.3>", 2.0),
        translucent("0.6", 1.0)
    );
    let settings = "subsurface { samples 12, 5 radiosity on } radiosity { count 10 always_sample on subsurface on }";
    is_independent_of_threads_and_region(&from_above(settings, 1.0, &objects), 24, 18);
}
