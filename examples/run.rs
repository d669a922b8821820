use durer::diagnostic::draw;
use durer::source::*;
fn main() {
    let run = || {
        let f = std::env::args().nth(1).unwrap();
        let sources = Sources::default();
        let text = decode_text(std::fs::read(&f).unwrap());
        let id = sources.add(&f, None, text).unwrap();
        let dir = std::path::Path::new(&f).parent().unwrap().to_path_buf();
        let o = durer::interpreter::Options {
            search: SearchPath::new(&dir, &[]),
            declares: vec![],
            clock: 0.0,
            frame: 0,
            size: (160, 120),
            max_steps: 100_000_000,
            max_time: None,
            max_memory: None,
        };
        let t = std::time::Instant::now();
        let out = durer::interpreter::interpret(&sources, id, &o, &mut |s| print!("{s}"));
        let e = t.elapsed();
        for d in &out.diagnostics {
            eprint!("{}", draw::render(d, &sources, draw::Style { fancy: false, width: 120 }));
        }
        eprintln!("{:?} objects, {:.1} ms", out.scene.as_ref().map(|s| s.objects.len()), e.as_secs_f64() * 1e3);
        if std::env::args().nth(2).is_some() {
            println!("{}", serde_json::to_string_pretty(&out.scene).unwrap());
        }
    };
    std::thread::Builder::new().stack_size(512 << 20).spawn(run).unwrap().join().unwrap();
}
