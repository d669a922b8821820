//! Noise and turbulence, per thousand points: `cargo bench -p durer-benches --bench noise`.

use criterion::{Criterion, criterion_group, criterion_main};
use durer::math::noise::{NoiseGenerator, Turbulence, noise, noise_vector, turbulence, vturbulence};
use durer::math::{DVec3, rng};
use std::hint::black_box;

/// Random points, so that every look-up in the tables goes elsewhere.
fn random(n: u64) -> Vec<DVec3> {
    let unit = |i, axis| rng::random_unit(&[i, axis]) * 100.0 - 50.0;
    (0..n).map(|i| DVec3::new(unit(i, 0), unit(i, 1), unit(i, 2))).collect()
}

/// As the pixels of a row ask for them.
fn coherent(n: u64) -> Vec<DVec3> {
    (0..n).map(|i| DVec3::new(0.01 * i as f64, 0.3, -0.7)).collect()
}

fn once(c: &mut Criterion) {
    let mut group = c.benchmark_group("noise, 1000 points");
    group.sample_size(50);
    for (place, points) in [("random", random(1000)), ("coherent", coherent(1000))] {
        for generator in [NoiseGenerator::RangeCorrected, NoiseGenerator::Perlin] {
            group.bench_function(format!("{generator:?}, {place}"), |b| {
                b.iter(|| black_box(&points).iter().map(|&p| noise(p, generator)).sum::<f64>());
            });
        }
        group.bench_function(format!("vector, {place}"), |b| {
            b.iter(|| black_box(&points).iter().map(|&p| noise_vector(p)).sum::<DVec3>());
        });
    }
    group.finish();
}

fn octaves(c: &mut Criterion) {
    let (points, words) = (random(1000), Turbulence::default());
    let mut group = c.benchmark_group("6 octaves, 1000 points");
    group.sample_size(50);
    group.bench_function("turbulence", |b| {
        let one = |p| turbulence(p, words, NoiseGenerator::RangeCorrected);
        b.iter(|| black_box(&points).iter().map(|&p| one(p)).sum::<f64>());
    });
    group.bench_function("vturbulence", |b| {
        b.iter(|| black_box(&points).iter().map(|&p| vturbulence(p, words)).sum::<DVec3>());
    });
    group.finish();
}

criterion_group!(benches, once, octaves);
criterion_main!(benches);
