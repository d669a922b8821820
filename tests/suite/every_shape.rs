//! Properties of every shape in the table, on random shapes written in the scene language. A shape without a writer
//! here fails the tests.

use durer::math::{DVec3, Range, Ray, Transform, rng::Stream};
use durer::shape::{Hit, Hits, Kernel, Shape};
use durer::value::Family;
use durer::world::{Geometry, Leaf, SolidKind, SolidNode};
use durer::{interpreter, render, source};
use std::fmt::Write;

/// Number of shapes of each kind.
const COUNT: u64 = 40;

/// Seeded random numbers, and the text of shapes that are `size` times as large.
struct Dice {
    stream: Stream,
    size: f64,
}

impl Dice {
    fn between(&mut self, lo: f64, hi: f64) -> f64 {
        lo + (hi - lo) * self.stream.next_random()
    }

    fn below(&mut self, n: usize) -> usize {
        (self.stream.next_random() * n as f64) as usize
    }

    fn vector(&mut self, size: f64) -> DVec3 {
        DVec3::new(self.between(-size, size), self.between(-size, size), self.between(-size, size))
    }

    /// A length as text.
    fn length(&mut self, lo: f64, hi: f64) -> String {
        format!("{:e}", self.size * self.between(lo, hi))
    }

    /// A point as text.
    fn point(&mut self) -> String {
        let p = self.vector(1.0);
        self.written(p)
    }

    fn written(&self, p: DVec3) -> String {
        format!("<{:e}, {:e}, {:e}>", p.x * self.size, p.y * self.size, p.z * self.size)
    }

    fn flat(&self, x: f64, y: f64) -> String {
        format!("<{:e}, {:e}>", x * self.size, y * self.size)
    }

    /// Transform of a shape with a fixed size.
    fn scaled(&self) -> String {
        format!("scale {:e}", self.size)
    }

    /// Coefficients of a polynomial of this order, highest powers of x first, for lengths `size` times as long; they
    /// begin with `first` and continue at random.
    fn polynomial(&mut self, order: i32, first: &[f64]) -> String {
        let mut terms = vec![];
        for i in (0..=order).rev() {
            for j in (0..=order - i).rev() {
                for k in (0..=order - i - j).rev() {
                    let at = terms.len();
                    let c = first.get(at).copied().unwrap_or_else(|| self.between(-1.0, 1.0));
                    terms.push(format!("{:e}", c * self.size.powi(-i - j - k)));
                }
            }
        }
        format!("<{}>", terms.join(", "))
    }

    /// Corners around the centre, at ascending angles, closed.
    fn outline(&mut self, count: usize, aside: f64) -> String {
        let mut corners: Vec<String> = (0..count)
            .map(|k| {
                let angle = std::f64::consts::TAU * k as f64 / count as f64;
                let r = self.between(0.3, 0.6);
                self.flat(aside + r * durer::math::fp::cos(angle), r * durer::math::fp::sin(angle))
            })
            .collect();
        corners.push(corners[0].clone());
        format!("{}, {}", corners.len(), corners.join(", "))
    }

    /// A closed mesh of eight triangles: corner points, and three indices for each triangle.
    fn octahedron(&mut self) -> (Vec<String>, Vec<[usize; 3]>) {
        let corners: Vec<String> = (0..6)
            .map(|k| {
                let out = DVec3::AXES[k / 2] * if k % 2 == 0 { 1.0 } else { -1.0 };
                let p = out * self.between(0.4, 1.0) + self.vector(0.1);
                self.written(p)
            })
            .collect();
        let faces = (0..8).map(|k| [k & 1, 2 + (k >> 1 & 1), 4 + (k >> 2)]).collect();
        (corners, faces)
    }
}

/// Properties that are expected of a kind of shape.
#[derive(Clone, Copy, PartialEq)]
enum Is {
    /// Every line enters as often as it leaves.
    Solid,
    /// May have no inside.
    Surface,
    /// A solid whose normals are approximate or artificial.
    Bumpy,
    /// A surface whose normals are approximate or artificial.
    BumpySurface,
}

type Writer = fn(&mut Dice) -> String;

/// Every kind, and a writer of its parameters.
const WRITERS: &[(&str, Is, Writer)] = &[
    ("sphere", Is::Solid, |d| format!("{}, {}", d.point(), d.length(0.2, 1.0))),
    ("box", Is::Solid, |d| format!("{}, {}", d.point(), d.point())),
    ("cylinder", Is::Solid, |d| format!("{}, {}, {}", d.point(), d.point(), d.length(0.2, 0.7))),
    ("cone", Is::Solid, |d| format!("{}, {}, {}, {}", d.point(), d.length(0.3, 0.7), d.point(), d.length(0.0, 0.25))),
    ("torus", Is::Solid, |d| format!("{}, {}", d.length(0.6, 1.0), d.length(0.1, 0.5))),
    ("disc", Is::Surface, |d| format!("{}, {}, {}, {}", d.point(), d.point(), d.length(0.5, 1.0), d.length(0.0, 0.4))),
    ("plane", Is::Surface, |d| format!("{}, {}", d.point(), d.length(-1.0, 1.0))),
    ("triangle", Is::Surface, |d| format!("{}, {}, {}", d.point(), d.point(), d.point())),
    ("smooth_triangle", Is::BumpySurface, |d| {
        let corners = [d.vector(1.0), d.vector(1.0), d.vector(1.0)];
        let up = (corners[1] - corners[0]).cross(corners[2] - corners[0]).normalize();
        let sides = corners.map(|corner| {
            let normal = up + d.vector(0.3);
            format!("{}, {}", d.written(corner), d.written(normal))
        });
        sides.join(", ")
    }),
    ("polygon", Is::Surface, |d| d.outline(6, 0.0)),
    ("mesh", Is::Solid, |d| {
        let (corners, faces) = d.octahedron();
        let triangle =
            |f: &[usize; 3]| format!("triangle {{ {}, {}, {} }}", corners[f[0]], corners[f[1]], corners[f[2]]);
        format!("{} inside_vector <0.1, 0.2, 0.3>", faces.iter().map(triangle).collect::<String>())
    }),
    ("mesh2", Is::Solid, |d| {
        let (corners, faces) = d.octahedron();
        let faces: Vec<String> = faces.iter().map(|f| format!("<{}, {}, {}>", f[0], f[1], f[2])).collect();
        format!(
            "vertex_vectors {{ 6, {} }} face_indices {{ 8, {} }} inside_vector <0.1, 0.2, 0.3>",
            corners.join(", "),
            faces.join(", ")
        )
    }),
    ("text", Is::Solid, |d| {
        let word = ["durer", "o", "Ag&", "i8"][d.below(4)];
        format!("ttf \"timrom.ttf\" \"{word}\" {}, {}*x {}", d.between(0.1, 0.6), d.between(0.0, 0.3), d.scaled())
    }),
    ("blob", Is::Solid, |d| {
        let ball =
            |d: &mut Dice| format!("sphere {{ {}, {}, {} }} ", d.point(), d.length(0.5, 1.2), d.between(0.3, 1.5));
        let rod =
            format!("cylinder {{ {}, {}, {}, {} }}", d.point(), d.point(), d.length(0.4, 0.8), d.between(-0.8, 1.0));
        format!("threshold 0.2 {}{}{}{rod}", ball(d), ball(d), ball(d))
    }),
    ("quadric", Is::Surface, |d| {
        let s = d.size;
        let (squares, mixed, linear) = (d.vector(1.0), d.vector(1.0), d.vector(1.0));
        let three = |p: DVec3, by: f64| format!("<{:e}, {:e}, {:e}>", p.x * by, p.y * by, p.z * by);
        let constant = d.between(-1.0, 1.0);
        format!(
            "{}, {}, {}, {constant:e}",
            three(squares, 1.0 / (s * s)),
            three(mixed, 1.0 / (s * s)),
            three(linear, 1.0 / s)
        )
    }),
    ("cubic", Is::Surface, |d| d.polynomial(3, &[])),
    ("quartic", Is::Surface, |d| d.polynomial(4, &[])),
    ("poly", Is::Surface, |d| format!("5, {}", d.polynomial(5, &[]))),
    ("polynomial", Is::Surface, |d| {
        let s = d.size;
        let mut terms = String::new();
        for (i, j, k) in [(3, 0, 0), (1, 2, 0), (0, 0, 2), (0, 1, 0), (0, 0, 0)] {
            let c = d.between(-1.0, 1.0) * s.powi(-i - j - k);
            write!(terms, ", xyz({i}, {j}, {k}): {c:e}").unwrap();
        }
        format!("3{terms}")
    }),
    ("superellipsoid", Is::Solid, |d| format!("<{}, {}> {}", d.between(0.3, 1.5), d.between(0.3, 1.5), d.scaled())),
    ("lathe", Is::Solid, |d| format!("linear_spline {}", d.outline(6, 0.7))),
    ("sor", Is::Solid, |d| {
        let point = |d: &mut Dice, k: usize| {
            let (x, y) = (d.between(0.2, 1.0), 0.4 * k as f64 - 1.0 + d.between(0.0, 0.2));
            d.flat(x, y)
        };
        let points: Vec<String> = (0..6).map(|k| point(d, k)).collect();
        format!("6, {}", points.join(", "))
    }),
    ("prism", Is::Solid, |d| format!("{}, {}, {}", d.length(-0.8, -0.1), d.length(0.1, 0.8), d.outline(7, 0.0))),
    ("height_field", Is::Surface, |d| {
        let k = d.between(5.0, 15.0);
        format!("function 12, 12 {{ 0.5 + 0.4*sin({k}*x)*cos({k}*y) }} {}", d.scaled())
    }),
    ("isosurface", Is::Bumpy, |d| {
        let (k, a, s) = (d.between(1.0, 9.0), d.between(0.0, 0.3), d.size);
        // (`accuracy` is in units of the ray, which grows with the shape.)
        let inside = format!("(x*x + y*y + 1.3*z*z)/{:e} + {a}*sin({k}*x/{s:e})*sin({k}*y/{s:e})", s * s);
        format!(
            "function {{ {inside} - 0.6 }} contained_by {{ box {{ -{s:e}, {:e} }} }} accuracy 1e-5 all_intersections",
            0.9 * s
        )
    }),
    ("parametric", Is::BumpySurface, |d| {
        let (k, a) = (d.between(1.0, 4.0), d.between(0.0, 0.4));
        let scaled = d.scaled();
        format!(
            "function {{ u }}, function {{ {a}*sin({k}*u) + 0.3*u*v }}, function {{ v }} <-0.8, -0.9>, <0.7, 1> {scaled}"
        )
    }),
    ("sphere_sweep", Is::Bumpy, |d| {
        let kind = ["linear_spline 4", "cubic_spline 5", "b_spline 5"][d.below(3)];
        let count = if kind.ends_with('4') { 4 } else { 5 };
        let balls: Vec<String> = (0..count).map(|_| format!("{}, {}", d.point(), d.length(0.1, 0.3))).collect();
        format!("{kind}, {}", balls.join(", "))
    }),
    ("bicubic_patch", Is::BumpySurface, |d| {
        let points: Vec<String> = (0..16).map(|_| d.point()).collect();
        format!("type {} u_steps 3 v_steps 3, {}", d.below(2), points.join(", "))
    }),
    ("julia_fractal", Is::Bumpy, |d| {
        let c: Vec<String> = (0..4).map(|_| d.between(-0.5, 0.5).to_string()).collect();
        let kind = ["quaternion sqr", "quaternion cube", "hypercomplex sqr"][d.below(3)];
        format!("<{}> {kind} max_iteration {} precision 500 {}", c.join(", "), 3 + d.below(3), d.scaled())
    }),
    ("ovus", Is::Solid, |d| format!("{}, {}", d.length(0.3, 0.9), d.length(0.1, 0.5))),
];

fn written(count: u64, size: f64) -> String {
    let mut text = String::from("#version 3.7;\n");
    for (name, _, writer) in WRITERS {
        for seed in 0..count {
            let mut dice = Dice { stream: Stream::new(&[seed]), size };
            writeln!(text, "{name} {{ {} }}", writer(&mut dice)).unwrap();
        }
    }
    text
}

/// All shapes of the text with their transforms, in the order of the text.
fn leaves(count: u64, size: f64) -> Vec<SolidNode> {
    let sources = source::Sources::default();
    let file = durer::load_bytes(&sources, "shapes.scene", written(count, size).into_bytes()).unwrap();
    let built = durer::build(&sources, file, &interpreter::Options::default(), &mut |_| {});
    let Some(world) = &built.world else {
        panic!("{:?}", built.diagnostics.iter().map(|d| &d.message).take(5).collect::<Vec<_>>())
    };
    let mut items: Vec<SolidNode> = world.geometry.items().map(|item| item.node().clone()).collect();
    items.sort_by_key(|item| item.object);
    // (Nearly all have a surface.)
    assert!(items.len() * 100 >= WRITERS.len() * count as usize * 99);
    items
}

/// Each shape with its kind.
fn shapes() -> impl Iterator<Item = (&'static str, Is, Shape)> {
    leaves(COUNT, 1.0).into_iter().map(|node| {
        let (name, is, _) = WRITERS[node.object as usize / COUNT as usize];
        match node.kind() {
            SolidKind::Leaf(leaf) => (name, is, leaf.shape.clone()),
            _ => panic!("{name} is more than a leaf"),
        }
    })
}

fn rays(seed: u64, count: usize) -> Vec<Ray> {
    let mut dice = Dice { stream: Stream::new(&[seed, 1]), size: 1.0 };
    let mut ray = || {
        let from = dice.vector(4.0);
        Ray::new(from, dice.vector(1.0) - from)
    };
    (0..count).map(|_| ray()).collect()
}

fn hits(shape: &Shape, ray: &Ray, range: Range) -> Vec<Hit> {
    let mut all = Hits::new();
    shape.hits(ray, range, &mut all);
    all.sort_by(|a, b| a.t.total_cmp(&b.t));
    all.into_vec()
}

#[test]
fn every_shape_has_a_writer() {
    let names: Vec<&str> = WRITERS.iter().map(|row| row.0).collect();
    for spec in Shape::SPECS {
        assert!(names.contains(&spec.name), "`{}` has no writer in tests/suite/every_shape.rs", spec.name);
    }
    assert_eq!(names.len(), Shape::SPECS.len());
}

#[test]
fn hits_are_in_bounds_and_all_queries_agree() {
    let mut met = std::collections::BTreeMap::new();
    for (i, (name, _, shape)) in shapes().enumerate() {
        let bounds = shape.bounds().grown(1e-9);
        for ray in rays(i as u64, 40) {
            let half = Range { min: 0.2, max: 0.9 };
            for range in [Range::ALL, Range::FORWARD, half] {
                let all = hits(&shape, &ray, range);
                let near = |t: f64, u: f64| (t - u).abs() < 1e-8;
                let first = shape.closest(&ray, range).map(|hit| hit.t);
                let same = first.zip(all.first()).is_some_and(|(t, hit)| near(t, hit.t));
                assert!(
                    same || first.is_none() && all.is_empty(),
                    "{name} {shape:?} {ray:?} {range:?} {first:?} {all:?}"
                );
                assert_eq!(shape.any_hit(&ray, range), first.is_some(), "{name} {shape:?} {ray:?} {range:?}");
                for hit in &all {
                    assert!(
                        range.contains(hit.t) && bounds.contains(ray.at(hit.t)),
                        "{name} {shape:?} {ray:?} {hit:?}"
                    );
                    let n = shape.normal(ray.at(hit.t), hit);
                    assert!(n.is_finite() && n != DVec3::ZERO && shape.uv(ray.at(hit.t), hit).is_finite());
                }
                *met.entry(name).or_insert(0) += all.len();
            }
        }
    }
    assert!(met.len() == WRITERS.len() && met.values().all(|count| *count > 100), "{met:?}");
}

/// Hits are exactly where a line enters or leaves a solid; the normal is that of the plane through three neighbouring
/// hits.
#[test]
fn hits_are_at_the_boundary_of_the_inside() {
    for (i, (name, is, shape)) in shapes().enumerate() {
        if !matches!(is, Is::Solid | Is::Bumpy) {
            continue;
        }
        for ray in rays(i as u64, 30) {
            let all = hits(&shape, &ray, Range::ALL);
            assert!(all.len().is_multiple_of(2), "{name} {shape:?} {ray:?} {all:?}");
            let apart = |t: f64, by: f64| all.iter().all(|hit| (hit.t - t).abs() * ray.dir.length() > by);
            for k in 0..60 {
                let t = f64::from(k) * 0.0337;
                let parity = all.iter().filter(|hit| hit.t < t).count() % 2 == 1;
                let grazes = !apart(t, 1e-6) || shape.inside(ray.at(t)) != shape.inside(ray.at(t + 1e-9));
                assert!(grazes || parity == shape.inside(ray.at(t)), "{name} {shape:?} {ray:?} {t} {all:?}");
            }
        }
    }
}

/// The hit of a parallel ray on the same part.
fn beside(shape: &Shape, ray: &Ray, hit: &Hit, by: DVec3) -> Option<DVec3> {
    let moved = Ray::new(ray.origin + by, ray.dir);
    let near =
        |other: &&Hit| (other.t - hit.t).abs() * ray.dir.length() < 100.0 * by.length() && other.part == hit.part;
    let mut close = hits(shape, &moved, Range::ALL);
    close.retain(|other| near(&other));
    (close.len() == 1).then(|| moved.at(close[0].t))
}

#[test]
fn normals_match_planes_through_three_hits() {
    let mut tested = std::collections::BTreeMap::new();
    for (i, (name, is, shape)) in shapes().enumerate() {
        if matches!(is, Is::Bumpy | Is::BumpySurface) {
            continue;
        }
        let (mut right, mut wrong) = (0, vec![]);
        for ray in rays(i as u64, 40) {
            let (e1, e2) = ray.dir.normalize().any_orthonormal_pair();
            for hit in hits(&shape, &ray, Range::ALL) {
                let plane = |step: f64| {
                    let [a, b] = [e1, e2]
                        .map(|e| beside(&shape, &ray, &hit, e * step).zip(beside(&shape, &ray, &hit, -e * step)));
                    let (a, b) = a.zip(b)?;
                    Some((a.0 - a.1).cross(b.0 - b.1).normalize())
                };
                let Some((fine, coarse)) = plane(1e-5).zip(plane(2e-5)) else { continue };
                // (An edge, or a strongly curved point.)
                if fine.dot(coarse).abs() < 1.0 - 1e-8 {
                    continue;
                }
                let n = shape.normal(ray.at(hit.t), &hit).normalize();
                if n.dot(fine).abs() > 1.0 - 1e-5 { right += 1 } else { wrong.push((ray, hit, n, fine)) }
            }
        }
        assert!(wrong.len() * 50 <= right, "{name} {shape:?}: {right} right, {wrong:?}");
        *tested.entry(name).or_insert(0) += right;
    }
    assert!(tested.values().all(|count| *count > 50), "{tested:?}");
}

fn nested(dice: &mut Dice) -> Transform {
    (0..3).fold(Transform::IDENTITY, |m, _| {
        let scale = Transform::scale(dice.vector(1.0).map(|x| x.signum() * (0.4 + x.abs()))).unwrap();
        m.then(&scale).then(&Transform::rotate(dice.vector(180.0))).then(&Transform::translate(dice.vector(2.0)))
    })
}

/// A transformed shape is hit where it is in its own space; its normal is perpendicular to its tangents.
#[test]
fn hits_follow_nested_transforms() {
    for (i, (name, is, shape)) in shapes().enumerate() {
        let mut dice = Dice { stream: Stream::new(&[i as u64, 2]), size: 1.0 };
        let m = nested(&mut dice);
        // (A shape that stores its transform, or is rebuilt for it, is another shape in the outer space.)
        let there = shape.shape_under_transform(&m).into_owned();
        let node = SolidNode::leaf(Leaf::new(there, &m, 3), 3);
        let world = Geometry::new(vec![node.clone()]);
        for ray in rays(i as u64, 20) {
            let moved = Ray::new(m.transform_point(ray.origin), m.transform_vector(ray.dir));
            let found = world.closest(&moved, Range::FORWARD, |_| true);
            let expected = shape.closest(&ray, Range::FORWARD).map(|hit| hit.t);
            assert_eq!(world.any(&moved, Range::FORWARD, |_| true), found.is_some(), "{name}");
            let t = found.as_ref().map(|found| found.t());
            let same = t.zip(expected).is_some_and(|(a, b)| (a - b).abs() < 1e-6) || t.is_none() && expected.is_none();
            assert!(same, "{name} {shape:?} {ray:?} {t:?} {expected:?}");
            let Some(found) = found else { continue };
            let surface = found.surface(&moved);
            let size = 1e-7 * (1.0 + surface.point.length());
            assert!(node.bounds().grown(size).contains(surface.point), "{name} {surface:?}");
            assert!(surface.point.distance(moved.at(found.t())) < size);
            if is == Is::BumpySurface {
                continue;
            }
            let local = shape.normal(ray.at(found.t()), &found.hit).normalize();
            for flat in <[DVec3; 2]>::from(local.any_orthonormal_pair()) {
                assert!(
                    m.transform_vector(flat).normalize().dot(surface.normal).abs() < 1e-6,
                    "{name} {shape:?} {surface:?}"
                );
            }
        }
    }
}

/// A shape a million times smaller or larger has the same hits.
#[test]
fn hits_are_scale_invariant() {
    let normal = leaves(30, 1.0);
    for size in [1e-6, 1e6] {
        for (i, (node, other)) in normal.iter().zip(&leaves(30, size)).enumerate() {
            let name = WRITERS[node.object as usize / 30].0;
            for ray in rays(i as u64, 30) {
                let there = Ray::new(ray.origin * size, ray.dir * size);
                let [a, b] = [node.closest(&ray, Range::FORWARD), other.closest(&there, Range::FORWARD)];
                let [a, b] = [a, b].map(|found| found.map(|found| found.t()));
                let same = a.zip(b).is_some_and(|(a, b)| (a - b).abs() < 1e-6) || a.is_none() && b.is_none();
                assert!(same, "{name} {size} {node:?} {ray:?} {a:?} {b:?}");
            }
        }
    }
}

/// A picture of a shape on a mirror with its shadow, all `size` times as large.
fn picture(name: &str, words: &str, size: f64) -> Vec<[f32; 4]> {
    let text = format!(
        "#version 3.7; global_settings {{ assumed_gamma 1 max_trace_level 4 }}
        camera {{ location <0.7, 1.5, -4>*{size:e} look_at 0 }}
        light_source {{ <3, 5, -4>*{size:e} rgb 1 }}
        {name} {{ {words} pigment {{ rgb <1, 0.7, 0.3> }} finish {{ specular 0.5 }} }}
        box {{ <-3, -1.6, -3>, <3, -1.5, 3> pigment {{ checker rgb 1 rgb 0.2 }} finish {{ reflection 0.4 }} scale {size:e} }}"
    );
    let sources = source::Sources::default();
    let file = durer::load_bytes(&sources, "size.scene", text.into_bytes()).unwrap();
    let world = durer::build(&sources, file, &interpreter::Options::default(), &mut |_| {}).world.unwrap();
    render::render(&world, &render::Options::new(32, 24), &render::Unwatched).unwrap().0.pixels
}

/// A scene a million times smaller or larger gives the same picture. (Planes end at 1e7, as in POV-Ray; and in scenes
/// of a size between 0.0001 and 0.1 the minimum distances of hits, 0.0001, and of shadows, 0.001, have an effect.)
#[test]
fn pictures_are_scale_invariant() {
    for (name, _, writer) in WRITERS {
        let written = |size| writer(&mut Dice { stream: Stream::new(&[7]), size });
        // (`accuracy` is a length in world space, whatever the scale.)
        let scaled = |size: f64| match *name {
            "isosurface" => format!("{} accuracy {:e}", written(size), 1e-5 * size),
            _ => format!("{} scale {size:e}", written(1.0)),
        };
        let usual = picture(name, &scaled(1.0), 1.0);
        for size in [1e-6, 1e-5, 1e3, 1e6] {
            if *name == "plane" && size > 1.0 {
                continue;
            }
            let words = scaled(size);
            let other = picture(name, &words, size);
            let differ = |(a, b): &(&[f32; 4], &[f32; 4])| a.iter().zip(*b).any(|(a, b)| (a - b).abs() > 1.0 / 255.0);
            let count = usual.iter().zip(&other).filter(differ).count();
            assert!(count <= 4, "{name} {size}: {count} of {} pixels differ: {words}", usual.len());
        }
    }
}
