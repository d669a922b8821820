//! The light model, compared with closed forms (POV-Ray's manual, "Finish", "Interior") and with POV-Ray 3.7's output.

use crate::scene_builder::*;
use durer::atmosphere::Background;
use durer::color::Gamma;
use durer::color::{Color, Rgb};
use durer::math::DVec3;
use durer::medium::Interior;
use durer::render::Options;
use durer::scene::Scene;
use durer::texture::{Finish, Pigment, Reflection};

/// A wall at z = 0, seen perpendicularly.
fn wall(color: Color, finish: Finish, others: Vec<durer::scene::Object>) -> Scene {
    let wall = plane(-Z, 0.0).painted(color, finish);
    scene(-5.0 * Z, Z, [vec![wall], others].concat())
}

fn mirror(amount: f64) -> Finish {
    let reflection = Reflection { min: Rgb::splat(amount), max: Rgb::splat(amount), ..Reflection::default() };
    Finish { reflection: reflection.into(), ..dull() }
}

const CLEAR: Color = Color { rgb: Rgb::ONE, filter: 0.0, transmit: 1.0 };

#[test]
fn lambert() {
    // default finish: ambient 0.1, diffuse 0.6
    let straight = scene(
        DVec3::ZERO,
        Z,
        vec![sphere(5.0 * Z, 1.0).painted(rgb(1.0, 0.5, 0.2), Finish::default()), lamp(DVec3::ZERO, 1.0)],
    );
    assert_near(look(&straight), [0.7, 0.35, 0.14]);
    // light from 60° off: cos = 1/2, brilliance 2: 1/4
    let lit_from = |finish| wall(rgb(1.0, 1.0, 1.0), finish, vec![lamp(v(0.0, 3f64.sqrt(), -1.0), 1.0)]);
    assert_gray(&lit_from(Finish::default()), 0.1 + 0.6 * 0.5);
    assert_gray(&lit_from(Finish { brilliance: 2.0, ..Finish::default() }), 0.1 + 0.6 * 0.25);
    assert_gray(
        &lit_from(Finish { brilliance: 2.0, diffuse_albedo: true, ..Finish::default() }),
        0.1 + 0.6 * 0.25 * 1.5,
    );
}

#[test]
fn ambient_and_emission() {
    let finish = Finish { ambient: Rgb::splat(0.2), emission: Rgb::new(0.1, 0.0, 0.3), ..dull() };
    let mut scene = wall(rgb(0.5, 0.5, 0.5), finish, vec![]);
    scene.settings.ambient_light = Rgb::new(1.0, 2.0, 0.0);
    assert_near(look(&scene), [0.5 * 0.3, 0.5 * 0.4, 0.5 * 0.3]);
}

#[test]
fn light_from_behind() {
    let behind = |finish| wall(rgb(0.5, 0.5, 0.5), finish, vec![lamp(v(0.0, 3.0, 3.0), 1.0)]);
    let back = Finish { diffuse: 0.5, diffuse_back: 0.3, phong: 1.0, ..dull() };
    let cos = 0.5f64.sqrt();
    assert_gray(&behind(back.clone()), 0.5 * 0.3 * cos);
    assert_gray(&behind(Finish { diffuse_back: 0.0, ..back.clone() }), 0.0);
    // `double_illuminate` takes the front's diffuse and no highlight
    let mut both = behind(back);
    both.objects[0].uncommon.flags.double_illuminate = true;
    assert_gray(&both, 0.5 * 0.5 * cos);
}

#[test]
fn highlights() {
    // light 30° off the mirrored ray, so 15° between normal and half-way vector
    let at = v(0.0, 30f64.to_radians().tan(), -1.0) * 4.0;
    let lit = |finish| wall(rgb(0.2, 0.4, 0.6), finish, vec![lamp(at, 1.0)]);
    let phong = 0.5 * 30f64.to_radians().cos().powi(10);
    assert_gray(&lit(Finish { phong: 0.5, phong_size: 10.0, ..dull() }), phong);
    assert_gray(&lit(Finish { phong: 0.5, phong_size: 10.0, phong_albedo: true, ..dull() }), phong * 5.5);
    let specular = 0.5 * 15f64.to_radians().cos().powi(20);
    assert_gray(&lit(Finish { specular: 0.5, ..dull() }), specular);
    // seen perpendicularly, metal has the colour of its pigment, apart from F(0) = 0
    let straight = wall(rgb(0.2, 0.4, 0.6), Finish { phong: 0.5, metallic: 1.0, ..dull() }, vec![lamp(-3.0 * Z, 1.0)]);
    assert_near(look(&straight), [0.1, 0.2, 0.3]);
    let mut shadowless = lit(Finish { specular: 0.5, ..dull() });
    set_light(&mut shadowless, |light| light.shadowless = true);
    assert_gray(&shadowless, 0.0);
}

fn set_light(scene: &mut Scene, change: impl Fn(&mut durer::light::Light)) {
    for object in &mut scene.objects {
        if let durer::scene::ObjectKind::Light(light) = &mut object.kind {
            change(&mut std::sync::Arc::make_mut(light).light);
        }
    }
}

#[test]
fn fading_and_negative_lights() {
    let mut faded = wall(rgb(1.0, 1.0, 1.0), Finish { diffuse: 0.4, ..dull() }, vec![lamp(-4.0 * Z, 1.0)]);
    set_light(&mut faded, |light| (light.fade_distance, light.fade_power) = (2.0, 3.0));
    // 2/(1 + (4/2)³)
    assert_gray(&faded, 0.4 * 2.0 / 9.0);
    let two = vec![lamp(-4.0 * Z, 1.0), lamp(-4.0 * Z, -0.25)];
    assert_gray(&wall(rgb(1.0, 1.0, 1.0), Finish { diffuse: 0.4, ..dull() }, two), 0.3);
}

#[test]
fn filter_and_transmit() {
    // a pane before a glowing wall: its own light, and the transmitted light
    let pane = disc(-2.0 * Z, Z, 1.0).painted(rgbft([0.2, 0.4, 0.6, 0.5, 0.25]), glowing());
    let seen = look(&wall(rgb(1.0, 0.5, 0.25), glowing(), vec![pane]));
    let expected = |p: f64, behind: f64| 0.25 * p + (0.5 * p + 0.25) * behind;
    assert_near(seen, [expected(0.2, 1.0), expected(0.4, 0.5), expected(0.6, 0.25)]);
}

#[test]
fn shadows_through_layers() {
    let tint = rgbft([0.9, 0.6, 0.3, 0.5, 0.4]);
    let pass = DVec3::new(0.5 * 0.9 + 0.4, 0.5 * 0.6 + 0.4, 0.5 * 0.3 + 0.4);
    for layers in 0..5 {
        // discs across the line to the lamp, beside the line of sight
        let to_lamp = v(0.0, 1.0, -1.0);
        let mut things = vec![lamp(to_lamp * 10.0, 1.0)];
        things.extend((0..layers).map(|i| disc(to_lamp * (3.0 + f64::from(i)), to_lamp, 1.0).painted(tint, dull())));
        let scene = wall(rgb(1.0, 1.0, 1.0), Finish { diffuse: 1.0, ..dull() }, things);
        let cos = 0.5f64.sqrt();
        assert_near(look(&scene), pass.to_array().map(|p| cos * p.powi(layers)));
    }
    // a solid has two surfaces; opaque ones, and ones without shadow
    let with = |ball: durer::scene::Object| {
        wall(rgb(1.0, 1.0, 1.0), Finish { diffuse: 1.0, ..dull() }, vec![lamp(v(0.0, 8.0, -8.0), 1.0), ball])
    };
    let ball = sphere(v(0.0, 4.0, -4.0), 1.0);
    assert_gray(&with(ball.clone().painted(rgbft([1.0, 1.0, 1.0, 0.0, 0.5]), dull())), 0.25 * 0.5f64.sqrt());
    assert_gray(&with(ball.clone().painted(rgb(1.0, 1.0, 1.0), dull())), 0.0);
    let mut ghost = ball.painted(rgb(1.0, 1.0, 1.0), dull());
    ghost.uncommon.flags.no_shadow = true;
    assert_gray(&with(ghost), 0.5f64.sqrt());
}

#[test]
fn mirrors() {
    let mut scene = wall(rgb(1.0, 1.0, 1.0), mirror(0.4), vec![plane(Z, -9.0).painted(rgb(0.5, 0.2, 1.0), glowing())]);
    assert_near(look(&scene), [0.2, 0.08, 0.4]);
    scene.objects[1].uncommon.flags.no_reflection = true;
    assert_gray(&scene, 0.0);
    // an exponent changes the reflected light
    let mut finish = mirror(0.4);
    finish.reflection.exponent = 2.0;
    let scene = wall(rgb(1.0, 1.0, 1.0), finish, vec![plane(Z, -9.0).painted(rgb(0.25, 0.25, 0.25), glowing())]);
    assert_gray(&scene, 0.4 * 0.5);
}

#[test]
fn fresnel_mirror() {
    let reflection = Reflection { max: Rgb::ONE, fresnel: true, ..Reflection::default() };
    let glass = cuboid(v(-9.0, -9.0, 0.0), v(9.0, 9.0, 1.0))
        .painted(rgb(0.0, 0.0, 0.0), Finish { reflection: reflection.into(), ..dull() })
        .filled(1.5);
    let behind = plane(Z, -9.0).painted(rgb(1.0, 1.0, 1.0), glowing());
    // ((n - 1)/(n + 1))²
    assert_gray(&scene(-5.0 * Z, Z, vec![glass, behind]), 0.04);
}

#[test]
fn levels_of_mirrors() {
    // two facing mirrors that glow: g·(1 + r + r² + …) with as many terms as the level allows
    let finish = Finish { ambient: Rgb::splat(0.3), ..mirror(0.5) };
    for level in [1, 2, 5, 9] {
        let faces = [plane(Z, 1.0), plane(-Z, 1.0)].map(|p| p.painted(rgb(1.0, 1.0, 1.0), finish.clone()));
        let mut scene = scene(DVec3::ZERO, Z, faces.into());
        scene.settings.max_trace_level = level;
        scene.settings.adc_bailout = 0.0;
        let sum: f64 = (0..level as i32).map(|k| 0.3 * 0.5f64.powi(k)).sum();
        assert_gray(&scene, sum);
    }
}

#[test]
fn adc_bailout_drops_rays() {
    let seen = |amount: f64, bailout: f64| {
        let mut scene =
            wall(rgb(1.0, 1.0, 1.0), mirror(amount), vec![plane(Z, -9.0).painted(rgb(1.0, 1.0, 1.0), glowing())]);
        scene.settings.adc_bailout = bailout;
        look(&scene)[0]
    };
    assert_near([seen(0.31, 0.3), seen(0.29, 0.3), seen(0.5, 0.5)], [0.31, 0.0, 0.0]);
    // a mirror that depends on the angle counts by its larger number: its reflectance is 0 here, but the ray is cast
    let finish = |max: f64| {
        let reflection = Reflection { max: Rgb::splat(max), ..Reflection::default() };
        Finish { reflection: reflection.into(), ..dull() }
    };
    let cast = |max: f64| {
        let mut scene = wall(rgb(1.0, 1.0, 1.0), finish(max), vec![]);
        scene.settings.adc_bailout = 0.3;
        draw(&scene, &Options::new(1, 1)).1.reflected
    };
    assert_eq!([cast(0.31), cast(0.29)], [1, 0]);
}

#[test]
fn unrefracted_rays_keep_their_level() {
    // ten panes without refraction, with a level of 2
    let mut panes: Vec<_> = (0..10).map(|i| plane(Z, f64::from(i)).painted(CLEAR, dull())).collect();
    panes.push(plane(Z, 20.0).painted(rgb(0.5, 0.5, 0.5), glowing()));
    let mut scene = scene(-5.0 * Z, Z, panes);
    scene.settings.max_trace_level = 2;
    assert_gray(&scene, 0.5);
    scene.settings.max_trace_level = 1;
    assert_gray(&scene, 0.0);
}

/// A ramp of brightness along y from 0 at 0 to 1 at 100, on the plane z = 10.
fn ruler() -> durer::scene::Object {
    use durer::pattern::{FieldPattern, Gradient, Kind, Pattern, Space};
    use durer::texture::{ColorMap, Paint};
    let kind = Kind::Field(FieldPattern::Gradient(Gradient { direction: Y }));
    let map = ColorMap { entries: vec![(0.0, Color::BLACK), (1.0, Color::WHITE)] };
    let transform = durer::math::Transform::scale(DVec3::splat(100.0)).unwrap();
    let pattern =
        Pattern { kind, space: Space { transform: transform.into(), ..Space::default() }, ..Pattern::default() };
    let pigment =
        Pigment { pattern: pattern.into(), paint: Paint::Colors(std::sync::Arc::new(map)), quick_color: None };
    plane(-Z, -10.0).textured(texture([(pigment, glowing())]))
}

#[test]
fn snell() {
    // through a slab of glass from z = 0 to 2, entering at (0, 50, 0) at 45°
    let (n, angle) = (1.5, 45f64.to_radians());
    let dir = v(0.0, angle.sin(), angle.cos());
    let slab = cuboid(v(-99.0, -99.0, 0.0), v(99.0, 199.0, 2.0)).painted(CLEAR, dull()).filled(n);
    let mut scene = scene(v(0.0, 50.0, 0.0) - dir * 3.0, dir, vec![slab, ruler()]);
    let inner = (angle.sin() / n).asin();
    assert_near(look(&scene), [(50.0 + 2.0 * inner.tan() + 8.0 * angle.tan()) / 100.0; 3]);
    // without refraction
    scene.objects[0].uncommon.interior = None;
    assert_near(look(&scene), [(50.0 + 10.0 * angle.tan()) / 100.0; 3]);
    // starting inside the glass
    let inside = crate::scene_builder::scene(v(0.0, 50.0, 1.0), dir, {
        let slab = cuboid(v(-99.0, -99.0, 0.0), v(99.0, 199.0, 2.0)).painted(CLEAR, dull()).filled(1.2);
        vec![slab, ruler()]
    });
    let outer = (angle.sin() * 1.2).asin();
    assert_near(look(&inside), [(50.0 + 1.0 + 8.0 * outer.tan()) / 100.0; 3]);
}

#[test]
fn total_reflection() {
    // a prism: perpendicularly through z = 0, reflected at the slope inside at 45°, out through the bottom
    let prism = |ior: f64| {
        let solid = csg(
            durer::scene::CsgOp::Intersection,
            vec![cuboid(DVec3::splat(-1.0), DVec3::splat(1.0)), plane(v(0.0, 1.0, 1.0), 0.5)],
        );
        // total reflection loses nothing, even at a surface that transmits half
        let pane = rgbft([1.0, 1.0, 1.0, 0.0, 0.5]);
        let prism = solid.painted(pane, dull()).filled(ior);
        let floor = plane(Y, -5.0).painted(rgb(0.8, 0.8, 0.8), glowing());
        let wall = plane(-Z, -9.0).painted(rgb(0.2, 0.2, 0.2), glowing());
        crate::scene_builder::scene(-5.0 * Z, Z, vec![prism, floor, wall])
    };
    // the pane transmits half on the way in and on the way out
    assert_gray(&prism(1.5), 0.25 * 0.8);
    assert_gray(&prism(1.0), 0.25 * 0.2);
}

#[test]
fn layered_textures() {
    // As in POV-Ray 3.7, the lower layer's light and highlights count for the transmittance of the top layer, its
    // reflection counts fully, and `adc_bailout` applies to both reflections together.
    let below = (
        Pigment::solid(rgb(0.5, 0.25, 0.1)),
        Finish { ambient: Rgb::splat(0.1), diffuse: 0.4, phong: 0.2, phong_size: 1.0, ..dull() },
    );
    let above = (
        Pigment::solid(rgbft([0.2, 0.4, 0.6, 0.0, 0.5])),
        Finish { ambient: Rgb::splat(0.3), diffuse: 0.1, phong: 0.1, phong_size: 1.0, ..dull() },
    );
    let wall = |layers: [(Pigment, Finish); 2], other| {
        scene(-5.0 * Z, Z, vec![plane(-Z, 0.0).textured(texture(layers)), other])
    };
    assert_near(look(&wall([below, above], lamp(-10.0 * Z, 1.0))), [0.365, 0.3425, 0.345]);
    let behind = || plane(Z, -20.0).painted(rgb(1.0, 1.0, 1.0), glowing());
    let pane = Pigment::solid(rgbft([0.2, 0.4, 0.6, 0.0, 0.5]));
    let mirrors = [(Pigment::solid(rgb(0.5, 0.25, 0.1)), mirror(0.2)), (pane, mirror(0.1))];
    let mut both = wall(mirrors, behind());
    assert_gray(&both, 0.3);
    both.settings.adc_bailout = 0.05;
    assert_gray(&both, 0.3);
    both.settings.adc_bailout = 0.15;
    assert_gray(&both, 0.0);
    // both layers transmit light
    let panes = [rgbft([0.5, 0.25, 0.1, 0.0, 0.5]), rgbft([0.2, 0.4, 0.6, 0.5, 0.0])];
    let glass =
        wall(panes.map(|c| (Pigment::solid(c), dull())), plane(-Z, -5.0).painted(rgb(1.0, 1.0, 1.0), glowing()));
    assert_near(look(&glass), [0.05, 0.1, 0.15]);
}

#[test]
fn gammas() {
    let seen = |gamma: Gamma, value: f64| {
        let mut scene = wall(rgb(value, value, value), glowing(), vec![]);
        scene.settings.gamma = Some(gamma);
        look(&scene)[0]
    };
    assert_near([seen(Gamma::Power(2.0), 0.5), seen(Gamma::Power(1.0), 0.3)], [0.25, 0.3]);
    let decoded = ((0.5f64 + 0.055) / 1.055).powf(2.4);
    assert_near([seen(Gamma::Srgb, 0.5), seen(Gamma::Raw, 0.5)], [decoded, decoded]);
    assert_near([seen(Gamma::Power(2.2), -0.5)], [0.0]);
    // the blend is computed in the numbers of the scene: half through glass, then squared
    let pane = disc(-2.0 * Z, Z, 1.0).painted(rgbft([0.0, 0.0, 0.0, 0.0, 0.5]), dull());
    let mut scene = wall(rgb(1.0, 1.0, 1.0), glowing(), vec![pane]);
    scene.settings.gamma = Some(Gamma::Power(2.0));
    assert_gray(&scene, 0.25);
}

#[test]
fn alpha() {
    let seen = |color: [f64; 5], finish: Finish| {
        let scene = scene(-5.0 * Z, Z, vec![plane(Z, 0.0).painted(rgbft(color), finish)]);
        look_with(&scene, |o| o.alpha = true)
    };
    let alpha = 1.0 - 0.5 * (0.297 * 0.8 + 0.589 * 0.4 + 0.114 * 0.2);
    assert_near(seen([0.8, 0.4, 0.2, 0.5, 0.0], glowing()), [0.4 / alpha, 0.2 / alpha, 0.1 / alpha, alpha]);
    assert_near(seen([1.0, 1.0, 1.0, 0.0, 0.0], glowing()), [1.0; 4]);
    let empty = scene(-5.0 * Z, Z, vec![]);
    assert_near(look_with(&empty, |o| o.alpha = true), [0.0; 4]);
    assert_near(look_with(&empty, |_| {}), [0.0, 0.0, 0.0, 1.0]);
    let mut half = empty;
    half.background = Some(Background { color: rgbft([0.4, 0.4, 0.4, 0.0, 0.25]), by_picture: false });
    assert_near(look_with(&half, |_| {}), [0.3, 0.3, 0.3, 1.0]);
    // Mirrors reflect the background fully where the picture keeps alpha, as in POV-Ray 3.7.
    half.objects = vec![plane(Z, 0.0).painted(rgb(0.0, 0.0, 0.0), mirror(0.5))];
    assert_near(look_with(&half, |o| o.alpha = true), [0.2, 0.2, 0.2, 1.0]);
    assert_near(look_with(&half, |_| {}), [0.15, 0.15, 0.15, 1.0]);
}

#[test]
fn attenuation_lowers_alpha() {
    // half of the light after the length of the path: 1/(1 + (2/2)³) (POV-Ray 3.7: alpha 0.5, and 0.8 before a
    // background of transmit 0.4)
    let interior = Interior { fade_distance: 2.0, fade_power: 3.0, ..Interior::default() };
    let mut glass = sphere(DVec3::ZERO, 1.0).painted(CLEAR, dull());
    glass.uncommon.interior = Some(std::sync::Arc::new(interior));
    let mut scene = scene(-5.0 * Z, Z, vec![glass]);
    assert_near(look_with(&scene, |o| o.alpha = true), [0.0, 0.0, 0.0, 0.5]);
    scene.background = Some(Background { color: rgbft([1.0, 0.8, 0.3, 0.0, 0.4]), by_picture: false });
    assert_near(look_with(&scene, |o| o.alpha = true), [0.375, 0.3, 0.1125, 0.8]);
}

#[test]
fn qualities() {
    let pane = disc(-2.0 * Z, Z, 1.0)
        .painted(rgbft([0.5, 0.5, 0.5, 0.0, 0.5]), Finish { ambient: Rgb::splat(0.2), ..mirror(0.5) });
    let back = plane(Z, -9.0).painted(rgb(1.0, 1.0, 1.0), glowing());
    let scene = wall(rgb(1.0, 1.0, 1.0), glowing(), vec![pane, back]);
    let at = |q| look_with(&scene, |o| o.quality = q)[0];
    // the pigment; the diffuse light; the transmitted light; the reflected light
    let through = 0.5 * 0.5 * 0.2 + 0.5;
    assert_near([at(1), at(3), at(7), at(9)], [0.5, 0.05, through, through + 0.5]);
    let dark = wall(rgb(1.0, 1.0, 1.0), Finish::default(), vec![lamp(-8.0 * Z, 1.0), sphere(-7.0 * Z, 0.5)]);
    let at = |q| look_with(&dark, |o| o.quality = q)[0];
    assert_near([at(3), at(4)], [0.7, 0.1]);
}

#[test]
fn adc_bailout_uses_largest_channel_and_gray() {
    let seen = |panes: &[[f64; 3]], bailout: f64| {
        let pane = |(i, c): (usize, &[f64; 3])| {
            disc(-(2.0 + i as f64) * Z, Z, 1.0).painted(rgbft([c[0], c[1], c[2], 1.0, 0.0]), dull())
        };
        let mut scene = wall(rgb(1.0, 1.0, 1.0), glowing(), panes.iter().enumerate().map(pane).collect());
        scene.settings.adc_bailout = bailout;
        look(&scene)
    };
    let (a, b) = ([0.5, 0.1, 0.1], [0.1, 0.5, 0.1]);
    // the gray of the first is 0.2188
    assert_near(seen(&[a], 0.218), a);
    assert_near(seen(&[a], 0.22), [0.0; 3]);
    // 0.5³, though no channel of the whole is more than 0.025
    assert_near(seen(&[a, b, a], 0.124), [0.025, 0.005, 0.001]);
    assert_near(seen(&[a, b, a], 0.126), [0.0; 3]);
    assert_near(seen(&[[1.0, 0.0, 0.0]; 4], 0.29), [1.0, 0.0, 0.0]);
}

#[test]
fn crand_darkens_other_terms() {
    // POV-Ray's mean over many pixels is 0.5488, its minimum 0.1
    let finish = Finish { ambient: Rgb::splat(0.5), diffuse: 0.5, crand: 0.9, ..dull() };
    let (picture, _) = draw(&wall(rgb(1.0, 1.0, 1.0), finish, vec![lamp(-5.0 * Z, 1.0)]), &Options::new(40, 40));
    let mean = picture.pixels.iter().map(|p| f64::from(p[0])).sum::<f64>() / 1600.0;
    let darkest = picture.pixels.iter().map(|p| p[0]).fold(f32::INFINITY, f32::min);
    assert!((mean - 0.54).abs() < 0.03 && (0.05..0.15).contains(&darkest), "{mean} {darkest}");
}

#[test]
fn crand_ignores_opacity() {
    // 0.3 - 0.4·u, clamped at 0: POV-Ray's mean over many pixels is 0.1123, and a share of 0.249 is black
    let finish = Finish { ambient: Rgb::splat(0.1), diffuse: 0.5, crand: 0.4, ..dull() };
    let glass = rgbft([1.0, 1.0, 1.0, 0.0, 0.5]);
    let (picture, _) = draw(&wall(glass, finish, vec![lamp(-5.0 * Z, 1.0)]), &Options::new(40, 40));
    let mean = picture.pixels.iter().map(|p| f64::from(p[0])).sum::<f64>() / 1600.0;
    let black = picture.pixels.iter().filter(|p| p[0] <= 0.0).count() as f64 / 1600.0;
    assert!((mean - 0.1125).abs() < 0.01 && (black - 0.25).abs() < 0.04, "{mean} {black}");
}
