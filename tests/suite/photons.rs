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

/// A sphere that bends photons, in place of [`PANE`].
const LENS: &str = "sphere { 5*y, 0.6";

/// Settings of the photons, target, refractive index, edits and end of a scene, and the mean of POV-Ray's picture.
type Case<'a> = (&'a str, &'a str, f64, &'a [(&'a str, &'a str)], &'a str, f64);

/// Returns a scene with the texts of `edits` replaced.
fn edited(mut text: String, edits: &[(&str, &str)]) -> String {
    for (from, to) in edits {
        assert!(text.contains(from), "{from}");
        text = text.replace(from, to);
    }
    text
}

/// Means that POV-Ray draws, of scenes for the quirks of photons (`src/quirks/light.rs`).
#[test]
fn unusual_photons_are_as_bright_as_pov_rays() {
    let below = |word: &str| {
        format!("box {{ <-1, 3, -1>, <1, 3.1, 1> pigment {{ rgb 1 }} finish {{ ambient 0 diffuse 0 }} {word} }}")
    };
    let above = |t: f64| {
        format!(
            "box {{ <-2, 7, -2>, <2, 7.1, 2> pigment {{ rgbt {t} }} finish {{ ambient 0 diffuse 0 }} photons {{ pass_through }} }}"
        )
    };
    let finish = "diffuse 1 ambient 0 }";
    let tilted = |slope: u32| {
        format!(
            "{finish} normal {{ gradient x slope_map {{ [0 <0, {slope}>][1 <{slope}, {slope}>] }} scale 10 translate -5*x }}"
        )
    };
    let group_of_light = "light_group { light_source { 10*y, rgb 0.2 photons { refraction on }";
    let cases: &[Case] = &[
        // Photons pass objects that cast no shadow or are not in the picture
        ("spacing 0.05", PANE, 1.0, &[], &below("no_image"), 0.20374),
        ("spacing 0.05", PANE, 1.0, &[], &below("no_shadow"), 0.20374),
        // Such objects are no targets
        ("spacing 0.05", PANE, 1.0, &[("photons { target", "no_image photons { target")], "", 0.19038),
        ("spacing 0.05", LENS, 1.1, &[("photons { target", "no_shadow photons { target")], "", 0.19038),
        // Objects with `pass_through` filter photons, opaque ones stop them
        ("spacing 0.05", PANE, 1.0, &[], &above(0.7), 0.09984),
        ("spacing 0.05", PANE, 1.0, &[], &above(0.0), 0.0),
        // The back of a surface
        (
            "spacing 0.05",
            PANE,
            1.0,
            &[("location 2*y", "location -2*y"), (finish, "diffuse 1, 0.1 ambient 0 }")],
            "",
            0.07578,
        ),
        (
            "spacing 0.05",
            PANE,
            1.0,
            &[("location 2*y", "location -2*y"), (finish, "diffuse 0.1 ambient 0 } double_illuminate")],
            "",
            0.07578,
        ),
        // Bumps, which tilt the plane of the estimate
        ("spacing 0.05", PANE, 1.0, &[(finish, &tilted(1))], "", 0.18191),
        ("spacing 0.05 radius 0.5", PANE, 1.0, &[(finish, &tilted(8))], "", 0.14431),
        // Light groups: the floor, the target, the target with global lights, and all together
        ("spacing 0.05", PANE, 1.0, &[("plane { y, 0 ", "light_group { plane { y, 0 ")], "}", 0.06271),
        ("spacing 0.05", PANE, 1.0, &[("box { <-1", "light_group { box { <-1"), ("off } }", "off } } }")], "", 0.19038),
        (
            "spacing 0.05",
            PANE,
            1.0,
            &[("box { <-1", "light_group { box { <-1"), ("off } }", "off } } global_lights on }")],
            "",
            0.20374,
        ),
        ("spacing 0.05", PANE, 1.0, &[("light_source { 10*y, rgb 0.2 ", group_of_light)], "}", 0.19038),
        // A reflection of a half has a weight of a quarter
        (
            "spacing 0.05 adc_bailout 0.1",
            PANE,
            1.0,
            &[
                ("ambient 0 diffuse 0 }", "ambient 0 diffuse 0 reflection 0.5 }"),
                ("target refraction on", "target refraction on reflection on"),
            ],
            "",
            0.20259,
        ),
        // Light that coloured glass reflects inside is attenuated
        (
            "spacing 0.05",
            PANE,
            1.0,
            &[
                ("ambient 0 diffuse 0 }", "ambient 0 diffuse 0 reflection 0.5 }"),
                ("target refraction on", "target refraction on reflection on"),
                ("ior 1 }", "ior 1 fade_power 1001 fade_distance 0.1 fade_color 0.2 }"),
            ],
            "",
            0.16953,
        ),
        // Two surfaces of a pane that does not bend light are two levels; POV-Ray lights a scene without photons as usual
        ("spacing 0.05 max_trace_level 2", PANE, 1.0, &[], "", 0.19038),
        ("spacing 0.05 max_trace_level 3", PANE, 1.0, &[], "", 0.20374),
        // A surface without photons is lit through the target; one without diffuse light shows photons by its highlights
        ("spacing 0.05", LENS, 1.1, &[(finish, "diffuse 1 ambient 0 } photons { collect off }")], "", 0.19038),
        ("spacing 0.05", PANE, 1.0, &[(finish, "diffuse 0 ambient 0 phong 1 phong_size 1 }")], "", 0.20374),
    ];
    for (photons, target, ior, edits, more, pov) in cases {
        let text = edited(scene(photons, "", target, *ior), edits) + more;
        let mean = mean(&picture(&text));
        assert!((mean - pov).abs() <= 0.025 * pov, "{edits:?} {more}: {mean} instead of {pov}");
    }
}

/// The beam of photons through a small pane in a medium: means of POV-Ray's pictures, and the share of lit pixels, which
/// shows the radius of the estimates.
#[test]
fn beams_in_media_are_as_bright_and_wide_as_pov_rays() {
    let medium = "box { <-4, -2, -2>, <4, 2, 2> hollow pigment { rgbt 1 } interior { media { scattering { 1, 0.02 extinction 0 } } } }";
    for (radius, height, pov_mean, pov_share) in [
        ("", "10", 0.14052, 0.902),
        ("radius 0.5 1 0.3", "10", 0.12032, 0.468),
        ("radius ,1,0.5", "10", 0.13272, 0.632),
        ("radius 0.5 1 0.3", "100", 0.02993, 0.351),
    ] {
        let of_light = format!("light_source {{ {height}*y, rgb 20 photons {{ refraction on }} media_interaction off ");
        let edits = [
            ("plane { y, 0 pigment { rgb 1 } finish { diffuse 1 ambient 0 } }", medium),
            ("light_source { 10*y, rgb 0.2 ", &of_light),
            ("location 2*y look_at 0 right 8*x up 8*z", "location -9*z look_at 0 right 4*x up 4*y"),
        ];
        let photons = format!("spacing 0.05 media 50 {radius}");
        let frame = picture(&edited(scene(&photons, "", "box { <-.2, 5, -.2>, <.2, 5.1, .2>", 1.0), &edits));
        let brightest = frame.pixels.iter().map(|pixel| pixel[0]).fold(0.0, f32::max);
        let lit = frame.pixels.iter().filter(|pixel| pixel[0] > 0.01 * brightest).count();
        let share = lit as f64 / frame.pixels.len() as f64;
        is_near(mean(&frame), pov_mean, 0.08);
        assert!((share - pov_share).abs() < 0.04, "{radius}: {share} instead of {pov_share}");
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
