//! Photons: energy in closed form, brightness beside POV-Ray's, the same bytes for any number of threads and any region.

use crate::drawing::{draw, is_independent_of_threads_and_region, is_near, mean};
use crate::scratch::Scratch;
use durer::{Frame, RenderOptions};

/// Returns the picture of a scene, 40 × 40 pixels.
fn picture(text: &str) -> Frame {
    draw(text, &RenderOptions::new(40, 40)).0
}

/// Returns a scene: a light at height 10 over a target at height 5 over a white plane, which the camera sees from below the
/// target, over 8 × 8 units.
fn scene(photons: &str, light: &str, target: &str, ior: f64) -> String {
    format!(
        "#version 3.7; global_settings {{ assumed_gamma 1 photons {{ {photons} }} }}
         camera {{ orthographic location 2*y look_at 0 right 8*x up 8*z }}
         light_source {{ 10*y, rgb 0.2 {light} }}
         {target} pigment {{ rgbf 1 }} finish {{ ambient 0 diffuse 0 }} interior {{ ior {ior} }}
           photons {{ target refraction on collect off }} }}
         plane {{ y, 0 pigment {{ rgb 1 }} finish {{ diffuse 1 ambient 0 }} }}"
    )
}

const PANE: &str = "box { <-1, 5, -1>, <1, 5.1, 1>";

/// A pane that does not refract changes nothing: its photons have the energy of the light that they replace.
#[test]
fn photons_through_a_pane_carry_the_energy_of_the_direct_light() {
    let lights =
        ["", "spotlight radius 10 falloff 15 point_at 0", "parallel point_at 0", "fade_distance 5 fade_power 2"];
    for light in lights {
        let caustic = mean(&picture(&scene("spacing 0.02 radius 0.2", light, PANE, 1.0)));
        let direct = scene("spacing 0.02", light, PANE, 1.0).replace("target refraction on", "");
        is_near(caustic, mean(&picture(&direct)), 0.03);
    }
}

/// A sphere of radius r at the distance d intercepts the solid angle π·r²/d² of a light; all of it reaches the plane at the
/// distance D, with the energy C·D²·π·r²/d²: light without `fade_distance` does not weaken on its way.
#[test]
fn a_lens_keeps_the_energy_of_the_light() {
    let mask = "difference { plane { y, 5.2 } cylinder { 4*y, 6*y, 0.61 } plane { y, 4.8 } pigment { rgb 0 }
                finish { ambient 0 diffuse 0 } photons { collect off } }";
    let lens = scene("spacing 0.01", "", "sphere { 5*y, 0.6", 1.1).replace("rgb 0.2", "rgb 0.005") + mask;
    let frame = draw(&lens.replace("right 8*x up 8*z", "right 4*x up 4*z"), &RenderOptions::new(160, 160)).0;
    let energy = mean(&frame) * 16.0;
    is_near(energy, 0.005 * std::f64::consts::PI * 0.36 * 100.0 / 25.0, 0.08);
}

/// POV-Ray's mean of the same scenes; both programs place photons in their own ways.
#[test]
fn caustics_are_as_bright_as_pov_rays() {
    for (photons, light, target, ior, pov) in [
        ("spacing 0.05", "", PANE, 1.0, 0.20374),
        ("spacing 0.1", "", PANE, 1.0, 0.20652),
        ("spacing 0.05 radius 0.5", "", PANE, 1.0, 0.19202),
        ("spacing 0.05 gather 5, 20", "", PANE, 1.0, 0.20015),
        ("spacing 0.02", "cylinder radius 0.5 falloff 0.7 point_at 0", PANE, 1.0, 0.00381),
        ("spacing 0.02", "area_light x, z, 3, 3 photons { area_light }", PANE, 1.0, 0.19310),
    ] {
        is_near(mean(&picture(&scene(photons, light, target, ior))), pov, 0.04);
    }
}

#[test]
fn threads_and_regions_do_not_change_a_byte() {
    let text = scene("spacing 0.05 media 20", "", "sphere { 5*y, 1", 1.3)
        + "box { <-2, 0.5, -2>, <2, 1.5, 2> hollow pigment { rgbt 1 } interior { media { scattering { 1, 0.1 } } } }";
    is_independent_of_threads_and_region(&text, 40, 40);
}

#[test]
fn light_without_a_target_stays_as_it_is() {
    for change in ["refraction on", "target refraction off", "target reflection on refraction off"] {
        let text = scene("spacing 0.05", "", PANE, 1.0).replace("target refraction on", change);
        let none = scene("spacing 0.05", "", PANE, 1.0).replace("target refraction on", "");
        assert_eq!(picture(&text).pixels, picture(&none).pixels, "{change}");
    }
}

/// A light with `media_interaction off` lights media by its photons, and by them alone (W0413).
#[test]
fn photons_light_media_without_interaction() {
    let scene = |photons: &str| {
        let object = "interior { media { scattering { 1, 0.1 } } }";
        format!(
            "global_settings {{ photons {{ spacing 0.1 {photons} }} }} camera {{ location -5*z }}\n\
             light_source {{ -9*x, 1 media_interaction off photons {{ refraction on }} }}\n\
             sphere {{ 0, 1 hollow pigment {{ rgbt 1 }} {object} photons {{ target refraction on }} }}\n"
        )
    };
    let scratch = Scratch::new();
    for (photons, is_warned) in [("media 100", false), ("", true)] {
        scratch.put("mist.scene", scene(photons));
        let (_, err) = scratch.exits(0, "render mist.scene --size 4x3");
        assert_eq!(err.contains("W0413"), is_warned, "{photons}: {err}");
    }
}
