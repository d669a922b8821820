//! Random shapes, transforms, rays and trees.

use durer::function::{Body, Function, Graph, Id, Operation, Program, numeric};
use durer::math::{DVec2, DVec3, Range, Ray, Transform, fp, rng};
use durer::shape::*;
use durer::syntax::ast::Operator;
use durer::world::{Leaf, SolidNode};

/// Seeded random numbers.
pub struct Dice {
    seed: u64,
    count: u64,
}

impl Dice {
    pub fn new(seed: u64) -> Self {
        Self { seed, count: 0 }
    }

    pub fn unit(&mut self) -> f64 {
        self.count += 1;
        rng::random_unit(&[self.seed, self.count])
    }

    pub fn between(&mut self, lo: f64, hi: f64) -> f64 {
        lo + (hi - lo) * self.unit()
    }

    pub fn below(&mut self, n: usize) -> usize {
        (self.unit() * n as f64) as usize
    }

    pub fn vector(&mut self, size: f64) -> DVec3 {
        DVec3::new(self.between(-size, size), self.between(-size, size), self.between(-size, size))
    }

    /// A closed solid.
    pub fn solid(&mut self) -> Shape {
        let (p, size) = (self.vector(1.0), self.between(0.2, 1.0));
        let q = p + self.vector(1.0) + DVec3::Y * 0.1;
        match self.below(15) {
            12 => self.sweep(),
            13 => Shape::from(Ovus::new(self.between(0.2, 1.0), self.between(0.0, 1.2))),
            14 => self.isosurface(),
            6 => self.superellipsoid(),
            7 => self.lathe(),
            8 => self.sor(),
            9 => self.prism(),
            10 => self.egg(),
            11 => self.ring(),
            0 => Shape::from(Sphere { center: p, radius: size }),
            1 => Shape::from(Cuboid::new(p, q)),
            2 => Shape::from(Cylinder::new(p, q, size, false)),
            3 => Shape::from(Cone::new(p, size, q, self.between(0.0, 1.0), false)),
            4 => Shape::from(Cone::new(p, 0.0, p + DVec3::X, size, false)),
            _ => Shape::from(Torus { major: 0.6 + size, minor: self.between(0.05, 0.55) }),
        }
    }

    /// Sixteen points anywhere, some of them the same.
    pub fn patch(&mut self) -> Shape {
        let mut points: [DVec3; 16] = std::array::from_fn(|_| self.vector(1.0));
        if self.below(3) == 0 {
            points[..4].fill(DVec3::Y);
        }
        let flatness = [0.0, self.between(0.0, 0.3)][self.below(2)];
        Shape::from(BicubicPatch::new(points, self.below(4) as u32, self.below(4) as u32, flatness))
    }

    /// A chain of balls; the path may turn sharply and intersect itself.
    pub fn sweep(&mut self) -> Shape {
        let kind = [SweepKind::Linear, SweepKind::BSpline, SweepKind::Cubic][self.below(3)];
        let balls: Vec<(DVec3, f64)> =
            (0..4 + self.below(5)).map(|_| (self.vector(1.2), self.between(0.1, 0.4))).collect();
        Shape::from(SphereSweep::new(kind, &balls))
    }

    /// From square to pointed; a star's tips have no normal.
    pub fn superellipsoid(&mut self) -> Shape {
        let mut exponent = || [self.between(0.05, 1.0), self.between(0.2, 1.9)][self.below(2)];
        Shape::from(Superellipsoid { e: exponent(), n: exponent() })
    }

    /// Points around the centre, at ascending angles.
    pub fn outline(&mut self, count: usize) -> Vec<DVec2> {
        let corner = |dice: &mut Dice, k: usize| {
            let angle = std::f64::consts::TAU * k as f64 / count as f64;
            DVec2::new(fp::cos(angle), fp::sin(angle)) * dice.between(0.5, 1.2)
        };
        (0..count).map(|k| corner(self, k)).collect()
    }

    /// A closed curve beside the axis, of any kind.
    pub fn lathe(&mut self) -> Shape {
        let moved: Vec<DVec2> = self.outline(6).iter().map(|p| *p * 0.5 + DVec2::X * 0.7).collect();
        let (kind, points) = self.closed(&moved);
        Shape::from(Lathe::new(kind, &points))
    }

    /// The points of a closed curve of any kind.
    pub fn closed(&mut self, p: &[DVec2]) -> (Interpolation, Vec<DVec2>) {
        let n = p.len();
        let row = |from: usize, count: usize| (from..from + count).map(|k| p[k % n]).collect();
        match self.below(4) {
            0 => (Interpolation::Linear, row(0, n + 1)),
            1 => (Interpolation::Quadratic, row(0, n + 2)),
            2 => (Interpolation::Cubic, row(0, n + 3)),
            _ => {
                let piece = |k: usize| [p[k], p[k] * 1.1, p[(k + 1) % n] * 0.9, p[(k + 1) % n]];
                (Interpolation::Bezier, (0..n).flat_map(piece).collect())
            }
        }
    }

    pub fn sor(&mut self) -> Shape {
        let point = |dice: &mut Dice, k: usize| {
            DVec2::new(dice.between(0.2, 1.0), 0.4 * k as f64 - 1.0 + dice.between(0.0, 0.2))
        };
        Shape::from(Sor::new((0..6).map(|k| point(self, k)).collect(), false))
    }

    pub fn prism(&mut self) -> Shape {
        let outline = self.outline(7);
        let (kind, points) = self.closed(&outline);
        let conic = self.below(3) == 0;
        let bottom = if conic { self.between(0.2, 0.5) } else { self.between(-0.8, 0.1) };
        Shape::from(Prism::new(kind, conic, [bottom, bottom + self.between(0.3, 1.0)], &points, false))
    }

    /// An ellipsoid, turned and moved.
    pub fn egg(&mut self) -> Shape {
        let squares = DVec3::ONE + self.vector(0.3);
        let (mixed, linear) = (self.vector(0.6), self.vector(1.0));
        Shape::from(Quadric::new(squares, mixed, linear, self.between(-1.0, -0.1)))
    }

    /// A torus as a polynomial; the polynomial's inside margin of 1e-4 is small against its large coefficients.
    pub fn ring(&mut self) -> Shape {
        let (major2, minor2) = (self.between(0.6, 1.2), self.between(0.05, 0.3));
        let (a, b, c) = (-2.0 * (major2 + minor2), 2.0 * (major2 - minor2), (major2 - minor2).powi(2));
        let mut terms = vec![0.0; 35];
        // x⁴, x²y², x²z², x², y⁴, y²z², y², z⁴, z², 1
        let places = [(0, 1.0), (4, 2.0), (7, 2.0), (9, a), (20, 1.0), (23, 2.0), (25, b), (30, 1.0), (32, a), (34, c)];
        places.iter().for_each(|(at, value)| terms[*at] = value * 1e4);
        Shape::from(Quartic::new(4, terms))
    }

    /// a·x² + b·y² + c·z² + d·sin(k·x)·sin(k·y) - 0.6 < 0, in a box or a ball.
    pub fn isosurface(&mut self) -> Shape {
        let (factors, k) = (DVec3::splat(1.1) + self.vector(0.5), self.between(0.0, 9.0));
        let wave = self.between(0.0, 0.4);
        let function = formula(|g, [x, y, z]| {
            let squares = [(x, factors.x), (y, factors.y), (z, factors.z)].map(|(x, factor)| {
                let square = two(g, Operator::Mul, x, x);
                scaled(g, factor, square)
            });
            let waves = [x, y].map(|x| {
                let x = scaled(g, k, x);
                g.add_operation(Operation::One(numeric::find_numeric("sin").unwrap(), x))
            });
            let waves = two(g, Operator::Mul, waves[0], waves[1]);
            let waves = scaled(g, wave, waves);
            squares.into_iter().fold(waves, |sum, square| two(g, Operator::Add, sum, square))
        });
        let container = match self.below(2) {
            0 => Container::Box(Cuboid::new(DVec3::splat(-0.9), DVec3::new(1.0, 0.7, 0.9))),
            _ => Container::Sphere(Sphere { center: DVec3::X * 0.1, radius: 0.9 }),
        };
        let mut surface = Isosurface::new(function);
        (surface.threshold, surface.container) = (0.6, container);
        (surface.accuracy, surface.max_trace) = (1e-6, u32::MAX);
        Shape::from(surface)
    }

    pub fn height_field(&mut self) -> Shape {
        let (width, depth) = (2 + self.below(20), 2 + self.below(20));
        let heights = (0..width * depth).map(|_| (self.unit() * 65535.0) as u16).collect();
        let water = [0.0, self.unit()][self.below(2)];
        Shape::from(HeightField::new(width, heights, self.below(2) == 0, water))
    }

    /// <u, a·u·v + b·sin(k·u), v>
    pub fn parametric(&mut self) -> Shape {
        let (twist, wave, k) = (self.between(-0.5, 0.5), self.between(0.0, 0.4), self.between(1.0, 4.0));
        let height = formula(|g, [u, v, _]| {
            let product = two(g, Operator::Mul, u, v);
            let product = scaled(g, twist, product);
            let turned = scaled(g, k, u);
            let sine = g.add_operation(Operation::One(numeric::find_numeric("sin").unwrap(), turned));
            let sine = scaled(g, wave, sine);
            two(g, Operator::Add, product, sine)
        });
        let functions = [formula(|_, [u, _, _]| u), height, formula(|_, [_, v, _]| v)];
        Shape::from(Parametric::new(functions, DVec2::new(-0.8, -0.9), DVec2::new(0.7, 1.0)))
    }

    /// Any shape.
    pub fn shape(&mut self) -> Shape {
        let (p, q, r) = (self.vector(1.0), self.vector(1.0), self.vector(1.0));
        let flat = Triangle::new(p, q, r);
        match self.below(21) {
            11 => self.patch(),
            12 => self.height_field(),
            13 => self.parametric(),
            0 => Shape::from(Disc::new(p, q, 1.0, 0.3)),
            1 => Shape::from(Plane::new(q, self.between(-1.0, 1.0)).unwrap()),
            2 => Shape::from(flat),
            3 => {
                let mut normal = || flat.face_normal().normalize() + self.vector(0.3);
                Shape::from(SmoothTriangle::new(flat, [normal(), normal(), normal()]))
            }
            4 => {
                let corners = [(0.0, 0.0), (1.0, 0.0), (0.3, 0.3), (0.0, 1.0), (0.0, 0.0)];
                Shape::from(Polygon::new(&corners.map(|(x, y)| DVec3::new(x, y, 0.5))))
            }
            5 => Shape::from(Cylinder::new(p, p + DVec3::Y, 0.4, true)),
            6 => Shape::from(Cone::new(p, -0.4, p + DVec3::Z, 0.6, self.unit() < 0.5)),
            7 => Shape::from(Cuboid::new(p.with_z(0.0), q.with_z(0.0))),
            8 => Shape::from(Quadric::new(p, q, r, self.between(-1.0, 1.0))),
            10 => Shape::from(Superellipsoid { e: self.between(0.5, 4.0), n: self.between(0.5, 4.0) }),
            9 => Shape::from(Cubic::new(3, (0..20).map(|_| self.between(-1.0, 1.0)).collect())),
            _ => self.solid(),
        }
    }

    /// Translation, rotation and a scale that is not the same on all axes.
    pub fn transform(&mut self) -> Transform {
        let scale = Transform::scale(self.vector(1.0).map(|x| x.signum() * (0.3 + x.abs()))).unwrap();
        match self.below(4) {
            0 => Transform::IDENTITY,
            1 => Transform::translate(self.vector(3.0)),
            _ => scale.then(&Transform::rotate(self.vector(180.0))).then(&Transform::translate(self.vector(3.0))),
        }
    }

    pub fn leaf(&mut self, shape: Shape) -> SolidNode {
        let id = (self.unit() * 1e6) as u32;
        SolidNode::leaf(Leaf::new(shape, &self.transform(), id), id)
    }

    /// A tree of at most `depth` levels, of any shapes.
    pub fn tree(&mut self, depth: usize) -> SolidNode {
        self.tree_of(depth, 7, Dice::shape)
    }

    /// A tree with the first `kinds` kinds of nodes: leaf, union, merge, intersection, difference, clipped union.
    pub fn tree_of(&mut self, depth: usize, kinds: usize, shape: fn(&mut Dice) -> Shape) -> SolidNode {
        let kind = if depth == 0 { 0 } else { self.below(kinds) };
        if kind < 2 {
            let shape = shape(self);
            let leaf = self.leaf(shape);
            return if self.below(8) == 0 { leaf.inverted() } else { leaf };
        }
        let count = if self.below(10) == 0 { 12 } else { 2 + self.below(2) };
        let children = (0..count).map(|_| self.tree_of(depth - 1, kinds, shape)).collect();
        let object = self.below(1000) as u32;
        match kind {
            2 => SolidNode::union(children, object),
            3 => SolidNode::merge(children, object),
            4 => SolidNode::intersection(children, object),
            5 => SolidNode::difference(children, object),
            _ => SolidNode::union(children, object).clipped(vec![self.tree_of(0, kinds, shape)]),
        }
    }

    /// A random ray near the origin; often along an axis, and then from a point of a coarse grid.
    pub fn ray(&mut self) -> Ray {
        let axis = DVec3::AXES[self.below(3)] * if self.below(2) == 0 { 1.0 } else { -1.0 };
        match self.below(4) {
            0 => Ray::new((self.vector(3.0) * 2.0).round() / 2.0, axis),
            1 => Ray::new(self.vector(3.0), axis * 3.0),
            2 => {
                let from = self.vector(100.0);
                Ray::new(from, (self.vector(2.0) - from).normalize())
            }
            _ => {
                let from = self.vector(4.0);
                Ray::new(from, self.vector(2.0) - from)
            }
        }
    }

    pub fn range(&mut self) -> Range {
        let min = self.between(-1.0, 1.0);
        [Range::ALL, Range::FORWARD, Range { min, max: min + self.between(0.0, 5.0) }][self.below(3)]
    }
}

fn two(g: &mut Graph, op: Operator, a: Id, b: Id) -> Id {
    g.add_operation(Operation::Binary(op, a, b))
}

fn scaled(g: &mut Graph, factor: f64, x: Id) -> Id {
    let factor = g.add_constant(factor);
    two(g, Operator::Mul, factor, x)
}

/// A function of three numbers.
fn formula(make: impl FnOnce(&mut Graph, [Id; 3]) -> Id) -> Formula {
    let mut graph = Graph::default();
    let parameters = [0, 1, 2].map(|i| graph.add_operation(Operation::Parameter(i)));
    graph.result = make(&mut graph, parameters);
    let body = Body::Numeric(Program::new(graph, 3).unwrap());
    Formula::new(Function { parameters: ["x", "y", "z"].map(Into::into).into(), body })
}
