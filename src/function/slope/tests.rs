use super::*;
use crate::function::{Id, numeric};
use crate::math::noise::NoiseGenerator;
use proptest::prelude::*;

/// Recipe of a random function's operation: its type, its two operands and a constant.
type Recipe = Vec<(u8, u32, u32, f64)>;

fn graph(recipe: &Recipe) -> Graph {
    let mut graph = Graph::default();
    let mut ids: Vec<Id> = (0..3).map(|i| graph.add_operation(Operation::Parameter(i))).collect();
    let rows =
        ["abs", "sin", "cos", "exp", "sqrt", "atan", "tanh", "max", "min", "atan2", "floor", "sinh", "asinh", "mod"];
    for &(kind, a, b, x) in recipe {
        let pick = |i: u32| ids[i as usize % ids.len()];
        let (a, b) = (pick(a), pick(b));
        let ops = [Operator::Add, Operator::Sub, Operator::Mul, Operator::Div];
        let id = match kind % 20 {
            0 => graph.add_constant(x),
            k @ 1..=4 => graph.add_operation(Operation::Binary(ops[k as usize - 1], a, b)),
            5 => {
                let power = graph.add_constant((x * 2.0).round());
                graph.add_operation(Operation::Two(numeric::find_numeric("pow").unwrap(), a, power))
            }
            k => {
                let row = numeric::find_numeric(rows[k as usize - 6]).unwrap();
                match numeric::TABLE[row as usize].kernel {
                    numeric::Kernel::One(_) => graph.add_operation(Operation::One(row, a)),
                    _ => graph.add_operation(Operation::Two(row, a, b)),
                }
            }
        };
        ids.push(id);
    }
    graph.result = ids[ids.len() - 1];
    graph
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 1000, max_global_rejects: 20_000, failure_persistence: None, ..ProptestConfig::default() })]

    /// Test: the difference of a function between two points of a box is at most the slope times their distance.
    #[test]
    fn slopes_bound_differences(
        recipe in prop::collection::vec((any::<u8>(), any::<u32>(), any::<u32>(), -2.0..2.0), 1..12),
        corner in prop::array::uniform3(-2.0..2.0),
        size in prop::array::uniform3(0.0..0.3),
        inner in prop::array::uniform3(0.0..1.0),
        other in prop::array::uniform3(0.0..1.0),
    ) {
        let graph = graph(&recipe);
        let boxes = [0, 1, 2].map(|i| Interval::new(corner[i], corner[i] + size[i]));
        let at = |s: [f64; 3]| [0, 1, 2].map(|i: usize| f64::min(corner[i] + s[i] * size[i], boxes[i].hi));
        let (p, q) = (at(inner), at(other));
        let value = |p: &[f64; 3]| crate::function::program::evaluate_recursively(&graph, p);
        let list = [0, 1, 2].map(|i| Slope::slope_of_parameter(i, boxes[i]));
        let slope = graph.slope_over_box(&list, &mut vec![]);
        let (a, b) = (value(&p), value(&q));
        let d = DVec3::from_array(q) - DVec3::from_array(p);
        let rise = slope.derivative_along(d);
        prop_assume!(a.is_finite() && b.is_finite() && rise.lo.is_finite() && rise.hi.is_finite());
        let every = (0..=8).all(|k| {
            let r = (DVec3::from_array(p) + d * (f64::from(k) / 8.0)).to_array();
            (0..graph.nodes.len() as Id).all(|id| {
                let mut part = graph.clone();
                part.result = id;
                crate::function::program::evaluate_recursively(&part, &r).is_finite()
            })
        });
        prop_assume!(every);
        // (atan2 jumps by a full turn, and most results that use it do not.)
        let turns = graph.nodes.iter().any(|n| matches!(n, Operation::Two(row, ..) if numeric::TABLE[*row as usize].name == "atan2"));
        prop_assume!(!turns);
        let slack = 1e-9 * (1.0 + a.abs() + b.abs());
        prop_assert!(slope.value.contains(a) && slope.value.contains(b));
        prop_assert!(b - a >= rise.lo - slack && b - a <= rise.hi + slack, "{a} {b} {rise:?} {graph:?}");
    }
}

#[test]
fn noise_gradients_are_within_their_bound() {
    use crate::math::noise::noise;
    for generator in [NoiseGenerator::Original, NoiseGenerator::RangeCorrected, NoiseGenerator::Perlin] {
        let at = |k: usize, m: usize| (k * m % 99_991) as f64 / 999.91 - 50.0;
        for k in 0..20_000 {
            let (p, step) =
                (DVec3::new(at(k, 7), at(k, 1009), at(k, 7919)), DVec3::new(at(k, 31), at(k, 13), at(k, 17)));
            let q = p + step.normalize_or(DVec3::X) * 1e-3;
            let rate = (noise(q, generator) - noise(p, generator)).abs() / 1e-3;
            assert!(rate < generator.max_gradient(), "{generator:?} {p} {q}");
        }
    }
}

/// Test: over balls of many sizes, noise is within the stated range, and differences between points are within the
/// bounds of its gradients.
#[test]
fn local_bounds_of_noise_hold() {
    for number in [1.0, 2.0, 3.0] {
        let callee = Callee::Internal(crate::function::internal::find_internal(78).unwrap());
        let at = |p: DVec3| callee.call_component(0, &[p.x, p.y, p.z, number]);
        let mut stream = crate::math::rng::Stream::new(&[number as u64]);
        let mut vector = |size: f64| DVec3::from([(); 3].map(|()| (2.0 * stream.next_random() - 1.0) * size));
        let mut bent = 0;
        for k in 0..20_000 {
            let (p, radius) = (vector(50.0), 0.5f64.powi(k % 12));
            let near = callee.value_bounds_near(&[p.x, p.y, p.z, number], radius)[0];
            bent += usize::from(near.gradient != DVec3::ZERO);
            let [a, b] = [(); 2].map(|()| p + vector(1.0).normalize() * radius * vector(1.0).x);
            let (fa, fb) = (at(a), at(b));
            assert!(near.range.contains(fa) && near.range.contains(fb), "{number} {p} {radius} {near:?}");
            let (expected, far) = (near.gradient.dot(b - a), near.steepest * a.distance(b));
            assert!((fb - fa - expected).abs() <= far + 1e-12, "{number} {p} {radius} {near:?}: {a} {b}");
        }
        assert!(bent > 10_000, "{bent}");
    }
}
