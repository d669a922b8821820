use super::*;
use crate::function::{Body, Function, Graph, Id, Operation, Program, numeric};
use crate::shape::testing::all_hits;
use crate::syntax::ast::Operator::{Add, Mul};

fn formula(make: impl Fn(&mut Graph, Id, Id) -> Id) -> Formula {
    let mut graph = Graph::default();
    let [u, v, _] = [0, 1, 2].map(|i| graph.add_operation(Operation::Parameter(i)));
    graph.result = make(&mut graph, u, v);
    let program = Program::new(graph, 3).unwrap();
    Formula::new(Function { parameters: ["x", "y", "z"].map(Into::into).into(), body: Body::Numeric(program) })
}

fn add_unary(graph: &mut Graph, name: &str, a: Id) -> Id {
    graph.add_operation(Operation::One(numeric::find_numeric(name).unwrap(), a))
}

fn add_product(graph: &mut Graph, names: [&str; 2], of: [Id; 2]) -> Id {
    let (a, b) = (add_unary(graph, names[0], of[0]), add_unary(graph, names[1], of[1]));
    graph.add_operation(Operation::Binary(Mul, a, b))
}

/// Returns a parametric surface for tests: a sphere of radius 1.
fn unit_ball() -> Parametric {
    let x = formula(|g, u, v| add_product(g, ["sin", "cos"], [u, v]));
    let y = formula(|g, u, v| add_product(g, ["sin", "sin"], [u, v]));
    let z = formula(|g, u, _| add_unary(g, "cos", u));
    let pi = std::f64::consts::PI;
    Parametric {
        container: Container::Box(crate::shape::Cuboid::new(DVec3::splat(-1.1), DVec3::splat(1.1))),
        ..Parametric::new([x, y, z], DVec2::ZERO, DVec2::new(pi, 2.0 * pi))
    }
}

#[test]
fn a_ball_has_the_hits_of_a_sphere() {
    let (shape, sphere) = (unit_ball(), crate::shape::Sphere { center: DVec3::ZERO, radius: 1.0 });
    let mut met = 0;
    for k in 0..2000 {
        let at = |m: usize| (k * m % 997) as f64 / 498.5 - 1.0;
        let ray = Ray::new(DVec3::new(at(13), at(29), at(5)) * 3.0, DVec3::new(at(7), at(11), at(3)));
        let (found, want) = (all_hits(&shape, &ray), all_hits(&sphere, &ray));
        // (A grazing ray may miss it, or hit once too often.)
        if want.len() == 2 && (want[1].t - want[0].t) * ray.dir.length() > 0.05 {
            met += 1;
            assert_eq!(found.len(), 2, "{ray:?} {found:?} {want:?}");
            for (found, want) in found.iter().zip(&want) {
                let p = ray.at(want.t);
                assert!((found.t - want.t).abs() * ray.dir.length() < 1e-7, "{ray:?} {found:?} {want:?}");
                let n = shape.normal(p, found).normalize();
                assert!(n.distance(p) < 1e-4 || p.z.abs() > 0.9999, "{p} {n}");
            }
            let first = shape.closest(&ray, Range::FORWARD).map(|hit| hit.t);
            assert_eq!(first, found.iter().map(|hit| hit.t).find(|t| *t > 0.0));
        } else if want.is_empty() {
            assert!(found.iter().all(|hit| (ray.at(hit.t).length() - 1.0).abs() < 1e-2), "{ray:?} {found:?}");
        }
    }
    assert!(met > 200, "{met}");
}

#[test]
fn a_surface_ends_with_its_parameters_and_its_container() {
    // A slightly curved sheet over a square.
    let square = |size: f64| {
        let (x, z) = (formula(|_, u, _| u), formula(|_, _, v| v));
        let y = formula(|g, u, v| {
            let (a, b) = (g.add_operation(Operation::Binary(Mul, u, u)), g.add_operation(Operation::Binary(Mul, v, v)));
            g.add_operation(Operation::Binary(Add, a, b))
        });
        Parametric::new([x, y, z], DVec2::splat(size), DVec2::splat(-size))
    };
    let down =
        |x: f64, z: f64, shape: &Parametric| all_hits(shape, &Ray::new(DVec3::new(x, 5.0, z), DVec3::NEG_Y)).len();
    let small = square(0.5);
    assert_eq!([down(0.2, 0.3, &small), down(0.499, -0.499, &small), down(0.501, 0.0, &small)], [1, 1, 0]);
    // Above 1 it leaves its container.
    let large = square(2.0);
    assert_eq!([down(0.7, 0.7, &large), down(0.75, 0.75, &large)], [1, 0]);
    let hit = small.closest(&Ray::new(DVec3::new(0.2, 5.0, 0.3), DVec3::NEG_Y), Range::FORWARD).unwrap();
    assert!(hit.uv.distance(DVec2::new(0.2, 0.3)) < 1e-9 && small.uv(DVec3::ZERO, &hit) == hit.uv);
    assert!(small.normal(DVec3::ZERO, &hit).normalize().distance(DVec3::new(0.4, -1.0, 0.6).normalize()) < 1e-6);
}
