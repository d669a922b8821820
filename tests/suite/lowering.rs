//! Lowering of nested blocks; pictures that do not depend on threads, tiles or regions.

use crate::scene_builder::*;
use durer::atmosphere::Background;
use durer::color::{Color, Rgb};
use durer::diagnostic::codes;
use durer::math::{DVec3, Transform};
use durer::pattern::{CellPattern, Checker, Kind, Pattern};
use durer::render::{Cancelled, Options, Region, SampleLayout, Watch, pick, render};
use durer::scene::{CsgOp, Object, ObjectKind, Scene};
use durer::source::Span;
use durer::texture::{Blend, Finish, Paint, Pigment};
use durer::world::lower;
use std::sync::atomic::{AtomicUsize, Ordering};

fn scaled(x: f64, y: f64, z: f64) -> Transform {
    Transform::scale(v(x, y, z)).unwrap()
}

fn checker(a: Color, b: Color) -> Pigment {
    let pigments = vec![Pigment::solid(a), Pigment::solid(b)];
    let pattern = Pattern { kind: Kind::Cells(CellPattern::Checker(Checker {})), ..Pattern::default() };
    Pigment { pattern: pattern.into(), paint: Paint::Pigments(Blend::List(pigments.into())), quick_color: None }
}

#[test]
fn nested_transforms() {
    // a unit ball at x = 1, scaled by 2 in a union, moved by 3 in another, turned about z in the last one
    let ball = sphere(DVec3::ZERO, 1.0).moved(Transform::translate(X));
    let inner = csg(CsgOp::Union, vec![ball]).moved(scaled(2.0, 2.0, 2.0));
    let middle = csg(CsgOp::Merge, vec![inner]).moved(Transform::translate(3.0 * X));
    let outer = csg(CsgOp::Union, vec![middle]).moved(Transform::rotate(90.0 * Z));
    // its centre is at (0, 5, 0) and its radius 2
    let scene = scene(v(0.0, 5.0, -10.0), Z, vec![outer]);
    let seen = pick(&lower(&scene).unwrap(), &Options::new(1, 1), 0, 0).unwrap();
    assert_eq!(seen.shape, "sphere");
    assert_near([seen.t], [8.0]);
    assert_near(seen.point, [0.0, 5.0, -2.0]);
    assert_near(seen.normal, [0.0, 0.0, -1.0]);
}

#[test]
fn normals_under_uneven_scaling() {
    // x²/4 + y² + z² = 1: the normal at p is (x/4, y, z)
    let egg = sphere(DVec3::ZERO, 1.0).moved(scaled(2.0, 1.0, 1.0));
    let scene = scene(v(1.0, 0.0, -10.0), Z, vec![egg]);
    let seen = pick(&lower(&scene).unwrap(), &Options::new(1, 1), 0, 0).unwrap();
    let z = -(0.75f64.sqrt());
    assert_near(seen.point, [1.0, 0.0, z]);
    assert_near(seen.normal, v(0.25, 0.0, z).normalize().to_array());
}

/// 49 copies side by side, each with another rotation and size.
fn rows(thing: impl Fn() -> Object) -> Scene {
    let place = |i: i32| v(f64::from(i % 7 - 3) * 1.2, f64::from(i / 7 - 3) * 1.1, 0.0);
    let mut objects = vec![lamp(v(-20.0, 30.0, -40.0), 1.0)];
    objects.extend((0..49).map(|i| {
        let size = 0.3 + 0.01 * f64::from(i % 11);
        let thing = thing().moved(Transform::rotate(v(7.0, 40.0, 3.0) * f64::from(i))).moved(scaled(size, 0.5, size));
        thing.moved(Transform::translate(place(i))).painted(rgb(0.5, f64::from(i) / 48.0, 0.9), Finish::default())
    }));
    let Scene { camera, .. } = scene(-10.0 * Z, Z, vec![]);
    let mut scene = Scene { version: 370, camera, objects, ..Scene::default() };
    if let durer::camera::Camera::Povray(camera) = &mut scene.camera {
        (camera.direction, camera.up, camera.right) = (Z, DVec3::Y, X * 4.0 / 3.0);
    }
    scene
}

#[test]
fn instances_look_like_single_objects() {
    let ball = |x: f64| sphere(v(x, 0.0, 0.0), 0.7);
    let squares = || texture([(checker(rgb(1.0, 0.0, 0.0), rgb(0.0, 1.0, 0.0)), glowing())]);
    let block = || cuboid(v(-0.5, -0.5, -0.5), v(0.5, 0.2, 0.5)).moved(Transform::rotate(30.0 * Z)).textured(squares());
    let things: [&dyn Fn() -> Object; 4] = [
        &|| csg(CsgOp::Union, vec![ball(-0.3), block(), sphere(v(0.0, 1.0, 0.0), 0.3)]),
        &|| csg(CsgOp::Difference, vec![ball(0.0), block(), ball(0.9)]),
        &|| csg(CsgOp::Union, vec![csg(CsgOp::Merge, vec![ball(0.0), ball(0.5)]).filled(1.3), block()]),
        &|| {
            csg(CsgOp::Intersection, vec![ball(0.0), plane(DVec3::Y, 0.1), csg(CsgOp::Union, vec![ball(0.6), block()])])
        },
    ];
    for thing in things {
        let apart = rows(thing);
        let one = thing();
        let copies = rows(|| one.clone());
        let told = |scene: &Scene| serde_json::to_string(&lower(scene).unwrap()).unwrap().contains("\"shared\"");
        assert_eq!([&apart, &copies].map(told), [false, true]);
        let options = Options::new(48, 36);
        let [a, b] = [&apart, &copies].map(|scene| draw(scene, &options).0.pixels);
        let differ = a.iter().zip(&b).filter(|(a, b)| a.iter().zip(*b).any(|(a, b)| (a - b).abs() > 1e-4)).count();
        assert!(differ <= 1, "{differ} pixels are others");
        let worlds = [&apart, &copies].map(|scene| lower(scene).unwrap());
        for (x, y) in [(5, 5), (20, 17), (24, 18), (30, 30)] {
            let [a, b] =
                [0, 1].map(|i| pick(&worlds[i], &options, x, y).map(|p| (p.shape, (p.t * 1e6).round(), p.source)));
            assert_eq!(a, b);
        }
    }
}

#[test]
fn picks_return_the_source_span() {
    let mut ball = sphere(DVec3::ZERO, 1.0);
    ball.source = Span::new(7, 12);
    let scene = scene(-5.0 * Z, Z, vec![ball]);
    let world = lower(&scene).unwrap();
    let seen = pick(&world, &Options::new(1, 1), 0, 0).unwrap();
    assert_eq!((seen.source, seen.t), (Span::new(7, 12), 4.0));
    assert!(serde_json::to_string(&world).unwrap().contains("\"sphere\""));
    let empty = crate::scene_builder::scene(-5.0 * Z, Z, vec![]);
    assert_eq!(pick(&lower(&empty).unwrap(), &Options::new(1, 1), 0, 0), None);
}

#[test]
fn textures_move_with_their_blocks() {
    let squares = || texture([(checker(rgb(1.0, 0.0, 0.0), rgb(0.0, 1.0, 0.0)), glowing())]);
    let red = [1.0, 0.0, 0.0];
    let green = [0.0, 1.0, 0.0];
    let looks = |object: Object, x: f64| look(&scene(v(x, 0.5, -9.5), Z, vec![object]));
    // parity of ⌊x⌋ + ⌊y⌋ + ⌊z⌋ at (0.5, 0.5, -0.5): odd
    let wall = || plane(-Z, 0.5).textured(squares());
    assert_near(looks(wall(), 0.5), green);
    assert_near(looks(wall(), 1.5), red);
    // moved after the texture was set, by itself and with its group
    assert_near(looks(wall().moved(Transform::translate(X)), 0.5), red);
    let group = |o: Object| csg(CsgOp::Union, vec![o]);
    assert_near(looks(group(wall()).moved(Transform::translate(X)), 0.5), red);
    assert_near(looks(group(wall().moved(Transform::translate(X))).moved(Transform::translate(X)), 0.5), green);
    // the group's texture applies to a part without one, in the group's space
    let plain = || plane(-Z, 0.5).moved(Transform::translate(7.0 * X));
    assert_near(looks(group(plain()).textured(squares()), 0.5), green);
    assert_near(looks(group(group(plain())).textured(squares()).moved(Transform::translate(X)), 0.5), red);
    // scaled by 3: (0.5, 0.5, -0.5) is in the cell of 0 and -1
    assert_near(looks(wall().moved(scaled(3.0, 3.0, 1.0)), 2.5), green);
}

#[test]
fn group_modifiers_apply_to_parts() {
    let mut group = csg(CsgOp::Union, vec![sphere(DVec3::ZERO, 1.0)]);
    group.uncommon.flags.no_image = true;
    assert_gray(&scene(-5.0 * Z, Z, vec![group.painted(rgb(1.0, 1.0, 1.0), glowing())]), 0.0);
    // a part without texture beside one that has one gets the default
    let base = sphere(DVec3::ZERO, 2.0).painted(rgb(1.0, 0.0, 0.0), glowing());
    let hole = sphere(-2.0 * Z, 1.0);
    let white = Finish { ambient: Rgb::ONE, ..Finish::default() };
    let default = texture([(Pigment::solid(rgb(1.0, 1.0, 1.0)), white)]).texture;
    let mut cut = csg(CsgOp::Difference, vec![base, hole]);
    cut.default_texture = default;
    assert_near(look(&scene(-5.0 * Z, Z, vec![cut.clone()])), [1.0, 1.0, 1.0]);
    cut.uncommon.flags.cutaway_textures = true;
    assert_near(look(&scene(-5.0 * Z, Z, vec![cut])), [1.0, 0.0, 0.0]);
}

#[test]
fn inverse_and_inside_textures() {
    let mut ball = sphere(-5.0 * Z, 1.0).painted(rgb(1.0, 0.0, 0.0), glowing());
    ball.uncommon.interior_texture = Some(texture([(Pigment::solid(rgb(0.0, 1.0, 0.0)), glowing())]));
    assert_near(look(&scene(-5.0 * Z, Z, vec![ball.clone()])), [0.0, 1.0, 0.0]);
    ball.uncommon.flags.inverse = true;
    assert_near(look(&scene(-5.0 * Z, Z, vec![ball])), [1.0, 0.0, 0.0]);
}

#[test]
fn clipped_objects() {
    let mut ball = sphere(DVec3::ZERO, 1.0);
    // only the part beyond z = 0; and the clipping object moves along
    ball.uncommon.clipped_by = Some([plane(-Z, 0.0)].into());
    let at = |o: Object| pick(&lower(&scene(-5.0 * Z, Z, vec![o])).unwrap(), &Options::new(1, 1), 0, 0).unwrap().t;
    assert_near([at(ball.clone()), at(ball.moved(Transform::translate(2.0 * Z)))], [6.0, 8.0]);
}

#[test]
fn lights_move_with_their_group() {
    let group = csg(CsgOp::Union, vec![lamp(DVec3::ZERO, 1.0)]).moved(Transform::translate(-3.0 * Z));
    let wall = plane(-Z, 0.0).painted(rgb(1.0, 1.0, 1.0), Finish { diffuse: 0.5, ..dull() });
    assert_gray(&scene(-5.0 * Z, Z, vec![wall, group]), 0.5);
}

#[test]
fn non_finite_numbers_are_reported() {
    let mut ball = sphere(DVec3::ZERO, 1.0).moved(Transform::translate(v(f64::INFINITY, 0.0, 0.0)));
    ball.source = Span::new(3, 5);
    let fault = lower(&scene(-5.0 * Z, Z, vec![ball])).unwrap_err();
    assert_eq!((fault.code, fault.span()), (codes::NOT_FINITE, Span::new(3, 5)));
    let fault = lower(&scene(-5.0 * Z, Z, vec![lamp(v(f64::NAN, 0.0, 0.0), 1.0)])).unwrap_err();
    assert_eq!(fault.code, codes::NOT_FINITE);
    // each of these has an inverse, their product has none
    let tiny = scaled(1e-150, 1e-150, 1e-150);
    let nested = csg(CsgOp::Union, vec![csg(CsgOp::Union, vec![sphere(DVec3::ZERO, 1.0).moved(tiny)]).moved(tiny)]);
    assert_eq!(lower(&scene(-5.0 * Z, Z, vec![nested.moved(tiny)])).unwrap_err().code, codes::SINGULAR);
    // colours that are not numbers give a black pixel
    let odd = wall_of(rgb(f64::NAN, f64::INFINITY, 0.5));
    let seen = look(&odd);
    assert!(seen[0] == 0.0 && !seen[1].is_nan() && seen[2] == 0.5, "{seen:?}");
}

fn wall_of(color: Color) -> Scene {
    scene(-5.0 * Z, Z, vec![plane(-Z, 0.0).painted(color, glowing())])
}

/// Glass, mirrors, grain, shadows, a checkered floor.
fn busy() -> Scene {
    use durer::camera::{Camera, PovrayCamera};
    let mut finish = Finish { crand: 0.3, phong: 0.5, ..Finish::default() };
    finish.reflection.min = Rgb::splat(0.2);
    finish.reflection.max = Rgb::splat(0.6);
    let floor = plane(Y, 0.0).textured(texture([(checker(rgb(0.9, 0.9, 0.9), rgb(0.1, 0.2, 0.5)), finish.clone())]));
    let balls = (0..30).map(|i| {
        let k = f64::from(i);
        let at = v((k * 1.7).sin() * 4.0, 0.5 + (k * 0.9).cos().abs() * 2.0, k * 0.4 - 4.0);
        let ball = sphere(at, 0.6);
        match i % 3 {
            0 => ball.painted(rgb(0.8, k / 30.0, 0.2), finish.clone()),
            1 => ball.painted(rgbft([0.9, 0.9, 1.0, 0.5, 0.4]), dull()).filled(1.4),
            _ => csg(CsgOp::Difference, vec![ball, sphere(at + X * 0.3, 0.5)])
                .painted(rgb(0.3, 0.8, k / 30.0), finish.clone()),
        }
    });
    let lamps = [lamp(v(6.0, 9.0, -8.0), 0.8), lamp(v(-9.0, 5.0, -3.0), 0.3)];
    let camera = PovrayCamera { location: v(0.0, 3.0, -9.0), look_at: Some(Y), ..PovrayCamera::default() };
    let objects = [floor].into_iter().chain(balls).chain(lamps).collect();
    Scene {
        camera: Camera::Povray(camera),
        background: Some(Background { color: rgb(0.3, 0.4, 0.6), by_picture: false }),
        objects,
        ..Scene::default()
    }
}

/// `busy` with balls that transmit light in part: POV-Ray's picture of such a scene depends on the order of its pixels.
fn filtering() -> Scene {
    let mut scene = busy();
    let clear = rgbft([1.0, 0.9, 0.8, 0.0, 0.5]);
    for object in &mut scene.objects {
        if let ObjectKind::Csg(_, parts) = &mut object.kind {
            let ball = parts[0].clone().textured(texture([(checker(rgb(0.9, 0.4, 0.1), clear), dull())]));
            *parts = [ball, parts[1].clone()].into();
        }
    }
    scene
}

fn methods() -> impl Iterator<Item = Options> {
    let spreads = [None, Some(SampleLayout::Lattice), Some(SampleLayout::Grid), Some(SampleLayout::Corners)];
    spreads.into_iter().map(|spread| {
        let mut options = Options::new(65, 41);
        options.antialias = spread.map(|_| 0.1);
        options.sampling.layout = spread.unwrap_or(SampleLayout::Lattice);
        options
    })
}

#[test]
fn thread_count_does_not_change_bytes() {
    for (scene, mut options) in [busy(), filtering()].iter().flat_map(|scene| methods().map(move |m| (scene, m))) {
        let (one, rays) = draw(scene, &options);
        for threads in [2, 5, 0] {
            options.threads = threads;
            let (many, counted) = draw(scene, &options);
            assert!(one.pixels.iter().zip(&many.pixels).all(|(a, b)| a.map(f32::to_bits) == b.map(f32::to_bits)));
            assert_eq!(rays, counted);
        }
        // another frame has different grain
        options.frame = 1;
        assert!(draw(scene, &options).0 != one);
    }
}

#[test]
fn regions_equal_parts_of_the_whole() {
    for (scene, mut options) in [busy(), filtering()].iter().flat_map(|scene| methods().map(move |m| (scene, m))) {
        let (whole, _) = draw(scene, &options);
        for region in [Region { x: 13, y: 7, width: 40, height: 21 }, Region { x: 60, y: 33, width: 99, height: 99 }] {
            options.region = Some(region);
            let (part, _) = draw(scene, &options);
            for (i, (a, b)) in part.pixels.iter().zip(&whole.pixels).enumerate() {
                let (x, y) = (i % 65, i / 65);
                let inside = (region.x..region.x + region.width).contains(&x)
                    && (region.y..region.y + region.height).contains(&y);
                assert_eq!(*a, if inside { *b } else { [0.0; 4] }, "at {x}, {y}");
            }
        }
        options.region = Some(Region { x: 500, y: 0, width: 5, height: 5 });
        assert!(draw(scene, &options).0.pixels.iter().all(|p| *p == [0.0; 4]));
    }
}

#[test]
fn anti_aliasing_averages_edges() {
    // a bright half plane that ends in the middle of a pixel
    let edge = cuboid(v(-9.0, -9.0, 0.0), v(0.0, 9.0, 1.0)).painted(rgb(1.0, 1.0, 1.0), glowing());
    let mut scene = scene(-5.0 * Z, Z, vec![edge]);
    scene.camera = durer::camera::Camera::Povray(durer::camera::PovrayCamera {
        location: v(0.01, 0.0, -5.0),
        ..Default::default()
    });
    let mut options = Options::new(3, 3);
    let (plain, _) = draw(&scene, &options);
    options.antialias = Some(0.3);
    let (smooth, rays) = draw(&scene, &options);
    assert_eq!([plain.pixels[3][0], plain.pixels[4][0], plain.pixels[5][0]], [1.0, 0.0, 0.0]);
    assert_eq!(smooth.pixels[5][0], 0.0);
    // Half of the samples, except the one in the middle.
    assert!((0.35..0.55).contains(&smooth.pixels[4][0]), "{:?}", smooth.pixels[4]);
    // The edge crosses three of the six pixels beside it, which get all ten samples.
    assert_eq!(rays.camera, 9 + 3 * 9 + 3 * 4);
}

struct Watcher {
    last: AtomicUsize,
    stop_at: usize,
}

impl Watch for Watcher {
    fn progress(&self, done: usize, total: usize) {
        assert!(done <= total);
        self.last.fetch_max(done, Ordering::Relaxed);
    }

    fn cancelled(&self) -> bool {
        self.last.load(Ordering::Relaxed) >= self.stop_at
    }
}

#[test]
fn progress_and_cancelling() {
    let world = lower(&busy()).unwrap();
    let mut options = Options::new(64, 64);
    options.antialias = Some(0.3);
    let watcher = Watcher { last: AtomicUsize::new(0), stop_at: usize::MAX };
    render(&world, &options, &watcher).unwrap();
    assert_eq!(watcher.last.into_inner(), 2 * 64 * 64);
    let impatient = Watcher { last: AtomicUsize::new(0), stop_at: 500 };
    assert_eq!(render(&world, &options, &impatient).unwrap_err(), Cancelled);
}

#[test]
fn many_transparent_surfaces_do_not_overflow_the_stack() {
    let pane = |i: i32| plane(Z, f64::from(i) * 0.01).painted(rgbft([1.0, 1.0, 1.0, 0.0, 1.0]), dull());
    let mut panes: Vec<Object> = (0..3000).map(pane).collect();
    panes.push(plane(Z, 50.0).painted(rgb(0.5, 0.5, 0.5), glowing()));
    assert_gray(&scene(-5.0 * Z, Z, panes), 0.5);
    // and two facing mirrors at the highest level
    let mut finish = dull();
    finish.reflection.min = Rgb::ONE;
    finish.reflection.max = Rgb::ONE;
    let faces = [plane(Z, 1.0), plane(-Z, 1.0)].map(|p| p.painted(rgb(1.0, 1.0, 1.0), finish.clone()));
    let mut hall = scene(DVec3::ZERO, Z, faces.into());
    hall.settings.max_trace_level = 256;
    let (_, rays) = draw(&hall, &Options::new(1, 1));
    assert_eq!(rays.reflected, 255);
    assert!(matches!(hall.objects[0].kind, ObjectKind::Shape(_)));
}
