//! `durer watch` over HTTP, without a browser (`tests/preview/browser.py` uses one).

use base64::prelude::{BASE64_STANDARD, Engine};
use serde_json::Value;
use std::io::{BufRead, BufReader, Read, Write};
use std::net::TcpStream;
use std::path::PathBuf;
use std::process::{Child, ChildStderr, Command, Stdio};
use std::sync::{Arc, Mutex};
use std::time::{Duration, Instant};

const SCENE: &str = "#version 3.7;
global_settings { assumed_gamma 1 }
#include \"colour.inc\"
camera { location <0, 1, -4> look_at 0 }
light_source { <-4, 6, -5>, 1 }
sphere { <clock, 0, 0>, 1 pigment { rgb Colour } }
plane { y, -1 pigment { checker rgb 0.8 rgb 0.6 } }
";

/// A running `durer watch`, killed when dropped.
struct Watch {
    folder: tempfile::TempDir,
    durer: Child,
    /// `None` after [`Watch::collect`].
    stderr: Option<BufReader<ChildStderr>>,
}

impl Watch {
    fn start(words: &str) -> Self {
        let folder = tempfile::tempdir().unwrap();
        std::fs::write(folder.path().join("ball.scene"), SCENE).unwrap();
        std::fs::write(folder.path().join("colour.inc"), "#declare Colour = <1, 0, 0>;\n").unwrap();
        let mut durer = Command::new(env!("CARGO_BIN_EXE_durer"));
        durer.args(["watch", "ball.scene", "--size", "72x54"]).args(words.split_whitespace());
        let mut durer = durer.current_dir(&folder).stderr(Stdio::piped()).spawn().unwrap();
        let stderr = Some(BufReader::new(durer.stderr.take().unwrap()));
        Self { folder, durer, stderr }
    }

    fn at(&self, name: &str) -> PathBuf {
        self.folder.path().join(name)
    }

    fn write(&self, name: &str, text: &str) {
        std::fs::write(self.at(name), text).unwrap();
    }

    /// Waits for a line on stderr that contains a word.
    fn line(&mut self, word: &str) -> String {
        let mut line = String::new();
        while !line.contains(word) {
            line.clear();
            assert!(self.stderr.as_mut().unwrap().read_line(&mut line).unwrap() > 0, "no line with `{word}`");
        }
        line
    }

    /// Collects the lines on stderr from now on.
    fn collect(&mut self) -> Arc<Mutex<String>> {
        let text = Arc::new(Mutex::new(String::new()));
        let mut stderr = self.stderr.take().unwrap();
        let to = text.clone();
        std::thread::spawn(move || {
            let mut line = String::new();
            while stderr.read_line(&mut line).is_ok_and(|length| length > 0) {
                to.lock().unwrap().push_str(&std::mem::take(&mut line));
            }
        });
        text
    }

    /// The picture of `durer render` for the current scene.
    fn rendered(&self, words: &str) -> image::RgbaImage {
        self.rendered_as("72x54", words)
    }

    fn rendered_as(&self, size: &str, words: &str) -> image::RgbaImage {
        let mut durer = Command::new(env!("CARGO_BIN_EXE_durer"));
        durer.args(["-q", "render", "ball.scene", "--size", size, "-o", "drawn.png"]).args(words.split_whitespace());
        assert!(durer.current_dir(&self.folder).status().unwrap().success());
        image::open(self.at("drawn.png")).unwrap().to_rgba8()
    }
}

impl Drop for Watch {
    fn drop(&mut self) {
        let _ = self.durer.kill();
        let _ = self.durer.wait();
    }
}

/// The page's address.
#[derive(Clone)]
struct Page {
    host: String,
    path: String,
}

impl Page {
    fn of(line: &str) -> Self {
        let address = line.split_whitespace().next().unwrap().strip_prefix("http://").unwrap();
        let (host, path) = address.split_once('/').unwrap();
        Self { host: host.into(), path: format!("/{path}") }
    }

    fn send(&self, request: &str) -> TcpStream {
        let mut stream = TcpStream::connect(&self.host).unwrap();
        stream.set_read_timeout(Some(Duration::from_secs(60))).unwrap();
        stream.write_all(request.as_bytes()).unwrap();
        stream
    }

    /// Status and body.
    fn ask(&self, request: &str) -> (u16, String) {
        let mut answer = vec![];
        self.send(request).read_to_end(&mut answer).unwrap();
        let answer = String::from_utf8_lossy(&answer).into_owned();
        let (head, body) = answer.split_once("\r\n\r\n").unwrap();
        (head[9..12].parse().unwrap(), body.to_string())
    }

    fn get(&self, path: &str) -> (u16, String) {
        self.ask(&format!("GET {}{path} HTTP/1.1\r\nHost: {}\r\n\r\n", self.path, self.host))
    }

    fn post(&self, path: &str, body: &str) -> (u16, String) {
        let (length, host) = (body.len(), &self.host);
        self.ask(&format!(
            "POST {}{path} HTTP/1.1\r\nHost: {host}\r\nContent-Length: {length}\r\n\r\n{body}",
            self.path
        ))
    }

    fn events(&self) -> Events {
        let request = format!("GET {}events HTTP/1.1\r\nHost: {}\r\n\r\n", self.path, self.host);
        let (picture, state) = (image::RgbaImage::default(), Value::Null);
        Events { lines: BufReader::new(self.send(&request)), picture, state, run: [0; 2], done: false }
    }
}

/// State of the page's script.
struct Events {
    lines: BufReader<TcpStream>,
    picture: image::RgbaImage,
    state: Value,
    /// Run numbers of the picture and of the state.
    run: [u64; 2],
    done: bool,
}

impl Events {
    /// Consumes events until a condition holds.
    fn until(&mut self, so: impl Fn(&Self) -> bool) {
        let start = Instant::now();
        while !so(self) {
            assert!(start.elapsed() < Duration::from_secs(60), "{}", self.state);
            let mut line = String::new();
            assert!(self.lines.read_line(&mut line).unwrap() > 0);
            let Some(event) = line.trim().strip_prefix("event: ").map(str::to_string) else { continue };
            let mut data = String::new();
            self.lines.read_line(&mut data).unwrap();
            let data: Value = serde_json::from_str(data.strip_prefix("data: ").unwrap()).unwrap();
            match &event[..] {
                "state" => (self.state, self.run[1]) = (data["state"].clone(), data["run"].as_u64().unwrap()),
                "picture" => self.paint(&data),
                other => panic!("{other}"),
            }
        }
    }

    fn paint(&mut self, data: &Value) {
        (self.run[0], self.done) = (data["run"].as_u64().unwrap(), data["done"].as_bool().unwrap());
        let number = |value: &Value| value.as_u64().unwrap() as u32;
        if let Some([width, height]) = data["size"].as_array().map(|size| [number(&size[0]), number(&size[1])]) {
            self.picture = image::RgbaImage::new(width, height);
        }
        for tile in data["tiles"].as_array().unwrap() {
            let bytes = BASE64_STANDARD.decode(tile[4].as_str().unwrap()).unwrap();
            let part = image::RgbaImage::from_raw(number(&tile[2]), number(&tile[3]), bytes).unwrap();
            image::imageops::replace(&mut self.picture, &part, number(&tile[0]).into(), number(&tile[1]).into());
        }
    }

    /// Consumes events until the last picture is complete.
    fn settle(&mut self) {
        self.until(|page| page.done && page.run[0] == page.run[1] && page.state["status"] == "done");
    }

    fn count(&self, severity: &str) -> usize {
        self.state["messages"].as_array().map_or(0, |all| all.iter().filter(|m| m["severity"] == severity).count())
    }
}

fn same(a: &image::RgbaImage, b: &image::RgbaImage) {
    assert_eq!(a.dimensions(), b.dimensions());
    let others = a.pixels().zip(b.pixels()).filter(|(a, b)| a != b).count();
    assert_eq!(others, 0, "pixels differ");
}

#[test]
fn page_shows_the_rendered_picture() {
    let mut watch = Watch::start("");
    let page = Page::of(&watch.line("http://"));
    let mut events = page.events();
    events.settle();
    same(&events.picture, &watch.rendered(""));
    // An editor replaces an included file by renaming a new one.
    watch.write("colour.new", "#declare Colour = <0, 0, 1>;\n");
    std::fs::rename(watch.at("colour.new"), watch.at("colour.inc")).unwrap();
    let run = events.run[0];
    events.until(|page| page.run[0] > run);
    events.settle();
    let blue = watch.rendered("");
    same(&events.picture, &blue);
    // A page that connects later receives the current state.
    let mut late = page.events();
    late.settle();
    same(&late.picture, &blue);
    assert_eq!(page.get("before.png").0, 200);
    // The clock, anti-aliasing and quality.
    assert_eq!(page.post("change", r#"{"clock": 0.5, "antialias": false, "quality": 3}"#).0, 200);
    events.until(|page| page.state["settings"]["quality"] == 3);
    events.settle();
    same(&events.picture, &watch.rendered("--clock 0.5 --aa off --quality 3"));
    // A region, twice as large.
    page.post("change", r#"{"zoom": [0.25, 0.25, 0.5, 0.5]}"#);
    events.until(|page| page.state["settings"]["zoom"].is_array());
    events.settle();
    let whole = watch.rendered_as("144x108", "--clock 0.5 --aa off --quality 3");
    same(&events.picture, &image::imageops::crop_imm(&whole, 36, 27, 72, 54).to_image());
    let picked: Value = serde_json::from_str(&page.get("pick?x=36&y=30").1).unwrap();
    assert!(picked["words"].as_str().unwrap().starts_with("sphere at ball.scene:6:1\n"), "{picked}");
    assert_eq!(page.get("pick?x=99999999999&y=-1").0, 200);
    assert!(page.get("pick?x=72&y=0").1.contains("false"));
}

#[test]
fn broken_scenes_are_reported_and_repaired_ones_rendered() {
    let mut watch = Watch::start("");
    let page = Page::of(&watch.line("http://"));
    let mut events = page.events();
    events.settle();
    let (first, run) = (events.picture.clone(), events.run[0]);
    watch.write("ball.scene", &SCENE.replace("sphere", "spere"));
    events.until(|page| page.state["status"] == "broken");
    assert_eq!((events.count("error"), events.run[0]), (1, run));
    let message = &events.state["messages"][0];
    assert!(message["text"].as_str().unwrap().contains("did you mean `sphere`"), "{message}");
    assert!(message["place"]["url"].as_str().unwrap().ends_with("/ball.scene:6:1"), "{message}");
    // The file is gone; an included file is gone; both are back.
    std::fs::remove_file(watch.at("ball.scene")).unwrap();
    events.until(|page| page.state["messages"][0]["code"] == "E0002");
    std::fs::remove_file(watch.at("colour.inc")).unwrap();
    watch.write("ball.scene", SCENE);
    events.until(|page| page.state.to_string().contains("colour.inc"));
    watch.write("colour.inc", "#declare Colour = <1, 0, 0>;\n");
    events.until(|page| page.count("error") == 0 && page.state["status"] == "done" && page.run[0] > run && page.done);
    same(&events.picture, &first);
    // A scene writes no files in a preview; the page says so.
    watch.write("ball.scene", &format!("{SCENE}#fopen F \"out.txt\" write\n"));
    events.until(|page| page.state["log"].to_string().contains("out.txt"));
    let mut names: Vec<_> = std::fs::read_dir(&watch.folder).unwrap().map(|e| e.unwrap().file_name()).collect();
    names.sort();
    assert_eq!(names, ["ball.scene", "colour.inc"]);
    // The user saves the picture.
    watch.write("ball.scene", SCENE);
    events.settle();
    assert_eq!(page.post("save", "{}").1, r#"{"text":"ball.png"}"#);
    same(&image::open(watch.at("ball.png")).unwrap().to_rgba8(), &first);
}

#[test]
fn foreign_requests_are_rejected() {
    let mut watch = Watch::start("");
    let page = Page::of(&watch.line("http://"));
    let (host, path) = (&page.host, &page.path);
    assert_eq!(page.get("").0, 200);
    for head in [
        format!("GET / HTTP/1.1\r\nHost: {host}"),
        format!("GET /{} HTTP/1.1\r\nHost: {host}", "0".repeat(32)),
        format!("GET {path}events HTTP/1.1\r\nHost: evil.example"),
        format!("GET {path}events HTTP/1.1\r\nHost: {host}\r\nOrigin: http://evil.example"),
        format!("GET {path}events HTTP/1.1\r\nHost: {host}\r\nSec-Fetch-Site: cross-site"),
        format!("POST {path}save HTTP/1.1\r\nHost: {host}\r\nOrigin: null"),
    ] {
        let (status, body) = page.ask(&format!("{head}\r\n\r\n"));
        assert_eq!(status, 403, "{head}");
        assert!(!body.contains(&page.path[1..33]), "{body}");
    }
    for outside in ["ball.scene", "../ball.scene", "%2e%2e/ball.scene", "/etc/passwd"] {
        assert_eq!(page.get(outside).0, 404, "{outside}");
    }
    assert_eq!(page.post("change", "[").0, 400);
    assert_eq!(page.post("change", r#"{"output": "/etc/passwd"}"#).0, 400);
    assert_eq!(page.post("open", r#"{"file": "/etc/passwd", "line": 1, "column": 1}"#).0, 400);
    assert_eq!(page.get("page.js").0, 200);
}

#[test]
fn bad_requests_get_an_answer() {
    let mut watch = Watch::start("");
    let page = Page::of(&watch.line("http://"));
    let (host, path) = (&page.host, &page.path);
    let long = "x".repeat(40_000);
    for (request, status, reason) in [
        ("\0\u{1}\u{2} nonsense\r\n\r\n".to_string(), 400, "not HTTP/1.1"),
        ("GET\r\n\r\n".to_string(), 400, "not HTTP/1.1"),
        (format!("GET {path} HTTP/3.0\r\n\r\n"), 400, "not HTTP/1.1"),
        (format!("GET {path} HTTP/1.1\r\nHost: {host}\r\nLong: {long}\r\n\r\n"), 400, "longer than 16 KB"),
        (format!("GET {path} HTTP/1.1\r\nHost: {host}\r\n{}\r\n", "A: b\r\n".repeat(100)), 400, "not HTTP/1.1"),
        (format!("GET {path} HTTP/1.1\r\n\r\n"), 400, "one header `Host`"),
        (format!("GET {path} HTTP/1.1\r\nHost: {host}\r\nHost: {host}\r\n\r\n"), 400, "one header `Host`"),
        (format!("BREW {path} HTTP/1.1\r\nHost: {host}\r\n\r\n"), 405, "`GET` only"),
        (format!("GET {path}save HTTP/1.1\r\nHost: {host}\r\n\r\n"), 405, "`POST` only"),
        (format!("POST {path}save HTTP/1.1\r\nHost: {host}\r\nContent-Length: -1\r\n\r\n"), 400, "Content-Length"),
        (
            format!("POST {path}save HTTP/1.1\r\nHost: {host}\r\nContent-Length: 99999999999\r\n\r\n"),
            400,
            "longer than 64 KB",
        ),
    ] {
        let (got, body) = page.ask(&request);
        assert_eq!(got, status, "{request:.80}: {body}");
        assert!(body.contains(reason), "{request:.80}: {body}");
    }
    // Slow requests do not hold up others, and end.
    let slow: Vec<_> = (0..5).map(|_| page.send("GET / HT")).collect();
    assert_eq!(page.get("page.js").0, 200);
    let start = Instant::now();
    for mut stream in slow {
        let mut answer = String::new();
        stream.read_to_string(&mut answer).unwrap();
        assert!(answer.starts_with("HTTP/1.1 400") && answer.contains("within 2 seconds"), "{answer}");
    }
    assert!(start.elapsed() < Duration::from_secs(8));
}

#[test]
fn connections_are_bounded() {
    let mut watch = Watch::start("");
    let page = Page::of(&watch.line("http://"));
    let open: Vec<_> = (0..64).map(|_| page.send("GET")).collect();
    // The server accepts connections in order.
    let (status, body) = page.ask("");
    assert_eq!(status, 503, "{body}");
    drop(open);
    let start = Instant::now();
    while page.ask(&format!("GET {}page.js HTTP/1.1\r\nHost: {}\r\n\r\n", page.path, page.host)).0 == 503 {
        assert!(start.elapsed() < Duration::from_secs(10));
    }
}

#[test]
fn a_broken_scene_is_not_run_again_for_other_files() {
    let mut watch = Watch::start("--no-page");
    watch.line("waiting for the next change");
    watch.write("ball.scene", "#include \"Later.inc\"\n");
    watch.line("help: looked in");
    let stderr = watch.collect();
    for i in 0..6 {
        watch.write("log.txt", &"x".repeat(i));
        std::thread::sleep(Duration::from_millis(60));
    }
    // A changed file is reported when the folder has been quiet for 25 ms.
    std::thread::sleep(Duration::from_millis(600));
    let n_runs = |text: &str| text.matches("Later.inc").count() + text.matches("waiting").count();
    let text = stderr.lock().unwrap().clone();
    assert_eq!(n_runs(&text), 0, "{text}");
    // A lookup would find this name, too.
    watch.write("later.inc", SCENE);
    let start = Instant::now();
    while !stderr.lock().unwrap().contains("waiting") {
        assert!(start.elapsed() < Duration::from_secs(20), "the new file has no effect");
        std::thread::sleep(Duration::from_millis(20));
    }
}

#[cfg(unix)]
#[test]
fn a_scene_that_was_no_file_for_a_moment_is_rendered_again() {
    for words in ["--no-page -o out.png", ""] {
        let mut watch = Watch::start(words);
        watch.line("rendered");
        let scene = watch.at("ball.scene");
        std::fs::remove_file(&scene).unwrap();
        assert!(Command::new("mkfifo").arg(&scene).status().unwrap().success());
        watch.line("it is a device or a pipe");
        std::fs::remove_file(&scene).unwrap();
        std::fs::create_dir(&scene).unwrap();
        std::thread::sleep(Duration::from_millis(100));
        std::fs::remove_dir(&scene).unwrap();
        watch.write("ball.scene", SCENE);
        watch.line("rendered");
    }
}

#[cfg(target_os = "linux")]
#[test]
fn opened_editors_leave_no_process() {
    let mut watch = Watch::start("--editor true");
    let page = Page::of(&watch.line("http://"));
    for _ in 0..5 {
        assert_eq!(page.post("open", r#"{"file": "ball.scene", "line": 1, "column": 1}"#).0, 200);
    }
    let id = watch.durer.id();
    let n_children = || {
        let tasks = std::fs::read_dir(format!("/proc/{id}/task")).unwrap();
        let children = tasks.filter_map(|task| std::fs::read_to_string(task.ok()?.path().join("children")).ok());
        children.map(|text| text.split_whitespace().count()).sum::<usize>()
    };
    let start = Instant::now();
    while n_children() > 0 {
        assert!(start.elapsed() < Duration::from_secs(10), "{} children", n_children());
        std::thread::sleep(Duration::from_millis(10));
    }
}

#[test]
fn a_save_takes_effect_during_long_work() {
    let blob = "#declare R = seed(1);\nblob { threshold 0.6\n#for (I, 1, 20000) sphere { <rand(R), rand(R), rand(R)>, 1, 1 } #end }\n";
    let mut averages = String::from("#declare P0 = pigment { granite }\n");
    for i in 1..=28 {
        let before = i - 1;
        averages +=
            &format!("#declare P{i} = pigment {{ average pigment_map {{ [1 P{before}] [1 P{before} rotate y] }} }}\n");
    }
    averages += "sphere { 0, 3 pigment { P28 } }\n";
    let mut watch = Watch::start("--no-page -o out.png");
    watch.line("waiting for the next change");
    for (number, slow) in [blob, &averages].into_iter().enumerate() {
        watch.write("ball.scene", &format!("{SCENE}{slow}"));
        std::thread::sleep(Duration::from_millis(1200));
        let start = Instant::now();
        watch.write("ball.scene", &format!("sphre_{number}\n"));
        watch.line(&format!("sphre_{number}"));
        assert!(start.elapsed() < Duration::from_millis(1500), "{:?}", start.elapsed());
    }
}

#[test]
fn no_page_mode_rewrites_the_file() {
    let mut watch = Watch::start("--no-page -o out.png");
    watch.line("waiting for the next change");
    let red = image::open(watch.at("out.png")).unwrap().to_rgba8();
    same(&red, &watch.rendered(""));
    watch.write("colour.inc", "#declare Colour = oops;\n");
    watch.line("oops");
    watch.write("colour.inc", "#declare Colour = <0, 0, 1>;\n");
    watch.line("waiting for the next change");
    let blue = image::open(watch.at("out.png")).unwrap().to_rgba8();
    assert!(blue != red && blue == watch.rendered(""));
    assert!(!watch.at("out.png.unfinished").exists());
}
