use durer::source::*;
fn main() {
    let names = durer::syntax::Names::default();
    let run = move || {
        let mut bad = 0;
        let mut n = 0;
        let mut bytes = 0;
        let t = std::time::Instant::now();
        for f in std::env::args().skip(1) {
            let sources = Sources::default();
            let text = decode_text(std::fs::read(&f).unwrap());
            bytes += text.len();
            n += 1;
            let id = sources.add(&f, None, text).unwrap();
            if let Err(ds) = durer::syntax::parse(&sources, id, &names) {
                bad += 1;
                for d in ds.iter().take(2) {
                    print!(
                        "{}",
                        durer::diagnostic::draw::render(
                            d,
                            &sources,
                            durer::diagnostic::draw::Style { fancy: false, width: 120 }
                        )
                    );
                }
            }
        }
        let s = t.elapsed().as_secs_f64();
        println!("{n} files, {bad} bad, {:.2} MB in {s:.3} s = {:.1} MB/s", bytes as f64 / 1e6, bytes as f64 / 1e6 / s);
    };
    std::thread::Builder::new().stack_size(512 << 20).spawn(run).unwrap().join().unwrap();
}
