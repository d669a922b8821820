//! Whole frames, from World to Frame.

#![allow(clippy::unwrap_used, missing_docs)]

use criterion::{Criterion, criterion_group, criterion_main};
use durer::interpreter;
use durer::render::{Options, Unwatched, render};
use durer::source::{SearchPath, Sources};
use durer::world::World;
use std::path::Path;

const SMALL: &str = "
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 2, -6> look_at <0, 0.8, 0> angle 50 }
light_source { <4, 6, -5> rgb 1 }
plane { y, 0 pigment { checker rgb 0.9 rgb <0.2, 0.3, 0.6> } }
sphere { <0, 1, 0>, 1 pigment { rgb <0.8, 0.3, 0.1> } finish { phong 0.6 } }
";

const MANY: &str = "
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 30, -60> look_at 0 angle 50 }
light_source { <40, 60, -50> rgb 1 }
background { rgb <0.2, 0.3, 0.5> }
#macro R(I, K) abs(mod(sin(I*12.9898 + K*78.233)*43758.5453, 1)) #end
#for (I, 1, 10000)
  sphere {
    <R(I, 0)*60 - 30, R(I, 1)*20 - 10, R(I, 2)*60 - 30>, 0.1 + R(I, 3)*0.4
    pigment { rgb <R(I, 4), R(I, 5), R(I, 6)> } finish { phong 0.5 }
  }
#end
";

fn world(text: &str) -> World {
    let sources = Sources::default();
    let file = durer::load_bytes(&sources, "bench", text.as_bytes().to_vec()).unwrap();
    let reading = interpreter::Options {
        search: SearchPath::new(Path::new("."), &[]),
        size: (640, 480),
        ..interpreter::Options::default()
    };
    durer::build(&sources, file, &reading, &mut |_| {}).world.unwrap()
}

fn frames(c: &mut Criterion) {
    let mut group = c.benchmark_group("frame");
    group.sample_size(10);
    let options = |width, height, antialias| Options { antialias, threads: 0, ..Options::new(width, height) };
    let small = world(SMALL);
    let many = world(MANY);
    let cases = [
        ("small 320x240", &small, options(320, 240, None)),
        ("small 320x240 anti-aliased", &small, options(320, 240, Some(0.3))),
        ("10 000 spheres 640x480", &many, options(640, 480, None)),
    ];
    for (name, world, options) in cases {
        group.bench_function(name, |b| b.iter(|| render(world, &options, &Unwatched)));
    }
    group.finish();
}

criterion_group!(benches, frames);
criterion_main!(benches);
