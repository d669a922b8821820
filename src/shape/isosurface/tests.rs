use super::*;
use crate::function::{Body, Callee, Function, Graph, Id, Operation, Program, numeric};
use crate::math::fp;
use crate::math::noise::NoiseGenerator;
use crate::shape::testing::all_hits;
use crate::syntax::ast::Operator::{self, Add, Mul, Sub};
use std::sync::atomic::AtomicU8;

/// Graph under construction for the function of a test.
struct Maker(Graph);

impl Maker {
    fn add_binary(&mut self, op: Operator, a: Id, b: Id) -> Id {
        self.0.add_operation(Operation::Binary(op, a, b))
    }

    fn add_unary(&mut self, name: &str, a: Id) -> Id {
        self.0.add_operation(Operation::One(numeric::find_numeric(name).unwrap(), a))
    }

    fn add_scaled(&mut self, factor: f64, a: Id) -> Id {
        let factor = self.0.add_constant(factor);
        self.add_binary(Mul, factor, a)
    }

    /// Adds the operations of x² + y² + z² to the graph.
    fn add_sum_of_squares(&mut self, p: [Id; 3]) -> Id {
        let [x, y, z] = p.map(|x| self.add_binary(Mul, x, x));
        let sum = self.add_binary(Add, x, y);
        self.add_binary(Add, sum, z)
    }
}

fn formula(make: impl Fn(&mut Maker, [Id; 3]) -> Id) -> Formula {
    let mut maker = Maker(Graph::default());
    let p = [0, 1, 2].map(|i| maker.0.add_operation(Operation::Parameter(i)));
    maker.0.result = make(&mut maker, p);
    let program = Program::new(maker.0, 3).unwrap();
    Formula::new(Function { parameters: ["x", "y", "z"].map(Into::into).into(), body: Body::Numeric(program) })
}

fn value_at(shape: &Isosurface, p: DVec3) -> f64 {
    shape.above_threshold(shape.function.value_at(p))
}

fn ball_isosurface(threshold: f64) -> Isosurface {
    let function = formula(|m, p| m.add_sum_of_squares(p));
    Isosurface { threshold, accuracy: 1e-10, max_trace: u32::MAX, ..Isosurface::new(function) }
}

#[test]
fn a_ball_in_closed_form_and_its_faces() {
    let ray = Ray::new(DVec3::new(0.3, -9.0, 0.2), DVec3::Y * 2.0);
    let h = (0.64_f64 - 0.13).sqrt();
    let hits = all_hits(&ball_isosurface(0.64), &ray);
    assert!(hits.len() == 2 && (hits[0].t * 2.0 - 9.0 + h).abs() < 1e-9, "{hits:?}");
    assert!((hits[1].t * 2.0 - 9.0 - h).abs() < 1e-9);
    // Cut by its container, closed and open.
    let cut = ball_isosurface(1.5);
    let hits = all_hits(&cut, &ray);
    assert!(hits.len() == 2 && hits[0].part == FACE && hits[0].t == 4.0 && hits[1].t == 5.0, "{hits:?}");
    assert_eq!(cut.normal(ray.at(hits[0].t), &hits[0]), DVec3::NEG_Y);
    assert!(all_hits(&Isosurface { open: true, ..cut.clone() }, &ray).is_empty());
    assert!(cut.inside(DVec3::ZERO) && !cut.inside(DVec3::Y * 1.1) && !cut.inside(DVec3::ONE * 0.99));
    // A distant eye costs no accuracy.
    let far = all_hits(&ball_isosurface(0.64), &Ray::new(DVec3::new(0.3, -1e7, 0.2), DVec3::Y));
    assert!((far[0].t - 1e7 + h).abs() < 1e-7, "{far:?}");
}

#[test]
fn only_so_many_hits_as_max_trace_says() {
    // Four sheets: sin(9x) = 0
    let sheets = formula(|m, [x, _, _]| {
        let x = m.add_scaled(9.0, x);
        m.add_unary("sin", x)
    });
    let ray = Ray::new(DVec3::new(-3.0, 0.1, 0.2), DVec3::X);
    let count = |max_trace: u32| {
        let shape = Isosurface { max_trace, open: true, ..Isosurface::new(sheets.clone()) };
        let mut hits = Hits::new();
        shape.limited_hits_for_csg(&ray, Range::FORWARD, &mut hits);
        assert_eq!(all_hits(&shape, &ray).len(), 5);
        hits.len()
    };
    assert_eq!([1, 3, u32::MAX].map(count), [1, 3, 5]);
}

/// Test: a function twice as steep as noise usually is has no holes, although the default `max_gradient` would tear the
/// surface.
#[test]
fn steep_functions_have_no_holes() {
    let noise = Arc::new(AtomicU8::new(NoiseGenerator::default().number()));
    let rough = formula(|m, [x, y, z]| {
        let list = [x, y, z].map(|x| m.add_scaled(9.0, x)).to_vec();
        let n = m.0.add_call_component(Callee::SceneNoise(noise.clone()), 0, list.into());
        let n = m.add_scaled(0.4, n);
        m.add_binary(Sub, y, n)
    });
    let shape = Isosurface { accuracy: 1e-10, max_trace: u32::MAX, ..Isosurface::new(rough) };
    assert!(shape.sampled_max_gradient() > 1.65, "{}", shape.sampled_max_gradient());
    for k in 0..3000 {
        let at = |m: usize| (k * m % 997) as f64 / 498.5 - 1.0;
        let (from, to) = (DVec3::new(at(13), 1.0, at(29)), DVec3::new(at(31), -0.99, at(17)));
        let ray = Ray::new(from, to - from);
        let hits = all_hits(&shape, &ray);
        let first = hits.first().filter(|hit| hit.part == SURFACE);
        assert!(first.is_some_and(|hit| value_at(&shape, ray.at(hit.t)).abs() < 1e-8), "{ray:?} {hits:?}");
        // No hit before it.
        let upto = first.map_or(0.0, |hit| hit.t);
        assert!(
            (0..200).all(|i| value_at(&shape, ray.at(upto * 0.999 * f64::from(i) / 200.0)) > 0.0),
            "{ray:?} {hits:?}"
        );
    }
}

#[test]
fn a_function_may_be_nan_or_jump() {
    let root = formula(|m, [x, y, _]| {
        let root = m.add_unary("sqrt", x);
        m.add_binary(Sub, y, root)
    });
    let stairs = formula(|m, [x, y, _]| {
        let x = m.add_scaled(4.0, x);
        let step = m.add_unary("floor", x);
        let step = m.add_scaled(0.2, step);
        m.add_binary(Sub, y, step)
    });
    for function in [root, stairs] {
        let shape = Isosurface { max_trace: u32::MAX, ..Isosurface::new(function) };
        for k in 0..500 {
            let at = |m: usize| (k * m % 499) as f64 / 249.5 - 1.0;
            let ray = Ray::new(DVec3::new(at(13), 3.0, at(29)), DVec3::new(at(7) * 0.3, -1.0, at(3) * 0.3));
            for hit in all_hits(&shape, &ray) {
                let p = ray.at(hit.t);
                assert!(shape.bounds().grown(1e-9).contains(p) && shape.normal(p, &hit).is_finite());
            }
        }
    }
}

/// Test: a union of balls on a circle has the hits of the nearest ball, and its cells share few pruned functions.
#[test]
fn a_union_by_min_has_the_hits_of_its_balls() {
    let (radius, n) = (0.3, 8);
    let center = |k: usize| DVec3::new(0.7 * fp::cos(k as f64), 0.7 * fp::sin(k as f64), 0.05 * k as f64);
    let union = formula(|m, p| {
        let balls: Vec<Id> = (0..n)
            .map(|k| {
                let moved = [0, 1, 2].map(|i| {
                    let c = m.0.add_constant(center(k)[i]);
                    m.add_binary(Sub, p[i], c)
                });
                let square = m.add_sum_of_squares(moved);
                let limit = m.0.add_constant(radius * radius);
                m.add_binary(Sub, square, limit)
            })
            .collect();
        let min = numeric::find_numeric("min").unwrap();
        balls.into_iter().reduce(|a, b| m.0.add_operation(Operation::Two(min, a, b))).unwrap()
    });
    let shape = Isosurface { accuracy: 1e-10, open: true, ..Isosurface::new(union) };
    for k in 0..2000 {
        let at = |m: usize| (k * m % 997) as f64 / 498.5 - 1.0;
        let ray = Ray::new(DVec3::new(at(13), at(29), -3.0), DVec3::new(0.2 * at(7), 0.2 * at(31), 1.0));
        let near = |k: usize| {
            let (from, d) = (ray.origin - center(k), ray.dir);
            let (b, c) = (from.dot(d) / d.length_squared(), (from.length_squared() - radius * radius));
            let root = b * b - c / d.length_squared();
            (root > 1e-9).then(|| -b - root.sqrt())
        };
        let wanted = (0..n).filter_map(near).fold(f64::INFINITY, f64::min);
        let found = shape.closest(&ray, Range::FORWARD).map_or(f64::INFINITY, |hit| hit.t);
        let outside =
            [wanted, found].iter().any(|&t| t.is_finite() && !shape.bounds().grown(-1e-6).contains(ray.at(t)));
        assert!(outside || wanted == found || (wanted - found).abs() < 1e-8, "{ray:?}: {wanted} {found}");
    }
    let count = shape.cells().pruned_count();
    assert!((2..100).contains(&count), "{count}");
}
