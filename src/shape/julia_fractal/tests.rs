//! Tests of julia fractals, with numbers of POV-Ray.

use super::*;
use crate::shape::testing::{all_hits, read_shape};

/// POV-Ray's `trace()` from (-5, y, z) along x: first hit and normal.
fn traced(text: &str, y: f64, z: f64, x: f64, normal: [f64; 3]) {
    let fractal = read_shape::<JuliaFractal>(text).0.unwrap();
    let ray = Ray::new(DVec3::new(-5.0, y, z), DVec3::X);
    let hit = fractal.closest(&ray, Range::FORWARD).unwrap();
    let n = fractal.normal(ray.at(hit.t), &hit).normalize();
    assert!((ray.at(hit.t).x - x).abs() < 3e-7 && n.distance(normal.into()) < 3e-5, "{text} {hit:?} {n}");
}

const C: &str = "<-0.083,0.0,-0.83,-0.025>";

#[test]
fn as_pov_ray_traces() {
    let slice = "slice <.2,.3,.4,1> 0.2";
    traced(&format!("{C} quaternion sqr max_iteration 8"), 0.1, 0.2, -0.367282507, [-0.749882, -0.016865, 0.661357]);
    traced(&format!("{C} cube max_iteration 8"), 0.1, 0.2, -0.842641290, [-0.877058, -0.421655, -0.230166]);
    traced(&format!("{C} hypercomplex max_iteration 8"), 0.1, 0.2, -0.362928556, [-0.989031, -0.104070, -0.104817]);
    traced(&format!("{C} max_iteration 8 {slice}"), 0.1, 0.2, -0.3860056, [-0.97510, -0.12615, 0.18237]);
    traced(&format!("{C} cube max_iteration 8 {slice}"), 0.1, 0.2, -0.7559081, [-0.48684, 0.00245, -0.87349]);
    let sphere = "hypercomplex sqr max_iteration 3";
    traced(&format!("<-0.083,0.1,-0.83,-0.025> {sphere}"), 0.1, 0.3, -1.084363418, [-0.821592, 0.073122, 0.565367]);
}

#[test]
fn all_hits_as_pov_ray_finds_them() {
    let fractal = read_shape::<JuliaFractal>(&format!("{C} max_iteration 8 precision 1000")).0.unwrap();
    let ray = Ray::new(DVec3::new(0.1, -5.0, 0.2), DVec3::Y * 2.0);
    let want = [0.962490147, 0.839721512, 0.802569119, 0.653626900, 0.493652024];
    let want: Vec<f64> = want.iter().map(|y| -y).chain(want.iter().rev().copied()).collect();
    let hits = all_hits(&fractal, &ray);
    assert!(hits.len() == want.len(), "{hits:?}");
    for (hit, y) in hits.iter().zip(want) {
        assert!((ray.at(hit.t).y - y).abs() < 2e-7, "{hit:?} {y}");
    }
}

#[test]
fn steps_never_pass_the_surface() {
    for text in [
        C,
        "<0.2,0.1,0.59,-0.2> hypercomplex",
        "<-0.03,0.5,-0.2,-0.5> cube",
        "<-0.1,0.1,0.7,0.1> slice <.5,0,.4,1> 0.1",
    ] {
        let fractal = read_shape::<JuliaFractal>(&format!("{text} max_iteration 9")).0.unwrap();
        let mut trail = Trail::new();
        for k in 0..400 {
            let at = |m: usize| (k * m % 101) as f64 / 50.0 - 1.0;
            let p = DVec3::new(at(13), at(29), at(43));
            let (inside, clearance) = fractal.is_inside_with_clearance(p, fractal.escape_radius(), &mut trail);
            for j in 0..20 {
                let around = |m: usize| (j * m % 37) as f64 / 18.0 - 1.0;
                let q = p + DVec3::new(around(5), around(7), around(11)).normalize() * clearance * 0.999;
                assert_eq!(fractal.contains(q), inside, "{text} {p} {q} {clearance}");
            }
        }
    }
}

#[test]
fn extents_and_reading() {
    let pov_bounds = |text: &str| read_shape::<JuliaFractal>(text).0.unwrap().pov_bounds(&Transform::IDENTITY).max.x;
    assert!((pov_bounds(C) - 1.834514).abs() < 1e-6 && pov_bounds(&format!("{C} hypercomplex exp")) == 4.0);
    assert!((pov_bounds("0.1") - 1.2).abs() < 1e-12 && (pov_bounds("<0.3,0.4,0>") - 1.5).abs() < 1e-12);
    let code = |text: &str| read_shape::<JuliaFractal>(text).0.unwrap_err().code;
    assert_eq!(code("0 slice <1,0,0,0> 0"), codes::BAD_ARGUMENT);
    assert_eq!(code("0 slice <0,0,0,0> 0"), codes::BAD_ARGUMENT);
    assert_eq!(code("0 exp"), codes::BAD_ARGUMENT);
    assert_eq!(code("NaN"), codes::NOT_FINITE);
    assert_eq!(code("0 hypercomplex pwr <1,inf>"), codes::NOT_FINITE);
    assert_eq!(read_shape::<JuliaFractal>("0 max_iteration -1").1[0].code, codes::NO_SURFACE);
    let huge = read_shape::<JuliaFractal>("<1e200,0,0,0> max_iteration 1e9 precision 1e99").0.unwrap();
    assert!(all_hits(&huge, &Ray::new(DVec3::NEG_X * 1e3, DVec3::X)).len() < 9);
    let flat = read_shape::<JuliaFractal>("0 hypercomplex pwr <2,1>").0.unwrap();
    assert_eq!(flat.function, Function::Pwr(2.0, 1.0));
}
