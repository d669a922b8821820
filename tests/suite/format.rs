//! `durer fmt` keeps tokens and comments, and is idempotent; `tests/format` has expected results.

use crate::mutate;
use durer::format::{WIDTH, decode, format};
use durer::syntax::{Granularity, Names, Piece, parse_text};
use std::path::{Path, PathBuf};

fn gather(folder: &Path, out: &mut Vec<PathBuf>) {
    for path in std::fs::read_dir(folder).into_iter().flatten().flatten().map(|e| e.path()) {
        if path.is_dir() && !path.is_symlink() {
            gather(&path, out);
        } else if path.extension().is_some_and(|e| e == "scene" || e == "pov" || e == "inc") {
            out.push(path);
        }
    }
}

/// The repository's texts, sorted.
fn own_texts() -> Vec<PathBuf> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let mut files = vec![];
    for folder in ["scenes", "tests", "src/library", "docs"] {
        gather(&root.join(folder), &mut files);
    }
    assert!(files.len() > 200);
    files.sort();
    files
}

/// The repository's files and, where POV-Ray is installed, every third of its files (`DURER_FUZZ=1`: all; `.ci/run` formats all of
/// them with `tests/format/prove.py`).
fn texts() -> Vec<PathBuf> {
    let mut files = vec![];
    gather(Path::new("/usr/share/povray-3.7"), &mut files);
    gather(Path::new("/usr/share/doc/povray"), &mut files);
    gather(Path::new("/usr/share/doc/povray-examples"), &mut files);
    files.sort();
    let step = if std::env::var_os("DURER_FUZZ").is_some() { 1 } else { 3 };
    own_texts().into_iter().chain(files.into_iter().step_by(step)).collect()
}

/// The tokens and comments, with each number and sign as a token of its own, without blanks after comments.
fn pieces(text: &str) -> Vec<String> {
    let (ast, _) = parse_text(text, 0, &Names::default(), Granularity::Tokens);
    let read = |piece: Piece| {
        text[piece.span().lo as usize..piece.span().hi as usize].trim_end_matches(|c| c <= ' ').to_string()
    };
    // Blanks between `#` and its word are dropped.
    ast.tokens.tokens_and_comments().map(read).collect()
}

fn check(text: &str, width: usize) -> Result<(), String> {
    // A text with faults stays unchanged.
    let Ok(once) = format(text, 0, width) else { return Ok(()) };
    let (old, new) = (pieces(text), pieces(&once));
    if let Some(i) = (0..old.len().max(new.len())).find(|i| old.get(*i) != new.get(*i)) {
        return Err(format!("{:?} became {:?}", old.get(i), new.get(i)));
    }
    let twice = format(&once, 0, width).map_err(|faults| format!("{faults:?}"))?;
    match once.lines().zip(twice.lines()).enumerate().find(|(_, (a, b))| a != b) {
        Some((line, (a, b))) => Err(format!("width {width}, line {}:\n{a}\n{b}", line + 1)),
        None if once != twice => Err("the second time another length".into()),
        None => Ok(()),
    }
}

fn hold(texts: impl IntoIterator<Item = (String, String)> + Send, widths: &[usize]) {
    let mut wrong = vec![];
    durer::on_big_stack(|| {
        for (name, text) in texts {
            let found = widths.iter().find_map(|width| check(&text, *width).err());
            wrong.extend(found.map(|why| format!("{name}: {why}")));
        }
    });
    assert!(wrong.is_empty(), "{} texts:\n{}", wrong.len(), wrong.join("\n"));
}

#[test]
fn tokens_are_kept_and_formatting_is_idempotent() {
    let read = |path: PathBuf| {
        let text = decode(std::fs::read(&path).ok()?).ok()?.text;
        // Skip huge lists of numbers.
        (text.len() < 500_000).then(|| (path.display().to_string(), text))
    };
    hold(texts().into_iter().filter_map(read), &[WIDTH, 40]);
}

/// `DURER_FUZZ=100000 cargo test --test suite format::mutants` tests more, `DURER_SEED=N DURER_FUZZ=1` keeps one as a
/// file.
#[test]
fn mutants_are_formatted() {
    let read = |path: &PathBuf| decode(std::fs::read(path).ok()?).ok().map(|text| text.text);
    let texts: Vec<String> = own_texts().iter().filter_map(read).filter(|text| text.len() < 20_000).collect();
    let number = |name, or| std::env::var(name).ok().and_then(|n| n.parse().ok()).unwrap_or(or);
    let (first, count) = (number("DURER_SEED", 0), number("DURER_FUZZ", 600));
    let mutants = (first..first + count).map(move |seed| {
        let mut rng = mutate::Rng::new(seed);
        let [one, other] = [(); 2].map(|()| &texts[rng.below(texts.len())]);
        let mutant = mutate::mutate(one, other, &mut rng);
        if std::env::var("DURER_SEED").is_ok() {
            std::fs::write(Path::new(env!("CARGO_TARGET_TMPDIR")).join("mutant.scene"), &mutant).ok();
        }
        (format!("seed {seed}"), mutant)
    });
    // (A text with a NUL is binary, and rejected.)
    let mutants = mutants.filter(|(_, mutant)| !mutant.contains('\0'));
    hold(mutants, &[WIDTH]);
}

/// Texts that the fuzzer `format` found.
#[test]
fn irregular_tokens_are_kept_and_formatting_is_idempotent() {
    let loose_characters = format!(", {}{}}}a{{}}", "\u{84}".repeat(14), "\u{ff}".repeat(3));
    let texts = [
        // A lone `#` before a word
        "#\u{1}A",
        "#\u{1a}C",
        "union { #\u{1}declare sphere { 0, 1 } }",
        // A quotation mark without its partner before a comma, and quoted text on the next line
        "sphere { 'A\n, 'B' }",
        "sphere { ‘}\n, 'B'",
        // A control character between a `.` and a word
        "#declare C = A.\u{f}B;",
        "#declare C = A.\u{7f}B;",
        // Lines that are broken where a bracket has no partner
        &loose_characters,
        "camera { location <0, 2, -5> look_at 0 }\ntriangle { 0, x, 2*macromooth_triangle { 0, y, x, y, z, -y }",
        "camera { location <0, 2, 0, 1< pigment { Red } <d\n",
    ];
    hold(texts.map(|text| (format!("{text:?}"), text.to_string())), &[WIDTH, 40]);
}

/// The comments at the ends of the lines 1, 5 and 6, whose names are long, get one column, and so does the last one. Six
/// comments in columns of their own are between the first and the last of them.
#[test]
fn formatting_of_interrupted_columns_of_comments_is_idempotent() {
    // Length of the name and column of the comment
    let lines = [(20, 40), (1, 41), (2, 42), (3, 43), (20, 40), (20, 50), (4, 44), (5, 45), (6, 46), (9, 50)];
    let line = |(length, column)| format!("{:column$}// c\n", format!("#declare {} = 1;", "A".repeat(length)));
    let text: String = lines.map(line).concat();
    hold([("columns of comments".to_string(), text)], &[WIDTH, 40]);
}

#[test]
fn expected_results() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/format");
    let mut count = 0;
    for path in std::fs::read_dir(&folder).unwrap().map(|e| e.unwrap().path()) {
        if path.extension().is_some_and(|e| e == "before") {
            let read = |path: &Path| decode(std::fs::read(path).unwrap()).unwrap();
            let (before, after) = (read(&path), read(&path.with_extension("after")));
            let new = durer::on_big_stack(|| before.formatted(0, WIDTH)).unwrap();
            assert_eq!(new, after.text, "{}", path.display());
            count += 1;
        }
    }
    assert!(count >= 10);
}
