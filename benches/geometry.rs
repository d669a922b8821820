//! Building the hierarchy and finding the closest hit: `cargo bench -p durer-benches --bench geometry`.

use criterion::{BatchSize, Criterion, criterion_group, criterion_main};
use durer::math::{DVec3, Range, Ray, Transform, fp, rng};
use durer::shape::{Shape, Sphere, Torus};
use durer::world::{Geometry, Leaf, SolidNode};
use std::hint::black_box;

fn random_vector(i: u64, dimension: u64) -> DVec3 {
    let unit = |axis| rng::random_unit(&[i, dimension, axis]) * 2.0 - 1.0;
    DVec3::new(unit(0), unit(1), unit(2))
}

/// Spheres of about the size that leaves gaps between them, in the cube from -1 to 1.
fn spheres(n: u64) -> Vec<SolidNode> {
    let radius = 0.4 / fp::pow(n as f64, 1.0 / 3.0);
    let sphere = |i| Sphere { center: random_vector(i, 0), radius: radius * (0.5 + rng::random_unit(&[i, 1])) };
    let leaf = |i| Leaf::new(Shape::from(sphere(i)), &Transform::IDENTITY, i as u32);
    (0..n).map(|i| SolidNode::leaf(leaf(i), i as u32)).collect()
}

/// The rays of a camera in front of the cube, row by row.
fn coherent(side: usize) -> Vec<Ray> {
    let eye = DVec3::new(0.0, 0.0, -4.0);
    let at = |k: usize| k as f64 / side as f64 * 2.0 - 1.0;
    let ray = |k: usize| Ray::new(eye, DVec3::new(at(k % side), at(k / side), 2.4).normalize());
    (0..side * side).map(ray).collect()
}

/// From everywhere to everywhere.
fn incoherent(n: u64) -> Vec<Ray> {
    (0..n).map(|i| Ray::new(random_vector(i, 2), random_vector(i, 3).normalize())).collect()
}

fn hits(geometry: &Geometry, rays: &[Ray]) -> usize {
    rays.iter().filter(|ray| geometry.closest(ray, Range::FORWARD, |_| true).is_some()).count()
}

fn build(c: &mut Criterion) {
    let mut group = c.benchmark_group("build");
    group.sample_size(10);
    group.bench_function("100k spheres", |b| {
        b.iter_batched(|| spheres(100_000), |nodes| black_box(Geometry::new(nodes)), BatchSize::LargeInput);
    });
    group.finish();
}

fn closest(c: &mut Criterion) {
    let (camera, random) = (coherent(100), incoherent(10_000));
    let mut group = c.benchmark_group("closest, 10 000 rays");
    group.sample_size(20);
    for (name, n) in [("10k", 10_000), ("1M", 1_000_000)] {
        let geometry = Geometry::new(spheres(n));
        group.bench_function(format!("{name} spheres, coherent"), |b| b.iter(|| hits(&geometry, black_box(&camera))));
        group.bench_function(format!("{name} spheres, incoherent"), |b| b.iter(|| hits(&geometry, black_box(&random))));
    }
    group.finish();
}

fn trees(c: &mut Criterion) {
    let sphere = |x: f64, r: f64| Shape::from(Sphere { center: DVec3::X * x, radius: r });
    let leaf = |shape| SolidNode::leaf(Leaf::new(shape, &Transform::IDENTITY, 0), 0);
    let lens = SolidNode::difference(vec![leaf(sphere(0.0, 1.0)), leaf(sphere(0.5, 0.7)), leaf(sphere(-0.9, 0.3))], 0);
    let ring = leaf(Shape::from(Torus { major: 0.8, minor: 0.3 }));
    let holes = (0..1000).map(|i| leaf(Shape::from(Sphere { center: random_vector(i, 0), radius: 0.05 })));
    let cheese = SolidNode::difference([leaf(sphere(0.0, 1.0))].into_iter().chain(holes).collect(), 0);
    let random = incoherent(10_000);
    let mut group = c.benchmark_group("one object, 10 000 rays");
    group.sample_size(20);
    for (name, node) in [("difference of 3 spheres", lens), ("torus", ring), ("1000 holes", cheese)] {
        let geometry = Geometry::new(vec![node]);
        group.bench_function(name, |b| b.iter(|| hits(&geometry, black_box(&random))));
    }
    group.finish();
}

criterion_group!(benches, build, closest, trees);
criterion_main!(benches);
