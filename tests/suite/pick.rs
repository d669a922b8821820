//! `durer pick` compared with calculation by hand, to 1e-9 relative: from the text of a scene, with expectations by the
//! lecture's formulas.

use durer::math::DVec3;
use durer::render::{self, Picked};
use durer::source::Sources;

const WIDTH: usize = 64;
const HEIGHT: usize = 48;

/// The pick through a pixel of a scene with the lecture's camera at (0, 0, 10), looking at the origin.
fn pick(objects: &str, x: usize, y: usize) -> Option<Picked> {
    let camera = "camera { eye <0, 0, 10> center 0 up y fov_x 60 fov_y 45 } light_source { 9, 1 } ";
    let text = format!("#version 3.7; global_settings {{ assumed_gamma 1 }} {camera}\n{objects}");
    durer::on_big_stack(move || pick_in(text, x, y))
}

fn pick_in(text: String, x: usize, y: usize) -> Option<Picked> {
    let sources = Sources::default();
    let file = durer::load_bytes(&sources, "test.scene", text.into_bytes()).unwrap();
    let reading = durer::interpreter::Options {
        size: (WIDTH, HEIGHT),
        max_steps: 1000,
        ..durer::interpreter::Options::default()
    };
    let built = durer::build(&sources, file, &reading, &mut |_| {});
    assert!(built.diagnostics.is_empty(), "{:?}", built.diagnostics);
    render::pick(&built.world.unwrap(), &render::Options::new(WIDTH, HEIGHT), x, y)
}

/// The lecture's ray: u = x, v = y, w = z for this camera.
fn ray(x: usize, y: usize) -> (DVec3, DVec3) {
    let (w, h) = (WIDTH as f64, HEIGHT as f64);
    let alpha = 30f64.to_radians().tan() * (x as f64 + 0.5 - w / 2.0) / (w / 2.0);
    let beta = 22.5f64.to_radians().tan() * (h / 2.0 - y as f64 - 0.5) / (h / 2.0);
    (DVec3::Z * 10.0, DVec3::new(alpha, beta, -1.0).normalize())
}

#[track_caller]
fn near(a: f64, b: f64) {
    assert!((a - b).abs() <= 1e-9 * b.abs().max(1.0), "{a} is not {b}");
}

#[track_caller]
fn near3(a: [f64; 3], b: DVec3) {
    for (a, b) in a.into_iter().zip(b.to_array()) {
        near(a, b);
    }
}

#[test]
fn sphere() {
    let (p, v) = ray(40, 20);
    let seen = pick("sphere { <1, 0.5, -2>, 3 pigment { rgb 1 } }", 40, 20).unwrap();
    // |p + t·v - c|² = r² with |v| = 1
    let m = p - DVec3::new(1.0, 0.5, -2.0);
    let t = -v.dot(m) - (v.dot(m).powi(2) - m.dot(m) + 9.0).sqrt();
    assert_eq!(seen.shape, "sphere");
    near(seen.t, t);
    near3(seen.point, p + v * t);
    near3(seen.normal, (m + v * t) / 3.0);
}

#[test]
fn plane_in_its_four_forms() {
    let (p, v) = ray(10, 40);
    // z = -3: t = -(C·p_z + D) / (C·v_z)
    let t = (-3.0 - p.z) / v.z;
    let at = p + v * t;
    for plane in ["z, -3", "implicit <0, 0, 2, 6>", "point <7, 8, -3> normal 5*z", "point <1, 2, -3> span 2*x, 3*y"] {
        let seen = pick(&format!("plane {{ {plane} pigment {{ rgb 1 }} }}"), 10, 40).unwrap();
        near(seen.t, t);
        near3(seen.point, at);
        near3(seen.normal, DVec3::Z);
        if plane.contains("span") {
            // p₀ - q₀ = -t·v + u·i + v·j
            near(seen.uv[0], (at.x - 1.0) / 2.0);
            near(seen.uv[1], (at.y - 2.0) / 3.0);
        }
    }
}

#[test]
fn triangle() {
    let (p, v) = ray(30, 22);
    let (a, b, c) = (DVec3::new(-2.0, -2.0, 0.0), DVec3::new(3.0, -1.0, 1.0), DVec3::new(0.0, 3.0, -1.0));
    let n = (c - a).cross(b - a).normalize();
    let t = n.dot(a - p) / n.dot(v);
    let seen = pick("triangle { <-2,-2,0>, <3,-1,1>, <0,3,-1> pigment { rgb 1 } }", 30, 22).unwrap();
    near(seen.t, t);
    near3(seen.normal, n);
    assert_eq!(pick("triangle { <-2,-2,0>, <3,-1,1>, <0,3,-1> pigment { rgb 1 } }", 0, 0), None);
}

#[test]
fn concave_polygon() {
    // A square with a notch from the right: the ray of the middle pixel passes the notch, that of the pixel to its left
    // does not.
    let notched = "polygon { 8, <-3,-3>, <3,-3>, <3,-1>, <-1,0>, <3,1>, <3,3>, <-3,3>, <-3,-3> pigment { rgb 1 } }";
    assert_eq!(pick(notched, 36, 24), None);
    let (p, v) = ray(24, 24);
    near(pick(notched, 24, 24).unwrap().t, -p.z / v.z);
}

#[test]
fn axis_aligned_box() {
    let (p, v) = ray(45, 18);
    let (low, high) = (DVec3::new(-1.0, -2.0, -3.0), DVec3::new(4.0, 3.0, 2.0));
    let (t1, t2) = ((low - p) / v, (high - p) / v);
    let t = t1.min(t2).max_element();
    let seen = pick("box { <-1,-2,-3>, <4,3,2> pigment { rgb 1 } }", 45, 18).unwrap();
    near(seen.t, t);
    near3(seen.point, p + v * t);
}

#[test]
fn transformed_object() {
    let (x, y) = (35, 20);
    let (p, v) = ray(x, y);
    // M = T·R·S: an ellipsoid, rotated and translated. A point q of it satisfies |S⁻¹·R⁻¹·(q - d)| = 1.
    let (sin, cos) = 30f64.to_radians().sin_cos();
    let d = DVec3::new(0.5, 0.0, -1.0);
    let unturn = |q: DVec3| DVec3::new(cos * q.x + sin * q.y, -sin * q.x + cos * q.y, q.z);
    let s = DVec3::new(3.0, 1.0, 2.0);
    let (o, w) = (unturn(p - d) / s, unturn(v) / s);
    let (a, b, c) = (w.dot(w), o.dot(w), o.dot(o) - 1.0);
    let t = (-b - (b * b - a * c).sqrt()) / a;
    let seen =
        pick("sphere { 0, 1 scale <3, 1, 2> rotate 30*z translate <0.5, 0, -1> pigment { rgb 1 } }", x, y).unwrap();
    near(seen.t, t);
    near3(seen.point, p + v * t);
    // n = R·S⁻¹·(local normal)
    let local = (o + w * t) / s;
    let turned = DVec3::new(cos * local.x - sin * local.y, sin * local.x + cos * local.y, local.z);
    near3(seen.normal, turned.normalize());
}

#[test]
fn nested_blocks() {
    let flat = "sphere { 0, 1 scale <3, 1, 2> rotate 30*z translate <0.5, 0, -1> pigment { rgb 1 } }";
    let nested = "union { object { sphere { 0, 1 scale <3, 1, 2> } rotate 30*z } transform { translate <1, 0, -2> scale 1 } \
                  translate <-0.5, 0, 1> pigment { rgb 1 } }";
    let (a, b) = (pick(flat, 35, 20).unwrap(), pick(nested, 35, 20).unwrap());
    near(a.t, b.t);
    near3(a.normal, DVec3::from_array(b.normal));
}
