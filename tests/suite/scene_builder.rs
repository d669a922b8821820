//! Scenes built in code, for tests of the light model.

use durer::camera::{Camera, PovrayCamera};
use durer::color::{Color, Rgb};
use durer::image_io::Frame;
use durer::light::Light;
use durer::math::{DVec3, Transform};
use durer::medium::Interior;
use durer::render::{Options, RayCounts, Unwatched, render};
use durer::scene::{CsgOp, Defaults, Object, ObjectKind, Painted, Scene};
use durer::shape::{Cuboid, Disc, Plane, Shape, Sphere};
use durer::source::Span;
use durer::texture::{Finish, Layer, Pigment, Texture};
use durer::value::Family;
use durer::world::lower;
use std::sync::Arc;

pub const X: DVec3 = DVec3::X;
pub const Y: DVec3 = DVec3::Y;
pub const Z: DVec3 = DVec3::Z;

pub fn v(x: f64, y: f64, z: f64) -> DVec3 {
    DVec3::new(x, y, z)
}

pub fn rgb(r: f64, g: f64, b: f64) -> Color {
    Color::opaque(v(r, g, b))
}

/// `rgbft`.
pub fn rgbft(c: [f64; 5]) -> Color {
    Color::from_array(c)
}

pub fn object(kind: ObjectKind, word: &'static str) -> Object {
    Object::new(kind, word, Span::NONE, &Defaults::default())
}

pub fn shape(shape: Shape) -> Object {
    let word = shape.spec().name;
    object(ObjectKind::Shape(shape), word)
}

pub fn sphere(center: DVec3, radius: f64) -> Object {
    shape(Shape::from(Sphere { center, radius }))
}

pub fn plane(normal: DVec3, distance: f64) -> Object {
    shape(Shape::from(Plane::new(normal, distance).unwrap()))
}

pub fn cuboid(a: DVec3, b: DVec3) -> Object {
    shape(Shape::from(Cuboid::new(a, b)))
}

pub fn disc(center: DVec3, normal: DVec3, radius: f64) -> Object {
    shape(Shape::from(Disc::new(center, normal, radius, 0.0)))
}

pub fn csg(op: CsgOp, parts: Vec<Object>) -> Object {
    object(ObjectKind::Csg(op, parts.into()), "union")
}

pub fn lamp(location: DVec3, color: f64) -> Object {
    let light = Light { location, color: Rgb::splat(color), ..Light::default() };
    object(ObjectKind::Light(Arc::new(light.into())), "light_source")
}

pub fn texture(layers: impl IntoIterator<Item = (Pigment, Finish)>) -> Painted {
    let layers = layers
        .into_iter()
        .map(|(pigment, finish)| Layer { pigment, finish: Arc::new(finish), ..Layer::default() })
        .collect();
    Painted::new(Arc::new(Texture { layers }), &Transform::IDENTITY)
}

/// A finish without ambient and diffuse light.
pub fn dull() -> Finish {
    Finish { ambient: Rgb::ZERO, diffuse: 0.0, ..Finish::default() }
}

/// A finish that shows the pigment itself.
pub fn glowing() -> Finish {
    Finish { ambient: Rgb::ONE, ..dull() }
}

pub trait Looks: Sized {
    fn painted(self, color: Color, finish: Finish) -> Self;
    fn textured(self, texture: Painted) -> Self;
    fn moved(self, by: Transform) -> Self;
    fn filled(self, ior: f64) -> Self;
}

impl Looks for Object {
    fn painted(self, color: Color, finish: Finish) -> Self {
        self.textured(texture([(Pigment::solid(color), finish)]))
    }

    fn textured(mut self, texture: Painted) -> Self {
        self.texture = Some(Painted::new(texture.texture, &self.transform));
        self
    }

    fn moved(mut self, by: Transform) -> Self {
        self.transform_by(&by);
        self
    }

    fn filled(mut self, ior: f64) -> Self {
        self.uncommon.interior = Some(Arc::new(Interior { ior, ..Interior::default() }));
        self
    }
}

/// A camera at `eye` with nearly parallel rays along `dir`.
pub fn scene(eye: DVec3, dir: DVec3, objects: Vec<Object>) -> Scene {
    // any `right` perpendicular to `dir`
    let right = dir.any_orthonormal_vector();
    let (direction, up) = (dir.normalize() * 1e6, dir.normalize().cross(right));
    let camera = Camera::Povray(PovrayCamera { location: eye, direction, right, up, ..PovrayCamera::default() });
    Scene { version: 370, camera, objects, ..Scene::default() }
}

pub fn draw(scene: &Scene, options: &Options) -> (Frame, RayCounts) {
    render(&lower(scene).unwrap(), options, &Unwatched).unwrap()
}

/// Red, green, blue, alpha of the only pixel of a picture.
pub fn look_with(scene: &Scene, change: impl Fn(&mut Options)) -> [f64; 4] {
    let mut options = Options::new(1, 1);
    change(&mut options);
    draw(scene, &options).0.pixels[0].map(f64::from)
}

pub fn look(scene: &Scene) -> [f64; 3] {
    let [r, g, b, _] = look_with(scene, |_| {});
    [r, g, b]
}

#[track_caller]
pub fn assert_near(found: impl IntoIterator<Item = f64>, expected: impl IntoIterator<Item = f64>) {
    let (found, expected): (Vec<_>, Vec<_>) = (found.into_iter().collect(), expected.into_iter().collect());
    let near = found.len() == expected.len() && found.iter().zip(&expected).all(|(a, b)| (a - b).abs() < 1e-6);
    assert!(near, "{found:?} is not {expected:?}");
}

#[track_caller]
pub fn assert_gray(scene: &Scene, expected: f64) {
    assert_near(look(scene), [expected; 3]);
}
