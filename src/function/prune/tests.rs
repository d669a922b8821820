use super::super::program::evaluate_recursively;
use super::super::program::tests::{Recipe, recipe, recipe_graph};
use super::*;
use proptest::prelude::*;

type Box3 = [Interval; 3];

fn function(graph: Graph) -> Function {
    let program = Program::new(graph, 3).unwrap();
    Function { parameters: ["x", "y", "z"].map(Into::into).into(), body: Body::Numeric(program) }
}

fn pruned_in(function: &Function, over: &Box3) -> Function {
    let mut slopes = vec![];
    function.slope_over_box(over, &mut slopes);
    function.pruned(&function.find_replacements(over, &slopes)).unwrap()
}

fn graph_of(function: &Function) -> &Graph {
    let Body::Numeric(program) = &function.body else { panic!("not numeric") };
    program.graph()
}

/// Number of operations that contribute to the function's result, without parameters and constants.
fn operation_count(function: &Function) -> usize {
    let graph = graph_of(function);
    let mut needs = vec![false; graph.nodes.len()];
    needs[graph.result as usize] = true;
    for id in (0..graph.nodes.len()).rev().filter(|id| *id <= graph.result as usize) {
        if needs[id] {
            graph.nodes[id].for_each_operand(|id| needs[id as usize] = true);
        }
    }
    let counts = |node: &Operation| !matches!(node, Operation::Constant(_) | Operation::Parameter(_));
    graph.nodes.iter().zip(needs).filter(|(node, needed)| *needed && counts(node)).count()
}

fn check_same_bits(
    function: &Function,
    corner: [f64; 3],
    size: [f64; 3],
    points: &[[f64; 3]],
) -> std::result::Result<(), TestCaseError> {
    let over = [0, 1, 2].map(|i| Interval::new(corner[i], corner[i] + size[i]));
    let pruned = pruned_in(function, &over);
    for inner in points {
        let p = [0, 1, 2].map(|i: usize| f64::min(corner[i] + inner[i] * size[i], over[i].hi));
        let (wanted, found) = (function.call_component(0, &p), pruned.call_component(0, &p));
        let same = wanted.to_bits() == found.to_bits() || wanted.is_nan() && found.is_nan();
        prop_assert!(same, "{wanted} {found} at {p:?} in {over:?}: {:?}", graph_of(function).nodes);
        let reference = evaluate_recursively(graph_of(&pruned), &p);
        prop_assert!(reference.to_bits() == found.to_bits() || reference.is_nan() && found.is_nan());
    }
    Ok(())
}

/// Points of the unit cube: some inside, and its corners, where intervals touch.
fn points() -> impl Strategy<Value = Vec<[f64; 3]>> {
    let coordinate = prop_oneof![3 => 0.0..1.0, 1 => Just(0.0), 1 => Just(1.0), 1 => Just(0.5)];
    prop::collection::vec(prop::array::uniform3(coordinate), 8)
}

/// A graph mostly of operations that pruning can replace.
fn csg_recipe() -> impl Strategy<Value = Recipe> {
    let kinds = vec![0u8, 1, 2, 3, 3, 4, 4, 6, 7, 8, 10, 12, 13, 14, 15, 18, 19, 20, 20, 20, 20, 21, 21, 21, 21];
    let operation = (prop::sample::select(kinds), any::<u32>(), any::<u32>(), any::<u32>(), -3.0..3.0);
    prop::collection::vec(operation, 1..40)
}

/// A corner of a box; often at 0, so that both signs of 0 occur.
fn corner() -> impl Strategy<Value = [f64; 3]> {
    prop::array::uniform3(prop_oneof![4 => -2.0..2.0, 1 => Just(0.0), 1 => Just(-0.0), 1 => Just(-0.5)])
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 2000, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn pruned_functions_give_the_same_bits(
        recipe in recipe(),
        corner in corner(),
        size in prop::array::uniform3(0.0..1.0),
        points in points(),
    ) {
        check_same_bits(&function(recipe_graph(&recipe)), corner, size, &points)?;
    }

    #[test]
    fn pruned_minima_and_maxima_give_the_same_bits(
        recipe in csg_recipe(),
        corner in corner(),
        size in prop::array::uniform3(prop_oneof![0.0..0.3, Just(0.5)]),
        points in points(),
    ) {
        check_same_bits(&function(recipe_graph(&recipe)), corner, size, &points)?;
    }

    #[test]
    fn pruned_callees_give_the_same_bits(
        inner in csg_recipe(),
        outer in csg_recipe(),
        corner in corner(),
        size in prop::array::uniform3(0.0..0.3),
        points in points(),
    ) {
        check_same_bits(&function(calling_graph(&inner, &outer)), corner, size, &points)?;
    }
}

/// Builds min(F(a, x, y), F(z, y, x)) of a called function F and a result `a` of other operations.
fn calling_graph(inner: &Recipe, outer: &Recipe) -> Graph {
    let callee = Callee::Function(Arc::new(function(recipe_graph(inner))));
    let mut graph = recipe_graph(outer);
    let [x, y, z] = [0, 1, 2].map(|i| graph.add_operation(Operation::Parameter(i)));
    let first = graph.add_call_component(callee.clone(), 0, [graph.result, x, y].into());
    let second = graph.add_call_component(callee, 0, [z, y, x].into());
    graph.result = two(&mut graph, "min", first, second);
    graph
}

fn one(graph: &mut Graph, name: &str, a: Id) -> Id {
    graph.add_operation(Operation::One(numeric::find_numeric(name).unwrap(), a))
}

fn two(graph: &mut Graph, name: &str, a: Id, b: Id) -> Id {
    graph.add_operation(Operation::Two(numeric::find_numeric(name).unwrap(), a, b))
}

fn binary(graph: &mut Graph, op: Operator, a: Id, b: Id) -> Id {
    graph.add_operation(Operation::Binary(op, a, b))
}

fn parameters(graph: &mut Graph) -> [Id; 3] {
    [0, 1, 2].map(|i| graph.add_operation(Operation::Parameter(i)))
}

/// Adds sqrt((x - center)² + y² + z²) - 1 to the graph: 8 operations, of which spheres share 3, if `center` is not 0.
fn add_sphere(graph: &mut Graph, center: f64) -> Id {
    let [x, y, z] = parameters(graph);
    let (center, radius) = (graph.add_constant(center), graph.add_constant(1.0));
    let x = binary(graph, Operator::Sub, x, center);
    let [x, y, z] = [x, y, z].map(|x| binary(graph, Operator::Mul, x, x));
    let yz = binary(graph, Operator::Add, y, z);
    let sum = binary(graph, Operator::Add, x, yz);
    let distance = one(graph, "sqrt", sum);
    binary(graph, Operator::Sub, distance, radius)
}

fn three_spheres(name: &str) -> Graph {
    let mut graph = Graph::default();
    let [a, b, c] = [-10.0, 1.0, 10.0].map(|center| add_sphere(&mut graph, center));
    let ab = two(&mut graph, name, a, b);
    graph.result = two(&mut graph, name, ab, c);
    graph
}

fn cube(center: [f64; 3], half: f64) -> Box3 {
    center.map(|x| Interval::new(x - half, x + half))
}

#[test]
fn one_of_three_distant_spheres_remains() {
    let whole = function(three_spheres("min"));
    assert_eq!(operation_count(&whole), 3 * 8 - 2 * 3 + 2);
    for x in [-9.0, 0.1, 9.0] {
        let pruned = pruned_in(&whole, &cube([x, 0.0, 0.2], 0.3));
        assert_eq!(operation_count(&pruned), 8);
        assert_eq!(pruned.call_component(0, &[x, 0.1, 0.2]), whole.call_component(0, &[x, 0.1, 0.2]));
    }
    // Two are near; over all, nothing is decided.
    assert_eq!(operation_count(&pruned_in(&whole, &cube([5.5, 0.0, 0.0], 0.3))), 2 * 8 - 3 + 1);
    assert_eq!(operation_count(&pruned_in(&whole, &cube([0.0; 3], 20.0))), operation_count(&whole));
    // The maximum is that of the most distant one.
    assert_eq!(operation_count(&pruned_in(&function(three_spheres("max")), &cube([8.0, 0.0, 0.0], 0.3))), 8);
}

/// Test: in `min(min(a, b), c)`, `a` overlaps `b`, but is always larger than `c`; `b` overlaps `c`.
#[test]
fn an_operand_is_dropped_by_a_minimum_further_up() {
    let mut graph = Graph::default();
    let [x, y, z] = parameters(&mut graph);
    let (one_, half) = (graph.add_constant(1.5), graph.add_constant(0.5));
    let x2 = binary(&mut graph, Operator::Mul, x, x);
    let a = binary(&mut graph, Operator::Add, x2, one_);
    let b = binary(&mut graph, Operator::Add, y, half);
    let ab = two(&mut graph, "min", a, b);
    graph.result = two(&mut graph, "min", ab, z);
    let pruned = pruned_in(&function(graph), &[Interval::new(0.0, 1.0), Interval::new(0.0, 2.0), Interval::TRUTH]);
    assert_eq!(operation_count(&pruned), 2);
}

#[test]
fn decided_conditions_and_absolute_values_disappear() {
    // x > 0 & y > 0 ? abs(x) : sin(y)
    let mut graph = Graph::default();
    let [x, y, _] = parameters(&mut graph);
    let zero = graph.add_constant(0.0);
    let [a, b] = [x, y].map(|x| binary(&mut graph, Operator::Greater, x, zero));
    let both = binary(&mut graph, Operator::And, a, b);
    let (yes, no) = (one(&mut graph, "abs", x), one(&mut graph, "sin", y));
    graph.result = graph.add_operation(Operation::Choice(both, yes, no));
    let whole = function(graph);
    assert_eq!(operation_count(&pruned_in(&whole, &cube([1.0; 3], 0.5))), 0);
    assert_eq!(operation_count(&pruned_in(&whole, &cube([1.0, -1.0, 0.0], 0.5))), 1);
    // The sign of x is known, but not that of y.
    assert_eq!(operation_count(&pruned_in(&whole, &cube([1.0, 0.0, 0.0], 0.5))), 4);
    assert_eq!(operation_count(&pruned_in(&whole, &cube([0.0; 3], 0.5))), 6);
}

/// Function that adds the two operands of a minimum to a graph with these parameters.
type MakeOperands<'a> = &'a dyn Fn(&mut Graph, [Id; 3]) -> (Id, Id);

/// Test: where an operand can be NaN or unbounded, or where operands can be equal, nothing is decided.
#[test]
fn doubtful_minima_remain() {
    let over = [Interval::new(0.0, 1.0), Interval::new(1.0, 2.0), Interval::new(-0.5, 0.5)];
    let remains = |make: MakeOperands| {
        let mut graph = Graph::default();
        let p = parameters(&mut graph);
        let (a, b) = make(&mut graph, p);
        graph.result = two(&mut graph, "min", a, b);
        let function = function(graph);
        operation_count(&pruned_in(&function, &over)) == operation_count(&function)
    };
    // The intervals touch.
    assert!(remains(&|_, [x, y, _]| (x, y)));
    // tanh(sqrt(z)) is less than 1, or NaN.
    assert!(remains(&|graph, [_, y, z]| {
        let root = one(graph, "sqrt", z);
        let (small, y) = (one(graph, "tanh", root), binary(graph, Operator::Add, y, y));
        (small, y)
    }));
    // (x - x)/(x - x) is 0/0, which is NaN.
    assert!(remains(&|graph, [x, y, _]| {
        let zero = binary(graph, Operator::Sub, x, x);
        (binary(graph, Operator::Div, zero, zero), y)
    }));
    // 1/z is unbounded.
    assert!(remains(&|graph, [_, y, z]| {
        let one_ = graph.add_constant(1.0);
        let over = binary(graph, Operator::Div, one_, z);
        let over = two(graph, "max", over, y);
        (over, z)
    }));
}

#[test]
fn a_callee_that_loses_is_not_called_and_others_are_pruned() {
    let callee = |graph| Callee::Function(Arc::new(function(graph)));
    let mut graph = Graph::default();
    let [x, y, z] = parameters(&mut graph);
    let spheres = graph.add_call_component(callee(three_spheres("min")), 0, [x, y, z].into());
    let four = graph.add_constant(4.0);
    let distant = binary(&mut graph, Operator::Add, y, four);
    let other = graph.add_call_component(callee(three_spheres("max")), 0, [x, distant, z].into());
    graph.result = two(&mut graph, "min", spheres, other);
    let whole = function(graph);
    // The call is inlined: one sphere of three remains.
    let pruned = pruned_in(&whole, &cube([0.1, 0.0, 0.0], 0.3));
    assert_eq!(operation_count(&pruned), 8);
    assert!(graph_of(&pruned).callees.is_empty());
}
