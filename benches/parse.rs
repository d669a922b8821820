//! Reading: the parser alone on a mesh and on ordinary text, and the interpreter on a loop.

use criterion::{Criterion, Throughput, criterion_group, criterion_main};
use durer::interpreter;
use durer::source::Sources;
use durer::syntax::{Granularity, Names, parse};
use std::hint::black_box;

/// A mesh2 of some 10 MB of numbers.
fn mesh() -> String {
    let mut state = 1u64;
    let mut next = || {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (state >> 33) as f64 / (1u64 << 31) as f64
    };
    let mut out = String::from("mesh2 { vertex_vectors { 330000,\n");
    for _ in 0..330_000 {
        out += &format!("<{:.6}, {:.6}, {:.6}>,\n", next(), -next(), next());
    }
    out + "<0, 0, 0> } }\n"
}

/// Ordinary text: objects, textures, macros, expressions.
fn text() -> String {
    let block = "#declare Wood = texture { pigment { color rgb <0.8, 0.5, 0.3>*0.9 } finish { phong 1 } }\n\
                 #macro Post(X, H) // a post\n  cylinder { <X, 0, 0>, <X, H*2 - 1, 0>, 0.2 texture { Wood scale 2 } }\n#end\n\
                 #if (clock > 0.5) Post(1, 2) #else union { Post(2, 3) sphere { y*4, 0.5 } rotate <0, 30, 0> } #end\n";
    block.repeat(1000)
}

fn parsing(c: &mut Criterion) {
    let mut group = c.benchmark_group("parse");
    group.sample_size(10);
    for (name, text) in [("mesh2", mesh()), ("text", text())] {
        let sources = Sources::default();
        group.throughput(Throughput::Bytes(text.len() as u64));
        let Some(file) = sources.add(name, None, text) else { continue };
        group.bench_function(name, |b| {
            b.iter(|| black_box(parse(&sources, file, &Names::default(), Granularity::Whole)))
        });
    }
    group.finish();
}

fn running(c: &mut Criterion) {
    let sources = Sources::default();
    let loops =
        "#declare S = 0; #for (I, 1, 100000) #declare S = S + mod(I, 7)*2; #if (S > 1e9) #declare S = 0; #end #end";
    let Some(file) = sources.add("loops", None, loops.into()) else { return };
    let options = interpreter::Options { size: (160, 120), max_steps: u64::MAX, ..Default::default() };
    c.bench_function("interpret/100k passes", |b| {
        b.iter(|| black_box(interpreter::interpret(&sources, file, &options, &mut |_| {})));
    });
}

criterion_group!(benches, parsing, running);
criterion_main!(benches);
