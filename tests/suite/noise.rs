//! Noise compared with POV-Ray's output; tests/noise/measure.py wrote the tables.

use durer::math::DVec3;
use durer::math::noise::{NoiseGenerator, Turbulence, noise, noise_vector, turbulence, vturbulence};
use std::f64::consts::TAU;

const GENERATORS: [NoiseGenerator; 3] =
    [NoiseGenerator::Original, NoiseGenerator::RangeCorrected, NoiseGenerator::Perlin];

fn rows<const N: usize>(text: &str) -> Vec<[f64; N]> {
    let row = |line: &str| line.split(' ').map(|word| word.parse().unwrap()).collect::<Vec<_>>().try_into().unwrap();
    text.lines().map(row).collect()
}

fn assert_near(name: &str, p: DVec3, ours: f64, theirs: f64, tolerance: f64) {
    assert!((ours - theirs).abs() <= tolerance, "{name} at {p}: {ours}, POV-Ray has {theirs}");
}

#[test]
fn noise_matches_povray() {
    for [x, y, z, g1, g2, g3, vx, vy, vz] in rows(include_str!("../noise/points.txt")) {
        let p = DVec3::new(x, y, z);
        for (generator, theirs) in GENERATORS.into_iter().zip([g1, g2, g3]) {
            assert_near(&format!("{generator:?}"), p, noise(p, generator), theirs, 1e-14);
        }
        for (ours, theirs) in noise_vector(p).to_array().into_iter().zip([vx, vy, vz]) {
            assert_near("vector", p, ours, theirs, 1e-14);
        }
    }
}

#[test]
fn turbulence_matches_povray() {
    for [x, y, z, lambda, omega, octaves, vx, vy, vz, patterns @ ..] in
        rows::<18>(include_str!("../noise/turbulence.txt"))
    {
        let (p, words) = (DVec3::new(x, y, z), Turbulence::new(lambda, omega, octaves));
        for (ours, theirs) in vturbulence(p, words).to_array().into_iter().zip([vx, vy, vz]) {
            assert_near("vturbulence", p, ours, theirs, 1e-12);
        }
        for (generator, theirs) in GENERATORS.into_iter().zip(patterns.chunks(3)) {
            for (name, ours, theirs) in [
                ("agate", agate(p, words, generator), theirs[0]),
                ("granite", granite(p, generator), theirs[1]),
                ("wrinkles", wrinkles(p, generator), theirs[2]),
            ] {
                assert_near(&format!("{name} {generator:?}"), p, ours, theirs, 1e-12);
            }
        }
    }
}

/// The number of `agate`: a sine of z and scalar turbulence.
fn agate(p: DVec3, words: Turbulence, generator: NoiseGenerator) -> f64 {
    let angle = TAU * (1.3 * turbulence(p, words, generator) + 1.1 * p.z);
    (0.5 * (angle.sin() + 1.0)).powf(0.77)
}

/// The number of `granite`: distances of octaves from their mean.
fn granite(p: DVec3, generator: NoiseGenerator) -> f64 {
    let octave = |i| 0.5f64.powi(i) * (0.5 - first_octave(p * 4.0 * 2f64.powi(i), generator)).abs();
    (0..6).map(octave).sum::<f64>().min(1.0)
}

/// The number of `wrinkles`: ten octaves, each clamped to [0, 1].
fn wrinkles(p: DVec3, generator: NoiseGenerator) -> f64 {
    (0..10).map(|i| 0.5f64.powi(i + 1) * first_octave(p * 2f64.powi(i), generator)).sum()
}

fn first_octave(p: DVec3, generator: NoiseGenerator) -> f64 {
    turbulence(p, Turbulence::new(1.0, 1.0, 1.0), generator)
}
