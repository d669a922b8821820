//! Photons: energy in closed form, brightness beside POV-Ray's, the same bytes for any number of threads and any region.

use durer::image_io::Frame;
use durer::interpreter;
use durer::render::{Options, Region, Unwatched, render};
use durer::source::{Sandbox, SearchPath, Sources};

/// Returns the picture of a scene, 40 × 40 pixels by default.
fn picture(text: &str, change: impl FnOnce(&mut Options) + Send) -> Frame {
    durer::on_big_stack(|| {
        let sources = Sources::default();
        let file = sources.add("scene", None, text.to_string()).unwrap();
        let options = interpreter::Options {
            sandbox: Sandbox::read_only(),
            search: SearchPath { folders: vec![], fonts: vec![] },
            size: (40, 40),
            ..interpreter::Options::default()
        };
        let scene = interpreter::interpret(&sources, file, &options, &mut |_| {}).scene.expect("a scene");
        let world = durer::world::lower(&scene).unwrap();
        let mut options = Options::new(40, 40);
        change(&mut options);
        render(&world, &options, &Unwatched).unwrap().0
    })
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

fn mean(frame: &Frame) -> f64 {
    frame.pixels.iter().map(|pixel| f64::from(pixel[0])).sum::<f64>() / frame.pixels.len() as f64
}

#[track_caller]
fn is_near(found: f64, expected: f64, tolerance: f64) {
    assert!((found / expected - 1.0).abs() < tolerance, "{found}, expected {expected}");
}

/// A pane that does not refract changes nothing: its photons have the energy of the light that they replace.
#[test]
fn photons_through_a_pane_carry_the_energy_of_the_direct_light() {
    let lights =
        ["", "spotlight radius 10 falloff 15 point_at 0", "parallel point_at 0", "fade_distance 5 fade_power 2"];
    for light in lights {
        let caustic = mean(&picture(&scene("spacing 0.02 radius 0.2", light, PANE, 1.0), |_| {}));
        let direct = scene("spacing 0.02", light, PANE, 1.0).replace("target refraction on", "");
        is_near(caustic, mean(&picture(&direct, |_| {})), 0.03);
    }
}

/// A sphere of radius r at the distance d intercepts the solid angle π·r²/d² of a light; all of it reaches the plane at the
/// distance D, with the energy C·D²·π·r²/d²: light without `fade_distance` does not weaken on its way.
#[test]
fn a_lens_keeps_the_energy_of_the_light() {
    let mask = "difference { plane { y, 5.2 } cylinder { 4*y, 6*y, 0.61 } plane { y, 4.8 } pigment { rgb 0 }
                finish { ambient 0 diffuse 0 } photons { collect off } }";
    let lens = scene("spacing 0.01", "", "sphere { 5*y, 0.6", 1.1).replace("rgb 0.2", "rgb 0.005") + mask;
    let frame = picture(&lens.replace("right 8*x up 8*z", "right 4*x up 4*z"), |options| {
        (options.width, options.height) = (160, 160);
    });
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
        is_near(mean(&picture(&scene(photons, light, target, ior), |_| {})), pov, 0.04);
    }
}

#[test]
fn threads_and_regions_do_not_change_a_byte() {
    let text = scene("spacing 0.05 media 20", "", "sphere { 5*y, 1", 1.3)
        + "box { <-2, 0.5, -2>, <2, 1.5, 2> hollow pigment { rgbt 1 } interior { media { scattering { 1, 0.1 } } } }";
    let whole = picture(&text, |_| {});
    for threads in [2, 7] {
        assert_eq!(picture(&text, |options| options.threads = threads).pixels, whole.pixels);
    }
    let part = picture(&text, |options| options.region = Some(Region { x: 7, y: 11, width: 20, height: 17 }));
    for y in 11..28 {
        assert_eq!(part.pixels[y * 40 + 7..y * 40 + 27], whole.pixels[y * 40 + 7..y * 40 + 27]);
    }
}

#[test]
fn light_without_a_target_stays_as_it_is() {
    for change in ["refraction on", "target refraction off", "target reflection on refraction off"] {
        let text = scene("spacing 0.05", "", PANE, 1.0).replace("target refraction on", change);
        let none = scene("spacing 0.05", "", PANE, 1.0).replace("target refraction on", "");
        assert_eq!(picture(&text, |_| {}).pixels, picture(&none, |_| {}).pixels, "{change}");
    }
}
