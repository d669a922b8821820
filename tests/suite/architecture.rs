//! The layers of the program. A module uses only modules with a smaller number; modules with equal numbers do not use
//! each other.

use std::path::{Path, PathBuf};

const LAYERS: &[(&str, u32)] = &[
    ("math", 0),
    ("source", 0),
    ("library", 0),
    ("diagnostic", 1),
    ("color", 1),
    ("quirks", 1),
    ("image_io", 2),
    ("mesh_io", 2),
    ("font", 2),
    ("syntax", 2),
    ("value", 3),
    ("snapshot", 3),
    ("format", 3),
    ("function", 4),
    ("light", 4),
    ("shape", 5),
    ("pattern", 5),
    ("texture", 6),
    ("medium", 7),
    ("atmosphere", 7),
    ("camera", 7),
    ("scene", 8),
    ("world", 9),
    ("interpreter", 10),
    ("transport", 10),
    ("render", 11),
    ("advice", 12),
    ("reference", 12),
    ("lsp", 14),
    ("preview", 14),
    ("cli", 15),
];

/// Layer of the functions in `lib.rs` itself: only front ends may use it.
const ROOT: u32 = 13;

/// Words that only some files may contain, by the beginnings of their paths below `src/`.
const RESERVED: &[(&str, &[&str])] = &[
    ("pest::", &["syntax/"]),
    ("pest_derive", &["syntax/"]),
    ("miette", &["diagnostic/draw.rs"]),
    ("rayon", &["render/", "math/fork.rs"]),
    ("indicatif", &["cli/render/progress.rs"]),
    ("clap::", &["cli/"]),
    ("lsp_types", &["lsp/"]),
    ("lsp_server", &["lsp/"]),
    ("notify::", &["preview/file_watcher.rs"]),
    ("httparse", &["preview/http.rs"]),
    ("TcpStream", &["preview/"]),
    ("base64", &["preview/stream.rs", "mesh_io/gltf/"]),
    ("getrandom", &["preview/guard.rs"]),
    ("image::", &["image_io/", "quirks/"]),
    ("exr::", &["image_io/"]),
    ("skrifa", &["font/"]),
    // The caller provides input, output and time: see DESIGN, law 5.
    ("std::fs", OUTSIDE_WORLD),
    ("std::env", &["source/", "cli/", "lsp/", "preview/", "main.rs"]),
    ("std::net", &["preview/"]),
    ("process::Command", &["cli/", "lsp/"]),
    ("std::thread", &["cli/", "lib.rs", "lsp/", "preview/"]),
    ("OpenOptions", OUTSIDE_WORLD),
    ("Instant", OUTSIDE_WORLD),
    ("SystemTime", OUTSIDE_WORLD),
    ("/proc/", OUTSIDE_WORLD),
    (".exists()", OUTSIDE_WORLD),
    (".is_file()", OUTSIDE_WORLD),
    (".is_dir()", OUTSIDE_WORLD),
    (".is_symlink()", OUTSIDE_WORLD),
    (".canonicalize()", OUTSIDE_WORLD),
    (".metadata()", OUTSIDE_WORLD),
    (".read_dir()", OUTSIDE_WORLD),
    ("println!", &["cli/", "main.rs"]),
    ("eprintln!", &["cli/", "main.rs"]),
    ("print!", &["cli/", "main.rs"]),
    ("eprint!", &["cli/", "main.rs"]),
    ("process::exit", &["cli/", "main.rs"]),
];

/// The storage and the front ends.
const OUTSIDE_WORLD: &[&str] = &["source/", "cli/", "lsp/", "preview/"];

/// Types of a `static` that holds state of the process.
const STATE: &[&str] = &["Mutex", "RwLock", "OnceLock", "OnceCell", "Atomic"];

/// Files that may have such a `static`: signals, exit codes and memory belong to the whole process, and the manual's folder never
/// changes.
const STATE_HOLDERS: &[&str] = &["cli/allocator.rs", "cli/exit.rs", "cli/interrupt.rs", "lsp/manual.rs"];

/// In each of these folders at most one file may contain the word.
const ONE_FILE: &[(&str, &str)] = &[("rayon", "render/")];

fn layer(module: &str) -> Option<u32> {
    LAYERS.iter().find(|(name, _)| *name == module).map(|(_, layer)| *layer)
}

fn is_word(c: char) -> bool {
    c.is_alphanumeric() || c == '_'
}

/// The source without comments; a `//` after a colon is a link in a text.
fn code(source: &str) -> String {
    let line = |line: &str| match line.match_indices("//").find(|(i, _)| !line[..*i].ends_with(':')) {
        Some((i, _)) => line[..i].to_string(),
        None => line.to_string(),
    };
    source.lines().map(line).collect::<Vec<_>>().join("\n")
}

/// True if the text contains the word, not as a part of a longer one.
fn holds(source: &str, word: &str) -> bool {
    let begins = |i: usize| !word.starts_with(is_word) || !source[..i].ends_with(is_word);
    let ends = |i: usize| !word.ends_with(is_word) || !source[i + word.len()..].starts_with(is_word);
    source.match_indices(word).any(|(i, _)| begins(i) && ends(i))
}

/// The modules directly under the crate's root that a file uses: `crate::a`, `crate::{a, b::c}`, and `super::a` at
/// depth 1.
fn root_names(source: &str, depth: usize) -> Vec<String> {
    let up = "super::".repeat(depth);
    let mut names = Vec::new();
    for root in ["crate::", up.as_str()] {
        let starts =
            source.match_indices(root).filter(|(i, _)| !source[..*i].ends_with(|c| is_word(c) || c == ':' || c == '$'));
        for (i, _) in starts {
            let rest = &source[i + root.len()..];
            if root == "crate::" || !rest.starts_with("super::") {
                names.extend(heads(rest));
            }
        }
    }
    names
}

/// The first segments of a path or of a group of paths.
fn heads(rest: &str) -> Vec<String> {
    let word = |text: &str| text.trim_start().chars().take_while(|c| is_word(*c)).collect::<String>();
    let Some(group) = rest.strip_prefix('{') else {
        return vec![word(rest)];
    };
    let (mut names, mut depth, mut start) = (Vec::new(), 0, 0);
    for (i, c) in group.char_indices() {
        match c {
            '{' => depth += 1,
            ',' | '}' if depth == 0 => {
                names.push(word(&group[start..i]));
                start = i + 1;
                if c == '}' {
                    break;
                }
            }
            '}' => depth -= 1,
            _ => {}
        }
    }
    names.retain(|name| !name.is_empty() && name != "self");
    names
}

/// The names in the table of shapes.
fn shapes() -> &'static [String] {
    static SHAPES: std::sync::LazyLock<Vec<String>> = std::sync::LazyLock::new(|| {
        let table = std::fs::read_to_string(concat!(env!("CARGO_MANIFEST_DIR"), "/src/shape/mod.rs")).unwrap();
        let row = table.split("pub enum Shape in Arc {").nth(1).unwrap().split('}').next().unwrap();
        row.split_whitespace().map(String::from).collect()
    });
    &SHAPES
}

/// Violations in one file, whose path is relative to `src/`.
fn faults(path: &str, source: &str) -> Vec<String> {
    let source = code(source);
    let mut faults = Vec::new();
    for (word, places) in RESERVED {
        if holds(&source, word) && !places.iter().any(|place| path.starts_with(place)) {
            faults.push(format!("{path}: `{word}` belongs into {}", places.join(" and ")));
        }
    }
    let statics =
        source.lines().filter(|line| line.contains("static ") && STATE.iter().any(|word| line.contains(word)));
    if statics.count() > 0 && !STATE_HOLDERS.contains(&path) {
        faults.push(format!("{path}: a `static` holds state of the process"));
    }
    let parts: Vec<_> = path.trim_end_matches(".rs").split('/').filter(|part| *part != "mod").collect();
    if matches!(parts[..], ["lib" | "main"]) {
        return faults;
    }
    let Some(own) = layer(parts[0]) else {
        faults.push(format!("{path}: `{}` is in no layer; add it to the list", parts[0]));
        return faults;
    };
    if own > layer("shape").unwrap() {
        // both `Shape::Sphere` and `shape::{Kernel, Sphere}`
        let named = source.match_indices("hape::").flat_map(|(i, found)| heads(&source[i + found.len()..]));
        let single = named.filter(|name| shapes().contains(name));
        faults.extend(single.map(|name| format!("{path}: what is special of `{name}` is asked of its kernel")));
    }
    for name in root_names(&source, parts.len()) {
        if name != parts[0] && layer(&name).unwrap_or(ROOT) >= own {
            faults.push(format!("{path}: `{}` must not use `{name}`", parts[0]));
        }
    }
    faults.sort();
    faults.dedup();
    faults
}

fn files(folder: &Path, found: &mut Vec<PathBuf>) {
    for entry in std::fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        if path.is_dir() {
            files(&path, found);
        } else if path.extension().is_some_and(|e| e == "rs") {
            found.push(path);
        }
    }
}

fn sources() -> Vec<(String, String)> {
    let (root, mut found) = (Path::new(env!("CARGO_MANIFEST_DIR")).join("src"), Vec::new());
    files(&root, &mut found);
    assert!(found.len() > 300);
    let name = |path: &Path| path.strip_prefix(&root).unwrap().to_string_lossy().replace('\\', "/");
    found.iter().map(|path| (name(path), std::fs::read_to_string(path).unwrap())).collect()
}

/// The parts of the interpreter that know each other only through their interfaces, and the other parts that they use.
const INTERPRETER_PARTS: &[(&str, &[&str])] =
    &[("evaluator", &[]), ("reporter", &[]), ("scene_builder", &[]), ("stream", &["evaluator"])];

#[test]
fn the_interpreters_parts_do_not_use_the_interpreter_or_each_other() {
    let mut found = 0;
    for (path, source) in sources() {
        let code = code(&source);
        for (part, uses) in
            INTERPRETER_PARTS.iter().filter(|(part, _)| path.starts_with(&format!("interpreter/{part}/")))
        {
            found += 1;
            assert!(!holds(&code, "Interpreter"), "{path} uses the whole interpreter");
            for (other, _) in INTERPRETER_PARTS.iter().filter(|(other, _)| other != part && !uses.contains(other)) {
                let used = [format!("interpreter::{other}::"), format!("super::{other}::")];
                assert!(!used.iter().any(|path| code.contains(path)), "{path} uses {other}");
            }
        }
    }
    assert!(found > 20);
}

#[test]
fn modules_use_only_lower_layers_and_words_stay_in_their_files() {
    let mut all: Vec<_> = sources().iter().flat_map(|(path, source)| faults(path, source)).collect();
    for (word, folder) in ONE_FILE {
        let sources = sources();
        let users = sources.iter().filter(|(path, source)| path.starts_with(folder) && holds(&code(source), word));
        let users: Vec<_> = users.map(|(path, _)| path.as_str()).collect();
        if users.len() > 1 {
            all.push(format!("only one file of {folder} may know `{word}`, not {}", users.join(", ")));
        }
    }
    assert!(all.is_empty(), "\n{}", all.join("\n"));
}

/// Folders with one file for each shape or pattern of the language.
const FAMILIES: &[&str] = &["pattern", "shape"];

#[test]
fn folders_have_at_most_25_files() {
    let mut counts = std::collections::BTreeMap::new();
    for (path, _) in sources() {
        let folder = path.rsplit_once('/').map_or(String::new(), |(folder, _)| folder.to_string());
        *counts.entry(folder).or_insert(0) += 1;
    }
    counts.retain(|folder, count| *count > 25 && !FAMILIES.contains(&folder.as_str()));
    assert!(counts.is_empty(), "{counts:?}");
}

#[test]
fn scanner_finds_violations() {
    let bad = |path: &str, source: &str| assert_eq!(faults(path, source).len(), 1, "{path}: {source}");
    bad("math/ray.rs", "use crate::render::Options;");
    bad("shape/sphere.rs", "use crate::{math::{Ray, Aabb}, pattern, value};");
    bad("shape/sphere.rs", "fn f() { crate::scene::Scene::default(); }");
    bad("image_io/frame.rs", "use super::super::world::World;");
    bad("image_io/mod.rs", "use super::syntax;");
    bad("render/mod.rs", "use crate::build;");
    bad("novelty/mod.rs", "");
    bad("scene/mod.rs", "use pest::Parser;");
    bad("diagnostic/mod.rs", "use miette::Report;");
    bad("shape/mod.rs", "use rayon::prelude::*;");
    bad("cli/render.rs", "use indicatif::ProgressBar;");
    bad("world/mod.rs", "fn f() { println!(\"x\") }");
    bad("interpreter/mod.rs", "fn f() { std::process::exit(1) }");
    bad("texture/mod.rs", "use image::DynamicImage;");
    bad("image_io/mod.rs", "fn f(p: &Path) { std::fs::read(p) }");
    bad("interpreter/mod.rs", "fn f(p: &Path) -> bool { p.exists() }");
    bad("interpreter/mod.rs", "let start = Instant::now();");
    bad("source/mod.rs", "static SEEN: Mutex<Seen> = Mutex::new(Seen::new());");
    bad("scene/extent.rs", "match shape { Shape::Sphere(s) => s, _ => x }");
    bad("world/lower/mod.rs", "use crate::shape::{Kernel, Plane};");
}

#[test]
fn scanner_accepts_valid_files() {
    let good = |path: &str, source: &str| assert_eq!(faults(path, source), [""; 0], "{path}: {source}");
    good("shape/sphere.rs", "use crate::{math::{Ray, Aabb}, value};\nuse crate::shape::Kernel;\nuse super::Hit;");
    good("shape/sphere.rs", "// use crate::render;\n/// As [`crate::world::World`] says.");
    good("cli/mod.rs", "use crate::{build, load, render};\nfn f() { println!(\"x\") }");
    good("math/fork.rs", "use rayon::prelude::*;");
    good("image_io/decode.rs", "use image::DynamicImage;\nlet x = \"http://a\";");
    good("syntax/mod.rs", "#[derive(pest_derive::Parser)] struct P; use pest::Parser;");
    good("texture/mod.rs", "let my_image = crate::image_io::decode; my_image::x();");
    good("world/leaf.rs", "use crate::shape::{Kernel, Shape};\nlet b = Shape::filling(&bounds);");
    good("main.rs", "fn main() { println!(\"x\") }");
    good("interpreter/mod.rs", "if self.files.exists(&path) && self.files.is_file(&path) {}");
    good("source/disk.rs", "std::fs::read(path)");
}
