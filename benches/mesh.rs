//! A million triangles and rays through them, for `embree/run.sh`: `mesh write FILE` writes both for Embree, `mesh run [ROUNDS]` measures
//! durer.

use durer::math::{DVec3, Range, Ray, fp, rng};
use durer::mesh_io::Triangles;
use durer::shape::{Kernel, Mesh};
use glam::Vec3;
use std::io::{BufWriter, Write};
use std::time::Instant;

/// Twice the square of this are the triangles.
const SIDE: usize = 708;
/// So many rays of each kind.
const RAYS: usize = 1 << 20;

/// A ball with waves.
fn ball() -> Triangles {
    let mut out = Triangles::default();
    let at = |i: usize| i as f64 / SIDE as f64 * std::f64::consts::PI;
    for (a, b) in (0..=SIDE).flat_map(|i| (0..=SIDE).map(move |j| (at(i), 2.0 * at(j)))) {
        let r = 1.0 + 0.1 * fp::sin(9.0 * a) * fp::cos(12.0 * b) + 0.02 * fp::sin(60.0 * a) * fp::sin(70.0 * b);
        let p = DVec3::new(r * fp::sin(a) * fp::cos(b), r * fp::cos(a), r * fp::sin(a) * fp::sin(b));
        out.vertices.push(p.as_vec3());
    }
    let number = |i: usize, j: usize| (i * (SIDE + 1) + j) as u32;
    for (i, j) in (0..SIDE).flat_map(|i| (0..SIDE).map(move |j| (i, j))) {
        let [a, b, c, d] = [number(i, j), number(i + 1, j), number(i + 1, j + 1), number(i, j + 1)];
        out.corners.extend([[a, b, c], [a, c, d]]);
    }
    out
}

/// A camera's, row by row, then those from everywhere to everywhere.
fn rays() -> [Vec<Ray>; 2] {
    let single = |v: DVec3| v.as_vec3().as_dvec3();
    let at = |k: usize| k as f64 / 512.0 - 1.0;
    let camera = |k: usize| Ray::new(DVec3::new(0.0, 0.0, -4.0), single(DVec3::new(at(k % 1024), at(k / 1024), 2.9)));
    let random =
        |i: usize, n: u64| DVec3::from_array([0, 1, 2].map(|axis| rng::random_unit(&[i as u64, n, axis]) * 2.4 - 1.2));
    let anywhere = |i: usize| Ray::new(single(random(i, 0)), single(random(i, 1)));
    [(0..RAYS).map(camera).collect(), (0..RAYS).map(anywhere).collect()]
}

fn write(path: &str) -> std::io::Result<()> {
    let (ball, rays) = (ball(), rays());
    let mut out = BufWriter::new(std::fs::File::create(path)?);
    for n in [ball.vertices.len(), ball.corners.len(), RAYS, RAYS] {
        out.write_all(&(n as u32).to_le_bytes())?;
    }
    let rays = rays.iter().flatten().flat_map(|ray| [ray.origin.as_vec3(), ray.dir.as_vec3()]);
    let numbers = |points: &mut dyn Iterator<Item = Vec3>| -> Vec<u8> {
        points.flat_map(|p| p.to_array()).flat_map(f32::to_le_bytes).collect()
    };
    out.write_all(&numbers(&mut ball.vertices.iter().copied()))?;
    out.write_all(&ball.corners.iter().flatten().flat_map(|i| i.to_le_bytes()).collect::<Vec<u8>>())?;
    out.write_all(&numbers(&mut { rays }))
}

/// Seconds of this thread's work, where the system tells them (others may work beside it); else those of the clock.
fn seconds(start: Instant) -> f64 {
    let work = std::fs::read_to_string("/proc/self/schedstat").ok();
    let nanoseconds = work.as_ref().and_then(|text| text.split(' ').next()?.parse::<f64>().ok());
    nanoseconds.map_or_else(|| start.elapsed().as_secs_f64(), |n| n * 1e-9)
}

/// The shortest of some runs, in seconds, and what the last gives.
fn measured<T>(rounds: usize, mut run: impl FnMut() -> T) -> (f64, Option<T>) {
    let (start, mut least, mut out) = (Instant::now(), f64::INFINITY, None);
    for _ in 0..rounds {
        let before = seconds(start);
        out = Some(run());
        least = least.min(seconds(start) - before);
    }
    (least, out)
}

fn run(rounds: usize) {
    let ball = ball();
    let (build, mesh) = measured(rounds, || Mesh::from_triangles(ball.clone()));
    println!("build: {build:.3} s");
    let Some(mesh) = mesh else { return };
    for (name, rays) in ["coherent", "incoherent"].into_iter().zip(rays()) {
        let print_rate = |what: &str, (seconds, hits): (f64, Option<usize>)| {
            println!("{name} {what}: {:.2} M/s ({} hits)", rays.len() as f64 / seconds / 1e6, hits.unwrap_or(0));
        };
        let met = |ray: &&Ray| mesh.closest(ray, Range::FORWARD).is_some();
        print_rate("closest", measured(rounds, || rays.iter().filter(met).count()));
        print_rate("any", measured(rounds, || rays.iter().filter(|ray| mesh.any_hit(ray, Range::FORWARD)).count()));
    }
}

fn main() {
    let arguments: Vec<String> = std::env::args().skip(1).filter(|a| a != "--bench").collect();
    match arguments.first().map(String::as_str) {
        Some("write") => write(arguments.get(1).map_or("mesh.bin", String::as_str)).expect("the file can be written"),
        _ => run(arguments.get(1).and_then(|n| n.parse().ok()).unwrap_or(3)),
    }
}
