//! The manual is correct. Its reference pages equal those generated from durer's tables; every example runs, every
//! picture is rendered, every command line parses. `UPDATE_DOCS=1 cargo test --test cases manual::` regenerates pages
//! and pictures.
//!
//! Flags after the three backticks of an example:
//!
//! ```text
//! pov                    runs without an error or a warning; `<!-- prints -->` and a following block: its output
//! pov,error=E0203        gives this error
//! pov,warns=W0103+W0209  gives these warnings
//! pov,drawn,warns=W0401  is rendered too, small, and warnings about the picture count
//! pov,picture=name       is rendered, and equals `pictures/name.png`, which the chapter shows
//! pov,file=name.inc      is the file `examples/name.inc`
//! sh                     lines that begin with `durer` are command lines
//! ```

mod illustrate;

use crate::Group;
use clap::Parser;
use durer::diagnostic::{Diagnostic, Severity};
use durer::image_io::{self, Encoding, Format, Frame};
use durer::interpreter::Options;
use durer::render;
use durer::snapshot::{Tolerance, Verdict, compare};
use durer::source::{Sandbox, SearchPath, Sources};
use durer::syntax::word;
use durer::value::Family;
use durer::world::World;
use libtest_mimic::{Failed, Trial};
use std::path::{Path, PathBuf};

const README: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/README.md");
const SIZE: (usize, usize) = (240, 180);
/// Text before an example in the code.
const STAGE: &str = "#include \"stage.inc\"\n";

pub fn group() -> Group {
    let source = Path::new(env!("CARGO_MANIFEST_DIR")).join("docs/src");
    let mut trials = vec![];
    for page in durer::cli::manual::generated_reference_pages() {
        let source = source.clone();
        trials.push(Trial::test(format!("manual::reference::{}", page.file), move || {
            reference(&source, page.file, &page.text)
        }));
    }
    for path in chapters(&source) {
        let name = path.strip_prefix(&source).unwrap_or(&path).display().to_string();
        let text = std::fs::read_to_string(&path).unwrap_or_default();
        for block in blocks(&text).into_iter().filter(|b| b.is("pov") || b.is("sh")) {
            let (source, text) = (source.clone(), text.clone());
            trials.push(Trial::test(format!("manual::{name}:{}", block.line), move || block.run(&source, &text)));
        }
        let source = source.clone();
        trials.push(Trial::test(format!("manual::{name}: links"), move || links(&path, &text, &source)));
    }
    for (place, block) in examples_in_code() {
        let source = source.clone();
        trials.push(Trial::test(format!("manual::{place}"), move || durer::on_big_stack(|| block.draw(&source))));
    }
    trials.push(Trial::test("manual::SUMMARY.md: every page", move || in_summary(&source)));
    trials.push(Trial::test("manual::README.md: every shape", || readme(&std::fs::read_to_string(README)?)));
    trials.push(Trial::test("manual::reference: every word of a table", every_tabled_word));
    trials.push(Trial::test("manual::tables: every word is known to the lexer", every_tabled_word_is_known));
    trials.push(Trial::test("manual::reference: every word that is read", every_read_word));
    Group { tests: trials, at_least: 320 }
}

/// A reference page equals the generated one, with an example and its picture for each entry.
fn reference(source: &Path, file: &str, text: &str) -> Result<(), Failed> {
    let page = illustrate::illustrated(file, text, source, &examples_in_code())?;
    durer::on_big_stack(|| {
        page.pictures.iter().try_for_each(|(name, scene)| {
            let world = illustrate::world(source, scene)?;
            picture(source, &format!("reference/{name}"), &world, illustrate::SIZE)
        })
    })?;
    same_file(&source.join("reference").join(file), &page.text)
}

/// README's list of shapes equals the table of shapes.
fn readme(text: &str) -> Result<(), Failed> {
    let drawn = text.split("## What is drawn today").nth(1).and_then(|rest| rest.split("\n## ").next()).unwrap_or("");
    let listed = drawn.split('`').nth(1).ok_or("README.md lists no shapes")?;
    let mut listed: Vec<&str> = listed.split_whitespace().collect();
    let mut shapes: Vec<&str> = durer::shape::Shape::SPECS.iter().map(|spec| spec.name).collect();
    listed.sort_unstable();
    shapes.sort_unstable();
    if listed != shapes {
        return Err(format!("README.md says that durer draws {listed:?}, the table says {shapes:?}").into());
    }
    Ok(())
}

/// Every page is in the summary.
fn in_summary(source: &Path) -> Result<(), Failed> {
    let summary = std::fs::read_to_string(source.join("SUMMARY.md"))?;
    let names = chapters(source).into_iter().filter_map(|p| Some(p.strip_prefix(source).ok()?.display().to_string()));
    let missing =
        names.filter(|n| n != "SUMMARY.md").find(|n| !summary.contains(&format!("({})", n.replace('\\', "/"))));
    missing.map_or(Ok(()), |name| Err(format!("{name} is not in SUMMARY.md").into()))
}

/// All words of tables in the code are in a row of a page other than the index.
fn every_tabled_word() -> Result<(), Failed> {
    let pages = durer::cli::manual::generated_reference_pages();
    let printed = |word: &str| {
        let row = format!("| `{word}`");
        pages.iter().any(|page| page.file != "words.md" && page.text.contains(&row))
    };
    all_found(tabled_words(), 150, &printed)
}

/// All words of tables are accepted: by the lexer, or in their block.
fn every_tabled_word_is_known() -> Result<(), Failed> {
    let in_block = |word: &str| word::CONTEXTUAL.iter().any(|(_, words)| words.contains(&word));
    all_found(tabled_words(), 150, &|word| word::lookup(word).is_some() || in_block(word))
}

/// The words of all rows of all tables in the source.
fn tabled_words() -> Vec<String> {
    let mut words = vec![];
    for text in sources() {
        for head in [" word(", "[word(", "WordSpec {"] {
            let rows = text
                .split(head)
                .skip(1)
                .filter_map(|row| row.trim_start().trim_start_matches("name:").trim_start().strip_prefix('"'));
            words.extend(rows.filter_map(|row| row.split('"').next()).map(str::to_string));
        }
    }
    words
}

/// All words that readers ask for by name are in the index.
fn every_read_word() -> Result<(), Failed> {
    let pages = durer::cli::manual::generated_reference_pages();
    let index = pages.iter().find(|page| page.file == "words.md").map(|page| page.text.as_str()).unwrap_or_default();
    let told = |word: &str| index.contains(&format!("\n| `{word}` |"));
    let mut words = vec![];
    for text in sources() {
        for head in ["Next::Word(", "Next::Block(", "accept("] {
            let lists = text.split(head).skip(1).filter_map(|rest| rest.split([')', '{', ';']).next());
            words.extend(lists.flat_map(|list| list.split('"').skip(1).step_by(2)).map(str::to_string));
        }
    }
    all_found(words, 45, &told)
}

/// Checks that there are at least `least` words, and that each of them is found.
fn all_found(words: Vec<String>, least: usize, found: &dyn Fn(&str) -> bool) -> Result<(), Failed> {
    let words: std::collections::BTreeSet<String> = words.into_iter().collect();
    let missing: Vec<_> = words.iter().filter(|word| !found(word)).collect();
    match missing.is_empty() && words.len() >= least {
        true => Ok(()),
        false => Err(format!("of {} words these are missing: {missing:?}", words.len()).into()),
    }
}

/// The source without tests, and without modules that do not concern scenes.
fn sources() -> Vec<String> {
    fn collect(folder: &Path, out: &mut Vec<String>) {
        for path in std::fs::read_dir(folder).into_iter().flatten().flatten().map(|entry| entry.path()) {
            if path.is_dir() && path.file_name().is_some_and(|name| name != "cli") {
                collect(&path, out);
            } else if path.extension().is_some_and(|ending| ending == "rs") {
                let text = std::fs::read_to_string(&path).unwrap_or_default();
                out.push(text.split("#[cfg(test)]").next().unwrap_or_default().to_string());
            }
        }
    }
    let mut out = vec![];
    collect(&Path::new(env!("CARGO_MANIFEST_DIR")).join("src"), &mut out);
    out
}

fn updating() -> bool {
    std::env::var_os("UPDATE_DOCS").is_some()
}

fn same_file(path: &Path, text: &str) -> Result<(), Failed> {
    if updating() {
        return Ok(std::fs::write(path, text)?);
    }
    let stored = std::fs::read_to_string(path).unwrap_or_default().replace("\r\n", "\n");
    let first = stored.lines().zip(text.lines()).find(|(a, b)| a != b);
    match first {
        _ if stored == text => Ok(()),
        Some((stored, now)) => Err(format!("stored: {stored}\nnow:    {now}\n(UPDATE_DOCS=1 takes it)").into()),
        None => Err("it is longer or shorter than the file (UPDATE_DOCS=1 takes it)".into()),
    }
}

/// All Markdown files.
fn chapters(source: &Path) -> Vec<PathBuf> {
    let files = |folder: &Path| {
        let entries = std::fs::read_dir(folder).into_iter().flatten().flatten();
        entries.map(|e| e.path()).filter(|p| p.extension().is_some_and(|e| e == "md")).collect::<Vec<_>>()
    };
    let mut all = [files(source), files(&source.join("reference"))].concat();
    all.sort();
    all
}

/// The examples at the head of the files of shapes and patterns, each with a stage around it.
fn examples_in_code() -> Vec<(String, Block)> {
    fn collect(folder: &Path, out: &mut Vec<PathBuf>) {
        for path in std::fs::read_dir(folder).into_iter().flatten().flatten().map(|entry| entry.path()) {
            match path.extension() {
                Some(extension) if extension == "rs" => out.push(path),
                _ if path.is_dir() => collect(&path, out),
                _ => {}
            }
        }
    }
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let mut out = vec![];
    let files = ["src/shape", "src/pattern"].map(|folder| {
        let mut files = vec![];
        collect(&root.join(folder), &mut files);
        files.sort_by_key(|file| (file.components().count(), file.clone()));
        files
    });
    for file in files.into_iter().flatten() {
        let text = std::fs::read_to_string(&file).unwrap_or_default();
        let doc: String =
            text.lines().map_while(|l| l.strip_prefix("//!")).map(|l| format!("{}\n", l.trim_start())).collect();
        for mut block in blocks(&doc).into_iter().filter(|b| b.is("pov")) {
            block.text = format!("{STAGE}{}", block.text);
            let name = file.strip_prefix(root).unwrap_or(&file).display();
            out.push((format!("{name}:{}", block.line), block));
        }
    }
    out
}

/// A fenced code block.
struct Block {
    /// Flags after the opening fence.
    flags: Vec<String>,
    text: String,
    /// The expected output.
    prints: Option<String>,
    /// Line of its beginning.
    line: usize,
}

fn blocks(text: &str) -> Vec<Block> {
    let (mut out, mut open, mut expected) = (Vec::<Block>::new(), None::<Block>, false);
    for (i, line) in text.lines().enumerate() {
        match (&mut open, line.strip_prefix("```")) {
            (None, Some(flags)) => {
                let flags = flags.split(',').map(|f| f.trim().to_string()).collect();
                open = Some(Block { flags, text: String::new(), prints: None, line: i + 1 });
            }
            (Some(_), Some(_)) => {
                let block = open.take();
                match (expected, out.last_mut()) {
                    (true, Some(last)) => last.prints = block.map(|b| b.text),
                    _ => out.extend(block),
                }
                expected = false;
            }
            (Some(block), None) => block.text += &format!("{line}\n"),
            (None, None) => expected |= line.trim() == "<!-- prints -->",
        }
    }
    out
}

impl Block {
    fn is(&self, flag: &str) -> bool {
        self.flags.iter().any(|f| f == flag)
    }

    fn value(&self, name: &str) -> Option<&str> {
        self.flags.iter().find_map(|f| f.strip_prefix(name)?.strip_prefix('='))
    }

    fn run(&self, source: &Path, chapter: &str) -> Result<(), Failed> {
        if self.is("sh") {
            return commands(&self.text);
        }
        if let Some(file) = self.value("file") {
            return same_file(&source.join("examples").join(file), &self.text);
        }
        durer::on_big_stack(|| self.run_scene(source, chapter))
    }

    /// Renders an example in the code: it gives no message, and differs from the stage alone.
    fn draw(&self, source: &Path) -> Result<(), Failed> {
        self.run_scene(source, "")?;
        match thumbnail(source, &self.text)? == thumbnail(source, STAGE)? {
            true => Err("it looks like the stage alone".into()),
            false => Ok(()),
        }
    }

    fn run_scene(&self, source: &Path, chapter: &str) -> Result<(), Failed> {
        let options = options(&source.join("examples"));
        let sources = Sources::default();
        let (mut printed, path) = (String::new(), source.join("examples/example.pov"));
        let Some(file) = sources.add("example.pov", Some(&path), self.text.clone()) else { return Ok(()) };
        let mut built = durer::build(&sources, file, &options, &mut |text| printed.push_str(text));
        if let Some(world) = built.world.as_ref().filter(|_| self.is("drawn")) {
            let told = of_picture(world)?;
            built.diagnostics.extend(told);
        }
        let describe = |d: &Diagnostic| {
            let line = sources.place(d.span()).map_or(0, |place| place.line);
            format!("line {line}: {} {}", d.code, d.message)
        };
        let told: Vec<&Diagnostic> = built.diagnostics.iter().filter(|d| d.code.0 != "W0206").collect();
        let codes = |severity| told.iter().filter(move |d| d.severity == severity).map(|d| d.code.0);
        let warnings = self.value("warns").into_iter().flat_map(|w| w.split('+'));
        if !codes(Severity::Error).eq(self.value("error")) || !codes(Severity::Warning).eq(warnings) {
            return Err(
                format!("{}\n{}", self.text, told.iter().map(|d| describe(d) + "\n").collect::<String>()).into()
            );
        }
        if let Some(expected) = self.prints.as_ref().filter(|expected| expected.trim_end() != printed.trim_end()) {
            return Err(format!("{}\nexpected:\n{expected}printed:\n{printed}", self.text).into());
        }
        match (self.value("picture"), &built.world) {
            (Some(name), Some(_)) if !chapter.contains(&format!("(pictures/{name}.png)")) => {
                Err(format!("the chapter does not show pictures/{name}.png").into())
            }
            (Some(name), Some(world)) => picture(source, name, world, SIZE),
            (Some(_), None) => Err("no picture without a scene".into()),
            (None, _) => Ok(()),
        }
    }
}

/// A small picture of a scene.
fn thumbnail(source: &Path, text: &str) -> Result<Frame, Failed> {
    let world = world_of(source, text, SIZE)?;
    Ok(render::render(&world, &drawing(32, 24), &render::Unwatched).map_err(|e| format!("{e:?}"))?.0)
}

/// The world of a scene of the manual, for a size of the picture.
fn world_of(source: &Path, text: &str, size: (usize, usize)) -> Result<World, Failed> {
    let folder = source.join("examples");
    let sources = Sources::default();
    let file = sources.add("example.pov", Some(&folder.join("example.pov")), text.into()).ok_or("too long")?;
    let built = durer::build(&sources, file, &Options { size, ..options(&folder) }, &mut |_| ());
    let told = || built.diagnostics.iter().map(|d| d.message.clone()).collect::<Vec<_>>().join("\n");
    Ok(built.world.ok_or_else(|| format!("there is nothing to draw: {}\n{text}", told()))?)
}

fn options(folder: &Path) -> Options {
    let search = SearchPath::new(folder, &[]);
    Options {
        sandbox: Sandbox::with_writes_in_memory(),
        search,
        input_name: "example.pov".into(),
        size: SIZE,
        ..Options::default()
    }
}

fn drawing(width: usize, height: usize) -> render::Options {
    render::Options { antialias: Some(0.1), ..render::Options::new(width, height) }
}

/// Warnings about a scene's picture.
fn of_picture(world: &durer::world::World) -> Result<Vec<Diagnostic>, Failed> {
    let drawing = drawing(160, 120);
    let (frame, _) = render::render(world, &drawing, &render::Unwatched).map_err(|e| format!("{e:?}"))?;
    let black = frame.rgba8().iter().all(|[r, g, b, _]| *r == 0 && *g == 0 && *b == 0);
    let circumstances = durer::advice::Circumstances { one_of_many: false, black };
    Ok(durer::advice::picture_warnings(world, &drawing, circumstances))
}

/// A picture equals the stored one, which is stored when the manual is updated.
fn picture(source: &Path, name: &str, world: &World, (width, height): (usize, usize)) -> Result<(), Failed> {
    let (drawn, _) =
        render::render(world, &drawing(width, height), &render::Unwatched).map_err(|e| format!("{e:?}"))?;
    let path = source.join("pictures").join(format!("{name}.png"));
    let drawn = drawn.over_black();
    let stored = image_io::decode_picture_file(&durer::source::Disk, &path).ok().map(|pixels| pixels.to_linear_image());
    let comparison = stored.map(|stored| compare(&stored, &drawn, Tolerance::default()));
    if comparison.is_some_and(|c| c.verdict != Verdict::Differs) {
        return Ok(());
    }
    if updating() {
        let bytes = image_io::encode(&drawn, &Encoding::new(Format::Png)).map_err(|e| format!("{e:?}"))?;
        return Ok(std::fs::write(path, bytes)?);
    }
    Err(format!("pictures/{name}.png: {comparison:?} (UPDATE_DOCS=1 takes it)").into())
}

/// Checks that durer's command lines parse.
fn commands(text: &str) -> Result<(), Failed> {
    for line in text.lines().map(|line| line.split(" #").next().unwrap_or_default().trim()) {
        let words: Vec<&str> =
            line.split_whitespace().map(|w| w.trim_matches('\'')).take_while(|w| *w != "|").collect();
        let povray = words.iter().any(|w| w.starts_with('+') || w.contains('[') || w.contains(".pov"));
        if words.first() == Some(&"durer") && !povray {
            durer::cli::Cli::try_parse_from(&words).map_err(|e| format!("{line}\n{e}"))?;
        }
    }
    Ok(())
}

/// Checks that the targets of a chapter's links exist.
fn links(path: &Path, text: &str, source: &Path) -> Result<(), Failed> {
    let folder = path.parent().unwrap_or(source);
    let targets = text.match_indices("](").filter_map(|(i, _)| text[i + 2..].split(')').next());
    let missing = targets.filter(|t| !t.starts_with("http") && !t.starts_with('#')).find(|target| {
        let (file, anchor) = target.split_once('#').unwrap_or((target, ""));
        let text = std::fs::read_to_string(folder.join(file)).unwrap_or_default();
        !folder.join(file).exists() || !anchor.is_empty() && !anchors(&text).any(|a| a == anchor)
    });
    missing.map_or(Ok(()), |target| Err(format!("there is no {target}").into()))
}

/// The anchors of a page's headings, as mdBook generates them.
fn anchors(text: &str) -> impl Iterator<Item = String> {
    let name = |line: &str| {
        let words = line.trim_start_matches('#').trim().to_lowercase();
        words
            .chars()
            .filter(|c| c.is_alphanumeric() || "-_ ".contains(*c))
            .map(|c| if c == ' ' { '-' } else { c })
            .collect()
    };
    text.lines().filter(|line| line.starts_with('#')).map(name).collect::<Vec<String>>().into_iter()
}
